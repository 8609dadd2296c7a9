// k_bvh_work.h - who builds what of the tree, and where the nodes are kept
// until all are there.

#ifndef K_BVH_WORK_H
#define K_BVH_WORK_H

#include "k_bvh_cut.h"

#define K_BLOCK 8192            // nodes

/** A thread and the nodes that it has made, in blocks. */
struct worker
{
  struct k_node **blocks;
  uint32_t block_count, block_room;
  uint32_t node_count;
  int is_short_of_memory;
  uint32_t start;               // first node of the task in hand
  unsigned depth;               // its deepest level
  double cost;                  // and what its children cost, see k_facts.c
};

/** A subtree that is put off, and what became of it. */
struct task
{
  struct k_range range;
  unsigned depth;
  uint32_t parent;              // node and slot of the top it hangs on
  int slot;
  unsigned worker;              // who built it
  uint32_t node_count;
  unsigned deepest;
  double cost;
  uint32_t at;                  // where its nodes go
};

struct builder
{
  unsigned threads;
  struct worker top;            // the nodes above all tasks
  struct worker *workers;       // one per thread
  struct task *tasks;
  uint32_t task_count, task_room;
  uint32_t next_task;           // atomic
  struct k_ref *refs;           // of the tree
  struct k_tree *tree;          // that is put together
};

/** A new node; its number. */
uint32_t k_worker_node(struct worker *w);

static inline struct k_node *
k_node_at(const struct worker *w, uint32_t number)
{
  return &w->blocks[number / K_BLOCK][number % K_BLOCK];
}

/** Makes tree->nodes of what the workers have, the top first and then the
    tasks in their order. 0: no memory. */
int k_put_together(struct builder *b, struct k_tree *tree);

void k_builder_free(struct builder *b);

#endif
