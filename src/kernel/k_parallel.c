// k_parallel.c - see k_parallel.h.

#include "k_parallel.h"
#include <pthread.h>

struct call
{
  void (*work)(void *, unsigned);
  void *context;
  unsigned number;
};

static void *
answer(void *p)
{
  const struct call *call = p;

  call->work(call->context, call->number);
  return NULL;
}

void
k_in_parallel(unsigned threads, void (*work)(void *, unsigned),
              void *context)
{
  struct call calls[threads];
  pthread_t others[threads];
  unsigned started = 1;

  for (unsigned i = 0; i < threads; i++)
    {
      calls[i] = (struct call){ work, context, i };
    }
  while (started < threads
         && pthread_create(&others[started], NULL, answer,
                           &calls[started]) == 0)
    {
      started++;
    }
  work(context, 0);
  for (unsigned i = started; i < threads; i++)
    {
      work(context, i);
    }
  while (--started)
    {
      pthread_join(others[started], NULL);
    }
}
