/* emit.h - writes a scene as text: .mdl, or Haines' Neutral File Format.

   A generator says the camera, then the lights, then a material and the
   shapes made of it, and so on; both formats get the same numbers. */

#ifndef BENCH_EMIT_H
#define BENCH_EMIT_H

#include <stdio.h>

enum emit_format
{
  EMIT_NFF,
  EMIT_MDL,
  EMIT_LENS                     /* only "focus fstop exposure", if any */
};

struct emit
{
  FILE *out;
  enum emit_format format;
  int side;                     /* columns, and rows */
  long lights, materials, shapes, solids;
  int inSolid;
};

struct point
{
  double x, y, z;
};

/* A lens is none if exposure is 0. */
struct emit_view
{
  struct point from, at, up;
  struct { double r, g, b; } background;
  double focus, fstop;
  int exposure;
};

/* Colour, share of diffuse light and of mirrored light, exponent of the
   highlight, share that goes through, index of refraction. */
struct emit_material
{
  double r, g, b, kd, ks, shine, clear, ior;
};

void emit_view (struct emit *to, const struct emit_view *view);

/* Count lights that together are as bright as NFF's without a colour. */
void emit_lights (struct emit *to, const struct point *place, int count);

void emit_material (struct emit *to, struct emit_material material);
void emit_sphere (struct emit *to, struct point center, double radius);
void emit_polygon (struct emit *to, const struct point *corner, int count);

/* The polygons between the two calls are the surface of one solid. */
void emit_solid_begin (struct emit *to);
void emit_solid_end (struct emit *to);

/* The scenes; size means something else in each, see generate.c. */
void scene_flake (struct emit *to, int size);
void scene_tetra (struct emit *to, int size);
void scene_mountain (struct emit *to, int size);
void scene_gears (struct emit *to, int size);
void scene_room (struct emit *to, int size);
void scene_lattice (struct emit *to, int size);
void scene_lens (struct emit *to, int size);

#endif
