#import "plan_t.h"
#import "camera_t.h"
#include "batches.h"
#import "model_t.h"
#include "kernel/k.h"
#include <inttypes.h>

#define STEP 16                 // one pixel in STEP x STEP is tried,
#define MOST_TRIED (1 << 18)    // of a large picture fewer

@implementation plan_t

/** Traces a few pixels, without lens; how many of the window's there are for
    each of them. */
+ (double) try: (struct window)w of: (camera_t *)camera
        engine: (fast_t *)engine counters: (struct counters *)counters
{
  uint64_t pixels = (uint64_t)(w.x1 - w.x0) * (w.y1 - w.y0), tried = 0;
  unsigned step = STEP;

  while (pixels / step / step > MOST_TRIED)
    {
      step *= 2;
    }
  for (unsigned y = w.y0; y < w.y1; y += step)
    {
      for (unsigned x = w.x0; x < w.x1; x += step, tried++)
        {
          struct sample s = { .column = x, .row = camera->rows - 1 - y };
          struct eye_ray ray;
          [camera centralRay: s pos: &ray.o dir: &ray.d];
          [engine trace: &ray : 1 counters: counters];
        }
    }
  return (double)pixels / tried;
}

/** "3 spheres, 1 plane" (autoreleased). */
+ (NSString *) shapesOf: (const struct k_facts *)f
{
  const struct
    {
      uint32_t count;
      NSString *one, *many;
    }
  kinds[] = {
    { f->spheres, @"sphere", @"spheres" },
    { f->planes, @"plane", @"planes" },
    { f->polygons, @"polygon", @"polygons" },
    { f->convex, @"clear convex solid", @"clear convex solids" },
    { f->users, @"shape asked as an object", @"shapes asked as objects" }
  };
  NSMutableArray *words = [NSMutableArray array];

  for (unsigned i = 0; i < sizeof kinds / sizeof *kinds; i++)
    {
      if (kinds[i].count)
        {
          [words addObject: [NSString stringWithFormat: @"%u %@",
                                      kinds[i].count, kinds[i].count == 1
                                      ? kinds[i].one : kinds[i].many]];
        }
    }
  return [words count] ? [words componentsJoinedByString: @", "] : @"none";
}

/** What no ray of the scene needs (autoreleased). */
+ (NSString *) leftOut: (const struct k_facts *)f of: (model_t *)model
{
  NSMutableArray *words = [NSMutableArray array];

  if ([model->lights count] == 0)
    {
      [words addObject: @"shadow feelers (no light)"];
    }
  if (!f->has_mirrors)
    {
      [words addObject: @"mirror rays and highlights (nothing specular)"];
    }
  if (!f->has_clear)
    {
      [words addObject: @"refraction and media (nothing transparent)"];
    }
  if (f->polygons == 0)
    {
      [words addObject: @"the polygons' view along each ray (no polygon)"];
    }
  if (f->nodes == 0)
    {
      [words addObject: @"the tree (no shape has a box)"];
    }
  if (!model->camera->has_lens)
    {
      [words addObject: @"lens samples (pinhole)"];
    }
  return [words count] ? [words componentsJoinedByString: @"; "] : @"nothing";
}

+ (NSString *) of: (model_t *)model engine: (fast_t *)engine
           window: (struct window)w
          options: (struct render_options)options depth: (unsigned)depth
{
  NSMutableString *text = [NSMutableString string];
  struct counters c = { 0 };
  struct k_facts f;
  camera_t *camera = model->camera;
  uint64_t pixels = (uint64_t)(w.x1 - w.x0) * (w.y1 - w.y0);
  // With --noise at least so many, and how many more nobody knows yet.
  uint64_t per_pixel = options.noise > 0
    ? (uint64_t)BATCHES * batches_start(options.noise,
                                        options.sampler == SAMPLER_RANDOM,
                                        options.max_samples)
    : (uint64_t)options.samples * camera->exposure;
  double each = [self try: w of: camera engine: engine counters: &c]
    * per_pixel;

  k_scene_facts(engine->scene, &f);
  [text appendFormat: @"picture   %u x %u pixels, %" PRIu64 " traced, %"
        PRIu64 " ray%s through each\n", camera->columns, camera->rows, pixels,
        per_pixel, per_pixel == 1 ? "" : "s"];
  [text appendFormat: @"shapes    %@\n", [self shapesOf: &f]];
  [text appendFormat: @"lights    %lu\n",
        (unsigned long)[model->lights count]];
  [text appendFormat: @"media     %u\n", f.media];
  [text appendFormat: @"tree      %u node%s, %u deep\n", f.nodes,
        f.nodes == 1 ? "" : "s", f.depth];
  [text appendFormat: @"depth     %u generation%s of rays at most\n",
        depth + 1, depth == 0 ? "" : "s"];
  [text appendFormat: @"left out  %@\n", [self leftOut: &f of: model]];
  [text appendFormat: @"memory    %zu bytes for the scene, %" PRIu64
        " for a picture of 8 bits, %" PRIu64 " for an .exr\n", f.bytes,
        pixels * [image_t bytesOfPixel: KEEP_BYTES],
        pixels * [image_t bytesOfPixel: KEEP_FLOATS]];
  [text appendFormat: @"rays      about %.2g: %.2g eye, %.2g reflection,"
        @" %.2g refraction, %.2g feeler\n", each * counters_rays(&c),
        each * c.eye, each * c.reflection, each * c.refraction,
        each * c.feeler];
  [text appendFormat: @"threads   %u, instructions %s\n", options.threads,
        f.isa];
  return text;
}

@end
