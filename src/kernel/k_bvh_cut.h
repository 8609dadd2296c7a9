// k_bvh_cut.h - where a list of boxes is best cut in two: the surface area
// heuristic over bins on all three axes at once.

#ifndef K_BVH_CUT_H
#define K_BVH_CUT_H

#include "k_bvh_build.h"
#include "k_simd.h"

/** A box in vectors: x y z and nothing. */
struct k_box
{
  f4 least, most;
};

struct k_range
{
  uint32_t first, count;
  struct k_box box;
  struct k_box centers;           // of twice the middles: least + most
};

/** How the middles of a range fall into bins, on all three axes. */
struct binning
{
  f4 origin, scale;
  int bins;
};

/** Where a range is best split: an axis and the first bin of the right part;
    the cost of asking both parts. Axis -1: nowhere. */
struct k_cut
{
  struct binning binning;
  int axis, at;
  float cost;
};

/** The best cut of a range, of those between bins. */
struct k_cut k_best_cut(const struct k_item *items, const struct k_range *r);

/** Splits a range in two, moving its items; in the middle of the list when no
    cut parts it. */
void k_split(struct k_item *items, const struct k_range *whole,
             const struct k_cut *cut, struct k_range *left,
             struct k_range *right);

static inline struct k_box
k_no_box(void)
{
  struct k_box b = { f4_all(HUGE_VALF), f4_all(-HUGE_VALF) };
  return b;
}

static inline struct k_box
k_box_of(const struct k_item *item)
{
  struct k_box b = { f4_load(item->least), f4_load(item->most) };
  return b;
}

static inline struct k_box
k_join(struct k_box a, struct k_box b)
{
  a.least = f4_min(a.least, b.least);
  a.most = f4_max(a.most, b.most);
  return a;
}

static inline float
k_half_area(struct k_box b)
{
  float s[4];

  f4_store(s, f4_sub(b.most, b.least));
  return s[0] < 0 ? 0 : s[0] * s[1] + s[1] * s[2] + s[2] * s[0];
}

/** The range with one more item, wherever that stands. */
static inline void
k_include(struct k_range *r, const struct k_item *item)
{
  struct k_box b = k_box_of(item);
  f4 c = f4_add(b.least, b.most);

  r->box = k_join(r->box, b);
  r->centers.least = f4_min(r->centers.least, c);
  r->centers.most = f4_max(r->centers.most, c);
}

static inline struct k_range
k_empty_range(uint32_t first)
{
  struct k_range r = { first, 0, k_no_box(), k_no_box() };
  return r;
}

#endif
