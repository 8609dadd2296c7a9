// cut.h - which rays are not worth tracing, and how far off the picture may be
// for it. A branch of the tree of rays has a weight: the part of its colour
// that reaches the eye. What it could have carried is known from above
// (brightest_t), so a branch that is cut leaves an error of at most its weight
// times that. What a light gives when it arrives is known before a feeler is
// sent; a feeler that is cut leaves no more than that times the weight. ray_t
// and kernel/k_trace.inc.c call these, in the same order: both engines cut the
// same rays.

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
  double min_weight;    // cut branches that weigh less in every channel
  double max_error;     // of an eye ray's colour, the most that cuts may leave;
                        // not above 0: no such limit, and no feeler is cut
  unsigned generations; // deepest generation of the picture that errors are
                        // counted from
  const struct cut_most *most;  // [g]: of a ray that g generations may follow;
  unsigned most_count;          // the last one holds for all more
};

/** Whether rays are cut and errors told. A program made with -DNO_CUTS never
    does: bench/trade/cost. */
static inline int
cut_is_on(const struct cut_rule *rule)
{
#ifdef NO_CUTS
  return 0;
#else
  return rule->is_on;
#endif
}

/** A ray as a branch of the tree. */
struct cut
{
  struct k_vec weight;  // of its colour in that of the eye ray
  double budget;        // error that it and what it spawns may leave
  double error;         // that they have left so far
};

/** An eye ray. Its budget is a little less than max_error, for the rounding of
    what is added up. */
static inline struct cut
cut_eye(const struct cut_rule *rule)
{
  struct cut cut = { { 1, 1, 1 }, rule->max_error * (1 - 0x1p-30), 0 };

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
  double loss[2];       // what would be lost without it, at most; without
                        // max_error only known when it is cut
  unsigned depth;       // their generation
  double dis;           // where they start
};

/** The larger of two colours, channel by channel. */
static inline struct k_vec
cut_larger(struct k_vec a, struct k_vec b)
{
  return k_vec(k_max2(a.x, b.x), k_max2(a.y, b.y), k_max2(a.z, b.z));
}

/** The most that a branch of generation `depth`, which starts `dis` from the
    eye, can bring back. */
static inline __attribute__((always_inline)) struct k_vec
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
    : k_add(dis > 0 ? k_div(m->ambient, dis)
            : k_vec(HUGE_VAL, HUGE_VAL, HUGE_VAL), m->rest);
}

/** The largest channel of weight times most; a little more, for what has been
    rounded. Nothing of something infinite is nothing: k_max2 leaves its first
    number out when it is none. */
static inline double
cut_loss(struct k_vec weight, struct k_vec most)
{
  double z = k_max2(weight.z * most.z, 0);
  double y = k_max2(weight.y * most.y, z);

  return (1 + 0x1p-30) * k_max2(weight.x * most.x, y);
}

/** Both branches of a ray that has hit something at the end of its path
    `dis`; they are of generation `depth`. A branch that does not exist loses
    nothing. The factors are those of shade_mirror and
    shade_blend. */
static inline __attribute__((always_inline)) void
cut_pair(struct cut_pair *pair, const struct cut_rule *rule,
         const struct cut *parent, struct k_vec specular, double alpha,
         double R, unsigned depth, double dis)
{
  struct k_vec share = specular;
  double through = 0;

  if (alpha > 0)
    {
      double bounce = alpha * R;
      share = k_add(k_scale(specular, 1 - alpha),
                    k_vec(bounce, bounce, bounce));
      through = alpha * (1 - R);
      pair->weight[CUT_REFRACTED] = k_scale(parent->weight, through);
    }
  pair->weight[CUT_REFLECTED] = k_mul(parent->weight, share);
  pair->depth = depth;
  pair->dis = dis;
  if (rule->max_error > 0)
    {
      struct k_vec most = cut_most(rule, depth, dis);
      pair->loss[CUT_REFLECTED] = cut_loss(pair->weight[CUT_REFLECTED], most);
      pair->loss[CUT_REFRACTED] = through > 0
        ? cut_loss(pair->weight[CUT_REFRACTED], most) : 0;
    }
}

// How much of what is left the first of two branches may lose. Measured on the
// scenes of scenes/ with --max-error from 0.1 to 10^-6: with half up to 1.2
// times as many rays are traced, with 0.9 four times as many among bubbles.
#define CUT_FIRST 0.78

/** Whether a branch is cut for max_error. If not, it gets its part of what its
    parent may still lose: all of it when nothing comes after it. */
static inline int
cut_is_affordable(struct cut *parent, const struct cut_pair *pair,
                  enum cut_which which, struct cut *branch)
{
  double loss = pair->loss[which];
  double other = which == CUT_REFLECTED ? pair->loss[CUT_REFRACTED] : 0;
  double left = parent->budget - parent->error;

  branch->budget = other == 0 ? left : left * CUT_FIRST;
  return loss + other <= left || loss <= branch->budget;
}

/** Whether no channel of a weight reaches min_weight. */
static inline int
cut_is_light(struct k_vec w, double min_weight)
{
  return w.x < min_weight && w.y < min_weight && w.z < min_weight;
}

/** Whether a branch is cut. If not, *branch is what it is as one. */
static inline __attribute__((always_inline)) int
cut_is(const struct cut_rule *rule, struct cut *parent,
       struct cut_pair *pair, enum cut_which which, int is_too_deep,
       struct cut *branch)
{
  struct k_vec w = pair->weight[which];
  int has_limit = rule->max_error > 0;

  if ((has_limit && cut_is_affordable(parent, pair, which, branch))
      || is_too_deep || cut_is_light(w, rule->min_weight))
    {
      pair->loss[which] = has_limit ? pair->loss[which]
        : cut_loss(w, cut_most(rule, pair->depth, pair->dis));
      parent->error += pair->loss[which];
      return 1;
    }
  branch->weight = w;
  branch->error = 0;
  return 0;
}

/** How far off a colour is at most when a feeler from the point that its ray
    hits is not sent and the light is taken to arrive, but for the highlight:
    `lit` is what there is of the light then, `shadow` what there would be in
    shadow. They count as shade_mirror and shade_blend have it. */
static inline struct k_vec
cut_feeler_off(struct k_vec diffuse, int is_mirror, double alpha,
               struct k_vec lit, struct k_vec shadow)
{
  struct k_vec off = k_scale(cut_larger(lit, shadow), 1 - alpha);

  return is_mirror ? k_mul(diffuse, off) : off;
}

/** Whether a ray's colour may be off by so much more. What is not a number may
    not be. */
static inline int
cut_is_left(const struct cut *cut, struct k_vec off)
{
  struct k_vec loss = k_mul(cut->weight, off);
  double left = (cut->budget - cut->error) * (1 - 0x1p-29);

  return loss.x <= left && loss.y <= left && loss.z <= left;
}

/** Whether a feeler is cut without which the colour may be off by so much, once
    the ray's branches are traced or cut. */
static inline int
cut_feeler_is(struct cut *cut, struct k_vec off)
{
  int is_cut = cut_is_left(cut, off);

  cut->error += is_cut ? cut_loss(cut->weight, off) : 0;
  return is_cut;
}

/** What a branch that was traced has lost is lost to its parent. */
static inline void
cut_add(struct cut *parent, const struct cut *branch)
{
  parent->error += branch->error;
}

#endif
