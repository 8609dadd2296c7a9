// image_t.m

#import "image_t.h"
#import "errors.h"
#import "machine.h"
#include "large.h"
#include <float.h>
#include <stdlib.h>

static double
made_finite(double c, NSUInteger *nanCount)
{
  if (isnan(c))
    {
      *nanCount += 1;
      return 0;
    }
  return isinf(c) ? copysign(FLT_MAX, c) : c;
}

@implementation image_t

- (id) init: (unsigned)columnCount : (unsigned)rowCount
     window: (struct window)part
   surfaces: (BOOL)withSurfaces
      error: (NSError **)error
{
  self = [super init];
  if (self == nil)
    {
      return nil;
    }
  NSAssert(part.x0 < part.x1 && part.x1 <= columnCount
           && part.y0 < part.y1 && part.y1 <= rowCount,
           @"the window is not a part of the picture");
  columns = columnCount;
  rows = rowCount;
  window = part;

  size_t each = sizeof *pixels + (withSurfaces ? sizeof *surfaces : 0);
  uint64_t count = (uint64_t)[self width] * [self height];
  double needed = (double)count * each; // may be past the largest integer
  double memory = machine_memory();

  if (needed <= memory)
    {
      pixels = calloc(count, sizeof *pixels);
      surfaces = withSurfaces ? calloc(count, sizeof *surfaces) : NULL;
      large_pages(pixels, count * sizeof *pixels);
    }
  if (pixels == NULL || (withSurfaces && surfaces == NULL))
    {
      if (error)
        {
          *error = error_saying(STATUS_FILE, @"not enough memory for %u x %u "
                                @"pixels: they take %.0f bytes, and the program "
                                @"may have %.0f in all",
                                [self width], [self height], needed, memory);
        }
      [self release];
      return nil;
    }
  return self;
}

- (BOOL) addPlane: (enum plane)plane error: (NSError **)error
{
  size_t count = (size_t)[self width] * [self height];

  planes[plane] = calloc(count, sizeof *planes[plane]);
  if (planes[plane] == NULL && error)
    {
      *error = error_saying(STATUS_FILE, @"not enough memory for one more "
                            @"channel of %u x %u pixels", [self width],
                            [self height]);
    }
  return planes[plane] != NULL;
}

- (void) dealloc
{
  for (enum plane plane = 0; plane < PLANES; plane++)
    {
      free(planes[plane]);
    }
  free(pixels);
  free(surfaces);
  [super dealloc];
}

- (unsigned) width
{
  return window.x1 - window.x0;
}

- (unsigned) height
{
  return window.y1 - window.y0;
}

- (struct pixel *) pixelAt: (unsigned)x : (unsigned)y
{
  return pixels + (size_t)(y - window.y0) * [self width] + (x - window.x0);
}

- (struct surface_pixel *) surfaceAt: (unsigned)x : (unsigned)y
{
  return surfaces + (size_t)(y - window.y0) * [self width] + (x - window.x0);
}

- (double *) plane: (enum plane)plane at: (unsigned)x : (unsigned)y
{
  return planes[plane] + (size_t)(y - window.y0) * [self width]
    + (x - window.x0);
}

- (NSUInteger) makeFinite
{
  NSUInteger nanCount = 0;
  size_t count = (size_t)[self width] * [self height];

  for (size_t i = 0; i < count; i++)
    {
      struct k_vec *color = &pixels[i].color;
      color->x = made_finite(color->x, &nanCount);
      color->y = made_finite(color->y, &nanCount);
      color->z = made_finite(color->z, &nanCount);
    }
  return nanCount;
}

static inline uint8_t
byte_of(double c)
{
  if (!(c > 0 && c < 1))
    {
      return c > 0 ? 255 : 0;
    }
  int whole = 255 * c;
  return whole + (255 * c - whole >= 0.5);
}

+ (uint8_t) byte: (double)c
{
  return byte_of(c);
}

- (NSData *) bytes
{
  size_t count = (size_t)[self width] * [self height];
  NSMutableData *data = [NSMutableData dataWithLength: 3 * count];
  uint8_t *byte = [data mutableBytes];

  for (size_t i = 0; i < count; i++)
    {
      *byte++ = byte_of(pixels[i].color.x);
      *byte++ = byte_of(pixels[i].color.y);
      *byte++ = byte_of(pixels[i].color.z);
    }
  return data;
}

@end
