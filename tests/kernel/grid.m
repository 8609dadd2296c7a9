// The grid of a polygon with many vertices says what the crossing test says,
// for every ray: aimed at vertices, edges and anywhere; from near and far; with
// polygons of any size and place, flat and not quite.

#import "kernel.h"

#define MOST 400

struct outline
{
  unsigned n;
  double at[3][MOST];
  const double *vertex[3];
  struct k_plane plane;
};

static struct k_vec
corner(const struct outline *p, unsigned i)
{
  return k_vec(p->at[0][i], p->at[1][i], p->at[2][i]);
}

/** A gear or a star about `middle`, `size` across, each vertex off its plane
    by up to `bent` of that. */
static void
make(struct outline *p, unsigned n, struct k_vec middle, double size,
     double bent, struct support_random *random)
{
  struct k_vec N = support_direction(random);
  struct k_vec U = k_unit(k_cross(N, support_direction(random)));
  struct k_vec V = k_cross(N, U);

  p->n = n;
  for (unsigned i = 0; i < n; i++)
    {
      double angle = 2 * M_PI * (i + support_between(random, -0.3, 0.3)) / n;
      double r = size * (n % 2 ? support_between(random, 0.2, 1)
                         : i / 2 % 2 ? 0.8 : 1);
      struct k_vec v = k_along(k_along(middle, r * cos(angle), U),
                               r * sin(angle), V);
      v = k_along(v, support_between(random, -bent, bent) * size, N);
      p->at[0][i] = v.x;
      p->at[1][i] = v.y;
      p->at[2][i] = v.z;
    }
  for (int axis = 0; axis < 3; axis++)
    {
      p->vertex[axis] = p->at[axis];
    }
  p->plane.n = N;
  p->plane.q = corner(p, 0);
}

static struct k_vec
target(const struct outline *p, unsigned kind, struct support_random *random)
{
  unsigned i = support_between(random, 0, p->n);
  struct k_vec a = corner(p, i % p->n), b = corner(p, (i + 1) % p->n);
  struct k_vec c = corner(p, (i + p->n / 2) % p->n);

  return kind % 4 == 0 ? a
    : kind % 4 == 1 ? k_along(a, support_unit(random), k_sub(b, a))
    : k_along(a, support_between(random, -0.2, 1.2), k_sub(c, a));
}

static unsigned rays, known, inside, wrong;

static void
polygon(unsigned n, struct k_vec middle, double size, double bent,
        double away)
{
  struct support_random random = support_seed(n + 1000 * away);
  struct outline p;

  make(&p, n, middle, size, bent, &random);
  struct k_polygon_grid *grid = k_polygon_grid(&p.plane, n, p.vertex);
  for (unsigned i = 0; grid && i < 4000 / KERNEL_FEWER; i++)
    {
      struct k_vec d = support_direction(&random);
      if (i % 8 == 0)
        {
          d = k_unit(k_cross(d, p.plane.n));    // along the plane, almost
          d = k_unit(k_along(d, support_between(&random, -0.1, 0.1),
                             p.plane.n));
        }
      struct k_vec o = k_along(target(&p, i, &random), -away * size, d);
      struct k_shear shear = k_shear(d);
      double t;
      if (!k_plane_hit(&p.plane, o, d, &t) || t < 0)
        {
          continue;
        }
      enum k_cell cell = k_polygon_grid_at(grid, &p.plane, o, d, t);
      int is_in = k_polygon_crossings(o, &shear, n, p.vertex);
      rays++;
      if (cell != K_CELL_MIXED)
        {
          known++;
          inside += is_in;
          wrong += is_in != (cell == K_CELL_IN);
        }
    }
  free(grid);
}

/** The share of rays whose place the grid knows is at least `least`; it knows
    none at all when that is 0. */
static void
tell(const char *what, double least)
{
  PASS(wrong == 0, "%s: %u of %u rays are wrong", what, wrong, known);
  PASS(least > 0 ? known >= least * rays && inside > 0 && inside < known
       : known == 0, "%s: the grid knows %u of %u rays, %u inside", what,
       known, rays, inside);
  rays = known = inside = wrong = 0;
}

/** Polygons of all numbers of vertices. */
static void
polygons(struct k_vec middle, double size, double bent, double away)
{
  for (unsigned n = K_GRID_FROM; n < MOST; n += 7)
    {
      polygon(n, middle, size, bent, away);
    }
}

int
main(void)
{
  const struct k_vec near = k_vec(0.3, -0.2, 0.1);

  polygons(near, 1, 0, 3);
  tell("near", 0.2);
  polygons(near, 1, 0, 1e6);
  tell("from far", 0.2);
  polygons(near, 1, 0, 1e12);
  tell("from so far that rounding counts", 0);
  polygons(k_vec(3e7, -2e7, 1e7), 1, 0, 3);
  tell("far from the origin", 0.2);
  polygons(k_vec(3e12, -2e12, 1e12), 1, 0, 3);
  tell("so far that rounding counts", 0);
  for (int k = -300; k <= 300; k += 100)
    {
      polygons(k_vec(0, 0, 0), ldexp(1, k), 0, 3);
    }
  tell("of any size", 0.2);
  polygons(k_vec(0, 0, 0), 1, 1e-6, 3);
  tell("not quite flat", 0.2);
  polygons(k_vec(0, 0, 0), 1, 1e-4, 3);
  tell("less flat", 0);
  return test_done();
}
