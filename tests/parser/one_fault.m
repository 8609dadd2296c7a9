// one_fault.m - one fault is told once: a good file is spoilt in one place, in
// every place and in many ways, and there is never a second message.

#import "test.h"
#import "load.h"

static const char good[] =
  "camera cam { pixeldim 8 6 worlddim 4 3 viewpoint 2 1.5 4 }\n"
  "background 0 0 1\n"
  "light sun { location 0 9 0 emissivity 1 1 1 falloff 2 }\n"
  "material glass { diffuse .1 .1 .1 alpha .9 ior 1.5 }\n"
  "sphere ball { material glass center 1 1 1 radius 2 }\n"
  "plane floor { material chalk normal 0 1 0 point 0 0 0 }\n"
  "material chalk { diffuse 1 1 1 }\n"
  "polygon p { material chalk vertex 0 0 0 vertex 1 0 0 vertex 0 1 0 }\n"
  "# the end\n";

/** What takes the place of a token; %s is the token. */
static const struct
{
  const char *name, *text;
} changes[] = {
  { "left out", "" }, { "twice", "%s %s" }, { "with a q", "%sq" },
  { "without meaning", "???" }, { "before a {", "%s {" },
  { "before a }", "%s }" }, { "after a {", "{ %s" }, { "after a }", "} %s" },
  { "after a number", "7 %s" }, { "after a word", "seven %s" },
  { "after a comma", ", %s" }, { "with a comma", "%s," },
  { "before a semicolon", "%s ;" }, { "as a comment", "#%s\n" },
};

static void
change(const char *name, const char *text)
{
  NSArray *lines = [[NSString stringWithUTF8String: good]
                     componentsSeparatedByString: @" "];
  unsigned most = 0;

  for (NSUInteger i = 0; i + 3 < [lines count]; i++)
    {
      NSAutoreleasePool *pool = [[NSAutoreleasePool alloc] init];
      NSMutableArray *changed = [NSMutableArray arrayWithArray: lines];
      NSString *word = [lines objectAtIndex: i];
      NSRange newline = [word rangeOfString: @"\n"];
      NSString *tail = @"";
      if (newline.length)               // "}\nlight": the brace is changed
        {
          tail = [word substringFromIndex: newline.location];
          word = [word substringToIndex: newline.location];
        }
      const char *bytes = [word UTF8String];
      char spoilt[256];
      snprintf(spoilt, sizeof spoilt, text, bytes, bytes);
      [changed replaceObjectAtIndex: i withObject:
        [NSString stringWithFormat: @"%s%@", spoilt, tail]];
      NSString *scene = [changed componentsJoinedByString: @" "];
      struct load load = load_text([scene UTF8String]);
      if (load.faults > 1)
        {
          printf("# '%s' %s:\n# %s\n", bytes, name,
                 [[load.report stringByReplacingOccurrencesOfString: @"\n"
                                            withString: @"\n# "] UTF8String]);
        }
      most = MAX(most, (unsigned)load.faults);
      [pool release];
    }
  PASS(most == 1, "any word %s: one message at most", name);
}

int
main(void)
{
  NSAutoreleasePool *pool = [[NSAutoreleasePool alloc] init];

  PASS(load_text(good).faults == 0, "the file is good");
  for (unsigned i = 0; i < sizeof changes / sizeof *changes; i++)
    {
      change(changes[i].name, changes[i].text);
    }
  [pool release];
  return test_done();
}
