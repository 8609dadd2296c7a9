// planes.m - stability: where rays meet planes. P01 to P08.

#include "battery.h"

/** A plane through q with the normal n, and the ray from o along d. */
static struct hit
plane_hit(const struct run *run, struct k_vec n, struct k_vec q,
          struct k_vec o, struct k_vec d)
{
  model_t *model = support_model(BATTERY_HEAD "plane p { material m normal" N3
                                 "point" N3 "}",
                                 ALONG(run, n.x, n.y, n.z), AT_V(run, q));

  return battery_hit(run, model, o, d);
}

// P01: height 1, cosines 1e-1 to 1e-15; level, and tilted by the rotation
// (x, y) -> (.6 x + .8 y, .6 y - .8 x), which is not exact.

static double p01_level, p01_tilted;

static void
run_P01(struct run *run)
{
  for (int e = 1; e <= 15; e++)
    {
      double cosine = pow(10, -e);
      struct k_vec d = k_vec(sqrt(1 - cosine * cosine), -cosine, 0);
      struct k_vec n = k_vec(3, 4, 0), o = k_vec(.6, .8, .25);
      struct hit hit = plane_hit(run, k_vec(0, 1, 0), k_vec(0, 0, 0),
                                 k_vec(.3, 1, 0), d);
      note_hit(run, hit);
      double bound = 2 * U / cosine + 4 * U;
      double error = fabs(IN(run, 1) / cosine - hit.t) / hit.t;
      p01_level = battery_max(p01_level, error / bound);

      d = k_vec(.8 * d.x + .6 * d.y, -.6 * d.x + .8 * d.y, 0);
      hit = plane_hit(run, n, k_vec(0, 0, 0), o, d);
      note_hit(run, hit);
      // The ray's own direction, rounded as it is; the plane as in the file.
      struct q_vec D = q_unit(q_of(k_unit(d)));
      quad t = -q_dot(q_of(n), q_of(o)) / q_dot(q_of(n), D);
      error = fabs((double)((hit.t / run->scale - t) / t));
      p01_tilted = battery_max(p01_tilted, error / bound);
    }
}

static void
test_P01(void)
{
  battery_run("P01 grazing", run_P01);
  PASS_PART(p01_level, "P01 t = 1/cos to 2u/cos + 4u, level (%.2f of it)",
            p01_level);
  PASS_PART(p01_tilted, "P01 t to 2u/cos + 4u, tilted (%.2f of it)",
            p01_tilted);
}

// P02: parallel, above and in the plane

static void
run_P02(struct run *run)
{
  static const struct k_vec normals[] = { { 0, 1, 0 }, { 3, 4, 0 },
                                          { 1, -1, 1 } };
  static const struct k_vec ways[] = { { .6, 0, .8 }, { 0, 0, -1 },
                                       { 1, 1, 0 } };

  for (int i = 0; i < 3; i++)
    {
      note_hit(run, plane_hit(run, normals[i], k_vec(0, 0, 0),
                              normals[i], ways[i]));
      note_hit(run, plane_hit(run, normals[i], k_vec(0, 0, 0),
                              k_scale(ways[i], 2), ways[i]));
    }
}

static void
test_P02(void)
{
  struct run run = battery_run("P02 parallel", run_P02);

  for (unsigned i = 0; i < 6; i++)
    {
      PASS(run.note[i] == HUGE_VAL, "P02 a ray %s plane %u misses it",
           i % 2 ? "in" : "along", i / 2);
    }
}

static void
run_P03(struct run *run)
{
  note_hit(run, plane_hit(run, k_vec(0, 0, 1), k_vec(0, 0, -1e15),
                          k_vec(.1, .2, 0), k_vec(0, 0, -1)));
  note_hit(run, plane_hit(run, k_vec(1, 2, 2),
                          k_scale(k_vec(-1, -2, -2), 1e15 / 3),
                          k_vec(0, 0, 0), k_vec(-1, -2, -2)));
}

static void
test_P03(void)
{
  struct run run = battery_run("P03 far", run_P03);

  PASS_ULPS(run.note[0], 1e15, 1, "P03 a plane at 1e15");
  PASS_ULPS(run.note[5], 1e15, 1, "P03 a tilted plane at 1e15");
}

// P04: height 1 over planes far from the origin

static double p04_worst;

static void
run_P04(struct run *run)
{
  for (int e = 6; e <= 12; e += 3)
    {
      for (unsigned i = 0; i < 300 / run->share; i++)
        {
          struct support_random random = support_seed(i);
          double offset = pow(10, e);
          struct k_vec n = support_direction(&random);
          struct k_vec q = k_scale(support_direction(&random), offset);
          struct k_vec o = k_add(q, k_add(n, support_point(&random, 1)));
          if (k_dot(n, k_sub(o, q)) < .5)
            {
              continue;
            }
          struct k_vec d = k_neg(battery_above(&random, n, .01));
          struct hit hit = plane_hit(run, n, q, o, d);
          note_hit(run, hit);
          struct q_vec D = q_unit(q_of(k_unit(d)));
          quad cosine = q_dot(q_unit(q_of(n)), D);
          quad t = q_dot(q_unit(q_of(n)), q_sub(q_of(q), q_of(o))) / cosine;
          double error = (double)q_abs((hit.t / run->scale - t) / t);
          double bound = 4 * U / (double)q_abs(cosine);
          p04_worst = battery_max(p04_worst, error / bound);
        }
    }
}

static void
test_P04(void)
{
  battery_run_share("P04 translated", run_P04, 10, 1);
  PASS_PART(p04_worst, "P04 t to 4u/cos at offsets 1e6, 1e9, 1e12"
            " (%.2f of it)", p04_worst);
}

// P05: rays that leave the plane they have hit do not hit it, and where a
// second plane lies in the first they do not hit that one either.

static void
run_P05(struct run *run)
{
  unsigned again = 0, rays = 0;

  for (unsigned i = 0; i < 100; i++)
    {
      struct support_random random = support_seed(i);
      double offset = i % 11 == 0 ? 0 : pow(10, i % 10);
      struct k_vec n = support_direction(&random);
      struct k_vec q = k_scale(support_direction(&random), offset);
      model_t *model
        = support_model(BATTERY_HEAD
                        "plane p { material m normal" N3 "point" N3 "}"
                        "plane q { material m normal" N3 "point" N3 "}",
                        ALONG(run, n.x, n.y, n.z), AT_V(run, q),
                        ALONG(run, -n.x, -n.y, -n.z), AT_V(run, q));
      for (unsigned j = 0; j < 1000 / run->share; j++)
        {
          NSAutoreleasePool *pool = [[NSAutoreleasePool alloc] init];
          struct k_vec o = k_add(q, k_add(n, support_point(&random, 1)));
          struct k_vec d = battery_above(&random, n, 0);
          if (k_dot(n, k_sub(o, q)) > 0)
            {
              d = k_neg(d);
            }
          ray_t *ray = battery_ray(run, model, o, d);
          [model find_closest: ray];
          note_hit(run, ray->hit);
          ray_t *away = battery_spawn(ray, battery_reflected(ray), NO);
          [model find_closest: away];
          rays++;
          again += away->hit.object != nil;
          [pool release];
        }
    }
  note_number(run, again);
  if (run->is_told)
    {
      PASS(again == 0, "P05 %u of %u reflected rays hit the plane they leave",
           again, rays);
    }
}

// P06: the length of a normal says nothing. A file has 2^-400 to 2^400; what
// is beyond is asked of k_unit.

static void
test_P06(void)
{
  static const char *lengths[] = { "1e-30", "1e100", "0x1p-400", "0x1p400",
                                   "3" };
  const char *scene = BATTERY_HEAD "light l { location 1 2 3 emissivity"
    " 5 5 5 } plane p { material m normal 0 0 %s point 0 0 -1 }";
  image_t *one = support_picture(support_model(scene, "1"),
                                 support_render_options());

  for (unsigned i = 0; i < sizeof lengths / sizeof *lengths; i++)
    {
      image_t *other = support_picture(support_model(scene, lengths[i]),
                                       support_render_options());
      PASS(support_differences(one, other) == 0,
           "P06 normal 0 0 %s: the same picture as 0 0 1", lengths[i]);
    }
  static const double beyond[] = { 0x1p-1074, 1e-310, 1e-200, 1e200,
                                   0x1.fffffffffffffp1023 };
  for (unsigned i = 0; i < sizeof beyond / sizeof *beyond; i++)
    {
      struct k_vec n = k_unit(k_vec(0, 0, -beyond[i]));
      PASS(k_is_equal(n, k_vec(0, 0, -1)), "P06 unit of (0 0 -%g)",
           beyond[i]);
      double least = 0x1p-1000;         // below it 3 : 4 is not to be had
      if (beyond[i] > least && beyond[i] < 1e300)
        {
          n = k_unit(k_vec(3 * beyond[i], 4 * beyond[i], 0));
          PASS_NEAR(n.x, .6, 2 * U, "P06 x of unit of (3 4 0) %g",
                    beyond[i]);
          PASS_NEAR(n.y, .8, 2 * U, "P06 y of unit of (3 4 0) %g",
                    beyond[i]);
        }
    }
}

// P07: planes that coincide: the one declared first is seen

static void
run_P07(struct run *run)
{
  unsigned wrong = 0;

  for (unsigned i = 0; i < 200; i++)
    {
      struct support_random random = support_seed(i);
      struct k_vec n = support_direction(&random);
      struct k_vec q = support_point(&random, 10);
      struct k_vec a, b;
      battery_across(n, &a, &b);
      // the same point, another one of the plane, the normal turned
      struct k_vec p = k_along(k_along(q, 3, a), -2, b);
      model_t *model
        = support_model(BATTERY_HEAD
                        "plane p { material m normal" N3 "point" N3 "}"
                        "plane q { material m normal" N3 "point" N3 "}"
                        "plane r { material m normal" N3 "point" N3 "}",
                        ALONG(run, n.x, n.y, n.z), AT_V(run, q),
                        ALONG(run, -n.x, -n.y, -n.z), AT_V(run, q),
                        ALONG(run, n.x, n.y, n.z), AT_V(run, p));
      for (unsigned j = 0; j < 50; j++)
        {
          struct k_vec o = support_point(&random, 30);
          struct k_vec to = k_along(q, support_between(&random, -5, 5), a);
          struct hit hit = battery_hit(run, model, o, k_sub(to, o));
          note_hit(run, hit);
          wrong += hit.object == nil || hit.object->number != 1;
        }
    }
  if (run->is_told)
    {
      PASS(wrong == 0, "P07 %u of 10000 rays at three planes in one do not"
           " see the first", wrong);
    }
}

// P08: three mirrors at right angles send every ray back

/** Directions are exact for mirrors along the axes. `near` is how near to the
    corner rays are aimed. Rays nearer to an edge than rounding can tell start
    their second leg on both mirrors at once (spec 3: such a surface is not
    hit): none is aimed there. */
static void
corner(struct run *run, struct k_vec x, struct k_vec y, struct k_vec z,
       double near, double *worst, unsigned *lost)
{
  model_t *model
    = support_model(BATTERY_HEAD
                    "plane p { material mirror normal" N3 "point 0 0 0 }"
                    "plane q { material mirror normal" N3 "point 0 0 0 }"
                    "plane r { material mirror normal" N3 "point 0 0 0 }",
                    ALONG(run, x.x, x.y, x.z), ALONG(run, y.x, y.y, y.z),
                    ALONG(run, z.x, z.y, z.z));

  for (unsigned i = 0; i < 500; i++)
    {
      NSAutoreleasePool *pool = [[NSAutoreleasePool alloc] init];
      struct support_random random = support_seed(i);
      double a[6];
      for (int j = 0; j < 6; j++)
        {
          a[j] = support_between(&random, 1, 2);
        }
      struct k_vec o = k_along(k_along(k_scale(x, 3 * a[0]), 3 * a[1], y),
                               3 * a[2], z);
      struct k_vec to = k_along(k_along(k_scale(x, a[3] * near),
                                        a[4] * near, y), a[5] * near, z);
      // Unit to 2u: otherwise the first reflection takes that out.
      struct k_vec d = q_double(q_unit(q_sub(q_of(to), q_of(o))));
      if (fabs(k_dot(d, d) - 1) > 2 * U)
        {
          [pool release];
          continue;
        }
      d = battery_turn(run, d);
      vec_t *pos = [vec_t vec: battery_put(run, o)];
      ray_t *ray = [[(ray_t *)[ray_t alloc] init: pos : [vec_t vec: d]]
                     autorelease];
      for (int leg = 0; leg < 3; leg++)
        {
          [model find_closest: ray];
          if (ray->hit.object == nil)
            {
              ++*lost;
              break;
            }
          note_hit(run, ray->hit);
          ray = battery_spawn(ray, battery_reflected(ray), NO);
        }
      [model find_closest: ray];
      *lost += ray->hit.object != nil;
      double off = k_norm_max(k_add(ray->dir->v, d));
      *worst = battery_max(*worst, off);
      [pool release];
    }
}

static double p08_straight, p08_turned;
static unsigned p08_lost;

static void
run_P08(struct run *run)
{
  for (double near = 1; near > 1e-12; near /= 1000)
    {
      corner(run, k_vec(1, 0, 0), k_vec(0, 1, 0), k_vec(0, 0, 1), near,
             &p08_straight, &p08_lost);
      corner(run, k_unit(k_vec(1, 2, 2)), k_unit(k_vec(2, 1, -2)),
             k_unit(k_vec(2, -2, 1)), near, &p08_turned, &p08_lost);
    }
}

static void
test_P08(void)
{
  battery_run("P08 corner reflector", run_P08);
  PASS(p08_lost == 0, "P08 %u rays slipped through a corner", p08_lost);
  PASS(p08_straight == 0, "P08 mirrors along the axes: back bit for bit (%g)",
       p08_straight);
  PASS_NEAR(p08_turned, 0, 1e-14, "P08 turned mirrors: back to %g", p08_turned);
}

int
main(void)
{
  NSAutoreleasePool *pool = [[NSAutoreleasePool alloc] init];

  test_P01();
  test_P02();
  test_P03();
  test_P04();
  battery_run_share("P05 re-hit storm", run_P05, 10, 1);
  test_P06();
  battery_run("P07 planes that coincide", run_P07);
  test_P08();
  [pool release];
  return test_done();
}
