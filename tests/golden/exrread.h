// exrread.h - reads an OpenEXR picture whole: every channel of every pixel, as
// bits. For the programs here; they end with status 2 when it cannot be read.

#ifndef EXRREAD_H
#define EXRREAD_H

#include <openexr.h>
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

#endif
