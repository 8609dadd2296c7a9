#include "shell.h"
#include "kernel/k_bounds.h"
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

static struct k_vec
vertex_of(const struct shell_face *f, unsigned i)
{
  return k_vec(f->vertex[0][i], f->vertex[1][i], f->vertex[2][i]);
}

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
              corners[k].v = vertex_of(&faces[f], i);
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

/** A vertex seen from p, divided by `scale`, a power of two, so that products
    of three lengths stay in range. */
static struct k_vec
seen_from(struct k_vec p, const struct shell_face *f, unsigned i,
          double scale)
{
  return k_div(k_sub(vertex_of(f, i), p), scale);
}

/** Six times the signed volume of a shell, as its faces are turned, measured
    from p. */
static double
volume(const struct shell_face *faces, unsigned count, unsigned shell,
       struct k_vec p, double scale)
{
  double sum = 0;

  for (unsigned f = 0; f < count; f++)
    {
      if (faces[f].shell == shell)
        {
          struct k_vec a = seen_from(p, &faces[f], 0, scale);
          double part = 0;
          for (unsigned i = 1; i + 1 < faces[f].n; i++)
            {
              struct k_vec b = seen_from(p, &faces[f], i, scale);
              struct k_vec c = seen_from(p, &faces[f], i + 1, scale);
              part += k_dot(a, k_cross(b, c));
            }
          sum += faces[f].is_turned ? -part : part;
        }
    }
  return sum;
}

/** The solid angle, signed, in turns, of a triangle seen from the origin
    (Van Oosterom and Strackee 1983). */
static double
turns_of_triangle(struct k_vec a, struct k_vec b, struct k_vec c)
{
  double la = k_length(a), lb = k_length(b), lc = k_length(c);
  double y = k_dot(a, k_cross(b, c));
  double x = la * lb * lc + k_dot(a, b) * lc + k_dot(b, c) * la
    + k_dot(c, a) * lb;

  return atan2(y, x) / (2 * M_PI);
}

/** Whether p is inside a shell: its faces cover a full turn seen from p. */
static int
is_inside(const struct shell_face *faces, unsigned count, unsigned shell,
          struct k_vec p, double scale)
{
  double turns = 0;

  for (unsigned f = 0; f < count; f++)
    {
      if (faces[f].shell == shell)
        {
          struct k_vec a = seen_from(p, &faces[f], 0, scale);
          double part = 0;
          for (unsigned i = 1; i + 1 < faces[f].n; i++)
            {
              part += turns_of_triangle(a, seen_from(p, &faces[f], i, scale),
                                        seen_from(p, &faces[f], i + 1,
                                                  scale));
            }
          turns += faces[f].is_turned ? -part : part;
        }
    }
  return fabs(turns) > 0.5;
}

static void
turn_shell(struct shell_face *faces, unsigned count, unsigned shell)
{
  for (unsigned f = 0; f < count; f++)
    {
      faces[f].is_turned ^= faces[f].shell == shell;
    }
}

/** Turns every shell outwards, then those that are cavities inwards. */
static void
orient(struct shell_face *faces, unsigned count, unsigned shells)
{
  struct k_bounds box = k_nothing();

  for (unsigned f = 0; f < count; f++)
    {
      for (unsigned i = 0; i < faces[f].n; i++)
        {
          box = k_bounds_include(box, vertex_of(&faces[f], i));
        }
    }
  double scale = k_exponent_scale(k_sub(box.most, box.least));
  for (unsigned s = 0; s < shells; s++)
    {
      unsigned f = 0;
      while (faces[f].shell != s)
        {
          f++;
        }
      struct k_vec p = vertex_of(&faces[f], 0);
      int depth = 0;
      for (unsigned other = 0; other < shells; other++)
        {
          depth += other != s && is_inside(faces, count, other, p,
                                              scale);
        }
      int is_outward = volume(faces, count, s, p, scale) > 0;
      if (is_outward != (depth % 2 == 0))
        {
          turn_shell(faces, count, s);
        }
    }
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
          open->a = vertex_of(f, s->corner);
          open->b = vertex_of(f, (s->corner + 1) % f->n);
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
      open->a = vertex_of(&faces[odd], 0);
      open->b = vertex_of(&faces[odd], 1);
      open->faces = 2;
      shells = 0;
      goto done;
    }
  orient(faces, count, shells);
done:
  free(sides);
  free(links);
  free(first);
  free(queue);
  return shells;
}
