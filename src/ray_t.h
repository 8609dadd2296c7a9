// ray_t.h - a ray that traces itself. Notes, "ray objectification":
//
//   ray_t *ray = [(ray_t *) [ray_t alloc] init: pos : dir];
//   color = [ray trace: model];
//   [ray release];
//
// trace: spawns the ray's own reflection and refraction rays and shadow
// feelers, traces them and releases them. A ray is used once.

#import <Foundation/Foundation.h>
#import "vec_t.h"
#import "media_t.h"
#include "counters.h"
#include "cut.h"
#include "kernel/k_shear.h"

@class light_t, model_t, object_t;

/** Where a ray meets an object. */
struct hit
{
  double t;             // distance along the ray
  object_t *object;     // nil: nothing was hit
  struct k_vec P;       // the point
  struct k_vec N;       // the object's outward unit normal there
  BOOL is_compensated;  // a sphere, from so near that t had to be computed
                        // with more digits
};

@interface ray_t : NSObject
{
@public
  double dis;           // length of the whole path from the eye to pos;
                        // after trace: to the point that was hit
  vec_t *pos;           // where it starts
  vec_t *dir;           // where it goes; unit
  media_t *media;       // what it is in: the notes' inside flag
  unsigned depth;       // 0 for an eye ray, one more for each generation

  object_t *from;       // the object whose surface it starts on, or nil
  BOOL starts_inside;   // on the inner side of that surface
  double slack;         // how far off that surface pos may be by rounding
  BOOL is_feeler;       // looks for anything opaque before `end` only
  double end;           // feelers: the distance of the light
  double end_slack;     // feelers: how far off the light may seem

  struct cut cut;       // its weight, and what is cut of its branches, if the
                        // model asks for that
  struct hit hit;       // the nearest hit so far; t infinite, object nil first
  double tie;           // the last t where two objects were met
  struct k_vec inverse; // 1 / dir, per component
  struct k_shear shear; // for polygons
  struct counters *counters;    // of the thread, or the ray's own
  struct counters own_counters;
}

/** An eye ray from pos along the unit vector dir, in air. */
- (id) init: (vec_t *)pos : (vec_t *)dir;

/** A ray that starts where `parent` has hit something: reflected (on the same
    side) when `through` is NO, refracted (on the other side) when it is YES.
    It takes over the parent's dis, media and counters. */
- (id) init: (vec_t *)pos : (vec_t *)dir
       from: (ray_t *)parent through: (BOOL)through;

/** A shadow feeler from where `parent` has hit something along the unit
    vector dir to the light at the distance r. */
- (id) initFeeler: (vec_t *)pos : (vec_t *)dir : (double)r
             from: (ray_t *)parent to: (light_t *)light;

/** The colour that comes back along the ray (autoreleased): section 4 of
    docs/formulas.md. Nothing is clamped. */
- (vec_t *) trace: (model_t *)model;

/** What an object says in hits: its surface is met at the distance t (any
    sign, any order) where its outward unit normal is N. The ray keeps the hit
    if it is in front, is not the surface it starts on and is the nearest so
    far; equal t: the object declared first. YES if it was kept. */
- (BOOL) meets: (object_t *)object at: (double)t normal: (struct k_vec)N;

/** The same for an object that knows the point better than pos + t dir. */
- (BOOL) meets: (object_t *)object at: (double)t normal: (struct k_vec)N
         point: (struct k_vec)P;

/** The same for the far side of a closed surface, or of a solid, that the ray
    is in: it counts at t = 0 too, so that no ray is caught in a corner. */
- (BOOL) exits: (object_t *)object at: (double)t normal: (struct k_vec)N
         point: (struct k_vec)P;

/** Whether a hit at t could still count: worth computing a normal for. */
- (BOOL) wants: (double)t;

/** Whether the ray, going on, would come out of the object: is there a
    surface of it ahead that is met from within? *t is its distance. */
- (BOOL) leaves: (object_t *)object at: (double *)t;

@end
