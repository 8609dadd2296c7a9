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

/** The variance of the mean of n rays, n at least 1, by that of 2^k, the largest
    power of two in n: a sequence is as good as its parts of powers of two, one
    for each bit of n. */
static inline double
halves_rest(uint64_t n, double gain)
{
  double part = 1, parts = 0, last = 1;

  // (2^j)^2 V(2^j), and in the end that of 2^k.
  for (uint64_t bits = n; bits; bits >>= 1, part *= 4 * gain)
    {
      parts += bits & 1 ? part : 0;
      last = part;
    }
  double most = (double)((uint64_t)1 << (63 - __builtin_clzll(n)));
  return parts / last * (most / n) * (most / n);
}

#endif
