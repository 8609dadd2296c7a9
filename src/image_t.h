// image_t.h - a picture, or a rectangle of one: its colours, kept as the file
// it is for will hold them, and what the eye ray of each pixel hit. Rows run
// from the top, as in a file.

#import <Foundation/Foundation.h>
#include "kernel/k_vec.h"
#include <float.h>

/** A rectangle of pixels, half open, origin in the top left corner. */
struct window
{
  unsigned x0, y0, x1, y1;
};

/** How colours are kept. Most of what a large picture with little in it takes
    is the memory it is put into, so it is no more than the file needs. */
enum keep
{
  KEEP_DOUBLES,         // as they were computed, for who looks at them;
                        // scene-linear, not clamped: 24 bytes a pixel
  KEEP_FLOATS,          // scene-linear, for exr_t: 12 bytes
  KEEP_BYTES            // 8 bits for png_t and ppm_t: 3 bytes
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

/** What a file of floats may hold of a number: 0 for NaN, and nothing past the
    largest float. */
static inline float
image_float(double c)
{
  if (isnan(c))
    {
      return 0;
    }
  return c > FLT_MAX ? FLT_MAX : c < -FLT_MAX ? -FLT_MAX : (float)c;
}

@interface image_t : NSObject
{
@public
  unsigned columns, rows;       // of the whole picture
  struct window window;         // the part of it that is here
  struct pixel *pixels;         // one of these three is there, the others are
  float (*floats)[3];           // NULL: pixel after pixel, see image_at
  uint8_t (*bytes)[3];
  struct surface_pixel *surfaces;       // likewise; NULL unless asked for
  double *planes[PLANES];       // likewise
  NSUInteger nanCount;  // numbers of colours that were NaN when they were put
}

/** nil with an NSError in *error when there is not enough memory; every
    pixel is black at first. */
- (id) init: (unsigned)columns : (unsigned)rows
     window: (struct window)window
       keep: (enum keep)keep
   surfaces: (BOOL)withSurfaces
      error: (NSError **)error;

/** One that keeps doubles. */
- (id) init: (unsigned)columns : (unsigned)rows
     window: (struct window)window
   surfaces: (BOOL)withSurfaces
      error: (NSError **)error;

/** Bytes that a pixel's colour takes. */
+ (size_t) bytesOfPixel: (enum keep)keep;

/** Makes room for it, 0 at first; NO with an NSError in *error when there is
    not enough memory. */
- (BOOL) addPlane: (enum plane)plane error: (NSError **)error;

- (unsigned) width;     // of the window
- (unsigned) height;

/** Gives `count` pixels of a row, from x, y on, their colours; any thread may,
    of pixels that are its own. Doubles are kept as they are; of the others
    none is NaN (it becomes 0) or infinite (the largest float). */
- (void) put: (const struct k_vec *)colors : (unsigned)count
          at: (unsigned)x : (unsigned)y;

/** The pixel of a picture of doubles; x, y are of the whole picture, here and
    below. */
- (struct pixel *) pixelAt: (unsigned)x : (unsigned)y;
- (struct surface_pixel *) surfaceAt: (unsigned)x : (unsigned)y;
- (double *) plane: (enum plane)plane at: (unsigned)x : (unsigned)y;

/** round(255 clamp(c, 0, 1)); 0 for NaN. */
+ (uint8_t) byte: (double)c;

@end

/** The number of a pixel in the arrays. */
static inline size_t
image_at(const image_t *image, unsigned x, unsigned y)
{
  const struct window *w = &image->window;

  return (size_t)(y - w->y0) * (w->x1 - w->x0) + (x - w->x0);
}
