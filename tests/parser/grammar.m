// grammar.m - what a model file may contain, and what it then means.

#import "test.h"
#import "load.h"

static void
test_tokens(void)
{
  struct load spaced = load_text(CAMERA GLASS
    "sphere ball { material glass center 1 2 3 radius 4 }\n");
  static const char *const others[] = {
    // Braces stand anywhere; all white space is the same.
    "camera cam{pixeldim 8 6 worlddim 4 3 viewpoint 2 1.5 4}material glass"
    "{diffuse 1 1 1}sphere ball{material glass center 1 2 3 radius 4}",
    "camera\tcam\r\n{\vpixeldim\f8\n6\nworlddim 4 3\rviewpoint 2 1.5 4 }\r\n"
    "material glass\n{\n diffuse\n1\n1\n1\n}\nsphere ball\n{\n material\nglass\n"
    "center 1 2 3\nradius 4\n}\n\n\n",
    // Comments too.
    "# a comment\ncamera# of mine\ncam#{\n{#}\npixeldim 8#9\n6 worlddim 4 3"
    " viewpoint 2 1.5 4 }" GLASS "sphere ball { material glass center 1 2 3"
    " radius 4 } # the end {{{",
    // A byte order mark.
    "\xEF\xBB\xBF" CAMERA GLASS
    "sphere ball { material glass center 1 2 3 radius 4 }",
    // Any order.
    "sphere ball { radius 4 center 1 2 3 material glass }\n" GLASS CAMERA,
  };

  for (unsigned i = 0; i < sizeof others / sizeof *others; i++)
    {
      struct load other = load_text(others[i]);
      PASS(other.model && [other.canonical isEqual: spaced.canonical],
           "the same tokens, written another way (%u)", i);
    }
}

static void
test_names(void)
{
  static const char *const names[] = {
    "a", "7", "-1.5", "camera", "material", "include", "radius", "\"", "@!;,",
    "Größe", "球", "x-y_z.0", "\xF0\x9F\x94\xAE"
  };

  for (unsigned i = 0; i < sizeof names / sizeof *names; i++)
    {
      NSString *text = [NSString stringWithFormat: @"material %s { }"
        " sphere %s { material %s center 0 0 0 radius 1 }", names[i],
        names[i], names[i]];
      struct load load = load_scene([text UTF8String]);
      NSString *name = [NSString stringWithUTF8String: names[i]];
      object_t *object = [load.model->objects lastObject];
      PASS(load.model && [[object name] isEqual: name]
           && [object->material->name isEqual: name],
           "'%s' is a name", names[i]);
    }
  PASS(load_scene(GLASS "light a { location 0 0 0 emissivity 1 1 1 } plane a"
                  " { material glass normal 0 1 0 point 0 0 0 } sphere a {"
                  " material glass center 0 0 0 radius 1 }").model,
       "blocks of different keywords may have one name");
}

static void
test_blocks(void)
{
  struct load load = load_text(
    "sphere first { material shiny center .5 -1. +2e1 radius 0x1p-3 }\n"
    "camera cam { pixeldim 640 480 viewpoint 0 0 5 lookat 1 0 0 up 0 2 0"
    " angle 40 focus 6.3 fstop 2.8 exposure 32 aperture disc }\n"
    "background .25 0 1e-3\n"
    "light near { emissivity 1 2 3 location 4 5 6 }\n"
    "light far { location 0 0 0 emissivity 0 0 0 falloff 0 }\n"
    "material shiny { ambient 1 2 3 diffuse .1 .2 .3 specular .4 .5 .6"
    " shininess 7 alpha .8 ior 1.83 }\n"
    "material plain { }\n"
    "plane floor { material plain normal 0 3 0 point 0 1 0 }\n");
  model_t *model = load.model;

  if (!PASS(model, "all blocks and attributes"))
    {
      return;
    }

  material_t *shiny = [model->materials objectForKey: @"shiny"];
  material_t *plain = [model->materials objectForKey: @"plain"];
  light_t *near = [model->lights objectAtIndex: 0];
  light_t *far = [model->lights objectAtIndex: 1];
  object_t *first = [model->objects objectAtIndex: 0];
  object_t *floor = [model->objects objectAtIndex: 1];
  struct k_bounds box = [(id <object_t>)first bounds];

  PASS(model->camera->columns == 640 && model->camera->rows == 480
       && model->camera->exposure == 32, "the camera");
  PASS(k_is_equal(model->background, k_vec(.25, 0, 1e-3)), "the background");
  PASS([model->lights count] == 2 && k_is_equal(near->location, k_vec(4, 5, 6))
       && k_is_equal(near->emissivity, k_vec(1, 2, 3)), "the lights");
  PASS(near->falloff == 1 && far->falloff == 0, "falloff is 1 or as given");
  PASS(k_is_equal(shiny->ambient, k_vec(1, 2, 3))
       && k_is_equal(shiny->diffuse, k_vec(.1, .2, .3))
       && k_is_equal(shiny->specular, k_vec(.4, .5, .6))
       && shiny->shininess == 7 && shiny->alpha == .8 && shiny->ior == 1.83,
       "a material");
  PASS(k_is_equal(plain->ambient, k_vec(0, 0, 0))
       && k_is_equal(plain->diffuse, k_vec(0, 0, 0))
       && k_is_equal(plain->specular, k_vec(0, 0, 0))
       && plain->shininess == 32 && plain->alpha == 0 && plain->ior == 1,
       "a material without attributes");
  PASS(first->number == 1 && first->material == shiny && floor->number == 2
       && floor->material == plain, "objects, numbered as declared");
  PASS_NEAR(box.least.x, .5 - .125, 1e-9, "the sphere's center and radius");
  PASS_NEAR(box.most.z, 20 + .125, 1e-9, "and in z");
}

static void
test_minimal(void)
{
  struct load load = load_text(CAMERA);

  PASS(load.model && [load.model->objects count] == 0
       && [load.model->lights count] == 0, "a camera alone is a model");
  PASS(k_is_equal(load.model->background, k_vec(0, 0, 0)),
       "the background is black unless given");
  PASS(load.model->max_depth == 5, "options are taken over");
  PASS([load.text isEqual: [NSData dataWithBytes: CAMERA
                                          length: strlen(CAMERA)]],
       "the text comes back byte for byte");
  PASS([load.report length] == 0, "nothing is told of it");
}

int
main(void)
{
  NSAutoreleasePool *pool = [[NSAutoreleasePool alloc] init];

  test_tokens();
  test_names();
  test_blocks();
  test_minimal();
  [pool release];
  return test_done();
}
