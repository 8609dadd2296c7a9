// notes_t.h - the notes engine: an object for every ray.

#import "engine_t.h"

@class model_t, ray_t;

@interface notes_t : NSObject <engine_t>
{
  model_t *model;
}

- (id) initWithModel: (model_t *)aModel;

/** What its rays are: ray_t, or a subclass. */
- (Class) rayClass;

/** A ray from the eye, from o along the unit d, in the media there (not
    autoreleased). */
- (ray_t *) rayAt: (struct k_vec)o : (struct k_vec)d;

@end
