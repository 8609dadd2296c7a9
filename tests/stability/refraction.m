// refraction.m - stability: Snell's law and Schlick's approximation near
// their edges. R01 to R12. Directions have no size: mirrored only.

#include "battery.h"

/** A ray that runs against N = z at a given sine and cosine. */
static struct k_vec
towards(double sine, double cosine)
{
  return k_vec(sine, 0, -cosine);
}

static const struct k_vec z = { 0, 0, 1 };

/** The cosine of the refracted ray, in four times the precision, for a sine
    `s` of the incident one; -1 for total internal reflection. */
static quad
reference_cosine(quad s, quad n)
{
  quad k = 1 - s * s / (n * n);

  return k < 0 ? -1 : q_sqrt(k);
}

/** [D refract: N : n] by the class; the same mirrored. */
static struct k_vec
refracted(struct k_vec D, struct k_vec N, double n, unsigned *unlike)
{
  vec_t *T = [[vec_t vec: D] refract: [vec_t vec: N] : n];
  vec_t *M = [[vec_t vec: k_vec(-D.x, D.y, D.z)]
               refract: [vec_t vec: k_vec(-N.x, N.y, N.z)] : n];
  int tir, mirrored_tir;
  struct k_vec value = shade_refract(D, N, n, &tir);

  shade_refract(k_vec(-D.x, D.y, D.z), k_vec(-N.x, N.y, N.z), n,
                &mirrored_tir);
  *unlike += tir != mirrored_tir || !k_is_equal(value, T->v)
    || !k_is_equal(T->v, k_vec(-M->v.x, M->v.y, M->v.z));
  return value;
}

static unsigned unlike;         // mirrored results that are other bits

static int
is_reflected(struct k_vec D, struct k_vec N, double n)
{
  int tir;

  shade_refract(D, N, n, &tir);
  return tir;
}

// R01: out of ior 1.5 on both sides of the critical angle

static void
test_R01(void)
{
  const double critical = .7453559924999299;
  unsigned wrong = 0;
  double worst = 0, last = 0;

  for (int j = 20; j <= 52; j++)
    {
      for (int side = -1; side <= 1; side += 2)
        {
          double c = critical * (1 + side * ldexp(1, -j));
          struct k_vec D = towards(q_sqrt(1 - (quad)c * c), c);
          struct k_vec T = refracted(D, z, 1 / 1.5, &unlike);
          int tir = is_reflected(D, z, 1 / 1.5);
          wrong += tir != (side < 0);
          if (!tir)
            {
              quad cosine = reference_cosine(q_sqrt(1 - (quad)c * c),
                                             1 / (quad)1.5);
              double off = q_abs(-T.z - cosine);
              double bound = 4 * U / (double)cosine;
              if (j == 52)
                {
                  last = off;
                }
              else
                {
                  worst = battery_max(worst, off / bound);
                }
            }
        }
    }
  PASS(wrong == 0, "R01 total internal reflection exactly below the critical"
       " angle: %u of 66 wrong", wrong);
  PASS_PART(worst, "R01 cos_t to 4u/cos_t (%.2f of it)", worst);
  PASS_NEAR(last, 0, 2e-8, "R01 2^-52 from the critical angle: cos_t off by"
            " %.2g, at most 2e-8", last);
}

// R02: the sine of the critical angle, and its neighbours

static void
test_R02(void)
{
  const double n = 1 / 1.5;
  unsigned wrong = 0;

  for (int i = -3; i <= 3; i++)
    {
      double s = 2 / 3.0 + i * U;
      struct k_vec D = towards(s, q_sqrt(1 - (quad)s * s));
      int expected = (quad)s > n;
      refracted(D, z, n, &unlike);
      wrong += is_reflected(D, z, n) != expected;
    }
  PASS(wrong == 0, "R02 within 3 ulps of the critical sine: %u of 7 decided"
       " wrong", wrong);
}

// R03: equal indices

static void
test_R03(void)
{
  unsigned wrong = 0;

  for (int e = 0; e <= 12; e++)
    {
      for (unsigned i = 0; i < 100; i++)
        {
          struct support_random random = support_seed(i);
          struct k_vec a, b, N = support_direction(&random);
          double c = pow(10, -e);
          battery_across(N, &a, &b);
          struct k_vec D = k_unit(k_along(k_scale(a, sqrt(1 - c * c)), -c,
                                          N));
          struct k_vec T = refracted(D, N, 1, &unlike);
          wrong += !support_same(D, T);
          wrong += shade_schlick(D, N, T, 1.5, 1.5) != 0;
        }
    }
  PASS(wrong == 0, "R03 ior 1, cosines 1 to 1e-12: %u of 1300 not straight"
       " on, bit for bit, with R = 0", wrong);
}

/** Largest error of cos_t, over 4 units of relative error times `per`. */
static double
cosine_error(double n, double s, double c, double per)
{
  struct k_vec T = refracted(towards(s, c), z, n, &unlike);
  quad cosine = reference_cosine(s, n);

  return (double)(q_abs(-T.z / cosine - 1) / (4 * U * per));
}

// R04: indices that are nearly equal

static void
test_R04(void)
{
  double worst = 0;

  for (double c = .5; c > 4e-5; c /= 1.7)
    {
      // The sine is rounded: the cosine that goes with it to the last digit.
      double s = q_sqrt(1 - (quad)c * c);
      quad exact_c = c;
      for (int way = 0; way < 2; way++)
        {
          double n = way ? 1 / (1 + 1e-9) : 1 + 1e-9;
          struct k_vec T = refracted(towards(s, c), z, n, &unlike);
          // n^2 cos_t^2 = n^2 - 1 + c^2
          quad k = ((quad)n - 1) * ((quad)n + 1) + exact_c * exact_c;
          if (k < 0)
            {
              PASS(is_reflected(towards(s, c), z, n), "R04 cos %g out of"
                   " ior 1 + 1e-9 is totally reflected", c);
              continue;
            }
          quad cosine = q_sqrt(k) / n;
          worst = battery_max(worst, (double)(q_abs(-T.z / cosine - 1)
                                              / (4 * U)));
        }
    }
  PASS_PART(worst, "R04 ior 1 + 1e-9: cos_t to 4u (%.2f of it)", worst);
}

// R05: into a bubble, ior .75

static void
test_R05(void)
{
  double worst = 0;
  unsigned wrong = 0;

  for (unsigned i = 0; i < 1000; i++)
    {
      double s = i / 1000.0, c = q_sqrt(1 - (quad)s * s);
      int tir = is_reflected(towards(s, c), z, .75);
      wrong += tir != (s > .75);
      if (!tir && s < .75)
        {
          quad k = ((quad).75 - 1) * ((quad).75 + 1) + (quad)c * c;
          struct k_vec T = refracted(towards(s, c), z, .75, &unlike);
          quad cosine = q_sqrt(k) / .75;
          double bound = 4 * U / (double)cosine;
          worst = battery_max(worst, (double)q_abs(-T.z - cosine) / bound);
        }
    }
  PASS(wrong == 0, "R05 into ior .75 total reflection is from sine .75 on:"
       " %u of 1000 wrong", wrong);
  PASS_PART(worst, "R05 cos_t to 4u/cos_t (%.2f of it)", worst);
}

// R06: out of ior 1e3 and 1e6

static void
test_R06(void)
{
  for (double ior = 1e3; ior <= 1e6; ior *= 1e3)
    {
      double worst = 0;
      for (double s = 1e-9; s < 1 / ior; s *= 1.3)
        {
          double n = 1 / ior;
          struct k_vec T = refracted(towards(s, q_sqrt(1 - (quad)s * s)), z,
                                     n, &unlike);
          quad cosine = reference_cosine(s, n);
          worst = battery_max(worst, q_apart(T, q_vec(s / (quad)n, 0,
                                                      -cosine)));
        }
      PASS_NEAR(worst, 0, 1e-9, "R06 out of ior %g: direction off by %.2g,"
                " at most 1e-9", ior, worst);
    }
}

static void
test_R07(void)
{
  static const char *const bad[] = { "0", "-1.5", "nan", "inf", "-inf" };

  for (unsigned i = 0; i < sizeof bad / sizeof *bad; i++)
    {
      char text[500];
      snprintf(text, sizeof text, SUPPORT_CAMERA
               "material glass { alpha 1\n  ior %s }\n", bad[i]);
      NSString *report = support_faults(text);
      PASS(report && strstr([report UTF8String], ":3:7: error: "),
           "R07 ior %s: an error at line 3, column 7", bad[i]);
    }
}

// R08: straight on

static void
test_R08(void)
{
  double worst = 0;

  for (unsigned i = 0; i < 100; i++)
    {
      struct support_random random = support_seed(i);
      struct k_vec N = i ? support_direction(&random) : z;
      struct k_vec D = k_neg(N);
      struct k_vec T = refracted(D, N, 1.5, &unlike);
      worst = battery_max(worst, k_norm_max(k_sub(T, D)));
    }
  PASS_NEAR(worst, 0, 2 * U, "R08 at cos 1 the ray goes straight on to %.2g u,"
            " at most 2", worst / U);
  struct k_vec D = k_neg(z);
  PASS_ULPS(shade_schlick(D, z, D, 1, 1.5), .04, 1, "R08 R into 1.5");
  PASS_ULPS(shade_schlick(D, z, D, 1.5, 1), .04, 1, "R08 R out of 1.5");
}

// R09: grazing

static void
test_R09(void)
{
  for (double c = 1e-8; c > 1e-17; c /= 1e8)
    {
      PASS_PART(cosine_error(1.5, q_sqrt(1 - (quad)c * c), c, 1),
                "R09 cos %g into 1.5: cos_t to 4u (%.2f of it)", c,
                cosine_error(1.5, q_sqrt(1 - (quad)c * c), c, 1));
      struct k_vec D = towards(q_sqrt(1 - (quad)c * c), c);
      struct k_vec T = refracted(D, z, 1.5, &unlike);
      // R0 + (1 - R0)(1 - c)^5 = 1 - 4.8 c
      PASS_NEAR(shade_schlick(D, z, T, 1, 1.5), 1 - 4.8 * c, 4 * U + 10 * c * c,
                "R09 cos %g: R", c);
    }
}

// R10 to R12: how much is reflected

static double
reflected_at(double cosine, double n_i, double n_t)
{
  struct k_vec D = towards(q_sqrt(1 - (quad)cosine * cosine), cosine);
  struct k_vec T = shade_refract(D, z, n_t / n_i, NULL);

  return shade_schlick(D, z, T, n_i, n_t);
}

static void
test_R10(void)
{
  PASS_ULPS(reflected_at(1, 1, 1.5), .04, 2, "R10 Schlick at 0 degrees");
  PASS_ULPS(reflected_at(.5, 1, 1.5), .07, 2, "R10 Schlick at 60 degrees");
  PASS_ULPS(reflected_at(0, 1, 1.5), 1, 2, "R10 Schlick at 90 degrees");
}

/** Fresnel's equations, for light that is not polarised. */
static double
fresnel(double cosine, double n_i, double n_t)
{
  quad ci = cosine, a = n_i, b = n_t;
  quad ct = q_sqrt(1 - a * a / (b * b) * (1 - ci * ci));
  quad s = (a * ci - b * ct) / (a * ci + b * ct);
  quad p = (b * ci - a * ct) / (b * ci + a * ct);

  return (s * s + p * p) / 2;
}

static void
test_R11(void)
{
  // The program has Schlick's approximation only (spec 4): what is tested is
  // how far that is from the exact value.
  PASS_ULPS(fresnel(.5, 1, 1.5), .089186712802212783, 2,
            "R11 the exact reflectance at 60 degrees, by the reference");
  PASS_NEAR(reflected_at(.5, 1, 1.5) - fresnel(.5, 1, 1.5),
            .07 - .089186712802212783, 4 * U,
            "R11 Schlick at 60 degrees is 0.019 below it");
  double worst = 0;
  for (unsigned i = 0; i <= 9000; i++)
    {
      double cosine = cos(i * M_PI / 18000);
      worst = battery_max(worst, fabs(reflected_at(cosine, 1, 1.5)
                                      - fresnel(cosine, 1, 1.5)));
    }
  PASS_NEAR(worst, .036, 1e-3, "R11 Schlick's largest error at ior 1.5");
}

static void
test_R12(void)
{
  const double critical = .7453559924999299;

  for (int j = 52; j >= 24; j -= 4)
    {
      double R = reflected_at(critical * (1 + ldexp(1, -j)), 1.5, 1);
      PASS(R <= 1 && (j < 28 || 1 - R < 1e-3),
           "R12 out of 1.5, 2^-%d before the critical angle: R = 1 - %.2g",
           j, 1 - R);
    }
  PASS_ULPS(reflected_at(1, 1.5, 1), .04, 2, "R12 and at 0 degrees");
}

int
main(void)
{
  NSAutoreleasePool *pool = [[NSAutoreleasePool alloc] init];

  test_R01();
  test_R02();
  test_R03();
  test_R04();
  test_R05();
  test_R06();
  test_R07();
  test_R08();
  test_R09();
  test_R10();
  test_R11();
  test_R12();
  PASS(unlike == 0, "R01-R09 mirrored in x: the same bits, by vec_t and by"
       " shade.h (%u not)", unlike);
  [pool release];
  return test_done();
}
