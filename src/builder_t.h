// builder_t.h - makes a model of the blocks of a store. An object is made as
// soon as it is read, if its material is there; the rest when everything is
// read, in the order of the text. Numbers follow that order all the same.

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
  material_t **materials;       // those made, by the numbers of their records
  unsigned material_count, material_capacity;
  unsigned numbered;            // objects of the records before this one have
                                // their numbers
  struct token last_name;       // of the material that was used last, and
  unsigned last_material;       // its record
  unknown_t *unknown;
}

/** Fills that model. */
- (id) init: (store_t *)store text: (text_t *)text diag: (diag_t *)diag
      model: (model_t *)model;

/** Makes the object of the last record. NO if that is not one, or cannot be
    made yet. */
- (BOOL) makeEarly: (unsigned)record;

/** Makes what is not made yet and completes the model. Blocks with a fault are
    left out; if there are any, or have been, the model is not to be used. */
- (void) build;

@end
