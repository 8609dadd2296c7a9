// k_polygon_grid.c - see k_polygon_grid.h.

#include "k_polygon_grid.h"
#include <stdlib.h>
#include <string.h>

#define MOST 64                 // cells of a side
#define MARGIN 0.0625           // of a cell: how near an edge may not come

// Both ways of telling where a point is err by less than this times the
// lengths that are in it, for a ray that K_GRID_STEEP lets pass.
#define ROUNDING 0x1p-42

/** The vertices in cells, and what is found out of each cell. */
struct raster
{
  int side;
  uint8_t is_mixed[MOST * MOST];
  uint8_t flips[MOST * MOST];   // whether going on along u crosses an edge
};

static int
clamp(double x, int most)
{
  return x < 0 ? 0 : x > most ? most : (int)x;
}

/** The cells of row v that the edge comes near to. */
static void
mark_row(struct raster *r, int v, double u0, double v0, double u1, double v1)
{
  double low = v - MARGIN, high = v + 1 + MARGIN;
  double a = u0, b = u1;

  // The part of the edge between low and high; v0 <= v1.
  if (v0 < low)
    {
      a = u0 + (u1 - u0) * ((low - v0) / (v1 - v0));
    }
  if (v1 > high)
    {
      b = u0 + (u1 - u0) * ((high - v0) / (v1 - v0));
    }
  int from = clamp(fmin(a, b) - MARGIN, r->side - 1);
  int to = clamp(fmax(a, b) + MARGIN, r->side - 1);
  memset(&r->is_mixed[v * r->side + from], 1, to - from + 1);
}

static void
add_edge(struct raster *r, double u0, double v0, double u1, double v1)
{
  if (v0 > v1)
    {
      add_edge(r, u1, v1, u0, v0);
      return;
    }
  int last = clamp(v1 + MARGIN, r->side - 1);
  for (int v = clamp(v0 - MARGIN, r->side - 1); v <= last; v++)
    {
      double middle = v + 0.5;
      mark_row(r, v, u0, v0, u1, v1);
      if (v0 < middle && v1 >= middle)
        {
          double u = u0 + (u1 - u0) * ((middle - v0) / (v1 - v0));
          r->flips[v * r->side + clamp(u + 0.5, r->side - 1)] ^= 1;
        }
    }
}

static void
fill_cells(const struct raster *r, uint8_t *cells)
{
  memset(cells, 0, r->side * r->side / 4);
  for (int v = 0; v < r->side; v++)
    {
      int is_in = 0;
      for (int u = 0; u < r->side; u++)
        {
          int i = v * r->side + u;
          is_in ^= r->flips[i];
          enum k_cell cell = r->is_mixed[i] ? K_CELL_MIXED
            : is_in ? K_CELL_IN : K_CELL_OUT;
          cells[i / 4] |= cell << (i % 4 * 2);
        }
    }
}

static void
span_of(const double *x, unsigned n, double *least, double *most)
{
  *least = *most = x[0];
  for (unsigned i = 1; i < n; i++)
    {
      *least = fmin(*least, x[i]);
      *most = fmax(*most, x[i]);
    }
}

/** The furthest of the vertices from the plane, and from the origin. */
static void
measure(const struct k_plane *plane, unsigned n,
        const double *const vertex[3], double *off, double *far)
{
  *off = *far = 0;
  for (unsigned i = 0; i < n; i++)
    {
      struct k_vec p = k_vec(vertex[0][i], vertex[1][i], vertex[2][i]);
      *off = fmax(*off, fabs(k_dot(plane->n, k_sub(p, plane->q))));
      *far = fmax(*far, k_norm1(p));
    }
}

struct k_polygon_grid *
k_polygon_grid(const struct k_plane *plane, unsigned n,
               const double *const vertex[3])
{
  double ax = fabs(plane->n.x), ay = fabs(plane->n.y), az = fabs(plane->n.z);
  int w = ax > ay ? (ax > az ? 0 : 2) : (ay > az ? 1 : 2);
  int u = w == 0 ? 1 : 0, v = w == 2 ? 1 : 2;
  int side = n < 48 ? MOST / 2 : MOST;
  double u0, u1, v0, v1, off, far;
  struct raster r;

  if (n < K_GRID_FROM)
    {
      return NULL;
    }
  span_of(vertex[u], n, &u0, &u1);
  span_of(vertex[v], n, &v0, &v1);
  measure(plane, n, vertex, &off, &far);
  // A row of cells stays free all round.
  double u_cell = (u1 - u0) / (side - 2), v_cell = (v1 - v0) / (side - 2);
  double margin = MARGIN * fmin(u_cell, v_cell);
  double reach = (margin - off / K_GRID_STEEP) / ROUNDING - far;
  struct k_polygon_grid *grid = reach > 4 * far && u_cell > 0x1p-500
    && v_cell > 0x1p-500 && far < 0x1p500
    ? malloc(sizeof *grid + side * side / 4) : NULL;
  if (!grid)
    {
      return NULL;
    }
  grid->u = u;
  grid->v = v;
  grid->side = r.side = side;
  grid->u0 = u0 - u_cell;
  grid->v0 = v0 - v_cell;
  grid->u_scale = 1 / u_cell;
  grid->v_scale = 1 / v_cell;
  grid->reach = reach;
  memset(r.is_mixed, 0, sizeof r.is_mixed);
  memset(r.flips, 0, sizeof r.flips);
  for (unsigned i = 0, last = n - 1; i < n; last = i++)
    {
      add_edge(&r, (vertex[u][last] - grid->u0) * grid->u_scale,
               (vertex[v][last] - grid->v0) * grid->v_scale,
               (vertex[u][i] - grid->u0) * grid->u_scale,
               (vertex[v][i] - grid->v0) * grid->v_scale);
    }
  fill_cells(&r, grid->cells);
  return grid;
}
