// polygon_t.h - a bounded plane: `polygon name { material … vertex … }`, any
// number of vertices, convex or not, and the point-in-polygon test. Notes,
// "bounded planes". With `solid name` it is a face of that solid (solid_t.h),
// otherwise an infinitesimally thin surface.

#import "flat_t.h"
#import "model_t.h"
#include "place.h"

@class solid_t;

@interface polygon_t : flat_t <object_t>
{
@public
  unsigned count;       // of vertices, repeated ones dropped
  double *vertex[3];    // their x, y, z
  struct k_vec newell;  // unit, right-handed round the vertices; plane.n is
                        // the outward side of it
  enum polygon_test test;
  solid_t *solid;       // the clear solid it is a face of, or nil;
                        // not retained: the model's
  NSString *solid_name; // nil: none
  struct place place, material_place, solid_place;      // for messages
@protected
  struct k_bounds box;
  double grazing;       // k_polygon_grazing
}

/** Whether the ray's line meets the plane, and the distance *t, of any sign,
    at which it does. */
- (BOOL) meetsPlane: (ray_t *)ray at: (double *)t;

/** Whether the ray's line passes through the polygon where it meets the
    plane, at the distance t. */
- (BOOL) holds: (ray_t *)ray at: (double)t;

/** Whether no corner is turned inwards. */
- (BOOL) isConvex;

- (struct k_vec) vertexAt: (unsigned)i;

/** Turns the face over: the other side becomes the outside. */
- (void) turn;

@end
