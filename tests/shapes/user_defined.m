// user_defined.m - an object class of one's own just works: `torus { … }`
// finds the class torus_t, which only this test knows. Notes, "bounded
// planes": "What about other objects?"

#import "support.h"
#import "block_t.h"
#import "registry_t.h"
#include "test.h"

/** A torus round the z axis:
    `torus name { material … ring … tube … }`. */
@interface torus_t : object_t <object_t>
{
@public
  double ring, tube;
}
@end

@implementation torus_t

+ (const struct attribute *) attributes
{
  static const struct attribute table[] = {
    { .name = "material", .kind = ATTRIBUTE_MATERIAL, .is_required = 1 },
    { .name = "ring", .kind = ATTRIBUTE_NUMBER, .is_required = 1,
      .range = RANGE_POSITIVE },
    { .name = "tube", .kind = ATTRIBUTE_NUMBER, .range = RANGE_POSITIVE },
    { .name = NULL }
  };
  return table;
}

- (id) initWithBlock: (block_t *)block
{
  if ((self = [super initWithBlock: block]))
    {
      ring = [block number: "ring" at: 0];
      tube = [block number: "tube" or: 0.5];
      if (tube >= ring)
        {
          [block fault: [block placeOfValue: "ring" at: 0]
                      : @"torus '%@' has no hole", [self name]];
        }
    }
  return self;
}

- (struct k_bounds) bounds
{
  double r = ring + tube;
  struct k_bounds box = { { -r, -r, -tube }, { r, r, tube } };

  return k_bounds_pad(box);
}

/** Negative inside. */
- (double) sideOf: (struct k_vec)p
{
  double across = sqrt(p.x * p.x + p.y * p.y) - ring;

  return across * across + p.z * p.z - tube * tube;
}

/** Steps along the ray, and halves each step in which the sign changes. */
- (void) hits: (ray_t *)ray
{
  struct k_vec o = ray->pos->v, d = ray->dir->v;
  double b = -k_dot(o, d), r = ring + tube, step = tube / 64;
  double before = [self sideOf: k_along(o, b - 1.01 * r, d)];

  for (double t = b - 1.01 * r; t < b + 1.01 * r; t += step)
    {
      double after = [self sideOf: k_along(o, t + step, d)];
      if ((before < 0) != (after < 0))
        {
          double least = t, most = t + step;
          for (int i = 0; i < 60; i++)
            {
              double middle = (least + most) / 2;
              double side = [self sideOf: k_along(o, middle, d)];
              *((side < 0) == (before < 0) ? &least : &most) = middle;
            }
          struct k_vec p = k_along(o, least, d);
          double across = sqrt(p.x * p.x + p.y * p.y);
          struct k_vec on_ring = k_scale(k_vec(p.x, p.y, 0), ring / across);
          [ray meets: self at: least normal: k_unit(k_sub(p, on_ring))];
        }
      before = after;
    }
}

@end

/** Looks like a shape but does not say it is one. */
@interface blob_t : object_t
@end

@implementation blob_t
@end

/** A class that is none of ours and has all but the name. */
@interface gadget : object_t
@end

@implementation gadget
@end

/** A shape made from another one, without a word of its own. */
@interface marble_t : sphere_t
@end

@implementation marble_t
@end

static const char world[] = SUPPORT_CAMERA
  "material m { ambient 1 1 1 diffuse 1 1 1 }\n"
  "material glass { alpha 1 ior 1.5 }\nmaterial air { alpha 1 }\n";

static void
words(void)
{
  const char *none[] = { "ray", "vec", "object", "solid", "flat", "camera",
    "camera2", "light", "material", "model", "media", "parser", "block",
    "diag", "image", "render", "registry", "blob", "gadget", "", "NSObject",
    "Sphere", "sphere_t", "torus " };
  const char *shapes[] = { "sphere", "plane", "polygon", "torus", "marble" };

  for (unsigned i = 0; i < sizeof none / sizeof *none; i++)
    {
      NSString *word = [NSString stringWithUTF8String: none[i]];
      PASS([registry_t shapeForWord: word] == Nil, "'%s' is no shape",
           none[i]);
    }
  for (unsigned i = 0; i < sizeof shapes / sizeof *shapes; i++)
    {
      NSString *word = [NSString stringWithUTF8String: shapes[i]];
      PASS([registry_t shapeForWord: word] != Nil, "'%s' is one", shapes[i]);
    }
  NSArray *all = [registry_t words];
  PASS([all containsObject: @"torus"] && [all containsObject: @"sphere"]
       && ![all containsObject: @"ray"] && ![all containsObject: @"flat"],
       "words has the shapes only");
  for (unsigned i = 0; i < 7; i++)
    {
      NSString *text = [NSString stringWithFormat:
        @"%s%s x { material m }\n", world, none[i]];
      PASS(support_faults([text UTF8String]) != nil, "a block '%s' is a"
           " fault", none[i]);
    }
}

static void
attributes(void)
{
  model_t *model = support_model
    ("%s torus t { ring 2 material m }\n", world);
  torus_t *t = (torus_t *)support_object(model, "t");

  PASS([t isKindOfClass: [torus_t class]], "the block makes a torus_t");
  PASS(t->ring == 2 && t->tube == 0.5, "with its attributes and defaults");
  PASS(t->number == 1 && [[t name] isEqual: @"t"] && t->material
       == [model->materials objectForKey: @"m"], "its name, number and"
       " material");
  PASS(t->slack > 0 && t->slack < 1e-8, "and some slack: %g", t->slack);
  NSString *report = support_faults
    ([[NSString stringWithFormat: @"%s torus t { ring .25 material m }",
                world] UTF8String]);
  PASS([report rangeOfString: @"torus 't' has no hole"].length > 0,
       "a fault that only the class can see is told");
  PASS(support_faults([[NSString stringWithFormat:
    @"%s torus t { ring 2 ring 3 material m }", world] UTF8String]) != nil
    && support_faults([[NSString stringWithFormat:
    @"%s torus t { material m }", world] UTF8String]) != nil
    && support_faults([[NSString stringWithFormat:
    @"%s torus t { ring -1 material m }", world] UTF8String]) != nil
    && support_faults([[NSString stringWithFormat:
    @"%s torus t { ring 2 material m radius 2 }", world] UTF8String]) != nil,
    "and so are those that its table is enough for");
  model = support_model
    ("%s marble b { material m center 0 0 0 radius 1 }", world);
  PASS(support_hit(model, k_vec(0, 0, 5), k_vec(0, 0, -1)).t == 4,
       "a class that inherits from a shape is one");
}

static void
rays(void)
{
  model_t *model = support_model("%s torus t { ring 2 material m }\n", world);
  struct hit hit = support_hit(model, k_vec(-5, 0, 0), k_vec(1, 0, 0));

  PASS_NEAR(hit.t, 2.5, 1e-12, "the near wall");
  PASS(k_length(k_sub(hit.N, k_vec(-1, 0, 0))) < 1e-9, "its normal");
  PASS_NEAR(support_hit(model, k_vec(0, 0, 0), k_vec(0, 1, 0)).t, 1.5, 1e-12,
            "from the hole to the ring");
  PASS_NEAR(support_hit(model, k_vec(0, 2, 0), k_vec(0, 1, 0)).t, 0.5, 1e-12,
            "from inside of it");
  PASS(support_number(model, k_vec(0, 0, 5), k_vec(0, 0, -1)) == 0,
       "through the hole");
  // Its shadow on a floor, and light through its hole.
  model = support_model
    ("%s light l { location 0 0 4 emissivity 1 1 1 falloff 0 }\n"
     "material f { diffuse 1 1 1 }\n"
     "plane floor { material f normal 0 0 1 point 0 0 -4 }\n"
     "torus t { ring 2 material m }\n", world);
  PASS(support_trace(model, k_vec(0.1, 0, -3), k_vec(0, 0, -1)).x > 0.9,
       "light through the hole");
  PASS(support_trace(model, k_vec(4, 0, -3), k_vec(0, 0, -1)).x == 0,
       "its shadow");
}

/** A torus of glass: the line through all of it crosses four walls; of index
    1 it changes no direction. */
static void
glass(void)
{
  model_t *model = support_model
    ("%s torus t { ring 2 material glass }\n"
     "plane w { material m normal -1 0 0 point 5 0 0 }\n", world);
  model->max_depth = 4;
  struct k_vec c = support_trace(model, k_vec(-5, 0, 0), k_vec(1, 0, 0));
  PASS_NEAR(c.x, pow(0.96, 4) / 10 * 1, 1e-10, "through four walls of glass:"
            " (1-R)^4");
  model->max_depth = 2;
  c = support_trace(model, k_vec(-2, 0, 0), k_vec(1, 0, 0));
  PASS(c.x == 0, "an eye in the glass meets three: too many for depth 2");
  model->max_depth = 3;
  c = support_trace(model, k_vec(-2, 0, 0), k_vec(1, 0, 0));
  PASS_NEAR(c.x, pow(0.96, 3) / 7, 1e-10, "an eye in the glass meets three");

  model = support_model
    ("background 1 2 4 %s torus t { ring 2 material air }\n", world);
  unsigned wrong = 0;
  for (unsigned i = 0; i < 150; i++)
    {
      struct support_random random = support_seed(i);
      struct k_vec o = support_point(&random, 3);
      struct k_vec to = support_point(&random, 3);
      struct k_vec color = support_trace(model, o, k_sub(to, o));
      wrong += !support_same(color, k_vec(1, 2, 4));
    }
  PASS(wrong == 0, "a torus of nothing is not seen, from wherever: %u", wrong);
}

int
main(void)
{
  NSAutoreleasePool *pool = [[NSAutoreleasePool alloc] init];

  words();
  attributes();
  rays();
  glass();
  [pool release];
  return test_done();
}
