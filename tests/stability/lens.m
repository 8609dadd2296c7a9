// lens.m - stability: depth of field. D01 to D06.

#include "battery.h"

#define LENS_SCENE \
  "material m { ambient 3 2 1 diffuse .5 .5 .5 }\n" \
  "light l { location 2 5 4 emissivity 3 3 3 }\n" \
  "sphere s { material m center 1 1 -2 radius 1 }\n" \
  "plane p { material m normal 0 1 0 point 0 -.5 0 }\n"
#define LENS_CAMERA \
  "camera c { pixeldim 16 12 worlddim 4 3 viewpoint 2 1.5 5 %s }\n"

static image_t *
seen(const char *lens)
{
  return support_picture(support_model(LENS_CAMERA LENS_SCENE, lens),
                         support_render_options());
}

static double
apart(image_t *a, image_t *b)
{
  double most = 0;

  for (size_t i = 0; i < (size_t)[a width] * [a height]; i++)
    {
      most = fmax(most, k_norm_max(k_sub(a->pixels[i].color,
                                         b->pixels[i].color)));
    }
  return most;
}

static void
test_D01(void)
{
  image_t *pinhole = seen("");

  PASS_NEAR(apart(seen("focus 7 fstop 0x1p400 exposure 1"), pinhole), 0,
            1e-13, "D01 the smallest lens there is");
  PASS_NEAR(apart(seen("focus 7 fstop 1e20 exposure 3"), pinhole), 0, 1e-13,
            "D01 a small lens");
}

static void
test_D02(void)
{
  image_t *image = seen("focus 7 fstop 1e-6 exposure 16");
  PASS(image->nanCount == 0, "D02 a lens a million times the scene");
}

static void
test_D03(void)
{
  static const char *const lens[] = { "1", "1e8", "0x1p400" };

  for (int i = 0; i < 3; i++)
    {
      quad focus = strtod(lens[i], NULL);
      char text[100];
      snprintf(text, sizeof text, "focus %s fstop 4 exposure 1", lens[i]);
      model_t *model = support_model(LENS_CAMERA LENS_SCENE, text);
      camera_t *camera = model->camera;
      struct sample sample = { .column = 3, .row = 4, .u = .7, .v = -.4 };
      struct k_vec o, d, pos, dir;
      [camera centralRay: sample pos: &pos dir: &dir];
      [camera ray: sample pos: &o dir: &d];
      struct q_vec lens_at = q_vec((quad).7 / 4, (quad)-.4 / 4, 0);
      struct q_vec want = q_vec(dir.x - lens_at.x / focus,
                                dir.y - lens_at.y / focus,
                                dir.z);
      quad length = q_sqrt(q_dot(want, want));
      double off = fmax(fmax((double)q_abs(want.x / length - d.x),
                             (double)q_abs(want.y / length - d.y)),
                        (double)q_abs(want.z / length - d.z));
      PASS_NEAR(off, 0, 4 * U, "D03 focus %s: direction off by", lens[i]);
      PASS_NEAR(o.x, pos.x + .7 / 4, 2 * U * o.x, "D03 focus %s: start",
                lens[i]);
    }
}

static void
test_D04(void)
{
  PASS(support_faults("camera c { pixeldim 4 4 worlddim 1 1 viewpoint 0 0 1"
                      " focus 0 fstop 1 exposure 1 }") != nil,
       "D04 focus 0 is refused");
}

static void
test_D05(void)
{
  image_t *image = seen("focus 6.5 fstop 2 exposure 8");
  PASS(image->nanCount == 0, "D05 focus inside an object: finite");
}

/** A half plane at half the focus covers the disc of blur up to `off` of its
    radius: how much of it is seen. */
static double
coverage(double off)
{
  model_t *model = support_model(
    "camera c { pixeldim 1 1 worlddim 1 1 viewpoint .5 .5 8 focus 16 fstop 2"
    " exposure 16384 aperture disc }\nbackground 1 1 1\nmaterial m { }\n"
    "polygon p { material m vertex %.17g -9 0 vertex 99 -9 0 vertex 99 9 0"
    " vertex %.17g 9 0 }\n", .5 + off / 4, .5 + off / 4);
  image_t *image = support_render(model, support_fast(model, nil),
                                  support_render_options(),
                                  (struct window){ 0, 0, 1, 1 });
  return image->pixels[0].color.x;
}

static void
test_D06(void)
{
  static const double table[][2] = {
    { 0, .5 }, { .25, .65748117876285372 }, { .5, .80449889052211468 },
    { .9, .98130696326575068 }
  };

  for (int i = 0; i < 4; i++)
    {
      double p = table[i][1];
      PASS_NEAR(coverage(table[i][0]), p, 4 * sqrt(p * (1 - p) / 16384),
                "D06 an edge %g of the blur off, 16384 rays",
                table[i][0]);
    }
}

int
main(void)
{
  NSAutoreleasePool *pool = [[NSAutoreleasePool alloc] init];

  test_D01();
  test_D02();
  test_D03();
  test_D04();
  test_D05();
  test_D06();
  [pool release];
  return test_done();
}
