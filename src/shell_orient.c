#include "shell_orient.h"
#include "box_pairs.h"
#include <stdlib.h>

// What is smaller than this part of what it is made of may be rounding.
#define NOISE 0x1p-32

struct shell
{
  const struct shell_face **faces;      // in their order
  unsigned count;
  unsigned depth;       // how many other shells it is in
};

struct shells
{
  struct shell *all;
  struct k_bounds *boxes;       // of each
  double scale;         // lengths are divided by it, a power of two, so that
                        // products of three stay in range
};

static struct k_vec
seen_from(struct k_vec p, const struct shell_face *f, unsigned i,
          double scale)
{
  return k_div(k_sub(shell_vertex(f, i), p), scale);
}

/** Six times the signed volume of a shell, as its faces are turned. */
static double
volume(const struct shell *shell, double scale)
{
  struct k_vec p = shell_vertex(shell->faces[0], 0);
  double sum = 0;

  for (unsigned k = 0; k < shell->count; k++)
    {
      const struct shell_face *f = shell->faces[k];
      struct k_vec a = seen_from(p, f, 0, scale);
      double part = 0;
      for (unsigned i = 1; i + 1 < f->n; i++)
        {
          struct k_vec b = seen_from(p, f, i, scale);
          struct k_vec c = seen_from(p, f, i + 1, scale);
          part += k_dot(a, k_cross(b, c));
        }
      sum += f->is_turned ? -part : part;
    }
  return sum;
}

/** The solid angle, signed, in turns, of a triangle seen from the origin
    (Van Oosterom and Strackee 1983). *is_on_it when the origin lies on the
    triangle, as near as can be told. */
static double
turns_of_triangle(struct k_vec a, struct k_vec b, struct k_vec c,
                  int *is_on_it)
{
  double la = k_length(a), lb = k_length(b), lc = k_length(c);
  double y = k_dot(a, k_cross(b, c));
  double x = la * lb * lc + k_dot(a, b) * lc + k_dot(b, c) * la
    + k_dot(c, a) * lb;
  double noise = NOISE * la * lb * lc;

  *is_on_it |= fabs(y) <= noise && x <= noise;
  return atan2(y, x) / (2 * M_PI);
}

/** Whether p is inside a shell: its faces cover a full turn seen from p.
    -1 when p lies on one of them. */
static int
holds(const struct shell *shell, struct k_vec p, double scale)
{
  double turns = 0;
  int is_on_it = 0;

  for (unsigned k = 0; k < shell->count && !is_on_it; k++)
    {
      const struct shell_face *f = shell->faces[k];
      struct k_vec a = seen_from(p, f, 0, scale);
      double part = 0;
      for (unsigned i = 1; i + 1 < f->n; i++)
        {
          part += turns_of_triangle(a, seen_from(p, f, i, scale),
                                    seen_from(p, f, i + 1, scale), &is_on_it);
        }
      turns += f->is_turned ? -part : part;
    }
  return is_on_it ? -1 : fabs(turns) > 0.5;
}

static struct k_vec
between(struct k_vec a, struct k_vec b)
{
  return k_scale(k_add(a, b), 0.5);
}

/** Whether a shell is inside another, as the first of its points says that
    does not lie on the other: of each face the corners, the middles of the
    edges, and that of a triangle. */
static int
is_inside(const struct shell *shell, const struct shell *other, double scale)
{
  for (unsigned k = 0; k < shell->count; k++)
    {
      const struct shell_face *f = shell->faces[k];
      struct k_vec sum = k_vec(0, 0, 0);
      int answer;
      for (unsigned i = 0; i < f->n; i++)
        {
          struct k_vec a = shell_vertex(f, i);
          struct k_vec b = shell_vertex(f, (i + 1) % f->n);
          sum = k_add(sum, a);
          if ((answer = holds(other, a, scale)) >= 0
              || (answer = holds(other, between(a, b), scale)) >= 0)
            {
              return answer;
            }
        }
      if (f->n == 3 && (answer = holds(other, k_div(sum, 3), scale)) >= 0)
        {
          return answer;
        }
    }
  return 0;
}

static int
is_in_box(const struct shells *shells, unsigned s, unsigned other)
{
  const struct k_bounds *box = &shells->boxes[s];

  return k_bounds_hold(&shells->boxes[other], box->least)
    && k_bounds_hold(&shells->boxes[other], box->most);
}

/** For box_pairs: two shells that may be one in the other. */
static void
nest(void *context, unsigned a, unsigned b)
{
  const struct shells *shells = context;
  struct shell *all = shells->all;

  if (is_in_box(shells, a, b))
    {
      all[a].depth += is_inside(&all[a], &all[b], shells->scale);
    }
  if (is_in_box(shells, b, a))
    {
      all[b].depth += is_inside(&all[b], &all[a], shells->scale);
    }
}

/** Hands out the faces to their shells, and makes the boxes. */
static void
gather(struct shells *shells, unsigned shell_count,
       const struct shell_face *faces, unsigned count,
       const struct shell_face **room)
{
  struct k_bounds whole = k_nothing();

  for (unsigned f = 0; f < count; f++)
    {
      shells->all[faces[f].shell].count++;
    }
  for (unsigned s = 0; s < shell_count; s++)
    {
      shells->all[s].faces = room;
      room += shells->all[s].count;
      shells->all[s].count = 0;
      shells->boxes[s] = k_nothing();
    }
  for (unsigned f = 0; f < count; f++)
    {
      struct shell *shell = &shells->all[faces[f].shell];
      struct k_bounds *box = &shells->boxes[faces[f].shell];
      shell->faces[shell->count++] = &faces[f];
      for (unsigned i = 0; i < faces[f].n; i++)
        {
          *box = k_bounds_include(*box, shell_vertex(&faces[f], i));
        }
      whole = k_bounds_include(k_bounds_include(whole, box->least),
                               box->most);
    }
  shells->scale = k_exponent_scale(k_sub(whole.most, whole.least));
}

int
shells_orient(struct shell_face *faces, unsigned count, unsigned shell_count)
{
  struct shells shells = {
    calloc(shell_count, sizeof *shells.all),
    malloc(shell_count * sizeof *shells.boxes), 0
  };
  const struct shell_face **room = malloc(count * sizeof *room);
  unsigned char *is_wrong = malloc(shell_count);
  int is_done = 0;

  if (shells.all && shells.boxes && room && is_wrong)
    {
      gather(&shells, shell_count, faces, count, room);
      is_done = box_pairs(shells.boxes, shell_count, nest, &shells);
      for (unsigned s = 0; s < shell_count; s++)
        {
          int is_cavity = shells.all[s].depth % 2;
          int is_outward = volume(&shells.all[s], shells.scale) > 0;
          is_wrong[s] = is_outward == is_cavity;
        }
      for (unsigned f = 0; f < count; f++)
        {
          faces[f].is_turned ^= is_wrong[faces[f].shell];
        }
    }
  free(shells.all);
  free(shells.boxes);
  free(room);
  free(is_wrong);
  return is_done;
}
