#import "compiler_t.h"
#import "material_t.h"

@implementation object_t (Compiling)

- (BOOL) compile: (compiler_t *)compiler
{
  return NO;
}

+ (BOOL) compileBlock: (block_t *)block number: (unsigned)number
                  for: (compiler_t *)compiler
{
  return NO;
}

+ (void) prepare: (NSUInteger)count for: (compiler_t *)compiler
{
}

@end

@implementation compiler_t

- (id) init
{
  if ((self = [super init]))
    {
      scene = k_scene_new();
      materials = NSCreateMapTable(NSNonOwnedPointerMapKeyCallBacks,
                                   NSIntegerMapValueCallBacks, 0);
      media = NSCreateMapTable(NSNonOwnedPointerMapKeyCallBacks,
                               NSIntegerMapValueCallBacks, 0);
      mediumObjects = [[NSMutableArray alloc] init];
      materialObjects = [[NSMutableArray alloc] init];
      if (scene == NULL)
        {
          [self release];
          return nil;
        }
    }
  return self;
}

- (void) dealloc
{
  k_scene_free(scene);
  NSFreeMapTable(materials);
  NSFreeMapTable(media);
  [mediumObjects release];
  [materialObjects release];
  [super dealloc];
}

- (unsigned) numberOf: (material_t *)m
{
  uintptr_t number = (uintptr_t)NSMapGet(materials, m);

  if (number == 0)
    {
      struct k_material copy = { m->ambient, m->diffuse, m->specular,
                                 m->shininess, m->alpha, m->ior };
      number = k_add_material(scene, &copy) + 1;
      NSMapInsert(materials, m, (void *)number);
      [materialObjects addObject: m];
    }
  return number - 1;
}

- (unsigned) mediumOf: (object_t *)object
{
  object_t *medium = [object medium];
  uintptr_t number = medium ? (uintptr_t)NSMapGet(media, medium) : 0;

  if (medium && number == 0)
    {
      number = k_add_medium(scene,
                            !k_is_unbounded([(id <object_t>)medium bounds]));
      NSMapInsert(media, medium, (void *)number);
      [mediumObjects addObject: medium];
    }
  return number;
}

- (object_t *) mediumNumbered: (unsigned)number
{
  return [mediumObjects objectAtIndex: number - 1];
}

- (object_t *) newStandInFor: (const struct k_surface *)surface
{
  object_t *object = [[object_t alloc] init];

  object->material = [materialObjects objectAtIndex: surface->material];
  object->number = surface->number;
  object->slack = surface->slack;
  return object;
}

- (struct k_surface) surfaceOf: (material_t *)material number: (unsigned)number
                         slack: (double)slack
{
  if (material != last_material)
    {
      last_number = [self numberOf: material];
      last_material = material;
    }

  return (struct k_surface){ number, last_number, 0, slack };
}

- (struct k_surface) surfaceOf: (object_t *)object
{
  struct k_surface s = [self surfaceOf: object->material
                                number: object->number slack: object->slack];

  if (object->material->alpha > 0)
    {
      s.medium = [self mediumOf: object];
    }
  return s;
}

@end
