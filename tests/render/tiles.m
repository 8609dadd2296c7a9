// tiles.m - a pixel depends on the model, the options and its own place: not
// on threads, tiles or the part that is computed.

#import "scene.h"
#include "test.h"

static BOOL
same_counters(struct counters a, struct counters b)
{
  return a.eye == b.eye && a.reflection == b.reflection
    && a.refraction == b.refraction && a.feeler == b.feeler
    && a.tests == b.tests && counters_same_edges(&a, &b);
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
      id <engine_t> notes = [[[notes_t alloc] initWithModel: model]
                              autorelease];
      render_t *render = [[render_t alloc] init: notes camera: model->camera
                                           into: image options: options];
      [render run];
      if (first == nil)
        {
          first = image;
          first_counters = render->counters;
          PASS([render done] == 1, "%s: done", what);
          uint64_t rays = (uint64_t)all.x1 * all.y1 * options.samples
            * model->camera->exposure;
          PASS(first_counters.eye == rays, "%s: one eye ray for each pixel,"
               " sample and exposure", what);
        }
      else
        {
          unsigned differences = support_differences(first, image);
          PASS(differences == 0, "%s: %u threads, the same bits:"
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
  options.sampler = SAMPLER_OWEN;
  threads(lens, options, "owen");
  crops(lens, options, "owen");
  options.sampler = SAMPLER_STRATIFIED;
  threads(lens, options, "stratified");
  crops(lens, options, "stratified");
  rows();
  empty();
  [pool release];
  return test_done();
}
