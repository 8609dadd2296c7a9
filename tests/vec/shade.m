// shade.m - the formulas of shade.h one by one. Notes, "Schlick's
// approximation", "shadow casting".

#import "support.h"
#include "test.h"

static double
schlick(double cos_i, double n_i, double n_t)
{
  struct k_vec N = { 0, 0, 1 };
  struct k_vec D = { sqrt(1 - cos_i * cos_i), 0, -cos_i };
  int tir;
  struct k_vec T = shade_refract(D, N, n_t / n_i, &tir);

  return tir ? 1 : shade_schlick(D, N, T, n_i, n_t);
}

static void
schlick_values(void)
{
  PASS_ULPS(schlick(1, 1, 1.5), 0.04, 1, "R0 = 0.04 for 1.5");
  PASS_ULPS(schlick(1, 1.5, 1), 0.04, 1, "and from the other side");
  PASS_ULPS(schlick(0.5, 1, 1.5), 0.07, 2, "0.07 at 60 degrees");
  PASS(schlick(0, 1, 1.5) == 1, "1 at 90 degrees");
  PASS_ULPS(schlick(1, 1, 1.83), 0.83 * 0.83 / (2.83 * 2.83), 4,
            "flint glass straight on: (0.83/2.83)^2");
  PASS(schlick(0.3, 1.5, 1.5) == 0, "equal indices reflect nothing");
  PASS(schlick(0.01, 1.5, 1.5) == 0, "not even at a grazing angle");
  PASS(schlick(0.7, 1.5, 1) == 1, "total internal reflection: 1");

  // Inside glass the angle counts on the air's side.
  double sin_i = 0.5, cos_t = sqrt(1 - 0.75 * 0.75);
  double want = 0.04 + 0.96 * pow(1 - cos_t, 5);
  PASS_NEAR(schlick(sqrt(1 - sin_i * sin_i), 1.5, 1), want, 8 * K_U,
            "from glass into air theta is the refracted angle");
  unsigned unlike = 0, outside = 0;
  for (unsigned i = 0; i < 10000; i++)
    {
      struct support_random random = support_seed(i);
      double a = support_between(&random, 1, 3);
      double b = support_between(&random, 1, 3);
      double c = support_between(&random, 0.01, 1);
      double n_i = fmin(a, b), n_t = fmax(a, b), n = n_t / n_i;
      double c_t = sqrt((n - 1) * (n + 1) + c * c) / n;
      double R = schlick(c, n_i, n_t);
      outside += !(R >= 0 && R <= 1);
      // Along the refracted ray, back: the cosine it is taken of is off by
      // 4 u n^2 / c, R by 5 times that.
      unlike += fabs(R - schlick(c_t, n_t, n_i)) > 20 * K_U * n * n / c;
    }
  PASS(outside == 0, "R is between 0 and 1: %u", outside);
  PASS(unlike == 0, "the way back reflects as much: %u", unlike);
  double s = 1 / 1.5;
  double just = schlick(sqrt(1 - s * s) * (1 + 1e-12), 1.5, 1);
  PASS(just > 1 - 1e-4 && just <= 1, "R grows to 1 at the critical angle,"
       " without a jump: %.9g", just);
}

/** Squarings lose up to u each, relative: y u in all for x^y; the fraction
    loses less than 4 u, under two ulps, and one product joins them. */
static void
powers(void)
{
  unsigned off = 0, off_fraction = 0;

  PASS(power(0, 0) == 1, "0^0 is 1");
  PASS(power(1, 0) == 1 && power(0.3, 0) == 1, "x^0 is 1");
  PASS(power(0, 7.5) == 0, "0^y is 0");
  PASS(power(1, 1e300) == 1, "1 to any power is 1");
  PASS(power(0.5, 10) == 0x1p-10, "2^-10");
  PASS(power(0.25, 0.5) == 0.5, "the root of 1/4");
  PASS(power(0.0625, 0.75) == 0.125, "1/16 to 3/4 is 1/8");
  PASS(power(0.25, 2.5) == 0x1p-5, "1/4 to 2.5 is 1/32");
  PASS(power(0.9, 1e30) == 0, "a huge exponent leaves nothing");
  PASS(power(1 - 0x1p-53, 0x1p70) == 0, "not even just below 1");
  for (unsigned i = 0; i < 20000; i++)
    {
      struct support_random random = support_seed(i);
      double x = support_unit(&random);
      double y = exp2(support_between(&random, -8, 10));
      long double want = powl(x, y);
      off += fabsl(power(x, y) - want) > (2 * y + 6) * K_U * want + DBL_MIN;
      // From next to 1 down to the smallest numbers.
      x = i % 2 ? x : exp2(support_between(&random, -1070, 0));
      y = support_unit(&random);
      want = powl(x, y);
      off_fraction += y > 0
        && fabsl(power(x, y) - want) > 4 * K_U * want + DBL_MIN;
    }
  PASS(off == 0, "agrees with powl: %u", off);
  PASS(off_fraction == 0, "exponents below 1, to two ulps: %u", off_fraction);
}

static void
falloffs(void)
{
  struct k_vec e = { 8, 4, 2 };

  PASS(support_same(shade_falloff(e, 4, 0), e), "falloff 0 keeps the light");
  PASS(support_same(shade_falloff(e, 4, 1), k_vec(2, 1, 0.5)), "falloff 1"
       " divides by r");
  PASS(support_same(shade_falloff(e, 4, 2), k_vec(0.5, 0.25, 0.125)),
       "falloff 2 divides by r^2");
  struct k_vec at_light = shade_falloff(k_vec(1, 0, 2), 0, 2);
  PASS(at_light.x == DBL_MAX && at_light.y == 0 && at_light.z == DBL_MAX,
       "at r = 0 it is the largest double, no infinity, and 0 stays 0");
  at_light = shade_ambient(k_vec(1, 0, 2), 0);
  PASS(at_light.x == DBL_MAX && at_light.y == 0 && at_light.z == DBL_MAX,
       "ambient over no distance likewise");
  PASS(support_same(shade_ambient(k_vec(3, 2, 1), 2), k_vec(1.5, 1, 0.5)),
       "ambient is divided by the distance");
}

static void
sums(void)
{
  struct k_vec c = { 1, 2, 3 };

  PASS(support_same(shade_lit(c, k_vec(0.5, 0.25, 1), k_vec(2, 4, 8), 0.5),
                    k_vec(1.5, 2.5, 7)), "lit: color + diffuse e (N.L)");
  PASS(support_same(shade_shadow(c, k_vec(10, 20, 30)),
                    k_vec(2, 4, 6)), "in shadow: color + 0.1 A");
  PASS(support_same(shade_mirror(c, k_vec(0.5, 0.5, 2), k_vec(1, 0, 0.5),
                                 k_vec(8, 8, 8)), k_vec(8.5, 1, 10)),
       "mirror: diffuse color + specular reflected");
  PASS(support_same(shade_blend(c, 0.75, 0.25, k_vec(4, 8, 0),
                                k_vec(8, 0, 4)),
                    k_vec(0.25 + 0.75 * 5, 0.5 + 0.75 * 6, 0.75 + 0.75)),
       "blend: (1-alpha) color + alpha ((1-R) refracted + R reflected)");
  PASS(support_same(shade_blend(c, 0, 0.25, k_vec(4, 8, 0), k_vec(8, 0, 4)),
                    c), "alpha 0 is the surface alone");
}

static void
highlights(void)
{
  struct k_vec N = { 0, 0, 1 }, black = { 0, 0, 0 };
  struct k_vec L = { 0.6, 0, 0.8 }, mirror = { -0.6, 0, 0.8 };
  struct k_vec ks = { 0.5, 0.25, 1 }, e = { 2, 4, 1 };
  struct k_vec h = shade_highlight(black, ks, e, N, L, mirror, 32);

  PASS_NEAR(h.x, 1, 100 * K_U, "in the mirror direction all of specular e");
  PASS_NEAR(h.z, 1, 100 * K_U, "in each channel");
  PASS(support_same(shade_highlight(black, ks, e, N, L, mirror, 0),
                    k_vec(1, 1, 1)), "shininess 0: everywhere");
  PASS(support_same(shade_highlight(black, ks, e, N, L, k_neg(mirror), 0),
                    k_vec(1, 1, 1)), "even behind: 0^0 is 1");
  PASS(support_same(shade_highlight(black, ks, e, N, L, k_neg(mirror), 2),
                    black), "but with any other exponent nothing behind");
  struct k_vec V = { 0, 0, 1 };         // H.V = 0.8
  PASS_NEAR(shade_highlight(black, ks, e, N, L, V, 2.5).x, pow(0.8, 2.5),
            100 * K_U, "an exponent that is not whole");
  PASS_NEAR(shade_highlight(black, ks, e, N, L, V, 1).z, 0.8, 4 * K_U,
            "exponent 1 is the cosine itself");
  // H.V rounded above 1 must not be raised to a power.
  struct k_vec longer = { 0, 0, 1 + 0x1p-50 };
  PASS(shade_highlight(black, ks, e, N, N, longer, 1e15).x == 1,
       "a cosine above 1 is 1");
}

int
main(void)
{
  NSAutoreleasePool *pool = [[NSAutoreleasePool alloc] init];

  schlick_values();
  powers();
  falloffs();
  sums();
  highlights();
  [pool release];
  return test_done();
}
