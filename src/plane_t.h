// plane_t.h - an unbounded plane, the surface of the half space behind it:
// `plane name { material … normal … point … }`.

#import "flat_t.h"

@interface plane_t : flat_t <object_t>
@end
