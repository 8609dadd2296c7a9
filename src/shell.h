// shell.h - whether faces close a volume, and which side of each is outside.
// Plain C on indices: solid_t gathers the faces, this finds the shells.

#ifndef SHELL_H
#define SHELL_H

#include "kernel/k_vec.h"

/** One face: n vertices as three arrays, as in polygon_t. */
struct shell_face
{
  unsigned n;
  const double *const *vertex;
  // found by shells_close:
  unsigned shell;       // which connected part the face belongs to, from 0
  int is_turned;        // its vertices go round the other way: turn it, and
                        // its right-handed normal points out of the volume
};

static inline struct k_vec
shell_vertex(const struct shell_face *f, unsigned i)
{
  return k_vec(f->vertex[0][i], f->vertex[1][i], f->vertex[2][i]);
}

/** An edge that is not shared as it has to be. */
struct shell_edge
{
  unsigned face;        // the first face that has it
  struct k_vec a, b;    // its ends, in that face's order
  unsigned faces;       // how many times it is there, in all faces
};

/** Checks that every edge is in exactly two faces, in opposite directions
    once faces are turned as is_turned then says (an edge that one face has in
    both directions, a bridge to a hole, does not count). Each shell's volume
    is positive afterwards, or negative for a cavity: a shell inside an odd
    number of others. Returns the number of shells; 0 when they are not
    closed, with *open as an example; -1 when there is no memory. */
int shells_close(struct shell_face *faces, unsigned count,
                 struct shell_edge *open);

#endif
