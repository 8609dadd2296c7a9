// stack.m - media_t: the notes' inside flag as a stack.

#import "support.h"
#include "test.h"

/** The indices from the top down, as text. */
static NSString *
shown(media_t *media)
{
  NSMutableString *text = [NSMutableString string];

  for (; media; media = media->below)
    {
      [text appendFormat: @"%g ", media->ior];
    }
  return text;
}

int
main(void)
{
  NSAutoreleasePool *pool = [[NSAutoreleasePool alloc] init];
  NSObject *a = [[[NSObject alloc] init] autorelease];
  NSObject *b = [[[NSObject alloc] init] autorelease];
  NSObject *c = [[[NSObject alloc] init] autorelease];

  PASS([media_t ior: nil] == 1, "air is 1");
  media_t *in_a = [media_t enter: a : 1.5 over: nil];
  media_t *in_ab = [media_t enter: b : 1.25 over: in_a];
  media_t *in_abc = [media_t enter: c : 2 over: in_ab];
  PASS([media_t ior: in_abc] == 2 && [media_t ior: in_a] == 1.5,
       "the top counts");
  PASS([shown(in_abc) isEqual: @"2 1.25 1.5 "], "the last in is on top");
  PASS([media_t media: in_abc has: a] && [media_t media: in_abc has: c]
       && ![media_t media: in_ab has: c] && ![media_t media: nil has: a],
       "has: finds them all");
  PASS([media_t leave: c from: in_abc] == in_ab, "the top is taken off");
  PASS([shown([media_t leave: b from: in_abc]) isEqual: @"2 1.5 "],
       "one in the middle is taken out");
  PASS([shown([media_t leave: a from: in_abc]) isEqual: @"2 1.25 "],
       "one at the bottom is taken out");
  PASS([shown(in_abc) isEqual: @"2 1.25 1.5 "], "without changing what"
       " others hold");
  PASS([media_t leave: a from: nil] == nil, "nothing to take out of air");
  PASS([media_t leave: c from: in_ab] == in_ab, "what is not in changes"
       " nothing");
  media_t *twice = [media_t enter: a : 1.5 over: in_ab];
  PASS([shown([media_t leave: a from: twice]) isEqual: @"1.25 1.5 "],
       "of two entries the topmost is taken");
  PASS([media_t leave: a from: in_a] == nil, "out of the last one is air");
  [pool release];
  return test_done();
}
