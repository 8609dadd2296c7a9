// box_pairs.h - which of many boxes overlap, in a time that grows little
// faster than their number and that of the pairs. Plain C.

#ifndef BOX_PAIRS_H
#define BOX_PAIRS_H

#include "kernel/k_bounds.h"

/** Calls `meet` once for every two of the boxes that overlap (to touch is to
    overlap), with their indices, in no order. 0 when there is no memory. */
int box_pairs(const struct k_bounds *boxes, unsigned count,
              void (*meet)(void *context, unsigned a, unsigned b),
              void *context);

#endif
