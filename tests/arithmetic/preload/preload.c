// preload - a library that changes the floating-point environment before main,
// as one that is linked with -ffast-math does. FLOATS says how.

#include <fenv.h>
#include <stdlib.h>
#include <string.h>
#if defined(__SSE2__)
#include <xmmintrin.h>
#endif

__attribute__((constructor)) static void
change(void)
{
  const char *how = getenv("FLOATS");

  if (!how)
    {
      return;
    }
  if (strcmp(how, "up") == 0)
    {
      fesetround(FE_UPWARD);
    }
  if (strcmp(how, "down") == 0)
    {
      fesetround(FE_DOWNWARD);
    }
  if (strcmp(how, "zero") == 0)
    {
      fesetround(FE_TOWARDZERO);
    }
#if defined(__SSE2__)
  if (strcmp(how, "ftz") == 0)
    {
      _mm_setcsr(_mm_getcsr() | 0x8000);
    }
  if (strcmp(how, "daz") == 0)
    {
      _mm_setcsr(_mm_getcsr() | 0x0040);
    }
#endif
}
