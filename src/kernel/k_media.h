// k_media.h - what a ray is in: a list whose entries stand in the frames of
// those who trace, so that nothing is allocated.

#ifndef K_MEDIA_H
#define K_MEDIA_H

#include "k.h"

static inline int
k_media_has(const struct k_media *media, unsigned medium)
{
  while (media && media->medium != medium)
    {
      media = media->below;
    }
  return media != NULL;
}

static inline unsigned
k_media_depth(const struct k_media *media)
{
  unsigned depth = 0;

  for (; media; media = media->below)
    {
      depth++;
    }
  return depth;
}

/** The media without the topmost entry of `medium`; entries above it are
    copied to `room`. */
static inline const struct k_media *
k_media_leave(const struct k_media *media, unsigned medium,
            struct k_media *room)
{
  const struct k_media *m = media, *left;
  struct k_media *last = NULL;

  if (!k_media_has(media, medium))
    {
      return media;
    }
  left = NULL;
  for (; m->medium != medium; m = m->below)
    {
      *room = *m;
      if (last)
        {
          last->below = room;
        }
      else
        {
          left = room;
        }
      last = room++;
    }
  if (last)
    {
      last->below = m->below;
      return left;
    }
  return m->below;
}

#endif
