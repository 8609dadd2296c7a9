// sampler.m - random numbers without a stream, and where the samples of a
// pixel and the points of a lens fall. A screen of this test's own notes each
// eye ray.

#import "support.h"
#include "batches.h"
#include "halves.h"
#include "sampler.h"
#include "test.h"

static struct k_vec starts[100000], ways[100000];
static unsigned noted;

/** `screen name { material … }`: is never met, but sees all eye rays. */
@interface screen_t : object_t <object_t>
@end

@implementation screen_t

+ (const struct attribute *) attributes
{
  static const struct attribute table[] = {
    { .name = "material", .kind = ATTRIBUTE_MATERIAL, .is_required = 1 },
    { .name = NULL }
  };
  return table;
}

- (id) initWithBlock: (block_t *)block
{
  return [super initWithBlock: block];
}

- (struct k_bounds) bounds
{
  return k_unbounded();
}

- (void) hits: (ray_t *)ray
{
  if (noted < sizeof starts / sizeof *starts)
    {
      starts[noted] = ray->pos->v;
      ways[noted++] = ray->dir->v;
    }
}

@end

static double
random_at(unsigned i)
{
  return sampler_random(i % 3, i % 7, i % 11, i % 13, i % 4);
}

/** Means, correlations and counts of what has to be even: five standard
    deviations. */
static void
numbers(void)
{
  const unsigned n = 200000;
  unsigned outside = 0, changed = 0, counts[64] = { 0 };
  double sum = 0, products[5] = { 0 };

  for (unsigned i = 0; i < n; i++)
    {
      unsigned x = i % 640, y = i / 640;
      double a = sampler_random(1, x, y, 0, DIMENSION_LENS_U);
      outside += !(a >= 0 && a < 1) || a * 0x1p53 != floor(a * 0x1p53);
      sum += a;
      counts[(int)(a * 64)]++;
      a -= 0.5;
      products[0] += a * (sampler_random(1, x, y, 0, DIMENSION_LENS_V) - 0.5);
      products[1] += a * (sampler_random(1, x + 1, y, 0, DIMENSION_LENS_U)
                          - 0.5);
      products[2] += a * (sampler_random(1, x, y + 1, 0, DIMENSION_LENS_U)
                          - 0.5);
      products[3] += a * (sampler_random(1, x, y, 1, DIMENSION_LENS_U) - 0.5);
      products[4] += a * (sampler_random(2, x, y, 0, DIMENSION_LENS_U) - 0.5);
    }
  for (unsigned i = 0; i < 1000; i++)
    {
      changed += random_at(i) != random_at(i);
    }
  const char *what[] = { "dimension", "column", "row", "sample", "seed" };
  PASS(outside == 0, "numbers are multiples of 2^-53 in [0, 1): %u", outside);
  PASS(changed == 0, "the same place gives the same number");
  PASS_NEAR(sum / n, 0.5, 5 / sqrt(12.0 * n), "their mean is 1/2");
  for (int k = 0; k < 5; k++)
    {
      PASS_NEAR(products[k] / n, 0, 5 / (12 * sqrt(n)), "the next %s has"
                " nothing to do with it", what[k]);
    }
  double chi2 = 0;
  for (int k = 0; k < 64; k++)
    {
      chi2 += (counts[k] - n / 64.0) * (counts[k] - n / 64.0) / (n / 64.0);
    }
  PASS(chi2 > 63 - 5 * sqrt(126) && chi2 < 63 + 5 * sqrt(126),
       "they are even: chi squared %g of 63", chi2);
  PASS(sampler_random(1, 2, 3, 0, 0) != sampler_random(1, 3, 2, 0, 0),
       "column and row are not mixed up");
}

/** Renders one pixel, column 2 and row 1 from the top of 5 x 4. */
static void
render(const char *lens, struct render_options options)
{
  model_t *model = support_model
    ("camera cam { pixeldim 5 4 worlddim 4 3 viewpoint 2 1 5 %s }\n"
     "material m { }\nscreen s { material m }\n", lens);
  struct window pixel = { 2, 1, 3, 2 };
  image_t *image = [[[image_t alloc] init: 5 : 4 window: pixel surfaces: NO
                                    error: NULL] autorelease];
  id <engine_t> notes = [[[notes_t alloc] initWithModel: model] autorelease];
  render_t *r = [[render_t alloc] init: notes camera: model->camera
                                  into: image options: options];

  noted = 0;
  [r run];
  [r release];
}

/** Where the i-th eye ray passes z = 0. Its pixel's point is (2 2 0), a
    spacing is 1. */
static struct k_vec
place(unsigned i)
{
  return k_along(starts[i], -starts[i].z / ways[i].z, ways[i]);
}

static void
grid(void)
{
  for (unsigned n = 1; n <= 4; n++)
    {
      struct render_options options = support_render_options();
      options.sampler = SAMPLER_GRID;
      options.samples = n * n;
      render("", options);
      unsigned seen[16] = { 0 }, wrong = 0;
      for (unsigned i = 0; i < noted; i++)
        {
          struct k_vec p = place(i);
          double a = (p.x - 2 + 0.5) * n - 0.5, b = (p.y - 2 + 0.5) * n - 0.5;
          int cell = (int)(lround(b) * n + lround(a));
          wrong += fabs(a - lround(a)) > 1e-12 || fabs(b - lround(b)) > 1e-12
            || cell < 0 || cell >= (int)(n * n);
          if (cell >= 0 && cell < (int)(n * n))
            {
              seen[cell]++;
            }
        }
      for (unsigned k = 0; k < n * n; k++)
        {
          wrong += seen[k] != 1;
        }
      PASS(noted == n * n && wrong == 0, "grid of %u: each place once, at"
           " ((a + 1/2)/n - 1/2, (b + 1/2)/n - 1/2): %u wrong", n, wrong);
    }
}

static void
random_samples(void)
{
  struct render_options options = support_render_options();

  render("", options);
  PASS(noted == 1 && support_same(starts[0], k_vec(2, 1, 5))
       && k_norm_max(k_sub(place(0), k_vec(2, 2, 0))) < 1e-14,
       "one sample is at the pixel's point");
  options.samples = 4000;
  render("", options);
  unsigned outside = 0;
  double x = 0, y = 0;
  for (unsigned i = 0; i < noted; i++)
    {
      struct k_vec p = place(i);
      outside += fabs(p.x - 2) > 0.5 + 1e-12 || fabs(p.y - 2) > 0.5 + 1e-12;
      x += p.x - 2;
      y += p.y - 2;
    }
  PASS(noted == 4000 && outside == 0, "random samples lie in the pixel's own"
       " area: %u", outside);
  PASS_NEAR(x / noted, 0, 5 / sqrt(12.0 * noted), "around its point (x)");
  PASS_NEAR(y / noted, 0, 5 / sqrt(12.0 * noted), "and y");
  struct k_vec first = ways[0], second = ways[1];
  render("", options);
  PASS(support_same(ways[0], first) && support_same(ways[1], second),
       "the same seed, the same places");
  PASS(!support_same(first, second), "two samples are two places");
  options.seed = 2;
  render("", options);
  PASS(!support_same(ways[0], first), "another seed, other places");
}

/** How many of the 2^k parts of each grid of 2^a x 2^(k-a) do not have
    exactly one of the points. */
static unsigned
uneven(const double (*points)[2], unsigned k)
{
  unsigned wrong = 0, n = 1u << k;

  for (unsigned a = 0; a <= k; a++)
    {
      unsigned seen[1024] = { 0 };
      for (unsigned i = 0; i < n; i++)
        {
          unsigned across = points[i][0] * (1u << a);
          unsigned up = points[i][1] * (1u << (k - a));
          seen[across << (k - a) | up]++;
        }
      for (unsigned i = 0; i < n; i++)
        {
          wrong += seen[i] != 1;
        }
    }
  return wrong;
}

/** Owen's sequence: even parts, each point anywhere, and no relation between
    pixels, batches, seeds and the two pairs. */
static void
owen(void)
{
  static double points[1024][2];
  unsigned wrong = 0;
  const unsigned n = 40000;
  double sums[7] = { 0 };

  for (unsigned seed = 0; seed < 30; seed++)
    {
      struct owen sequence = owen_sequence(seed, 3 * seed, 7, seed % 3,
                                           seed % 2 ? DIMENSION_LENS_U
                                           : DIMENSION_PIXEL_RIGHT);
      for (unsigned k = 0; k <= 10; k++)
        {
          for (unsigned i = 0; i < 1u << k; i++)
            {
              owen_point(&sequence, (seed % 4 << k) + i, &points[i][0],
                         &points[i][1]);
            }
          wrong += uneven(points, k);
        }
    }
  PASS(wrong == 0, "owen: 2^k points, one in each of 2^a x 2^(k-a) parts: %u",
       wrong);
  for (unsigned i = 0; i < n; i++)
    {
      unsigned x = i % 200, y = i / 200;
      const struct owen other[5] = {
        owen_sequence(1, x, y, 0, DIMENSION_PIXEL_RIGHT),
        owen_sequence(1, x + 1, y, 0, DIMENSION_LENS_U),
        owen_sequence(1, x, y + 1, 0, DIMENSION_LENS_U),
        owen_sequence(1, x, y, 1, DIMENSION_LENS_U),
        owen_sequence(2, x, y, 0, DIMENSION_LENS_U)
      };
      struct owen one = owen_sequence(1, x, y, 0, DIMENSION_LENS_U);
      double a, b, c, d;
      owen_point(&one, i % 8, &a, &b);
      for (unsigned k = 0; k < 5; k++)
        {
          owen_point(&other[k], i % 8, &c, &d);
          sums[k] += (a - 0.5) * (c - 0.5);
        }
      sums[5] += (a - 0.5) * (b - 0.5);
      sums[6] += a - 0.5;
    }
  const char *what[] = { "the pixel", "the next column", "the next row",
                         "the next batch", "the next seed", "the other number"
  };
  for (unsigned k = 0; k < 6; k++)
    {
      PASS_NEAR(sums[k] / n, 0, 5 / (12 * sqrt(n)), "owen: %s has nothing to"
                " do with the lens", what[k]);
    }
  PASS_NEAR(sums[6] / n, 0, 5 / sqrt(12.0 * n), "owen: the mean is 1/2");
}

/** How many boxes of 2^-a x 2^-b x 2^-c x 2^-d, a + b + c + d = k - 3, have
    not 8 of 2^k points. */
static unsigned
uneven_boxes(double (*points)[4], unsigned k)
{
  unsigned wrong = 0, n = 1u << k, left = k - 3;

  for (unsigned a = 0; a <= left; a++)
    for (unsigned b = 0; a + b <= left; b++)
      for (unsigned c = 0; a + b + c <= left; c++)
        {
          const unsigned digits[4] = { a, b, c, left - a - b - c };
          unsigned seen[128] = { 0 };
          for (unsigned i = 0; i < n; i++)
            {
              unsigned box = 0;
              for (unsigned d = 0; d < 4; d++)
                {
                  box = box << digits[d]
                    | (unsigned)(points[i][d] * (1u << digits[d]));
                }
              seen[box]++;
            }
          for (unsigned box = 0; box < n / 8; box++)
            {
              wrong += seen[box] != 8;
            }
        }
  return wrong;
}

/** Pixel and lens together; and the table of Sobol's numbers is what Joe and
    Kuo's polynomials and beginnings make. */
static void
together(void)
{
  static double points[1024][4];
  unsigned wrong = 0;

  for (unsigned seed = 0; seed < 30; seed++)
    {
      struct ray_places p = { .seed = seed, .samples = 2, .exposure = 1,
                              .moves_in_pixel = YES, .has_lens = YES };
      ray_places_begin(&p, 5 * seed, 9, seed % 3);
      for (unsigned k = 3; k <= 10; k++)
        {
          for (unsigned i = 0; i < 1u << k; i++)
            {
              struct sample s;
              ray_places_set(&p, (seed % 4 << k) + i, &s);
              points[i][0] = s.right + 0.5;
              points[i][1] = s.up + 0.5;
              points[i][2] = (s.u + 1) / 2;
              points[i][3] = (s.v + 1) / 2;
            }
          wrong += uneven_boxes(points, k);
        }
    }
  PASS(wrong == 0, "owen: 2^k places in the pixel and on the lens, 8 in each of"
       " 2^(k-3) boxes of four dimensions: %u", wrong);
  uint32_t third[32] = { 1u << 31, 3u << 30 };
  uint32_t fourth[32] = { 1u << 31, 3u << 30, 1u << 29 };
  for (unsigned j = 0; j < 32; j++)
    {
      if (j >= 2)
        {
          third[j] = third[j - 1] ^ third[j - 2] ^ third[j - 2] >> 2;
        }
      if (j >= 3)
        {
          fourth[j] = fourth[j - 2] ^ fourth[j - 3] ^ fourth[j - 3] >> 3;
        }
      wrong += owen_reverse(third[j]) != sobol_columns[0][j]
        || owen_reverse(fourth[j]) != sobol_columns[1][j];
    }
  PASS(wrong == 0, "Sobol's third and fourth dimension by their recurrences");
}

/** The root of the mean square error of the mean of n places on the lens: of
    the half of a lens behind an edge, and of a smooth picture. */
static void
errors_of(enum sampler sampler, unsigned n, double *edge, double *smooth)
{
  // The integrals over the unit square of [a + 0.7 b < 0.6] and of e^-a cos 3b.
  const double half = 0.18 / 0.7, whole = (1 - exp(-1)) * sin(3) / 3;
  struct ray_places p = { .sampler = sampler, .samples = 1, .exposure = n,
                          .rays = n, .has_lens = YES };
  double squares[2] = { 0, 0 };

  for (unsigned trial = 0; trial < 400; trial++)
    {
      double sums[2] = { 0, 0 };
      struct sample s;
      ray_places_begin(&p, trial, 3, 0);
      for (unsigned i = 0; i < n; i++)
        {
          ray_places_set(&p, i, &s);
          double a = (s.u + 1) / 2, b = (s.v + 1) / 2;
          sums[0] += a + 0.7 * b < 0.6;
          sums[1] += exp(-a) * cos(3 * b);
        }
      squares[0] += pow(sums[0] / n - half, 2);
      squares[1] += pow(sums[1] / n - whole, 2);
    }
  *edge = sqrt(squares[0] / 400);
  *smooth = sqrt(squares[1] / 400);
}

/** What a sampler is for. The limits are those of a study of such samplers,
    and a tenth more for the number of trials. */
static void
errors(void)
{
  double edge, smooth, random_edge, random_smooth;

  errors_of(SAMPLER_RANDOM, 64, &random_edge, &random_smooth);
  PASS_NEAR(random_edge, sqrt(0.18 / 0.7 * (1 - 0.18 / 0.7) / 64),
            0.1 * random_edge, "random: the error of a binomial");
  errors_of(SAMPLER_OWEN, 64, &edge, &smooth);
  PASS(edge < 1.1 * 0.018 && smooth < 1.1 * 2.0e-3,
       "owen, 64 places: errors %g, %g", edge, smooth);
  errors_of(SAMPLER_OWEN, 256, &edge, &smooth);
  PASS(edge < 1.1 * 6.3e-3 && smooth < 1.1 * 3.6e-4,
       "owen, 256 places: errors %g, %g", edge, smooth);
  errors_of(SAMPLER_STRATIFIED, 64, &edge, &smooth);
  // 64 squares, each with the variance of the gradient in it: a mean of its
  // square of 2.24, by 12 and by 64.
  PASS_NEAR(smooth, sqrt(2.24 / 12) / 64, 0.1 * smooth,
            "stratified, 64 places: the error of a smooth picture");
  PASS(edge < 1.1 * 0.020, "and at an edge: %g", edge);
  errors_of(SAMPLER_OWEN, 50, &edge, &smooth);
  PASS(edge < random_edge / 2 && smooth < random_smooth / 4,
       "owen, 50 places: errors %g, %g", edge, smooth);
  errors_of(SAMPLER_STRATIFIED, 50, &edge, &smooth);
  PASS(edge < random_edge / 1.8 && smooth < random_smooth / 3,
       "stratified, 50 places: errors %g, %g", edge, smooth);
}

/** How the error of numbers that are no powers of two is foretold (halves.h): at
    an edge, from that of 32. */
static void
between(void)
{
  const unsigned counts[] = { 33, 40, 48, 56, 60, 63, 64, 96, 127 };
  double error, smooth;

  errors_of(SAMPLER_OWEN, 32, &error, &smooth);
  for (unsigned i = 0; i < sizeof counts / sizeof *counts; i++)
    {
      unsigned n = counts[i];
      double at, part = 32.0 / n;
      double expected = error * part
        * sqrt(halves_sum(n, batches_gain(NO, NO))
               / halves_sum(32, batches_gain(NO, NO)));
      errors_of(SAMPLER_OWEN, n, &at, &smooth);
      PASS_NEAR(at, expected, 0.2 * expected, "owen, %u places: the error by"
                " that of 32", n);
    }
  PASS_NEAR(halves_rest(48, 0.5), 32.0 / 48, 1e-15, "random ones: 1/n");
}

/** Parts of equal area, each with one point. */
static void
stratified(void)
{
  unsigned wrong = 0, outside = 0;

  for (unsigned n = 1; n <= 300; n++)
    {
      uint64_t rows = stratified_rows(n);
      unsigned seen[300] = { 0 };
      double area = 0;
      for (unsigned i = 0; i < n; i++)
        {
          double a0 = 0, b0 = 0, a1 = 1, b1 = 1;
          stratified_point(i, n, rows, &a0, &b0);
          stratified_point(i, n, rows, &a1, &b1);
          outside += !(a0 >= 0 && a1 <= 1 + 1e-12 && b0 >= 0
                       && b1 <= 1 + 1e-12);
          wrong += fabs((a1 - a0) * (b1 - b0) * n - 1) > 1e-12;
          wrong += n > 3 && (a1 - a0 > 2.1 * (b1 - b0)
                             || b1 - b0 > 2.1 * (a1 - a0));
          area += (a1 - a0) * (b1 - b0);
          uint64_t at = stratified_place(i, n, 0x123456789abcdefu * n);
          outside += at >= n;
          wrong += at < n && seen[at]++ > 0;
        }
      wrong += fabs(area - 1) > 1e-10;
    }
  PASS(wrong == 0 && outside == 0, "stratified: n parts of equal area, none"
       " long, each taken once: %u, %u", wrong, outside);
}

static void
lenses(void)
{
  struct render_options options = support_render_options();
  unsigned outside = 0, twice = 0, meet = 0;

  options.samples = 3;
  render("focus 5 fstop 2 exposure 1000", options);
  PASS(noted == 3000, "exposure rays for each sample");
  for (unsigned i = 0; i < noted; i++)
    {
      struct k_vec lens = k_sub(starts[i], k_vec(2, 1, 5));
      outside += fabs(lens.x) > 0.5 || fabs(lens.y) > 0.5 || lens.z != 0;
      for (unsigned j = 0; j < i && i < 200; j++)
        {
          twice += support_same(starts[i], starts[j]);
        }
    }
  PASS(outside == 0, "all of them start in the aperture: %u", outside);
  PASS(twice == 0, "each elsewhere: %u", twice);
  options.samples = 1;
  render("focus 5 fstop 2 exposure 1000 aperture disc", options);
  outside = 0;
  struct k_vec to = k_along(k_vec(2, 1, 5), 5, k_unit(k_vec(0, 1, -5)));
  for (unsigned i = 0; i < noted; i++)
    {
      struct k_vec lens = k_sub(starts[i], k_vec(2, 1, 5));
      outside += k_length(lens) > 0.5 + 1e-15;
      struct k_vec way = k_unit(k_sub(to, starts[i]));
      meet += k_norm_max(k_sub(way, ways[i])) > 1e-15;
    }
  PASS(noted == 1000 && outside == 0, "in the disc if it is one: %u",
       outside);
  PASS(meet == 0, "they meet where the pixel is in focus: %u", meet);
  render("focus 5 fstop 2 exposure 1", options);
  PASS(noted == 1 && !support_same(starts[0], k_vec(2, 1, 5)),
       "exposure 1 is one ray from somewhere on the lens");
}

int
main(void)
{
  NSAutoreleasePool *pool = [[NSAutoreleasePool alloc] init];

  numbers();
  grid();
  random_samples();
  owen();
  together();
  stratified();
  errors();
  between();
  lenses();
  [pool release];
  return test_done();
}
