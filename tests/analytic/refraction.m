// refraction.m - pictures through glass and water whose every pixel has a
// closed form: the shift of a slab, the window of light seen from under
// water, Schlick's reflectance from 0 to 90 degrees.

#import "support.h"
#include "test.h"

/** The ray of a pixel: columns x rows pixels over a window w x h seen from
    `eye`; y from the top. */
static struct q_vec
direction(struct k_vec eye, unsigned columns, unsigned rows, double w,
          double h, unsigned x, unsigned y)
{
  quad px = (quad)w * x / (columns - 1);
  quad py = (quad)h * (rows - 1 - y) / (rows - 1);

  return q_unit(q_sub(q_vec(px, py, 0), q_of(eye)));
}

/** A slab of glass, two units thick, over a floor of stripes: each pixel
    shows the stripe that the bent ray ends in, at the length of its path. */
static void
slab(void)
{
  enum { N = 101 };
  NSMutableString *text = [NSMutableString stringWithFormat:
    @"camera cam { pixeldim %d %d worlddim 8 8 viewpoint 4 4 3 }\n"
    "material glass { alpha 1 ior 1.5 }\n"
    "material odd { ambient 1 1 1 }\nmaterial even { ambient 8 8 8 }\n%s",
    N, N, support_box("slab", "slab", "glass", k_vec(-50, -50, -3),
                      k_vec(50, 50, -1))];
  for (int i = 0; i < 80; i++)
    {
      double x = (i - 40) * 0.5;
      [text appendFormat: @"polygon s%d { material %s vertex %g -40 -4"
        " vertex %g -40 -4 vertex %g 40 -4 vertex %g 40 -4 }\n", i,
        i % 2 ? "odd" : "even", x, x + 0.5, x + 0.5, x];
    }
  model_t *model = support_model_with(support_options(), text);
  model->max_depth = 2;
  image_t *image = support_picture(model, support_render_options());
  unsigned wrong = 0, straight = 0, even = 0;
  double worst = 0;

  for (unsigned y = 0; y < N; y++)
    {
      for (unsigned x = 0; x < N; x++)
        {
          struct k_vec eye = { 4, 4, 3 };
          struct q_vec d = direction(eye, N, N, 8, 8, x, y);
          quad c = -d.z, s2 = 1 - c * c, ct = q_sqrt(1 - s2 / (quad)2.25);
          // 4 above the slab and 1 below it straight, 2 in it bent: what
          // goes sideways is s / c a unit, in the glass (s / n) / ct.
          quad bent = 2 / ((quad)1.5 * ct), plain = 5 / c;
          quad at = 4 + d.x * (bent + plain);
          quad dis = 2 / ct + plain;
          quad m = 1 - c, R = (1 + 24 * m * m * m * m * m) / 25;
          double stripe = at * 2;
          if (fabs(stripe - lround(stripe)) < 1e-12)
            {
              continue;
            }
          int is_even = ((int)floor(stripe + 40) % 2) == 0;
          double want = (1 - R) * (1 - R) * (is_even ? 8 : 1) / dis;
          double got = [image pixelAt: x : y]->color.x;
          double off = fabs(got - want) / want;
          wrong += !(off < 64 * K_U);
          worst = fmax(worst, off);
          even += is_even;
          // Would a ray that is not bent have ended in the other colour?
          double other = (double)(4 + d.x * 7 / c) * 2;
          straight += ((int)floor(other + 40) % 2 == 0) != is_even;
        }
    }
  PASS(straight > 2000, "the slab moves the stripes in many pixels: %u",
       straight);
  PASS(wrong == 0, "slab: shift, length and reflectance of every pixel: %u"
       " wrong, at most %g", wrong, worst);
  PASS(even > 4000 && even < 6200, "both colours are seen");
}

/** From under water: the sky is in a circle of radius depth tan(critical
    angle), outside of it the bottom is mirrored completely. */
static void
snells_window(void)
{
  enum { N = 121 };
  const double n = 1.25;        // critical: sin = .8, tan = 4/3
  model_t *model = support_model
    ("background 1 1 1\n"
     "camera cam { pixeldim %d %d worlddim 12 12 viewpoint 6 6 3 }\n"
     "material water { alpha 1 ior %g }\n"
     "material bottom { ambient 16 16 16 }\n"
     "plane surface { material water normal 0 0 -1 point 0 0 0 }\n"
     "plane bottom { material bottom normal 0 0 -1 point 0 0 5 }\n", N, N, n);
  image_t *image = support_picture(model, support_render_options());
  unsigned wrong = 0, inside = 0, outside = 0, side = 0;

  for (unsigned y = 0; y < N; y++)
    {
      for (unsigned x = 0; x < N; x++)
        {
          double px = 12.0 * x / (N - 1) - 6, py = 12.0 * y / (N - 1) - 6;
          double r = hypot(px, py);
          double got = [image pixelAt: x : y]->color.x;
          quad c2 = 9 / (9 + (quad)px * px + (quad)py * py);
          quad c = q_sqrt(c2), dis = 3 / c + 5 / c;
          quad k = 1 - (1 - c2) * n * n, R = 1;
          if (fabs(r - 4) < 1e-9)
            {
              continue;
            }
          if (k > 0)
            {
              quad m = 1 - q_sqrt(k), R0 = (quad)0.25 * 0.25 / 2.25 / 2.25;
              R = R0 + (1 - R0) * m * m * m * m * m;
            }
          side += (k > 0) != (r < 4);
          inside += k > 0;
          outside += k <= 0;
          double want = (1 - R) + R * 16 / dis;
          // cos_t is a root: near the circle its error is that of k over it.
          double bound = 32 * K_U * (1 + (k > 0 ? 1 / (double)q_sqrt(k) : 0));
          wrong += !(fabs(got - want) <= bound * (1 + want));
        }
    }
  PASS(side == 0, "the critical angle is at the radius depth 4/3");
  PASS(inside > 4000 && outside > 6000, "both sides of it are in the picture:"
       " %u, %u", inside, outside);
  PASS(wrong == 0, "seen from under water: %u pixels wrong", wrong);
}

/** Clear glass over black before a white sky: the picture is the reflectance,
    0.04 below the eye, 1 at the horizon. */
static void
schlick(void)
{
  enum { COLUMNS = 3, ROWS = 1001 };
  model_t *model = support_model
    ("background 1 1 1\n"
     "camera cam { pixeldim %d %d viewpoint 0 1 0 lookat 0 0 -1 up 0 1 0"
     " angle 90 }\n"
     "material glass { alpha 1 ior 1.5 }\nmaterial black { }\n"
     "plane surface { material glass normal 0 1 0 point 0 0 0 }\n"
     "plane bottom { material black normal 0 1 0 point 0 -1 0 }\n",
     COLUMNS, ROWS);
  image_t *image = support_picture(model, support_render_options());
  unsigned wrong = 0;

  // 45 degrees down in the middle, 45 more up and down: from the horizon to
  // straight down.
  for (unsigned y = 1; y < ROWS; y++)
    {
      quad t = 1 - 2 * (quad)y / (ROWS - 1);
      // Down is 1/sqrt 2 (ahead) and -1/sqrt 2 (up): cos = (1 - t) / sqrt 2
      // over the length sqrt(1 + t^2).
      quad c = (1 - t) / q_sqrt(2 * (1 + t * t)), m = 1 - c;
      double want = (1 + 24 * m * m * m * m * m) / 25;
      double got = [image pixelAt: 1 : y]->color.x;
      wrong += !(fabs(got - want) <= 32 * K_U);
    }
  PASS(wrong == 0, "Schlick from 90 to 0 degrees, every row: %u", wrong);
  PASS_NEAR([image pixelAt: 1 : ROWS - 1]->color.x, 0.04, 8 * K_U,
            "straight down R0 = 0.04");
  PASS([image pixelAt: 1 : 1]->color.x > 0.98, "1 at the horizon: %g",
       [image pixelAt: 1 : 1]->color.x);
  double middle = [image pixelAt: 1 : ROWS / 2]->color.x;
  PASS_NEAR(middle, 0.04 + 0.96 * pow(1 - sqrt(0.5), 5), 8 * K_U,
            "and Schlick's value at 45");
}

int
main(void)
{
  NSAutoreleasePool *pool = [[NSAutoreleasePool alloc] init];

  slab();
  snells_window();
  schlick();
  [pool release];
  return test_done();
}
