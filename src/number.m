#define _GNU_SOURCE             // strtod_l
#include "number.h"
#include <errno.h>
#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>

const char *
number_read_short(const char *p, double *value)
{
  static const double powers[] = {
    1e0, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8, 1e9, 1e10, 1e11, 1e12, 1e13,
    1e14, 1e15, 1e16, 1e17
  };
  int is_negative = *p == '-';
  uint64_t whole = 0;

  p += *p == '-' || *p == '+';

  const char *start = p, *point = NULL;

  for (; p - start <= 17; p++)
    {
      unsigned digit = (unsigned char)*p - '0';
      if (digit <= 9)
        {
          whole = 10 * whole + digit;
        }
      else if (*p == '.' && point == NULL)
        {
          point = p;
        }
      else
        {
          break;
        }
    }

  int decimals = point ? p - point - 1 : 0;

  if (p - start > 17 || p - start == (point != NULL)
      || whole > (uint64_t)1 << 53)
    {
      return NULL;
    }
  double magnitude = whole / powers[decimals];
  *value = is_negative ? -magnitude : magnitude;
  return p;
}

enum number_result
number_range(double value)
{
  double magnitude = fabs(value);

  return magnitude > 0x1p400 ? NUMBER_TOO_LARGE
    : magnitude < 0x1p-400 && magnitude != 0 ? NUMBER_TOO_SMALL : NUMBER_GOOD;
}

enum number_result
number_read(const char *at, size_t length, locale_t c, double *value)
{
  const char *end = at + length;
  char *stop;

  if (length == 0 || number_read_short(at, value) != end)
    {
      errno = 0;
      *value = strtod_l(at, &stop, c);
      if (stop != end || length == 0 || isnan(*value)
          || (isinf(*value) && errno != ERANGE))
        {
          return NUMBER_NONE;
        }
      if (*value == 0 && errno == ERANGE)
        {
          return NUMBER_TOO_SMALL;
        }
    }
  return number_range(*value);
}

enum number_result
number_read_whole(const char *at, size_t length, locale_t c, double *value)
{
  double whole = 0;

  for (size_t i = 0; i < length; i++)
    {
      if (at[i] < '0' || at[i] > '9')
        {
          return number_read(at, length, c, value) == NUMBER_NONE
            ? NUMBER_NONE : NUMBER_NOT_WHOLE;
        }
      whole = fmin(10 * whole + (at[i] - '0'), 1e15);
    }
  *value = whole;
  return length > 0 ? NUMBER_GOOD : NUMBER_NONE;
}

void
number_write(double value, locale_t c, char text[32])
{
  locale_t before = uselocale(c);

  for (int digits = 15; digits <= 17; digits++)
    {
      snprintf(text, 32, "%.*g", digits, value);
      if (strtod(text, NULL) == value)
        {
          break;
        }
    }
  uselocale(before);
}
