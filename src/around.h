// around.h - the mean of what the pixels of 5 x 5 around one say, each by the
// inverse square of its distance.

#ifndef AROUND_H
#define AROUND_H

#import "image_t.h"
#include "kernel/k_vec.h"

/** How far they are, in columns and in rows. */
enum { AROUND_REACH = 2 };

/** A window and the pixels around those in it, as far as they are within
    bounds. */
static inline struct window
around_window(struct window w, struct window bounds)
{
  w.x0 -= MIN(w.x0 - bounds.x0, AROUND_REACH);
  w.y0 -= MIN(w.y0 - bounds.y0, AROUND_REACH);
  w.x1 += MIN(bounds.x1 - w.x1, AROUND_REACH);
  w.y1 += MIN(bounds.y1 - w.y1, AROUND_REACH);
  return w;
}

struct around
{
  struct k_vec sum;
  double weight;
};

/** Adds the pixel dx columns and dy rows off, by a share of its weight; not when
    it is infinite, or no number: that says nothing of others. */
static inline void
around_add(struct around *a, int dx, int dy, double share, struct k_vec said)
{
  double weight = dx || dy ? share / (dx * dx + dy * dy) : share;

  if (k_norm1(said) < HUGE_VAL)
    {
      a->sum = k_add(a->sum, k_scale(said, weight));
      a->weight += weight;
    }
}

#endif
