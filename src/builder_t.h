// builder_t.h - makes a model of the blocks of a store: materials first, then
// the camera, lights and objects in the order of the text.

#import "model_t.h"
#import "store_t.h"
#import "text_t.h"

@class block_t, diag_t, unknown_t;

@interface builder_t : NSObject
{
  store_t *store;               // these four are not retained: they live
  text_t *text;                 // as long as the load
  diag_t *diag;
  model_t *model;
  block_t *block;
  material_t **materials;       // per record of the store
  unknown_t *unknown;
}

- (id) init: (store_t *)store text: (text_t *)text diag: (diag_t *)diag;

/** Fills and completes the model. Blocks with a fault are left out; if there
    are any, or have been, the model is not to be used. */
- (void) build: (model_t *)model;

@end
