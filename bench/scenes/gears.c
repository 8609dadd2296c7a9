/* gears.c - meshing gears in layers: each is two concave polygons of 144
   corners and 144 sides; every other one is clear. */

#include "emit.h"

#include <math.h>

enum { TEETH = 36, CORNERS = 4 * TEETH };

/* A gear round the z axis, from z = low to high, turned by half a tooth if
   odd. */
static void
gear (struct emit *to, double x, double y, double low, double high,
      double radius, int odd)
{
  struct point bottom[CORNERS], top[CORNERS], side[4];
  int i;

  for (i = 0; i < CORNERS; i++)
    {
      /* Of the four corners of a tooth two are on the tip. */
      static const double across[] = { 0, 0.15, 0.35, 0.5 };
      double turn = 2 * acos (-1) / TEETH
                    * (i / 4 + across[i % 4] + (odd ? 0.5 : 0));
      double r = radius * (i % 4 == 1 || i % 4 == 2 ? 1.04 : 0.94);

      top[i] = (struct point) { x + r * cos (turn), y + r * sin (turn),
                                high };
      bottom[CORNERS - 1 - i] = (struct point) { top[i].x, top[i].y, low };
    }
  emit_solid_begin (to);
  emit_polygon (to, top, CORNERS);
  emit_polygon (to, bottom, CORNERS);
  for (i = 0; i < CORNERS; i++)
    {
      int next = (i + 1) % CORNERS;

      side[0] = top[i];
      side[1] = bottom[CORNERS - 1 - i];
      side[2] = bottom[CORNERS - 1 - next];
      side[3] = top[next];
      emit_polygon (to, side, 4);
    }
  emit_solid_end (to);
}

void
scene_gears (struct emit *to, int size)
{
  static const struct emit_view view = {
    .from = { -1.45, -2.7, 3.0 }, .at = { 0, 0, 0.45 }, .up = { 0, 0, 1 },
    .background = { 0.078, 0.361, 0.753 }
  };
  static const struct point lights[] = {
    { 2, 4, 4 }, { -2, 4, 3 }, { 2, -2.5, 2.5 }, { -1, -4, 2 },
    { -1.1, -2.1, 2.7 }
  };
  static const struct point ground[] = {
    { 2, 2, 0 }, { -2, 2, 0 }, { -2, -2, 0 }, { 2, -2, 0 }
  };
  double cell = 2.0 / size;
  int i, j, k;

  emit_view (to, &view);
  emit_lights (to, lights, 5);
  emit_material (to, (struct emit_material) { 1, 0.85, 0.7, 0.3, 0.6, 3,
                                              0, 1 });
  emit_polygon (to, ground, 4);
  for (k = 0; k < size; k++)
    for (i = 0; i < size; i++)
      for (j = 0; j < size; j++)
        {
          double red = 1 - 0.6 * i / size, green = 1 - 0.6 * j / size;
          double low = (k + 0.15) * 0.75 * cell;

          if ((i + j + k) % 2)
            emit_material (to, (struct emit_material) {
                             1, red, green, 0.2, 0, 32, 0.8, 1.1 });
          else
            emit_material (to, (struct emit_material) {
                             1, red, green, 1, 0, 32, 0, 1 });
          gear (to, -1 + (i + 0.5) * cell, -1 + (j + 0.5) * cell, low,
                low + 0.45 * cell, 0.475 * cell, (i + j) % 2);
        }
}
