#import "format_t.h"
#include "attribute_check.h"
#include "number.h"
#include <stdio.h>

@implementation format_t

static void
write_number(FILE *out, double value, locale_t c)
{
  char text[32];

  number_write(value, c, text);
  fprintf(out, " %s", text);
}

static void
write_word(FILE *out, const char *at, size_t length)
{
  fputc(' ', out);
  fwrite(at, 1, length, out);
}

/** One attribute where it is given. */
static void
write_given(FILE *out, const struct attribute *a, const struct value *value,
            locale_t c)
{
  fprintf(out, "  %s", a->name);
  for (unsigned i = 0, n = attribute_values(a); i < n; i++)
    {
      if (attribute_is_numeric(a))
        {
          write_number(out, value[i].number, c);
        }
      else
        {
          write_word(out, value[i].word, value[i].length);
        }
    }
  fputc('\n', out);
}

/** A block, its attributes in the order of the table. */
static void
write_block(FILE *out, store_t *store, const struct record *record, locale_t c)
{
  const struct kind *kind = &store->kinds[record->kind];

  if (ftell(out) > 0)
    {
      fputc('\n', out);
    }
  fwrite(kind->word.at, 1, kind->word.length, out);
  write_word(out, record->name.at, record->name.length);
  fputs("\n{\n", out);
  for (unsigned n = 0; kind->table[n].name; n++)
    {
      const struct given *given = &store->givens[record->given];
      for (unsigned i = 0; i < record->given_count; i++)
        {
          if (given[i].attribute == n)
            {
              write_given(out, &kind->table[n],
                          &store->values[given[i].value], c);
            }
        }
    }
  fputs("}\n", out);
}

+ (NSString *) textOf: (store_t *)store
{
  char *bytes = NULL;
  size_t length;
  FILE *out = open_memstream(&bytes, &length);
  locale_t c = newlocale(LC_ALL_MASK, "C", NULL);

  if (store->has_background)
    {
      fputs("background", out);
      write_number(out, store->background.x, c);
      write_number(out, store->background.y, c);
      write_number(out, store->background.z, c);
      fputc('\n', out);
    }
  for (unsigned kind = KIND_CAMERA; kind <= KIND_SHAPES; kind++)
    {
      for (unsigned i = 0; i < store->record_count; i++)
        {
          const struct record *record = &store->records[i];
          if (MIN(record->kind, KIND_SHAPES) == kind)
            {
              write_block(out, store, record, c);
            }
        }
    }
  freelocale(c);
  fclose(out);
  return [[[NSString alloc] initWithBytesNoCopy: bytes length: length
                                       encoding: NSUTF8StringEncoding
                                   freeWhenDone: YES] autorelease];
}

@end
