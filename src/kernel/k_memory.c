// k_memory.c - see k_memory.h.

#define _GNU_SOURCE             // madvise
#include "k_memory.h"
#include <stdlib.h>
#include <sys/mman.h>

#define LINE ((size_t)64)
#define LARGE_PAGE ((size_t)1 << 21)

void *
k_large_new(size_t bytes)
{
  size_t unit = bytes < LARGE_PAGE / 2 ? LINE : LARGE_PAGE;
  void *memory = aligned_alloc(unit, (bytes + unit - 1) / unit * unit);

#ifdef MADV_HUGEPAGE
  if (memory && unit == LARGE_PAGE)
    {
      madvise(memory, bytes, MADV_HUGEPAGE);    // no matter if it cannot
    }
#endif
  return memory;
}
