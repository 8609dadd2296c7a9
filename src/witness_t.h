// witness_t.h - a ray that remembers how it was traced, with all that it
// spawned: what --explain tells. It is traced by the methods of ray_t, which it
// watches; it computes nothing of its own.

#import "ray_steps.h"

@class witness_t;

/** What one light did at the hit point. */
struct seen_light
{
  BOOL is_lit;
  struct k_vec L;       // direction to it
  struct k_vec e;       // lit: what arrives, with the falloff in it
  double r;             // lit: its distance
  BOOL is_cut;          // lit, but not known to be: the feeler was not worth it
  double loss;          // then how far off the pixel may be for that
  object_t *blocker;    // the object that hides it; nil: none, or the point
                        // has its back to the light or is in it
};

/** What became of the reflected or the refracted ray. */
struct seen_branch
{
  BOOL is_left_out;     // not wanted: --no-reflection, --no-refraction
  BOOL is_cut;          // not worth it: --min-weight, --max-error
  double loss;          // then the most that it could have brought
  witness_t *ray;       // nil: not traced
};

@interface witness_t : ray_t
{
@public
  struct k_vec color;           // what came back along it
  media_t *start;               // what it was in when it started
  struct seen_light *lights;    // as many as the model has; NULL: none seen
  struct seen_branch branches[2];       // by enum cut_which
  double R;                     // how much is reflected, of a clear object
  BOOL is_through;              // refracted
  BOOL is_critical, is_unbalanced;      // near the edge: counters.h
@private
  witness_t *parent;            // not retained: it is traced while it is asked
  ray_t *feeler;                // the last one
  BOOL is_feeler_cut;           // or it was not sent
  double feeler_loss;
  unsigned light_count;
}
@end
