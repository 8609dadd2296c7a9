#include "shell.h"
#include "shell_orient.h"
#include <stdlib.h>

/** One side of one face. */
struct side
{
  unsigned low, high;   // ids of its ends
  unsigned face;
  unsigned corner;      // it goes from this corner to the next
  int falls;            // from high to low
};

struct corner
{
  struct k_vec v;
  unsigned face, i;
};

static int
compare_points(struct k_vec a, struct k_vec b)
{
  return a.x != b.x ? (a.x < b.x ? -1 : 1)
    : a.y != b.y ? (a.y < b.y ? -1 : 1)
    : a.z != b.z ? (a.z < b.z ? -1 : 1) : 0;
}

static int
by_point(const void *p, const void *q)
{
  return compare_points(((const struct corner *)p)->v,
                        ((const struct corner *)q)->v);
}

static int
by_ends(const void *p, const void *q)
{
  const struct side *a = p, *b = q;

  return a->low != b->low ? (a->low < b->low ? -1 : 1)
    : a->high != b->high ? (a->high < b->high ? -1 : 1)
    : a->face != b->face ? (a->face < b->face ? -1 : 1)
    : a->corner < b->corner ? -1 : a->corner > b->corner;
}

/** All sides of all faces, sorted by their ends; equal points have one id. */
static struct side *
sorted_sides(const struct shell_face *faces, unsigned count, unsigned *total)
{
  unsigned n = 0;

  for (unsigned f = 0; f < count; f++)
    {
      n += faces[f].n;
    }
  struct corner *corners = malloc(n * sizeof *corners);
  unsigned *first = malloc(count * sizeof *first);
  unsigned *id = malloc(n * sizeof *id);
  struct side *sides = malloc(n * sizeof *sides);
  *total = n;
  if (corners && first && id && sides)
    {
      unsigned k = 0;
      for (unsigned f = 0; f < count; f++)
        {
          first[f] = k;
          for (unsigned i = 0; i < faces[f].n; i++, k++)
            {
              corners[k].v = shell_vertex(&faces[f], i);
              corners[k].face = f;
              corners[k].i = i;
            }
        }
      qsort(corners, n, sizeof *corners, by_point);
      unsigned point = 0;
      for (k = 0; k < n; k++)
        {
          point += k > 0 && compare_points(corners[k - 1].v, corners[k].v);
          id[first[corners[k].face] + corners[k].i] = point;
        }
      for (unsigned f = 0; f < count; f++)
        {
          for (unsigned i = 0; i < faces[f].n; i++)
            {
              unsigned a = id[first[f] + i];
              unsigned b = id[first[f] + (i + 1) % faces[f].n];
              struct side side = { a < b ? a : b, a < b ? b : a, f, i,
                                   a > b };
              sides[first[f] + i] = side;
            }
        }
      qsort(sides, n, sizeof *sides, by_ends);
    }
  else
    {
      free(sides);
      sides = NULL;
    }
  free(corners);
  free(first);
  free(id);
  return sides;
}

/** The sides s[0..run) are one edge. Drops the pairs that one face has in
    both directions (bridges); returns how many are left, in front. */
static unsigned
drop_bridges(struct side *s, unsigned run)
{
  unsigned kept = 0;

  for (unsigned i = 0; i < run; i++)
    {
      if (kept && s[kept - 1].face == s[i].face
          && s[kept - 1].falls != s[i].falls)
        {
          kept--;
        }
      else
        {
          s[kept++] = s[i];
        }
    }
  return kept;
}

/** A link of a face to its neighbour across an edge. */
struct link
{
  unsigned face, neighbour;
  int same_way;         // both run along the edge in the same direction
};

static int
by_face(const void *p, const void *q)
{
  const struct link *a = p, *b = q;

  return a->face != b->face ? (a->face < b->face ? -1 : 1)
    : a->neighbour < b->neighbour ? -1 : a->neighbour > b->neighbour;
}

/** Goes from each face to its neighbours, numbering shells and turning faces;
    the first face whose neighbour will not fit either way round, or count. */
static unsigned
spread(struct shell_face *faces, unsigned count, const struct link *links,
       const unsigned *first, unsigned *queue, int *shells)
{
  for (unsigned f = 0; f < count; f++)
    {
      faces[f].shell = ~0u;
    }
  *shells = 0;
  for (unsigned seed = 0; seed < count; seed++)
    {
      unsigned head = 0, tail = 0;
      if (faces[seed].shell != ~0u)
        {
          continue;
        }
      faces[seed].shell = *shells;
      faces[seed].is_turned = 0;
      queue[tail++] = seed;
      while (head < tail)
        {
          unsigned f = queue[head++];
          for (unsigned k = first[f]; k < first[f + 1]; k++)
            {
              unsigned g = links[k].neighbour;
              int turned = faces[f].is_turned ^ links[k].same_way;
              if (faces[g].shell == ~0u)
                {
                  faces[g].shell = *shells;
                  faces[g].is_turned = turned;
                  queue[tail++] = g;
                }
              else if (faces[g].is_turned != turned)
                {
                  return f;
                }
            }
        }
      ++*shells;
    }
  return count;
}

int
shells_close(struct shell_face *faces, unsigned count,
             struct shell_edge *open)
{
  unsigned total, kept = 0, link_count = 0;
  int shells = -1;
  struct side *sides = sorted_sides(faces, count, &total);
  struct link *links = malloc((total + 1) * sizeof *links);
  unsigned *first = calloc(count + 1, sizeof *first);
  unsigned *queue = malloc((count + 1) * sizeof *queue);

  if (!sides || !links || !first || !queue)
    {
      goto done;
    }
  for (unsigned i = 0, run; i < total; i += run)
    {
      for (run = 1; i + run < total && sides[i + run].low == sides[i].low
             && sides[i + run].high == sides[i].high; run++)
        {
        }
      struct side *s = &sides[i];
      kept = drop_bridges(s, run);
      if (kept == 0)
        {
          continue;
        }
      if (kept != 2 || s[0].face == s[1].face)
        {
          const struct shell_face *f = &faces[s->face];
          open->face = s->face;
          open->a = shell_vertex(f, s->corner);
          open->b = shell_vertex(f, (s->corner + 1) % f->n);
          open->faces = kept;
          shells = 0;
          goto done;
        }
      int same_way = s[0].falls == s[1].falls;
      struct link there = { s[0].face, s[1].face, same_way };
      struct link back = { s[1].face, s[0].face, same_way };
      links[link_count++] = there;
      links[link_count++] = back;
    }
  qsort(links, link_count, sizeof *links, by_face);
  for (unsigned k = 0; k < link_count; k++)
    {
      first[links[k].face + 1]++;
    }
  for (unsigned f = 0; f < count; f++)
    {
      first[f + 1] += first[f];
    }
  unsigned odd = spread(faces, count, links, first, queue, &shells);
  if (odd < count)
    {
      open->face = odd;
      open->a = shell_vertex(&faces[odd], 0);
      open->b = shell_vertex(&faces[odd], 1);
      open->faces = 2;
      shells = 0;
      goto done;
    }
  if (!shells_orient(faces, count, shells))
    {
      shells = -1;
    }
done:
  free(sides);
  free(links);
  free(first);
  free(queue);
  return shells;
}
