// timed.m - --time-limit when the time is up before the first pass is complete:
// tiles that are missing are copies of the last one that is there.

#import "support.h"
#include "test.h"

// Five tiles across and three down, those at the right and below smaller.
enum { COLUMNS = 70, ROWS = 37, TILE = 16, ACROSS = 5, DOWN = 3 };

/** Answers each ray with where it goes, until it has been asked often enough:
    then the time is up. */
@interface stopping_t : NSObject <engine_t>
{
@public
  unsigned calls;       // until then
  render_t *render;     // not retained
}
@end

@implementation stopping_t

- (void) trace: (struct eye_ray *)rays : (unsigned)count
      counters: (struct counters *)counters
{
  for (unsigned i = 0; i < count; i++)
    {
      rays[i].color = rays[i].d;
    }
  calls -= calls > 0;
  if (calls == 0)
    {
      render->options.until = -1;
    }
}

- (struct surface_pixel) surfaceAt: (struct k_vec)o : (struct k_vec)d
{
  struct surface_pixel nothing = { .depth = HUGE_VAL };

  return nothing;
}

@end

/** What is there when the engine has been asked so often. */
static image_t *
picture(unsigned calls, unsigned *samples)
{
  model_t *model = support_model
    ("camera c { pixeldim 70 37 worlddim 8 6 viewpoint 4 3 9 }\n");
  struct window all = { 0, 0, COLUMNS, ROWS };
  image_t *image = [[[image_t alloc] init: COLUMNS : ROWS window: all
                                 surfaces: NO error: NULL] autorelease];
  [image addPlane: PLANE_SAMPLING error: NULL];
  struct render_options options = support_render_options();
  stopping_t *engine = [[[stopping_t alloc] init] autorelease];

  options.until = HUGE_VAL;
  render_t *render = [[render_t alloc] init: engine camera: model->camera
                                       into: image options: options];
  engine->calls = calls;
  engine->render = render;
  [render runTimed];
  *samples = [render samplesDone];
  [render release];
  return image;
}

static unsigned
blocks_of(unsigned tile)
{
  unsigned across = MIN(COLUMNS - tile % ACROSS * TILE, TILE);
  unsigned down = MIN(ROWS - tile / ACROSS * TILE, TILE);

  return (across + 7) / 8 * ((down + 3) / 4);
}

/** The first `there` tiles are; the time was up in the next one. */
static void
filled(image_t *whole, unsigned there)
{
  unsigned calls = 1, samples, wrong = 0, last = there ? there - 1 : 0;

  for (unsigned tile = 0; tile < there; tile++)
    {
      calls += blocks_of(tile);
    }
  image_t *image = picture(calls, &samples);
  PASS(samples == 0, "%u tiles are no pass", there);
  for (unsigned y = 0; y < ROWS; y++)
    {
      for (unsigned x = 0; x < COLUMNS; x++)
        {
          unsigned tile = y / TILE * ACROSS + x / TILE;
          unsigned x0 = last % ACROSS * TILE, y0 = last / ACROSS * TILE;
          unsigned x1 = MIN(x0 + TILE, COLUMNS), y1 = MIN(y0 + TILE, ROWS);
          struct k_vec want = tile < there ? [whole pixelAt: x : y]->color
            : there == 0 ? k_vec(0, 0, 0)
            : [whole pixelAt: MIN(x0 + x % TILE, x1 - 1)
                            : MIN(y0 + y % TILE, y1 - 1)]->color;
          wrong += !support_same(want, [image pixelAt: x : y]->color);
        }
    }
  PASS(wrong == 0, "with %u tiles the others are copies of the last: %u pixels"
       " are not", there, wrong);
}

int
main(void)
{
  NSAutoreleasePool *pool = [[NSAutoreleasePool alloc] init];
  unsigned all = 0, samples;

  for (unsigned tile = 0; tile < ACROSS * DOWN; tile++)
    {
      all += blocks_of(tile);
    }
  image_t *whole = picture(all + 1, &samples);
  PASS(samples == 1, "a pass and a bit are one ray through each pixel");
  for (unsigned there = 0; there < ACROSS * DOWN; there++)
    {
      filled(whole, there);
    }
  [pool release];
  return test_done();
}
