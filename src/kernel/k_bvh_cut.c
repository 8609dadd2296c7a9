// k_bvh_cut.c - see k_bvh_cut.h.

#include "k_bvh_cut.h"
#include <string.h>

struct k_binning
k_binning_of(const struct k_range *r)
{
  struct k_binning b;
  float width[4], scale[4] = { 0 };

  b.origin = r->centers.least;
  f4_store(width, f4_sub(r->centers.most, r->centers.least));
  for (int axis = 0; axis < 3; axis++)
    {
      float s = 0.9999f * K_BINS / width[axis];
      scale[axis] = width[axis] > 0 && s < HUGE_VALF ? s : 0;
    }
  b.scale = f4_load(scale);
  return b;
}

/** In which bin a middle falls, and how far into it. */
static inline f4
bins_of(const struct k_binning *b, f4 center)
{
  return f4_mul(f4_sub(center, b->origin), b->scale);
}

void
k_bins_clear(struct k_bins *bins)
{
  for (int axis = 0; axis < 3; axis++)
    {
      for (int i = 0; i < K_BINS; i++)
        {
          bins->boxes[axis][i] = k_no_box();
          bins->counts[axis][i] = 0;
        }
    }
}

void
k_bins_add(struct k_bins *bins, const struct k_binning *binning,
           const struct k_item *items, uint32_t count)
{
  for (uint32_t i = 0; i < count; i++)
    {
      struct k_box b = k_box_of(&items[i]);
      int32_t bin[4];
      f4_to_ints(bin, bins_of(binning, f4_add(b.least, b.most)));
      for (int axis = 0; axis < 3; axis++)
        {
          struct k_box *box = &bins->boxes[axis][bin[axis]];
          *box = k_join(*box, b);
          bins->counts[axis][bin[axis]]++;
        }
    }
}

void
k_bins_join(struct k_bins *bins, const struct k_bins *more)
{
  for (int axis = 0; axis < 3; axis++)
    {
      for (int i = 0; i < K_BINS; i++)
        {
          bins->boxes[axis][i] = k_join(bins->boxes[axis][i],
                                        more->boxes[axis][i]);
          bins->counts[axis][i] += more->counts[axis][i];
        }
    }
}

/** Tries the cuts between the bins of an axis. A part without items costs
    infinity times 0: not a number, and so not less than anything. */
static void
try_axis(struct k_cut *cut, int axis, const struct k_box *boxes,
         const uint32_t *counts)
{
  float left_cost[K_BINS], best = cut->cost;
  struct k_box sum = boxes[0];
  uint32_t n = counts[0];
  int at = 0;

  for (int i = 1; i < K_BINS; i++)
    {
      left_cost[i] = k_half_area(sum) * n;
      sum = k_join(sum, boxes[i]);
      n += counts[i];
    }
  sum = k_no_box();
  n = 0;
  for (int i = K_BINS - 1; i > 0; i--)
    {
      sum = k_join(sum, boxes[i]);
      n += counts[i];
      float cost = left_cost[i] + k_half_area(sum) * n;
      at = cost < best ? i : at;
      best = cost < best ? cost : best;
    }
  if (at)
    {
      cut->cost = best;
      cut->at = at;
      cut->axis = axis;
    }
}

void
k_cut_bins(const struct k_bins *bins, struct k_cut *cut)
{
  float scale[4];

  cut->axis = -1;
  cut->cost = HUGE_VALF;
  f4_store(scale, cut->binning.scale);
  for (int axis = 0; axis < 3; axis++)
    {
      if (scale[axis] > 0)
        {
          try_axis(cut, axis, bins->boxes[axis], bins->counts[axis]);
        }
    }
  if (cut->axis < 0)
    {
      return;
    }
  const struct k_box *boxes = bins->boxes[cut->axis];
  const uint32_t *counts = bins->counts[cut->axis];
  cut->left = boxes[0];
  cut->left_count = counts[0];
  for (int i = 1; i < cut->at; i++)
    {
      cut->left = k_join(cut->left, boxes[i]);
      cut->left_count += counts[i];
    }
  cut->right = boxes[cut->at];
  for (int i = cut->at + 1; i < K_BINS; i++)
    {
      cut->right = k_join(cut->right, boxes[i]);
    }
}

/** The numbers from 0 in the order of their keys: without a branch on these,
    which nobody could foretell. */
static void
sort(unsigned char *order, float (*keys)[4], int axis, uint32_t n)
{
  unsigned rank[K_FEW] = { 0 };

  for (uint32_t i = 1; i < n; i++)
    {
      for (uint32_t k = 0; k < i; k++)
        {
          unsigned is_less = keys[i][axis] < keys[k][axis];
          rank[k] += is_less;
          rank[i] += !is_less;
        }
    }
  for (uint32_t i = 0; i < n; i++)
    {
      order[rank[i]] = i;
    }
}

/** The best cut of n boxes in some order. */
static void
try_order(struct k_cut *cut, int axis, const struct k_box *boxes,
          const unsigned char *order, uint32_t n)
{
  float right_cost[K_FEW];
  struct k_box sum = boxes[order[n - 1]];
  uint32_t best = 0;

  for (uint32_t i = n - 1; i > 0; i--)
    {
      right_cost[i] = k_half_area(sum) * (n - i);
      sum = k_join(sum, boxes[order[i - 1]]);
    }
  sum = boxes[order[0]];
  for (uint32_t i = 1; i < n; i++)
    {
      float cost = k_half_area(sum) * i + right_cost[i];
      best = cost < cut->cost ? i : best;
      cut->cost = cost < cut->cost ? cost : cut->cost;
      sum = k_join(sum, boxes[order[i]]);
    }
  if (best)
    {
      cut->axis = axis;
      cut->left_count = best;
      memcpy(cut->order, order, K_FEW);
    }
}

void
k_cut_few(const struct k_range *r, struct k_cut *cut)
{
  struct k_box boxes[K_FEW];
  float centers[K_FEW][4], width[4];
  unsigned char order[K_FEW] = { 0, 1 };

  cut->axis = -1;
  cut->cost = HUGE_VALF;
  for (uint32_t i = 0; i < r->count; i++)
    {
      boxes[i] = k_box_of(&r->items[i]);
      f4_store(centers[i], f4_add(boxes[i].least, boxes[i].most));
    }
  if (r->count == 2)
    {
      try_order(cut, 0, boxes, order, 2);
      return;
    }
  f4_store(width, f4_sub(r->centers.most, r->centers.least));
  for (int axis = 0; axis < 3; axis++)
    {
      if (width[axis] > 0)
        {
          sort(order, centers, axis, r->count);
          try_order(cut, axis, boxes, order, r->count);
        }
    }
}

void
k_best_cut(const struct k_range *r, struct k_cut *cut)
{
  struct k_bins bins;

  if (r->count <= K_FEW)
    {
      k_cut_few(r, cut);
      return;
    }
  cut->binning = k_binning_of(r);
  k_bins_clear(&bins);
  k_bins_add(&bins, &cut->binning, r->items, r->count);
  k_cut_bins(&bins, cut);
}

void
k_part(const struct k_item *items, uint32_t count, const struct k_cut *cut,
       struct k_item *left, struct k_item *right, struct k_box centers[2])
{
  // What moves a middle that is not on a side to where it counts nothing.
  const f4 none[2] = { f4_all(0), f4_all(HUGE_VALF) };
  struct k_box a = centers[0], b = centers[1];
  f4 at = f4_all(cut->at);
  struct k_item *to[2] = { left, right };

  for (uint32_t i = 0; i < count; i++)
    {
      struct k_box box = k_box_of(&items[i]);
      f4 c = f4_add(box.least, box.most);
      unsigned is_left
        = f4_less(bins_of(&cut->binning, c), at) >> cut->axis & 1;
      a.least = f4_min(a.least, f4_add(c, none[!is_left]));
      a.most = f4_max(a.most, f4_sub(c, none[!is_left]));
      b.least = f4_min(b.least, f4_add(c, none[is_left]));
      b.most = f4_max(b.most, f4_sub(c, none[is_left]));
      *to[!is_left] = items[i];
      to[0] += is_left;
      to[1] += !is_left;
    }
  centers[0] = a;
  centers[1] = b;
}

void
k_halves(const struct k_range *whole, const struct k_cut *cut,
         struct k_range *left, struct k_range *right)
{
  uint32_t n = cut->left_count;
  struct k_range parts[2] = {
    { whole->spare, whole->items, whole->first, n, cut->left, k_no_box() },
    { whole->spare + n, whole->items + n, whole->first + n,
      whole->count - n, cut->right, k_no_box() }
  };

  *left = parts[0];
  *right = parts[1];
}

/** Splits as the order says. */
static void
split_order(const struct k_range *whole, const struct k_cut *cut,
            struct k_range *left, struct k_range *right)
{
  k_halves(whole, cut, left, right);
  left->box = right->box = k_no_box();
  for (uint32_t i = 0; i < whole->count; i++)
    {
      const struct k_item *item = &whole->items[cut->order[i]];
      whole->spare[i] = *item;
      k_include(i < cut->left_count ? left : right, item);
    }
}

/** Splits where the list has its middle. */
static void
split_middle(const struct k_range *whole, struct k_range *left,
             struct k_range *right)
{
  struct k_cut cut = { .left_count = whole->count / 2 };

  k_halves(whole, &cut, left, right);
  left->box = right->box = k_no_box();
  for (uint32_t i = 0; i < whole->count; i++)
    {
      whole->spare[i] = whole->items[i];
      k_include(i < cut.left_count ? left : right, &whole->items[i]);
    }
}

void
k_split(const struct k_range *whole, const struct k_cut *cut,
        struct k_range *left, struct k_range *right)
{
  struct k_box centers[2] = { k_no_box(), k_no_box() };
  struct k_range r = *whole;    // left or right may be the same

  if (cut->axis < 0)
    {
      split_middle(&r, left, right);
      return;
    }
  if (r.count <= K_FEW)
    {
      split_order(&r, cut, left, right);
      return;
    }
  k_part(r.items, r.count, cut, r.spare, r.spare + cut->left_count, centers);
  k_halves(&r, cut, left, right);
  left->centers = centers[0];
  right->centers = centers[1];
}
