// battery.h - what the stability tests share. Every set-up of the battery is
// a function of a `struct run`: it places everything through IN, AT and
// battery_put, notes what it finds, and is then run again at 2^-100 and 2^100
// times the size and mirrored in x; all notes have to be the same bits.

#ifndef BATTERY_H
#define BATTERY_H

#include "test.h"
#include "support.h"

#define U 0x1p-53               // unit roundoff
#define NOTES 64

struct run
{
  double scale;                 // a power of two
  int is_mirrored;              // x is -x
  unsigned share;               // storms make 1/share of their rays
  int is_told;                  // this run reports what it counts
  double note[NOTES];           // the first notes, at scale 1, not mirrored
  unsigned notes;
  uint64_t hash;                // of the bits of all notes
};

typedef void battery_setup(struct run *run);

// Where things are: IN for a length, AT for the three numbers of a point or
// ALONG for those of a direction, in a text made with support_model.

#define N3 " %a %a %a "
#define IN(run, x) ((x) * (run)->scale)
#define SIGN(run) ((run)->is_mirrored ? -1.0 : 1.0)
#define AT(run, x, y, z) \
  IN(run, x) * SIGN(run), IN(run, y), IN(run, z)
#define AT_V(run, v) AT(run, (v).x, (v).y, (v).z)
#define ALONG(run, x, y, z) (x) * SIGN(run), (double)(y), (double)(z)

#define BATTERY_HEAD \
  SUPPORT_CAMERA \
  "material m { diffuse 1 1 1 }\n" \
  "material mirror { specular 1 1 1 }\n" \
  "material glass { alpha 1 ior 1.5 }\n"

static inline struct k_vec
battery_put(const struct run *run, struct k_vec p)
{
  return k_vec(AT_V(run, p));
}

static inline struct k_vec
battery_turn(const struct run *run, struct k_vec d)
{
  return k_vec(d.x * SIGN(run), d.y, d.z);
}

// What is found

static inline void
note_number(struct run *run, double x)
{
  uint64_t bits;

  x += 0;                       // -0 counts as +0
  memcpy(&bits, &x, sizeof bits);
  run->hash = (run->hash ^ bits) * 0x100000001b3u;
  run->hash ^= run->hash >> 29;
  if (run->notes < NOTES)
    {
      run->note[run->notes++] = x;
    }
}

static inline void
note_length(struct run *run, double x)
{
  note_number(run, x / run->scale);
}

static inline void
note_direction(struct run *run, struct k_vec d)
{
  note_number(run, d.x * SIGN(run));
  note_number(run, d.y);
  note_number(run, d.z);
}

static inline void
note_point(struct run *run, struct k_vec p)
{
  note_direction(run, k_div(p, run->scale));
}

/** t, the normal and the number of the object; or that there was none.
    Mirrored, the vertices of a thin polygon go round the other way. */
static inline void
note_hit(struct run *run, struct hit hit)
{
  int is_thin = [hit.object isKindOfClass: [polygon_t class]]
    && ((polygon_t *)hit.object)->solid_name == nil;

  if (hit.object == nil)
    {
      note_number(run, HUGE_VAL);
      return;
    }
  note_length(run, hit.t);
  note_direction(run, is_thin ? k_scale(hit.N, SIGN(run)) : hit.N);
  note_number(run, hit.object->number);
}

// Runs

static inline struct run
battery_once(battery_setup *setup, double scale, int is_mirrored,
             unsigned share, int is_told)
{
  NSAutoreleasePool *pool = [[NSAutoreleasePool alloc] init];
  struct run run = { .scale = scale, .is_mirrored = is_mirrored,
                     .share = share, .is_told = is_told,
                     .hash = 0xcbf29ce484222325u };

  setup(&run);
  [pool release];
  return run;
}

/** Runs the set-up whole, and 1/share of it at the other sizes and mirrored.
    Returns the first run. `mirrors` 0: mirrored it is something else. */
static inline struct run
battery_run_share(const char *id, battery_setup *setup, unsigned share,
                  int mirrors)
{
  struct run whole = battery_once(setup, 1, 0, 1, 1);
  struct run first = share == 1 ? whole
    : battery_once(setup, 1, 0, share, 0);
  unsigned different = 0;

  for (int k = -100; k <= 100; k += 100)
    {
      for (int m = k == 0; m <= mirrors; m++)
        {
          struct run other = battery_once(setup, ldexp(1, k), m, share, 0);
          if (other.hash != first.hash)
            {
              printf("# %s at 2^%d%s:", id, k, m ? ", mirrored" : "");
              for (unsigned i = 0; i < 6 && i < first.notes; i++)
                {
                  printf(" %.17g not %.17g", other.note[i], first.note[i]);
                }
              printf("\n");
              different++;
            }
        }
    }
  PASS(different == 0, "%s: the same bits at 2^-100 and 2^100%s", id,
       mirrors ? " and mirrored in x" : "");
  return whole;
}

static inline struct run
battery_run(const char *id, battery_setup *setup)
{
  return battery_run_share(id, setup, 1, 1);
}

// Rays

/** An eye ray, not traced; o and d as in a run at scale 1. */
static inline ray_t *
battery_ray(const struct run *run, model_t *model, struct k_vec o,
            struct k_vec d)
{
  return support_ray(model, battery_put(run, o), battery_turn(run, d));
}

static inline struct hit
battery_hit(const struct run *run, model_t *model, struct k_vec o,
            struct k_vec d)
{
  ray_t *ray = battery_ray(run, model, o, d);

  [model find_closest: ray];
  return ray->hit;
}

/** A ray that starts where the parent has hit something and runs along the
    unit vector dir, with the media that trace: would give it. */
static inline ray_t *
battery_spawn(ray_t *parent, struct k_vec dir, BOOL through)
{
  ray_t *ray = [(ray_t *)[ray_t alloc] init: [vec_t vec: parent->hit.P]
                                           : [vec_t vec: dir]
                                       from: parent through: through];
  object_t *medium = [parent->hit.object medium];

  ray->counters = &ray->own_counters;   // the parent may be gone before it
  if (through && medium)
    {
      BOOL goes_in = k_dot(parent->hit.N, parent->dir->v) < 0;
      media_t *media = goes_in
        ? [media_t enter: medium : parent->hit.object->material->ior
                    over: parent->media]
        : [media_t leave: medium from: parent->media];
      [media retain];
      [ray->media release];
      ray->media = media;
    }
  return [ray autorelease];
}

/** The reflected direction as trace: makes it. */
static inline struct k_vec
battery_reflected(ray_t *ray)
{
  return shade_renew(shade_reflect(ray->dir->v, ray->hit.N));
}

/** A random direction on the side of N that N points to, not closer to the
    surface than the sine `least`. */
static inline struct k_vec
battery_above(struct support_random *random, struct k_vec N, double least)
{
  struct k_vec d;

  do
    {
      d = support_direction(random);
      if (k_dot(d, N) < 0)
        {
          d = k_neg(d);
        }
    }
  while (k_dot(d, N) < least);
  return d;
}

/** Two unit vectors square to the unit vector d and to each other. */
static inline void
battery_across(struct k_vec d, struct k_vec *a, struct k_vec *b)
{
  struct k_vec hint = fabs(d.x) < 0.6 ? k_vec(1, 0, 0) : k_vec(0, 1, 0);

  *a = k_unit(k_cross(d, hint));
  *b = k_unit(k_cross(d, *a));
}

static inline double
battery_max(double a, double b)
{
  return a > b ? a : b;
}

/** The text of a polygon; `more` may name its solid. */
static inline NSString *
battery_polygon(const struct run *run, const char *name, const char *material,
                const char *more, unsigned n, const struct k_vec *v)
{
  NSMutableString *text = [NSMutableString stringWithFormat:
                                             @"polygon %s { material %s %s",
                                           name, material, more];
  char vertex[100];

  for (unsigned i = 0; i < n; i++)
    {
      snprintf(vertex, sizeof vertex, " vertex" N3, AT_V(run, v[i]));
      [text appendString: [NSString stringWithUTF8String: vertex]];
    }
  [text appendString: @"}\n"];
  return text;
}

#endif
