// render_t.h - computes a picture: tiles, threads, samples. A pixel depends
// on the model, the options and its own place only, so neither the threads
// nor the tiles nor the crop change a bit of it.

#import <Foundation/Foundation.h>
#import "engine_t.h"
#include "pilots.h"
#include "ray_places.h"

/** Pixels of one side of a tile: large enough that taking the next one costs
    nothing, small enough that the last ones keep all threads busy. */
enum { TILE_SIDE = 16 };

/** Pixels of a block, whose rays are traced together: across and down. */
enum { BLOCK_ACROSS = 8, BLOCK_DOWN = EYE_RAYS / BLOCK_ACROSS };

/** Bytes that each thread's stack has at least. */
#define RENDER_STACK_LEAST ((size_t)64 << 20)

/** What becomes of a pixel by passes. */
struct timed_pixel
{
  struct k_vec sum;             // of the colours of complete passes
  struct k_vec next;            // and of the pass under way
  struct k_vec half, whole;     // of the first 2^(k-1) and 2^k, the most it has
};

struct render_options
{
  unsigned threads;     // at least 1
  size_t stack;         // bytes of each one's stack; 0: what is usual
  uint64_t seed;
  unsigned samples;     // rays through each pixel; 1: through its point
  enum sampler sampler;
  double noise;         // above 0: as many rays, until the error that a pixel
                        // states is at most this; owen or random
  double errors;        // such an error is this many standard errors
  unsigned max_samples; // or no more than so many rays
  double until;         // above 0: passes of one ray through each pixel until
                        // this time of clock_seconds(), and
  double grace;         // so many seconds after it, if that is worth it: a
                        // power of two is much better than a few rays less
};

@interface render_t : NSObject
{
@public
  id <engine_t> engine;
  camera_t *camera;
  image_t *image;
  struct render_options options;
  struct counters counters;     // of all threads, after run
@protected
  struct window area;           // that is being worked on, tile by tile
  unsigned tile_count, tiles_across;    // of it
  unsigned all_tiles;           // of the image
  unsigned next_tile, tiles_done;       // atomic
  unsigned tile_stride;         // timed only: each so many-th is stated
  NSLock *lock;                 // of counters
  struct pilots pilots;         // adaptive only
  struct timed_pixel *timed;    // timed only
  unsigned *tile_shown;         // the number, from 1, of that whose colours of
                                // the first pass it shows
  unsigned char *tile_is_added; // whether its sums have the pass before
  unsigned taken;               // rays through each pixel, in complete passes
  unsigned step;                // in the pass under way
  double pace;                  // seconds of the pass before, by its step
  BOOL is_first_pass;           // through the pixels' points: never in the sums
}

/** Bytes of the stack of a thread that traces so many generations. */
+ (size_t) stackFor: (unsigned)generations;

- (id) init: (id <engine_t>)engine camera: (camera_t *)camera
       into: (image_t *)image options: (struct render_options)options;

/** Computes all pixels of the image's window. */
- (void) run;

/** How much is done, 0 to 1; for a progress bar on another thread. */
- (double) done;

/** Where rays go, of no pixel yet. */
- (struct ray_places) places;

/** What each thread does: takes tiles of the area until there are none left. */
- (void) work;

@end

@interface render_t (timed)

/** Passes over the whole picture until the time is up: the picture of one ray
    through the point of each pixel, and then as many rays through each as there
    is time for, more at once the more there are: those of options.samples (and
    exposure 1) of that number, to the last bit. A pass that is not complete
    does not count; of the first one the missing tiles are filled from those
    beside them. To state the errors is part of the time, once there are two. */
- (void) runTimed;

/** How many rays each pixel has got; 0: not even one each. */
- (unsigned) samplesDone;

@end

@interface render_t (threads)

/** The area to be worked on from now on, none of it done. */
- (void) cover: (struct window)w;

/** Does the work in all threads and waits for them. */
- (void) inThreads: (SEL)work;

/** A tile of the area. */
- (struct window) windowOf: (unsigned)tile;

@end

@interface render_t (adaptive)

/** All pixels of the image's window, with as many rays as each needs. The image
    has the planes PLANE_SAMPLES and PLANE_SAMPLING. */
- (void) runAdaptive;

/** The pixels of a window, at most 32, whose pilots and those around them are
    there. */
- (void) adaptivePixelsOf: (struct window)w
                 counters: (struct counters *)count;

@end
