// explain.m - --explain tells of the pixel that is rendered: its last line is
// that colour to the last bit, its terms add up to it, and it has a ray for
// each that is traced.

#import "brightest_t.h"
#import "explain_t.h"
#import "scene.h"
#include "test.h"

/** What is in a text: sums of value times weight over the terms. */
struct sums
{
  unsigned rays, wrong;         // wrong: rays whose terms are not their colour
  struct k_vec leaves;          // of what spawns nothing
  struct k_vec pixel;
  double off;                   // for all rays that are not traced
  double told;                  // what the last line says of that
};

/** Numbers behind a word. */
static BOOL
read_vec(const char *line, const char *word, struct k_vec *v)
{
  const char *at = strstr(line, word);

  return at && sscanf(at + strlen(word), "%lf %lf %lf", &v->x, &v->y, &v->z)
    == 3;
}

static BOOL
is_near(struct k_vec a, struct k_vec b)
{
  return k_norm1(k_sub(a, b)) <= 1e-13 * (k_norm1(a) + k_norm1(b));
}

static struct sums
read_text(NSString *text)
{
  struct sums sums = { 0 };
  struct k_vec own = k_vec(0, 0, 0), W = own, value, weight;

  for (NSString *string in [text componentsSeparatedByString: @"\n"])
    {
      const char *line = [string UTF8String], *off;
      line += strspn(line, " ");
      if (strncmp(line, "ray ", 4) == 0)
        {
          sums.rays++;
          own = k_vec(0, 0, 0);
        }
      else if (strncmp(line, "weight ", 7) == 0)
        {
          read_vec(line, "weight", &W);
        }
      else if (read_vec(line, "value", &value)
               && read_vec(line, "weight", &weight))
        {
          struct k_vec part = k_mul(value, weight);
          own = k_add(own, part);
          if (strncmp(line, "refl", 4) != 0 && strncmp(line, "refr", 4) != 0)
            {
              sums.leaves = k_add(sums.leaves, part);
            }
        }
      else if (strncmp(line, "color ", 6) == 0
               && read_vec(line, "color", &value))
        {
          sums.wrong += !is_near(own, k_mul(value, W));
        }
      else if (strncmp(line, "pixel   ", 8) == 0)
        {
          read_vec(line, "pixel", &sums.pixel);
        }
      else if (strncmp(line, "off at most ", 12) == 0)
        {
          sums.told = atof(line + 12);
        }
      if ((off = strstr(line, "pixel off by at most ")))
        {
          sums.off += atof(off + 21);
        }
    }
  return sums;
}

/** The picture of one pixel, by an engine. */
static image_t *
render(model_t *model, id <engine_t> engine, struct render_options options,
       unsigned x, unsigned y, struct counters *counters)
{
  struct window window = { x, y, x + 1, y + 1 };
  image_t *image = [[[image_t alloc] init: model->camera->columns
                                         : model->camera->rows
                                   window: window surfaces: NO
                                    error: NULL] autorelease];

  if (model->cut.is_on)
    {
      [image addPlane: PLANE_TRUNCATION error: NULL];
    }
  render_t *render = [[render_t alloc] init: engine camera: model->camera
                                       into: image options: options];
  [render run];
  *counters = render->counters;
  [render release];
  return image;
}

static NSString *
explain(model_t *model, struct render_options options, unsigned x, unsigned y,
        struct counters *counters)
{
  explain_t *engine = [[[explain_t alloc] initWithModel: model] autorelease];

  return [engine textOf: render(model, engine, options, x, y, counters)];
}

static void
pixels(model_t *model, struct render_options options, const char *what)
{
  id <engine_t> engines[] = {
    [[[notes_t alloc] initWithModel: model] autorelease],
    support_fast(model, @"base")
  };
  unsigned wrong = 0, rays = 0, terms = 0, lost = 0, other = 0, edges = 0;

  for (unsigned i = 0; i < 60; i++)
    {
      NSAutoreleasePool *pool = [[NSAutoreleasePool alloc] init];
      unsigned x = 7 * i % model->camera->columns;
      unsigned y = 5 * i % model->camera->rows;
      struct counters mine, its;
      NSString *text = explain(model, options, x, y, &mine);
      struct sums sums = read_text(text);
      for (int k = 0; k < 2; k++)
        {
          image_t *image = render(model, engines[k], options, x, y, &its);
          wrong += !support_same(sums.pixel, image->pixels->color);
          edges += !counters_same_edges(&mine, &its);
        }
      rays += sums.rays != its.eye + its.reflection + its.refraction;
      terms += sums.wrong + !is_near(sums.leaves, sums.pixel);
      lost += !(fabs(sums.off - sums.told) <= 1e-12 * sums.told);
      other += ![text isEqual: explain(model, options, x, y, &its)];
      [pool release];
    }
  PASS(wrong == 0, "%s: the pixel of both engines: %u are not", what, wrong);
  PASS(edges == 0, "%s: the same happens near the edge: %u", what, edges);
  PASS(rays == 0, "%s: every ray that is traced: %u", what, rays);
  PASS(terms == 0, "%s: the terms add up: %u do not", what, terms);
  PASS(lost == 0, "%s: so does what is cut: %u", what, lost);
  PASS(other == 0, "%s: the same text again: %u", what, other);
}

static void
cut(model_t *model, double min_weight, double max_error)
{
  brightest_t *brightest = [[[brightest_t alloc]
                              initWithModel: model generations: 1000]
                             autorelease];

  model->cut.is_on = 1;
  model->cut.min_weight = min_weight;
  model->cut.max_error = max_error;
  model->cut.generations = 1000;
  model->cut.most = brightest->most;
  model->cut.most_count = brightest->count;
}

/** What stands in the text for a floor in the shadow of a ball, and for a
    mirror over it, computed by hand. */
static void
words(void)
{
  model_t *model = support_model("background 4 5 6\n"
    "camera c { pixeldim 1 1 worlddim 2 2 viewpoint 1 1 2 }\n"
    "material m { ambient 8 8 8 diffuse .5 .5 .5 specular .25 .25 .25 }\n"
    "material o { }\n"
    "plane wall { material m normal 0 0 1 point 0 0 -2 }\n"
    "sphere ball { material o center 1 1 4 radius .5 }\n"
    "light lamp { location 1 1 6 emissivity 1 1 1 }\n"
    "light back { location 1 1 -3 emissivity 1 1 1 }\n"
    "light near { location 1 1 0 emissivity 8 8 8 }\n");
  struct counters counters;
  NSString *text = explain(model, support_render_options(), 0, 0, &counters);

  PASS([text isEqual:
    @"pixel 0,0 of 1 x 1: 1 ray\n\n"
    @"ray 1         eye, generation 0\n"
    @"weight        1 1 1\n"
    @"starts at     1 1 2\n"
    @"dir           0 0 -1\n"
    @"in            air\n"
    @"hits          plane 'wall' (object 1) from outside\n"
    @"t             4\n"
    @"dis           4\n"
    @"P             1 1 -2\n"
    @"N             0 0 1\n"
    @"ambient       value 2 2 2 weight 0.5 0.5 0.5\n"
    @"light 1       in shadow of sphere 'ball' (object 2)\n"
    @"  shadow      value 0.2 0.2 0.2 weight 0.5 0.5 0.5\n"
    @"light 2       in shadow of the surface itself\n"
    @"  shadow      value 0.2 0.2 0.2 weight 0.5 0.5 0.5\n"
    @"light 3       lit, r 2, Ns.L 1\n"
    @"  diffuse     value 2 2 2 weight 0.5 0.5 0.5\n"
    @"  highlight   value 1 1 1 weight 1 1 1\n"
    @"reflection    value 0 0 0 weight 0.25 0.25 0.25\n"
    @"color         3.2 3.2 3.2\n\n"
    @"  ray 1r        reflection, generation 1\n"
    @"  weight        0.25 0.25 0.25\n"
    @"  starts at     1 1 -2\n"
    @"  dir           0 0 1\n"
    @"  in            air\n"
    @"  hits          sphere 'ball' (object 2) from outside\n"
    @"  t             5.5\n"
    @"  dis           9.5\n"
    @"  P             1 1 3.5\n"
    @"  N             0 0 -1\n"
    @"  ambient       value 0 0 0 weight 0.25 0.25 0.25\n"
    @"  light 1       in shadow of the surface itself\n"
    @"    shadow      value 0 0 0 weight 0.25 0.25 0.25\n"
    @"  light 2       in shadow of plane 'wall' (object 1)\n"
    @"    shadow      value 0 0 0 weight 0.25 0.25 0.25\n"
    @"  light 3       lit, r 3.5, Ns.L 1\n"
    @"    diffuse     value 0 0 0 weight 0.25 0.25 0.25\n"
    @"  color         0 0 0\n\n"
    @"pixel         3.2 3.2 3.2\n"], "the words:\n%s", [text UTF8String]);
}

/** Media, R and the deepest generation. */
static void
glass(void)
{
  model_t *model = support_model("background 4 4 4\n"
    "camera c { pixeldim 1 1 worlddim 2 2 viewpoint 1 1 4 }\n"
    "material g { alpha 1 ior 3 }\nmaterial w { alpha .5 ior 1 }\n"
    "sphere outer { material g center 1 1 0 radius 2 }\n"
    "sphere inner { material w center 1 1 0 radius 1 }\n");
  struct counters counters;

  model->max_depth = 2;
  NSString *text = explain(model, support_render_options(), 0, 0, &counters);
  const char *lines[] = {
    "\nR             0.25\n",
    "\nreflection    value 4 4 4 weight 0.25 0.25 0.25\n",
    "\n  in            sphere 'outer' (object 1) ior 3\n",
    "\n    in            sphere 'inner' (object 2) ior 1, in sphere 'outer'"
      " (object 1) ior 3\n",
    "\n    hits          sphere 'inner' (object 2) from inside\n",
    "\n    refraction    black, too deep, weight 0.10546875 0.10546875"
      " 0.10546875\n"
  };
  for (unsigned i = 0; i < sizeof lines / sizeof *lines; i++)
    {
      PASS(strstr([text UTF8String], lines[i]) != NULL, "'%s' in\n%s",
           lines[i], [text UTF8String]);
    }
}

int
main(void)
{
  NSAutoreleasePool *pool = [[NSAutoreleasePool alloc] init];
  struct render_options options = support_render_options();
  struct scene pinhole = { .columns = 31, .rows = 23 };
  struct scene lens = { .has_lens = 1, .columns = 31, .rows = 23 };

  words();
  glass();
  pixels(scene_model(pinhole), options, "pinhole");
  model_t *model = scene_model(pinhole);
  cut(model, .1, -1);
  pixels(model, options, "cut");
  model = scene_model(pinhole);
  cut(model, -1, .3);
  pixels(model, options, "of a small error");
  model = scene_model(pinhole);
  cut(model, .1, -1);
  model->choice.no_reflection = model->choice.no_refraction = 1;
  pixels(model, options, "left out");
  model = scene_model(pinhole);
  model->max_depth = 1;
  cut(model, 0, -1);
  pixels(model, options, "not deep");
  model = scene_model(pinhole);
  model->choice.no_shadows = 1;
  pixels(model, options, "no shadows");
  options.samples = 3;
  pixels(scene_model(lens), options, "lens, 3 samples");
  [pool release];
  return test_done();
}
