#import "block_t.h"
#import "diag_t.h"
#import "store_t.h"
#import "text_t.h"
#include "attribute_check.h"

@implementation block_t

- (id) init: (store_t *)theStore text: (text_t *)theText
       diag: (diag_t *)theDiag materials: (material_t **)theMaterials
{
  if ((self = [super init]))
    {
      store = theStore;
      text = theText;
      diag = theDiag;
      materials = theMaterials;
    }
  return self;
}

- (void) dealloc
{
  [keyword release];
  [name release];
  [super dealloc];
}

- (void) show: (unsigned)number
{
  record = &store->records[number];
  table = store->kinds[record->kind].table;
  is_refused = NO;
  [keyword release];
  [name release];
  keyword = name = nil;
}

- (NSString *) keyword
{
  if (keyword == nil)
    {
      keyword = [token_string(store->kinds[record->kind].word) retain];
    }
  return keyword;
}

- (NSString *) name
{
  if (name == nil)
    {
      name = [[NSString alloc] initWithBytes: record->name.at
                                length: record->name.length
                              encoding: NSUTF8StringEncoding];
    }
  return name;
}

/** The i-th occurrence of an attribute, or NULL. */
- (const struct given *) given: (const char *)attribute at: (unsigned)i
{
  const struct given *given = &store->givens[record->given];

  for (unsigned k = 0; k < record->given_count; k++, given++)
    {
      const char *other = table[given->attribute].name;
      if ((other == attribute || strcmp(other, attribute) == 0) && i-- == 0)
        {
          return given;
        }
    }
  return NULL;
}

- (unsigned) count: (const char *)attribute
{
  const struct given *given = &store->givens[record->given];
  unsigned count = 0;

  for (unsigned k = 0; k < record->given_count; k++)
    {
      count += strcmp(table[given[k].attribute].name, attribute) == 0;
    }
  return count;
}

- (double) number: (const char *)attribute or: (double)fallback
{
  const struct given *given = [self given: attribute at: 0];

  return given ? store->values[given->value].number : fallback;
}

- (double) number: (const char *)attribute at: (unsigned)i
{
  const struct given *given = [self given: attribute at: 0];

  NSAssert(given, @"%s was not given", attribute);
  return store->values[given->value + i].number;
}

static struct k_vec
vector(const struct value *values)
{
  return k_vec(values[0].number, values[1].number, values[2].number);
}

- (struct k_vec) vector: (const char *)attribute or: (struct k_vec)fallback
{
  const struct given *given = [self given: attribute at: 0];

  return given ? vector(&store->values[given->value]) : fallback;
}

- (struct k_vec) vector: (const char *)attribute at: (unsigned)i
{
  const struct given *given = [self given: attribute at: i];

  NSAssert(given, @"%s was not given", attribute);
  return vector(&store->values[given->value]);
}

static struct token
word(const struct value *value)
{
  return (struct token){ value->word, value->length };
}

- (NSString *) word: (const char *)attribute
{
  const struct given *given = [self given: attribute at: 0];

  return given == NULL ? nil
    : token_string(word(&store->values[given->value]));
}

- (material_t *) material
{
  const struct given *given = [self given: "material" at: 0];

  NSAssert(given, @"%@ has no material", [self keyword]);
  return materials[[store find: KIND_MATERIAL
                              : word(&store->values[given->value])]];
}

- (struct place) place
{
  return [text placeAt: record->order];
}

- (struct place) placeOf: (const char *)attribute at: (unsigned)i
{
  const struct given *given = [self given: attribute at: i];

  NSAssert(given, @"%s was not given", attribute);
  return [text placeAt: given->order];
}

- (struct place) placeOfValue: (const char *)attribute at: (unsigned)i
{
  const struct given *given = [self given: attribute at: 0];

  NSAssert(given, @"%s was not given", attribute);

  unsigned n = attribute_values(&table[given->attribute]);

  given = [self given: attribute at: i / n];
  return [text placeAt: store->values[given->value + i % n].order];
}

- (void) fault: (struct place)place : (NSString *)format, ...
{
  va_list values;

  va_start(values, format);
  NSString *message = [[NSString alloc] initWithFormat: format
                                             arguments: values];
  va_end(values);
  [diag fault: place : @"%@", message];
  [message release];
  is_refused = YES;
}

- (void) warn: (struct place)place : (NSString *)format, ...
{
  va_list values;

  va_start(values, format);
  NSString *message = [[NSString alloc] initWithFormat: format
                                             arguments: values];
  va_end(values);
  [diag warn: place : @"%@", message];
  [message release];
}

@end
