// shadows.m - what blocks a shadow feeler and what does not. Notes, "shadow
// casting". The floor z = 0 is matte with ambient 0, so that it is black in
// shadow, and lit by one light.

#import "support.h"
#include "test.h"

#define WORLD \
  "material m { diffuse 1 1 1 }\n" \
  "material glass { alpha .001 ior 1.5 }\n" \
  "plane floor { material m normal 0 0 1 point 0 0 0 }\n" SUPPORT_CAMERA

/** Whether light comes to the origin, seen from (0 2 2). */
static BOOL
is_lit(model_t *model)
{
  return support_trace(model, k_vec(0, 2, 2), k_vec(0, -1, -1)).x > 0;
}

static BOOL
is_lit_with(const char *things)
{
  return is_lit(support_model(WORLD "%s", things));
}

#define LIGHT "light l { location 0 0 4 emissivity 1 1 1 }\n"

static void
blockers(void)
{
  PASS(is_lit_with(LIGHT), "nothing between: lit");
  PASS(!is_lit_with(LIGHT "sphere s { material m center 0 0 2 radius .5 }"),
       "an opaque sphere between");
  PASS(is_lit_with(LIGHT "sphere s { material m center 2 0 2 radius .5 }"),
       "an opaque sphere beside");
  PASS(is_lit_with(LIGHT "sphere s { material m center 0 0 6 radius 1 }"),
       "an opaque sphere beyond the light");
  PASS(is_lit_with(LIGHT "sphere s { material m center 0 0 -3 radius 1 }"),
       "an opaque sphere under the floor");
  PASS(!is_lit_with(LIGHT "plane p { material m normal 0 0 1 point 0 0 3 }"),
       "a plane between, its back");
  PASS(!is_lit_with(LIGHT "plane p { material m normal 0 0 -1 point 0 0 3 }"),
       "a plane between, its front");
  PASS(!is_lit_with(LIGHT "polygon p { material m vertex -1 -1 1"
                    " vertex 1 -1 1 vertex 0 .5 1 }"), "a polygon");
  PASS(!is_lit_with(LIGHT "sphere s { material m center 0 0 4 radius 1 }"),
       "a sphere round the light");
  PASS(is_lit_with(LIGHT "sphere s { material m center 0 0 0 radius 9 }"),
       "a sphere round all");
}

static void
near_and_far(void)
{
  PASS(!is_lit_with(LIGHT
    "sphere s { material m center 0 0 1.5e-7 radius 5e-8 }"),
       "a blocker 1e-7 above the floor");
  PASS(!is_lit_with("light l { location 0 0 1e-6 emissivity 1 1 1 }\n"
    "polygon p { material m vertex -1e-7 -1e-7 5e-7 vertex 1e-7 -1e-7 5e-7"
    " vertex 0 1e-7 5e-7 }"), "between the floor and a light 1e-6 above it");
  PASS(is_lit_with("light l { location 0 0 1e-6 emissivity 1 1 1 }\n"),
       "that light without a blocker");
  PASS(is_lit_with("light l { location 0 0 1e100 emissivity 1 1 1 }\n"),
       "a light at 1e100");
  PASS(!is_lit_with("light l { location 0 0 1e100 emissivity 1 1 1 }\n"
    "sphere s { material m center 0 0 2 radius .5 }"),
       "and a blocker before it");
  PASS(is_lit_with(LIGHT
    "polygon p { material m vertex -1 -1 4.0000001 vertex 1 -1 4.0000001"
    " vertex 0 2 4.0000001 }"), "just beyond the light");
  PASS(!is_lit_with(LIGHT
    "polygon p { material m vertex -1 -1 3.9999999 vertex 1 -1 3.9999999"
    " vertex 0 2 3.9999999 }"), "just before it");
}

/** Lights that lie on surfaces are not hidden by them. */
static void
on_surface(void)
{
  PASS(is_lit_with(LIGHT "plane p { material m normal 0 0 1 point 0 0 4 }"),
       "a light on a plane");
  PASS(is_lit_with(LIGHT "sphere s { material m center 0 0 5 radius 1 }"),
       "a light on the near side of a sphere");
  PASS(!is_lit_with(LIGHT "sphere s { material m center 0 0 3 radius 1 }"),
       "a light on the far side of a sphere");
  unsigned plane = 0, polygon = 0;
  for (unsigned i = 0; i < 300; i++)
    {
      // A tilted wall through the light; seen from random points of the
      // floor, which see it at random angles.
      NSAutoreleasePool *pool = [[NSAutoreleasePool alloc] init];
      struct support_random random = support_seed(i);
      double far = exp2(support_between(&random, 0, 30));
      struct k_vec c = support_point(&random, far);
      c.z = 4;
      struct k_vec u = support_direction(&random);
      struct k_vec w = k_unit(k_cross(u, support_direction(&random)));
      struct k_vec n = k_cross(u, w);
      double a = support_between(&random, -0.3, 0.3);
      double b = support_between(&random, -0.3, 0.3);
      struct k_vec l = k_along(k_along(c, a, u), b, w);
      model_t *model = support_model
        (WORLD "light l { location %.17g %.17g %.17g emissivity 1 1 1 }\n"
         "plane p { material m normal %.17g %.17g %.17g"
         " point %.17g %.17g %.17g }", l.x, l.y, l.z, n.x, n.y, n.z,
         c.x, c.y, c.z);
      for (int j = 0; j < 20; j++)
        {
          struct k_vec eye = k_add(c, support_point(&random, 9));
          eye.z = 0x1p-3;
          plane += support_number(model, eye, k_vec(0, 0, -1)) == 1
            && !(support_trace(model, eye, k_vec(0, 0, -1)).x > 0);
        }
      model = support_model
        (WORLD "light l { location %.17g %.17g %.17g emissivity 1 1 1 }\n"
         "polygon p { material m vertex %.17g %.17g %.17g"
         " vertex %.17g %.17g %.17g vertex %.17g %.17g %.17g }",
         l.x, l.y, l.z, c.x - u.x - w.x, c.y - u.y - w.y, c.z - u.z - w.z,
         c.x + u.x - w.x, c.y + u.y - w.y, c.z + u.z - w.z,
         c.x + 2 * w.x, c.y + 2 * w.y, c.z + 2 * w.z);
      for (int j = 0; j < 20; j++)
        {
          struct k_vec eye = k_add(c, support_point(&random, 9));
          eye.z = 0x1p-3;
          polygon += !(support_trace(model, eye, k_vec(0, 0, -1)).x > 0);
        }
      [pool release];
    }
  PASS(plane == 0, "a light on a tilted plane, anywhere: %u dark", plane);
  PASS(polygon == 0, "a light on a tilted polygon, anywhere: %u dark",
       polygon);
}

static void
glass(void)
{
  PASS(is_lit_with(LIGHT
    "sphere s { material glass center 0 0 2 radius .5 }"),
       "glass, however little of it is clear, does not block");
  PASS(!is_lit_with(LIGHT
    "sphere s { material glass center 0 0 1 radius .5 }\n"
    "sphere t { material m center 0 0 3 radius .5 }"),
       "an opaque sphere behind glass does");
  PASS(!is_lit_with(LIGHT
    "sphere s { material glass center 0 0 2 radius 1 }\n"
    "sphere t { material m center 0 0 2 radius .5 }"),
       "an opaque sphere inside glass does");
  PASS(is_lit_with(LIGHT
    "sphere s { material glass center 0 0 2 radius 1 }\n"
    "sphere t { material glass center 0 0 2 radius .5 }"),
       "glass inside glass does not");
  PASS(is_lit_with(LIGHT
    "polygon p { material glass vertex -1 -1 1 vertex 1 -1 1"
    " vertex 0 .5 1 }"), "a thin sheet of glass does not");
}

/** Both sides of one surface, and the inside of a hollow sphere. */
static void
own_surface(void)
{
  model_t *model = support_model
    ("material m { diffuse 1 1 1 }\n" SUPPORT_CAMERA
     "sphere s { material m center 0 0 0 radius 2 }\n"
     "light in { location 0 0 1 emissivity 1 0 0 }\n"
     "light out { location 0 0 6 emissivity 0 1 0 }\n");
  struct k_vec c = support_trace(model, k_vec(0, 0, 0), k_vec(0.3, 0, -1));
  PASS(c.x > 0 && c.y == 0, "inside a hollow sphere its inner light shines"
       " and the outer one does not");
  c = support_trace(model, k_vec(0, 0, 4), k_vec(0.1, 0, -1));
  PASS(c.x == 0 && c.y > 0, "outside it is the other way round");
  c = support_trace(model, k_vec(0, 0, -4), k_vec(0, 0, 1));
  PASS(c.x == 0 && c.y == 0, "on the far side none of them");

  // Points of a ball, lit where the light sees them, dark elsewhere.
  unsigned wrong = 0;
  for (unsigned i = 0; i < 20000; i++)
    {
      struct support_random random = support_seed(i);
      struct k_vec N = support_direction(&random);
      struct k_vec eye = k_scale(N, 3);
      struct k_vec P = k_scale(N, 2);
      double side = k_dot(N, k_sub(k_vec(0, 0, 6), P));
      NSAutoreleasePool *pool = [[NSAutoreleasePool alloc] init];
      c = support_trace(model, eye, k_neg(N));
      wrong += fabs(side) > 1e-12 && (c.y > 0) != (side > 0);
      [pool release];
    }
  PASS(wrong == 0, "a ball is lit exactly where its light sees it: %u",
       wrong);
}

static void
counts(void)
{
  model_t *model = support_model
    (WORLD LIGHT "light k { location 0 0 -4 emissivity 1 1 1 }\n"
     "light j { location 1 1 4 emissivity 1 1 1 }\n");
  ray_t *ray = support_ray(model, k_vec(0, 2, 2), k_vec(0, -1, -1));

  [ray trace: model];
  PASS(ray->counters->feeler == 2, "one feeler for each light that is not"
       " behind the surface: %llu",
       (unsigned long long)ray->counters->feeler);
}

int
main(void)
{
  NSAutoreleasePool *pool = [[NSAutoreleasePool alloc] init];

  blockers();
  near_and_far();
  on_surface();
  glass();
  own_surface();
  counts();
  [pool release];
  return test_done();
}
