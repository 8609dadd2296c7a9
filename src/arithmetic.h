// arithmetic.h - whether this machine computes as the pictures need it: IEEE
// doubles, rounded to nearest after every operation, down to the smallest.
// Another library can change that for the whole process at start-up.

#ifndef ARITHMETIC_H
#define ARITHMETIC_H

#include <float.h>

_Static_assert(FLT_EVAL_METHOD == 0, "doubles are computed as doubles");
_Static_assert(FLT_RADIX == 2 && DBL_MANT_DIG == 53, "IEEE doubles");

/** NULL, or what is wrong with the arithmetic, for a message. */
const char *arithmetic_fault(void);

#endif
