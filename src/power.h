// power.h - x to the power y with + - * / alone, in an order that is written
// here: the same bits everywhere, which pow of the C library does not promise.

#ifndef POWER_H
#define POWER_H

#include <math.h>
#include <stdint.h>
#include <string.h>

/** 2^n for -1022 <= n <= 1023. */
static inline double
power_of_two(int n)
{
  uint64_t bits = (uint64_t)(n + 1023) << 52;
  double x;

  memcpy(&x, &bits, sizeof x);
  return x;
}

/** x = m 2^e, m between the roots of 1/2 and 2, for x > 0. */
static inline double
power_split(double x, int *e)
{
  uint64_t bits;

  *e = 0;
  if (x < 0x1p-1022)
    {
      x *= 0x1p54;
      *e = -54;
    }
  memcpy(&bits, &x, sizeof bits);
  *e += (int)(bits >> 52) - 1023;
  double m = x * power_of_two(-((int)(bits >> 52) - 1023));
  if (m > 0x1.6a09e667f3bcdp0)
    {
      m /= 2;
      ++*e;
    }
  return m;
}

/** The binary logarithm of m between the roots of 1/2 and 2: the series of
    2 artanh((m - 1)/(m + 1)) / ln 2. */
static inline double
power_log2(double m)
{
  static const double c[] = {
    0x1.71547652b82fep+1, 0x1.ec709dc3a03fdp-1, 0x1.2776c50ef9bfep-1,
    0x1.a61762a7aded9p-2, 0x1.484b13d7c02a9p-2, 0x1.0c9a84994022dp-2,
    0x1.c68f568d31760p-3, 0x1.89f3b1694cffep-3, 0x1.5b9ac9b743f0dp-3,
    0x1.3703c1f4d0ffep-3, 0x1.1964ec6fc9491p-3
  };
  double s = (m - 1) / (m + 1);
  double z = s * s;
  double z2 = z * z;
  double even = c[10], odd = c[9];

  for (int k = 8; k >= 0; k -= 2)
    {
      even = even * z2 + c[k];
    }
  for (int k = 7; k > 0; k -= 2)
    {
      odd = odd * z2 + c[k];
    }
  return s * (even + odd * z);
}

/** 2^r for -1/2 <= r <= 1/2: the series of exp(r ln 2). */
static inline double
power_exp2(double r)
{
  static const double c[] = {
    0x1.0000000000000p+0, 0x1.62e42fefa39efp-1, 0x1.ebfbdff82c58fp-3,
    0x1.c6b08d704a0c0p-5, 0x1.3b2ab6fba4e77p-7, 0x1.5d87fe78a6731p-10,
    0x1.430912f86c787p-13, 0x1.ffcbfc588b0c7p-17, 0x1.62c0223a5c824p-20,
    0x1.b5253d395e7c4p-24, 0x1.e4cf5158b8ecap-28, 0x1.e8cac7351bb25p-32,
    0x1.c3bd650fc2986p-36, 0x1.816193166d0f9p-40, 0x1.314964d5878a9p-44
  };
  double r2 = r * r;
  double even = c[14], odd = c[13];

  for (int k = 12; k >= 0; k -= 2)
    {
      even = even * r2 + c[k];
    }
  for (int k = 11; k > 0; k -= 2)
    {
      odd = odd * r2 + c[k];
    }
  return even + odd * r;
}

/** x^f for 0 < x <= 1 and 0 < f < 1, to about an ulp: 2^(f log2 x), where the
    whole part of the logarithm times f, which may be large, is kept exact. */
static inline double
power_fraction(double x, double f)
{
  int e;
  double l = power_log2(power_split(x, &e));
  double high = (float)f;       // 24 bits: times e it is exact
  double low = f - high;
  double rest = e * low + f * l;
  double n = e * high + rest;

  n = (n + 0x1.8p52) - 0x1.8p52;        // to the nearest
  double power = power_exp2((e * high - n) + rest);
  return n < -1022 ? power * 0x1p-600 * power_of_two(n + 600)
    : power * power_of_two(n);
}

/** x^y for 0 <= x <= 1 and y >= 0: the whole part of y by squaring, the
    fraction by logarithm. 0^0 is 1. */
static inline double
power(double x, double y)
{
  double result = 1;

  if (y >= 0x1p63)
    {
      return x < 1 ? 0 : 1;
    }
  uint64_t whole = (uint64_t)y;
  double fraction = y - (double)whole;

  if (x == 0)
    {
      return y == 0 ? 1 : 0;
    }
  for (double p = x; whole; whole >>= 1, p *= p)
    {
      if (whole & 1)
        {
          result *= p;
        }
    }
  return fraction > 0 ? result * power_fraction(x, fraction) : result;
}

#endif
