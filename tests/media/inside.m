// inside.m - which media a ray is in. A ball of a class of this test, opaque
// and black, tells the media of the ray that hits it. Notes, "bounded
// planes", last page.

#import "support.h"
#include "test.h"

/** `probe name { … }`: a sphere that notes what the ray was in that came to
    it straight down from the eye. */
@interface probe_t : sphere_t
@end

static char seen[256];          // indices, from the top down
static double eye_z;            // where the eye ray starts

@implementation probe_t

- (void) hits: (ray_t *)ray
{
  [super hits: ray];
  BOOL is_straight = fabs(eye_z - ray->pos->v.z - ray->dis) < 1e-9;

  if (is_straight && ray->hit.object == self)
    {
      seen[0] = 0;
      for (media_t *m = ray->media; m; m = m->below)
        {
          sprintf(seen + strlen(seen), "%g ", m->ior);
        }
      strcpy(seen + strlen(seen), "air");
    }
}

@end

#define WORLD SUPPORT_CAMERA \
  "material black { }\n" \
  "material glass { alpha 1 ior 1.5 }\n" \
  "material water { alpha 1 ior 1.25 }\n" \
  "material bubble { alpha 1 }\n" \
  "material heavy { alpha 1 ior 2 }\n"

/** A cube round (0 0 z), as text. */
static const char *
cube(const char *name, const char *solid, const char *material, double half,
     double z)
{
  return support_box(name, solid, material, k_vec(-half, -half, z - half),
                     k_vec(half, half, z + half));
}

/** What a ray from (0 0 z) straight down is in where it hits the probe, a
    small ball at (0 0 -50) unless `things` has another. */
static const char *
down_from(double z, const char *things, ...)
{
  char text[20000];
  va_list arguments;

  va_start(arguments, things);
  vsnprintf(text, sizeof text, things, arguments);
  va_end(arguments);
  model_t *model = support_model
    (WORLD "%s\n%s", text, strstr(text, "probe") ? ""
     : "probe p { material black center 0 0 -50 radius 1 }");
  strcpy(seen, "nothing");
  eye_z = z;
  support_trace(model, k_vec(0, 0, z), k_vec(0, 0, -1));
  return seen;
}

static void
is(const char *got, const char *want, const char *what)
{
  if (!PASS(strcmp(got, want) == 0, "%s: %s", what, want))
    {
      printf("# got %s\n", got);
    }
}

#define PROBE "probe p { material black center 0 0 0 radius .1 }\n"

static void
spheres(void)
{
  is(down_from(9, ""), "air", "nothing in the way");
  is(down_from(9, "sphere s { material glass center 0 0 0 radius 1 }" PROBE),
     "1.5 air", "in a glass ball");
  is(down_from(9, "sphere s { material glass center 0 0 0 radius 1 }"),
     "air", "behind it");
  is(down_from(9, "sphere s { material glass center 0 0 0 radius 2 }\n"
               "sphere b { material bubble center 0 0 0 radius 1 }\n" PROBE),
     "1 1.5 air", "in a bubble in glass");
  is(down_from(9, "sphere s { material glass center 0 0 0 radius 2 }\n"
               "sphere b { material bubble center 0 0 0 radius 1 }\n"
               "probe p { material black center 0 0 -1.5 radius .1 }"),
     "1.5 air", "in the glass behind the bubble");
  is(down_from(9, "sphere s { material glass center 0 0 0 radius 2 }\n"
               "sphere b { material bubble center 0 0 0 radius 1 }\n"),
     "air", "behind both");
  is(down_from(9, "sphere s { material glass center 0 0 1 radius 2 }\n"
               "sphere w { material water center 0 0 -1 radius 2 }\n" PROBE),
     "1.25 1.5 air", "where two balls overlap");
  is(down_from(9, "sphere s { material glass center 0 0 1 radius 2 }\n"
               "sphere w { material water center 0 0 -1 radius 2 }\n"
               "probe p { material black center 0 0 -2 radius .1 }\n"),
     "1.25 air", "when the first of them is left inside the other");
  is(down_from(9, "sphere s { material glass center 0 0 1 radius 2 }\n"
               "sphere w { material water center 0 0 -1 radius 2 }\n"),
     "air", "behind both");
  is(down_from(9, "sphere a { material glass center 0 0 0 radius 3 }\n"
               "sphere b { material water center 0 0 0 radius 2 }\n"
               "sphere c { material heavy center 0 0 0 radius 1 }\n" PROBE),
     "2 1.25 1.5 air", "in the innermost of three");
}

static void
eye_inside(void)
{
  is(down_from(0.5, "sphere s { material glass center 0 0 0 radius 1 }"
               PROBE), "1.5 air", "the eye in a glass ball");
  is(down_from(0.5, "sphere s { material glass center 0 0 0 radius 1 }"),
     "air", "out of it");
  is(down_from(0.5, "sphere s { material glass center 0 0 0 radius 2 }\n"
               "sphere b { material bubble center 0 0 0 radius 1 }\n" PROBE),
     "1 1.5 air", "the eye in a bubble in glass");
  is(down_from(0.5, "sphere b { material bubble center 0 0 0 radius 1 }\n"
               "sphere s { material glass center 0 0 0 radius 2 }\n"
               "probe p { material black center 0 0 -1.5 radius .1 }\n"),
     "1.5 air", "from the bubble into the glass");
  // What is left first is on top: w ends at -2, s at -3.
  is(down_from(0, "sphere w { material water center 0 0 1 radius 3 }\n"
               "sphere s { material glass center 0 0 -1 radius 2 }\n"
               "probe p { material black center 0 0 -1 radius .1 }\n"),
     "1.25 1.5 air", "in two overlapping balls the one left first is on"
     " top");
  is(down_from(0, "sphere s { material glass center 0 0 -1 radius 2 }\n"
               "sphere w { material water center 0 0 1 radius 3 }\n"
               "probe p { material black center 0 0 -1 radius .1 }\n"),
     "1.25 1.5 air", "in whichever order they are declared");
  is(down_from(0, "sphere s { material black center 0 0 0 radius 2 }"
               "probe p { material black center 0 0 -1 radius .1 }\n"),
     "air", "in an opaque ball is air");
  is(down_from(1, "sphere s { material glass center 0 0 0 radius 1 }"
               PROBE), "air", "the eye on the ball is outside");
  is(down_from(-1, "sphere s { material glass center 0 0 0 radius 1 }"),
     "air", "the eye on the ball, looking away, is in air");
}

static void
planes(void)
{
#define POND "plane w { material water normal 0 0 1 point 0 0 0 }\n"
  is(down_from(9, POND), "1.25 air", "a plane is a half space");
  is(down_from(-1, POND), "1.25 air", "with the eye in it");
  is(down_from(0, POND), "air", "an eye on it is in air");
  is(down_from(9, "plane w { material water normal 0 0 -1 point 0 0 0 }\n"),
     "air", "out of the half space that the eye is in");
  is(down_from(9, "plane w { material water normal 0 0 -1 point 0 0 0 }\n"
               "probe p { material black center 0 0 3 radius 1 }"),
     "1.25 air", "the half space in front");
  is(down_from(9, POND "sphere s { material glass center 0 0 -9 radius 2 }\n"
               "probe p { material black center 0 0 -9 radius 1 }"),
     "1.5 1.25 air", "a glass ball in water");
  is(down_from(-1, "sphere s { material glass center 0 0 -1 radius 3 }\n"
               POND "probe p { material black center 0 0 -3 radius .1 }"),
     "1.5 1.25 air", "the eye in water and glass: the water is never left");
  is(down_from(9, POND
               "plane b { material black normal 0 0 1 point 0 0 -60 }\n"),
     "1.25 air", "opaque planes are no media");
}

static void
sheets(void)
{
#define SHEET(z) "polygon t" #z " { material heavy vertex -5 -5 " #z \
  " vertex 5 -5 " #z " vertex 5 5 " #z " vertex -5 5 " #z " }\n"
  is(down_from(9, SHEET(1)), "air", "a thin sheet is no medium");
  is(down_from(9, SHEET(1) SHEET(2)), "air", "nor are two");
  is(down_from(9, "sphere s { material glass center 0 0 0 radius 4 }\n"
               SHEET(1) PROBE), "1.5 air", "a sheet inside glass");
  is(down_from(9, "sphere s { material glass center 0 0 0 radius 4 }\n"
               SHEET(1)), "air", "and out again");
}

static void
solids(void)
{
  is(down_from(9, "%s" PROBE, cube("c", "c", "glass", 1, 0)),
     "1.5 air", "in a glass cube");
  is(down_from(9, "%s", cube("c", "c", "glass", 1, 0)), "air",
     "behind it");
  is(down_from(0.5, "%s" PROBE, cube("c", "c", "glass", 1, 0)),
     "1.5 air", "the eye in it");
  is(down_from(1, "%s" PROBE, cube("c", "c", "glass", 1, 0)),
     "air", "the eye on it is outside");
  is(down_from(9, "%s%s" PROBE, cube("c", "c", "glass", 2, 0),
               cube("b", "b", "bubble", 1, 0)),
     "1 1.5 air", "a cube of air in a cube of glass");
  is(down_from(9, "%s%s", cube("c", "c", "glass", 2, 0),
               cube("b", "b", "bubble", 1, 0)),
     "air", "behind both");
  is(down_from(0.5, "%s%s" PROBE, cube("c", "c", "glass", 2, 0),
               cube("b", "b", "bubble", 1, 0)),
     "1 1.5 air", "the eye in both");
  is(down_from(9, "%s%s" PROBE, cube("c", "c", "glass", 2, 1),
               cube("w", "w", "water", 3, -2)),
     "1.25 1.5 air", "two cubes that overlap");
  is(down_from(9, "%s%s", cube("c", "c", "glass", 2, 1),
               cube("w", "w", "water", 3, -2)),
     "air", "behind them");
  is(down_from(9, "%s%s" PROBE, cube("c", "c", "glass", 2, 0),
               cube("d", "d", "glass", 1, 0)),
     "1.5 1.5 air", "two solids of glass, one in the other");
}

/** Two cubes under one name: the inner one is a cavity. */
static void
cavity(void)
{
  const char *text
    = [[NSString stringWithFormat: @"%s%s", cube("c", "c", "glass", 2, 0),
                 cube("d", "c", "glass", 1, 0)] UTF8String];

  is(down_from(9, "%s" PROBE, text), "air", "in the cavity of a solid");
  is(down_from(9, "%sprobe p { material black center 0 0 -1.5 radius .1 }",
               text), "1.5 air", "in its wall");
  is(down_from(0.5, "%s" PROBE, text), "air", "the eye in the cavity");
  is(down_from(0.5, "%sprobe p { material black center 0 0 -1.5 radius .1 }",
               text), "1.5 air", "from there into the wall");
  is(down_from(1.5, "%s" PROBE, text), "air", "from the wall into it");
  is(down_from(9, "%s", text), "air", "behind it all");
}

/** Out of what the ray was never told to be in: n_i is the object's own. */
static void
not_on_the_stack(void)
{
  model_t *model = support_model
    (WORLD "sphere s { material glass center 0 0 0 radius 1 }\n"
     "material white { ambient 1 1 1 }\n"
     "plane b { material white normal 0 0 1 point 0 0 -5 }\n"
     "plane g { material glass normal 0 1 0 point 0 9 0 }\n");
  ray_t *ray = [(ray_t *)[ray_t alloc] init: [vec_t vec: k_vec(0, 0, 0)]
                                           : [vec_t vec: k_vec(0, 0, -1)]];
  model->max_depth = 1;
  struct k_vec c = [ray trace: model]->v;

  // No media although it is inside: out of glass into air all the same.
  PASS_ULPS(c.x, 0.96 / 5, 4, "out of a ball that is not on the stack");
  [ray release];
  ray = [(ray_t *)[ray_t alloc] init: [vec_t vec: k_vec(0, 0, 0)]
                                    : [vec_t vec: k_vec(0, 0, -1)]];
  object_t *g = support_object(model, "g");
  ray->media = [[media_t enter: g : 1.5 over: nil] retain];
  c = [ray trace: model]->v;
  PASS_ULPS(c.x, 1.0 / 5, 4, "n_t is the top of the stack: 1.5 to 1.5");
  [ray release];
}

static double
normal_reflectance(double n_i, double n_t)
{
  return (n_t - n_i) / (n_t + n_i) * (n_t - n_i) / (n_t + n_i);
}

/** Straight through two balls that overlap: what is left behind is the ball's
    own index, even when it is not on top. */
static void
indices(void)
{
  model_t *model = support_model
    (WORLD "material white { ambient 1 1 1 }\n"
     "sphere s { material glass center 0 0 1 radius 2 }\n"
     "sphere w { material water center 0 0 -1 radius 2 }\n"
     "plane b { material white normal 0 0 1 point 0 0 -5 }\n");
  const double pairs[4][2] = { { 1, 1.5 }, { 1.5, 1.25 }, { 1.5, 1.25 },
                               { 1.25, 1 } };
  double want = 1 / 10.0;

  model->max_depth = 4;
  for (int i = 0; i < 4; i++)
    {
      want *= 1 - normal_reflectance(pairs[i][0], pairs[i][1]);
    }
  struct k_vec c = support_trace(model, k_vec(0, 0, 5), k_vec(0, 0, -1));
  PASS_ULPS(c.x, want, 16, "through two overlapping balls: 1 to 1.5, 1.5 to"
            " 1.25, 1.5 to 1.25, 1.25 to 1");

  model = support_model
    (WORLD "material white { ambient 1 1 1 }\n"
     "sphere s { material glass center 0 0 0 radius 2 }\n"
     "sphere b { material bubble center 0 0 0 radius 1 }\n"
     "plane w { material white normal 0 0 1 point 0 0 -5 }\n");
  model->max_depth = 4;
  c = support_trace(model, k_vec(0, 0, 5), k_vec(0, 0, -1));
  PASS_ULPS(c.x, pow(0.96, 4) / 10, 16, "through a bubble in glass: 1 to 1.5"
            " and back, twice");
}

/** Each point of the lens is in what it is in by itself: a ball round the
    right half of the lens. */
static void
lens(void)
{
  model_t *model = support_model
    ("camera cam { pixeldim 1 1 worlddim 2 2 viewpoint 0 0 5 focus 1 fstop 1"
     " exposure 4 }\n"
     "material glass { alpha 1 ior 1.5 }\n"
     "sphere s { material glass center 10 0 5 radius 10 }\n");
  unsigned wrong = 0, inside = 0;

  for (unsigned i = 0; i < 200; i++)
    {
      struct support_random random = support_seed(i);
      struct sample sample = { 0, 0, 0, 0, support_between(&random, -1, 1),
                               support_between(&random, -1, 1) };
      struct k_vec o, d;
      [model->camera ray: sample pos: &o dir: &d];
      ray_t *ray = [(ray_t *)[ray_t alloc] init: [vec_t vec: o]
                                               : [vec_t vec: d]];
      struct k_vec f = k_sub(o, k_vec(10, 0, 5));
      BOOL is_inside = k_dot(f, f) < 100;
      wrong += ([model mediaOf: ray] != nil) != is_inside;
      inside += is_inside;
      [ray release];
    }
  PASS(inside > 50 && inside < 150, "the ball's surface crosses the lens");
  PASS(wrong == 0, "each point of the lens starts in its own medium: %u",
       wrong);
}

/** From the middle of a ball every ray meets its surface at a right angle:
    0.04 stays in, the rest goes straight on. */
static void
eye_in_the_middle(void)
{
  model_t *model = support_model
    (WORLD "background 1 1 1\n"
     "sphere s { material glass center 1 2 3 radius 2 }\n");
  unsigned wrong = 0;
  model->max_depth = 1;
  for (unsigned i = 0; i < 500; i++)
    {
      struct support_random random = support_seed(i);
      struct k_vec c = support_trace(model, k_vec(1, 2, 3),
                                     support_direction(&random));
      wrong += !(fabs(c.x - 0.96) <= 4 * K_U);
    }
  PASS(wrong == 0, "from the middle of a ball every ray leaves straight: %u",
       wrong);
}

int
main(void)
{
  NSAutoreleasePool *pool = [[NSAutoreleasePool alloc] init];

  spheres();
  eye_inside();
  planes();
  sheets();
  solids();
  cavity();
  not_on_the_stack();
  indices();
  lens();
  eye_in_the_middle();
  [pool release];
  return test_done();
}
