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
  double until;         // above 0: passes of one ray through each pixel until
                        // this time of clock_seconds()
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
  struct k_vec *pass;           // colours of the pass under way; timed only
  unsigned char *tile_is_there; // whether the pass has it
  unsigned passes;              // that are complete
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

@interface render_t (timed)

/** Passes over the whole picture until the time is up: the picture of one ray
    through the point of each pixel, and then as many rays through each as there
    is time for: those of options.samples (and exposure 1) of that number, to
    the last bit. A pass that is not complete does not count; of the first one
    the missing tiles are filled from those beside them. */
- (void) runTimed;

/** How many rays each pixel has got; 0: not even one each. */
- (unsigned) samplesDone;

@end

@interface render_t (threads)

/** Does the work in all threads and waits for them. */
- (void) inThreads: (SEL)work;

@end

@interface render_t (adaptive)

/** The pixels of a window, at most 32, with as many rays as each needs. The
    image has the planes PLANE_SAMPLES and PLANE_SAMPLING. */
- (void) adaptivePixelsOf: (struct window)w
                 counters: (struct counters *)count;

@end
