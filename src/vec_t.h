// vec_t.h - a vector, point or colour: three doubles that do not change once
// made. Notes, "vector reflect/refract functions". Methods that return a
// vector return a new one that the caller does not own (autoreleased).

#import <Foundation/Foundation.h>
#include "kernel/k_vec.h"

@interface vec_t : NSObject
{
@public
  struct k_vec v;       // the same as a plain value
}

+ (vec_t *) vec: (struct k_vec)value;
- (id) init: (double)x : (double)y : (double)z;
- (id) initWithValue: (struct k_vec)value;

- (double) x;
- (double) y;
- (double) z;
- (struct k_vec) value;

- (vec_t *) add: (vec_t *)b;
- (vec_t *) sub: (vec_t *)b;

/** Channel by channel, for colours. */
- (vec_t *) mul: (vec_t *)b;
- (vec_t *) scale: (double)s;
- (double) dot: (vec_t *)b;
- (vec_t *) cross: (vec_t *)b;

/** Length, at any magnitude. */
- (double) length;

/** The vector of length 1 in this direction; the zero vector stays zero. */
- (vec_t *) unit;

/** The mirrored direction: self - 2 (self.N) N. N is unit; self runs
    towards the surface. */
- (vec_t *) reflect: (vec_t *)N;

/** The refracted direction by Snell's law, for a unit self that runs against
    the unit normal N (self.N < 0), n = n_t / n_i: the notes' [dir refract: N :
    ior] going in and [dir refract: [N scale: -1.0] : 1.0 / ior] going out. At
    total internal reflection it is [self reflect: N]. */
- (vec_t *) refract: (vec_t *)N : (double)n;

@end
