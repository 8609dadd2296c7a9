// errors.c - how far off formulas are, as tables for tests/stability/extremes.
// usage: errors sphere | refraction | cost
//
// sphere: the distance of a hit by the notes' formula as printed, with its
// missing 2a, and by ours, against the ratio of distance and radius; in radii,
// the worst of 2000 rays. refraction: the cosine of the refracted ray near the
// critical angle, out of an index of 1.5. The reference has 113 bits. cost:
// nanoseconds for each, which depend on the machine.

#include "kernel/k_sphere_hit.h"
#include "../random.h"
#include "shade.h"
#include <stdio.h>
#include <time.h>

/** The square root in 113 bits. */
static __float128
root(__float128 x)
{
  __float128 y = sqrt((double)x);

  for (int i = 0; i < 2 && y != 0; i++)
    {
      y = (y + x / y) / 2;
    }
  return y;
}

static __float128
size(__float128 x)
{
  return x < 0 ? -x : x;
}

/** Notes, "transmission": t0 of the sphere, by -b - sqrt(b^2 - 4ac) over 2a. */
static int
notes_hit(struct k_vec o, struct k_vec d, struct k_vec center, double r,
          double *t)
{
  struct k_vec f = k_sub(o, center);
  double a = k_dot(d, d), b = 2 * k_dot(f, d), c = k_dot(f, f) - r * r;
  double discriminant = b * b - 4 * a * c;

  *t = (-b - sqrt(discriminant)) / (2 * a);
  return discriminant >= 0;
}

static __float128
exact_hit(struct k_vec o, struct k_vec d, struct k_vec c, double r)
{
  __float128 x = (__float128)o.x - c.x, y = (__float128)o.y - c.y;
  __float128 z = (__float128)o.z - c.z;
  __float128 a = (__float128)d.x * d.x + (__float128)d.y * d.y
    + (__float128)d.z * d.z;
  __float128 b = x * d.x + y * d.y + z * d.z;
  __float128 px = x - b / a * d.x, py = y - b / a * d.y, pz = z - b / a * d.z;
  __float128 h = (__float128)r * r - (px * px + py * py + pz * pz);

  return (-b - root(a * h)) / a;
}

/** A ray from the origin that passes a unit sphere's center at 0 to 0.9. */
static void
aim(struct support_random *random, double ratio, struct k_vec *d,
    struct k_vec *center)
{
  double pass = 0.9 * support_unit(random);
  struct k_vec side;

  *d = support_direction(random);
  side = k_unit(k_cross(*d, fabs(d->x) < 0.6 ? k_vec(1, 0, 0)
                        : k_vec(0, 1, 0)));
  *center = k_add(k_scale(*d, ratio), k_scale(side, pass));
}

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

/** Fresnel's equations, unpolarised. */
static double
fresnel(double c, double n)
{
  double t = sqrt(1 - (1 - c * c) / (n * n));
  double s = (c - n * t) / (c + n * t), p = (t - n * c) / (t + n * c);

  return (s * s + p * p) / 2;
}

static double
seconds(void)
{
  struct timespec now;

  clock_gettime(CLOCK_MONOTONIC, &now);
  return now.tv_sec + 1e-9 * now.tv_nsec;
}

static volatile double sink;

#define TIME(name, expression) \
  do \
    { \
      double best = 1; \
      for (int round = 0; round < 15; round++) \
        { \
          double sum = 0, start = seconds(); \
          for (int i = 0; i < 1000000; i++) \
            { \
              double x = (i & 1023) * 0x1p-11 + 0.25; \
              sum += (expression); \
            } \
          sink = sum; \
          best = fmin(best, seconds() - start); \
        } \
      printf("%s\t%.1f ns\n", name, best * 1e3); \
    } \
  while (0)

static double
near_root(double height, int is_ours)
{
  struct k_vec o = k_vec(0, 1 + height, 0), c = k_vec(0, 0, 0), p;
  struct k_vec d = k_vec(0.6 * height / (1 + height), -0.8, 0.6);
  double t = 0, t1, s;

  return (is_ours ? k_sphere_hit(o, d, c, 1, &t, &t1, &p, &s)
          : notes_hit(o, d, c, 1, &t)) ? t : 0;
}

static void
cost(void)
{
  TIME("sphere, the notes' formula", near_root(x, 0));
  TIME("sphere, ours, far from the surface", near_root(x, 1));
  TIME("sphere, ours, near it (compensated)", near_root(x * 1e-4, 1));
  TIME("refraction, the notes' cosine", notes_cosine(x, 1.5));
  TIME("refraction, ours, the whole vector", our_cosine(x, 1.5));
  TIME("Schlick, by products", shade_schlick(k_vec(0, 0, -x), k_vec(0, 0, 1),
                                             k_vec(0, 0, -x), 1, 1.5));
  TIME("Fresnel", fresnel(x, 1.5));
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
  else if (*what == 'c')
    {
      cost();
    }
  else
    {
      fprintf(stderr, "usage: errors sphere | refraction | cost\n");
      return 2;
    }
  return 0;
}
