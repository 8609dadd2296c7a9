// polygons_again.m - stability: large, far, edge-on and coinciding polygons.
// G13 to G20.

#include "battery.h"

static const struct k_vec ell[6] = {
  { 0, 0, 0 }, { 2, 0, 0 }, { 2, 1, 0 }, { 1, 1, 0 }, { 1, 2, 0 }, { 0, 2, 0 }
};

static int
in_ell(double x, double y)
{
  return x > 0 && y > 0 && ((x < 2 && y < 1) || (x < 1 && y < 2));
}

// G13: 10^4 corners

static void
run_G13(struct run *run)
{
  enum { N = 10000 };
  struct k_vec *v = malloc(N * sizeof *v);
  struct support_random random = { 13 };
  unsigned wrong = 0;

  for (int i = 0; i < N; i++)
    {
      double a = 2 * M_PI * i / N;
      v[i] = k_vec(cos(a), sin(a), 0);
    }
  model_t *model = support_model(BATTERY_HEAD "%s",
                                 [battery_polygon(run, "p", "m", "", N, v)
                                   UTF8String]);
  polygon_t *polygon = [model->objects lastObject];
  for (unsigned i = 0; i < 4000 / run->share; i++)
    {
      double a = 2 * M_PI * support_unit(&random);
      double r = i % 2 ? 1 + 1e-9 + support_unit(&random)
        : (1 - 1e-7) * sqrt(support_unit(&random));
      struct hit hit = battery_hit(run, model, k_vec(r * cos(a), r * sin(a), 3),
                                   k_vec(0, 0, -1));
      wrong += (hit.object != nil) != (i % 2 == 0);
    }
  note_number(run, wrong);
  note_number(run, hypot(polygon->plane.n.x, polygon->plane.n.y));
  free(v);
}

// G14: far from the origin, where the corners are still what they were

static void
test_G14(void)
{
  for (double offset = 1e6; offset <= 1e12; offset *= 1e3)
    {
      struct k_vec v[6];
      struct support_random random = { 14 };
      struct run run = { .scale = 1 };
      unsigned wrong = 0;
      for (int i = 0; i < 6; i++)
        {
          v[i] = k_add(ell[i], k_vec(offset, -offset, offset));
        }
      model_t *model = support_model(BATTERY_HEAD "%s",
                                     [battery_polygon(&run, "p", "m", "", 6, v)
                                       UTF8String]);
      id <engine_t> fast = support_fast(model, nil);
      for (int i = 0; i < 5000; i++)
        {
          double x = ((int)(support_unit(&random) * 768) - 128 + .5) / 256;
          double y = ((int)(support_unit(&random) * 768) - 128 + .5) / 256;
          struct k_vec o = k_vec(x + offset, y - offset, offset + 4);
          struct surface_pixel s = [fast surfaceAt: o : k_vec(0, 0, -1)];
          wrong += (s.object != 0) != in_ell(x, y)
            || (s.object && s.depth != 4)
            || support_number(model, o, k_vec(0, 0, -1)) != s.object;
        }
      PASS(wrong == 0, "G14 an L %g away: %u of 5000 rays wrong", offset,
           wrong);
    }
}

// G15: seen from the side

static void
run_G15(struct run *run)
{
  static const struct k_vec flat[4] = { { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 },
                                        { 0, 1, 0 } };
  static const struct k_vec up[4] = { { 1, 0, 0 }, { 1, 1, 0 }, { 1, 1, 1 },
                                      { 1, 0, 1 } };
  static const struct k_vec down[4] = { { 1, 0, 0 }, { 1, 1, 0 },
                                        { 1, 1, -1 }, { 1, 0, -1 } };
  model_t *model = support_model(BATTERY_HEAD "%s%s%s",
    [battery_polygon(run, "f", "m", "", 4, flat) UTF8String],
    [battery_polygon(run, "u", "m", "", 4, up) UTF8String],
    [battery_polygon(run, "d", "m", "", 4, down) UTF8String]);
  unsigned wrong = 0;

  for (int i = 1; i < 100; i++)
    {
      struct hit hit = battery_hit(run, model, k_vec(-1, i / 100., 0),
                                   k_vec(1, 0, 0));
      wrong += hit.object == nil || hit.object->number == 1
        || hit.t != IN(run, 2.0);
    }
  note_number(run, wrong);
}

// G16: a corner in the middle of an edge is no shared corner

static void
test_G16(void)
{
  NSString *report = support_faults(BATTERY_HEAD
    "polygon a { material glass solid s vertex 0 0 0 vertex 1 0 0"
    " vertex 0 1 0 }\n"
    "polygon b { material glass solid s vertex 0 0 0 vertex 0 1 0"
    " vertex 0 0 1 }\n"
    "polygon c { material glass solid s vertex 0 0 0 vertex 0 0 1"
    " vertex 1 0 0 }\n"
    "polygon d { material glass solid s vertex 1 0 0 vertex .5 .5 0"
    " vertex 0 0 1 }\n"
    "polygon e { material glass solid s vertex .5 .5 0 vertex 0 1 0"
    " vertex 0 0 1 }\n");

  PASS(report && [report rangeOfString: @"open"].length
       + [report rangeOfString: @"edge"].length > 0,
       "G16 a solid with a corner in the middle of an edge is open");
}

// G17: two polygons in one plane that is not along the axes

static struct k_vec
on_plane(double a, double b)
{
  return k_vec(a, b, .3 * a + .7 * b - 1);
}

static void
test_G17(void)
{
  struct run run = { .scale = 1 };
  struct k_vec p[4] = { on_plane(-1, -1), on_plane(1.1, -1.2),
                        on_plane(1.3, 1), on_plane(-.9, 1.4) };
  struct k_vec q[3] = { on_plane(-1.3, .1), on_plane(.7, -1.9),
                        on_plane(.3, 1.7) };
  unsigned wrong = 0;

  for (int swapped = 0; swapped < 2; swapped++)
    {
      NSString *a = battery_polygon(&run, "p", "m", "", 4, p);
      NSString *b = battery_polygon(&run, "q", "m", "", 3, q);
      model_t *model = support_model(BATTERY_HEAD "%s%s",
                                     [swapped ? b : a UTF8String],
                                     [swapped ? a : b UTF8String]);
      id <engine_t> fast = support_fast(model, nil);
      struct support_random random = { 17 };
      for (int i = 0; i < 4000; i++)
        {
          // In both of them.
          struct k_vec at = on_plane(.6 * support_unit(&random) - .4,
                                     .6 * support_unit(&random) - .4);
          struct k_vec o = k_add(at, k_scale(support_direction(&random), 9));
          struct k_vec d = k_unit(k_sub(at, o));
          wrong += support_number(model, o, d) != 1
            || [fast surfaceAt: o : d].object != 1;
        }
    }
  PASS(wrong == 0, "G17 the one declared first, %u of 8000 rays not", wrong);
}

// G18: plates that all but touch

static void
test_G18(void)
{
  for (int k = 0; k < 3; k++)
    {
      double gap = (k == 0 ? 16 : k == 1 ? 64 : 1024) * U * 16;
      model_t *model = support_model(BATTERY_HEAD
        "polygon back { material m vertex -9 -9 -%a vertex 9 -9 -%a"
        " vertex 9 9 -%a vertex -9 9 -%a }\n"
        "polygon front { material m vertex -9 -9 -1 vertex 9 -9 -1"
        " vertex 9 9 -1 vertex -9 9 -1 }\n", 1 + gap, 1 + gap, 1 + gap,
        1 + gap);
      id <engine_t> fast = support_fast(model, nil);
      struct support_random random = { 18 };
      unsigned wrong = 0, unlike = 0;
      for (int i = 0; i < 4000; i++)
        {
          struct k_vec o = k_vec(support_unit(&random),
                                 support_unit(&random), 5);
          struct k_vec d = k_unit(k_vec(support_unit(&random) - .5,
                                        support_unit(&random) - .5, -1));
          unsigned number = support_number(model, o, d);
          wrong += number != 2;
          unlike += number != [fast surfaceAt: o : d].object;
        }
      // Nearer than a plane is known they are one: the first declared then.
      PASS(unlike == 0 && (wrong == 0 || (k == 0 && wrong == 4000)),
           "G18 plates %g apart, seen from 6 away: %u of 4000 wrong", gap,
           wrong);
    }
}

// G19: from another corner, the other way round

static void
run_G19(struct run *run)
{
  struct support_random random = { 19 };
  unsigned wrong = 0;

  for (int start = 0; start < 6; start++)
    {
      for (int way = -1; way <= 1; way += 2)
        {
          struct k_vec v[6];
          for (int i = 0; i < 6; i++)
            {
              v[i] = ell[(start + way * i + 12) % 6];
              v[i].z = .3 * v[i].x - .2 * v[i].y;
            }
          struct k_vec w[6];
          for (int i = 0; i < 6; i++)
            {
              w[i] = k_vec(ell[i].x, ell[i].y,
                           .3 * ell[i].x - .2 * ell[i].y);
            }
          model_t *a = support_model(BATTERY_HEAD "%s",
            [battery_polygon(run, "p", "m", "", 6, v) UTF8String]);
          model_t *b = support_model(BATTERY_HEAD "%s",
            [battery_polygon(run, "p", "m", "", 6, w) UTF8String]);
          for (int i = 0; i < 100; i++)
            {
              struct k_vec o = k_vec(3 * support_unit(&random) - .5,
                                     3 * support_unit(&random) - .5, 4);
              struct hit h = battery_hit(run, a, o, k_vec(.1, .05, -1));
              struct hit g = battery_hit(run, b, o, k_vec(.1, .05, -1));
              wrong += (h.object != nil) != (g.object != nil)
                || (h.object
                    && (fabs(h.t - g.t) > 8 * U * g.t
                        || 1 - fabs(k_dot(h.N, g.N)) > 4 * U));
            }
        }
    }
  note_number(run, wrong);
}

// G20: a corner of four squares exactly on the ray

static void
test_G20(void)
{
  model_t *model = support_model(BATTERY_HEAD
    "polygon a { material m vertex 0 0 0 vertex 1 0 0 vertex 1 1 0"
    " vertex 0 1 0 }\n"
    "polygon b { material m vertex 0 0 .25 vertex 0 1 .25 vertex -1 1 .25"
    " vertex -1 0 .25 }\n"
    "polygon c { material m vertex 0 0 .5 vertex -1 0 .5 vertex -1 -1 .5"
    " vertex 0 -1 .5 }\n"
    "polygon d { material m vertex 0 0 .75 vertex 0 -1 .75 vertex 1 -1 .75"
    " vertex 1 0 .75 }\n");
  unsigned hits = 0;

  for (unsigned i = 0; i < 4; i++)
    {
      // From just above each: is it the one that has the corner?
      hits += support_number(model, k_vec(0, 0, i * .25 + .125),
                             k_vec(0, 0, -1)) == i + 1;
    }
  PASS(hits == 1, "G20 a corner that four squares share belongs to one");
}

int
main(void)
{
  NSAutoreleasePool *pool = [[NSAutoreleasePool alloc] init];
  struct run run = battery_run_share("G13 10^4 corners", run_G13, 4, 0);

  PASS_NEAR(run.note[0], 0, 0, "G13 of 4000 points wrong");
  PASS_NEAR(run.note[1], 0, 1e-14, "G13 the normal");
  test_G14();
  run = battery_run("G15 edge-on", run_G15);
  PASS_NEAR(run.note[0], 0, 0, "G15 not hit; behind it one of two that share"
            " the edge, of 99 rays wrong");
  test_G16();
  test_G17();
  test_G18();
  run = battery_run("G19 another start", run_G19);
  PASS_NEAR(run.note[0], 0, 0, "G19 of 1200 rays otherwise");
  test_G20();
  [pool release];
  return test_done();
}
