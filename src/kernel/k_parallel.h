// k_parallel.h - one function on several threads at once.

#ifndef K_PARALLEL_H
#define K_PARALLEL_H

#include <stdint.h>

/** Calls work(context, i) for each i below `threads`, each on a thread of its
    own, this one among them; returns when all have. Where a thread cannot be
    made its call comes later, on this one: so they must not wait for each
    other. */
void k_in_parallel(unsigned threads, void (*work)(void *, unsigned),
                   void *context);

/** The next of the numbers below `count` that no thread has taken; `count`
    when there is none. *next is 0 at first. */
static inline uint32_t
k_take(uint32_t *next, uint32_t count)
{
  uint32_t i = __atomic_fetch_add(next, 1, __ATOMIC_RELAXED);

  return i < count ? i : count;
}

#endif
