// boxes.m - no box that a ray meets is left out, neither by the tree nor by
// the test of a single box: rays in the planes of faces, along edges, from
// corners, with zeros of both signs in their direction, at flat boxes, from
// far away; scenes far from the origin, very small, very large.

#import "kernel.h"
#include "kernel/k_bounds.h"

#define BOXES 200
#define RAYS (12000 / KERNEL_FEWER)     // a scene

static unsigned long asked[BOXES];      // last ray that each box was asked by
static unsigned long now;

/** A shape that is never hit and remembers who asked. */
static void
remember(void *shape, const struct k_surface *s, struct k_ray *ray)
{
  *(unsigned long *)shape = now;
}

static double
one_of(struct support_random *random, double a, double b)
{
  return support_unit(random) < 0.5 ? a : b;
}

/** A number between the ends, or an end. */
static double
within(struct support_random *random, double least, double most)
{
  double x = support_between(random, least, most);

  return support_unit(random) < 0.6 ? one_of(random, least, most)
    : x < least ? least : x > most ? most : x;
}

static struct k_vec
in_box(struct support_random *random, struct k_bounds box)
{
  double x = within(random, box.least.x, box.most.x);
  double y = within(random, box.least.y, box.most.y);
  double z = within(random, box.least.z, box.most.z);

  return k_vec(x, y, z);
}

/** Some with corners in common, some flat, some a line or a point. */
static struct k_bounds
some_box(struct support_random *random, double offset, int k)
{
  double least[3], most[3];

  for (int axis = 0; axis < 3; axis++)
    {
      double u = support_unit(random);
      least[axis] = floor(support_between(random, -8, 8)) / 2;
      most[axis] = least[axis] + (u < 0.2 ? 0 : u < 0.6 ? 0.5
                                  : support_between(random, 0, 2));
      least[axis] = ldexp(least[axis] + offset, k);
      most[axis] = ldexp(most[axis] + offset, k);
    }
  struct k_bounds box = { { least[0], least[1], least[2] },
                          { most[0], most[1], most[2] } };
  return box;
}

/** A ray that passes through p, which may be its start. */
static void
aim(struct support_random *random, struct k_vec p, double away,
    struct k_vec *o, struct k_vec *d)
{
  double v[3], tiny = pow(2, support_between(random, -1074, -20));
  int kind = 5 * support_unit(random), axis = 3 * support_unit(random);
  struct k_vec u = support_direction(random);

  v[0] = u.x, v[1] = u.y, v[2] = u.z;
  if (kind == 1)                // in a plane
    {
      v[axis] = one_of(random, 0.0, -0.0);
    }
  else if (kind == 2)           // along an axis
    {
      v[axis] = one_of(random, 0.0, -0.0);
      v[(axis + 1) % 3] = one_of(random, 0.0, -0.0);
    }
  else if (kind == 3)           // nearly
    {
      v[axis] = one_of(random, tiny, -tiny);
      v[(axis + 1) % 3] = one_of(random, v[(axis + 1) % 3], 0);
    }
  *d = k_unit(k_vec(v[0], v[1], v[2]));
  *o = kind == 4 ? p : k_along(p, -away, *d);
  if (kind == 0)
    {
      *d = k_unit(k_sub(p, *o));
    }
}

/** How many boxes stick out of the box that the tree has of their leaf. */
static unsigned
outside(const struct k_scene *scene)
{
  const struct k_tree *tree = &scene->tree;
  unsigned outside = 0;

  for (uint32_t i = 0; i < tree->node_count * K_WIDTH; i++)
    {
      const struct k_node *node = &tree->nodes[i / K_WIDTH];
      uint32_t child = node->child[i % K_WIDTH];
      if (!(child & K_LEAF))
        {
          continue;
        }
      for (uint32_t k = 0; k <= (child & 7); k++)
        {
          struct k_ref ref = tree->refs[((child & ~K_LEAF) >> 3) + k];
          struct k_bounds box = kernel_box(scene, ref);
          struct k_vec least = k_scale(k_sub(box.least, tree->center),
                                       tree->scale);
          struct k_vec most = k_scale(k_sub(box.most, tree->center),
                                      tree->scale);
          for (int axis = 0; axis < 3; axis++)
            {
              outside += k_component(least, axis)
                < node->bounds[axis][i % K_WIDTH]
                || k_component(most, axis)
                > node->bounds[axis + 3][i % K_WIDTH];
            }
        }
    }
  return outside;
}

/** Boxes about 8 across, moved by `offset` and taken times 2^k, seen from
    `away` times 8. */
static unsigned
scene(double offset, int k, double away, uint64_t seed)
{
  struct support_random random = support_seed(seed);
  struct k_scene *scene = k_scene_new();
  struct k_material material = { .ior = 1 };
  struct k_bounds boxes[BOXES];
  const struct k_isa *isas[4];
  unsigned missed = 0, count = kernel_isas(isas);

  k_add_material(scene, &material);
  for (unsigned i = 0; i < BOXES; i++)
    {
      struct k_surface s = { .number = i + 1 };
      struct k_user user = { remember, &asked[i],
                             some_box(&random, offset, k) };
      boxes[i] = user.box;
      k_add_user(scene, s, user);
    }
  struct k_settings settings = { .threads = 1 };
  if (k_scene_finish(scene, settings) != K_OK)
    {
      k_scene_free(scene);
      return RAYS;
    }
  missed += outside(scene);
  for (unsigned i = 0; i < RAYS; i++)
    {
      struct counters counters = { 0 };
      unsigned which = BOXES * support_unit(&random);
      struct k_vec o, d, p = in_box(&random, boxes[which]);
      aim(&random, p, ldexp(8 * away * support_unit(&random), k), &o, &d);
      for (unsigned j = 0; j < count; j++)
        {
          struct k_ray ray = kernel_ray(o, d, &counters);
          if (i % 2)
            {
              // Nothing beyond p is of interest.
              ray.is_feeler = 1;
              ray.end = k_length(k_sub(p, o));
            }
          now++;
          isas[j]->closest(scene, &ray);
          if (asked[which] != now && missed++ < 3)
            {
              const struct k_bounds *b = &boxes[which];
              printf("# %s: from (%a %a %a) along (%a %a %a) to %a is not in"
                     " (%a %a %a) (%a %a %a)\n", isas[j]->name, o.x, o.y, o.z,
                     d.x, d.y, d.z, ray.end, b->least.x, b->least.y,
                     b->least.z, b->most.x, b->most.y, b->most.z);
            }
        }
    }
  k_scene_free(scene);
  return missed;
}

static void
trees(void)
{
  static const double offsets[] = { 0, 1e6, -1e9 };
  static const int scales[] = { 0, -390, 390, 30 };
  static const double aways[] = { 1, 1e3, 0x1p20, 0x1p29, 0x1p31, 0x1p35,
                                  0x1p80, 0x1p150 };
  uint64_t seed = 0;

  for (int i = 0; i < 3; i++)
    {
      for (int j = 0; j < 4; j++)
        {
          unsigned missed = 0;
          for (int a = 0; a < 8; a++)
            {
              missed += scene(offsets[i], scales[j], aways[a], seed++);
            }
          PASS(missed == 0, "boxes + %g times 2^%d: %u are left out by the"
               " tree", offsets[i], scales[j], missed);
        }
    }
}

/** In whole numbers nothing is rounded: it is known what is hit. */
static void
one_box(void)
{
  unsigned missed = 0, false_hits = 0;

  for (unsigned i = 0; i < 1000000; i++)
    {
      struct support_random random = support_seed(i);
      double o[3], d[3], p[3], least[3], most[3];
      double t = 1 + floor(15 * support_unit(&random));
      double scale = ldexp(1, (int)(i % 801) - 400);
      double size = pow(2, 40 * support_unit(&random));
      for (int axis = 0; axis < 3; axis++)
        {
          double u = support_unit(&random);
          least[axis] = floor(support_between(&random, -size, size));
          most[axis] = least[axis]
            + floor(support_between(&random, 0, 4));
          p[axis] = one_of(&random, least[axis], most[axis]);
          d[axis] = u < 0.3 ? one_of(&random, 0.0, -0.0)
            : floor(support_between(&random, -9, 10));
          o[axis] = p[axis] - t * d[axis];
        }
      struct k_bounds box = {
        k_scale(k_vec(least[0], least[1], least[2]), scale),
        k_scale(k_vec(most[0], most[1], most[2]), scale)
      };
      struct k_vec inverse = k_vec(1 / d[0], 1 / d[1], 1 / d[2]);
      struct k_vec from = k_scale(k_vec(o[0], o[1], o[2]), scale);
      missed += !k_bounds_hit(&box, from, inverse, t * scale);
      // A box that is larger than this one by 1 all round and lies behind.
      struct k_vec one = k_vec(scale, scale, scale);
      struct k_vec behind = k_along(from, -9 * scale,
                                    k_vec(d[0], d[1], d[2]));
      struct k_bounds back = { k_sub(behind, one), k_add(behind, one) };
      false_hits += (d[0] != 0 || d[1] != 0 || d[2] != 0)
        && k_bounds_hit(&back, from, inverse, HUGE_VAL);
    }
  PASS(missed == 0, "a million rays at corners of boxes: %u miss", missed);
  PASS(false_hits == 0, "a box behind is not met: %u", false_hits);
}

/** What a class of one's own may say of itself: no scene is broken by it. */
static void
odd_boxes(void)
{
  static const struct
  {
    const char *what;
    struct k_bounds box;
    int is_asked;
  } odd[] = {
    { "a point", { { 1, 2, 3 }, { 1, 2, 3 } }, 1 },
    { "nothing", { { HUGE_VAL, HUGE_VAL, HUGE_VAL },
                   { -HUGE_VAL, -HUGE_VAL, -HUGE_VAL } }, 0 },
    { "all doubles", { { -DBL_MAX, -DBL_MAX, -DBL_MAX },
                       { DBL_MAX, DBL_MAX, DBL_MAX } }, 1 },
    { "half of space", { { -HUGE_VAL, 0, -HUGE_VAL },
                         { HUGE_VAL, HUGE_VAL, HUGE_VAL } }, 1 }
  };
  const struct k_isa *isas[4];
  unsigned count = kernel_isas(isas);

  for (unsigned i = 0; i < sizeof odd / sizeof *odd; i++)
    {
      // Only such boxes, and next to one as usual.
      for (int others = 0; others < 2; others++)
        {
          struct k_scene *scene = k_scene_new();
          struct k_material material = { .ior = 1 };
          struct k_settings settings = { .threads = 2 };
          struct counters counters = { 0 };
          unsigned wrong = 0;
          k_add_material(scene, &material);
          for (unsigned n = 0; n < 40; n++)
            {
              struct k_surface s = { .number = n + 1 };
              struct k_user user = { remember, &asked[n], odd[i].box };
              k_add_user(scene, s, user);
            }
          if (others)
            {
              struct k_surface s = { .number = 99 };
              k_add_sphere(scene, s, k_vec(5, 5, 5), 0.5);
            }
          PASS(k_scene_finish(scene, settings) == K_OK,
               "forty boxes of %s%s", odd[i].what, others ? " and one" : "");
          for (unsigned j = 0; j < count; j++)
            {
              struct k_vec o = k_vec(5, 0, 5), p = k_vec(-5, 9, 3);
              struct k_ray ray = kernel_ray(o, k_vec(0, 1, 0), &counters);
              isas[j]->closest(scene, &ray);
              wrong += others != (ray.hit.surface != NULL);
              ray = kernel_ray(p, k_unit(k_sub(k_vec(1, 2, 3), p)),
                               &counters);
              now++;
              isas[j]->closest(scene, &ray);
              for (unsigned n = 0; n < 40; n++)
                {
                  wrong += odd[i].is_asked != (asked[n] == now);
                }
            }
          PASS(wrong == 0, "asked, or not, as they should be: %u wrong",
               wrong);
          k_scene_free(scene);
        }
    }
}

int
main(void)
{
  NSAutoreleasePool *pool = [[NSAutoreleasePool alloc] init];

  trees();
  one_box();
  odd_boxes();
  [pool release];
  return test_done();
}
