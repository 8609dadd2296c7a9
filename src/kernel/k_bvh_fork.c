// k_bvh_fork.c - see k_bvh_fork.h.

#include "k_bvh_fork.h"

#define COST_OF_NODE 1.5f       // against asking one shape

// A fork's choice: 3 bits for each number of children k of 2 to 8, from bit
// 3 (k - 2) on: how many of these are on the left, 0 when k - 1 are no worse.
// The same for its own node from bit 21 on. Bit 24: it is a leaf.
#define OF_NODE 21
#define LEAF (1u << 24)

void
k_roots_join(struct k_roots *roots, struct k_fork *fork, uint32_t count,
             float area, const struct k_roots *left,
             const struct k_roots *right)
{
  const unsigned most = count < K_WIDTH ? count : K_WIDTH;
  unsigned lefts[K_WIDTH + 1], of_node = 1;
  float best = HUGE_VALF;

  // As k children, none of which is the whole list.
  for (unsigned k = 2; k <= most; k++)
    {
      lefts[k] = 0;
      for (unsigned l = 1; l < k; l++)
        {
          float cost = left->cost[l - 1] + right->cost[k - l - 1];
          lefts[k] = cost < best ? l : lefts[k];
          best = cost < best ? cost : best;
        }
      of_node = lefts[k] ? lefts[k] : of_node;
      roots->cost[k - 1] = best;
    }
  // As one.
  fork->choice = of_node << OF_NODE;
  roots->cost[0] = COST_OF_NODE * area + best;
  roots->nodes[0] = 1 + left->nodes[of_node - 1]
    + right->nodes[K_WIDTH - of_node - 1];
  if (count <= K_LEAF_MOST && count * area <= roots->cost[0])
    {
      fork->choice |= LEAF;
      roots->cost[0] = count * area;
      roots->nodes[0] = 0;
    }
  // As up to k.
  for (unsigned k = 2; k <= K_WIDTH; k++)
    {
      if (k <= most && roots->cost[k - 1] < roots->cost[k - 2])
        {
          fork->choice |= lefts[k] << 3 * (k - 2);
          roots->nodes[k - 1] = left->nodes[lefts[k] - 1]
            + right->nodes[k - lefts[k] - 1];
        }
      else
        {
          roots->cost[k - 1] = roots->cost[k - 2];
          roots->nodes[k - 1] = roots->nodes[k - 2];
        }
    }
}

void
k_roots_of_two(struct k_roots *roots, struct k_fork *fork, float area,
               float both)
{
  float as_leaf = 2 * area, as_node = COST_OF_NODE * area + both;
  int is_leaf = as_leaf <= as_node;
  float as_one = is_leaf ? as_leaf : as_node;
  int is_better_two = both < as_one;

  fork->choice = 1 << OF_NODE | (is_leaf ? LEAF : 0) | is_better_two;
  roots->cost[0] = as_one;
  roots->nodes[0] = !is_leaf;
  for (int i = 1; i < K_WIDTH; i++)
    {
      roots->cost[i] = is_better_two ? both : as_one;
      roots->nodes[i] = is_better_two ? 0 : !is_leaf;
    }
}

unsigned
k_fork_left(const struct k_fork *fork, unsigned *most)
{
  for (; *most > 1; --*most)
    {
      unsigned left = fork->choice >> 3 * (*most - 2) & 7;
      if (left)
        {
          return left;
        }
    }
  return 0;
}

int
k_fork_is_leaf(const struct k_fork *fork)
{
  return (fork->choice & LEAF) != 0;
}

unsigned
k_fork_left_of_node(const struct k_fork *fork)
{
  return fork->choice >> OF_NODE & 7;
}
