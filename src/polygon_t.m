#import "polygon_t.h"
#import "block_t.h"
#import "compiler_t.h"
#import "diag_t.h"
#import "ray_t.h"
#import "solid_t.h"
#include "grow.h"
#include "kernel/k_polygon_hit.h"

@implementation polygon_t

+ (const struct attribute *) attributes
{
  static const struct attribute table[] = {
    { .name = "material", .kind = ATTRIBUTE_MATERIAL, .is_required = 1 },
    { .name = "vertex", .kind = ATTRIBUTE_POINT, .is_required = 1,
      .is_repeated = 1 },
    { .name = "solid", .kind = ATTRIBUTE_NAME },
    { .name = NULL }
  };
  return table;
}

/** Takes the vertices over, repeated neighbours once, -0 as +0. The first one
    stays the first: the plane goes through it. */
- (void) readVertices: (block_t *)block
{
  unsigned given = [block count: "vertex"];
  struct k_vec first = k_vec(0, 0, 0), last = first;

  for (int axis = 0; axis < 3; axis++)
    {
      vertex[axis] = new_array(given, sizeof(double));
    }
  box = k_nothing();
  for (unsigned i = 0; i < given; i++)
    {
      struct k_vec v = k_add([block vector: "vertex" at: i], k_vec(0, 0, 0));
      if (count == 0 || !k_is_equal(v, last))
        {
          vertex[0][count] = v.x;
          vertex[1][count] = v.y;
          vertex[2][count] = v.z;
          first = count == 0 ? v : first;
          last = v;
          count++;
          box = k_bounds_include(box, v);
        }
    }
  while (count > 1 && k_is_equal([self vertexAt: count - 1], first))
    {
      count--;
    }
}

/** Newell's normal, from vectors relative to the first vertex so that
    nothing is lost far from the origin. *area_is_noise: it is no larger than
    the rounding errors in it. */
- (struct k_vec) newellNormal: (BOOL *)area_is_noise
{
  struct k_vec v0 = [self vertexAt: 0];
  struct k_vec a = k_vec(0, 0, 0), sum = a, magnitude = a;

  for (unsigned i = 1; i < count; i++)
    {
      struct k_vec b = k_sub([self vertexAt: i], v0);
      sum = k_add(sum, k_cross(a, b));
      magnitude = k_add(magnitude,
                        k_vec(fabs(a.y * b.z) + fabs(a.z * b.y),
                              fabs(a.z * b.x) + fabs(a.x * b.z),
                              fabs(a.x * b.y) + fabs(a.y * b.x)));
      a = b;
    }
  *area_is_noise = k_norm_max(sum) <= 4 * K_U * k_norm_max(magnitude);
  return sum;
}

/** How flat it is: farther than 1e-4 of its extent from the plane is a fault
    of the vertex, more than rounding is worth a warning. */
- (void) checkPlanarity: (block_t *)block
{
  double extent = k_bounds_extent(box), worst = 0;
  unsigned given = [block count: "vertex"], worst_vertex = 0;

  for (unsigned i = 0; i < given; i++)
    {
      struct k_vec v = [block vector: "vertex" at: i];
      double off = fabs(k_dot(plane.n, k_sub(v, plane.q)));
      if (off > worst)
        {
          worst = off;
          worst_vertex = i;
        }
    }
  if (worst > 1e-4 * extent)
    {
      [block fault: [block placeOf: "vertex" at: worst_vertex]
                  : @"polygon '%@' is not planar: this vertex is %.3g off its"
        @" plane, more than 1e-4 of the polygon's extent %.6g",
             [self name], worst, extent];
    }
  else if (worst > 0x1p-20 * extent)
    {
      [block warn: [block placeOf: "vertex" at: worst_vertex]
                 : @"polygon '%@' is not quite planar: this vertex is %.3g"
        @" off its plane", [self name], worst];
    }
}

- (id) initWithBlock: (block_t *)block
{
  if ((self = [super initWithBlock: block]))
    {
      BOOL area_is_noise = YES;

      place = [block place];
      material_place = [block placeOfValue: "material" at: 0];
      solid_name = [[block word: "solid"] copy];
      if (solid_name)
        {
          solid_place = [block placeOfValue: "solid" at: 0];
        }
      if ([block count: "vertex"] < 3)
        {
          [block fault: place : @"polygon '%@' has %u vertices, expected"
            @" three or more", [self name], [block count: "vertex"]];
          return self;
        }
      [self readVertices: block];
      struct k_vec normal = [self newellNormal: &area_is_noise];
      if (count < 3 || area_is_noise)
        {
          [block fault: place : @"polygon '%@' has no area", [self name]];
          return self;
        }
      newell = plane.n = k_unit(normal);
      plane.q = [self vertexAt: 0];
      slack = 16 * K_U * k_max2(k_norm1(box.least), k_norm1(box.most));
      const double *const v[3] = { vertex[0], vertex[1], vertex[2] };
      grazing = k_polygon_grazing(&plane, count, v);
      [self checkPlanarity: block];
    }
  return self;
}

- (void) dealloc
{
  for (int axis = 0; axis < 3; axis++)
    {
      free(vertex[axis]);
    }
  [solid_name release];
  [super dealloc];
}

- (struct k_vec) vertexAt: (unsigned)i
{
  return k_vec(vertex[0][i], vertex[1][i], vertex[2][i]);
}

- (struct k_bounds) bounds
{
  return k_bounds_pad(box);
}

- (double) extent
{
  return k_bounds_extent(box);
}

/** A plane that is known from very far away lies anywhere, as far as can be
    told: it must not move a corner by more than a millionth of the polygon or
    the corner's own rounding. */
- (BOOL) liesIn: (const struct k_plane *)other
{
  double q1 = k_norm1(other->q);
  double part = 0x1p-20 * [self extent];

  for (unsigned i = 0; i < count; i++)
    {
      struct k_vec v = [self vertexAt: i];
      double off = fabs(k_dot(other->n, k_sub(v, other->q)));
      double v1 = k_norm1(v);
      if (off > 8 * K_U * (v1 + q1) || off > k_max2(part, 16 * K_U * v1))
        {
          return NO;
        }
    }
  return YES;
}

- (void) takePlane: (struct k_plane)shared
{
  const double *const v[3] = { vertex[0], vertex[1], vertex[2] };

  [super takePlane: shared];
  grazing = k_polygon_grazing(&plane, count, v);
}

- (double) distanceFrom: (struct k_vec)P
{
  return k_max2([super distanceFrom: P], k_bounds_distance(&box, P));
}

- (id) medium
{
  return solid;
}

- (void) turn
{
  plane.n = k_neg(plane.n);
}

/** Convex: going round, the outline turns to one side only, and once. A turn
    that rounding of the corners can make is none. */
- (BOOL) isConvex
{
  struct k_vec a = [self vertexAt: count - 2], b = [self vertexAt: count - 1];
  int turns = 0, flips = 0, last_sign = 0;
  int axis = fabs(plane.n.x) > 0.5 ? 1 : 0;     // not along the normal

  for (unsigned i = 0; i < count; i++)
    {
      struct k_vec c = [self vertexAt: i];
      struct k_vec ab = k_sub(b, a), bc = k_sub(c, b);
      double turn = k_dot(newell, k_cross(ab, bc));
      double noise = slack * (k_norm1(ab) + k_norm1(bc));
      double step = k_component(c, axis) - k_component(b, axis);
      int sign = (step > slack) - (step < -slack);
      turns |= turn > noise ? 1 : turn < -noise ? 2 : 0;
      flips += sign != 0 && last_sign != 0 && sign != last_sign;
      last_sign = sign != 0 ? sign : last_sign;
      a = b;
      b = c;
    }
  return turns != 3 && flips <= 2;
}

- (BOOL) meetsPlane: (ray_t *)ray at: (double *)t
{
  struct k_vec o = ray->pos->v, d = ray->dir->v;
  const double *const v[3] = { vertex[0], vertex[1], vertex[2] };

  return k_plane_hit(&plane, o, d, t)
    && (test != POLYGON_CROSSINGS
        || k_polygon_settle(&plane, o, d, grazing, count, v, t));
}

- (BOOL) holds: (ray_t *)ray at: (double)t
{
  struct k_vec o = ray->pos->v, d = ray->dir->v;
  const double *const v[3] = { vertex[0], vertex[1], vertex[2] };

  switch (test)
    {
    case POLYGON_EDGES:
      return k_polygon_edges(k_along(o, t, d), newell, count, v);
    case POLYGON_ANGLES:
      return k_polygon_angles(k_along(o, t, d), newell, count, v);
    default:
      return k_polygon_crossings(o, &ray->shear, count, v);
    }
}

- (void) hits: (ray_t *)ray
{
  struct k_vec o = ray->pos->v, d = ray->dir->v;
  double t;

  if (ray->from != self && [self meetsPlane: ray at: &t] && [ray wants: t]
      && [self holds: ray at: t])
    {
      [ray meets: self at: t normal: plane.n
           point: k_plane_point(&plane, o, d, t)];
    }
}

- (BOOL) compile: (compiler_t *)compiler
{
  const double *const v[3] = { vertex[0], vertex[1], vertex[2] };

  k_add_polygon(compiler->scene, [compiler surfaceOf: self], plane, newell,
                count, v, test);
  return YES;
}

+ (void) complete: (NSArray *)instances
            model: (model_t *)model
             diag: (diag_t *)diag
{
  for (polygon_t *polygon in instances)
    {
      polygon->test = model->polygon_test;
      if (polygon->test == POLYGON_EDGES && ![polygon isConvex])
        {
          [diag fault: polygon->place : @"polygon '%@' is not convex: the test"
            @" by edges is for convex polygons only; use --polygon-test"
            @" crossings or angles", [polygon name]];
        }
    }
  [solid_t joinFaces: instances model: model diag: diag];
}

@end
