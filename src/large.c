// large.c - see large.h.

#define _GNU_SOURCE             // madvise
#include "large.h"
#include <malloc.h>
#include <stdint.h>
#include <stdlib.h>
#include <sys/mman.h>
#include <unistd.h>

#define LINE ((size_t)64)
#define LARGE_PAGE ((size_t)1 << 21)

/** Advises the system on the whole pages of a piece of memory. No matter if it
    does not take it. */
static void
advise(void *memory, size_t bytes, int advice)
{
  uintptr_t page = sysconf(_SC_PAGESIZE);
  uintptr_t from = ((uintptr_t)memory + page - 1) & -page;
  uintptr_t to = ((uintptr_t)memory + bytes) & -page;

  if (to > from)
    {
      madvise((void *)from, to - from, advice);
    }
}

void
large_pages(void *memory, size_t bytes)
{
#ifdef MADV_HUGEPAGE
  advise(memory, bytes, MADV_HUGEPAGE);
#endif
}

void
large_drop(void *memory, size_t bytes)
{
  advise(memory, bytes, MADV_DONTNEED);
}

void
large_give_back(void)
{
#ifdef M_MMAP_THRESHOLD
  mallopt(M_MMAP_THRESHOLD, 1 << 20);
#endif
}

void *
large_new(size_t bytes)
{
  size_t unit = bytes < LARGE_PAGE / 2 ? LINE : LARGE_PAGE;
  void *memory = aligned_alloc(unit, (bytes + unit - 1) / unit * unit);

  if (memory && unit == LARGE_PAGE)
    {
      large_pages(memory, bytes);
    }
  return memory;
}
