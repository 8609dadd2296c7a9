// lens.m - depth of field: where the rays of a lens start and where they
// meet. Notes, "depth of field".

#import "support.h"
#include "test.h"

#define FSTOP 2.8
#define FOCUS 6.3

static camera_t *
camera(const char *view, const char *lens)
{
  return [[support_model("camera cam { pixeldim 9 7 %s focus 6.3 fstop 2.8"
                         " exposure 32 %s }", view, lens)->camera retain]
           autorelease];
}

static const char window[] = "worlddim 4 3 viewpoint 2 1.5 5";
static const char lookat[] = "viewpoint 1 2 3 lookat -4 3 1 up .1 1 .3"
  " angle 50";

static struct sample
random_sample(uint64_t i)
{
  struct support_random random = support_seed(i);
  struct sample s;

  s.column = 9 * support_unit(&random);
  s.row = 7 * support_unit(&random);
  s.right = support_between(&random, -0.5, 0.5);
  s.up = support_between(&random, -0.5, 0.5);
  s.u = support_between(&random, -1, 1);
  s.v = support_between(&random, -1, 1);
  return s;
}

/** All rays of a pixel meet at the distance `focus` from the viewpoint, in
    the direction of the pixel: the focal surface is a sphere. */
static void
focal_sphere(camera_t *cam, const char *what)
{
  unsigned off = 0, unit = 0, across = 0, square = 0;
  double most_u = 0, most_v = 0;
  struct k_vec eye, ahead, d0, d1, d2;
  struct sample s = { .column = 4, .row = 3 };

  // The window's axes, from the pixels round the middle.
  [cam centralRay: s pos: &eye dir: &ahead];
  s.column = 5;
  [cam centralRay: s pos: &eye dir: &d1];
  s.column = 4;
  s.row = 4;
  [cam centralRay: s pos: &eye dir: &d2];
  d0 = k_scale(ahead, k_dot(d1, ahead));
  struct k_vec right = k_unit(k_sub(d1, d0));
  struct k_vec up = k_unit(k_sub(d2, k_scale(ahead, k_dot(d2, ahead))));
  for (unsigned i = 0; i < 5000; i++)
    {
      s = random_sample(i);
      struct k_vec pos, dir, centre, middle;
      [cam ray: s pos: &pos dir: &dir];
      [cam centralRay: s pos: &centre dir: &middle];
      struct k_vec lens = k_sub(pos, centre);
      struct k_vec meet = k_along(centre, FOCUS, middle);
      struct k_vec to = k_sub(meet, pos);
      off += k_norm_max(k_sub(dir, k_unit(to))) > 16 * K_U;
      unit += fabs(k_length(dir) - 1) > 3 * K_U;
      across += fabs(k_dot(lens, ahead)) > 16 * K_U;
      double u = k_dot(lens, right) * FSTOP, v = k_dot(lens, up) * FSTOP;
      square += fabs(u - s.u) > 64 * K_U || fabs(v - s.v) > 64 * K_U;
      most_u = fmax(most_u, fabs(u));
      most_v = fmax(most_v, fabs(v));
    }
  PASS(off == 0, "%s: every ray of a pixel meets the central one at the"
       " distance focus: %u", what, off);
  PASS(unit == 0, "%s: directions are unit: %u", what, unit);
  PASS(across == 0, "%s: the lens is parallel to the window: %u", what,
       across);
  PASS(square == 0, "%s: du and dv are 1/fstop times the sample, along the"
       " window's axes: %u", what, square);
  PASS(most_u > 0.99 && most_u <= 1 + 64 * K_U && most_v > 0.99
       && most_v <= 1 + 64 * K_U, "%s: the lens is the square of half side"
       " 1/fstop", what);
}

/** aperture disc: in the disc, evenly. */
static void
disc(void)
{
  camera_t *cam = camera(window, "aperture disc");
  unsigned outside = 0, inner = 0, quarters[4] = { 0 }, off = 0;
  const unsigned n = 100000;
  double most = 0;

  for (unsigned i = 0; i < n; i++)
    {
      struct sample s = random_sample(i);
      struct k_vec pos, dir, centre, middle;
      [cam ray: s pos: &pos dir: &dir];
      [cam centralRay: s pos: &centre dir: &middle];
      struct k_vec lens = k_sub(pos, centre);
      double r = k_length(lens) * FSTOP;
      outside += r > 1 + 16 * K_U;
      most = fmax(most, r);
      inner += r < sqrt(0.5);
      quarters[(lens.x > 0) + 2 * (lens.y > 0)]++;
      struct k_vec to = k_sub(k_along(centre, FOCUS, middle), pos);
      off += k_norm_max(k_sub(dir, k_unit(to))) > 16 * K_U;
    }
  PASS(outside == 0 && most > 0.999, "disc: no point outside of the radius"
       " 1/fstop, and some near it: %u, %g", outside, most);
  // Counts of n trials: five standard deviations.
  PASS(fabs(inner - n * 0.5) < 5 * sqrt(n * 0.25), "disc: half of the points"
       " in half of its area: %u of %u", inner, n);
  for (int k = 0; k < 4; k++)
    {
      PASS(fabs(quarters[k] - n * 0.25) < 5 * sqrt(n * 0.1875),
           "disc: a quarter in quarter %d: %u", k, quarters[k]);
    }
  PASS(off == 0, "disc: the focal surface is the same sphere: %u", off);
  // The corners of the square are the four diagonals of the disc.
  struct sample corner = { 4, 3, 0, 0, 1, -1 };
  struct k_vec pos, dir;
  [cam ray: corner pos: &pos dir: &dir];
  PASS_NEAR(k_length(k_sub(pos, k_vec(2, 1.5, 5))) * FSTOP, 1, 8 * K_U,
            "disc: a corner of the square is on its rim");
  corner.u = corner.v = 0;
  [cam ray: corner pos: &pos dir: &dir];
  PASS(support_same(pos, k_vec(2, 1.5, 5)), "disc: the middle is the"
       " viewpoint");
}

/** Far focus: the rays of a pixel become parallel; a small one: they cross
    right before the lens. */
static void
extremes(void)
{
  const double focus[] = { 0x1p-398, 1e-12, 1e8, 1e100, 0x1p398 };
  unsigned off = 0;

  for (int k = 0; k < 5; k++)
    {
      camera_t *cam = support_model
        ("camera cam { pixeldim 9 7 %s focus %a fstop 2.8 exposure 3 }",
         window, focus[k])->camera;
      for (unsigned i = 0; i < 1000; i++)
        {
          struct sample s = random_sample(i);
          struct k_vec pos, dir, centre, middle;
          [cam ray: s pos: &pos dir: &dir];
          [cam centralRay: s pos: &centre dir: &middle];
          struct q_vec lens = q_scale(q_vec(s.u, s.v, 0), 1 / (quad)FSTOP);
          struct q_vec to = q_sub(q_scale(q_of(middle), focus[k]), lens);
          off += q_apart(dir, q_unit(to)) > 8 * K_U;
        }
    }
  PASS(off == 0, "a focus of 2^-398 to 2^398 is right to 8 u: %u", off);
  camera_t *cam = support_model
    ("camera cam { pixeldim 9 7 %s focus 1 fstop 0x1p398 exposure 3 }",
     window)->camera;
  struct sample s = random_sample(1);
  struct k_vec pos, dir, centre, middle;
  [cam ray: s pos: &pos dir: &dir];
  [cam centralRay: s pos: &centre dir: &middle];
  PASS(support_same(pos, centre), "a tiny lens starts at the viewpoint");
  PASS(k_norm_max(k_sub(dir, middle)) <= 4 * K_U, "and is a pinhole");
}

int
main(void)
{
  NSAutoreleasePool *pool = [[NSAutoreleasePool alloc] init];

  focal_sphere(camera(window, ""), "window");
  focal_sphere(camera(lookat, "aperture square"), "lookat");
  disc();
  extremes();
  [pool release];
  return test_done();
}
