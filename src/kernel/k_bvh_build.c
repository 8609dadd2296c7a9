// k_bvh_build.c - the tree over all shapes with a box: split top down where
// the surface area heuristic, in bins, expects the least work (Wald, "On fast
// Construction of SAH-based Bounding Volume Hierarchies", 2007), eight
// children to a node. The tree is a function of the scene alone: threads
// build separate subtrees, which are put together in a fixed order.

#include "k_bvh_work.h"
#include "k_memory.h"
#include "k_parallel.h"
#include <stdlib.h>
#include <string.h>

#define COST_OF_NODE 1.0f       // against asking one shape
#define DEEP 40                 // from this level on lists are halved, which
                                // ends within 32 more: K_DEEPEST
#define TASK 32768              // shapes of a subtree that one thread builds

struct child
{
  struct k_range range;
  struct k_cut cut;
  int is_leaf;
  float area;
};

/** Several threads share the large lists, of which only the top has any. */
static int
is_wide(const struct builder *b, const struct k_range *r)
{
  return b->threads > 1 && r->count >= K_WIDE;
}

/** Looks for the best cut; it is a leaf when asking its shapes is cheaper than
    another node. */
static void
consider(const struct builder *b, struct child *c, unsigned depth)
{
  const struct k_range *r = &c->range;

  c->area = k_half_area(r->box);
  c->is_leaf = r->count == 1;
  if (!c->is_leaf)
    {
      if (is_wide(b, r))
        {
          k_wide_cut(r, b->threads, &c->cut);
        }
      else
        {
          k_best_cut(r, &c->cut);
        }
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
children_of(const struct builder *b, const struct k_range *r,
            struct child *children, unsigned depth)
{
  int count = 1;

  children[0].range = *r;
  consider(b, &children[0], depth);
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
      struct child *left = &children[widest], *right = &children[count++];
      if (is_wide(b, &left->range))
        {
          k_wide_split(&left->range, &left->cut, b->threads, &left->range,
                       &right->range);
        }
      else
        {
          k_split(&left->range, &left->cut, &left->range, &right->range);
        }
      consider(b, left, depth);
      consider(b, right, depth);
    }
  return count;
}

/** Fills in the children's boxes. */
static void
set_boxes(struct k_node *node, const struct child *children, int count)
{
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
  b->tasks[b->task_count++] = (struct task){
    .range = *r, .depth = depth, .parent = parent, .slot = slot
  };
}

/** Lists the shapes of a leaf; what the leaf is as a child. */
static uint32_t
make_leaf(struct builder *b, const struct k_range *r)
{
  for (uint32_t i = 0; i < r->count; i++)
    {
      b->refs[r->first + i] = r->items[i].ref;
    }
  return K_LEAF | r->first << 3 | (r->count - 1);
}

/** Makes a node of a range and all below it; its number from the start of the
    task. In the top the subtrees that are small enough are put off. */
static uint32_t
build(struct builder *b, struct worker *w, const struct k_range *r,
      unsigned depth)
{
  struct child children[K_WIDTH];
  int count = children_of(b, r, children, depth);
  uint32_t number = k_worker_node(w);

  if (w->is_short_of_memory)
    {
      return 0;
    }
  struct k_node *node = k_node_at(w, number);
  set_boxes(node, children, count);
  w->depth = depth > w->depth ? depth : w->depth;
  for (int i = 0; i < count && !w->is_short_of_memory; i++)
    {
      const struct k_range *c = &children[i].range;
      w->cost += (double)children[i].area
        * (children[i].is_leaf ? c->count : 1);
      if (children[i].is_leaf)
        {
          node->child[i] = make_leaf(b, c);
        }
      else if (w == &b->top && c->count <= TASK)
        {
          put_off(b, c, depth + 1, number, i);
        }
      else
        {
          node->child[i] = build(b, w, c, depth + 1) - w->start;
        }
    }
  return number;
}

/** Builds tasks as long as there are any. */
static void
work(void *builder, unsigned number)
{
  struct builder *b = builder;
  struct worker *w = &b->workers[number];
  uint32_t i;

  while ((i = k_take(&b->next_task, b->task_count)) < b->task_count)
    {
      struct task *t = &b->tasks[i];
      w->start = w->node_count;
      w->cost = 0;
      w->depth = 0;
      build(b, w, &t->range, t->depth);
      t->worker = number;
      t->node_count = w->node_count - w->start;
      t->cost = w->cost;
      t->deepest = w->depth;
    }
}

/** The largest first, which leaves the least to wait for at the end. */
static int
by_size(const void *p, const void *q)
{
  const struct task *a = p, *b = q;

  return a->range.count != b->range.count
    ? (a->range.count > b->range.count ? -1 : 1)
    : a->range.first < b->range.first ? -1 : 1;
}

static struct k_range
all_of(struct k_item *items, struct k_item *spare, uint32_t count)
{
  struct k_range all = { items, spare, 0, count, k_no_box(), k_no_box() };

  for (uint32_t i = 0; i < count; i++)
    {
      k_include(&all, &items[i]);
    }
  return all;
}

static enum k_status
build_all(struct builder *b, struct k_tree *tree, struct k_item *items,
          struct k_item *spare, uint32_t count)
{
  struct k_range all = all_of(items, spare, count);
  double area = k_half_area(all.box);

  build(b, &b->top, &all, 1);
  qsort(b->tasks, b->task_count, sizeof *b->tasks, by_size);
  k_in_parallel(b->threads, work, b);
  tree->refs = b->refs;
  tree->ref_count = count;
  if (!k_put_together(b, tree))
    {
      return K_NO_MEMORY;
    }
  tree->cost = area > 0 ? 1 + tree->cost / area : 0;
  return K_OK;
}

enum k_status
k_bvh_build(struct k_tree *tree, struct k_item *items, uint32_t count,
            unsigned threads)
{
  enum k_status status = K_NO_MEMORY;
  struct k_item *spare = k_large_new(count * sizeof *spare);
  struct builder b = { .threads = count > TASK ? threads : 1 };

  b.workers = calloc(b.threads, sizeof *b.workers);
  b.refs = malloc(count * sizeof *b.refs);
  if (spare && b.workers && b.refs)
    {
      status = build_all(&b, tree, items, spare, count);
    }
  else
    {
      free(b.refs);
    }
  k_builder_free(&b);
  free(spare);
  return status;
}
