// flat_t.h - what is flat: planes and polygons. Flat objects that lie in one
// plane share its numbers, so that a ray meets all of them at the same t and
// the one declared first is seen, everywhere.

#import "object_t.h"
#include "kernel/k_plane_hit.h"

@interface flat_t : object_t
{
@public
  struct k_plane plane;
}

/** Whether all of the object lies in `other`, as near as can be told. */
- (BOOL) liesIn: (const struct k_plane *)other;

/** Takes over a plane that it lies in. */
- (void) takePlane: (struct k_plane)shared;

/** A length that is the larger the better the object knows its plane. */
- (double) extent;

@end
