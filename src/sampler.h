// sampler.h - random numbers that are no stream: each is a function of the
// seed, the pixel, the sample and the dimension, so a picture does not depend
// on the order in which its pixels are computed. Notes, "depth of field":
// "need a random no. generator: rand()".

#ifndef SAMPLER_H
#define SAMPLER_H

#include <stdint.h>

/** What a random number is for. */
enum dimension
{
  DIMENSION_PIXEL_RIGHT,
  DIMENSION_PIXEL_UP,
  DIMENSION_LENS_U,
  DIMENSION_LENS_V
};

/** Mixes 64 bits so that each bit of the result depends on every bit of x
    (the finaliser of Steele, Lea, Flood, "Fast Splittable Pseudorandom Number
    Generators", 2014, variant 13 of Stafford). */
static inline uint64_t
sampler_mix(uint64_t x)
{
  x ^= x >> 30;
  x *= 0xbf58476d1ce4e5b9u;
  x ^= x >> 27;
  x *= 0x94d049bb133111ebu;
  x ^= x >> 31;
  return x;
}

#define SAMPLER_GOLDEN 0x9e3779b97f4a7c15u

/** 64 bits for a sample of a pixel. */
static inline uint64_t
sampler_key(uint64_t seed, unsigned column, unsigned row, uint64_t sample)
{
  uint64_t x = sampler_mix(seed + SAMPLER_GOLDEN);

  x = sampler_mix(x ^ (((uint64_t)row << 32 | column) + SAMPLER_GOLDEN));
  return sampler_mix(x ^ (sample + SAMPLER_GOLDEN));
}

/** A number in [0, 1), a multiple of 2^-53. */
static inline double
sampler_random(uint64_t seed, unsigned column, unsigned row, uint64_t sample,
               enum dimension dimension)
{
  uint64_t x = sampler_key(seed, column, row, sample);

  x = sampler_mix(x ^ (dimension + SAMPLER_GOLDEN));
  return (x >> 11) * 0x1p-53;
}

#endif
