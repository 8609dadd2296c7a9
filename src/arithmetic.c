#include "arithmetic.h"
#include <math.h>

const char *
arithmetic_fault(void)
{
  // Volatile, so that it is this machine that computes, now.
  volatile double one = 1, tenth = 0.1, two = 2, tiny = 0x1p-1022;
  volatile double half_ulp = 0x1p-53, more = 0x1.8p-53;
  volatile double product = tenth * 10, fused = tenth * 10 - one;

  if (one + half_ulp != 1 || one + more != 1 + 0x1p-52
      || -one - more != -1 - 0x1p-52)
    {
      return "does not round to nearest";
    }
  if (product - one != 0 || fused != 0)
    {
      return "does not round after every operation";
    }
  if (tiny / two != 0x1p-1023 || tiny / two == 0)
    {
      return "does not keep the smallest numbers (flush to zero)";
    }
  if (sqrt(two) != 0x1.6a09e667f3bcdp+0)
    {
      return "has another square root";
    }
  return 0;
}
