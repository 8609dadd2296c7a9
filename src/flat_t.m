#import "flat_t.h"

/** A flat object with the box it is looked for in. */
struct entry
{
  flat_t *flat;
  struct k_bounds box;
  double extent;
  double least, most;   // of the box, along the axis of the sweep
  struct k_plane plane; // its own, before any is shared
  struct entry *better; // whose plane it takes over, or NULL
};

static int
by_least(const void *a, const void *b)
{
  const struct entry *p = a, *q = b;

  if (p->least != q->least)
    {
      return p->least < q->least ? -1 : 1;
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
  return a->least.x <= b->most.x && b->least.x <= a->most.x
    && a->least.y <= b->most.y && b->least.y <= a->most.y
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

/** The axis along which the boxes overlap least: where they are narrowest
    against all of them together. Unbounded ones do not count. */
static int
sweep_axis(const struct entry *entries, NSUInteger count)
{
  struct k_bounds all = k_nothing();
  struct k_vec widths = k_vec(0, 0, 0);
  int best = 0;
  double best_share = HUGE_VAL;

  for (NSUInteger i = 0; i < count; i++)
    {
      struct k_bounds b = entries[i].box;
      if (!k_is_unbounded(b))
        {
          all = k_bounds_include(k_bounds_include(all, b.least), b.most);
          widths = k_add(widths, k_sub(b.most, b.least));
        }
    }
  for (int axis = 0; axis < 3; axis++)
    {
      double share = k_component(widths, axis)
        / k_component(k_sub(all.most, all.least), axis);
      if (share < best_share)
        {
          best_share = share;
          best = axis;
        }
    }
  return best;
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
    takes over the plane of the largest one. A sweep along one axis finds
    the pairs. */
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
  int axis = sweep_axis(entries, count);
  for (NSUInteger i = 0; i < count; i++)
    {
      entries[i].least = k_component(entries[i].box.least, axis);
      entries[i].most = k_component(entries[i].box.most, axis);
    }
  qsort(entries, count, sizeof *entries, by_least);
  for (NSUInteger i = 0; i < count; i++)
    {
      NSUInteger kept = 0;
      for (NSUInteger j = 0; j < active; j++)
        {
          if (open[j]->most >= entries[i].least)
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
