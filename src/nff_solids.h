// nff_solids.h - which polygons of an NFF file close a volume together. Plain
// C on arrays.

#ifndef NFF_SOLIDS_H
#define NFF_SOLIDS_H

#include "store_t.h"

/** A polygon: its corners are `count` times three numbers from the value
    number `vertex` on. */
struct nff_face
{
  unsigned record;
  unsigned vertex, count;
  unsigned fill;
  double alpha, ior;
  unsigned solid;       // found: number of its solid, from 1; 0: none
};

/** Looks for polygons that share edges (with the same bits, -0 as +0) and
    close a volume: every edge is in exactly two of them, in opposite
    directions. First among those of one fill, then among what is left with one
    alpha and ior. */
void nff_find_solids(struct nff_face *faces, unsigned count,
                     const struct value *values);

#endif
