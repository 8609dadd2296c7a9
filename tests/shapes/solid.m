// solid.m - polygons that close a volume: turned outwards, cavities, faults,
// and one object for rays that pass through. Notes, "bounded planes": "for
// more solid objects".

#import "support.h"
#include "test.h"

#define WORLD SUPPORT_CAMERA "material m { }\n" \
  "material glass { alpha 1 ior 1.5 }\nmaterial water { alpha 1 ior 1.25 }\n" \
  "material tinted { ambient 1 0 0 alpha 1 ior 1.5 }\n"

// Corners of an L-shaped prism, z from 0 to 1, and its faces.
static const char l_prism[] =
  "polygon l0 { material %1$s solid l vertex 0 0 0 vertex 2 0 0 vertex 2 1 0"
  " vertex 1 1 0 vertex 1 2 0 vertex 0 2 0 }\n"
  "polygon l1 { material %1$s solid l vertex 0 0 1 vertex 2 0 1 vertex 2 1 1"
  " vertex 1 1 1 vertex 1 2 1 vertex 0 2 1 }\n"
  "polygon l2 { material %1$s solid l vertex 0 0 0 vertex 2 0 0 vertex 2 0 1"
  " vertex 0 0 1 }\n"
  "polygon l3 { material %1$s solid l vertex 2 0 0 vertex 2 1 0 vertex 2 1 1"
  " vertex 2 0 1 }\n"
  "polygon l4 { material %1$s solid l vertex 2 1 0 vertex 1 1 0 vertex 1 1 1"
  " vertex 2 1 1 }\n"
  "polygon l5 { material %1$s solid l vertex 1 1 0 vertex 1 2 0 vertex 1 2 1"
  " vertex 1 1 1 }\n"
  "polygon l6 { material %1$s solid l vertex 1 2 0 vertex 0 2 0 vertex 0 2 1"
  " vertex 1 2 1 }\n"
  "polygon l7 { material %1$s solid l vertex 0 2 0 vertex 0 0 0 vertex 0 0 1"
  " vertex 0 2 1 }\n";

static int
in_l(struct k_vec p)
{
  return p.x > 0 && p.y > 0 && p.z > 0 && p.z < 1 && p.x < 2 && p.y < 2
    && (p.x < 1 || p.y < 1);
}

static int
in_cube(struct k_vec p, double half)
{
  return k_norm_max(p) < half;
}

static void
normals(void)
{
  model_t *model = support_model
    (WORLD "%s", support_box("c", "c", "m", k_vec(-1, -1, -1),
                             k_vec(1, 1, 1)));
  const struct k_vec axes[6] = { { 1, 0, 0 }, { -1, 0, 0 }, { 0, 1, 0 },
                                 { 0, -1, 0 }, { 0, 0, 1 }, { 0, 0, -1 } };

  for (int i = 0; i < 6; i++)
    {
      struct hit hit = support_hit(model, k_scale(axes[i], 5),
                                   k_neg(axes[i]));
      PASS(hit.t == 4 && k_dot(hit.N, axes[i]) == 1, "face %d of a cube is"
           " turned outwards, whichever way it was wound", i);
    }
  struct hit hit = support_hit(model, k_vec(0, 0, 0), k_vec(0, 0, 1));
  PASS(hit.t == 1 && hit.N.z == 1, "seen from inside its normal is outward"
       " too");
  PASS([hit.object medium] == nil, "the faces of an opaque solid are no"
       " medium");

  // A cavity's normals point into it.
  model = support_model
    (WORLD "%s%s", support_box("a", "c", "m", k_vec(-2, -2, -2),
                               k_vec(2, 2, 2)),
     support_box("b", "c", "m", k_vec(-1, -1, -1), k_vec(1, 1, 1)));
  hit = support_hit(model, k_vec(0, 0, 0), k_vec(0, 1, 0));
  PASS(hit.t == 1 && hit.N.y == -1, "the wall of a cavity faces into it");
  hit = support_hit(model, k_vec(0, 9, 0), k_vec(0, -1, 0));
  PASS(hit.t == 7 && hit.N.y == 1, "the outer shell faces out");
  // A grain in the cavity faces out again; beside it stands another cube.
  model = support_model
    (WORLD "%s%s%s%s",
     support_box("g", "c", "m", k_vec(-.5, -.5, -.5), k_vec(.5, .5, .5)),
     support_box("b", "c", "m", k_vec(-1, -1, -1), k_vec(1, 1, 1)),
     support_box("a", "c", "m", k_vec(-2, -2, -2), k_vec(2, 2, 2)),
     support_box("d", "c", "m", k_vec(3, -1, -1), k_vec(4, 1, 1)));
  hit = support_hit(model, k_vec(0, .75, 0), k_vec(0, -1, 0));
  PASS(hit.t == 0.25 && hit.N.y == 1, "a grain in a cavity faces out");
  hit = support_hit(model, k_vec(0, .75, 0), k_vec(0, 1, 0));
  PASS(hit.t == 0.25 && hit.N.y == -1, "the cavity round it faces in");
  hit = support_hit(model, k_vec(9, 0, 0), k_vec(-1, 0, 0));
  PASS(hit.t == 5 && hit.N.x == 1, "a part beside it faces out");
}

/** Random tetrahedra, faces wound at random: the normal seen from outside
    always faces the ray, whatever the material. */
static void
tetrahedra(void)
{
  unsigned wrong = 0, hits = 0, in_out = 0;

  for (unsigned i = 0; i < 300; i++)
    {
      NSAutoreleasePool *pool = [[NSAutoreleasePool alloc] init];
      struct support_random random = support_seed(i);
      struct k_vec c = support_point(&random, i % 3 ? 1 : 1e4), v[4];
      for (int k = 0; k < 4; k++)
        {
          v[k] = k_add(c, support_point(&random, 2));
        }
      double volume = k_dot(k_sub(v[1], v[0]),
                            k_cross(k_sub(v[2], v[0]), k_sub(v[3], v[0])));
      if (fabs(volume) < 0.1)
        {
          [pool release];
          continue;
        }
      NSMutableString *text = [NSMutableString stringWithUTF8String: WORLD];
      for (int k = 0; k < 4; k++)
        {
          int a = (k + 1) % 4, b = (k + 2) % 4, d = (k + 3) % 4;
          if (support_unit(&random) < 0.5)
            {
              int swap = a;
              a = b;
              b = swap;
            }
          [text appendFormat: @"polygon p%d { material %s solid s"
            @" vertex %.17g %.17g %.17g vertex %.17g %.17g %.17g"
            @" vertex %.17g %.17g %.17g }\n", k, i % 2 ? "m" : "glass",
            v[a].x, v[a].y, v[a].z, v[b].x, v[b].y, v[b].z,
            v[d].x, v[d].y, v[d].z];
        }
      model_t *model = support_model_with(support_options(), text);
      struct k_vec middle = k_scale(k_add(k_add(v[0], v[1]),
                                          k_add(v[2], v[3])), 0.25);
      for (unsigned j = 0; j < 50; j++)
        {
          struct k_vec d = support_direction(&random);
          struct hit hit = support_hit(model, k_along(middle, -20, d), d);
          hits += hit.object != nil;
          wrong += hit.object == nil || !(k_dot(hit.N, d) < 0);
          struct hit out = support_hit(model, middle, d);
          wrong += out.object == nil || !(k_dot(out.N, d) > 0);
          // Both ways through the middle give the same chord.
          struct hit back = support_hit(model, middle, k_neg(d));
          in_out += fabs(hit.t + back.t - 20) > 1e-11 * k_norm1(c) + 1e-12;
        }
      [pool release];
    }
  PASS(hits > 9000, "rays at tetrahedra hit: %u", hits);
  PASS(wrong == 0, "from outside they meet an outward normal, from inside"
       " they leave by one: %u", wrong);
  PASS(in_out == 0, "at the same place either way: %u", in_out);
}

/** One ray through a solid of index 1 and alpha 1, face by face: its length
    inside must be that of the shape. `inside` says what is inside. */
static void
chords(model_t *model, int (*inside)(struct k_vec), double size,
       const char *what)
{
  unsigned wrong = 0, pieces = 0, dirty = 0;

  for (unsigned i = 0; i < 3000; i++)
    {
      NSAutoreleasePool *pool = [[NSAutoreleasePool alloc] init];
      struct support_random random = support_seed(i);
      struct k_vec o = k_scale(support_direction(&random), 4 * size);
      struct k_vec aim = support_point(&random, size);
      ray_t *ray = support_ray(model, o, k_sub(aim, o));
      double begin = 0;
      for (int k = 0; k < 20; k++)
        {
          [model find_closest: ray];
          double end = ray->hit.object ? begin + ray->hit.t : 16 * size;
          // The middle of this piece of the line is inside or is not.
          struct k_vec half = k_along(o, (begin + end) / 2, ray->dir->v);
          if (end - begin > 1e-9)
            {
              wrong += inside(half) != (ray->media != nil);
              pieces++;
            }
          if (ray->hit.object == nil)
            {
              dirty += ray->media != nil;
              break;
            }
          // On through the surface, as trace: does.
          BOOL goes_in = k_dot(ray->hit.N, ray->dir->v) < 0;
          object_t *medium = [ray->hit.object medium];
          media_t *media = goes_in
            ? [media_t enter: medium : 1 over: ray->media]
            : [media_t leave: medium from: ray->media];
          ray_t *on = [[(ray_t *)[ray_t alloc]
                         init: [vec_t vec: ray->hit.P] : ray->dir
                         from: ray through: YES] autorelease];
          [media retain];
          [on->media release];
          on->media = media;
          begin = end;
          ray = on;
        }
      [pool release];
    }
  PASS(pieces > 4000, "%s: pieces of lines: %u", what, pieces);
  PASS(wrong == 0, "%s: each is in the medium it lies in: %u", what, wrong);
  PASS(dirty == 0, "%s: none leaves with a medium: %u", what, dirty);
}

static int
in_cavity(struct k_vec p)
{
  return in_cube(p, 2) && !in_cube(p, 1);
}

static int
in_two(struct k_vec p)
{
  return in_cube(p, 2);
}

static void
through(void)
{
  char text[sizeof l_prism + 200];

  snprintf(text, sizeof text, l_prism, "glass");
  chords(support_model(WORLD "%s", text), in_l, 2, "L-prism");
  chords(support_model(WORLD "%s", support_box("c", "c", "glass",
                                               k_vec(-2, -2, -2),
                                               k_vec(2, 2, 2))),
         in_two, 2.5, "cube");
  chords(support_model(WORLD "%s%s",
                       support_box("c", "c", "glass", k_vec(-2, -2, -2),
                                   k_vec(2, 2, 2)),
                       support_box("d", "c", "glass", k_vec(-1, -1, -1),
                                   k_vec(1, 1, 1))),
         in_cavity, 2.5, "cube with a cavity");
}

static void
kinds(void)
{
  char text[sizeof l_prism + 200];
  model_t *model = support_model
    (WORLD "%s", support_box("c", "c", "glass", k_vec(-1, -1, -1),
                             k_vec(1, 1, 1)));
  struct hit hit = support_hit(model, k_vec(0, 0, 5), k_vec(0, 0, -1));
  solid_t *solid = [hit.object medium];

  PASS([solid isKindOfClass: [solid_t class]] && [solid->faces count] == 6,
       "the faces of a clear solid are one medium");
  PASS(solid->is_convex, "a cube is convex");
  PASS(hit.object->number == 2, "the hit names the face: %u",
       hit.object->number);
  PASS([solid contains: k_vec(0, 0, 0.999)]
       && ![solid contains: k_vec(0, 0, 1)]
       && ![solid contains: k_vec(0, 0, 1.001)], "on the surface is outside");
  snprintf(text, sizeof text, l_prism, "glass");
  model = support_model(WORLD "%s", text);
  hit = support_hit(model, k_vec(0.5, 0.5, 5), k_vec(0, 0, -1));
  solid = [hit.object medium];
  PASS(!solid->is_convex, "an L-prism is not");
  unsigned wrong = 0, on = 0;
  for (unsigned i = 0; i < 5000; i++)
    {
      struct support_random random = support_seed(i);
      struct k_vec p = support_point(&random, 2.2);
      wrong += [solid contains: p] != in_l(p);
      // On the surface: one coordinate that of a face.
      p = k_vec(support_between(&random, 0, 1),
                support_between(&random, 0, 2), 0);
      p = i % 4 == 0 ? k_vec(p.x, p.y, 1) : i % 4 == 1 ? p
        : i % 4 == 2 ? k_vec(0, p.y, p.x) : k_vec(p.y, 0, p.x);
      on += [solid contains: p];
    }
  PASS(wrong == 0, "contains: knows its shape: %u", wrong);
  PASS(on == 0, "on its surface is outside: %u", on);

  // Faces may differ in colour, not in alpha or ior.
  PASS(support_faults([[NSString stringWithFormat: @"%s%s", WORLD,
    support_box("c", "c", "glass", k_vec(0, 0, 0), k_vec(1, 1, 1))]
    UTF8String]) == nil, "a closed cube has no fault");
  NSMutableString *cube = [NSMutableString stringWithFormat: @"%s%s", WORLD,
    support_box("c", "c", "glass", k_vec(0, 0, 0), k_vec(1, 1, 1))];
  NSRange third = [cube rangeOfString: @"polygon c3 { material glass"];
  NSString *tinted = [cube stringByReplacingCharactersInRange: third
                      withString: @"polygon c3 { material tinted"];
  PASS(support_faults([tinted UTF8String]) == nil, "one face may be of"
       " another colour");
  NSString *water = [cube stringByReplacingCharactersInRange: third
                     withString: @"polygon c3 { material water"];
  NSString *report = support_faults([water UTF8String]);
  PASS(report && [report rangeOfString: @":9:23:"].length > 0,
       "but not of another index: a fault at its material");
}

static void
not_closed(void)
{
  NSMutableString *cube = [NSMutableString stringWithFormat: @"%s%s", WORLD,
    support_box("c", "box", "m", k_vec(0, 0, 0), k_vec(1, 1, 1))];
  NSRange last = [cube rangeOfString: @"polygon c5"];
  NSString *report = support_faults
    ([[cube substringToIndex: last.location] UTF8String]);

  PASS(report && [report rangeOfString: @"'box' is not closed"].length > 0,
       "a missing face is a fault that names the solid");
  PASS(report && [report rangeOfString: @"edge"].length > 0, "and an edge");
  [cube appendString: @"polygon c6 { material m solid box vertex 0 0 0"
    " vertex 1 0 0 vertex 1 1 0 vertex 0 1 0 }\n"];
  report = support_faults([cube UTF8String]);
  PASS(report != nil, "a face twice is a fault");
  PASS(support_faults(WORLD
    "polygon a { material m solid s vertex 0 0 0 vertex 1 0 0"
    " vertex 0 1 0 }") != nil, "one polygon alone is not closed");
  // The same cube by corners that differ in the last bit.
  report = support_faults([[cube stringByReplacingOccurrencesOfString:
    @"vertex 1 1 0" withString: @"vertex 1 1.0000000000000002 0"]
    UTF8String]);
  PASS(report != nil, "corners have to be the same numbers");
}

/** Names of solids are their own: the same as a polygon's or sphere's. */
static void
names(void)
{
  NSString *text = [NSString stringWithFormat: @"%s%s"
    @"sphere c { material m center 9 9 9 radius 1 }\n", WORLD,
    support_box("c", "c0", "glass", k_vec(0, 0, 0), k_vec(1, 1, 1))];

  PASS(support_faults([text UTF8String]) == nil, "a solid may be called as"
       " one of its polygons");
  // Two solids, their polygons in any order.
  NSMutableArray *lines = [NSMutableArray array];
  NSString *a = [NSString stringWithUTF8String:
    support_box("a", "a", "glass", k_vec(0, 0, 0), k_vec(1, 1, 1))];
  NSString *b = [NSString stringWithUTF8String:
    support_box("b", "b", "water", k_vec(0, 0, 2), k_vec(1, 1, 3))];
  NSArray *as = [a componentsSeparatedByString: @"\n"];
  NSArray *bs = [b componentsSeparatedByString: @"\n"];
  for (NSUInteger i = 0; i < 6; i++)
    {
      [lines addObject: [as objectAtIndex: i]];
      [lines addObject: [bs objectAtIndex: 5 - i]];
    }
  model_t *model = support_model
    (WORLD "%s", [[lines componentsJoinedByString: @"\n"] UTF8String]);
  solid_t *sa = [[support_object(model, "a3") medium] retain];
  solid_t *sb = [support_object(model, "b0") medium];
  PASS(sa != sb && [sa->faces count] == 6 && [sb->faces count] == 6,
       "two solids whose polygons are mixed");
  [sa release];
}

int
main(void)
{
  NSAutoreleasePool *pool = [[NSAutoreleasePool alloc] init];

  normals();
  tetrahedra();
  through();
  kinds();
  not_closed();
  names();
  [pool release];
  return test_done();
}
