// k_plane_hit.h - where a ray meets a plane.

#ifndef K_PLANE_HIT_H
#define K_PLANE_HIT_H

#include "k_vec.h"

/** A plane by a unit normal and a point of it. (The form n.x + D = 0 loses
    all digits far from the origin; this one none.) */
struct k_plane
{
  struct k_vec n;
  struct k_vec q;
};

/** 1 and the distance t, of any sign, at which the line o + t d meets the
    plane; 0 when it is parallel to it. */
static inline int
k_plane_hit(const struct k_plane *plane, struct k_vec o, struct k_vec d,
            double *t)
{
  double n_dot_d = k_dot(plane->n, d);

  if (n_dot_d == 0)
    {
      return 0;
    }
  *t = k_dot(plane->n, k_sub(plane->q, o)) / n_dot_d;
  return 1;
}

/** The point o + t d, put back onto the plane along its normal. */
static inline struct k_vec
k_plane_point(const struct k_plane *plane, struct k_vec o, struct k_vec d,
              double t)
{
  struct k_vec p = k_along(o, t, d);
  double off = k_dot(plane->n, k_sub(p, plane->q));

  return k_along(p, -off, plane->n);
}

#endif
