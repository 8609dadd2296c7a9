// large.h - memory for what a large scene or picture has much of.

#ifndef LARGE_H
#define LARGE_H

#include <stddef.h>

/** Memory that is about to be used may come in large pages, where the system
    has them: a quarter of a million faults less per GB, and fewer misses in the
    tables of pages. */
void large_pages(void *memory, size_t bytes);

/** From now on memory of a megabyte or more goes back to the system when it is
    freed, so that no two steps of the program have theirs at once. */
void large_give_back(void);

/** Such memory, from the start of a cache line on. NULL when there is none;
    free() frees it. */
void *large_new(size_t bytes);

/** Gives back a part of such memory before the rest: what was in it is gone. */
void large_drop(void *memory, size_t bytes);

#endif
