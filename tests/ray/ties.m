// ties.m - of what is met at the same distance the object declared first is
// hit; flat objects in one plane count as equal although rounding may part
// them.

#import "support.h"
#include "test.h"

static const char materials[] = SUPPORT_CAMERA "material m { }\n"
  "material g { alpha 1 ior 1.5 }\n";

static void
equal(void)
{
  model_t *model = support_model
    ("%s sphere a { material m center 0 0 0 radius 1 }\n"
     "sphere b { material m center 0 0 0 radius 1 }\n"
     "sphere c { material g center 0 0 0 radius 1 }\n", materials);
  unsigned wrong = 0;

  for (unsigned i = 0; i < 5000; i++)
    {
      NSAutoreleasePool *pool = [[NSAutoreleasePool alloc] init];
      struct support_random random = support_seed(i);
      struct k_vec o = k_scale(support_direction(&random), 4);
      struct k_vec aim = k_scale(support_direction(&random), 0.9);
      wrong += support_number(model, o, k_sub(aim, o)) != 1;
      wrong += support_number(model, aim, k_sub(aim, o)) != 1;
      [pool release];
    }
  PASS(wrong == 0, "three spheres in one place: the first, everywhere: %u",
       wrong);

  model = support_model
    ("%s sphere a { material m center 1 0 0 radius 1 }\n"
     "sphere b { material m center -1 0 0 radius 1 }\n", materials);
  PASS(support_number(model, k_vec(0, 0, 5), k_vec(0, 0, -1)) == 1,
       "two spheres that touch, at the touching point");
  model = support_model
    ("%s sphere b { material m center -1 0 0 radius 1 }\n"
     "sphere a { material m center 1 0 0 radius 1 }\n", materials);
  struct hit hit = support_hit(model, k_vec(0, 0, 5), k_vec(0, 0, -1));
  PASS([[hit.object name] isEqual: @"b"], "in the other order");
  PASS(hit.t == 5, "at 5");

  model = support_model
    ("%s plane p { material m normal 0 0 1 point 3 1 0 }\n"
     "sphere s { material m center 0 0 -1 radius 1 }\n"
     "plane q { material m normal 0 0 -1 point 0 0 0 }\n", materials);
  PASS(support_number(model, k_vec(0, 0, 5), k_vec(0, 0, -1)) == 1,
       "a plane before a sphere that touches it");
  model = support_model
    ("%s sphere s { material m center 0 0 -1 radius 1 }\n"
     "plane p { material m normal 0 0 1 point 3 1 0 }\n", materials);
  PASS(support_number(model, k_vec(0, 0, 5), k_vec(0, 0, -1)) == 1,
       "a sphere before a plane that touches it");
}

/** A point of the plane through c with axes u, w, as exact as a double is. */
static struct k_vec
in_plane(struct k_vec c, struct k_vec u, struct k_vec w, double a, double b)
{
  struct q_vec p = q_add(q_of(c), q_add(q_scale(q_of(u), a),
                                        q_scale(q_of(w), b)));
  return q_double(p);
}

/** A convex polygon of n corners round (x y) of the plane, either way round,
    as text. */
static NSString *
polygon(unsigned number, unsigned n, struct k_vec c, struct k_vec u,
        struct k_vec w, struct support_random *random)
{
  NSMutableString *text = [NSMutableString stringWithFormat:
    @"polygon p%u { material m", number];
  double start = support_between(random, 0, 7);
  int way = support_unit(random) < 0.5 ? 1 : -1;

  for (unsigned i = 0; i < n; i++)
    {
      double angle = start + way * 2 * M_PI * i / n;
      double radius = support_between(random, 1.5, 1.9);
      struct k_vec v = in_plane(c, u, w, radius * cos(angle),
                                radius * sin(angle));
      [text appendFormat: @" vertex %.17g %.17g %.17g", v.x, v.y, v.z];
    }
  [text appendString: @" }\n"];
  return text;
}

/** Three tilted polygons of different corners and sides in one plane, near
    the origin or far from it: rays through their common part. */
static void
coplanar(double offset, const char *where)
{
  unsigned wrong = 0, missed = 0;

  for (unsigned i = 0; i < 400; i++)
    {
      NSAutoreleasePool *pool = [[NSAutoreleasePool alloc] init];
      struct support_random random = support_seed(i);
      struct k_vec c = support_point(&random, offset);
      struct k_vec u = support_direction(&random);
      struct k_vec n = q_double(q_unit(q_cross(q_of(u),
                                        q_of(support_direction(&random)))));
      struct k_vec w = q_double(q_unit(q_cross(q_of(n), q_of(u))));
      NSMutableString *text
        = [NSMutableString stringWithUTF8String: materials];
      for (unsigned number = 1; number <= 3; number++)
        {
          unsigned corners = 4 + (unsigned)(3 * support_unit(&random));
          [text appendString: polygon(number, corners, c, u, w, &random)];
        }
      model_t *model = support_model_with(support_options(), text);
      for (unsigned j = 0; j < 50; j++)
        {
          double a = support_between(&random, -0.5, 0.5);
          double b = support_between(&random, -0.5, 0.5);
          struct k_vec aim = in_plane(c, u, w, a, b);
          struct k_vec d = support_direction(&random);
          if (fabs(k_dot(d, n)) < 1e-3)
            {
              continue;
            }
          unsigned number = support_number(model, k_along(aim, -3, d), d);
          missed += number == 0;
          wrong += number > 1;
        }
      [pool release];
    }
  PASS(missed == 0, "overlapping coplanar polygons are hit, %s: %u not",
       where, missed);
  PASS(wrong == 0, "the first of them everywhere, %s: %u not", where, wrong);
}

/** A picture on a wall: a polygon declared before or after the plane it lies
    in. */
static void
on_plane(void)
{
  unsigned first = 0, second = 0;

  for (unsigned i = 0; i < 400; i++)
    {
      NSAutoreleasePool *pool = [[NSAutoreleasePool alloc] init];
      struct support_random random = support_seed(i);
      struct k_vec c = support_point(&random, 10);
      struct k_vec u = support_direction(&random);
      struct k_vec n = q_double(q_unit(q_cross(q_of(u),
                                        q_of(support_direction(&random)))));
      struct k_vec w = q_double(q_unit(q_cross(q_of(n), q_of(u))));
      NSString *picture = polygon(1, 4, c, u, w, &random);
      struct k_vec q = in_plane(c, u, w, support_between(&random, -9, 9), 3);
      NSString *wall = [NSString stringWithFormat: @"plane w { material m"
        @" normal %.17g %.17g %.17g point %.17g %.17g %.17g }\n",
        n.x, n.y, n.z, q.x, q.y, q.z];
      NSString *common = [NSString stringWithUTF8String: materials];
      model_t *a = support_model_with(support_options(),
        [NSString stringWithFormat: @"%@%@%@", common, picture, wall]);
      model_t *b = support_model_with(support_options(),
        [NSString stringWithFormat: @"%@%@%@", common, wall, picture]);
      for (unsigned j = 0; j < 20; j++)
        {
          struct k_vec aim = in_plane(c, u, w,
                                      support_between(&random, -0.5, 0.5),
                                      support_between(&random, -0.5, 0.5));
          struct k_vec d = support_direction(&random);
          if (fabs(k_dot(d, n)) < 1e-3)
            {
              continue;
            }
          struct k_vec o = k_along(aim, -3, d);
          first += ![[support_hit(a, o, d).object name] isEqual: @"p1"];
          second += ![[support_hit(b, o, d).object name] isEqual: @"w"];
        }
      [pool release];
    }
  PASS(first == 0, "a picture declared before its wall is seen: %u not",
       first);
  PASS(second == 0, "one declared after it is not: %u", second);
}

/** What shares a plane keeps its own side of it. */
static void
own_side(void)
{
  model_t *model = support_model
    ("%s polygon up { material m vertex -1 -1 0 vertex 1 -1 0 vertex 1 1 0"
     " vertex -1 1 0 }\n"
     "polygon down { material m vertex 0 0 0 vertex 0 3 0 vertex 3 3 0"
     " vertex 3 0 0 }\n"
     "plane below { material g normal 0 0 -2 point 7 7 0 }\n", materials);
  struct k_vec way = { 0, 0, -1 };

  PASS(support_hit(model, k_vec(.5, .5, 1), way).N.z == 1, "the first");
  PASS(support_hit(model, k_vec(2, 2, 1), way).N.z == -1, "the second");
  struct hit hit = support_hit(model, k_vec(5, 5, 1), way);
  PASS(hit.N.z == -1 && hit.object->number == 3, "the plane");
}

/** Flat objects that are merely near each other are not made one. */
static void
not_quite(void)
{
  model_t *model = support_model
    ("%s polygon back { material m vertex -1 -1 0 vertex 1 -1 0"
     " vertex 1 1 0 vertex -1 1 0 }\n"
     "polygon front { material m vertex -1 -1 1e-12 vertex 1 -1 1e-12"
     " vertex 1 1 1e-12 vertex -1 1 1e-12 }\n", materials);

  PASS(support_number(model, k_vec(0, 0, 3), k_vec(0, 0, -1)) == 2,
       "1e-12 in front is in front");
  PASS(support_number(model, k_vec(0, 0, -3), k_vec(0, 0, 1)) == 1,
       "and behind from behind");
  model = support_model
    ("%s plane back { material m normal 0 0 1 point 0 0 0 }\n"
     "polygon tilted { material m vertex -1 -1 0 vertex 1 -1 0"
     " vertex 1 1 1e-12 vertex -1 1 1e-12 }\n", materials);
  PASS(support_number(model, k_vec(0, 0.5, 3), k_vec(0, 0, -1)) == 2,
       "a tilt of 5e-13 is a tilt");
}

int
main(void)
{
  NSAutoreleasePool *pool = [[NSAutoreleasePool alloc] init];

  equal();
  coplanar(1, "near the origin");
  coplanar(1000, "1000 away");
  coplanar(1e6, "1e6 away");
  on_plane();
  own_side();
  not_quite();
  [pool release];
  return test_done();
}
