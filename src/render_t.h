// render_t.h - computes a picture: tiles, threads, samples. A pixel depends
// on the model, the options and its own place only, so neither the threads
// nor the tiles nor the crop change a bit of it.

#import <Foundation/Foundation.h>
#import "engine_t.h"
#include "ray_places.h"

struct render_options
{
  unsigned threads;     // at least 1
  uint64_t seed;
  unsigned samples;     // rays through each pixel; 1: through its point
  enum sampler sampler;
  double noise;         // above 0: as many rays, until the error that a pixel
                        // states is at most this; owen or random
  double errors;        // such an error is this many standard errors
  unsigned max_samples; // or no more than so many rays
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
  unsigned tile_count, tiles_across;
  unsigned next_tile, tiles_done;       // atomic
  NSLock *lock;                 // of counters
}

- (id) init: (id <engine_t>)engine camera: (camera_t *)camera
       into: (image_t *)image options: (struct render_options)options;

/** Computes all pixels of the image's window. */
- (void) run;

/** How much is done, 0 to 1; for a progress bar on another thread. */
- (double) done;

/** Where rays go, of no pixel yet. */
- (struct ray_places) places;

@end

@interface render_t (adaptive)

/** The pixels of a window, at most 32, with as many rays as each needs. The
    image has the planes PLANE_SAMPLES and PLANE_SAMPLING. */
- (void) adaptivePixelsOf: (struct window)w
                 counters: (struct counters *)count;

@end
