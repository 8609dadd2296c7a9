// kept.m - a picture may be kept as floats or as bytes: they are those of the
// picture in doubles, whoever rendered it, and what is no number is counted
// once, whatever the threads.

#import "brightest_t.h"
#import "scene.h"
#include "clock.h"
#include "test.h"

enum { SIDE = 45 };

/** Answers every ray with the same colour. */
@interface constant_t : NSObject <engine_t>
{
@public
  struct k_vec color;
}
@end

@implementation constant_t

- (void) trace: (struct eye_ray *)rays : (unsigned)count
      counters: (struct counters *)counters
{
  for (unsigned i = 0; i < count; i++)
    {
      rays[i].color = color;
      rays[i].error = 0;
    }
}

- (struct surface_pixel) surfaceAt: (struct k_vec)o : (struct k_vec)d
{
  struct surface_pixel nothing = { .depth = HUGE_VAL };

  return nothing;
}

@end

/** A part of the picture, kept in one of three ways. */
static image_t *
picture(model_t *model, id <engine_t> engine, struct render_options options,
        enum keep keep)
{
  struct window part = { 2, 3, SIDE - 1, SIDE };
  image_t *image = [[[image_t alloc] init: SIDE : SIDE window: part keep: keep
                                 surfaces: NO error: NULL] autorelease];

  [image addPlane: PLANE_TRUNCATION error: NULL];
  [image addPlane: PLANE_SAMPLING error: NULL];
  [image addPlane: PLANE_SAMPLES error: NULL];
  render_t *render = [[render_t alloc] init: engine camera: model->camera
                                       into: image options: options];
  if (options.until > 0)
    {
      [render runTimed];
    }
  else
    {
      [render run];
    }
  [render release];
  return image;
}

static void
same(model_t *model, struct render_options options, const char *what)
{
  id <engine_t> fast = support_fast(model, nil);
  image_t *doubles = picture(model, fast, options, KEEP_DOUBLES);
  image_t *floats = picture(model, fast, options, KEEP_FLOATS);
  image_t *bytes = picture(model, fast, options, KEEP_BYTES);
  size_t count = (size_t)[doubles width] * [doubles height];
  const double *errors = doubles->planes[PLANE_TRUNCATION];
  unsigned wrong = 0, lit = 0, off = 0;

  PASS(floats->pixels == NULL && floats->bytes == NULL
       && bytes->pixels == NULL && bytes->floats == NULL,
       "%s: nothing is kept twice", what);
  for (size_t i = 0; i < count; i++)
    {
      struct k_vec c = doubles->pixels[i].color;
      const float *f = floats->floats[i];
      const uint8_t *b = bytes->bytes[i];
      lit += !k_is_zero(c);
      off += errors[i] > 0;
      wrong += f[0] != (float)c.x || f[1] != (float)c.y || f[2] != (float)c.z;
      wrong += b[0] != [image_t byte: c.x] || b[1] != [image_t byte: c.y]
        || b[2] != [image_t byte: c.z];
    }
  PASS(lit > count / 4, "%s: there is something to see: %u", what, lit);
  PASS(wrong == 0, "%s: floats and bytes are those of the doubles: %u are not",
       what, wrong);
  PASS(off > 0 && memcmp(errors, bytes->planes[PLANE_TRUNCATION],
                         count * sizeof *errors) == 0,
       "%s: so are errors, of %u pixels", what, off);
  PASS(doubles->nanCount + floats->nanCount + bytes->nanCount == 0,
       "%s: all is a number", what);
}

static void
counted(model_t *model, struct render_options options, const char *what)
{
  constant_t *engine = [[[constant_t alloc] init] autorelease];
  enum keep keeps[] = { KEEP_DOUBLES, KEEP_FLOATS, KEEP_BYTES };

  engine->color = k_vec(NAN, 1, -NAN);
  for (unsigned k = 0; k < 3; k++)
    {
      double limit = options.until;
      options.until = limit > 0 ? clock_seconds() + limit : 0;
      image_t *image = picture(model, engine, options, keeps[k]);
      NSUInteger want = (NSUInteger)2 * [image width] * [image height];
      options.until = limit;
      PASS(image->nanCount == want, "%s: each NaN of the picture is counted"
           " once: %lu of %lu", what, (unsigned long)image->nanCount,
           (unsigned long)want);
    }
}

int
main(void)
{
  NSAutoreleasePool *pool = [[NSAutoreleasePool alloc] init];
  struct render_options options = support_render_options();
  struct scene how = { .has_lens = 1, .columns = SIDE, .rows = SIDE };
  model_t *model = scene_model(how);
  brightest_t *brightest = [[[brightest_t alloc]
                              initWithModel: model
                                generations: model->max_depth] autorelease];

  options.threads = 3;
  model->cut = (struct cut_rule){ 1, 0.1, -1, model->max_depth,
                                  brightest->most, brightest->count };
  same(model, options, "a lens");
  counted(model, options, "a lens");
  options.samples = 3;
  same(model, options, "samples");
  model->camera->has_lens = NO;
  model->camera->exposure = 1;
  options.samples = 1;
  same(model, options, "pinhole");
  counted(model, options, "pinhole");
  options.noise = 0.1;
  options.errors = 2;
  options.max_samples = 200;
  same(model, options, "noise");
  counted(model, options, "noise");
  options.noise = 0;
  options.until = 0.1;
  counted(model, options, "time");
  [pool release];
  return test_done();
}
