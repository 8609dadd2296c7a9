// costs.c - what the robust forms cost and what they gain, as the table of
// docs/stability.md. usage: costs
//
// Nanoseconds are the best of 15 rounds of a million, and depend on the machine.
// What is gained is an error against 113 bits, or a count, and does not.

#include "kernel/k_polygon_hit.h"
#include "exact.h"
#include "shade.h"
#include <stdio.h>
#include <time.h>

#define ROUNDS 15
#define TRIES 1000000

static double
seconds(void)
{
  struct timespec now;

  clock_gettime(CLOCK_MONOTONIC, &now);
  return now.tv_sec + 1e-9 * now.tv_nsec;
}

static volatile double sink;

/** A row: x takes 1024 values in [.25, .75). */
#define ROW(name, expression, ...) \
  do \
    { \
      double best = 1; \
      for (int round = 0; round < ROUNDS; round++) \
        { \
          double sum = 0, start = seconds(); \
          for (int i = 0; i < TRIES; i++) \
            { \
              double x = (i & 1023) * 0x1p-11 + 0.25; \
              sum += (expression); \
            } \
          sink = sum; \
          best = fmin(best, seconds() - start); \
        } \
      printf("| %s | %.1f ns | ", name, best / TRIES * 1e9); \
      printf(__VA_ARGS__); \
      printf(" |\n"); \
    } \
  while (0)

// Spheres

/** Ours without its compensated branch. */
static int
plain_hit(struct k_vec o, struct k_vec d, struct k_vec center, double r,
          double *t)
{
  struct k_vec f = k_sub(o, center);
  double b = -k_dot(f, d);
  struct k_vec p = k_along(f, b, d);
  double discriminant = r * r - k_dot(p, p);

  *t = b - sqrt(discriminant);
  return discriminant >= 0;
}

static int
our_hit(struct k_vec o, struct k_vec d, struct k_vec center, double r,
        double *t)
{
  struct k_vec p;
  double t1, s;

  return k_sphere_hit(o, d, center, r, t, &t1, &p, &s);
}

typedef int hit(struct k_vec, struct k_vec, struct k_vec, double, double *);

/** The worst of the distances of rays from so many radii away, in radii. */
static double
far_error(hit *hits)
{
  struct support_random random = support_seed(1);
  double worst = 0;

  for (int i = 0; i < 2000; i++)
    {
      struct k_vec d, center, o = k_vec(0, 0, 0);
      double t = 0;
      aim(&random, 1e6, &d, &center);
      double off = hits(o, d, center, 1, &t)
        ? (double)size(t - exact_hit(o, d, center, 1)) : 1;
      worst = fmax(worst, fmin(off, 1));
    }
  return worst;
}

/** The same from 1e-9 of a radius above it, straight down to 60 degrees; as a
    part of the distance. */
static double
near_error(hit *hits)
{
  struct k_vec o = k_vec(0, 1 + 1e-9, 0), center = k_vec(0, 0, 0);
  double worst = 0;

  for (int i = 0; i < 2000; i++)
    {
      double c = 0.5 + i / 4000., t = 0;
      struct k_vec d = k_vec(0, -c, sqrt(1 - c * c));
      __float128 want = exact_hit(o, d, center, 1);
      double off = hits(o, d, center, 1, &t)
        ? (double)(size(t - want) / want) : 1;
      worst = fmax(worst, fmin(off, 1));
    }
  return worst;
}

// The ray that is timed: from that height above a unit sphere.
#define TIMED(height) \
  k_vec(0, 1 + (height), 0), \
  k_vec(0.6 * (height) / (1 + (height)), -0.8, 0.6), k_vec(0, 0, 0), 1

static double
notes_timed(double height)
{
  double t = 0;

  notes_hit(TIMED(height), &t);
  return t;
}

static double
plain_timed(double height)
{
  double t = 0;

  plain_hit(TIMED(height), &t);
  return t;
}

static double
our_timed(double height)
{
  struct k_vec p;
  double t = 0, t1, s;

  k_sphere_hit(TIMED(height), &t, &t1, &p, &s);
  return t;
}

static void
spheres(void)
{
  ROW("sphere, the notes' formula", notes_timed(x),
      "from 10^6 radii off by %.2g radii; from 10^-9 above it by %.2g of the"
      " way", far_error(notes_hit), near_error(notes_hit));
  ROW("sphere, ours, far from the surface", our_timed(x),
      "from 10^6 radii off by %.2g radii", far_error(our_hit));
  ROW("sphere, the same near it", plain_timed(x * 1e-4),
      "from 10^-9 above it off by %.2g of the way", near_error(plain_hit));
  ROW("sphere, ours, near it (compensated)", our_timed(x * 1e-4),
      "from 10^-9 above it off by %.2g of the way", near_error(our_hit));
}

// Polygons: two of four corners that share an edge

enum test
{
  EDGES,
  ANGLES,
  CROSSINGS
};

static const double left[3][4] = { { -1, .1, .3, -1.2 },
                                   { -1, -1.3, 1.1, 1 },
                                   { -2, -2, -2, -2 } };
static const double right[3][4] = { { .1, 1.4, 1.2, .3 },
                                    { -1.3, -1, 1.2, 1.1 },
                                    { -2, -2, -2, -2 } };

static inline int
holds(enum test test, const double corners[3][4], struct k_vec o,
      struct k_vec d)
{
  const double *const v[3] = { corners[0], corners[1], corners[2] };
  struct k_plane plane = { k_vec(0, 0, 1), k_vec(v[0][0], v[1][0], v[2][0]) };
  double t;

  if (!k_plane_hit(&plane, o, d, &t))
    {
      return 0;
    }
  if (test == CROSSINGS)
    {
      struct k_shear shear = k_shear(d);
      return k_polygon_crossings(o, &shear, 4, v);
    }
  struct k_vec P = k_along(o, t, d);
  return test == EDGES ? k_polygon_edges(P, plane.n, 4, v)
    : k_polygon_angles(P, plane.n, 4, v);
}

/** Of a million rays to the edge that both share, those that meet neither
    polygon, or both. */
static unsigned
leaks(enum test test)
{
  struct support_random random = support_seed(1);
  unsigned wrong = 0;

  for (int i = 0; i < TRIES; i++)
    {
      double along = support_unit(&random);
      struct k_vec o = support_point(&random, 1);
      struct k_vec P = k_vec(.1 + .2 * along, -1.3 + 2.4 * along, -2);
      struct k_vec d = k_unit(k_sub(P, o));
      wrong += holds(test, left, o, d) + holds(test, right, o, d) != 1;
    }
  return wrong;
}

static inline int
ask(enum test test, double x)
{
  return holds(test, left, k_vec(.1, .2, .3), k_vec(x - 0.5, 0.6, -0.8));
}

static void
polygons(void)
{
  const char *lost = "%u of 10^6 rays to a shared edge meet both or neither";

  ROW("polygon of four, edges", ask(EDGES, x), lost, leaks(EDGES));
  ROW("polygon of four, angles", ask(ANGLES, x), lost, leaks(ANGLES));
  ROW("polygon of four, crossings (ours)", ask(CROSSINGS, x), lost,
      leaks(CROSSINGS));
}

// Clear surfaces

static struct k_vec
slope(double c)
{
  return k_vec(sqrt(1 - c * c), 0, -c);
}

static double
notes_cosine(double c, double n)
{
  return sqrt(1 - (1 - c * c) / (n * n));
}

static double
our_cosine(double c, double n)
{
  return -shade_refract(slope(c), k_vec(0, 0, 1), n, NULL).z;
}

/** The worst cosine at an index of 1 + 10^-6, to 10^-6 from the surface. */
static double
bend_error(double (*cosine)(double, double))
{
  double n = 1 + 1e-6, worst = 0;

  for (double c = 1e-6; c < 1; c *= 1.01)
    {
      __float128 k = 1 - (1 - (__float128)c * c) / ((__float128)n * n);
      worst = fmax(worst, (double)size(cosine(c, n) - root(k)));
    }
  return worst;
}

static double
reflected(double c, int is_exact)
{
  struct k_vec N = k_vec(0, 0, 1), D = slope(c);
  struct k_vec T = shade_refract(D, N, 1.5, NULL);

  return is_exact ? shade_fresnel(D, N, T, 1, 1.5)
    : shade_schlick(D, N, T, 1, 1.5);
}

/** The farthest from Fresnel's equations in 113 bits, into glass. */
static double
reflection_error(int is_exact)
{
  double worst = 0;

  for (double c = 0.0005; c < 1; c += 0.0005)
    {
      __float128 n = 1.5, t = root(1 - (1 - (__float128)c * c) / (n * n));
      __float128 s = (c - n * t) / (c + n * t), p = (t - n * c) / (t + n * c);
      double off = (double)size(reflected(c, is_exact) - (s * s + p * p) / 2);
      worst = fmax(worst, off);
    }
  return worst;
}

static void
clear(void)
{
  ROW("refraction, the notes' cosine", notes_cosine(x, 1.5),
      "index 1.000001: off by %.2g", bend_error(notes_cosine));
  ROW("refraction, ours, the whole vector", our_cosine(x, 1.5),
      "index 1.000001: off by %.2g", bend_error(our_cosine));
  ROW("Schlick, by products", reflected(x, 0),
      "off by %.2g of Fresnel's equations, glass", reflection_error(0));
  ROW("`--fresnel exact`, with the cosine that it needs", reflected(x, 1),
      "off by %.2g", reflection_error(1));
}

int
main(void)
{
  printf("| what | time | what is gained |\n|---|---|---|\n");
  spheres();
  polygons();
  clear();
  return 0;
}
