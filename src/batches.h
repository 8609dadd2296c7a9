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

/** The fewest rays that each batch begins with; then twice as many, and so
    on. */
enum { BATCH_START = 4 };

/** The rays that each batch begins with for an error of at most `limit`. What
    is too small for all of them to meet it is not seen, so there are one or
    more for each part of the pixel as large as the limit; three or more when
    they are random (of 3/p random rays 1 in 20 times none meets a part p). No
    more than `most` in all. */
static inline unsigned
batches_start(double limit, int is_random, unsigned most)
{
  double needed = (is_random ? 3 : 1) / limit;
  unsigned length = BATCH_START;

  while (BATCHES * length < needed && 2.0 * BATCHES * length <= most)
    {
      length *= 2;
    }
  return length;
}

struct batches
{
  struct k_vec sums[BATCHES];   // of the colours of each batch's rays
  unsigned length;              // rays in each
  double last;                  // standard error when they were half as long
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

/** How much smaller a standard error becomes with batches twice as long:
    between 2^(-3/4), at edges, and 2^(-5/4), where the picture is smooth; or
    2^(-1/2) when rays are random. */
static inline double
batches_gain(int is_random)
{
  return is_random ? 0.70710678118654752 : 0.5;
}

/** The standard error of the mean, of the channel where it is the largest;
    infinite when the colours are, or are no numbers. Who stops when an error is
    small stops more often when it only seems so; so it is no smaller than the
    one before lets expect. To be asked once for each length. */
static inline double
batches_error(struct batches *b, int is_random)
{
  double x = batches_spread(&b->sums[0].x);
  double y = batches_spread(&b->sums[0].y);
  double z = batches_spread(&b->sums[0].z);
  double most = x > y ? x : y;
  double expected = b->last * batches_gain(is_random);

  most = (most > z ? most : z) / b->length;
  b->last = x + y + z < HUGE_VAL ? most : HUGE_VAL;
  return b->last > expected ? b->last : expected;
}

/** The half-width of the interval of `errors` standard errors. What none of
    the rays meets is not in it: one ray that differs by 1 is always allowed
    for. */
static inline double
batches_half_width(struct batches *b, int is_random, double errors)
{
  double width = errors * batches_error(b, is_random);
  double unseen = 1 / ((double)BATCHES * b->length);

  return width > unseen ? width : unseen;
}

#endif
