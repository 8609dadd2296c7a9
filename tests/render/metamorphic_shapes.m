// metamorphic_shapes.m - pictures of one thing made of other shapes: polygons
// cut in two along a diagonal, and a solid of more and more faces in place of
// a sphere. No picture is known beforehand.

#import "support.h"

/** The largest difference of two pictures, and their mean one. */
static double
apart(image_t *a, image_t *b, double *mean)
{
  size_t count = (size_t)[a width] * [a height];
  double most = 0, sum = 0;

  for (size_t i = 0; i < count; i++)
    {
      double off = k_norm_max(k_sub(a->pixels[i].color, b->pixels[i].color));
      most = fmax(most, off);
      sum += off;
    }
  *mean = sum / count;
  return most;
}

static image_t *
picture(NSString *text)
{
  model_t *model = support_model("%s", [text UTF8String]);

  return support_picture(model, support_render_options());
}

// Polygons cut in two

/** A polygon of corners 0 to n - 1, or what is left of it and right of it
    after a cut from corner 0 to corner `cut`. */
static NSString *
polygon(const char *name, const char *what, const double corners[][3],
        unsigned n, unsigned cut)
{
  NSMutableString *text = [NSMutableString string];

  for (unsigned part = 0; part < (cut ? 2 : 1); part++)
    {
      unsigned first = part == 0 ? 1 : cut;
      unsigned last = cut && part == 0 ? cut : n - 1;
      [text appendFormat: @"polygon %s%u { %s vertex %.17g %.17g %.17g", name,
            part, what, corners[0][0], corners[0][1], corners[0][2]];
      for (unsigned i = first; i <= last; i++)
        {
          [text appendFormat: @" vertex %.17g %.17g %.17g", corners[i][0],
                corners[i][1], corners[i][2]];
        }
      [text appendString: @" }\n"];
    }
  return text;
}

static NSString *const room =
  @"background .2 .4 .6\n"
  "camera cam { pixeldim 64 48 viewpoint 1 2 6 lookat .2 .1 0 up 0 1 0"
  " angle 50 }\n"
  "light a { location 3 5 4 emissivity 4 4 4 }\n"
  "light b { location -3 4 1 emissivity 2 1 3 falloff 1 }\n"
  "material stone { ambient 2 1 1 diffuse .6 .5 .4 specular .2 .2 .2 }\n"
  "material chrome { diffuse .1 .1 .1 specular .9 .9 .9 }\n"
  "material glass { diffuse .1 .1 .1 alpha .8 ior 1.5 }\n"
  "sphere ball { material stone center 0 .3 1 radius .6 }\n"
  "sphere drop { material glass center 1.3 .2 1.6 radius .5 }\n";

/** A floor with a reflex corner and a mirror, in planes that are not along
    the axes: their normals, of other corners, may be rounded otherwise. */
static NSString *
cut_room(int is_cut)
{
  static const double slope[6][3] = { { 0, -.5, 0 }, { 0, -.7, 2.5 },
    { -2.5, -.45, 2.5 }, { -2.5, .1, -3 }, { 3, -.45, -3 }, { 3, -.65, -.5 } };
  static const double mirror[4][3] = { { -2.5, -.5, -1.5 },
    { 1.5, -.25, -2.25 }, { 1.25, 2.5, -2.5 }, { -2.75, 2.25, -1.75 } };
  double floor[6][3];

  for (int i = 0; i < 6; i++)
    {
      floor[i][0] = slope[i][0];
      floor[i][1] = -.5 - .125 * slope[i][0] + .0625 * slope[i][2];
      floor[i][2] = slope[i][2];
    }
  NSString *text = [room stringByAppendingString:
    polygon("floor", "material stone", floor, 6, is_cut ? 3 : 0)];
  return [text stringByAppendingString:
    polygon("mirror", "material chrome", mirror, 4, is_cut ? 2 : 0)];
}

/** A clear box, leaning, each face in two triangles or in one piece. */
static NSString *
cut_box(int is_cut)
{
  static const unsigned char faces[6][4] = {    // bit 0: x, 1: y, 2: z
    { 0, 1, 3, 2 }, { 4, 5, 7, 6 }, { 0, 1, 5, 4 },
    { 2, 3, 7, 6 }, { 0, 2, 6, 4 }, { 1, 3, 7, 5 }
  };
  NSString *text = [room stringByAppendingString:
    @"plane floor { material stone normal 0 1 0 point 0 -.5 0 }\n"];

  for (int i = 0; i < 6; i++)
    {
      double corners[4][3];
      char name[16];
      for (int j = 0; j < 4; j++)
        {
          double x = faces[i][j] & 1 ? 1 : 0, y = faces[i][j] & 2 ? 1.5 : 0;
          double z = faces[i][j] & 4 ? .75 : 0;
          corners[j][0] = -.5 + x + .25 * y;
          corners[j][1] = -.25 + y - .125 * x;
          corners[j][2] = 2 + z + .0625 * y;
        }
      snprintf(name, sizeof name, "box%d_", i);
      text = [text stringByAppendingString:
        polygon(name, "material glass solid box", corners, 4, is_cut ? 2 : 0)];
    }
  return text;
}

static void
cut(void)
{
  double mean;
  image_t *whole = picture(cut_room(0)), *parts = picture(cut_room(1));
  unsigned of_second = 0;

  for (unsigned i = 0; i < 64 * 48; i++)
    {
      of_second += parts->surfaces[i].object == 4
        || parts->surfaces[i].object == 6;
    }
  PASS(of_second > 200, "second halves are seen in %u pixels", of_second);
  double most = apart(whole, parts, &mean);
  PASS(most < 1e-11, "a floor and a mirror cut in two: off by %g", most);
  most = apart(picture(cut_box(0)), picture(cut_box(1)), &mean);
  PASS(most < 1e-11, "a clear box cut in triangles: off by %g", most);
}

// A solid in place of a sphere

#define LEVELS 4        // 8 * 4^4 faces

struct mesh
{
  NSMutableString *text;
  const char *what;
  unsigned count;
};

/** A triangle on the unit sphere in 4^level smaller ones. */
static void
triangles(struct mesh *mesh, struct k_vec a, struct k_vec b, struct k_vec c,
          int level)
{
  if (level == 0)
    {
      [mesh->text appendFormat: @"polygon p%u { %s vertex %.17g %.17g %.17g"
            @" vertex %.17g %.17g %.17g vertex %.17g %.17g %.17g }\n",
            mesh->count++, mesh->what, a.x, a.y, a.z, b.x, b.y, b.z,
            c.x, c.y, c.z];
      return;
    }
  struct k_vec ab = k_unit(k_add(a, b)), bc = k_unit(k_add(b, c));
  struct k_vec ca = k_unit(k_add(c, a));

  triangles(mesh, a, ab, ca, level - 1);
  triangles(mesh, ab, b, bc, level - 1);
  triangles(mesh, ca, bc, c, level - 1);
  triangles(mesh, ab, bc, ca, level - 1);
}

/** A ball: a sphere with level -1, or 8 * 4^level faces. */
static image_t *
ball(const char *material, int level)
{
  NSMutableString *text = [NSMutableString stringWithString:
    @"background .2 .4 .6\n"
    "camera cam { pixeldim 56 56 viewpoint .7 .4 5 lookat 0 0 0 up 0 1 0"
    " angle 30 }\n"
    "light a { location 3 4 5 emissivity 2 2 2 }\n"
    "material matt { diffuse .8 .7 .6 }\n"
    "material chrome { diffuse .1 .1 .1 specular .9 .9 .9 }\n"
    "material glass { diffuse .1 .1 .1 alpha .9 ior 1.5 }\n"
    "material sand { ambient 4 3 2 diffuse .3 .3 .3 }\n"
    "plane floor { material sand normal 0 1 0 point 0 -1.25 0 }\n"];
  char what[64];
  struct mesh mesh = { text, what, 0 };

  snprintf(what, sizeof what, "material %s solid ball", material);
  if (level < 0)
    {
      [text appendFormat: @"sphere ball { material %s center 0 0 0"
            " radius 1 }\n", material];
    }
  for (int i = 0; i < 8 && level >= 0; i++)
    {
      triangles(&mesh, k_vec(i & 1 ? -1 : 1, 0, 0),
                k_vec(0, i & 2 ? -1 : 1, 0), k_vec(0, 0, i & 4 ? -1 : 1),
                level);
    }
  return picture(text);
}

/** Each level halves the edges, and with them how far the normals are off; so
    the mean difference comes near 0, in step but for edges of what is seen in
    the ball. */
static void
limit(const char *material)
{
  image_t *sphere = ball(material, -1);
  double mean[LEVELS + 1];

  for (int level = 1; level <= LEVELS; level++)
    {
      NSAutoreleasePool *pool = [[NSAutoreleasePool alloc] init];
      apart(ball(material, level), sphere, &mean[level]);
      [pool release];
      if (level > 1)
        {
          PASS(mean[level] < 0.8 * mean[level - 1], "%s, %d faces: off by %g"
               " in the mean, with a quarter of them %g", material,
               8 << (2 * level), mean[level], mean[level - 1]);
        }
    }
  PASS(mean[LEVELS] < mean[1] / 4, "%s: from %g to %g", material, mean[1],
       mean[LEVELS]);
}

int
main(void)
{
  NSAutoreleasePool *pool = [[NSAutoreleasePool alloc] init];

  cut();
  limit("matt");
  limit("chrome");
  limit("glass");
  [pool release];
  return test_done();
}
