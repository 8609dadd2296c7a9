// exrcompare.c - whether two OpenEXR pictures hold the same pixels.
// usage: exrcompare EXPECTED FOUND [DIFFERENCE.ppm]
//        exrcompare --pixels PICTURE
//
// What is compared is every channel of every pixel, bit for bit, after it
// has been unpacked: a NaN equals a NaN of the same bits only, and 0 is not
// -0. Says what differs; the difference picture has the expected one on the
// left, the one found in the middle, and on the right white where any channel
// differs. --pixels writes all values to standard output, 32 bits each, channel
// after channel. Exit status: 0 the same, 1 not, 2 a file that cannot be read.

#include <openexr.h>
#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

struct channel
{
  const char *name;
  exr_pixel_type_t type;
  uint32_t *values;     // bits of a float or a whole number, row by row
};

struct picture
{
  const char *path;
  exr_context_t file;
  exr_attr_box2i_t display, data;
  int width, height, count;
  struct channel *channels;     // in the order of their names, as files are
};

static void
fail(const struct picture *picture, const char *what)
{
  fprintf(stderr, "%s: %s\n", picture->path, what);
  exit(2);
}

static void
check(const struct picture *picture, exr_result_t result)
{
  if (result != EXR_ERR_SUCCESS)
    {
      fail(picture, exr_get_default_error_message(result));
    }
}

static void
keep_silent(exr_const_context_t context, exr_result_t code,
            const char *message)
{
}

static void *
allocate(const struct picture *picture, size_t count, size_t size)
{
  void *memory = calloc(count ? count : 1, size);

  if (memory == NULL)
    {
      fail(picture, "out of memory");
    }
  return memory;
}

static void
read_header(struct picture *picture)
{
  exr_context_initializer_t doors = EXR_DEFAULT_CONTEXT_INITIALIZER;
  const exr_attr_chlist_t *list;
  exr_storage_t storage;

  doors.error_handler_fn = keep_silent;
  check(picture, exr_start_read(&picture->file, picture->path, &doors));
  check(picture, exr_get_storage(picture->file, 0, &storage));
  if (storage != EXR_STORAGE_SCANLINE)
    {
      fail(picture, "not a picture of scanlines");
    }
  check(picture, exr_get_display_window(picture->file, 0, &picture->display));
  check(picture, exr_get_data_window(picture->file, 0, &picture->data));
  check(picture, exr_get_channels(picture->file, 0, &list));
  picture->width = picture->data.max.x - picture->data.min.x + 1;
  picture->height = picture->data.max.y - picture->data.min.y + 1;
  picture->count = list->num_channels;
  picture->channels = allocate(picture, picture->count,
                               sizeof *picture->channels);
  for (int c = 0; c < picture->count; c++)
    {
      struct channel *to = &picture->channels[c];
      const exr_attr_chlist_entry_t *from = &list->entries[c];
      if (from->x_sampling != 1 || from->y_sampling != 1
          || from->pixel_type == EXR_PIXEL_HALF)
        {
          fail(picture, "a channel is neither float nor uint, or has not"
               " one sample in each pixel");
        }
      to->name = from->name.str;
      to->type = from->pixel_type;
      to->values = allocate(picture,
                            (size_t)picture->width * picture->height, 4);
    }
}

static struct picture
read_picture(const char *path)
{
  struct picture picture = { .path = path };
  exr_decode_pipeline_t decoder = EXR_DECODE_PIPELINE_INITIALIZER;
  exr_chunk_info_t chunk;
  int last = -1;

  read_header(&picture);
  for (int y = picture.data.min.y; y <= picture.data.max.y; y += chunk.height)
    {
      check(&picture, exr_read_scanline_chunk_info(picture.file, 0, y,
                                                   &chunk));
      check(&picture, last < 0
            ? exr_decoding_initialize(picture.file, 0, &chunk, &decoder)
            : exr_decoding_update(picture.file, 0, &chunk, &decoder));
      for (int c = 0; c < decoder.channel_count; c++)
        {
          exr_coding_channel_info_t *to = &decoder.channels[c];
          size_t row = (size_t)(y - picture.data.min.y) * picture.width;
          to->user_bytes_per_element = 4;
          to->user_data_type = picture.channels[c].type;
          to->user_pixel_stride = 4;
          to->user_line_stride = 4 * picture.width;
          to->decode_to_ptr = (uint8_t *)(picture.channels[c].values + row);
        }
      if (last < 0)
        {
          check(&picture, exr_decoding_choose_default_routines(picture.file,
                                                               0, &decoder));
        }
      check(&picture, exr_decoding_run(picture.file, 0, &decoder));
      last = y;
    }
  exr_decoding_destroy(picture.file, &decoder);
  return picture;
}

static void
release(struct picture *picture)
{
  for (int c = 0; c < picture->count; c++)
    {
      free(picture->channels[c].values);
    }
  free(picture->channels);
  exr_finish(&picture->file);
}

// What differs

static int
are_equal_boxes(exr_attr_box2i_t a, exr_attr_box2i_t b)
{
  return a.min.x == b.min.x && a.min.y == b.min.y && a.max.x == b.max.x
         && a.max.y == b.max.y;
}

static void
print_form(const char *which, const struct picture *picture)
{
  printf("%s: %d x %d pixels from %d %d, of %d x %d, channels", which,
         picture->width, picture->height, picture->data.min.x,
         picture->data.min.y,
         picture->display.max.x - picture->display.min.x + 1,
         picture->display.max.y - picture->display.min.y + 1);
  for (int c = 0; c < picture->count; c++)
    {
      printf(" %s%s", picture->channels[c].name,
             picture->channels[c].type == EXR_PIXEL_UINT ? "(uint)" : "");
    }
  printf("\n");
}

static int
are_of_one_form(const struct picture *a, const struct picture *b)
{
  int is_same = are_equal_boxes(a->data, b->data)
                && are_equal_boxes(a->display, b->display)
                && a->count == b->count;

  for (int c = 0; is_same && c < a->count; c++)
    {
      is_same = strcmp(a->channels[c].name, b->channels[c].name) == 0
                && a->channels[c].type == b->channels[c].type;
    }
  return is_same;
}

static float
number_of(uint32_t bits)
{
  float number;

  memcpy(&number, &bits, sizeof number);
  return number;
}

static void
print_value(const struct channel *channel, size_t i)
{
  uint32_t bits = channel->values[i];

  if (channel->type == EXR_PIXEL_UINT)
    {
      printf("%u", bits);
    }
  else
    {
      printf("%.9g (0x%08x)", number_of(bits), bits);
    }
}

/** Counts the pixels that differ and names the first. */
static size_t
compare(const struct picture *expected, const struct picture *found)
{
  size_t pixels = (size_t)expected->width * expected->height, differing = 0;
  size_t in_channel[expected->count];

  memset(in_channel, 0, sizeof in_channel);
  for (size_t i = 0; i < pixels; i++)
    {
      int is_same = 1;
      for (int c = 0; c < expected->count; c++)
        {
          if (expected->channels[c].values[i] != found->channels[c].values[i])
            {
              if (differing == 0 && is_same)
                {
                  printf("first at column %d, row %d from the top, channel"
                         " %s: expected ",
                         expected->data.min.x + (int)(i % expected->width),
                         expected->data.min.y + (int)(i / expected->width),
                         expected->channels[c].name);
                  print_value(&expected->channels[c], i);
                  printf(", found ");
                  print_value(&found->channels[c], i);
                  printf("\n");
                }
              in_channel[c]++;
              is_same = 0;
            }
        }
      differing += !is_same;
    }
  if (differing > 0)
    {
      printf("%zu of %zu pixels differ:", differing, pixels);
      for (int c = 0; c < expected->count; c++)
        {
          printf(" %s %zu", expected->channels[c].name, in_channel[c]);
        }
      printf("\n");
    }
  return differing;
}

// The difference picture

static uint8_t
byte_of(const struct picture *picture, const char *name, size_t i)
{
  for (int c = 0; c < picture->count; c++)
    {
      if (strcmp(picture->channels[c].name, name) == 0)
        {
          float v = number_of(picture->channels[c].values[i]);
          return v > 0 ? v < 1 ? (uint8_t)lrintf(255 * v) : 255 : 0;
        }
    }
  return 0;
}

static int
do_differ(const struct picture *a, const struct picture *b, size_t i)
{
  for (int c = 0; c < a->count; c++)
    {
      if (a->channels[c].values[i] != b->channels[c].values[i])
        {
          return 1;
        }
    }
  return 0;
}

static void
write_difference(const struct picture *expected, const struct picture *found,
                 const char *path)
{
  struct picture difference = { .path = path };
  FILE *file = fopen(path, "wb");

  if (file == NULL)
    {
      fail(&difference, "cannot be written");
    }
  fprintf(file, "P6\n%d %d\n255\n", 3 * expected->width, expected->height);
  for (int y = 0; y < expected->height; y++)
    {
      for (int x = 0; x < 3 * expected->width; x++)
        {
          size_t i = (size_t)y * expected->width + x % expected->width;
          const struct picture *from = x < expected->width ? expected : found;
          if (x < 2 * expected->width)
            {
              putc(byte_of(from, "R", i), file);
              putc(byte_of(from, "G", i), file);
              putc(byte_of(from, "B", i), file);
            }
          else
            {
              uint8_t byte = do_differ(expected, found, i) ? 255 : 0;
              fwrite((uint8_t[]){ byte, byte, byte }, 3, 1, file);
            }
        }
    }
  if (fclose(file) != 0)
    {
      fail(&difference, "cannot be written");
    }
}

static int
write_pixels(const char *path)
{
  struct picture picture = read_picture(path);
  size_t count = (size_t)picture.width * picture.height;

  for (int c = 0; c < picture.count; c++)
    {
      if (fwrite(picture.channels[c].values, 4, count, stdout) != count)
        {
          fail(&picture, "cannot be written");
        }
    }
  release(&picture);
  return fflush(stdout) ? 2 : 0;
}

int
main(int argc, char **argv)
{
  if (argc == 3 && strcmp(argv[1], "--pixels") == 0)
    {
      return write_pixels(argv[2]);
    }
  if (argc < 3 || argc > 4)
    {
      fprintf(stderr, "usage: exrcompare EXPECTED FOUND [DIFFERENCE.ppm]\n");
      return 2;
    }
  struct picture expected = read_picture(argv[1]);
  struct picture found = read_picture(argv[2]);
  int is_same;

  if (are_of_one_form(&expected, &found))
    {
      is_same = compare(&expected, &found) == 0;
      if (!is_same && argc == 4)
        {
          write_difference(&expected, &found, argv[3]);
        }
    }
  else
    {
      print_form("expected", &expected);
      print_form("   found", &found);
      is_same = 0;
    }
  release(&expected);
  release(&found);
  return is_same ? 0 : 1;
}
