#import "block_t.h"
#import "diag_t.h"
#import "names_t.h"
#import "store_t.h"
#import "text_t.h"
#include "attribute_check.h"

@implementation block_t

- (id) init: (store_t *)theStore text: (text_t *)theText
       diag: (diag_t *)theDiag names: (names_t *)theNames
{
  if ((self = [super init]))
    {
      store = theStore;
      text = theText;
      diag = theDiag;
      names = theNames;
    }
  return self;
}

- (void) dealloc
{
  [keyword release];
  [name release];
  [super dealloc];
}

- (void) show: (unsigned)number material: (material_t *)aMaterial
{
  material = aMaterial;
  record = &store->records[number];
  table = store->kinds[record->kind].table;
  is_refused = NO;
  last_attribute = NULL;
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
      name = [token_string(record->name) retain];
    }
  return name;
}

- (unsigned) addName
{
  return [names add: record->name];
}

/** The i-th occurrence of an attribute in a block, or NULL. Asked for one after
    the other they are found one after the other. */
static const struct given *
find_given(block_t *block, const char *attribute, unsigned i)
{
  const struct record *record = block->record;
  const struct given *givens = &block->store->givens[record->given];
  unsigned k = 0, seen = 0;

  if (attribute == block->last_attribute && i >= block->last_occurrence)
    {
      k = block->last_place;
      seen = block->last_occurrence;
    }
  for (; k < record->given_count; k++)
    {
      const char *other = block->table[givens[k].attribute].name;
      if (attribute_is_named(other, attribute) && seen++ == i)
        {
          block->last_attribute = attribute;
          block->last_occurrence = i;
          block->last_place = k;
          return &givens[k];
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
      count += attribute_is_named(table[given[k].attribute].name, attribute);
    }
  return count;
}

- (double) number: (const char *)attribute or: (double)fallback
{
  const struct given *given = find_given(self, attribute, 0);

  return given ? store->values[given->value].number : fallback;
}

- (double) number: (const char *)attribute at: (unsigned)i
{
  const struct given *given = find_given(self, attribute, 0);

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
  const struct given *given = find_given(self, attribute, 0);

  return given ? vector(&store->values[given->value]) : fallback;
}

- (struct k_vec) vector: (const char *)attribute at: (unsigned)i
{
  const struct given *given = find_given(self, attribute, i);

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
  const struct given *given = find_given(self, attribute, 0);

  return given == NULL ? nil
    : token_string(word(&store->values[given->value]));
}

- (material_t *) material
{
  NSAssert(material, @"%@ has no material", [self keyword]);
  return material;
}

- (struct place) place
{
  return [text placeAt: record->order];
}

- (struct place) placeOf: (const char *)attribute at: (unsigned)i
{
  const struct given *given = find_given(self, attribute, i);

  NSAssert(given, @"%s was not given", attribute);
  return [text placeAt: given->order];
}

- (struct place) placeOfValue: (const char *)attribute at: (unsigned)i
{
  const struct given *given = find_given(self, attribute, 0);

  NSAssert(given, @"%s was not given", attribute);

  unsigned n = attribute_values(&table[given->attribute]);

  given = find_given(self, attribute, i / n);
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
