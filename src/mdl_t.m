#import "mdl_t.h"
#import "diag_t.h"
#import "fence.h"
#import "nff_t.h"
#import "path.h"
#include "attribute_check.h"

@implementation mdl_t

- (id) init: (text_t *)theText into: (store_t *)theStore
       diag: (diag_t *)theDiag includePath: (NSArray *)path
{
  if ((self = [super init: theText into: theStore diag: theDiag]))
    {
      include_path = [path retain];
    }
  return self;
}

- (void) dealloc
{
  [include_path release];
  [path_folders release];
  [folders release];
  [keywords release];
  [super dealloc];
}

- (NSString *) owner
{
  return kind.table == NULL ? @""
    : name.length == 0
    ? [NSString stringWithFormat: @" of the %@", token_string(kind.word)]
    : [NSString stringWithFormat: @" of %@ %@", token_string(kind.word),
                [self quote: name]];
}

- (BOOL) endsValues: (struct token)t
{
  struct cursor here = text->cursor;

  here.at = t.at;
  return kind.table
    ? attribute_named(kind.table, t) != NULL || [self isBlockAt: here]
    : [self isDirective: t] || [store kindFor: t] != KIND_UNKNOWN;
}

- (BOOL) enter: (source_t *)source from: (unsigned)order
{
  [text enter: source from: order];
  if (!source->is_text)
    {
      FAULT(source->text + source->length, @"expected text in UTF-8, found"
            @" the byte 0x%02x: this is not a text file",
            (unsigned char)source->text[source->length]);
      store->is_partial = YES;
      return NO;
    }
  if ([[source->name lowercaseString] hasSuffix: @".nff"])
    {
      nff_t *nff = [[nff_t alloc] init: text into: store diag: diag];
      [nff read];
      [nff release];
    }
  return YES;
}

- (BOOL) wantsFault: (const char *)at
{
  return at != told && [super wantsFault: at];
}

- (BOOL) isPath: (struct token)t
{
  return token_is_word(t) && ![self isNumber: t]
    && (memchr(t.at, '/', t.length) || memchr(t.at, '.', t.length));
}

- (void) resumeAfter: (struct token)t
{
  struct cursor behind = text->cursor;
  struct token next = token_next(&behind);
  BOOL is_path = [self isPath: t];

  if ((is_path && token_is(next, "include"))
      || ([self isNumber: t] && token_is(next, "background")))
    {
      text->cursor = behind;            // they have changed places
    }
  for (int i = 0; i < 2 && !is_path; i++)
    {
      is_path = [self isPath: next] && !token_is(token_peek(behind), "{");
      next = token_next(&behind);
    }
  store->is_partial |= is_path;
  store->is_sound = NO;

  struct token block = [self resumeOutside];

  if (block.length > 0)
    {
      [store noteName: block];
    }
}

/** Reads `background r g b`, from behind that word. */
- (void) readBackground: (struct token)word
{
  static const struct attribute background =
    { .name = "background", .kind = ATTRIBUTE_COLOR };
  struct value values[3];
  struct token t;

  if (store->has_background)
    {
      FAULT(word.at, @"second background, expected one in the whole model;"
            @" the first is at %@",
            [diag nameOf: [text placeAt: store->background_order]]);
    }
  else
    {
      store->has_background = YES;
      store->background_order = [self orderOf: word];
    }
  if ([self read: &background into: values])
    {
      store->background = k_vec(values[0].number, values[1].number,
                                values[2].number);
      t = token_peek(text->cursor);
      if ([self isNumber: t] && ![self looksLikeBlock: text->cursor])
        {
          FAULT(t.at, @"expected 3 numbers for background, found one more:"
                @" %@", [self quote: t]);
          while ([self isNumber: token_peek(text->cursor)])
            {
              token_next(&text->cursor);
            }
        }
      return;
    }
  t = token_peek(text->cursor);
  if (token_is(t, "}"))
    {
      struct cursor behind = text->cursor;
      token_next(&behind);
      text->cursor = [self isNumber: token_peek(behind)] ? behind
        : text->cursor;
    }
  // Past the rest of the values, up to what looks like something else.
  for (t = token_peek(text->cursor);
       token_is_word(t) && ![self isDirective: t]
         && ![self looksLikeBlock: text->cursor];
       t = token_peek(text->cursor))
    {
      token_next(&text->cursor);
    }
  if ([self isNumber: t])
    {
      [self resumeAfter: t];            // a value in place of a keyword
    }
}

- (NSArray *) keywords
{
  if (keywords == nil)
    {
      keywords = [[[store words] arrayByAddingObjectsFromArray:
        [NSArray arrayWithObjects: @"include", @"background", nil]] retain];
    }
  return keywords;
}

/** A word that is no keyword. */
- (void) refuseWord: (struct token)t
{
  FAULT(t.at, @"unknown keyword %@%@", [self quote: t],
        [self advise: t among: [self keywords]]);

  NSString *meant = [self nearestTo: t among: [self keywords]];

  store->has_camera |= [meant isEqual: @"camera"];
  store->is_partial |= [meant isEqual: @"include"];
  [store noteName: t];
  [self resumeAfter: t];
}

/** Goes on after a brace outside of blocks. It may stand for a keyword: the
    name follows, or a path. */
- (void) resumeBehindBrace: (struct token)brace
{
  struct cursor behind = text->cursor;
  struct token t = token_next(&behind);
  BOOL is_opening = token_is(brace, "{");

  if (token_is_word(t) && [store kindFor: t] == KIND_UNKNOWN
      && ![self isDirective: t]
      && (!is_opening || token_is(token_peek(behind), "{")
          || [self isPath: t]))
    {
      [self resumeAfter: brace];
    }
  else if (is_opening && [self isDirective: t])
    {
      open_braces++;
    }
  else if (is_opening)
    {
      text->cursor.at = brace.at;
      store->is_sound = NO;
      [self resumeOutside];
    }
}

- (void) readItem: (struct token)t
{
  unsigned kind_number;

  if (token_is(t, "}"))
    {
      if (open_braces)
        {
          open_braces--;
          return;
        }
      FAULT(t.at, @"expected a block or a directive, found '}' without a"
            @" '{' before it");
      [self resumeBehindBrace: t];
    }
  else if (token_is(t, "{"))
    {
      FAULT(t.at, @"expected a keyword and a name before '{'");
      store->is_nameless = YES;
      [self resumeBehindBrace: t];
    }
  else if (token_is(t, "include"))
    {
      [self readInclude];
    }
  else if (token_is(t, "background"))
    {
      [self readBackground: t];
    }
  else if ((kind_number = [store kindFor: t]) != KIND_UNKNOWN)
    {
      [self readBlock: kind_number keyword: t];
    }
  else
    {
      [self refuseWord: t];
    }
}

/** Fixes where files may be included from. */
- (void) fence: (source_t *)source
{
  NSMutableArray *allowed = [NSMutableArray array];
  NSString *own = fence_folder(path_folder(source->name));

  for (NSString *folder in include_path)
    {
      NSString *real = fence_folder(folder);
      if (real)
        {
          [allowed addObject: real];
        }
    }
  path_folders = [allowed copy];
  if (own)
    {
      [allowed addObject: own];
    }
  folders = [allowed copy];
}

- (void) read: (source_t *)source
{
  [self fence: source];
  if (![self enter: source from: 0])
    {
      return;
    }
  for (;;)
    {
      struct token t = token_next(&text->cursor);

      if (t.length > 0)
        {
          [self readItem: t];
        }
      else if (![text leave])
        {
          return;
        }
    }
}

@end
