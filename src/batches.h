// batches.h - the mean of a pixel from independent batches of rays, and how
// far it may be from the true one. Every batch spreads its rays evenly by
// itself, so its mean is better than that of as many random rays; how far the
// batches' means are apart says how good their own mean is. What so few say is
// weighed against what the pixels around and shorter batches lead to expect
// (Smyth, "Linear models and empirical Bayes methods", 2004, calls that a
// moderated t).

#ifndef BATCHES_H
#define BATCHES_H

#include "kernel/k_vec.h"
#include "student.h"

/** Few batches are long ones, and rays that belong together are the better
    spread the more they are. */
enum { BATCHES = 4 };

/** What variances are worth, in degrees of freedom: those of the batches, and
    three times as many for what was expected (batches_moderate). */
enum { BATCHES_FREEDOM = 4 * (BATCHES - 1) };

/** The rays that each batch begins with for an error of at most `limit`: so
    many that one which none of them is like (batches_half_width) is allowed for;
    three times as many when they are random (of 3/p random rays 1 in 20 times
    none meets a part p). No more than `most` in all. */
static inline unsigned
batches_start(double limit, int is_random, unsigned most)
{
  double needed = (is_random ? 3 : 1) / (2 * limit);
  unsigned length = 1;

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

static inline struct k_vec
batches_square(struct k_vec a)
{
  return k_vec(a.x * a.x, a.y * a.y, a.z * a.z);
}

/** The variance of the mean, of each channel, from what the batches differ. */
static inline struct k_vec
batches_variance(const struct batches *b)
{
  struct k_vec mean = batches_mean(b), squares = k_vec(0, 0, 0);

  for (unsigned i = 0; i < BATCHES; i++)
    {
      struct k_vec off = k_sub(k_div(b->sums[i], b->length), mean);
      squares = k_add(squares, batches_square(off));
    }
  return k_div(squares, BATCHES * (BATCHES - 1));
}

/** Whether it is a number in each channel: not of a pixel that is infinite. */
static inline int
batches_is_finite(struct k_vec variance)
{
  return variance.x + variance.y + variance.z < HUGE_VAL;
}

/** How much smaller the variance becomes with batches twice as long: 2^-1 when
    rays are random; else 2^-(1 + 1/d) where an edge is in d dimensions (He and
    Wang, "On the convergence rate of randomized quasi-Monte Carlo for
    discontinuous functions", 2015), less where the picture is smooth. Two in
    the pixel; with two more on the lens, what the four scenes that this was
    chosen on have. */
static inline double
batches_gain(int is_random, int has_lens)
{
  return is_random ? 0.5 : has_lens ? 0.375 : 0.35355339059327376;
}

/** That of the channel where it is largest. */
static inline double
batches_largest(struct k_vec variance)
{
  return k_max2(variance.x, k_max2(variance.y, variance.z));
}

/** A variance as it is to be used: one part what the batches say, three parts
    what was expected. */
static inline struct k_vec
batches_moderate(struct k_vec expected, struct k_vec found)
{
  return k_div(k_add(k_scale(expected, 3), found), 4);
}

/** The half-width of the interval of `errors` standard errors, in the channel
    where it is largest; infinite when the colours are, or are no numbers. What
    none of the rays meets is not in it: half a ray that differs by 1 is always
    allowed for, as a share of n rays is known to that. */
static inline double
batches_half_width(struct k_vec variance, double rays, double errors)
{
  return batches_is_finite(variance)
    ? k_max2(errors * sqrt(batches_largest(variance)), 1 / (2 * rays))
    : HUGE_VAL;
}

#endif
