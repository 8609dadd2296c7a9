// tree.m - the search through the tree finds what asking every shape finds:
// same surface, t, P and N, to the bit, by each instruction set; and what the
// notes engine finds. Random rays, rays aimed at where a search may fail, the
// rays that start where those hit, and shadow feelers; in scenes far from the
// origin, very small and very large, and seen from very far away.

#import "kernel.h"
#import "pebble.h"

/** A plane that it does not know: without a box. */
@interface sea_t : plane_t
@end

@implementation sea_t

- (BOOL) compile: (compiler_t *)compiler
{
  return NO;
}

@end

enum kind
{
  SPHERES, TRIANGLES, CONCAVE, MIXED
};

static const char *kind_names[] = { "spheres", "triangles",
                                    "concave polygons", "mixed shapes" };

// The sanitizers look at memory and at undefined operations, for which a part
// of the rays is enough.
#ifdef __SANITIZE_ADDRESS__
#define FEWER 10
#else
#define FEWER 1
#endif

#define SIZE 4.0                // all scenes fill about [-4, 4]^3

/** Then that is moved by `offset` and taken times 2^k. */
struct where
{
  int k;
  double offset;
  double away;          // aimed rays start this many SIZE away, or so
};

static struct where where;

static struct k_vec
placed(struct k_vec v)
{
  v = k_add(v, k_vec(where.offset, -where.offset, where.offset / 2));
  return k_scale(v, ldexp(1, where.k));
}

// Scenes

static const char *
some_material(struct support_random *random)
{
  double u = support_unit(random);

  return u < 0.7 ? "stone" : u < 0.9 ? "glass" : "water";
}

static void
add_sphere(NSMutableString *text, const char *word, unsigned i, double radius,
           struct support_random *random)
{
  struct k_vec c = placed(support_point(random, SIZE));

  radius = ldexp(radius, where.k);
  [text appendFormat: @"%s s%u { material %s center %.17g %.17g %.17g"
    @" radius %.17g }\n", word, i, some_material(random), c.x, c.y, c.z,
    radius * support_between(random, 0.2, 2)];
}

/** A polygon of n corners round a point, at random distances from it when it
    is to be concave; every fourth one at right angles to an axis. */
static void
add_polygon(NSMutableString *text, unsigned i, unsigned n, double radius,
            int is_concave, struct support_random *random)
{
  struct k_vec c = support_point(random, SIZE);
  struct k_vec z = support_direction(random), x, y;

  if (i % 4 == 0)
    {
      z = i % 8 ? k_vec(0, 1, 0) : k_vec(0, 0, 1);
    }
  x = k_unit(k_cross(z, fabs(z.x) < 0.5 ? k_vec(1, 0, 0) : k_vec(0, 1, 0)));
  y = k_cross(z, x);
  [text appendFormat: @"polygon p%u { material %s", i,
    some_material(random)];
  for (unsigned k = 0; k < n; k++)
    {
      double turn = 2 * M_PI * (k + 0.8 * support_unit(random)) / n;
      double r = radius * (is_concave ? support_between(random, 0.1, 2) : 1);
      struct k_vec v = placed(k_along(k_along(c, r * cos(turn), x),
                                      r * sin(turn), y));
      [text appendFormat: @" vertex %.17g %.17g %.17g", v.x, v.y, v.z];
    }
  [text appendString: @" }\n"];
}

/** A clear box, or a clear prism over an L. */
static void
add_solid(NSMutableString *text, unsigned i, double size, int is_convex,
          struct support_random *random)
{
  static const double outlines[2][6][2] = {
    { { 0, 0 }, { 2, 0 }, { 2, 1 }, { 1, 1 }, { 1, 2 }, { 0, 2 } },
    { { 0, 0 }, { 1, 0 }, { 1, 1 }, { 0, 1 } }
  };
  unsigned n = is_convex ? 4 : 6;
  struct k_vec c = support_point(random, SIZE);
  double turn = i % 2 ? support_between(random, 0, 7) : 0;
  struct k_vec corners[2][6];

  for (unsigned k = 0; k < n; k++)
    {
      double x = size * outlines[is_convex][k][0];
      double y = size * outlines[is_convex][k][1];
      struct k_vec at = { cos(turn) * x - sin(turn) * y,
                          sin(turn) * x + cos(turn) * y, 0 };
      corners[0][k] = k_add(c, at);
      corners[1][k] = k_add(corners[0][k], k_vec(0, 0, size));
    }
  for (unsigned face = 0; face < n + 2; face++)
    {
      [text appendFormat: @"polygon f%u-%u { material %s solid x%u", i, face,
        i % 3 ? "glass" : "water", i];
      for (unsigned k = 0; k < (face < n ? 4 : n); k++)
        {
          struct k_vec v = face < n
            ? corners[k / 2][(face + (k == 1 || k == 2)) % n]
            : corners[face - n][k];
          v = placed(v);
          [text appendFormat: @" vertex %.17g %.17g %.17g", v.x, v.y, v.z];
        }
      [text appendString: @" }\n"];
    }
}

static model_t *
scene_of(enum kind kind, unsigned n, uint64_t seed)
{
  struct support_random random = support_seed(seed);
  NSMutableString *text = [NSMutableString stringWithUTF8String:
    SUPPORT_CAMERA "material stone { }\nmaterial glass { alpha 1 ior 1.5 }\n"
    "material water { alpha .5 ior 1.33 }\n"];
  double radius = SIZE / cbrt(n);

  for (unsigned i = 0; i < n; i++)
    {
      unsigned what = kind == MIXED ? i % 16 : 0;
      if (kind == SPHERES || (kind == MIXED && what < 5))
        {
          add_sphere(text, "sphere", i, radius, &random);
        }
      else if (kind == TRIANGLES || (kind == MIXED && what < 8))
        {
          add_polygon(text, i, 3, 1.5 * radius, 0, &random);
        }
      else if (kind == CONCAVE || what < 12)
        {
          add_polygon(text, i, 4 + i % 9, radius, 1, &random);
        }
      else if (what == 12 && i < 400)
        {
          add_sphere(text, "pebble", i, radius, &random);
        }
      else
        {
          add_solid(text, i, radius, what < 15, &random);
        }
    }
  if (kind == MIXED)
    {
      static const char *planes[] = {
        "plane low { material stone normal 0 1 0",
        "plane side { material glass normal 1 .25 0",
        "sea sea { material stone normal .1 0 1",
        "sea mist { material water normal 0 -1 .5"
      };
      static const struct k_vec points[] = { { 0, -5, 0 }, { 3, 0, 0 },
                                             { 0, 0, -6 }, { 0, 4, 0 } };
      for (int i = 0; i < 4; i++)
        {
          struct k_vec p = placed(points[i]);
          [text appendFormat: @"%s point %.17g %.17g %.17g }\n", planes[i],
            p.x, p.y, p.z];
        }
    }
  return support_model_with(support_options(), text);
}

// Rays

static double
one_of(struct support_random *random, double a, double b)
{
  return support_unit(random) < 0.5 ? a : b;
}

/** Zero, of either sign. */
static double
zero(struct support_random *random)
{
  return one_of(random, 0.0, -0.0);
}

/** A point of a shape that a search may miss: a corner of a polygon or a
    place on its edge; a place on a sphere's outline, seen along d. */
static struct k_vec
feature(const struct k_scene *scene, struct k_ref ref, struct k_vec d,
        struct support_random *random)
{
  struct k_bounds box = kernel_box(scene, ref);

  if (ref.kind == K_POLYGON)
    {
      const struct k_polygon *p = &scene->polygons[ref.index];
      unsigned i = p->n * support_unit(random), j = (i + 1) % p->n;
      struct k_vec a = k_vec(p->vertex[0][i], p->vertex[1][i],
                             p->vertex[2][i]);
      struct k_vec b = k_vec(p->vertex[0][j], p->vertex[1][j],
                             p->vertex[2][j]);
      return support_unit(random) < 0.5 ? a
        : k_along(a, support_unit(random), k_sub(b, a));
    }
  struct k_vec c = k_scale(k_add(box.least, box.most), 0.5);
  struct k_vec across = k_unit(k_cross(d, support_direction(random)));
  return k_along(c, (box.most.x - box.least.x) / 2, across);
}

/** A corner of the box, or a place on an edge or a face of it. */
static struct k_vec
on_box(const struct k_bounds *box, int free, struct support_random *random)
{
  double v[3];

  for (int axis = 0; axis < 3; axis++)
    {
      double least = k_component(box->least, axis);
      double most = k_component(box->most, axis);
      v[axis] = axis < free ? support_between(random, least, most)
        : one_of(random, least, most);
    }
  int turn = 3 * support_unit(random);
  struct k_vec p = k_vec(v[0], v[1], v[2]);
  if (free && turn)
    {
      // The same with the axes changed: y and z are free in turn.
      p = on_box(box, 0, random);
      double f = support_between(random, box->least.y, box->most.y);
      p = turn == 1 ? k_vec(p.x, f, free == 2 ? support_between
                            (random, box->least.z, box->most.z) : p.z)
        : k_vec(p.x, p.y, support_between(random, box->least.z,
                                          box->most.z));
    }
  return p;
}

static void
random_ray(struct support_random *random, struct k_vec *o, struct k_vec *d)
{
  *o = placed(support_point(random, 2 * SIZE));
  *d = support_direction(random);
}

#define AIMS 9

static void
aimed_ray(const struct k_scene *scene, unsigned aim,
          struct support_random *random, struct k_vec *o, struct k_vec *d)
{
  uint32_t n = scene->tree.ref_count;
  struct k_ref ref = scene->tree.refs[(uint32_t)(n * support_unit(random))];
  struct k_bounds box = kernel_box(scene, ref);
  struct k_vec p = on_box(&box, aim % 3, random);
  double away = ldexp(where.away * support_between(random, -SIZE, SIZE),
                      where.k);

  random_ray(random, o, d);
  *o = k_along(*o, away, support_direction(random));
  switch (aim)
    {
    case 0:                     // a corner, an edge, a face of a box
    case 1:
    case 2:
      *d = k_unit(k_sub(p, *o));
      break;
    case 3:                     // in the plane of a face, or along an edge
    case 4:
      *d = aim == 3 ? k_vec(d->x, d->y, zero(random))
        : k_vec(zero(random), d->y, zero(random));
      *d = support_unit(random) < 0.5 ? k_vec(d->y, d->z, d->x) : *d;
      *d = support_unit(random) < 0.5 ? k_vec(d->y, d->z, d->x) : *d;
      *d = k_unit(*d);
      *o = k_along(p, away, *d);
      break;
    case 5:                     // from the box's corner
      *o = p;
      break;
    case 6:                     // a feature, from anywhere
      *o = k_along(feature(scene, ref, *d, random), away, *d);
      break;
    case 7:                     // a feature, along an axis
      *d = k_vec(zero(random), one_of(random, -1, 1), zero(random));
      *d = support_unit(random) < 0.5 ? k_vec(d->y, d->z, d->x) : *d;
      *o = k_along(feature(scene, ref, *d, random), away, *d);
      break;
    default:                    // through two features: in a polygon's plane
      p = feature(scene, ref, *d, random);
      *d = k_sub(feature(scene, ref, *d, random), p);
      *d = k_is_zero(*d) ? k_vec(1, 0, 0) : k_unit(*d);
      *o = k_along(p, away, *d);
    }
}

// Comparing

struct tally
{
  unsigned rays, hits, children, feelers, blocked, wrong;
  unsigned asked_notes, notes_wrong;
};

/** The ray as each instruction set finds it; *found as it should be. */
static void
compare(const struct k_scene *scene, const struct k_ray *ray,
        struct k_ray *found, struct tally *tally)
{
  const struct k_isa *isas[4];
  unsigned count = kernel_isas(isas);

  *found = *ray;
  kernel_ask_all(scene, found);
  kernel_finish(found);
  for (unsigned i = 0; i < count; i++)
    {
      struct k_ray other = *ray;
      isas[i]->closest(scene, &other);
      kernel_finish(&other);
      if (!kernel_agree(&other, found) && tally->wrong++ < 3)
        {
          kernel_show(isas[i]->name, &other, found);
        }
    }
}

/** The same by the notes engine; `parent` is nil for an eye ray. What it
    returns is autoreleased. */
static ray_t *
compare_notes(model_t *model, const struct k_ray *ray,
              const struct k_ray *found, ray_t *parent, int through,
              struct tally *tally)
{
  vec_t *o = [vec_t vec: ray->o], *d = [vec_t vec: ray->d];
  ray_t *twin = [ray_t alloc];

  twin = parent ? [twin init: o : d from: parent through: through]
    : [twin init: o : d];
  twin->is_feeler = ray->is_feeler;
  twin->end = ray->end;
  twin->end_slack = ray->end_slack;
  if (parent)
    {
      object_t *medium = [parent->hit.object medium];
      [twin->media release];
      twin->media = ray->media
        ? [[media_t enter: medium : ray->media->ior over: nil] retain] : nil;
    }
  [model find_closest: twin];
  unsigned number = twin->hit.object ? twin->hit.object->number : 0;
  unsigned wanted = found->hit.surface ? found->hit.surface->number : 0;
  int agrees = ray->is_feeler ? !number == !wanted
    : number == wanted
      && (!number || (twin->hit.t == found->hit.t
                      && support_same(twin->hit.P, found->hit.P)
                      && support_same(twin->hit.N, found->hit.N)));
  tally->asked_notes++;
  if (!agrees && tally->notes_wrong++ < 3)
    {
      kernel_show("kernel against notes", found, found);
      printf("#   notes: object %u at %a\n", number, twin->hit.t);
    }
  return [twin autorelease];
}

/** One ray, and when it hits a ray from there and a feeler. */
static void
try(model_t *model, const struct k_scene *scene, struct k_vec o,
    struct k_vec d, int asks_notes, struct support_random *random,
    struct tally *tally)
{
  struct counters counters = { 0 };
  struct k_ray ray = kernel_ray(o, d, &counters), found, next, last;
  struct k_media in = { 0 };
  ray_t *twin = nil;

  compare(scene, &ray, &found, tally);
  tally->rays++;
  tally->hits += found.hit.surface != NULL;
  if (asks_notes)
    {
      twin = compare_notes(model, &ray, &found, nil, 0, tally);
      asks_notes = twin->hit.object != nil;
    }
  if (!found.hit.surface || tally->rays % 4)
    {
      return;
    }

  // Reflected, or straight on into what is behind the surface.
  const struct k_surface *s = found.hit.surface;
  int through = !k_is_opaque(scene, s);
  next = kernel_child(&found, through ? d
                      : shade_renew(shade_reflect(d, found.hit.N)), through);
  if (through && s->medium && k_dot(found.hit.N, d) < 0)
    {
      in.medium = s->medium;
      in.ior = scene->materials[s->material].ior;
      next.media = &in;
    }
  compare(scene, &next, &last, tally);
  tally->children++;
  if (asks_notes)
    {
      compare_notes(model, &next, &last, twin, through, tally);
    }

  next = kernel_feeler(&found, placed(support_point(random, 2 * SIZE)));
  compare(scene, &next, &last, tally);
  tally->feelers++;
  tally->blocked += last.hit.surface != NULL;
  if (asks_notes)
    {
      compare_notes(model, &next, &last, twin, 0, tally);
    }
}

/** `rays` random rays and `aimed` aimed ones. */
static void
scene(enum kind kind, unsigned n, unsigned rays, unsigned aimed,
      struct where there)
{
  NSAutoreleasePool *pool = [[NSAutoreleasePool alloc] init];
  where = there;
  model_t *model = scene_of(kind, n, n + kind);
  fast_t *fast = (fast_t *)support_fast(model, nil);
  struct tally random_tally = { 0 }, aimed_tally = { 0 };

  rays /= KERNEL_FEWER;
  aimed /= KERNEL_FEWER;
  unsigned every = 1 + rays / 2000;

  for (unsigned i = 0; i < rays + aimed; i++)
    {
      NSAutoreleasePool *inner = [[NSAutoreleasePool alloc] init];
      struct support_random random = support_seed(i);
      struct k_vec o, d;
      if (i < rays)
        {
          random_ray(&random, &o, &d);
          try(model, fast->scene, o, d, i % (4 * every) < 4, &random,
              &random_tally);
        }
      else
        {
          aimed_ray(fast->scene, i % AIMS, &random, &o, &d);
          try(model, fast->scene, o, d, i % every == 0, &random,
              &aimed_tally);
        }
      [inner release];
    }
  const struct tally *tallies[] = { &random_tally, &aimed_tally };
  for (int i = 0; i < 2; i++)
    {
      const struct tally *t = tallies[i];
      const char *which = i ? "aimed" : "random";
      if (t->rays == 0)
        {
          continue;
        }
      PASS(t->hits > t->rays / 10 && t->feelers > t->rays / 50
           && t->blocked > t->feelers / 50,
           "%u %s + %g times 2^%d: of %u %s rays, from up to %g away, %u hit;"
           " of %u feelers %u are blocked", n, kind_names[kind], where.offset,
           where.k, t->rays, which, where.away * SIZE, t->hits, t->feelers,
           t->blocked);
      PASS(t->wrong == 0, "the tree finds what asking all does: %u wrong",
           t->wrong);
      PASS(t->notes_wrong == 0, "so does the notes engine: %u of %u wrong",
           t->notes_wrong, t->asked_notes);
    }
  [pool release];
}

int
main(void)
{
  NSAutoreleasePool *pool = [[NSAutoreleasePool alloc] init];
  const struct k_isa *isas[4];
  unsigned count = kernel_isas(isas);
  static const struct where places[] = {
    { 0, 0, 1e3 }, { 0, 0, 0x1p20 }, { 0, 0, 0x1p29 }, { 0, 0, 0x1p35 },
    { 0, 1e6, 2 }, { 0, 1e9, 2 }, { -370, 0, 2 }, { -370, 1e6, 1e3 },
    { 380, 0, 2 }, { 350, 1e9, 0x1p20 }
  };

  for (unsigned i = 0; i < count; i++)
    {
      printf("# instructions: %s\n", isas[i]->name);
    }
  for (int kind = SPHERES; kind <= MIXED; kind++)
    {
      struct where here = { 0, 0, 2 };
      scene(kind, 80, 230000 / FEWER, 23000 / FEWER, here);
      scene(kind, kind == MIXED ? 1000 : 2000, 20000 / FEWER, 2000 / FEWER,
            here);
      for (unsigned i = 0; i < sizeof places / sizeof *places; i++)
        {
          scene(kind, 80, 0, 4000, places[i]);
        }
    }
  [pool release];
  return test_done();
}
