// ppm_t.h - a picture as a binary PPM file (P6), the format of the course.

#import "image_t.h"

@interface ppm_t : NSObject

/** The whole file (autoreleased). */
+ (NSData *) fileOf: (image_t *)image;

@end
