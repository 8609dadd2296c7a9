/* solids.c - which polygons of clear materials close a volume. */

#include "nff.h"

#include <stdlib.h>
#include <string.h>

/* One side of a polygon; from and to are corners, by value. */
struct edge
{
  float low[3], high[3];
  uint32_t polygon;
  int forward;
};

static int
by_ends (const void *a, const void *b)
{
  const struct edge *x = a, *y = b;
  int ends = memcmp (x->low, y->low, sizeof x->low + sizeof x->high);

  return ends ? ends : x->forward - y->forward;
}

static uint32_t
root (uint32_t *parent, uint32_t i)
{
  while (parent[i] != i)
    i = parent[i] = parent[parent[i]];
  return i;
}

/* -0 and 0 are one place. */
static void
put (float to[3], const float *from)
{
  int k;

  for (k = 0; k < 3; k++)
    to[k] = from[k] + 0.0f;
}

static size_t
list_edges (const struct nff *s, struct edge *edge)
{
  size_t n = 0, i;
  uint32_t k;

  for (i = 0; i < s->polygons; i++)
    for (k = 0; k < s->polygon[i].count; k++)
      {
        const struct nff_polygon *p = &s->polygon[i];
        struct edge *e = &edge[n];
        float a[3], b[3];

        if (s->material[p->material].clear <= 0)
          break;
        put (a, s->corner + 3 * (p->first + k));
        put (b, s->corner + 3 * (p->first + (k + 1) % p->count));
        e->polygon = i;
        e->forward = memcmp (a, b, sizeof a) < 0;
        memcpy (e->low, e->forward ? a : b, sizeof a);
        memcpy (e->high, e->forward ? b : a, sizeof a);
        n++;
      }
  return n;
}

/* Six times the signed volume between the polygon and the origin. */
static double
volume (const struct nff *s, const struct nff_polygon *p)
{
  const float *c = s->corner + 3 * p->first;
  double n[3];

  nff_normal (c, p->count, n);
  return n[0] * c[0] + n[1] * c[1] + n[2] * c[2];
}

static void
turn (const struct nff *s, const struct nff_polygon *p)
{
  float *a = s->corner + 3 * p->first, *b = a + 3 * (p->count - 1), t[3];

  for (; a < b; a += 3, b -= 3)
    {
      memcpy (t, a, sizeof t);
      memcpy (a, b, sizeof t);
      memcpy (b, t, sizeof t);
    }
}

void
nff_solids (struct nff *s)
{
  struct edge *edge = malloc ((s->corners + 1) * sizeof *edge);
  uint32_t *parent = malloc ((s->polygons + 1) * sizeof *parent);
  char *isOpen = calloc (s->polygons + 1, 1);
  double *inside = calloc (s->polygons + 1, sizeof *inside);
  size_t n, i;

  if (edge == NULL || parent == NULL || isOpen == NULL || inside == NULL)
    exit (4);
  for (i = 0; i < s->polygons; i++)
    parent[i] = i;
  n = list_edges (s, edge);
  qsort (edge, n, sizeof *edge, by_ends);
  /* Two sides that are the same, one each way, join their polygons. */
  for (i = 0; i < n;)
    {
      size_t end = i + 1;

      while (end < n && memcmp (edge[i].low, edge[end].low,
                                2 * sizeof edge[i].low) == 0)
        end++;
      if (end - i == 2 && edge[i].forward != edge[i + 1].forward)
        parent[root (parent, edge[i].polygon)]
          = root (parent, edge[i + 1].polygon);
      else
        for (; i < end; i++)
          isOpen[edge[i].polygon] = 1;
      i = end;
    }
  for (i = 0; i < s->polygons; i++)
    {
      isOpen[root (parent, i)] |= isOpen[i];
      inside[root (parent, i)] += volume (s, &s->polygon[i]);
    }
  for (i = 0; i < s->polygons; i++)
    {
      struct nff_polygon *p = &s->polygon[i];
      uint32_t r = root (parent, i);

      if (s->material[p->material].clear <= 0 || isOpen[r])
        continue;
      p->solid = r + 1;
      if (inside[r] < 0)
        turn (s, p);
    }
  free (edge);
  free (parent);
  free (isOpen);
  free (inside);
}
