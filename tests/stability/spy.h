// spy.h - a shape that is nowhere and sees everything: the block `spy name {
// material … }` writes down every ray that is looked after, and meets none.

#ifndef SPY_H
#define SPY_H

#include "support.h"

struct seen
{
  struct k_vec pos, dir;
  unsigned depth;               // generation
  unsigned media;               // how many media it is in
  BOOL is_feeler;
};

#define SPY_MOST 4096

static struct seen spy_seen[SPY_MOST];
static unsigned spy_count;

@interface spy_t : object_t <object_t>
@end

@implementation spy_t

+ (const struct attribute *) attributes
{
  static const struct attribute table[] = {
    { .name = "material", .kind = ATTRIBUTE_MATERIAL, .is_required = 1 },
    { .name = NULL }
  };
  return table;
}

- (id) initWithBlock: (block_t *)block
{
  return [super initWithBlock: block];
}

- (struct k_bounds) bounds
{
  return k_unbounded();
}

- (void) hits: (ray_t *)ray
{
  struct seen seen = { ray->pos->v, ray->dir->v, ray->depth, 0,
                       ray->is_feeler };

  for (media_t *m = ray->media; m; m = m->below)
    {
      seen.media++;
    }
  if (spy_count < SPY_MOST)
    {
      spy_seen[spy_count++] = seen;
    }
}

@end

/** The last ray of that generation that goes on along `way`: the one that was
    refracted each time, for a reflected ray is traced before the refracted
    one. NULL if there is none. */
static inline const struct seen *
spy_find(unsigned depth, struct k_vec way)
{
  for (unsigned i = spy_count; i-- > 0;)
    {
      if (!spy_seen[i].is_feeler && spy_seen[i].depth == depth
          && k_dot(spy_seen[i].dir, way) > 0)
        {
          return &spy_seen[i];
        }
    }
  return NULL;
}

#endif
