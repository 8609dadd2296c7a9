// pictures.m - stability: whole pictures of one scene, in other units, at other
// places, along other axes; the tree and the instruction sets against asking
// everything. N04, N05, N07, N09, N10, N11, N12, N14, N16.

#include "battery.h"
#include "kernel/k_bounds.h"

/** Where the scene is: every point is turned, scaled and moved. */
struct spot
{
  double scale, offset;
  int turns;                    // of x y z to y z x
  int quarters;                 // then by 90 degrees, of x y z to -y x z
};

static char text[4000];

static void
say(const char *format, ...)
{
  size_t used = strlen(text);
  va_list arguments;

  va_start(arguments, format);
  vsnprintf(text + used, sizeof text - used, format, arguments);
  va_end(arguments);
}

static void
say_vector(struct spot at, double x, double y, double z, double offset)
{
  double v[3] = { x, y, z }, w[3];

  for (int i = 0; i < 3; i++)
    {
      w[i] = v[(i + at.turns) % 3];
    }
  for (int i = 0; i < at.quarters; i++)
    {
      double old = w[0];
      w[0] = -w[1];
      w[1] = old;
    }
  for (int i = 0; i < 3; i++)
    {
      say(" %.17g", w[i] * at.scale + offset);
    }
  say("\n");
}

static void
point(struct spot at, const char *what, double x, double y, double z)
{
  say(" %s", what);
  say_vector(at, x, y, z, at.offset);
}

static void
direction(struct spot at, const char *what, double x, double y, double z)
{
  struct spot here = { 1, 0, at.turns, at.quarters };

  say(" %s", what);
  say_vector(here, x, y, z, 0);
}

static image_t *
scene(struct spot at)
{
  static const double corners[6][2] = { { -2, -2 }, { 2, -2 }, { 2, 0 },
                                        { 0, 0 }, { 0, 2 }, { -2, 2 } };
  double s = at.scale;

  text[0] = '\0';
  say("camera c { pixeldim 32 24");
  point(at, "viewpoint", 1, 2, 7);
  point(at, "lookat", .1, .2, .3);
  direction(at, "up", 0, 1, 0);
  say(" angle 45 }\nbackground .2 .3 .4\n");
  say("material a { ambient %.17g %.17g %.17g diffuse .7 .6 .5 specular .3 .3"
      " .3 }\n", s, 2 * s, s);
  say("material g { diffuse .1 .1 .1 alpha .8 ior 1.5 }\n");
  say("light l { emissivity %.17g %.17g %.17g", 6 * s, 5 * s, 4 * s);
  point(at, "location", 3, 5, 4);
  say("}\nlight k { falloff 2 emissivity %.17g %.17g %.17g", 9 * s * s,
      s * s, 9 * s * s);
  point(at, "location", -3, 4, 2);
  say("}\nsphere s { material g radius %.17g", 1.1 * s);
  point(at, "center", .3, .4, 1);
  say("}\nsphere t { material a radius %.17g", .7 * s);
  point(at, "center", -1.5, .2, -.5);
  say("}\npolygon p { material a");
  for (int i = 0; i < 6; i++)
    {
      point(at, "vertex", corners[i][0], -1 + .1 * corners[i][1],
            -corners[i][1]);
    }
  say("}\nplane q { material a");
  direction(at, "normal", 0, 0, 1);
  point(at, "point", 0, 0, -4);
  say("}\n");
  model_t *model = support_model("%s", text);
  return support_picture(model, support_render_options());
}

/** The farthest that two pictures are apart; *wrong: by more than 1/512. */
static double
apart(image_t *a, image_t *b, unsigned *wrong)
{
  double most = 0;

  *wrong = 0;
  for (size_t i = 0; i < (size_t)[a width] * [a height]; i++)
    {
      double off = k_norm_max(k_sub(a->pixels[i].color, b->pixels[i].color));
      most = fmax(most, off);
      *wrong += off > 1. / 512;
    }
  return most;
}

static void
test_places(void)
{
  struct spot here = { 1, 0, 0, 0 };
  image_t *image = scene(here);
  unsigned wrong;

  for (int k = -9; k <= 9; k += 3)
    {
      struct spot at = { 1, 0, 0, 0 };
      for (int i = 0; i < abs(k); i++)
        {
          at.scale = k < 0 ? at.scale / 10 : at.scale * 10;
        }
      double off = apart(scene(at), image, &wrong);
      PASS_NEAR(off, 0, 1e-12, "N04 scaled by 10^%d, pixels off by", k);
    }

  static const double moves[][2] = { { 1, 2e-13 }, { 1e3, 2e-11 },
                                     { 1e6, 2e-8 }, { 1e9, 2e-5 } };
  for (int i = 0; i < 4; i++)
    {
      struct spot at = { 1, moves[i][0], 0, 0 };
      double off = apart(scene(at), image, &wrong);
      PASS_NEAR(off, 0, moves[i][1], "N05 moved by %g, pixels off by",
                moves[i][0]);
    }
  struct spot far = { 1, 1e12, 0, 0 };
  apart(scene(far), image, &wrong);
  PASS_NEAR(wrong / (32. * 24), 0, .01, "N05 moved by 1e12, share of pixels"
            " off by more than 1/512");
  for (int turn = 1; turn < 12; turn++)
    {
      struct spot at = { 1, 0, turn / 4, turn % 4 };
      PASS_NEAR(apart(scene(at), image, &wrong), 0, 1e-12,
                "N07 axes permuted %d times, then turned by 90 degrees %d"
                " times, pixels off by", turn / 4, turn % 4);
    }
}

// N09, N16: many shapes

static model_t *
crowd(void)
{
  struct support_random random = support_seed(9);
  NSMutableString *all = [NSMutableString stringWithString: @BATTERY_HEAD];

  for (int i = 0; i < 1500; i++)
    {
      struct k_vec c = support_point(&random, 5);
      if (i % 2)
        {
          [all appendFormat: @"sphere s%d { material m center %a %a %a radius"
               @" %a }\n", i, c.x, c.y, c.z, .3 * support_unit(&random) + .01];
          continue;
        }
      [all appendFormat: @"polygon p%d { material m", i];
      for (int j = 0; j < 3; j++)
        {
          struct k_vec v = k_add(c, support_point(&random, .7));
          [all appendFormat: @" vertex %a %a %a", v.x, v.y, v.z];
        }
      [all appendString: @" }\n"];
    }
  return support_model_with(support_options(), all);
}

static unsigned
unlike(id <engine_t> a, id <engine_t> b, unsigned rays)
{
  struct support_random random = support_seed(16);
  unsigned different = 0;

  for (unsigned i = 0; i < rays; i++)
    {
      struct k_vec o = support_point(&random, 7);
      struct k_vec d = support_direction(&random);
      struct surface_pixel p = [a surfaceAt: o : d], q = [b surfaceAt: o : d];
      different += p.object != q.object || p.depth != q.depth
        || !k_is_equal(p.N, q.N);
    }
  return different;
}

static void
test_crowd(void)
{
  model_t *model = crowd();
  id <engine_t> all = [[[notes_t alloc] initWithModel: model] autorelease];
  id <engine_t> base = support_fast(model, @"base");
  id <engine_t> best = support_fast(model, nil);

  PASS_NEAR(unlike(all, best, 4000), 0, 0, "N09 the tree against asking 1500"
            " shapes, of 4000 rays unlike");
  PASS_NEAR(unlike(base, best, 100000), 0, 0, "N16 base against the best"
            " instructions, of 100000 rays unlike");
}

static void
test_N11_N12(void)
{
  PASS(support_faults(BATTERY_HEAD "sphere s { material m center 1e308 0 0"
                      " radius 1 }") != nil, "N11 1e308 is refused");
  struct k_vec a = shade_ambient(k_vec(1, 0, 2), 0);
  PASS(isfinite(a.x) && a.y == 0 && isfinite(a.z),
       "N12 ambient over no distance is finite");
  a = shade_ambient(k_vec(1, 0, 2), 1e-320);
  PASS(isfinite(a.x) && a.y == 0, "N12 over next to none too");
  a = shade_ambient(k_vec(1, 0, 2), 1e308);
  PASS_NEAR(a.x, 1e-308, 1e-320, "N12 and over a very long one");
}

static void
test_N10(void)
{
  static const char *const wrong[] = { "nan", "inf", "1e400", "1e-400", "1,5",
                                       "1e", "3.5abc" };

  for (unsigned i = 0; i < sizeof wrong / sizeof *wrong; i++)
    {
      NSString *report = support_faults([[NSString stringWithFormat:
        @BATTERY_HEAD "sphere s { material m\n center 1 %s 0 radius 1 }",
        wrong[i]] UTF8String]);
      PASS(report && [report rangeOfString: @":6:11:"].length > 0,
           "N10 %s is refused where it stands", wrong[i]);
    }
  PASS(support_faults(BATTERY_HEAD "sphere s { material m center -0.0 0x1p-3 0"
                      " radius 1 }") == nil, "N10 -0.0 and 0x1p-3 are numbers");
}

/** Rays at corners, edges and faces of a box, along and across its faces. */
static void
test_N14(void)
{
  struct k_bounds box = { { -1, -2, -3 }, { 4, 5, 6 } };
  const double at[3][4] = { { -1, 1, 3, 4 }, { -2, 0, 1, 5 },
                            { -3, 0, 2, 6 } };
  unsigned missed = 0, rays = 0;

  for (int p = 0; p < 64; p++)
    {
      struct k_vec on = k_vec(at[0][p % 4], at[1][p / 4 % 4], at[2][p / 16]);
      for (int k = 0; k < 343; k++)
        {
          struct k_vec d = k_vec(k % 7 - 3, k / 7 % 7 - 3, k / 49 - 3);
          for (int zero = 0; zero < 2 && !k_is_zero(d); zero++)
            {
              // With zeros of both signs.
              d.x = d.x == 0 && zero ? -0.0 : d.x;
              d.y = d.y == 0 && zero ? -0.0 : d.y;
              d.z = d.z == 0 && zero ? -0.0 : d.z;
              struct k_vec inverse = k_vec(1 / d.x, 1 / d.y, 1 / d.z);
              missed += !k_bounds_hit(&box, k_along(on, -8, d), inverse,
                                      HUGE_VAL);
              rays++;
            }
        }
    }
  PASS_NEAR(missed, 0, 0, "N14 of %u rays at faces, edges and corners of a box"
            " missed", rays);
}

int
main(void)
{
  NSAutoreleasePool *pool = [[NSAutoreleasePool alloc] init];

  test_places();
  test_crowd();
  test_N10();
  test_N11_N12();
  test_N14();
  [pool release];
  return test_done();
}
