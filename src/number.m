#define _GNU_SOURCE             // strtod_l
#include "number.h"
#include <errno.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

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
