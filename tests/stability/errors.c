// errors.c - how far off formulas are, as tables for tests/stability/extremes.
// usage: errors sphere | refraction
//
// sphere: the distance of a hit by the notes' formula as printed, with its
// missing 2a, and by ours, against the ratio of distance and radius; in radii,
// the worst of 2000 rays. refraction: the cosine of the refracted ray near the
// critical angle, out of an index of 1.5. The reference has 113 bits.

#include "exact.h"
#include "shade.h"
#include <stdio.h>

static void
sphere(void)
{
  printf("distance / radius\tthe notes' formula\tours\n");
  for (double ratio = 2; ratio <= 1.1e15; ratio *= ratio < 10 ? 5 : 10)
    {
      struct support_random random = support_seed(1);
      double worst[2] = { 0, 0 };
      for (int i = 0; i < 2000; i++)
        {
          struct k_vec d, center, p, o = k_vec(0, 0, 0);
          double t[2], t1, s;
          aim(&random, ratio, &d, &center);
          __float128 exact = exact_hit(o, d, center, 1);
          int hit[2] = { notes_hit(o, d, center, 1, &t[0]),
                         k_sphere_hit(o, d, center, 1, &t[0 + 1], &t1, &p,
                                      &s) };
          for (int j = 0; j < 2; j++)
            {
              // Missed: off by the whole sphere.
              double off = hit[j] ? (double)size(t[j] - exact) : 1;
              worst[j] = fmax(worst[j], fmin(off, 1));
            }
        }
      printf("%g\t%.3g\t%.3g\n", ratio, worst[0], worst[1]);
    }
}

static double
notes_cosine(double c, double n)
{
  double k = 1 - (1 - c * c) / (n * n);

  return k < 0 ? 0 : sqrt(k);
}

static double
our_cosine(double c, double n)
{
  struct k_vec D = k_vec(sqrt(1 - c * c), 0, -c);
  int tir;
  struct k_vec T = shade_refract(D, k_vec(0, 0, 1), n, &tir);

  return tir ? 0 : -T.z;
}

static void
refraction(void)
{
  const double critical = 0.7453559924999299, n = 1 / 1.5;

  printf("1 - cosine / critical cosine\tthe notes' formula\tours\n");
  for (int j = 1; j <= 50; j++)
    {
      double worst[2] = { 0, 0 }, e = ldexp(1, -j);
      for (int i = 0; i < 200; i++)
        {
          double c = critical * (1 + e * (1 + i / 200.));
          c = fmin(c, 1);
          __float128 k = 1 - (1 - (__float128)c * c) / ((__float128)n * n);
          __float128 exact = k < 0 ? 0 : root(k);
          worst[0] = fmax(worst[0], (double)size(notes_cosine(c, n) - exact));
          worst[1] = fmax(worst[1], (double)size(our_cosine(c, n) - exact));
        }
      printf("%.6g\t%.3g\t%.3g\n", e, fmax(worst[0], 1e-18),
             fmax(worst[1], 1e-18));
    }
}

int
main(int argc, char **argv)
{
  const char *what = argc == 2 ? argv[1] : "";

  if (*what == 's')
    {
      sphere();
    }
  else if (*what == 'r')
    {
      refraction();
    }
  else
    {
      fprintf(stderr, "usage: errors sphere | refraction\n");
      return 2;
    }
  return 0;
}
