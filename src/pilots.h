// pilots.h - the first rays of each pixel of some rows, and what the pixels
// around one lead to expect of it. The rows are as many as are needed at a
// time; each takes the place of one that is done.

#ifndef PILOTS_H
#define PILOTS_H

#include "around.h"
#include "batches.h"

struct pilot
{
  struct k_vec sums[BATCHES];
  struct k_vec variance;        // of their mean
};

struct pilots
{
  struct pilot *at;
  struct window seen;           // all pixels that have one at some time
  unsigned rows;                // that are there at a time
};

/** Of a pixel of the whole picture. */
static inline struct pilot *
pilots_at(const struct pilots *p, unsigned x, unsigned y)
{
  size_t columns = p->seen.x1 - p->seen.x0;

  return p->at + y % p->rows * columns + (x - p->seen.x0);
}

/** How much one pixel's variance tells of another's: all unless it is much
    smaller, as flat pixels beside an edge tell nothing of those in it. */
static inline double
pilots_share(struct k_vec own, struct k_vec other)
{
  double a = batches_largest(own), b = batches_largest(other);

  return 10 * b < a ? 10 * b / a : 1;
}

/** The variance of the pixel's mean as its own pilot and those around it say:
    where it saw nothing by chance, they did. */
static inline struct k_vec
pilots_variance(const struct pilots *p, unsigned x, unsigned y)
{
  struct window one = { x, y, x + 1, y + 1 };
  struct window w = around_window(one, p->seen);
  struct k_vec own = pilots_at(p, x, y)->variance;
  struct around a = { .weight = 0 };

  for (unsigned row = w.y0; row < w.y1; row++)
    {
      for (unsigned column = w.x0; column < w.x1; column++)
        {
          if (column != x || row != y)
            {
              struct k_vec other = pilots_at(p, column, row)->variance;
              around_add(&a, (int)column - (int)x, (int)row - (int)y,
                         pilots_share(own, other), other);
            }
        }
    }
  return a.weight > 0 ? batches_moderate(k_div(a.sum, a.weight), own) : own;
}

#endif
