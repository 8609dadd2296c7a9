#import "mdl_t.h"
#import "diag_t.h"
#include "attribute_check.h"

/** What the attributes of one block were. */
struct block_state
{
  struct record *record;
  uint64_t given;       // bits of the table's attributes
  uint64_t excused;     // those that an unknown one was meant to be
  unsigned values[4];   // how many more groups of so many values have no
                        // attribute: they may be those of a missing one
  const struct attribute *last; // the attribute just given; NULL after a fault
  const char *told;     // a brace at which there was a fault
  unsigned inner;       // braces opened by mistake
  BOOL is_closed;       // by a brace that came too early
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
      struct token found = token_peek(text->cursor);

      [self spoil: state->record];
      state->last = NULL;
      state->told = found.at;
      if (token_is(found, "{"))
        {
          token_next(&text->cursor);
          state->inner++;
        }
      [self resumeInside];
      return;
    }
  state->last = NULL;
  if (!is_second)
    {
      [store give: a at: [self orderOf: t] values: values];
      state->last = a;
    }
}

/** More values than the last attribute has. The first one is a number. */
- (void) refuseValue: (struct token)t state: (struct block_state *)state
{
  const struct attribute *last = state->last;
  unsigned values;

  if (last)
    {
      FAULT(t.at, @"expected %@ for %s%@, found one more: %@",
            attribute_expected(last, attribute_values(last)), last->name,
            [self owner], [self quote: t]);
    }
  else
    {
      FAULT(t.at, @"expected an attribute%@ or '}', found %@", [self owner],
            [self quote: t]);
    }
  values = 1 + [self resumeInside];
  state->values[MIN(values, 4) % 4]++;
}

/** A word that is no attribute. */
- (void) refuseWord: (struct token)t state: (struct block_state *)state
{
  FAULT(t.at, @"unknown attribute %@%@%@", [self quote: t], [self owner],
        [self advise: t among: attribute_names(kind.table)]);

  NSAutoreleasePool *pool = [NSAutoreleasePool new];
  NSString *meant = [self nearestTo: t among: attribute_names(kind.table)];
  unsigned values = [self resumeInside];

  if (meant)
    {
      const char *word = [meant UTF8String];
      struct token other = { word, strlen(word) };
      state->excused |= (uint64_t)1
        << (attribute_named(kind.table, other) - kind.table);
    }
  else
    {
      // Without values it may be one itself, and lack its attribute.
      state->values[values == 0 ? 1 : MIN(values, 4) % 4]++;
      if (values == 0 && state->last
          && state->last->kind == ATTRIBUTE_MATERIAL)
        {
          // It may be the material, and what was taken for that is not.
          store->given_count--;
          state->record->given_count--;
        }
    }
  [pool drain];
}

/** A closing brace. NO if the block goes on: that is a fault. */
- (BOOL) close: (struct token)brace state: (struct block_state *)state
{
  BOOL is_told = state->told == brace.at;

  if (![self isTooEarly: is_told])
    {
      return YES;
    }

  struct token t = token_peek(text->cursor);

  [self spoil: state->record];
  state->last = NULL;
  if (state->inner > 0)
    {
      state->inner--;
      return NO;
    }
  if (!is_told)
    {
      FAULT(t.at, @"expected a keyword, found %@: it would belong before the"
            @" '}'%@", [self quote: t], [self owner]);
    }
  state->is_closed = YES;
  [self resumeInside];
  return NO;
}

/** Something that cannot be in a block, where its closing brace should be. */
- (void) missBrace: (struct token)t state: (struct block_state *)state
{
  [self spoil: state->record];
  if (!state->is_closed)
    {
      FAULT(t.at, @"expected '}' after the attributes%@, found %@",
            [self owner], [self quote: t]);
    }
}

/** Something else than an attribute. */
- (void) refuse: (struct token)t state: (struct block_state *)state
{
  [self spoil: state->record];
  if (token_is(t, "include"))
    {
      [self refuseInclude];
    }
  else if ([self isNumber: t])
    {
      [self refuseValue: t state: state];
    }
  else
    {
      [self refuseWord: t state: state];
    }
  state->last = NULL;
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
          if ([self close: t state: state])
            {
              return YES;
            }
        }
      else if (a && (a->kind != ATTRIBUTE_MATERIAL
                     || ![self isBlockNotAttributeAt: here]))
        {
          [self readAttribute: a word: t state: state];
        }
      else if (token_is(t, "{"))
        {
          [self spoil: state->record];
          state->inner++;
          FAULT(t.at, @"expected an attribute%@ or '}', found '{'",
                [self owner]);
        }
      else if (t.length == 0 || [self isBlockAt: here]
               || ([self isDirective: t] && ![self isClosed]))
        {
          [self missBrace: t state: state];
          text->cursor = here;
          return NO;
        }
      else if ([self isEndBehind: t])
        {
          [self missBrace: t state: state];
          return NO;
        }
      else
        {
          [self refuse: t state: state];
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
  if (state->values[values])
    {
      state->values[values]--;
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
  open_braces += state.inner;
}

@end
