// one_fault.m - one fault is told once: a good file is spoilt in one place, in
// every place and in many ways, and there is never a second message.

#import "test.h"
#import "load.h"

// Blanks part all words, and line ends from words.
static const char good[] =
  "camera cam { pixeldim 8 6 worlddim 4 3 viewpoint 2 1.5 4 } \n "
  "background 0 0 1 \n "
  "light sun { location 0 9 0 emissivity 1 1 1 falloff 2 } \n "
  "include one_fault.inc \n "
  "material glass { diffuse .1 .1 .1 alpha .9 ior 1.5 } \n "
  "sphere ball { material glass center 1 1 1 radius 2 } \n "
  "plane floor { material chalk normal 0 1 0 point 0 0 0 } \n "
  "material chalk { diffuse 1 1 1 } \n "
  "polygon p { material clay vertex 0 0 0 vertex 1 0 0 vertex 0 1 0 } \n "
  "polygon a { vertex 0 0 0 vertex 0 1 0 vertex 1 0 0 solid rock"
  " material clay } \n "
  "polygon b { solid rock material clay vertex 0 0 0 vertex 1 0 0"
  " vertex 0 0 1 } \n "
  "polygon c { material clay solid rock vertex 0 0 0 vertex 0 0 1"
  " vertex 0 1 0 } \n "
  "polygon d { material clay solid rock vertex 1 0 0 vertex 0 1 0"
  " vertex 0 0 1 } \n "
  "plane back { material clay normal 0 1 0 point 0 0 0 } # the end\n";

/** What takes the place of a token; %s is the token. */
static const struct
{
  const char *name, *text;
} changes[] = {
  { "left out", "" }, { "twice", "%s %s" }, { "with a q", "%sq" },
  { "with a capital Q", "Q%s" }, { "without meaning", "???" },
  { "before a {", "%s {" }, { "before a }", "%s }" },
  { "after a {", "{ %s" }, { "after a }", "} %s" },
  { "after a number", "7 %s" }, { "after a word", "seven %s" },
  { "after a comma", ", %s" }, { "with a comma", "%s," },
  { "before a semicolon", "%s ;" }, { "as a comment", "#%s\n" },
  { "as a number", "7" }, { "as a negative number", "-1" },
  { "as a word", "seven" }, { "as a {", "{" }, { "as a }", "}" },
  { "in another place", NULL }
};

/** The words with number i changed as text says, or with the next one before
    it if that is NULL. */
static NSString *
changed(NSArray *words, NSUInteger i, const char *text)
{
  NSMutableArray *all = [NSMutableArray arrayWithArray: words];
  const char *word = [[words objectAtIndex: i] UTF8String];
  char spoilt[256];

  if (text)
    {
      snprintf(spoilt, sizeof spoilt, text, word, word);
      [all replaceObjectAtIndex: i withObject:
        [NSString stringWithUTF8String: spoilt]];
    }
  else
    {
      NSUInteger next = i + 1;
      while ([[words objectAtIndex: next] isEqual: @"\n"])
        {
          next++;
        }
      [all exchangeObjectAtIndex: i withObjectAtIndex: next];
    }
  return [all componentsJoinedByString: @" "];
}

static void
change(const char *name, const char *text)
{
  NSArray *words = [[NSString stringWithUTF8String: good]
                     componentsSeparatedByString: @" "];
  unsigned most = 0, none = 0;

  for (NSUInteger i = 0; i + 3 < [words count]; i++)
    {
      NSAutoreleasePool *pool = [[NSAutoreleasePool alloc] init];
      if (![[words objectAtIndex: i] isEqual: @"\n"])
        {
          NSString *scene = changed(words, i, text);
          struct load load = load_text([scene UTF8String]);
          if (load.faults > 1)
            {
              printf("# '%s' %s:\n# %s\n",
                     [[words objectAtIndex: i] UTF8String], name,
                     [[load.report stringByReplacingOccurrencesOfString: @"\n"
                                               withString: @"\n# "]
                       UTF8String]);
            }
          most = MAX(most, (unsigned)load.faults);
          none += load.faults == 0;
        }
      [pool release];
    }
  PASS(most == 1, "any word %s: one message at most (%u times none)", name,
       none);
}

/** A whole solid whose faces name it so. */
static NSString *
solid(NSString *a, NSString *b, NSString *c, NSString *d)
{
  return [NSString stringWithFormat: @CAMERA GLASS
    "polygon a { material glass solid %@ vertex 0 0 0 vertex 0 1 0 vertex 1 0"
    " 0 }\npolygon b { material glass solid %@ vertex 0 0 0 vertex 1 0 0"
    " vertex 0 0 1 }\npolygon c { material glass solid %@ vertex 0 0 0 vertex"
    " 0 0 1 vertex 0 1 0 }\npolygon d { material glass solid %@ vertex 1 0 0"
    " vertex 0 1 0 vertex 0 0 1 }\n", a, b, c, d];
}

static void
test_solids(void)
{
  struct load two = load_text([solid(@"rock", @"rock", @"rokc", @"roc")
                                UTF8String]);
  NSString *closed = solid(@"stone", @"stone", @"stone", @"stone");
  NSString *moved = [solid(@"rock", @"stone", @"rock", @"rock")
    stringByReplacingOccurrencesOfString: @"polygon " withString: @"polygon x"];

  moved = [moved stringByReplacingOccurrencesOfString: @" 1"
                                           withString: @" 2"];

  moved = [moved substringFromIndex:
    [moved rangeOfString: @"polygon"].location];

  struct load stray = load_text([[closed stringByAppendingString: moved]
                                  UTF8String]);

  PASS(load_text([closed UTF8String]).model, "a closed solid");
  PASS(two.faults == 2
       && [two.report rangeOfString: @"3:32"].length == 0
       && [two.report rangeOfString: @"'rokc' is not closed"].length
       && [two.report rangeOfString: @"'roc' is not closed"].length,
       "two slips in a solid's name are two faults");
  PASS(stray.faults == 1 && [stray.report rangeOfString:
         @"solid 'stone' is not closed, nor is 'rock' without polygon 'xb';"
          @" did you mean 'rock'?"].length,
       "a face that names a solid which is closed without it");
  PASS(load_text([solid(@"r1", @"r1", @"q2", @"q2") UTF8String]).faults == 2,
       "no name is a slip of the other if they are equally frequent");
}

int
main(void)
{
  NSAutoreleasePool *pool = [[NSAutoreleasePool alloc] init];

  load_write("one_fault.inc", "material clay { ambient 1 1 1 }\n");
  PASS(load_text(good).faults == 0, "the file is good");
  for (unsigned i = 0; i < sizeof changes / sizeof *changes; i++)
    {
      change(changes[i].name, changes[i].text);
    }
  test_solids();
  [pool release];
  return test_done();
}
