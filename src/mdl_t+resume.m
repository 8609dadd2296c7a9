#import "mdl_t.h"
#include "attribute_check.h"

// So many words after a fault are compared with attributes.
#define COMPARED 16

@implementation mdl_t (resume)

- (BOOL) isDirective: (struct token)t
{
  return token_is(t, "include") || token_is(t, "background");
}

- (BOOL) looksLikeBlock: (struct cursor)cursor
{
  return token_is_word(token_next(&cursor))
    && token_is_word(token_next(&cursor))
    && token_is(token_next(&cursor), "{");
}

- (BOOL) isBlockAt: (struct cursor)cursor
{
  return [self looksLikeBlock: cursor]
    && [store kindFor: token_peek(cursor)] != KIND_UNKNOWN;
}

- (BOOL) isClosed
{
  if (next_brace == NULL || next_brace < text->cursor.at
      || next_brace >= text->cursor.text + [text source]->length
      || next_brace < text->cursor.text)
    {
      struct cursor ahead = text->cursor;
      struct token t;
      do
        {
          t = token_next(&ahead);
        }
      while (token_is_word(t));
      next_brace = t.at;
    }
  return *next_brace == '}';
}

- (BOOL) isBlockNotAttributeAt: (struct cursor)cursor
{
  if (![self isBlockAt: cursor])
    {
      return NO;
    }

  unsigned other = [store kindFor: token_next(&cursor)];
  struct token its_name = token_next(&cursor);

  token_next(&cursor);

  struct token t = token_next(&cursor);
  const struct attribute *theirs = store->kinds[other].table;

  return attribute_named(theirs, t)
    || (token_is(t, "}") && [store find: other : its_name] == NO_RECORD)
    || (!attribute_named(kind.table, t)
        && [self nearestTo: t among: attribute_names(theirs)] != nil);
}

- (BOOL) isAttributeAt: (struct cursor)cursor
{
  return attribute_named(kind.table, token_peek(cursor))
    && ![self isBlockNotAttributeAt: cursor];
}

- (BOOL) isTooEarly: (BOOL)is_told
{
  struct cursor ahead = text->cursor;
  struct token t = token_next(&ahead);
  unsigned other = [store kindFor: t];

  if (token_is_word(t) && other == KIND_UNKNOWN)
    {
      return ![self isDirective: t] && ![self looksLikeBlock: text->cursor]
        && (is_told || attribute_named(kind.table, t)
            || [self isAttributeAt: ahead] || token_is(token_peek(ahead), "}")
            || ([self isNumber: t] && ![self isPath: token_peek(ahead)]
                && ![self isDirective: token_peek(ahead)]));
    }
  if (other == KIND_UNKNOWN || !attribute_named(kind.table, t))
    {
      return NO;
    }
  // A keyword that is an attribute, a name, and what follows an attribute.
  token_next(&ahead);
  t = token_next(&ahead);

  BOOL is_brace = token_is(t, "}");     // ours, or in place of its '{'

  t = is_brace ? token_peek(ahead) : t;
  return !attribute_named(store->kinds[other].table, t)
    && (is_brace ? !token_is(t, "{") : attribute_named(kind.table, t) != NULL);
}

- (BOOL) isEnd
{
  struct cursor behind = text->cursor;
  struct token next = token_peek(behind);

  return next.length == 0 || [self isBlockAt: behind]
    || ([self isDirective: next] && ![self isClosed]);
}

- (BOOL) isBeforeBrace: (struct token)t
{
  struct cursor behind = text->cursor;
  struct token brace = token_next(&behind), next = token_peek(behind);

  if (([self isDirective: t] || [store kindFor: t] != KIND_UNKNOWN)
      && token_is(brace, "}") && token_is_word(next)
      && ![self isDirective: next] && ![self isBlockAt: behind])
    {
      told = brace.at;
      return YES;
    }
  return NO;
}

/** Whether a word may have been meant to be an attribute of the block. */
- (BOOL) isNearAttribute: (struct token)t
{
  NSAutoreleasePool *pool = [NSAutoreleasePool new];
  BOOL is_near = ![self isNumber: t]
    && [self nearestTo: t among: attribute_names(kind.table)] != nil;

  [pool drain];
  return is_near;
}

- (unsigned) wordsAt: (struct cursor)cursor
{
  unsigned words = 0;
  struct token t = token_peek(cursor);

  while (words < COMPARED && token_is_word(t)
         && !attribute_named(kind.table, t) && ![self isDirective: t]
         && ![self isBlockAt: cursor] && ![self isNearAttribute: t])
    {
      token_next(&cursor);
      t = token_peek(cursor);
      words++;
    }
  return words;
}

/** Whether the first attribute of a block is one of a camera. */
- (BOOL) isCameraAt: (struct cursor)cursor
{
  return attribute_named(store->kinds[KIND_CAMERA].table,
                         token_next(&cursor)) != NULL;
}

/** Goes past words, and past braces with all they hold, to something that can
    be read. A block of a known kind is that wherever it is: the braces round
    it are open_braces then. */
- (void) resume: (BOOL)is_inside words: (unsigned *)words
          block: (struct token *)block
{
  struct cursor last[2];        // the last two words since a brace
  unsigned depth = 0, count = 0, compared = 0;
  BOOL has_name = !token_is(token_peek(text->cursor), "{");

  for (;;)
    {
      struct cursor here = text->cursor;
      struct token t = token_next(&text->cursor);

      if (t.length == 0 || (depth == 0 && is_inside && token_is(t, "}")))
        {
          text->cursor = here;
          if (depth > 0 && has_name)
            {
              FAULT(t.at, @"expected '}', found the end of the file");
            }
          return;
        }
      if (token_is(t, "}"))
        {
          count = 0;
          depth -= depth > 0;
          if (depth == 0 && !is_inside)
            {
              return;
            }
        }
      else if (token_is(t, "{"))
        {
          if (count >= 2 && [self isBlockAt: last[0]])
            {
              text->cursor = last[0];
              open_braces += depth;
              return;
            }
          if (depth++ == 0 && !is_inside)
            {
              *block = count > 0 ? token_peek(last[1]) : *block;
              store->has_camera |= [self isCameraAt: text->cursor];
            }
          count = 0;
        }
      else
        {
          if (depth == 0
              && ([self isDirective: t]
                  || (is_inside && attribute_named(kind.table, t))
                  || (is_inside && compared++ < COMPARED
                      && [self isNearAttribute: t])))
            {
              text->cursor = here;
              return;
            }
          *words += depth == 0;
          count++;
          last[0] = last[1];
          last[1] = here;
        }
    }
}

- (struct token) resumeOutside
{
  struct token block = { NULL, 0 };
  unsigned words = 0;

  [self resume: NO words: &words block: &block];
  return block;
}

- (unsigned) resumeInside
{
  struct token block;
  unsigned words = 0;

  [self resume: YES words: &words block: &block];
  return words;
}

@end
