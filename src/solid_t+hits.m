// What a ray meets of a clear solid, and whether a point is inside of it.

#import "solid_t.h"
#import "polygon_t.h"
#import "ray_t.h"

@implementation solid_t (Hits)

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

- (BOOL) hasSurfaceIn: (struct k_bounds)place
{
  for (polygon_t *face in faces)
    {
      struct k_bounds b = [face bounds];
      if (k_bounds_overlap(&b, &place))
        {
          return YES;
        }
    }
  return NO;
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

/** Any solid: a ray that is inside, or comes from a face and so is known to be
    inside or outside, meets only faces that it goes out through, or in. Inside
    it meets those at t = 0, round the edge it stands on, too. */
- (void) search: (ray_t *)ray isInside: (BOOL)is_inside
{
  struct k_vec o = ray->pos->v, d = ray->dir->v;
  BOOL comes_from_it = ray->from && [self isFace: ray->from];
  BOOL goes_out = is_inside || (comes_from_it && ray->starts_inside);

  for (polygon_t *face in faces)
    {
      double t;
      if (ray->from == face
          || ((is_inside || comes_from_it)
              && (k_dot(face->plane.n, d) > 0) != goes_out)
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

@end
