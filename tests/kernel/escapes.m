// escapes.m - rays that leave something clear without going through its
// surface: both engines take it off the ray's media when it hits the next
// thing, and count it.

#import "kernel.h"

/** `leaky name { … }`: a ball that a ray below z = 0 finds no way out of. */
@interface leaky_t : sphere_t
@end

@implementation leaky_t

- (BOOL) compile: (id)compiler
{
  return NO;
}

- (void) hits: (ray_t *)ray
{
  if (ray->pos->v.z > 0)
    {
      [super hits: ray];
    }
}

@end

/** `probe name { … }`: a ball that writes down the media of the last ray that
    hit it. */
@interface probe_t : sphere_t
@end

static char seen[256];          // indices, from the top down

@implementation probe_t

- (BOOL) compile: (id)compiler
{
  return NO;
}

- (void) hits: (ray_t *)ray
{
  [super hits: ray];
  if (ray->hit.object == self && !ray->is_feeler)
    {
      seen[0] = 0;
      for (media_t *m = ray->media; m; m = m->below)
        {
          sprintf(seen + strlen(seen), "%g ", m->ior);
        }
    }
}

@end

#define WORLD SUPPORT_CAMERA "background 1 1 1\n" \
  "material black { }\nmaterial sheet { alpha 1 }\n" \
  "material glass { alpha 1 ior 1.5 }\nmaterial water { alpha 1 ior 1.25 }\n" \
  "material air { alpha 1 }\nmaterial heavy { alpha 1 ior 2 }\n"

/** A thin sheet square to z. */
#define SHEET(name, z) "polygon " name " { material sheet vertex -5 -5 " z \
  " vertex 5 -5 " z " vertex 5 5 " z " vertex -5 5 " z " }\n"

/** Traces a ray straight down in both engines, with all instruction sets: the
    media that it is in at the probe, and whether any ray on the way, reflected
    ones too, has escaped. */
static void
check(model_t *model, const char *media, int escapes, const char *what)
{
  struct k_vec o = k_vec(0, 0, 9), down = k_vec(0, 0, -1);
  struct counters notes = { 0 };
  const struct k_isa *isas[4];
  unsigned count = kernel_isas(isas);
  fast_t *engine = (fast_t *)support_fast(model, nil);
  notes_t *oracle = [[[notes_t alloc] initWithModel: model] autorelease];

  strcpy(seen, "nothing");
  struct k_vec wanted = support_color(oracle, o, down, &notes);
  PASS(strcmp(seen, media) == 0 && (notes.escapes > 0) == escapes,
       "%s: %sair, %llu escapes", what, seen,
       (unsigned long long)notes.escapes);
  for (unsigned k = 0; k < count; k++)
    {
      struct counters fast = { 0 };
      strcpy(seen, "nothing");
      engine->scene->isa = isas[k];
      struct k_vec color = support_color(engine, o, down, &fast);
      PASS(strcmp(seen, media) == 0 && fast.escapes == notes.escapes
           && support_same(color, wanted), "%s, %s: %sair, %llu escapes",
           what, isas[k]->name, seen, (unsigned long long)fast.escapes);
    }
}

#define PROBE "probe p { material black center 0 0 -1 radius .25 }\n"
#define LEAKY "leaky l { material glass center 0 0 0 radius 3 }\n"
#define WATER "sphere w { material water center 0 0 0 radius 2 }\n"
#define HEAVY "sphere h { material heavy center 0 0 0 radius 4 }\n"
#define SHEETS SHEET("a", "-.25") SHEET("b", "-.5")

/** A ball that lies: alone, and below, above and between others that stay.
    The second sheet is hit by a ray from below z = 0. */
static void
lies(void)
{
  check(support_model(WORLD LEAKY PROBE), "1.5 ", 0, "from above z = 0");
  check(support_model(WORLD LEAKY SHEETS PROBE), "", 1, "from one medium");
  check(support_model(WORLD LEAKY WATER SHEETS PROBE), "1.25 ", 1,
        "from under another");
  check(support_model(WORLD HEAVY LEAKY SHEETS PROBE), "2 ", 1,
        "from above another");
  check(support_model(WORLD HEAVY LEAKY WATER SHEETS PROBE), "1.25 2 ", 1,
        "from between two");
  check(support_model(WORLD LEAKY WATER "leaky m { material heavy"
                      " center 0 0 0 radius 1 }\n" SHEETS PROBE), "1.25 ", 1,
        "two, from above and below another");
}

/** Rays aimed at the edges of tilted clear L-prisms of ior 1: now and then
    one slips out between two faces. */
static void
edges(void)
{
  static const double l[6][2] = { { 0, 0 }, { 2, 0 }, { 2, 1 }, { 1, 1 },
                                  { 1, 2 }, { 0, 2 } };
  struct counters notes = { 0 }, fast = { 0 };
  unsigned wrong = 0, rays = 0;

  for (unsigned seed = 0; seed < 40; seed++)
    {
      NSAutoreleasePool *pool = [[NSAutoreleasePool alloc] init];
      struct support_random random = support_seed(seed);
      struct k_vec x = support_direction(&random);
      struct k_vec y = k_unit(k_cross(x, support_direction(&random)));
      struct k_vec z = k_cross(x, y), at[2][6];
      NSMutableString *text = [NSMutableString stringWithUTF8String: WORLD
        "material room { ambient 1 2 3 }\n"
        "sphere room { material room center 0 0 0 radius 50 }\n"];
      for (int i = 0; i < 12; i++)
        {
          at[i / 6][i % 6] = k_add(k_add(k_scale(x, l[i % 6][0]),
                                         k_scale(y, l[i % 6][1])),
                                   k_scale(z, i / 6));
        }
      for (int face = 0; face < 8; face++)
        {
          [text appendFormat: @"polygon l%d { material air solid l", face];
          for (int k = 0; k < (face < 6 ? 4 : 6); k++)
            {
              struct k_vec v = face < 6
                ? at[k / 2][(face + (k == 1 || k == 2)) % 6]
                : at[face - 6][k];
              [text appendFormat: @" vertex %.17g %.17g %.17g", v.x, v.y, v.z];
            }
          [text appendString: @" }\n"];
        }
      model_t *model = support_model_with(support_options(), text);
      id <engine_t> engine = support_fast(model, nil);
      notes_t *oracle = [[[notes_t alloc] initWithModel: model] autorelease];
      for (unsigned i = 0; i < 500 / KERNEL_FEWER; i++)
        {
          NSAutoreleasePool *inner = [[NSAutoreleasePool alloc] init];
          unsigned k = 6 * support_unit(&random);
          struct k_vec edge = k_along(at[0][k], support_unit(&random), z);
          struct k_vec o = k_along(edge, 5, support_direction(&random));
          struct k_vec d = k_unit(k_sub(edge, o));
          struct k_vec a = support_color(oracle, o, d, &notes);
          struct k_vec b = support_color(engine, o, d, &fast);
          wrong += !support_same(a, b);
          rays++;
          [inner release];
        }
      [pool release];
    }
  PASS(notes.escapes > 0 && notes.escapes == fast.escapes,
       "%u rays at the edges of prisms: %llu escapes in the notes engine,"
       " %llu in the fast one", rays, (unsigned long long)notes.escapes,
       (unsigned long long)fast.escapes);
  PASS(wrong == 0, "both see the same: %u", wrong);
}

int
main(void)
{
  NSAutoreleasePool *pool = [[NSAutoreleasePool alloc] init];

  lies();
  edges();
  [pool release];
  return test_done();
}
