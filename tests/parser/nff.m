// nff.m - Haines' Neutral File Format: what becomes of each entity.

#import "test.h"
#import "load.h"

#define VIEW "v\nfrom 1 2 3\nat 0 0 0\nup 0 1 0\nangle 45\nhither 1\n" \
  "resolution 64 48\n"
#define FILL "f 1 .5 .25 .5 .8 10 0 1\n"

static struct load
load_nff(const char *text)
{
  load_write("text.nff", text);
  return load_file("text.nff", [NSArray array]);
}

static void
test_entities(void)
{
  struct load load = load_nff("b .1 .2 .3\n" VIEW
    "l 1 2 3\nl 4 5 6 .7 .8 .9\nl 7 8 9\nl 0 0 0\n"
    FILL "s 1 2 3 4\np 3\n0 0 0\n1 0 0\n0 1 0\n"
    "# a comment\nf .5 .5 .5 1 0 3.0827 .5 1.5 # another\n"
    "pp 3 0 0 1 0 0 1  1 0 1 0 0 1  0 1 1 0 0 1\n");

  PASS(is_text(load.canonical,
    "background 0.1 0.2 0.3\n"
    "\ncamera v1\n{\n  pixeldim 64 48\n  viewpoint 1 2 3\n  lookat 0 0 0\n"
    "  up 0 1 0\n  angle 45\n}\n"
    "\nlight l1\n{\n  location 1 2 3\n  emissivity 0.5 0.5 0.5\n  falloff 0\n}\n"
    "\nlight l2\n{\n  location 4 5 6\n  emissivity 0.7 0.8 0.9\n  falloff 0\n}\n"
    "\nlight l3\n{\n  location 7 8 9\n  emissivity 0.5 0.5 0.5\n  falloff 0\n}\n"
    "\nlight l4\n{\n  location 0 0 0\n  emissivity 0.5 0.5 0.5\n  falloff 0\n}\n"
    "\nmaterial f1\n{\n  diffuse 0.5 0.25 0.125\n  specular 0.8 0.4 0.2\n"
    "  shininess 10\n  alpha 0\n  ior 1\n}\n"
    "\nmaterial f2\n{\n  diffuse 0.5 0.5 0.5\n  specular 0 0 0\n"
    "  shininess 3.0827\n  alpha 0.5\n  ior 1.5\n}\n"
    "\nsphere s1\n{\n  material f1\n  center 1 2 3\n  radius 4\n}\n"
    "\npolygon p1\n{\n  material f1\n  vertex 0 0 0\n  vertex 1 0 0\n"
    "  vertex 0 1 0\n}\n"
    "\npolygon p2\n{\n  material f2\n  vertex 0 0 1\n  vertex 1 0 1\n"
    "  vertex 0 1 1\n}\n"), "every entity");
  load_write("again.mdl", [load.canonical UTF8String]);
  PASS([load_file("again.mdl", [NSArray array]).canonical
         isEqual: load.canonical], "and the same as a model file");
}

static void
test_fills(void)
{
  struct load load = load_nff(VIEW "f 1 1 1 1 0 1 0 0\ns 0 0 0 1\n");
  material_t *material = [load.model->materials objectForKey: @"f1"];

  PASS(material && material->ior == 1,
       "an opaque fill may have no index of refraction");
  PASS(load_nff(VIEW "f 1 1 1 1 0 1 .5 0\n").faults == 1,
       "a clear one may not");
  PASS(load_nff(VIEW "f 1 0x1p-300 1 0x1p-300 0 1 0 1\n").model,
       "a product below the range of numbers is 0");
  PASS(load_nff(VIEW "f 1 0x1p300 1 0x1p300 0 1 0 1\n").faults == 1,
       "one beyond it is a fault");
}

/** The faces of a tetrahedron with a corner at (x 0 0), outwards. */
static NSString *
tetrahedron(const char *fills[4], double x)
{
  const double v[4][3] = {
    { x, 0, 0 }, { x + 1, 0, 0 }, { x, 1, 0 }, { x, 0, 1 }
  };
  static const int faces[4][3] = {
    { 0, 2, 1 }, { 0, 1, 3 }, { 0, 3, 2 }, { 1, 2, 3 }
  };
  NSMutableString *text = [NSMutableString string];

  for (int f = 0; f < 4; f++)
    {
      [text appendFormat: @"%sp 3\n", fills[f]];
      for (int i = 0; i < 3; i++)
        {
          const double *p = v[faces[f][i]];
          [text appendFormat: @"%g %g %g\n", p[0], p[1], p[2]];
        }
    }
  return text;
}

/** How many solids there are, and how many polygons are thin. */
static BOOL
has(NSString *text, unsigned solids, unsigned thin)
{
  struct load load = load_nff([text UTF8String]);
  NSMutableSet *names = [NSMutableSet set];
  unsigned found = 0;

  for (polygon_t *polygon in load.model->objects)
    {
      if (polygon->solid_name)
        {
          [names addObject: polygon->solid_name];
        }
      found += polygon->solid_name == nil;
    }
  if ([names count] != solids || found != thin)
    {
      printf("# %lu solids, %u thin\n", (unsigned long)[names count], found);
      printf("# %s\n", [load.report UTF8String]);
    }
  return load.model && [names count] == solids && found == thin;
}

static void
test_solids(void)
{
  static const char *one[] = { "f 1 1 1 1 0 1 .5 1.5\n", "", "", "" };
  static const char *more[] = { "", "", "", "" };
  static const char *colours[] = {
    "f 1 0 0 1 0 1 .5 1.5\n", "f 0 1 0 1 0 1 .5 1.5\n",
    "f 0 0 1 1 0 1 .5 1.5\n", "f 0 0 0 1 0 1 .5 1.5\n"
  };
  static const char *kinds[] = {
    "f 1 0 0 1 0 1 .5 1.5\n", "", "f 1 0 0 1 0 1 .5 1.6\n", ""
  };
  NSString *view = @VIEW;
  NSString *closed = [view stringByAppendingString: tetrahedron(one, 0)];
  NSRange last = [closed rangeOfString: @"p 3\n" options: NSBackwardsSearch];
  NSString *open = [closed substringToIndex: last.location];
  NSString *turned = [open stringByAppendingString:
                       @"p 3\n1 0 0\n0 0 1\n0 1 0\n"];

  PASS(has(closed, 1, 0), "four faces that close a volume are a solid");
  PASS(has([closed stringByAppendingString: tetrahedron(more, 5)], 2, 0),
       "two volumes are two solids");
  PASS(has([closed stringByAppendingString: tetrahedron(more, 1)], 2, 0),
       "even if they touch in a point");
  PASS(has([closed stringByAppendingString:
             @"p 3\n5 0 0\n6 0 0\n5 1 0\n"], 1, 1), "others are thin");
  PASS(has(open, 0, 3), "an open one is thin");
  PASS(has(turned, 0, 4), "so is one with a face that is turned round");
  PASS(has([closed stringByReplacingOccurrencesOfString: @"0 0 1\n"
                                             withString: @"-0 0 1\n"], 1, 0),
       "-0 is +0");
  PASS(has([view stringByAppendingString: tetrahedron(colours, 0)], 1, 0),
       "a solid of several colours");
  PASS(has([view stringByAppendingString: tetrahedron(kinds, 0)], 0, 4),
       "not one of several indices of refraction");
  PASS(has(@VIEW FILL "p 3\n0 0 0\n1 0 0\n0 1 0\np 3\n0 0 0\n0 1 0\n1 0 0\n",
           0, 2), "two sides of one triangle close no volume");
}

static void
test_includes(void)
{
  load_write("scene.nff", VIEW FILL "s 0 0 0 1\n");
  load_write("both.mdl", "include scene.nff\nlight l { location 0 9 0"
             " emissivity 1 1 1 }\nsphere s { material f1 center 3 0 0"
             " radius 1 }\n");
  PASS([load_file("both.mdl", [NSArray array]).model->objects count] == 2,
       "a model file may include NFF");
}

int
main(void)
{
  NSAutoreleasePool *pool = [[NSAutoreleasePool alloc] init];

  test_entities();
  test_fills();
  test_solids();
  test_includes();
  [pool release];
  return test_done();
}
