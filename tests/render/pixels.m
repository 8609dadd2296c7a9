// pixels.m - the colour of a pixel against rays that are traced one by one:
// the mean of its samples, and an eye inside glass.

#import "scene.h"
#include "test.h"

/** The mean of the four places of a grid of 2 x 2. */
static void
means(void)
{
  struct scene how = { .columns = 7, .rows = 5 };
  struct render_options options = support_render_options();
  model_t *model = scene_model(how);
  unsigned wrong = 0;

  options.sampler = SAMPLER_GRID;
  options.samples = 4;
  image_t *image = support_picture(model, options);
  for (unsigned y = 0; y < 5; y++)
    {
      for (unsigned x = 0; x < 7; x++)
        {
          struct k_vec sum = { 0, 0, 0 };
          for (int k = 0; k < 4; k++)
            {
              struct sample s = { .column = x, .row = 4 - y,
                                  .right = k % 2 ? 0.25 : -0.25,
                                  .up = k / 2 ? 0.25 : -0.25 };
              struct k_vec o, d;
              [model->camera ray: s pos: &o dir: &d];
              vec_t *pos = [vec_t vec: o], *dir = [vec_t vec: d];
              ray_t *ray = [(ray_t *)[ray_t alloc] init: pos : dir];
              ray->media = [[model mediaOf: ray] retain];
              sum = k_add(sum, [ray trace: model]->v);
              [ray release];
            }
          struct k_vec got = [image pixelAt: x : y]->color;
          wrong += k_norm_max(k_sub(got, k_scale(sum, 0.25)))
            > 8 * K_U * k_norm_max(sum);
        }
    }
  PASS(wrong == 0, "a pixel is the mean of its samples: %u", wrong);
}

/** With the eye in glass in water the picture starts in both, as single rays
    do. */
static void
in_glass(void)
{
  model_t *model = support_model
    ("background 1 2 3\n" SUPPORT_CAMERA
     "material glass { alpha 1 ior 1.5 }\n"
     "material water { alpha 1 ior 1.25 }\n"
     "sphere w { material water center 1.5 1 5 radius 4 }\n"
     "sphere s { material glass center 1.5 1 5 radius 1 }\n"
     "sphere t { material glass center 1 1 2 radius .5 }\n");
  image_t *image = support_picture(model, support_render_options());
  unsigned wrong = 0;

  for (unsigned y = 0; y < 9; y++)
    {
      for (unsigned x = 0; x < 9; x++)
        {
          struct k_vec eye = { 1, 1, 5 };
          struct k_vec to = k_vec(x / 4.0, (8 - y) / 4.0, 0);
          struct k_vec c = support_trace(model, eye, k_sub(to, eye));
          wrong += !support_same(c, [image pixelAt: x : y]->color);
        }
    }
  PASS(wrong == 0, "an eye in glass: %u pixels are not what single rays see",
       wrong);
}

int
main(void)
{
  NSAutoreleasePool *pool = [[NSAutoreleasePool alloc] init];

  means();
  in_glass();
  [pool release];
  return test_done();
}
