// plan_t.h - what a scene requires, before anything is traced: what it has,
// which work is left out since nothing in it asks for that, what it takes of
// memory, how many rays it will be. --plan shows it.

#import "fast_t.h"
#import "image_t.h"
#import "render_t.h"

@interface plan_t : NSObject

/** The plan as lines for people (autoreleased). The rays are estimated from
    one pixel in 256. */
+ (NSString *) of: (model_t *)model engine: (fast_t *)engine
           window: (struct window)window
          options: (struct render_options)options depth: (unsigned)depth;

@end
