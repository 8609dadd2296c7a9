// reflect_refract.m - [dir reflect: N] and [dir refract: N : ior]. Notes,
// "vector reflect/refract functions", "transmission".

#import "support.h"
#include "test.h"

/** A direction d and a unit normal N with d.N < 0. */
static void
meeting(uint64_t i, struct k_vec *d, struct k_vec *N)
{
  struct support_random random = support_seed(i);

  *N = support_direction(&random);
  do
    {
      *d = support_direction(&random);
    }
  while (k_dot(*d, *N) == 0);
  if (k_dot(*d, *N) > 0)
    {
      *d = k_neg(*d);
    }
}

static struct k_vec
refract(struct k_vec d, struct k_vec N, double n)
{
  return [[vec_t vec: d] refract: [vec_t vec: N] : n]->v;
}

static struct k_vec
reflect(struct k_vec d, struct k_vec N)
{
  return [[vec_t vec: d] reflect: [vec_t vec: N]]->v;
}

static void
reflection(void)
{
  unsigned off = 0, sides = 0, back = 0;

  PASS(support_same(reflect(k_vec(0.6, -0.8, 0), k_vec(0, 1, 0)),
                    k_vec(0.6, 0.8, 0)), "a ball bounces off the floor");
  PASS(support_same(reflect(k_vec(0, 0, -1), k_vec(0, 0, 1)),
                    k_vec(0, 0, 1)), "straight on comes straight back");
  PASS(support_same(reflect(k_vec(1, 0, 0), k_vec(0, 1, 0)),
                    k_vec(1, 0, 0)), "along the surface stays so");
  for (unsigned i = 0; i < 20000; i++)
    {
      struct k_vec d, N;
      meeting(i, &d, &N);
      struct k_vec r = reflect(d, N);
      struct q_vec D = q_of(d), Q = q_of(N);
      struct q_vec want = q_sub(D, q_scale(Q, 2 * q_dot(D, Q)));
      off += q_apart(r, want) > 8 * K_U;
      sides += !support_same(r, reflect(d, k_neg(N)));
      back += q_apart(reflect(r, N), D) > 20 * K_U;
    }
  PASS(off == 0, "D - 2 (D.N) N to 8 u: %u", off);
  PASS(sides == 0, "either side of the normal will do, bit for bit: %u",
       sides);
  PASS(back == 0, "reflected twice is the same direction: %u", back);
}

/** Snell's law, checked by the sines and the plane of incidence, and the
    value itself against 113 bits. Near the critical angle cos_t is the root
    of a small difference: its error is that of k over 2 cos_t. */
static void
refraction(void)
{
  unsigned snell = 0, plane = 0, side = 0, off = 0, unit = 0;

  for (unsigned i = 0; i < 40000; i++)
    {
      struct k_vec d, N;
      struct support_random random = support_seed(i + 1000000);
      double n = exp2(support_between(&random, -2, 2));
      struct q_vec T;
      meeting(i, &d, &N);
      if (!q_refract(q_of(d), q_of(N), n, &T))
        {
          continue;
        }
      struct k_vec t = refract(d, N, n);
      double cos_t = -q_dot(T, q_of(N));
      double most = n > 1 ? n : 1 / n;
      double bound = 8 * K_U * most * (1 + most / cos_t);
      struct k_vec sin_t = k_cross(t, N), sin_i = k_cross(d, N);
      snell += fabs(k_length(sin_t) * n - k_length(sin_i)) > n * bound;
      plane += fabs(k_dot(t, sin_i)) > bound;
      side += !(k_dot(t, N) <= 0);
      off += q_apart(t, T) > bound;
      unit += fabs(k_length(t) - 1) > bound;
    }
  PASS(snell == 0, "sin theta_t / sin theta_i = n_i / n_t: %u", snell);
  PASS(plane == 0, "it stays in the plane of d and N: %u", plane);
  PASS(side == 0, "it goes to the other side: %u", side);
  PASS(unit == 0, "it is unit: %u", unit);
  PASS(off == 0, "it is right to rounding over cos_t: %u", off);
}

/** Where n is almost 1 and the angle flat, cos_t is the root of two small
    numbers that must not be got by subtraction: it is right to a few u of
    itself. */
static void
almost_nothing(void)
{
  unsigned off = 0;

  for (unsigned i = 0; i < 20000; i++)
    {
      struct support_random random = support_seed(i);
      double n = 1 + exp2(support_between(&random, -40, -2));
      double c = exp2(support_between(&random, -25, 0));
      struct k_vec N = { 0, 0, 1 };
      struct k_vec d = { sqrt((1 - c) * (1 + c)), 0, -c };
      // The law with this c, not with the one that d's rounding makes.
      quad n2k = ((quad)n - 1) * ((quad)n + 1) + (quad)c * c;
      quad cos_t = q_sqrt(n2k) / n;
      off += q_abs(-refract(d, N, n).z - cos_t) > 4 * (quad)K_U * cos_t;
    }
  PASS(off == 0, "cos_t for n near 1 and flat rays, to 4 u: %u", off);
}

static void
special(void)
{
  struct k_vec N = { 0, 0, 1 };
  struct k_vec t = refract(k_vec(0.6, 0, -0.8), N, 1.5);

  PASS_ULPS(t.x, 0.4, 1, "sin 0.6 into glass 1.5 is 0.4");
  PASS_ULPS(t.z, -0.91651513899116801, 1, "and the cosine sqrt(0.84)");
  PASS(t.y == 0, "and nothing sideways");
  PASS(support_same(refract(k_vec(0, 0, -1), N, 1.83), k_vec(0, 0, -1)),
       "straight on goes straight on");
  unsigned bent = 0;
  for (unsigned i = 0; i < 10000; i++)
    {
      struct k_vec d;
      meeting(i, &d, &N);
      bent += !support_same(refract(d, N, 1), d);
    }
  PASS(bent == 0, "n = 1 changes no bit of the direction: %u", bent);
}

/** The notes' two calls, one after the other at the two sides of a slab:
    going out with 1/ior undoes going in. The direction inside is rounded to
    u in each component; going out multiplies that by ior and divides by
    cos_i. */
static void
round_trip(void)
{
  unsigned off = 0, reflected = 0;

  for (unsigned i = 0; i < 40000; i++)
    {
      struct k_vec d, N;
      struct support_random random = support_seed(i + 2000000);
      double ior = support_between(&random, 1, 3);
      meeting(i, &d, &N);
      vec_t *dir = [vec_t vec: d], *normal = [vec_t vec: N];
      vec_t *in = [dir refract: normal : ior];
      // In at the front, out at the back, whose outward normal is -N.
      vec_t *back = [normal scale: -1.0];
      vec_t *out = [in refract: [back scale: -1.0] : 1.0 / ior];
      double cos_i = fabs(k_dot(d, N));
      if (cos_i > 1e-6)
        {
          off += q_apart(out->v, q_of(d)) > 20 * K_U * ior * ior / cos_i;
          reflected += k_dot(out->v, N) >= 0;
        }
    }
  PASS(reflected == 0, "what came in through a face can leave through a"
       " parallel one: %u", reflected);
  PASS(off == 0, "[dir refract: -N : 1/ior] undoes [dir refract: N : ior]: %u",
       off);
}

static void
total_internal_reflection(void)
{
  unsigned wrong = 0, fallback = 0, both = 0;

  for (unsigned i = 0; i < 40000; i++)
    {
      struct k_vec d, N;
      struct support_random random = support_seed(i + 3000000);
      double n = support_between(&random, 0.3, 1);
      meeting(i, &d, &N);
      quad c = q_dot(q_unit(q_of(d)), q_unit(q_of(N)));
      quad k = 1 - (1 - c * c) / ((quad)n * n);
      int tir;
      struct k_vec t = shade_refract(d, N, n, &tir);
      if (q_abs(k) > 16 * (quad)K_U / (n * n))
        {
          wrong += tir != (k < 0);
          both |= k < 0 ? 1 : 2;
        }
      if (tir)
        {
          fallback += !support_same(t, reflect(d, N))
            || !support_same(refract(d, N, n), reflect(d, N));
        }
    }
  PASS(both == 3, "the sample has both cases");
  PASS(wrong == 0, "total internal reflection when k < 0: %u", wrong);
  PASS(fallback == 0, "refract: falls back to reflect: bit for bit: %u",
       fallback);
  PASS(support_same(refract(k_vec(0.8, 0, -0.6), k_vec(0, 0, 1), 1 / 1.5),
                    reflect(k_vec(0.8, 0, -0.6), k_vec(0, 0, 1))),
       "sin 0.8 out of glass 1.5 is reflected");
  PASS(refract(k_vec(0.6, 0, -0.8), k_vec(0, 0, 1), 1 / 1.5).z < 0,
       "sin 0.6 is not");
}

/** A direction that drifts is put right: the length after one step is
    1 - (3/2) e^2 for a drift of e. */
static void
renewal(void)
{
  unsigned off = 0, touched = 0;

  for (unsigned i = 0; i < 1000; i++)
    {
      struct support_random random = support_seed(i);
      struct k_vec d = support_direction(&random);
      double e = exp2(support_between(&random, -50, -20));
      struct k_vec renewed = shade_renew(k_scale(d, 1 + e));
      off += fabs(k_length(renewed) - 1) > 1.5 * e * e + 4 * K_U;
      d = shade_renew(shade_renew(d));
      touched += !support_same(shade_renew(d), d)
        && fabs(k_dot(d, d) - 1) <= 2 * K_U;
    }
  PASS(off == 0, "a drift of e becomes 3/2 e^2: %u", off);
  PASS(touched == 0, "a direction that is unit is left alone: %u", touched);
  struct k_vec d = k_unit(k_vec(1, 2, 3)), N = k_unit(k_vec(-1, 5, 2));
  double worst = 0;
  for (int i = 0; i < 10000; i++)
    {
      d = shade_renew(shade_reflect(d, N));
      N = k_unit(k_vec(N.y, -N.z, N.x + 0.1));
      worst = fmax(worst, q_abs(q_dot(q_of(d), q_of(d)) - 1));
    }
  PASS(worst <= 8 * K_U, "10000 mirrors leave the length 1: off by %g",
       worst);
}

int
main(void)
{
  NSAutoreleasePool *pool = [[NSAutoreleasePool alloc] init];

  reflection();
  refraction();
  almost_nothing();
  special();
  round_trip();
  total_internal_reflection();
  renewal();
  [pool release];
  return test_done();
}
