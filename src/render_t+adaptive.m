// render_t+adaptive.m - as many rays through each pixel as it needs: batches
// of rays (batches.h), twice as long each time, until the means of the batches
// agree. What a pixel needs is found from its own rays and from the first ones,
// the pilots, of the pixels around. Those are rays of its own even where they
// are not of the part that is computed, so a part is that of the whole.

#import "render_t.h"
#import "camera_t.h"
#include "grow.h"

/** About so many pixels have pilots at a time: 120 bytes each. */
enum { PILOTS_MOST = 1 << 18 };

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

/** Where the rays of batches go. */
- (struct ray_places) batchPlaces
{
  struct ray_places places = [self places];

  places.moves_in_pixel = YES;
  places.exposure = 1;
  return places;
}

- (unsigned) startLength
{
  return batches_start(options.noise, options.sampler == SAMPLER_RANDOM,
                       options.max_samples);
}

/** Where the pixel's error.truncation is summed up, if anywhere. */
- (double *) truncationAt: (unsigned)x : (unsigned)y
{
  struct window w = image->window;
  BOOL is_here = x >= w.x0 && x < w.x1 && y >= w.y0 && y < w.y1;

  return is_here && image->planes[PLANE_TRUNCATION]
    ? [image plane: PLANE_TRUNCATION at: x : y] : NULL;
}

/** Makes all batches of the pixel, `from` rays long, `length` rays long. */
- (void) lengthen: (struct k_vec *)sums from: (unsigned)from
               to: (unsigned)length at: (unsigned)x : (unsigned)y
          through: (struct ray_places *)places
             into: (struct adaptive_bundle *)bundle
         counters: (struct counters *)count
{
  struct sample sample = { .column = x, .row = image->rows - 1 - y };
  double *truncation = [self truncationAt: x : y];

  for (unsigned batch = 0; batch < BATCHES; batch++)
    {
      ray_places_begin(places, sample.column, sample.row, batch);
      for (unsigned ray = from; ray < length; ray++)
        {
          ray_places_set(places, ray, &sample);
          bundle->samples[bundle->count] = sample;
          bundle->truncations[bundle->count] = truncation;
          bundle->sums[bundle->count++] = &sums[batch];
          if (bundle->count == EYE_RAYS)
            {
              trace(self, bundle, count);
            }
        }
    }
}

/** The pilots of a tile. */
- (void) try: (struct window)w counters: (struct counters *)count
{
  struct ray_places places = [self batchPlaces];
  struct adaptive_bundle bundle;
  struct batches b = { .length = [self startLength] };

  bundle.count = 0;
  for (unsigned y = w.y0; y < w.y1; y++)
    {
      for (unsigned x = w.x0; x < w.x1; x++)
        {
          struct pilot *pilot = pilots_at(&pilots, x, y);
          memset(pilot, 0, sizeof *pilot);
          [self lengthen: pilot->sums from: 0 to: b.length at: x : y
                 through: &places into: &bundle counters: count];
        }
    }
  trace(self, &bundle, count);
  for (unsigned y = w.y0; y < w.y1; y++)
    {
      for (unsigned x = w.x0; x < w.x1; x++)
        {
          struct pilot *pilot = pilots_at(&pilots, x, y);
          memcpy(b.sums, pilot->sums, sizeof b.sums);
          pilot->variance = batches_variance(&b);
        }
    }
}

/** What each thread does before it computes the pixels. */
- (void) tryTiles
{
  NSAutoreleasePool *pool = [[NSAutoreleasePool alloc] init];
  struct counters mine = { 0 };
  unsigned tile;

  while ((tile = __atomic_fetch_add(&next_tile, 1, __ATOMIC_RELAXED))
         < tile_count)
    {
      [self try: [self windowOf: tile] counters: &mine];
    }
  [lock lock];
  counters_add(&counters, &mine);
  [lock unlock];
  [pool release];
}

- (void) finish: (const struct batches *)b error: (double)error
             at: (unsigned)x : (unsigned)y
{
  double rays = (double)BATCHES * b->length;
  struct k_vec color = batches_mean(b);

  [image put: &color : 1 at: x : y];
  *[image plane: PLANE_SAMPLES at: x : y] = rays;
  *[image plane: PLANE_SAMPLING at: x : y] = error;
  if (image->planes[PLANE_TRUNCATION])
    {
      *[image plane: PLANE_TRUNCATION at: x : y] /= rays;
    }
}

- (void) adaptivePixelsOf: (struct window)w
                 counters: (struct counters *)count
{
  struct ray_places places = [self batchPlaces];
  struct batches batches[EYE_RAYS];
  struct k_vec variances[EYE_RAYS];
  struct adaptive_bundle bundle;
  unsigned across = w.x1 - w.x0, left[EYE_RAYS];
  unsigned count_left = across * (w.y1 - w.y0), length = [self startLength];
  double gain = batches_gain(options.sampler == SAMPLER_RANDOM,
                             places.has_lens);

  NSAssert(count_left <= EYE_RAYS, @"a block of pixels is too large");
  bundle.count = 0;
  for (unsigned i = 0; i < count_left; i++)
    {
      unsigned x = w.x0 + i % across, y = w.y0 + i / across;
      memcpy(batches[i].sums, pilots_at(&pilots, x, y)->sums,
             sizeof batches[i].sums);
      batches[i].length = length;
      variances[i] = pilots_variance(&pilots, x, y);
      left[i] = i;
    }
  for (;;)
    {
      unsigned still = 0;
      BOOL isLast = 2.0 * length * BATCHES > options.max_samples;
      for (unsigned k = 0; k < count_left; k++)
        {
          unsigned i = left[k];
          double error = batches_half_width(variances[i],
                                            (double)BATCHES * length,
                                            options.errors);
          if (!isLast && error > options.noise && error < HUGE_VAL)
            {
              left[still++] = i;
              continue;
            }
          [self finish: &batches[i] error: error
                    at: w.x0 + i % across : w.y0 + i / across];
        }
      if ((count_left = still) == 0)
        {
          return;
        }
      for (unsigned k = 0; k < count_left; k++)
        {
          unsigned i = left[k];
          [self lengthen: batches[i].sums from: length to: 2 * length
                      at: w.x0 + i % across : w.y0 + i / across
                 through: &places into: &bundle counters: count];
        }
      trace(self, &bundle, count);
      length *= 2;
      for (unsigned k = 0; k < count_left; k++)
        {
          unsigned i = left[k];
          batches[i].length = length;
          variances[i] = batches_moderate(k_scale(variances[i], gain),
                                          batches_variance(&batches[i]));
        }
    }
}

/** Some rows after the other: their pilots and those of the rows around that are
    not there yet, then the pixels. */
- (void) runAdaptive
{
  struct window w = image->window;
  struct window all = { 0, 0, image->columns, image->rows };
  struct window seen = around_window(w, all);
  unsigned columns = seen.x1 - seen.x0, tried = seen.y0;
  unsigned rows = MAX(PILOTS_MOST / columns / TILE_SIDE, 1) * TILE_SIDE;

  pilots.seen = seen;
  pilots.rows = MIN(rows + 2 * AROUND_REACH, seen.y1 - seen.y0);
  pilots.at = new_array((size_t)columns * pilots.rows, sizeof *pilots.at);
  for (unsigned y = w.y0; y < w.y1; y += rows)
    {
      struct window next = { w.x0, y, w.x1, MIN(y + rows, w.y1) };
      unsigned end = MIN(next.y1 + AROUND_REACH, seen.y1);
      [self cover: (struct window){ seen.x0, tried, seen.x1, end }];
      [self inThreads: @selector(tryTiles)];
      tried = end;
      [self cover: next];
      [self inThreads: @selector(work)];
    }
}

@end
