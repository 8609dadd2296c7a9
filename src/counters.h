// counters.h - what happened while tracing, counted per thread and added up
// at the end; --stats shows it.

#ifndef COUNTERS_H
#define COUNTERS_H

#include <stdint.h>

struct counters
{
  uint64_t eye, reflection, refraction, feeler; // rays traced, by kind
  uint64_t tests;       // times an object was asked for its hits
  uint64_t nodes;       // nodes of the tree that were looked at
  uint64_t escapes;     // rays that left a closed object through an edge

  // Near the edge, of eye, reflected and refracted rays: feelers take the first
  // thing in their way, which may be any. docs/determinism.md.
  uint64_t compensated; // that hit a sphere they start near to
  uint64_t ties;        // that hit two objects or more at the same distance
  uint64_t critical;    // that meet something clear at the critical angle,
                        // |k| < 4 u
  uint64_t unbalanced;  // that leave something they were not in
};

static inline uint64_t
counters_rays(const struct counters *c)
{
  return c->eye + c->reflection + c->refraction + c->feeler;
}

/** Whether the same happened near the edge. */
static inline int
counters_same_edges(const struct counters *a, const struct counters *b)
{
  return a->escapes == b->escapes && a->compensated == b->compensated
    && a->ties == b->ties && a->critical == b->critical
    && a->unbalanced == b->unbalanced;
}

static inline void
counters_add(struct counters *sum, const struct counters *c)
{
  sum->eye += c->eye;
  sum->reflection += c->reflection;
  sum->refraction += c->refraction;
  sum->feeler += c->feeler;
  sum->tests += c->tests;
  sum->nodes += c->nodes;
  sum->escapes += c->escapes;
  sum->compensated += c->compensated;
  sum->ties += c->ties;
  sum->critical += c->critical;
  sum->unbalanced += c->unbalanced;
}

#endif
