// token.h - the words of a model's text: separated by white space, a brace is
// one wherever it stands, `#` starts a comment wherever it stands. A token is
// a piece of the text itself; nothing is copied.

#ifndef TOKEN_H
#define TOKEN_H

#import <Foundation/Foundation.h>
#include <string.h>

// No word of more bytes can be meant for one that is known.
#define LONGEST_WORD 64

/** A word or a brace; of length 0 at the end of the text. */
struct token
{
  const char *at;
  size_t length;
};

/** A place in one file's text, which a NUL ends. `shift` makes an offset in
    the file one in the text of the whole model, see text_t.h. */
struct cursor
{
  const char *at, *text;
  unsigned shift;
};

/** The order of a place in the text that the cursor is in. */
static inline unsigned
cursor_order(const struct cursor *cursor, const char *at)
{
  return cursor->shift + (unsigned)(at - cursor->text);
}

enum token_byte
{
  TOKEN_WORD, TOKEN_SPACE, TOKEN_BRACE, TOKEN_HASH, TOKEN_END
};

static inline enum token_byte
token_byte(char c)
{
  static const unsigned char kinds[256] = {
    [0] = TOKEN_END, ['\t'] = TOKEN_SPACE, ['\n'] = TOKEN_SPACE,
    ['\v'] = TOKEN_SPACE, ['\f'] = TOKEN_SPACE, ['\r'] = TOKEN_SPACE,
    [' '] = TOKEN_SPACE, ['#'] = TOKEN_HASH, ['{'] = TOKEN_BRACE,
    ['}'] = TOKEN_BRACE
  };
  return kinds[(unsigned char)c];
}

/** Goes past white space and comments. */
static inline void
token_skip_space(struct cursor *cursor)
{
  const char *p = cursor->at;

  for (;;)
    {
      while (token_byte(*p) == TOKEN_SPACE)
        {
          p++;
        }
      if (*p != '#')
        {
          break;
        }
      p += strcspn(p, "\n");
    }
  cursor->at = p;
}

/** Takes the next token. */
static inline struct token
token_next(struct cursor *cursor)
{
  token_skip_space(cursor);

  const char *start = cursor->at, *p = start;

  if (token_byte(*p) == TOKEN_BRACE)
    {
      p++;
    }
  else
    {
      while (token_byte(*p) == TOKEN_WORD)
        {
          p++;
        }
    }
  cursor->at = p;
  return (struct token){ start, p - start };
}

/** The next token, which stays where it is. */
static inline struct token
token_peek(struct cursor cursor)
{
  return token_next(&cursor);
}

static inline int
token_is(struct token t, const char *word)
{
  return strncmp(t.at, word, t.length) == 0 && word[t.length] == '\0';
}

static inline int
token_is_same(struct token a, struct token b)
{
  return a.length == b.length && memcmp(a.at, b.at, a.length) == 0;
}

static inline int
token_is_brace(struct token t)
{
  return t.length == 1 && token_byte(*t.at) == TOKEN_BRACE;
}

/** As a string (autoreleased). */
static inline NSString *
token_string(struct token t)
{
  return [[[NSString alloc] initWithBytes: t.at length: t.length
                                 encoding: NSUTF8StringEncoding] autorelease];
}

/** Any token but a brace. */
static inline int
token_is_word(struct token t)
{
  return t.length > 0 && !token_is_brace(t);
}

#endif
