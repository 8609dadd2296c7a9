// k_bvh_work.h - the state of building a tree: first all forks, from the top
// down, then the nodes.

#ifndef K_BVH_WORK_H
#define K_BVH_WORK_H

#include "k_bvh_fork.h"

#define K_TASK 32768            // longest list that one thread has to itself

/** A part of the tree that one thread makes. */
struct task
{
  struct k_range range;
  uint32_t fork;                // the first of its forks
  unsigned depth;               // of that
  struct k_roots roots;
  unsigned most;                // children that it is of the node above it
  struct k_node *node;          // that node,
  unsigned slot, level;         // the first of these children, its level
  uint32_t first_node;          // of those that are made
  unsigned deepest;             // level of these
  double cost;                  // see k_tree
};

struct builder
{
  unsigned threads;
  uint32_t count;
  struct k_item *items;         // in the end in the order of the leaves
  struct k_fork *forks;
  float area;                   // half that of the box of all
  struct task *tasks;           // in the order of their items
  uint32_t task_count, task_room;
  uint32_t next_task;           // atomic
  struct k_tree *tree;
};

/** Makes the nodes and the list of shapes of the forks. 0: no memory. */
int k_nodes_make(struct builder *b, const struct k_roots *roots,
                 struct k_tree *tree);

#endif
