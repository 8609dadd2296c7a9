// exr_t.m

#import "exr_t.h"
#import "errors.h"
#import "exr_channel.h"
#include <stdlib.h>
#include <string.h>

/** A file that is being written. */
struct writing
{
  NSMutableData *bytes;
  const struct exr_channel *channels[EXR_CHANNELS];
  unsigned count;       // of channels
  union exr_value *lines;       // of one chunk, channel after channel
  exr_result_t (*compress)(exr_encode_pipeline_t *encoder);     // OpenEXR's
};

/** OpenEXR's door to the file: like pwrite. It leaves room for the table of
    chunks, goes on and comes back to it. */
static int64_t
write_bytes(exr_const_context_t context, void *user, const void *bytes,
            uint64_t length, uint64_t offset,
            exr_stream_error_func_ptr_t error)
{
  struct writing *writing = user;

  if (offset > [writing->bytes length])
    {
      [writing->bytes setLength: offset];
    }
  if (offset == [writing->bytes length])
    {
      [writing->bytes appendBytes: bytes length: length];
    }
  else
    {
      [writing->bytes replaceBytesInRange: NSMakeRange(offset, length)
                                withBytes: bytes];
    }
  return length;
}

/** What OpenEXR says is wrong, of the file that this thread writes. It calls
    with its own lock taken, so nothing may be asked of the file here. */
static _Thread_local struct message { char text[256]; } said;

static void
keep_message(exr_const_context_t context, exr_result_t code,
             const char *message)
{
  if (said.text[0] == 0)
    {
      snprintf(said.text, sizeof said.text, "%s", message);
    }
}

/** A rectangle as OpenEXR has it, its last column and row included. */
static exr_attr_box2i_t
box(unsigned x0, unsigned y0, unsigned x1, unsigned y1)
{
  exr_attr_box2i_t box = {
    { .x = (int32_t)x0, .y = (int32_t)y0 },
    { .x = (int32_t)x1 - 1, .y = (int32_t)y1 - 1 }
  };
  return box;
}

static exr_result_t
write_header(exr_context_t file, image_t *image, NSDictionary *attributes,
             const struct writing *writing)
{
  struct window window = image->window;
  exr_attr_box2i_t display = box(0, 0, image->columns, image->rows);
  exr_attr_box2i_t data = box(window.x0, window.y0, window.x1, window.y1);
  exr_attr_v2f_t center = { .x = 0, .y = 0 };
  exr_result_t result;

  result = exr_add_part(file, NULL, EXR_STORAGE_SCANLINE, NULL);
  if (result == EXR_ERR_SUCCESS)
    {
      result = exr_initialize_required_attr(file, 0, &display, &data, 1,
                                            &center, 1,
                                            EXR_LINEORDER_INCREASING_Y,
                                            EXR_COMPRESSION_ZIP);
    }
  for (unsigned c = 0; c < writing->count && result == EXR_ERR_SUCCESS; c++)
    {
      result = exr_add_channel(file, 0, writing->channels[c]->name,
                               writing->channels[c]->type,
                               EXR_PERCEPTUALLY_LOGARITHMIC, 1, 1);
    }
  for (NSString *name in [[attributes allKeys]
                           sortedArrayUsingSelector: @selector(compare:)])
    {
      const char *value = [[attributes objectForKey: name] UTF8String];
      if (result == EXR_ERR_SUCCESS)
        {
          result = exr_attr_set_string(file, 0, [name UTF8String], value);
        }
    }
  return result == EXR_ERR_SUCCESS ? exr_write_header(file) : result;
}

/** Packs a chunk. What does not get smaller is stored as it is, which readers
    know by its size. Up to version 3.4.7 OpenEXR stores it packed when packing
    leaves the size the same, and then noise is read. */
static exr_result_t
compress(exr_encode_pipeline_t *encoder)
{
  const struct writing *writing = encoder->encoding_user_data;
  exr_result_t result = writing->compress(encoder);

  if (result == EXR_ERR_SUCCESS
      && encoder->compressed_bytes == encoder->packed_bytes)
    {
      memcpy(encoder->compressed_buffer, encoder->packed_buffer,
             encoder->packed_bytes);
    }
  return result;
}

/** Writes the chunk that begins with line y; *height is its number of
    lines. */
static exr_result_t
write_chunk(exr_context_t file, exr_encode_pipeline_t *encoder,
            image_t *image, struct writing *writing, unsigned y,
            unsigned *height)
{
  exr_chunk_info_t chunk;
  exr_result_t result;
  BOOL isFirst = y == image->window.y0;

  result = exr_write_scanline_chunk_info(file, 0, (int)y, &chunk);
  if (result == EXR_ERR_SUCCESS)
    {
      result = isFirst ? exr_encoding_initialize(file, 0, &chunk, encoder)
                       : exr_encoding_update(file, 0, &chunk, encoder);
    }
  if (result != EXR_ERR_SUCCESS)
    {
      return result;
    }
  *height = (unsigned)chunk.height;
  for (unsigned c = 0; c < writing->count; c++)
    {
      exr_coding_channel_info_t *to = &encoder->channels[c];
      union exr_value *lines = writing->lines
                               + (size_t)c * chunk.width * chunk.height;

      exr_channel_fill(lines, writing->channels[c], image, y, *height);
      to->user_pixel_stride = sizeof *lines;
      to->user_line_stride = chunk.width * (int32_t)sizeof *lines;
      to->encode_from_ptr = (const uint8_t *)lines;
    }
  if (isFirst)
    {
      result = exr_encoding_choose_default_routines(file, 0, encoder);
      writing->compress = encoder->compress_fn;
      encoder->encoding_user_data = writing;
      encoder->compress_fn = compress;
    }
  return result == EXR_ERR_SUCCESS ? exr_encoding_run(file, 0, encoder)
                                   : result;
}

static exr_result_t
write_pixels(exr_context_t file, image_t *image, struct writing *writing)
{
  exr_encode_pipeline_t encoder = EXR_ENCODE_PIPELINE_INITIALIZER;
  exr_result_t result;
  int32_t chunkHeight;

  result = exr_get_scanlines_per_chunk(file, 0, &chunkHeight);
  if (result != EXR_ERR_SUCCESS)
    {
      return result;
    }
  writing->lines = calloc((size_t)writing->count * [image width],
                          chunkHeight * sizeof *writing->lines);
  if (writing->lines == NULL)
    {
      return EXR_ERR_OUT_OF_MEMORY;
    }
  for (unsigned y = image->window.y0, height = 0;
       y < image->window.y1 && result == EXR_ERR_SUCCESS; y += height)
    {
      result = write_chunk(file, &encoder, image, writing, y, &height);
    }
  exr_encoding_destroy(file, &encoder);
  free(writing->lines);
  return result;
}

@implementation exr_t

+ (NSData *) fileOf: (image_t *)image
               aovs: (unsigned)aovs
         attributes: (NSDictionary *)attributes
              error: (NSError **)error
{
  struct writing writing = { .bytes = [NSMutableData data] };
  exr_context_initializer_t doors = EXR_DEFAULT_CONTEXT_INITIALIZER;
  exr_context_t file = NULL;
  exr_result_t result, finished;

  NSAssert(image->floats, @"the image does not keep floats");
  NSAssert(!(aovs & AOV_SURFACES) || image->surfaces,
           @"the image has no surfaces");
  writing.count = exr_channels(writing.channels, aovs);
  said.text[0] = 0;
  doors.user_data = &writing;
  doors.write_fn = write_bytes;
  doors.error_handler_fn = keep_message;
  result = exr_start_write(&file, "picture", EXR_WRITE_FILE_DIRECTLY, &doors);
  if (result == EXR_ERR_SUCCESS)
    {
      result = write_header(file, image, attributes, &writing);
    }
  if (result == EXR_ERR_SUCCESS)
    {
      result = write_pixels(file, image, &writing);
    }
  finished = exr_finish(&file);
  result = result == EXR_ERR_SUCCESS ? finished : result;
  if (result != EXR_ERR_SUCCESS && error)
    {
      const char *text = exr_get_default_error_message(result);
      *error = error_saying(STATUS_FILE, @"OpenEXR: %s", said.text[0]
                            ? said.text : text);
    }
  return result == EXR_ERR_SUCCESS ? writing.bytes : nil;
}

@end
