// k_bvh_cut.c - see k_bvh_cut.h.

#include "k_bvh_cut.h"

#define BINS 16                 // 8 in short lists

static struct binning
binning_of(const struct k_range *r)
{
  struct binning b;
  float width[4], scale[4] = { 0 };

  b.bins = r->count < 16 ? 8 : BINS;
  b.origin = r->centers.least;
  f4_store(width, f4_sub(r->centers.most, r->centers.least));
  for (int axis = 0; axis < 3; axis++)
    {
      float s = 0.9999f * b.bins / width[axis];
      scale[axis] = width[axis] > 0 && s < HUGE_VALF ? s : 0;
    }
  b.scale = f4_load(scale);
  return b;
}

static inline void
bins_of(const struct binning *b, const struct k_item *item, int32_t bins[4])
{
  f4 c = f4_add(f4_load(item->least), f4_load(item->most));

  f4_to_ints(bins, f4_mul(f4_sub(c, b->origin), b->scale));
}

static void
try_axis(struct k_cut *cut, int axis, const struct k_box *boxes,
         const uint32_t *counts)
{
  float left_cost[BINS];
  int bins = cut->binning.bins;
  struct k_box sum = k_no_box();
  uint32_t n = 0;

  for (int i = 0; i < bins - 1; i++)
    {
      sum = k_join(sum, boxes[i]);
      n += counts[i];
      left_cost[i] = n ? k_half_area(sum) * n : HUGE_VALF;
    }
  sum = k_no_box();
  n = 0;
  for (int i = bins - 1; i > 0; i--)
    {
      sum = k_join(sum, boxes[i]);
      n += counts[i];
      float cost = left_cost[i - 1] + k_half_area(sum) * n;
      if (n && cost < cut->cost)
        {
          cut->cost = cost;
          cut->at = i;
          cut->axis = axis;
        }
    }
}

struct k_cut
k_best_cut(const struct k_item *items, const struct k_range *r)
{
  struct k_cut cut = { binning_of(r), -1, 0, HUGE_VALF };
  struct k_box boxes[3][BINS];
  uint32_t counts[3][BINS];
  float scale[4];

  for (int axis = 0; axis < 3; axis++)
    {
      for (int i = 0; i < cut.binning.bins; i++)
        {
          boxes[axis][i] = k_no_box();
          counts[axis][i] = 0;
        }
    }
  for (uint32_t i = r->first; i < r->first + r->count; i++)
    {
      struct k_box b = k_box_of(&items[i]);
      int32_t bin[4];
      bins_of(&cut.binning, &items[i], bin);
      for (int axis = 0; axis < 3; axis++)
        {
          boxes[axis][bin[axis]] = k_join(boxes[axis][bin[axis]], b);
          counts[axis][bin[axis]]++;
        }
    }
  f4_store(scale, cut.binning.scale);
  for (int axis = 0; axis < 3; axis++)
    {
      if (scale[axis] > 0)
        {
          try_axis(&cut, axis, boxes[axis], counts[axis]);
        }
    }
  return cut;
}

void
k_split(struct k_item *items, const struct k_range *whole,
        const struct k_cut *cut, struct k_range *left, struct k_range *right)
{
  struct k_range a = k_empty_range(whole->first), b = a;
  uint32_t low = whole->first, high = whole->first + whole->count;

  while (low < high)
    {
      int32_t bin[4];
      int goes_left = low - whole->first < whole->count / 2;
      if (cut->axis >= 0)
        {
          bins_of(&cut->binning, &items[low], bin);
          goes_left = bin[cut->axis] < cut->at;
        }
      if (goes_left)
        {
          k_include(&a, &items[low++]);
        }
      else
        {
          k_include(&b, &items[low]);
          struct k_item swap = items[low];
          items[low] = items[--high];
          items[high] = swap;
        }
    }
  a.count = low - a.first;
  b.first = low;
  b.count = whole->count - a.count;
  *left = a;
  *right = b;
}
