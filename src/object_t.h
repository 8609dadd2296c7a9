// object_t.h - an abstract shape, and the one short protocol every shape
// implements. This is the border between the tracer and the shapes: the
// parser finds the class of the block `torus { … }` under the name torus_t
// when that class adopts the protocol, and nothing else has to be told of it
// (docs/new-object.md). Notes, "bounded planes": "What about other objects?"

#import <Foundation/Foundation.h>
#include "attribute.h"
#include "kernel/k_bounds.h"

@class block_t, diag_t, material_t, model_t, names_t, ray_t;

@protocol object_t <NSObject>

/** The attributes of the shape's block, ended by a NULL name. `material` has
    to be one of them. */
+ (const struct attribute *) attributes;

/** Reads the shape from its block. */
- (id) initWithBlock: (block_t *)block;

/** A box round the shape, or k_unbounded(). Whatever hits: reports lies in
    it. */
- (struct k_bounds) bounds;

/** Tells the ray of every place where its line meets the shape, in any
    order: [ray meets: self at: t normal: N], N being unit and outward. The ray
    itself decides which of them count. */
- (void) hits: (ray_t *)ray;

@end

/** What all shapes share. A shape inherits from this class and adopts the
    protocol. */
@interface object_t : NSObject
{
@public
  material_t *material; // owned by the model
  unsigned number;      // 1, 2, 3 … in the order of declaration
  double slack;         // how far off its surface its hits may be: 2^-30 of
                        // its box's coordinates unless the class knows better
@private
  names_t *names;       // owned by the model: where its name is
  unsigned name_at;
}

- (id) initWithBlock: (block_t *)block;

/** The name that its block has (autoreleased). */
- (NSString *) name;

/** Whether P is inside; on the surface is outside. Asked only of clear
    objects, for rays that start in a medium. The default looks along a fixed
    direction whether the first surface is met from within. */
- (BOOL) contains: (struct k_vec)P;

/** Whether its surface may pass through the box: NO when contains: is the same
    everywhere in it. The default is YES. */
- (BOOL) hasSurfaceIn: (struct k_bounds)box;

/** How far its surface is from P, or less. The default is how far its box
    is. */
- (double) distanceFrom: (struct k_vec)P;

/** Which object a ray is in when it has gone through this surface: self, or
    the solid it is part of; nil for a thin sheet. */
- (id) medium;

/** Called once per class when all blocks of a model are read, with the
    instances in order of declaration: for what can be known only then. The
    default does nothing. Faults go to diag; the model may be changed. */
+ (void) complete: (NSArray *)instances
            model: (model_t *)model
             diag: (diag_t *)diag;

@end
