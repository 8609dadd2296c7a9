// random_scenes.m - of scenes at random (random_scene.h): both engines, every
// instruction set and any number of threads give the same bits and count the
// same rays; every number is finite; and of a pixel --explain tells as many rays
// as were traced. `random_scenes FROM TO` makes those.

#import "explain_t.h"
#import "random_scene.h"
#include "test.h"

static BOOL
same_counters(const struct counters *a, const struct counters *b)
{
  return a->eye == b->eye && a->reflection == b->reflection
    && a->refraction == b->refraction && a->feeler == b->feeler
    && counters_same_edges(a, b);
}

/** How many rays --explain tells of a pixel. */
static unsigned
rays_told(model_t *model, struct render_options options, struct window pixel)
{
  explain_t *engine = [[[explain_t alloc] initWithModel: model] autorelease];
  struct counters counters;
  NSString *text = [engine textOf: support_render_counted(model, engine, options, pixel,
                                           NO, &counters)];
  unsigned rays = 0;

  for (NSString *line in [text componentsSeparatedByString: @"\n"])
    {
      rays += [[line stringByTrimmingCharactersInSet:
                       [NSCharacterSet whitespaceCharacterSet]]
                hasPrefix: @"ray "];
    }
  return rays;
}

static void
scene(uint64_t seed)
{
  model_t *model = support_model_with(support_options(), random_scene_text(seed));
  struct render_options options = support_render_options();
  camera_t *camera = model->camera;
  struct window all = { 0, 0, camera->columns, camera->rows };
  struct counters wanted, counters;

  options.samples = 1 + seed % 3;
  options.seed = seed;
  model->choice.exact_fresnel = seed % 5 == 0;
  options.threads = 1;
  image_t *notes = support_render_counted(model, [[[notes_t alloc] initWithModel: model]
                                    autorelease], options, all, YES,
                           &wanted);
  size_t bad = 0, apart = 0, miscounted = 0;
  for (unsigned i = 0; i < all.x1 * all.y1; i++)
    {
      bad += !isfinite(k_norm1(notes->pixels[i].color))
        || isnan(notes->surfaces[i].depth);
    }
  for (int isa = 0; isa < 2; isa++)
    {
      options.threads = 1 + 2 * isa;
      image_t *fast = support_render_counted(model, support_fast(model, isa ? nil : @"base"),
                              options, all, YES, &counters);
      apart += support_pixels_apart(notes, fast);
      miscounted += !same_counters(&wanted, &counters);
    }
  PASS(bad == 0 && apart == 0 && miscounted == 0, "scene %llu: %zu not finite,"
       " %zu pixels apart, %zu miscounted", (unsigned long long)seed, bad,
       apart, miscounted);
  unsigned samples = options.samples * camera->exposure;
  PASS(wanted.eye == (uint64_t)all.x1 * all.y1 * samples,
       "scene %llu: all eye rays", (unsigned long long)seed);
  struct window pixel = { seed % all.x1, seed % all.y1, seed % all.x1 + 1,
                          seed % all.y1 + 1 };
  support_render_counted(model, support_fast(model, nil), options, pixel, NO,
          &counters);
  unsigned told = rays_told(model, options, pixel);
  PASS(told == counters.eye + counters.reflection + counters.refraction,
       "scene %llu: %u rays of a pixel", (unsigned long long)seed, told);
}

int
main(int count, char **words)
{
  return random_main(count, words, scene);
}
