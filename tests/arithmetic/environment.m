// The start-up check sees a floating-point environment that is not ours.

#import <Foundation/Foundation.h>
#include "arithmetic.h"
#include "test.h"
#include <fenv.h>
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
      PASS(fault != NULL, "rounding mode %u is refused", i);
    }
#if defined(__SSE2__)
  unsigned before = _mm_getcsr();
  _mm_setcsr(before | 0x8000);  // flush to zero
  const char *fault = arithmetic_fault();
  _mm_setcsr(before);
  PASS(fault != NULL, "flush to zero is refused");
#endif
  return test_done();
}
