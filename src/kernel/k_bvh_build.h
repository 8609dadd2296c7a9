// k_bvh_build.h - building the tree over boxes.

#ifndef K_BVH_BUILD_H
#define K_BVH_BUILD_H

#include "k_scene.h"

/** A shape and its box in the tree's coordinates, rounded outwards. 32 bytes,
    so that the box loads as two vectors. */
struct k_item
{
  float least[3], zero;
  float most[3];
  struct k_ref ref;
};

_Static_assert(sizeof(struct k_item) == 32, "two vectors of four floats");

/** Builds tree->nodes over `count` > 0 items, which do not outlast it, and
    lists them in tree->refs in the order of the leaves. The same tree for any
    number of threads. */
enum k_status k_bvh_build(struct k_tree *tree, struct k_item *items,
                          uint32_t count, unsigned threads);

#endif
