#include "box_pairs.h"
#include <stdlib.h>

#define FEW 32                  // boxes that are compared all with all
#define SAMPLE 31               // boxes whose median stands for that of all

struct search
{
  const struct k_bounds *boxes;
  void (*meet)(void *context, unsigned a, unsigned b);
  void *context;
};

/** A part of space, without its upper sides, and the boxes that are in it. */
struct cell
{
  struct k_bounds space;
  unsigned *list, count;
};

/** Compares all with all. Two boxes may meet in several cells: they count in
    that of the least corner they have in common. */
static void
compare(const struct search *s, const struct cell *cell)
{
  struct k_vec from = cell->space.least, to = cell->space.most;

  for (unsigned i = 0; i < cell->count; i++)
    {
      const struct k_bounds *a = &s->boxes[cell->list[i]];
      for (unsigned j = i + 1; j < cell->count; j++)
        {
          const struct k_bounds *b = &s->boxes[cell->list[j]];
          double x = k_max2(a->least.x, b->least.x);
          double y = k_max2(a->least.y, b->least.y);
          double z = k_max2(a->least.z, b->least.z);
          if (k_bounds_overlap(a, b) && from.x <= x && x < to.x
              && from.y <= y && y < to.y && from.z <= z && z < to.z)
            {
              s->meet(s->context, cell->list[i], cell->list[j]);
            }
        }
    }
}

static int
by_number(const void *p, const void *q)
{
  double a = *(const double *)p, b = *(const double *)q;

  return (a > b) - (a < b);
}

/** Where to cut along an axis: half of the boxes, or nearly, begin before. */
static double
middle(const struct search *s, const struct cell *cell, int axis)
{
  double least[SAMPLE];

  for (unsigned i = 0; i < SAMPLE; i++)
    {
      size_t at = (size_t)i * cell->count / SAMPLE;
      least[i] = k_component(s->boxes[cell->list[at]].least, axis);
    }
  qsort(least, SAMPLE, sizeof *least, by_number);
  return least[SAMPLE / 2];
}

/** The boxes that are in the cell below (side 0) or above a cut; into `list`
    unless it is NULL. Those that the cut goes through are in both. */
static unsigned
part(const struct search *s, const struct cell *cell, int axis, double cut,
     int side, unsigned *list)
{
  unsigned count = 0;

  for (unsigned i = 0; i < cell->count; i++)
    {
      const struct k_bounds *box = &s->boxes[cell->list[i]];
      if (side ? k_component(box->most, axis) >= cut
               : k_component(box->least, axis) < cut)
        {
          if (list)
            {
              list[count] = cell->list[i];
            }
          count++;
        }
    }
  return count;
}

static void
set_component(struct k_vec *v, int axis, double x)
{
  *(axis == 0 ? &v->x : axis == 1 ? &v->y : &v->z) = x;
}

/** Cuts the cell along the axis that leaves least to compare, as long as that
    is worth it. */
static int
search(const struct search *s, const struct cell *cell)
{
  double least = 0.9 * cell->count * cell->count, cut = 0;
  unsigned counts[2] = { 0, 0 };
  int axis = -1;

  for (int a = 0; a < 3 && cell->count > FEW; a++)
    {
      double at = middle(s, cell, a);
      double below = part(s, cell, a, at, 0, NULL);
      double above = part(s, cell, a, at, 1, NULL);
      if (below * below + above * above < least)
        {
          least = below * below + above * above;
          axis = a;
          cut = at;
          counts[0] = below;
          counts[1] = above;
        }
    }
  if (axis < 0)
    {
      compare(s, cell);
      return 1;
    }
  for (int side = 0; side < 2; side++)
    {
      struct cell half = { cell->space, NULL, counts[side] };
      set_component(side ? &half.space.least : &half.space.most, axis, cut);
      half.list = malloc((half.count + 1) * sizeof *half.list);
      if (!half.list)
        {
          return 0;
        }
      part(s, cell, axis, cut, side, half.list);
      int is_done = search(s, &half);
      free(half.list);
      if (!is_done)
        {
          return 0;
        }
    }
  return 1;
}

int
box_pairs(const struct k_bounds *boxes, unsigned count,
          void (*meet)(void *context, unsigned a, unsigned b), void *context)
{
  struct search s = { boxes, meet, context };
  struct cell all = { k_unbounded(), malloc((count + 1) * sizeof(unsigned)),
                      count };

  if (!all.list)
    {
      return 0;
    }
  for (unsigned i = 0; i < count; i++)
    {
      all.list[i] = i;
    }
  int is_done = search(&s, &all);
  free(all.list);
  return is_done;
}
