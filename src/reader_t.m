#import "reader_t.h"
#import "diag_t.h"
#include "attribute_check.h"
#include "number.h"
#include "utf8.h"

// After so many no more guesses are made.
#define ENOUGH_FAULTS 1000

@implementation reader_t

- (id) init: (text_t *)theText into: (store_t *)theStore
       diag: (diag_t *)theDiag
{
  if ((self = [super init]))
    {
      text = theText;
      store = theStore;
      diag = theDiag;
      c_locale = newlocale(LC_ALL_MASK, "C", NULL);
    }
  return self;
}

- (void) dealloc
{
  freelocale(c_locale);
  [super dealloc];
}

- (NSString *) owner
{
  return @"";
}

- (BOOL) endsValues: (struct token)t
{
  return NO;
}

// Faults

- (unsigned) orderOf: (struct token)t
{
  return cursor_order(&text->cursor, t.at);
}

- (BOOL) wantsFault: (const char *)at
{
  return [diag wantsFault: cursor_order(&text->cursor, at)];
}

- (void) fault: (const char *)at : (NSString *)format, ...
{
  va_list values;

  va_start(values, format);
  NSString *message = [[NSString alloc] initWithFormat: format
                                             arguments: values];
  va_end(values);
  [diag fault: [text placeAt: cursor_order(&text->cursor, at)]
             : @"%@", message];
  [message release];
}

- (NSString *) quote: (struct token)t
{
  return t.length == 0 ? @"the end of the file" : utf8_quote(t.at, t.length);
}

- (NSString *) nearestTo: (struct token)t among: (NSArray *)words
{
  if (t.length > LONGEST_WORD || [diag faultCount] > ENOUGH_FAULTS)
    {
      return nil;
    }

  NSAutoreleasePool *pool = [NSAutoreleasePool new];
  NSString *nearest = [diag_t nearestTo: token_string(t) among: words];

  [pool drain];
  return nearest;
}

- (NSString *) suggest: (struct token)t among: (NSArray *)words
{
  return t.length > LONGEST_WORD ? @""
    : [diag_t suggestionFor: token_string(t) among: words];
}

- (NSString *) advise: (struct token)t among: (NSArray *)words
{
  NSString *advice = [self suggest: t among: words];

  return [advice length] ? advice
    : [NSString stringWithFormat: @"; expected %@",
                attribute_list(words, @"or")];
}

// Values

/** Something else instead of the value number i. */
- (void) tooFew: (struct token)t for: (const struct attribute *)a
           have: (unsigned)i
{
  if ([self wantsFault: t.at])
    {
      NSString *some = i == 0 ? @""
        : [NSString stringWithFormat: @"%u and then ", i];
      [self fault: t.at : @"expected %@ for %s%@, found %@%@",
            attribute_expected(a, attribute_values(a)), a->name,
            [self owner], some, [self quote: t]];
    }
}

/** A number that the attribute does not allow, or something else. */
- (void) wrong: (struct token)t for: (const struct attribute *)a
           with: (enum number_result)result
{
  const char *reason = result == NUMBER_TOO_LARGE ? ", which is beyond 2^400"
    : result == NUMBER_TOO_SMALL ? ", which is not 0 but below 2^-400"
    : result == NUMBER_NOT_WHOLE ? "; digits only" : "";

  FAULT(t.at, @"expected %@ for %s%@, found %@%s", attribute_expected(a, 1),
        a->name, [self owner], [self quote: t], reason);
}

/** Takes the next token, which should be a number. */
static inline enum number_result
next_number(struct cursor *cursor, BOOL is_whole, locale_t c,
            struct token *t, double *value)
{
  token_skip_space(cursor);

  const char *end = is_whole ? NULL : number_read_short(cursor->at, value);

  if (end && token_byte(*end) != TOKEN_WORD)
    {
      *t = (struct token){ cursor->at, end - cursor->at };
      cursor->at = end;
      return NUMBER_GOOD;
    }
  *t = token_next(cursor);
  return is_whole ? number_read_whole(t->at, t->length, c, value)
    : number_read(t->at, t->length, c, value);
}

/** The same for numbers only. */
static BOOL
read_numbers(reader_t *self, const struct attribute *a, struct value *values)
{
  BOOL is_good = YES, is_zero = YES, is_whole = attribute_is_whole(a);
  text_t *text = self->text;
  const char *first = NULL;

  for (unsigned i = 0, n = attribute_values(a); i < n; i++)
    {
      double *value = &values[i].number;
      struct cursor here = text->cursor;
      struct token t;
      enum number_result result
        = next_number(&text->cursor, is_whole, self->c_locale, &t, value);

      if (result == NUMBER_NONE && (!token_is_word(t) || [self endsValues: t]))
        {
          text->cursor = here;
          [self tooFew: t for: a have: i];
          return NO;
        }
      if (result != NUMBER_GOOD || !attribute_allows(a, *value))
        {
          is_good = NO;
          [self wrong: t for: a with: result];
          if (result == NUMBER_NONE)
            {
              return NO;
            }
        }
      first = i == 0 ? t.at : first;
      is_zero = is_zero && *value == 0;
      values[i].order = cursor_order(&text->cursor, t.at);
    }
  if (is_good && is_zero && a->kind == ATTRIBUTE_VECTOR)
    {
      FAULT(first, @"expected a vector other than 0 0 0 for %s%@", a->name,
            [self owner]);
      return NO;
    }
  return is_good;
}

- (BOOL) isNumber: (struct token)t
{
  double value;

  return number_read(t.at, t.length, c_locale, &value) != NUMBER_NONE;
}

/** Whether values cannot go on here. */
- (BOOL) isAtEnd
{
  struct token t = token_peek(text->cursor);

  return !token_is_word(t) || [self endsValues: t];
}

- (BOOL) readWord: (const struct attribute *)a into: (struct value *)value
{
  struct cursor here = text->cursor;
  struct token t = token_next(&text->cursor);

  // A word that is an attribute too is a name when another one follows, and
  // an attribute when its values do.
  if (!token_is_word(t) || ([self endsValues: t] && ![self isAtEnd]))
    {
      text->cursor = here;
      [self tooFew: t for: a have: 0];
      return NO;
    }
  if (!attribute_allows_word(a, t))
    {
      FAULT(t.at, @"expected %@ for %s%@, found %@%@",
            attribute_expected(a, 1), a->name, [self owner], [self quote: t],
            [self suggest: t among: attribute_words(a)]);
      return NO;
    }
  value->word = t.at;
  value->length = t.length;
  value->order = [self orderOf: t];
  return YES;
}

- (BOOL) read: (const struct attribute *)a into: (struct value *)values
{
  return attribute_is_numeric(a) ? read_numbers(self, a, values)
    : [self readWord: a into: values];
}

@end
