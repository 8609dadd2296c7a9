// ray_steps.h - the steps of trace: that a ray's subclass may watch: witness_t.
// They are part of ray_t.m.

#import "ray_t.h"

@interface ray_t (Steps)

/** A ray can slip out of a closed object through an edge. Before it goes on,
    the objects it has no way out of are taken off its media. */
- (void) forgetMediaLeft;

/** Whether light from `light` reaches the hit point P: *L is the direction to
    it, *e what arrives, on the side of Ns. */
- (BOOL) sees: (light_t *)light in: (model_t *)model from: (vec_t *)P
             : (struct k_vec)Ns : (struct k_vec *)L : (struct k_vec *)e;

/** The refracted direction at the hit point, straight on for a thin sheet;
    *inside is what the ray is in after it and *R how much is reflected. */
- (vec_t *) refractAt: (vec_t *)Ns inside: (media_t **)inside
          reflectance: (double *)R of: (model_t *)model;

/** Whether the feeler that sees: would send is not worth it, without which
    the colour is off by that much at most. */
- (BOOL) cutsFeeler: (struct k_vec)off;

/** Whether a ray that would be spawned is not worth it; if not, *branch is
    what it is as a branch. */
- (BOOL) cuts: (enum cut_which)which of: (struct cut_pair *)pair
           in: (model_t *)model as: (struct cut *)branch;

@end
