#import "vec_t.h"
#include "shade.h"

@implementation vec_t

+ (vec_t *) vec: (struct k_vec)value
{
  return [[[vec_t alloc] initWithValue: value] autorelease];
}

- (id) init: (double)x : (double)y : (double)z
{
  return [self initWithValue: k_vec(x, y, z)];
}

- (id) initWithValue: (struct k_vec)value
{
  if ((self = [super init]))
    {
      v = value;
    }
  return self;
}

- (double) x
{
  return v.x;
}

- (double) y
{
  return v.y;
}

- (double) z
{
  return v.z;
}

- (struct k_vec) value
{
  return v;
}

- (vec_t *) add: (vec_t *)b
{
  return [vec_t vec: k_add(v, b->v)];
}

- (vec_t *) sub: (vec_t *)b
{
  return [vec_t vec: k_sub(v, b->v)];
}

- (vec_t *) mul: (vec_t *)b
{
  return [vec_t vec: k_mul(v, b->v)];
}

- (vec_t *) scale: (double)s
{
  return [vec_t vec: k_scale(v, s)];
}

- (double) dot: (vec_t *)b
{
  return k_dot(v, b->v);
}

- (vec_t *) cross: (vec_t *)b
{
  return [vec_t vec: k_cross(v, b->v)];
}

- (double) length
{
  return k_length(v);
}

- (vec_t *) unit
{
  return [vec_t vec: k_unit(v)];
}

- (vec_t *) reflect: (vec_t *)N
{
  return [vec_t vec: shade_reflect(v, N->v)];
}

- (vec_t *) refract: (vec_t *)N : (double)n
{
  return [vec_t vec: shade_refract(v, N->v, n, NULL)];
}

- (NSString *) description
{
  return [NSString stringWithFormat: @"(%.17g %.17g %.17g)", v.x, v.y, v.z];
}

@end
