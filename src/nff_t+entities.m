#import "nff_t.h"
#import "diag_t.h"
#include "attribute_check.h"

@implementation nff_t (entities)

- (struct record *) begin: (unsigned)kind : (const char *)prefix
                         : (unsigned)number
{
  unsigned order = cursor_order(&text->cursor, letter.at);
  struct token name = [store make: prefix : number];
  struct record *record = [store begin: kind at: order name: name at: order];
  // Where there is no other file nobody else gives names to objects.
  BOOL is_unique = kind >= KIND_SHAPES && [text depth] == 0;
  unsigned other = is_unique ? NO_RECORD : [store enter];

  if (other != NO_RECORD)
    {
      record->is_faulty = YES;
      FAULT(letter.at, @"the name of this %@, %@, is taken at %@",
            token_string(store->kinds[kind].word), token_string(name),
            [diag nameOf: [text placeAt: store->records[other].name_order]]);
    }
  return record;
}

void
nff_give(nff_t *self, const char *name, const struct value *values)
{
  store_t *store = self->store;
  unsigned kind = store->records[store->record_count - 1].kind;
  const struct attribute *a = store->kinds[kind].table;

  while (!attribute_is_named(a->name, name))
    {
      a++;
    }
  store_give(store, a, values[0].order, values);
}

- (struct value) valueOf: (struct token)word
{
  return (struct value){ .word = word.at, .length = (unsigned)word.length,
                         .order = cursor_order(&text->cursor, letter.at) };
}

- (const char *) at: (const struct value *)value
{
  return text->cursor.text + (value->order - text->cursor.shift);
}

/** A letter that NFF does not have, or that nothing is made of. */
- (BOOL) refuse
{
  BOOL is_number = [self isNumber: letter];

  FAULT(letter.at, @"%s %@; expected v, b, l, f, s, p or pp",
        token_is(letter, "c") ? "no shape for the cone"
        : is_number ? "one number too many:"
        : "unknown entity", [self quote: letter]);
  if (is_number && store->record_count > 0)
    {
      store->records[store->record_count - 1].is_faulty = YES;
    }
  [self resume];
  [self skipView];      // if that was to be the v
  return NO;
}

- (BOOL) isEntity: (struct token)t
{
  static const char *const letters[] = {
    "v", "b", "l", "f", "s", "p", "pp", "c"
  };

  for (unsigned i = 0; i < sizeof letters / sizeof *letters; i++)
    {
      if (token_is(t, letters[i]))
        {
          return YES;
        }
    }
  return NO;
}

- (BOOL) readEntity
{
  return token_is(letter, "s") ? [self readSphere]
    : token_is(letter, "p") ? [self readPolygon: NO]
    : token_is(letter, "pp") ? [self readPolygon: YES]
    : token_is(letter, "f") ? [self readFill]
    : token_is(letter, "l") ? [self readLight]
    : token_is(letter, "v") ? [self readView]
    : token_is(letter, "b") ? [self readBackground]
    : [self refuse];
}

@end
