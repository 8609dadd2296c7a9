// k_bvh_build.c - the tree over all shapes with a box: split top down where
// the surface area heuristic, in bins, expects the least work (Wald, "On fast
// Construction of SAH-based Bounding Volume Hierarchies", 2007), eight
// children to a node. The tree is a function of the scene alone: threads
// build separate subtrees, which are put together in a fixed order.

#include "k_bvh_build.h"
#include "k_simd.h"
#include <pthread.h>
#include <stdlib.h>
#include <string.h>

#define BINS 16
#define COST_OF_NODE 1.0f       // against asking one shape
#define TASK 4096               // shapes of a subtree that one thread builds

/** A box in vectors: x y z and nothing. */
struct box
{
  f4 least, most;
};

struct range
{
  uint32_t first, count;
  struct box box;
  struct box centers;           // of twice the middles: least + most
};

/** A subtree that is still to be built. */
struct task
{
  struct range range;
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

static inline struct box
no_box(void)
{
  struct box b = { f4_all(HUGE_VALF), f4_all(-HUGE_VALF) };
  return b;
}

static inline struct box
box_of(const struct k_item *item)
{
  struct box b = { f4_load(item->least), f4_load(item->most) };
  return b;
}

static inline struct box
join(struct box a, struct box b)
{
  a.least = f4_min(a.least, b.least);
  a.most = f4_max(a.most, b.most);
  return a;
}

static inline float
half_area(struct box b)
{
  float s[4];

  f4_store(s, f4_sub(b.most, b.least));
  return s[0] < 0 ? 0 : s[0] * s[1] + s[1] * s[2] + s[2] * s[0];
}

/** The range with one more item, wherever that stands. */
static inline void
include(struct range *r, const struct k_item *item)
{
  struct box b = box_of(item);
  f4 c = f4_add(b.least, b.most);

  r->box = join(r->box, b);
  r->centers.least = f4_min(r->centers.least, c);
  r->centers.most = f4_max(r->centers.most, c);
}

/** How the middles of a range fall into bins, on all three axes. */
struct binning
{
  f4 origin, scale;
  int bins;
};

static struct binning
binning_of(const struct range *r)
{
  struct binning b;
  float width[4], scale[4] = { 0 };

  b.bins = r->count < 16 ? 8 : BINS;
  b.origin = r->centers.least;
  f4_store(width, f4_sub(r->centers.most, r->centers.least));
  for (int axis = 0; axis < 3; axis++)
    {
      float s = 0.9999f * b.bins / width[axis];
      scale[axis] = width[axis] > 0 && s < HUGE_VALF ? s : 0;
    }
  b.scale = f4_load(scale);
  return b;
}

static inline void
bins_of(const struct binning *b, const struct k_item *item, int32_t bins[4])
{
  f4 c = f4_add(f4_load(item->least), f4_load(item->most));

  f4_to_ints(bins, f4_mul(f4_sub(c, b->origin), b->scale));
}

/** Where a range is best split: an axis and the first bin of the right part;
    the cost of asking both parts. Axis -1: nowhere. */
struct cut
{
  struct binning binning;
  int axis, at;
  float cost;
};

static void
try_axis(struct cut *cut, int axis, const struct box *boxes,
         const uint32_t *counts)
{
  float left_cost[BINS];
  int bins = cut->binning.bins;
  struct box sum = no_box();
  uint32_t n = 0;

  for (int i = 0; i < bins - 1; i++)
    {
      sum = join(sum, boxes[i]);
      n += counts[i];
      left_cost[i] = n ? half_area(sum) * n : HUGE_VALF;
    }
  sum = no_box();
  n = 0;
  for (int i = bins - 1; i > 0; i--)
    {
      sum = join(sum, boxes[i]);
      n += counts[i];
      float cost = left_cost[i - 1] + half_area(sum) * n;
      if (n && cost < cut->cost)
        {
          cut->cost = cost;
          cut->at = i;
          cut->axis = axis;
        }
    }
}

static struct cut
best_cut(const struct k_item *items, const struct range *r)
{
  struct cut cut = { binning_of(r), -1, 0, HUGE_VALF };
  struct box boxes[3][BINS];
  uint32_t counts[3][BINS];
  float scale[4];

  for (int axis = 0; axis < 3; axis++)
    {
      for (int i = 0; i < cut.binning.bins; i++)
        {
          boxes[axis][i] = no_box();
          counts[axis][i] = 0;
        }
    }
  for (uint32_t i = r->first; i < r->first + r->count; i++)
    {
      struct box b = box_of(&items[i]);
      int32_t bin[4];
      bins_of(&cut.binning, &items[i], bin);
      for (int axis = 0; axis < 3; axis++)
        {
          boxes[axis][bin[axis]] = join(boxes[axis][bin[axis]], b);
          counts[axis][bin[axis]]++;
        }
    }
  f4_store(scale, cut.binning.scale);
  for (int axis = 0; axis < 3; axis++)
    {
      if (scale[axis] > 0)
        {
          try_axis(&cut, axis, boxes[axis], counts[axis]);
        }
    }
  return cut;
}

static struct range
empty_range(uint32_t first)
{
  struct range r = { first, 0, no_box(), no_box() };
  return r;
}

/** Splits a range in two; in the middle of the list when no cut parts it. */
static void
split(struct k_item *items, const struct range *whole, const struct cut *cut,
      struct range *left, struct range *right)
{
  struct range a = empty_range(whole->first), b = a;
  uint32_t low = whole->first, high = whole->first + whole->count;

  while (low < high)
    {
      int32_t bin[4];
      int goes_left = low - whole->first < whole->count / 2;
      if (cut->axis >= 0)
        {
          bins_of(&cut->binning, &items[low], bin);
          goes_left = bin[cut->axis] < cut->at;
        }
      if (goes_left)
        {
          include(&a, &items[low++]);
        }
      else
        {
          include(&b, &items[low]);
          struct k_item swap = items[low];
          items[low] = items[--high];
          items[high] = swap;
        }
    }
  a.count = low - a.first;
  b.first = low;
  b.count = whole->count - a.count;
  *left = a;
  *right = b;
}

struct child
{
  struct range range;
  struct cut cut;
  int is_leaf;
  float area;
};

/** Looks for the best cut; leaves the range as it is when asking its shapes is
    cheaper than another node. */
static void
consider(const struct k_item *items, struct child *c)
{
  const struct range *r = &c->range;

  c->area = half_area(r->box);
  c->is_leaf = r->count == 1;
  if (!c->is_leaf)
    {
      c->cut = best_cut(items, r);
      c->is_leaf = r->count <= K_LEAF_MOST
        && (c->cut.axis < 0
            || c->cut.cost + COST_OF_NODE * c->area >= r->count * c->area);
    }
}

/** Splits a range into as many as eight, the largest first. */
static int
children_of(struct k_item *items, const struct range *r,
            struct child *children)
{
  int count = 1;

  children[0].range = *r;
  consider(items, &children[0]);
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
      split(items, &parent.range, &parent.cut, &children[widest].range,
            &children[count].range);
      consider(items, &children[widest]);
      consider(items, &children[count]);
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
      struct box box = i < count ? children[i].range.box : no_box();
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
put_off(struct builder *b, const struct range *r, unsigned depth,
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
build(struct builder *b, struct task *t, const struct range *r,
      unsigned depth)
{
  struct child children[K_WIDTH];
  int count = children_of(b->items, r, children);
  uint32_t index = add_node(t, children, count);

  t->deepest = depth > t->deepest ? depth : t->deepest;
  for (int i = 0; i < count && !t->is_short_of_memory; i++)
    {
      const struct range *c = &children[i].range;
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
      struct range r = t->range;
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
  struct range all = empty_range(0);
  enum k_status status;

  for (uint32_t i = 0; i < count; i++)
    {
      include(&all, &items[i]);
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
