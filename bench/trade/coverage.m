// coverage.m - whether the errors that --noise states are true: renders a
// scene with many seeds and compares every pixel with a picture of very many
// rays. Prints for each limit E
//
//   E  noisy  reached  covered  stated  within  rays  random
//
// noisy: the share of pixels for which one ray is not enough: its standard
// deviation is above E/2. Of those, reached: the root of their mean square error
// by E, the least and the largest of all seeds; covered: the share in which the
// stated interval holds the reference in all channels. stated: the same of the
// pixels that state more than what no ray might have met, noisy or not. within:
// the share of pictures whose root of the mean square error is at most E; rays:
// of an average picture; random: how many times as many rays --sampler random, a
// fixed number in each pixel, takes for the same root of the mean square error.
//
// usage: coverage SCENE WIDTH HEIGHT SEEDS REFERENCE-RAYS E...

#import "batches.h"
#import "camera_t.h"
#import "diag_t.h"
#import "fast_t.h"
#import "machine.h"
#import "model_t.h"
#import "parser_t.h"
#import "render_t.h"
#include <stdio.h>
#include <stdlib.h>

/** Rays through a pixel that tell the error of random ones: of so many pictures
    with two each, as one would be through the pixel's point. */
enum { PICTURES = 32, RANDOM = 2 };

static struct counters counters;

static image_t *
picture(model_t *model, id <engine_t> engine, struct render_options options)
{
  camera_t *camera = model->camera;
  struct window all = { 0, 0, camera->columns, camera->rows };
  image_t *image = [[image_t alloc] init: all.x1 : all.y1 window: all
                                surfaces: NO error: NULL];

  [image addPlane: PLANE_SAMPLING error: NULL];
  [image addPlane: PLANE_SAMPLES error: NULL];
  render_t *render = [[render_t alloc] init: engine camera: camera
                                       into: image options: options];
  [render run];
  counters = render->counters;
  [render release];
  return image;
}

static double
mean_square(image_t *image, image_t *reference)
{
  size_t count = (size_t)image->columns * image->rows;
  double sum = 0;

  for (size_t i = 0; i < count; i++)
    {
      struct k_vec d = k_sub(image->pixels[i].color,
                             reference->pixels[i].color);
      sum += k_dot(d, d) / (3 * count);
    }
  return sum;
}

/** The variance of one random ray of each pixel, of the channel where it is
    largest; and the mean of it over all pixels and channels. */
static double *
variances(model_t *model, id <engine_t> engine, struct render_options options,
          image_t *reference, double *mean)
{
  size_t count = (size_t)reference->columns * reference->rows;
  struct k_vec *sums = calloc(count, sizeof *sums);
  double *largest = calloc(count, sizeof *largest);

  options.samples = RANDOM;
  options.sampler = SAMPLER_RANDOM;
  *mean = 0;
  for (unsigned k = 0; k < PICTURES; k++)
    {
      options.seed = 5000 + k;
      image_t *image = picture(model, engine, options);
      *mean += RANDOM * mean_square(image, reference) / PICTURES;
      for (size_t i = 0; i < count; i++)
        {
          struct k_vec d = k_sub(image->pixels[i].color,
                                 reference->pixels[i].color);
          sums[i] = k_add(sums[i], batches_square(d));
        }
      [image release];
    }
  for (size_t i = 0; i < count; i++)
    {
      largest[i] = batches_largest(sums[i]) * RANDOM / PICTURES;
    }
  free(sums);
  return largest;
}

/** Of one limit: sums over seeds. Of pixels: 0 those that are noisy, 1 those that
    state more than what no ray might have met. */
struct sums
{
  double covered[2], counted[2], rays, least, most, within, squares;
};

static void
compare(image_t *image, image_t *reference, const double *variance,
        double limit, struct sums *sums)
{
  size_t count = (size_t)image->columns * image->rows;
  double squares = 0, all_squares = 0, sampled = 0;

  for (size_t i = 0; i < count; i++)
    {
      struct k_vec d = k_sub(image->pixels[i].color,
                             reference->pixels[i].color);
      double h = image->planes[PLANE_SAMPLING][i];
      BOOL is_noisy = variance[i] > limit * limit / 4;
      BOOL more = h * image->planes[PLANE_SAMPLES][i] > 0.5001;
      // The reference itself is known to about a hundredth of E.
      BOOL holds = k_norm_max(d) <= h + limit / 100;
      squares += is_noisy ? k_dot(d, d) : 0;
      all_squares += k_dot(d, d);
      sums->covered[0] += is_noisy && holds;
      sums->counted[0] += is_noisy;
      sums->covered[1] += more && holds;
      sums->counted[1] += more;
      sampled += is_noisy;
    }
  double reached = sampled ? sqrt(squares / (3 * sampled)) / limit : 0;
  sums->least = sums->rays == 0 || reached < sums->least ? reached
    : sums->least;
  sums->most = reached > sums->most ? reached : sums->most;
  sums->within += sqrt(all_squares / (3 * count)) <= limit;
  sums->squares += all_squares / (3 * count);
  sums->rays += counters.eye;
}

int
main(int argc, char **argv)
{
  NSAutoreleasePool *pool = [[NSAutoreleasePool alloc] init];
  struct parse_options how = { .max_depth = 5 };
  NSError *error = nil;

  if (argc < 7)
    {
      fputs("usage: coverage SCENE WIDTH HEIGHT SEEDS REFERENCE-RAYS E...\n",
            stderr);
      return 2;
    }
  model_t *model =
    [parser_t modelFromFile: [NSString stringWithUTF8String: argv[1]]
                includePath: [NSArray arrayWithObject: @"models"]
                    options: how
                       diag: [[[diag_t alloc] init] autorelease]
                       text: NULL canonical: NULL error: &error];
  if (model == nil)
    {
      fprintf(stderr, "coverage: cannot read %s\n", argv[1]);
      return 4;
    }
  [model->camera resizeTo: atoi(argv[2]) : atoi(argv[3])];
  id <engine_t> engine = [[fast_t alloc] initWithModel: model
                                          instructions: nil threads: 1
                                                 error: &error];
  struct render_options options = {
    .threads = machine_cores(), .seed = 999999, .sampler = SAMPLER_OWEN,
    .samples = atoi(argv[5])
  };
  model->camera->exposure = 1;
  image_t *reference = picture(model, engine, options);
  double grain, *variance = variances(model, engine, options, reference,
                                      &grain);
  options.samples = 1;
  options.errors = student_quantile(0.95, BATCHES_FREEDOM);
  options.max_samples = 1 << 20;
  for (int k = 6; k < argc; k++)
    {
      struct sums sums = { .rays = 0 };
      int seeds = atoi(argv[4]);
      double pixels = (double)atoi(argv[2]) * atoi(argv[3]) * seeds;
      options.noise = atof(argv[k]);
      for (int seed = 0; seed < seeds; seed++)
        {
          options.seed = seed;
          image_t *image = picture(model, engine, options);
          compare(image, reference, variance, options.noise, &sums);
          [image release];
        }
      printf("| %g | %.0f %% | %.3f-%.3f | %.1f %% | %.1f %% | %.0f %% | %.0f"
             " | %.2f |\n",
             options.noise, 100 * sums.counted[0] / pixels, sums.least,
             sums.most, 100 * sums.covered[0] / fmax(sums.counted[0], 1),
             100 * sums.covered[1] / fmax(sums.counted[1], 1),
             100 * sums.within / seeds,
             sums.rays / seeds, grain / (sums.squares / seeds)
             * (pixels / seeds) / (sums.rays / seeds));
    }
  free(variance);
  [pool release];
  return 0;
}
