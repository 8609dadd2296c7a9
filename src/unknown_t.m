#import "unknown_t.h"
#import "diag_t.h"
#include "attribute_check.h"
#include "utf8.h"

// More names than this are too many for a message.
#define LISTED_NAMES 8

// After so many faults no more guesses are made.
#define ENOUGH_FAULTS 1000

@implementation unknown_t

- (id) init: (store_t *)theStore text: (text_t *)theText
       diag: (diag_t *)theDiag
{
  if ((self = [super init]))
    {
      store = theStore;
      text = theText;
      diag = theDiag;
      told = [NSMutableDictionary new];
    }
  return self;
}

- (void) dealloc
{
  [names release];
  [told release];
  [super dealloc];
}

/** All names of materials, in the order of the text. */
- (NSArray *) names
{
  if (names)
    {
      return names;
    }
  names = [NSMutableArray new];
  for (unsigned i = 0; i < store->record_count; i++)
    {
      struct record *record = &store->records[i];
      if (record->kind == KIND_MATERIAL && record->name.length > 0)
        {
          [names addObject: token_string(record->name)];
        }
    }
  return names;
}

/** Whether any block names this material. */
- (BOOL) isUsed: (NSString *)name
{
  const char *bytes = [name UTF8String];
  struct token wanted = { bytes, strlen(bytes) };

  for (unsigned i = 0; i < store->record_count; i++)
    {
      struct record *record = &store->records[i];
      if (record->is_used && token_is_same(record->name, wanted))
        {
          return YES;
        }
      const struct given *given = &store->givens[record->given];
      const struct attribute *table = store->kinds[record->kind].table;

      for (unsigned k = 0; k < record->given_count; k++)
        {
          const struct value *value = &store->values[given[k].value];
          struct token word = { value->word, value->length };
          if (table[given[k].attribute].kind == ATTRIBUTE_MATERIAL
              && token_is_same(word, wanted))
            {
              return YES;
            }
        }
    }
  return NO;
}

/** What is expected instead, when nothing is near. */
- (NSString *) list
{
  NSUInteger count = [[self names] count];

  return count == 0 ? @"; there is no material in the model"
    : count > LISTED_NAMES ? @"; expected the name of a material"
    : [NSString stringWithFormat: @"; expected %@",
                attribute_list([self names], @"or")];
}

/** The end of the message for a name, when it is met for the first time. */
- (NSString *) firstAdviceFor: (NSString *)name
{
  NSString *nearest = [diag faultCount] > ENOUGH_FAULTS ? nil
    : [diag_t nearestTo: name among: [self names]];
  NSString *advice = nearest == nil ? [self list]
    : [NSString stringWithFormat: @"; did you mean '%@'?", nearest];
  BOOL is_slip = nearest != nil && [self isUsed: nearest];

  if ([[self names] count] == 0 && [told count] > 0)
    {
      advice = @"";     // none at all: that has been told
    }
  [told setObject: is_slip ? advice : @"" forKey: name];
  return advice;
}

- (void) refuse: (struct value)value of: (const struct record *)record
{
  NSAutoreleasePool *pool = [NSAutoreleasePool new];
  NSString *name = token_string((struct token){ value.word, value.length });
  NSString *advice = [told objectForKey: name];

  if (advice == nil)
    {
      advice = [self firstAdviceFor: name];
    }
  if ([advice length] > 0 && [diag wantsFault: value.order])
    {
      [diag fault: [text placeAt: value.order]
                 : @"unknown material %@ for %@ %@%@",
            utf8_quote(value.word, value.length),
            token_string(store->kinds[record->kind].word),
            utf8_quote(record->name.at, record->name.length), advice];
    }
  [pool drain];
}

@end
