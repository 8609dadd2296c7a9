// notes_t.h - the notes engine: an object for every ray.

#import "engine_t.h"

@class model_t;

@interface notes_t : NSObject <engine_t>
{
  model_t *model;
}

- (id) initWithModel: (model_t *)aModel;

@end
