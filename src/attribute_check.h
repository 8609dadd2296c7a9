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
static inline unsigned
attribute_values(const struct attribute *a)
{
  switch (a->kind)
    {
    case ATTRIBUTE_PAIR:
    case ATTRIBUTE_WHOLE_PAIR:
      return 2;
    case ATTRIBUTE_POINT:
    case ATTRIBUTE_VECTOR:
    case ATTRIBUTE_COLOR:
      return 3;
    default:
      return 1;
    }
}

/** Whether its values are numbers; otherwise they are words. */
static inline BOOL
attribute_is_numeric(const struct attribute *a)
{
  return a->kind != ATTRIBUTE_MATERIAL && a->kind != ATTRIBUTE_NAME
    && a->kind != ATTRIBUTE_WORD;
}

/** Whether they are whole numbers, of digits only. */
static inline BOOL
attribute_is_whole(const struct attribute *a)
{
  return a->kind == ATTRIBUTE_WHOLE || a->kind == ATTRIBUTE_WHOLE_PAIR;
}

/** Whether a number is in the attribute's range. */
static inline BOOL
attribute_allows(const struct attribute *a, double value)
{
  if (a->kind == ATTRIBUTE_COLOR && value < 0)
    {
      return NO;
    }
  switch (a->range)
    {
    case RANGE_POSITIVE:
      return value > 0;
    case RANGE_NOT_NEGATIVE:
      return value >= 0;
    case RANGE_BETWEEN:
      return value >= a->least && value <= a->most;
    case RANGE_STRICTLY_BETWEEN:
      return value > a->least && value < a->most;
    default:
      return YES;
    }
}

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
