// exr_t.h - a picture as an OpenEXR file: scene-linear 32-bit float, ZIP
// compressed, written through OpenEXR's C interface. Channels:
//
//   R G B         the colour
//   Z             depth: the distance from the eye; nothing hit: the
//                 largest float
//   N.X N.Y N.Z   the outward unit normal in world space; nothing hit: 0
//   id            uint: the number of the object, from 1 in the order of
//                 declaration; nothing hit: 0
//   error.truncation
//                 the most that rays which were not traced, too deep or of too
//                 little weight, could change of R, G or B
//   error.sampling
//                 how far R, G and B may each be from what more and more rays
//                 would give, at the confidence of the attribute
//                 raytrace:confidence
//   samples       uint: the number of rays through the pixel
//
// The data window is the part of the picture that is there, the display
// window is the whole. The same picture always gives the same bytes.

#import "image_t.h"

/** The channels beside R, G and B. */
enum aov
{
  AOV_DEPTH = 1,
  AOV_NORMAL = 2,
  AOV_OBJECT = 4,
  AOV_TRUNCATION = 8,
  AOV_SAMPLING = 16,
  AOV_SAMPLES = 32
};

/** Those that need the picture to have surfaces. */
#define AOV_SURFACES (AOV_DEPTH | AOV_NORMAL | AOV_OBJECT)

@interface exr_t : NSObject

/** The whole file (autoreleased) of an image that keeps floats. `aovs` is a sum
    of enum aov: the image must have surfaces, or the plane, for them.
    `attributes` are strings by name, to be written as attributes of the header.
    A number that no float can hold becomes the largest one, NaN becomes 0. nil
    with an NSError in *error when OpenEXR fails. */
+ (NSData *) fileOf: (image_t *)image
               aovs: (unsigned)aovs
         attributes: (NSDictionary *)attributes
              error: (NSError **)error;

@end
