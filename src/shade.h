// shade.h - what light does at a hit point: the formulas of the notes, once,
// as inline C on values. ray_t calls them one after the other, and so does
// kernel/k_trace.inc.c: both engines get the same bits. All products of colours
// are channel by channel; nothing is clamped.

#ifndef SHADE_H
#define SHADE_H

#include <float.h>
#include "kernel/k_vec.h"
#include "power.h"

/** What of the formulas is wanted. All 0: everything, as the notes have it. */
struct shade_choice
{
  int exact_fresnel;    // shade_fresnel in place of shade_schlick
  int no_shadows;       // no feelers: light goes through everything
  int no_reflection;    // what reflected rays bring back is black
  int no_refraction;    // and what refracted ones do
};

/** Notes, "ray objectification": the mirrored direction D - 2 (D.N) N.
    D runs towards the surface, N is unit; either side of N will do. */
static inline struct k_vec
shade_reflect(struct k_vec D, struct k_vec N)
{
  double two_c = 2 * k_dot(D, N);

  return k_vec(D.x - two_c * N.x, D.y - two_c * N.y, D.z - two_c * N.z);
}

/** Notes, "transmission": Snell's law. D and N are unit and D.N < 0;
    n = n_t / n_i, so going in is `refract(D, N, ior)` and going out
    `refract(D, -N, 1/ior)`. At total internal reflection the result is
    reflect(D, N) and *tir is 1, otherwise 0 (tir may be NULL).

    With c = -D.N the law is  T = (D + c N)/n - sqrt(k) N,
    k = 1 - (1 - c^2)/n^2. Written so, k cancels; n^2 k is computed instead,
    as (n-1)(n+1) + c^2 or, for a strong step down, as (n-s)(n+s) with
    s = |D + c N| the sine: exact where the other is not. With n = 1 the
    ray goes on bit for bit as it came.

    *is_critical: |k| < 4 u, so that the last bits decide whether it is
    refracted at all; not for n = 1. */
static inline struct k_vec
shade_refract_near(struct k_vec D, struct k_vec N, double n, int *tir,
                   int *is_critical)
{
  double c = -k_dot(D, N);
  struct k_vec along = k_along(D, c, N);        // the part along the surface
  double n2k;

  *is_critical = 0;
  if (tir)
    {
      *tir = 0;
    }
  if (n == 1)
    {
      return D;
    }
  if (n * n > 0.5)
    {
      n2k = (n - 1) * (n + 1) + c * c;
    }
  else
    {
      double s = k_length(along);
      n2k = (n - s) * (n + s);
    }
  *is_critical = fabs(n2k) < 4 * K_U * (n * n);
  if (n2k < 0)
    {
      if (tir)
        {
          *tir = 1;
        }
      return shade_reflect(D, N);
    }
  // A step too large to square leaves along N.
  double nk = n < 0x1p500 ? sqrt(n2k) : n;
  return k_div(k_along(along, -nk, N), n);
}

/** The same for those who do not ask how near it was. */
static inline struct k_vec
shade_refract(struct k_vec D, struct k_vec N, double n, int *tir)
{
  int is_critical;

  return shade_refract_near(D, N, n, tir, &is_critical);
}

/** Takes the rounding out of a direction that was unit and has been
    reflected or refracted: one Newton step towards length 1, and only when
    it has drifted by more than two roundings. */
static inline struct k_vec
shade_renew(struct k_vec D)
{
  double d2 = k_dot(D, D);

  if (fabs(d2 - 1) > 2 * K_U)
    {
      return k_scale(D, 0.5 * (3 - d2));
    }
  return D;
}

/** Notes, "Schlick's approximation": how much of the light is reflected
    between media n_i and n_t, 0 to 1. T is the refracted direction. The
    angle is taken on the side with the smaller index, where it can be 90
    degrees; equal indices are no surface at all and reflect nothing. */
static inline double
shade_schlick(struct k_vec D, struct k_vec N, struct k_vec T,
              double n_i, double n_t)
{
  if (n_i == n_t)
    {
      return 0;
    }
  double r = (n_t - n_i) / (n_t + n_i);
  double R0 = r * r;
  double cosine = n_i < n_t ? -k_dot(D, N) : -k_dot(T, N);
  double m = 1 - cosine;
  double m2 = m * m;

  return R0 + (1 - R0) * (m2 * m2 * m);
}

/** What Schlick's formula stands for: Fresnel's equations for light that is not
    polarised, the mean of how much of it is reflected that swings across the
    plane of incidence and in it (Born and Wolf, "Principles of Optics",
    1.5.2). */
static inline double
shade_fresnel(struct k_vec D, struct k_vec N, struct k_vec T,
              double n_i, double n_t)
{
  double c_i = -k_dot(D, N), c_t = -k_dot(T, N);

  if (n_i == n_t)
    {
      return 0;
    }
  double across = (n_i * c_i - n_t * c_t) / (n_i * c_i + n_t * c_t);
  double in = (n_t * c_i - n_i * c_t) / (n_t * c_i + n_i * c_t);
  return 0.5 * (across * across + in * in);
}

/** a / b for a colour a and a length b >= 0. A quotient past the largest
    double stays there, and 0 / 0 is 0: no infinity, no NaN. */
static inline struct k_vec
shade_over(struct k_vec a, double b)
{
  if (b < 0x1p-600)
    {
      return k_vec(a.x == 0 ? 0 : fmin(a.x / b, DBL_MAX),
                   a.y == 0 ? 0 : fmin(a.y / b, DBL_MAX),
                   a.z == 0 ? 0 : fmin(a.z / b, DBL_MAX));
    }
  return k_div(a, b);
}

/** Light of intensity e that has come the distance r: e / r^falloff. */
static inline struct k_vec
shade_falloff(struct k_vec e, double r, int falloff)
{
  return falloff == 0 ? e : shade_over(e, falloff == 1 ? r : r * r);
}

/** Ambient over the length of the whole path from the eye. */
static inline struct k_vec
shade_ambient(struct k_vec ambient, double dis)
{
  return shade_over(ambient, dis);
}

/** One light that reaches the point: color + diffuse e (Ns.L), where e has
    the falloff in it. */
static inline struct k_vec
shade_lit(struct k_vec color, struct k_vec diffuse, struct k_vec e,
          double n_dot_l)
{
  return k_add(color, k_scale(k_mul(diffuse, e), n_dot_l));
}

/** Notes, "shadow casting": one light that does not: color + 0.1 A. */
static inline struct k_vec
shade_shadow(struct k_vec color, struct k_vec A)
{
  return k_add(color, k_scale(A, 0.1));
}

/** A mirror: diffuse color + specular reflected. */
static inline struct k_vec
shade_mirror(struct k_vec color, struct k_vec diffuse, struct k_vec specular,
             struct k_vec reflected)
{
  return k_add(k_mul(diffuse, color), k_mul(specular, reflected));
}

/** Notes, "Schlick's approximation", last line:
    (1-alpha) color + alpha ((1-R) refracted + R reflected). */
static inline struct k_vec
shade_blend(struct k_vec color, double alpha, double R,
            struct k_vec refracted, struct k_vec reflected)
{
  struct k_vec through = k_add(k_scale(refracted, 1 - R),
                               k_scale(reflected, R));

  return k_add(k_scale(color, 1 - alpha), k_scale(through, alpha));
}

/** The highlight of one light that reaches the point:
    H = 2 (Ns.L) Ns - L, color + specular e max(0, H.V)^shininess. A cosine
    that rounding put above 1 is 1. */
static inline struct k_vec
shade_highlight(struct k_vec color, struct k_vec specular, struct k_vec e,
                struct k_vec Ns, struct k_vec L, struct k_vec V,
                double shininess)
{
  double two_c = 2 * k_dot(Ns, L);
  struct k_vec H = k_vec(two_c * Ns.x - L.x, two_c * Ns.y - L.y,
                         two_c * Ns.z - L.z);
  double h_dot_v = k_dot(H, V);

  h_dot_v = h_dot_v > 0 ? h_dot_v < 1 ? h_dot_v : 1 : 0;
  return k_add(color,
               k_scale(k_mul(specular, e), power(h_dot_v, shininess)));
}

#endif
