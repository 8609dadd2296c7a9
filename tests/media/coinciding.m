// coinciding.m - surfaces of clear things that coincide, which is not
// supported: a picture comes out all the same, the same by both engines, and
// the same whether a box is clipped by its six planes or, one of its faces
// being in two triangles, searched for the face that is hit. The number of a
// scene is its seed; `coinciding FROM TO` makes those.

#import "support.h"

#define HEAD \
  "background .2 .3 .4\nlight a { location 5 6 7 emissivity 9 9 9 }\n" \
  "material glass { ambient 0 .1 .1 alpha .95 ior 1.5 specular .1 .1 .1" \
  " }\nmaterial water { alpha .9 ior 1.33 }\nmaterial air { alpha 1 }\n" \
  "material heavy { ambient .1 .2 0 diffuse .4 .3 .2 alpha .5 ior 2 }\n" \
  "material stone { ambient .1 .1 .1 diffuse .6 .5 .4 }\n" \
  "sphere room { material stone center 0 0 0 radius 40 }\n"

static const char *const materials[] = { "glass", "water", "air", "heavy" };

/** A whole multiple of a half. */
static double
half(struct support_random *random, int least, int most)
{
  return 0.5 * (least + (int)((most - least + 1) * support_unit(random)));
}

static struct k_vec
corner(unsigned i, struct k_vec least, struct k_vec most)
{
  return k_vec(i & 1 ? most.x : least.x, i & 2 ? most.y : least.y,
               i & 4 ? most.z : least.z);
}

/** The six faces of a box, or seven. */
static void
write_box(NSMutableString *text, unsigned k, const char *material,
          struct k_vec least, struct k_vec most, int is_split)
{
  static const unsigned char corners[7][4] = {
    { 0, 1, 3, 2 }, { 4, 5, 7, 6 }, { 0, 1, 5, 4 },
    { 2, 3, 7, 6 }, { 0, 2, 6, 4 }, { 1, 3, 7, 5 }, { 0, 3, 2, 2 }
  };

  for (int face = 0; face < (is_split ? 7 : 6); face++)
    {
      int is_half = is_split && face % 6 == 0;
      [text appendFormat: @"polygon p%u-%d { material %s solid s%u", k, face,
        material, k];
      for (int i = 0; i < (is_half ? 3 : 4); i++)
        {
          struct k_vec v = corner(corners[face][i], least, most);
          [text appendFormat: @" vertex %g %g %g", v.x, v.y, v.z];
        }
      [text appendString: @" }\n"];
    }
}

/** Boxes on a coarse grid, side by side and one in the other, seen from
    anywhere. */
static NSString *
boxes(uint64_t seed, int is_split)
{
  struct support_random random = support_seed(seed);
  struct k_vec eye = k_scale(support_direction(&random), 4);
  NSMutableString *text = [NSMutableString stringWithFormat:
    @HEAD
    @"camera c { pixeldim 9 9 viewpoint %.17g %.17g %.17g lookat .01 .02 -.03"
    @" up .3 1 .2 angle 40 }\n", eye.x, eye.y, eye.z];

  for (unsigned k = 0; k < 2 + seed % 3; k++)
    {
      double x = half(&random, -2, 2), y = half(&random, -2, 2);
      struct k_vec least = k_vec(x, y, half(&random, -2, 2));
      double w = half(&random, 1, 3), h = half(&random, 1, 3);
      struct k_vec size = k_vec(w, h, half(&random, 1, 3));
      write_box(text, k, materials[(int)(4 * support_unit(&random))], least,
                k_add(least, size), is_split);
    }
  return text;
}

static struct k_vec
node(struct support_random *random)
{
  double x = half(random, -3, 3), y = half(random, -3, 3);

  return k_vec(x, y, half(random, -3, 3));
}

/** Boxes, some two of one solid, and balls on a coarse grid, where the eye is
    too, and rays along it: everything coincides with something. */
static NSString *
grid(uint64_t seed)
{
  struct support_random random = support_seed(seed);
  NSMutableString *text = [NSMutableString stringWithUTF8String: HEAD];
  double x = half(&random, 0, 4), y = half(&random, 0, 4);

  for (unsigned k = 0; k < 2 + seed % 4; k++)
    {
      const char *of = materials[(int)(4 * support_unit(&random))];
      char name[2][16], solid[16];
      struct k_vec c = node(&random);
      double s = half(&random, 1, 3), t = half(&random, 1, 3);
      double u = half(&random, 1, 3);
      snprintf(solid, sizeof solid, "s%u", k);
      snprintf(name[0], sizeof *name, "a%u-", k);
      snprintf(name[1], sizeof *name, "b%u-", k);
      if (support_unit(&random) < 0.3)
        {
          [text appendFormat: @"sphere s%u { material %s center %g %g %g"
            @" radius %g }\n", k, of, c.x, c.y, c.z, s];
          continue;
        }
      struct k_vec size = k_vec(s, t, u);
      [text appendFormat: @"%s", support_box(name[0], solid, of, c,
                                             k_add(c, size))];
      if (support_unit(&random) < 0.4)
        {
          // On its floor, or on its top.
          struct k_vec at = k_add(c, k_vec(s / 4, t / 4, 0));
          at.z += support_unit(&random) < 0.5 ? 0 : u;
          size = k_scale(size, 0.5);
          [text appendFormat: @"%s", support_box(name[1], solid, of, at,
                                                 k_add(at, size))];
        }
    }
  [text appendFormat: @"camera c { pixeldim 9 9 worlddim 2 2 viewpoint %g %g"
    @" %g }\n", x - 0.5, y - 0.5, half(&random, 1, 4)];
  return text;
}

int
main(int count, char **words)
{
  NSAutoreleasePool *pool = [[NSAutoreleasePool alloc] init];
  uint64_t from = count > 1 ? atoi(words[1]) : 0;
  uint64_t to = count > 2 ? atoi(words[2]) : 60;

  for (uint64_t seed = from; seed < to; seed++)
    {
      NSAutoreleasePool *inner = [[NSAutoreleasePool alloc] init];
      image_t *image[2];
      unsigned differences = 0;
      for (int is_split = 0; is_split < 2; is_split++)
        {
          model_t *model = support_model_with(support_options(),
                                              boxes(seed, is_split));
          image[is_split] = support_picture(model, support_render_options());
        }
      for (unsigned i = 0; i < 81; i++)
        {
          differences += !support_same(image[0]->pixels[i].color,
                                       image[1]->pixels[i].color);
        }
      PASS(differences == 0, "scene %llu: clipped or searched, the same: %u"
           " pixels differ", (unsigned long long)seed, differences);
      [inner release];
    }
  for (uint64_t seed = from; seed < to; seed++)
    {
      NSAutoreleasePool *inner = [[NSAutoreleasePool alloc] init];
      model_t *model = support_model_with(support_options(), grid(seed));
      image_t *image = support_picture(model, support_render_options());
      unsigned bad = 0;
      for (unsigned i = 0; i < 81; i++)
        {
          bad += !isfinite(k_norm1(image->pixels[i].color));
        }
      PASS(bad == 0, "grid %llu: %u pixels are no numbers",
           (unsigned long long)seed, bad);
      [inner release];
    }
  [pool release];
  return test_done();
}
