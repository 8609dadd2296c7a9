#import "sphere_t.h"
#import "block_t.h"
#import "compiler_t.h"
#import "ray_t.h"
#include "kernel/k_sphere_hit.h"

@implementation sphere_t

+ (const struct attribute *) attributes
{
  static const struct attribute table[] = {
    { .name = "material", .kind = ATTRIBUTE_MATERIAL, .is_required = 1 },
    { .name = "center", .kind = ATTRIBUTE_POINT, .is_required = 1 },
    { .name = "radius", .kind = ATTRIBUTE_NUMBER, .is_required = 1,
      .range = RANGE_POSITIVE },
    { .name = NULL }
  };
  return table;
}

/** Of its centre and radius. */
static double
slack_of(struct k_vec center, double radius)
{
  return 16 * K_U * (k_norm1(center) + radius);
}

- (id) initWithBlock: (block_t *)block
{
  if ((self = [super initWithBlock: block]))
    {
      center = [block vector: "center" at: 0];
      radius = [block number: "radius" at: 0];
      slack = slack_of(center, radius);
    }
  return self;
}

- (struct k_bounds) bounds
{
  struct k_vec r = k_vec(radius, radius, radius);
  struct k_bounds box = { k_sub(center, r), k_add(center, r) };

  return k_bounds_pad(box);
}

- (BOOL) contains: (struct k_vec)P
{
  return k_sphere_power(P, center, radius) < 0;
}

- (double) distanceFrom: (struct k_vec)P
{
  return fabs(k_length(k_sub(P, center)) - radius);
}

/** The far side, for a ray that starts on the inner side of this sphere: one
    root is where it starts, the other is exact. */
- (void) farSideOf: (ray_t *)ray
{
  double t = -2 * k_dot(k_sub(ray->pos->v, center), ray->dir->v);

  t = t > 0 ? t : 0;
  struct k_vec N = k_unit(k_sub(k_along(ray->pos->v, t, ray->dir->v),
                                center));
  [ray exits: self at: t normal: N point: k_along(center, radius, N)];
}

- (void) hits: (ray_t *)ray
{
  double t0, t1, s;
  struct k_vec p;

  if (ray->from == self)
    {
      if (ray->starts_inside)
        {
          [self farSideOf: ray];
        }
      return;
    }
  int how = k_sphere_hit(ray->pos->v, ray->dir->v, center, radius,
                         &t0, &t1, &p, &s);
  if (how == 0)
    {
      return;
    }
  BOOL is_met = NO;
  if ([ray wants: t0])
    {
      struct k_vec N = k_sphere_normal(p, s, -1, ray->dir->v);
      is_met |= [ray meets: self at: t0 normal: N
                     point: k_along(center, radius, N)];
    }
  if ([ray wants: t1])
    {
      struct k_vec N = k_sphere_normal(p, s, +1, ray->dir->v);
      is_met |= [ray meets: self at: t1 normal: N
                     point: k_along(center, radius, N)];
    }
  if (is_met)
    {
      ray->hit.is_compensated = how == K_SPHERE_COMPENSATED;
    }
}

+ (void) prepare: (NSUInteger)count for: (compiler_t *)compiler
{
  k_expect_spheres(compiler->scene, count);
}

- (BOOL) compile: (compiler_t *)compiler
{
  k_add_sphere(compiler->scene, [compiler surfaceOf: self], center, radius);
  return YES;
}

+ (BOOL) compileBlock: (block_t *)block number: (unsigned)number
                  for: (compiler_t *)compiler
{
  struct k_vec center = [block vector: "center" at: 0];
  double radius = [block number: "radius" at: 0];
  struct k_surface s = [compiler surfaceOf: [block material] number: number
                                     slack: slack_of(center, radius)];

  k_add_sphere(compiler->scene, s, center, radius);
  return YES;
}

@end
