// engine_t.h - what render_t asks for the colour of an eye ray: the notes
// engine (notes_t: rays are objects) or the fast one (fast_t: the kernel).
// Both give the same bits.

#import <Foundation/Foundation.h>
#import "image_t.h"
#include "counters.h"
#include "eye_ray.h"

@protocol engine_t <NSObject>

/** The colours that come back along eye rays; best EYE_RAYS at once, that go
    much the same way. Any number of threads may ask at once, each with its own
    counters. */
- (void) trace: (struct eye_ray *)rays : (unsigned)count
      counters: (struct counters *)counters;

/** What an eye ray from o along the unit d hits first. */
- (struct surface_pixel) surfaceAt: (struct k_vec)o : (struct k_vec)d;

@end
