// lights_camera.m - stability: shadow feelers and eye rays at their edges.
// L01 to L08, C01 to C03. Lights have falloff 0 here and material m is white,
// without ambient: a point is lit exactly if its colour is not black.

#include "battery.h"

#define LIGHT "light l { falloff 0 emissivity 1 1 1 location" N3 "}\n"

static struct k_vec
color_of(const struct run *run, model_t *model, struct k_vec o,
         struct k_vec d)
{
  return [battery_ray(run, model, o, d) trace: model]->v;
}

static double
lit(const struct run *run, model_t *model, struct k_vec o, struct k_vec d)
{
  struct k_vec color = color_of(run, model, o, d);

  return color.x;
}

// L01: a light on a polygon

static void
run_L01(struct run *run)
{
  static const double offsets[] = { 0, 1e3, 1e6 };
  unsigned dark = 0, points = 0;

  for (unsigned i = 0; i < 200 / run->share; i++)
    {
      struct support_random random = support_seed(i);
      struct k_vec up = support_direction(&random), a, b, v[4];
      struct k_vec o = k_scale(support_direction(&random), offsets[i % 3]);
      battery_across(up, &a, &b);
      v[0] = k_along(k_along(o, -3, a), -3, b);
      v[1] = k_along(k_along(o, 3, a), -3, b);
      v[2] = k_along(k_along(o, 3, a), 3, b);
      v[3] = k_along(k_along(o, -3, a), 3, b);
      struct k_vec light = k_along(k_along(o, support_between(&random, -2, 2),
                                           a),
                                   support_between(&random, -2, 2), b);
      struct k_vec floor = k_along(o, -2, up);
      struct k_vec n = k_add(up, support_point(&random, .3));
      NSString *ceiling = battery_polygon(run, "ceiling", "m", "", 4, v);
      model_t *model = support_model(BATTERY_HEAD LIGHT "%s plane floor {"
                                     " material m normal" N3 "point" N3 "}",
                                     AT_V(run, light), [ceiling UTF8String],
                                     ALONG(run, n.x, n.y, n.z),
                                     AT_V(run, floor));
      for (unsigned j = 0; j < 1000; j++)
        {
          NSAutoreleasePool *pool = [[NSAutoreleasePool alloc] init];
          struct k_vec eye = k_along(o, -1, up);
          struct k_vec d = k_neg(battery_above(&random, up, .05));
          double shine = lit(run, model, eye, d);
          note_number(run, shine);
          // the plane may come up to the ceiling far off: not that part
          ray_t *ray = battery_ray(run, model, eye, d);
          [model find_closest: ray];
          struct k_vec P = battery_turn(run, k_div(ray->hit.P, run->scale));
          if (ray->hit.object && ray->hit.object->number == 2
              && k_dot(up, k_sub(P, o)) < -.001)
            {
              dark += shine == 0;
              points++;
            }
          [pool release];
        }
    }
  if (run->is_told)
    {
      PASS(dark == 0 && points > 150000, "L01 %u of %u points below a polygon"
           " with the light on it are dark", dark, points);
    }
}

/** A small square across the z axis at the height z, of half the side. */
static NSString *
blocker(const struct run *run, const char *name, double x, double z,
        double half)
{
  const struct k_vec v[4] = { { x - half, -half, z }, { x + half, -half, z },
                              { x + half, half, z }, { x - half, half, z } };

  return battery_polygon(run, name, "m", "", 4, v);
}

// L02: a light 1e-6 above the floor

static void
run_L02(struct run *run)
{
  NSString *plate = blocker(run, "plate", 2e-7, 5e-7, 1e-7);
  model_t *model = support_model(BATTERY_HEAD LIGHT "plane floor { material m"
                                 " normal 0 0 1 point 0 0 0 } %s",
                                 AT(run, 0, 0, 1e-6), [plate UTF8String]);
  // straight below; in the plate's shadow; beside it, on both sides; far
  static const double x[] = { 0, 4e-7, 7e-7, 1e-7, -4e-7, .5 };

  for (unsigned i = 0; i < 6; i++)
    {
      note_number(run, lit(run, model, k_vec(x[i] + 1, 0, 1e-7),
                           k_vec(-1, 0, -1e-7)));
    }
}

static void
test_L02(void)
{
  struct run run = battery_run("L02 low light", run_L02);
  static const int expected[] = { 1, 0, 1, 1, 1, 1 };

  for (unsigned i = 0; i < 6; i++)
    {
      PASS((run.note[i] > 0) == expected[i], "L02 point %u is %s", i,
           expected[i] ? "lit" : "in shadow");
    }
}

// L03: a light in an opaque sphere

static void
run_L03(struct run *run)
{
  model_t *model = support_model(BATTERY_HEAD LIGHT "plane floor { material m"
                                 " normal 0 0 1 point 0 0 %a } sphere s {"
                                 " material m center 0 0 0 radius %a }",
                                 AT(run, .25, .1, .2), IN(run, -2),
                                 IN(run, 1));

  for (unsigned i = 0; i < 300; i++)
    {
      struct support_random random = support_seed(i);
      struct k_vec d = support_direction(&random);
      // on the floor, on the sphere from without, and from within
      note_number(run, lit(run, model, k_vec(0, 0, -1.5),
                           k_vec(d.x, d.y, -fabs(d.z))));
      note_number(run, lit(run, model, k_scale(d, 3), k_neg(d)));
      note_number(run, lit(run, model, k_vec(.1, 0, -.1), d));
    }
}

static void
test_L03(void)
{
  unsigned shine[3] = { 0 };
  struct run run = battery_run("L03 enclosed light", run_L03);

  for (unsigned i = 0; i < NOTES / 3 * 3; i++)
    {
      shine[i % 3] += run.note[i] > 0;
    }
  PASS(shine[0] == 0, "L03 %u points of the floor are lit by a light in an"
       " opaque sphere", shine[0]);
  PASS(shine[1] == 0, "L03 %u points of its outside are", shine[1]);
  PASS(shine[2] == NOTES / 3, "L03 all %u points of its inside are (%u)",
       NOTES / 3, shine[2]);
}

// L04: the light is where the ray hits

static void
run_L04(struct run *run)
{
  const char *head = SUPPORT_CAMERA "material gray { ambient %a 0 0"
    " diffuse 1 1 1 specular .5 .5 .5 } light l { emissivity %a 1 1 location"
    N3 "falloff %d }";
  NSString *plate = blocker(run, "plate", .25, 0, 1);

  plate = [plate stringByReplacingOccurrencesOfString: @"material m"
                                           withString: @"material gray"];
  for (int falloff = 0; falloff <= 2; falloff++)
    {
      char text[500];
      snprintf(text, sizeof text, head, IN(run, 1.0), 1.0, AT(run, .25, .5, 0),
               falloff);
      model_t *model = support_model("%s plane p { material gray normal"
                                     " 0 0 1 point 0 0 0 }", text);
      struct k_vec c = color_of(run, model, k_vec(.25, .5, 2),
                                k_vec(0, 0, -1));
      note_direction(run, k_vec(c.x * SIGN(run), c.y, c.z));
      model = support_model("%s %s", text, [plate UTF8String]);
      c = color_of(run, model, k_vec(.25, .5, 2), k_vec(0, 0, -1));
      note_direction(run, k_vec(c.x * SIGN(run), c.y, c.z));
      model = support_model("%s sphere s { material gray center" N3
                            "radius %a }", text, AT(run, .25, .5, -1),
                            IN(run, 1));
      c = color_of(run, model, k_vec(.25, .5, 2), k_vec(0, 0, -1));
      note_direction(run, k_vec(c.x * SIGN(run), c.y, c.z));
    }
}

static void
test_L04(void)
{
  struct run run = battery_run("L04 light at the hit point", run_L04);

  for (unsigned i = 0; i < 9; i++)
    {
      // shadow: A + 0.1 A with A = 1 / 2; the mirror sees nothing
      PASS_NEAR(run.note[3 * i], .55, 2 * U, "L04 set-up %u: 1.1 A", i);
      PASS(run.note[3 * i + 1] == 0 && run.note[3 * i + 2] == 0,
           "L04 set-up %u: no light", i);
    }
}

// L05: a light behind the surface, or in its plane

static void
run_L05(struct run *run)
{
  static const double heights[] = { -1, -1e-9, 0, 1e-9 };

  for (unsigned i = 0; i < 4; i++)
    {
      model_t *model = support_model(BATTERY_HEAD LIGHT "plane p { material m"
                                     " normal 0 0 1 point 0 0 0 }",
                                     AT(run, 1, .5, heights[i]));
      ray_t *ray = battery_ray(run, model, k_vec(0, 0, 1), k_vec(0, 0, -1));
      note_number(run, [ray trace: model]->v.x > 0);
      note_number(run, ray->own_counters.feeler);
    }
}

static void
test_L05(void)
{
  struct run run = battery_run("L05 light behind", run_L05);

  for (unsigned i = 0; i < 4; i++)
    {
      PASS(run.note[2 * i] == (i == 3) && run.note[2 * i + 1] == (i == 3),
           "L05 light %s the surface: %s", i < 2 ? "behind" : i == 2 ? "in"
           : "in front of", i == 3 ? "lit, a feeler" : "unlit, no feeler");
    }
}

// L06 and L07: blockers near the light and near the point

static const struct
{
  const char *name;
  double z;             // of a square; or
  double center, radius;// of a sphere
  int is_lit;
} blocked[] = {
  { "L06 a square 1e-7 beyond the light", 1.0000001, 0, 0, 1 },
  { "L06 a square 1e-7 before the light", .9999999, 0, 0, 0 },
  { "L06 a square at the light", 1, 0, 0, 1 },
  { "L06 a sphere 1e-7 beyond the light", 0, 1.1000001, .1, 1 },
  { "L06 a sphere 1e-7 before the light", 0, 1.0999999, .1, 0 },
  { "L06 a sphere that touches the light", 0, 1.25, .25, 1 },
  { "L07 a square 1e-7 from the point", 1e-7, 0, 0, 0 },
  { "L07 a square 1e-12 from the point", 1e-12, 0, 0, 0 },
  { "L07 a sphere 1e-7 from the point", 0, .1000001, .1, 0 },
  { "L07 a square 1e-7 behind the point", -1e-7, 0, 0, 1 }
};

#define BLOCKED (sizeof blocked / sizeof *blocked)

static void
run_blocked(struct run *run)
{
  for (unsigned i = 0; i < BLOCKED; i++)
    {
      char text[500];
      snprintf(text, sizeof text, "sphere s { material m center" N3
               "radius %a }", AT(run, 0, 0, blocked[i].center),
               IN(run, blocked[i].radius));
      if (blocked[i].radius == 0)
        {
          NSString *square = blocker(run, "square", 0, blocked[i].z, 1e-8);
          snprintf(text, sizeof text, "%s", [square UTF8String]);
        }
      model_t *model = support_model(BATTERY_HEAD LIGHT "plane floor {"
                                     " material m normal 0 0 1"
                                     " point 0 0 0 } %s", AT(run, 0, 0, 1),
                                     text);
      // to the floor at (0 0 0) from aside, below what hangs there
      double low = blocked[i].z > 0 && blocked[i].z < 1e-6
        ? blocked[i].z * 1e6 : .2;
      low = blocked[i].center > 0 && blocked[i].center < .2 ? .001 : low;
      note_number(run, lit(run, model, k_vec(1, 0, low),
                           k_vec(-1, 0, -low)) > 0);
    }
}

// L08: a light far away is a direction. A file has up to 2^400; what is
// beyond is put into the light.

static void
test_L08(void)
{
  static const double far[] = { 1e12, 1e50, 1e100, 1e150, 1e300 };
  const struct k_vec L = { 2 / 7.0, -3 / 7.0, 6 / 7.0 };

  for (unsigned i = 0; i < 5; i++)
    {
      struct k_vec at = k_scale(L, i < 3 ? far[i] : 1);
      double worst = 0;
      model_t *model
        = support_model(BATTERY_HEAD LIGHT "sphere s { material m center"
                        " 0 0 0 radius 1 } plane p { material m normal"
                        " 0 .1 1 point 0 0 -1 }", at.x, at.y, at.z);
      light_t *light = [model->lights objectAtIndex: 0];
      light->location = k_scale(L, far[i]);
      for (unsigned j = 0; j < 1000; j++)
        {
          struct support_random random = support_seed(j);
          struct k_vec o = k_add(k_vec(0, 0, 5), support_point(&random, 2));
          ray_t *ray = support_ray(model, o, k_vec(-o.x, -o.y,
                                                   -5 - o.z));
          struct k_vec color = [ray trace: model]->v;
          double shine = k_dot(ray->hit.N, L);
          // in the sphere's shadow when the line to the light goes through
          struct k_vec P = ray->hit.P;
          double b = k_dot(P, L);
          BOOL is_dark = ray->hit.object->number == 2 && b < 0
            && k_dot(P, P) - b * b < 1;
          shine = shine > 0 && !is_dark ? shine : 0;
          worst = battery_max(worst, fabs(color.x - shine));
          worst = isfinite(color.x) ? worst : HUGE_VAL;
        }
      PASS_NEAR(worst, 0, 1e-12, "L08 a light at %g is a direction to %.2g,"
                " at most 1e-12", far[i], worst);
    }
}

// C01: cameras that are none

static void
test_C01(void)
{
  static const char *const bad[][3] = {
    { "lookat is the viewpoint", "2:8",
      "lookat 1 2 3 up 0 1 0 angle 40 viewpoint 1 2 3" },
    { "up along the view", "2:18",
      "lookat 1 2 -5 up 0 0 3 angle 40 viewpoint 1 2 3" },
    { "up against the view", "2:18",
      "lookat 4 6 15 up -1 -2 -6 angle 40 viewpoint 1 0 -3" },
    { "up 1e-9 from the view", "2:18",
      "lookat 1 2 -5 up 1e-9 0 1 angle 40 viewpoint 1 2 3" },
    { "up zero", "2:18", "lookat 1 2 -5 up 0 0 0 angle 40 viewpoint 1 2 3" },
    { "angle 0", "2:30", "lookat 1 2 -5 up 0 1 0 angle 0 viewpoint 1 2 3" },
    { "angle 180", "2:30",
      "lookat 1 2 -5 up 0 1 0 angle 180 viewpoint 1 2 3" },
    { "angle nan", "2:30",
      "lookat 1 2 -5 up 0 1 0 angle nan viewpoint 1 2 3" },
    { "angle -40", "2:30",
      "lookat 1 2 -5 up 0 1 0 angle -40 viewpoint 1 2 3" },
    { "window of no width", "2:10", "worlddim 0 1 viewpoint 0 0 1" },
    { "window of negative height", "2:12", "worlddim 1 -1 viewpoint 0 0 1" },
    { "viewpoint in the window", "2:28", "worlddim 1 1 viewpoint 0 0 0" },
    { "viewpoint behind the window", "2:28", "worlddim 1 1 viewpoint 0 0 -1" }
  };

  for (unsigned i = 0; i < sizeof bad / sizeof *bad; i++)
    {
      char text[500], place[40];
      snprintf(text, sizeof text, "camera cam { pixeldim 4 3\n%s }\n",
               bad[i][2]);
      snprintf(place, sizeof place, ":%s: error: ", bad[i][1]);
      NSString *report = support_faults(text);
      PASS(report && strstr([report UTF8String], place),
           "C01 %s: an error at %s", bad[i][0], bad[i][1]);
    }
}

// C02: pictures of one row, of one column, of one pixel

static unsigned c02_wrong, c02_pixels;
static double c02_worst;

/** The direction by the formulas of spec 2. */
static struct q_vec
pixel_direction(BOOL is_lookat, unsigned columns, unsigned rows, unsigned i,
                unsigned j)
{
  quad x = columns == 1 ? (quad)1 / 2 : (quad)i / (columns - 1);
  quad y = rows == 1 ? (quad)1 / 2 : (quad)j / (rows - 1);

  if (!is_lookat)
    {
      return q_unit(q_vec(4 * x - 1.5, 3 * y - .5, -2.25));
    }
  // angle 90: the window is 2 high, from row to row 2 / (rows - 1)
  quad pixel = rows == 1 ? 2 : (quad)2 / (rows - 1);
  return q_unit(q_vec((x - .5) * (columns == 1 ? 0 : columns - 1) * pixel,
                      (y - .5) * (rows == 1 ? 0 : 2), -1));
}

static void
run_C02(struct run *run)
{
  static const unsigned sizes[][2] = { { 1, 1 }, { 1, 100000 },
                                       { 100000, 1 }, { 640, 1 }, { 3, 2 } };

  for (unsigned k = 0; k < 10; k++)
    {
      unsigned columns = sizes[k / 2][0], rows = sizes[k / 2][1];
      BOOL is_lookat = k % 2;
      char window[300];
      if (is_lookat)
        {
          snprintf(window, sizeof window, "lookat" N3 "up 0 1 0 angle 90"
                   " viewpoint" N3, AT(run, 1.5, .5, -7.75),
                   AT(run, 1.5, .5, 2.25));
        }
      else
        {
          snprintf(window, sizeof window, "worlddim %a %a viewpoint" N3,
                   IN(run, 4), IN(run, 3), IN(run, 1.5), IN(run, .5),
                   IN(run, 2.25));
        }
      model_t *model = support_model("camera cam { pixeldim %u %u %s }",
                                     columns, rows, window);
      for (unsigned i = 0; i < columns; i++)
        {
          for (unsigned j = 0; j < rows; j++)
            {
              struct sample sample = { .column = i, .row = j };
              struct k_vec o, d;
              [model->camera ray: sample pos: &o dir: &d];
              note_direction(run, battery_turn(run, d));
              double off = q_apart(d, pixel_direction(is_lookat, columns,
                                                      rows, i, j));
              c02_worst = battery_max(c02_worst, off);
              c02_pixels++;
              if (is_lookat && columns == 1 && rows == 1)
                {
                  c02_wrong += !k_is_equal(d, k_vec(0, 0, -1));
                }
            }
        }
    }
}

static void
test_C02(void)
{
  battery_run_share("C02 sizes", run_C02, 1, 0);
  PASS(c02_wrong == 0, "C02 one pixel: the ray runs along the line of sight,"
       " bit for bit");
  PASS_NEAR(c02_worst, 0, 2 * U, "C02 %u pixels: every direction is the"
            " formula's to %.2g u, at most 2", c02_pixels, c02_worst / U);
}

// C03: the eye on what it looks at

static void
run_C03(struct run *run)
{
  const struct k_vec v[4] = { { -1, -1, 0 }, { 1, -1, 0 }, { 1, 1, 0 },
                              { -1, 1, 0 } };
  static const struct k_vec eyes[] = { { .25, .5, 0 }, { 3, .5, 0 },
                                       { 1, 1, 0 }, { 1, .25, 0 },
                                       { 0, 0, 2 }, { 2, 0, 4 } };
  model_t *model
    = support_model(SUPPORT_CAMERA "material gray { ambient %a %a %a"
                    " diffuse .5 .5 .5 specular .5 .5 .5 alpha .5 ior 1.5 }"
                    "%ssphere s { material gray center 0 0 %a radius %a }"
                    "light l { location" N3 "emissivity 1 1 1 falloff 0 }",
                    IN(run, 1), IN(run, 1), IN(run, 1),
                    [battery_polygon(run, "p", "gray", "", 4, v) UTF8String],
                    IN(run, 4), IN(run, 2), AT(run, 3, 4, 5));
  unsigned strange = 0, behind = 0;

  for (unsigned e = 0; e < 6; e++)
    {
      for (unsigned i = 0; i < 500; i++)
        {
          NSAutoreleasePool *pool = [[NSAutoreleasePool alloc] init];
          struct support_random random = support_seed(i);
          struct k_vec d = support_direction(&random);
          // a part of them in the polygon's plane, or along a side
          d.z = i % 5 == 0 ? 0 : d.z;
          d = i % 50 == 0 ? k_vec(1, 0, 0) : d;
          ray_t *ray = battery_ray(run, model, eyes[e], d);
          struct k_vec color = [ray trace: model]->v;
          // From the plane the polygon is not seen, nor from the surface of
          // the ball its own place: nothing is nearer than 1e-9.
          behind += ray->hit.object && !(ray->hit.t > IN(run, 1e-9));
          strange += !(k_norm_max(color) < 1e9)
            || (e < 4 && ray->hit.object && ray->hit.object->number == 1);
          note_direction(run, k_vec(color.x * SIGN(run), color.y, color.z));
          [pool release];
        }
    }
  if (run->is_told)
    {
      PASS(strange == 0, "C03 %u of 3000 colours are no numbers or show the"
           " polygon that the eye is in", strange);
      PASS(behind == 0, "C03 %u of 3000 eye rays hit where the eye is",
           behind);
    }
}

int
main(void)
{
  NSAutoreleasePool *pool = [[NSAutoreleasePool alloc] init];

  battery_run_share("L01 light on a polygon", run_L01, 20, 1);
  test_L02();
  test_L03();
  test_L04();
  test_L05();
  struct run run = battery_run("L06, L07 blockers", run_blocked);
  for (unsigned i = 0; i < BLOCKED; i++)
    {
      PASS(run.note[i] == blocked[i].is_lit, "%s: %s", blocked[i].name,
           blocked[i].is_lit ? "lit" : "shadow");
    }
  test_L08();
  test_C01();
  test_C02();
  battery_run("C03 eye on a surface", run_C03);
  [pool release];
  return test_done();
}
