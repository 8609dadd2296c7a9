// k_polygon_hit.h - point in polygon. Notes, "bounded planes": the two
// methods of the notes (edges, angles), and the one that is watertight
// (crossings). The vertices are three arrays of n numbers.

#ifndef K_POLYGON_HIT_H
#define K_POLYGON_HIT_H

#include "k_bounds.h"
#include "k_plane_hit.h"
#include "k_shear.h"

/** Crossings: how often the line from the ray to infinity along +x crosses
    the outline, seen along the ray; odd is inside. Any polygon, convex or
    not.

    An edge counts when its ends lie on different sides of the ray's y (on it
    counts as above), and then by the sign of one 2 x 2 determinant, taken
    from the lower end to the upper. Both are the same bits for both polygons
    of a shared edge, whichever way round they go, so a ray hits exactly one
    of them. */
static inline int
k_polygon_crossings(struct k_vec o, const struct k_shear *shear, unsigned n,
                    const double *const vertex[3])
{
  const double *vx = vertex[shear->kx];
  const double *vy = vertex[shear->ky];
  const double *vz = vertex[shear->kz];
  double ox = k_component(o, shear->kx);
  double oy = k_component(o, shear->ky);
  double oz = k_component(o, shear->kz);
  double wz = vz[n - 1] - oz;
  double X0 = (vx[n - 1] - ox) - shear->Sx * wz;
  double Y0 = (vy[n - 1] - oy) - shear->Sy * wz;
  int is_inside = 0;

  for (unsigned i = 0; i < n; i++)
    {
      wz = vz[i] - oz;
      double X1 = (vx[i] - ox) - shear->Sx * wz;
      double Y1 = (vy[i] - oy) - shear->Sy * wz;
      int above0 = Y0 >= 0;
      int above1 = Y1 >= 0;
      if (above0 != above1)
        {
          int crosses = above1 ? X0 * Y1 - Y0 * X1 > 0
                               : X1 * Y0 - Y1 * X0 > 0;
          is_inside ^= crosses;
        }
      X0 = X1;
      Y0 = Y1;
    }
  return is_inside;
}

// A ray that runs along a polygon's plane, this near, meets the plane at a
// distance that has lost a quarter of its digits or all.
#define K_GRAZING 0x1p-12

/** How flat against its plane a ray must be for k_polygon_settle: K_GRAZING,
    or any way it runs (2) when a corner is off the plane by more than the
    padding of the box, since the plane then is met outside of the box. */
static inline double
k_polygon_grazing(const struct k_plane *plane, unsigned n,
                  const double *const v[3])
{
  double off = 0, size = 0;

  for (unsigned i = 0; i < n; i++)
    {
      struct k_vec p = k_vec(v[0][i], v[1][i], v[2][i]);
      off = k_max2(off, fabs(k_dot(plane->n, k_sub(p, plane->q))));
      size = k_max2(size, k_norm_max(p));
    }
  return off > 0x1p-50 * size ? 2 : K_GRAZING;
}

/** For crossings, which look at the line only: moves the distance at which a
    ray meets a polygon's plane to where the ray is in the polygon's box, if it
    grazes and rounding has put that elsewhere, or if the polygon is not quite
    flat (grazing: k_polygon_grazing). So the hit is never in front of
    the box, and whoever has something nearer may leave out the polygon. 0 when
    the ray misses the box. */
static inline int
k_polygon_settle(const struct k_plane *plane, struct k_vec o, struct k_vec d,
                 double grazing, unsigned n, const double *const v[3],
                 double *t)
{
  struct k_bounds box = k_nothing();
  double t_in = -HUGE_VAL, t_out = HUGE_VAL;

  if (fabs(k_dot(plane->n, d)) >= grazing)
    {
      return 1;
    }
  for (unsigned i = 0; i < n; i++)
    {
      box = k_bounds_include(box, k_vec(v[0][i], v[1][i], v[2][i]));
    }
  box = k_bounds_pad(box);
  struct k_vec inverse = k_vec(1 / d.x, 1 / d.y, 1 / d.z);
  k_slab(box.least.x, box.most.x, o.x, inverse.x, &t_in, &t_out);
  k_slab(box.least.y, box.most.y, o.y, inverse.y, &t_in, &t_out);
  k_slab(box.least.z, box.most.z, o.z, inverse.z, &t_in, &t_out);
  *t = *t > t_out ? t_out : *t;
  *t = *t < t_in ? t_in : *t;
  return t_in <= t_out * (1 + 8 * K_U);
}

/** Edges: P is inside when it is on the inner side of every edge, that is of
    the plane through the edge with normal N x edge. Convex polygons only. */
static inline int
k_polygon_edges(struct k_vec P, struct k_vec N, unsigned n,
                const double *const v[3])
{
  struct k_vec a = k_vec(v[0][n - 1], v[1][n - 1], v[2][n - 1]);

  for (unsigned i = 0; i < n; i++)
    {
      struct k_vec b = k_vec(v[0][i], v[1][i], v[2][i]);
      if (k_dot(k_cross(N, k_sub(b, a)), k_sub(P, a)) < 0)
        {
          return 0;
        }
      a = b;
    }
  return 1;
}

/** Angles: the angles under which P sees the edges, with their signs, sum to
    +-2 pi inside and to 0 outside. (Without signs, as in the notes, the sum is
    wrong for polygons that are not convex.) The only use of libm while
    tracing: atan2. */
static inline int
k_polygon_angles(struct k_vec P, struct k_vec N, unsigned n,
                 const double *const v[3])
{
  struct k_vec a = k_sub(k_vec(v[0][n - 1], v[1][n - 1], v[2][n - 1]), P);
  double sum = 0;

  for (unsigned i = 0; i < n; i++)
    {
      struct k_vec b = k_sub(k_vec(v[0][i], v[1][i], v[2][i]), P);
      sum += atan2(k_dot(N, k_cross(a, b)), k_dot(a, b));
      a = b;
    }
  return fabs(sum) > M_PI;
}

#endif
