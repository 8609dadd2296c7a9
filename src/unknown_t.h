// unknown_t.h - what is said of names that no material has.

#import "store_t.h"
#import "text_t.h"

@class diag_t;

@interface unknown_t : NSObject
{
  store_t *store;               // these three are not retained: they live
  text_t *text;                 // as long as the load
  diag_t *diag;
  NSMutableArray *names;        // of all materials, when asked for
  NSMutableDictionary *told;    // by name, what is to be said the next time:
                                // nothing if it is empty
}

- (id) init: (store_t *)store text: (text_t *)text diag: (diag_t *)diag;

/** Notes that a block names a material that does not exist. A name that is
    near that of a material which others use is a slip in each place. Any other
    is a material that is missing or has got a wrong name itself: that is
    told once. That there is no material at all is told once, too. */
- (void) refuse: (struct value)value of: (const struct record *)record;

@end
