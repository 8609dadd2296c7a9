// exr_channel.h - the channels an OpenEXR file of ours can have, and how they
// are filled from a picture. For exr_t.

#import "exr_t.h"
#include <openexr.h>

/** One channel: its name, the AOV it belongs to (0: the colour, always there),
    its type and where its value is: the number of the colour's channel, or
    where in a surface_pixel, or, of an AOV that needs no surfaces, the number
    of the picture's plane. */
struct exr_channel
{
  const char *name;
  enum aov aov;
  exr_pixel_type_t type;
  size_t offset;
};

enum { EXR_CHANNELS = 11 };

/** One value as the file holds it: 32 bits of either type. */
union exr_value
{
  float number;
  uint32_t whole;
};

/** Finds the channels of a file with these AOVs, in alphabetical order as
    OpenEXR wants them; returns how many they are. */
unsigned exr_channels(const struct exr_channel *found[EXR_CHANNELS],
                      unsigned aovs);

/** Copies `height` whole lines of one channel, from line y, to values. */
void exr_channel_fill(union exr_value *values,
                      const struct exr_channel *channel, image_t *image,
                      unsigned y, unsigned height);
