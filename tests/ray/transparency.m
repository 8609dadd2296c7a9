// transparency.m - clear surfaces: blending, Schlick's reflectance, total
// internal reflection, thin sheets. Notes, "Schlick's approximation".

#import "support.h"
#include "test.h"

// The half space z < 0 is glass; the sky is at z = 10, seen only in a mirror
// from above, and the bottom at z = -10, seen only through the glass.
#define POND(material) \
  SUPPORT_CAMERA \
  "material m { " material " }\n" \
  "material sky { ambient 8 4 2 }\n" \
  "material bottom { ambient 1 2 3 }\n" \
  "plane p { material m normal 0 0 1 point 0 0 0 }\n" \
  "plane s { material sky normal 0 0 -1 point 0 0 10 }\n" \
  "plane b { material bottom normal 0 0 1 point 0 0 -10 }\n"

static void
blend(void)
{
  // Straight down from z = 2: surface A/2, bottom at 12, sky at 12.
  struct k_vec eye = { 0, 0, 2 }, down = { 0, 0, -1 };
  model_t *model = support_model(POND("ambient 4 4 4 alpha .75"));
  ray_t *ray = support_ray(model, eye, down);
  struct k_vec c = [ray trace: model]->v;

  PASS_ULPS(c.x, 0.25 * 2 + 0.75 / 12, 4, "(1-alpha) color + alpha"
            " refracted");
  PASS_ULPS(c.z, 0.25 * 2 + 0.75 * 3 / 12, 4, "in each channel");
  PASS(ray->counters->reflection == 0, "equal indices: no reflected ray");
  PASS(ray->counters->refraction == 1, "one refracted ray");
  c = support_trace(support_model(POND("ambient 4 4 4 alpha 1")), eye, down);
  PASS_ULPS(c.x, 1 / 12.0, 1, "alpha 1: only what is behind");
  model = support_model(POND("ambient 4 4 4 alpha .5 ior 1.5"));
  ray = support_ray(model, eye, down);
  c = [ray trace: model]->v;
  PASS_ULPS(c.x, 0.5 * 2 + 0.5 * (0.96 / 12 + 0.04 * 8 / 12), 4,
            "(1-R) refracted + R reflected, R = 0.04");
  PASS(ray->counters->reflection == 1 && ray->counters->refraction == 1,
       "one ray of each kind");
  // One reflected ray for mirror and glass; ambient 4/2, no diffuse.
  model = support_model(POND("ambient 4 4 4 specular .5 1 0 alpha .5"
                             " ior 1.5"));
  ray = support_ray(model, eye, down);
  c = [ray trace: model]->v;
  PASS_ULPS(c.x, 0.5 * (0.5 * 8 / 12) + 0.5 * (0.96 / 12 + 0.04 * 8 / 12), 4,
            "mirror and glass in one");
  PASS(ray->counters->reflection == 1, "share their reflected ray");
}

/** The same pond under an angle: sin 0.6 in air is 0.4 in glass 1.5. */
static void
angles(void)
{
  double cos_t = sqrt(1 - 0.16);
  struct k_vec c = support_trace(support_model(POND("alpha 1 ior 1.5")),
                                 k_vec(0, 0, 8), k_vec(0.6, 0, -0.8));
  double R = 0.04 + 0.96 * pow(0.2, 5);

  PASS_ULPS(c.x, (1 - R) / (10 + 10 / cos_t) + R * 8 / (10 + 12.5), 8,
            "into glass: Snell's path, R by the angle outside");
  PASS_ULPS(c.z, (1 - R) * 3 / (10 + 10 / cos_t) + R * 2 / (10 + 12.5), 8,
            "the same in blue");

  // From inside, sin 0.6 in glass 1.25 is 0.75 in air.
  double out = sqrt(1 - 0.75 * 0.75), R0 = 0.25 / 2.25 * (0.25 / 2.25);
  R = R0 + (1 - R0) * pow(1 - out, 5);
  c = support_trace(support_model(POND("alpha 1 ior 1.25")),
                    k_vec(0, 0, -8), k_vec(0.6, 0, 0.8));
  PASS_ULPS(c.x, (1 - R) * 8 / (10 + 10 / out) + R * 1 / (10 + 12.5), 16,
            "out of glass: R by the angle outside, that of refraction");

  // sin 0.8 in glass 1.5 cannot get out.
  model_t *model = support_model(POND("alpha 1 ior 1.5"));
  ray_t *ray = support_ray(model, k_vec(0, 0, -6), k_vec(0.8, 0, 0.6));
  c = [ray trace: model]->v;
  PASS_ULPS(c.x, 1 / (10 + 10 / 0.6), 8, "total internal reflection: R = 1");
  PASS(ray->counters->refraction == 0 && ray->counters->reflection == 1,
       "and no refracted ray");
}

static void
glass_ball(void)
{
  // Straight through a ball: 4 to it, 2 in it, 4 to the wall behind.
  model_t *model = support_model
    (SUPPORT_CAMERA "material m { alpha 1 ior 1.5 }\n"
     "material w { ambient 1 1 1 }\n"
     "sphere s { material m center 0 0 0 radius 1 }\n"
     "plane b { material w normal 0 0 1 point 0 0 -5 }\n");
  model->max_depth = 2;
  ray_t *ray = support_ray(model, k_vec(0, 0, 5), k_vec(0, 0, -1));
  struct k_vec c = [ray trace: model]->v;

  PASS_ULPS(c.x, 0.96 * 0.96 / 10, 4, "through a ball: (1-R)^2");
  model->max_depth = 1;
  PASS(support_trace(model, k_vec(0, 0, 5), k_vec(0, 0, -1)).x == 0,
       "one generation fewer does not get out of it");

  // Off the axis by h: under asin h in, asin(h/n) inside, asin h out again;
  // its direction has then turned by twice the difference.
  model->max_depth = 2;
  for (int i = 1; i <= 9; i++)
    {
      double h = i / 10.0;
      double theta_i = asin(h), theta_t = asin(h / 1.5);
      double turn = 2 * (theta_i - theta_t);
      double z = cos(theta_i + M_PI - 2 * theta_t);     // where it gets out
      double R = 0.04 + 0.96 * pow(1 - cos(theta_i), 5);
      double in_front = 5 - cos(theta_i);
      double dis = in_front + 2 * cos(theta_t) + (5 + z) / cos(turn);
      double want = (1 - R) * (1 - R) / dis;
      if (cos(2 * theta_i) < 0)         // the reflected ray goes down too
        {
          want += R / (in_front - (5 + cos(theta_i)) / cos(2 * theta_i));
        }
      c = support_trace(model, k_vec(h, 0, 5), k_vec(0, 0, -1));
      PASS_NEAR(c.x, want, 64 * K_U * want, "a ray %.1f off the axis", h);
    }
}

/** A thin sheet: straight on, R of going in from both sides. */
static void
thin_sheet(void)
{
  model_t *model = support_model
    (SUPPORT_CAMERA "material m { alpha 1 ior 1.5 }\n"
     "material up { ambient 8 8 8 }\n"
     "material low { ambient 1 1 1 }\n"
     "polygon p { material m vertex -9 -9 0 vertex 9 -9 0 vertex 9 9 0"
     " vertex -9 9 0 }\n"
     "plane s { material up normal 0 0 -1 point 0 0 10 }\n"
     "plane b { material low normal 0 0 1 point 0 0 -10 }\n");
  double R = 0.04 + 0.96 * pow(0.2, 5);
  struct k_vec c = support_trace(model, k_vec(0, 0, 4), k_vec(3, 0, -4));

  PASS_ULPS(c.x, (1 - R) / 17.5 + R * 8 / 17.5, 16, "from above");
  c = support_trace(model, k_vec(0, 0, -4), k_vec(3, 0, 4));
  PASS_ULPS(c.x, (1 - R) * 8 / 17.5 + R / 17.5, 16, "from below, under sin"
            " 0.6: R is that of going in too");
  c = support_trace(model, k_vec(0, 0, -3), k_vec(4, 0, 3));
  R = 0.04 + 0.96 * pow(0.4, 5);
  PASS_ULPS(c.x, (1 - R) * 8 / (13 / 0.6) + R / (13 / 0.6), 16,
            "and no total reflection under sin 0.8");
  // Under water, n_i = 1.25: R0 = (.25/2.75)^2 for 1.5; a sheet of 1 reflects
  // all above sin 0.8.
  const char *water = SUPPORT_CAMERA
    "material water { alpha 1 ior 1.25 }\nmaterial m { alpha 1 ior %g }\n"
    "material up { ambient 8 8 8 }\nmaterial low { ambient 1 1 1 }\n"
    "plane w { material water normal 0 0 1 point 0 0 90 }\n"
    "polygon p { material m vertex -9 -9 0 vertex 9 -9 0 vertex 9 9 0"
    " vertex -9 9 0 }\n"
    "plane s { material up normal 0 0 -1 point 0 0 10 }\n"
    "plane b { material low normal 0 0 1 point 0 0 -10 }\n";
  double R0 = 0.25 / 2.75 * (0.25 / 2.75);
  R = R0 + (1 - R0) * pow(0.2, 5);
  c = support_trace(support_model(water, 1.5), k_vec(0, 0, 4),
                    k_vec(3, 0, -4));
  PASS_ULPS(c.x, (1 - R) / 17.5 + R * 8 / 17.5, 16, "a sheet under water");
  c = support_trace(support_model(water, 1.0), k_vec(0, 0, 2.5),
                    k_vec(12, 0, -5));
  PASS_ULPS(c.x, 8 / 32.5, 16, "a sheet of air under water reflects"
            " all of a flat ray");
  unsigned bent = 0;
  for (unsigned i = 0; i < 2000; i++)
    {
      struct support_random random = support_seed(i);
      struct k_vec o = k_vec(support_between(&random, -2, 2),
                             support_between(&random, -2, 2), 4);
      struct k_vec to = k_vec(support_between(&random, -4, 4),
                              support_between(&random, -4, 4), 0);
      ray_t *ray = support_ray(model, o, k_sub(to, o));
      [model find_closest: ray];
      // What trace: would make of it: look at the refracted ray's direction
      // by its hit of the bottom.
      ray_t *on = [(ray_t *)[ray_t alloc] init: [vec_t vec: ray->hit.P]
                                              : ray->dir
                                          from: ray through: YES];
      [model find_closest: on];
      bent += on->hit.object != support_object(model, "b");
      [on release];
    }
  PASS(bent == 0, "what goes on through a sheet does not meet it again: %u",
       bent);
}

int
main(void)
{
  NSAutoreleasePool *pool = [[NSAutoreleasePool alloc] init];

  blend();
  angles();
  glass_ball();
  thin_sheet();
  [pool release];
  return test_done();
}
