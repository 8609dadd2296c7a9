#include "attribute_check.h"

NSArray *
attribute_words(const struct attribute *a)
{
  return [[NSString stringWithUTF8String: a->words]
           componentsSeparatedByString: @" "];
}

BOOL
attribute_allows_word(const struct attribute *a, struct token word)
{
  if (a->kind != ATTRIBUTE_WORD)
    {
      return YES;
    }
  for (const char *p = a->words; *p; p += strspn(p, " "))
    {
      size_t length = strcspn(p, " ");
      if (length == word.length && memcmp(p, word.at, length) == 0)
        {
          return YES;
        }
      p += length;
    }
  return NO;
}

NSString *
attribute_list(NSArray *words, NSString *conjunction)
{
  NSUInteger count = [words count];

  if (count < 2)
    {
      return [words lastObject];
    }
  NSString *first = [[words subarrayWithRange: NSMakeRange(0, count - 1)]
                      componentsJoinedByString: @", "];
  return [NSString stringWithFormat: @"%@ %@ %@", first, conjunction,
                   [words lastObject]];
}

static NSString *
range_text(const struct attribute *a)
{
  switch (a->range)
    {
    case RANGE_POSITIVE:
      return @" > 0";
    case RANGE_NOT_NEGATIVE:
      return @" >= 0";
    case RANGE_BETWEEN:
      return [NSString stringWithFormat: @" from %.15g to %.15g",
                       a->least, a->most];
    case RANGE_STRICTLY_BETWEEN:
      return [NSString stringWithFormat: @" > %.15g and < %.15g",
                       a->least, a->most];
    default:
      return a->kind == ATTRIBUTE_COLOR ? @" >= 0" : @"";
    }
}

NSString *
attribute_expected(const struct attribute *a, unsigned values)
{
  switch (a->kind)
    {
    case ATTRIBUTE_MATERIAL:
      return @"the name of a material";
    case ATTRIBUTE_NAME:
      return @"a name";
    case ATTRIBUTE_WORD:
      return attribute_list(attribute_words(a), @"or");
    default:
      break;
    }

  const char *number = attribute_is_whole(a) ? "whole number" : "number";

  return values == 1
    ? [NSString stringWithFormat: @"a %s%@", number, range_text(a)]
    : [NSString stringWithFormat: @"%u %ss%@", values, number, range_text(a)];
}

const struct attribute *
attribute_named(const struct attribute *table, struct token name)
{
  for (const struct attribute *a = table; a->name; a++)
    {
      if (token_is(name, a->name))
        {
          return a;
        }
    }
  return NULL;
}

NSArray *
attribute_names(const struct attribute *table)
{
  return attribute_names_of(table, UINT64_MAX);
}

NSArray *
attribute_names_of(const struct attribute *table, uint64_t bits)
{
  NSMutableArray *names = [NSMutableArray array];

  for (const struct attribute *a = table; a->name; a++, bits >>= 1)
    {
      if (bits & 1)
        {
          [names addObject: [NSString stringWithUTF8String: a->name]];
        }
    }
  return names;
}
