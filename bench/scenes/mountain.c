/* mountain.c - ground made by moving the middles of edges up and down, and
   four glass spheres above it. */

#include "emit.h"

#include <math.h>
#include <stdint.h>
#include <stdlib.h>

/* -1 to 1, the same for the same place. */
static double
noise (uint32_t i, uint32_t j)
{
  uint32_t h = i * 0x9e3779b1u ^ (j + 0x7f4a7c15u) * 0x85ebca6bu;

  h ^= h >> 15;
  h *= 0x2c1b3c6du;
  h ^= h >> 12;
  h *= 0x297a2d39u;
  h ^= h >> 15;
  return h / 2147483648.0 - 1;
}

/* The height of point i, j of n + 1 by n + 1 points, by midpoint
   displacement: the point's level says between which older ones it lies. */
static void
raise (double *height, int n)
{
  int step, i, j;

  for (step = n; step > 1; step /= 2)
    for (i = 0; i <= n; i += step / 2)
      for (j = 0; j <= n; j += step / 2)
        {
          int h = step / 2, di = i % step ? h : 0, dj = j % step ? h : 0;

          if (di == 0 && dj == 0)
            continue;
          height[i * (n + 1) + j]
            = (height[(i - di) * (n + 1) + j - dj]
               + height[(i + di) * (n + 1) + j + dj]) / 2
              + 0.45 * step / n * noise (i * (1024 / n), j * (1024 / n));
        }
}

static struct point
place (const double *height, int n, int i, int j)
{
  return (struct point) { 2.0 * i / n - 1, 2.0 * j / n - 1,
                          height[i * (n + 1) + j] };
}

void
scene_mountain (struct emit *to, int size)
{
  static const struct emit_view view = {
    .from = { -1.3, 1.3, 1.45 }, .up = { 0, 0, 1 },
    .background = { 0.078, 0.361, 0.753 }
  };
  static const struct point lights[] = { { -100, -100, 100 } };
  static const struct point glass[] = {
    { -0.65, 0.65, 1.05 }, { -0.511, 0.511, 0.772 },
    { -0.599, 0.84, 0.772 }, { -0.84, 0.599, 0.772 }
  };
  int n = 1 << size, i, j;
  double *height = calloc ((size_t) (n + 1) * (n + 1), sizeof *height);

  if (height == NULL)
    exit (4);
  raise (height, n);
  emit_view (to, &view);
  emit_lights (to, lights, 1);
  emit_material (to, (struct emit_material) { 1, 1, 1, 0.1, 0.1, 100,
                                              0.9, 1.5 });
  for (i = 0; i < 4; i++)
    emit_sphere (to, glass[i], 0.17);
  emit_material (to, (struct emit_material) { 0.5, 0.45, 0.35, 1, 0, 32,
                                              0, 1 });
  for (i = 0; i < n; i++)
    for (j = 0; j < n; j++)
      {
        struct point a = place (height, n, i, j);
        struct point b = place (height, n, i + 1, j);
        struct point c = place (height, n, i + 1, j + 1);
        struct point d = place (height, n, i, j + 1);

        emit_polygon (to, (struct point[]) { a, b, c }, 3);
        emit_polygon (to, (struct point[]) { c, d, a }, 3);
      }
  free (height);
}
