#import "solid_t.h"
#import "compiler_t.h"
#import "diag_t.h"
#import "material_t.h"
#import "polygon_t.h"
#import "ray_t.h"
#include "shell.h"

// Clipping asks every face of a convex solid; past this many it is no faster
// than asking which face is hit.
#define CLIPPED_FACES 256

@implementation solid_t

- (BOOL) isOfOneKind: (diag_t *)diag
{
  for (polygon_t *face in faces)
    {
      material_t *m = face->material;
      if (m->alpha != material->alpha || m->ior != material->ior)
        {
          [diag fault: face->material_place : @"solid '%@' has faces of alpha"
            @" %.6g and ior %.6g and this one of alpha %.6g and ior %.6g;"
            @" a solid is of one kind", name, material->alpha, material->ior,
                m->alpha, m->ior];
          return NO;
        }
    }
  return YES;
}

/** Checks that the faces close a volume and turns them outwards. */
- (BOOL) close: (diag_t *)diag
{
  unsigned count = [faces count], i = 0;
  struct shell_face *f = calloc(count, sizeof *f);
  struct shell_edge open;

  for (polygon_t *face in faces)
    {
      f[i].n = face->count;
      f[i].vertex = (const double *const *)face->vertex;
      i++;
    }
  int shells = shells_close(f, count, &open);
  for (i = 0; i < count; i++)
    {
      if (shells > 0 && f[i].is_turned)
        {
          [(polygon_t *)[faces objectAtIndex: i] turn];
        }
    }
  free(f);
  if (shells == 0)
    {
      polygon_t *face = [faces objectAtIndex: open.face];
      NSString *how = open.faces == 1 ? @"belongs to no other face"
        : open.faces == 2 ? @"has its two faces the wrong way round"
        : [NSString stringWithFormat: @"is in %u faces", open.faces];
      [diag fault: face->solid_place : @"solid '%@' is not closed: the edge"
        @" from (%.6g %.6g %.6g) to (%.6g %.6g %.6g) of polygon '%@' %@",
            name, open.a.x, open.a.y, open.a.z, open.b.x, open.b.y, open.b.z,
            face->name, how];
    }
  return shells > 0;
}

/** Whether every vertex lies behind every face or, as near as can be told, on
    it, and no two faces lie in one plane: then the planes alone say which face
    a ray meets. */
- (BOOL) isGivenByPlanes
{
  for (polygon_t *face in faces)
    {
      for (polygon_t *other in faces)
        {
          BOOL lies_in_it = other != face;
          for (unsigned i = 0; i < other->count; i++)
            {
              struct k_vec v = k_sub([other vertexAt: i], face->plane.q);
              double ahead = k_dot(face->plane.n, v);
              if (ahead > 4 * slack)
                {
                  return NO;
                }
              lies_in_it &= ahead >= -4 * slack;
            }
          if (lies_in_it)
            {
              return NO;
            }
        }
    }
  return YES;
}

/** nil, and a fault in diag, if the faces do not make a solid. */
- (id) initWithFaces: (NSArray *)polygons diag: (diag_t *)diag
{
  if ((self = [super init]))
    {
      polygon_t *first = [polygons objectAtIndex: 0];

      name = [first->solid_name copy];
      faces = [polygons retain];
      material = first->material;
      number = first->number;
      box = k_nothing();
      for (polygon_t *face in faces)
        {
          struct k_bounds b = [face bounds];
          box = k_bounds_include(k_bounds_include(box, b.least), b.most);
          slack = k_max2(slack, face->slack);
        }
      if (![self isOfOneKind: diag] || ![self close: diag])
        {
          [self release];
          return nil;
        }
      is_convex = [faces count] <= CLIPPED_FACES && [self isGivenByPlanes];
      for (polygon_t *face in faces)
        {
          if (material->alpha > 0)
            {
              face->solid = self;
              face->slack = slack;
            }
        }
    }
  return self;
}

- (void) dealloc
{
  [faces release];
  [super dealloc];
}

- (struct k_bounds) bounds
{
  return box;
}

- (BOOL) isFace: (object_t *)object
{
  return [object medium] == self;
}

/** Inside, strictly. For a solid that is not convex: how often a line in a
    fixed direction crosses the faces. */
- (BOOL) contains: (struct k_vec)P
{
  BOOL is_inside = is_convex, is_on_face = NO;
  vec_t *pos = [[vec_t alloc] initWithValue: P];
  vec_t *dir = [[vec_t alloc] initWithValue: k_unit(k_vec(5, 3, 2))];
  ray_t *ray = [[ray_t alloc] init: pos : dir];

  for (polygon_t *face in faces)
    {
      double t;
      if (is_convex)
        {
          is_inside &= k_dot(face->plane.n, k_sub(P, face->plane.q)) < 0;
        }
      else if (k_plane_hit(&face->plane, P, dir->v, &t) && t >= 0
               && [face holds: ray at: t])
        {
          is_inside = !is_inside;
          is_on_face |= t == 0;
        }
    }
  [ray release];
  [dir release];
  [pos release];
  return is_inside && !is_on_face;
}

/** A convex solid: the ray is in front of some faces until the last of them
    and behind the others from the first of those. No face is asked for its
    outline, so no ray slips through between two of them. */
- (void) clip: (ray_t *)ray isInside: (BOOL)is_inside
{
  struct k_vec o = ray->pos->v, d = ray->dir->v;
  polygon_t *in = nil, *out = nil;
  double t_in = -HUGE_VAL, t_out = HUGE_VAL, t;

  for (polygon_t *face in faces)
    {
      double n_dot_d = k_dot(face->plane.n, d);
      double ahead = k_dot(face->plane.n, k_sub(face->plane.q, o));
      if (n_dot_d == 0)
        {
          if (ahead < 0 && !is_inside)
            {
              return;
            }
          continue;
        }
      t = ahead / n_dot_d;
      if (n_dot_d < 0 && t > t_in)
        {
          t_in = t;
          in = face;
        }
      else if (n_dot_d > 0 && t < t_out && ray->from != face)
        {
          t_out = t;
          out = face;
        }
    }
  if (is_inside && out)
    {
      t = t_out > 0 ? t_out : 0;
      [ray exits: out at: t normal: out->plane.n
           point: k_plane_point(&out->plane, o, d, t)];
    }
  else if (!is_inside && in && out && t_in <= t_out
           && ![ray meets: in at: t_in normal: in->plane.n
                    point: k_plane_point(&in->plane, o, d, t_in)])
    {
      // It starts on the surface and runs in: only the way out is ahead.
      [ray meets: out at: t_out normal: out->plane.n
           point: k_plane_point(&out->plane, o, d, t_out)];
    }
}

/** Any solid: a ray that comes from a surface meets, outside, only faces that
    it goes in through, and inside only those it goes out through; those at
    t = 0, round the edge it stands on, too. */
- (void) search: (ray_t *)ray isInside: (BOOL)is_inside
{
  struct k_vec o = ray->pos->v, d = ray->dir->v;

  for (polygon_t *face in faces)
    {
      double t;
      if (ray->from == face
          || ((ray->from || is_inside)
              && (k_dot(face->plane.n, d) > 0) != is_inside)
          || ![face meetsPlane: ray at: &t])
        {
          continue;
        }
      double tolerance = ray->slack + slack;
      double off = fabs(k_dot(face->plane.n, k_sub(face->plane.q, o)));
      BOOL stands_on_it = is_inside && ray->from && off <= tolerance
        && fabs(t) <= 16 * tolerance;
      if (stands_on_it && [face holds: ray at: t])
        {
          [ray exits: face at: t > 0 ? t : 0 normal: face->plane.n point: o];
        }
      else if (!stands_on_it && [ray wants: t] && [face holds: ray at: t])
        {
          [ray meets: face at: t normal: face->plane.n
               point: k_plane_point(&face->plane, o, d, t)];
        }
    }
}

- (void) hits: (ray_t *)ray
{
  BOOL is_inside = [media_t media: ray->media has: self];

  if (is_convex)
    {
      // From a face of a convex solid outwards there is no way back to it.
      BOOL starts_outside = ray->from && [self isFace: ray->from]
        && !ray->starts_inside;
      if (is_inside || !starts_outside)
        {
          [self clip: ray isInside: is_inside];
        }
    }
  else
    {
      [self search: ray isInside: is_inside];
    }
}

- (BOOL) compile: (compiler_t *)compiler
{
  NSUInteger count = [faces count], i = 0;

  if (!is_convex)
    {
      for (polygon_t *face in faces)
        {
          [face compile: compiler];
        }
      return YES;
    }
  struct k_surface surfaces[count];
  struct k_plane planes[count];
  for (polygon_t *face in faces)
    {
      surfaces[i] = [compiler surfaceOf: face];
      planes[i++] = face->plane;
    }
  k_add_convex(compiler->scene, count, surfaces, planes, box,
               [compiler mediumOf: self]);
  return YES;
}

+ (void) joinFaces: (NSArray *)polygons
             model: (model_t *)model
              diag: (diag_t *)diag
{
  NSMutableDictionary *by_name = [NSMutableDictionary dictionary];
  NSMutableArray *names = [NSMutableArray array];

  for (polygon_t *polygon in polygons)
    {
      if (polygon->solid_name == nil)
        {
          continue;
        }
      NSMutableArray *group = [by_name objectForKey: polygon->solid_name];
      if (group == nil)
        {
          group = [NSMutableArray array];
          [by_name setObject: group forKey: polygon->solid_name];
          [names addObject: polygon->solid_name];
        }
      [group addObject: polygon];
    }
  for (NSString *each in names)
    {
      NSArray *group = [by_name objectForKey: each];
      solid_t *solid = [[solid_t alloc] initWithFaces: group diag: diag];
      if (solid)
        {
          if (solid->material->alpha > 0)
            {
              [model replace: group by: solid];
            }
          [solid release];
        }
    }
}

@end
