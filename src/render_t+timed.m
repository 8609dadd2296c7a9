// render_t+timed.m - --time-limit: the best picture there is time for. Whole
// passes only, each one ray or more through every pixel, in the order in which
// --samples would take them: their sums are the same bits. The sums of a pass
// become those of the picture tile by tile while the next one is under way.

#import "render_t.h"
#import "camera_t.h"
#include "around.h"
#include "batches.h"
#include "clock.h"
#include "grow.h"
#include "halves.h"

@implementation render_t (timed)

- (unsigned) samplesDone
{
  return taken;
}

- (struct timed_pixel *) timedAt: (unsigned)x : (unsigned)y
{
  return timed + image_at(image, x, y);
}

/** Traces rays and adds each colour to its pixel, in order; NO if the time is
    up then. */
- (BOOL) trace: (const struct sample *)samples : (unsigned)n
           into: (struct timed_pixel **)at counters: (struct counters *)count
{
  struct eye_ray rays[EYE_RAYS];

  [camera rays: rays : n of: samples];
  [engine trace: rays : n counters: count];
  for (unsigned i = 0; i < n; i++)
    {
      at[i]->next = k_add(at[i]->next, rays[i].color);
    }
  return clock_seconds() <= options.until + (is_first_pass ? 0 : options.grace);
}

/** A block of a tile: `step` rays through each pixel, after those it has; NO if
    the time is up before its end. */
- (BOOL) block: (struct window)w places: (struct ray_places *)places
      counters: (struct counters *)count
{
  struct sample samples[EYE_RAYS];
  struct timed_pixel *at[EYE_RAYS];
  unsigned n = 0;

  for (unsigned y = w.y0; y < w.y1; y++)
    {
      for (unsigned x = w.x0; x < w.x1; x++)
        {
          struct sample sample = { .column = x, .row = image->rows - 1 - y };
          struct timed_pixel *pixel = [self timedAt: x : y];
          BOOL moves = places->moves_in_pixel || places->has_lens;
          pixel->next = pixel->sum;
          if (moves)
            {
              ray_places_begin(places, sample.column, sample.row, 0);
            }
          for (unsigned ray = taken; ray < taken + step; ray++)
            {
              if (moves)
                {
                  ray_places_set(places, ray, &sample);
                }
              at[n] = pixel;
              samples[n++] = sample;
              if (n == EYE_RAYS)
                {
                  if (![self trace: samples : n into: at counters: count])
                    {
                      return NO;
                    }
                  n = 0;
                }
            }
        }
    }
  return n == 0 || [self trace: samples : n into: at counters: count];
}

/** Makes a tile of the last complete pass count. */
- (void) addTile: (unsigned)tile
{
  struct window w = [self windowOf: tile];

  for (unsigned y = w.y0; y < w.y1; y++)
    {
      for (unsigned x = w.x0; x < w.x1; x++)
        {
          struct timed_pixel *pixel = [self timedAt: x : y];
          pixel->sum = pixel->next;
          if ((taken & (taken - 1)) == 0)
            {
              pixel->half = pixel->whole;
              pixel->whole = pixel->sum;
            }
        }
    }
  tile_is_added[tile] = 1;
}

/** A tile, block by block; NO if the time is up before its end. */
- (BOOL) passTile: (struct window)w places: (struct ray_places *)places
         counters: (struct counters *)count
{
  for (unsigned y = w.y0; y < w.y1; y += BLOCK_DOWN)
    {
      for (unsigned x = w.x0; x < w.x1; x += BLOCK_ACROSS)
        {
          struct window block = { x, y, MIN(x + BLOCK_ACROSS, w.x1),
                                  MIN(y + BLOCK_DOWN, w.y1) };
          if (![self block: block places: places counters: count])
            {
              return NO;
            }
        }
    }
  return YES;
}

/** Shows the colours of a tile of the first pass, whose number is from 1, in
    its place or, column by column, in one that is missing; 0: black. How far
    off they are is not known. */
- (void) show: (unsigned)number at: (unsigned)tile
{
  struct window w = [self windowOf: tile];
  struct window v = number ? [self windowOf: number - 1] : w;

  for (unsigned y = w.y0; y < w.y1; y++)
    {
      struct k_vec row[TILE_SIDE] = { { 0, 0, 0 } };
      for (unsigned x = w.x0; x < w.x1; x++)
        {
          unsigned from_x = MIN(v.x0 + (x - w.x0), v.x1 - 1);
          unsigned from_y = MIN(v.y0 + (y - w.y0), v.y1 - 1);
          if (number)
            {
              row[x - w.x0] = [self timedAt: from_x : from_y]->next;
            }
          *[image plane: PLANE_SAMPLING at: x : y] = HUGE_VAL;
        }
      [image put: row : w.x1 - w.x0 at: w.x0 : y];
    }
}

/** Takes tiles of this pass until none are left or the time is up. */
- (void) passTiles
{
  NSAutoreleasePool *pool = [[NSAutoreleasePool alloc] init];
  struct counters mine = { 0 };
  struct ray_places places = [self places];
  unsigned tile;

  // The first pass goes through the pixels' points; those after it are the rays
  // of a picture with many, whose number matters to no ray.
  places.samples = 2;
  places.exposure = 1;
  places.rays = UINT32_MAX;
  places.moves_in_pixel = !is_first_pass;
  while ((tile = __atomic_fetch_add(&next_tile, 1, __ATOMIC_RELAXED))
         < tile_count)
    {
      if (taken > 0)
        {
          [self addTile: tile];
        }
      if (![self passTile: [self windowOf: tile] places: &places
                 counters: &mine])
        {
          break;
        }
      if (is_first_pass)
        {
          tile_shown[tile] = tile + 1;
          [self show: tile + 1 at: tile];
        }
      __atomic_fetch_add(&tiles_done, 1, __ATOMIC_RELAXED);
    }
  [lock lock];
  counters_add(&counters, &mine);
  [lock unlock];
  [pool release];
}

/** How many rays through each pixel the next pass has. It never goes past a
    power of two, so that all of them are met. Many rays of one pixel go alike,
    so as long as there is time for it, and a tenth more, all up to that; then
    half of what there is time for, again and again, as the pass that the end of
    the time cuts off is in vain. 0: no time is left. */
- (unsigned) nextStep
{
  unsigned up = 2 * (unsigned)halves_most(taken) - taken;
  double left = options.until - clock_seconds(), rays = left / pace;

  if (left + options.grace > 1.1 * up * pace)
    {
      return up;
    }
  return left <= 0 ? 0
    : (unsigned)MAX(1, MIN(up, rays > taken / 32. ? rays / 2 : rays));
}

/** One pass of `step` rays; NO if the time was up before it was complete. */
- (BOOL) onePass
{
  double began = clock_seconds();

  next_tile = tiles_done = 0;
  [self inThreads: @selector(passTiles)];
  if (tiles_done < tile_count)
    {
      return NO;
    }
  memset(tile_is_added, 0, tile_count);
  pace = (clock_seconds() - began) / step;
  return YES;
}

/** Shows the tiles that the first pass has not come to. */
- (void) fillTiles
{
  unsigned tile;

  while ((tile = __atomic_fetch_add(&next_tile, 1, __ATOMIC_RELAXED))
         < tile_count)
    {
      if (tile_shown[tile] != tile + 1)
        {
          [self show: tile_shown[tile] at: tile];
        }
    }
}

/** Adds what is missing of the last pass. */
- (void) addTiles
{
  unsigned tile;

  while ((tile = __atomic_fetch_add(&next_tile, 1, __ATOMIC_RELAXED))
         < tile_count)
    {
      if (!tile_is_added[tile])
        {
          [self addTile: tile];
        }
    }
}

/** The variance of the pixel's mean, of each channel, as its halves and those
    of the pixels around say; `most` rays are in both, and `share` is what the
    square of their difference is worth. */
- (struct k_vec) varianceAt: (unsigned)x : (unsigned)y most: (double)most
                      share: (double)share
{
  struct window one = { x, y, x + 1, y + 1 }, w = image->window;
  struct window near = around_window(one, w);
  struct around a = { .weight = 0 };

  for (unsigned row = near.y0; row < near.y1; row++)
    {
      for (unsigned column = near.x0; column < near.x1; column++)
        {
          const struct timed_pixel *pixel = [self timedAt: column : row];
          struct k_vec off = k_div(k_sub(k_scale(pixel->half, 2), pixel->whole),
                                   most / 2);
          around_add(&a, (int)column - (int)x, (int)row - (int)y, 1,
                     batches_square(off));
        }
    }
  return k_scale(a.sum, share / a.weight);
}

/** The mean of each pixel, and how far it may be off. */
- (void) stateTiles
{
  unsigned tile;
  double gain = batches_gain(options.sampler == SAMPLER_RANDOM,
                             camera_has_lens(camera));
  double share = halves_share(gain) * halves_rest(taken, gain);
  double most = (double)halves_most(taken);

  while ((tile = __atomic_fetch_add(&next_tile, tile_stride, __ATOMIC_RELAXED))
         < tile_count)
    {
      struct window w = [self windowOf: tile];
      for (unsigned y = w.y0; y < w.y1; y++)
        {
          struct k_vec row[TILE_SIDE];
          for (unsigned x = w.x0; x < w.x1; x++)
            {
              struct k_vec variance = [self varianceAt: x : y most: most
                                                 share: share];
              struct k_vec sum = [self timedAt: x : y]->sum;
              BOOL is_finite = k_norm1(sum) < HUGE_VAL;
              row[x - w.x0] = k_div(sum, (double)taken);
              *[image plane: PLANE_SAMPLING at: x : y] = is_finite
                ? batches_half_width(variance, taken, options.errors) : HUGE_VAL;
            }
          [image put: row : w.x1 - w.x0 at: w.x0 : y];
        }
    }
}

/** Seconds that the end will take: what it takes of a few tiles, which get
    their colours again at the end, and half as much for their sums and facts. */
- (double) endTakes
{
  double began = clock_seconds();

  tile_stride = MAX(1, tile_count / 64);
  next_tile = 0;
  [self inThreads: @selector(stateTiles)];
  return 1.5 * tile_stride * (clock_seconds() - began);
}

- (void) runTimed
{
  timed = new_array((size_t)[image width] * [image height], sizeof *timed);
  tile_shown = new_array(tile_count, sizeof *tile_shown);
  tile_is_added = new_array(tile_count, 1);
  is_first_pass = YES;
  step = 1;
  if (![self onePass])
    {
      for (unsigned tile = 1; tile < tile_count; tile++)
        {
          tile_shown[tile] = tile_shown[tile] ? tile_shown[tile]
            : tile_shown[tile - 1];
        }
      next_tile = 0;
      [self inThreads: @selector(fillTiles)];
      return;
    }
  is_first_pass = NO;
  while (step && taken <= INT32_MAX && [self onePass])
    {
      taken += step;
      if (taken == 2)
        {
          options.until -= [self endTakes];
        }
      step = [self nextStep];
    }
  // Two rays are the least that are a picture of many.
  if (taken < 2)
    {
      taken = 1;
      return;
    }
  image->nanCount = 0;          // of the first pass, which they replace
  next_tile = 0;
  [self inThreads: @selector(addTiles)];
  next_tile = 0;
  tile_stride = 1;
  [self inThreads: @selector(stateTiles)];
}

@end
