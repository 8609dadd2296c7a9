// PNG and PPM files, read back: libpng's own reader, and the bytes of P6.

#import "errors.h"
#import "png_t.h"
#import "ppm_t.h"
#include "test.h"
#include <png.h>
#include <stdlib.h>

static image_t *
sample_image(struct window window)
{
  image_t *image = [[[image_t alloc] init: 50 : 40 window: window
                                     keep: KEEP_BYTES surfaces: NO
                                    error: NULL] autorelease];

  for (unsigned y = window.y0; y < window.y1; y++)
    {
      for (unsigned x = window.x0; x < window.x1; x++)
        {
          struct k_vec color = k_vec(x / 40.0, y / 50.0 - 0.2, (x ^ y) / 64.0);
          [image put: &color : 1 at: x : y];
        }
    }
  return image;
}

static void
test_ppm(image_t *image)
{
  NSData *file = [ppm_t fileOf: image];
  const char header[] = "P6\n33 27\n255\n";
  size_t length = sizeof header - 1;

  PASS([file length] == length + 3 * 33 * 27, "a PPM of the right length");
  PASS(memcmp([file bytes], header, length) == 0, "the header of P6");
  PASS(memcmp((char *)[file bytes] + length, image->bytes, 3 * 33 * 27) == 0,
       "then the pixels");
  PASS([file isEqual: [ppm_t fileOf: image]],
       "the same picture gives the same PPM");
}

static void
test_png(image_t *image)
{
  NSError *error = nil;
  NSData *file = [png_t fileOf: image error: &error];
  png_image reader = { .version = PNG_IMAGE_VERSION };
  uint8_t pixels[27][33][3];

  PASS(file && error == nil, "a PNG is made");
  PASS([file isEqual: [png_t fileOf: image error: NULL]],
       "the same picture gives the same PNG");
  PASS(png_image_begin_read_from_memory(&reader, [file bytes],
                                        [file length]),
       "libpng reads its header");
  PASS(reader.width == 33 && reader.height == 27
       && reader.format == PNG_FORMAT_RGB, "33 x 27 pixels of 3 x 8 bits");
  reader.format = PNG_FORMAT_RGB;
  PASS(png_image_finish_read(&reader, NULL, pixels, 0, NULL),
       "libpng reads its pixels");
  PASS(memcmp(pixels, image->bytes, sizeof pixels) == 0,
       "every pixel is as it was");
}

static BOOL
has_chunk(NSData *file, const char *name)
{
  const uint8_t *bytes = [file bytes];
  size_t at = 8;

  while (at + 8 <= [file length])
    {
      if (memcmp(bytes + at + 4, name, 4) == 0)
        {
          return YES;
        }
      at += 12 + png_get_uint_32(bytes + at);
    }
  return NO;
}

static void
test_chunks(image_t *part, image_t *whole)
{
  NSData *ofPart = [png_t fileOf: part error: NULL];
  NSData *ofWhole = [png_t fileOf: whole error: NULL];

  PASS(has_chunk(ofWhole, "IEND"), "the chunks are found");
  PASS(has_chunk(ofPart, "oFFs"), "a part says where it belongs");
  PASS(!has_chunk(ofWhole, "oFFs"), "a whole picture does not");
  PASS(!has_chunk(ofWhole, "tIME"), "there is no time in it");
  PASS(!has_chunk(ofWhole, "gAMA") && !has_chunk(ofWhole, "sRGB"),
       "nor a claim about its colours");
}

static void
test_failure(void)
{
  struct window window = { 0, 0, 1000001, 1 };
  image_t *image = [[[image_t alloc] init: 1000001 : 1 window: window
                                     keep: KEEP_BYTES surfaces: NO
                                    error: NULL] autorelease];
  NSError *error = nil;

  PASS([png_t fileOf: image error: &error] == nil,
       "what libpng refuses is no file");
  PASS([error code] == STATUS_FILE
       && [error_text(error) hasPrefix: @"libpng: "],
       "but an error: %s", [error_text(error) UTF8String]);
}

int
main(void)
{
  NSAutoreleasePool *pool = [[NSAutoreleasePool alloc] init];
  struct window part = { 4, 6, 37, 33 }, all = { 0, 0, 50, 40 };

  test_ppm(sample_image(part));
  test_png(sample_image(part));
  test_chunks(sample_image(part), sample_image(all));
  test_failure();
  [pool release];
  return test_done();
}
