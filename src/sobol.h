// sobol.h - the four dimensions of Sobol's sequence ("Distribution of points in
// a cube and approximate evaluation of integrals", 1967), with the digits of a
// number in the order of their worth: bit 0 is the first one after the point.
// The first dimension is the index itself.

#ifndef SOBOL_H
#define SOBOL_H

#include <stdint.h>

/** The second dimension: digit r is the sum of the index's bits j with an
    odd binomial coefficient (j over r), and that is odd when r has no bit that
    j has not (Lucas). */
static inline uint32_t
sobol_second(uint32_t index)
{
  index ^= index >> 1 & 0x55555555u;
  index ^= index >> 2 & 0x33333333u;
  index ^= index >> 4 & 0x0f0f0f0fu;
  index ^= index >> 8 & 0x00ff00ffu;
  return index ^ index >> 16;
}

/** What each bit of the index adds to the third and to the fourth dimension,
    of the polynomials x^2 + x + 1 and x^3 + x + 1 and the beginnings 1, 3 and
    1, 3, 1 (Joe and Kuo, "Constructing Sobol sequences with better
    two-dimensional projections", 2008; theirs is the other order of bits). */
static const uint32_t sobol_columns[2][32] = {
  {
    0x1, 0x3, 0x6, 0x9, 0x17, 0x3a,
    0x71, 0xa3, 0x116, 0x339, 0x677, 0x9aa,
    0x1601, 0x3903, 0x7706, 0xaa09, 0x10117, 0x3033a,
    0x60671, 0x909a3, 0x171616, 0x3a3939, 0x717777, 0xa3aaaa,
    0x1170001, 0x33a0003, 0x6710006, 0x9a30009, 0x16160017, 0x3939003a,
    0x77770071, 0xaaaa00a3
  },
  {
    0x1, 0x3, 0x4, 0xa, 0x1f, 0x2e,
    0x45, 0xc9, 0x11b, 0x2a4, 0x79a, 0xb67,
    0x101e, 0x302d, 0x4041, 0xa0c3, 0x1f104, 0x2e28a,
    0x457df, 0xc9bae, 0x11a105, 0x2a7289, 0x79e7db, 0xb6dba4,
    0x100011a, 0x30002a7, 0x400079e, 0xa000b6d, 0x1f001001, 0x2e003003,
    0x45004004, 0xc900a00a
  }
};

static inline void
sobol_third_and_fourth(uint32_t index, uint32_t *third, uint32_t *fourth)
{
  *third = *fourth = 0;
  for (; index; index &= index - 1)
    {
      unsigned bit = __builtin_ctz(index);
      *third ^= sobol_columns[0][bit];
      *fourth ^= sobol_columns[1][bit];
    }
}

#endif
