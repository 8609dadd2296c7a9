// engine_t.h - what render_t asks for the colour of an eye ray: the notes
// engine (notes_t: rays are objects) or the fast one (fast_t: the kernel).
// Both give the same bits.

#import <Foundation/Foundation.h>
#import "image_t.h"
#include "counters.h"

@protocol engine_t <NSObject>

/** The colour that comes back along the eye ray from o along the unit d. Any
    number of threads may ask at once, each with its own counters. */
- (struct k_vec) colorAt: (struct k_vec)o : (struct k_vec)d
                counters: (struct counters *)counters;

/** What that ray hits first. */
- (struct surface_pixel) surfaceAt: (struct k_vec)o : (struct k_vec)d;

@end
