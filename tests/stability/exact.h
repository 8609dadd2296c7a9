// exact.h - where a ray meets a sphere, in 113 bits and by the notes' formula,
// for the tables of errors.c and costs.c.

#ifndef EXACT_H
#define EXACT_H

#include "kernel/k_sphere_hit.h"
#include "../random.h"

/** The square root in 113 bits. */
static inline __float128
root(__float128 x)
{
  __float128 y = sqrt((double)x);

  for (int i = 0; i < 2 && y != 0; i++)
    {
      y = (y + x / y) / 2;
    }
  return y;
}

static inline __float128
size(__float128 x)
{
  return x < 0 ? -x : x;
}

/** Notes, "transmission": t0 of the sphere, by -b - sqrt(b^2 - 4ac) over 2a. */
static inline int
notes_hit(struct k_vec o, struct k_vec d, struct k_vec center, double r,
          double *t)
{
  struct k_vec f = k_sub(o, center);
  double a = k_dot(d, d), b = 2 * k_dot(f, d), c = k_dot(f, f) - r * r;
  double discriminant = b * b - 4 * a * c;

  *t = (-b - sqrt(discriminant)) / (2 * a);
  return discriminant >= 0;
}

static inline __float128
exact_hit(struct k_vec o, struct k_vec d, struct k_vec c, double r)
{
  __float128 x = (__float128)o.x - c.x, y = (__float128)o.y - c.y;
  __float128 z = (__float128)o.z - c.z;
  __float128 a = (__float128)d.x * d.x + (__float128)d.y * d.y
    + (__float128)d.z * d.z;
  __float128 b = x * d.x + y * d.y + z * d.z;
  __float128 px = x - b / a * d.x, py = y - b / a * d.y, pz = z - b / a * d.z;
  __float128 h = (__float128)r * r - (px * px + py * py + pz * pz);

  return (-b - root(a * h)) / a;
}

/** A ray from the origin that passes a unit sphere's center at 0 to 0.9. */
static inline void
aim(struct support_random *random, double ratio, struct k_vec *d,
    struct k_vec *center)
{
  double pass = 0.9 * support_unit(random);
  struct k_vec side;

  *d = support_direction(random);
  side = k_unit(k_cross(*d, fabs(d->x) < 0.6 ? k_vec(1, 0, 0)
                        : k_vec(0, 1, 0)));
  *center = k_add(k_scale(*d, ratio), k_scale(side, pass));
}

#endif
