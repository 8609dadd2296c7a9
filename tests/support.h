// support.h - what the tests of the tracer share: models from text, single
// rays, whole pictures, random numbers, and vectors of four times the
// precision to compare with. A test makes an autorelease pool first; all
// objects that come from here are autoreleased.

#ifndef SUPPORT_H
#define SUPPORT_H

#import <Foundation/Foundation.h>
#import "camera_t.h"
#import "diag_t.h"
#import "image_t.h"
#import "light_t.h"
#import "material_t.h"
#import "fast_t.h"
#import "media_t.h"
#import "model_t.h"
#import "notes_t.h"
#import "object_t.h"
#import "parser_t.h"
#import "plane_t.h"
#import "polygon_t.h"
#import "ray_t.h"
#import "render_t.h"
#import "solid_t.h"
#import "sphere_t.h"
#include "random.h"
#include "shade.h"
#include "test.h"
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

// Models

/** A camera that every model needs and many tests never use: a window of
    2 x 2, seen from (1 1 5). */
#define SUPPORT_CAMERA \
  "camera cam { pixeldim 9 9 worlddim 2 2 viewpoint 1 1 5 }\n"

static inline struct parse_options
support_options(void)
{
  struct parse_options options = { .polygon_test = POLYGON_CROSSINGS,
                                   .max_depth = 5 };
  return options;
}

/** The model that the text describes, or nil with what was told of it in
    *report (which may be NULL). */
static inline model_t *
support_parse(NSString *text, struct parse_options options, NSString **report)
{
  NSString *folder = NSTemporaryDirectory();
  char path[4096];
  NSError *error = nil;
  diag_t *diag = [[[diag_t alloc] init] autorelease];

  snprintf(path, sizeof path, "%s/support-XXXXXX.mdl",
           [folder fileSystemRepresentation]);
  int file = mkstemps(path, 4);
  const char *bytes = [text UTF8String];
  size_t length = strlen(bytes);
  if (file < 0 || write(file, bytes, length) != (ssize_t)length)
    {
      perror(path);
      exit(1);
    }
  close(file);
  model_t *model
    = [parser_t modelFromFile: [NSString stringWithUTF8String: path]
                  includePath: [NSArray array]
                      options: options
                         diag: diag
                         text: NULL
                    canonical: NULL
                        error: &error];
  unlink(path);
  if (report)
    {
      *report = [diag report];
    }
  return model;
}

/** The model of a text that has to be without faults: otherwise the test
    itself is broken and ends at once. */
static inline model_t *
support_model_with(struct parse_options options, NSString *text)
{
  NSString *report = nil;
  model_t *model = support_parse(text, options, &report);

  if (model == nil)
    {
      fprintf(stderr, "a model of this test has faults:\n%s\n%s\n",
              [report UTF8String], [text UTF8String]);
      fflush(NULL);
      abort();
    }
  return model;
}

/** The same with the options that a user gets who gives none. The text is a
    format as in printf. */
static inline model_t *support_model(const char *format, ...)
  __attribute__((format(printf, 1, 2)));

static inline model_t *
support_model(const char *format, ...)
{
  va_list arguments;

  va_start(arguments, format);
  int length = vsnprintf(NULL, 0, format, arguments);
  va_end(arguments);
  char *text = malloc(length + 1);
  va_start(arguments, format);
  vsnprintf(text, length + 1, format, arguments);
  va_end(arguments);
  NSString *string = [NSString stringWithUTF8String: text];
  free(text);
  return support_model_with(support_options(), string);
}

/** What is told of a text that has to have faults; nil if it has none. */
static inline NSString *
support_faults(const char *text)
{
  NSString *report = nil;
  model_t *model = support_parse([NSString stringWithUTF8String: text],
                                 support_options(), &report);

  return model ? nil : report;
}

/** The object of that name; nil if there is none. */
static inline object_t *
support_object(model_t *model, const char *name)
{
  NSString *wanted = [NSString stringWithUTF8String: name];

  for (object_t *object in model->objects)
    {
      if ([[object name] isEqual: wanted])
        {
          return object;
        }
    }
  return nil;
}

/** The six polygons of a box, as text (autoreleased): names that begin with
    `name`, all of the solid `solid`, not all wound the same way. */
static inline const char *
support_box(const char *name, const char *solid, const char *material,
            struct k_vec least, struct k_vec most)
{
  static const unsigned char faces[6][4] = {    // bit 0: x, 1: y, 2: z
    { 0, 1, 3, 2 }, { 4, 5, 7, 6 }, { 0, 1, 5, 4 },
    { 2, 3, 7, 6 }, { 0, 2, 6, 4 }, { 1, 3, 7, 5 }
  };
  NSMutableString *text = [NSMutableString string];

  for (int i = 0; i < 6; i++)
    {
      [text appendFormat: @"polygon %s%d { material %s solid %s", name, i,
            material, solid];
      for (int j = 0; j < 4; j++)
        {
          int corner = faces[i][j];
          [text appendFormat: @" vertex %.17g %.17g %.17g",
                corner & 1 ? most.x : least.x,
                corner & 2 ? most.y : least.y,
                corner & 4 ? most.z : least.z];
        }
      [text appendString: @" }\n"];
    }
  return [text UTF8String];
}

// Rays

/** An eye ray from o along d, which need not be unit, in the media that o
    lies in; not traced yet. */
static inline ray_t *
support_ray(model_t *model, struct k_vec o, struct k_vec d)
{
  ray_t *ray = [(ray_t *)[ray_t alloc] init: [vec_t vec: o]
                                           : [vec_t vec: k_unit(d)]];

  ray->media = [[model mediaOf: ray] retain];
  return [ray autorelease];
}

/** What the eye ray hits first; .object is nil for nothing. */
static inline struct hit
support_hit(model_t *model, struct k_vec o, struct k_vec d)
{
  ray_t *ray = support_ray(model, o, d);

  [model find_closest: ray];
  return ray->hit;
}

/** The number of the object the eye ray hits first; 0 for nothing. */
static inline unsigned
support_number(model_t *model, struct k_vec o, struct k_vec d)
{
  struct hit hit = support_hit(model, o, d);

  return hit.object ? hit.object->number : 0;
}

/** The colour that comes back along the eye ray. */
static inline struct k_vec
support_trace(model_t *model, struct k_vec o, struct k_vec d)
{
  NSAutoreleasePool *pool = [[NSAutoreleasePool alloc] init];
  struct k_vec color = [support_ray(model, o, d) trace: model]->v;

  [pool release];
  return color;
}

// Pictures

static inline struct render_options
support_render_options(void)
{
  struct render_options options = { .threads = 1, .seed = 1, .samples = 1,
                                    .sampler = SAMPLER_RANDOM };
  return options;
}

/** A part of the model's picture, with or without surfaces, by an engine; what
    was counted goes to *counters. */
static inline image_t *
support_render_counted(model_t *model, id <engine_t> engine,
                       struct render_options options, struct window window,
                       BOOL with_surfaces, struct counters *counters)
{
  camera_t *camera = model->camera;
  image_t *image = [[[image_t alloc] init: camera->columns : camera->rows
                                   window: window
                                 surfaces: with_surfaces
                                    error: NULL] autorelease];
  render_t *render = [[render_t alloc] init: engine camera: camera
                                       into: image options: options];

  [render run];
  *counters = render->counters;
  [render release];
  return image;
}

/** A part of the model's picture, with surfaces, by an engine. */
static inline image_t *
support_render(model_t *model, id <engine_t> engine,
               struct render_options options, struct window window)
{
  struct counters nobody_asks;

  return support_render_counted(model, engine, options, window, YES,
                                &nobody_asks);
}

/** The fast engine with the model in it (autoreleased). */
static inline id <engine_t>
support_fast(model_t *model, NSString *instructions)
{
  return [[[fast_t alloc] initWithModel: model instructions: instructions
                                threads: 2 error: NULL] autorelease];
}

/** In how many pixels two pictures with surfaces differ by a bit. */
static inline size_t
support_pixels_apart(image_t *a, image_t *b)
{
  size_t count = (size_t)[a width] * [a height], apart = 0;

  for (size_t i = 0; i < count; i++)
    {
      const struct surface_pixel *p = &a->surfaces[i], *q = &b->surfaces[i];
      apart += memcmp(&a->pixels[i].color, &b->pixels[i].color,
                      sizeof(struct k_vec)) != 0
        || memcmp(&p->depth, &q->depth, sizeof p->depth) != 0
        || memcmp(&p->N, &q->N, sizeof p->N) != 0
        || p->object != q->object;
    }
  return apart;
}

/** A part of the model's picture, with surfaces: by the notes engine, and
    the fast one has to agree. */
static inline image_t *
support_window(model_t *model, struct render_options options,
               struct window window)
{
  id <engine_t> notes = [[[notes_t alloc] initWithModel: model] autorelease];
  image_t *image = support_render(model, notes, options, window);
  image_t *fast = support_render(model, support_fast(model, nil), options,
                                 window);

  PASS(support_pixels_apart(image, fast) == 0, "both engines: the same bits");
  return image;
}

/** The model's whole picture, with surfaces. */
static inline image_t *
support_picture(model_t *model, struct render_options options)
{
  struct window all = { 0, 0, model->camera->columns, model->camera->rows };

  return support_window(model, options, all);
}

/** Whether two colours or points are the same bits. */
static inline int
support_same(struct k_vec a, struct k_vec b)
{
  return memcmp(&a, &b, sizeof a) == 0;
}

/** How many pixels of two pictures of one size differ in colour, depth,
    normal or object by any bit; what the first one is goes to the log. */
static inline unsigned
support_differences(image_t *a, image_t *b)
{
  unsigned differences = 0;
  size_t count = (size_t)[a width] * [a height];

  for (size_t i = 0; i < count; i++)
    {
      struct k_vec p = a->pixels[i].color, q = b->pixels[i].color;
      struct surface_pixel *s = &a->surfaces[i], *t = &b->surfaces[i];
      if (!support_same(p, q) || !support_same(s->N, t->N)
          || s->depth != t->depth || s->object != t->object)
        {
          if (differences++ == 0)
            {
              printf("# pixel %zu of %u x %u differs: (%a %a %a) and"
                     " (%a %a %a), depth %a and %a, object %u and %u\n", i,
                     [a width], [a height], p.x, p.y, p.z, q.x, q.y, q.z,
                     s->depth, t->depth, s->object, t->object);
            }
        }
    }
  return differences;
}

// Reference arithmetic: 113 bits

#ifdef __SIZEOF_FLOAT128__
typedef __float128 quad;
#else
typedef long double quad;
#endif

struct q_vec
{
  quad x, y, z;
};

static inline struct q_vec
q_vec(quad x, quad y, quad z)
{
  struct q_vec v = { x, y, z };
  return v;
}

static inline struct q_vec
q_of(struct k_vec v)
{
  return q_vec(v.x, v.y, v.z);
}

static inline struct q_vec
q_add(struct q_vec a, struct q_vec b)
{
  return q_vec(a.x + b.x, a.y + b.y, a.z + b.z);
}

static inline struct q_vec
q_sub(struct q_vec a, struct q_vec b)
{
  return q_vec(a.x - b.x, a.y - b.y, a.z - b.z);
}

static inline struct q_vec
q_scale(struct q_vec a, quad s)
{
  return q_vec(a.x * s, a.y * s, a.z * s);
}

static inline quad
q_dot(struct q_vec a, struct q_vec b)
{
  return a.x * b.x + a.y * b.y + a.z * b.z;
}

static inline struct q_vec
q_cross(struct q_vec a, struct q_vec b)
{
  return q_vec(a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z,
               a.x * b.y - a.y * b.x);
}

static inline quad
q_abs(quad x)
{
  return x < 0 ? -x : x;
}

/** Newton's method from the double's root; x in the range of doubles whose
    root is one too. */
static inline quad
q_sqrt(quad x)
{
  if (!(x > 0))
    {
      return 0;
    }
  quad root = sqrt((double)x);
  for (int i = 0; i < 3; i++)
    {
      root = (root + x / root) / 2;
    }
  return root;
}

static inline struct q_vec
q_unit(struct q_vec a)
{
  return q_scale(a, 1 / q_sqrt(q_dot(a, a)));
}

static inline struct k_vec
q_double(struct q_vec a)
{
  return k_vec(a.x, a.y, a.z);
}

/** Snell's law as the notes mean it, T = (D - c N)/n - sqrt(k) N with c = D.N
    and k = 1 - (1 - c^2)/n^2: the refracted direction of D (unit to all
    digits here) at N, n = n_t / n_i. Returns 0 at total internal
    reflection. */
static inline int
q_refract(struct q_vec D, struct q_vec N, quad n, struct q_vec *T)
{
  D = q_unit(D);
  N = q_unit(N);
  quad c = q_dot(D, N);
  quad k = 1 - (1 - c * c) / (n * n);

  if (k < 0)
    {
      return 0;
    }
  *T = q_sub(q_scale(q_sub(D, q_scale(N, c)), 1 / n), q_scale(N, q_sqrt(k)));
  return 1;
}

/** How far a is from b: the largest difference of a component. */
static inline double
q_apart(struct k_vec a, struct q_vec b)
{
  struct q_vec d = q_sub(q_of(a), b);
  quad x = q_abs(d.x), y = q_abs(d.y), z = q_abs(d.z);

  return x > y ? (x > z ? x : z) : (y > z ? y : z);
}

/** The colour of one eye ray. */
static inline struct k_vec
support_color(id <engine_t> engine, struct k_vec o, struct k_vec d,
              struct counters *counters)
{
  struct eye_ray ray = { .o = o, .d = d };

  [engine trace: &ray : 1 counters: counters];
  return ray.color;
}

#endif
