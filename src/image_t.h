// image_t.h - a picture, or a rectangle of one, as it was computed: colours
// in double precision, scene-linear, not clamped, and what the eye ray of
// each pixel hit. Rows run from the top, as in a file.

#import <Foundation/Foundation.h>
#include "kernel/k_vec.h"

/** A rectangle of pixels, half open, origin in the top left corner. */
struct window
{
  unsigned x0, y0, x1, y1;
};

struct pixel
{
  struct k_vec color;
};

/** What the ray through the middle of the pixel hit. */
struct surface_pixel
{
  double depth;         // distance from the eye; infinite: nothing
  struct k_vec N;       // outward unit normal; 0 0 0: nothing
  uint32_t object;      // number of the object, from 1; 0: nothing
};

/** One more number for each pixel, if asked for. */
enum plane
{
  PLANE_TRUNCATION,     // most that cut branches of the ray tree could change
                        // of a channel of the colour
  PLANE_SAMPLING,       // half the width of the interval that holds each
                        // channel of the true colour at the stated rate
  PLANE_SAMPLES,        // rays through the pixel
  PLANES
};

@interface image_t : NSObject
{
@public
  unsigned columns, rows;       // of the whole picture
  struct window window;         // the part of it that is here
  struct pixel *pixels;         // (y - y0) * (x1 - x0) + x - x0
  struct surface_pixel *surfaces;       // likewise; NULL unless asked for
  double *planes[PLANES];       // likewise
}

/** nil with an NSError in *error when there is not enough memory; every
    pixel is black at first. */
- (id) init: (unsigned)columns : (unsigned)rows
     window: (struct window)window
   surfaces: (BOOL)withSurfaces
      error: (NSError **)error;

/** Makes room for it, 0 at first; NO with an NSError in *error when there is
    not enough memory. */
- (BOOL) addPlane: (enum plane)plane error: (NSError **)error;

- (unsigned) width;     // of the window
- (unsigned) height;
- (struct pixel *) pixelAt: (unsigned)x : (unsigned)y;  // whole picture's x, y
- (struct surface_pixel *) surfaceAt: (unsigned)x : (unsigned)y;
- (double *) plane: (enum plane)plane at: (unsigned)x : (unsigned)y;

/** Replaces what no file may hold, NaN by 0 and infinity by the largest
    float, in the colours; returns how many numbers were NaN. */
- (NSUInteger) makeFinite;

/** round(255 clamp(c, 0, 1)); 0 for NaN. */
+ (uint8_t) byte: (double)c;

/** The colours as files of 8 bits hold them: red, green, blue of each pixel,
    row by row from the top (autoreleased). */
- (NSData *) bytes;

@end
