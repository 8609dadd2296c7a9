// k_bvh_fork.h - the tree in two: forks, of which the nodes with eight
// children are then made. Which forks become one node is decided so that the
// whole tree costs least (Ylitie, Karras and Laine, "Efficient Incoherent Ray
// Traversal on GPUs Through Compressed Wide BVHs", 2017, section 3.2).

#ifndef K_BVH_FORK_H
#define K_BVH_FORK_H

#include "k_bvh_cut.h"

/** A list of at least two, cut in two. All forks below the left part follow
    their fork, then those below the right part: a list of n has n - 1, so the
    fork of the right part stands `left` farther on. Boxes are not kept: nodes
    are made from below, of those of the shapes. */
struct k_fork
{
  uint32_t left;                // how many are on the left
  uint32_t choice;              // see k_bvh_fork.c
};

_Static_assert(sizeof(struct k_fork) == 8, "there is one for each shape");

/** What a list costs at least as 1 to 8 children of a node above it, by the
    surfaces, and how many nodes are below these; item 0 is as 1 child. */
struct k_roots
{
  float cost[K_WIDTH];
  uint32_t nodes[K_WIDTH];
};

/** Of a list of one. */
static inline void
k_roots_of_one(struct k_roots *roots, float area)
{
  for (int i = 0; i < K_WIDTH; i++)
    {
      roots->cost[i] = area;
      roots->nodes[i] = 0;
    }
}

/** Of a list of two, with this surface, whose shapes have `both` surfaces
    together; notes the choice in the fork. */
void k_roots_of_two(struct k_roots *roots, struct k_fork *fork, float area,
                    float both);

/** Those of a list of `count`, with this surface, of those of its parts;
    notes the choice in the fork. */
void k_roots_join(struct k_roots *roots, struct k_fork *fork, uint32_t count,
                  float area, const struct k_roots *left,
                  const struct k_roots *right);

/** How many of at most `most` children, 2 to 8, the left part takes; 0: the
    list is better one child. *most becomes how many are used at all. */
unsigned k_fork_left(const struct k_fork *fork, unsigned *most);

/** Whether the list is a leaf when it is one child, and not a node. */
int k_fork_is_leaf(const struct k_fork *fork);

/** How many of the eight children of its node the left part takes. */
unsigned k_fork_left_of_node(const struct k_fork *fork);

#endif
