// block_t.h - one block of a model file, `keyword name { attribute values }`,
// read and checked against its class's table of attributes. A class asks it
// for values in its initWithBlock:. All values are there and in range by
// then: a block with a fault never gets that far. (A material's own faulty
// attributes are as if they were not given.) The block is a view: it shows
// one block now and another one later.

#import <Foundation/Foundation.h>
#include "attribute.h"
#include "place.h"
#include "kernel/k_vec.h"

@class diag_t, material_t, names_t, store_t, text_t;

@interface block_t : NSObject
{
@public
  BOOL is_refused;              // the class has noted a fault
  names_t *names;               // of the model
@protected
  store_t *store;               // these three are not retained: they live
  text_t *text;                 // as long as the load
  diag_t *diag;
  material_t *material;         // of the block that is shown
  struct record *record;        // the one that is shown
  const struct attribute *table;
  NSString *keyword, *name;     // of that, when they have been asked for
  const char *last_attribute;   // what was looked up last, where it was and
  unsigned last_occurrence, last_place; // which time it was given
}

/** A view of the store's blocks; show: chooses one and says which material
    its attribute `material` names. */
- (id) init: (store_t *)store text: (text_t *)text diag: (diag_t *)diag
      names: (names_t *)names;
- (void) show: (unsigned)record material: (material_t *)material;

/** The word before the name: "sphere". */
- (NSString *) keyword;

/** The block's name, unique per keyword. */
- (NSString *) name;

/** Adds it to the model's names; where it is there. */
- (unsigned) addName;

/** How often an attribute was given: 0 or 1, more for a repeated one. */
- (unsigned) count: (const char *)attribute;

/** The number after an attribute, the default if it was not given. */
- (double) number: (const char *)attribute or: (double)fallback;

/** The i-th number after an attribute that was given. */
- (double) number: (const char *)attribute at: (unsigned)i;

/** The point, vector or colour after an attribute; `fallback` if it was not
    given. */
- (struct k_vec) vector: (const char *)attribute or: (struct k_vec)fallback;

/** The point that the attribute has where it is given for the i-th time. */
- (struct k_vec) vector: (const char *)attribute at: (unsigned)i;

/** The word or name after an attribute (autoreleased); nil if it was not
    given. */
- (NSString *) word: (const char *)attribute;

/** The material that the attribute `material` names. Owned by the model. */
- (material_t *) material;

/** Where the block's keyword stands. */
- (struct place) place;

/** Where the i-th occurrence of an attribute's name stands. */
- (struct place) placeOf: (const char *)attribute at: (unsigned)i;

/** Where the i-th value of an attribute stands, counted through all its
    occurrences: the third vertex's z is value 8. */
- (struct place) placeOfValue: (const char *)attribute at: (unsigned)i;

/** Notes a fault that only the class itself can see. */
- (void) fault: (struct place)place : (NSString *)format, ...
  __attribute__((format(NSString, 2, 3)));

/** Notes a warning that only the class itself can see. */
- (void) warn: (struct place)place : (NSString *)format, ...
  __attribute__((format(NSString, 2, 3)));

@end
