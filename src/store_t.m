#import "store_t.h"
#import "builder_t.h"
#import "camera_t.h"
#import "light_t.h"
#import "material_t.h"
#import "registry_t.h"
#include "attribute_check.h"
#include "grow.h"

#define MADE_WORDS (1 << 16)     // bytes in one block of made words
#define MOST_DIGITS 10          // of an unsigned number

/** A place in the hash table; record NO_RECORD: empty. */
struct name
{
  unsigned hash;
  unsigned record;
};

@implementation store_t

- (void) addKind: (struct token)word class: (Class)class
{
  struct kind kind = { word, class, [class attributes] };

  grow((void **)&kinds, kind_count, &kind_capacity, sizeof kind);
  kinds[kind_count++] = kind;
}

- (id) init
{
  if ((self = [super init]))
    {
      is_sound = YES;
      camera = NO_RECORD;
      made_words = [NSMutableArray new];
      made_length = MADE_WORDS;
      [self addKind: (struct token){ "", 0 } class: Nil];
      [self addKind: (struct token){ "camera", 6 } class: [camera_t class]];
      [self addKind: (struct token){ "light", 5 } class: [light_t class]];
      [self addKind: (struct token){ "material", 8 }
              class: [material_t class]];
      // Never NULL: the place of the first attribute of none is asked for.
      grow((void **)&givens, 0, &given_capacity, sizeof *givens);
      grow((void **)&values, 0, &value_capacity, sizeof *values);
    }
  return self;
}

- (void) dealloc
{
  free(kinds);
  free(records);
  free(givens);
  free(values);
  NSZoneFree(NULL, names);
  [made_words release];
  [super dealloc];
}

/** Whether a word can be part of a class's name. */
static BOOL
is_identifier(struct token word)
{
  for (size_t i = 0; i < word.length; i++)
    {
      char c = word.at[i];
      if (!((c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z')
            || (c >= '0' && c <= '9') || c == '_'))
        {
          return NO;
        }
    }
  return word.length > 0 && word.length <= LONGEST_WORD;
}

- (unsigned) kindFor: (struct token)word
{
  for (unsigned i = KIND_CAMERA; i < kind_count; i++)
    {
      if (token_is_same(kinds[i].word, word))
        {
          return i;
        }
    }
  if (!is_identifier(word)
      || (unknown.at && token_is_same(unknown, word)))
    {
      return KIND_UNKNOWN;
    }

  NSAutoreleasePool *pool = [NSAutoreleasePool new];
  Class class = [registry_t shapeForWord: token_string(word)];

  [pool drain];
  if (class == Nil)
    {
      unknown = word;
      return KIND_UNKNOWN;
    }
  [self addKind: word class: class];
  return kind_count - 1;
}

- (NSArray *) words
{
  return [[NSArray arrayWithObjects: @"camera", @"light", @"material", nil]
           arrayByAddingObjectsFromArray: [registry_t words]];
}

- (struct record *) begin: (unsigned)kind at: (unsigned)order
                     name: (struct token)name at: (unsigned)name_order
{
  struct record record = {
    .kind = kind, .order = order, .name = name, .name_order = name_order,
    .given = given_count
  };

  grow((void **)&records, record_count, &record_capacity, sizeof record);
  records[record_count] = record;
  return &records[record_count++];
}

void
store_give(store_t *self, const struct attribute *a, unsigned order,
           const struct value *values)
{
  struct record *record = &self->records[self->record_count - 1];
  unsigned n = attribute_values(a);
  struct given given = {
    (unsigned)(a - self->kinds[record->kind].table), order, self->value_count
  };

  grow((void **)&self->givens, self->given_count, &self->given_capacity,
       sizeof given);
  self->givens[self->given_count++] = given;
  record->given_count++;
  while (self->value_capacity - self->value_count < n)
    {
      grow((void **)&self->values, self->value_capacity,
           &self->value_capacity, sizeof *values);
    }
  for (unsigned i = 0; i < n; i++)
    {
      self->values[self->value_count++] = values[i];
    }
}

- (void) end
{
  struct record *record = &records[record_count - 1];

  if (![builder makeEarly: record_count - 1])
    {
      return;
    }
  record->is_made = YES;
  if (record->given_count > 0)
    {
      value_count = givens[record->given].value;
    }
  given_count = record->given;
  record->given_count = 0;
  if (!record->is_known)
    {
      if (record->name.at + record->name.length == made + made_length)
        {
          made_length -= record->name.length;
        }
      record_count--;
    }
}

/** FNV-1a of all but the last character, its bits mixed once more; the last
    character is the lowest bits. So s10, s11 … s19, which usually come one
    after the other, are near each other in memory. */
static unsigned
hash_of(unsigned kind, struct token name)
{
  unsigned hash = 2166136261u ^ kind;

  if (name.length == 0)
    {
      return hash;
    }
  for (size_t i = 0; i < name.length - 1; i++)
    {
      hash = (hash ^ (unsigned char)name.at[i]) * 16777619u;
    }
  hash = (hash ^ hash >> 16) * 0x85EBCA6Bu;
  hash ^= hash >> 13;
  return hash << 4 | (name.at[name.length - 1] & 15);
}

/** Where the name is in the table, or where it would be. */
- (struct name *) slotFor: (unsigned)kind : (struct token)word
                     hash: (unsigned)hash
{
  for (unsigned i = hash & name_mask;; i = (i + 1) & name_mask)
    {
      if (names[i].record == NO_RECORD)
        {
          return &names[i];
        }
      if (names[i].hash == hash)
        {
          struct record *record = &records[names[i].record];
          if (record->kind == kind && token_is_same(record->name, word))
            {
              return &names[i];
            }
        }
    }
}

/** Makes the table twice as large. */
- (void) growNames
{
  struct name *old = names;
  unsigned old_size = old ? name_mask + 1 : 0, size = old ? 2 * old_size : 64;

  names = NSZoneMalloc(NULL, size * sizeof *names);
  memset(names, 0xFF, size * sizeof *names);
  name_mask = size - 1;
  for (unsigned i = 0; i < old_size; i++)
    {
      unsigned slot = old[i].hash & name_mask;
      while (old[i].record != NO_RECORD && names[slot].record != NO_RECORD)
        {
          slot = (slot + 1) & name_mask;
        }
      names[slot] = old[i];
    }
  NSZoneFree(NULL, old);
}

- (unsigned) enter: (unsigned)number
{
  struct record *record = &records[number];
  unsigned hash = hash_of(record->kind, record->name);

  if (2 * name_count >= name_mask)
    {
      [self growNames];
    }

  struct name *slot = [self slotFor: record->kind : record->name hash: hash];

  if (slot->record == NO_RECORD)
    {
      slot->hash = hash;
      slot->record = number;
      name_count++;
      return NO_RECORD;
    }
  return slot->record;
}

- (unsigned) enter
{
  records[record_count - 1].is_known = YES;
  return [self enter: record_count - 1];
}

- (void) forgetShapes
{
  NSZoneFree(NULL, names);
  names = NULL;
  name_count = name_mask = 0;
  for (unsigned i = 0; i < record_count; i++)
    {
      if (records[i].kind < KIND_SHAPES && records[i].name.length > 0)
        {
          [self enter: i];
        }
    }
}

- (void) noteName: (struct token)word
{
  [self begin: KIND_UNKNOWN at: 0 name: word at: 0];
  [self enter];
}

- (unsigned) find: (unsigned)kind : (struct token)name
{
  return names == NULL ? NO_RECORD
    : [self slotFor: kind : name hash: hash_of(kind, name)]->record;
}

- (struct token) make: (const char *)prefix : (unsigned)number
{
  size_t length = strlen(prefix);

  if (made_length + length + MOST_DIGITS > MADE_WORDS)
    {
      [made_words addObject: [NSMutableData dataWithLength: MADE_WORDS]];
      made = [[made_words lastObject] mutableBytes];
      made_length = 0;
    }

  char *word = made + made_length;
  unsigned digits = 1;

  for (unsigned rest = number; rest >= 10; rest /= 10)
    {
      digits++;
    }
  memcpy(word, prefix, length);
  for (unsigned i = digits; i > 0; i--, number /= 10)
    {
      word[length + i - 1] = '0' + number % 10;
    }
  length += digits;
  made_length += length;
  return (struct token){ word, length };
}

@end
