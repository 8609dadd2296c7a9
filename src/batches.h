// batches.h - the mean of a pixel from independent batches of rays, and how
// far it may be from the true one. Every batch spreads its rays evenly by
// itself, so its mean is better than that of as many random rays; how far the
// batches' means are apart says how good their own mean is.

#ifndef BATCHES_H
#define BATCHES_H

#include "kernel/k_vec.h"
#include "student.h"

/** Few batches are long ones, and rays that belong together are the better
    spread the more they are; but the error of few numbers is itself not well
    known. */
enum { BATCHES = 9 };

/** The rays that each batch begins with; then twice as many, and so on. */
enum { BATCH_START = 4 };

struct batches
{
  struct k_vec sums[BATCHES];   // of the colours of each batch's rays
  unsigned length;              // rays in each
};

/** The mean of all rays. */
static inline struct k_vec
batches_mean(const struct batches *b)
{
  struct k_vec sum = b->sums[0];

  for (unsigned i = 1; i < BATCHES; i++)
    {
      sum = k_add(sum, b->sums[i]);
    }
  return k_div(sum, (double)BATCHES * b->length);
}

static inline double
batches_spread(const double *sums)
{
  double mean = 0, squares = 0;

  for (unsigned i = 0; i < BATCHES; i++)
    {
      mean += sums[3 * i] / BATCHES;
    }
  for (unsigned i = 0; i < BATCHES; i++)
    {
      squares += (sums[3 * i] - mean) * (sums[3 * i] - mean);
    }
  return sqrt(squares / (BATCHES * (BATCHES - 1)));
}

/** The half-width of an interval of t standard errors round the mean, of the
    channel where it is the widest; infinite when the colours are, or are no
    numbers. */
static inline double
batches_error(const struct batches *b, double t)
{
  double x = batches_spread(&b->sums[0].x);
  double y = batches_spread(&b->sums[0].y);
  double z = batches_spread(&b->sums[0].z);
  double most = x > y ? x : y;

  most = most > z ? most : z;
  return x + y + z < HUGE_VAL ? t * most / b->length : HUGE_VAL;
}

#endif
