// crossings.m - whether a point is in a polygon, four edges at a time: the
// same answer as edge by edge, for any number of corners, by each instruction
// set, for rays at random and rays through corners and edges.

#import "kernel.h"

#define MOST 203

struct outline
{
  unsigned n;
  double room[3][MOST + 5];     // one corner in front and four behind
  const double *vertex[3];
};

/** Round the origin, with corners at random distances; some coordinates are
    rounded so that corners and rays have them in common. */
static void
make(struct outline *p, unsigned n, struct support_random *random)
{
  struct k_vec z = n % 3 ? support_direction(random) : k_vec(0, 0, 1);
  struct k_vec x = k_unit(k_cross(z, fabs(z.x) < 0.5 ? k_vec(1, 0, 0)
                                  : k_vec(0, 1, 0)));
  struct k_vec y = k_cross(z, x);

  p->n = n;
  for (unsigned i = 0; i < n; i++)
    {
      double turn = 2 * M_PI * i / n;
      double r = support_between(random, 0.2, 1);
      struct k_vec v = k_add(k_scale(x, r * cos(turn)),
                             k_scale(y, r * sin(turn)));
      v = n % 3 ? v : k_vec(round(8 * v.x) / 8, round(8 * v.y) / 8, 0);
      p->room[0][i + 1] = v.x;
      p->room[1][i + 1] = v.y;
      p->room[2][i + 1] = v.z;
    }
  for (int axis = 0; axis < 3; axis++)
    {
      double *v = p->room[axis] + 1;
      v[-1] = v[n - 1];
      for (unsigned i = n; i < n + 4; i++)
        {
          v[i] = v[n - 1];
        }
      p->vertex[axis] = v;
    }
}

/** A ray at the polygon: at a place of it, a corner, an edge; from a corner;
    as high as one. */
static void
aim(const struct outline *p, unsigned kind, struct support_random *random,
    struct k_vec *o, struct k_vec *d)
{
  unsigned i = p->n * support_unit(random), j = (i + 1) % p->n;
  struct k_vec a = k_vec(p->vertex[0][i], p->vertex[1][i], p->vertex[2][i]);
  struct k_vec b = k_vec(p->vertex[0][j], p->vertex[1][j], p->vertex[2][j]);
  struct k_vec at = kind % 4 == 0 ? support_point(random, 0.6)
    : kind % 4 == 1 ? a
    : kind % 4 == 2 ? k_along(a, support_unit(random), k_sub(b, a))
    : k_vec(support_between(random, -1, 1), a.y, a.z);

  *d = support_direction(random);
  if (kind % 5 == 0)
    {
      *d = k_vec(-0.0, 0, kind % 2 ? 1 : -1);
    }
  *o = kind % 7 ? k_along(at, -4, *d) : a;
}

int
main(void)
{
  NSAutoreleasePool *pool = [[NSAutoreleasePool alloc] init];
  const struct k_isa *isas[4];
  unsigned count = kernel_isas(isas), rays = 0, inside = 0, apart = 0;
  unsigned wrong[4] = { 0 };

  for (unsigned n = 3; n <= MOST; n++)
    {
      struct support_random random = support_seed(n);
      struct counters counters = { 0 };
      struct k_material material = { .ior = 1 };
      struct k_surface s = { .number = 1 };
      struct k_scene *scene = k_scene_new();
      struct outline p;
      make(&p, n, &random);
      // The polygon's plane is moved away, so that its distance plays no part.
      struct k_plane plane = { { 0, 0, 1 }, { 0, 0, 0 } };
      k_add_material(scene, &material);
      k_add_polygon(scene, s, plane, plane.n, n, p.vertex, POLYGON_CROSSINGS);
      struct k_settings settings = { .threads = 1 };
      k_scene_finish(scene, settings);
      // Nor does a grid, which knows that plane: tests/kernel/grid.m.
      free(scene->polygons[0].grid);
      scene->polygons[0].grid = NULL;
      for (unsigned i = 0; i < 5000 / KERNEL_FEWER; i++)
        {
          struct k_vec o, d;
          aim(&p, i, &random, &o, &d);
          struct k_ray ray = kernel_ray(o, d, &counters);
          int is_in = k_polygon_crossings(o, k_ray_shear(&ray), n, p.vertex);
          apart += is_in != k_polygon_crossings_4(o, k_ray_shear(&ray), n,
                                                  p.vertex);
          rays++;
          inside += is_in;
          // Asked by the search, on a plane across the ray, ahead of it.
          scene->polygons[0].plane.n = d;
          scene->polygons[0].plane.q = k_along(o, 8, d);
          for (unsigned k = 0; k < count; k++)
            {
              struct k_ray asked = ray;
              isas[k]->closest(scene, &asked);
              wrong[k] += is_in != (asked.hit.surface != NULL);
            }
        }
      k_scene_free(scene);
    }
  PASS(inside > rays / 5 && inside < rays / 5 * 4, "%u rays, %u inside", rays,
       inside);
  PASS(apart == 0, "four at a time, in plain C: %u differ", apart);
  for (unsigned k = 0; k < count; k++)
    {
      PASS(wrong[k] == 0, "asked by the search, %s: %u differ", isas[k]->name,
           wrong[k]);
    }
  [pool release];
  return test_done();
}
