// Rays that are searched for together hit what each hits when every shape is
// asked: from one point and from many, narrow and wide, along axes, from far
// away; rays from where those have hit; feelers to one light, which may stand on
// a shape. In scenes of any size, with each instruction set.

#import "kernel.h"

#define SHAPES 300
#define CORNERS 20

/** Spheres, triangles and stars about 8 across, moved by `offset` and taken
    times 2^k; every third shape is clear, every fifth is there twice. */
static struct k_scene *
make(double offset, int k, struct support_random *random)
{
  struct k_scene *scene = k_scene_new();
  struct k_material opaque = { .ior = 1 }, clear = { .alpha = 1, .ior = 1.5 };
  double x[CORNERS], y[CORNERS], z[CORNERS];
  const double *const vertex[3] = { x, y, z };

  k_add_material(scene, &opaque);
  k_add_material(scene, &clear);
  for (unsigned i = 0; i < SHAPES; i++)
    {
      struct k_vec c = k_vec(support_between(random, -4, 4) + offset,
                             support_between(random, -4, 4),
                             support_between(random, -4, 4) - offset);
      double r = support_between(random, 0.02, i % 16 ? 0.4 : 2);
      struct k_surface s = { .number = i + 1, .material = i % 3 == 0 };
      struct k_surface twin = s;
      twin.number += SHAPES;
      twin.slack = s.slack = ldexp(0x1p-48 * (k_norm1(c) + r), k);
      if (i % 2)
        {
          k_add_sphere(scene, s, k_scale(c, ldexp(1, k)), ldexp(r, k));
          if (i % 5 == 0)
            {
              k_add_sphere(scene, twin, k_scale(c, ldexp(1, k)), ldexp(r, k));
            }
          continue;
        }
      unsigned n = i % 8 ? 3 : CORNERS;
      struct k_vec N = support_direction(random);
      struct k_vec U = k_unit(k_cross(N, support_direction(random)));
      struct k_vec V = k_cross(N, U);
      for (unsigned v = 0; v < n; v++)
        {
          double far = v % 2 ? r : r / 2, angle = 2 * M_PI * v / n;
          struct k_vec p = k_along(k_along(c, far * cos(angle), U),
                                   far * sin(angle), V);
          x[v] = ldexp(p.x, k);
          y[v] = ldexp(p.y, k);
          z[v] = ldexp(p.z, k);
        }
      struct k_plane plane = { N, k_vec(x[0], y[0], z[0]) };
      k_add_polygon(scene, s, plane, N, n, vertex, 0);
      if (i % 5 == 0)
        {
          k_add_polygon(scene, twin, plane, N, n, vertex, 0);
        }
    }
  struct k_settings settings = { .threads = 1 };
  if (k_scene_finish(scene, settings) != K_OK)
    {
      k_scene_free(scene);
      return NULL;
    }
  return scene;
}

/** Rays of one kind towards a place in the scene, as if that were about the
    origin and of size 8. */
static void
aim(unsigned kind, double offset, int k, struct support_random *random,
    struct k_vec o[K_MANY], struct k_vec d[K_MANY])
{
  static const double widths[] = { 0, 1e-6, 0.01, 0.1, 1, 10 };
  double width = widths[kind % 6], away = kind / 6 % 5 ? 12 : 1e5;
  struct k_vec from = k_scale(support_direction(random), away);
  struct k_vec at = k_scale(support_direction(random),
                            support_between(random, 0, 5));
  double apart = kind % 2 ? 0 : kind / 12 % 3;

  if (kind / 6 % 5 == 1)
    {
      // Straight along an axis, some numbers 0 with either sign.
      from = at;
      (&from.x)[kind % 3] = kind / 3 % 2 ? 12 : -12;
    }
  for (unsigned i = 0; i < K_MANY; i++)
    {
      struct k_vec a = k_along(from, apart * support_unit(random),
                               support_direction(random));
      struct k_vec b = k_along(at, width * support_unit(random),
                               support_direction(random));
      struct k_vec shift = k_vec(offset, 0, -offset);
      o[i] = k_scale(k_add(a, shift), ldexp(1, k));
      d[i] = k_unit(k_sub(b, a));
    }
}

static unsigned rays, hits, children, ties, feelers, blocked, wrong;

/** Whether one of two was nearest. */
static int
is_tied(const struct k_ray *ray)
{
  return ray->hit.surface && ray->tied == ray->hit.surface;
}

/** Whether found is as wanted, and how it was found is what --stats counts. */
static int
is_right(const struct k_ray *found, const struct k_ray *wanted)
{
  return kernel_agree(found, wanted)
    && (found->is_feeler || !found->hit.surface
        || (is_tied(found) == is_tied(wanted)
            && found->hit.is_compensated == wanted->hit.is_compensated));
}

static void
compare(const struct k_scene *scene, const struct k_isa *isa,
        struct k_ray *many, const struct k_ray *wanted, unsigned n,
        int are_feelers)
{
  struct k_ray found[K_MANY];

  memcpy(found, many, n * sizeof *many);
  isa->find(scene, found, n, are_feelers);
  for (unsigned i = 0; i < n; i++)
    {
      kernel_finish(&found[i]);
      if (!is_right(&found[i], &wanted[i]) && wrong++ < 3)
        {
          kernel_show(isa->name, &found[i], &wanted[i]);
        }
    }
}

static void
bundle(struct k_scene *scene, unsigned kind, double offset, int k,
       struct support_random *random)
{
  struct counters counters = { 0 };
  struct k_ray many[K_MANY], wanted[K_MANY];
  struct k_vec o[K_MANY], d[K_MANY];
  const struct k_isa *isas[4];
  unsigned count = kernel_isas(isas), n = 1 + kind % K_MANY, points = 0;

  aim(kind, offset, k, random, o, d);
  for (unsigned i = 0; i < n; i++)
    {
      many[i] = wanted[i] = kernel_ray(o[i], d[i], &counters);
      kernel_ask_all(scene, &wanted[i]);
      kernel_finish(&wanted[i]);
      hits += wanted[i].hit.surface != NULL;
      ties += is_tied(&wanted[i]);
    }
  rays += n;
  for (unsigned s = 0; s < count; s++)
    {
      compare(scene, isas[s], many, wanted, n, 0);
    }
  struct k_vec light = k_scale(k_vec(offset + 3, kind % 2 ? 5 : 50,
                                     2 - offset), ldexp(1, k));
  struct k_vec away = support_direction(random);
  struct k_ray felt[K_MANY];
  if (kind % 3 == 0 && wanted[0].hit.surface)
    {
      light = wanted[0].hit.P;
    }
  for (unsigned i = 0; i < n; i++)
    {
      if (wanted[i].hit.surface)
        {
          many[points] = felt[points] = kernel_feeler(&wanted[i], light);
          // As the search does: what is clear is in nobody's way.
          for (unsigned kind = K_SPHERE; kind <= K_POLYGON; kind++)
            {
              for (uint32_t j = 0; j < kernel_count(scene, kind); j++)
                {
                  struct k_ref ref = { kind, j };
                  k_ref_ask(scene, ref, &felt[points]);
                }
            }
          blocked += felt[points++].hit.surface != NULL;
        }
    }
  feelers += points;
  for (unsigned s = 0; s < count && points; s++)
    {
      compare(scene, isas[s], many, felt, points, 1);
    }
  points = 0;
  for (unsigned i = 0; i < n; i++)
    {
      if (wanted[i].hit.surface)
        {
          struct k_vec to = k_unit(k_along(away, kind % 5 * 0.02,
                                           support_direction(random)));
          struct k_vec N = wanted[i].hit.N;
          int goes_on = k_dot(to, N) * k_dot(d[i], N) > 0;
          many[points] = felt[points] = kernel_child(&wanted[i], to, goes_on);
          kernel_ask_all(scene, &felt[points]);
          kernel_finish(&felt[points++]);
        }
    }
  children += points;
  for (unsigned s = 0; s < count && points; s++)
    {
      compare(scene, isas[s], many, felt, points, 0);
    }
}

int
main(void)
{
  static const struct
    {
      double offset;
      int k;
    }
  places[] = { { 0, 0 }, { 100, 0 }, { 1e6, 0 }, { 0, -300 }, { 3, 300 } };

  for (unsigned p = 0; p < sizeof places / sizeof *places; p++)
    {
      struct support_random random = support_seed(p + 1);
      struct k_scene *scene = make(places[p].offset, places[p].k, &random);
      for (unsigned kind = 0; kind < 1800u / KERNEL_FEWER; kind++)
        {
          bundle(scene, kind, places[p].offset, places[p].k, &random);
        }
      k_scene_free(scene);
      PASS(wrong == 0, "moved by %g, 2^%d: %u rays are wrong",
           places[p].offset, places[p].k, wrong);
      PASS(hits > rays / 20 && hits < rays && blocked > feelers / 20
           && blocked < feelers && children > rays / 20 && ties > rays / 200,
           "%u rays, %u hits, %u of two at once; %u feelers, %u blocked;"
           " %u children", rays, hits, ties, feelers, blocked, children);
      rays = hits = children = ties = feelers = blocked = wrong = 0;
    }
  return test_done();
}
