// tiles.m - a pixel depends on the model, the options and its own place: not
// on threads, tiles or the part that is computed.

#import "scene.h"
#include "test.h"

static BOOL
same_counters(struct counters a, struct counters b)
{
  return a.eye == b.eye && a.reflection == b.reflection
    && a.refraction == b.refraction && a.feeler == b.feeler
    && a.tests == b.tests && a.escapes == b.escapes;
}

static void
threads(struct scene how, struct render_options options, const char *what)
{
  const unsigned counts[] = { 1, 2, 7, 64 };
  model_t *model = scene_model(how);
  struct window all = { 0, 0, model->camera->columns, model->camera->rows };
  image_t *first = nil;
  struct counters first_counters = { 0 };

  for (int i = 0; i < 4; i++)
    {
      options.threads = counts[i];
      image_t *image = [[[image_t alloc] init: model->camera->columns
                                             : model->camera->rows
                                        window: all surfaces: YES
                                         error: NULL] autorelease];
      render_t *render = [[render_t alloc] init: model into: image
                                        options: options];
      BOOL finished = [render run];
      if (first == nil)
        {
          first = image;
          first_counters = render->counters;
          PASS(finished && [render done] == 1, "%s: done", what);
          uint64_t rays = (uint64_t)all.x1 * all.y1 * options.samples
            * model->camera->exposure;
          PASS(first_counters.eye == rays, "%s: one eye ray for each pixel,"
               " sample and exposure", what);
        }
      else
        {
          unsigned differences = support_differences(first, image);
          PASS(finished && differences == 0, "%s: %u threads, the same bits:"
               " %u pixels differ", what, counts[i], differences);
          PASS(same_counters(first_counters, render->counters),
               "%s: %u threads, the same counts", what, counts[i]);
        }
      [render release];
    }
}

static void
crops(struct scene how, struct render_options options, const char *what)
{
  model_t *model = scene_model(how);
  image_t *whole = support_picture(model, options);
  unsigned columns = whole->columns, rows = whole->rows, wrong = 0;
  const struct window parts[] = {
    { 0, 0, 1, 1 }, { columns - 1, rows - 1, columns, rows },
    { 3, 5, 30, 29 }, { 0, 7, columns, 8 }, { 20, 0, 21, rows },
    { 16, 16, 32, 32 }, { 15, 15, 33, 33 }
  };

  for (unsigned k = 0; k < sizeof parts / sizeof *parts; k++)
    {
      struct window part = parts[k];
      part.x1 = part.x1 < columns ? part.x1 : columns;
      part.y1 = part.y1 < rows ? part.y1 : rows;
      image_t *image = support_window(model, options, part);
      for (unsigned y = part.y0; y < part.y1; y++)
        {
          for (unsigned x = part.x0; x < part.x1; x++)
            {
              struct surface_pixel *a = [whole surfaceAt: x : y];
              struct surface_pixel *b = [image surfaceAt: x : y];
              wrong += !support_same([whole pixelAt: x : y]->color,
                                     [image pixelAt: x : y]->color)
                || a->depth != b->depth || a->object != b->object
                || !support_same(a->N, b->N);
            }
        }
    }
  PASS(wrong == 0, "%s: parts are the pixels of the whole: %u", what, wrong);
}

/** Row 0 of the camera is the bottom, row 0 of the image the top. */
static void
rows(void)
{
  model_t *model = support_model
    ("camera cam { pixeldim 3 3 worlddim 2 2 viewpoint 1 1 5 }\n"
     "material m { ambient 1 1 1 }\n"
     "sphere s { material m center 0 2 0 radius .1 }\n");
  image_t *image = support_picture(model, support_render_options());

  PASS([image surfaceAt: 0 : 0]->object == 1, "top left is (0 height)");
  PASS([image surfaceAt: 0 : 2]->object == 0
       && [image surfaceAt: 2 : 0]->object == 0, "and no other corner");
  PASS([image surfaceAt: 2 : 2]->depth == HUGE_VAL, "nothing is at infinity");
  PASS(k_is_zero([image surfaceAt: 2 : 2]->N), "and has no normal");
  PASS(support_same([image pixelAt: 2 : 2]->color, k_vec(0, 0, 0)),
       "and is black");
}

/** The mean of the samples, against each of them traced by itself. */
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

static void
stopping(void)
{
  struct scene how = { .columns = 40, .rows = 40 };
  model_t *model = scene_model(how);
  struct window all = { 0, 0, 40, 40 };
  image_t *image = [[[image_t alloc] init: 40 : 40 window: all surfaces: NO
                                    error: NULL] autorelease];
  struct render_options options = support_render_options();
  volatile int stop = 1;
  options.threads = 3;
  render_t *render = [[render_t alloc] init: model into: image
                                    options: options];

  render->stop = &stop;
  PASS(![render run], "a run that is stopped says NO");
  PASS(render->counters.eye == 0, "and computes nothing more");
  [render release];
}

/** No lights, no objects: background. */
static void
empty(void)
{
  model_t *model = support_model("background .5 2 0 " SUPPORT_CAMERA);
  image_t *image = support_picture(model, support_render_options());
  unsigned wrong = 0;

  for (unsigned i = 0; i < 81; i++)
    {
      wrong += !support_same(image->pixels[i].color, k_vec(0.5, 2, 0));
    }
  PASS(wrong == 0, "an empty scene is its background: %u", wrong);
}

int
main(void)
{
  NSAutoreleasePool *pool = [[NSAutoreleasePool alloc] init];
  struct render_options options = support_render_options();
  struct scene pinhole = { .columns = 61, .rows = 35 };
  struct scene lens = { .has_lens = 1, .columns = 33, .rows = 17 };

  threads(pinhole, options, "pinhole");
  crops(pinhole, options, "pinhole");
  threads(lens, options, "lens");
  crops(lens, options, "lens");
  options.samples = 2;
  options.seed = 99;
  threads(lens, options, "two samples");
  crops(lens, options, "two samples");
  rows();
  means();
  stopping();
  empty();
  [pool release];
  return test_done();
}
