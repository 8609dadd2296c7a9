// random_scenes.m - valid scenes at random: every class, every kind of
// material, lights, cameras with and without a lens, of any size. Both engines,
// every instruction set and any number of threads give the same bits and count
// the same rays; every number is finite; and of a pixel --explain tells as many
// rays as were traced. The number of a scene is its seed; `random_scenes FROM
// TO` makes those.

#import "explain_t.h"
#import "scene.h"
#include "test.h"

#if defined(__OPTIMIZE__) && !defined(__SANITIZE_ADDRESS__)
#define SCENES 150
#else
#define SCENES 15
#endif

/** A scene in the making; lengths are times the scale. */
struct making
{
  struct support_random random;
  double scale;
  NSMutableString *text;
};

static unsigned
choose(struct making *m, unsigned count)
{
  return (unsigned)(count * support_unit(&m->random));
}

static void
write_point(struct making *m, const char *word, struct k_vec p)
{
  p = k_scale(p, m->scale);
  [m->text appendFormat: @" %s %.17g %.17g %.17g", word, p.x, p.y, p.z];
}

static void
write_color(struct making *m, const char *word, double most)
{
  [m->text appendFormat: @" %s %.3g %.3g %.3g", word,
     most * support_unit(&m->random), most * support_unit(&m->random),
     most * support_unit(&m->random)];
}

static void
write_material(struct making *m, unsigned k)
{
  static const double iors[] = { 1, 1.0001, 1.33, 1.5, 2.4, 0.7, 5 };

  [m->text appendFormat: @"material m%u {", k];
  write_color(m, "ambient", 0.5);
  if (choose(m, 4))
    {
      write_color(m, "diffuse", 1);
    }
  if (choose(m, 2))
    {
      write_color(m, "specular", 1);
      [m->text appendFormat: @" shininess %.3g",
         exp2(support_between(&m->random, 0, 12))];
    }
  if (choose(m, 2))
    {
      [m->text appendFormat: @" alpha %.3g ior %g",
         choose(m, 4) ? support_unit(&m->random) : 1, iors[choose(m, 7)]];
    }
  [m->text appendString: @" }\n"];
}

/** n corners round a point: a star when `inner` is less than 1. */
static void
write_star(struct making *m, struct k_vec middle, double size, unsigned n,
           double inner)
{
  struct k_vec a = support_direction(&m->random);
  struct k_vec b = k_unit(k_cross(a, support_direction(&m->random)));

  for (unsigned i = 0; i < n; i++)
    {
      double angle = 2 * M_PI * i / n, r = i % 2 ? inner * size : size;
      write_point(m, "vertex",
                  k_along(k_along(middle, r * cos(angle), a), r * sin(angle),
                          b));
    }
}

static void
write_tetrahedron(struct making *m, unsigned k, unsigned material,
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
              write_point(m, "vertex", v[i]);
            }
        }
      [m->text appendString: @" }\n"];
    }
}

static void
write_object(struct making *m, unsigned k, unsigned materials)
{
  struct k_vec middle = support_point(&m->random, 3);
  double size = exp2(support_between(&m->random, choose(m, 8) ? -3 : -30, 2));
  unsigned material = choose(m, materials);

  switch (choose(m, 8))
    {
    case 0:
      [m->text appendFormat: @"plane o%u { material m%u", k, material];
      write_point(m, "point", k_scale(middle, 3));
      struct k_vec n = support_direction(&m->random);
      [m->text appendFormat: @" normal %.17g %.17g %.17g }\n", n.x, n.y, n.z];
      return;
    case 1: case 2:
      [m->text appendFormat: @"polygon o%u { material m%u", k, material];
      write_star(m, middle, size, 3 + choose(m, 5), 1);
      break;
    case 3:
      [m->text appendFormat: @"polygon o%u { material m%u", k, material];
      write_star(m, middle, size, 4 + 2 * choose(m, 12), 0.5);
      break;
    case 4:
      write_tetrahedron(m, k, material, middle, size);
      return;
    default:
      [m->text appendFormat: @"sphere o%u { material m%u", k, material];
      write_point(m, "center", middle);
      [m->text appendFormat: @" radius %.17g", size * m->scale];
    }
  [m->text appendString: @" }\n"];
}

static NSString *
text_of(uint64_t seed)
{
  struct making m = { support_seed(seed), 1, [NSMutableString string] };
  unsigned materials = 1 + choose(&m, 5), objects = 1 + choose(&m, 30);
  unsigned lights = choose(&m, 4);

  m.scale = choose(&m, 2) ? 1 : ldexp(1, (int)choose(&m, 121) - 60);
  [m.text appendString: @"camera c { pixeldim 12 9"];
  write_point(&m, "viewpoint", support_point(&m.random, 5));
  write_point(&m, "lookat", support_point(&m.random, 0.5));
  [m.text appendFormat: @" up 0.01 1 0.02 angle %.3g",
     support_between(&m.random, 5, 120)];
  if (choose(&m, 3) == 0)
    {
      [m.text appendFormat: @" focus %.17g fstop %.17g exposure %u",
         m.scale * support_between(&m.random, 0.5, 9),
         support_between(&m.random, 1, 30) / m.scale, 1 + choose(&m, 4)];
    }
  [m.text appendString: @" }\n"];
  if (choose(&m, 2))
    {
      [m.text appendString: @"background .1 .2 .3\n"];
    }
  for (unsigned k = 0; k < lights; k++)
    {
      [m.text appendFormat: @"light l%u {", k];
      write_point(&m, "location", support_point(&m.random, 6));
      write_color(&m, "emissivity", 2);
      [m.text appendString: @" }\n"];
    }
  for (unsigned k = 0; k < materials; k++)
    {
      write_material(&m, k);
    }
  for (unsigned k = 0; k < objects; k++)
    {
      write_object(&m, k, materials);
    }
  return m.text;
}

static BOOL
same_counters(const struct counters *a, const struct counters *b)
{
  return a->eye == b->eye && a->reflection == b->reflection
    && a->refraction == b->refraction && a->feeler == b->feeler
    && counters_same_edges(a, b);
}

/** How many rays --explain tells of a pixel. */
static unsigned
rays_told(model_t *model, struct render_options options, struct window pixel)
{
  explain_t *engine = [[[explain_t alloc] initWithModel: model] autorelease];
  struct counters counters;
  NSString *text = [engine textOf: support_render_counted(model, engine, options, pixel,
                                           NO, &counters)];
  unsigned rays = 0;

  for (NSString *line in [text componentsSeparatedByString: @"\n"])
    {
      rays += [[line stringByTrimmingCharactersInSet:
                       [NSCharacterSet whitespaceCharacterSet]]
                hasPrefix: @"ray "];
    }
  return rays;
}

static void
scene(uint64_t seed)
{
  model_t *model = support_model_with(support_options(), text_of(seed));
  struct render_options options = support_render_options();
  camera_t *camera = model->camera;
  struct window all = { 0, 0, camera->columns, camera->rows };
  struct counters wanted, counters;

  options.samples = 1 + seed % 3;
  options.seed = seed;
  model->choice.exact_fresnel = seed % 5 == 0;
  options.threads = 1;
  image_t *notes = support_render_counted(model, [[[notes_t alloc] initWithModel: model]
                                    autorelease], options, all, YES,
                           &wanted);
  size_t bad = 0, apart = 0, miscounted = 0;
  for (unsigned i = 0; i < all.x1 * all.y1; i++)
    {
      bad += !isfinite(k_norm1(notes->pixels[i].color))
        || isnan(notes->surfaces[i].depth);
    }
  for (int isa = 0; isa < 2; isa++)
    {
      options.threads = 1 + 2 * isa;
      image_t *fast = support_render_counted(model, support_fast(model, isa ? nil : @"base"),
                              options, all, YES, &counters);
      apart += support_pixels_apart(notes, fast);
      miscounted += !same_counters(&wanted, &counters);
    }
  PASS(bad == 0 && apart == 0 && miscounted == 0, "scene %llu: %zu not finite,"
       " %zu pixels apart, %zu miscounted", (unsigned long long)seed, bad,
       apart, miscounted);
  unsigned samples = options.samples * camera->exposure;
  PASS(wanted.eye == (uint64_t)all.x1 * all.y1 * samples,
       "scene %llu: all eye rays", (unsigned long long)seed);
  struct window pixel = { seed % all.x1, seed % all.y1, seed % all.x1 + 1,
                          seed % all.y1 + 1 };
  support_render_counted(model, support_fast(model, nil), options, pixel, NO,
          &counters);
  unsigned told = rays_told(model, options, pixel);
  PASS(told == counters.eye + counters.reflection + counters.refraction,
       "scene %llu: %u rays of a pixel", (unsigned long long)seed, told);
}

int
main(int count, char **words)
{
  uint64_t from = count > 1 ? strtoull(words[1], NULL, 10) : 0;
  uint64_t to = count > 2 ? strtoull(words[2], NULL, 10) : SCENES;

  for (uint64_t seed = from; seed < to; seed++)
    {
      NSAutoreleasePool *pool = [[NSAutoreleasePool alloc] init];
      scene(seed);
      [pool release];
    }
  return test_done();
}
