/* nff.h - reads a scene in Haines' Neutral File Format for the peers. */

#ifndef BENCH_NFF_H
#define BENCH_NFF_H

#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C"
{
#endif

struct nff_light
{
  float place[3], color[3];
};

struct nff_material
{
  float color[3], kd, ks, shine, clear, ior;
};

struct nff_polygon
{
  uint32_t first, count;        /* corners, from corner[3 * first] */
  uint32_t material;
  uint32_t solid;               /* 1 on, or 0: a thin sheet; nff_solids () */
};

struct nff
{
  float background[3], from[3], at[3], up[3], angle;
  int columns, rows;
  struct nff_light *light;
  struct nff_material *material;
  float *sphere;                /* x y z radius */
  uint32_t *sphereMaterial;
  struct nff_polygon *polygon;
  float *corner;                /* x y z */
  size_t lights, materials, spheres, polygons, corners;

  size_t lightRoom, materialRoom, sphereRoom, sphereMaterialRoom,
    polygonRoom, cornerRoom;
};

/* Reads the file; ends the program with a message if it cannot. */
void nff_read (struct nff *scene, const char *path);

/* Gives back the memory of the shapes. */
void nff_free_shapes (struct nff *scene);

/* Finds the polygons of clear materials that close a volume, gives each
   volume a number and turns its polygons to face outward. */
void nff_solids (struct nff *scene);

/* The window's axes: right and up as long as half its width and height, at
   distance 1 along ahead; the outermost pixels are on its edge. */
void nff_window (const struct nff *scene, double right[3], double up[3],
                 double ahead[3]);

/* Cuts a simple polygon into count - 2 triangles of corner numbers. */
void nff_clip (const float *corner, uint32_t count, uint32_t (*triangle)[3]);

/* Newell's normal, not of length 1. */
void nff_normal (const float *corner, uint32_t count, double normal[3]);

#ifdef __cplusplus
}
#endif

#endif
