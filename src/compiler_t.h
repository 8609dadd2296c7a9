// compiler_t.h - what a shape tells when it describes itself to the kernel:
// its numbers, its material, what is behind it.

#import "object_t.h"
#include "kernel/k.h"

@interface compiler_t : NSObject
{
@public
  struct k_scene *scene;        // where shapes add themselves; its own
@protected
  NSMapTable *materials, *media;        // numbers from 1, by object
  material_t *last_material;            // the one asked for last, and its
  unsigned last_number;                 // number, from 0
  NSMutableArray *mediumObjects;        // the media, by number - 1
  NSMutableArray *materialObjects;      // the materials, by number
}

/** With an empty scene. nil: no memory. */
- (id) init;

/** What the kernel has to know of a surface of the object, or of an opaque one
    that is not made. */
- (struct k_surface) surfaceOf: (material_t *)material number: (unsigned)number
                         slack: (double)slack;
- (struct k_surface) surfaceOf: (object_t *)object;

/** The kernel's number for what [object medium] is; 0 for nil. */
- (unsigned) mediumOf: (object_t *)object;

/** What has that number. */
- (object_t *) mediumNumbered: (unsigned)number;

/** An object with the number, the material and the slack of one that is not
    there any more (not autoreleased). */
- (object_t *) newStandInFor: (const struct k_surface *)surface;

@end

/** A shape may describe itself to the kernel once; one that does not is asked
    through its hits: as ever. */
@interface object_t (Compiling)

/** NO if it did not. */
- (BOOL) compile: (compiler_t *)compiler;

/** Describes the object that initWithBlock: would make, with this number, and
    whose material is opaque: it will not be made, since nobody else will ask
    it. NO, as by default, if it has to be. */
+ (BOOL) compileBlock: (block_t *)block number: (unsigned)number
                  for: (compiler_t *)compiler;

/** Called before instances of the class are asked to compile:, or its blocks
    come to compileBlock:, up to so many, to make room for them. The default
    does nothing. */
+ (void) prepare: (NSUInteger)count for: (compiler_t *)compiler;

@end
