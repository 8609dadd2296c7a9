// The picture in memory: where its pixels are, how they are kept, what becomes
// of numbers that no file may hold, how 8-bit values are rounded, what is too
// large.

#import "errors.h"
#import "image_t.h"
#import "sha256.h"
#include "test.h"
#include <float.h>

static image_t *
image_of(unsigned columns, unsigned rows, struct window window, BOOL surfaces,
         NSError **error)
{
  return [[[image_t alloc] init: columns : rows window: window
                       surfaces: surfaces error: error] autorelease];
}

static void
test_pixels(void)
{
  struct window window = { 3, 2, 7, 5 };
  image_t *image = image_of(10, 6, window, YES, NULL);

  PASS([image width] == 4 && [image height] == 3, "size of the window");
  PASS([image pixelAt: 3 : 2] == image->pixels,
       "the window's first pixel is the first");
  PASS([image pixelAt: 6 : 4] == image->pixels + 11,
       "the window's last pixel is the last");
  PASS([image surfaceAt: 4 : 3] == image->surfaces + 5,
       "surfaces lie as pixels do");
  PASS(image->pixels[11].color.z == 0, "pixels are black at first");
  PASS(image_of(10, 6, window, NO, NULL)->surfaces == NULL,
       "no surfaces unless asked for");
}

static image_t *
kept(unsigned columns, struct window window, enum keep keep, NSError **error)
{
  return [[[image_t alloc] init: columns : window.y1 window: window keep: keep
                       surfaces: NO error: error] autorelease];
}

static void
test_finite(void)
{
  struct window window = { 3, 2, 5, 4 };
  image_t *doubles = kept(6, window, KEEP_DOUBLES, NULL);
  image_t *floats = kept(6, window, KEEP_FLOATS, NULL);
  image_t *bytes = kept(6, window, KEEP_BYTES, NULL);
  image_t *images[] = { doubles, floats, bytes };
  const struct k_vec colors[] = { k_vec(NAN, INFINITY, -INFINITY),
                                  k_vec(-NAN, 1e300, -2) };

  for (int i = 0; i < 3; i++)
    {
      [images[i] put: &colors[1] : 1 at: 4 : 2];
      PASS(images[i]->nanCount == 1, "a NaN is counted");
      [images[i] put: colors : 2 at: 3 : 3];
      PASS(images[i]->nanCount == 3, "NaNs are counted");
    }
  PASS(memcmp(doubles->pixels + 2, colors, sizeof colors) == 0
       && memcmp(doubles->pixels + 1, colors + 1, sizeof *colors) == 0,
       "doubles are kept as they are");
  float (*f)[3] = floats->floats + 2;
  PASS(f[0][0] == 0 && !signbit(f[0][0]), "NaN becomes 0");
  PASS(f[1][0] == 0 && !signbit(f[1][0]), "-NaN becomes 0");
  PASS(f[0][1] == FLT_MAX, "infinity becomes the largest float");
  PASS(f[0][2] == -FLT_MAX, "so does -infinity");
  PASS(f[1][1] == FLT_MAX, "and what is past it");
  PASS(f[1][2] == -2, "what is negative stays");
  PASS(floats->floats[0][0] == 0 && floats->floats[1][1] == FLT_MAX,
       "the row before is one of its own");
  PASS(memcmp(bytes->bytes, "\0\0\0\0\377\0\0\377\0\0\377\0", 12) == 0,
       "bytes: NaN is 0, infinity 255");
}

static void
test_bytes(void)
{
  struct window window = { 0, 0, 2, 1 };
  image_t *image = kept(2, window, KEEP_BYTES, NULL);
  const struct k_vec colors[] = { k_vec(0, 0.2, 0.4), k_vec(0.6, 0.8, 1) };
  int wrong = 0;

  for (int i = 0; i <= 255; i++)
    {
      wrong += [image_t byte: i / 255.0] != i;
      wrong += [image_t byte: (i + 0.499999) / 255] != i;
      wrong += [image_t byte: (i - 0.499999) / 255] != i;
    }
  PASS(wrong == 0, "every byte is round(255 c)");
  PASS([image_t byte: 0.5] == 128, "127.5 is rounded up");
  PASS([image_t byte: -1] == 0 && [image_t byte: -INFINITY] == 0,
       "less than 0 is 0");
  PASS([image_t byte: 2] == 255 && [image_t byte: INFINITY] == 255,
       "more than 1 is 255");
  PASS([image_t byte: NAN] == 0, "NaN is 0");
  PASS(memcmp(image->bytes, "\0\0\0\0\0\0", 6) == 0, "black at first");
  [image put: colors : 2 at: 0 : 0];
  PASS(memcmp(image->bytes, "\0\x33\x66\x99\xcc\xff", 6) == 0,
       "red, green, blue, pixel after pixel");
}

static void
test_memory(void)
{
  struct window whole = { 0, 0, 1000000, 1000000 };
  struct window largest = { 0, 0, 4294967295u, 4294967295u };
  NSError *error = nil;

  PASS(image_of(1000000, 1000000, whole, NO, &error) == nil,
       "10^12 pixels are refused");
  PASS([error code] == STATUS_FILE, "with the status for memory");
  PASS([error_text(error) hasPrefix: @"not enough memory for 1000000 x "
         @"1000000 pixels: they take 24000000000000 bytes, and the program may"],
       "and a message with the size: %s", [error_text(error) UTF8String]);
  error = nil;
  PASS(kept(1000000, whole, KEEP_FLOATS, &error) == nil
       && [error_text(error) rangeOfString: @" 12000000000000 "].length,
       "so are floats, which are half of that");
  error = nil;
  PASS(kept(1000000, whole, KEEP_BYTES, &error) == nil
       && [error_text(error) rangeOfString: @" 3000000000000 "].length,
       "and bytes, an eighth");
  error = nil;
  PASS(image_of(4294967295u, 4294967295u, largest, YES, &error) == nil
       && error, "a size past 2^64 bytes is refused");
}

static void
test_hash(void)
{
  // FIPS 180-2, appendix B.1.
  NSData *abc = [@"abc" dataUsingEncoding: NSASCIIStringEncoding];

  PASS([sha256_of(abc) isEqual: @"ba7816bf8f01cfea414140de5dae2223"
                                @"b00361a396177a9cb410ff61f20015ad"],
       "SHA-256 of abc");
  PASS([sha256_of([NSData data]) hasPrefix: @"e3b0c44298fc1c14"],
       "SHA-256 of nothing");
}

int
main(void)
{
  NSAutoreleasePool *pool = [[NSAutoreleasePool alloc] init];

  test_pixels();
  test_finite();
  test_bytes();
  test_memory();
  test_hash();
  [pool release];
  return test_done();
}
