#import "notes_t.h"
#import "model_t.h"
#import "ray_t.h"

@implementation notes_t

- (id) initWithModel: (model_t *)aModel
{
  if ((self = [super init]))
    {
      model = [aModel retain];
    }
  return self;
}

- (void) dealloc
{
  [model release];
  [super dealloc];
}

- (Class) rayClass
{
  return [ray_t class];
}

- (ray_t *) rayAt: (struct k_vec)o : (struct k_vec)d
{
  ray_t *ray = [(ray_t *)[[self rayClass] alloc] init: [vec_t vec: o]
                                                    : [vec_t vec: d]];

  ray->media = [[model mediaOf: ray] retain];
  ray->cut = cut_eye(&model->cut);
  return ray;
}

- (void) trace: (struct eye_ray *)rays : (unsigned)count
      counters: (struct counters *)counters
{
  for (unsigned i = 0; i < count; i++)
    {
      NSAutoreleasePool *pool = [[NSAutoreleasePool alloc] init];
      ray_t *ray = [self rayAt: rays[i].o : rays[i].d];
      counters->eye++;
      ray->counters = counters;
      rays[i].color = [ray trace: model]->v;
      rays[i].error = ray->cut.error;
      [ray release];
      [pool release];
    }
}

- (struct surface_pixel) surfaceAt: (struct k_vec)o : (struct k_vec)d
{
  struct surface_pixel surface = { HUGE_VAL, { 0, 0, 0 }, 0 };
  NSAutoreleasePool *pool = [[NSAutoreleasePool alloc] init];
  ray_t *ray = [self rayAt: o : d];

  [model find_closest: ray];
  if (ray->hit.object)
    {
      surface.depth = ray->hit.t;
      surface.N = ray->hit.N;
      surface.object = ray->hit.object->number;
    }
  [ray release];
  [pool release];
  return surface;
}

@end
