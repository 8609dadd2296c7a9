#include "arithmetic.h"
#include <math.h>

// What a compiler works out beforehand is the same as what the machine works
// out: 0.1 · 10 - 1 is 0 after two roundings, 2^-54 after one.
static const double folded_data = 0.1 * 10 - 1;

static double
folded_code(void)
{
  double tenth = 0.1, ten = 10, one = 1;

  return tenth * ten - one;
}

const char *
arithmetic_fault(void)
{
  // Volatile, so that it is this machine that computes, now.
  volatile double one = 1, tenth = 0.1, ten = 10, two = 2;
  volatile double half_ulp = 0x1p-53, more = 0x1.8p-53;
  volatile double product = tenth * ten, fused = tenth * ten - one;
  volatile double small = 0x1p-1022, smallest = 0x1p-1074;
  volatile float small_float = 0x1p-126f, smallest_float = 0x1p-149f;

  if (one + half_ulp != 1 || one + more != 1 + 0x1p-52
      || -one - more != -1 - 0x1p-52)
    {
      return "does not round to nearest";
    }
  if (product - one != 0 || fused != 0)
    {
      return "does not round after every operation";
    }
  if (folded_data != 0 || folded_code() != 0)
    {
      return "is not that of the compiler, which rounds otherwise";
    }
  // An operand that is taken for 0.
  if (smallest * 0x1p1000 != 0x1p-74
      || smallest_float * 0x1p100f != 0x1p-49f)
    {
      return "does not read the smallest numbers (denormals are zero)";
    }
  // A result that is flushed to 0.
  if (small / two * two != small
      || small_float / (float)two * (float)two != small_float)
    {
      return "does not keep the smallest numbers (flush to zero)";
    }
  if (sqrt(two) != 0x1.6a09e667f3bcdp+0 || sqrt(2.0) != 0x1.6a09e667f3bcdp+0)
    {
      return "has another square root";
    }
  return 0;
}
