// A class of one's own is asked by both engines through a ray that is in the
// same media: here one that is met only by rays inside of something.

#import "support.h"

@interface shy_t : sphere_t
@end

@implementation shy_t

- (BOOL) compile: (id)compiler
{
  return NO;
}

/** Met in glass only, and by feelers that start there. */
- (void) hits: (ray_t *)ray
{
  if (ray->media && [[(object_t *)ray->media->object name] isEqual: @"ball"])
    {
      [super hits: ray];
    }
}

@end

int
main(void)
{
  NSAutoreleasePool *pool = [[NSAutoreleasePool alloc] init];
  model_t *model = support_model
    ("camera c { pixeldim 40 40 worlddim 4 4 viewpoint 2 2 6 }\n"
     "background .2 .3 .4\n"
     "light l { location 5 6 4 emissivity 9 9 9 }\n"
     "material glass { alpha .9 ior 1.5 }\n"
     "material paint { ambient 5 1 1 diffuse .8 .8 .8 }\n"
     "material floor { ambient 1 3 1 diffuse .5 .5 .5 }\n"
     "sphere ball { material glass center 2 2 -2 radius 1.4 }\n"
     "shy inside { material paint center 2 2 -2 radius .6 }\n"
     "shy outside { material paint center 3.6 3.6 -1 radius .5 }\n"
     "sphere seen { material floor center 2.3 2.5 -1.2 radius .2 }\n");
  image_t *image = support_picture(model, support_render_options());
  struct k_vec middle = [image pixelAt: 20 : 20]->color;
  unsigned outside = 0;

  for (unsigned i = 0; i < 40 * 40; i++)
    {
      outside += image->surfaces[i].object == 3;
    }
  // Nothing else is red: the background is blue, the other ball green.
  PASS(middle.x > middle.z, "in the glass it is seen: (%g %g %g)",
       middle.x, middle.y, middle.z);
  PASS(outside == 0, "in air it is not: %u pixels", outside);
  [pool release];
  return test_done();
}
