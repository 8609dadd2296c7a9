// render_t+timed.m - --time-limit: the best picture there is time for. Whole
// passes only, each one ray through every pixel, in the order in which
// --samples would take them: their sums are the same bits.

#import "render_t.h"
#import "camera_t.h"
#include "clock.h"
#include "grow.h"

@implementation render_t (timed)

- (unsigned) samplesDone
{
  return passes;
}

/** The colours of the pixels of a block, at most EYE_RAYS, by ray number `ray`
    of each. */
- (void) block: (struct window)w ray: (uint64_t)ray
        places: (struct ray_places *)places counters: (struct counters *)count
{
  struct sample samples[EYE_RAYS];
  struct eye_ray rays[EYE_RAYS];
  size_t at[EYE_RAYS];
  unsigned n = 0;

  for (unsigned y = w.y0; y < w.y1; y++)
    {
      for (unsigned x = w.x0; x < w.x1; x++)
        {
          struct sample sample = { .column = x, .row = image->rows - 1 - y };
          if (places->moves_in_pixel || places->has_lens)
            {
              ray_places_begin(places, sample.column, sample.row, 0);
              ray_places_set(places, ray, &sample);
            }
          at[n] = [image pixelAt: x : y] - image->pixels;
          samples[n++] = sample;
        }
    }
  [camera rays: rays : n of: samples];
  [engine trace: rays : n counters: count];
  for (unsigned i = 0; i < n; i++)
    {
      pass[at[i]] = rays[i].color;
    }
}

/** A tile, block by block; NO if the time is up before its end. */
- (BOOL) passTile: (struct window)w ray: (uint64_t)ray
           places: (struct ray_places *)places
         counters: (struct counters *)count
{
  for (unsigned y = w.y0; y < w.y1; y += BLOCK_DOWN)
    {
      for (unsigned x = w.x0; x < w.x1; x += BLOCK_ACROSS)
        {
          struct window block = { x, y, MIN(x + BLOCK_ACROSS, w.x1),
                                  MIN(y + BLOCK_DOWN, w.y1) };
          [self block: block ray: ray places: places counters: count];
          if (clock_seconds() > options.until)
            {
              return NO;
            }
        }
    }
  return YES;
}

/** Takes tiles of this pass until none are left or the time is up. */
- (void) passTiles
{
  NSAutoreleasePool *pool = [[NSAutoreleasePool alloc] init];
  struct counters mine = { 0 };
  struct ray_places places = [self places];
  BOOL is_first = passes == 0;
  unsigned tile;

  // The first pass goes through the pixels' points; those after it are the rays
  // of a picture with many, whose number matters to no ray.
  places.samples = 2;
  places.exposure = 1;
  places.rays = UINT32_MAX;
  places.moves_in_pixel = !is_first;
  while ((tile = __atomic_fetch_add(&next_tile, 1, __ATOMIC_RELAXED))
         < tile_count)
    {
      if (![self passTile: [self windowOf: tile]
                      ray: is_first ? 0 : passes - 1
                   places: &places counters: &mine])
        {
          break;
        }
      tile_is_there[tile] = 1;
      __atomic_fetch_add(&tiles_done, 1, __ATOMIC_RELAXED);
    }
  [lock lock];
  counters_add(&counters, &mine);
  [lock unlock];
  [pool release];
}

/** One pass; NO if the time was up before it was complete. */
- (BOOL) onePass
{
  next_tile = tiles_done = 0;
  memset(tile_is_there, 0, tile_count);
  [self inThreads: @selector(passTiles)];
  return tiles_done == tile_count;
}

/** Gives tiles that are not there the colours of the last one before them that
    is, column by column of the tile; black where there is none. */
- (void) fillTiles
{
  size_t count = (size_t)[image width] * [image height];
  unsigned last = 0;

  for (size_t i = 0; i < count; i++)
    {
      image->pixels[i].color = pass[i];
    }
  for (unsigned tile = 0; tile < tile_count; tile++)
    {
      if (tile_is_there[tile])
        {
          last = tile;
          continue;
        }
      struct window w = [self windowOf: tile], v = [self windowOf: last];
      for (unsigned y = w.y0; y < w.y1; y++)
        {
          for (unsigned x = w.x0; x < w.x1; x++)
            {
              unsigned from_x = MIN(v.x0 + (x - w.x0), v.x1 - 1);
              unsigned from_y = MIN(v.y0 + (y - w.y0), v.y1 - 1);
              struct k_vec color = k_vec(0, 0, 0);
              if (tile_is_there[last])
                {
                  color = [image pixelAt: from_x : from_y]->color;
                }
              [image pixelAt: x : y]->color = color;
            }
        }
    }
}

- (void) runTimed
{
  size_t count = (size_t)[image width] * [image height];
  unsigned rays = 0;            // in the sums, beside the first pass

  pass = new_array(count, sizeof *pass);
  tile_is_there = new_array(tile_count, 1);
  if (![self onePass])
    {
      [self fillTiles];
      return;
    }
  for (size_t i = 0; i < count; i++)
    {
      image->pixels[i].color = pass[i];
    }
  struct k_vec *sums = new_array(count, sizeof *sums);
  for (passes = 1; passes < UINT32_MAX && [self onePass]; passes++)
    {
      for (size_t i = 0; i < count; i++)
        {
          sums[i] = k_add(sums[i], pass[i]);
        }
      rays = passes;
    }
  // Two rays are the least that are a picture of many.
  for (size_t i = 0; rays > 1 && i < count; i++)
    {
      image->pixels[i].color = k_div(sums[i], (double)rays);
    }
  passes = rays > 1 ? rays : 1;
  free(sums);
}

@end
