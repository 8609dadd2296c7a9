// pixels.m - the ray of every pixel against the formula of the window, in 113
// bits: the default camera and the one with lookat.

#import "support.h"
#include "trig.h"
#include "test.h"

struct view
{
  unsigned columns, rows;
  double width, height;
  struct k_vec eye;
};

static camera_t *
camera(const char *format, ...)
{
  char text[1000];
  va_list arguments;

  va_start(arguments, format);
  vsnprintf(text, sizeof text, format, arguments);
  va_end(arguments);
  return [[support_model("camera cam { %s }", text)->camera retain]
           autorelease];
}

/** Point and direction for a place in the window: three roundings of the
    point, one of the difference and those of unit. */
static unsigned
window_errors(struct view v)
{
  camera_t *cam = camera("pixeldim %u %u worlddim %a %a viewpoint %a %a %a",
                         v.columns, v.rows, v.width, v.height,
                         v.eye.x, v.eye.y, v.eye.z);
  unsigned wrong = 0;
  unsigned di = v.columns / 50 + 1, dj = v.rows / 50 + 1;

  for (unsigned i = 0; i < v.columns; i += di)
    {
      for (unsigned j = 0; j < v.rows; j += dj)
        {
          struct sample s = { .column = i, .row = j };
          struct k_vec o, d;
          [cam ray: s pos: &o dir: &d];
          quad x = v.columns == 1 ? (quad)v.width / 2
            : (quad)v.width * i / (v.columns - 1);
          quad y = v.rows == 1 ? (quad)v.height / 2
            : (quad)v.height * j / (v.rows - 1);
          struct q_vec to = q_sub(q_vec(x, y, 0), q_of(v.eye));
          double size = v.width + v.height + k_norm1(v.eye);
          double length = q_sqrt(q_dot(to, to));
          wrong += !support_same(o, v.eye);
          wrong += q_apart(d, q_unit(to)) > 4 * K_U * (1 + size / length);
          wrong += fabs(k_length(d) - 1) > 3 * K_U;
        }
    }
  return wrong;
}

static void
window(void)
{
  const struct view views[] = {
    { 512, 384, 5.12, 3.84, { 2.56, 2, 5 } },
    { 9, 7, 2, 2, { 1, 1, 5 } },
    { 2, 2, 1, 3, { -4, 9, 0.01 } },
    { 1, 1, 3, 2, { 1, 1, 1 } },
    { 1, 33, 3, 2, { 1, 1, 1 } },
    { 33, 1, 3, 2, { 1, 1, 1 } },
    { 1, 100000, 4, 2, { 0, 0, 7 } },
    { 100000, 1, 4, 2, { 0, 0, 7 } },
    { 640, 480, 0x1p-200, 0x1p-201, { 0x1p-202, 0, 0x1p-200 } },
    { 640, 480, 0x1p200, 0x1p201, { 0x1p202, 0, 0x1p200 } }
  };

  for (unsigned k = 0; k < sizeof views / sizeof *views; k++)
    {
      PASS(window_errors(views[k]) == 0, "%u x %u, window %g x %g",
           views[k].columns, views[k].rows, views[k].width, views[k].height);
    }

  camera_t *cam = camera("pixeldim 3 3 worlddim 2 4 viewpoint 1 2 1");
  struct k_vec o, d;
  [cam ray: (struct sample){ .column = 0, .row = 0 } pos: &o dir: &d];
  PASS(d.x < 0 && d.y < 0 && d.z < 0, "column 0 is on the left, row 0 at"
       " the bottom");
  [cam ray: (struct sample){ .column = 1, .row = 1 } pos: &o dir: &d];
  PASS(support_same(d, k_vec(0, 0, -1)), "the middle pixel looks straight"
       " on");
  [cam ray: (struct sample){ .column = 2, .row = 2 } pos: &o dir: &d];
  PASS(d.x == 1 / sqrt(6) && d.y == 2 / sqrt(6), "the last pixel is the"
       " window's corner");
  PASS(cam->exposure == 1 && !cam->has_lens, "without a lens it is a"
       " pinhole");
}

/** The window at distance 1, from the same description. */
static unsigned
lookat_errors(unsigned columns, unsigned rows, struct k_vec eye,
              struct k_vec there, struct k_vec up, double angle)
{
  camera_t *cam = camera("pixeldim %u %u viewpoint %a %a %a lookat %a %a %a"
                         " up %a %a %a angle %a", columns, rows,
                         eye.x, eye.y, eye.z, there.x, there.y, there.z,
                         up.x, up.y, up.z, angle);
  unsigned wrong = 0;
  struct q_vec ahead = q_unit(q_sub(q_of(there), q_of(eye)));
  struct q_vec u = q_unit(q_of(up));
  struct q_vec right = q_cross(ahead, u);
  // How well the axes are known: eye and lookat as given, up nearly ahead.
  double across = q_sqrt(q_dot(right, right));
  right = q_unit(right);
  struct q_vec top = q_cross(right, ahead);
  double half = tan(angle / 2 * (M_PI / 180));

  for (unsigned i = 0; i < columns; i += columns / 20 + 1)
    {
      for (unsigned j = 0; j < rows; j += rows / 20 + 1)
        {
          struct sample s = { .column = i, .row = j };
          struct k_vec o, d;
          [cam ray: s pos: &o dir: &d];
          // Rows 0 and rows-1 are at -half and +half; square pixels.
          quad pixel = 2 * (quad)half / (rows == 1 ? 1 : rows - 1);
          quad x = columns == 1 ? 0 : (i - (quad)(columns - 1) / 2) * pixel;
          quad y = rows == 1 ? 0 : (j - (quad)(rows - 1) / 2) * pixel;
          struct q_vec want
            = q_unit(q_add(ahead, q_add(q_scale(right, x),
                                        q_scale(top, y))));
          // tan of a double is off by a few ulps, steep near 180 degrees:
          // the direction hardly feels it there.
          wrong += q_apart(d, want) > 16 * K_U * (1 + 1 / across);
          wrong += !support_same(o, eye);
          wrong += fabs(k_length(d) - 1) > 3 * K_U;
        }
    }
  return wrong;
}

static void
lookat(void)
{
  const struct k_vec y = { 0, 1, 0 };
  unsigned wrong = 0;

  PASS(lookat_errors(64, 48, k_vec(0, 0, 5), k_vec(0, 0, 0), y, 40) == 0,
       "lookat straight on");
  PASS(lookat_errors(64, 48, k_vec(1, 2, 3), k_vec(-4, 0.5, 9),
                     k_vec(0.2, 7, 0.1), 90) == 0, "lookat, aslant, 90");
  PASS(lookat_errors(1, 1, k_vec(1, 2, 3), k_vec(4, 5, 6), y, 60) == 0,
       "one pixel");
  PASS(lookat_errors(1, 9, k_vec(1, 2, 3), k_vec(4, 5, 6), y, 60) == 0,
       "one column");
  PASS(lookat_errors(9, 1, k_vec(1, 2, 3), k_vec(4, 5, 6), y, 60) == 0,
       "one row: pixels of the height of two");
  for (unsigned k = 0; k < 300; k++)
    {
      NSAutoreleasePool *pool = [[NSAutoreleasePool alloc] init];
      struct support_random random = support_seed(k);
      double size = exp2(support_between(&random, -100, 100));
      struct k_vec eye = k_scale(support_point(&random, 1), size);
      struct k_vec to = k_scale(support_direction(&random), size);
      struct k_vec up = k_scale(support_direction(&random),
                                exp2(support_between(&random, -100, 100)));
      double angle = support_between(&random, 0.001, 179);
      struct k_vec there = k_add(eye, to);
      wrong += lookat_errors(1 + (unsigned)(40 * support_unit(&random)),
                             1 + (unsigned)(40 * support_unit(&random)),
                             eye, there, up, angle);
      [pool release];
    }
  PASS(wrong == 0, "random views: %u", wrong);

  // The same view as a window: z = 0 seen from z = 5 is 10 tan(angle/2) high.
  camera_t *a = camera("pixeldim 5 5 viewpoint 0 0 5 lookat 0 0 0 up 0 9 0"
                       " angle 90");
  struct k_vec o, d;
  [a ray: (struct sample){ .column = 4, .row = 4 } pos: &o dir: &d];
  PASS_NEAR(d.x, 1 / sqrt(3), 4 * K_U, "90 degrees from the top row to the"
            " bottom row, and square pixels (x)");
  PASS_NEAR(d.y, 1 / sqrt(3), 4 * K_U, "y");
  PASS_NEAR(d.z, -1 / sqrt(3), 4 * K_U, "z");
  [a ray: (struct sample){ .column = 2, .row = 2 } pos: &o dir: &d];
  PASS(support_same(d, k_vec(0, 0, -1)), "the middle is the line of sight");
}

static void
tangents(void)
{
  unsigned wrong = 0;

  PASS(trig_tan_degrees(45) == 1, "tan 45 is 1");
  for (unsigned k = 0; k < 20000; k++)
    {
      struct support_random random = support_seed(k);
      double degrees = k < 10000 ? support_between(&random, 1e-6, 90)
        : exp2(support_between(&random, -30, 6));
      double want = tan(degrees * (M_PI / 180));
      // One rounding of the angle is worth 1 / sin cos of it.
      double x = degrees * (M_PI / 180);
      wrong += fabs(trig_tan_degrees(degrees) - want)
        > (8 + 4 * x / (sin(x) * cos(x))) * K_U * want;
    }
  PASS(wrong == 0, "tangents agree with libm's: %u", wrong);
  wrong = 0;
  for (unsigned k = 0; k < 20000; k++)
    {
      struct support_random random = support_seed(k);
      double x = support_between(&random, -TRIG_PI / 4, TRIG_PI / 4);
      wrong += fabs(trig_sin(x) - sin(x)) > 3 * K_U * fabs(sin(x));
      wrong += fabs(trig_cos(x) - cos(x)) > 3 * K_U;
    }
  PASS(wrong == 0, "so do sines and cosines: %u", wrong);
}

static void
places(void)
{
  camera_t *cam = camera("pixeldim 3 5 worlddim 2 4 viewpoint 1 2 1");
  struct k_vec o, d, e;

  [cam ray: (struct sample){ .column = 0, .row = 3, .right = 0.5,
                             .up = -0.25 } pos: &o dir: &d];
  e = k_unit(k_sub(k_vec(0.5, 2.75, 0), k_vec(1, 2, 1)));
  PASS(k_norm_max(k_sub(d, e)) <= 4 * K_U, "a place in the pixel is in"
       " spacings of pixels");
  cam = camera("pixeldim 1 1 worlddim 2 4 viewpoint 1 2 1");
  [cam ray: (struct sample){ .right = 0.5, .up = -0.5 } pos: &o dir: &d];
  e = k_unit(k_sub(k_vec(2, 0, 0), k_vec(1, 2, 1)));
  PASS(k_norm_max(k_sub(d, e)) <= 4 * K_U, "a single pixel is as large as"
       " the spacing of two: all of the window");
  cam = camera("pixeldim 9 9 worlddim 2 4 viewpoint 1 2 1");
  [cam resizeTo: 3 : 5];
  [cam ray: (struct sample){ .column = 2, .row = 1 } pos: &o dir: &d];
  e = k_unit(k_sub(k_vec(2, 1, 0), k_vec(1, 2, 1)));
  PASS(cam->columns == 3 && cam->rows == 5
       && k_norm_max(k_sub(d, e)) <= 4 * K_U, "resizeTo: keeps the window");
}

static void
faults(void)
{
#define CAMERA(text) "camera c { pixeldim 4 4 " text " }"
#define LOOK "viewpoint 1 2 3 lookat 4 5 6 up 0 1 0 angle 40 "
  PASS(support_faults(CAMERA(LOOK)) == nil, "a camera with lookat");
  PASS(support_faults(CAMERA("viewpoint 0 0 1 worlddim 1 1")) == nil,
       "a camera with a window");
  PASS(support_faults(CAMERA(LOOK "worlddim 1 1")) != nil, "not both");
  PASS(support_faults(CAMERA("viewpoint 0 0 1")) != nil, "nor none");
  PASS(support_faults(CAMERA("viewpoint 0 0 0 worlddim 1 1")) != nil
       && support_faults(CAMERA("viewpoint 0 0 -1 worlddim 1 1")) != nil,
       "the window is in front of the viewpoint");
  PASS(support_faults(CAMERA("viewpoint 1 2 3 lookat 1 2 3 up 0 1 0"
                             " angle 40")) != nil, "lookat the viewpoint");
  PASS(support_faults(CAMERA("viewpoint 1 2 3 lookat 1 7 3 up 0 -2 0"
                             " angle 40")) != nil, "up along the sight");
  PASS(support_faults(CAMERA("viewpoint 1 2 3 lookat 4 5 6 up 0 0 0"
                             " angle 40")) != nil, "up 0");
  PASS(support_faults(CAMERA("viewpoint 1 2 3 lookat 4 5 6 up 0 1 0"
                             " angle 0")) != nil
       && support_faults(CAMERA("viewpoint 1 2 3 lookat 4 5 6 up 0 1 0"
                                " angle 180")) != nil,
       "an angle of 0 or 180");
  PASS(support_faults(CAMERA("viewpoint 1 2 3 lookat 4 5 6")) != nil
       && support_faults(CAMERA("viewpoint 1 2 3 angle 9")) != nil,
       "lookat, up and angle go together");
  PASS(support_faults(CAMERA(LOOK "focus 1 fstop 1 exposure 3")) == nil
       && support_faults(CAMERA(LOOK "focus 1 fstop 1")) != nil
       && support_faults(CAMERA(LOOK "aperture disc")) != nil,
       "focus, fstop and exposure go together, aperture with them");
  PASS(support_faults("camera c { pixeldim 0 4 viewpoint 0 0 1"
                      " worlddim 1 1 }") != nil, "no columns");
}

int
main(void)
{
  NSAutoreleasePool *pool = [[NSAutoreleasePool alloc] init];

  window();
  lookat();
  tangents();
  places();
  faults();
  [pool release];
  return test_done();
}
