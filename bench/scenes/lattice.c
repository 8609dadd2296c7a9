/* lattice.c - clear spheres in rows, columns and layers over a ground: each
   surface sends two rays on. */

#include "emit.h"

void
scene_lattice (struct emit *to, int size)
{
  static const struct emit_view view = {
    .from = { 1.9, 1.3, 1.7 }, .at = { 0, 0, 0 }, .up = { 0, 0, 1 },
    .background = { 0.3, 0.5, 0.8 }
  };
  static const struct point lights[] = { { 4, 3, 5 }, { 1, -4, 4 } };
  static const struct point ground[] = {
    { 6, 6, -1.2 }, { -6, 6, -1.2 }, { -6, -6, -1.2 }, { 6, -6, -1.2 }
  };
  int i, j, k;

  emit_view (to, &view);
  emit_lights (to, lights, 2);
  emit_material (to, (struct emit_material) { 0.9, 0.8, 0.5, 0.8, 0, 32,
                                              0, 1 });
  emit_polygon (to, ground, 4);
  emit_material (to, (struct emit_material) { 0.9, 1, 1, 0.2, 0, 32,
                                              0.9, 1.5 });
  for (k = 0; k < size; k++)
    for (j = 0; j < size; j++)
      for (i = 0; i < size; i++)
        emit_sphere (to, (struct point) { -0.8 + 1.6 * (i + 0.5) / size,
                                          -0.8 + 1.6 * (j + 0.5) / size,
                                          -0.8 + 1.6 * (k + 0.5) / size },
                     0.6 / size);
}
