// k_shear.h - coordinates in which a ray is the z axis: the polygon test
// looks at a polygon along the ray, in two dimensions. x and y of a vertex
// depend on the ray and on that vertex alone, so all polygons that share a
// vertex see it at the same place to the last bit (Woop, Benthin, Wald,
// "Watertight Ray/Triangle Intersection", JCGT 2013).

#ifndef K_SHEAR_H
#define K_SHEAR_H

#include "k_vec.h"

struct k_shear
{
  int kx, ky, kz;       // kz: the axis the ray runs along most
  double Sx, Sy;        // slope of the ray against that axis
};

static inline struct k_shear
k_shear(struct k_vec d)
{
  struct k_shear s;
  double ax = fabs(d.x), ay = fabs(d.y), az = fabs(d.z);

  s.kz = ax > ay ? (ax > az ? 0 : 2) : (ay > az ? 1 : 2);
  s.kx = s.kz == 2 ? 0 : s.kz + 1;
  s.ky = s.kx == 2 ? 0 : s.kx + 1;
  double dz = k_component(d, s.kz);
  s.Sx = k_component(d, s.kx) / dz;
  s.Sy = k_component(d, s.ky) / dz;
  return s;
}

#endif
