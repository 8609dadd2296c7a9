// reader_t.h - what the readers of both kinds of model files share: values
// after an attribute's name, and faults that cost next to nothing when they
// are too many to be shown. Abstract; see mdl_t.h and nff_t.h.

#import "text_t.h"
#import "store_t.h"
#include <locale.h>

@class diag_t;

/** Notes a fault at a place of the file that is being read. The message is
    made only if it will be shown. */
#define FAULT(at, ...) \
  do \
    { \
      if ([self wantsFault: (at)]) \
        { \
          [self fault: (at) : __VA_ARGS__]; \
        } \
    } \
  while (0)

@interface reader_t : NSObject
{
  text_t *text;
  store_t *store;
  diag_t *diag;
  locale_t c_locale;
}

/** None of them is retained: they live as long as the load. */
- (id) init: (text_t *)text into: (store_t *)store diag: (diag_t *)diag;

/** Reads the values of an attribute. If they are not what it allows, notes
    that and returns NO; the text goes on with the token that was found
    instead of too few values, or behind a wrong one. */
- (BOOL) read: (const struct attribute *)a into: (struct value *)values;

/** What the attributes that are read belong to, " of sphere 'ball'"; for
    messages. To be overridden; here it is empty. */
- (NSString *) owner;

/** Whether a token starts something else where values are expected. To be
    overridden; here it is NO. */
- (BOOL) endsValues: (struct token)t;

/** Where a thing stands in the text of the model. */
- (unsigned) orderOf: (struct token)t;

/** Whether a fault at this place will be shown; notes it if not. */
- (BOOL) wantsFault: (const char *)at;

- (void) fault: (const char *)at : (NSString *)format, ...
  __attribute__((format(NSString, 2, 3)));

/** A token in a message: 'glas', or the end of the file (autoreleased). */
- (NSString *) quote: (struct token)t;

/** The word that was meant, or nil if none is near. After a thousand faults
    it is not looked for any more. */
- (NSString *) nearestTo: (struct token)t among: (NSArray *)words;

/** "; did you mean 'x'?", or nothing if none is near (autoreleased). */
- (NSString *) suggest: (struct token)t among: (NSArray *)words;

/** The same, or "; expected a, b or c" (autoreleased). */
- (NSString *) advise: (struct token)t among: (NSArray *)words;

/** Whether the token is a number, in range or not. */
- (BOOL) isNumber: (struct token)t;

@end
