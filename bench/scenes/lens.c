/* lens.c - mirroring spheres on a ground through a lens of 16 rays: sharp
   in the middle, blurred in front and behind. */

#include "emit.h"

void
scene_lens (struct emit *to, int size)
{
  static const struct emit_view view = {
    .from = { 0, -2.2, 0.9 }, .at = { 0, 0, 0 }, .up = { 0, 0, 1 },
    .background = { 0.4, 0.5, 0.7 },
    .focus = 2.3, .fstop = 25, .exposure = 16
  };
  static const struct point lights[] = { { 3, -3, 5 }, { -4, -1, 3 } };
  static const struct point ground[] = {
    { 8, 8, 0 }, { -8, 8, 0 }, { -8, -8, 0 }, { 8, -8, 0 }
  };
  double cell = 2.4 / size;
  int i, j;

  emit_view (to, &view);
  emit_lights (to, lights, 2);
  emit_material (to, (struct emit_material) { 0.7, 0.7, 0.7, 0.9, 0, 32,
                                              0, 1 });
  emit_polygon (to, ground, 4);
  for (j = 0; j < size; j++)
    {
      emit_material (to, (struct emit_material) {
                       0.4 + 0.6 * j / size, 0.7, 1 - 0.6 * j / size,
                       0.8, j % 2 ? 0.2 : 0, 20, 0, 1 });
      for (i = 0; i < size; i++)
        emit_sphere (to, (struct point) { -1.2 + (i + 0.5) * cell,
                                          -1.2 + (j + 0.5) * cell,
                                          0.35 * cell + 0.01 }, 0.35 * cell);
    }
}
