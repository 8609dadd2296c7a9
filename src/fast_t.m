#import "fast_t.h"
#import "compiler_t.h"
#import "errors.h"
#import "light_t.h"
#import "material_t.h"
#import "media_t.h"
#import "model_t.h"
#import "ray_t.h"
#import <objc/runtime.h>
#include "kernel/k_ray.h"
#include <alloca.h>

/** A shape that did not describe itself. */
struct user
{
  object_t *object;
  model_t *model;
  compiler_t *compiler;
};

/** The kernel's media as objects (autoreleased). */
static media_t *
media_of(const struct k_media *media, compiler_t *compiler)
{
  return media == NULL ? nil
    : [media_t enter: [compiler mediumNumbered: media->medium] : media->ior
                over: media_of(media->below, compiler)];
}

/** The object of a surface, or somebody who stands for it (not autoreleased);
    nil for none. */
static object_t *
object_of(const struct user *user, const struct k_surface *s)
{
  object_t *object = s ? [user->model objectNumbered: s->number] : nil;

  return object || s == NULL ? [object retain]
    : [user->compiler newStandInFor: s];
}

/** Asks it through a ray_t that is as far as the kernel's ray. */
static void
ask_object(void *shape, const struct k_surface *s, struct k_ray *ray)
{
  const struct user *user = shape;
  NSAutoreleasePool *pool = ray->media ? [[NSAutoreleasePool alloc] init]
    : nil;
  vec_t *pos = [[vec_t alloc] initWithValue: ray->o];
  vec_t *dir = [[vec_t alloc] initWithValue: ray->d];
  ray_t *twin = [(ray_t *)[ray_t alloc] init: pos : dir];

  object_t *from = object_of(user, ray->from);
  object_t *hit = object_of(user, ray->hit.surface);

  twin->from = from;
  twin->hit.object = hit;
  twin->hit.t = ray->hit.t;
  twin->starts_inside = ray->starts_inside;
  twin->slack = ray->slack;
  twin->is_feeler = ray->is_feeler;
  twin->end = ray->end;
  twin->end_slack = ray->end_slack;
  twin->media = [media_of(ray->media, user->compiler) retain];
  [(id <object_t>)user->object hits: twin];
  if (twin->hit.object == user->object)
    {
      ray->hit.t = twin->hit.t;
      ray->hit.surface = s;
      ray->hit.P = twin->hit.P;
      ray->hit.N = twin->hit.N;
      ray->hit.finish = K_FINISHED;
      ray->hit.is_compensated = twin->hit.is_compensated;
    }
  if (twin->tie == ray->hit.t)
    {
      ray->tied = ray->hit.surface;
    }
  [twin release];
  [hit release];
  [from release];
  [dir release];
  [pos release];
  [pool release];
}

@implementation fast_t

- (void) addUser: (object_t *)object
{
  struct user *user = &users[user_count++];
  struct k_user shape = { ask_object, user,
                          [(id <object_t>)object bounds] };

  user->object = object;
  user->model = model;
  user->compiler = compiler;
  k_add_user(scene, [compiler surfaceOf: object], shape);
}

typedef BOOL (*compile_t)(id, SEL, compiler_t *);

/** Asks all objects to describe themselves. */
- (void) compile: (NSArray *)objects
{
  NSUInteger left = [objects count];
  Class last = Nil;
  compile_t compile = NULL;

  for (object_t *object in objects)
    {
      Class class = object_getClass(object);
      if (class != last)
        {
          last = class;
          compile = (compile_t)(void (*)(void))
            [class instanceMethodForSelector: @selector(compile:)];
          [class prepare: left for: compiler];
        }
      left--;
      if (!compile(object, @selector(compile:), compiler))
        {
          [self addUser: object];
        }
    }
}

- (id) initWithModel: (model_t *)aModel instructions: (NSString *)instructions
            threads: (unsigned)threads
               error: (NSError **)error
{
  if ((self = [super init]))
    {
      NSArray *surfaces = [aModel surfaces];
      NSUInteger count = [surfaces count];

      model = [aModel retain];
      // What was passed on is in it already.
      compiler = model->compiler ? model->compiler : [[compiler_t alloc] init];
      model->compiler = nil;
      users = calloc(count + 1, sizeof *users);
      if (compiler && users)
        {
          scene = compiler->scene;
          [self compile: surfaces];
          for (light_t *l in model->lights)
            {
              struct k_light light = { l->location, l->emissivity,
                                       l->falloff };
              k_add_light(scene, &light);
            }
          struct k_settings settings = {
            model->background, model->max_depth, model->cut,
            model->choice, threads,
            [instructions UTF8String]
          };
          switch (k_scene_finish(scene, settings))
            {
            case K_OK:
              return self;
            case K_NO_ISA:
              *error = error_saying(STATUS_USAGE, @"this machine does not have"
                                    @" the instructions '%@'", instructions);
              [self release];
              return nil;
            case K_NO_MEMORY:
              break;
            }
        }
      *error = error_saying(STATUS_FILE, @"not enough memory for the scene");
      [self release];
      self = nil;
    }
  return self;
}

- (void) dealloc
{
  free(users);
  [compiler release];
  [model release];
  [super dealloc];
}

/** What an eye ray starts in, as the kernel has it, into `room`. */
- (const struct k_media *) mediaOf: (media_t *)media
                              into: (struct k_media *)room
{
  struct k_media *first = room;

  for (; media; media = media->below, room++)
    {
      room->medium = [compiler mediumOf: media->object];
      room->ior = media->ior;
      room->below = media->below ? room + 1 : NULL;
    }
  return room == first ? NULL : first;
}

/** The media an eye ray starts in. */
- (media_t *) startOf: (struct k_vec)o : (struct k_vec)d
{
  ray_t *ray = [(ray_t *)[ray_t alloc] init: [vec_t vec: o]
                                           : [vec_t vec: d]];
  media_t *media = [model mediaOf: ray];

  [ray release];
  return media;
}

static unsigned
depth_of(media_t *media)
{
  unsigned depth = 0;

  for (; media; media = media->below)
    {
      depth++;
    }
  return depth;
}

/** With what each ray starts in. */
- (void) trace: (struct eye_ray *)rays insideOf: (unsigned)count
      counters: (struct counters *)counters
{
  NSAutoreleasePool *pool = [[NSAutoreleasePool alloc] init];
  const struct k_media *media[count];

  for (unsigned i = 0; i < count; i++)
    {
      media_t *start = [model mayStartInside: &rays[i] : 1]
        ? [self startOf: rays[i].o : rays[i].d] : nil;
      media[i] = [self mediaOf: start
                          into: alloca(depth_of(start)
                                       * sizeof(struct k_media))];
    }
  k_trace(scene, rays, count, media, counters);
  [pool release];
}

- (void) trace: (struct eye_ray *)rays : (unsigned)count
      counters: (struct counters *)counters
{
  if (![model mayStartInside: rays : count])
    {
      k_trace(scene, rays, count, NULL, counters);
      return;
    }
  for (unsigned i = 0; i < count; i += EYE_RAYS)
    {
      [self trace: &rays[i] insideOf: MIN(count - i, EYE_RAYS)
         counters: counters];
    }
}

- (struct surface_pixel) surfaceAt: (struct k_vec)o : (struct k_vec)d
{
  NSAutoreleasePool *pool = [[NSAutoreleasePool alloc] init];
  struct eye_ray ray = { .o = o, .d = d };
  media_t *start = [model mayStartInside: &ray : 1] ? [self startOf: o : d]
    : nil;
  struct k_media room[depth_of(start) + 1];
  struct k_surface_hit hit = k_first_hit(scene, o, d,
                                         [self mediaOf: start into: room]);
  struct surface_pixel surface = { hit.t, hit.N, hit.number };

  [pool release];
  return surface;
}

@end
