// k_polygon_grid.h - which points of a polygon with many vertices are surely
// in it: a grid over it whose cells are wholly in, wholly out, or neither.
//
// The answer is that of k_polygon_crossings: no edge comes near a cell that is
// in or out, not within a margin larger than all that both ways round.

#ifndef K_POLYGON_GRID_H
#define K_POLYGON_GRID_H

#include <stdint.h>
#include "k_plane_hit.h"

// With fewer vertices asking them all is as fast.
#define K_GRID_FROM 12

// A ray that runs along the plane more than this is not looked up.
#define K_GRID_STEEP 0x1p-6

enum k_cell
{
  K_CELL_OUT,
  K_CELL_IN,
  K_CELL_MIXED
};

struct k_polygon_grid
{
  int u, v;                     // axes of the world that the grid has
  int side;                     // cells along each
  double u0, v0, u_scale, v_scale;      // (P.u - u0) * u_scale is the cell
  double reach;                 // of |o|_1 + t: farther off rounding matters
  uint8_t cells[];              // side * side, four to a byte
};

/** The grid of a polygon; NULL when there is none, because it would not pay,
    the polygon is not flat enough or memory is short. To be freed. */
struct k_polygon_grid *k_polygon_grid(const struct k_plane *plane, unsigned n,
                                      const double *const vertex[3]);

/** Where the point at t of the ray from o along d is. */
static inline enum k_cell
k_polygon_grid_at(const struct k_polygon_grid *grid,
                  const struct k_plane *plane, struct k_vec o,
                  struct k_vec d, double t)
{
  if (!(fabs(k_dot(plane->n, d)) >= K_GRID_STEEP
        && k_norm1(o) + t <= grid->reach))
    {
      return K_CELL_MIXED;
    }
  double u = (k_component(o, grid->u) + t * k_component(d, grid->u)
              - grid->u0) * grid->u_scale;
  double v = (k_component(o, grid->v) + t * k_component(d, grid->v)
              - grid->v0) * grid->v_scale;
  if (!(u >= 0 && u < grid->side && v >= 0 && v < grid->side))
    {
      return K_CELL_OUT;
    }
  unsigned i = (unsigned)v * grid->side + (unsigned)u;
  return grid->cells[i / 4] >> (i % 4 * 2) & 3;
}

#endif
