// k_float.h - the floats below and above a double: rounding outwards.

#ifndef K_FLOAT_H
#define K_FLOAT_H

#include <float.h>
#include <math.h>
#include <stdint.h>
#include <string.h>

/** The next float up (step +1) or down (-1) in value, for finite x; the
    largest goes to infinity. */
static inline float
k_float_step(float x, int step)
{
  int32_t bits;

  if (x == 0)
    {
      return step > 0 ? 0x1p-149f : -0x1p-149f;
    }
  memcpy(&bits, &x, sizeof bits);
  bits += x > 0 ? step : -step;
  memcpy(&x, &bits, sizeof bits);
  return x;
}

/** The largest float <= x (-infinity only for itself and below all). */
static inline float
k_float_below(double x)
{
  float f = x > FLT_MAX && x < HUGE_VAL ? FLT_MAX : (float)x;

  return f > x ? k_float_step(f, -1) : f;
}

/** The smallest float >= x. */
static inline float
k_float_above(double x)
{
  float f = x < -FLT_MAX && x > -HUGE_VAL ? -FLT_MAX : (float)x;

  return f < x ? k_float_step(f, +1) : f;
}

#endif
