// numbers.m - stability: whole pictures at other sizes, mirrored, in another
// order; recursion in closed form. N01 to N03, N06, N08, N13, N15.

#include "battery.h"

// N01 and N02: inside a mirror. The eye stands in the center, so that every
// ray comes back along itself. The light stands .75 beside it: 1.25 from both
// places that are hit, under a cosine of .8, so that every generation has a
// colour of its own of 1.25 * .8 = 1; shininess 1e9 leaves no highlight.

static double
mirror_color(double k, unsigned max_depth)
{
  NSAutoreleasePool *pool = [[NSAutoreleasePool alloc] init];
  model_t *model
    = support_model(SUPPORT_CAMERA "material m { diffuse 1 1 1 specular"
                    " %a %a %a shininess 1e9 } light l { location .75 0 0"
                    " emissivity 1.25 1.25 1.25 falloff 0 } sphere s {"
                    " material m center 0 0 0 radius 1 }", k, k, k);

  model->max_depth = max_depth;
  double color = support_trace(model, k_vec(0, 0, 0), k_vec(0, 0, -1)).x;
  [pool release];
  return color;
}

static void
test_N02(void)
{
  static const double ks[] = { .5, .9, .99, 1 };
  static const unsigned depths[] = { 0, 1, 2, 50, 1000 };

  for (unsigned i = 0; i < 4; i++)
    {
      for (unsigned j = 0; j < 5; j++)
        {
          unsigned d = depths[j];
          quad k = ks[i], power = 1;
          for (unsigned n = 0; n <= d; n++)
            {
              power *= k;
            }
          quad expected = k == 1 ? d + 1 : (1 - power) / (1 - k);
          double tolerance = k == 1 && d == 1000 ? 2e-14 : 4e-15;
          PASS_NEAR(mirror_color(ks[i], d), (double)expected,
                    tolerance * (double)expected,
                    "%s reflecting %g, depth %u", d < 3 && i == 0 ? "N01"
                    : "N02", ks[i], d);
        }
    }
}

/** The same with ambient, which depends on the length of the path: .5, 1.5,
    2.5 … from the center of a sphere of radius .5. */
static void
test_N01(void)
{
  for (unsigned d = 0; d <= 2; d++)
    {
      model_t *model
        = support_model(SUPPORT_CAMERA "material m { ambient 3 3 3 diffuse"
                        " .5 .5 .5 specular .25 .25 .25 } sphere s {"
                        " material m center 0 0 0 radius .5 }");
      model->max_depth = d;
      quad expected = 0;
      for (int n = d; n >= 0; n--)
        {
          expected = (quad).5 * 3 / (n + (quad).5) + (quad).25 * expected;
        }
      PASS_NEAR(support_trace(model, k_vec(0, 0, 0), k_vec(0, 1, 0)).x,
                (double)expected, 4 * U * (double)expected,
                "N01 ambient over distance, depth %u", d);
    }
}

// A scene with everything in it

struct view
{
  double scale;
  int is_mirrored;
  int has_lens;
  int is_window;                // worlddim, not lookat
  int square_falloff;           // the falloff of the second light
  unsigned order;               // of the objects
};

/** Numbers of a point, of a direction. */
#define PUT(view, x, y, z) AT(view, x, y, z)

static NSString *
view_polygon(const struct view *view, const char *name, const char *material,
             const char *more, unsigned n, const double (*v)[3])
{
  struct run run = { .scale = view->scale, .is_mirrored = view->is_mirrored };
  struct k_vec vertex[16];

  for (unsigned i = 0; i < n; i++)
    {
      vertex[i] = k_vec(v[i][0], v[i][1], v[i][2]);
    }
  return battery_polygon(&run, name, material, more, n, vertex);
}

/** A clear cube, turned out of the axes. */
static NSString *
view_cube(const struct view *view)
{
  NSMutableString *text = [NSMutableString string];
  static const double a[3] = { .31, .12, -.17 };
  static const double b[3] = { -.15, .33, .07 };
  static const double c[3] = { .19, .02, .36 };
  double corner[8][3];
  static const unsigned faces[6][4] = { { 0, 2, 3, 1 }, { 4, 5, 7, 6 },
                                        { 0, 1, 5, 4 }, { 2, 6, 7, 3 },
                                        { 0, 4, 6, 2 }, { 1, 3, 7, 5 } };

  for (unsigned i = 0; i < 8; i++)
    {
      const double at[3] = { .8, -.4, .5 };
      for (unsigned j = 0; j < 3; j++)
        {
          corner[i][j] = at[j] + (i & 1 ? a[j] : -a[j])
            + (i & 2 ? b[j] : -b[j]) + (i & 4 ? c[j] : -c[j]);
        }
    }
  for (unsigned f = 0; f < 6; f++)
    {
      double v[4][3];
      char name[10];
      for (unsigned i = 0; i < 4; i++)
        {
          memcpy(v[i], corner[faces[f][i]], sizeof v[i]);
        }
      snprintf(name, sizeof name, "cube%u", f);
      [text appendString: view_polygon(view, name, "glass", "solid cube", 4,
                                       (const double (*)[3])v)];
    }
  return text;
}

static NSString *
format(const char *text, ...) __attribute__((format(printf, 1, 2)));

static NSString *
format(const char *text, ...)
{
  char line[1000];
  va_list arguments;

  va_start(arguments, text);
  vsnprintf(line, sizeof line, text, arguments);
  va_end(arguments);
  return [NSString stringWithUTF8String: line];
}

/** The objects, shuffled by `order`. */
static NSString *
view_objects(const struct view *view)
{
  double L[6][3] = { { -1.9, -.83 }, { -.6, -.87 }, { -.7, -.17 },
                     { -1.2, -.15 }, { -1.3, .55 }, { -2, .57 } };
  NSMutableArray *objects = [NSMutableArray array];
  struct support_random random = support_seed(view->order);

  for (unsigned i = 0; i < 6; i++)
    {
      L[i][2] = -1.3 - .12 * L[i][0] + .07 * L[i][1];
    }
  [objects addObject: format("sphere glass { material glass center" N3
                             "radius %a }", PUT(view, -.55, -.4, .9),
                             IN(view, .45))];
  [objects addObject: format("sphere bubble { material air center" N3
                             "radius %a }", PUT(view, -.5, -.35, .95),
                             IN(view, .25))];
  [objects addObject: format("sphere mirror { material mirror center" N3
                             "radius %a }", PUT(view, .4, .35, -1.4),
                             IN(view, .8))];
  [objects addObject: format("sphere ball { material red center" N3
                             "radius %a }", PUT(view, 1.45, -.7, -.45),
                             IN(view, .27))];
  [objects addObject: format("plane floor { material gray normal" N3
                             "point" N3 "}", ALONG(view, .01, 1, .02),
                             PUT(view, .1, -1.03, .2))];
  [objects addObject: view_polygon(view, "L", "red", "", 6,
                                  (const double (*)[3])L)];
  [objects addObject: view_cube(view)];
  for (NSUInteger i = [objects count] - 1; view->order && i > 0; i--)
    {
      [objects exchangeObjectAtIndex: i
                   withObjectAtIndex: support_unit(&random) * (i + 1)];
    }
  return [objects componentsJoinedByString: @"\n"];
}

static model_t *
view_model(const struct view *view)
{
  double s = view->scale;
  char camera[500], lens[200] = "";

  if (view->has_lens)
    {
      snprintf(lens, sizeof lens, "focus %a fstop %a exposure 3",
               IN(view, 4.3), 8.5 / s);
    }
  if (view->is_window)
    {
      snprintf(camera, sizeof camera, "worlddim %a %a viewpoint" N3,
               IN(view, 2.9), IN(view, 2.2), IN(view, .3), IN(view, .9),
               IN(view, 4.1));
    }
  else
    {
      snprintf(camera, sizeof camera, "lookat" N3 "up" N3 "angle 37"
               " viewpoint" N3, PUT(view, .05, -.3, .1),
               ALONG(view, .1, 1, .03), PUT(view, .7, .8, 4.6));
    }
  return support_model(
    "camera cam { pixeldim 64 48 %s %s }\n"
    "material glass { ambient %a %a 0 alpha .9 ior 1.5 }\n"
    "material air { alpha 1 }\n"
    "material mirror { diffuse .2 .2 .2 specular .7 .8 .9 shininess 20 }\n"
    "material red { ambient %a 0 0 diffuse .8 .3 .2 }\n"
    "material gray { ambient %a %a %a diffuse .6 .6 .6 specular .2 .2 .2"
    " shininess 7.5 }\nbackground .1 .2 .4\n"
    "light one { location" N3 "emissivity %a %a %a falloff 1 }\n"
    "light two { location" N3 "emissivity %a %a %a falloff %d }\n%s",
    camera, lens, .3 * s, .4 * s, 1.5 * s, 2 * s, s, 1.25 * s,
    PUT(view, 2.1, 3.3, 3.9), 2 * s, 1.9 * s, 1.5 * s,
    PUT(view, -2.7, 2.2, 1.3),
    view->square_falloff ? s * s : 1.0, view->square_falloff ? s * s : 1.0,
    view->square_falloff ? s * s : 1.0, view->square_falloff ? 2 : 0,
    [view_objects(view) UTF8String]);
}

static image_t *
view_picture(struct view view, unsigned threads)
{
  struct render_options options = support_render_options();

  options.threads = threads;
  return support_picture(view_model(&view), options);
}

/** How many colours of two pictures differ in any bit; mirrored: left and
    right exchanged. */
static unsigned
color_differences(image_t *a, image_t *b, int is_mirrored)
{
  unsigned differences = 0, width = [a width];

  for (unsigned y = 0; y < [a height]; y++)
    {
      for (unsigned x = 0; x < width; x++)
        {
          unsigned other = is_mirrored ? width - 1 - x : x;
          struct k_vec p = [a pixelAt: x : y]->color;
          struct k_vec q = [b pixelAt: other : y]->color;
          differences += !support_same(p, q);
        }
    }
  return differences;
}

// N03: the same picture at every size

static void
test_N03(void)
{
  for (unsigned i = 0; i < 8; i++)
    {
      NSAutoreleasePool *pool = [[NSAutoreleasePool alloc] init];
      struct view view = { .scale = 1, .has_lens = i & 1,
                           .is_window = i / 2 & 1,
                           .square_falloff = i / 4 };
      image_t *one = view_picture(view, 1);
      // Emissivities go with the square of the size under falloff 2 and have
      // to stay in the range of a file; the other lengths go on to 2^394.
      static const int exponents[] = { -394, -350, -300, -250, -200, -150,
                                       -100, -50, -1, 1, 50, 100, 150, 200,
                                       250, 300, 350, 394 };
      for (unsigned j = 0; j < sizeof exponents / sizeof *exponents; j++)
        {
          int k = exponents[j];
          if (view.square_falloff && abs(k) > 200)
            {
              continue;
            }
          view.scale = ldexp(1, k);
          image_t *other = view_picture(view, 1);
          PASS(color_differences(one, other, 0) == 0,
               "N03 2^%d,%s%s falloffs 1 and %d: %u pixels of 3072 differ", k,
               view.has_lens ? " lens," : "",
               view.is_window ? " window," : "",
               view.square_falloff ? 2 : 0, color_differences(one, other, 0));
        }
      [pool release];
    }
}

// N06: mirrored in x; the window camera has its window right of the origin
// and cannot be mirrored, the samples of a lens are not mirrored either

static void
test_N06(void)
{
  for (int k = -100; k <= 100; k += 100)
    {
      struct view view = { .scale = ldexp(1, k), .square_falloff = 1 };
      image_t *one = view_picture(view, 1);
      view.is_mirrored = 1;
      image_t *other = view_picture(view, 1);
      PASS(color_differences(one, other, 1) == 0,
           "N06 mirrored in x, at 2^%d: %u pixels of 3072 differ", k,
           color_differences(one, other, 1));
    }
}

// N08: the order of the objects

static void
test_N08(void)
{
  struct view view = { .scale = 1, .has_lens = 1 };
  image_t *one = view_picture(view, 1);

  for (view.order = 1; view.order <= 10; view.order++)
    {
      NSAutoreleasePool *pool = [[NSAutoreleasePool alloc] init];
      image_t *other = view_picture(view, 1);
      PASS(color_differences(one, other, 0) == 0,
           "N08 objects in order %u: %u pixels of 3072 differ", view.order,
           color_differences(one, other, 0));
      [pool release];
    }
}

// N13: nothing to see

static void
test_N13(void)
{
  static const char *const scenes[][2] = {
    { "no object and no light", "" },
    { "no object", "light l { location 1 2 3 emissivity 4 5 6 }" },
    { "a ball behind the eye", "material m { ambient 1 1 1 }"
      " sphere s { material m center 0 0 50 radius 1 }" }
  };

  for (unsigned i = 0; i < 3; i++)
    {
      model_t *model = support_model(SUPPORT_CAMERA "background .25 .5 7\n%s",
                                     scenes[i][1]);
      image_t *image = support_picture(model, support_render_options());
      unsigned wrong = 0;
      for (unsigned p = 0; p < 81; p++)
        {
          wrong += !support_same(image->pixels[p].color, k_vec(.25, .5, 7));
        }
      PASS(wrong == 0, "N13 %s: %u of 81 pixels are not the background",
           scenes[i][0], wrong);
    }
  model_t *model = support_model(SUPPORT_CAMERA "material m { ambient 2 0 0"
                                 " diffuse 1 1 1 } plane p { material m"
                                 " normal 0 0 1 point 0 0 -3 }");
  struct k_vec color = support_trace(model, k_vec(1, 1, 5), k_vec(0, 0, -1));
  PASS(support_same(color, k_vec(.25, 0, 0)),
       "N13 no light: ambient over distance, exactly");
}

// N15: threads, and parts of the picture

static void
test_N15(void)
{
  static const unsigned threads[] = { 2, 7, 64 };
  static const struct window windows[] = {
    { 0, 0, 1, 1 }, { 13, 7, 29, 40 }, { 63, 47, 64, 48 }, { 0, 20, 64, 21 },
    { 31, 0, 32, 48 }
  };
  struct view view = { .scale = 1, .has_lens = 1, .square_falloff = 1 };
  image_t *one = view_picture(view, 1);

  for (unsigned i = 0; i < 3; i++)
    {
      image_t *other = view_picture(view, threads[i]);
      PASS(support_differences(one, other) == 0, "N15 %u threads: the same"
           " picture", threads[i]);
    }
  // The tile is a constant of render_t; a window moves and cuts the tiles.
  for (unsigned i = 0; i < sizeof windows / sizeof *windows; i++)
    {
      struct window w = windows[i];
      image_t *part = support_window(view_model(&view),
                                     support_render_options(), w);
      unsigned wrong = 0;
      for (unsigned y = w.y0; y < w.y1; y++)
        {
          for (unsigned x = w.x0; x < w.x1; x++)
            {
              wrong += !support_same([part pixelAt: x : y]->color,
                                     [one pixelAt: x : y]->color);
            }
        }
      PASS(wrong == 0, "N15 the window (%u %u) to (%u %u): %u pixels differ",
           w.x0, w.y0, w.x1, w.y1, wrong);
    }
}

int
main(void)
{
  NSAutoreleasePool *pool = [[NSAutoreleasePool alloc] init];

  test_N01();
  test_N02();
  test_N03();
  test_N06();
  test_N08();
  test_N13();
  test_N15();
  [pool release];
  return test_done();
}
