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

/** The window of a picture. */
static image_t *
part(model_t *model, id <engine_t> engine, struct render_options options,
     struct window w)
{
  image_t *image = [[[image_t alloc] init: model->camera->columns
                                         : model->camera->rows
                                   window: w
                                 surfaces: NO error: NULL] autorelease];

  [image addPlane: PLANE_SAMPLING error: NULL];
  [image addPlane: PLANE_SAMPLES error: NULL];
  render_t *render = [[render_t alloc] init: engine camera: model->camera
                                       into: image options: options];
  [render run];
  [render release];
  return image;
}

static image_t *
picture(model_t *model, id <engine_t> engine, struct render_options options)
{
  struct window all = { 0, 0, model->camera->columns, model->camera->rows };

  return part(model, engine, options, all);
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

static BOOL
is_flat(unsigned x, unsigned row)
{
  return share(x, row) < 1e-9 || share(x, row) > 1 - 1e-9;
}

/** Whether the pixel and those it looks at are all flat. */
static BOOL
is_far(unsigned x, unsigned row)
{
  for (unsigned y = row < 2 ? 0 : row - 2; y <= row + 2; y++)
    {
      for (unsigned column = x < 2 ? 0 : x - 2; column <= x + 2; column++)
        {
          if (!is_flat(column, y))
            {
              return NO;
            }
        }
    }
  return YES;
}

/** A picture in white, with black left of a slanting edge in the window. */
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
      options.errors = student_quantile(confidence, BATCHES_FREEDOM);
      options.max_samples = 1 << 24;
      image_t *image = picture(model, engine, options);
      for (unsigned i = 0; i < SIDE * SIDE; i++)
        {
          double true_value = share(i % SIDE, SIDE - 1 - i / SIDE);
          double off = fabs(image->pixels[i].color.x - true_value);
          double stated = image->planes[PLANE_SAMPLING][i];
          over += stated > limit;
          if (is_flat(i % SIDE, SIDE - 1 - i / SIDE))
            {
              flat += off > 1e-12
                || (is_far(i % SIDE, SIDE - 1 - i / SIDE)
                    && (stated != 0.5 / (BATCHES * start)
                        || image->planes[PLANE_SAMPLES][i] != BATCHES * start));
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
  PASS(flat == 0, "E %g: a flat pixel is exact; far from the edge it has the"
       " least number of rays and states half of one: %u", limit, flat);
  PASS(rate > confidence - 0.025 && rate < confidence + 0.025,
       "E %g: %g of %u intervals at an edge hold the area, to be %g", limit,
       rate, counted, confidence);
  PASS(reached > 0.25 && reached < 1, "E %g: the error reached is %g E",
       limit, reached);
  PASS(gross < 0.003 * counted, "E %g: more than 3 E is rare: %u", limit,
       gross);
}

/** A lamp so small, and so far out of focus, that one ray in 70 meets it, and 20
    times as bright as what is allowed for: the first rays of most pixels do not,
    but those of the pixels around tell of it. With few first rays not always:
    then intervals hold it less often than they say (docs/formulas.md). */
static void
lamp(void)
{
  const struct { double limit, least, most_missed; } cases[] = {
    { 0.02, 0.88, 0 }, { 0.1, 0.78, 0.15 }
  };
  model_t *model = support_model
    ("camera cam { pixeldim 40 40 worlddim 4 4 viewpoint 2 2 8 focus 4 fstop 1.5"
     " exposure 1 aperture disc }\n"
     "material bright { ambient 240 240 240 }\n"
     "sphere lamp { material bright center 2 2 -4 radius .16 }\n");
  id <engine_t> engine = support_fast(model, nil);
  struct render_options options = support_render_options();
  struct window within = { 14, 14, 26, 26 };
  const unsigned count = 12 * 12, seeds = 6;

  options.sampler = SAMPLER_OWEN;
  options.samples = 1 << 16;
  options.seed = 99;
  image_t *reference = part(model, engine, options, within);
  options.samples = 1;
  options.errors = student_quantile(0.95, BATCHES_FREEDOM);
  options.max_samples = 1 << 20;
  for (unsigned k = 0; k < 2; k++)
    {
      double held = 0, missed = 0;
      options.noise = cases[k].limit;
      for (unsigned seed = 0; seed < seeds; seed++)
        {
          options.seed = seed;
          image_t *image = part(model, engine, options, within);
          for (unsigned i = 0; i < count; i++)
            {
              double off = fabs(image->pixels[i].color.x
                                - reference->pixels[i].color.x);
              held += off <= image->planes[PLANE_SAMPLING][i];
              missed += image->pixels[i].color.x == 0;
            }
        }
      held /= count * seeds;
      missed /= count * seeds;
      PASS(missed <= cases[k].most_missed, "E %g: %g of the pixels are left"
           " without a small lamp's light", options.noise, missed);
      PASS(held > cases[k].least, "E %g: %g of intervals hold it, to be 0.95",
           options.noise, held);
    }
}

/** Crops that begin anywhere, and a picture of more rows than have their first
    rays at a time. */
static void
parts(void)
{
  model_t *model = support_model
    ("camera cam { pixeldim 300 1300 worlddim 300 1300 viewpoint 150 650 1500 }"
     "\nmaterial m { ambient 1 .5 2 }\n"
     "sphere s { material m center 150 1000 -10 radius 149 }\n"
     "sphere t { material m center 150 440 -10 radius 3 }\n");
  id <engine_t> engine = support_fast(model, nil);
  struct render_options options = support_render_options();

  options.noise = 0.1;
  options.errors = student_quantile(0.95, BATCHES_FREEDOM);
  options.max_samples = 1 << 16;
  image_t *whole = picture(model, engine, options);
  const struct window windows[] = {
    { 0, 0, 1, 1 }, { 299, 1299, 300, 1300 }, { 2, 150, 300, 460 },
    { 147, 857, 154, 864 }, { 149, 860, 150, 861 }, { 0, 862, 300, 864 }
  };
  for (unsigned k = 0; k < sizeof windows / sizeof *windows; k++)
    {
      struct window w = windows[k];
      image_t *image = part(model, engine, options, w);
      unsigned wrong = 0, more = 0;
      for (unsigned y = w.y0; y < w.y1; y++)
        {
          for (unsigned x = w.x0; x < w.x1; x++)
            {
              double rays = *[image plane: PLANE_SAMPLES at: x : y];
              wrong += !support_same([whole pixelAt: x : y]->color,
                                     [image pixelAt: x : y]->color)
                || rays != *[whole plane: PLANE_SAMPLES at: x : y]
                || *[image plane: PLANE_SAMPLING at: x : y]
                != *[whole plane: PLANE_SAMPLING at: x : y];
              more += rays > BATCHES * batches_start(0.1, NO, 1 << 16);
            }
        }
      PASS(wrong == 0 && (k < 2 || more > 0), "part %u is that of the whole:"
           " %u pixels are not; %u took more rays than the first", k, wrong,
           more);
    }
}

/** A picture that is light left of an edge, in a column infinite and in one no
    number, or light there too. */
@interface spots_t : NSObject <engine_t>
{
@public
  BOOL is_finite;
}
@end

@implementation spots_t

- (void) trace: (struct eye_ray *)rays : (unsigned)count
      counters: (struct counters *)counters
{
  for (unsigned i = 0; i < count; i++)
    {
      double x = rays[i].o.x - rays[i].o.z / rays[i].d.z * rays[i].d.x;
      double light = x < 4.3;
      light = is_finite || x < -0.5 || x > 1.5 ? light : x > 0.5 ? NAN : HUGE_VAL;
      rays[i].color = k_vec(light, 1, light);
    }
}

- (struct surface_pixel) surfaceAt: (struct k_vec)o : (struct k_vec)d
{
  return (struct surface_pixel){ .depth = HUGE_VAL };
}

@end

/** What is infinite says nothing of the pixels around. */
static void
infinite(void)
{
  model_t *model = support_model("camera cam { pixeldim 9 9 worlddim 8 8"
                                 " viewpoint 4 4 9 }\n");
  struct render_options options = support_render_options();
  unsigned wrong = 0, finite = 0;
  image_t *images[2];

  options.noise = 0.1;
  options.errors = student_quantile(0.95, BATCHES_FREEDOM);
  options.max_samples = 1 << 12;
  for (int k = 0; k < 2; k++)
    {
      spots_t *engine = [[[spots_t alloc] init] autorelease];
      engine->is_finite = k == 0;
      images[k] = picture(model, engine, options);
    }
  for (unsigned y = 0; y < 9; y++)
    {
      for (unsigned x = 0; x < 9; x++)
        {
          double h = *[images[1] plane: PLANE_SAMPLING at: x : y];
          BOOL is_same = h == *[images[0] plane: PLANE_SAMPLING at: x : y]
            && *[images[1] plane: PLANE_SAMPLES at: x : y]
            == *[images[0] plane: PLANE_SAMPLES at: x : y];
          finite += x < 2 && h < HUGE_VAL;
          // Columns 2 and 3 look at those that are infinite.
          wrong += x >= 2 && !(h <= 0.1 && (x < 4 || is_same));
        }
    }
  PASS(finite == 0, "pixels that are infinite, or no number, state that: %u",
       finite);
  PASS(wrong == 0, "the pixels beside do not: %u", wrong);
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
  lamp();
  parts();
  infinite();
  [pool release];
  return test_done();
}
