// k_bvh_build.c - the tree over all shapes with a box: split top down where
// the surface area heuristic, in bins, expects the least work (Wald, "On fast
// Construction of SAH-based Bounding Volume Hierarchies", 2007), eight
// children to a node. The tree is a function of the scene alone: threads
// build separate subtrees, which are put together in a fixed order.

#include "k_bvh_build.h"
#include "k_bvh_cut.h"
#include <pthread.h>
#include <stdlib.h>
#include <string.h>

#define COST_OF_NODE 0.5f
#define DEEP 40                 // from this level on lists are halved, which
                                // ends within 32 more: K_DEEPEST
#define TASK 4096               // shapes of a subtree that one thread builds

/** A subtree that is still to be built. */
struct task
{
  struct k_range range;
  unsigned depth;
  uint32_t parent;              // node and slot of the tree it hangs on
  int slot;
  struct k_node *nodes;         // its own nodes, children from 0
  uint32_t node_count, node_room;
  unsigned deepest;
  int is_short_of_memory;
};

struct builder
{
  struct k_item *items;
  struct task top;              // the nodes above all tasks
  struct task *tasks;
  uint32_t task_count, task_room;
  uint32_t next_task;           // atomic
};

struct child
{
  struct k_range range;
  struct k_cut cut;
  int is_leaf;
  float area;
};

/** Looks for the best cut; leaves the range as it is when asking its shapes is
    cheaper than another node. */
static void
consider(const struct k_item *items, struct child *c, unsigned depth)
{
  const struct k_range *r = &c->range;

  c->area = k_half_area(r->box);
  c->is_leaf = r->count == 1;
  if (!c->is_leaf)
    {
      c->cut = k_best_cut(items, r);
      if (depth > DEEP)
        {
          c->cut.axis = -1;
        }
      c->is_leaf = r->count <= K_LEAF_MOST
        && (c->cut.axis < 0
            || c->cut.cost + COST_OF_NODE * c->area >= r->count * c->area);
    }
}

/** Splits a range into as many as eight, the largest first. */
static int
children_of(struct k_item *items, const struct k_range *r,
            struct child *children, unsigned depth)
{
  int count = 1;

  children[0].range = *r;
  consider(items, &children[0], depth);
  while (count < K_WIDTH)
    {
      int widest = -1;
      for (int i = 0; i < count; i++)
        {
          if (!children[i].is_leaf
              && (widest < 0 || children[i].area > children[widest].area))
            {
              widest = i;
            }
        }
      if (widest < 0)
        {
          break;
        }
      struct child parent = children[widest];
      k_split(items, &parent.range, &parent.cut, &children[widest].range,
            &children[count].range);
      consider(items, &children[widest], depth);
      consider(items, &children[count], depth);
      count++;
    }
  return count;
}

/** A new node with the children's boxes; its index in the task. */
static uint32_t
add_node(struct task *t, const struct child *children, int count)
{
  if (t->node_count == t->node_room)
    {
      uint32_t room = t->node_room ? 2 * t->node_room : 64;
      struct k_node *nodes = realloc(t->nodes, room * sizeof *nodes);
      if (!nodes)
        {
          t->is_short_of_memory = 1;
          return 0;
        }
      t->nodes = nodes;
      t->node_room = room;
    }
  struct k_node *node = &t->nodes[t->node_count];
  for (int i = 0; i < K_WIDTH; i++)
    {
      struct k_box box = i < count ? children[i].range.box : k_no_box();
      float least[4], most[4];
      f4_store(least, box.least);
      f4_store(most, box.most);
      for (int axis = 0; axis < 3; axis++)
        {
          node->bounds[axis][i] = least[axis];
          node->bounds[axis + 3][i] = most[axis];
        }
      node->child[i] = 0;
    }
  return t->node_count++;
}

static void
put_off(struct builder *b, const struct k_range *r, unsigned depth,
        uint32_t parent, int slot)
{
  if (b->task_count == b->task_room)
    {
      uint32_t room = b->task_room ? 2 * b->task_room : 64;
      struct task *tasks = realloc(b->tasks, room * sizeof *tasks);
      if (!tasks)
        {
          b->top.is_short_of_memory = 1;
          return;
        }
      b->tasks = tasks;
      b->task_room = room;
    }
  struct task *t = &b->tasks[b->task_count++];
  memset(t, 0, sizeof *t);
  t->range = *r;
  t->depth = depth;
  t->parent = parent;
  t->slot = slot;
}

/** Makes a node of a range and all below it; its index in the task. Above the
    tasks (t is b->top) the subtrees that are small enough are put off. */
static uint32_t
build(struct builder *b, struct task *t, const struct k_range *r,
      unsigned depth)
{
  struct child children[K_WIDTH];
  int count = children_of(b->items, r, children, depth);
  uint32_t index = add_node(t, children, count);

  t->deepest = depth > t->deepest ? depth : t->deepest;
  for (int i = 0; i < count && !t->is_short_of_memory; i++)
    {
      const struct k_range *c = &children[i].range;
      if (children[i].is_leaf)
        {
          t->nodes[index].child[i] = K_LEAF | c->first << 3 | (c->count - 1);
        }
      else if (t == &b->top && c->count <= TASK)
        {
          put_off(b, c, depth + 1, index, i);
        }
      else
        {
          uint32_t child = build(b, t, c, depth + 1);
          t->nodes[index].child[i] = child;
        }
    }
  return index;
}

static void *
work(void *builder)
{
  struct builder *b = builder;
  uint32_t i;

  while ((i = __atomic_fetch_add(&b->next_task, 1, __ATOMIC_RELAXED))
         < b->task_count)
    {
      struct task *t = &b->tasks[i];
      struct k_range r = t->range;
      build(b, t, &r, t->depth);
    }
  return NULL;
}

/** Builds the tasks with this and other threads. */
static void
run_tasks(struct builder *b, unsigned threads)
{
  pthread_t others[threads];
  unsigned started = 0;

  while (started + 1 < threads
         && pthread_create(&others[started], NULL, work, b) == 0)
    {
      started++;
    }
  work(b);
  while (started)
    {
      pthread_join(others[--started], NULL);
    }
}

/** Hangs all subtrees on the top, in order. */
static enum k_status
put_together(struct builder *b, struct k_tree *tree)
{
  uint32_t total = b->top.node_count;
  int is_short = b->top.is_short_of_memory;

  tree->depth = b->top.deepest;
  for (uint32_t i = 0; i < b->task_count; i++)
    {
      const struct task *t = &b->tasks[i];
      total += t->node_count;
      is_short |= t->is_short_of_memory;
      tree->depth = t->deepest > tree->depth ? t->deepest : tree->depth;
    }
  struct k_node *nodes = is_short ? NULL
    : aligned_alloc(64, (total * sizeof *nodes + 63) / 64 * 64);
  if (!nodes)
    {
      return K_NO_MEMORY;
    }
  memcpy(nodes, b->top.nodes, b->top.node_count * sizeof *nodes);
  uint32_t at = b->top.node_count;
  for (uint32_t i = 0; i < b->task_count; i++)
    {
      const struct task *t = &b->tasks[i];
      nodes[t->parent].child[t->slot] = at;
      for (uint32_t k = 0; k < t->node_count; k++)
        {
          struct k_node *node = &nodes[at + k];
          *node = t->nodes[k];
          for (int c = 0; c < K_WIDTH; c++)
            {
              // 0 is no node's child: an empty slot.
              node->child[c] += node->child[c] & K_LEAF
                || node->child[c] == 0 ? 0 : at;
            }
        }
      at += t->node_count;
    }
  tree->nodes = nodes;
  tree->node_count = total;
  return K_OK;
}

enum k_status
k_bvh_build(struct k_tree *tree, struct k_item *items, uint32_t count,
            unsigned threads)
{
  struct builder b = { .items = items };
  struct k_range all = k_empty_range(0);
  enum k_status status;

  for (uint32_t i = 0; i < count; i++)
    {
      k_include(&all, &items[i]);
    }
  all.count = count;
  build(&b, &b.top, &all, 1);
  run_tasks(&b, threads);
  status = put_together(&b, tree);
  for (uint32_t i = 0; i < b.task_count; i++)
    {
      free(b.tasks[i].nodes);
    }
  free(b.tasks);
  free(b.top.nodes);
  return status;
}
