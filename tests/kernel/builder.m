// builder.m - the tree: the same for any number of threads and in plain C,
// every shape in one leaf, boxes within those of their parents, and never
// deeper than the search allows for, whatever the boxes.

#import "support.h"
#include "kernel/k_bvh_build.h"
#include "kernel/k_float.h"

// The builder without instruction sets, under other names.
#undef K_SIMD_H
#undef __AVX2__
#undef __SSE2__
#define f4 plain_f4
#define f8 plain_f8
#define d4 plain_d4
#define f4_load plain_f4_load
#define f4_store plain_f4_store
#define f4_all plain_f4_all
#define f4_add plain_f4_add
#define f4_sub plain_f4_sub
#define f4_mul plain_f4_mul
#define f4_min plain_f4_min
#define f4_max plain_f4_max
#define f4_less plain_f4_less
#define f4_xyz plain_f4_xyz
#define f4_turn plain_f4_turn
#define f4_first plain_f4_first
#define f4_to_ints plain_f4_to_ints
#define k_bvh_build plain_bvh_build
#define k_binning_of plain_binning_of
#define k_bins_clear plain_bins_clear
#define k_bins_add plain_bins_add
#define k_bins_join plain_bins_join
#define k_cut_bins plain_cut_bins
#define k_cut_few plain_cut_few
#define k_best_cut plain_best_cut
#define k_part plain_part
#define k_halves plain_halves
#define k_split plain_split
#define k_wide_cut plain_wide_cut
#define k_wide_split plain_wide_split
#define k_roots_of_two plain_roots_of_two
#define k_roots_join plain_roots_join
#define k_fork_left plain_fork_left
#define k_fork_is_leaf plain_fork_is_leaf
#define k_fork_left_of_node plain_fork_left_of_node
#define k_nodes_make plain_nodes_make
enum k_status plain_bvh_build(struct k_tree *tree, struct k_item *items,
                              uint32_t count, unsigned threads);
#include "kernel/k_bvh_build.c"
#include "kernel/k_bvh_cut.c"
#include "kernel/k_bvh_fork.c"
#undef LEAF
#include "kernel/k_bvh_nodes.c"
#include "kernel/k_bvh_wide.c"
#undef k_bvh_build

// Fewer in a build that is not optimised.
#if defined(__OPTIMIZE__) && !defined(__SANITIZE_ADDRESS__)
#define MOST 100000
#else
#define MOST 20000
#endif

enum boxes
{
  RANDOM, FLAKE, SHRINKING, SAME, HUGE_AMONG_TINY, LINE, POINTS, GRID, NESTED,
  TINY, KINDS
};

static const char *names[] = { "random", "clustered", "shrinking", "identical",
  "one huge among tiny", "on a line", "points", "on a grid", "nested",
  "too small for floats" };

static void
set(struct k_item *item, struct k_vec center, struct k_vec half)
{
  for (int axis = 0; axis < 3; axis++)
    {
      double c = k_component(center, axis), h = k_component(half, axis);
      item->least[axis] = k_float_below(c - h);
      item->most[axis] = k_float_above(c + h);
    }
}

static void
make(struct k_item *items, uint32_t n, enum boxes kind)
{
  struct support_random random = support_seed(kind);
  struct k_vec c = k_vec(0, 0, 0);

  memset(items, 0, n * sizeof *items);
  for (uint32_t i = 0; i < n; i++)
    {
      double r = 0.5 / cbrt(n), s = pow(0.5, i % 120 + 1);
      struct k_vec p = support_point(&random, 0.5);
      items[i].ref.kind = K_USER;
      items[i].ref.index = i;
      switch (kind)
        {
        case RANDOM:
          set(&items[i], p, k_scale(support_point(&random, 0.5), 4 * r));
          for (int axis = 0; axis < 3; axis++)
            {
              float a = items[i].least[axis], b = items[i].most[axis];
              items[i].least[axis] = fminf(a, b);
              items[i].most[axis] = fmaxf(a, b);
            }
          break;
        case FLAKE:
          c = i % 100 ? k_along(c, 0.1 * s, p) : p;
          set(&items[i], c, k_vec(0.01 * s, 0.01 * s, 0.01 * s));
          break;
        case SHRINKING:
          set(&items[i], k_vec(s, s, s), k_vec(s / 4, s / 4, s / 4));
          break;
        case SAME:
          set(&items[i], k_vec(0.25, 0.25, 0.25), k_vec(0.5, 0.1, 0.2));
          break;
        case HUGE_AMONG_TINY:
          r = i == n / 2 ? 1 : 0x1p-30;
          set(&items[i], k_scale(p, i == n / 2 ? 0 : 0x1p-20),
              k_vec(r, r, r));
          break;
        case LINE:
          set(&items[i], k_vec(pow(0.999, i), 0, 0), k_vec(0, r, r));
          break;
        case POINTS:
          set(&items[i], i % 2 ? k_vec(0, 0, 0) : p, k_vec(0, 0, 0));
          break;
        case GRID:
          set(&items[i], k_vec(i % 40 / 40.0, i / 40 % 40 / 40.0,
                               i / 1600 / 80.0), k_vec(0.01, 0.01, 0));
          break;
        case NESTED:
          set(&items[i], c, k_vec(1.0 / (i + 1), 1.0 / (i + 1), 0.5));
          break;
        default:
          set(&items[i], k_scale(p, 0x1p-130), k_vec(0, 0, 0));
        }
    }
}

/** Walks the tree: counts the leaves' items, and what is wrong. */
struct walk
{
  const struct k_tree *tree;
  const struct k_item *items;   // as they were at first
  unsigned char seen[MOST];     // by item
  uint32_t nodes;
  unsigned depth, outside, empty, twice;
};

static int
is_in(const float box[6], const float least[3], const float most[3])
{
  int in = 1;

  for (int axis = 0; axis < 3; axis++)
    {
      in &= box[axis] <= least[axis] && most[axis] <= box[axis + 3];
    }
  return in;
}

static void
walk(struct walk *w, uint32_t index, const float *outer, unsigned depth)
{
  const struct k_node *node = &w->tree->nodes[index];

  w->nodes++;
  w->depth = depth > w->depth ? depth : w->depth;
  for (int i = 0; i < K_WIDTH && depth <= 1000; i++)
    {
      float box[6];
      uint32_t child = node->child[i];
      for (int k = 0; k < 6; k++)
        {
          box[k] = node->bounds[k][i];
        }
      if (child == 0)
        {
          w->empty += !(box[0] > box[3]);       // never met
          continue;
        }
      w->outside += outer && !is_in(outer, box, box + 3);
      if (!(child & K_LEAF))
        {
          walk(w, child, box, depth + 1);
          continue;
        }
      uint32_t first = (child & ~K_LEAF) >> 3;
      for (uint32_t k = first; k <= first + (child & 7); k++)
        {
          uint32_t i = w->tree->refs[k].index;
          w->outside += !is_in(box, w->items[i].least, w->items[i].most);
          w->twice += w->seen[i]++ != 0;
        }
    }
}

static int
is_same(const struct k_tree *a, const struct k_tree *b)
{
  return a->node_count == b->node_count && a->depth == b->depth
    && a->cost == b->cost && a->ref_count == b->ref_count
    && memcmp(a->nodes, b->nodes, a->node_count * sizeof *a->nodes) == 0
    && memcmp(a->refs, b->refs, a->ref_count * sizeof *a->refs) == 0;
}

static struct k_tree
tree_of(const struct k_item *items, uint32_t n, unsigned threads,
        enum k_status (*build)(struct k_tree *, struct k_item *, uint32_t,
                               unsigned))
{
  static struct k_item moved[MOST];
  struct k_tree tree = { 0 };

  memcpy(moved, items, n * sizeof *items);
  build(&tree, moved, n, threads);
  return tree;
}

static void
discard(struct k_tree *tree)
{
  free(tree->nodes);
  free(tree->refs);
}

static void
check(enum boxes kind, uint32_t n)
{
  static struct k_item items[MOST];
  static struct walk w;
  unsigned missing = 0;

  make(items, n, kind);
  struct k_tree tree = tree_of(items, n, 1, k_bvh_build);
  struct k_tree by_two = tree_of(items, n, 2, k_bvh_build);
  struct k_tree by_seven = tree_of(items, n, 7, k_bvh_build);
  struct k_tree plain = tree_of(items, n, 2, plain_bvh_build);
  PASS(is_same(&tree, &by_two) && is_same(&tree, &by_seven),
       "%u boxes, %s: the same tree by 1, 2 and 7 threads", n, names[kind]);
  PASS(is_same(&tree, &plain), "the same tree in plain C");

  memset(&w, 0, sizeof w);
  w.tree = &tree;
  w.items = items;
  walk(&w, 0, NULL, 1);
  for (uint32_t i = 0; i < n; i++)
    {
      missing += !w.seen[i];
    }
  PASS(missing == 0 && w.twice == 0,
       "each in one leaf: %u are in none, %u in two", missing, w.twice);
  PASS(w.outside == 0 && w.empty == 0,
       "boxes are in their parents': %u are not; %u empty ones are met",
       w.outside, w.empty);
  PASS(w.nodes == tree.node_count && w.depth == tree.depth
       && w.depth <= K_DEEPEST, "%u nodes, %u levels", w.nodes, w.depth);
  discard(&tree);
  discard(&by_two);
  discard(&by_seven);
  discard(&plain);
}

int
main(void)
{
  for (int kind = RANDOM; kind < KINDS; kind++)
    {
      static const uint32_t counts[] = { 1, 2, 9, 1000, MOST };
      for (int i = 0; i < 5; i++)
        {
          check(kind, counts[i]);
        }
    }
  return test_done();
}
