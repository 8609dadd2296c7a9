// owen.h - points of the unit square that fill it evenly: Sobol's first two
// dimensions, whose digits are scrambled as by Owen ("Randomly permuted
// (t,m,s)-nets", 1995). Every 2^k of them, from a multiple of 2^k on, has one
// point in each of the 2^k parts of any grid of 2^a x 2^(k-a); each point by
// itself is anywhere. Whole numbers only.
//
// Two numbers more, of the third and fourth dimension, make points of a cube of
// four: a place on the lens and one in the pixel, so that each place on the
// lens meets all places in the pixel evenly. Every 2^k of those, k above 2,
// have 8 points in each of the 2^(k-3) parts of any grid of halvings.

#ifndef OWEN_H
#define OWEN_H

#include "sampler.h"
#include "sobol.h"

/** What makes two sequences different: one such for each pair of
    dimensions. */
struct owen
{
  uint64_t order, across, up;
};

/** Bit 31 becomes bit 0. */
static inline uint32_t
owen_reverse(uint32_t x)
{
  x = __builtin_bswap32(x);
  x = (x >> 4 & 0x0f0f0f0fu) | (x & 0x0f0f0f0fu) << 4;
  x = (x >> 2 & 0x33333333u) | (x & 0x33333333u) << 2;
  return (x >> 1 & 0x55555555u) | (x & 0x55555555u) << 1;
}

/** Changes each bit, or not, by a rule of its own for all that is in the
    lower ones: a sum and a product do that (Laine and Karras, "Stratified
    sampling for stochastic transparency", 2011). Bit 0 of x is the first
    digit of a point. */
static inline uint32_t
owen_scramble(uint32_t x, uint64_t key)
{
  uint32_t sum = (uint32_t)key, factor = (uint32_t)(key >> 32);

  x += sum;
  x *= factor | 1;
  x ^= x * 0x9c8f2d56u;
  x += factor >> 7;
  x ^= x * 0x5be0cd1au;
  x *= sum | 1;
  x ^= x * 0xa54ff532u;
  return x;
}

/** The sequence of a pixel for a pair of dimensions, the first of which is
    named. Batches are independent of each other. */
static inline struct owen
owen_sequence(uint64_t seed, unsigned column, unsigned row, uint64_t batch,
              enum dimension first)
{
  uint64_t x = sampler_key(seed, column, row, batch);

  return (struct owen){
    sampler_mix(x + 3 * first + 1), sampler_mix(x + 3 * first + 2),
    sampler_mix(x + 3 * first + 3)
  };
}

/** Where point `index` comes in Sobol's order: in another one, in which 2^k
    points that belong together stay together. */
static inline uint32_t
owen_index(const struct owen *sequence, uint32_t index)
{
  return owen_reverse(owen_scramble(owen_reverse(index), sequence->order));
}

/** Point number `index`: multiples of 2^-32 in [0, 1). */
static inline void
owen_point(const struct owen *sequence, uint32_t index, double *a, double *b)
{
  uint32_t i = owen_index(sequence, index);

  *a = owen_reverse(owen_scramble(i, sequence->across)) * 0x1p-32;
  *b = owen_reverse(owen_scramble(sobol_second(i), sequence->up)) * 0x1p-32;
}

/** The same of the third and fourth dimension: beside the points of a sequence
    of the same order. */
static inline void
owen_point_beside(const struct owen *sequence, uint32_t index, double *a,
                  double *b)
{
  uint32_t third, fourth;

  sobol_third_and_fourth(owen_index(sequence, index), &third, &fourth);
  *a = owen_reverse(owen_scramble(third, sequence->across)) * 0x1p-32;
  *b = owen_reverse(owen_scramble(fourth, sequence->up)) * 0x1p-32;
}

#endif
