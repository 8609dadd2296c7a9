#include "utf8.h"
#include <stdint.h>
#include <string.h>

// Words longer than this are cut in messages.
#define QUOTED_CHARACTERS 40

#define REPLACEMENT 0xFFFD

/** The well-formed character at `at`, or -1; *bytes is its length. The
    table is that of the Unicode standard, "well-formed UTF-8 byte
    sequences". */
static int
decode(const unsigned char *at, size_t left, unsigned *bytes)
{
  static const struct
  {
    unsigned char first_least, first_most, second_least, second_most, bytes;
  } forms[] = {
    { 0xC2, 0xDF, 0x80, 0xBF, 2 }, { 0xE0, 0xE0, 0xA0, 0xBF, 3 },
    { 0xE1, 0xEC, 0x80, 0xBF, 3 }, { 0xED, 0xED, 0x80, 0x9F, 3 },
    { 0xEE, 0xEF, 0x80, 0xBF, 3 }, { 0xF0, 0xF0, 0x90, 0xBF, 4 },
    { 0xF1, 0xF3, 0x80, 0xBF, 4 }, { 0xF4, 0xF4, 0x80, 0x8F, 4 },
  };

  *bytes = 1;
  if (at[0] < 0x80)
    {
      return at[0];
    }
  for (size_t i = 0; i < sizeof forms / sizeof *forms; i++)
    {
      if (at[0] >= forms[i].first_least && at[0] <= forms[i].first_most
          && left >= forms[i].bytes
          && at[1] >= forms[i].second_least && at[1] <= forms[i].second_most)
        {
          int character = at[0] & (0x7F >> forms[i].bytes);
          for (unsigned k = 1; k < forms[i].bytes; k++)
            {
              if (utf8_is_first(at[k]))
                {
                  return -1;
                }
              character = character << 6 | (at[k] & 0x3F);
            }
          *bytes = forms[i].bytes;
          return character;
        }
    }
  return -1;
}

size_t
utf8_valid(const char *text, size_t length)
{
  size_t i = 0;

  while (i < length)
    {
      uint64_t eight;
      unsigned bytes = 8;

      if (length - i >= sizeof eight)
        {
          memcpy(&eight, text + i, sizeof eight);
          if ((eight & 0x8080808080808080) == 0)
            {
              i += bytes;
              continue;
            }
        }
      if (decode((const unsigned char *)text + i, length - i, &bytes) < 0)
        {
          break;
        }
      i += bytes;
    }
  return i;
}

unsigned
utf8_shown(const char *at, size_t left, unsigned *bytes)
{
  int c = decode((const unsigned char *)at, left, bytes);

  if (c < 0 || (c < 0x20 && c != '\t') || (c >= 0x7F && c < 0xA0)
      || (c >= 0x2028 && c <= 0x202E) || (c >= 0x2066 && c <= 0x2069))
    {
      return REPLACEMENT;
    }
  return c;
}

unsigned
utf8_width(unsigned c)
{
  static const struct
  {
    unsigned least, most, width;
  } ranges[] = {
    { 0x0300, 0x036F, 0 }, { 0x1100, 0x115F, 2 }, { 0x200B, 0x200F, 0 },
    { 0x20D0, 0x20FF, 0 }, { 0x2E80, 0x303E, 2 }, { 0x3041, 0xA4CF, 2 },
    { 0xAC00, 0xD7A3, 2 }, { 0xF900, 0xFAFF, 2 }, { 0xFE00, 0xFE0F, 0 },
    { 0xFE30, 0xFE6F, 2 }, { 0xFEFF, 0xFEFF, 0 }, { 0xFF00, 0xFF60, 2 },
    { 0xFFE0, 0xFFE6, 2 }, { 0x1F300, 0x1F64F, 2 }, { 0x1F680, 0x1F6FF, 2 },
    { 0x1F900, 0x1F9FF, 2 }, { 0x20000, 0x3FFFD, 2 },
  };

  for (size_t i = 0; i < sizeof ranges / sizeof *ranges; i++)
    {
      if (c >= ranges[i].least && c <= ranges[i].most)
        {
          return ranges[i].width;
        }
    }
  return 1;
}

/** Whether a character looks like a space or like nothing, and is no ASCII. */
static BOOL
is_invisible(unsigned c)
{
  return c == 0xA0 || c == 0xAD || c == 0x1680 || (c >= 0x2000 && c <= 0x200F)
    || c == 0x202F || (c >= 0x205F && c <= 0x2064) || c == 0x3000
    || c == 0xFEFF;
}

NSString *
utf8_quote(const char *at, size_t length)
{
  NSMutableString *quoted = [NSMutableString stringWithString: @"'"];
  size_t i = 0;

  for (unsigned n = 0; i < length && n < QUOTED_CHARACTERS; n++)
    {
      unsigned bytes, c = utf8_shown(at + i, length - i, &bytes);
      NSString *shown = c == REPLACEMENT
        ? [NSString stringWithFormat: @"%C", (unichar)REPLACEMENT]
        : is_invisible(c) ? [NSString stringWithFormat: @"<U+%04X>", c]
        : [[[NSString alloc] initWithBytes: at + i length: bytes
                                  encoding: NSUTF8StringEncoding]
            autorelease];
      [quoted appendString: shown];
      i += bytes;
    }
  [quoted appendString: i < length ? @"...'" : @"'"];
  return quoted;
}
