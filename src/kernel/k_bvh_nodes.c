// k_bvh_nodes.c - the nodes of a tree, made of its forks: those at the top,
// then, by all threads, those of each task behind those of the one before.

#include "k_bvh_work.h"
#include "k_parallel.h"
#include "../large.h"
#include <stdlib.h>
#include <string.h>

/** Nodes in the making. */
struct making
{
  struct builder *b;
  uint32_t next_node;
  unsigned deepest;             // level so far; the root's is 1
  double cost;                  // of all children so far, by their surfaces
  int is_top;                   // ends at the tasks, which it puts in place
};

/** A list: its first fork and its items. */
struct list
{
  uint32_t fork, first, count;
};

static struct list
left_of(const struct list *l, const struct k_fork *fork)
{
  struct list left = { l->fork + 1, l->first, fork->left };
  return left;
}

static struct list
right_of(const struct list *l, const struct k_fork *fork)
{
  struct list right = { l->fork + fork->left, l->first + fork->left,
                        l->count - fork->left };
  return right;
}

/** Gives a child its box; `cost` is that of asking it. */
static void
set_box(struct making *m, struct k_node *node, unsigned slot,
        struct k_box box, uint32_t cost)
{
  float least[4], most[4];

  f4_store(least, box.least);
  f4_store(most, box.most);
  m->cost += (double)k_half_area(box) * cost;
  for (int axis = 0; axis < 3; axis++)
    {
      node->bounds[axis][slot] = least[axis];
      node->bounds[axis + 3][slot] = most[axis];
    }
}

/** Lists the shapes of a leaf; what the leaf is as a child, and its box. */
static uint32_t
leaf_of(const struct builder *b, const struct list *l, struct k_box *box)
{
  *box = k_no_box();
  for (uint32_t i = l->first; i < l->first + l->count; i++)
    {
      b->tree->refs[i] = b->items[i].ref;
      *box = k_join(*box, k_box_of(&b->items[i]));
    }
  return K_LEAF | l->first << 3 | (l->count - 1);
}

static uint32_t node_of(struct making *m, const struct list *l,
                        unsigned level, struct k_box *box);

/** Makes a list one child of a node at that level; its box. */
static struct k_box
make_child(struct making *m, const struct list *l, struct k_node *node,
           unsigned slot, unsigned level)
{
  const struct builder *b = m->b;
  int is_leaf = l->count == 1 || k_fork_is_leaf(&b->forks[l->fork]);
  struct k_box box;

  node->child[slot] = is_leaf ? leaf_of(b, l, &box)
    : node_of(m, l, level + 1, &box);
  set_box(m, node, slot, box, is_leaf ? l->count : 1);
  return box;
}

/** Makes a list up to `most` children of a node, from a slot on; returns the
    slot behind them. Their boxes are joined to that of the node. */
static unsigned
make_children(struct making *m, const struct list *l, unsigned most,
              struct k_node *node, unsigned slot, unsigned level,
              struct k_box *box)
{
  struct builder *b = m->b;
  const struct k_fork *fork = &b->forks[l->fork];
  unsigned on_left = l->count == 1 ? 0 : k_fork_left(fork, &most);

  if (m->is_top && l->count <= K_TASK)
    {
      struct task *t = &b->tasks[b->next_task++];
      t->most = on_left ? most : 1;
      t->node = node;
      t->slot = slot;
      t->level = level;
      *box = k_join(*box, t->range.box);
      return slot + t->most;
    }
  if (on_left == 0)
    {
      *box = k_join(*box, make_child(m, l, node, slot, level));
      return slot + 1;
    }
  struct list left = left_of(l, fork), right = right_of(l, fork);
  slot = make_children(m, &left, on_left, node, slot, level, box);
  return make_children(m, &right, most - on_left, node, slot, level, box);
}

/** A node without children: boxes that nothing meets. */
static struct k_node *
new_node(struct making *m, unsigned level)
{
  struct k_node *node = &m->b->tree->nodes[m->next_node++];

  for (int i = 0; i < K_WIDTH; i++)
    {
      for (int axis = 0; axis < 3; axis++)
        {
          node->bounds[axis][i] = HUGE_VALF;
          node->bounds[axis + 3][i] = -HUGE_VALF;
        }
      node->child[i] = 0;
    }
  m->deepest = level > m->deepest ? level : m->deepest;
  return node;
}

/** Makes a list a node; its number, and its box. */
static uint32_t
node_of(struct making *m, const struct list *l, unsigned level,
        struct k_box *box)
{
  uint32_t number = m->next_node;
  struct k_node *node = new_node(m, level);
  const struct k_fork *fork = &m->b->forks[l->fork];
  unsigned on_left = k_fork_left_of_node(fork);
  struct list left = left_of(l, fork), right = right_of(l, fork);

  *box = k_no_box();
  unsigned slot = make_children(m, &left, on_left, node, 0, level, box);
  make_children(m, &right, K_WIDTH - on_left, node, slot, level, box);
  return number;
}

/** Makes the nodes of tasks as long as there are any. */
static void
make_tasks(void *builder, unsigned thread)
{
  struct builder *b = builder;
  uint32_t i;

  (void)thread;
  while ((i = k_take(&b->next_task, b->task_count)) < b->task_count)
    {
      struct task *t = &b->tasks[i];
      struct making m = { .b = b, .next_node = t->first_node };
      struct list l = { t->fork, t->range.first, t->range.count };
      struct k_box box = k_no_box();    // nobody asks
      make_children(&m, &l, t->most, t->node, t->slot, t->level, &box);
      large_drop(&b->items[l.first], l.count * sizeof *b->items);
      t->deepest = m.deepest;
      t->cost = m.cost;
    }
}

/** The root and what is above the tasks; all if there is but one. */
static void
make_top(struct making *m)
{
  const struct builder *b = m->b;
  struct list all = { 0, 0, b->count };
  struct k_box box;

  if (b->count > 1 && !k_fork_is_leaf(b->forks))
    {
      node_of(m, &all, 1, &box);
      return;
    }
  make_child(m, &all, new_node(m, 1), 0, 1);
}

int
k_nodes_make(struct builder *b, const struct k_roots *roots,
             struct k_tree *tree)
{
  struct making top = { .b = b, .is_top = b->count > K_TASK };
  uint32_t count = roots->nodes[0] ? roots->nodes[0] : 1;

  b->tree = tree;
  tree->nodes = large_new(count * sizeof *tree->nodes);
  tree->refs = malloc(b->count * sizeof *tree->refs);
  if (!tree->nodes || !tree->refs)
    {
      return 0;
    }
  tree->node_count = count;
  tree->ref_count = b->count;
  b->next_task = 0;
  make_top(&top);
  if (top.is_top)
    {
      uint32_t next = top.next_node;
      for (uint32_t i = 0; i < b->task_count; i++)
        {
          b->tasks[i].first_node = next;
          next += b->tasks[i].roots.nodes[b->tasks[i].most - 1];
        }
      b->next_task = 0;
      k_in_parallel(b->threads, make_tasks, b);
      for (uint32_t i = 0; i < b->task_count; i++)
        {
          const struct task *t = &b->tasks[i];
          top.deepest = t->deepest > top.deepest ? t->deepest : top.deepest;
          top.cost += t->cost;
        }
    }
  tree->depth = top.deepest;
  tree->cost = b->area > 0 ? 1 + top.cost / b->area : 0;
  return 1;
}
