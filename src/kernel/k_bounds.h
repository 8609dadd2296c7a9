// k_bounds.h - an axis-aligned box and the test whether a ray may meet what
// is in it: it never says no to a ray that does.
//
// The test is the slab test in the form that has no false misses: true
// infinities as reciprocals, near and far side chosen by the sign bit of the
// direction, comparisons that take a NaN (0 times infinity, a ray in the
// plane of a face) as "no constraint", and the far side moved out by the
// rounding of three operations (Ize, "Robust BVH Ray Traversal", JCGT 2013).

#ifndef K_BOUNDS_H
#define K_BOUNDS_H

#include "k_vec.h"

struct k_bounds
{
  struct k_vec least, most;
};

/** The box of a shape that has none. */
static inline struct k_bounds
k_unbounded(void)
{
  struct k_bounds b = { { -HUGE_VAL, -HUGE_VAL, -HUGE_VAL },
                        { HUGE_VAL, HUGE_VAL, HUGE_VAL } };
  return b;
}

/** The box that is in every box: grows with k_bounds_include. */
static inline struct k_bounds
k_nothing(void)
{
  struct k_bounds b = { { HUGE_VAL, HUGE_VAL, HUGE_VAL },
                        { -HUGE_VAL, -HUGE_VAL, -HUGE_VAL } };
  return b;
}

/** The box round both; k_nothing() adds nothing. */
static inline struct k_bounds
k_bounds_join(struct k_bounds a, struct k_bounds b)
{
  a.least.x = b.least.x < a.least.x ? b.least.x : a.least.x;
  a.least.y = b.least.y < a.least.y ? b.least.y : a.least.y;
  a.least.z = b.least.z < a.least.z ? b.least.z : a.least.z;
  a.most.x = b.most.x > a.most.x ? b.most.x : a.most.x;
  a.most.y = b.most.y > a.most.y ? b.most.y : a.most.y;
  a.most.z = b.most.z > a.most.z ? b.most.z : a.most.z;
  return a;
}

static inline int
k_is_unbounded(struct k_bounds b)
{
  return !(b.least.x > -HUGE_VAL && b.least.y > -HUGE_VAL
           && b.least.z > -HUGE_VAL && b.most.x < HUGE_VAL
           && b.most.y < HUGE_VAL && b.most.z < HUGE_VAL);
}

static inline struct k_bounds
k_bounds_include(struct k_bounds b, struct k_vec p)
{
  struct k_bounds point = { p, p };

  return k_bounds_join(b, point);
}

/** The largest side. */
static inline double
k_bounds_extent(struct k_bounds b)
{
  return k_norm_max(k_sub(b.most, b.least));
}

/** Whether p is in the box or on it. */
static inline int
k_bounds_hold(const struct k_bounds *b, struct k_vec p)
{
  return b->least.x <= p.x && p.x <= b->most.x
    && b->least.y <= p.y && p.y <= b->most.y
    && b->least.z <= p.z && p.z <= b->most.z;
}

/** How far p is from the box; 0 in it. */
static inline double
k_bounds_distance(const struct k_bounds *b, struct k_vec p)
{
  double x = k_max2(0, k_max2(b->least.x - p.x, p.x - b->most.x));
  double y = k_max2(0, k_max2(b->least.y - p.y, p.y - b->most.y));
  double z = k_max2(0, k_max2(b->least.z - p.z, p.z - b->most.z));

  return k_length(k_vec(x, y, z));
}

/** Whether two boxes have a point in common. */
static inline int
k_bounds_overlap(const struct k_bounds *a, const struct k_bounds *b)
{
  return a->least.x <= b->most.x && b->least.x <= a->most.x
    && a->least.y <= b->most.y && b->least.y <= a->most.y
    && a->least.z <= b->most.z && b->least.z <= a->most.z;
}

/** The box grown on every side by 2^-40 of its magnitude, so that what is
    computed to lie on the shape lies in it, not only what would exactly. */
static inline struct k_bounds
k_bounds_pad(struct k_bounds b)
{
  double m = 0x1p-40 * k_max2(k_norm_max(b.least), k_norm_max(b.most));
  struct k_vec pad = k_vec(m, m, m);

  b.least = k_sub(b.least, pad);
  b.most = k_add(b.most, pad);
  return b;
}

/** One pair of sides. `inverse` is 1 / d, infinite for d = 0 with its sign. */
static inline void
k_slab(double least, double most, double o, double inverse,
       double *t_in, double *t_out)
{
  int falls = signbit(inverse) != 0;
  double t0 = ((falls ? most : least) - o) * inverse;
  double t1 = ((falls ? least : most) - o) * inverse;

  *t_in = t0 > *t_in ? t0 : *t_in;
  *t_out = t1 < *t_out ? t1 : *t_out;
}

/** Whether the ray from o may meet what is in the box at 0 <= t <= t_most.
    `inverse` holds the reciprocals of the direction. */
static inline int
k_bounds_hit(const struct k_bounds *b, struct k_vec o, struct k_vec inverse,
             double t_most)
{
  double t_in = 0;
  double t_out = t_most;

  k_slab(b->least.x, b->most.x, o.x, inverse.x, &t_in, &t_out);
  k_slab(b->least.y, b->most.y, o.y, inverse.y, &t_in, &t_out);
  k_slab(b->least.z, b->most.z, o.z, inverse.z, &t_in, &t_out);
  return t_in <= t_out * (1 + 8 * K_U);
}

#endif
