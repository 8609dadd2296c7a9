// ppm_t.m

#import "ppm_t.h"

@implementation ppm_t

+ (NSData *) fileOf: (image_t *)image
{
  NSString *header = [NSString stringWithFormat: @"P6\n%u %u\n255\n",
                               [image width], [image height]];
  NSData *ascii = [header dataUsingEncoding: NSASCIIStringEncoding];
  NSMutableData *file = [NSMutableData dataWithData: ascii];

  NSAssert(image->bytes, @"the image does not keep bytes");
  [file appendBytes: image->bytes
             length: sizeof *image->bytes * [image width] * [image height]];
  return file;
}

@end
