// k_simd.h - several numbers at once, in the few operations that are needed:
// four floats for building the tree, four doubles for polygons, eight floats
// for the search. On AVX2 one register, on other x86-64 up to two, elsewhere an
// array.
// f8_max(a, acc) and f8_min(a, acc) give acc when a is not a number.

#ifndef K_SIMD_H
#define K_SIMD_H

// Four floats, for building the tree.

#include <math.h>
#include <stdint.h>

#if defined(__SSE2__)

#include <emmintrin.h>

typedef __m128 f4;

static inline f4 f4_load(const float *p) { return _mm_loadu_ps(p); }
static inline void f4_store(float *p, f4 a) { _mm_storeu_ps(p, a); }
static inline f4 f4_all(float x) { return _mm_set1_ps(x); }
static inline f4 f4_add(f4 a, f4 b) { return _mm_add_ps(a, b); }
static inline f4 f4_sub(f4 a, f4 b) { return _mm_sub_ps(a, b); }
static inline f4 f4_mul(f4 a, f4 b) { return _mm_mul_ps(a, b); }
static inline f4 f4_min(f4 a, f4 b) { return _mm_min_ps(a, b); }
static inline f4 f4_max(f4 a, f4 b) { return _mm_max_ps(a, b); }
static inline f4 f4_div(f4 a, f4 b) { return _mm_div_ps(a, b); }

/** Bit i: a[i] < b[i]. */
static inline unsigned
f4_less(f4 a, f4 b)
{
  return _mm_movemask_ps(_mm_cmplt_ps(a, b));
}

/** x y z 0. */
static inline f4
f4_xyz(f4 a)
{
  return _mm_and_ps(a, _mm_castsi128_ps(_mm_setr_epi32(-1, -1, -1, 0)));
}

/** y z x w. */
static inline f4
f4_turn(f4 a)
{
  return _mm_shuffle_ps(a, a, _MM_SHUFFLE(3, 0, 2, 1));
}

static inline float f4_first(f4 a) { return _mm_cvtss_f32(a); }

/** The greatest of the first three. */
static inline float
f4_most_xyz(f4 a)
{
  f4 m = _mm_max_ps(a, _mm_movehl_ps(a, a));

  return _mm_cvtss_f32(_mm_max_ss(m, _mm_shuffle_ps(a, a, 1)));
}

/** Each towards zero. */
static inline void
f4_to_ints(int32_t *to, f4 a)
{
  _mm_storeu_si128((__m128i *)to, _mm_cvttps_epi32(a));
}

#else

typedef struct { float x[4]; } f4;

#define F4_EACH(e) \
  f4 r; for (int i = 0; i < 4; i++) { r.x[i] = (e); } return r

static inline f4 f4_load(const float *p) { F4_EACH(p[i]); }
static inline f4 f4_all(float x) { F4_EACH(x); }
static inline f4 f4_add(f4 a, f4 b) { F4_EACH(a.x[i] + b.x[i]); }
static inline f4 f4_sub(f4 a, f4 b) { F4_EACH(a.x[i] - b.x[i]); }
static inline f4 f4_mul(f4 a, f4 b) { F4_EACH(a.x[i] * b.x[i]); }
static inline f4 f4_div(f4 a, f4 b) { F4_EACH(a.x[i] / b.x[i]); }

static inline f4
f4_min(f4 a, f4 b)
{
  F4_EACH(a.x[i] < b.x[i] ? a.x[i] : b.x[i]);
}

static inline f4
f4_max(f4 a, f4 b)
{
  F4_EACH(a.x[i] > b.x[i] ? a.x[i] : b.x[i]);
}

static inline unsigned
f4_less(f4 a, f4 b)
{
  return (a.x[0] < b.x[0]) | (a.x[1] < b.x[1]) << 1
    | (a.x[2] < b.x[2]) << 2 | (a.x[3] < b.x[3]) << 3;
}

static inline f4 f4_xyz(f4 a) { F4_EACH(i < 3 ? a.x[i] : 0); }
static inline f4 f4_turn(f4 a) { F4_EACH(a.x[i < 3 ? (i + 1) % 3 : 3]); }
static inline float f4_first(f4 a) { return a.x[0]; }

static inline float
f4_most_xyz(f4 a)
{
  float m = a.x[0] > a.x[1] ? a.x[0] : a.x[1];

  return a.x[2] > m ? a.x[2] : m;
}

static inline void
f4_store(float *p, f4 a)
{
  for (int i = 0; i < 4; i++)
    {
      p[i] = a.x[i];
    }
}

static inline void
f4_to_ints(int32_t *to, f4 a)
{
  for (int i = 0; i < 4; i++)
    {
      to[i] = (int32_t)a.x[i];
    }
}

#endif

static inline f4
f4_abs(f4 a)
{
  return f4_max(f4_sub(f4_all(0), a), a);
}

// Four doubles, for the corners of a polygon, and for a shape that four rays
// ask: the same arithmetic as one, in each lane.

#if defined(__AVX2__)

#include <immintrin.h>

typedef __m256d d4;

static inline d4 d4_load(const double *p) { return _mm256_loadu_pd(p); }
static inline d4 d4_all(double x) { return _mm256_set1_pd(x); }
static inline void d4_store(double *p, d4 a) { _mm256_storeu_pd(p, a); }
static inline d4 d4_add(d4 a, d4 b) { return _mm256_add_pd(a, b); }
static inline d4 d4_sub(d4 a, d4 b) { return _mm256_sub_pd(a, b); }
static inline d4 d4_mul(d4 a, d4 b) { return _mm256_mul_pd(a, b); }
static inline d4 d4_div(d4 a, d4 b) { return _mm256_div_pd(a, b); }
static inline d4 d4_sqrt(d4 a) { return _mm256_sqrt_pd(a); }
static inline f4 d4_to_f4(d4 a) { return _mm256_cvtpd_ps(a); }

/** Bit i: a[i] >= b[i]; a[i] > b[i]; 0 where one is not a number. */
static inline unsigned
d4_ge(d4 a, d4 b)
{
  return _mm256_movemask_pd(_mm256_cmp_pd(a, b, _CMP_GE_OQ));
}

static inline unsigned
d4_gt(d4 a, d4 b)
{
  return _mm256_movemask_pd(_mm256_cmp_pd(a, b, _CMP_GT_OQ));
}

#elif defined(__SSE2__)

typedef struct { __m128d l, h; } d4;

#define D4(l, h) ({ d4 r_ = { l, h }; r_; })

static inline d4
d4_load(const double *p)
{
  return D4(_mm_loadu_pd(p), _mm_loadu_pd(p + 2));
}

static inline d4
d4_all(double x)
{
  return D4(_mm_set1_pd(x), _mm_set1_pd(x));
}

static inline void
d4_store(double *p, d4 a)
{
  _mm_storeu_pd(p, a.l);
  _mm_storeu_pd(p + 2, a.h);
}

static inline d4
d4_add(d4 a, d4 b)
{
  return D4(_mm_add_pd(a.l, b.l), _mm_add_pd(a.h, b.h));
}

static inline d4
d4_sub(d4 a, d4 b)
{
  return D4(_mm_sub_pd(a.l, b.l), _mm_sub_pd(a.h, b.h));
}

static inline d4
d4_mul(d4 a, d4 b)
{
  return D4(_mm_mul_pd(a.l, b.l), _mm_mul_pd(a.h, b.h));
}

static inline d4
d4_div(d4 a, d4 b)
{
  return D4(_mm_div_pd(a.l, b.l), _mm_div_pd(a.h, b.h));
}

static inline d4
d4_sqrt(d4 a)
{
  return D4(_mm_sqrt_pd(a.l), _mm_sqrt_pd(a.h));
}

static inline f4
d4_to_f4(d4 a)
{
  return _mm_movelh_ps(_mm_cvtpd_ps(a.l), _mm_cvtpd_ps(a.h));
}

static inline unsigned
d4_ge(d4 a, d4 b)
{
  return _mm_movemask_pd(_mm_cmpge_pd(a.l, b.l))
    | _mm_movemask_pd(_mm_cmpge_pd(a.h, b.h)) << 2;
}

static inline unsigned
d4_gt(d4 a, d4 b)
{
  return _mm_movemask_pd(_mm_cmpgt_pd(a.l, b.l))
    | _mm_movemask_pd(_mm_cmpgt_pd(a.h, b.h)) << 2;
}

#else

typedef struct { double x[4]; } d4;

#define D4_EACH(e) \
  d4 r; for (int i = 0; i < 4; i++) { r.x[i] = (e); } return r
#define D4_MASK(e) \
  unsigned m = 0; for (int i = 0; i < 4; i++) { m |= (unsigned)(e) << i; } \
  return m

static inline d4 d4_load(const double *p) { D4_EACH(p[i]); }
static inline d4 d4_all(double x) { D4_EACH(x); }
static inline d4 d4_add(d4 a, d4 b) { D4_EACH(a.x[i] + b.x[i]); }
static inline d4 d4_sub(d4 a, d4 b) { D4_EACH(a.x[i] - b.x[i]); }
static inline d4 d4_mul(d4 a, d4 b) { D4_EACH(a.x[i] * b.x[i]); }
static inline d4 d4_div(d4 a, d4 b) { D4_EACH(a.x[i] / b.x[i]); }
static inline d4 d4_sqrt(d4 a) { D4_EACH(sqrt(a.x[i])); }
static inline f4 d4_to_f4(d4 a) { F4_EACH((float)a.x[i]); }

static inline void
d4_store(double *p, d4 a)
{
  for (int i = 0; i < 4; i++)
    {
      p[i] = a.x[i];
    }
}

static inline unsigned d4_ge(d4 a, d4 b) { D4_MASK(a.x[i] >= b.x[i]); }
static inline unsigned d4_gt(d4 a, d4 b) { D4_MASK(a.x[i] > b.x[i]); }

#endif

static inline d4
d4_neg(d4 a)
{
  return d4_mul(a, d4_all(-1));
}

static inline d4
d4_abs(d4 a)
{
#ifdef __AVX2__
  return _mm256_andnot_pd(d4_all(-0.0), a);
#elif defined(__SSE2__)
  return D4(_mm_andnot_pd(_mm_set1_pd(-0.0), a.l),
            _mm_andnot_pd(_mm_set1_pd(-0.0), a.h));
#else
  D4_EACH(fabs(a.x[i]));
#endif
}

/** Four vectors, each x y z and something, as four x, four y and four z. */
static inline void
d4_turn_four(const double *const v[4], double *x, double *y, double *z)
{
#ifdef __AVX2__
  d4 v0 = d4_load(v[0]), v1 = d4_load(v[1]);
  d4 v2 = d4_load(v[2]), v3 = d4_load(v[3]);
  d4 xz0 = _mm256_unpacklo_pd(v0, v1), xz1 = _mm256_unpacklo_pd(v2, v3);
  d4 yw0 = _mm256_unpackhi_pd(v0, v1), yw1 = _mm256_unpackhi_pd(v2, v3);

  d4_store(x, _mm256_permute2f128_pd(xz0, xz1, 0x20));
  d4_store(y, _mm256_permute2f128_pd(yw0, yw1, 0x20));
  d4_store(z, _mm256_permute2f128_pd(xz0, xz1, 0x31));
#else
  for (int i = 0; i < 4; i++)
    {
      x[i] = v[i][0];
      y[i] = v[i][1];
      z[i] = v[i][2];
    }
#endif
}

// Eight, for the search.

#if defined(__AVX2__) && defined(__FMA__)

typedef __m256 f8;

static inline f8 f8_load(const float *p) { return _mm256_loadu_ps(p); }
static inline void f8_store(float *p, f8 a) { _mm256_storeu_ps(p, a); }
static inline f8 f8_all(float x) { return _mm256_set1_ps(x); }
/** a b - c, rounded once or twice. */
static inline f8
f8_multiply_subtract(f8 a, f8 b, f8 c)
{
  return _mm256_fmsub_ps(a, b, c);
}

static inline f8 f8_add(f8 a, f8 b) { return _mm256_add_ps(a, b); }
static inline f8 f8_sub(f8 a, f8 b) { return _mm256_sub_ps(a, b); }
static inline f8 f8_mul(f8 a, f8 b) { return _mm256_mul_ps(a, b); }
static inline f8 f8_div(f8 a, f8 b) { return _mm256_div_ps(a, b); }
static inline f8 f8_max(f8 a, f8 acc) { return _mm256_max_ps(a, acc); }
static inline f8 f8_min(f8 a, f8 acc) { return _mm256_min_ps(a, acc); }

/** Bit i: a[i] <= b[i]. */
static inline unsigned
f8_le(f8 a, f8 b)
{
  return _mm256_movemask_ps(_mm256_cmp_ps(a, b, _CMP_LE_OQ));
}

#define F8_LOW(a) _mm256_castps256_ps128(a)
#define F8_HIGH(a) _mm256_extractf128_ps(a, 1)

#elif defined(__SSE2__)

typedef struct { __m128 l, h; } f8;

#define F8(l, h) ({ f8 r_ = { l, h }; r_; })

static inline f8
f8_load(const float *p)
{
  return F8(_mm_loadu_ps(p), _mm_loadu_ps(p + 4));
}

static inline void
f8_store(float *p, f8 a)
{
  _mm_storeu_ps(p, a.l);
  _mm_storeu_ps(p + 4, a.h);
}

static inline f8
f8_all(float x)
{
  return F8(_mm_set1_ps(x), _mm_set1_ps(x));
}

static inline f8
f8_add(f8 a, f8 b)
{
  return F8(_mm_add_ps(a.l, b.l), _mm_add_ps(a.h, b.h));
}

static inline f8
f8_sub(f8 a, f8 b)
{
  return F8(_mm_sub_ps(a.l, b.l), _mm_sub_ps(a.h, b.h));
}

static inline f8
f8_mul(f8 a, f8 b)
{
  return F8(_mm_mul_ps(a.l, b.l), _mm_mul_ps(a.h, b.h));
}

static inline f8
f8_div(f8 a, f8 b)
{
  return F8(_mm_div_ps(a.l, b.l), _mm_div_ps(a.h, b.h));
}

static inline f8
f8_multiply_subtract(f8 a, f8 b, f8 c)
{
  return F8(_mm_sub_ps(_mm_mul_ps(a.l, b.l), c.l),
            _mm_sub_ps(_mm_mul_ps(a.h, b.h), c.h));
}

static inline f8
f8_max(f8 a, f8 acc)
{
  return F8(_mm_max_ps(a.l, acc.l), _mm_max_ps(a.h, acc.h));
}

static inline f8
f8_min(f8 a, f8 acc)
{
  return F8(_mm_min_ps(a.l, acc.l), _mm_min_ps(a.h, acc.h));
}

static inline unsigned
f8_le(f8 a, f8 b)
{
  return _mm_movemask_ps(_mm_cmple_ps(a.l, b.l))
    | _mm_movemask_ps(_mm_cmple_ps(a.h, b.h)) << 4;
}

#define F8_LOW(a) (a).l
#define F8_HIGH(a) (a).h

#else

typedef struct { float x[8]; } f8;

#define F8_EACH(e) \
  f8 r; for (int i = 0; i < 8; i++) { r.x[i] = (e); } return r

static inline f8 f8_load(const float *p) { F8_EACH(p[i]); }
static inline f8 f8_all(float x) { F8_EACH(x); }
static inline f8 f8_add(f8 a, f8 b) { F8_EACH(a.x[i] + b.x[i]); }
static inline f8 f8_sub(f8 a, f8 b) { F8_EACH(a.x[i] - b.x[i]); }
static inline f8 f8_mul(f8 a, f8 b) { F8_EACH(a.x[i] * b.x[i]); }
static inline f8 f8_div(f8 a, f8 b) { F8_EACH(a.x[i] / b.x[i]); }

static inline f8
f8_multiply_subtract(f8 a, f8 b, f8 c)
{
  F8_EACH(a.x[i] * b.x[i] - c.x[i]);
}

static inline f8
f8_max(f8 a, f8 acc)
{
  F8_EACH(a.x[i] > acc.x[i] ? a.x[i] : acc.x[i]);
}

static inline f8
f8_min(f8 a, f8 acc)
{
  F8_EACH(a.x[i] < acc.x[i] ? a.x[i] : acc.x[i]);
}

static inline void
f8_store(float *p, f8 a)
{
  for (int i = 0; i < 8; i++)
    {
      p[i] = a.x[i];
    }
}

static inline unsigned
f8_le(f8 a, f8 b)
{
  unsigned mask = 0;

  for (int i = 0; i < 8; i++)
    {
      mask |= (unsigned)(a.x[i] <= b.x[i]) << i;
    }
  return mask;
}

/** The least of all eight. */
static inline float
f8_least(f8 a)
{
  float least = a.x[0];

  for (int i = 1; i < 8; i++)
    {
      least = a.x[i] < least ? a.x[i] : least;
    }
  return least;
}

/** The greatest. */
static inline float
f8_most(f8 a)
{
  float most = a.x[0];

  for (int i = 1; i < 8; i++)
    {
      most = a.x[i] > most ? a.x[i] : most;
    }
  return most;
}

#endif

#ifdef F8_LOW

static inline float
f8_least(f8 a)
{
  __m128 m = _mm_min_ps(F8_LOW(a), F8_HIGH(a));

  m = _mm_min_ps(m, _mm_movehl_ps(m, m));
  return _mm_cvtss_f32(_mm_min_ss(m, _mm_shuffle_ps(m, m, 1)));
}

static inline float
f8_most(f8 a)
{
  __m128 m = _mm_max_ps(F8_LOW(a), F8_HIGH(a));

  m = _mm_max_ps(m, _mm_movehl_ps(m, m));
  return _mm_cvtss_f32(_mm_max_ss(m, _mm_shuffle_ps(m, m, 1)));
}

#endif
#endif
