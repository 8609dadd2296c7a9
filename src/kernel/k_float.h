// k_float.h - the floats below and above a double: rounding outwards.

#ifndef K_FLOAT_H
#define K_FLOAT_H

#include <float.h>
#include <math.h>
#include <stdint.h>
#include <string.h>

/** The next float up in value (step +1), down (-1) or the same (0), for finite
    x; the largest goes to infinity. A zero to be left has the sign of where it
    comes from: what was rounded to it was not 0. */
static inline float
k_float_step(float x, int step)
{
  int32_t bits;

  memcpy(&bits, &x, sizeof bits);
  bits += bits < 0 ? -step : step;
  memcpy(&x, &bits, sizeof bits);
  return x;
}

/** The largest float <= x (-infinity only for itself and below all). */
static inline float
k_float_below(double x)
{
  float f = x > FLT_MAX && x < HUGE_VAL ? FLT_MAX : (float)x;

  return k_float_step(f, -(f > x));
}

/** The smallest float >= x. */
static inline float
k_float_above(double x)
{
  float f = x < -FLT_MAX && x > -HUGE_VAL ? -FLT_MAX : (float)x;

  return k_float_step(f, f < x);
}

#endif
