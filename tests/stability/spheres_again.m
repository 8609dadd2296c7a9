// spheres_again.m - stability: sizes, mirrors, ties and lenses. S19 to S25.

#include "battery.h"

static const double root[3] = { 0x1p-360, 1, 0x1p360 };

// S19: as small and as large as a model may be

static void
run_S19(struct run *run)
{
  model_t *model = support_model(BATTERY_HEAD "sphere s { material m center"
                                 N3 "radius %a }", AT(run, 0, 0, 10.0),
                                 IN(run, 1.0));

  note_hit(run, battery_hit(run, model, k_vec(0, 0, 0), k_vec(0, 0, 1)));
}

static void
test_S19(void)
{
  for (int i = 0; i < 3; i++)
    {
      struct run run = battery_once(run_S19, root[i], 0, 1, 0);
      PASS_BITS(run.note[0], 9, "S19 radius 2^%d", 360 * (i - 1));
    }
}

// S20: what is no sphere

static void
test_S20(void)
{
  static const char *const wrong[] = { "0", "-1", "nan", "inf", "1e-170",
                                       "1e160" };

  for (unsigned i = 0; i < sizeof wrong / sizeof *wrong; i++)
    {
      char text[300];
      snprintf(text, sizeof text, BATTERY_HEAD
               "sphere s {\n  material m center 0 0 0\n  radius %s }\n",
               wrong[i]);
      NSString *report = support_faults(text);
      NSRange place = report ? [report rangeOfString: @":7:10:"]
        : NSMakeRange(0, 0);
      PASS(place.length > 0, "S20 radius %s is refused where it stands",
           wrong[i]);
    }
}

// S21: inside a mirror

static void
run_S21(struct run *run)
{
  model_t *model = support_model(BATTERY_HEAD "sphere s { material mirror"
                                 " center" N3 "radius %a }",
                                 AT(run, 0, 0, 0), IN(run, 1.0));
  ray_t *ray = battery_ray(run, model, k_vec(.3, .2, .1),
                           k_unit(k_vec(.5, -.7, .2)));
  double worst = 0;

  for (int bounce = 0; bounce < 1000; bounce++)
    {
      [model find_closest: ray];
      if (ray->hit.object == nil)
        {
          worst = HUGE_VAL;
          break;
        }
      worst = battery_max(worst, fabs(k_length(ray->hit.P) / run->scale - 1));
      ray = battery_spawn(ray, battery_reflected(ray), NO);
    }
  note_number(run, worst);
}

// S22: two mirrors that look at each other: what is a rounding error at first
// grows by 2 + sqrt(3) each time

static void
run_S22(struct run *run)
{
  model_t *model = support_model(BATTERY_HEAD
                                 "sphere a { material mirror center" N3
                                 "radius %a }\nsphere b { material mirror"
                                 " center" N3 "radius %a }",
                                 AT(run, 0, 0, 0), IN(run, 1.0),
                                 AT(run, 0, 0, 3.0), IN(run, 1.0));
  ray_t *ray = battery_ray(run, model, k_vec(1e-12, 0, 1.5), k_vec(0, 0, 1));
  double before = 0, growth = 0;

  for (int bounce = 0; bounce < 12 && (bounce == 0 || before != 0); bounce++)
    {
      [model find_closest: ray];
      double x = ray->hit.object ? fabs(ray->hit.P.x) : 0;
      growth = bounce ? x / before : 0;
      before = x;
      ray = battery_spawn(ray, battery_reflected(ray), NO);
    }
  note_number(run, growth);
}

// S23, S24: two spheres at the same place, two that touch

static unsigned
first_of(const char *order, struct k_vec o, struct k_vec d)
{
  char text[600] = BATTERY_HEAD;

  for (const char *c = order; *c; c++)
    {
      size_t used = strlen(text);
      double x = *c == 'l' ? -1 : *c == 'r' ? 1 : 0;
      snprintf(text + used, sizeof text - used,
               "sphere s%zu { material m center %g 0 %g radius %g }\n", used, x,
               *c == 'f' ? 50. : 0., 1.);
    }
  model_t *model = support_model("%s", text);
  id <engine_t> fast = support_fast(model, nil);
  unsigned number = support_number(model, o, d);

  return number == [fast surfaceAt: o : d].object ? number : 0;
}

static void
test_ties(void)
{
  unsigned wrong = 0;

  for (int i = 0; i < 200; i++)
    {
      struct k_vec o = k_vec(sin(i) * .5, cos(i) * .5, 5);
      wrong += first_of("ffmfffm", o, k_vec(0, 0, -1)) != 3;
    }
  PASS(wrong == 0, "S23 of spheres 3 and 7 at one place, 3 is hit by 200 rays");
  PASS(first_of("lr", k_vec(0, 0, 5), k_vec(0, 0, -1)) == 1,
       "S24 where two spheres touch, the first is hit");
  PASS(first_of("rl", k_vec(0, 0, 5), k_vec(0, 0, -1)) == 1,
       "S24 and when they are declared the other way round");
}

// S25: a ball lens

static double lens_height;

static void
run_S25(struct run *run)
{
  model_t *model = support_model(BATTERY_HEAD "sphere s { material glass"
                                 " center" N3 "radius %a }",
                                 AT(run, 0, 0, 0), IN(run, 1.0));
  ray_t *ray = battery_ray(run, model, k_vec(lens_height, 0, 5),
                           k_vec(0, 0, -1));
  struct k_vec d = ray->dir->v;

  [model find_closest: ray];
  d = shade_renew(shade_refract(d, ray->hit.N, 1.5, NULL));
  ray = battery_spawn(ray, d, YES);
  [model find_closest: ray];
  d = shade_renew(shade_refract(d, k_neg(ray->hit.N), 1 / 1.5, NULL));
  note_number(run, atan2(hypot(d.x, d.y), -d.z));
}

static void
test_S25(void)
{
  static const double expected[][2] = {
    { 1e-8, 6.666666666666667e-9 }, { .1, .066902545502669077 },
    { .5, .36752373228835387 }, { .9, .95253681241069966 },
    { .999999, 1.6793107026290379 }
  };

  for (unsigned i = 0; i < 5; i++)
    {
      lens_height = expected[i][0];
      struct run run = battery_run("S25 a ball lens", run_S25);
      // A height that is rounded turns the normal by 1/sqrt(1 - h^2) of it.
      double turns = 1 / sqrt(1 - lens_height * lens_height);
      PASS_NEAR(run.note[0], expected[i][1],
                8 * U * (lens_height < .95 ? expected[i][1] : turns),
                "S25 height %g", lens_height);
    }
}

int
main(void)
{
  NSAutoreleasePool *pool = [[NSAutoreleasePool alloc] init];
  struct run run;

  test_S19();
  test_S20();
  run = battery_run("S21 inside a mirror", run_S21);
  PASS_NEAR(run.note[0], 0, 4 * U, "S21 on the sphere after 1000 bounces");
  run = battery_run("S22 two mirrors", run_S22);
  PASS_NEAR(run.note[0], 2 + sqrt(3), 1e-3, "S22 an error grows by 2 + sqrt 3");
  test_ties();
  test_S25();
  [pool release];
  return test_done();
}
