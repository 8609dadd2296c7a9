// image_t.m

#import "image_t.h"
#import "errors.h"
#import "machine.h"
#include "large.h"
#include <stdlib.h>

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

@implementation image_t

- (id) init: (unsigned)columnCount : (unsigned)rowCount
     window: (struct window)part
       keep: (enum keep)keep
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

  size_t of_color = [image_t bytesOfPixel: keep];
  size_t each = of_color + (withSurfaces ? sizeof *surfaces : 0);
  uint64_t count = (uint64_t)[self width] * [self height];
  double needed = (double)count * each; // may be past the largest integer
  double memory = machine_memory();

  void *kept = NULL;

  if (needed <= memory)
    {
      kept = calloc(count, of_color);
      surfaces = withSurfaces ? calloc(count, sizeof *surfaces) : NULL;
      large_pages(kept, count * of_color);
    }
  pixels = keep == KEEP_DOUBLES ? kept : NULL;
  floats = keep == KEEP_FLOATS ? kept : NULL;
  bytes = keep == KEEP_BYTES ? kept : NULL;
  if (kept == NULL || (withSurfaces && surfaces == NULL))
    {
      if (error)
        {
          *error = error_saying(STATUS_FILE, @"not enough memory for %u x %u "
                                @"pixels: they take %.0f bytes, and the "
                                @"program may have %.0f in all",
                                [self width], [self height], needed, memory);
        }
      [self release];
      return nil;
    }
  return self;
}

- (id) init: (unsigned)columnCount : (unsigned)rowCount
     window: (struct window)part
   surfaces: (BOOL)withSurfaces
      error: (NSError **)error
{
  return [self init: columnCount : rowCount window: part keep: KEEP_DOUBLES
           surfaces: withSurfaces error: error];
}

+ (size_t) bytesOfPixel: (enum keep)keep
{
  return keep == KEEP_DOUBLES ? sizeof *((image_t *)nil)->pixels
    : keep == KEEP_FLOATS ? sizeof *((image_t *)nil)->floats
    : sizeof *((image_t *)nil)->bytes;
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
  free(floats);
  free(bytes);
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

static void
put_floats(float (*to)[3], const struct k_vec *colors, unsigned count)
{
  for (unsigned i = 0; i < count; i++)
    {
      to[i][0] = image_float(colors[i].x);
      to[i][1] = image_float(colors[i].y);
      to[i][2] = image_float(colors[i].z);
    }
}

static void
put_bytes(uint8_t (*to)[3], const struct k_vec *colors, unsigned count)
{
  for (unsigned i = 0; i < count; i++)
    {
      to[i][0] = byte_of(colors[i].x);
      to[i][1] = byte_of(colors[i].y);
      to[i][2] = byte_of(colors[i].z);
    }
}

- (void) put: (const struct k_vec *)colors : (unsigned)count
          at: (unsigned)x : (unsigned)y
{
  size_t first = image_at(self, x, y);
  NSUInteger nans = 0;

  for (unsigned i = 0; i < count; i++)
    {
      nans += (isnan(colors[i].x) != 0) + (isnan(colors[i].y) != 0)
        + (isnan(colors[i].z) != 0);
    }
  if (nans)
    {
      __atomic_fetch_add(&nanCount, nans, __ATOMIC_RELAXED);
    }
  if (bytes)
    {
      put_bytes(bytes + first, colors, count);
    }
  else if (floats)
    {
      put_floats(floats + first, colors, count);
    }
  else
    {
      memcpy(pixels + first, colors, count * sizeof *pixels);
    }
}

- (struct pixel *) pixelAt: (unsigned)x : (unsigned)y
{
  return pixels + image_at(self, x, y);
}

- (struct surface_pixel *) surfaceAt: (unsigned)x : (unsigned)y
{
  return surfaces + image_at(self, x, y);
}

- (double *) plane: (enum plane)plane at: (unsigned)x : (unsigned)y
{
  return planes[plane] + image_at(self, x, y);
}

+ (uint8_t) byte: (double)c
{
  return byte_of(c);
}

@end
