// paths.m - the rays that a ray spawns: the length of the whole path, the
// generations, and which side of which surface each starts on.

#import "support.h"
#include "test.h"

#define MIRRORS \
  SUPPORT_CAMERA \
  "material m { ambient 30 20 10 diffuse 1 1 1 specular .5 .25 1 }\n" \
  "plane floor { material m normal 0 0 1 point 0 0 0 }\n" \
  "plane ceiling { material m normal 0 0 -1 point 0 0 10 }\n"

/** A ray that has hit the floor from (0 0 5). */
static ray_t *
parent(model_t *model)
{
  ray_t *ray = support_ray(model, k_vec(0, 0, 5), k_vec(0, 0, -1));

  ray->dis = 2;
  ray->depth = 3;
  [ray trace: model];
  return ray;
}

static void
children(void)
{
  model_t *model = support_model(MIRRORS);
  ray_t *ray = parent(model);
  vec_t *P = [vec_t vec: ray->hit.P], *up = [vec_t vec: k_vec(0, 0, 1)];

  PASS(ray->dis == 7, "dis goes on from where it was");
  ray_t *child = [(ray_t *)[ray_t alloc] init: P : up from: ray through: NO];
  PASS(child->dis == 7, "a child starts with its parent's dis");
  PASS(child->depth == 4, "it is one generation on");
  PASS(child->from == ray->hit.object && !child->starts_inside,
       "it knows the surface it starts on and its side");
  PASS(child->counters == ray->counters, "and counts with its parent");
  PASS(child->hit.object == nil && child->hit.t == HUGE_VAL,
       "it has hit nothing yet");
  [child release];
  child = [(ray_t *)[ray_t alloc] init: P : up from: ray through: YES];
  PASS(child->starts_inside, "through the surface it is on the other side");
  [child release];
  ray_t *plain = [(ray_t *)[ray_t alloc] init: P : up];
  PASS(plain->dis == 0 && plain->depth == 0 && plain->from == nil
       && plain->media == nil && plain->counters == &plain->own_counters,
       "init: pos : dir makes an eye ray in air");
  PASS([plain->pos isEqual: P] && plain->dir == up, "from pos along dir");
  [plain release];
}

/** Straight up and down between two mirrors from the middle: distances 5, 15,
    25 … and the colour is a sum of ambient over each. */
static void
generations(void)
{
  for (unsigned depth = 0; depth <= 9; depth++)
    {
      model_t *model = support_model(MIRRORS);
      double x = 0, y = 0, z = 0;
      model->max_depth = depth;
      for (unsigned g = 0; g <= depth; g++)
        {
          double dis = 5 + 10 * g;
          x += pow(0.5, g) * 30 / dis;
          y += pow(0.25, g) * 20 / dis;
          z += 10 / dis;
        }
      struct k_vec c = support_trace(model, k_vec(0, 0, 5),
                                     k_vec(0, 0, -1));
      PASS_ULPS(c.x, x, depth + 2, "max_depth %u shades %u generations",
                depth, depth + 1);
      PASS_ULPS(c.y, y, depth + 2, "green");
      PASS_ULPS(c.z, z, depth + 2, "blue, where mirrors lose nothing");
    }
  PASS(support_model(MIRRORS)->max_depth == 5, "max_depth is 5 unless asked"
       " otherwise");
}

/** A zigzag through a mirror, a thin sheet and a glass plate: dis is the
    length of all of it. */
static void
distance(void)
{
  model_t *model = support_model
    (SUPPORT_CAMERA "material mirror { specular 1 1 1 }\n"
     "material sheet { alpha 1 }\n"
     "material wall { ambient 1 1 1 }\n"
     "plane m { material mirror normal 0 0 1 point 0 0 0 }\n"
     "polygon s { material sheet vertex 5 -9 -9 vertex 5 9 -9 vertex 5 9 9"
     " vertex 5 -9 9 }\n"
     "plane w { material wall normal -1 0 0 point 14 0 0 }\n");
  // From (0 0 8) along (3 0 -4)/5 to (6 0 0)? No: the sheet comes first, at
  // x = 5; then the mirror at (6 0 0), then the wall at x = 14.
  struct k_vec c = support_trace(model, k_vec(0, 0, 8), k_vec(3, 0, -4));
  PASS_NEAR(1 / c.x, 14 / 0.6, 64 * K_U, "through a sheet, off a mirror, to"
            " a wall");

  // Two mirrors at right angles send a ray back where it came from.
  model = support_model
    (SUPPORT_CAMERA "material mirror { specular 1 1 1 }\n"
     "material wall { ambient 1 1 1 }\n"
     "plane a { material mirror normal 0 0 1 point 0 0 0 }\n"
     "plane b { material mirror normal 1 0 0 point 0 0 0 }\n"
     "plane w { material wall normal 0 0 -1 point 0 0 8 }\n");
  ray_t *ray = support_ray(model, k_vec(7, 0, 4), k_vec(-3, 0, -4));
  struct k_vec d = [ray trace: model]->v;
  // Down to (4 0 0), 5; to (0 0 16/3)? That is below the wall: 20/3 on; then
  // up to z = 8: (8 - 16/3)/.8.
  PASS_NEAR(1 / d.x, 5 + 20 / 3.0 + (8 - 16 / 3.0) / 0.8, 64 * K_U,
            "off two mirrors to a wall");
  PASS(ray->counters->reflection == 2, "two reflected rays");
  PASS(ray->dis == 5, "the first ray's own dis ends at its hit");
}

/** Through n sheets of nothing: a wall behind them is seen while n does not
    pass max_depth. */
static void
sheets(void)
{
  for (unsigned n = 1; n <= 4; n++)
    {
      NSMutableString *text = [NSMutableString stringWithUTF8String:
        SUPPORT_CAMERA "background 9 9 9 material sheet { alpha 1 }\n"
        "material wall { ambient 10 10 10 }\n"
        "plane w { material wall normal 0 0 1 point 0 0 -10 }\n"];
      for (unsigned i = 0; i < n; i++)
        {
          [text appendFormat: @"polygon s%u { material sheet vertex -9 -9 -%u"
            @" vertex 9 -9 -%u vertex 0 9 -%u }\n", i, i, i, i];
        }
      model_t *model = support_model_with(support_options(), text);
      model->max_depth = 2;
      double c = support_trace(model, k_vec(0, 0, 0.25), k_vec(0, 0, -1)).x;
      if (n <= 2)
        {
          PASS_ULPS(c, 10 / 10.25, 4, "behind %u sheets, max_depth 2", n);
        }
      else
        {
          PASS(c == 0, "behind %u sheets, max_depth 2: black", n);
        }
    }
}

/** Reflected rays leave on the side they came to, however flat: none hits the
    surface it starts on. */
static void
sides(void)
{
  model_t *model = support_model
    (SUPPORT_CAMERA "background 1 1 1 material m { specular 1 1 1 }\n"
     "plane p { material m normal 1 2 3 point 100 0 0 }\n");
  model_t *ball = support_model
    (SUPPORT_CAMERA "background 1 1 1 material m { specular 1 1 1 }\n"
     "sphere s { material m center 5 6 7 radius 3 }\n");
  unsigned caught = 0, hits = 0;

  for (unsigned i = 0; i < 20000; i++)
    {
      NSAutoreleasePool *pool = [[NSAutoreleasePool alloc] init];
      struct support_random random = support_seed(i);
      struct k_vec n = k_unit(k_vec(1, 2, 3));
      struct k_vec along = k_unit(k_cross(n, support_direction(&random)));
      double flat = exp2(support_between(&random, -40, 0));
      struct k_vec o = k_add(k_vec(100, 0, 0), k_scale(n, flat));
      ray_t *ray = support_ray(model, o, k_along(along, -flat, n));
      struct k_vec c = [ray trace: model]->v;
      hits += ray->hit.object != nil;
      caught += ray->counters->reflection != 1 || c.x != 1;
      // At the ball: aimed at its outline or just inside of it.
      struct k_vec N = support_direction(&random);
      along = k_unit(k_cross(N, support_direction(&random)));
      o = k_along(k_vec(5, 6, 7), 3 * (1 - flat / 2), N);
      ray = support_ray(ball, k_along(o, -20, along), along);
      c = [ray trace: ball]->v;
      hits += ray->hit.object != nil;
      caught += c.x != 1;
      [pool release];
    }
  PASS(hits > 39900, "most rays hit: %u", hits);
  PASS(caught == 0, "no reflected ray hits the surface it leaves: %u",
       caught);
}

int
main(void)
{
  NSAutoreleasePool *pool = [[NSAutoreleasePool alloc] init];

  children();
  generations();
  distance();
  sheets();
  sides();
  [pool release];
  return test_done();
}
