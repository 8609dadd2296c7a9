// job_t+choices.m - what the options ask of the model, of the render and of
// memory.

#import "job_t.h"
#import "brightest_t.h"
#import "camera_t.h"
#import "errors.h"
#import "exr_channel.h"
#import "machine.h"
#import "model_t.h"
#include "batches.h"
#include "clock.h"

@implementation job_t (choices)

- (BOOL) explains
{
  return options->settings.explain[0] != NO_CROP;
}

- (unsigned) aovs
{
  const struct settings *settings = &options->settings;
  BOOL is_cut = settings->min_weight >= 0 || settings->max_error > 0;

  return (unsigned)settings->aovs | (is_cut ? AOV_TRUNCATION : 0)
    | (settings->noise > 0 ? AOV_SAMPLING | AOV_SAMPLES : 0)
    | (isTimed ? AOV_SAMPLING : 0);
}

- (unsigned) threads
{
  const struct settings *settings = &options->settings;

  return settings->threads ? (unsigned)settings->threads : machine_cores();
}

- (double) confidence
{
  double given = options->settings.confidence;

  return given > 0 ? given : 0.95;
}

- (struct render_options) renderOptions
{
  const struct settings *settings = &options->settings;
  struct render_options how = {
    .threads = [self threads],
    .stack = [render_t stackFor: model->max_depth],
    .seed = settings->seed,
    .until = settings->time_limit > 0 ? clock_seconds() + settings->time_limit
      : 0,
    .grace = MIN(0.05, settings->time_limit / 2),
    .samples = (unsigned)settings->samples,
    .sampler = (enum sampler)settings->sampler,
    .noise = settings->noise,
    .errors = student_quantile([self confidence], BATCHES_FREEDOM),
    .max_samples = settings->max_samples ? (unsigned)settings->max_samples
    : 65536
  };

  return how;
}

- (struct shade_choice) choice
{
  const struct settings *settings = &options->settings;
  struct shade_choice choice = {
    settings->fresnel == 1, settings->no_shadows == 1,
    settings->no_reflection == 1, settings->no_refraction == 1
  };

  return choice;
}

- (void) setCut
{
  const struct settings *settings = &options->settings;
  BOOL is_bound = settings->max_error > 0;
  struct cut_rule *cut = &model->cut;

  cut->is_on = ([self aovs] & AOV_TRUNCATION) != 0;
  if (!cut->is_on)
    {
      return;
    }
  if (is_bound && ![options isGiven: "max-depth"])
    {
      model->max_depth = CUT_BOUND_GENERATIONS;
    }
  cut->generations = is_bound || model->max_depth > CUT_GENERATIONS
    ? model->max_depth : CUT_GENERATIONS;
  cut->min_weight = settings->min_weight;
  cut->max_error = is_bound ? settings->max_error : -1;
  brightest = [[brightest_t alloc] initWithModel: model
                                     generations: cut->generations];
  cut->most = brightest->most;
  cut->most_count = brightest->count;
}

- (enum keep) keep
{
  return [self explains] ? KEEP_DOUBLES
    : options->format == FORMAT_EXR ? KEEP_FLOATS : KEEP_BYTES;
}

/** What a pixel takes at most, from the first ray to the file, which is made
    whole in memory and may be as large as what goes into it. */
- (size_t) bytesOfPixel
{
  const struct exr_channel *found[EXR_CHANNELS];
  unsigned aovs = [self aovs];

  return [image_t bytesOfPixel: [self keep]]
    + (aovs & AOV_SURFACES ? sizeof(struct surface_pixel) : 0)
    + (aovs & AOV_TRUNCATION ? sizeof(double) : 0)
    + (aovs & AOV_SAMPLING ? sizeof(double) : 0)
    + (aovs & AOV_SAMPLES ? sizeof(double) : 0)
    + (isTimed ? sizeof(struct timed_pixel) : 0)
    + (options->format == FORMAT_EXR
       ? sizeof(float) * exr_channels(found, aovs)
       : 3);            // a byte each
}

- (BOOL) hasRoomFor: (struct window)w error: (NSError **)error
{
  unsigned columns = w.x1 - w.x0, rows = w.y1 - w.y0;
  double needed = (double)columns * rows * [self bytesOfPixel];
  double memory = machine_memory();

  if (needed > memory)
    {
      *error = error_saying(STATUS_FILE, @"not enough memory for %u x %u "
                            @"pixels: they and their file take %.0f bytes, and "
                            @"the program may have %.0f in all", columns, rows,
                            needed, memory);
    }
  return needed <= memory;
}

@end
