// registry_t.h - from a block word to the class that reads it, at run time.

#import <Foundation/Foundation.h>

@interface registry_t : NSObject

/** The class `<word>_t`, if there is one and it adopts the protocol object_t;
    otherwise Nil, so that `ray` or `vec` find nothing. */
+ (Class) shapeForWord: (NSString *)word;

/** All words that shapeForWord: knows, sorted. */
+ (NSArray *) words;

@end
