#import "model_t.h"
#import "camera_t.h"
#include "grow.h"
#import "material_t.h"
#import "ray_t.h"

/** An object that a ray can be inside of. */
struct clear
{
  object_t *object;
  struct k_bounds box;
  BOOL contains_lens;   // all points of it: need not be asked
};

/** One of the objects an eye ray starts in. */
struct start
{
  object_t *object;
  double t;             // where the ray leaves it
};

static int
last_left_first(const void *p, const void *q)
{
  const struct start *a = p, *b = q;

  return a->t != b->t ? (a->t > b->t ? -1 : 1)
    : a->object->number > b->object->number ? -1 : 1;
}

static BOOL
contains(const struct clear *clear, struct k_vec o)
{
  return k_bounds_hold(&clear->box, o) && [clear->object contains: o];
}

@implementation model_t (Media)

/** Those that matter to eye rays come first. What has no surface where these
    start, for a pinhole every object, is asked now, once for all of them. */
- (void) findClear
{
  NSUInteger count = [surfaces count];
  struct clear *others = new_array(count + 1, sizeof *others);
  unsigned other_count = 0;

  clear = new_array(count + 1, sizeof *clear);
  lens = camera ? [camera lensBox] : k_nothing();
  BOOL is_point = k_is_equal(lens.least, lens.most);
  for (object_t *object in surfaces)
    {
      if (object->material->alpha == 0 || [object medium] != object)
        {
          continue;
        }
      struct clear c = { object, [(id <object_t>)object bounds], NO };
      BOOL matters = k_bounds_overlap(&c.box, &lens);
      if (matters && (is_point || ![object hasSurfaceIn: lens]))
        {
          matters = c.contains_lens = contains(&c, lens.least);
        }
      if (matters)
        {
          clear[clear_at_lens++] = c;
        }
      else
        {
          others[other_count++] = c;
        }
    }
  memcpy(clear + clear_at_lens, others, other_count * sizeof *others);
  clear_count = clear_at_lens + other_count;
  free(others);
}

/** How many of `clear` a ray from o may start in: the first ones if o is on
    the lens. */
static inline unsigned
clear_near(const model_t *self, struct k_vec o, BOOL *is_on_lens)
{
  *is_on_lens = k_bounds_hold(&self->lens, o);
  return *is_on_lens ? self->clear_at_lens : self->clear_count;
}

- (BOOL) mayStartInside: (const struct eye_ray *)rays : (unsigned)ray_count
{
  for (unsigned k = 0; clear_count > 0 && k < ray_count; k++)
    {
      BOOL is_on_lens;
      unsigned count = clear_near(self, rays[k].o, &is_on_lens);
      for (unsigned i = 0; i < count; i++)
        {
          if ((is_on_lens && clear[i].contains_lens)
              || k_bounds_hold(&clear[i].box, rays[k].o))
            {
              return YES;
            }
        }
    }
  return NO;
}

- (media_t *) mediaOf: (ray_t *)ray
{
  struct k_vec o = ray->pos->v;
  BOOL is_on_lens;
  unsigned near = clear_near(self, o, &is_on_lens), count = 0;
  media_t *media = nil, *saved = ray->media;

  for (unsigned i = 0; i < near; i++)
    {
      if ((is_on_lens && clear[i].contains_lens) || contains(&clear[i], o))
        {
          object_t *object = clear[i].object;
          media = [media_t enter: object : object->material->ior over: media];
          count++;
        }
    }
  if (count <= 1)
    {
      return media;
    }
  struct start starts[count];
  ray->media = media;           // a solid is left only by a ray inside it
  for (unsigned i = 0; i < count; i++, media = media->below)
    {
      starts[i].object = media->object;
      if (![ray leaves: media->object at: &starts[i].t])
        {
          starts[i].t = HUGE_VAL;
        }
    }
  ray->media = saved;
  qsort(starts, count, sizeof *starts, last_left_first);
  media = nil;
  for (unsigned i = 0; i < count; i++)
    {
      object_t *object = starts[i].object;
      media = [media_t enter: object : object->material->ior over: media];
    }
  return media;
}

@end
