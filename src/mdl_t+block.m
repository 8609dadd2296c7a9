#import "mdl_t.h"
#import "diag_t.h"
#import "material_t.h"
#include "attribute_check.h"

@implementation mdl_t (block)

- (void) spoil: (struct record *)record
{
  record->is_faulty = YES;
  if (record->kind != KIND_CAMERA && record->kind != KIND_LIGHT)
    {
      store->is_sound = NO;
    }
}

/** Reads the name. Adds the block, which is faulty if it has none. */
- (struct record *) readName: (unsigned)kind_number
                     keyword: (struct token)keyword
{
  struct token t = token_peek(text->cursor);
  struct cursor behind = text->cursor;
  BOOL is_brace = token_is_brace(t);

  token_next(&behind);

  struct token first = token_next(&behind), second = token_next(&behind);

  if (is_brace && token_is_word(first) && token_is(second, "{"))
    {
      // The brace has nothing to do there, the name comes next.
      open_braces += *t.at == '{';
      token_next(&text->cursor);
    }
  else if (token_is(t, "{") && token_is(first, "{"))
    {
      // It stands for the name.
      token_next(&text->cursor);
    }
  else if (token_is(t, "{") && token_is_word(first)
           && !attribute_named(kind.table, first)
           && attribute_named(kind.table, second))
    {
      // It has changed places with the name.
      token_next(&text->cursor);
      told = second.at;
    }
  name = token_peek(text->cursor);
  if (token_is_word(name))
    {
      token_next(&text->cursor);
    }
  else
    {
      name.length = 0;
    }

  struct record *record =
    [store begin: kind_number at: [self orderOf: keyword]
            name: name at: [self orderOf: name]];

  if (is_brace || name.length == 0)
    {
      [self spoil: record];
      store->is_nameless |= kind_number == KIND_MATERIAL && name.length == 0;
      FAULT(t.at, @"expected a name for the %@, found %@",
            token_string(kind.word), [self quote: t]);
    }
  return record;
}

/** Whether that block is in this file too, which is included once more. Its
    first clash stands for all. */
- (BOOL) isReadAgain: (const struct record *)record
{
  source_t *here = [text source], *there = [text sourceAt: record->order];
  BOOL is_again = here != there && here->device == there->device
    && here->inode == there->inode;
  BOOL is_told = here->is_told_again;

  here->is_told_again = is_again;
  return is_again && is_told;
}

/** Notes the first camera. NO, with a fault, for another one. */
- (BOOL) isOnlyCamera: (struct token)keyword
{
  if (store->camera == NO_RECORD)
    {
      store->camera = store->record_count - 1;
      store->has_camera = YES;
      return YES;
    }
  if ([self isReadAgain: &store->records[store->camera]])
    {
      return NO;
    }
  FAULT(keyword.at, @"second camera, expected one in the whole model; the"
        @" first is at %@", [diag nameOf: [text placeAt:
          store->records[store->camera].order]]);
  return NO;
}

/** Makes the block known by its name. NO, with a fault, if the name is
    taken. */
- (BOOL) isOnlyOne
{
  unsigned other = name.length ? [store enter] : NO_RECORD;

  if (other != NO_RECORD && ![self isReadAgain: &store->records[other]])
    {
      // A material may be meant to have the name of one that is missing.
      store->is_nameless |= kind.class == [material_t class];
      FAULT(name.at, @"second %@ of the name %@, expected another name; the"
            @" first is at %@", token_string(kind.word), [self quote: name],
            [diag nameOf: [text placeAt: store->records[other].name_order]]);
    }
  return other == NO_RECORD;
}

/** Goes past the opening brace. NO if the block has none. *extra is the word
    before it if that is too much: maybe the name is meant. */
- (BOOL) openBrace: (struct record *)record extra: (struct token *)extra
{
  struct token t = token_peek(text->cursor);

  if (token_is(t, "{"))
    {
      token_next(&text->cursor);
      return YES;
    }
  [self spoil: record];
  FAULT(t.at, @"expected '{' and the attributes%@, found %@", [self owner],
        [self quote: t]);
  if (t.length == 0 || [self isDirective: t] || [self isBlockAt: text->cursor])
    {
      return NO;
    }
  if (attribute_named(kind.table, t))
    {
      struct cursor behind = text->cursor;
      token_next(&behind);
      t = token_peek(behind);
      told = token_is(t, "{") ? t.at : told;    // they have changed places
      text->cursor = attribute_named(kind.table, t) ? behind : text->cursor;
      return YES;
    }
  // The attributes may start a little later.
  while (token_is_word(t) && ![self isBlockAt: text->cursor])
    {
      *extra = token_next(&text->cursor);
      t = token_peek(text->cursor);
    }
  if (token_is_brace(t))
    {
      token_next(&text->cursor);
    }
  if (token_is(t, "}") && [self isAttributeAt: text->cursor])
    {
      return YES;                       // it stands for the other brace
    }
  if (token_is(t, "}") && token_is(token_peek(text->cursor), "{"))
    {
      t = token_next(&text->cursor);
    }
  return token_is(t, "{");
}

- (void) readBlock: (unsigned)kind_number keyword: (struct token)keyword
{
  struct token extra = { NULL, 0 };

  kind = store->kinds[kind_number];

  struct record *record = [self readName: kind_number keyword: keyword];

  BOOL is_second = kind_number == KIND_CAMERA && ![self isOnlyCamera: keyword];

  if ([self openBrace: record extra: &extra])
    {
      if (is_second || (extra.length == 0 && ![self isOnlyOne]))
        {
          [self spoil: record];
        }
      [self readAttributesOf: record keyword: keyword];
      [store end];
    }
  else if (name.length > 0)
    {
      [store noteName: name];
    }
  kind.table = NULL;
  if (extra.length > 0)
    {
      [store noteName: extra];
      store->is_nameless |= kind_number == KIND_MATERIAL;
    }
}

@end
