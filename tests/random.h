// random.h - random numbers for tests: a stream of its own for each, seeded by
// the index of a loop.

#ifndef RANDOM_H
#define RANDOM_H

#include <stdint.h>
#include "kernel/k_vec.h"

struct support_random
{
  uint64_t state;
};

static inline struct support_random
support_seed(uint64_t index)
{
  struct support_random random = { (index + 1) * 0x9e3779b97f4a7c15u };
  return random;
}

/** In [0, 1). */
static inline double
support_unit(struct support_random *random)
{
  uint64_t x = random->state += 0x9e3779b97f4a7c15u;

  x = (x ^ x >> 32) * 0xd6e8feb86659fd93u;
  x = (x ^ x >> 32) * 0xd6e8feb86659fd93u;
  x ^= x >> 32;
  return (x >> 11) * 0x1p-53;
}

/** In [least, most). */
static inline double
support_between(struct support_random *random, double least, double most)
{
  return least + (most - least) * support_unit(random);
}

/** In the cube [-size, size)^3. */
static inline struct k_vec
support_point(struct support_random *random, double size)
{
  double x = support_between(random, -size, size);
  double y = support_between(random, -size, size);
  double z = support_between(random, -size, size);

  return k_vec(x, y, z);
}

/** A unit vector, all directions alike. */
static inline struct k_vec
support_direction(struct support_random *random)
{
  struct k_vec v;

  do
    {
      v = support_point(random, 1);
    }
  while (k_dot(v, v) > 1 || k_dot(v, v) < 0x1p-20);
  return k_unit(v);
}

#endif
