// number.h - numbers as they stand in a model file, and back. Whole words,
// in the C locale whatever the user's is; never rounded but to the nearest
// double.

#ifndef NUMBER_H
#define NUMBER_H

#include <locale.h>
#include <stddef.h>

enum number_result
{
  NUMBER_GOOD,
  NUMBER_NONE,          // not a number; nan and inf are none
  NUMBER_NOT_WHOLE,     // something else than digits
  NUMBER_TOO_LARGE,     // more than 2^400
  NUMBER_TOO_SMALL      // less than 2^-400 and not 0
};

/** The fast way for short decimal numbers. The digits make a whole number below
    2^53 and the power of ten is one of those that a double holds exactly, so
    that the one operation is correctly rounded: what strtod gives (Clinger,
    "How to Read Floating Point Numbers Accurately", 1990). Where the number
    ends; NULL if it is not as simple as that. It is in every model's range. */
const char *number_read_short(const char *at, double *value);

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
