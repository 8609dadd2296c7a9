#import "builder_t.h"
#import "block_t.h"
#import "camera_t.h"
#import "diag_t.h"
#import "light_t.h"
#import "material_t.h"
#import "names_t.h"
#import "unknown_t.h"
#include "attribute_check.h"
#include "grow.h"

#define FORETOLD_FROM 1024      // objects

@implementation builder_t

- (id) init: (store_t *)theStore text: (text_t *)theText
       diag: (diag_t *)theDiag model: (model_t *)theModel
{
  if ((self = [super init]))
    {
      store = theStore;
      text = theText;
      diag = theDiag;
      model = theModel;
      block = [[block_t alloc] init: store text: text diag: diag
                              names: model->names];
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

/** The object of a block (not autoreleased); nil if its class refuses it. */
- (id) make: (unsigned)i of: (material_t *)material
{
  [block show: i material: material];

  id made = [[store->kinds[store->records[i].kind].class alloc]
              initWithBlock: block];

  if (block->is_refused)
    {
      [made release];
      return nil;
    }
  return made;
}

/** The record of the material of that name, or NO_RECORD. */
- (unsigned) find: (struct token)name
{
  if (last_name.length == 0 || !token_is_same(name, last_name))
    {
      last_material = [store find: KIND_MATERIAL : name];
      last_name = name;
      last_name.length *= last_material != NO_RECORD;
    }
  return last_material;
}

/** The material of a record. A faulty one too: it was meant to be there. */
- (material_t *) materialOf: (unsigned)i
{
  struct record *record = &store->records[i];

  if (record->number == 0)
    {
      material_t *material = [self make: i of: nil];
      grow((void **)&materials, material_count, &material_capacity,
           sizeof *materials);
      materials[material_count++] = material;
      record->number = material_count;
      [model->materials setObject: material forKey: material->name];
      [material release];
    }
  return materials[record->number - 1];
}

/** The material of an object, whose name is the value of its `material`. nil
    if it does not exist, or another that the object names; for that there is a
    fault when everything is read, unless it may be that of something else. */
- (material_t *) materialFor: (struct record *)record isLast: (BOOL)is_last
{
  const struct attribute *table = store->kinds[record->kind].table;
  const struct given *given = &store->givens[record->given];
  material_t *material = nil;
  BOOL is_good = YES;

  for (unsigned i = 0; i < record->given_count; i++)
    {
      const struct attribute *a = &table[given[i].attribute];
      if (a->kind != ATTRIBUTE_MATERIAL)
        {
          continue;
        }
      struct value value = store->values[given[i].value];
      struct token name = { value.word, value.length };
      unsigned found = [self find: name];
      if (found != NO_RECORD)
        {
          store->records[found].is_used = YES;
          material = attribute_is_named(a->name, "material")
            ? [self materialOf: found] : material;
          continue;
        }
      is_good = NO;
      if (is_last && !store->is_partial && !store->is_nameless
          && [store find: KIND_UNKNOWN : name] == NO_RECORD)
        {
          [unknown refuse: value of: record];
        }
    }
  return is_good ? material : nil;
}

/** Gives the objects of the records up to this one their numbers. */
- (void) numberUpTo: (unsigned)end
{
  for (; numbered < end; numbered++)
    {
      if (store->records[numbered].kind >= KIND_SHAPES)
        {
          struct object_place place = [model keepPlace];
          store->records[numbered].number = place.number;
          store->records[numbered].index = place.index;
        }
    }
}

/** Adds an object to the model; now and then says how many more there will be,
    if the text goes on like this. */
- (void) add: (object_t *)object from: (unsigned)names_end
{
  unsigned count;

  if (![model addObject: object])
    {
      [model->names forgetFrom: names_end];
    }
  count = model->object_count;
  if (count >= FORETOLD_FROM && (count & (count - 1)) == 0)
    {
      [model expect: count * (1.05 / [text partRead] - 1)];
    }
}

- (BOOL) makeEarly: (unsigned)i
{
  struct record *record = &store->records[i];
  material_t *material = record->kind < KIND_SHAPES || record->is_faulty ? nil
    : [self materialFor: record isLast: NO];

  if (material == nil)
    {
      return NO;
    }
  [self numberUpTo: i];

  unsigned names_end = [model->names end];
  object_t *object = [self make: i of: material];

  numbered = record->is_known ? i + 1 : i;
  if (object == nil)
    {
      store->is_sound = NO;
      return YES;               // it will not be any better later
    }
  [self add: object from: names_end];
  [object release];
  return YES;
}

- (void) makeObject: (unsigned)i
{
  struct record *record = &store->records[i];
  material_t *material = [self materialFor: record isLast: YES];
  object_t *object = material && !record->is_faulty
    ? [self make: i of: material] : nil;

  if (object == nil)
    {
      store->is_sound = NO;
      return;
    }
  struct object_place place = { record->number, record->index };
  [model put: object at: place];
  [object release];
}

- (void) makeLight: (unsigned)i
{
  light_t *light = store->records[i].is_faulty ? nil : [self make: i of: nil];

  if (light)
    {
      [model addLight: light];
      [light release];
    }
}

- (void) build
{
  unsigned camera = store->camera;

  [store forgetShapes];
  model->background = store->background;
  if (camera != NO_RECORD && !store->records[camera].is_faulty)
    {
      model->camera = [self make: camera of: nil];
    }
  if (!store->has_camera && !store->is_partial)
    {
      [diag fault: [text placeAt: [text endOfFirst]]
                 : @"expected a camera in the model, found none"];
    }
  [self numberUpTo: store->record_count];
  for (unsigned i = 0; i < store->record_count; i++)
    {
      unsigned kind = store->records[i].kind;
      if (kind >= KIND_SHAPES && !store->records[i].is_made)
        {
          [self makeObject: i];
        }
      else if (kind == KIND_LIGHT)
        {
          [self makeLight: i];
        }
      else if (kind == KIND_MATERIAL)
        {
          [self materialOf: i];
        }
    }
  if (store->is_sound && !store->is_partial)
    {
      [model complete: diag];
    }
}

@end
