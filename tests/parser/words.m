// words.m - which words are near enough to be suggested.

#import "test.h"
#import "load.h"
#include "edit_distance.h"

static void
test_distance(void)
{
  static const struct
  {
    const char *a, *b;
    NSUInteger distance;
  } cases[] = {
    { "", "", 0 }, { "a", "", 1 }, { "sphere", "sphere", 0 },
    { "spere", "sphere", 1 }, { "ssphere", "sphere", 1 },
    { "sphhere", "sphere", 1 }, { "spehre", "sphere", 1 },
    { "psheer", "sphere", 2 }, { "SPHERE", "sphere", 0 },
    { "kitten", "sitting", 3 }, { "ca", "abc", 3 }, { "gr\xC3\xBCn",
      "gr\xC3\xB6n", 1 },
  };

  for (unsigned i = 0; i < sizeof cases / sizeof *cases; i++)
    {
      NSString *a = [NSString stringWithUTF8String: cases[i].a];
      NSString *b = [NSString stringWithUTF8String: cases[i].b];
      PASS(edit_distance(a, b, 9) == cases[i].distance
           && edit_distance(b, a, 9) == cases[i].distance,
           "%lu slips from '%s' to '%s'", (unsigned long)cases[i].distance,
           cases[i].a, cases[i].b);
    }
  PASS(edit_distance(@"kitten", @"sitting", 2) == NSNotFound,
       "more than asked for is not found");
  PASS(edit_distance([@"" stringByPaddingToLength: 1000 withString: @"x"
                                  startingAtIndex: 0], @"x", 2000)
       == NSNotFound, "very long words are not compared");
}

static void
test_suggestion(void)
{
  static const struct
  {
    const char *word, *suggestion;
  } cases[] = {
    { "glas", "; did you mean 'glass'?" },
    { "galss", "; did you mean 'glass'?" },
    { "Glass", "; did you mean 'glass'?" },
    { "gren", "; did you mean 'green'?" },
    { "grey", "; did you mean 'gray'?" },
    { "chrom", "; did you mean 'chrome'?" },
    { "wood", "" }, { "x", "" }, { "g", "" }, { "", "" },
    { "R", "; did you mean 'r'?" },
  };
  NSArray *words = [NSArray arrayWithObjects: @"glass", @"green", @"gray",
                            @"chrome", @"r", nil];

  for (unsigned i = 0; i < sizeof cases / sizeof *cases; i++)
    {
      NSString *word = [NSString stringWithUTF8String: cases[i].word];
      PASS(is_text([diag_t suggestionFor: word among: words],
                   cases[i].suggestion),
           "for '%s': '%s'", cases[i].word, cases[i].suggestion);
    }
  PASS([[diag_t suggestionFor: @"x" among: [NSArray array]] length] == 0,
       "nothing among no words");
  PASS(is_text([diag_t suggestionFor: @"aac" among:
                 [NSArray arrayWithObjects: @"aab", @"aaa", nil]],
               "; did you mean 'aab'?"), "the first of two that are as near");
}

int
main(void)
{
  NSAutoreleasePool *pool = [[NSAutoreleasePool alloc] init];

  test_distance();
  test_suggestion();
  [pool release];
  return test_done();
}
