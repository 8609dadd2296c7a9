// metamorphic.m - pictures of one scene described in different ways: scaled,
// mirrored, in another order, with what cannot be seen. No picture is known
// beforehand; what is known is that they are the same.

#import "scene.h"
#include "test.h"

static image_t *
picture(struct scene how)
{
  return support_picture(scene_model(how), support_render_options());
}

/** Everything times 2^k, ambient too, emissivity times 2^(k falloff): the
    same bits, and depth times 2^k. */
static void
scaled(struct scene how, const char *what)
{
  how.k = 0;
  image_t *plain = picture(how);

  for (int k = -200; k <= 200; k += 50)
    {
      NSAutoreleasePool *pool = [[NSAutoreleasePool alloc] init];
      how.k = k;
      image_t *image = picture(how);
      size_t count = (size_t)[image width] * [image height];
      for (size_t i = 0; i < count; i++)
        {
          image->surfaces[i].depth = ldexp(image->surfaces[i].depth, -k);
        }
      unsigned differences = support_differences(plain, image);
      PASS(differences == 0, "%s times 2^%d: %u pixels differ", what, k,
           differences);
      [pool release];
    }
}

/** x becomes -x: the picture is its mirror image. */
static void
mirrored(void)
{
  struct scene how = { .columns = 64, .rows = 48 };
  image_t *plain = picture(how);
  how.is_mirrored = 1;
  image_t *image = picture(how);
  unsigned wrong = 0, rows = [plain height], columns = [plain width];

  for (unsigned y = 0; y < rows; y++)
    {
      for (unsigned x = 0; x < columns; x++)
        {
          struct surface_pixel *a = [plain surfaceAt: x : y];
          struct surface_pixel *b = [image surfaceAt: columns - 1 - x : y];
          struct k_vec p = [plain pixelAt: x : y]->color;
          struct k_vec q = [image pixelAt: columns - 1 - x : y]->color;
          int is_wrong = !support_same(p, q) || a->depth != b->depth
            || a->object != b->object || a->N.x != -b->N.x
            || a->N.y != b->N.y || a->N.z != b->N.z;
          if (is_wrong && wrong++ == 0)
            {
              printf("# first at %u %u: objects %u and %u\n", x, y,
                     a->object, b->object);
            }
        }
    }
  PASS(wrong == 0, "mirrored: %u pixels differ", wrong);
}

/** In a random order, their numbers put back afterwards. */
static void
shuffled(void)
{
  struct scene how = { .columns = 40, .rows = 30 };
  model_t *plain = scene_model(how);
  image_t *image = support_picture(plain, support_render_options());
  unsigned differences = 0, moved = 0;

  for (how.shuffle = 1; how.shuffle <= 8; how.shuffle++)
    {
      NSAutoreleasePool *pool = [[NSAutoreleasePool alloc] init];
      model_t *model = scene_model(how);
      for (object_t *object in plain->objects)
        {
          object_t *same = support_object(model, [[object name] UTF8String]);
          moved += same->number != object->number;
          same->number = object->number;
        }
      image_t *other = support_picture(model, support_render_options());
      differences += support_differences(image, other);
      [pool release];
    }
  PASS(moved > 100, "shuffling moves objects: %u", moved);
  PASS(differences == 0, "in another order: %u pixels differ", differences);
}

/** More objects where no ray gets to. */
static void
unseen(void)
{
  struct scene how = { .columns = 40, .rows = 30 };
  image_t *plain = picture(how);

  how.more = "sphere hidden { material red center -2 0 0 radius .5 }\n"
    "sphere clear { material glass center -2 .1 0 radius .25 }\n"
    "polygon in { material red vertex -2 0 0 vertex -2 .5 0"
    " vertex -2 0 .5 }\n";
  image_t *image = picture(how);
  unsigned differences = support_differences(plain, image);
  PASS(differences == 0, "things inside an opaque ball: %u pixels differ",
       differences);
  how.more = "sphere far { material red center 0 1 1e9 radius 1 }\n";
  image = picture(how);
  differences = support_differences(plain, image);
  PASS(differences == 0, "a ball far behind the eye: %u pixels differ",
       differences);
  how.more = "material unused { ambient 9 9 9 ior 9 alpha .5 }\n";
  image = picture(how);
  differences = support_differences(plain, image);
  PASS(differences == 0, "a material that nothing is made of: %u pixels"
       " differ", differences);
}

/** A cube of index 1 and alpha 1 is not there. */
static void
nothing_cube(void)
{
  const char *cube = support_box("n", "n", "nothing", k_vec(0.5, 0.25, 0.5),
                                 k_vec(1.5, 1.5, 1.75));
  model_t *model = support_model
    ("background .1 .7 .3\n"
     "camera cam { pixeldim 64 64 worlddim 2 2 viewpoint 1 1 5 }\n"
     "material nothing { alpha 1 }\n%s", cube);
  image_t *image = support_picture(model, support_render_options());
  unsigned wrong = 0, seen = 0;

  for (unsigned i = 0; i < 64 * 64; i++)
    {
      wrong += !support_same(image->pixels[i].color, k_vec(0.1, 0.7, 0.3));
      seen += image->surfaces[i].object != 0;
    }
  PASS(seen > 1000, "the eye's rays do hit the cube: %u", seen);
  PASS(wrong == 0, "before a constant background it does not show, bit for"
       " bit: %u pixels", wrong);

  // Before things: each ray is cut into three, so dis is rounded anew.
  const char *things = "background .25 .5 1\n"
    "camera cam { pixeldim 64 48 worlddim 4 3 viewpoint 2 1.5 6 }\n"
    "light a { location 5 6 4 emissivity 4 4 4 }\n"
    "light b { location -3 2 3 emissivity 2 2 2 }\n"
    "material stone { ambient 3 3 3 diffuse .5 .5 .5 }\n"
    "material chrome { diffuse .2 .2 .2 specular .8 .8 .8 }\n"
    "plane floor { material stone normal 0 1 0 point 0 -.5 0 }\n"
    "sphere ball { material stone center 1 0 -1 radius .8 }\n"
    "sphere mirror { material chrome center 3 1 -2 radius 1.2 }\n"
    "polygon sign { material stone vertex 0 1 -2 vertex 2 1.2 -2"
    " vertex 1 3 -2 }\n";
  model_t *plain = support_model("%s", things);
  model_t *with = support_model
    ("%s material nothing { alpha 1 }\n%s", things,
     support_box("n", "n", "nothing", k_vec(0.3, 0.2, 1), k_vec(3, 2, 2)));
  plain->max_depth = with->max_depth = 8;
  image = support_picture(with, support_render_options());
  image_t *without = support_picture(plain, support_render_options());
  unsigned through = 0;
  double worst = 0;
  for (unsigned i = 0; i < 64 * 48; i++)
    {
      struct k_vec p = without->pixels[i].color;
      struct k_vec q = image->pixels[i].color;
      through += image->surfaces[i].object > 4;
      worst = fmax(worst, k_norm_max(k_sub(p, q)));
    }
  PASS(through > 1000, "it covers a part of the picture: %u pixels", through);
  // A few roundings of points at most 10 away, on a mirror ball once, where
  // they grow by 2 distance / radius; colours change by about 1 a unit but
  // for highlights, 32 a unit.
  PASS(worst < 1e-11, "before a scene it changes nothing: %g", worst);
}

int
main(void)
{
  NSAutoreleasePool *pool = [[NSAutoreleasePool alloc] init];
  struct scene lookat = { .columns = 40, .rows = 30 };
  struct scene lens = { .has_lens = 1, .columns = 20, .rows = 15 };
  struct scene window = { .has_window = 1, .columns = 40, .rows = 30 };
  struct scene both = { .has_lens = 1, .has_window = 1, .columns = 20,
                        .rows = 15 };

  scaled(lookat, "lookat");
  scaled(lens, "lookat with lens");
  scaled(window, "window");
  scaled(both, "window with lens");
  mirrored();
  shuffled();
  unseen();
  nothing_cube();
  [pool release];
  return test_done();
}
