// utf8.h - the characters of a text in UTF-8: whether it is one, and how to
// show a part of it on a terminal.

#ifndef UTF8_H
#define UTF8_H

#import <Foundation/Foundation.h>

/** How many bytes from the start are well-formed UTF-8: `length` if all. */
size_t utf8_valid(const char *text, size_t length);

/** Whether a byte is the first of a character. */
static inline int
utf8_is_first(char byte)
{
  return (byte & 0xC0) != 0x80;
}

/** The character at a place that has at least one byte left, and how many
    bytes it has. What is no character, and what would confuse a terminal
    (control characters, changes of direction), is U+FFFD. A tab is a tab. */
unsigned utf8_shown(const char *at, size_t left, unsigned *bytes);

/** How many columns of a terminal a character takes: 0, 1 or 2. */
unsigned utf8_width(unsigned character);

/** A few words of a text in single quotes, for a message (autoreleased). What
    nobody would see, as a space that does not separate, is <U+00A0>. */
NSString *utf8_quote(const char *at, size_t length);

#endif
