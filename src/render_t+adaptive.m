// render_t+adaptive.m - as many rays through each pixel as it needs: batches
// of rays (batches.h), twice as long each time, until the means of the batches
// agree. What a pixel needs is found from its own rays alone.

#import "render_t.h"
#import "camera_t.h"
#include "batches.h"

/** Pixels that are sampled together. */
enum { BLOCK = 32 };

/** Rays that are traced together, and the sums their colours go to. */
struct adaptive_bundle
{
  struct sample samples[EYE_RAYS];
  struct k_vec *sums[EYE_RAYS];
  double *truncations[EYE_RAYS];        // NULL: nobody asks
  unsigned count;
};

static void
trace(const render_t *self, struct adaptive_bundle *bundle,
      struct counters *count)
{
  struct eye_ray rays[EYE_RAYS];

  [self->camera rays: rays : bundle->count of: bundle->samples];
  [self->engine trace: rays : bundle->count counters: count];
  for (unsigned i = 0; i < bundle->count; i++)
    {
      *bundle->sums[i] = k_add(*bundle->sums[i], rays[i].color);
      if (bundle->truncations[i])
        {
          *bundle->truncations[i] += rays[i].error;
        }
    }
  bundle->count = 0;
}

@implementation render_t (adaptive)

/** Makes all batches of the pixel `length` rays long. */
- (void) lengthen: (struct batches *)b to: (unsigned)length
               at: (unsigned)x : (unsigned)y
          through: (struct ray_places *)places
             into: (struct adaptive_bundle *)bundle
         counters: (struct counters *)count
{
  struct sample sample = { .column = x, .row = image->rows - 1 - y };
  double *truncation = image->planes[PLANE_TRUNCATION]
    ? [image plane: PLANE_TRUNCATION at: x : y] : NULL;

  for (unsigned batch = 0; batch < BATCHES; batch++)
    {
      ray_places_begin(places, sample.column, sample.row, batch);
      for (unsigned ray = b->length; ray < length; ray++)
        {
          ray_places_set(places, ray, &sample);
          bundle->samples[bundle->count] = sample;
          bundle->truncations[bundle->count] = truncation;
          bundle->sums[bundle->count++] = &b->sums[batch];
          if (bundle->count == EYE_RAYS)
            {
              trace(self, bundle, count);
            }
        }
    }
  b->length = length;
}

- (void) finish: (const struct batches *)b error: (double)error
             at: (unsigned)x : (unsigned)y
{
  double rays = (double)BATCHES * b->length;
  struct k_vec color = batches_mean(b);

  [image put: &color : 1 at: x : y];
  *[image plane: PLANE_SAMPLES at: x : y] = rays;
  // A pixel that is infinite, or no number, has no error that is.
  *[image plane: PLANE_SAMPLING at: x : y] = error < HUGE_VAL ? error
    : HUGE_VAL;
  if (image->planes[PLANE_TRUNCATION])
    {
      *[image plane: PLANE_TRUNCATION at: x : y] /= rays;
    }
}

- (void) adaptivePixelsOf: (struct window)w
                 counters: (struct counters *)count
{
  struct ray_places places = [self places];
  struct batches batches[BLOCK];
  struct adaptive_bundle bundle;
  unsigned across = w.x1 - w.x0, left[BLOCK];
  unsigned pixels = across * (w.y1 - w.y0);
  BOOL isRandom = options.sampler == SAMPLER_RANDOM;
  unsigned start = batches_start(options.noise, isRandom,
                                 options.max_samples);
  unsigned length = start / 2;

  NSAssert(pixels <= BLOCK, @"a block of pixels is too large");
  places.moves_in_pixel = YES;
  places.exposure = 1;
  memset(batches, 0, sizeof batches);
  bundle.count = 0;
  for (unsigned i = 0; i < pixels; i++)
    {
      left[i] = i;
    }
  for (unsigned count_left = pixels; count_left > 0; length *= 2)
    {
      unsigned still = 0;
      BOOL isLast = 2.0 * length * BATCHES > options.max_samples;
      for (unsigned k = 0; k < count_left; k++)
        {
          unsigned i = left[k];
          [self lengthen: &batches[i] to: length
                      at: w.x0 + i % across : w.y0 + i / across
                 through: &places into: &bundle counters: count];
        }
      trace(self, &bundle, count);
      for (unsigned k = 0; k < count_left; k++)
        {
          unsigned i = left[k];
          double error = batches_half_width(&batches[i], isRandom,
                                            options.errors);
          if (length < start
              || (!isLast && error > options.noise && error < HUGE_VAL))
            {
              left[still++] = i;
              continue;
            }
          [self finish: &batches[i] error: error
                    at: w.x0 + i % across : w.y0 + i / across];
        }
      count_left = still;
    }
}

@end
