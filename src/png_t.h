// png_t.h - a picture as a PNG file of 8 bits, written by libpng.

#import "image_t.h"

@interface png_t : NSObject

/** The whole file (autoreleased). It has no time in it. Of a part of a
    picture it holds that part's pixels, and their place in an oFFs chunk.
    nil with an NSError in *error when libpng fails. */
+ (NSData *) fileOf: (image_t *)image error: (NSError **)error;

@end
