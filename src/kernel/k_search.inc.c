// k_search.inc.c - one ray's search through the tree, compiled once for each
// instruction set by the k_isa_*.c, which name it.
//
// The boxes are tested in floats, which only decides what is asked; the shapes
// are asked in doubles, which decides the picture. So the test must never say
// no to a ray that hits: all boxes are taken larger by a margin that is more
// than everything that is rounded on the way.

#include "k_float.h"
#include "k_leaf.h"
#include "k_simd.h"

#define STACK (7 * K_DEEPEST)   // each level leaves at most 7 for later

// Farther from the scene than this, in units of its size, everything is asked.
#define FAR 0x1p30

// How much all boxes are grown, against all that is rounded in the test, for
// an origin within the scene; more in proportion if it is farther off.
#define PAD 0x1p-21

// A reciprocal is never taken larger: so flat a ray leaves no box sideways.
#define STEEP 0x1p60f

// More than rounding to floats takes from a length.
#define REACH_MORE 0x1.000002p0f

/** Beyond what a ray is interested in, in the tree's coordinates. */
static inline float
k_reach_float(const struct k_scene *scene, const struct k_ray *ray)
{
  return (float)(k_ray_reach(ray) * scene->tree.scale) * REACH_MORE;
}

/** Where a ray starts, in the tree's coordinates, and where it goes, as floats:
    x y z and something. */
static inline f4
k_float_o(const struct k_tree *tree, const struct k_ray *ray)
{
  d4 o = d4_load(&ray->o.x), center = d4_load(&tree->center.x);

  return d4_to_f4(d4_mul(d4_sub(o, center), d4_all(tree->scale)));
}

static inline f4
k_float_d(const struct k_ray *ray)
{
  return d4_to_f4(d4_load(&ray->d.x));
}

struct k_float_ray
{
  f8 inverse[3];
  f8 near_o[3], far_o[3];       // origin times inverse, with the pad
  int near_side[3], far_side[3];
};

/** The floats of one axis. */
static inline void
k_float_ray_set(struct k_float_ray *f, int axis, float inverse, float near_o,
                float far_o)
{
  int falls = inverse < 0;

  f->near_side[axis] = axis + 3 * falls;
  f->far_side[axis] = axis + 3 * !falls;
  f->inverse[axis] = f8_all(inverse);
  f->near_o[axis] = f8_all(near_o);
  f->far_o[axis] = f8_all(far_o);
}

/** 0: the ray comes from too far. */
static inline int
k_float_ray_start(struct k_float_ray *f, const struct k_tree *tree,
                  const struct k_ray *ray)
{
  f4 o = k_float_o(tree, ray);
  f4 i = f4_div(f4_all(1), k_float_d(ray));
  float far = f4_most_xyz(f4_abs(o));
  float inverse[4], near_o[4], far_o[4];

  i = f4_max(f4_all(-STEEP), f4_min(f4_all(STEEP), i));
  f4 slack = f4_mul(f4_all(2 * PAD * (far > 1 ? far : 1)), f4_abs(i));
  f4 middle = f4_mul(o, i);
  f4_store(inverse, i);
  f4_store(near_o, f4_add(middle, slack));
  f4_store(far_o, f4_sub(middle, slack));
  for (int axis = 0; axis < 3; axis++)
    {
      k_float_ray_set(f, axis, inverse[axis], near_o[axis], far_o[axis]);
    }
  return far < FAR;
}

/** Which boxes of a node the ray may meet before t_most, bit by bit, and
    where it goes in. */
static inline unsigned
k_node_test(const struct k_node *node, const struct k_float_ray *f,
            float t_most, f8 *t_in)
{
  f8 in = f8_all(0), out = f8_all(t_most);

  for (int axis = 0; axis < 3; axis++)
    {
      f8 near = f8_load(node->bounds[f->near_side[axis]]);
      f8 far = f8_load(node->bounds[f->far_side[axis]]);
      in = f8_max(f8_multiply_subtract(near, f->inverse[axis],
                                       f->near_o[axis]), in);
      out = f8_min(f8_multiply_subtract(far, f->inverse[axis],
                                        f->far_o[axis]), out);
    }
  *t_in = in;
  return f8_le(in, out);
}

/** Asks n shapes of the tree, those of one medium if the ray asks for no
    others. */
static __attribute__((noinline)) void
k_ask_some(const struct k_scene *scene, struct k_ray *ray,
           const struct k_ref *ref, uint32_t n)
{
  for (; n; n--, ref++)
    {
      if (ray->only && k_ref_medium(scene, *ref) != ray->only)
        {
          continue;
        }
      ray->counters->tests++;
      k_ref_ask(scene, *ref, ray);
    }
}

static inline void
k_leaf_ask(const struct k_scene *scene, struct k_ray *ray, uint32_t leaf)
{
  const struct k_ref *ref = &scene->tree.refs[(leaf & ~K_LEAF) >> 3];
  unsigned n = (leaf & 7) + 1;

  k_assume_eye(ray);
  if (ray->only)
    {
      k_ask_some(scene, ray, ref, n);
      return;
    }
  ray->counters->tests += n;
  for (; n; n--, ref++)
    {
      k_ref_ask(scene, *ref, ray);
    }
}

/** A child on the stack: where the ray goes in, and which. No t is below 0, so
    that its bits in front order entries as t does. */
static inline uint64_t
k_entry(uint32_t child, float t)
{
  uint32_t bits;

  memcpy(&bits, &t, sizeof bits);
  return (uint64_t)bits << 32 | child;
}

static inline float
k_entry_t(uint64_t entry)
{
  uint32_t bits = entry >> 32;
  float t;

  memcpy(&t, &bits, sizeof t);
  return t;
}

/** Puts the lesser of two first. */
static inline void
k_order(uint64_t *first, uint64_t *second)
{
  uint64_t a = *first, b = *second;

  *first = a < b ? a : b;
  *second = a < b ? b : a;
}

/** Puts all boxes that are hit on the stack but the nearest, the nearest of
    them on top; that one is returned. They are ordered without branches, which
    nobody could guess. */
static inline uint32_t
k_nearest_first(const struct k_node *node, unsigned hits, f8 t_in,
                uint64_t **top)
{
  float t[K_WIDTH];
  unsigned i = __builtin_ctz(hits);
  uint64_t *bottom = *top;

  if ((hits &= hits - 1) == 0)
    {
      return node->child[i];
    }
  f8_store(t, t_in);
  uint64_t nearest = k_entry(node->child[i], t[i]);
  do
    {
      i = __builtin_ctz(hits);
      uint64_t e = k_entry(node->child[i], t[i]);
      k_order(&nearest, &e);
      for (uint64_t *p = bottom; p < *top; p++)
        {
          k_order(&e, p);
        }
      *(*top)++ = e;
    }
  while (hits &= hits - 1);
  return (uint32_t)nearest;
}

/** The same in no order, for feelers, who take whatever blocks them. */
static inline uint32_t
k_any_first(const struct k_node *node, unsigned hits, uint64_t **top)
{
  unsigned i = __builtin_ctz(hits);

  while (hits &= hits - 1)
    {
      *(*top)++ = node->child[__builtin_ctz(hits)];
    }
  return node->child[i];
}

/** Asks what is below a node of the tree, with the ray as floats. */
static void
k_tree_walk(const struct k_scene *scene, struct k_ray *ray,
            const struct k_float_ray *f, uint32_t at)
{
  const struct k_tree *tree = &scene->tree;
  uint64_t stack[STACK], *top = stack;
  k_assume_eye(ray);
  float t_most = k_reach_float(scene, ray);

  for (;;)
    {
      unsigned hits = 0;
      if (at & K_LEAF)
        {
          k_leaf_ask(scene, ray, at);
          if (ray->is_feeler && ray->hit.surface)
            {
              return;
            }
          t_most = k_reach_float(scene, ray);
        }
      else
        {
          const struct k_node *node = &tree->nodes[at];
          f8 t_in;
          ray->counters->nodes++;
          hits = k_node_test(node, f, t_most, &t_in);
          if (hits)
            {
              at = ray->is_feeler ? k_any_first(node, hits, &top)
                : k_nearest_first(node, hits, t_in, &top);
            }
        }
      while (!hits)
        {
          if (top == stack)
            {
              return;
            }
          top--;
          at = (uint32_t)*top;
          hits = k_entry_t(*top) <= t_most;
        }
    }
}

/** Asks what is in the tree. */
static void
k_tree_ask(const struct k_scene *scene, struct k_ray *ray)
{
  struct k_float_ray f;

  k_assume_eye(ray);
  if (k_float_ray_start(&f, &scene->tree, ray))
    {
      k_tree_walk(scene, ray, &f, 0);
    }
  else
    {
      k_ask_some(scene, ray, scene->tree.refs, scene->tree.ref_count);
    }
}

/** Asks what is not in the tree. */
static inline __attribute__((always_inline)) void
k_ask_unbounded(const struct k_scene *scene, struct k_ray *ray)
{
  k_assume_eye(ray);
  if (ray->only)
    {
      return;                   // the faces of a mesh are in the tree
    }
  for (uint32_t i = 0; i < scene->plane_count; i++)
    {
      ray->counters->tests++;
      k_plane_ask(scene, &scene->planes[i], ray);
    }
  for (uint32_t i = 0; i < scene->unbounded_count; i++)
    {
      struct k_ref user = { K_USER, scene->unbounded[i] };
      ray->counters->tests++;
      k_ref_ask(scene, user, ray);
    }
}

static void
K_CLOSEST(const struct k_scene *scene, struct k_ray *ray)
{
  k_ask_unbounded(scene, ray);
  if (scene->tree.nodes && !(ray->is_feeler && ray->hit.surface))
    {
      k_tree_ask(scene, ray);
    }
}
