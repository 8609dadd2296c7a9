// k_bvh_build.c - the tree over all shapes with a box: lists are cut in two
// where the surface area heuristic, in bins, expects the least work (Wald, "On
// fast Construction of SAH-based Bounding Volume Hierarchies", 2007), down to
// single shapes. The tree is a function of the scene alone: threads share the
// long lists, and take one each of the shorter ones.

#include "k_bvh_work.h"
#include "k_parallel.h"
#include "../large.h"
#include <stdlib.h>
#include <string.h>

#define DEEP 64                 // from this fork on lists are halved, which
                                // ends within 32 more: K_DEEPEST

/** A fork of a range; its parts. */
static void
split(const struct builder *b, const struct k_range *r, uint32_t fork,
      unsigned depth, struct k_range *left, struct k_range *right)
{
  int is_wide = b->threads > 1 && r->count >= K_WIDE;
  struct k_cut cut;

  cut.axis = -1;
  if (depth <= DEEP && is_wide)
    {
      k_wide_cut(r, b->threads, &cut);
    }
  else if (depth <= DEEP)
    {
      k_best_cut(r, &cut);
    }
  if (is_wide)
    {
      k_wide_split(r, &cut, b->threads, left, right);
    }
  else
    {
      k_split(r, &cut, left, right);
    }
  b->forks[fork].left = left->count;
}

/** Makes the fork of a range of two, which every other fork is. */
static void
fork_two(const struct builder *b, const struct k_range *r, uint32_t fork,
         float area, struct k_roots *roots)
{
  struct k_item *items = &b->items[r->first];
  struct k_fork *f = &b->forks[fork];

  items[0] = r->items[0];
  items[1] = r->items[1];
  f->left = 1;
  k_roots_of_two(roots, f, area, k_half_area(k_box_of(&items[0]))
                 + k_half_area(k_box_of(&items[1])));
}

/** Makes the forks of a range. */
static void
fork_all(const struct builder *b, const struct k_range *r, uint32_t fork,
         unsigned depth, struct k_roots *roots)
{
  struct k_roots of_left, of_right;
  struct k_range left, right;
  float area = k_half_area(r->box);

  if (r->count == 1)
    {
      b->items[r->first] = r->items[0];
      k_roots_of_one(roots, area);
      return;
    }
  if (r->count == 2)
    {
      fork_two(b, r, fork, area, roots);
      return;
    }
  split(b, r, fork, depth, &left, &right);
  fork_all(b, &left, fork + 1, depth + 1, &of_left);
  fork_all(b, &right, fork + left.count, depth + 1, &of_right);
  k_roots_join(roots, &b->forks[fork], r->count, area, &of_left, &of_right);
}

/** Makes the forks at the top and puts off the tasks below them. 0: no
    memory. */
static int
fork_top(struct builder *b, const struct k_range *r, uint32_t fork,
         unsigned depth)
{
  if (r->count > K_TASK)
    {
      struct k_range left, right;
      split(b, r, fork, depth, &left, &right);
      return fork_top(b, &left, fork + 1, depth + 1)
        && fork_top(b, &right, fork + left.count, depth + 1);
    }
  if (b->task_count == b->task_room)
    {
      uint32_t room = b->task_room ? 2 * b->task_room : 64;
      struct task *tasks = realloc(b->tasks, room * sizeof *tasks);
      if (!tasks)
        {
          return 0;
        }
      b->tasks = tasks;
      b->task_room = room;
    }
  b->tasks[b->task_count++] = (struct task){
    .range = *r, .fork = fork, .depth = depth
  };
  return 1;
}

/** Makes the forks of tasks as long as there are any. */
static void
fork_tasks(void *builder, unsigned thread)
{
  struct builder *b = builder;
  uint32_t i;

  (void)thread;
  while ((i = k_take(&b->next_task, b->task_count)) < b->task_count)
    {
      struct task *t = &b->tasks[i];
      fork_all(b, &t->range, t->fork, t->depth, &t->roots);
    }
}

/** Goes through the forks at the top once more: what all costs. The box of the
    list. */
static struct k_box
join_top(struct builder *b, uint32_t fork, uint32_t count,
         struct k_roots *roots)
{
  if (count <= K_TASK)
    {
      const struct task *t = &b->tasks[b->next_task++];
      *roots = t->roots;
      return t->range.box;
    }
  struct k_roots left, right;
  struct k_fork *f = &b->forks[fork];
  struct k_box on_left = join_top(b, fork + 1, f->left, &left);
  struct k_box box = k_join(on_left, join_top(b, fork + f->left,
                                              count - f->left, &right));

  k_roots_join(roots, f, count, k_half_area(box), &left, &right);
  return box;
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

/** Makes all forks; with one shape there is none. 0: no memory. */
static int
make_forks(struct builder *b, struct k_roots *roots)
{
  struct k_item *spare = large_new(b->count * sizeof *spare);
  int is_done = 0;

  b->forks = large_new(b->count * sizeof *b->forks);
  if (spare && b->forks)
    {
      struct k_range all = all_of(b->items, spare, b->count);
      b->area = k_half_area(all.box);
      is_done = fork_top(b, &all, 0, 1);
    }
  if (is_done)
    {
      k_in_parallel(b->threads, fork_tasks, b);
      b->next_task = 0;
      join_top(b, 0, b->count, roots);
    }
  free(spare);
  return is_done;
}

enum k_status
k_bvh_build(struct k_tree *tree, struct k_item *items, uint32_t count,
            unsigned threads)
{
  struct builder b = { .threads = count > K_TASK ? threads : 1,
                       .items = items, .count = count };
  struct k_roots roots;
  int is_done = make_forks(&b, &roots) && k_nodes_make(&b, &roots, tree);

  free(b.forks);
  free(b.tasks);
  return is_done ? K_OK : K_NO_MEMORY;
}
