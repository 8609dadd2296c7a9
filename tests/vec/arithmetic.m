// arithmetic.m - vec_t: everything but reflection and refraction.

#import "support.h"
#include "test.h"

static vec_t *
vec(double x, double y, double z)
{
  return [[[vec_t alloc] init: x : y : z] autorelease];
}

static int
is(vec_t *a, double x, double y, double z)
{
  return [a x] == x && [a y] == y && [a z] == z;
}

static void
components(void)
{
  vec_t *a = vec(1, -2, 3);
  struct k_vec v = { 4, 5, 6 };

  PASS(is(a, 1, -2, 3), "init: x : y : z keeps the three in this order");
  PASS(support_same([a value], k_vec(1, -2, 3)), "value is the three");
  PASS(support_same([vec_t vec: v]->v, v), "vec: makes one from a value");
  vec_t *b = [[vec_t alloc] initWithValue: v];
  PASS(is(b, 4, 5, 6), "initWithValue: likewise");
  [b release];
  PASS([[a description] isEqual: @"(1 -2 3)"], "description shows them");
}

static void
operations(void)
{
  vec_t *a = vec(1, -2, 3), *b = vec(5, 7, -11);

  PASS(is([a add: b], 6, 5, -8), "add:");
  PASS(is([a sub: b], -4, -9, 14), "sub:");
  PASS(is([a mul: b], 5, -14, -33), "mul: is channel by channel");
  PASS(is([a scale: -2], -2, 4, -6), "scale:");
  PASS([a dot: b] == 5 - 14 - 33, "dot:");
  PASS(is([a cross: b], 22 - 21, 15 + 11, 7 + 10), "cross:");
  PASS(is([vec(1, 0, 0) cross: vec(0, 1, 0)], 0, 0, 1),
       "x cross y is z: right-handed");
  PASS(is([vec(0, 1, 0) cross: vec(0, 0, 1)], 1, 0, 0), "y cross z is x");
  PASS(is([vec(0, 0, 1) cross: vec(1, 0, 0)], 0, 1, 0), "z cross x is y");
  PASS(is(a, 1, -2, 3) && is(b, 5, 7, -11), "none of them changes its"
       " operands");
}

static void
lengths(void)
{
  PASS([vec(2, 3, 6) length] == 7, "length of (2 3 6) is 7");
  PASS([vec(0, 0, 0) length] == 0, "length of zero is 0");
  PASS_ULPS([vec(3e300, 4e300, 0) length], 5e300, 2, "no overflow at 3e300");
  PASS_ULPS([vec(3e-300, 4e-300, 0) length], 5e-300, 2,
            "no underflow at 3e-300");
  PASS([vec(0x1.8p-1073, 0, 0) length] == 0x1.8p-1073,
       "a denormal's length is itself");
  PASS(is([vec(0, 0, 0) unit], 0, 0, 0), "the unit of zero is zero");
  PASS(is([vec(0, -1e-320, 0) unit], 0, -1, 0), "unit of a denormal");
  PASS(is([vec(DBL_MAX, 0, 0) unit], 1, 0, 0), "unit of the largest double");
  PASS(is([vec(-0x1p-400, 0, 0) unit], -1, 0, 0), "unit at 2^-400");
}

/** unit: three operations on each component, the sum of squares halved by
    the root: 1.5 u + 0.5 u + 0.5 u, each component within 3 u; the same bits
    at every power of two. */
static void
units(void)
{
  unsigned long_or_short = 0, changed = 0, off = 0, lengths_off = 0;

  for (unsigned i = 0; i < 20000; i++)
    {
      struct support_random random = support_seed(i);
      struct k_vec v = support_point(&random, 10);
      struct k_vec unit = [[vec_t vec: v] unit]->v;
      struct q_vec u = q_unit(q_of(v));
      double length = [[vec_t vec: v] length];
      quad l2 = q_dot(q_of(unit), q_of(unit));
      long_or_short += q_abs(l2 - 1) > 6 * (quad)K_U;
      off += q_apart(unit, u) > 3 * K_U;
      lengths_off += q_abs(length - q_sqrt(q_dot(q_of(v), q_of(v))))
        > 2.5 * K_U * length;
      for (int k = -1000; k <= 1000; k += 125)
        {
          struct k_vec scaled = k_scale(v, ldexp(1, k));
          changed += !support_same([[vec_t vec: scaled] unit]->v, unit)
            && k_norm_max(scaled) > 0x1p-1010;
          changed += ldexp([[vec_t vec: scaled] length], -k) != length
            && k_norm_max(scaled) > 0x1p-950;
        }
    }
  PASS(long_or_short == 0, "the unit vector's length is 1 to 3 u: %u",
       long_or_short);
  PASS(off == 0, "its components are right to 3 u: %u", off);
  PASS(lengths_off == 0, "length is right to 2.5 u: %u", lengths_off);
  PASS(changed == 0, "unit and length do not depend on a power of two: %u",
       changed);
}

int
main(void)
{
  NSAutoreleasePool *pool = [[NSAutoreleasePool alloc] init];

  components();
  operations();
  lengths();
  units();
  [pool release];
  return test_done();
}
