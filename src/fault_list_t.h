// fault_list_t.h - the first twenty faults of a text, whatever the order in
// which they are found, and the number of all. Part of diag_t.

#import <Foundation/Foundation.h>
#include "place.h"

/** One fault. */
@interface fault_t : NSObject
{
@public
  struct place place;
  NSString *message;
}
@end

@interface fault_list_t : NSObject
{
@public
  NSMutableArray *shown;        // of fault_t, in the order of the text
  NSUInteger count;             // of all, the others too
@protected
  unsigned long last_counted;   // place of the last that is not shown
}

/** Whether a fault at this place is one of the first twenty. If not it is
    counted, once for one place. */
- (BOOL) wants: (unsigned long)order;

/** Adds a fault, unless it is not wanted or there is one at its place. */
- (void) add: (NSString *)message at: (struct place)place;

@end
