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

/** The object of the block that is shown (not autoreleased); nil if its class
    refuses it. */
static id
make_shown(builder_t *self, Class class)
{
  id made = [[class alloc] initWithBlock: self->block];

  if (self->block->is_refused)
    {
      [made release];
      return nil;
    }
  return made;
}

/** The object of a block (not autoreleased); nil if its class refuses it. */
static id
make(builder_t *self, unsigned i, material_t *material)
{
  store_t *store = self->store;

  [self->block show: i material: material];
  return make_shown(self, store->kinds[store->records[i].kind].class);
}

/** The record of the material of that name, or NO_RECORD. */
static unsigned
find(builder_t *self, struct token name)
{
  if (self->last_name.length == 0 || !token_is_same(name, self->last_name))
    {
      self->last_material = [self->store find: KIND_MATERIAL : name];
      self->last_name = name;
      self->last_name.length *= self->last_material != NO_RECORD;
    }
  return self->last_material;
}

/** The material of a record. A faulty one too: it was meant to be there. */
static material_t *
material_of(builder_t *self, unsigned i)
{
  struct record *record = &self->store->records[i];

  if (record->number == 0)
    {
      material_t *material = make(self, i, nil);
      grow((void **)&self->materials, self->material_count,
           &self->material_capacity, sizeof *self->materials);
      self->materials[self->material_count++] = material;
      record->number = self->material_count;
      [self->model->materials setObject: material forKey: material->name];
      [material release];
    }
  return self->materials[record->number - 1];
}

/** The material of an object, whose name is the value of its `material`. nil
    if it does not exist, or another that the object names; for that there is a
    fault when everything is read, unless it may be that of something else. */
static material_t *
material_for(builder_t *self, struct record *record, BOOL is_last)
{
  store_t *store = self->store;
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
      unsigned found = find(self, name);
      if (found != NO_RECORD)
        {
          store->records[found].is_used = YES;
          material = attribute_is_named(a->name, "material")
            ? material_of(self, found) : material;
          continue;
        }
      is_good = NO;
      if (is_last && !store->is_partial && !store->is_nameless
          && [store find: KIND_UNKNOWN : name] == NO_RECORD)
        {
          [self->unknown refuse: value of: record];
        }
    }
  return is_good ? material : nil;
}

/** Gives the objects of the records up to this one their numbers. */
static void
number_up_to(builder_t *self, unsigned end)
{
  for (; self->numbered < end; self->numbered++)
    {
      struct record *record = &self->store->records[self->numbered];
      if (record->kind >= KIND_SHAPES)
        {
          struct object_place place = [self->model keepPlace];
          record->number = place.number;
          record->index = place.index;
        }
    }
}

/** Adds the object of a block to the model, or what the kernel has to know of
    it. NO if its class refuses it. */
static BOOL
add(builder_t *self, unsigned i, material_t *material)
{
  store_t *store = self->store;
  Class class = store->kinds[store->records[i].kind].class;

  [self->block show: i material: material];
  if ([self->model passOn: self->block of: class])
    {
      return YES;
    }

  object_t *object = make_shown(self, class);

  if (object)
    {
      [self->model addObject: object];
      [object release];
    }
  return object != nil;
}

/** Now and then says how many more objects there will be, if the text goes on
    like this. */
static void
foretell(builder_t *self)
{
  unsigned count = self->model->object_count;

  if (count >= FORETOLD_FROM && (count & (count - 1)) == 0)
    {
      [self->model expect: count * (1.05 / [self->text partRead] - 1)];
    }
}

- (BOOL) makeEarly: (unsigned)i
{
  struct record *record = &store->records[i];
  material_t *material = record->kind < KIND_SHAPES || record->is_faulty ? nil
    : material_for(self, record, NO);

  if (material == nil)
    {
      return NO;
    }
  number_up_to(self, i);
  numbered = record->is_known ? i + 1 : i;
  if (!add(self, i, material))
    {
      store->is_sound = NO;     // it will not be any better later
    }
  foretell(self);
  return YES;
}

- (void) makeObject: (unsigned)i
{
  struct record *record = &store->records[i];
  material_t *material = material_for(self, record, YES);
  object_t *object = material && !record->is_faulty
    ? make(self, i, material) : nil;

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
  light_t *light = store->records[i].is_faulty ? nil : make(self, i, nil);

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
      model->camera = make(self, camera, nil);
    }
  if (!store->has_camera && !store->is_partial)
    {
      [diag fault: [text placeAt: [text endOfFirst]]
                 : @"expected a camera in the model, found none"];
    }
  number_up_to(self, store->record_count);
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
          material_of(self, i);
        }
    }
  if (store->is_sound && !store->is_partial)
    {
      [model complete: diag];
    }
}

@end
