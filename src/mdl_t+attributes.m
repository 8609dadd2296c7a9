#import "mdl_t.h"
#import "diag_t.h"
#include "attribute_check.h"

/** What the attributes of one block were. */
struct block_state
{
  struct record *record;
  uint64_t given;       // bits of the table's attributes
  uint64_t excused;     // those that an unknown one was meant to be
  unsigned unknown[4];  // how many more unknown ones had so many values
  const struct attribute *last; // the attribute just read; NULL after a fault
};

@implementation mdl_t (attributes)

- (void) readAttribute: (const struct attribute *)a word: (struct token)t
                 state: (struct block_state *)state
{
  uint64_t bit = (uint64_t)1 << (a - kind.table);
  BOOL is_second = (state->given & bit) && !a->is_repeated;
  struct value values[3];

  state->given |= bit;
  if (is_second)
    {
      [self spoil: state->record];
      FAULT(t.at, @"second %s%@, expected one", a->name, [self owner]);
    }
  if (![self read: a into: values])
    {
      [self spoil: state->record];
      [self resumeInside];
      state->last = NULL;
      return;
    }
  if (!is_second)
    {
      [store give: a at: [self orderOf: t] values: values];
    }
  state->last = a;
}

/** A word that is no attribute. */
- (void) refuseWord: (struct token)t state: (struct block_state *)state
{
  const struct attribute *last = state->last;

  [self spoil: state->record];
  state->last = NULL;
  if (last && [self isNumber: t])
    {
      FAULT(t.at, @"expected %@ for %s%@, found one more: %@",
            attribute_expected(last, attribute_values(last)), last->name,
            [self owner], [self quote: t]);
      [self resumeInside];
      return;
    }

  FAULT(t.at, @"unknown attribute %@%@%@", [self quote: t], [self owner],
        [self advise: t among: attribute_names(kind.table)]);

  NSAutoreleasePool *pool = [NSAutoreleasePool new];
  NSString *meant = [self nearestTo: t among: attribute_names(kind.table)];
  unsigned words = [self resumeInside];

  if (meant)
    {
      const char *word = [meant UTF8String];
      struct token other = { word, strlen(word) };
      state->excused |= (uint64_t)1
        << (attribute_named(kind.table, other) - kind.table);
    }
  else
    {
      state->unknown[words < 4 ? words : 0]++;
    }
  [pool drain];
}

/** Reads up to the closing brace and past it. NO if it is missing. */
- (BOOL) readAttributes: (struct block_state *)state
{
  for (;;)
    {
      struct cursor here = text->cursor;
      struct token t = token_next(&text->cursor);
      const struct attribute *a = attribute_named(kind.table, t);

      if (token_is(t, "}"))
        {
          return YES;
        }
      // The attribute `material` is also the start of a block.
      if (a && (a->kind != ATTRIBUTE_MATERIAL || ![self isBlockAt: here]))
        {
          [self readAttribute: a word: t state: state];
        }
      else if (token_is(t, "{"))
        {
          [self spoil: state->record];
          open_braces++;
          FAULT(t.at, @"expected an attribute%@ or '}', found '{'",
                [self owner]);
        }
      else if (t.length == 0 || [self isBlockAt: here]
               || ([self isDirective: t] && ![self isClosed]))
        {
          [self spoil: state->record];
          FAULT(t.at, @"expected '}' after the attributes%@, found %@",
                [self owner], [self quote: t]);
          text->cursor = here;
          return NO;
        }
      else if (token_is(t, "include"))
        {
          [self spoil: state->record];
          [self refuseInclude];
        }
      else
        {
          [self refuseWord: t state: state];
        }
    }
}

/** Whether an unknown attribute was meant to be this one. */
static BOOL
is_excused(struct block_state *state, const struct attribute *table,
           const struct attribute *a)
{
  unsigned values = attribute_values(a);

  if (state->excused & (uint64_t)1 << (a - table))
    {
      return YES;
    }
  if (state->unknown[values])
    {
      state->unknown[values]--;
      return YES;
    }
  return NO;
}

- (void) requireAttributes: (struct block_state *)state
                   keyword: (struct token)keyword
{
  uint64_t missing = 0, bit = 1;

  for (const struct attribute *a = kind.table; a->name; a++, bit <<= 1)
    {
      if (a->is_required && !(state->given & bit)
          && !is_excused(state, kind.table, a))
        {
          missing |= bit;
        }
    }
  if (missing)
    {
      [self spoil: state->record];
      FAULT(keyword.at, @"expected %@%@, found none",
            attribute_list(attribute_names_of(kind.table, missing), @"and"),
            [self owner]);
    }
}

- (void) readAttributesOf: (struct record *)record
                  keyword: (struct token)keyword
{
  struct block_state state = { .record = record };

  if ([self readAttributes: &state])
    {
      [self requireAttributes: &state keyword: keyword];
    }
}

@end
