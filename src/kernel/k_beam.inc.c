// k_beam.inc.c - the search through the tree for rays that go much the same
// way. A shaft of four planes holds them all; a node whose box is outside of it
// is left out for all at once. What is inside is tested against each ray's
// float twin, and from where few rays are left on, each goes alone.
//
// As in k_search.inc.c floats only decide what is asked, and never leave out
// what is hit: shaft and boxes have margins for all that is rounded.

#include "k_search.inc.c"
#include "k_leaf_many.inc.c"

// Fewer rays than this are not worth a shaft.
#define FEW 8

// So many rays that are left in a box go on alone.
#define ALONE 8

// A shaft is made of rays that run along one axis by this much at least: their
// slopes against it are then less than 4.
#define ALONG 0.25f

// How far the planes of a shaft are moved out, and its ends.
#define SHAFT_PAD 0x1p-18f

struct k_shaft
{
  int x, y, z_near, z_far;      // which bounds of a node
  int z[4];                     // that of z for each plane
  float slope[4], at[4];        // planes: slope * z - x <= at, or >= for 1, 3
  float sign;                   // which way along z
  float z_least, z_most;        // of sign * z
};

#define GROUPS (K_MANY / 8)     // of eight rays, at most
#define EACH_GROUP(g, beam) (int g = 0; g == 0 || g < (beam)->groups; g++)

/** A float of each ray. */
union k_lanes
{
  f8 all[GROUPS];
  float of[K_MANY];
};

struct k_beam
{
  struct k_ray *rays;
  unsigned n;
  int groups;                   // of eight rays, that n rays take
  int is_from_one;              // all rays start at one point, as floats
  f8 o[3][GROUPS], d[3][GROUPS];
  union k_lanes inverse[3];
  union k_lanes near_o[3], far_o[3];    // as in k_float_ray
  union k_lanes t_most;
  struct k_shaft shaft;
  struct k_many many;
};

static inline float
k_least(const struct k_beam *beam, const f8 x[GROUPS])
{
  f8 m = x[0];

  for (int g = 1; g < beam->groups; g++)
    {
      m = f8_min(x[g], m);
    }
  return f8_least(m);
}

static inline float
k_most(const struct k_beam *beam, const f8 x[GROUPS])
{
  f8 m = x[0];

  for (int g = 1; g < beam->groups; g++)
    {
      m = f8_max(x[g], m);
    }
  return f8_most(m);
}

static inline f8
f8_abs(f8 a)
{
  return f8_max(f8_sub(f8_all(0), a), a);
}

/** How far a ray looks still: infinitely far back if it wants nothing, which
    stays that at any scale. */
static inline double
k_beam_reach(const struct k_ray *ray)
{
  return ray->is_feeler && ray->hit.surface ? -HUGE_VAL : k_ray_reach(ray);
}

/** Four rays from number i on; after the last, the first again, which then
    wants nothing. */
static inline void
k_beam_take_four(struct k_beam *beam, const struct k_scene *scene, unsigned i)
{
  struct k_many *many = &beam->many;
  const double *from[4], *to[4];

  for (unsigned j = 0; j < 4; j++)
    {
      const struct k_ray *ray = &beam->rays[i + j < beam->n ? i + j : 0];
      from[j] = &ray->o.x;
      to[j] = &ray->d.x;
      many->reach[i + j] = i + j < beam->n ? k_beam_reach(ray) : -HUGE_VAL;
      many->from |= ray->from ? 1ull << (ray->from->number & 63) : 0;
      many->slack[i + j] = ray->from ? ray->slack : -HUGE_VAL;
      many->end_slack[i + j] = ray->end_slack;
    }
  d4_turn_four(from, &many->o[0][i], &many->o[1][i], &many->o[2][i]);
  d4_turn_four(to, &many->d[0][i], &many->d[1][i], &many->d[2][i]);
  f4 t_most = d4_to_f4(d4_mul(d4_load(&many->reach[i]),
                              d4_all(scene->tree.scale)));
  f4_store(&beam->t_most.of[i], f4_mul(t_most, f4_all(REACH_MORE)));
}

/** The rays as doubles and as floats, in the tree's coordinates; lanes without
    a ray are like the first. 0: one comes from too far. */
static inline int
k_beam_start(struct k_beam *beam, const struct k_scene *scene,
             struct k_ray *rays, unsigned n)
{
  const struct k_tree *tree = &scene->tree;
  float o[3][K_MANY], d[3][K_MANY];
  f8 farthest = f8_all(0);

  beam->rays = rays;
  beam->n = n;
  beam->groups = (n + 7) / 8;
  beam->many.from = 0;
  for (unsigned i = 0; i < 8u * beam->groups; i += 4)
    {
      k_beam_take_four(beam, scene, i);
      for (int axis = 0; axis < 3; axis++)
        {
          d4 from = d4_sub(d4_load(&beam->many.o[axis][i]),
                           d4_all(k_component(tree->center, axis)));
          f4_store(&o[axis][i], d4_to_f4(d4_mul(from, d4_all(tree->scale))));
          f4_store(&d[axis][i], d4_to_f4(d4_load(&beam->many.d[axis][i])));
        }
    }
  beam->is_from_one = 1;
  for EACH_GROUP (g, beam)
    {
      f8 far = f8_all(1);
      for (int axis = 0; axis < 3; axis++)
        {
          f8 first = f8_all(o[axis][0]);
          beam->o[axis][g] = f8_load(o[axis] + 8 * g);
          beam->is_from_one &= (f8_le(beam->o[axis][g], first)
                                & f8_le(first, beam->o[axis][g])) == 0xff;
          beam->d[axis][g] = f8_load(d[axis] + 8 * g);
          far = f8_max(f8_abs(beam->o[axis][g]), far);
        }
      farthest = f8_max(far, farthest);
      f8 pad = f8_mul(f8_all(2 * PAD), far);
      for (int axis = 0; axis < 3; axis++)
        {
          f8 inverse = f8_div(f8_all(1), beam->d[axis][g]);
          inverse = f8_min(f8_all(STEEP), inverse);
          inverse = f8_max(f8_all(-STEEP), inverse);
          f8 slack = f8_mul(pad, f8_abs(inverse));
          f8 middle = f8_mul(beam->o[axis][g], inverse);
          beam->inverse[axis].all[g] = inverse;
          beam->near_o[axis].all[g] = f8_add(middle, slack);
          beam->far_o[axis].all[g] = f8_sub(middle, slack);
        }
    }
  return f8_most(farthest) < FAR;
}

/** A little more than x, or less. */
static inline float
k_pad(float x, float pad)
{
  return x + pad * (1 + fabsf(x));
}

/** How far along sign * z any of the rays still reaches. */
static inline float
k_beam_z_most(const struct k_beam *beam, int z)
{
  f8 end[GROUPS];

  for EACH_GROUP (g, beam)
    {
      end[g] = f8_mul(f8_all(beam->shaft.sign),
                      f8_add(beam->o[z][g], f8_mul(beam->t_most.all[g],
                                                   beam->d[z][g])));
    }
  return k_pad(k_most(beam, end), SHAFT_PAD);
}

/** Two planes of the shaft, that bound x against z, for rays that come from
    `from`, or each from its own o (from NULL). */
static inline void
k_shaft_planes(struct k_beam *beam, int side, int x, int z,
               const float *from)
{
  struct k_shaft *shaft = &beam->shaft;
  f8 slope[GROUPS], low[GROUPS], high[GROUPS], far = f8_all(1);

  for EACH_GROUP (g, beam)
    {
      slope[g] = f8_mul(beam->d[x][g], beam->inverse[z].all[g]);
    }
  // Of x against z, whichever way the rays go along z.
  float least = k_least(beam, slope), most = k_most(beam, slope);
  // Those that bound x from below and above while sign * z grows.
  float below = shaft->sign > 0 ? least : most;
  float above = shaft->sign > 0 ? most : least;
  // Inside: below * z - x <= that of the ray with the most, and so on.
  if (from)
    {
      float pad = SHAFT_PAD * (1 + fabsf(from[x]) + fabsf(from[z]));
      shaft->at[side] = below * from[z] - from[x] + pad;
      shaft->at[side + 1] = above * from[z] - from[x] - pad;
    }
  else
    {
      const f8 *ox = beam->o[x], *oz = beam->o[z];
      for EACH_GROUP (g, beam)
        {
          low[g] = f8_multiply_subtract(f8_all(below), oz[g], ox[g]);
          high[g] = f8_multiply_subtract(f8_all(above), oz[g], ox[g]);
          far = f8_max(f8_abs(ox[g]), far);
          far = f8_max(f8_abs(oz[g]), far);
        }
      float pad = SHAFT_PAD * f8_most(far);
      shaft->at[side] = k_most(beam, low) + pad;
      shaft->at[side + 1] = k_least(beam, high) - pad;
    }
  shaft->slope[side] = below;
  shaft->slope[side + 1] = above;
  shaft->z[side] = below > 0 ? z : z + 3;
  shaft->z[side + 1] = above > 0 ? z + 3 : z;
}

/** 0: the rays do not go the same way. */
static inline int
k_shaft_start(struct k_beam *beam, const struct k_scene *scene,
              int is_feeler)
{
  struct k_shaft *shaft = &beam->shaft;
  const struct k_ray *first = beam->rays;
  double ax = fabs(first->d.x), ay = fabs(first->d.y);
  double az = fabs(first->d.z);
  int z = ax > ay ? (ax > az ? 0 : 2) : (ay > az ? 1 : 2);
  int x = z == 2 ? 0 : z + 1, y = x == 2 ? 0 : x + 1;
  int rises = k_component(first->d, z) > 0;
  float from[3];

  if ((rises ? k_least(beam, beam->d[z]) : -k_most(beam, beam->d[z]))
      < ALONG)
    {
      return 0;
    }
  if (is_feeler || beam->is_from_one)
    {
      // Feelers are taken from the light, where they all meet.
      struct k_vec o = is_feeler ? k_along(first->o, first->end, first->d)
        : first->o;
      o = k_scale(k_sub(o, scene->tree.center), scene->tree.scale);
      from[0] = o.x;
      from[1] = o.y;
      from[2] = o.z;
      rises ^= is_feeler;
    }
  const float *one = is_feeler || beam->is_from_one ? from : NULL;
  shaft->sign = rises ? 1 : -1;
  shaft->x = x;
  shaft->y = y;
  shaft->z_near = rises ? z : z + 3;
  shaft->z_far = rises ? z + 3 : z;
  if (scene->polygon_count)
    {
      k_many_shear(&beam->many, 8u * beam->groups, x, y, z);
    }
  k_shaft_planes(beam, 0, x, z, one);
  k_shaft_planes(beam, 2, y, z, one);
  float least = one ? shaft->sign * from[z]
    : rises ? k_least(beam, beam->o[z]) : -k_most(beam, beam->o[z]);
  shaft->z_least = -k_pad(-least, SHAFT_PAD);
  shaft->z_most = !is_feeler ? k_beam_z_most(beam, z)
    : k_pad(rises ? k_most(beam, beam->o[z]) : -k_least(beam, beam->o[z]),
            SHAFT_PAD);
  return !one || fabsf(from[0]) + fabsf(from[1]) + fabsf(from[2]) < FAR;
}

/** Which boxes of a node are in the shaft, at least in part, and where they
    begin. */
static inline unsigned
k_shaft_test(const struct k_node *node, const struct k_shaft *s, f8 *z_in)
{
  const float (*b)[K_WIDTH] = node->bounds;
  f8 sign = f8_all(s->sign);
  f8 near = f8_mul(sign, f8_load(b[s->z_near]));
  f8 far = f8_mul(sign, f8_load(b[s->z_far]));
  f8 v0 = f8_multiply_subtract(f8_all(s->slope[0]), f8_load(b[s->z[0]]),
                               f8_load(b[s->x + 3]));
  f8 v1 = f8_multiply_subtract(f8_all(s->slope[1]), f8_load(b[s->z[1]]),
                               f8_load(b[s->x]));
  f8 v2 = f8_multiply_subtract(f8_all(s->slope[2]), f8_load(b[s->z[2]]),
                               f8_load(b[s->y + 3]));
  f8 v3 = f8_multiply_subtract(f8_all(s->slope[3]), f8_load(b[s->z[3]]),
                               f8_load(b[s->y]));

  *z_in = near;
  return f8_le(near, f8_all(s->z_most)) & f8_le(f8_all(s->z_least), far)
    & f8_le(v0, f8_all(s->at[0])) & f8_le(f8_all(s->at[1]), v1)
    & f8_le(v2, f8_all(s->at[2])) & f8_le(f8_all(s->at[3]), v3);
}

/** Which rays may meet box i of a node. */
static inline unsigned
k_beam_test(const struct k_beam *beam, const struct k_node *node, unsigned i)
{
  unsigned lanes = 0;

  for EACH_GROUP (g, beam)
    {
      f8 in = f8_all(0), out = beam->t_most.all[g];
      for (int axis = 0; axis < 3; axis++)
        {
          f8 inverse = beam->inverse[axis].all[g];
          f8 a = f8_mul(f8_all(node->bounds[axis][i]), inverse);
          f8 b = f8_mul(f8_all(node->bounds[axis + 3][i]), inverse);
          in = f8_max(f8_sub(f8_min(a, b), beam->near_o[axis].all[g]), in);
          out = f8_min(f8_sub(f8_max(a, b), beam->far_o[axis].all[g]), out);
        }
      lanes |= f8_le(in, out) << (8 * g);
    }
  return lanes;
}

/** A box on the stack: node * K_WIDTH + slot, and where it begins along the
    shaft, which may be less than 0. */
struct entry
{
  uint32_t child;
  float t;
};

/** Puts all boxes on the stack, the nearest on top. */
static inline struct entry *
k_push_sorted(uint32_t node, unsigned hits, f8 z_in, struct entry *top)
{
  float z[K_WIDTH];
  struct entry *bottom = top;

  f8_store(z, z_in);
  for (; hits; hits &= hits - 1)
    {
      unsigned i = __builtin_ctz(hits);
      struct entry e = { node * K_WIDTH + i, z[i] };
      struct entry *p = top++;
      while (p > bottom && p[-1].t < e.t)
        {
          *p = p[-1];
          p--;
        }
      *p = e;
    }
  return top;
}

static inline struct entry *
k_push_all(uint32_t node, unsigned hits, struct entry *top)
{
  for (; hits; hits &= hits - 1)
    {
      top->child = node * K_WIDTH + __builtin_ctz(hits);
      top++->t = 0;
    }
  return top;
}

/** One ray of the beam as floats. */
static inline void
k_lane(struct k_float_ray *f, const struct k_beam *beam, unsigned i)
{
  for (int axis = 0; axis < 3; axis++)
    {
      k_float_ray_set(f, axis, beam->inverse[axis].of[i],
                      beam->near_o[axis].of[i], beam->far_o[axis].of[i]);
    }
}

/** Ray i has hit something: how far it looks now. */
static inline void
k_beam_told(struct k_beam *beam, const struct k_scene *scene, unsigned i)
{
  const struct k_ray *ray = &beam->rays[i];

  beam->many.reach[i] = k_beam_reach(ray);
  beam->t_most.of[i] = ray->is_feeler ? -1 : k_reach_float(scene, ray);
}

/** Asks all shapes below a node, for one ray after the other. Bit by bit: who
    has hit something. */
static inline uint32_t
k_beam_ask_alone(const struct k_scene *scene, struct k_beam *beam,
                 uint32_t lanes, uint32_t node)
{
  uint32_t hits = 0;

  for (; lanes; lanes &= lanes - 1)
    {
      unsigned i = __builtin_ctz(lanes);
      double t = beam->rays[i].hit.t;
      struct k_float_ray f;
      k_lane(&f, beam, i);
      k_tree_walk(scene, &beam->rays[i], &f, node);
      if (beam->rays[i].hit.t < t)
        {
          hits |= 1u << i;
          k_beam_told(beam, scene, i);
        }
    }
  return hits;
}

/** The same for the shapes of a leaf: one after the other, for all rays. */
static inline uint32_t
k_beam_ask_leaf(const struct k_scene *scene, struct k_beam *beam,
                uint32_t lanes, uint32_t leaf, int is_feeler)
{
  const struct k_ref *ref = &scene->tree.refs[(leaf & ~K_LEAF) >> 3];
  unsigned n = (leaf & 7) + 1;
  uint32_t hits = 0;

  for (; n && lanes; n--, ref++)
    {
      beam->rays->counters->tests += __builtin_popcount(lanes);
      struct k_told told = k_ref_many(scene, *ref, &beam->many, beam->rays,
                                      lanes, is_feeler);
      for (uint32_t left = told.others; left; left &= left - 1)
        {
          unsigned i = __builtin_ctz(left);
          double t = beam->rays[i].hit.t;
          k_ref_ask(scene, *ref, &beam->rays[i]);
          told.hits |= (uint32_t)(beam->rays[i].hit.t < t) << i;
        }
      for (uint32_t left = told.hits; left; left &= left - 1)
        {
          k_beam_told(beam, scene, __builtin_ctz(left));
        }
      hits |= told.hits;
      lanes &= is_feeler ? ~hits : ~0u;
    }
  return hits;
}

static inline void
k_beam_ask(const struct k_scene *scene, struct k_beam *beam, int is_feeler)
{
  const struct k_tree *tree = &scene->tree;
  struct entry stack[STACK + K_WIDTH], *top = stack;
  struct k_shaft *shaft = &beam->shaft;
  unsigned live = (1ull << beam->n) - 1;  // feelers that nothing blocks yet
  uint32_t at = 0;
  int z = shaft->z_near % 3;

  for (;;)
    {
      const struct k_node *node = &tree->nodes[at];
      f8 z_in;
      beam->rays->counters->nodes++;
      unsigned hits = k_shaft_test(node, shaft, &z_in);
      top = is_feeler ? k_push_all(at, hits, top)
        : k_push_sorted(at, hits, z_in, top);
      for (;;)
        {
          if (top == stack)
            {
              return;
            }
          struct entry e = *--top;
          if (!is_feeler && e.t > shaft->z_most)
            {
              continue;
            }
          node = &tree->nodes[e.child / K_WIDTH];
          unsigned lanes = k_beam_test(beam, node, e.child % K_WIDTH);
          if (lanes == 0)
            {
              continue;
            }
          uint32_t child = node->child[e.child % K_WIDTH];
          if (!(child & K_LEAF) && __builtin_popcount(lanes) > ALONE)
            {
              at = child;
              break;
            }
          uint32_t hits_now = child & K_LEAF
            ? k_beam_ask_leaf(scene, beam, lanes, child, is_feeler)
            : k_beam_ask_alone(scene, beam, lanes, child);
          live &= ~hits_now;
          if (hits_now && live == 0)
            {
              if (is_feeler)
                {
                  return;
                }
              shaft->z_most = k_beam_z_most(beam, z);
            }
        }
    }
}

/** The nearest hits of n <= K_MANY rays; of feelers, which must go to one
    light, whether anything is in their way. */
static inline void
k_find_many(const struct k_scene *scene, struct k_ray *rays, unsigned n,
            int is_feeler)
{
  struct k_beam beam;

  if (n < FEW || !scene->tree.nodes)
    {
      for (unsigned i = 0; i < n; i++)
        {
          K_CLOSEST(scene, &rays[i]);
        }
      return;
    }
  for (unsigned i = 0; i < n; i++)
    {
      k_ask_unbounded(scene, &rays[i]);
    }
  if (k_beam_start(&beam, scene, rays, n)
      && k_shaft_start(&beam, scene, is_feeler))
    {
      k_beam_ask(scene, &beam, is_feeler);
      return;
    }
  for (unsigned i = 0; i < n; i++)
    {
      if (!(is_feeler && rays[i].hit.surface))
        {
          k_tree_ask(scene, &rays[i]);
        }
    }
}
