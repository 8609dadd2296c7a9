// k_sphere_hit.h - where a ray meets a sphere. Notes, "transmission": sphere_t
// calculates both roots t0 and t1.
//
// The notes' -b +- sqrt(b^2 - 4ac) cancels twice: far from a small sphere in
// b^2 - 4ac, near the surface of a huge one in c. So the discriminant is taken
// from p, the point of the line nearest to the center (Haines, Gunther,
// Akenine-Moller, "Precision Improvements for Ray/Sphere Intersection", Ray
// Tracing Gems 7); and near the surface c is computed with the rounding errors
// of its own terms in it.

#ifndef K_SPHERE_HIT_H
#define K_SPHERE_HIT_H

#include "k_vec.h"

/** a + b = *s + *e exactly (Knuth). */
static inline void
k_two_sum(double a, double b, double *s, double *e)
{
  *s = a + b;
  double bb = *s - a;
  *e = (a - (*s - bb)) + (b - bb);
}

/** a * b = *p + *e exactly (Dekker; no fused multiply-add, which not every
    machine has). */
static inline void
k_two_product(double a, double b, double *p, double *e)
{
  const double split = 0x1p27 + 1;
  double ca = split * a, cb = split * b;
  double ah = ca - (ca - a), bh = cb - (cb - b);
  double al = a - ah, bl = b - bh;

  *p = a * b;
  *e = ((ah * bh - *p) + ah * bl + al * bh) + al * bl;
}

/** Adds x + e to the sum *s + *r of twice the precision of a double. */
static inline void
k_sum_add(double x, double e, double *s, double *r)
{
  double rounding;

  k_two_sum(*s, x, s, &rounding);
  *r += rounding + e;
}

/** |o - center|^2 - radius^2 with the rounding of every step, that of
    o - center too, taken along: negative inside, 0 on the surface. */
static inline double
k_sphere_power(struct k_vec o, struct k_vec center, double radius)
{
  const double from[3] = { o.x, o.y, o.z };
  const double to[3] = { center.x, center.y, center.z };
  double sum, rest, p, e;

  k_two_product(-radius, radius, &sum, &rest);
  for (int i = 0; i < 3; i++)
    {
      double f, fe;
      k_two_sum(from[i], -to[i], &f, &fe);
      k_two_product(f, f, &p, &e);
      k_sum_add(p, e + 2 * f * fe, &sum, &rest);
    }
  return sum + rest;
}

#define K_SPHERE_COMPENSATED 2

/** Both roots t0 <= t1 of the line o + t d (d unit) and the sphere, and p,
    the line's nearest point to the center, seen from the center; *s is half
    the distance between the roots. Returns 0 when the line misses, 1 when it
    meets the sphere (a tangent does), K_SPHERE_COMPENSATED when it does and o
    is so near the surface that c was computed with its rounding errors. */
static inline int
k_sphere_hit(struct k_vec o, struct k_vec d, struct k_vec center,
             double radius, double *t0, double *t1, struct k_vec *p,
             double *s)
{
  struct k_vec f = k_sub(o, center);
  double b = -k_dot(f, d);              // distance to the nearest point
  double ff = k_dot(f, f);
  double c = ff - radius * radius;

  *p = k_along(f, b, d);
  if (__builtin_expect(fabs(c) < 0x1p-10 * ff, 0))      // near the surface
    {
      c = k_sphere_power(o, center, radius);
      double discriminant = b * b - c;
      if (discriminant < 0)
        {
          return 0;
        }
      *s = sqrt(discriminant);
      double q = b > 0 ? b + *s : b - *s;
      double other = q == 0 ? 0 : c / q;
      *t0 = b > 0 ? other : q;
      *t1 = b > 0 ? q : other;
      return K_SPHERE_COMPENSATED;
    }
  double discriminant = radius * radius - k_dot(*p, *p);
  if (discriminant < 0)
    {
      return 0;
    }
  *s = sqrt(discriminant);
  *t0 = b - *s;
  *t1 = b + *s;
  return 1;
}

/** The outward unit normal at the root t0 (side -1) or t1 (side +1). */
static inline struct k_vec
k_sphere_normal(struct k_vec p, double s, int side, struct k_vec d)
{
  return k_unit(k_along(p, side * s, d));
}

#endif
