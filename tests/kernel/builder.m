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
#define f4_to_ints plain_f4_to_ints
#define k_bvh_build plain_bvh_build
#define k_best_cut plain_best_cut
#define k_split plain_split
enum k_status plain_bvh_build(struct k_tree *tree, struct k_item *items,
                              uint32_t count, unsigned threads);
#include "kernel/k_bvh_build.c"
#include "kernel/k_bvh_cut.c"
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
  const struct k_item *items;
  unsigned char seen[MOST];     // by place
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
          w->outside += !is_in(box, w->items[k].least, w->items[k].most);
          w->twice += w->seen[k]++ != 0;
        }
    }
}

static int
is_same(const struct k_tree *a, const struct k_item *i,
        const struct k_tree *b, const struct k_item *j, uint32_t n)
{
  return a->node_count == b->node_count && a->depth == b->depth
    && memcmp(a->nodes, b->nodes, a->node_count * sizeof *a->nodes) == 0
    && memcmp(i, j, n * sizeof *i) == 0;
}

static void
check(enum boxes kind, uint32_t n)
{
  static const unsigned threads[] = { 1, 2, 7 };
  static struct k_item items[3][MOST], original[MOST];
  static struct walk w;
  struct k_tree tree[3] = { { 0 } };
  unsigned missing = 0, changed = 0;

  make(original, n, kind);
  for (int i = 0; i < 3; i++)
    {
      memcpy(items[i], original, n * sizeof *original);
      k_bvh_build(&tree[i], items[i], n, threads[i]);
    }
  PASS(is_same(&tree[0], items[0], &tree[1], items[1], n)
       && is_same(&tree[0], items[0], &tree[2], items[2], n),
       "%u boxes, %s: the same tree by 1, 2 and 7 threads", n, names[kind]);

  memcpy(items[1], original, n * sizeof *original);
  free(tree[1].nodes);
  plain_bvh_build(&tree[1], items[1], n, 2);
  PASS(is_same(&tree[0], items[0], &tree[1], items[1], n),
       "the same tree in plain C");

  memset(&w, 0, sizeof w);
  w.tree = &tree[0];
  w.items = items[0];
  walk(&w, 0, NULL, 1);
  for (uint32_t i = 0; i < n; i++)
    {
      const struct k_item *item = &items[0][i];
      missing += !w.seen[i];
      changed += memcmp(item, &original[item->ref.index], sizeof *item) != 0;
    }
  PASS(missing == 0 && w.twice == 0 && changed == 0,
       "each in one leaf: %u are in none, %u in two, %u changed", missing,
       w.twice, changed);
  PASS(w.outside == 0 && w.empty == 0,
       "boxes are in their parents': %u are not; %u empty ones are met",
       w.outside, w.empty);
  PASS(w.nodes == tree[0].node_count && w.depth == tree[0].depth
       && w.depth <= K_DEEPEST, "%u nodes, %u levels", w.nodes, w.depth);
  for (int i = 0; i < 3; i++)
    {
      free(tree[i].nodes);
    }
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
