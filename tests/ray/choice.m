// choice.m - what may be left out of the formulas, and Fresnel's in place of
// Schlick's.

#import "support.h"
#include "test.h"

// A lit floor under a ball; a mirror on the left, a sheet of glass on the right.
#define ROOM \
  "camera c { pixeldim 24 18 worlddim 8 6 viewpoint 4 3 9 %s }\n" \
  "background .1 .2 .3\n" \
  "light l { location 4 9 1 emissivity 5 5 5 }\n" \
  "material f { ambient 1 1 1 diffuse .5 .6 .7 }\n" \
  "material m { specular .5 .5 .5 diffuse .2 .2 .2 ambient 1 1 1 }\n" \
  "material g { alpha .75 ior 1.5 ambient 1 1 1 }\n" \
  "plane floor { material f normal 0 1 0 point 0 0 0 }\n" \
  "sphere ball { material f center 4 2 -2 radius 1 }\n" \
  "sphere mirror { material m center 1.5 2 -1 radius 1 }\n" \
  "sphere glass { material g center 6.5 2 -1 radius 1 }\n"

static image_t *
seen(struct shade_choice choice, struct counters *count)
{
  model_t *model = support_model(ROOM, "");
  struct window all = { 0, 0, 24, 18 };
  id <engine_t> fast;
  image_t *image;

  model->choice = choice;
  image = support_picture(model, support_render_options());
  fast = support_fast(model, @"base");
  PASS(support_pixels_apart(image, support_render(model, fast,
                                                  support_render_options(),
                                                  all)) == 0,
       "every instruction set: the same bits");
  render_t *render = [[render_t alloc] init: fast camera: model->camera
                                       into: image
                                    options: support_render_options()];
  [render run];
  *count = render->counters;
  [render release];
  return image;
}

static void
left_out(void)
{
  struct counters whole, less;
  struct shade_choice choice = { 0 };
  image_t *all = seen(choice, &whole);

  choice.no_shadows = 1;
  image_t *image = seen(choice, &less);
  PASS(whole.feeler > 0 && less.feeler == 0, "no shadows, no feelers");
  PASS(less.reflection == whole.reflection
       && less.refraction == whole.refraction, "and all other rays");
  unsigned darker = 0, unlike = 0;
  for (int i = 0; i < 24 * 18; i++)
    {
      struct k_vec a = all->pixels[i].color, b = image->pixels[i].color;
      unlike += !support_same(a, b);
      darker += b.x < a.x - 0.02;
    }
  PASS(unlike > 0 && darker == 0, "nothing is darker without shadows");

  choice.no_shadows = 0;
  choice.no_reflection = 1;
  seen(choice, &less);
  PASS(whole.reflection > 0 && less.reflection == 0, "no reflected rays");
  choice.no_reflection = 0;
  choice.no_refraction = 1;
  seen(choice, &less);
  PASS(whole.refraction > 0 && less.refraction == 0, "no refracted rays");
}

/** What is black: half a mirror, three quarters of a clear ball. */
static void
black(void)
{
  model_t *model = support_model(ROOM, "");
  struct k_vec eye = k_vec(1.5, 2, 9), ahead = k_vec(0, 0, -1);

  model->choice.no_reflection = model->choice.no_refraction = 1;
  model->choice.no_shadows = 1;
  struct k_vec mirror = support_trace(model, eye, ahead);
  // diffuse (ambient / 9 + diffuse e cos / r) and the highlight
  struct k_vec l = k_sub(k_vec(4, 9, 1), k_vec(1.5, 2, 0));
  double r = k_length(l), lit = .2 * 5 * (l.z / r) / r;
  double h = 2 * (l.z / r) * 1 - l.z / r;
  double want = .2 * (1 / 9. + lit) + .5 * 5 * pow(h, 32) / r;
  PASS_NEAR(mirror.x, want, 1e-12, "a mirror without its reflection");
  struct k_vec glass = support_trace(model, k_vec(6.5, 2, 9), ahead);
  PASS_NEAR(glass.x, .25 * (1 / 9.), 1e-12, "a clear ball without rays");
}

static void
fresnel(void)
{
  const struct k_vec N = { 0, 0, 1 };

  for (int degrees = 0; degrees < 90; degrees += 10)
    {
      double a = degrees * (M_PI / 180), n = 1.5;
      double b = asin(sin(a) / n);
      struct k_vec D = k_vec(sin(a), 0, -cos(a));
      struct k_vec T = k_vec(sin(b), 0, -cos(b));
      double s = degrees ? sin(a - b) / sin(a + b) : .2;
      double p = degrees ? tan(a - b) / tan(a + b) : .2;
      double want = (s * s + p * p) / 2;
      PASS_NEAR(shade_fresnel(D, N, T, 1, n), want, 1e-14,
                "R11 Fresnel at %d degrees", degrees);
      PASS_NEAR(shade_fresnel(k_neg(T), k_neg(N), k_neg(D), n, 1), want, 1e-14,
                "and back, %d degrees", degrees);
    }
  struct k_vec D = k_vec(sqrt(3) / 2, 0, -.5);
  PASS_NEAR(shade_fresnel(D, N, shade_refract(D, N, 1.5, NULL), 1, 1.5),
            .089186712802212783, 4 * .5 * 0x1p-52, "R11 at 60 degrees");
  PASS(shade_fresnel(D, N, D, 1.3, 1.3) == 0, "equal indices reflect nothing");

  struct shade_choice choice = { .exact_fresnel = 1 };
  struct counters count;
  image_t *exact = seen(choice, &count);
  choice.exact_fresnel = 0;
  PASS(support_differences(exact, seen(choice, &count)) > 0,
       "the picture is another one");
}

int
main(void)
{
  NSAutoreleasePool *pool = [[NSAutoreleasePool alloc] init];

  left_out();
  black();
  fresnel();
  [pool release];
  return test_done();
}
