/* tetra.c - a tetrahedron made of four half as large, and so on: what is
   left of it is mostly air, and most rays miss. */

#include "emit.h"

static struct point
middle (struct point a, struct point b)
{
  return (struct point) { (a.x + b.x) / 2, (a.y + b.y) / 2,
                          (a.z + b.z) / 2 };
}

static void
split (struct emit *to, int level, const struct point p[4])
{
  static const int face[4][3] = {
    { 0, 1, 2 }, { 0, 3, 1 }, { 0, 2, 3 }, { 1, 3, 2 }
  };
  int i, k;

  for (i = 0; i < 4; i++)
    {
      struct point corner[4];

      if (level == 0)
        {
          for (k = 0; k < 3; k++)
            corner[k] = p[face[i][k]];
          emit_polygon (to, corner, 3);
          continue;
        }
      for (k = 0; k < 4; k++)
        corner[k] = middle (p[i], p[k]);
      split (to, level - 1, corner);
    }
}

void
scene_tetra (struct emit *to, int size)
{
  static const struct emit_view view = {
    .from = { 0.85, -2.63, -1.76 }, .at = { 0, 0, 0.2 },
    .up = { -0.8, -0.8, 0.8 }, .background = { 0.078, 0.361, 0.753 }
  };
  static const struct point lights[] = { { 2, -18, -5 } };
  static const struct point corner[] = {
    { 1, 1, 1 }, { -1, -1, 1 }, { -1, 1, -1 }, { 1, -1, -1 }
  };

  emit_view (to, &view);
  emit_lights (to, lights, 1);
  emit_material (to, (struct emit_material) { 1, 0.2, 0.2, 1, 0, 32, 0, 1 });
  split (to, size - 1, corner);
}
