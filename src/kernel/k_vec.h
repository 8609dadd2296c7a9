// k_vec.h - a vector as a plain value: three doubles, passed and returned by
// copy. vec_t wraps one in an object; everything that must not allocate uses
// this. Only + - * / and sqrt, always in the order written here, so every
// compiler and every engine gets the same bits (docs/determinism.md).

#ifndef K_VEC_H
#define K_VEC_H

#include <math.h>

struct k_vec
{
  double x, y, z;
};

#define K_U 0x1p-53             // unit roundoff: half an ulp of 1

static inline struct k_vec
k_vec(double x, double y, double z)
{
  struct k_vec v = { x, y, z };
  return v;
}

static inline struct k_vec
k_add(struct k_vec a, struct k_vec b)
{
  return k_vec(a.x + b.x, a.y + b.y, a.z + b.z);
}

static inline struct k_vec
k_sub(struct k_vec a, struct k_vec b)
{
  return k_vec(a.x - b.x, a.y - b.y, a.z - b.z);
}

/** Product channel by channel: colours. */
static inline struct k_vec
k_mul(struct k_vec a, struct k_vec b)
{
  return k_vec(a.x * b.x, a.y * b.y, a.z * b.z);
}

static inline struct k_vec
k_scale(struct k_vec a, double s)
{
  return k_vec(a.x * s, a.y * s, a.z * s);
}

static inline struct k_vec
k_div(struct k_vec a, double s)
{
  return k_vec(a.x / s, a.y / s, a.z / s);
}

static inline struct k_vec
k_neg(struct k_vec a)
{
  return k_vec(-a.x, -a.y, -a.z);
}

/** The point a + t d. */
static inline struct k_vec
k_along(struct k_vec a, double t, struct k_vec d)
{
  return k_vec(a.x + t * d.x, a.y + t * d.y, a.z + t * d.z);
}

static inline double
k_dot(struct k_vec a, struct k_vec b)
{
  return a.x * b.x + a.y * b.y + a.z * b.z;
}

static inline struct k_vec
k_cross(struct k_vec a, struct k_vec b)
{
  return k_vec(a.y * b.z - a.z * b.y,
               a.z * b.x - a.x * b.z,
               a.x * b.y - a.y * b.x);
}

/** |x| + |y| + |z|: the magnitude that error bounds are made of. */
static inline double
k_norm1(struct k_vec a)
{
  return fabs(a.x) + fabs(a.y) + fabs(a.z);
}

static inline double
k_max2(double a, double b)
{
  return a > b ? a : b;
}

/** The largest of |x|, |y|, |z|. */
static inline double
k_norm_max(struct k_vec a)
{
  return k_max2(fabs(a.x), k_max2(fabs(a.y), fabs(a.z)));
}

static inline double
k_component(struct k_vec a, int axis)
{
  return axis == 0 ? a.x : axis == 1 ? a.y : a.z;
}

static inline int
k_is_zero(struct k_vec a)
{
  return a.x == 0 && a.y == 0 && a.z == 0;
}

static inline int
k_is_equal(struct k_vec a, struct k_vec b)
{
  return a.x == b.x && a.y == b.y && a.z == b.z;
}

/** A power of two near the largest component, so that dividing by it is
    exact and squares neither over- nor underflow; 0 for the zero vector. */
static inline double
k_exponent_scale(struct k_vec a)
{
  int e;
  double m = k_norm_max(a);

  if (m == 0)
    {
      return 0;
    }
  frexp(m, &e);
  return ldexp(1.0, e < -1000 ? -1000 : e > 1000 ? 1000 : e);
}

/** Length. Squares that would leave the range of a double are scaled by a
    power of two first, which changes no bit of the others. */
static inline double
k_length(struct k_vec a)
{
  double l2 = k_dot(a, a);

  if (l2 > 0x1p-900 && l2 < 0x1p900)
    {
      return sqrt(l2);
    }
  double s = k_exponent_scale(a);
  if (s == 0)
    {
      return 0;
    }
  a = k_div(a, s);
  return s * sqrt(k_dot(a, a));
}

/** a / |a|, at any magnitude; the zero vector stays zero. */
static inline struct k_vec
k_unit(struct k_vec a)
{
  double l2 = k_dot(a, a);

  if (!(l2 > 0x1p-900 && l2 < 0x1p900))
    {
      double s = k_exponent_scale(a);
      if (s == 0)
        {
          return a;
        }
      a = k_div(a, s);
      l2 = k_dot(a, a);
    }
  return k_div(a, sqrt(l2));
}

/** a / |a| and |a|, as k_unit and k_length have them. */
static inline struct k_vec
k_unit_length(struct k_vec a, double *length)
{
  double l2 = k_dot(a, a);

  if (l2 > 0x1p-900 && l2 < 0x1p900)
    {
      *length = sqrt(l2);
      return k_div(a, *length);
    }
  *length = k_length(a);
  return k_unit(a);
}

#endif
