// random_bounds.m - of scenes at random (random_scene.h), with every kind of
// cut: no channel of any pixel is farther off a deep picture than the picture
// says, no picture says more than was asked for, and both engines, instruction
// sets and numbers of threads cut the same. `random_bounds FROM TO` makes those
// scenes.

#import "cut_pictures.h"
#import "random_scene.h"

enum { DEEP = 9 };

/** One way of cutting: a limit on the error, a least weight or a depth. */
struct way
{
  unsigned max_depth;
  double min_weight, max_error;
};

static const struct way ways[] = {
  { DEEP, -1, 1 }, { DEEP, -1, 0.1 }, { DEEP, -1, 1 / 255. },
  { DEEP, -1, 1e-4 }, { DEEP, 0.05, -1 }, { DEEP, 0.2, 0.02 }, { 2, -1, -1 }
};

enum { WAYS = sizeof ways / sizeof *ways };

static BOOL
same_rays(const struct counters *a, const struct counters *b)
{
  return a->reflection == b->reflection && a->refraction == b->refraction
    && a->feeler == b->feeler;
}

static void
check(model_t *model, const struct way *way, image_t *deep,
      struct render_options options, uint64_t seed)
{
  NSAutoreleasePool *pool = [[NSAutoreleasePool alloc] init];
  struct counters wanted, counters;
  size_t apart = 0, miscounted = 0;
  double most;

  cut_model(model, way->max_depth, way->min_weight, way->max_error, DEEP);
  options.threads = 1;
  image_t *notes = cut_picture(model, [[[notes_t alloc] initWithModel: model]
                                        autorelease], options, &wanted);
  for (int isa = 0; isa < 2; isa++)
    {
      options.threads = 1 + 2 * isa;
      image_t *fast = cut_picture(model, support_fast(model, isa ? nil
                                                      : @"base"),
                                  options, &counters);
      apart += cut_apart(notes, fast);
      miscounted += !same_rays(&wanted, &counters);
    }
  PASS(apart == 0 && miscounted == 0, "scene %llu, way %d: %zu pixels apart,"
       " %zu miscounted", (unsigned long long)seed, (int)(way - ways), apart,
       miscounted);
  unsigned broken = cut_broken(notes, deep, &most);
  PASS(broken == 0, "scene %llu, way %d: bound holds, but for %u pixels",
       (unsigned long long)seed, (int)(way - ways), broken);
  PASS(way->max_error < 0 || way->min_weight >= 0 || most <= way->max_error,
       "scene %llu, way %d: says %g", (unsigned long long)seed,
       (int)(way - ways), most);
  [pool release];
}

static void
scene(uint64_t seed)
{
  model_t *model = support_model_with(support_options(),
                                      random_scene_text(seed));
  struct render_options options = support_render_options();

  options.samples = 1 + seed % 2;
  options.seed = seed;
  model->choice.exact_fresnel = seed % 5 == 0;
  model->choice.no_shadows = seed % 11 == 0;
  model->choice.no_reflection = seed % 13 == 0;
  model->choice.no_refraction = seed % 17 == 0;
  model->max_depth = DEEP;
  image_t *deep = cut_picture(model, support_fast(model, nil), options, NULL);
  for (unsigned i = 0; i < WAYS; i++)
    {
      check(model, &ways[i], deep, options, seed);
    }
}

int
main(int count, char **words)
{
  return random_main(count, words, scene);
}
