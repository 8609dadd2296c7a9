// alive.m - nothing stays alive: not a ray nor a vector when a picture is
// done, not an object when a scene is released. Foundation counts.

#import "scene.h"
#import <Foundation/NSDebug.h>
#include <objc/runtime.h>
#include "test.h"

/** Our own classes: those whose name ends in _t. */
static NSMutableArray *names;

static void
find_classes(void)
{
  int count = objc_getClassList(NULL, 0);
  Class *classes = calloc(count, sizeof *classes);

  names = [[NSMutableArray alloc] init];
  count = objc_getClassList(classes, count);
  for (int i = 0; i < count; i++)
    {
      NSString *name = NSStringFromClass(classes[i]);
      if ([name hasSuffix: @"_t"])
        {
          [names addObject: name];
        }
    }
  free(classes);
}

/** How many objects of our classes are alive. */
static long
alive(void)
{
  long sum = 0;

  for (NSString *name in names)
    {
      sum += GSDebugAllocationCount(NSClassFromString(name));
    }
  return sum;
}

/** Says which classes have grown since `before`. */
static void
tell(long *before, BOOL is_first)
{
  unsigned i = 0;

  for (NSString *name in names)
    {
      long now = GSDebugAllocationCount(NSClassFromString(name));
      if (!is_first && now != before[i])
        {
          printf("# %s: %ld alive, %ld before\n", [name UTF8String], now,
                 before[i]);
        }
      before[i++] = now;
    }
}

static void
per_ray(struct scene how, const char *what)
{
  long before[512], count;
  NSAutoreleasePool *pool = [[NSAutoreleasePool alloc] init];
  model_t *model = scene_model(how);
  struct window all = { 0, 0, model->camera->columns, model->camera->rows };
  image_t *image = [[image_t alloc] init: model->camera->columns
                                        : model->camera->rows
                                  window: all surfaces: YES error: NULL];
  struct render_options options = support_render_options();
  id <engine_t> notes = [[[notes_t alloc] initWithModel: model] autorelease];
  render_t *render = [[render_t alloc] init: notes camera: model->camera
                                       into: image options: options];
  NSAutoreleasePool *inner = [[NSAutoreleasePool alloc] init];

  count = alive();
  tell(before, YES);
  [render run];
  [inner release];
  PASS(render->counters.reflection > 1000 && render->counters.refraction > 500
       && render->counters.feeler > 1000, "%s: rays of all kinds were made",
       what);
  long now = alive();
  if (!PASS(now == count, "%s: none of them is alive: %ld objects more", what,
            now - count))
    {
      tell(before, NO);
    }
  [render release];
  [image release];
  [pool release];
}

/** One ray by hand: what it spawns is gone when its pool is. */
static void
one_ray(void)
{
  NSAutoreleasePool *pool = [[NSAutoreleasePool alloc] init];
  struct scene how = { 0 };
  model_t *model = scene_model(how);
  long rays = GSDebugAllocationCount([ray_t class]);
  long vectors = GSDebugAllocationCount([vec_t class]);
  long media = GSDebugAllocationCount([media_t class]);
  unsigned most = 0;

  for (unsigned i = 0; i < 200; i++)
    {
      NSAutoreleasePool *inner = [[NSAutoreleasePool alloc] init];
      struct support_random random = support_seed(i);
      struct k_vec aim = support_point(&random, 3);
      vec_t *pos = [[vec_t alloc] init: 0 : 1.5 : 9];
      vec_t *dir = [[vec_t alloc]
                     initWithValue: k_unit(k_sub(aim, k_vec(0, 1.5, 9)))];
      ray_t *ray = [(ray_t *)[ray_t alloc] init: pos : dir];
      vec_t *color = [ray trace: model];
      // Rays are released, not autoreleased: only this one is alive.
      long now = GSDebugAllocationCount([ray_t class]) - rays;
      most = now > (long)most ? now : most;
      (void)color;
      [ray release];
      [dir release];
      [pos release];
      [inner release];
    }
  PASS(most == 1, "while a ray returns its colour no other is alive: %u",
       most);
  PASS(GSDebugAllocationCount([ray_t class]) == rays, "no ray stays");
  PASS(GSDebugAllocationCount([vec_t class]) == vectors, "no vector stays");
  PASS(GSDebugAllocationCount([media_t class]) == media, "no medium stays");
  [pool release];
}

static void
load(void)
{
  NSAutoreleasePool *pool = [[NSAutoreleasePool alloc] init];
  struct scene how = { .has_lens = 1 };

  scene_model(how);
  [pool release];
}

static void
load_with_faults(void)
{
  NSAutoreleasePool *pool = [[NSAutoreleasePool alloc] init];

  // Every kind of fault that is found when some objects are already made.
  support_faults(SUPPORT_CAMERA "material m { }\n"
    "sphere a { material m center 0 0 0 radius 1 }\n"
    "sphere b { material n center 0 0 0 radius -1 }\n"
    "polygon p { material m vertex 0 0 0 vertex 1 0 0 vertex 2 0 0 }\n"
    "polygon q { material m solid s vertex 0 0 0 vertex 1 0 0 vertex 2 1 0 }\n"
    "torus t { }\nsphere a { material m center 0 0 0 radius 1 }\n"
    "light l { location 1 2 }\n");
  support_faults("");
  support_faults("camera c { } }");
  support_faults("sphere s { center nan");
  [pool release];
}

static void
per_scene(void (*load_it)(void), const char *what)
{
  long before[512];

  load_it();                    // tables that are made once
  long count = alive();
  tell(before, YES);
  for (int i = 0; i < 5; i++)
    {
      load_it();
    }
  long now = alive();
  if (!PASS(now == count, "%s: five times leaves nothing: %ld objects more",
            what, now - count))
    {
      tell(before, NO);
    }
}

int
main(void)
{
  NSAutoreleasePool *pool = [[NSAutoreleasePool alloc] init];
  struct scene pinhole = { .columns = 40, .rows = 30 };
  struct scene lens = { .has_lens = 1, .columns = 20, .rows = 15 };

  GSDebugAllocationActive(YES);
  find_classes();
  PASS([names containsObject: @"ray_t"] && [names containsObject: @"solid_t"]
       && [names containsObject: @"media_t"] && [names count] < 512,
       "our classes are known: %u", (unsigned)[names count]);
  vec_t *v = [[vec_t alloc] init: 1 : 2 : 3];
  long with = alive();
  [v release];
  PASS(alive() == with - 1, "counting works");
  per_ray(pinhole, "pinhole");
  per_ray(lens, "lens");
  one_ray();
  per_scene(load, "loading and releasing a scene");
  per_scene(load_with_faults, "files with faults");
  [names release];
  [pool release];
  return test_done();
}
