#import "flat_t.h"

/** A flat object with the box it is looked for in. */
struct entry
{
  flat_t *flat;
  struct k_bounds box;
  double extent;
  struct k_plane plane; // its own, before any is shared
  struct entry *better; // whose plane it takes over, or NULL
};

static int
by_least_x(const void *a, const void *b)
{
  const struct entry *p = a, *q = b;

  if (p->box.least.x != q->box.least.x)
    {
      return p->box.least.x < q->box.least.x ? -1 : 1;
    }
  return p->flat->number < q->flat->number ? -1 : 1;
}

static BOOL
is_better(const struct entry *a, const struct entry *b)
{
  return a->extent != b->extent ? a->extent > b->extent
    : a->flat->number < b->flat->number;
}

static BOOL
overlap(const struct k_bounds *a, const struct k_bounds *b)
{
  return a->least.y <= b->most.y && b->least.y <= a->most.y
    && a->least.z <= b->most.z && b->least.z <= a->most.z;
}

/** Lets the worse of the two take over the plane of the better, if it lies
    in it and knows no better one still. */
static void
compare(struct entry *a, struct entry *b)
{
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

- (double) extent
{
  [self doesNotRecognizeSelector: _cmd];
  return 0;
}

/** Objects that overlap and lie in one plane get that plane to share: each
    takes over the plane of the largest one. A sweep along x finds the
    pairs. */
+ (void) complete: (NSArray *)instances
            model: (model_t *)model
             diag: (diag_t *)diag
{
  NSUInteger count = [instances count], active = 0;
  struct entry *entries = calloc(count, sizeof *entries);
  struct entry **open = calloc(count, sizeof *open);

  for (NSUInteger i = 0; i < count; i++)
    {
      flat_t *flat = [instances objectAtIndex: i];
      entries[i].flat = flat;
      entries[i].box = [(id <object_t>)flat bounds];
      entries[i].extent = [flat extent];
      entries[i].plane = flat->plane;
    }
  qsort(entries, count, sizeof *entries, by_least_x);
  for (NSUInteger i = 0; i < count; i++)
    {
      NSUInteger kept = 0;
      for (NSUInteger j = 0; j < active; j++)
        {
          if (open[j]->box.most.x >= entries[i].box.least.x)
            {
              if (overlap(&open[j]->box, &entries[i].box))
                {
                  compare(open[j], &entries[i]);
                }
              open[kept++] = open[j];
            }
        }
      active = kept;
      open[active++] = &entries[i];
    }
  for (NSUInteger i = 0; i < count; i++)
    {
      struct entry *best = &entries[i];
      while (best->better)
        {
          best = best->better;
        }
      struct k_plane *own = &entries[i].flat->plane;
      BOOL is_turned = k_dot(own->n, best->plane.n) < 0;
      own->q = best->plane.q;
      own->n = is_turned ? k_neg(best->plane.n) : best->plane.n;
    }
  free(open);
  free(entries);
}

@end
