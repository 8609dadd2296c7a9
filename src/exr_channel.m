// exr_channel.m

#import "exr_channel.h"
#include <float.h>
#include <stddef.h>

static const struct exr_channel channels[EXR_CHANNELS] =
{
  { "B", 0, EXR_PIXEL_FLOAT, offsetof(struct pixel, color.z) },
  { "G", 0, EXR_PIXEL_FLOAT, offsetof(struct pixel, color.y) },
  { "N.X", AOV_NORMAL, EXR_PIXEL_FLOAT, offsetof(struct surface_pixel, N.x) },
  { "N.Y", AOV_NORMAL, EXR_PIXEL_FLOAT, offsetof(struct surface_pixel, N.y) },
  { "N.Z", AOV_NORMAL, EXR_PIXEL_FLOAT, offsetof(struct surface_pixel, N.z) },
  { "R", 0, EXR_PIXEL_FLOAT, offsetof(struct pixel, color.x) },
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

static float
float_of(double d)
{
  if (isnan(d))
    {
      return 0;
    }
  return d > FLT_MAX ? FLT_MAX : d < -FLT_MAX ? -FLT_MAX : (float)d;
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

void
exr_channel_fill(union exr_value *values, const struct exr_channel *channel,
                 image_t *image, unsigned y, unsigned height)
{
  unsigned x = image->window.x0;
  size_t count = (size_t)[image width] * height;
  size_t stride = sizeof(struct pixel);
  const char *from = (const char *)[image pixelAt: x : y];

  if (channel->aov && !(channel->aov & AOV_SURFACES))
    {
      const double *plane = [image plane: (enum plane)channel->offset
                                      at: x : y];
      for (size_t i = 0; i < count; i++)
        {
          if (channel->type == EXR_PIXEL_UINT)
            {
              values[i].whole = (uint32_t)plane[i];
            }
          else
            {
              values[i].number = float_above(plane[i]);
            }
        }
      return;
    }
  if (channel->aov)
    {
      stride = sizeof(struct surface_pixel);
      from = (const char *)[image surfaceAt: x : y];
    }
  from += channel->offset;
  for (size_t i = 0; i < count; i++, from += stride)
    {
      if (channel->type == EXR_PIXEL_UINT)
        {
          values[i].whole = *(const uint32_t *)from;
        }
      else
        {
          values[i].number = float_of(*(const double *)from);
        }
    }
}
