/* room.c - a closed room: walls, blocks, a mirror and a glass sphere. No
   ray leaves it, so every one is followed as deep as allowed. */

#include "emit.h"

static void
block (struct emit *to, struct point a, struct point b, int inward)
{
  static const int face[6][4] = {
    { 0, 2, 3, 1 }, { 4, 5, 7, 6 }, { 0, 1, 5, 4 },
    { 2, 6, 7, 3 }, { 0, 4, 6, 2 }, { 1, 3, 7, 5 }
  };
  static const double wall[6][3] = {
    { 0.8, 0.8, 0.8 }, { 0.8, 0.8, 0.8 }, { 0.7, 0.7, 0.7 },
    { 0.8, 0.8, 0.8 }, { 0.8, 0.3, 0.3 }, { 0.3, 0.8, 0.3 }
  };
  int i, k;

  for (i = 0; i < 6; i++)
    {
      struct point corner[4];

      for (k = 0; k < 4; k++)
        {
          int c = face[i][inward ? 3 - k : k];

          corner[k] = (struct point) { c & 1 ? b.x : a.x, c & 2 ? b.y : a.y,
                                       c & 4 ? b.z : a.z };
        }
      if (inward)
        emit_material (to, (struct emit_material) {
                         wall[i][0], wall[i][1], wall[i][2], 0.9, 0, 32,
                         0, 1 });
      emit_polygon (to, corner, 4);
    }
}

void
scene_room (struct emit *to, int size)
{
  static const struct emit_view view = {
    .from = { 0, -0.1, 2.9 }, .at = { 0, -0.2, 0 }, .up = { 0, 1, 0 },
    .background = { 0, 0, 0 }
  };
  static const struct point lights[] = {
    { -0.6, 0.9, 0.5 }, { 0.6, 0.9, 2 }
  };
  int i, j;

  emit_view (to, &view);
  emit_lights (to, lights, 2);
  block (to, (struct point) { -1.5, -1, -1.5 }, (struct point) { 1.5, 1, 3 },
         1);
  emit_material (to, (struct emit_material) { 0.9, 0.8, 0.6, 0.8, 0, 32,
                                              0, 1 });
  for (i = 0; i < size; i++)
    for (j = 0; j < size; j++)
      {
        double cell = 2.6 / size, x = -1.3 + i * cell, z = -1.3 + j * cell;
        double up = -1 + 0.1 + 0.15 * ((3 * i + 5 * j) % 4);

        block (to, (struct point) { x + 0.15 * cell, -0.999,
                                    z + 0.15 * cell },
               (struct point) { x + 0.85 * cell, up, z + 0.85 * cell }, 0);
      }
  emit_material (to, (struct emit_material) { 1, 1, 1, 0.3, 0.7, 60, 0, 1 });
  emit_sphere (to, (struct point) { -0.65, 0.1, -0.3 }, 0.45);
  emit_material (to, (struct emit_material) { 1, 1, 1, 0.1, 0.1, 60,
                                              0.9, 1.5 });
  emit_sphere (to, (struct point) { 0.6, 0, 0.6 }, 0.4);
}
