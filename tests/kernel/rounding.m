// rounding.m - k_float.h: the floats next to a double, on the side they are
// said to be on and no farther away than the next.

#import <Foundation/Foundation.h>
#include "kernel/k_float.h"
#include "support.h"

static unsigned wrong, far;

/** below <= x <= above, and nothing in between. */
static void
check(double x)
{
  float below = k_float_below(x), above = k_float_above(x);
  int is_wrong = !(below <= x) || !(above >= x);
  int is_far = (double)(float)x == x ? below != x || above != x
    : nextafterf(below, HUGE_VALF) != above;

  if ((is_wrong || is_far) && wrong + far == 0)
    {
      printf("# %a: %a and %a\n", x, below, above);
    }
  wrong += is_wrong;
  far += is_far;
}

static void
both(double x)
{
  check(x);
  check(-x);
}

int
main(void)
{
  static const double some[] = { 0, 0x1p-1074, 0x1p-1022, 0x1p-200, 0x1p-151,
    0x1p-150, 0x1.8p-150, 0x1p-149, 0x1.8p-149, 0x1.fffffep-127, 0x1p-126,
    1, 0x1.000001p0, 0x1.0000018p0, 0x1.fffffefp0, FLT_MAX, 0x1.fffffefp127,
    0x1.ffffffp127, 0x1.ffffff8p127, 0x1p128, 0x1p200, DBL_MAX, HUGE_VAL };

  for (unsigned i = 0; i < sizeof some / sizeof *some; i++)
    {
      both(some[i]);
      both(nextafter(some[i], HUGE_VAL));
      both(nextafter(some[i], 0));
    }
  for (int e = -1074; e <= 1023; e++)
    {
      struct support_random random = support_seed(e + 2000);
      for (int i = 0; i < 500; i++)
        {
          both(ldexp(1 + support_unit(&random), e));
        }
    }
  PASS(wrong == 0, "two million doubles of every size: %u are rounded"
       " inwards", wrong);
  PASS(far == 0, "and %u farther than to the next float", far);
  PASS(k_float_below(0x1p200) == FLT_MAX && k_float_above(-0x1p200) == -FLT_MAX
       && k_float_above(0x1p200) == HUGE_VALF
       && k_float_below(-0x1p200) == -HUGE_VALF,
       "beyond all floats: the last one and infinity");
  PASS(k_float_below(0x1p-1074) == 0 && k_float_above(0x1p-1074) == 0x1p-149f
       && k_float_below(-0x1p-1074) == -0x1p-149f
       && k_float_above(-0x1p-1074) == 0, "below all floats: 0 and the first");
  return test_done();
}
