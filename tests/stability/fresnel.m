// fresnel.m - stability: Schlick against Fresnel, energy, reciprocity, drift;
// clear surfaces that coincide. R13 to R16, V06, V08.

#include "battery.h"

/** Fresnel's reflectance, unpolarised, into an index n times larger. */
static double
exact(double c, double n)
{
  double t = sqrt(1 - (1 - c * c) / (n * n));
  double s = (c - n * t) / (c + n * t), p = (t - n * c) / (t + n * c);

  return (s * s + p * p) / 2;
}

static double
schlick(double c, double n_i, double n_t)
{
  struct k_vec D = k_vec(sqrt(1 - c * c), 0, -c), N = k_vec(0, 0, 1);
  int tir;
  struct k_vec T = shade_refract(D, N, n_t / n_i, &tir);

  return tir ? 1 : shade_schlick(D, N, T, n_i, n_t);
}

static void
test_R13(void)
{
  static const double table[][2] = {
    { 1.0001, .902 }, { 1.1, .211 }, { 1.333, .059 }, { 1.5, .036 },
    { 2, .044 }, { 2.42, .076 }, { 4, .201 }, { 10, .398 }
  };

  for (unsigned i = 0; i < sizeof table / sizeof *table; i++)
    {
      double most = 0;
      for (int k = 0; k < 9000; k++)
        {
          double c = cos(k * (M_PI / 18000));
          most = fmax(most, fabs(schlick(c, 1, table[i][0])
                                 - exact(c, table[i][0])));
        }
      PASS_NEAR(most, table[i][1], 1.2e-3, "R13 index %g, most", table[i][0]);
    }
}

static void
test_R14_R15(void)
{
  double apart = 0, least = 1, most = 0;

  for (double n = 1.1; n < 4; n += .1)
    {
      for (int k = 0; k < 900; k++)
        {
          double c = cos(k * (M_PI / 1800));
          double c_t = sqrt(1 - (1 - c * c) / (n * n));
          double in = schlick(c, 1, n), out = schlick(c_t, n, 1);
          double back = schlick(c, n, 1);
          // R falls by 5 for the cosine c, which what c_t and its sine have
          // been rounded by changes by n^2 / c of that.
          apart = fmax(apart, fabs(in - out) * c / (5 * n * n));
          least = fmin(least, fmin(in, back));
          most = fmax(most, fmax(in, back));
        }
    }
  PASS_NEAR(apart, 0, 8 * U, "R14 in and out again");
  PASS(least >= 0 && most <= 1, "R15 between 0 and 1: %g to %.17g", least,
       most);
}

static void
test_R16(void)
{
  struct support_random random = { 16 };
  struct k_vec d = k_vec(0, 0, 1);
  double worst = 0;

  for (int bounce = 0; bounce < 1000; bounce++)
    {
      struct k_vec N = support_direction(&random);
      d = shade_renew(shade_reflect(d, k_dot(d, N) < 0 ? N : k_neg(N)));
      worst = fmax(worst, (double)q_abs(q_sqrt((quad)d.x * d.x
                                               + (quad)d.y * d.y
                                               + (quad)d.z * d.z) - 1));
    }
  PASS_NEAR(worst, 0, 2.5 * U, "R16 length after each of 1000 bounces, off by");
}

/** Whether everything that rays bring back is a number, from both engines. */
static int
is_finite(model_t *model)
{
  struct render_options options = support_render_options();
  image_t *image = support_picture(model, options);

  return image->nanCount == 0;
}

static void
test_coinciding(void)
{
  NSString *a = [NSString stringWithUTF8String:
                  support_box("a", "A", "glass", k_vec(.2, .2, -1),
                              k_vec(1, 1.8, 0))];
  NSString *b = [NSString stringWithUTF8String:
                  support_box("b", "B", "glass", k_vec(1, .2, -1),
                              k_vec(1.8, 1.8, 0))];
  model_t *cubes = support_model(BATTERY_HEAD "background 1 1 1\n%s%s",
                                 [a UTF8String], [b UTF8String]);
  model_t *walls = support_model(BATTERY_HEAD "background 1 1 1\n"
    "material water { alpha 1 ior 1.33 }\n"
    "sphere out { material glass center 1 1 -1 radius .8 }\n"
    "sphere in { material water center 1 1 -1 radius .8 }\n");

  PASS(is_finite(cubes), "V06 cubes that share a face (unsupported): finite,"
       " both engines alike");
  PASS(is_finite(walls), "V08 walls at one place (unsupported): finite, both"
       " engines alike");
}

int
main(void)
{
  NSAutoreleasePool *pool = [[NSAutoreleasePool alloc] init];

  test_R13();
  test_R14_R15();
  test_R16();
  test_coinciding();
  [pool release];
  return test_done();
}
