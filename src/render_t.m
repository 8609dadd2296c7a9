#import "render_t.h"
#import "camera_t.h"
#include "sampler.h"
#include <pthread.h>

// Pixels of one side of a tile: large enough that taking the next one costs
// nothing, small enough that the last ones keep all threads busy.
#define TILE 16

// Bytes of a thread's stack: rays are traced by recursion, and deep ones in
// many media at once need more than threads commonly have.
#define STACK_SIZE (64 << 20)

@implementation render_t

- (id) init: (id <engine_t>)anEngine camera: (camera_t *)aCamera
       into: (image_t *)anImage options: (struct render_options)someOptions
{
  if ((self = [super init]))
    {
      engine = [anEngine retain];
      camera = [aCamera retain];
      image = [anImage retain];
      lock = [[NSLock alloc] init];
      options = someOptions;
      tiles_across = ([image width] + TILE - 1) / TILE;
      tile_count = tiles_across * (([image height] + TILE - 1) / TILE);
    }
  return self;
}

- (void) dealloc
{
  [image release];
  [camera release];
  [engine release];
  [lock release];
  [super dealloc];
}

/** The place of sample s in the pixel. */
- (void) place: (struct sample *)sample of: (unsigned)s
{
  if (options.samples == 1)
    {
      sample->right = sample->up = 0;
    }
  else if (options.sampler == SAMPLER_GRID)
    {
      unsigned n = lround(sqrt(options.samples));
      sample->right = (s % n + 0.5) / n - 0.5;
      sample->up = (s / n + 0.5) / n - 0.5;
    }
  else
    {
      sample->right = sampler_random(options.seed, sample->column,
                                     sample->row, s,
                                     DIMENSION_PIXEL_RIGHT) - 0.5;
      sample->up = sampler_random(options.seed, sample->column, sample->row,
                                  s, DIMENSION_PIXEL_UP) - 0.5;
    }
}

/** The mean colour of all rays of a pixel. */
- (struct k_vec) colorOf: (struct sample)sample
                counters: (struct counters *)count
{
  struct k_vec sum = k_vec(0, 0, 0);
  uint64_t ray_number = 0;

  for (unsigned s = 0; s < options.samples; s++)
    {
      [self place: &sample of: s];
      for (unsigned e = 0; e < camera->exposure; e++, ray_number++)
        {
          struct k_vec o, d;
          if (camera->has_lens)
            {
              sample.u = 2 * sampler_random(options.seed, sample.column,
                                            sample.row, ray_number,
                                            DIMENSION_LENS_U) - 1;
              sample.v = 2 * sampler_random(options.seed, sample.column,
                                            sample.row, ray_number,
                                            DIMENSION_LENS_V) - 1;
            }
          [camera ray: sample pos: &o dir: &d];
          sum = k_add(sum, [engine colorAt: o : d counters: count]);
        }
    }
  return k_div(sum, ray_number);
}

- (void) pixel: (unsigned)x : (unsigned)y counters: (struct counters *)count
{
  struct sample sample = { .column = x, .row = image->rows - 1 - y };

  if (image->surfaces)
    {
      // Through the middle of the pixel and of the lens.
      struct k_vec o, d;
      [camera centralRay: sample pos: &o dir: &d];
      *[image surfaceAt: x : y] = [engine surfaceAt: o : d];
    }
  [image pixelAt: x : y]->color = [self colorOf: sample counters: count];
}

- (void) tile: (unsigned)tile counters: (struct counters *)count
{
  unsigned x0 = image->window.x0 + tile % tiles_across * TILE;
  unsigned y0 = image->window.y0 + tile / tiles_across * TILE;

  for (unsigned y = y0; y < y0 + TILE && y < image->window.y1; y++)
    {
      for (unsigned x = x0; x < x0 + TILE && x < image->window.x1; x++)
        {
          [self pixel: x : y counters: count];
        }
    }
}

/** What each thread does: take tiles until there are none left. */
- (void) work
{
  NSAutoreleasePool *pool = [[NSAutoreleasePool alloc] init];
  struct counters mine = { 0 };
  unsigned tile;

  while ((tile = __atomic_fetch_add(&next_tile, 1, __ATOMIC_RELAXED))
         < tile_count)
    {
      [self tile: tile counters: &mine];
      __atomic_fetch_add(&tiles_done, 1, __ATOMIC_RELAXED);
    }
  [lock lock];
  counters_add(&counters, &mine);
  [lock unlock];
  [pool release];
}

static void *
work_in_thread(void *render)
{
  GSRegisterCurrentThread();
  [(render_t *)render work];
  GSUnregisterCurrentThread();
  return NULL;
}

- (void) run
{
  pthread_t threads[options.threads];
  pthread_attr_t attributes;
  unsigned started = 0;

  pthread_attr_init(&attributes);
  pthread_attr_setstacksize(&attributes, STACK_SIZE);
  while (started < options.threads
         && pthread_create(&threads[started], &attributes, work_in_thread,
                           self) == 0)
    {
      started++;
    }
  pthread_attr_destroy(&attributes);
  if (started == 0)
    {
      [self work];              // no thread is to be had: then in this one
    }
  while (started)
    {
      pthread_join(threads[--started], NULL);
    }
}

- (double) done
{
  return tile_count ? (double)__atomic_load_n(&tiles_done, __ATOMIC_RELAXED)
    / tile_count : 1;
}

@end
