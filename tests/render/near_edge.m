// near_edge.m - what --stats counts near the edge: scenes that have each of
// these events, and as many as can be told beforehand; the same from both
// engines and all instructions.

#import "support.h"
#include "test.h"

/** `lying name { … }`: a sphere that nobody starts in. */
@interface lying_t : sphere_t
@end

@implementation lying_t

- (BOOL) contains: (struct k_vec)P
{
  return NO;
}

@end

/** `own name { … }`: a sphere that the kernel asks as an object. */
@interface own_t : sphere_t
@end

@implementation own_t

- (BOOL) compile: (id)compiler
{
  return NO;
}

@end

/** An eye ray from o along d; what is counted is `want` but for its rays. */
static void
check(model_t *model, struct k_vec o, struct k_vec d, struct counters want,
      const char *what)
{
  NSString *names[] = { nil, @"base", @"avx2" };

  for (int k = -1; k < 3; k++)
    {
      id <engine_t> engine = k < 0
        ? [[[notes_t alloc] initWithModel: model] autorelease]
        : support_fast(model, names[k]);
      struct counters is = { 0 };
      if (engine == nil)
        {
          continue;             // the machine has no such instructions
        }
      support_color(engine, o, k_unit(d), &is);
      PASS(counters_same_edges(&is, &want), "%s, %s: %llu escapes, %llu"
           " compensated, %llu ties, %llu critical, %llu unbalanced", what,
           k < 0 ? "notes" : k == 0 ? "best" : [names[k] UTF8String],
           (unsigned long long)is.escapes, (unsigned long long)is.compensated,
           (unsigned long long)is.ties, (unsigned long long)is.critical,
           (unsigned long long)is.unbalanced);
    }
}

#define WORLD SUPPORT_CAMERA "material m { }\n" \
  "material glass { alpha 1 ior 2 }\nmaterial mirror { specular 1 1 1 }\n"
#define LAMP "light lamp { location 0 0 90 emissivity 1 1 1 }\n"
#define DOWN k_vec(0, 0, -1)

/** A sphere that is met from near its surface, within 1/1024 of the square of
    the distance from its center; where light is, and where it is not. */
static void
compensated(const char *word, const char *lamp)
{
  struct counters none = { 0 }, one = { .compensated = 1 };
  model_t *model = support_model
    ("%s %s %s s { material m center 0 0 0 radius 1 }\n", WORLD, lamp, word);

  check(model, k_vec(0, 0, 1.0004), DOWN, one, "an eye close to a sphere");
  check(model, k_vec(0, 0, 1.0006), DOWN, none, "and not so close");
  check(model, k_vec(0, 0, -0.9996), k_vec(0, 0, 1), one, "inside, close");
  check(model, k_vec(0, 0, 0.5), k_vec(1, 0, 0), none, "inside");
  check(model, k_vec(0, 0, 1.0001), k_vec(0, 0, 1), none, "close, and misses");

  // The mirrored ray starts close to the other one, and so does the feeler,
  // which does not count.
  model = support_model
    ("%s %s plane p { material mirror normal 0 0 1 point 0 0 0 }\n"
     "%s s { material m center 3 0 1.0001 radius 1 }\n", WORLD, lamp, word);
  check(model, k_vec(2.9, 0, 10), k_vec(0.1, 0, -10), none, "from far");
  check(model, k_vec(-7, 0, 0.01), k_vec(9.99, 0, -0.01), none,
        "along the mirror");
  model = support_model
    ("%s %s plane p { material mirror normal 0 0 1 point 0 0 0 }\n"
     "%s s { material m center 0 0 1.0001 radius 1 }\n", WORLD, lamp, word);
  check(model, k_vec(0.01, 0, 0.00001), DOWN, one, "off a mirror");
}

static void
ties(const char *word)
{
  struct counters none = { 0 }, one = { .ties = 1 };
  struct k_vec o = k_vec(.25, .5, 5);
  model_t *model = support_model
    ("%s %s a { material m center 0 0 0 radius 1 }\n"
     "%s b { material m center 0 0 0 radius 1 }\n"
     "%s c { material m center 0 0 0 radius 1 }\n", WORLD, word, word, word);

  check(model, o, DOWN, one, "three spheres in one place");
  model = support_model
    ("%s %s far { material m center 0 0 -9 radius 1 }\n"
     "%s twin { material m center 0 0 -9 radius 1 }\n"
     "%s near { material m center 0 0 0 radius 1 }\n", WORLD, word, word, word);
  check(model, o, DOWN, none, "two that are hidden");
  model = support_model
    ("%s %s s { material m center 0 0 0 radius 1 }\n", WORLD, word);
  check(model, k_vec(1, 0, 5), DOWN, none, "both roots of a tangent");
  model = support_model
    ("%s %s s { material m center 0 0 -1 radius 1 }\n"
     "plane p { material m normal 0 0 1 point 0 0 0 }\n", WORLD, word);
  check(model, k_vec(0, 0, 5), DOWN, one, "a sphere on a plane");
  check(model, o, DOWN, none, "beside it");
  model = support_model
    ("%s plane p { material m normal 0 0 1 point 0 0 0 }\n"
     "polygon q { material m vertex 0 0 0 vertex 1 0 0 vertex 0 1 0 }\n"
     "polygon r { material m vertex 1 0 0 vertex 1 1 0 vertex 0 1 0 }\n",
     WORLD);
  check(model, k_vec(.5, .5, 5), DOWN, one, "a plane and the edge of two"
        " polygons on it");
  model = support_model
    ("%s polygon q { material m vertex 0 0 0 vertex 1 0 0 vertex 0 1 0 }\n"
     "polygon r { material m vertex 1 0 0 vertex 1 1 0 vertex 0 1 0 }\n",
     WORLD);
  check(model, k_vec(.5, .5, 5), DOWN, none, "the edge alone");
}

/** Out of glass of index 5/3 into air: critical where the sine is 3/5. */
static void
critical(void)
{
  struct counters none = { 0 }, one = { .critical = 1 };
  model_t *model = support_model
    ("%s material g { alpha 1 ior 1.6666666666666667 }\n"
     "plane p { material g normal 0 0 1 point 0 0 0 }\n", WORLD);
  struct k_vec o = k_vec(0, 0, -1);

  model->max_depth = 0;
  check(model, o, k_vec(3, 0, 4), one, "the critical angle");
  check(model, o, k_vec(3 * (1 + 0x1p-47), 0, 4), none,
        "some forty roundings above");
  check(model, o, k_vec(3 * (1 - 0x1p-47), 0, 4), none,
        "some forty roundings below");
  model = support_model
    ("%s material clear { alpha 1 }\n"
     "plane p { material clear normal 0 0 1 point 0 0 0 }\n", WORLD);
  model->max_depth = 0;
  check(model, o, k_vec(1, 0, 0x1p-30), none, "index 1, grazing: |k| is less,"
        " but the ray goes on as it came");
}

static void
unbalanced(void)
{
  struct counters none = { 0 }, one = { .unbalanced = 1 };
  model_t *model = support_model
    ("%s lying s { material glass center 0 0 0 radius 1 }\n", WORLD);

  model->max_depth = 0;
  check(model, k_vec(0, 0, 0.5), DOWN, one, "out of a sphere it is not in");
  model = support_model
    ("%s sphere s { material glass center 0 0 0 radius 1 }\n", WORLD);
  check(model, k_vec(0, 0, 0.5), DOWN, none, "out of one that it is in");
  model = support_model
    ("%s polygon s { material glass vertex 0 0 0 vertex 3 0 0 vertex 0 3 0 }\n",
     WORLD);
  check(model, k_vec(1, 1, -0.5), k_vec(0, 0, 1), none, "through a sheet from"
        " behind");
}

int
main(void)
{
  NSAutoreleasePool *pool = [[NSAutoreleasePool alloc] init];

  compensated("sphere", "");
  compensated("sphere", LAMP);
  compensated("own", LAMP);
  ties("sphere");
  ties("own");
  critical();
  unbalanced();
  [pool release];
  return test_done();
}
