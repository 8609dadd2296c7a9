#import "nff_t.h"
#import "diag_t.h"
#include "attribute_check.h"
#include "grow.h"
#include "nff_solids.h"
#include "number.h"

@implementation nff_t (shapes)

/** Multiplies a colour. NO, with a fault, if that gets too large. */
- (BOOL) scale: (struct value *)rgb by: (const struct value *)k
{
  for (unsigned channel = 0; channel < 3; channel++)
    {
      double *c = &rgb[channel].number;

      *c *= k->number;
      if (number_range(*c) == NUMBER_TOO_LARGE)
        {
          FAULT([self at: k],
                @"expected less: this times the colour is beyond 2^400");
          return NO;
        }
      *c = number_range(*c) == NUMBER_GOOD ? *c : 0;
    }
  return YES;
}

- (BOOL) readFill
{
  static const struct attribute table[] = {
    { .name = "the colour", .kind = ATTRIBUTE_COLOR },
    { .name = "Kd", .range = RANGE_NOT_NEGATIVE },
    { .name = "Ks", .range = RANGE_NOT_NEGATIVE },
    { .name = "shine", .range = RANGE_NOT_NEGATIVE },
    { .name = "T", .range = RANGE_BETWEEN, .least = 0, .most = 1 },
    { .name = "the index of refraction", .range = RANGE_NOT_NEGATIVE },
    { .name = NULL }
  };
  struct value values[6][3], specular[3];
  struct value *Kd = values[1], *Ks = values[2], *T = values[4];
  struct value *index = values[5];
  BOOL is_good = YES;

  for (const struct attribute *a = table; a->name && is_good; a++)
    {
      is_good = [self read: a into: values[a - table]];
    }
  fill = [self begin: KIND_MATERIAL : "f" : ++fills]->name;
  if (!is_good)
    {
      return NO;
    }
  if (index->number == 0 && T->number == 0)
    {
      index->number = 1;        // many files give an opaque fill no index
    }
  if (index->number == 0)
    {
      FAULT([self at: index], @"expected a number > 0 for the index of"
            @" refraction%@, found 0", [self owner]);
      return NO;
    }
  alpha = T->number;
  ior = index->number;
  memcpy(specular, values[0], sizeof specular);
  if (![self scale: values[0] by: Kd] || ![self scale: specular by: Ks])
    {
      return NO;
    }
  nff_give(self, "diffuse", values[0]);
  nff_give(self, "specular", specular);
  nff_give(self, "shininess", values[3]);
  nff_give(self, "alpha", T);
  nff_give(self, "ior", index);
  return YES;
}

/** Whether there is a fill for a shape; a fault if not, but once only. */
- (BOOL) hasFill
{
  if (fill.length == 0 && !lacks_fill)
    {
      lacks_fill = YES;
      FAULT(letter.at, @"expected an f before the first s, p or pp");
    }
  return fill.length > 0;
}

/** Adds the block of a shape and its material. */
- (struct record *) beginShape: (unsigned)kind : (const char *)prefix
                              : (unsigned)number
{
  struct record *record = [self begin: kind : prefix : number];
  struct value material = [self valueOf: fill];

  nff_give(self, "material", &material);
  return record;
}

- (BOOL) readSphere
{
  static const struct attribute center =
    { .name = "the center", .kind = ATTRIBUTE_POINT };
  static const struct attribute radius =
    { .name = "the radius", .range = RANGE_POSITIVE };
  struct value xyz[3], r;
  BOOL has_fill = [self hasFill];

  spheres++;
  if (![self read: &center into: xyz] || ![self read: &radius into: &r])
    {
      return NO;
    }
  if (has_fill)
    {
      sphere_kind = sphere_kind ? sphere_kind
        : [store kindFor: (struct token){ "sphere", 6 }];
      [self beginShape: sphere_kind : "s" : spheres];
      nff_give(self, "center", xyz);
      nff_give(self, "radius", &r);
      [store end];
    }
  return YES;
}

- (BOOL) readPolygon: (BOOL)has_normals
{
  static const struct attribute corners =
    { .name = "the number of vertices", .kind = ATTRIBUTE_WHOLE,
      .range = RANGE_BETWEEN, .least = 3, .most = 1000000000 };
  static const struct attribute vertex =
    { .name = "a vertex", .kind = ATTRIBUTE_POINT };
  static const struct attribute normal =
    { .name = "a normal", .kind = ATTRIBUTE_POINT };
  struct value n, solid, xyz[3], dropped[3];
  BOOL has_fill = [self hasFill];

  polygons++;
  if (![self read: &corners into: &n])
    {
      return NO;
    }

  if (!has_fill)
    {
      return NO;
    }

  polygon_kind = polygon_kind ? polygon_kind
    : [store kindFor: (struct token){ "polygon", 7 }];

  struct record *record = [self beginShape: polygon_kind : "p" : polygons];
  struct nff_face face = {
    .record = store->record_count - 1, .fill = fills, .alpha = alpha,
    .ior = ior, .count = (unsigned)n.number
  };

  solid = [self valueOf: letter];
  nff_give(self, "solid", &solid);
  face.vertex = store->value_count;
  for (unsigned i = 0; i < face.count; i++)
    {
      if (![self read: &vertex into: xyz]
          || (has_normals && ![self read: &normal into: dropped]))
        {
          record->is_faulty = YES;
          return NO;
        }
      nff_give(self, "vertex", xyz);
    }
  grow((void **)&faces, face_count, &face_capacity, sizeof face);
  faces[face_count++] = face;
  return YES;
}

@end
