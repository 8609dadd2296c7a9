#import "model_t.h"
#import "camera_t.h"
#import "compiler_t.h"
#import "light_t.h"
#import "material_t.h"
#include "grow.h"
#import "names_t.h"
#import "ray_t.h"
#import <objc/runtime.h>

/** One object that rays ask, with what is needed to skip it. */
struct surface
{
  struct k_bounds box;
  object_t *object;
  void (*hits)(id, SEL, ray_t *);       // its method hits:
  BOOL is_opaque;
};

@implementation model_t

- (id) init
{
  if ((self = [super init]))
    {
      lights = [[NSMutableArray alloc] init];
      materials = [[NSMutableDictionary alloc] init];
      objects = [[NSMutableArray alloc] init];
      names = [[names_t alloc] init];
      replacements
        = NSCreateMapTable(NSNonOwnedPointerMapKeyCallBacks,
                           NSObjectMapValueCallBacks, 0);
      surfaces = [objects retain];
      max_depth = 5;
    }
  return self;
}

- (void) dealloc
{
  free(table);
  free(clear);
  [surfaces release];
  [compiler release];
  NSFreeMapTable(replacements);
  [names release];
  [objects release];
  [materials release];
  [lights release];
  [camera release];
  [super dealloc];
}

- (void) addLight: (light_t *)light
{
  [lights addObject: light];
}

/** An object gets its number, and its slack unless its class has. */
static void
number_object(object_t *object, unsigned number)
{
  object->number = number;
  if (object->slack < 0)
    {
      struct k_bounds box = [(id <object_t>)object bounds];
      object->slack = k_is_unbounded(box) ? 0
        : 0x1p-30 * k_max2(k_norm1(box.least), k_norm1(box.most));
    }
}

- (void) addObject: (object_t *)object
{
  number_object(object, ++object_count);
  [objects addObject: object];
}

- (struct object_place) keepPlace
{
  struct object_place place = { ++object_count, [objects count] };

  [objects addObject: [NSNull null]];
  return place;
}

- (void) put: (object_t *)object at: (struct object_place)place
{
  [objects replaceObjectAtIndex: place.index withObject: object];
  number_object(object, place.number);
}

- (object_t *) objectNumbered: (unsigned)number
{
  NSUInteger first = 0, end = [objects count];  // it is in first … end - 1

  if (end == object_count)
    {
      return [objects objectAtIndex: number - 1];
    }
  while (first < end)
    {
      NSUInteger middle = first + (end - first) / 2;
      object_t *object = [objects objectAtIndex: middle];
      if (object->number == number)
        {
          return object;
        }
      if (object->number < number)
        {
          first = middle + 1;
        }
      else
        {
          end = middle;
        }
    }
  return nil;
}

// Completion

static BOOL
overrides_complete(Class class, Class above)
{
  SEL complete = @selector(complete:model:diag:);

  return [class methodForSelector: complete]
    != [above methodForSelector: complete];
}

/** The objects whose classes have something to do when the model is
    complete. */
- (NSArray *) incomplete
{
  NSMutableArray *incomplete = [NSMutableArray array];
  Class last = Nil;
  BOOL is_incomplete = NO;

  for (object_t *object in objects)
    {
      Class class = object_getClass(object);
      if (class != last)
        {
          last = class;
          is_incomplete = overrides_complete(class, [object_t class]);
        }
      if (is_incomplete)
        {
          [incomplete addObject: object];
        }
    }
  return incomplete;
}

/** The classes of these and what they inherit from, below object_t, that have
    something to do: the most general first, otherwise in the order of their
    first object. */
- (NSArray *) classesOf: (NSArray *)incomplete
{
  NSMutableArray *classes = [NSMutableArray array];
  Class last = Nil;

  for (object_t *object in incomplete)
    {
      NSUInteger at = [classes count];
      if ([object class] == last)
        {
          continue;
        }
      last = [object class];
      for (Class c = last; c != [object_t class]; c = [c superclass])
        {
          if (overrides_complete(c, [c superclass])
              && ![classes containsObject: c])
            {
              [classes insertObject: c atIndex: at];
            }
        }
    }
  return classes;
}

- (struct surface *) newTable
{
  struct surface *s = new_array([surfaces count] + 1, sizeof *s), *next = s;

  for (object_t *object in surfaces)
    {
      next->box = [(id <object_t>)object bounds];
      next->object = object;
      next->hits = (void (*)(id, SEL, ray_t *))(void (*)(void))
        [object methodForSelector: @selector(hits:)];
      next->is_opaque = object->material->alpha == 0;
      next++;
    }
  surface_count = next - s;
  return s;
}

/** Makes the table, which only the notes engine needs. Several threads may
    ask for it at once: none sees it before it is complete. */
- (void) makeTable
{
  @synchronized (self)
    {
      if (table == NULL)
        {
          __atomic_store_n(&table, [self newTable], __ATOMIC_RELEASE);
        }
    }
}

- (void) replace: (NSArray *)parts by: (object_t *)whole
{
  for (object_t *part in parts)
    {
      NSMapInsert(replacements, part, [NSNull null]);
    }
  NSMapInsert(replacements, [parts objectAtIndex: 0], whole);
}

- (void) putReplacements
{
  NSMutableArray *kept = [NSMutableArray array];

  if (NSCountMapTable(replacements) == 0)
    {
      return;
    }
  for (id object in surfaces)
    {
      id whole = NSMapGet(replacements, object);
      if (whole != [NSNull null])
        {
          [kept addObject: whole ? whole : object];
        }
    }
  [surfaces release];
  surfaces = [kept retain];
  NSResetMapTable(replacements);
}

- (void) complete: (diag_t *)diag
{
  NSArray *incomplete = [self incomplete];

  for (Class class in [self classesOf: incomplete])
    {
      NSMutableArray *instances = [NSMutableArray array];
      for (object_t *object in incomplete)
        {
          if ([object isKindOfClass: class])
            {
              [instances addObject: object];
            }
        }
      [class complete: instances model: self diag: diag];
    }
  [self putReplacements];
  [self findClear];
}

- (NSArray *) surfaces
{
  return surfaces;
}

// Rays

- (void) find_closest: (ray_t *)ray
{
  struct k_vec o = ray->pos->v;
  uint64_t tests = 0;

  if (__atomic_load_n(&table, __ATOMIC_ACQUIRE) == NULL)
    {
      [self makeTable];
    }
  for (unsigned i = 0; i < surface_count; i++)
    {
      const struct surface *s = &table[i];
      double t_most = ray->is_feeler ? ray->end : ray->hit.t;
      if ((ray->is_feeler && !s->is_opaque)
          || !k_bounds_hit(&s->box, o, ray->inverse, t_most))
        {
          continue;
        }
      tests++;
      s->hits(s->object, @selector(hits:), ray);
      if (ray->is_feeler && ray->hit.object)
        {
          break;
        }
    }
  ray->counters->tests += tests;
}

@end
