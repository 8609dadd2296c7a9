// store_t.h - all blocks of a model as they were read: plain arrays, filled
// once by a reader and read by block_t. Words are pieces of the text, which
// has to live as long; a place is an order in it (text_t.h).

#import <Foundation/Foundation.h>
#include "attribute.h"
#include "kernel/k_vec.h"
#include "token.h"

@class builder_t;

/** A block word. Numbers of kinds: see below, the shapes follow. */
struct kind
{
  struct token word;
  Class class;
  const struct attribute *table;
};

enum
{
  KIND_UNKNOWN,         // blocks of this kind are there for their names only
  KIND_CAMERA,
  KIND_LIGHT,
  KIND_MATERIAL,
  KIND_SHAPES
};

/** One value after an attribute. */
struct value
{
  union
  {
    double number;
    const char *word;
  };
  unsigned length;      // of the word
  unsigned order;
};

/** One attribute that was given. */
struct given
{
  unsigned attribute;   // its number in the table
  unsigned order;
  unsigned value;       // number of its first value
};

/** One block. */
struct record
{
  unsigned kind;
  unsigned order;       // of the keyword
  struct token name;    // of length 0: there is none
  unsigned name_order;
  unsigned given;       // number of the first attribute given
  unsigned given_count;
  unsigned number;      // of the object, or of the material among those made;
                        // 0: not known yet
  unsigned index;       // of the object, see model_t's object_place
  BOOL is_faulty;
  BOOL is_known;        // by its name
  BOOL is_used;         // this material, by an object that is made
  BOOL is_made;         // this object: its attributes are gone
};

#define NO_RECORD UINT_MAX

@interface store_t : NSObject
{
@public
  struct kind *kinds;
  struct record *records;
  struct given *givens;
  struct value *values;
  unsigned kind_count, record_count, given_count, value_count;
  struct k_vec background;
  BOOL has_background;
  unsigned background_order;
  unsigned camera;      // the first one, or NO_RECORD
  BOOL has_camera;      // or something that was meant to be one
  BOOL is_partial;      // a file is missing: what is not there may be in it
  BOOL is_nameless;     // a material has no name: it may be one that is sought
  BOOL is_sound;        // no fault that may make a shape incomplete
  builder_t *builder;   // makes objects as they are read; not retained; nil:
                        // all blocks are kept
@protected
  unsigned kind_capacity, record_capacity, given_capacity, value_capacity;
  struct name *names;   // hash table of records by kind and name
  unsigned name_count, name_mask;
  NSMutableArray *made_words;   // pieces of memory
  char *made;                   // the last of them
  size_t made_length;
  struct token unknown; // the last word that is no kind
}

/** The kind that a block word means; KIND_UNKNOWN if it means none. */
- (unsigned) kindFor: (struct token)word;

/** All block words, for suggestions (autoreleased). */
- (NSArray *) words;

/** Adds a block without attributes: the last record from now on. */
- (struct record *) begin: (unsigned)kind at: (unsigned)order
                     name: (struct token)name at: (unsigned)name_order;

/** Says that all of the last record is there. If it is an object that can be
    made now, it is, and its values are given back; so is the record if it is
    not known by its name. */
- (void) end;

/** Makes the last record known by its name. If there is one of that kind and
    name already, that stays and is returned; otherwise NO_RECORD. */
- (unsigned) enter;

/** Notes a name that may have been meant for a block: who asks for it must not
    be told that there is none. */
- (void) noteName: (struct token)word;

/** Gives back what only names of shapes need, when all is read: none of them
    is found from now on. */
- (void) forgetShapes;

/** The record of that kind and name; NO_RECORD if there is none. */
- (unsigned) find: (unsigned)kind : (struct token)name;

/** A word that no text has: prefix and number. */
- (struct token) make: (const char *)prefix : (unsigned)number;

@end

/** Adds an attribute with its values to the last record. */
void store_give(store_t *store, const struct attribute *a, unsigned order,
                const struct value *values);
