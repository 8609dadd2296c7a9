#include "excerpt.h"
#include "utf8.h"
#include <string.h>

// Characters of a line that are shown at most, and how many of these come
// before the column.
#define SHOWN 120
#define BEFORE 60

/** The start of a line; the end of the text if it has fewer lines. */
static const char *
line_start(const char *at, const char *end, int line)
{
  while (line > 1 && at < end)
    {
      const char *newline = memchr(at, '\n', end - at);
      at = newline ? newline + 1 : end;
      line--;
    }
  return at;
}

/** Goes over a number of characters. */
static const char *
skip(const char *at, const char *end, int characters)
{
  unsigned bytes;

  while (characters > 0 && at < end)
    {
      utf8_shown(at, end - at, &bytes);
      at += bytes;
      characters--;
    }
  return at;
}

/** Appends the character to the line, and as much space to the row of the
    caret while that has not come. */
static void
show(unsigned c, NSMutableString *shown, NSMutableString *caret)
{
  static const char *const spaces[] = { "", " ", "  " };

  [shown appendString: c < 0x10000
    ? [NSString stringWithFormat: @"%C", (unichar)c]
    : [NSString stringWithFormat: @"%C%C",
                (unichar)(0xD800 + ((c - 0x10000) >> 10)),
                (unichar)(0xDC00 + ((c - 0x10000) & 0x3FF))]];
  [caret appendFormat: @"%s", c == '\t' ? "\t" : spaces[utf8_width(c)]];
}

NSString *
excerpt(NSData *text, int line, int column)
{
  const char *bytes = [text length] ? [text bytes] : "";
  const char *end = bytes + [text length];
  const char *start = line_start(bytes, end, line);
  const char *newline = memchr(start, '\n', end - start);
  NSMutableString *shown = [NSMutableString string];
  NSMutableString *caret = [NSMutableString string];

  end = newline ? newline : end;
  if (end > start && end[-1] == '\r')
    {
      end--;
    }

  BOOL is_short = skip(start, end, SHOWN) == end;
  int first = is_short || column <= BEFORE ? 1 : column - BEFORE;
  const char *at = skip(start, end, first - 1);

  if (first > 1)
    {
      [shown appendString: @"..."];
      [caret appendString: @"   "];
    }
  for (int i = first; i < first + SHOWN && at < end; i++)
    {
      unsigned bytes, c = utf8_shown(at, end - at, &bytes);
      show(c, shown, i < column ? caret : nil);
      at += bytes;
    }
  if (at < end)
    {
      [shown appendString: @"..."];
    }
  NSString *number = [NSString stringWithFormat: @"%4d", line];
  return [NSString stringWithFormat: @"%@ |%s%@\n%*s | %@^\n", number,
                   [shown length] ? " " : "", shown, (int)[number length],
                   "", caret];
}
