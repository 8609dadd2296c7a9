#import "plane_t.h"
#import "block_t.h"
#import "compiler_t.h"
#import "ray_t.h"

@implementation plane_t

+ (const struct attribute *) attributes
{
  static const struct attribute table[] = {
    { .name = "material", .kind = ATTRIBUTE_MATERIAL, .is_required = 1 },
    { .name = "normal", .kind = ATTRIBUTE_VECTOR, .is_required = 1 },
    { .name = "point", .kind = ATTRIBUTE_POINT, .is_required = 1 },
    { .name = NULL }
  };
  return table;
}

- (id) initWithBlock: (block_t *)block
{
  if ((self = [super initWithBlock: block]))
    {
      plane.n = k_unit([block vector: "normal" at: 0]);
      plane.q = [block vector: "point" at: 0];
      slack = 16 * K_U * k_norm1(plane.q);
    }
  return self;
}

- (struct k_bounds) bounds
{
  return k_unbounded();
}

- (double) extent
{
  return HUGE_VAL;
}

- (BOOL) liesIn: (const struct k_plane *)other
{
  double off = k_dot(other->n, k_sub(plane.q, other->q));
  double magnitude = k_norm1(plane.q) + k_norm1(other->q);

  return k_norm_max(k_cross(plane.n, other->n)) <= 8 * K_U
    && fabs(off) <= 8 * K_U * magnitude;
}

/** Behind the plane. */
- (BOOL) contains: (struct k_vec)P
{
  return k_dot(plane.n, k_sub(P, plane.q)) < 0;
}

- (void) hits: (ray_t *)ray
{
  struct k_vec o = ray->pos->v, d = ray->dir->v;
  double t;

  if (ray->from != self && k_plane_hit(&plane, o, d, &t) && [ray wants: t])
    {
      [ray meets: self at: t normal: plane.n
           point: k_plane_point(&plane, o, d, t)];
    }
}

- (BOOL) compile: (compiler_t *)compiler
{
  k_add_plane(compiler->scene, [compiler surfaceOf: self], plane);
  return YES;
}

@end
