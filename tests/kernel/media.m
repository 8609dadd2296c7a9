// media.m - clear things in clear things, overlapping, touching the eye: what
// the notes engine sees through them the kernel sees too, bit for bit. Scenes
// at random; the number of each is its seed.

#import "kernel.h"

static struct k_vec
somewhere(struct support_random *random)
{
  return k_along(k_vec(1, 1, 2), 1, support_point(random, 1));
}

static const char *
material(struct support_random *random)
{
  static const char *all[] = { "glass", "water", "air", "tinted", "chrome",
                               "stone" };

  return all[(int)(6 * pow(support_unit(random), 2))];
}

/** Spheres one in the other or across each other, boxes, prisms over an L,
    sheets; the eye in the middle of it now and then. */
static NSString *
text(uint64_t seed)
{
  static const double l[6][2] = { { 0, 0 }, { 2, 0 }, { 2, 1 }, { 1, 1 },
                                  { 1, 2 }, { 0, 2 } };
  struct support_random random = support_seed(seed);
  NSMutableString *text = [NSMutableString stringWithFormat:
    @"camera c { pixeldim 24 18 worlddim 2 1.5 viewpoint 1 1 %g }\n"
    @"background .2 .3 .4\nlight a { location 3 5 4 emissivity 1 1 1 }\n"
    @"light b { location 1 1 2 emissivity 1 .5 1 falloff 2 }\n"
    @"material glass { ambient 0 .1 .1 alpha .95 ior 1.5 specular .1 .1 .1"
    @" shininess 9 }\nmaterial water { ambient .1 0 .1 alpha .9 ior 1.33 }\n"
    @"material air { alpha 1 }\n"
    @"material tinted { ambient .1 .2 0 diffuse .4 .3 .2 alpha .5 ior 2 }\n"
    @"material chrome { diffuse .1 .1 .1 specular .8 .8 .8 shininess 5 }\n"
    @"material stone { ambient .1 .1 .1 diffuse .6 .5 .4 }\n"
    @"plane floor { material %s normal 0 1 0 point 0 -.25 0 }\n",
    seed % 3 ? 5 : 2.25, seed % 4 ? "stone" : "water"];

  for (int i = 0; i < 5; i++)
    {
      struct k_vec c = somewhere(&random);
      double r = support_between(&random, 0.2, 1.2);
      for (int shell = 0; shell < 1 + i % 3; shell++)
        {
          [text appendFormat: @"sphere s%d-%d { material %s center %.17g %.17g"
            @" %.17g radius %.17g }\n", i, shell, material(&random), c.x, c.y,
            c.z, r];
          r *= support_between(&random, 0.4, 1);
          c = k_along(c, 0.2 * r, support_point(&random, 1));
        }
    }
  for (int i = 0; i < 2; i++)
    {
      char name[16];
      struct k_vec p = somewhere(&random);
      double r = support_between(&random, 0.3, 1);
      snprintf(name, sizeof name, "b%d", i);
      [text appendFormat: @"%s", support_box(name, name, material(&random), p,
                                             k_add(p, k_vec(r, 0.5, r)))];

      const char *clear = material(&random);
      struct k_vec q = somewhere(&random), v[2][6];
      for (int k = 0; k < 6; k++)
        {
          v[0][k] = k_add(q, k_vec(0.4 * l[k][0], 0.1 * l[k][1] * (i + 1),
                                   0.4 * l[k][1]));
          v[1][k] = k_add(v[0][k], k_vec(0, r, 0));
        }
      for (int face = 0; face < 8; face++)
        {
          [text appendFormat: @"polygon l%d%d { material %s solid l%d", i,
            face, clear, i];
          for (int k = 0; k < (face < 6 ? 4 : 6); k++)
            {
              struct k_vec at = face < 6
                ? v[k / 2][(face + (k == 1 || k == 2)) % 6] : v[face - 6][k];
              [text appendFormat: @" vertex %.17g %.17g %.17g", at.x, at.y,
                at.z];
            }
          [text appendString: @" }\n"];
        }
      [text appendFormat: @"polygon t%d { material %s", i,
        material(&random)];
      for (int k = 0; k < 3; k++)
        {
          struct k_vec at = somewhere(&random);
          [text appendFormat: @" vertex %.17g %.17g %.17g", at.x, at.y, at.z];
        }
      [text appendString: @" }\n"];
    }
  return text;
}

static struct counters all;

static void
scene(uint64_t seed)
{
  NSAutoreleasePool *pool = [[NSAutoreleasePool alloc] init];
  model_t *model = support_model_with(support_options(), text(seed));
  struct counters notes = { 0 }, fast = { 0 };
  unsigned wrong = 0, columns = model->camera->columns;
  unsigned rows = model->camera->rows;
  const struct k_isa *isas[4];
  unsigned count = kernel_isas(isas);

  model->max_depth = 7;
  fast_t *engine = (fast_t *)support_fast(model, nil);
  notes_t *oracle = [[[notes_t alloc] initWithModel: model] autorelease];
  for (unsigned i = 0; i < columns * rows; i++)
    {
      NSAutoreleasePool *inner = [[NSAutoreleasePool alloc] init];
      struct k_vec o = k_vec(1, 1, seed % 3 ? 5 : 2.25);
      struct k_vec at = k_vec(2.0 * (i % columns) / columns,
                              1.5 * (i / columns) / rows, 0);
      struct k_vec d = k_unit(k_sub(at, o));
      struct k_vec wanted = support_color(oracle, o, d, &notes);
      for (unsigned k = 0; k < count; k++)
        {
          struct counters own = { 0 };
          engine->scene->isa = isas[k];
          struct k_vec color = support_color(engine, o, d, &own);
          if (!support_same(color, wanted) && wrong++ < 3)
            {
              printf("# %s: pixel %u: (%a %a %a), not (%a %a %a)\n",
                     isas[k]->name, i, color.x, color.y, color.z, wanted.x,
                     wanted.y, wanted.z);
            }
          if (k == 0)
            {
              counters_add(&fast, &own);
            }
        }
      [inner release];
    }
  PASS(wrong == 0, "scene %llu: %u pixels differ", (unsigned long long)seed,
       wrong);
  PASS(fast.refraction == notes.refraction && counters_same_edges(&fast, &notes)
       && fast.reflection == notes.reflection && fast.feeler == notes.feeler,
       "it takes the same rays: %llu refracted,"
       " %llu reflected, %llu feelers, %llu escapes",
       (unsigned long long)fast.refraction,
       (unsigned long long)fast.reflection, (unsigned long long)fast.feeler,
       (unsigned long long)fast.escapes);
  counters_add(&all, &fast);
  [pool release];
}

int
main(void)
{
  NSAutoreleasePool *pool = [[NSAutoreleasePool alloc] init];

  for (uint64_t seed = 0; seed < 28; seed++)
    {
      scene(seed);
    }
  PASS(all.refraction > 4 * all.eye && all.reflection > 2 * all.eye,
       "%llu eye rays make %llu refracted ones, %llu reflected ones and %llu"
       " escapes", (unsigned long long)all.eye,
       (unsigned long long)all.refraction, (unsigned long long)all.reflection,
       (unsigned long long)all.escapes);
  [pool release];
  return test_done();
}
