// random_scene.h - valid scenes at random: every class, every kind of material,
// lights, cameras with and without a lens, of any size. The number of a scene is
// its seed.

#ifndef RANDOM_SCENE_H
#define RANDOM_SCENE_H

#import "support.h"

#if defined(__OPTIMIZE__) && !defined(__SANITIZE_ADDRESS__)
#define RANDOM_SCENES 150
#else
#define RANDOM_SCENES 15
#endif

/** A scene in the making; lengths are times the scale. */
struct random_making
{
  struct support_random random;
  double scale;
  NSMutableString *text;
};

static inline unsigned
random_choose(struct random_making *m, unsigned count)
{
  return (unsigned)(count * support_unit(&m->random));
}

static inline void
random_write_point(struct random_making *m, const char *word, struct k_vec p)
{
  p = k_scale(p, m->scale);
  [m->text appendFormat: @" %s %.17g %.17g %.17g", word, p.x, p.y, p.z];
}

static inline void
random_write_color(struct random_making *m, const char *word, double most)
{
  [m->text appendFormat: @" %s %.3g %.3g %.3g", word,
     most * support_unit(&m->random), most * support_unit(&m->random),
     most * support_unit(&m->random)];
}

static inline void
random_write_material(struct random_making *m, unsigned k)
{
  static const double iors[] = { 1, 1.0001, 1.33, 1.5, 2.4, 0.7, 5 };

  [m->text appendFormat: @"material m%u {", k];
  random_write_color(m, "ambient", 0.5);
  if (random_choose(m, 4))
    {
      random_write_color(m, "diffuse", 1);
    }
  if (random_choose(m, 2))
    {
      random_write_color(m, "specular", 1);
      [m->text appendFormat: @" shininess %.3g",
         exp2(support_between(&m->random, 0, 12))];
    }
  if (random_choose(m, 2))
    {
      [m->text appendFormat: @" alpha %.3g ior %g",
         random_choose(m, 4) ? support_unit(&m->random) : 1, iors[random_choose(m, 7)]];
    }
  [m->text appendString: @" }\n"];
}

/** n corners round a point: a star when `inner` is less than 1. */
static inline void
random_write_star(struct random_making *m, struct k_vec middle, double size, unsigned n,
           double inner)
{
  struct k_vec a = support_direction(&m->random);
  struct k_vec b = k_unit(k_cross(a, support_direction(&m->random)));

  for (unsigned i = 0; i < n; i++)
    {
      double angle = 2 * M_PI * i / n, r = i % 2 ? inner * size : size;
      random_write_point(m, "vertex",
                  k_along(k_along(middle, r * cos(angle), a), r * sin(angle),
                          b));
    }
}

static inline void
random_write_tetrahedron(struct random_making *m, unsigned k, unsigned material,
                  struct k_vec middle, double size)
{
  struct k_vec v[4];

  for (int i = 0; i < 4; i++)
    {
      v[i] = k_vec(i & 1 ? size : -size, i & 2 ? size : -size,
                   i == 0 || i == 3 ? size : -size);
      v[i] = k_add(middle, v[i]);
    }
  for (int skip = 0; skip < 4; skip++)
    {
      [m->text appendFormat: @"polygon t%u-%d { material m%u solid t%u", k,
         skip, material, k];
      for (int i = 0; i < 4; i++)
        {
          if (i != skip)
            {
              random_write_point(m, "vertex", v[i]);
            }
        }
      [m->text appendString: @" }\n"];
    }
}

static inline void
random_write_object(struct random_making *m, unsigned k, unsigned materials)
{
  struct k_vec middle = support_point(&m->random, 3);
  double size = exp2(support_between(&m->random, random_choose(m, 8) ? -3 : -30, 2));
  unsigned material = random_choose(m, materials);

  switch (random_choose(m, 8))
    {
    case 0:
      [m->text appendFormat: @"plane o%u { material m%u", k, material];
      random_write_point(m, "point", k_scale(middle, 3));
      struct k_vec n = support_direction(&m->random);
      [m->text appendFormat: @" normal %.17g %.17g %.17g }\n", n.x, n.y, n.z];
      return;
    case 1: case 2:
      [m->text appendFormat: @"polygon o%u { material m%u", k, material];
      random_write_star(m, middle, size, 3 + random_choose(m, 5), 1);
      break;
    case 3:
      [m->text appendFormat: @"polygon o%u { material m%u", k, material];
      random_write_star(m, middle, size, 4 + 2 * random_choose(m, 12), 0.5);
      break;
    case 4:
      random_write_tetrahedron(m, k, material, middle, size);
      return;
    default:
      [m->text appendFormat: @"sphere o%u { material m%u", k, material];
      random_write_point(m, "center", middle);
      [m->text appendFormat: @" radius %.17g", size * m->scale];
    }
  [m->text appendString: @" }\n"];
}

/** The text of scene number `seed` (autoreleased). */
static inline NSString *
random_scene_text(uint64_t seed)
{
  struct random_making m = { support_seed(seed), 1, [NSMutableString string] };
  unsigned materials = 1 + random_choose(&m, 5), objects = 1 + random_choose(&m, 30);
  unsigned lights = random_choose(&m, 4);

  m.scale = random_choose(&m, 2) ? 1 : ldexp(1, (int)random_choose(&m, 121) - 60);
  [m.text appendString: @"camera c { pixeldim 12 9"];
  random_write_point(&m, "viewpoint", support_point(&m.random, 5));
  random_write_point(&m, "lookat", support_point(&m.random, 0.5));
  [m.text appendFormat: @" up 0.01 1 0.02 angle %.3g",
     support_between(&m.random, 5, 120)];
  if (random_choose(&m, 3) == 0)
    {
      [m.text appendFormat: @" focus %.17g fstop %.17g exposure %u",
         m.scale * support_between(&m.random, 0.5, 9),
         support_between(&m.random, 1, 30) / m.scale, 1 + random_choose(&m, 4)];
    }
  [m.text appendString: @" }\n"];
  if (random_choose(&m, 2))
    {
      [m.text appendString: @"background .1 .2 .3\n"];
    }
  for (unsigned k = 0; k < lights; k++)
    {
      [m.text appendFormat: @"light l%u {", k];
      random_write_point(&m, "location", support_point(&m.random, 6));
      random_write_color(&m, "emissivity", 2);
      [m.text appendString: @" }\n"];
    }
  for (unsigned k = 0; k < materials; k++)
    {
      random_write_material(&m, k);
    }
  for (unsigned k = 0; k < objects; k++)
    {
      random_write_object(&m, k, materials);
    }
  return m.text;
}

/** The main of a test of such scenes: FROM TO, or the first ones. */
static inline int
random_main(int count, char **words, void (*test)(uint64_t seed))
{
  uint64_t from = count > 1 ? strtoull(words[1], NULL, 10) : 0;
  uint64_t to = count > 2 ? strtoull(words[2], NULL, 10) : RANDOM_SCENES;

  for (uint64_t seed = from; seed < to; seed++)
    {
      NSAutoreleasePool *pool = [[NSAutoreleasePool alloc] init];
      test(seed);
      [pool release];
    }
  return test_done();
}

#endif
