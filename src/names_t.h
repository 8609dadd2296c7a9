// names_t.h - the names of a model's objects, one after the other in one piece
// of memory: half a million strings would take longer to make than the rest
// of a model, and more room.

#import <Foundation/Foundation.h>
#include "token.h"

@interface names_t : NSObject
{
  char *text;           // each is ended by a NUL
  unsigned length, capacity;
}

/** Adds a name; where it is. */
- (unsigned) add: (struct token)name;

/** The name that was added there (autoreleased). */
- (NSString *) nameAt: (unsigned)at;

@end
