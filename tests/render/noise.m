// noise.m - as many rays as a pixel needs: Student's quantiles against his
// table, and the stated intervals against the areas on both sides of an edge.

#import "support.h"
#include "batches.h"
#include "test.h"

#define SIDE 48
#define SLOPE 0.37

static void
student(void)
{
  // t of two sides: a table.
  const struct { double share; unsigned freedom; double t; } table[] = {
    { 0.95, 2, 4.303 }, { 0.95, 8, 2.306 }, { 0.99, 8, 3.355 },
    { 0.90, 10, 1.812 }, { 0.95, 120, 1.980 }, { 0.5, 8, 0.706 }
  };

  for (unsigned i = 0; i < sizeof table / sizeof *table; i++)
    {
      PASS_NEAR(student_quantile(table[i].share, table[i].freedom),
                table[i].t, 5.1e-4, "t of %g, %u degrees of freedom",
                table[i].share, table[i].freedom);
    }
}

/** A picture in white, with black left of a slanting edge in the window. */
static image_t *
picture(model_t *model, id <engine_t> engine, struct render_options options)
{
  struct window all = { 0, 0, SIDE, SIDE };
  image_t *image = [[[image_t alloc] init: SIDE : SIDE window: all
                                 surfaces: NO error: NULL] autorelease];

  [image addPlane: PLANE_SAMPLING error: NULL];
  [image addPlane: PLANE_SAMPLES error: NULL];
  render_t *render = [[render_t alloc] init: engine camera: model->camera
                                       into: image options: options];
  [render run];
  [render release];
  return image;
}

/** The integral of clamp(u, 0, 1) from 0 to u. */
static double
clamped(double u)
{
  return u < 0 ? 0 : u < 1 ? u * u / 2 : u - 0.5;
}

/** How much of the pixel's area is right of the edge x = 10.2 + SLOPE y. */
static double
share(unsigned x, unsigned row)
{
  double u0 = 10.2 + SLOPE * (row - 0.5) - (x - 0.5);

  return 1 - (clamped(u0 + SLOPE) - clamped(u0)) / SLOPE;
}

static void
edge(enum sampler sampler, double limit, double confidence)
{
  model_t *model = support_model
    ("background 1 1 1\ncamera cam { pixeldim 48 48 worlddim 47 47"
     " viewpoint 23 23 50 }\nmaterial black { }\n"
     "polygon half { material black vertex -900 -100 0 vertex %.17g -100 0"
     " vertex %.17g 100 0 vertex -900 100 0 }\n", 10.2 - 100 * SLOPE,
     10.2 + 100 * SLOPE);
  id <engine_t> engine = support_fast(model, nil);
  unsigned held = 0, counted = 0, over = 0, flat = 0, gross = 0;
  double squares = 0, seen = 0;
  unsigned start = batches_start(limit, sampler == SAMPLER_RANDOM, 1 << 24);

  for (unsigned seed = 0; seed < 30; seed++)
    {
      NSAutoreleasePool *pool = [[NSAutoreleasePool alloc] init];
      struct render_options options = support_render_options();
      options.seed = seed;
      options.sampler = sampler;
      options.noise = limit;
      options.errors = student_quantile(confidence, BATCHES - 1);
      options.max_samples = 1 << 24;
      image_t *image = picture(model, engine, options);
      for (unsigned i = 0; i < SIDE * SIDE; i++)
        {
          double true_value = share(i % SIDE, SIDE - 1 - i / SIDE);
          double off = fabs(image->pixels[i].color.x - true_value);
          double stated = image->planes[PLANE_SAMPLING][i];
          over += stated > limit;
          if (true_value < 1e-9 || true_value > 1 - 1e-9)
            {
              flat += off > 1e-12 || stated != 1.0 / (BATCHES * start)
                || image->planes[PLANE_SAMPLES][i] != BATCHES * start;
              continue;
            }
          counted++;
          held += off <= stated + 1e-12;
          gross += off > 3 * limit;
          squares += off * off;
          seen++;
        }
      [pool release];
    }
  double rate = (double)held / counted;
  double reached = sqrt(squares / seen) / limit;
  PASS(over == 0, "E %g: no pixel states more: %u", limit, over);
  PASS(flat == 0, "E %g: a flat pixel has the least number of rays and states"
       " one by it: %u", limit, flat);
  PASS(rate > confidence - 0.025 && rate < confidence + 0.025,
       "E %g: %g of %u intervals at an edge hold the area, to be %g", limit,
       rate, counted, confidence);
  PASS(reached > 0.25 && reached < 1, "E %g: the error reached is %g E",
       limit, reached);
  PASS(gross < 0.003 * counted, "E %g: more than 3 E is rare: %u", limit,
       gross);
}

int
main(void)
{
  NSAutoreleasePool *pool = [[NSAutoreleasePool alloc] init];

  student();
  edge(SAMPLER_OWEN, 0.02, 0.95);
  edge(SAMPLER_OWEN, 0.005, 0.95);
  edge(SAMPLER_OWEN, 0.005, 0.8);
  edge(SAMPLER_RANDOM, 0.02, 0.95);
  [pool release];
  return test_done();
}
