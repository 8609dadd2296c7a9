#import "flat_t.h"
#include "box_pairs.h"
#include "grow.h"

struct entry
{
  flat_t *flat;
  double extent;
  struct k_plane plane; // its own, before any is shared
  struct entry *better; // whose plane it takes over, or NULL
};

static BOOL
is_better(const struct entry *a, const struct entry *b)
{
  return a->extent != b->extent ? a->extent > b->extent
    : a->flat->number < b->flat->number;
}

/** Lets the worse of the two take over the plane of the better, if it lies
    in it and knows no better one still. */
static void
compare(void *context, unsigned i, unsigned j)
{
  struct entry *entries = context, *a = &entries[i], *b = &entries[j];
  struct entry *good = is_better(a, b) ? a : b;
  struct entry *bad = good == a ? b : a;

  if ((bad->better == NULL || is_better(good, bad->better))
      && [bad->flat liesIn: &good->plane])
    {
      bad->better = good;
    }
}

@implementation flat_t

- (BOOL) liesIn: (const struct k_plane *)other
{
  [self doesNotRecognizeSelector: _cmd];
  return NO;
}

- (void) takePlane: (struct k_plane)shared
{
  plane = shared;
}

- (double) distanceFrom: (struct k_vec)P
{
  return fabs(k_dot(plane.n, k_sub(P, plane.q)));
}

- (double) extent
{
  [self doesNotRecognizeSelector: _cmd];
  return 0;
}

/** Objects that overlap and lie in one plane get that plane to share: each
    takes over the plane of the largest one. */
+ (void) complete: (NSArray *)instances
            model: (model_t *)model
             diag: (diag_t *)diag
{
  NSUInteger count = [instances count], i = 0;
  struct entry *entries = new_array(count, sizeof *entries);
  struct k_bounds *boxes = new_array(count, sizeof *boxes);

  for (flat_t *flat in instances)
    {
      boxes[i] = [(id <object_t>)flat bounds];
      entries[i].flat = flat;
      entries[i].extent = [flat extent];
      entries[i].plane = flat->plane;
      i++;
    }
  if (!box_pairs(boxes, count, compare, entries))
    {
      raise_no_memory(count);
    }
  for (i = 0; i < count; i++)
    {
      struct entry *best = &entries[i];
      while (best->better)
        {
          best = best->better;
        }
      struct k_plane shared = best->plane;
      if (k_dot(entries[i].flat->plane.n, shared.n) < 0)
        {
          shared.n = k_neg(shared.n);
        }
      if (best != &entries[i])
        {
          [entries[i].flat takePlane: shared];
        }
    }
  free(boxes);
  free(entries);
}

@end
