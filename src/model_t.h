// model_t.h - all that a model file describes: the camera, the lights, the
// materials and the objects; and the search for the object a ray hits first.

#import <Foundation/Foundation.h>
#import "object_t.h"
#import "media_t.h"
#include "cut.h"
#include "eye_ray.h"
#include "shade.h"

@class block_t, camera_t, compiler_t, light_t, diag_t, names_t;

/** How a polygon finds out whether a point is in it. */
enum polygon_test
{
  POLYGON_CROSSINGS,    // watertight; the default
  POLYGON_EDGES,        // the notes' first method; convex polygons only
  POLYGON_ANGLES        // the notes' second method
};

/** Where an object will be. */
struct object_place
{
  unsigned number, index;       // the index in `objects`
};

@interface model_t : NSObject
{
@public
  camera_t *camera;             // never nil once loaded
  NSMutableArray *lights;
  NSMutableDictionary *materials;       // by name
  NSMutableArray *objects;      // as declared: numbers 1, 2, 3 …, but for
                                // those that were passed on
  unsigned object_count;        // passed on or not
  compiler_t *compiler;         // who gets those; nil: all are kept
  names_t *names;               // of the objects
  struct k_vec background;      // colour of a ray that hits nothing
  unsigned max_depth;           // deepest generation of rays; 5
  struct cut_rule cut;          // of rays that are worth little; off
  enum polygon_test polygon_test;
  struct shade_choice choice;   // what of the formulas is wanted; all
@protected
  NSMapTable *replacements;     // see replace:by:; by object, NSNull: none
  NSArray *surfaces;            // what find_closest: asks
  struct surface *table;        // the same for speed, see model_t.m; made
                                // when a ray first asks
  unsigned surface_count;
  struct clear *clear;          // objects a ray can be inside of, see
  unsigned clear_count;         // model_t+media.m
  unsigned clear_at_lens;       // the first ones: those that matter to eye
  struct k_bounds lens;         // rays, which start in this box
  Class last_class;             // see passOn:of:, and its compileBlock:, if its
                                // instances may be passed on
  BOOL (*last_compile)(id, SEL, block_t *, unsigned, compiler_t *);
}

- (void) addLight: (light_t *)light;

/** Adds an object and gives it its number, and its slack unless its class
    has. */
- (void) addObject: (object_t *)object;

/** Keeps the next number, and a place in `objects`, for one that is put there
    later. */
- (struct object_place) keepPlace;
- (void) put: (object_t *)object at: (struct object_place)place;

/** The object of that number; nil if it was passed on. */
- (object_t *) objectNumbered: (unsigned)number;

/** To be called once when everything is added, before anything is traced:
    every class looks at its instances once more (solids are closed, planes
    that coincide become one). Faults go to diag. */
- (void) complete: (diag_t *)diag;

/** For complete: rays ask `whole` in place of `parts` from now on. */
- (void) replace: (NSArray *)parts by: (object_t *)whole;

/** What find_closest: asks: the objects, clear solids in place of their
    polygons. */
- (NSArray *) surfaces;

/** Lets every object in the ray's way tell the ray where it is met; the
    ray's hit is then the closest one. For a shadow feeler only opaque objects
    count, and the first one found is enough. */
- (void) find_closest: (ray_t *)ray;

@end

@interface model_t (Passing)

/** With a compiler: an object whose class tells the kernel all there is to know
    of it, and that nobody else will ask, gets its number and is not made. NO if
    it has to be. */
- (BOOL) passOn: (block_t *)block of: (Class)class;

/** About so many more objects will follow, as the last one. */
- (void) expect: (double)count;

@end

@interface model_t (Media)

/** Looks which objects a ray can start in, once all are complete. */
- (void) findClear;

/** NO when all of these rays start in air. */
- (BOOL) mayStartInside: (const struct eye_ray *)rays : (unsigned)count;

/** The media an eye ray starts in: the clear objects that contain its pos, in
    the order in which it would leave them, the first on top. */
- (media_t *) mediaOf: (ray_t *)ray;

@end
