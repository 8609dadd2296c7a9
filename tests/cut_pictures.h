// cut_pictures.h - pictures with the errors that they say they may have.

#ifndef CUT_PICTURES_H
#define CUT_PICTURES_H

#import "brightest_t.h"
#import "support.h"

/** A picture with the plane of errors; *counters, unless NULL, is what was
    traced. */
static inline image_t *
cut_picture(model_t *model, id <engine_t> engine,
            struct render_options options, struct counters *counters)
{
  struct window all = { 0, 0, model->camera->columns, model->camera->rows };
  image_t *image = [[[image_t alloc] init: all.x1 : all.y1 window: all
                                 surfaces: NO error: NULL] autorelease];
  render_t *render;

  [image addPlane: PLANE_TRUNCATION error: NULL];
  if (options.noise > 0)
    {
      [image addPlane: PLANE_SAMPLING error: NULL];
      [image addPlane: PLANE_SAMPLES error: NULL];
    }
  render = [[render_t alloc] init: engine camera: model->camera into: image
                          options: options];
  [render run];
  if (counters)
    {
      *counters = render->counters;
    }
  [render release];
  return image;
}

/** Lets a model cut so; errors count from `generations`. */
static inline void
cut_model(model_t *model, unsigned max_depth, double min_weight,
          double max_error, unsigned generations)
{
  brightest_t *brightest = [[[brightest_t alloc]
                              initWithModel: model
                                generations: generations] autorelease];
  struct cut_rule rule = { 1, min_weight, max_error, generations,
                           brightest->most, brightest->count };

  model->max_depth = max_depth;
  model->cut = rule;
}

/** How many pixels have other colours or errors. */
static inline size_t
cut_apart(image_t *a, image_t *b)
{
  size_t count = (size_t)[a width] * [a height], apart = 0;

  for (size_t i = 0; i < count; i++)
    {
      apart += !support_same(a->pixels[i].color, b->pixels[i].color)
        || a->planes[PLANE_TRUNCATION][i] != b->planes[PLANE_TRUNCATION][i];
    }
  return apart;
}

/** How many channels are farther off than the picture says. */
static inline unsigned
cut_broken(image_t *image, image_t *deep, double *most)
{
  size_t count = (size_t)[image width] * [image height];
  unsigned wrong = 0;

  *most = 0;
  for (size_t i = 0; i < count; i++)
    {
      double error = image->planes[PLANE_TRUNCATION][i];
      struct k_vec off = k_sub(deep->pixels[i].color,
                               image->pixels[i].color);
      wrong += !(k_norm_max(off) <= error
                 + 1e-13 * k_norm_max(deep->pixels[i].color));
      *most = fmax(*most, error);
    }
  return wrong;
}

#endif
