/* clip.c - cuts polygons, concave ones too, into triangles: ear clipping. */

#include "nff.h"

#include <math.h>
#include <stdlib.h>

void
nff_normal (const float *corner, uint32_t count, double normal[3])
{
  uint32_t i;
  int k;

  for (k = 0; k < 3; k++)
    {
      int u = (k + 1) % 3, v = (k + 2) % 3;

      normal[k] = 0;
      for (i = 0; i < count; i++)
        {
          const float *a = corner + 3 * i;
          const float *b = corner + 3 * ((i + 1) % count);

          normal[k] += ((double) a[u] - b[u]) * ((double) a[v] + b[v]);
        }
    }
}

/* Twice the area of a triangle in the plane, positive if it turns left. */
static double
area (const double *a, const double *b, const double *c)
{
  return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}

/* Whether the corner between before and after can be cut off. */
static int
is_ear (double (*p)[2], const uint32_t *left, uint32_t lefts, uint32_t i)
{
  const double *a = p[left[(i + lefts - 1) % lefts]], *b = p[left[i]];
  const double *c = p[left[(i + 1) % lefts]];
  uint32_t k;

  if (area (a, b, c) <= 0)
    return 0;
  for (k = 0; k < lefts; k++)
    {
      const double *q = p[left[k]];

      if (q != a && q != b && q != c && area (a, b, q) >= 0
          && area (b, c, q) >= 0 && area (c, a, q) >= 0)
        return 0;
    }
  return 1;
}

void
nff_clip (const float *corner, uint32_t count, uint32_t (*triangle)[3])
{
  double normal[3], (*p)[2] = malloc (count * sizeof *p);
  uint32_t *left = malloc (count * sizeof *left), lefts = count, i, at = 0;
  int drop = 0, k;

  if (p == NULL || left == NULL)
    exit (4);
  /* Seen along the axis in which the polygon is flattest. */
  nff_normal (corner, count, normal);
  for (k = 1; k < 3; k++)
    if (fabs (normal[k]) > fabs (normal[drop]))
      drop = k;
  for (i = 0; i < count; i++)
    {
      p[i][0] = corner[3 * i + (drop + 1) % 3];
      p[i][1] = corner[3 * i + (drop + 2) % 3]
                * (normal[drop] < 0 ? -1.0 : 1.0);
      left[i] = i;
    }
  for (i = 0; lefts > 3; i = (i + 1) % lefts)
    {
      uint32_t tries = 0, k;

      /* Where rounding leaves no ear any corner will do. */
      while (tries++ < lefts && !is_ear (p, left, lefts, i))
        i = (i + 1) % lefts;
      triangle[at][0] = left[(i + lefts - 1) % lefts];
      triangle[at][1] = left[i];
      triangle[at++][2] = left[(i + 1) % lefts];
      for (k = i; k + 1 < lefts; k++)
        left[k] = left[k + 1];
      lefts--;
      i %= lefts;
    }
  for (k = 0; k < 3; k++)
    triangle[at][k] = left[k];
  free (p);
  free (left);
}
