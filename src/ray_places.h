// ray_places.h - where the rays of a pixel go: each has a place in the pixel
// and one on the lens.

#ifndef RAY_PLACES_H
#define RAY_PLACES_H

#import "camera_t.h"
#include "owen.h"
#include "stratified.h"

enum sampler
{
  SAMPLER_OWEN,         // scrambled Sobol
  SAMPLER_RANDOM,       // the notes' rand(), seeded
  SAMPLER_STRATIFIED,   // one in each of as many parts
  SAMPLER_GRID          // n x n, regular; on the lens random
};

/** Those of one pixel. */
struct ray_places
{
  enum sampler sampler;
  uint64_t seed;
  unsigned samples, exposure;   // exposure rays for each sample
  uint64_t rays;                // their product
  BOOL moves_in_pixel;          // or all go through its point
  BOOL has_lens;
  unsigned column, row, batch;
  struct owen pixel, lens;      // SAMPLER_OWEN
  uint64_t keys[2];             // SAMPLER_STRATIFIED: pixel, lens
  uint64_t next;                // first ray of the next sample
  uint64_t parts;               // in a row; of SAMPLER_STRATIFIED: rows
};

/** Gets ready for a batch of rays of a pixel. Batches are independent: each
    by itself spreads its rays as evenly as it can. */
static inline void
ray_places_begin(struct ray_places *p, unsigned column, unsigned row,
                 unsigned batch)
{
  p->column = column;
  p->row = row;
  p->batch = batch;
  p->next = 0;
  if (p->sampler == SAMPLER_OWEN)
    {
      p->pixel = owen_sequence(p->seed, column, row, batch,
                               DIMENSION_PIXEL_RIGHT);
      p->lens = owen_sequence(p->seed, column, row, batch, DIMENSION_LENS_U);
      if (p->has_lens)
        {
          p->pixel.order = p->lens.order;       // together in four dimensions
        }
    }
  else if (p->sampler == SAMPLER_STRATIFIED)
    {
      uint64_t key = sampler_key(p->seed, column, row,
                                 ((uint64_t)batch << 32) + p->rays);
      p->keys[0] = sampler_mix(key + 1);
      p->keys[1] = sampler_mix(key + 2);
      p->parts = stratified_rows(p->rays);
    }
  else if (p->sampler == SAMPLER_GRID)
    {
      p->parts = (unsigned)(sqrt(p->samples) + 0.5);
    }
}

/** The random number of a ray, or of a sample. */
static inline double
ray_places_random(const struct ray_places *p, uint64_t number,
                  enum dimension dimension)
{
  return sampler_random(p->seed, p->column, p->row,
                        ((uint64_t)p->batch << 48) + number, dimension);
}

static inline void
ray_places_stratified(const struct ray_places *p, uint64_t ray,
                      enum dimension first, double *a, double *b)
{
  uint64_t part = stratified_place(ray, p->rays, p->keys[first / 2]);

  *a = ray_places_random(p, ray, first);
  *b = ray_places_random(p, ray, first + 1);
  stratified_point(part, p->rays, p->parts, a, b);
}

/** The place of sample s in the pixel: two numbers in [0, 1). */
static inline void
ray_places_in_pixel(const struct ray_places *p, uint64_t s, double *a,
                    double *b)
{
  switch (p->sampler)
    {
    case SAMPLER_OWEN:
      if (p->has_lens)
        {
          owen_point_beside(&p->pixel, (uint32_t)s, a, b);
        }
      else
        {
          owen_point(&p->pixel, (uint32_t)s, a, b);
        }
      return;
    case SAMPLER_RANDOM:
      *a = ray_places_random(p, s, DIMENSION_PIXEL_RIGHT);
      *b = ray_places_random(p, s, DIMENSION_PIXEL_UP);
      return;
    case SAMPLER_STRATIFIED:
      ray_places_stratified(p, s, DIMENSION_PIXEL_RIGHT, a, b);
      return;
    case SAMPLER_GRID:
      break;
    }
  *a = (s % p->parts + 0.5) / p->parts;
  *b = (s / p->parts + 0.5) / p->parts;
}

/** The place on the lens: two numbers in [0, 1). */
static inline void
ray_places_on_lens(const struct ray_places *p, uint64_t ray, double *a,
                   double *b)
{
  if (p->sampler == SAMPLER_OWEN)
    {
      owen_point(&p->lens, (uint32_t)ray, a, b);
    }
  else if (p->sampler == SAMPLER_STRATIFIED)
    {
      ray_places_stratified(p, ray, DIMENSION_LENS_U, a, b);
    }
  else
    {
      *a = ray_places_random(p, ray, DIMENSION_LENS_U);
      *b = ray_places_random(p, ray, DIMENSION_LENS_V);
    }
}

/** The places of ray number `ray` of the batch; one after the other, from
    any on. */
static inline void
ray_places_set(struct ray_places *p, uint64_t ray, struct sample *sample)
{
  double a, b;

  if (p->moves_in_pixel && p->sampler != SAMPLER_RANDOM
      && p->sampler != SAMPLER_GRID)
    {
      ray_places_in_pixel(p, ray, &a, &b);
      sample->right = a - 0.5;
      sample->up = b - 0.5;
    }
  else if (p->moves_in_pixel && ray >= p->next)
    {
      // Notes: all rays of a sample go through one place of the pixel.
      ray_places_in_pixel(p, ray / p->exposure, &a, &b);
      sample->right = a - 0.5;
      sample->up = b - 0.5;
      p->next = (ray / p->exposure + 1) * p->exposure;
    }
  if (p->has_lens)
    {
      ray_places_on_lens(p, ray, &a, &b);
      sample->u = 2 * a - 1;
      sample->v = 2 * b - 1;
    }
}

#endif
