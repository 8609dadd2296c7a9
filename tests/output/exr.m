// OpenEXR files, read back by OpenEXR: channels, values, windows, attributes.

#import "errors.h"
#import "exr_t.h"
#include "random.h"
#include "test.h"
#include <float.h>
#include <openexr.h>
#include <stdlib.h>

// A part of a picture whose numbers tell where they are. Its height is not a
// whole number of chunks.
enum { COLUMNS = 40, ROWS = 50, X0 = 3, Y0 = 5, X1 = 36, Y1 = 46 };
enum { WIDTH = X1 - X0, HEIGHT = Y1 - Y0, CHANNELS = 8 };

/** Its colours, some of which no float can hold. */
static struct k_vec
color_at(unsigned x, unsigned y)
{
  if (y == Y0 && x <= X0 + 1)
    {
      return x == X0 ? k_vec(NAN, 1e39, -1e300)
        : k_vec(INFINITY, nextafter(FLT_MAX, INFINITY), 1e-60);
    }
  return k_vec(x + y / 64.0, -0.1 * x, 1e10 * y);
}

static image_t *
sample_image(void)
{
  struct window window = { X0, Y0, X1, Y1 };
  image_t *image = [[[image_t alloc] init: COLUMNS : ROWS window: window
                                     keep: KEEP_FLOATS surfaces: YES
                                    error: NULL] autorelease];

  for (unsigned y = Y0; y < Y1; y++)
    {
      for (unsigned x = X0; x < X1; x++)
        {
          struct surface_pixel *surface = [image surfaceAt: x : y];
          struct k_vec color = color_at(x, y);
          [image put: &color : 1 at: x : y];
          surface->depth = x == y ? INFINITY : 100 + x * y;
          surface->N = k_vec(x == y ? 0 : 0.6, 0, x == y ? 0 : -0.8);
          surface->object = x == y ? 0 : 0x12345678 + x + 1000 * y;
        }
    }
  return image;
}

/** A file as OpenEXR reads it. */
struct reading
{
  NSData *bytes;
  exr_context_t file;
  unsigned count;
  char names[CHANNELS][8];
  exr_pixel_type_t types[CHANNELS];
  uint32_t values[CHANNELS][HEIGHT][WIDTH];     // bits
};

static int64_t
read_bytes(exr_const_context_t context, void *user, void *bytes,
           uint64_t length, uint64_t offset,
           exr_stream_error_func_ptr_t error)
{
  NSData *file = ((struct reading *)user)->bytes;

  if (offset + length > [file length])
    {
      length = offset < [file length] ? [file length] - offset : 0;
    }
  [file getBytes: bytes range: NSMakeRange(offset, length)];
  return length;
}

static int64_t
size_of(exr_const_context_t context, void *user)
{
  return [((struct reading *)user)->bytes length];
}

static int
start(struct reading *reading, NSData *bytes)
{
  exr_context_initializer_t doors = EXR_DEFAULT_CONTEXT_INITIALIZER;
  const exr_attr_chlist_t *list;

  reading->bytes = bytes;
  doors.user_data = reading;
  doors.read_fn = read_bytes;
  doors.size_fn = size_of;
  if (exr_start_read(&reading->file, "memory", &doors) != EXR_ERR_SUCCESS
      || exr_get_channels(reading->file, 0, &list) != EXR_ERR_SUCCESS)
    {
      return 0;
    }
  reading->count = list->num_channels;
  for (unsigned c = 0; c < reading->count && c < CHANNELS; c++)
    {
      snprintf(reading->names[c], sizeof reading->names[c], "%s",
               list->entries[c].name.str);
      reading->types[c] = list->entries[c].pixel_type;
    }
  return 1;
}

static int
read_chunk(struct reading *reading, int y, int *height)
{
  exr_decode_pipeline_t decoder = EXR_DECODE_PIPELINE_INITIALIZER;
  exr_chunk_info_t chunk;
  exr_result_t result;

  result = exr_read_scanline_chunk_info(reading->file, 0, y, &chunk);
  if (result != EXR_ERR_SUCCESS)
    {
      return 0;
    }
  *height = chunk.height;
  exr_decoding_initialize(reading->file, 0, &chunk, &decoder);
  for (unsigned c = 0; c < reading->count; c++)
    {
      exr_coding_channel_info_t *to = &decoder.channels[c];
      to->user_bytes_per_element = 4;
      to->user_data_type = reading->types[c];
      to->user_pixel_stride = 4;
      to->user_line_stride = 4 * WIDTH;
      to->decode_to_ptr = (uint8_t *)reading->values[c][y - Y0];
    }
  result = exr_decoding_choose_default_routines(reading->file, 0, &decoder);
  if (result == EXR_ERR_SUCCESS)
    {
      result = exr_decoding_run(reading->file, 0, &decoder);
    }
  exr_decoding_destroy(reading->file, &decoder);
  return result == EXR_ERR_SUCCESS;
}

static int
read_pixels(struct reading *reading)
{
  int height = 0;

  for (int y = Y0; y < Y1; y += height)
    {
      if (!read_chunk(reading, y, &height))
        {
          return 0;
        }
    }
  return 1;
}

/** The bits that stand for a number of the picture. */
static uint32_t
bits_of(double number)
{
  double limited = isnan(number) ? 0
    : number > FLT_MAX ? FLT_MAX : number < -FLT_MAX ? -FLT_MAX : number;
  float narrow = (float)limited;
  uint32_t bits;

  memcpy(&bits, &narrow, sizeof bits);
  return bits;
}

static void
test_values(struct reading *reading, image_t *image)
{
  int wrong[CHANNELS] = { 0 };

  for (unsigned y = Y0; y < Y1; y++)
    {
      for (unsigned x = X0; x < X1; x++)
        {
          struct k_vec color = color_at(x, y);
          struct surface_pixel *surface = [image surfaceAt: x : y];
          uint32_t want[CHANNELS] = {
            bits_of(color.z), bits_of(color.y), bits_of(surface->N.x),
            bits_of(surface->N.y), bits_of(surface->N.z), bits_of(color.x),
            bits_of(surface->depth), surface->object
          };
          for (int c = 0; c < CHANNELS; c++)
            {
              wrong[c] += reading->values[c][y - Y0][x - X0] != want[c];
            }
        }
    }
  for (int c = 0; c < CHANNELS; c++)
    {
      PASS(wrong[c] == 0, "every value of %s is as it was",
           reading->names[c]);
    }
  PASS(reading->values[5][0][0] == 0, "NaN is 0 in the file");
  PASS(reading->values[1][0][0] == bits_of(FLT_MAX)
       && reading->values[1][0][1] == bits_of(FLT_MAX)
       && reading->values[5][0][1] == bits_of(FLT_MAX),
       "what is past the largest float is the largest float");
}

static void
test_header(struct reading *reading)
{
  static const char *const names[CHANNELS] = {
    "B", "G", "N.X", "N.Y", "N.Z", "R", "Z", "id"
  };
  exr_attr_box2i_t data, display;
  exr_compression_t compression;
  int32_t length;
  const char *text = "";
  int wrong = 0;

  PASS(reading->count == CHANNELS, "eight channels");
  for (int c = 0; c < CHANNELS; c++)
    {
      wrong += strcmp(reading->names[c], names[c]) != 0;
      wrong += reading->types[c]
        != (c == CHANNELS - 1 ? EXR_PIXEL_UINT : EXR_PIXEL_FLOAT);
    }
  PASS(wrong == 0, "their names in alphabetical order, and their types");
  exr_get_data_window(reading->file, 0, &data);
  exr_get_display_window(reading->file, 0, &display);
  exr_get_compression(reading->file, 0, &compression);
  PASS(data.min.x == X0 && data.min.y == Y0 && data.max.x == X1 - 1
       && data.max.y == Y1 - 1, "the data window is the part that is there");
  PASS(display.min.x == 0 && display.min.y == 0
       && display.max.x == COLUMNS - 1 && display.max.y == ROWS - 1,
       "the display window is the whole picture");
  PASS(compression == EXR_COMPRESSION_ZIP, "zip compression");
  exr_attr_get_string(reading->file, 0, "raytrace:seed", &length, &text);
  PASS(strcmp(text, "12") == 0, "an attribute");
  text = "x";
  exr_attr_get_string(reading->file, 0, "empty", &length, &text);
  PASS(length == 0, "an empty attribute");
}

static void
test_aovs(image_t *image)
{
  static const char *const channels[8] = {
    "B G R", "B G R Z", "B G N.X N.Y N.Z R", "B G N.X N.Y N.Z R Z",
    "B G R id", "B G R Z id", "B G N.X N.Y N.Z R id",
    "B G N.X N.Y N.Z R Z id"
  };

  for (unsigned aovs = 0; aovs < 8; aovs++)
    {
      struct reading reading = { .count = 0 };
      NSData *file = [exr_t fileOf: image aovs: aovs attributes: nil
                             error: NULL];
      char names[64] = "";
      start(&reading, file);
      for (unsigned c = 0; c < reading.count; c++)
        {
          size_t used = strlen(names);
          snprintf(names + used, sizeof names - used, "%s%s", c ? " " : "",
                   reading.names[c]);
        }
      exr_finish(&reading.file);
      PASS(strcmp(names, channels[aovs]) == 0, "channels %s, found %s",
           channels[aovs], names);
    }
}

/** A number of any bits, but that it is finite. */
static double
noise(struct support_random *random)
{
  float number;

  do
    {
      uint32_t bits = support_unit(random) * 0x1p32;
      memcpy(&number, &bits, sizeof number);
    }
  while (!isfinite(number));
  return number;
}

/** Noise, which does not get smaller by packing, with zeros in it until it
    does: at some number of them the size stays the same. */
static void
test_noise(void)
{
  static struct k_vec colors[WIDTH * HEIGHT];
  struct support_random random = support_seed(1);
  unsigned wrong = 0;

  for (unsigned zeros = 0; zeros < 600; zeros++)
    {
      NSAutoreleasePool *pool = [[NSAutoreleasePool alloc] init];
      struct reading reading = { 0 };
      image_t *image = sample_image();
      for (unsigned i = 0; i < WIDTH * HEIGHT; i++)
        {
          struct k_vec color;
          unsigned in_chunk = i % (16 * WIDTH);
          color = k_vec(noise(&random), noise(&random), noise(&random));
          color.x = in_chunk < zeros / 6 ? 0 : color.x;
          [image put: &color : 1 at: X0 + i % WIDTH : Y0 + i / WIDTH];
          colors[i] = color;
        }
      NSData *bytes = [exr_t fileOf: image aovs: 0 attributes: nil error: NULL];
      if (!start(&reading, bytes) || !read_pixels(&reading))
        {
          wrong += WIDTH * HEIGHT;
        }
      for (unsigned i = 0; i < WIDTH * HEIGHT; i++)
        {
          struct k_vec color = colors[i];
          unsigned x = i % WIDTH, y = i / WIDTH;
          wrong += reading.values[0][y][x] != bits_of(color.z)
            || reading.values[1][y][x] != bits_of(color.y)
            || reading.values[2][y][x] != bits_of(color.x);
        }
      exr_finish(&reading.file);
      [pool release];
    }
  PASS(wrong == 0, "noise is read back: %u pixels are not", wrong);
}

/** The float of a bound is the least that is not below it. */
static void
test_bounds(void)
{
  struct support_random random = support_seed(2);
  struct reading reading = { 0 };
  image_t *image = sample_image();
  unsigned wrong = 0;

  [image addPlane: PLANE_TRUNCATION error: NULL];
  double *bounds = image->planes[PLANE_TRUNCATION];
  for (unsigned i = 0; i < WIDTH * HEIGHT; i++)
    {
      bounds[i] = i == 0 ? HUGE_VAL : i == 1 ? 0.5
        : support_unit(&random) * exp2(i % 40 - 20.0);
    }
  NSData *bytes = [exr_t fileOf: image aovs: AOV_TRUNCATION attributes: nil
                          error: NULL];
  PASS(start(&reading, bytes) && read_pixels(&reading), "bounds are read back");
  for (unsigned i = 0; i < WIDTH * HEIGHT; i++)
    {
      float bound;
      memcpy(&bound, &reading.values[3][i / WIDTH][i % WIDTH], sizeof bound);
      wrong += i == 0 ? bound != FLT_MAX
        : !(bound >= bounds[i] && nextafterf(bound, 0) < bounds[i]);
    }
  exr_finish(&reading.file);
  PASS(wrong == 0, "none is below what it was, nor above by more than a"
       " rounding: %u", wrong);
}

int
main(void)
{
  NSAutoreleasePool *pool = [[NSAutoreleasePool alloc] init];
  image_t *image = sample_image();
  unsigned all = AOV_DEPTH | AOV_NORMAL | AOV_OBJECT;
  NSDictionary *attributes =
    [NSDictionary dictionaryWithObjectsAndKeys: @"12", @"raytrace:seed",
                  @"", @"empty", @"a", @"zebra", @"b", @"ape", nil];
  NSError *error = nil;
  NSData *file = [exr_t fileOf: image aovs: all attributes: attributes
                         error: &error];
  NSData *again = [exr_t fileOf: image aovs: all attributes: attributes
                          error: &error];
  struct reading *reading = calloc(1, sizeof *reading);

  PASS(file != nil && error == nil, "the file is made");
  PASS([file isEqual: again], "the same picture gives the same bytes");
  if (PASS(start(reading, file) && read_pixels(reading),
           "OpenEXR reads all of it"))
    {
      test_header(reading);
      test_values(reading, image);
    }
  exr_finish(&reading->file);
  test_aovs(image);
  free(reading);
  test_noise();
  test_bounds();
  [pool release];
  return test_done();
}
