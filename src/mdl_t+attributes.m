#include "block_state.h"
#include "attribute_check.h"

@implementation mdl_t (attributes)

- (void) readAttribute: (const struct attribute *)a word: (struct token)t
                 state: (struct block_state *)state
{
  uint64_t bit = attribute_bit(a, kind.table);
  BOOL is_second = (state->given & bit) && !a->is_repeated;
  struct cursor start = text->cursor;
  struct value values[3];

  state->given |= bit;
  if (is_second)
    {
      [self refuseSecond: a word: t state: state];
    }
  else if ([self read: a into: values])
    {
      store_give(store, a, [self orderOf: t], values);
      state->last = a;
    }
  else
    {
      [self resumeAfter: a from: start state: state];
    }
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
      else if (a && !(!a->is_repeated
                      && (state->given & attribute_bit(a, kind.table))
                      && [self isBeforeBrace: t])
               && (a->kind != ATTRIBUTE_MATERIAL
                   || ![self isBlockNotAttributeAt: here]))
        {
          [self readAttribute: a word: t state: state];
        }
      else if (t.length == 0 || [self isBlockAt: here]
               || ([self isDirective: t] && ![self isClosed])
               || [self isBeforeBrace: t])
        {
          [self missBrace: t state: state];
          text->cursor = here;
          return NO;
        }
      else if ([self isEnd])
        {
          [self missBrace: t state: state];
          return NO;
        }
      else if (token_is(t, "{"))
        {
          [self openInside: t state: state];
        }
      else
        {
          [self refuse: t state: state];
        }
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
