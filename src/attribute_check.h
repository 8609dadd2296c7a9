// attribute_check.h - what a table of attributes says about one value.

#ifndef ATTRIBUTE_CHECK_H
#define ATTRIBUTE_CHECK_H

#import <Foundation/Foundation.h>
#include "attribute.h"
#include "token.h"

/** Whether a table's name is the one asked for. */
static inline BOOL
attribute_is_named(const char *name, const char *asked)
{
  return name == asked || (*name == *asked && strcmp(name, asked) == 0);
}

/** How many values the attribute has. */
unsigned attribute_values(const struct attribute *a);

/** Whether its values are numbers; otherwise they are words. */
BOOL attribute_is_numeric(const struct attribute *a);

/** Whether they are whole numbers, of digits only. */
BOOL attribute_is_whole(const struct attribute *a);

/** Whether a number is in the attribute's range. */
BOOL attribute_allows(const struct attribute *a, double value);

/** Whether a word is one of the attribute's words, or it has none. */
BOOL attribute_allows_word(const struct attribute *a, struct token word);

/** The attribute's words (autoreleased). */
NSArray *attribute_words(const struct attribute *a);

/** What belongs there, for a message: "3 numbers >= 0" (autoreleased). */
NSString *attribute_expected(const struct attribute *a, unsigned values);

/** The attribute of that name in a table, or NULL. */
const struct attribute *attribute_named(const struct attribute *table,
                                        struct token name);

/** The names of a table's attributes, in its order (autoreleased). */
NSArray *attribute_names(const struct attribute *table);

/** The same of those whose bits are set. */
NSArray *attribute_names_of(const struct attribute *table, uint64_t bits);

/** "a, b or c" (autoreleased). */
NSString *attribute_list(NSArray *words, NSString *conjunction);

#endif
