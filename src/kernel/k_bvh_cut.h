// k_bvh_cut.h - where a list of boxes is best cut in two: the surface area
// heuristic, over bins on all three axes at once or, for a few boxes, over
// all places between two of them.

#ifndef K_BVH_CUT_H
#define K_BVH_CUT_H

#include "k_bvh_build.h"
#include "k_simd.h"

#define K_BINS 16
#define K_FEW 8                 // boxes that are sorted
#define K_WIDE 65536            // boxes that several threads share …
#define K_PIECES 16             // … in so many pieces

/** A box in vectors: x y z and 0. */
struct k_box
{
  f4 least, most;
};

struct k_range
{
  struct k_item *items;
  struct k_item *spare;         // room for as many; their parts go there
  uint32_t first, count;        // their places in tree->refs
  struct k_box box;
  struct k_box centers;         // of twice the middles: least + most
};

/** How the middles of a range fall into bins, on all three axes. */
struct k_binning
{
  f4 origin, scale;
};

/** What falls into them. */
struct k_bins
{
  struct k_box boxes[3][K_BINS];
  uint32_t counts[3][K_BINS];
};

/** Where a range is best split: an axis and the first bin of the right part,
    or the order of a few; the boxes of both parts, and the cost of asking
    them. Axis -1: nowhere. */
struct k_cut
{
  struct k_binning binning;
  struct k_box left, right;
  uint32_t left_count;
  float cost;
  int axis, at;
  union
  {
    unsigned char order[K_FEW];
    uint32_t before[K_PIECES];  // of the items on the left; see k_bvh_wide.c
  };
};

struct k_binning k_binning_of(const struct k_range *r);
void k_bins_clear(struct k_bins *bins);
void k_bins_add(struct k_bins *bins, const struct k_binning *binning,
                const struct k_item *items, uint32_t count);

/** Adds the second to the first. */
void k_bins_join(struct k_bins *bins, const struct k_bins *more);

/** The best cut between bins; cut->binning is given. */
void k_cut_bins(const struct k_bins *bins, struct k_cut *cut);

/** The best cut of a range of 2 to K_FEW. */
void k_cut_few(const struct k_range *r, struct k_cut *cut);

/** Copies items to their sides of a cut between bins, keeping their order, and
    adds their middles to the sides' centers. */
void k_part(const struct k_item *items, uint32_t count,
            const struct k_cut *cut, struct k_item *left,
            struct k_item *right, struct k_box centers[2]);

/** The two parts of a range, without what k_part does. */
void k_halves(const struct k_range *whole, const struct k_cut *cut,
              struct k_range *left, struct k_range *right);

/** The best cut of any range of at least 2. */
void k_best_cut(const struct k_range *r, struct k_cut *cut);

/** Splits a range in two, moving its items; in the middle of the list when no
    cut parts it. */
void k_split(const struct k_range *whole, const struct k_cut *cut,
             struct k_range *left, struct k_range *right);

/** The same two by several threads, for a range of at least K_WIDE. */
void k_wide_cut(const struct k_range *r, unsigned threads,
                struct k_cut *cut);
void k_wide_split(const struct k_range *whole, const struct k_cut *cut,
                  unsigned threads, struct k_range *left,
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
  struct k_box b = { f4_load(item->least), f4_xyz(f4_load(item->most)) };
  return b;
}

static inline struct k_box
k_join(struct k_box a, struct k_box b)
{
  a.least = f4_min(a.least, b.least);
  a.most = f4_max(a.most, b.most);
  return a;
}

/** Of a box that is one. */
static inline float
k_half_area(struct k_box b)
{
  f4 side = f4_sub(b.most, b.least);
  f4 face = f4_mul(side, f4_turn(side));

  return f4_first(face) + f4_first(f4_turn(face))
    + f4_first(f4_turn(f4_turn(face)));
}

/** A box with one more point. */
static inline struct k_box
k_reach(struct k_box b, f4 p)
{
  b.least = f4_min(b.least, p);
  b.most = f4_max(b.most, p);
  return b;
}

/** The range with one more item, wherever that stands. */
static inline void
k_include(struct k_range *r, const struct k_item *item)
{
  struct k_box b = k_box_of(item);

  r->box = k_join(r->box, b);
  r->centers = k_reach(r->centers, f4_add(b.least, b.most));
}

#endif
