// large.h - memory for what a large scene or picture has much of.

#ifndef LARGE_H
#define LARGE_H

#include <stddef.h>

/** Memory that is about to be used may come in large pages, where the system
    has them: a quarter of a million faults less per GB, and fewer misses in the
    tables of pages. */
void large_pages(void *memory, size_t bytes);

/** Such memory, from the start of a cache line on. NULL when there is none;
    free() frees it. */
void *large_new(size_t bytes);

#endif
