#import "mdl_t.h"
#import "diag_t.h"
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

/** Reads the name and makes the block known by it. */
- (struct record *) readName: (unsigned)kind_number
                     keyword: (struct token)keyword
{
  struct token t = token_peek(text->cursor);
  BOOL has_name = token_is_word(t);

  name = has_name ? token_next(&text->cursor) : (struct token){ t.at, 0 };

  struct record *record =
    [store begin: kind_number at: [self orderOf: keyword]
            name: name at: [self orderOf: name]];

  if (!has_name)
    {
      [self spoil: record];
      store->is_nameless |= kind_number == KIND_MATERIAL;
      FAULT(t.at, @"expected a name for the %@, found %@",
            reader_string(kind.word), [self quote: t]);
    }
  if (kind_number == KIND_CAMERA)
    {
      if (store->camera != NO_RECORD)
        {
          [self spoil: record];
          unsigned first = store->records[store->camera].order;
          FAULT(keyword.at, @"second camera, expected one in the whole model;"
                @" the first is at %@",
                [diag nameOf: [text placeAt: first]]);
          return record;
        }
      store->camera = store->record_count - 1;
      store->has_camera = YES;
    }
  if (has_name)
    {
      unsigned other = [store enter];
      if (other != NO_RECORD)
        {
          [self spoil: record];
          unsigned first = store->records[other].name_order;
          FAULT(name.at, @"second %@ of the name %@, expected another name;"
                @" the first is at %@", reader_string(kind.word),
                [self quote: name], [diag nameOf: [text placeAt: first]]);
        }
    }
  return record;
}

/** Goes past the opening brace. NO if the block has none. */
- (BOOL) openBrace: (struct record *)record
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
      return YES;
    }
  // The attributes may start a little later.
  while (token_is_word(t) && ![self isBlockAt: text->cursor])
    {
      token_next(&text->cursor);
      t = token_peek(text->cursor);
    }
  if (token_is_brace(t))
    {
      token_next(&text->cursor);
    }
  return token_is(t, "{");
}

- (void) readBlock: (unsigned)kind_number keyword: (struct token)keyword
{
  kind = store->kinds[kind_number];

  struct record *record = [self readName: kind_number keyword: keyword];

  if ([self openBrace: record])
    {
      [self readAttributesOf: record keyword: keyword];
    }
  kind.table = NULL;
}

@end
