// coverage.m - whether the errors that --noise states are true: renders a
// scene with many seeds and compares every pixel with a picture of very many
// rays. Prints for each limit E
//
//   E  states  reached  covered  all  within  rays
//
// states: the share of pixels whose rays differ enough that they state more
// than what no ray might have met; reached: the root of their mean square error
// by E, the least and the largest of all seeds; covered: the share of them in
// which the stated interval holds the reference in all channels; all: the same
// of all pixels; within: the share of pictures whose root of the mean square
// error is at most E; rays: of an average picture; random: how many times as
// many rays --sampler random, a fixed number in each pixel, takes for the same
// root of the mean square error.
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

/** Rays through a pixel of the picture that tells the error of random ones. */
enum { RANDOM = 64 };

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

/** Of one limit: sums over seeds. */
struct sums
{
  double covered[2], counted[2], rays, stating, least, most, within, squares;
};

static void
compare(image_t *image, image_t *reference, double limit, struct sums *sums)
{
  size_t count = (size_t)image->columns * image->rows;
  double squares = 0, all_squares = 0, sampled = 0;

  for (size_t i = 0; i < count; i++)
    {
      struct k_vec d = k_sub(image->pixels[i].color,
                             reference->pixels[i].color);
      double h = image->planes[PLANE_SAMPLING][i];
      const double off[3] = { fabs(d.x), fabs(d.y), fabs(d.z) };
      BOOL more = h * image->planes[PLANE_SAMPLES][i] > 0.5001;
      // The reference itself is known to about a hundredth of E.
      BOOL holds = fmax(off[0], fmax(off[1], off[2])) <= h + limit / 100;
      for (int c = 0; c < 3; c++)
        {
          squares += more ? off[c] * off[c] : 0;
          all_squares += off[c] * off[c];
        }
      sums->covered[0] += more && holds;
      sums->counted[0] += more;
      sums->covered[1] += holds;
      sums->counted[1]++;
      sampled += more;
      sums->stating += more;
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
  options.samples = RANDOM;
  options.sampler = SAMPLER_RANDOM;
  image_t *grainy = picture(model, engine, options);
  double grain = mean_square(grainy, reference);
  options.sampler = SAMPLER_OWEN;
  options.samples = 1;
  options.errors = student_quantile(0.95, BATCHES_FREEDOM);
  options.max_samples = 1 << 20;
  printf("%-10s %6s %11s %8s %8s %7s %10s %7s\n", "E", "states", "reached",
         "covered", "all", "within", "rays", "random");
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
          compare(image, reference, options.noise, &sums);
          [image release];
        }
      printf("%-10g %6.3f %5.3f-%5.3f %8.4f %8.4f %7.3f %10.0f %7.2f\n",
             options.noise, sums.stating / pixels, sums.least, sums.most,
             sums.covered[0] / fmax(sums.counted[0], 1),
             sums.covered[1] / sums.counted[1], sums.within / seeds,
             sums.rays / seeds, grain / (sums.squares / seeds) * RANDOM
             * (pixels / seeds) / (sums.rays / seeds));
    }
  [pool release];
  return 0;
}
