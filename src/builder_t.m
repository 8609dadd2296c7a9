#import "builder_t.h"
#import "block_t.h"
#import "camera_t.h"
#import "diag_t.h"
#import "light_t.h"
#import "material_t.h"
#import "unknown_t.h"
#include "grow.h"

@implementation builder_t

- (id) init: (store_t *)theStore text: (text_t *)theText
       diag: (diag_t *)theDiag
{
  if ((self = [super init]))
    {
      store = theStore;
      text = theText;
      diag = theDiag;
      materials = new_array(store->record_count + 1, sizeof *materials);
      block = [[block_t alloc] init: store text: text diag: diag
                          materials: materials];
      unknown = [[unknown_t alloc] init: store text: text diag: diag];
    }
  return self;
}

- (void) dealloc
{
  free(materials);
  [block release];
  [unknown release];
  [super dealloc];
}

/** Whether the materials that a block names exist. A fault if not, unless
    that may be the fault of something else. */
- (BOOL) resolve: (struct record *)record
{
  const struct attribute *table = store->kinds[record->kind].table;
  const struct given *given = &store->givens[record->given];
  BOOL is_good = YES;

  for (unsigned i = 0; i < record->given_count; i++)
    {
      if (table[given[i].attribute].kind == ATTRIBUTE_MATERIAL)
        {
          struct value value = store->values[given[i].value];
          struct token name = { value.word, value.length };
          if ([store find: KIND_MATERIAL : name] == NO_RECORD)
            {
              is_good = NO;
              if (!store->is_partial && !store->is_nameless
                  && [store find: KIND_UNKNOWN : name] == NO_RECORD)
                {
                  [unknown refuse: value of: record];
                }
            }
        }
    }
  return is_good;
}

/** The object of a block (not autoreleased); nil if its class refuses it. */
- (id) make: (unsigned)i
{
  [block show: i];

  id made = [[store->kinds[store->records[i].kind].class alloc]
              initWithBlock: block];

  if (block->is_refused)
    {
      [made release];
      return nil;
    }
  return made;
}

- (void) makeMaterials
{
  for (unsigned i = 0; i < store->record_count; i++)
    {
      // A faulty one too: it was meant to be there.
      if (store->records[i].kind == KIND_MATERIAL)
        {
          materials[i] = [self make: i];
          [model->materials setObject: materials[i]
                               forKey: materials[i]->name];
          [materials[i] release];
        }
    }
}

- (void) makeObject: (unsigned)i
{
  struct record *record = &store->records[i];
  BOOL is_good = [self resolve: record] && !record->is_faulty;
  object_t *object = is_good ? [self make: i] : nil;

  if (object == nil)
    {
      store->is_sound = NO;
      return;
    }
  [model addObject: object];
  [object release];
}

- (void) makeLight: (unsigned)i
{
  light_t *light = store->records[i].is_faulty ? nil : [self make: i];

  if (light)
    {
      [model addLight: light];
      [light release];
    }
}

- (void) build: (model_t *)theModel
{
  unsigned camera = store->camera;

  [store forgetShapes];
  model = theModel;
  model->background = store->background;
  [self makeMaterials];
  if (camera != NO_RECORD && !store->records[camera].is_faulty)
    {
      model->camera = [self make: camera];
    }
  if (!store->has_camera && !store->is_partial)
    {
      [diag fault: [text placeAt: [text endOfFirst]]
                 : @"expected a camera in the model, found none"];
    }
  for (unsigned i = 0; i < store->record_count; i++)
    {
      unsigned kind = store->records[i].kind;
      if (kind >= KIND_SHAPES)
        {
          [self makeObject: i];
        }
      else if (kind == KIND_LIGHT)
        {
          [self makeLight: i];
        }
    }
  if (store->is_sound && !store->is_partial)
    {
      [model complete: diag];
    }
}

@end
