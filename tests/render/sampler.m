// sampler.m - random numbers without a stream, and where the samples of a
// pixel and the points of a lens fall. A screen of this test's own notes each
// eye ray.

#import "support.h"
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
  lenses();
  [pool release];
  return test_done();
}
