// format_t.h - writes a model in canonical form: one way to write everything,
// so that files of the same content are the same text. docs/format.md says
// what it looks like.

#import "store_t.h"

@interface format_t : NSObject

/** The text for all blocks of a store without faults (autoreleased). */
+ (NSString *) textOf: (store_t *)store;

@end
