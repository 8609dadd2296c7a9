// cuts.m - branches of the ray tree that are not traced, and the error that the
// picture says it may have for it: never less than the true one.

#import "cut_pictures.h"
#include "test.h"

#define WINDOW \
  "camera c { pixeldim 24 18 worlddim 8 6 viewpoint 4 3 9 }\n"

static const char *const scenes[] = {
  // Two mirrors face each other at a slant, coloured, ambient falls off.
  "mirrors", WINDOW
  "background .1 .2 .6\n"
  "light l { location 4 5 4 emissivity 3 4 5 }\n"
  "material a { ambient 2 1 0 diffuse .4 .5 .6 specular .9 .7 .5 }\n"
  "material b { ambient 0 1 2 diffuse .5 .4 .3 specular .6 .8 .9"
  " shininess 5 }\n"
  "plane far { material a normal .05 0 1 point 0 0 -4 }\n"
  "plane near { material b normal 0 .05 -1 point 0 0 10 }\n"
  "sphere ball { material b center 4 3 -2 radius 1 }\n",
  // Half clear balls in one another, lights near by, every falloff.
  "glass", WINDOW
  "background .3 .3 .3\n"
  "light l { location 2 5 2 emissivity 1 2 1 falloff 0 }\n"
  "light m { location 6 1 1 emissivity 2 1 1 falloff 2 }\n"
  "material g { ambient 1 1 1 diffuse .5 .6 .7 alpha .8 ior 1.5 }\n"
  "material w { diffuse .8 .8 .8 specular .1 .2 .3 alpha .5 ior 1.3 }\n"
  "material f { ambient .5 .5 .5 diffuse .8 .7 .6 }\n"
  "sphere out { material g center 4 3 -2 radius 2 }\n"
  "sphere in { material w center 4 3 -2 radius 1 }\n"
  "sphere off { material w center 6 2 0 radius .7 }\n"
  "plane floor { material f normal 0 1 0 point 0 0 0 }\n",
  // Clear, with highlights: every generation may add one.
  "clear", WINDOW
  "light l { location 4 8 2 emissivity 9 9 9 }\n"
  "material g { specular .3 .3 .3 shininess 9 alpha 1 ior 1.6 }\n"
  "material f { diffuse .8 .7 .6 specular .2 .2 .2 }\n"
  "sphere a { material g center 3 3 -1 radius 1.2 }\n"
  "sphere b { material g center 5.5 3 -1 radius 1.2 }\n"
  "plane floor { material f normal 0 1 0 point 0 0 0 }\n",
};

enum { SCENES = sizeof scenes / sizeof *scenes / 2, DEEP = 14 };

static image_t *
picture(model_t *model, id <engine_t> engine)
{
  return cut_picture(model, engine, support_render_options(), NULL);
}

/** By both engines and instruction sets, which have to agree. */
static image_t *
agreed(model_t *model, const char *what)
{
  image_t *image = picture(model, [[[notes_t alloc] initWithModel: model]
                                    autorelease]);

  for (NSString *isa in [NSArray arrayWithObjects: @"base", @"avx2", nil])
    {
      id <engine_t> fast = support_fast(model, isa);
      image_t *other = fast ? picture(model, fast) : image;
      PASS(cut_apart(image, other) == 0,
           "%s: both engines, the same colours and errors", what);
    }
  return image;
}

/** A model that cuts so; errors count from `generations`. */
static model_t *
cutting(unsigned scene, unsigned max_depth, double min_weight,
        double max_error, unsigned generations)
{
  model_t *model = support_model(scenes[2 * scene + 1]);

  cut_model(model, max_depth, min_weight, max_error, generations);
  return model;
}

static void
bounds_hold(unsigned scene)
{
  const char *name = scenes[2 * scene];
  model_t *deepest = support_model(scenes[2 * scene + 1]);
  double most, before = HUGE_VAL;

  deepest->max_depth = DEEP;
  image_t *deep = picture(deepest, support_fast(deepest, nil));
  for (unsigned depth = 0; depth <= 5; depth++)
    {
      image_t *image = agreed(cutting(scene, depth, -1, -1, CUT_GENERATIONS),
                              name);
      PASS(cut_broken(image, deep, &most) == 0, "%s: bound holds at depth %u",
           name, depth);
      PASS(most > 0 && most <= before, "%s: depth %u may be off by %g, no more"
           " than one less", name, depth, most);
      before = most;
    }
  before = HUGE_VAL;
  for (double weight = 1; weight > 1e-3; weight /= 4)
    {
      image_t *image = agreed(cutting(scene, DEEP, weight, -1,
                                      CUT_GENERATIONS), name);
      PASS(cut_broken(image, deep, &most) == 0, "%s: bound holds at weight %g",
           name, weight);
      PASS(most <= before, "%s: weight %g may be off by %g", name, weight,
           most);
      before = most;
    }
  for (double error = 0.1; error > 1e-7; error /= 10)
    {
      image_t *image = agreed(cutting(scene, DEEP, -1, error, DEEP), name);
      PASS(cut_broken(image, deep, &most) == 0 && most <= error,
           "%s: bound of %g holds, %g is reached", name, error, most);
    }
}

/** Without a cut nothing changes, and nothing may be off. */
static void
nothing_cut(void)
{
  for (unsigned scene = 0; scene < SCENES; scene++)
    {
      model_t *plain = support_model(scenes[2 * scene + 1]);
      plain->max_depth = 6;
      image_t *a = picture(plain, support_fast(plain, nil));
      image_t *b = agreed(cutting(scene, 6, 0, -1, 6), "no cut");
      double most;
      PASS(memcmp(a->pixels, b->pixels, (size_t)[a width] * [a height]
                  * sizeof *a->pixels) == 0, "the same picture");
      PASS(cut_broken(b, a, &most) == 0 && most == 0, "without any error");
    }
}

/** A scene without anything that spawns rays, which the kernel traces in a way
    of its own. */
static void
plain(void)
{
  model_t *model = support_model(WINDOW "background .1 .2 .3\n"
                                 "material m { ambient 1 2 3 }\n"
                                 "sphere s { material m center 4 3 -1"
                                 " radius 2 }\n");
  double most = HUGE_VAL;

  cut_model(model, 5, -1, 0.1, 5);
  image_t *image = agreed(model, "plain");
  cut_broken(image, image, &most);
  PASS(most == 0, "plain: nothing is cut, and the errors are 0, not %g", most);
}

/** A half mirror that sees a background of 1: cut, just that is missing. */
static void
exact(void)
{
  model_t *model = support_model(WINDOW "background 1 1 1\n"
                                 "material m { specular .5 .25 0 }\n"
                                 "plane p { material m normal 0 0 1"
                                 " point 0 0 -1 }\n");
  brightest_t *brightest = [[[brightest_t alloc] initWithModel: model
                                                   generations: 1000]
                             autorelease];
  struct cut_rule rule = { 1, -1, -1, 1000, brightest->most,
                           brightest->count };

  model->cut = rule;
  model->max_depth = 0;
  image_t *image = agreed(model, "half mirror");
  PASS_NEAR(image->planes[PLANE_TRUNCATION][0], 0.5, 1e-8,
            "all that is missing is told, and no more");
  struct render_options options = support_render_options();
  options.noise = 0.1;
  options.max_samples = 64;
  image = cut_picture(model, support_fast(model, nil), options, NULL);
  PASS_NEAR(image->planes[PLANE_TRUNCATION][0], 0.5, 1e-8,
            "with --noise it is the mean of the rays' too");
  model->cut.min_weight = 0.5;
  model->max_depth = 1;
  PASS(agreed(model, "weight")->planes[PLANE_TRUNCATION][0] == 0,
       "a branch of just that weight is traced");
  model->cut.min_weight = nextafter(0.5, 1);
  PASS(agreed(model, "weight")->planes[PLANE_TRUNCATION][0] > 0,
       "one that is lighter is not");
}

/** Between two mirrors, straight to and fro, with a light on the way: each
    generation adds all that it can, so a bound that is any smaller is broken. */
static void
tight(void)
{
  model_t *model = support_model
    ("camera c { pixeldim 1 1 worlddim 2 2 viewpoint 1 1 3 }\n"
     "light l { location 1 1 2 emissivity 2 2 2 falloff 0 }\n"
     "material m { diffuse .5 .5 .5 specular .75 .75 .75 }\n"
     "plane far { material m normal 0 0 1 point 0 0 -4 }\n"
     "plane near { material m normal 0 0 -1 point 0 0 10 }\n");

  model->max_depth = DEEP;
  image_t *deep = picture(model, support_fast(model, nil));
  for (unsigned depth = 0; depth < DEEP; depth++)
    {
      cut_model(model, depth, -1, -1, DEEP);
      image_t *image = agreed(model, "tight");
      double off = deep->pixels->color.x - image->pixels->color.x;
      PASS_NEAR(image->planes[PLANE_TRUNCATION][0], off, 1e-8 * off,
                "tight: depth %u, what is told is what is missing", depth);
    }
}

/** Weights that are infinite, of a colour that nothing in the scene has: their
    part of the error is none, and not no number. */
static void
infinite(void)
{
  static const char *const speculars[] = {
    "1e120 0 0", "0 1e120 0", "0 0 1e120"
  };

  for (unsigned channel = 0; channel < 3; channel++)
    {
      model_t *model = support_model
        (WINDOW "material m { specular %s }\n"
         "plane far { material m normal 0 0 1 point 0 0 -4 }\n"
         "plane near { material m normal 0 0 -1 point 0 0 10 }\n",
         speculars[channel]);
      double most;
      cut_model(model, 5, -1, -1, 9);
      image_t *image = agreed(model, "infinite");
      unsigned broken = cut_broken(image, image, &most);
      PASS(broken == 0 && most == 0, "channel %u: infinite weight of nothing"
           " is %g, not in %u pixels", channel, most, broken);
    }
}

/** The table against its closed form: a mirror of 3/4 that gives 2 of its own:
    2 (1 - k^(g+1)) / (1 - k). */
static void
table(void)
{
  model_t *model = support_model(WINDOW
    "light l { location 4 3 5 emissivity 2 2 2 falloff 0 }\n"
    "material m { diffuse 1 0 0 specular .75 0 0 }\n"
    "sphere s { material m center 4 3 -1 radius 1 }\n");
  brightest_t *b = [[[brightest_t alloc] initWithModel: model
                                           generations: 1000] autorelease];
  double own = 2 + .75 * 2;

  for (unsigned g = 0; g < 50; g++)
    {
      PASS_NEAR(b->most[g].rest.x, own * (1 - pow(.75, g + 1)) / .25, 1e-12,
                "%u generations", g);
    }
  PASS(b->count < 200, "it ends where it does not grow any more");
  PASS(b->most[9].rest.y == 0, "nothing of what is not lit");
}

/** A light half a unit from a surface, of every falloff. */
static void
falloffs(void)
{
  for (int falloff = 0; falloff <= 2; falloff++)
    {
      model_t *model = support_model
        (WINDOW "light l { location 4 3 .5 emissivity 3 3 3 falloff %d }\n"
         "material m { diffuse 1 1 1 }\n"
         "sphere s { material m center 4 3 -1 radius 1 }\n", falloff);
      brightest_t *b = [[[brightest_t alloc] initWithModel: model
                                               generations: 0] autorelease];
      PASS_NEAR(b->most[0].rest.x, 3 * (1 << falloff), 1e-6,
                "a light that is near, falloff %d", falloff);
    }
}

/** What three lights leave in shadow. */
static void
shadows(void)
{
  model_t *model = support_model
    (WINDOW "light k { location 1 1 5 emissivity 0 0 0 }\n"
     "light l { location 4 1 5 emissivity 0 0 0 }\n"
     "light m { location 7 1 5 emissivity 0 0 0 }\n"
     "material m { ambient 2 0 0 }\n"
     "sphere s { material m center 4 3 -1 radius 1 }\n");
  brightest_t *b = [[[brightest_t alloc] initWithModel: model
                                           generations: 0] autorelease];

  PASS_NEAR(b->most[0].ambient.x, 2 * (1 + 3 * 0.1), 1e-15,
            "ambient, and a tenth of it for each light");
}

/** How near a light is to each shape. */
static void
distances(void)
{
  model_t *model = support_model(WINDOW
    "material m { }\n"
    "sphere s { material m center 0 0 0 radius 2 }\n"
    "plane p { material m normal 0 2 0 point 7 -3 9 }\n"
    "polygon q { material m vertex 0 0 0 vertex 4 0 0 vertex 4 4 0"
    " vertex 0 4 0 }\n");
  object_t *s = [model->objects objectAtIndex: 0];
  object_t *p = [model->objects objectAtIndex: 1];
  object_t *q = [model->objects objectAtIndex: 2];

  PASS_NEAR([s distanceFrom: k_vec(0, 0, 5)], 3, 1e-15, "outside a sphere");
  PASS_NEAR([s distanceFrom: k_vec(0, .5, 0)], 1.5, 1e-15, "inside it");
  PASS_NEAR([p distanceFrom: k_vec(100, 2, -50)], 5, 1e-15, "from a plane");
  PASS_NEAR([q distanceFrom: k_vec(1, 1, 6)], 6, 1e-9, "above a polygon");
  PASS_NEAR([q distanceFrom: k_vec(7, 8, 0)], 5, 1e-9, "beside it");
}

int
main(void)
{
  NSAutoreleasePool *pool = [[NSAutoreleasePool alloc] init];

  for (unsigned scene = 0; scene < SCENES; scene++)
    {
      bounds_hold(scene);
    }
  nothing_cut();
  plain();
  exact();
  tight();
  infinite();
  table();
  falloffs();
  shadows();
  distances();
  [pool release];
  return test_done();
}
