#import "nff_t.h"
#include "nff_solids.h"

@implementation nff_t

- (void) dealloc
{
  free(plain_lights);
  free(faces);
  [super dealloc];
}

- (NSString *) owner
{
  return [NSString stringWithFormat: @" of %@", token_string(letter)];
}

/** What starts a line is no value any more. */
- (BOOL) endsValues: (struct token)t
{
  const char *p = t.at;

  while (p > text->cursor.text && (p[-1] == ' ' || p[-1] == '\t'))
    {
      p--;
    }
  return p == text->cursor.text || p[-1] == '\n';
}

- (void) resume
{
  struct token t = token_peek(text->cursor);

  while (t.length > 0 && ([self isNumber: t] || ![self endsValues: t]))
    {
      text->cursor.at = t.at + t.length;
      t = token_peek(text->cursor);
    }
}

/** Lights without a colour share 1: each has 1 / sqrt(number of lights). */
- (void) shareLight
{
  for (unsigned i = 0; i < plain_light_count; i++)
    {
      for (unsigned channel = 0; channel < 3; channel++)
        {
          store->values[plain_lights[i] + channel].number = 1 / sqrt(lights);
        }
    }
}

/** Tells the faces of solids which it is. Their `solid` is the second
    attribute of their blocks; the other polygons lose it. */
- (void) nameSolids
{
  nff_find_solids(faces, face_count, store->values);
  for (unsigned i = 0; i < face_count; i++)
    {
      struct record *record = &store->records[faces[i].record];
      struct given *given = &store->givens[record->given];

      if (faces[i].solid)
        {
          struct value *word = &store->values[given[1].value];
          struct token solid = [store make: "solid" : faces[i].solid];
          word->word = solid.at;
          word->length = (unsigned)solid.length;
        }
      else
        {
          given[1] = given[0];
          record->given++;
          record->given_count--;
        }
    }
}

- (void) read
{
  for (letter = token_next(&text->cursor); letter.length > 0;
       letter = token_next(&text->cursor))
    {
      if (![self readEntity])
        {
          store->is_sound = NO;
          lacks_fill = YES;     // it may have been the first f
          [self resume];
        }
    }
  [self shareLight];
  [self nameSolids];
}

@end
