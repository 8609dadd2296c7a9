// exr_channel.m

#import "exr_channel.h"
#include <stddef.h>

static const struct exr_channel channels[EXR_CHANNELS] =
{
  { "B", 0, EXR_PIXEL_FLOAT, 2 },
  { "G", 0, EXR_PIXEL_FLOAT, 1 },
  { "N.X", AOV_NORMAL, EXR_PIXEL_FLOAT, offsetof(struct surface_pixel, N.x) },
  { "N.Y", AOV_NORMAL, EXR_PIXEL_FLOAT, offsetof(struct surface_pixel, N.y) },
  { "N.Z", AOV_NORMAL, EXR_PIXEL_FLOAT, offsetof(struct surface_pixel, N.z) },
  { "R", 0, EXR_PIXEL_FLOAT, 0 },
  { "Z", AOV_DEPTH, EXR_PIXEL_FLOAT, offsetof(struct surface_pixel, depth) },
  { "error.sampling", AOV_SAMPLING, EXR_PIXEL_FLOAT, PLANE_SAMPLING },
  { "error.truncation", AOV_TRUNCATION, EXR_PIXEL_FLOAT, PLANE_TRUNCATION },
  { "id", AOV_OBJECT, EXR_PIXEL_UINT,
    offsetof(struct surface_pixel, object) },
  { "samples", AOV_SAMPLES, EXR_PIXEL_UINT, PLANE_SAMPLES }
};

/** No less than d: a bound stays one. */
static float
float_above(double d)
{
  float f = d > FLT_MAX ? FLT_MAX : (float)d;

  return f < d && f < FLT_MAX ? nextafterf(f, FLT_MAX) : f;
}

unsigned
exr_channels(const struct exr_channel *found[EXR_CHANNELS], unsigned aovs)
{
  unsigned count = 0;

  for (unsigned c = 0; c < EXR_CHANNELS; c++)
    {
      if (channels[c].aov == 0 || (channels[c].aov & aovs))
        {
          found[count++] = &channels[c];
        }
    }
  return count;
}

/** Of the colour. */
static void
fill_color(union exr_value *values, size_t count, const float *from)
{
  for (size_t i = 0; i < count; i++, from += 3)
    {
      values[i].number = *from;
    }
}

static void
fill_plane(union exr_value *values, size_t count, const double *plane,
           exr_pixel_type_t type)
{
  for (size_t i = 0; i < count; i++)
    {
      if (type == EXR_PIXEL_UINT)
        {
          values[i].whole = (uint32_t)plane[i];
        }
      else
        {
          values[i].number = float_above(plane[i]);
        }
    }
}

/** Of what was hit, where the first one's value is at `from`. */
static void
fill_surface(union exr_value *values, size_t count, const char *from,
             exr_pixel_type_t type)
{
  for (size_t i = 0; i < count; i++, from += sizeof(struct surface_pixel))
    {
      if (type == EXR_PIXEL_UINT)
        {
          values[i].whole = *(const uint32_t *)from;
        }
      else
        {
          values[i].number = image_float(*(const double *)from);
        }
    }
}

void
exr_channel_fill(union exr_value *values, const struct exr_channel *channel,
                 image_t *image, unsigned y, unsigned height)
{
  unsigned x = image->window.x0;
  size_t across = [image width], count = across * height;

  if (channel->aov == 0)
    {
      fill_color(values, count, image->floats[(y - image->window.y0) * across]
                 + channel->offset);
    }
  else if (channel->aov & AOV_SURFACES)
    {
      fill_surface(values, count, (const char *)[image surfaceAt: x : y]
                   + channel->offset, channel->type);
    }
  else
    {
      fill_plane(values, count, [image plane: (enum plane)channel->offset
                                          at: x : y], channel->type);
    }
}
