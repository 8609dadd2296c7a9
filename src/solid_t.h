// solid_t.h - a volume closed by polygons, those that name it. For opaque
// solids nothing more is needed than that the polygons' normals point out of
// it; a clear one is one object for the rays that pass through it, so that
// none can get lost between its faces. Notes, "bounded planes": "for more
// solid objects, could use two grids".
//
// Not a block of its own: polygon_t makes solids when a model is complete.

#import "object_t.h"

@class polygon_t;
struct shell_face;

@interface solid_t : object_t
{
@public
  NSArray *faces;       // polygon_t, in order of declaration
  BOOL is_convex;       // and of few faces: slab clipping
@protected
  NSString *name;
  struct k_bounds box;
}

/** The polygons as shells_close takes them; to be freed. They own the
    vertices. */
+ (struct shell_face *) newShellFaces: (NSArray *)polygons;

/** Joins the polygons that name a solid: checks that they close a volume and
    are of one alpha and ior, turns them outwards, and puts a clear solid in
    their place in the model. Faults go to diag. */
+ (void) joinFaces: (NSArray *)polygons
             model: (model_t *)model
              diag: (diag_t *)diag;

@end
