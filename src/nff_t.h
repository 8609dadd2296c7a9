// nff_t.h - reads Haines' Neutral File Format (docs/format.md, "NFF") into
// the same blocks that a model file has. Names are made up: fills f1, f2 …,
// lights l1 …, spheres s1 …, polygons p1 …, solids solid1 … What is called
// an entity here is one letter and its numbers.

#import "reader_t.h"

@interface nff_t : reader_t
{
  struct token letter;          // of the entity that is being read
  struct token fill;            // name of the last f; of length 0: none yet
  double alpha, ior;            // of that
  unsigned fills, lights, spheres, polygons;
  unsigned sphere_kind, polygon_kind;   // of their blocks; 0: not looked up yet
  BOOL lacks_fill;              // this was said, or follows from a fault
  unsigned *plain_lights;       // values that depend on the number of lights
  unsigned plain_light_count, plain_light_capacity;
  struct nff_face *faces;       // the polygons, see nff_solids.h
  unsigned face_count, face_capacity;
}

/** Reads the innermost file of the text to its end. */
- (void) read;

/** After a fault: goes on to the next line that starts with a word. */
- (void) resume;

@end

@interface nff_t (entities)

/** Reads one entity, from behind its letter. NO after a fault. */
- (BOOL) readEntity;

/** Whether it is the letter of an entity. */
- (BOOL) isEntity: (struct token)t;

/** Adds a block that stands for the entity, with a made up name. */
- (struct record *) begin: (unsigned)kind : (const char *)prefix
                         : (unsigned)number;

/** A word as a value, which stands where the letter does. */
- (struct value) valueOf: (struct token)word;

/** Where a value stands. */
- (const char *) at: (const struct value *)value;

@end

/** Gives the last block an attribute, which stands where its first value
    does. */
void nff_give(nff_t *nff, const char *attribute, const struct value *values);

/** The entities that are not shapes. */
@interface nff_t (view)

- (BOOL) readView;

/** Goes past what is in a v. */
- (void) skipView;

- (BOOL) readBackground;
- (BOOL) readLight;

@end

@interface nff_t (shapes)

- (BOOL) readFill;
- (BOOL) readSphere;
- (BOOL) readPolygon: (BOOL)has_normals;

@end
