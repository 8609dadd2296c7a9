// stratified.h - n points of the unit square, one in each of n parts of equal
// area, anywhere in it ("jittered"). The parts lie in rows, as near to square
// as n allows: 7 are rows of 2, 3 and 2, as high as they have parts.

#ifndef STRATIFIED_H
#define STRATIFIED_H

#include "sampler.h"

/** The same number of things in another order: where thing i of n goes, by a
    key. The bits that n needs are mixed until the result is below n. */
static inline uint64_t
stratified_place(uint64_t i, uint64_t n, uint64_t key)
{
  unsigned bits = n > 2 ? 64 - __builtin_clzll(n - 1) : 1;
  uint64_t mask = ((uint64_t)1 << bits) - 1;

  do
    {
      for (unsigned turn = 0; turn < 4; turn++)
        {
          uint64_t k = key >> 16 * turn;
          i = (i + k) & mask;
          i = (i * (k << 1 | 1)) & mask;
          i ^= i >> (bits + 1) / 2;
        }
    }
  while (i >= n);
  return i;
}

/** How many rows n parts make: the root of n, to the nearest. */
static inline uint64_t
stratified_rows(uint64_t n)
{
  uint64_t rows = (uint64_t)sqrt((double)n);

  return n > rows * (rows + 1) ? rows + 1 : rows;
}

/** The point in part i of n, for two numbers in [0, 1) that are random; it is
    written over them. */
static inline void
stratified_point(uint64_t i, uint64_t n, uint64_t rows, double *a, double *b)
{
  uint64_t row = i * rows / n;
  uint64_t first = (row * n + rows - 1) / rows; // part of this row
  uint64_t next = ((row + 1) * n + rows - 1) / rows;

  *a = (i - first + *a) / (next - first);
  *b = (first + *b * (next - first)) / n;
}

#endif
