// exrcompare.c - whether two OpenEXR pictures hold the same pixels.
// usage: exrcompare EXPECTED FOUND [DIFFERENCE.ppm]
//
// What is compared is every channel of every pixel, bit for bit, after it
// has been unpacked: a NaN equals a NaN of the same bits only, and 0 is not
// -0. Says what differs; the difference picture has the expected one on the
// left, the one found in the middle, and on the right white where any channel
// differs. Exit status: 0 the same, 1 not, 2 a file that cannot be read.

#include "exrread.h"
#include <math.h>

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

int
main(int argc, char **argv)
{
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
