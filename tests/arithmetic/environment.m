// The start-up check sees a floating-point environment that is not ours.

#import <Foundation/Foundation.h>
#include "arithmetic.h"
#include "test.h"
#include <fenv.h>
#include <string.h>
#if defined(__SSE2__)
#include <xmmintrin.h>
#endif

int
main(void)
{
  PASS(arithmetic_fault() == NULL, "the machine as it starts is fine");

  static const int modes[] = { FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO };
  for (unsigned i = 0; i < 3; i++)
    {
      fesetround(modes[i]);
      const char *fault = arithmetic_fault();
      fesetround(FE_TONEAREST);
      PASS(fault && strstr(fault, "nearest"), "rounding mode %u is refused", i);
    }
#if defined(__SSE2__)
  // Bit 15 flushes results, bit 6 takes operands for zero.
  static const struct { unsigned bits; const char *fault; } ways[] = {
    { 0x8000, "flush to zero" }, { 0x0040, "denormals are zero" },
    { 0x8040, "denormals are zero" },
  };
  for (unsigned i = 0; i < 3; i++)
    {
      unsigned before = _mm_getcsr();
      _mm_setcsr(before | ways[i].bits);
      const char *fault = arithmetic_fault();
      _mm_setcsr(before);
      PASS(fault && strstr(fault, ways[i].fault), "%s (%x) is refused: %s",
           ways[i].fault, ways[i].bits, fault ? fault : "it was not");
    }
#endif
  PASS(arithmetic_fault() == NULL, "and fine again");
  return test_done();
}
