// sphere_t.h - a sphere: `sphere name { material … center … radius … }`.
// Notes, "transmission": both roots are needed, for a ray may come from inside.

#import "object_t.h"

@interface sphere_t : object_t <object_t>
{
@public
  struct k_vec center;
  double radius;        // > 0
}
@end
