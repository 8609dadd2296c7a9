// box_pairs.m - box_pairs: every two boxes that overlap, once.

#import "support.h"
#include "box_pairs.h"
#include "test.h"

#define MOST 600

static unsigned char met[MOST][MOST];

static void
meet(void *context, unsigned a, unsigned b)
{
  unsigned *calls = context;

  met[a][b]++;
  met[b][a]++;
  ++*calls;
}

/** Boxes of a kind: small ones, points, sticks, of all sizes, on a grid so
    that they touch, all alike, and some without bounds. */
static struct k_bounds
box_of(unsigned kind, struct support_random *random)
{
  struct k_vec c = support_point(random, 10), size = k_vec(1, 1, 1);
  struct k_bounds box;

  switch (kind)
    {
    case 1:
      size = k_vec(0, 0, 0);
      break;
    case 2:
      size = support_unit(random) < 0.5 ? k_vec(20, 0.1, 0.1)
        : k_vec(0.1, 0.1, 20);
      break;
    case 3:
      size = k_scale(size, ldexp(1, 40 * support_unit(random) - 36));
      break;
    case 4:
      c = k_vec(floor(c.x), floor(c.y), floor(c.z));
      break;
    case 5:
      c = k_vec(0, 0, 0);
      break;
    }
  box.least = c;
  box.most = k_add(c, size);
  if (kind == 6 && support_unit(random) < 0.3)
    {
      box = k_unbounded();
    }
  return box;
}

int
main(void)
{
  static const char *kinds[] = { "small", "points", "sticks", "of all sizes",
                                 "on a grid", "all alike",
                                 "some without bounds" };
  static struct k_bounds boxes[MOST];
  NSAutoreleasePool *pool = [[NSAutoreleasePool alloc] init];

  for (unsigned kind = 0; kind < 7; kind++)
    {
      unsigned wrong = 0, pairs = 0;
      for (unsigned seed = 0; seed < 20; seed++)
        {
          struct support_random random = support_seed(seed);
          unsigned count = MOST * (seed / 19.0), calls = 0, wanted = 0;
          for (unsigned i = 0; i < count; i++)
            {
              boxes[i] = box_of(kind, &random);
            }
          memset(met, 0, sizeof met);
          wrong += !box_pairs(boxes, count, meet, &calls);
          for (unsigned i = 0; i < count; i++)
            {
              for (unsigned j = i + 1; j < count; j++)
                {
                  int is_pair = k_bounds_overlap(&boxes[i], &boxes[j]);
                  wrong += met[i][j] != is_pair;
                  wanted += is_pair;
                }
            }
          wrong += calls != wanted;
          pairs += wanted;
        }
      PASS(wrong == 0, "boxes, %s: each of %u pairs once: %u", kinds[kind],
           pairs, wrong);
    }
  [pool release];
  return test_done();
}
