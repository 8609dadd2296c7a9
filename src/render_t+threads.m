// render_t+threads.m - an area, tile by tile, in as many threads as there are.

#import "render_t.h"
#include "grow.h"
#include <pthread.h>

/** What a thread is started with. */
struct task
{
  render_t *render;
  SEL work;
};

static void *
work_in_thread(void *given)
{
  const struct task *task = given;

  GSRegisterCurrentThread();
  [task->render performSelector: task->work];
  GSUnregisterCurrentThread();
  return NULL;
}

@implementation render_t (threads)

- (void) cover: (struct window)w
{
  area = w;
  tiles_across = (w.x1 - w.x0 + TILE_SIDE - 1) / TILE_SIDE;
  tile_count = tiles_across * ((w.y1 - w.y0 + TILE_SIDE - 1) / TILE_SIDE);
  next_tile = 0;
}

- (struct window) windowOf: (unsigned)tile
{
  struct window w;

  w.x0 = area.x0 + tile % tiles_across * TILE_SIDE;
  w.y0 = area.y0 + tile / tiles_across * TILE_SIDE;
  w.x1 = MIN(w.x0 + TILE_SIDE, area.x1);
  w.y1 = MIN(w.y0 + TILE_SIDE, area.y1);
  return w;
}

- (void) inThreads: (SEL)work
{
  struct task task = { self, work };
  pthread_t threads[options.threads];
  pthread_attr_t attributes;
  unsigned started = 0;

  pthread_attr_init(&attributes);
  pthread_attr_setstacksize(&attributes, options.stack);
  while (started < options.threads
         && pthread_create(&threads[started], &attributes, work_in_thread,
                           &task) == 0)
    {
      started++;
    }
  pthread_attr_destroy(&attributes);
  if (started == 0 && options.stack > RENDER_STACK_LEAST)
    {
      raise_no_memory(options.stack);
    }
  if (started == 0)
    {
      [self performSelector: work];     // without a thread, in this one
    }
  while (started)
    {
      pthread_join(threads[--started], NULL);
    }
}

@end
