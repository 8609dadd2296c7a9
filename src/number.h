// number.h - numbers as they stand in a model file, and back. Whole words,
// in the C locale whatever the user's is; never rounded but to the nearest
// double.

#ifndef NUMBER_H
#define NUMBER_H

#include <locale.h>
#include <stddef.h>
#include <stdint.h>

enum number_result
{
  NUMBER_GOOD,
  NUMBER_NONE,          // not a number; nan and inf are none
  NUMBER_NOT_WHOLE,     // something else than digits
  NUMBER_TOO_LARGE,     // more than 2^400
  NUMBER_TOO_SMALL      // less than 2^-400 and not 0
};

/** The fast way for short decimal numbers. The digits make a whole number of at
    most 2^53 and the power of ten is one of those that a double holds exactly,
    so that the one operation is correctly rounded: what strtod gives (Clinger,
    "How to Read Floating Point Numbers Accurately", 1990). Where the number
    ends; NULL if it is not as simple as that. It is in every model's range. */
static inline const char *
number_read_short(const char *p, double *value)
{
  static const double powers[] = {
    1e0, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8, 1e9, 1e10, 1e11, 1e12, 1e13,
    1e14, 1e15, 1e16, 1e17
  };
  int is_negative = *p == '-';
  uint64_t whole = 0;
  unsigned digit;

  p += *p == '-' || *p == '+';

  const char *start = p;
  ptrdiff_t digits, decimals = 0;

  for (; (digit = (unsigned char)*p - '0') <= 9; p++)
    {
      whole = 10 * whole + digit;
    }
  digits = p - start;
  if (*p == '.')
    {
      start = ++p;
      for (; (digit = (unsigned char)*p - '0') <= 9; p++)
        {
          whole = 10 * whole + digit;
        }
      decimals = p - start;
      digits += decimals;
    }
  if (digits == 0 || digits > 17 || whole > (uint64_t)1 << 53)
    {
      return NULL;
    }
  double magnitude = whole / powers[decimals];
  *value = is_negative ? -magnitude : magnitude;
  return p;
}

/** What strtod reads, if that is all of the word: `length` characters that
    are followed by white space, a brace, `#` or NUL. c is the C locale. */
enum number_result number_read(const char *at, size_t length, locale_t c,
                               double *value);

/** The same for digits only; past 10^15 it is 10^15. */
enum number_result number_read_whole(const char *at, size_t length,
                                     locale_t c, double *value);

/** Whether a model may have this number: 0 or a magnitude of 2^-400 to
    2^400. */
enum number_result number_range(double value);

/** The shortest of 15, 16 and 17 digits that reads back as the same. */
void number_write(double value, locale_t c, char text[32]);

#endif
