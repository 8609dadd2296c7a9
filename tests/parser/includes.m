// includes.m - files in files: where they are looked for, what they may do,
// and how their faults are told.

#import "test.h"
#import "load.h"

static void
test_places(void)
{
  [[NSFileManager defaultManager]
    createDirectoryAtPath: load_path("parts/deep")
    withIntermediateDirectories: YES attributes: nil error: NULL];
  [[NSFileManager defaultManager]
    createDirectoryAtPath: load_path("library")
    withIntermediateDirectories: YES attributes: nil error: NULL];
  load_write("parts/glass.mdl", GLASS "include deep/brass.mdl\n");
  load_write("parts/deep/brass.mdl", "material brass { }\n");
  load_write("parts/two words.mdl", "material two-words { }\n");
  load_write("parts/br}ace#.mdl", "material brace { }\n");
  load_write("library/wood.mdl", "material wood { }\n");
  load_write("library/twin.mdl", "material from-library { }\n");
  load_write("twin.mdl", "material from-folder { }\n");
  load_write("empty.mdl", "");
  load_write("main.mdl", CAMERA "include parts/glass.mdl\n"
             "include \"parts/two words.mdl\"include wood.mdl#comment\n"
             "include\n  twin.mdl include \"parts/br}ace#.mdl\"\n"
             "include empty.mdl include empty.mdl\n");

  NSArray *path = [NSArray arrayWithObjects: load_path("nowhere"),
                           load_path("library"), nil];
  struct load load = load_file("main.mdl", path);

  if (!PASS(load.model, "a model of many files"))
    {
      printf("# %s\n", [load.report UTF8String]);
      return;
    }

  NSDictionary *materials = load.model->materials;

  PASS([materials objectForKey: @"glass"], "a file in a folder");
  PASS([materials objectForKey: @"brass"],
       "found from the folder of the including file");
  PASS([materials objectForKey: @"two-words"], "a path with a space");
  PASS([materials objectForKey: @"brace"], "a path with a brace and a #");
  PASS([materials objectForKey: @"wood"], "a file of the include path");
  PASS([materials objectForKey: @"from-folder"]
       && ![materials objectForKey: @"from-library"],
       "the including file's folder comes first");
  PASS(load_file("main.mdl", [NSArray array]).faults == 1,
       "without the include path one file is missing");
}

/** A scene with one include of this path. */
static struct load
load_fenced(const char *path, NSArray *include_path)
{
  load_write("scene/main.mdl", [[NSString stringWithFormat: @CAMERA
    "include \"%s\"\n", path] UTF8String]);
  return load_file("scene/main.mdl", include_path);
}

/** Nothing outside of the scene's folder is read, however it is written. */
static void
test_fence(void)
{
  NSFileManager *manager = [NSFileManager defaultManager];
  NSArray *none = [NSArray array];
  NSArray *all = [NSArray arrayWithObject: load_path("outside")];
  const char *secret = [load_path("outside/secret.mdl") UTF8String];
  const char *own = [load_path("scene/own.mdl") UTF8String];

  for (NSString *folder in [NSArray arrayWithObjects: load_path("scene/sub"),
                                    load_path("scene2"), load_path("outside"),
                                    nil])
    {
      [manager createDirectoryAtPath: folder
         withIntermediateDirectories: YES attributes: nil error: NULL];
    }
  load_write("outside/secret.mdl", GLASS);
  load_write("scene2/twin.mdl", GLASS);
  load_write("scene/own.mdl", GLASS);
  load_write("scene/sub/up.mdl", "include ../own.mdl\n");
  load_write("scene/sub/out.mdl", "include ../../outside/secret.mdl\n");
  (void)!symlink("../outside/secret.mdl", [load_path("scene/link.mdl")
                                            UTF8String]);
  (void)!symlink("../outside", [load_path("scene/linked") UTF8String]);
  (void)!symlink("sub/../own.mdl", [load_path("scene/inner.mdl") UTF8String]);

  const struct
    {
      const char *path, *what;
      BOOL isAllowed, isWithPath;       // without and with --include-path
    }
  cases[] = {
    { "own.mdl", "its own folder", YES, YES },
    { "sub/up.mdl", "up from a folder in it", YES, YES },
    { "sub/../own.mdl", "down and up", YES, YES },
    { "../scene/own.mdl", "out and in again", YES, YES },
    { "inner.mdl", "a link that stays inside", YES, YES },
    { "../outside/secret.mdl", "..", NO, YES },
    { "sub/out.mdl", ".. in an included file", NO, YES },
    { secret, "an absolute path", NO, YES },
    { own, "an absolute path into its own folder", NO, NO },
    { "link.mdl", "a link to a file", NO, YES },
    { "linked/secret.mdl", "a link to a folder", NO, YES },
    { "../scene2/twin.mdl", "a folder whose name begins the same", NO, NO },
    { "/etc/passwd", "a file of the system", NO, NO },
    { "/dev/zero", "a device", NO, NO }
  };

  for (unsigned i = 0; i < sizeof cases / sizeof *cases; i++)
    {
      struct load without = load_fenced(cases[i].path, none);
      PASS((without.model != nil) == cases[i].isAllowed
           && (cases[i].isAllowed
               || [without.report rangeOfString: @"lies outside"].length),
           "%s: %s", cases[i].what, cases[i].isAllowed ? "read" : "not read");
      PASS((load_fenced(cases[i].path, all).model != nil)
           == cases[i].isWithPath, "%s, with an include path that has the"
           " secret", cases[i].what);
    }

  NSString *want = [NSString stringWithFormat:
    @"%@:2:9: error: expected a file in the scene's folder,"
     " '../outside/secret.mdl' lies outside of it;"
     " 'raytrace --include-path DIR' allows what is in DIR\n"
     "   2 | include \"../outside/secret.mdl\"\n     |         ^\n",
    load_path("scene/main.mdl")];
  PASS(is_text(load_fenced("../outside/secret.mdl", none).report,
               [want UTF8String]), "what is told of it");
  PASS(![load_fenced("../outside/secre.mdl", none).report
          rangeOfString: @"did you mean"].length,
       "names of files outside are not told");
}

static void
test_text(void)
{
  load_write("inner.mdl", GLASS);
  load_write("outer.mdl", CAMERA "include inner.mdl\n# end\n");

  struct load load = load_file("outer.mdl", [NSArray array]);
  NSData *want = [[NSString stringWithFormat: @"%s", CAMERA
                             "include inner.mdl\n# end\n" GLASS]
                   dataUsingEncoding: NSUTF8StringEncoding];

  PASS([load.text isEqual: want], "the text is that of all files as read");
  PASS(is_text(load.canonical, "camera cam\n{\n  pixeldim 8 6\n"
               "  worlddim 4 3\n  viewpoint 2 1.5 4\n}\n\n"
               "material glass\n{\n  diffuse 1 1 1\n}\n"),
       "canonical form has no includes");
}

static void
test_chain(void)
{
  NSString *here = load_folder();

  load_write("c.mdl", "\n  spehre s { }\n");
  load_write("b.mdl", "include c.mdl\n");
  load_write("a.mdl", CAMERA "\n include b.mdl\nsphere t { }\n");

  NSString *want = [NSString stringWithFormat:
    @"In file included from %@/b.mdl:1:9,\n"
     "                 from %@/a.mdl:3:10:\n"
     "%@/c.mdl:2:3: error: unknown keyword 'spehre'; did you mean 'sphere'?\n"
     "   2 |   spehre s { }\n"
     "     |   ^\n"
     "%@/a.mdl:4:1: error: expected material, center and radius of sphere"
     " 't', found none\n"
     "   4 | sphere t { }\n"
     "     | ^\n", here, here, here, here];

  PASS(is_text(load_file("a.mdl", [NSArray array]).report,
               [want UTF8String]),
       "a fault in an included file shows the chain");
}

/** n files, each includes the next. */
static struct load
load_nested(unsigned n)
{
  for (unsigned i = 0; i < n; i++)
    {
      char name[32], text[128];
      snprintf(name, sizeof name, "n%u.mdl", i);
      snprintf(text, sizeof text, i == n - 1 ? "%s" : "%sinclude n%u.mdl\n",
               i == 0 ? CAMERA : "", i + 1);
      load_write(name, text);
    }
  return load_file("n0.mdl", [NSArray array]);
}

static void
test_depth(void)
{
  struct load deep = load_nested(10000);

  load_write("n256.mdl", "include none.mdl\ninclude none.mdl\n");
  load_write("n255.mdl", "include n256.mdl\ninclude n256.mdl\n");
  load_write("n0.mdl", CAMERA "include n1.mdl\n");
  PASS(load_file("n0.mdl", [NSArray array]).faults == 1,
       "a depth that is reached again and again is told once");
  PASS(load_nested(257).model, "256 files deep");
  PASS(deep.faults == 1
       && [deep.report rangeOfString: @"n256.mdl:1:9: error: "].length
       && [deep.report rangeOfString: @"... 248 more ..."].length,
       "10,000 files deep are one fault");
}

/** 40 files, each includes the next one twice: 2^40 in all. */
static void
test_bomb(void)
{
  for (unsigned i = 0; i < 40; i++)
    {
      char name[32], text[128];
      snprintf(name, sizeof name, "w%u.mdl", i);
      snprintf(text, sizeof text, "include w%u.mdl include w%u.mdl\n", i + 1,
               i + 1);
      load_write(name, i == 0 ? CAMERA "include w1.mdl\n" : text);
    }
  load_write("w40.mdl", "");

  struct load load = load_file("w0.mdl", [NSArray array]);

  PASS(load.model == nil && load.faults == 1,
       "2^40 files come to an end, and that is told once");
}

static void
test_cycles(void)
{
  load_write("self.mdl", CAMERA "include ./self.mdl\n");
  load_write("x.mdl", "include y.mdl\n");
  load_write("y.mdl", "include \"../y.mdl\"\ninclude x.mdl\n");
  load_write("cycle.mdl", CAMERA "include x.mdl\n");
  symlink([load_path("self.mdl") UTF8String],
          [load_path("link.mdl") UTF8String]);
  load_write("self.mdl", CAMERA "include link.mdl\n");
  PASS(load_file("self.mdl", [NSArray array]).faults == 1,
       "a file that includes itself by another name");
  PASS(load_file("cycle.mdl", [NSArray array]).faults == 2,
       "a cycle of two, and a file that is missing");
}

int
main(void)
{
  NSAutoreleasePool *pool = [[NSAutoreleasePool alloc] init];

  test_places();
  test_fence();
  test_text();
  test_chain();
  test_depth();
  test_bomb();
  test_cycles();
  [pool release];
  return test_done();
}
