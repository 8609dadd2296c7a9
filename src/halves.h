// halves.h - how good the mean of n evenly spread rays is, from the two halves
// of the first 2^k of them. Halves are no independent batches: they keep out of
// each other's way, so what they differ is more than their mean is off. With the
// variance of twice as many rays `gain` times as large,
//
//   E (first - second)^2 = 4 (1 - gain) V(2^(k-1)),  V(2^k) = gain V(2^(k-1))

#ifndef HALVES_H
#define HALVES_H

#include <stdint.h>

/** The variance of the mean of 2^k rays by the square of what the halves differ:
    1/4 for random ones, whose gain is 1/2. */
static inline double
halves_share(double gain)
{
  return gain / (4 * (1 - gain));
}

/** The largest power of two in n, at least 1. */
static inline uint64_t
halves_most(uint64_t n)
{
  return (uint64_t)1 << (63 - __builtin_clzll(n));
}

/** The variance of the sum of n rays by that of one. A sequence is as good as its
    parts of powers of two, and few rays less than such a number are as good as
    that number without a sequence of those few: what is nearer. */
static inline double
halves_sum(uint64_t n, double gain)
{
  double sum = 0;

  while (n)
    {
      uint64_t below = halves_most(n);
      uint64_t part = n - below <= 2 * below - n ? below : 2 * below;
      double variance = 1;      // part^2 V(part)
      for (uint64_t k = part; k > 1; k /= 2)
        {
          variance *= 4 * gain;
        }
      sum += variance;
      n = n > part ? n - part : part - n;
    }
  return sum;
}

/** The variance of the mean of n rays, n at least 1, by that of 2^k, the largest
    power of two in n. */
static inline double
halves_rest(uint64_t n, double gain)
{
  uint64_t most = halves_most(n);
  double part = (double)most / n;

  return halves_sum(n, gain) / halves_sum(most, gain) * part * part;
}

#endif
