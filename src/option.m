// option.m

#import "option.h"
#import "diag_t.h"
#include "number.h"
#include <ctype.h>
#include <errno.h>
#include <stdlib.h>

NSString *
option_name(const struct option *option)
{
  return [NSString stringWithFormat: @"--%s", option->name];
}

const struct option *
option_written(NSString *text)
{
  for (const struct option *o = option_table; o->name; o++)
    {
      if ([option_name(o) isEqual: text]
          || (o->letter
              && [[NSString stringWithFormat: @"-%c", o->letter]
                   isEqual: text]))
        {
          return o;
        }
    }
  return NULL;
}

static void *
place(const struct option *option, const struct settings *settings)
{
  return (char *)settings + option->offset;
}

void
option_reset(struct settings *settings)
{
  for (const struct option *o = option_table; o->name; o++)
    {
      if (o->kind == OPTION_WORD || o->kind == OPTION_WHOLE)
        {
          *(uint64_t *)place(o, settings) = o->standard;
        }
      else if (o->kind == OPTION_NUMBER)
        {
          *(double *)place(o, settings) = o->usual;
        }
    }
}

static NSArray *
words_of(const struct option *option)
{
  return [[NSString stringWithUTF8String: option->words]
           componentsSeparatedByString: @" "];
}

/** Digits only, so no sign, no space, no fraction. */
static BOOL
read_whole(const char **text, const struct option *option, uint64_t *value)
{
  char *end;

  if (**text < '0' || **text > '9')
    {
      return NO;
    }
  errno = 0;
  *value = strtoull(*text, &end, 10);
  *text = end;
  return errno == 0 && *value >= option->least && *value <= option->most;
}

static BOOL
read_wholes(const struct option *option, NSString *value, uint64_t *numbers)
{
  const char *text = [value UTF8String];
  uint64_t read[4];

  for (unsigned i = 0; i < option->count; i++)
    {
      if ((i > 0 && *text++ != option->separator)
          || !read_whole(&text, option, &read[i]))
        {
          return NO;
        }
    }
  memcpy(numbers, read, option->count * sizeof *read);
  return *text == '\0';
}

static BOOL
is_in_range(const struct option *option, double number)
{
  return number <= option->high
    && (option->is_above_low ? number > option->low : number >= option->low);
}

/** As in a model file, or two such with a / between. */
static BOOL
read_number(const struct option *option, NSString *value, double *number)
{
  NSArray *words = [value componentsSeparatedByString: @"/"];
  locale_t c = newlocale(LC_ALL_MASK, "C", (locale_t)0);
  double read[2] = { 0, 1 };
  BOOL isGood = [words count] <= 2;

  for (NSUInteger i = 0; isGood && i < [words count]; i++)
    {
      const char *word = [[words objectAtIndex: i] UTF8String];
      isGood = !isspace((unsigned char)*word)
        && number_read(word, strlen(word), c, &read[i]) == NUMBER_GOOD;
    }
  freelocale(c);
  double quotient = read[0] / read[1];
  if (!isGood || !is_in_range(option, quotient))
    {
      return NO;
    }
  *number = quotient + 0.0;     // -0 is 0
  return YES;
}

static BOOL
read_words(const struct option *option, NSString *value, uint64_t *bits)
{
  *bits = 0;
  for (NSString *word in [value componentsSeparatedByString: @","])
    {
      NSUInteger i = [words_of(option) indexOfObject: word];
      if (i == NSNotFound)
        {
          return NO;
        }
      if (*bits & 1u << i)
        {
          return NO;    // it is there twice
        }
      *bits |= 1u << i;
    }
  return YES;
}

static BOOL
read_value(const struct option *option, NSString *value,
            struct settings *settings)
{
  uint64_t *number = place(option, settings);
  NSString **text = place(option, settings);
  NSMutableArray **texts = place(option, settings);
  NSUInteger word;

  switch (option->kind)
    {
    case OPTION_FLAG:
      *number = 1;
      return YES;
    case OPTION_WHOLE:
      return read_wholes(option, value, number);
    case OPTION_NUMBER:
      return read_number(option, value, place(option, settings));
    case OPTION_WORD:
      word = [words_of(option) indexOfObject: value];
      if (word != NSNotFound)
        {
          *number = word;
        }
      return word != NSNotFound;
    case OPTION_WORDS:
      return read_words(option, value, number);
    case OPTION_TEXT:
      ASSIGNCOPY(*text, value);
      return [value length] > 0;
    case OPTION_TEXTS:
      [*texts addObject: value];
      return [value length] > 0;
    }
  return NO;
}

static NSString *
number_text(double number)
{
  locale_t c = newlocale(LC_ALL_MASK, "C", (locale_t)0);
  char text[32];

  number_write(number, c, text);
  freelocale(c);
  return [NSString stringWithUTF8String: text];
}

/** What the option takes. */
static NSString *
expected(const struct option *option)
{
  NSString *words = option->words
    ? [words_of(option) componentsJoinedByString: @", "] : nil;

  switch (option->kind)
    {
    case OPTION_WHOLE:
      return [NSString stringWithFormat: @"%s%s from %llu to %llu",
                       option->count == 1 ? "a whole number" : option->value,
                       option->count == 1 ? "" : ", whole numbers",
                       (unsigned long long)option->least,
                       (unsigned long long)option->most];
    case OPTION_NUMBER:
      return [NSString stringWithFormat: @"a number %s %@ %s %@, or a"
                       @" fraction such as 1/255",
                       option->is_above_low ? "above" : "from",
                       number_text(option->low),
                       option->is_above_low ? "up to" : "to",
                       number_text(option->high)];
    case OPTION_WORD:
      return [@"one of " stringByAppendingString: words];
    case OPTION_WORDS:
      return [NSString stringWithFormat: @"some of %@, with commas between and"
                       @" each once", words];
    default:
      return [NSString stringWithFormat: @"a %s", option->value];
    }
}

BOOL
option_wants_value(const struct option *option)
{
  return option->kind != OPTION_FLAG && !option->may_be_bare;
}

NSString *
option_take(const struct option *option, NSString *value,
            struct settings *settings)
{
  NSString *name = option_name(option);
  NSString *meant = @"";

  if (value == nil && option_wants_value(option))
    {
      return [NSString stringWithFormat: @"option '%@' needs %@", name,
                       expected(option)];
    }
  if (value && option->kind == OPTION_FLAG)
    {
      return [NSString stringWithFormat:
                         @"option '%@' takes no value, but got '%@'",
                       name, value];
    }
  if (value == nil && option->may_be_bare)
    {
      value = [words_of(option) objectAtIndex: 1];
    }
  if (read_value(option, value, settings))
    {
      return nil;
    }
  if (option->kind == OPTION_WORD)
    {
      meant = [diag_t suggestionFor: value among: words_of(option)];
    }
  return [NSString stringWithFormat: @"option '%@' takes %@, not '%@'%@",
                   name, expected(option), value, meant];
}

NSString *
option_value(const struct option *option, const struct settings *settings)
{
  const uint64_t *numbers = place(option, settings);

  if (option->kind == OPTION_WORD)
    {
      NSArray *words = words_of(option);
      return numbers[0] < [words count] ? [words objectAtIndex: numbers[0]]
        : nil;
    }
  if (option->kind == OPTION_FLAG)
    {
      return numbers[0] ? @"" : nil;
    }
  if (option->kind == OPTION_NUMBER)
    {
      double number = *(double *)place(option, settings);
      return is_in_range(option, number) ? number_text(number) : nil;
    }
  if (option->kind != OPTION_WHOLE || numbers[0] < option->least
      || numbers[0] > option->most)
    {
      return nil;
    }
  NSMutableString *value = [NSMutableString string];
  for (unsigned i = 0; i < option->count; i++)
    {
      if (i > 0)
        {
          [value appendFormat: @"%c", option->separator];
        }
      [value appendFormat: @"%llu", (unsigned long long)numbers[i]];
    }
  return value;
}
