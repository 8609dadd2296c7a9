// png_t.m

#import "png_t.h"
#import "errors.h"
#include "version.h"
#include <png.h>
#include <string.h>

static void
append(png_structp png, png_bytep bytes, png_size_t length)
{
  NSMutableData *file = png_get_io_ptr(png);

  [file appendBytes: bytes length: length];
}

static void
flush(png_structp png)
{
}

/** libpng must not return from here. */
static void
fail(png_structp png, png_const_charp message)
{
  NSError **error = png_get_error_ptr(png);

  *error = error_saying(STATUS_FILE, @"libpng: %s", message);
  png_longjmp(png, 1);
}

static void
ignore(png_structp png, png_const_charp message)
{
}

static void
write_picture(png_structp png, png_infop info, image_t *image)
{
  size_t across = [image width];
  png_text text;

  png_set_IHDR(png, info, [image width], [image height], 8,
               PNG_COLOR_TYPE_RGB, PNG_INTERLACE_NONE,
               PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
  if ([image width] != image->columns || [image height] != image->rows)
    {
      png_set_oFFs(png, info, image->window.x0, image->window.y0,
                   PNG_OFFSET_PIXEL);
    }
  memset(&text, 0, sizeof text);
  text.compression = PNG_TEXT_COMPRESSION_NONE;
  text.key = (char *)"Software";
  text.text = (char *)"raytrace " RAYTRACE_VERSION;
  png_set_text(png, info, &text, 1);
  png_write_info(png, info);
  for (unsigned y = 0; y < [image height]; y++)
    {
      png_write_row(png, image->bytes[y * across]);
    }
  png_write_end(png, info);
}

@implementation png_t

+ (NSData *) fileOf: (image_t *)image error: (NSError **)error
{
  NSMutableData *file = [NSMutableData data];
  NSError *failure = nil;
  NSError **failureAt = &failure;
  png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, failureAt,
                                            fail, ignore);
  png_infop info = png ? png_create_info_struct(png) : NULL;
  volatile BOOL isDone = NO;

  NSAssert(image->bytes, @"the image does not keep bytes");
  if (info == NULL)
    {
      failure = error_saying(STATUS_FILE, @"libpng: not enough memory");
    }
  else if (setjmp(png_jmpbuf(png)) == 0)
    {
      png_set_write_fn(png, file, append, flush);
      write_picture(png, info, image);
      isDone = YES;
    }
  png_destroy_write_struct(&png, &info);
  if (!isDone && error)
    {
      *error = *failureAt;
    }
  return isDone ? file : nil;
}

@end
