// lighting.m - the colour of one hit point: ambient over distance, diffuse
// light, the mirror and the highlight, formula by formula with round numbers.
// The floor is the plane z = 0; rays come down on it from above.

#import "support.h"
#include "test.h"

#define FLOOR "plane floor { material m normal 0 0 1 point 0 0 0 }\n"
#define MATTE \
  "material m { ambient 3 2 1 diffuse .5 .25 1 }\n" FLOOR SUPPORT_CAMERA

/** The colour from (0 0 2) straight down: dis is 2. */
static struct k_vec
down(model_t *model)
{
  return support_trace(model, k_vec(0, 0, 2), k_vec(0, 0, -1));
}

static void
is_near(struct k_vec got, double x, double y, double z, const char *what)
{
  PASS_ULPS(got.x, x, 4, "%s (red)", what);
  PASS_ULPS(got.y, y, 4, "%s (green)", what);
  PASS_ULPS(got.z, z, 4, "%s (blue)", what);
}

static void
ambient(void)
{
  model_t *model = support_model(MATTE);

  PASS(support_same(down(model), k_vec(1.5, 1, 0.5)),
       "without lights it is ambient over the distance");
  PASS(support_same(support_trace(model, k_vec(0, 0, 0.5), k_vec(0, 0, -1)),
                    k_vec(6, 4, 2)), "nearer is brighter, without a limit");
  PASS(support_same(support_trace(model, k_vec(0, 0, 4), k_vec(3, 0, -4)),
                    k_vec(0.6, 0.4, 0.2)), "the distance is along the ray");
  PASS(support_same(support_trace(model, k_vec(0, 0, -2), k_vec(0, 0, 1)),
                    k_vec(1.5, 1, 0.5)), "from below it looks the same");
  ray_t *ray = support_ray(model, k_vec(0, 0, 2), k_vec(0, 0, -1));
  [ray trace: model];
  PASS(ray->dis == 2 && ray->depth == 0, "dis is the distance afterwards");
  PASS(ray->hit.object->number == 1 && ray->hit.t == 2
       && support_same(ray->hit.P, k_vec(0, 0, 0))
       && support_same(ray->hit.N, k_vec(0, 0, 1)), "and hit says where");
  PASS(support_same(support_trace(model, k_vec(0, 0, 2), k_vec(0, 0, 1)),
                    k_vec(0, 0, 0)), "nothing hit: black");
  model = support_model("background .25 .5 2\n" MATTE);
  PASS(support_same(support_trace(model, k_vec(0, 0, 2), k_vec(0, 0, 1)),
                    k_vec(0.25, 0.5, 2)), "or the background, not clamped");
}

/** A light at (3 0 4): r = 5, L = (.6 0 .8), N.L = .8. */
static void
diffuse(void)
{
  const double divided[3] = { 1, 5, 25 };

  for (int falloff = 0; falloff <= 2; falloff++)
    {
      double k = 0.8 / divided[falloff];
      struct k_vec c = down(support_model
        (MATTE "light l { location 3 0 4 emissivity 10 20 40 falloff %d }",
         falloff));
      is_near(c, 1.5 + 5 * k, 1 + 5 * k, 0.5 + 40 * k,
              falloff == 0 ? "diffuse with falloff 0"
              : falloff == 1 ? "diffuse with falloff 1"
              : "diffuse with falloff 2");
    }
  struct k_vec one = down(support_model
    (MATTE "light l { location 3 0 4 emissivity 10 20 40 falloff 1 }"));
  PASS(support_same(one, down(support_model
    (MATTE "light l { location 3 0 4 emissivity 10 20 40 }"))),
       "falloff is 1 unless said otherwise");
  is_near(down(support_model
    (MATTE "light a { location 3 0 4 emissivity 10 20 40 }\n"
     "light b { location 0 0 8 emissivity 16 16 16 falloff 0 }")),
          1.5 + 0.8 + 8, 1 + 0.8 + 4, 0.5 + 6.4 + 16, "two lights add up");
}

/** Light that does not arrive: 0.1 A instead. */
static void
no_light(void)
{
  const double x = 1.5 + 0.15, y = 1 + 0.1, z = 0.5 + 0.05;
  model_t *under;

  is_near(down(support_model
    (MATTE "light l { location 0 0 -1 emissivity 9 9 9 }")),
          x, y, z, "a light behind the surface");
  is_near(down(support_model
    (MATTE "light l { location 5 0 0 emissivity 9 9 9 }")),
          x, y, z, "a light in the surface");
  is_near(down(support_model
    (MATTE "light l { location 0 0 0 emissivity 9 9 9 }")),
          x, y, z, "a light at the very point");
  is_near(down(support_model
    (MATTE "light l { location 0 0 0 emissivity 9 9 9 falloff 2 }")),
          x, y, z, "the same with falloff 2");
  is_near(down(support_model
    (MATTE "light l { location 3 0 4 emissivity 9 9 9 }\n"
     "sphere s { material m center 1.5 0 2 radius .25 }")),
          x, y, z, "a light behind an opaque sphere");
  is_near(down(support_model
    (MATTE "light l { location 3 0 4 emissivity 9 9 9 }\n"
     "light k { location 0 0 -4 emissivity 9 9 9 }\n"
     "sphere s { material m center 1.5 0 2 radius .25 }")),
          1.5 + 0.3, 1 + 0.2, 0.5 + 0.1, "two lights that do not arrive");
  under = support_model
    (MATTE "light l { location 3 0 -4 emissivity 10 20 40 falloff 0 }\n");
  is_near(support_trace(under, k_vec(0, 0, -2), k_vec(0, 0, 1)),
          1.5 + 4, 1 + 4, 0.5 + 32, "from below the light below counts");
  is_near(down(under), x, y, z, "from above it does not");
}

/** The ceiling is at 10; a reflected ray gets there after 2 + 10. */
#define ROOM(floor) \
  "material m { ambient 3 2 1 diffuse .5 .25 1 " floor " }\n" FLOOR \
  "material c { ambient 12 24 6 }\n" \
  "plane ceiling { material c normal 0 0 -1 point 0 0 10 }\n" SUPPORT_CAMERA

static void
mirror(void)
{
  is_near(down(support_model(ROOM("specular .5 .25 0"))),
          0.75 + 0.5, 0.25 + 0.5, 0.5,
          "mirror: diffuse color + specular reflected");
  is_near(down(support_model(ROOM("specular .5 .25 0")
    "light l { location 3 0 -4 emissivity 9 9 9 }\n")),
          0.5 * 1.65 + 0.55, 0.25 * 1.1 + 0.55, 0.55,
          "diffuse multiplies the shadow's term too");
  // No reflected ray where nothing mirrors.
  ray_t *ray = support_ray(support_model(ROOM("")), k_vec(0, 0, 2),
                           k_vec(0, 0, -1));
  [ray trace: support_model(ROOM(""))];
  PASS(ray->counters->reflection == 0, "no specular, no reflected ray");
  model_t *model = support_model(ROOM("specular 0 0 .5"));
  ray = support_ray(model, k_vec(0, 0, 2), k_vec(0, 0, -1));
  struct k_vec c = [ray trace: model]->v;
  PASS(ray->counters->reflection == 1, "specular in one channel is enough");
  is_near(c, 0.75, 0.25, 0.5 + 0.25, "and changes only that");
}

/** From (-3 0 4) to the origin: dis 5, H.V = 1 for a light at (3 0 4). */
static struct k_vec
aslant(model_t *model)
{
  return support_trace(model, k_vec(-3, 0, 4), k_vec(3, 0, -4));
}

#define SHINY(shininess) \
  "material m { diffuse 1 1 1 specular .5 1 2 " shininess " }\n" FLOOR \
  SUPPORT_CAMERA

static void
highlight(void)
{
  struct k_vec c;
  double cosine;

  // diffuse (N.L) e / r + specular e / r
  c = aslant(support_model
    (SHINY("") "light l { location 3 0 4 emissivity 5 10 20 }"));
  PASS_NEAR(c.x, 0.8 + 0.5, 64 * K_U, "highlight in the mirror direction,"
            " shininess 32");
  PASS_NEAR(c.y, 1.6 + 2, 256 * K_U, "green");
  PASS_NEAR(c.z, 3.2 + 8, 1024 * K_U, "blue");
  c = aslant(support_model
    (SHINY("") "light l { location 3 0 4 emissivity 5 10 20 falloff 2 }"));
  PASS_NEAR(c.x, (0.8 + 0.5) / 5, 64 * K_U, "the highlight falls off too");

  // Light straight above: L = N, H = N, H.V = .8, N.L = 1, r = 4.
  const char *shininess[] = { "0", "1", "2", "2.5", "7.3", "200" };
  for (int i = 0; i < 6; i++)
    {
      double n = strtod(shininess[i], NULL);
      c = aslant(support_model
        ("material m { specular .5 1 2 shininess %s }\n" FLOOR
         SUPPORT_CAMERA "light l { location 0 0 4 emissivity 4 4 4 }",
         shininess[i]));
      PASS_NEAR(c.z, 2 * pow(0.8, n), 8 * (n + 32) * K_U * pow(0.8, n),
                "shininess %s", shininess[i]);
    }
  c = aslant(support_model
    (SHINY("shininess 1e30") "light l { location 0 0 4 emissivity 4 4 4 }"));
  PASS(c.z == 1, "a huge shininess leaves no highlight beside the mirror"
       " direction: %g", c.z);
  c = support_trace(support_model
    (SHINY("shininess 1e30") "light l { location 0 0 4 emissivity 4 4 4 }"),
                    k_vec(0, 0, 2), k_vec(0, 0, -1));
  PASS(c.z == 3, "but all of it in it: %g", c.z);

  // L = (0 0 1) seen from the side at 60 degrees and more: H.V = cos.
  cosine = 0.28;
  c = support_trace(support_model
    (SHINY("shininess 3") "light l { location 0 0 4 emissivity 4 4 4 }"),
                    k_vec(-0.96, 0, 0.28), k_vec(0.96, 0, -0.28));
  PASS_NEAR(c.z, 1 + 2 * cosine * cosine * cosine, 32 * K_U,
            "a flat angle");
  // H and V more than 90 degrees apart: H = (-.96 0 .28), V = (.96 0 .28).
  c = support_trace(support_model
    (SHINY("shininess 0") "light l { location .96 0 .28 emissivity 1 1 1 }"),
                    k_vec(0.96, 0, 0.28), k_vec(-0.96, 0, -0.28));
  PASS_NEAR(c.z, 0.28 + 2, 16 * K_U, "shininess 0 shines everywhere:"
            " 0^0 is 1");
  c = support_trace(support_model
    (SHINY("shininess 1") "light l { location .96 0 .28 emissivity 1 1 1 }"),
                    k_vec(0.96, 0, 0.28), k_vec(-0.96, 0, -0.28));
  PASS_NEAR(c.z, 0.28, 16 * K_U, "any other exponent: nothing past 90"
            " degrees");
}

static void
highlight_and_others(void)
{
  // In the shadow there is none.
  struct k_vec c = aslant(support_model
    (SHINY("") "light l { location 3 0 4 emissivity 5 10 20 }\n"
     "material b { }\n"
     "sphere s { material b center 1.5 0 2 radius .25 }"));
  PASS(support_same(c, k_vec(0, 0, 0)), "no highlight in shadow");
  // No specular, no highlight, whatever the shininess.
  c = aslant(support_model
    ("material m { diffuse 1 1 1 shininess 0 }\n" FLOOR SUPPORT_CAMERA
     "light l { location 3 0 4 emissivity 5 10 20 }"));
  PASS_NEAR(c.x, 0.8, 8 * K_U, "no highlight without specular");
  // It is added last: neither diffuse nor alpha weigh it.
  c = aslant(support_model
    ("background 1 2 4\n"
     "material m { ambient 5 5 5 diffuse .5 0 .25 specular .5 1 2"
     " alpha .5 shininess 0 }\n" FLOOR SUPPORT_CAMERA
     "light l { location 3 0 4 emissivity 5 10 20 }"));
  // A = 1; surface: diffuse (1 + diffuse e .8 / 5) + specular background;
  // half of it, half of the background behind, and the highlight.
  PASS_NEAR(c.x, 0.5 * (0.5 * (1 + 0.5 * 0.8) + 0.5) + 0.5 + 0.5, 16 * K_U,
            "the highlight stands outside of mirror and blend (red)");
  PASS_NEAR(c.y, 0.5 * (0 + 2) + 0.5 * 2 + 2, 16 * K_U, "green");
  PASS_NEAR(c.z, 0.5 * (0.25 * (1 + 0.25 * 3.2) + 8) + 0.5 * 4 + 8,
            64 * K_U, "blue");
  // Two lights, two highlights, one in shadow.
  c = aslant(support_model
    ("material m { specular 1 1 1 shininess 0 }\n" FLOOR SUPPORT_CAMERA
     "light a { location 3 0 4 emissivity 5 5 5 }\n"
     "light b { location -3 0 4 emissivity 10 10 10 }\n"
     "light c { location 3 0 -4 emissivity 20 20 20 }\n"));
  PASS_NEAR(c.x, 1 + 2, 8 * K_U, "a highlight of each light that is lit");
}

int
main(void)
{
  NSAutoreleasePool *pool = [[NSAutoreleasePool alloc] init];

  ambient();
  diffuse();
  no_light();
  mirror();
  highlight();
  highlight_and_others();
  [pool release];
  return test_done();
}
