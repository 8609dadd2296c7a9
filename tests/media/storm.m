// storm.m - clear bodies at random, one in the other and across each other:
// spheres, pyramids on both sides of a star (convex or not, of few faces or
// many) and such with a cavity and a grain in it. Rays that go on at random
// are in what they lie in, and both engines see the same. The number of a
// scene is its seed; `storm FROM TO` makes those.

#import "support.h"

#if defined(__OPTIMIZE__) && !defined(__SANITIZE_ADDRESS__)
#define SCENES 60
#else
#define SCENES 8
#endif

/** A star with two tips, and smaller ones in it; or a sphere. */
struct body
{
  struct k_vec o, axis[3];      // its middle and directions
  double size, ratio;           // the inner corners are nearer by the ratio
  unsigned n;                   // corners of the star; 0: a sphere
  unsigned shells;              // each half as large as the one before
};

struct world
{
  struct body bodies[6];
  unsigned count;
  NSMutableString *text;
};

static struct k_vec
place(const struct body *b, double x, double y, double z)
{
  return k_along(k_along(k_along(b->o, x, b->axis[0]), y, b->axis[1]), z,
                 b->axis[2]);
}

/** Corner i of the star, or a tip: -1 and -2. */
static struct k_vec
corner(const struct body *b, int i, unsigned shell)
{
  double s = ldexp(b->size, -(int)shell), a = 2 * M_PI * (i % (int)b->n) / b->n;
  double r = i % 2 ? s * b->ratio : s;

  return i == -1 ? place(b, 0, 0, s) : i == -2 ? place(b, 0, 0, -s)
    : place(b, r * cos(a), r * sin(a), 0);
}

/** Face f of a shell: three corners. */
static void
face(const struct body *b, unsigned shell, unsigned f, struct k_vec v[3])
{
  int i = f / 2;

  v[0] = corner(b, i, shell);
  v[1] = corner(b, (i + 1) % b->n, shell);
  v[2] = corner(b, f % 2 ? -2 : -1, shell);
}

static struct body
body_of(struct support_random *random)
{
  static const unsigned corners[] = { 0, 0, 4, 6, 16, 140 };
  struct body b;

  b.o = support_point(random, 1);
  b.axis[0] = support_direction(random);
  b.axis[1] = k_unit(k_cross(b.axis[0], support_direction(random)));
  b.axis[2] = k_cross(b.axis[0], b.axis[1]);
  b.size = support_between(random, 0.3, 1.5);
  b.n = corners[(int)(6 * support_unit(random))];
  b.ratio = b.n && support_unit(random) < 0.5 ? 0.6 : 1;
  b.shells = b.n && b.n < 100 && support_unit(random) < 0.3 ? 3 : 1;
  return b;
}

static void
write_body(NSMutableString *text, const struct body *b, unsigned k,
           const char *material)
{
  if (b->n == 0)
    {
      [text appendFormat: @"sphere s%u { material %s center %.17g %.17g %.17g"
        @" radius %.17g }\n", k, material, b->o.x, b->o.y, b->o.z, b->size];
    }
  for (unsigned shell = 0; shell < b->shells; shell++)
    {
      for (unsigned f = 0; f < 2 * b->n; f++)
        {
          struct k_vec v[3];
          face(b, shell, f, v);
          [text appendFormat: @"polygon p%u-%u-%u { material %s solid s%u", k,
            shell, f, material, k];
          for (int i = 0; i < 3; i++)
            {
              [text appendFormat: @" vertex %.17g %.17g %.17g", v[i].x,
                v[i].y, v[i].z];
            }
          [text appendString: @" }\n"];
        }
    }
}

static const char *
material(struct support_random *random)
{
  static const char *all[] = { "glass", "water", "air", "heavy" };

  return all[(int)(4 * support_unit(random))];
}

static struct world
world_of(uint64_t seed)
{
  struct support_random random = support_seed(seed);
  struct world w = { .count = 2 + seed % 5 };

  w.text = [NSMutableString stringWithString:
    @"background .2 .3 .4\nlight a { location 5 6 7 emissivity 9 9 9 }\n"
    @"light b { location 0 0 0 emissivity 1 .5 1 }\n"
    @"material glass { ambient 0 .1 .1 alpha .95 ior 1.5 specular .1 .1 .1"
    @" }\nmaterial water { alpha .9 ior 1.33 }\nmaterial air { alpha 1 }\n"
    @"material heavy { ambient .1 .2 0 diffuse .4 .3 .2 alpha .5 ior 2 }\n"
    @"material stone { ambient .1 .1 .1 diffuse .6 .5 .4 }\n"
    @"sphere stone { material stone center .3 .2 -.1 radius .25 }\n"
    @"sphere room { material stone center 0 0 0 radius 40 }\n"];
  for (unsigned k = 0; k < w.count; k++)
    {
      struct body *b = &w.bodies[k];
      *b = body_of(&random);
      if (k % 3 == 2)           // in or round the one before
        {
          b->o = b[-1].o;
          b->size = b[-1].size * (support_unit(&random) < 0.5 ? 0.3 : 2.5);
        }
      write_body(w.text, b, k, material(&random));
    }
  struct k_vec eye = seed % 2 ? k_vec(0, 0, 5)
    : k_along(w.bodies[0].o, 0.3 * w.bodies[0].size,
              support_direction(&random));
  [w.text appendFormat: @"camera c { pixeldim 16 12 viewpoint %.17g %.17g"
    @" %.17g lookat .01 .02 -.03 up 0 1 0 angle 70%s }\n", eye.x, eye.y, eye.z,
    seed % 4 < 2 ? "" : " focus 2 fstop 5 exposure 2"];
  return w;
}

/** How often the triangles go round P, in whole turns: the sum of the signed
    solid angles, by Van Oosterom and Strackee. */
static double
turns(const struct body *b, unsigned shell, struct k_vec P)
{
  double sum = 0;

  for (unsigned f = 0; f < 2 * b->n; f++)
    {
      struct k_vec v[3];
      face(b, shell, f, v);
      struct k_vec p = k_sub(v[0], P), q = k_sub(v[1], P), r = k_sub(v[2], P);
      double l = k_length(p), m = k_length(q), n = k_length(r);
      double angle = atan2(k_dot(p, k_cross(q, r)),
                           l * m * n + k_dot(p, q) * n + k_dot(q, r) * l
                           + k_dot(r, p) * m);
      sum += f % 2 ? -angle : angle;
    }
  return fabs(sum) / (2 * M_PI);
}

static int
is_in(const struct body *b, struct k_vec P)
{
  int shells = 0;

  if (b->n == 0)
    {
      return k_length(k_sub(P, b->o)) < b->size;
    }
  for (unsigned shell = 0; shell < b->shells; shell++)
    {
      shells += turns(b, shell, P) > 0.5;
    }
  return shells % 2;
}

struct found
{
  unsigned pieces, wrong;
};

/** Whether the ray is in those bodies, and no others, that its way to the hit
    lies in. */
static void
check_media(const struct world *w, object_t *const *objects, ray_t *ray,
            double t, struct found *found)
{
  struct k_vec P = k_along(ray->pos->v, t / 2, ray->dir->v);

  for (unsigned k = 0; t > 1e-6 && k < w->count; k++)
    {
      int depth = 0;
      for (media_t *m = ray->media; m; m = m->below)
        {
          depth += m->object == [objects[k] medium];
        }
      found->pieces++;
      if (depth != is_in(&w->bodies[k], P))
        {
          found->wrong++;
          printf("# body %u: %d times in the media, from (%.17g %.17g %.17g)"
                 " along (%.17g %.17g %.17g) to %g\n", k, depth,
                 ray->pos->v.x, ray->pos->v.y, ray->pos->v.z, ray->dir->v.x,
                 ray->dir->v.y, ray->dir->v.z, t);
        }
    }
}

/** The ray after a hit, reflected or, through what is clear, refracted: any
    direction on that side (autoreleased). */
static ray_t *
next(ray_t *ray, struct support_random *random)
{
  struct k_vec N = ray->hit.N, d = support_direction(random);
  BOOL goes_in = k_dot(N, ray->dir->v) < 0;
  BOOL through = ray->hit.object->material->alpha > 0
    && support_unit(random) < 0.7;
  object_t *medium = [ray->hit.object medium];
  media_t *media = ray->media;

  if ((k_dot(d, N) > 0) == (goes_in == through))
    {
      d = k_neg(d);
    }
  if (through)
    {
      media = goes_in ? [media_t enter: medium : 1 over: media]
        : [media_t leave: medium from: media];
    }
  ray_t *on = [(ray_t *)[ray_t alloc] init: [vec_t vec: ray->hit.P]
                                          : [vec_t vec: d]
                                      from: ray through: through];
  on->counters = &on->own_counters;
  [media retain];
  [on->media release];
  on->media = media;
  return [on autorelease];
}

static void
walk(const struct world *w, model_t *model, uint64_t seed,
     struct found *found)
{
  struct support_random random = support_seed(1000 + seed);
  object_t *objects[6];

  for (unsigned k = 0; k < w->count; k++)
    {
      char name[32];
      snprintf(name, sizeof name, w->bodies[k].n ? "p%u-0-0" : "s%u", k);
      objects[k] = support_object(model, name);
    }
  for (unsigned i = 0; i < 100; i++)
    {
      NSAutoreleasePool *pool = [[NSAutoreleasePool alloc] init];
      struct sample s = { .u = support_between(&random, -1, 1),
                          .v = support_between(&random, -1, 1) };
      struct k_vec o = support_point(&random, 2), d;
      if (i % 2)
        {
          [model->camera ray: s pos: &o dir: &d];
        }
      ray_t *ray = support_ray(model, o, support_direction(&random));
      for (unsigned step = 0; step < 12; step++)
        {
          [model find_closest: ray];
          if (ray->hit.object == nil)
            {
              break;
            }
          check_media(w, objects, ray, ray->hit.t, found);
          ray = next(ray, &random);
        }
      [pool release];
    }
}

static struct counters all;

static void
pictures(model_t *model, uint64_t seed)
{
  struct counters mine[2] = { { 0 }, { 0 } };
  id <engine_t> engines[2] = {
    [[[notes_t alloc] initWithModel: model] autorelease],
    support_fast(model, seed % 3 ? nil : @"base")
  };
  struct window window = { 0, 0, model->camera->columns,
                           model->camera->rows };
  image_t *image[2];
  size_t bad = 0;

  for (int k = 0; k < 2; k++)
    {
      image[k] = [[[image_t alloc] init: window.x1 : window.y1 window: window
                                    surfaces: YES error: NULL] autorelease];
      render_t *render = [[render_t alloc]
                            init: engines[k] camera: model->camera
                            into: image[k] options: support_render_options()];
      [render run];
      mine[k] = render->counters;
      [render release];
    }
  for (unsigned i = 0; i < window.x1 * window.y1; i++)
    {
      bad += !isfinite(k_norm1(image[1]->pixels[i].color));
    }
  PASS(support_differences(image[0], image[1]) == 0 && bad == 0
       && mine[0].refraction == mine[1].refraction
       && counters_same_edges(&mine[0], &mine[1]),
       "scene %llu: both engines see the same", (unsigned long long)seed);
  counters_add(&all, &mine[1]);
}

int
main(int count, char **words)
{
  NSAutoreleasePool *pool = [[NSAutoreleasePool alloc] init];
  struct found found = { 0 };
  uint64_t from = count > 1 ? atoi(words[1]) : 0;
  uint64_t to = count > 2 ? atoi(words[2]) : SCENES;

  for (uint64_t seed = from; seed < to; seed++)
    {
      NSAutoreleasePool *inner = [[NSAutoreleasePool alloc] init];
      struct world w = world_of(seed);
      model_t *model = support_model_with(support_options(), w.text);
      model->max_depth = 7;
      walk(&w, model, seed, &found);
      pictures(model, seed);
      [inner release];
    }
  PASS(found.wrong == 0, "of %u times that a ray is in a body or is not, the"
       " media are wrong in %u", found.pieces, found.wrong);
  PASS(all.escapes == 0, "%llu of %llu refracted rays escape",
       (unsigned long long)all.escapes, (unsigned long long)all.refraction);
  [pool release];
  return test_done();
}
