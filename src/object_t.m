#import "object_t.h"
#import "block_t.h"
#import "material_t.h"
#import "names_t.h"
#import "ray_t.h"

@implementation object_t

- (id) initWithBlock: (block_t *)block
{
  if ((self = [super init]))
    {
      material = [block material];
      names = block->names;
      name_at = [block addName];
      slack = -1;
    }
  return self;
}

- (NSString *) name
{
  return [names nameAt: name_at];
}

- (BOOL) contains: (struct k_vec)P
{
  vec_t *pos = [[vec_t alloc] initWithValue: P];
  vec_t *dir = [[vec_t alloc] initWithValue: k_unit(k_vec(3, 2, 1))];
  ray_t *ray = [[ray_t alloc] init: pos : dir];
  double t;
  BOOL is_inside = [ray leaves: self at: &t];

  [ray release];
  [dir release];
  [pos release];
  return is_inside;
}

- (BOOL) hasSurfaceIn: (struct k_bounds)box
{
  return YES;
}

- (double) distanceFrom: (struct k_vec)P
{
  struct k_bounds box = [(id <object_t>)self bounds];

  return k_bounds_distance(&box, P);
}

- (id) medium
{
  return self;
}

+ (void) complete: (NSArray *)instances
            model: (model_t *)model
             diag: (diag_t *)diag
{
}

@end
