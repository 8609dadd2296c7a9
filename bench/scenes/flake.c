/* flake.c - the sphere flake: nine spheres a third as large sit on each
   sphere, six round its equator and three above it, 45 degrees up. */

#include "emit.h"

#include <math.h>

/* Turns v as the shortest turn does that takes the z axis to axis. */
static struct point
turned (struct point v, struct point axis)
{
  /* The turn is about k = z x axis; Rodrigues with k not normalised. */
  double kx = -axis.y, ky = axis.x, c = axis.z;
  double share, dot = kx * v.x + ky * v.y;

  if (c < -1 + 1e-12)
    return (struct point) { -v.x, v.y, -v.z };
  share = dot / (1 + c);
  return (struct point) {
    v.x * c + ky * v.z + kx * share,
    v.y * c - kx * v.z + ky * share,
    v.z * c + (kx * v.y - ky * v.x)
  };
}

static void
grow (struct emit *to, int level, struct point center, double radius,
      struct point axis)
{
  const double degree = acos (-1) / 180;
  int third, k;

  emit_sphere (to, center, radius);
  if (level == 0)
    return;
  for (third = 0; third < 3; third++)
    for (k = 0; k < 3; k++)
      {
        double turn = 120 * third + (k == 0 ? 45 : k == 1 ? 15 : 75);
        double z = k == 0 ? sqrt (2 / 3.0) : 0, flat = sqrt (1 - z * z);
        double reach = radius * 4 / 3;
        struct point d = { flat * cos (turn * degree),
                           flat * sin (turn * degree), z };

        d = turned (d, axis);
        grow (to, level - 1,
              (struct point) { center.x + reach * d.x,
                               center.y + reach * d.y,
                               center.z + reach * d.z }, radius / 3, d);
      }
}

void
scene_flake (struct emit *to, int size)
{
  static const struct emit_view view = {
    .from = { 1.74, 1.08, 1.41 }, .up = { 0, 0, 1 },
    .background = { 0.078, 0.361, 0.753 }
  };
  static const struct point lights[] = {
    { 4, 3, 2 }, { 1, -4, 4 }, { -3, 1, 5 }
  };
  static const struct point ground[] = {
    { 12, 12, -0.5 }, { -12, 12, -0.5 }, { -12, -12, -0.5 },
    { 12, -12, -0.5 }
  };

  emit_view (to, &view);
  emit_lights (to, lights, 3);
  emit_material (to, (struct emit_material) { 1, 0.75, 0.33, 0.8, 0,
                                              32, 0, 1 });
  emit_polygon (to, ground, 4);
  emit_material (to, (struct emit_material) { 1, 0.9, 0.7, 0.5, 0.5,
                                              3, 0, 1 });
  grow (to, size, (struct point) { 0, 0, 0 }, 0.5,
        (struct point) { 0, 0, 1 });
}
