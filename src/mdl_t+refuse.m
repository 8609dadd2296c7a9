// mdl_t+refuse.m - faults in a block: what is said of them, and where to go on
// so that each is told once.

#include "block_state.h"
#import "diag_t.h"
#include "attribute_check.h"

@implementation mdl_t (refuse)

static void
note_stray(struct block_state *state, unsigned words)
{
  if (words <= MOST_STRAY)
    {
      state->stray[words]++;
    }
}

/** There were so many words too few, or too many if it is negative. NO if that
    has nothing to do with the next attribute. If that has what is missing
    here, or lacks what is too much, a word has changed its place; if it stands
    where a value is missing, it is one. Goes past it then. */
- (BOOL) balance: (int)lacking state: (struct block_state *)state
{
  struct cursor ahead = text->cursor;
  struct token t = token_next(&ahead);
  const struct attribute *next = attribute_named(kind.table, t);
  int words = next ? (int)[self wordsAt: ahead] : 0;

  if (next == NULL || lacking == 0)
    {
      return NO;
    }
  if (words == (int)attribute_values(next) + lacking)
    {
      state->given |= attribute_bit(next, kind.table);
    }
  else if (words == lacking - 1)
    {
      state->excused |= attribute_bit(next, kind.table);
    }
  else
    {
      return NO;
    }
  text->cursor = ahead;
  while (words-- > 0)
    {
      token_next(&text->cursor);
    }
  return YES;
}

- (void) resumeAfter: (const struct attribute *)a from: (struct cursor)start
               state: (struct block_state *)state
{
  struct token found = token_peek(text->cursor), last = found;
  int words = 0, values = (int)attribute_values(a), lacking;

  for (; start.at < text->cursor.at; words++)
    {
      last = token_next(&start);
    }
  [self spoil: state->record];
  state->last = NULL;
  state->told = found.at;
  if (token_is(found, "{"))
    {
      token_next(&text->cursor);
      state->inner++;
    }
  else if (token_is(found, "}") && words < values)
    {
      struct cursor behind = text->cursor;
      token_next(&behind);
      if (token_is(token_peek(behind), "}"))
        {
          text->cursor = behind;        // it stands for a value
        }
    }
  lacking = values - words - (int)[self resumeInside];
  if (lacking > 0 && words > 0 && ![self isNumber: last])
    {
      lacking = 0;      // a word instead of numbers, however many
      if (a->is_repeated)
        {
          note_stray(state, 1 + words); // or another attribute is meant
        }
    }
  if (![self balance: lacking state: state] && lacking < 0)
    {
      note_stray(state, -lacking);
    }
}

- (void) refuseSecond: (const struct attribute *)a word: (struct token)t
                state: (struct block_state *)state
{
  [self spoil: state->record];
  FAULT(t.at, @"second %s%@, expected one", a->name, [self owner]);
  if ([self isEnd])
    {
      told = token_peek(text->cursor).at;       // it stands for the brace
    }
  note_stray(state, 1 + [self resumeInside]);
  state->last = NULL;
}

/** More values than the last attribute has. The first one is a number. */
- (void) refuseValue: (struct token)t state: (struct block_state *)state
{
  const struct attribute *last = state->last;
  unsigned words;

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
  words = 1 + [self resumeInside];
  if (![self balance: -(int)words state: state])
    {
      note_stray(state, words);
    }
}

/** The attribute that a word and the next one are the halves of, or NULL. Goes
    past the next one then. */
- (const struct attribute *) attributeInTwo: (struct token)t
{
  struct token next = token_peek(text->cursor);

  for (const struct attribute *a = kind.table; a->name; a++)
    {
      if (strlen(a->name) == t.length + next.length
          && memcmp(a->name, t.at, t.length) == 0
          && memcmp(a->name + t.length, next.at, next.length) == 0)
        {
          token_next(&text->cursor);
          return a;
        }
    }
  return NULL;
}

/** The attribute that a word was meant to be, or NULL. */
- (const struct attribute *) attributeNear: (struct token)t
{
  NSAutoreleasePool *pool = [NSAutoreleasePool new];
  NSString *near = [self nearestTo: t among: attribute_names(kind.table)];
  const char *word = [near UTF8String];
  const struct attribute *a = word == NULL ? NULL
    : attribute_named(kind.table, (struct token){ word, strlen(word) });

  [pool drain];
  return a;
}

/** A word that is no attribute. */
- (void) refuseWord: (struct token)t state: (struct block_state *)state
{
  const struct attribute *both = [self attributeInTwo: t];
  const struct attribute *meant = both ? both : [self attributeNear: t];

  FAULT(t.at, @"unknown attribute %@%@%@", [self quote: t], [self owner],
        both ? [NSString stringWithFormat: @"; did you mean '%s'?", both->name]
        : [self advise: t among: attribute_names(kind.table)]);

  unsigned values = [self resumeInside];

  if (meant)
    {
      state->excused |= attribute_bit(meant, kind.table);
    }
  else if (values > 0 || ![self balance: -1 state: state])
    {
      note_stray(state, 1 + values);
      if (values == 0 && state->last
          && state->last->kind == ATTRIBUTE_MATERIAL)
        {
          // It may be the material, and what was taken for that is not.
          store->given_count--;
          state->record->given_count--;
        }
    }
}

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
  note_stray(state, 1 + [self resumeInside]);
  return NO;
}

- (void) missBrace: (struct token)t state: (struct block_state *)state
{
  [self spoil: state->record];
  if (!state->is_closed)
    {
      FAULT(t.at, @"expected '}' after the attributes%@, found %@",
            [self owner], [self quote: t]);
    }
}

- (void) openInside: (struct token)brace state: (struct block_state *)state
{
  [self spoil: state->record];
  state->inner++;
  FAULT(brace.at, @"expected an attribute%@ or '}', found '{'", [self owner]);
  if ([self wordsAt: text->cursor] > 0)
    {
      note_stray(state, 1 + [self resumeInside]);
      state->last = NULL;
    }
}

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

/** Whether an unknown attribute was meant to be this one. */
static BOOL
is_excused(struct block_state *state, const struct attribute *table,
           const struct attribute *a)
{
  unsigned values = attribute_values(a);

  if (state->excused & attribute_bit(a, table))
    {
      return YES;
    }
  // Its values alone, or with a word in place of its name.
  for (unsigned words = values; words <= values + 1; words++)
    {
      if (state->stray[words])
        {
          state->stray[words]--;
          return YES;
        }
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

@end
