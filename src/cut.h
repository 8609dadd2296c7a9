// cut.h - which rays are not worth tracing, and how much the picture may lack
// for it. A branch of the tree of rays has a weight: the part of its colour
// that reaches the eye. What it could have carried is known from above
// (brightest_t), so a branch that is cut leaves an error of at most its weight
// times that. ray_t and kernel/k_trace.inc.c call these, in the same order:
// both engines cut the same branches.

#ifndef CUT_H
#define CUT_H

#include "kernel/k_vec.h"

/** What a ray can bring back at most, of each channel, when it starts `dis`
    from the eye: ambient / dis + rest. */
struct cut_most
{
  struct k_vec ambient, rest;
};

/** The deepest generation of the picture that errors are counted from, unless
    a deeper one is traced. */
#define CUT_GENERATIONS 1000

/** The same with a bound on the error (--max-error) and no other depth asked
    for. */
#define CUT_BOUND_GENERATIONS 20

/** When a branch is cut. */
struct cut_rule
{
  int is_on;            // otherwise only max_depth cuts, and no error is told
  double min_weight;    // cut what weighs less than this in every channel
  double max_error;     // of an eye ray's colour, the most that cuts may leave
  unsigned generations; // deepest generation of the picture that errors are
                        // counted from
  const struct cut_most *most;  // [g]: of a ray that g generations may follow;
  unsigned most_count;          // the last one holds for all more
};

/** A ray as a branch of the tree. */
struct cut
{
  struct k_vec weight;  // of its colour in that of the eye ray
  double budget;        // error that it and what it spawns may leave
  double error;         // that they have left so far
};

/** An eye ray. */
static inline struct cut
cut_eye(const struct cut_rule *rule)
{
  struct cut cut = { { 1, 1, 1 }, rule->max_error, 0 };

  return cut;
}

/** The two rays that a hit point can spawn, in the order in which they are
    traced. */
enum cut_which
{
  CUT_REFLECTED,
  CUT_REFRACTED
};

struct cut_pair
{
  struct k_vec weight[2];
  double loss[2];       // what would be lost without it, at most
};

/** The most that a branch of generation `depth`, which starts `dis` from the
    eye, can bring back. */
static inline struct k_vec
cut_most(const struct cut_rule *rule, unsigned depth, double dis)
{
  const struct cut_most *m;
  unsigned follow;

  if (depth > rule->generations)
    {
      return k_vec(0, 0, 0);
    }
  follow = rule->generations - depth;
  m = &rule->most[follow < rule->most_count ? follow : rule->most_count - 1];
  return k_is_zero(m->ambient) ? m->rest
    : k_add(k_vec(m->ambient.x == 0 ? 0 : m->ambient.x / dis,
                  m->ambient.y == 0 ? 0 : m->ambient.y / dis,
                  m->ambient.z == 0 ? 0 : m->ambient.z / dis), m->rest);
}

/** The largest channel of weight times most, where no weight of anything is
    nothing; a little more, for what has been rounded. */
static inline double
cut_loss(struct k_vec weight, struct k_vec most)
{
  double x = weight.x == 0 ? 0 : weight.x * most.x;
  double y = weight.y == 0 ? 0 : weight.y * most.y;
  double z = weight.z == 0 ? 0 : weight.z * most.z;

  return (1 + 0x1p-30) * k_max2(x, k_max2(y, z));
}

/** Both branches of a ray that has hit something at the end of its path
    `dis`; they are of generation `depth`. A branch that does not exist loses
    nothing. The factors are those of shade_mirror and shade_blend. */
static inline void
cut_pair(struct cut_pair *pair, const struct cut_rule *rule,
         const struct cut *parent, struct k_vec specular, double alpha,
         double R, unsigned depth, double dis)
{
  double bounce = alpha * R, through = alpha * (1 - R);
  struct k_vec share = k_add(k_scale(specular, 1 - alpha),
                             k_vec(bounce, bounce, bounce));
  struct k_vec most = cut_most(rule, depth, dis);

  pair->weight[CUT_REFLECTED] = k_mul(parent->weight, share);
  pair->loss[CUT_REFLECTED] = cut_loss(pair->weight[CUT_REFLECTED], most);
  pair->loss[CUT_REFRACTED] = 0;
  if (through > 0)
    {
      pair->weight[CUT_REFRACTED] = k_scale(parent->weight, through);
      pair->loss[CUT_REFRACTED] = cut_loss(pair->weight[CUT_REFRACTED], most);
    }
}

// How much of what is left the first of two branches may lose. Measured on the
// scenes of scenes/ with --max-error from 0.1 to 10^-6: with half 1.2 times as
// many rays are traced, with 0.9 four times as many among bubbles.
#define CUT_FIRST 0.75

/** Whether a branch is cut. If not, *branch gets its part of what its parent
    may still lose: all of it when nothing comes after it. */
static inline int
cut_is(const struct cut_rule *rule, struct cut *parent,
       const struct cut_pair *pair, enum cut_which which, int is_too_deep,
       struct cut *branch)
{
  struct k_vec w = pair->weight[which];
  double loss = pair->loss[which];
  double other = which == CUT_REFLECTED ? pair->loss[CUT_REFRACTED] : 0;
  double left = parent->budget - parent->error;
  double may_lose = other == 0 ? left : left * CUT_FIRST;

  if (is_too_deep || k_max2(w.x, k_max2(w.y, w.z)) < rule->min_weight
      || loss + other <= left || loss <= may_lose)
    {
      parent->error += loss;
      return 1;
    }
  branch->weight = w;
  branch->budget = may_lose;
  branch->error = 0;
  return 0;
}

/** What a branch that was traced has lost is lost to its parent. */
static inline void
cut_add(struct cut *parent, const struct cut *branch)
{
  parent->error += branch->error;
}

#endif
