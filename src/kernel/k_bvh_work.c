// k_bvh_work.c - see k_bvh_work.h.

#include "k_bvh_work.h"
#include "k_memory.h"
#include "k_parallel.h"
#include <stdlib.h>
#include <string.h>

uint32_t
k_worker_node(struct worker *w)
{
  if (w->node_count == w->block_count * K_BLOCK)
    {
      if (w->block_count == w->block_room)
        {
          uint32_t room = w->block_room ? 2 * w->block_room : 16;
          struct k_node **blocks = realloc(w->blocks, room * sizeof *blocks);
          if (!blocks)
            {
              w->is_short_of_memory = 1;
              return 0;
            }
          w->blocks = blocks;
          w->block_room = room;
        }
      struct k_node *block = w->block_count
        ? k_large_new(K_BLOCK * sizeof *block)
        : malloc(K_BLOCK * sizeof *block);
      if (!block)
        {
          w->is_short_of_memory = 1;
          return 0;
        }
      w->blocks[w->block_count++] = block;
    }
  return w->node_count++;
}

/** Copies nodes to `at`, their children along; gives blocks back as it goes
    past them. */
static void
copy_nodes(struct worker *w, uint32_t first, uint32_t count,
           struct k_node *nodes, uint32_t at)
{
  for (uint32_t i = first; i < first + count; i++)
    {
      struct k_node *node = &nodes[at + i - first];
      *node = *k_node_at(w, i);
      for (int c = 0; c < K_WIDTH; c++)
        {
          // 0 is no node's child: an empty slot.
          node->child[c] += node->child[c] & K_LEAF
            || node->child[c] == 0 ? 0 : at;
        }
      if ((i + 1) % K_BLOCK == 0)
        {
          free(w->blocks[i / K_BLOCK]);
          w->blocks[i / K_BLOCK] = NULL;
        }
    }
}

/** Copies the nodes of one worker. */
static void
copy_tasks(void *builder, unsigned number)
{
  struct builder *b = builder;
  uint32_t first = 0;

  for (uint32_t i = 0; i < b->task_count; i++)
    {
      const struct task *t = &b->tasks[i];
      if (t->worker == number)
        {
          copy_nodes(&b->workers[number], first, t->node_count,
                     b->tree->nodes, t->at);
          first += t->node_count;
        }
    }
}

int
k_put_together(struct builder *b, struct k_tree *tree)
{
  uint32_t total = b->top.node_count;
  int is_short = b->top.is_short_of_memory;

  tree->depth = b->top.depth;
  tree->cost = b->top.cost;
  for (uint32_t i = 0; i < b->task_count; i++)
    {
      struct task *t = &b->tasks[i];
      is_short |= b->workers[t->worker].is_short_of_memory;
      t->at = total;
      total += t->node_count;
      tree->depth = t->deepest > tree->depth ? t->deepest : tree->depth;
      tree->cost += t->cost;
    }
  tree->nodes = is_short ? NULL : k_large_new(total * sizeof *tree->nodes);
  if (!tree->nodes)
    {
      return 0;
    }
  tree->node_count = total;
  b->tree = tree;
  k_in_parallel(b->threads, copy_tasks, b);
  for (uint32_t i = 0; i < b->task_count; i++)
    {
      const struct task *t = &b->tasks[i];
      k_node_at(&b->top, t->parent)->child[t->slot] = t->at;
    }
  copy_nodes(&b->top, 0, b->top.node_count, tree->nodes, 0);
  return 1;
}

static void
worker_free(struct worker *w)
{
  for (uint32_t i = 0; i < w->block_count; i++)
    {
      free(w->blocks[i]);
    }
  free(w->blocks);
}

void
k_builder_free(struct builder *b)
{
  worker_free(&b->top);
  for (unsigned i = 0; b->workers && i < b->threads; i++)
    {
      worker_free(&b->workers[i]);
    }
  free(b->workers);
  free(b->tasks);
}
