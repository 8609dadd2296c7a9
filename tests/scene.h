// scene.h - one scene with a bit of everything, for tests that compare
// pictures: opaque, mirroring and clear objects of all shapes, solids, a thin
// sheet, a picture on a wall, and lights of each falloff. It can be written at
// any scale, mirrored, and with its objects in any order.

#ifndef SCENE_H
#define SCENE_H

#import "support.h"

/** How the scene is written. All zero is as it is. */
struct scene
{
  int k;                // all lengths times 2^k
  int is_mirrored;      // x becomes -x
  int has_lens;
  int has_window;       // the default camera, not one with lookat
  uint64_t shuffle;     // not 0: objects in a random order
  const char *more;     // more text, or NULL
  unsigned columns, rows;       // 0: 40 x 30
};

/** A scene while it is written. */
struct scene_text
{
  struct scene how;
  NSMutableString *text;
  NSMutableArray *objects;
};

/** A length, a point and a vector as the scene is written. */
static inline NSString *
scene_length(const struct scene_text *s, double x)
{
  return [NSString stringWithFormat: @"%.17g", ldexp(x, s->how.k)];
}

static inline NSString *
scene_point(const struct scene_text *s, double x, double y, double z)
{
  return [NSString stringWithFormat: @"%@ %@ %@",
    scene_length(s, s->how.is_mirrored ? -x : x), scene_length(s, y),
    scene_length(s, z)];
}

static inline NSString *
scene_vector(const struct scene_text *s, double x, double y, double z)
{
  return [NSString stringWithFormat: @"%.17g %.17g %.17g",
    s->how.is_mirrored ? -x : x, y, z];
}

static inline void
scene_material(struct scene_text *s, const char *name, double r, double g,
               double b, const char *rest)
{
  [s->text appendFormat: @"material %s { ambient %@ %@ %@ %s }\n", name,
    scene_length(s, r), scene_length(s, g), scene_length(s, b), rest];
}

static inline void
scene_light(struct scene_text *s, const char *name, double x, double y,
            double z, const char *color, int falloff)
{
  double r, g, b;

  sscanf(color, "%lf %lf %lf", &r, &g, &b);
  [s->text appendFormat: @"light %s { location %@ emissivity %.17g %.17g"
    @" %.17g falloff %d }\n", name, scene_point(s, x, y, z),
    ldexp(r, falloff * s->how.k), ldexp(g, falloff * s->how.k),
    ldexp(b, falloff * s->how.k), falloff];
}

static inline void
scene_sphere(struct scene_text *s, const char *name, const char *material,
             double x, double y, double z, double r)
{
  [s->objects addObject: [NSString stringWithFormat: @"sphere %s { material"
    @" %s center %@ radius %@ }\n", name, material, scene_point(s, x, y, z),
    scene_length(s, r)]];
}

static inline void
scene_plane(struct scene_text *s, const char *name, const char *material,
            struct k_vec n, struct k_vec q)
{
  [s->objects addObject: [NSString stringWithFormat: @"plane %s { material %s"
    @" normal %@ point %@ }\n", name, material,
    scene_vector(s, n.x, n.y, n.z), scene_point(s, q.x, q.y, q.z)]];
}

/** Mirrored, the corners go round the other way, from the same first one, so
    that the normal is the mirror image too. */
static inline void
scene_polygon(struct scene_text *s, const char *name, const char *material,
              const char *solid, unsigned n, const struct k_vec *v)
{
  NSMutableString *text = [NSMutableString stringWithFormat:
    @"polygon %s { material %s", name, material];

  if (solid)
    {
      [text appendFormat: @" solid %s", solid];
    }
  for (unsigned i = 0; i < n; i++)
    {
      struct k_vec p = v[s->how.is_mirrored ? (n - i) % n : i];
      [text appendFormat: @" vertex %@", scene_point(s, p.x, p.y, p.z)];
    }
  [text appendString: @" }\n"];
  [s->objects addObject: text];
}

/** A prism over an outline in x and y, turned a little, as a solid. */
static inline void
scene_prism(struct scene_text *s, const char *name, const char *material,
            unsigned n, const double (*at)[2], struct k_vec c, double height)
{
  struct k_vec low[8], high[8];
  char face[64];

  for (unsigned i = 0; i < n; i++)
    {
      double x = at[i][0], y = at[i][1];
      low[i] = k_add(c, k_vec(0.8 * x - 0.6 * y, 0, 0.6 * x + 0.8 * y));
      high[i] = k_add(low[i], k_vec(0, height, 0));
    }
  snprintf(face, sizeof face, "%s-low", name);
  scene_polygon(s, face, material, name, n, low);
  snprintf(face, sizeof face, "%s-high", name);
  scene_polygon(s, face, material, name, n, high);
  for (unsigned i = 0; i < n; i++)
    {
      unsigned j = (i + 1) % n;
      const struct k_vec side[4] = { low[i], low[j], high[j], high[i] };
      snprintf(face, sizeof face, "%s-%u", name, i);
      scene_polygon(s, face, material, name, 4, side);
    }
}

static inline void
scene_objects(struct scene_text *s)
{
  static const double square[4][2] = { { 0, 0 }, { 1, 0 }, { 1, 1 },
                                       { 0, 1 } };
  static const double l[6][2] = { { 0, 0 }, { 2, 0 }, { 2, 1 }, { 1, 1 },
                                  { 1, 2 }, { 0, 2 } };
  static const struct k_vec sheet[4] = { { -3, 0, 2 }, { -1.5, 0, 2.5 },
                                         { -1.5, 2, 2.5 }, { -3, 2, 2 } };
  static const struct k_vec arrow[4] = { { -3, 2, -4 }, { -1, 3, -4 },
                                         { -3, 4, -4 }, { -2.5, 3, -4 } };
  static const struct k_vec hanging[3] = { { 0, 4, 1 }, { 2, 4.5, 0 },
                                           { 1, 3, 0.5 } };

  scene_plane(s, "floor", "stone", k_vec(0, 2, 0), k_vec(0, -1, 0));
  scene_plane(s, "wall", "stone", k_vec(0.1, 0, 1), k_vec(0, 0, -6));
  scene_polygon(s, "arrow", "red", NULL, 4, arrow);
  scene_sphere(s, "ball", "red", -2, 0, 0, 1);
  scene_sphere(s, "mirror", "chrome", 1.5, 0.5, -2.5, 1.5);
  scene_sphere(s, "glass", "glass", 0.25, 0, 1.5, 0.9);
  scene_sphere(s, "bubble", "air", 0.4, 0.1, 1.5, 0.5);
  scene_sphere(s, "half", "tinted", 2.5, -0.25, 1, 0.75);
  scene_polygon(s, "sheet", "glass", NULL, 4, sheet);
  scene_polygon(s, "hanging", "red", NULL, 3, hanging);
  scene_prism(s, "cube", "water", 4, square, k_vec(-1.2, -0.9, 2), 0.9);
  scene_prism(s, "l", "glass", 6, l, k_vec(3, -0.9, -1), 1.5);
  scene_prism(s, "stone", "red", 4, square, k_vec(-4, -0.9, -2), 2);
}

static inline void
scene_camera(struct scene_text *s)
{
  unsigned columns = s->how.columns ? s->how.columns : 40;
  unsigned rows = s->how.rows ? s->how.rows : 30;

  [s->text appendFormat: @"camera cam { pixeldim %u %u ", columns, rows];
  if (s->how.has_window)
    {
      [s->text appendFormat: @"viewpoint %@ worlddim %@ %@",
        scene_point(s, 1.5, 1, 9), scene_length(s, 4), scene_length(s, 3)];
    }
  else
    {
      [s->text appendFormat: @"viewpoint %@ lookat %@ up 0 1 0 angle 45",
        scene_point(s, 0, 1.5, 9), scene_point(s, 0, 0.5, 0)];
    }
  if (s->how.has_lens)
    {
      [s->text appendFormat: @" focus %@ fstop %.17g exposure 3",
        scene_length(s, 7.5), ldexp(2.8, -s->how.k)];
    }
  [s->text appendString: @" }\n"];
}

static inline NSString *
scene_text(struct scene how)
{
  struct scene_text s = { how, [NSMutableString string],
                          [NSMutableArray array] };

  [s.text appendString: @"background .25 .5 1\n"];
  scene_camera(&s);
  scene_material(&s, "stone", 3, 3, 3, "diffuse .5 .5 .5");
  scene_material(&s, "red", 4, 1, 1, "diffuse .8 .2 .1");
  scene_material(&s, "chrome", 1, 1, 1,
                 "diffuse .1 .1 .1 specular .9 .9 .8 shininess 20");
  scene_material(&s, "glass", 0, 0, 0, "specular .1 .1 .1 alpha .95"
                 " ior 1.5 shininess 99.5");
  scene_material(&s, "water", 0, 1, 1, "alpha .875 ior 1.33");
  scene_material(&s, "air", 0, 0, 0, "alpha 1");
  scene_material(&s, "tinted", 1, 2, 3, "diffuse .3 .3 .3 alpha .5 ior 1.83");
  scene_light(&s, "far", 6, 9, 7, ".5 .5 .5", 0);
  scene_light(&s, "lamp", -4, 5, 3, "3 3 2", 1);
  scene_light(&s, "near", 1, 2, 2, "1 1 0", 2);
  scene_objects(&s);
  struct support_random random = support_seed(how.shuffle);
  while ([s.objects count])
    {
      NSUInteger i = how.shuffle
        ? [s.objects count] * support_unit(&random) : 0;
      [s.text appendString: [s.objects objectAtIndex: i]];
      [s.objects removeObjectAtIndex: i];
    }
  if (how.more)
    {
      [s.text appendFormat: @"%s\n", how.more];
    }
  return s.text;
}

static inline model_t *
scene_model(struct scene how)
{
  return support_model_with(support_options(), scene_text(how));
}

#endif
