// explain_t.h - --explain: the notes engine with rays that remember, and the
// text that is made of them.

#import "image_t.h"
#import "notes_t.h"

// As many rays of a pixel are explained at most.
#define EXPLAIN_MOST 4096

@interface explain_t : notes_t
{
  NSMutableArray *rays;         // eye rays, as they were traced
}

/** What the rays that were traced so far saw, which are all of one pixel, the
    only one of the picture, and its colour as it was rendered
    (autoreleased). The same text from every build. */
- (NSString *) textOf: (image_t *)image;

@end
