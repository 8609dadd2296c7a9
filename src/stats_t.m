// stats_t.m

#import "stats_t.h"
#include "clock.h"
#include <inttypes.h>

static const char *const phase_names[PHASES] = {
  "load", "build", "trace", "write"
};

/** Seconds to the microsecond, with a point whatever the locale. */
static NSString *
text_of(double seconds)
{
  unsigned long micro = lround(seconds * 1e6);

  return [NSString stringWithFormat: @"%lu.%06lu", micro / 1000000,
                   micro % 1000000];
}

@implementation stats_t

- (id) init
{
  self = [super init];
  if (self)
    {
      mark = clock_seconds();
    }
  return self;
}

- (void) ended: (enum phase)phase
{
  double now = clock_seconds();

  seconds[phase] += now - mark;
  mark = now;
}

- (NSString *) text
{
  NSMutableString *text = [NSMutableString string];
  const struct counters *c = &counters;

  for (int i = 0; i < PHASES; i++)
    {
      [text appendFormat: @"%-11s%16@ s\n", phase_names[i],
            text_of(seconds[i])];
    }
  [text appendFormat: @"eye        %16" PRIu64 " rays\n", c->eye];
  [text appendFormat: @"reflection %16" PRIu64 " rays\n", c->reflection];
  [text appendFormat: @"refraction %16" PRIu64 " rays\n", c->refraction];
  [text appendFormat: @"feeler     %16" PRIu64 " rays\n", c->feeler];
  [text appendFormat: @"tests      %16" PRIu64 "\n", c->tests];
  [text appendFormat: @"escapes    %16" PRIu64 "\n", c->escapes];
  return text;
}

- (NSString *) json
{
  NSMutableString *json = [NSMutableString string];
  const struct counters *c = &counters;

  for (int i = 0; i < PHASES; i++)
    {
      [json appendFormat: @"%s\"%s\": %@", i ? ", " : "{\"seconds\": {",
            phase_names[i], text_of(seconds[i])];
    }
  [json appendFormat: @"}, \"rays\": {\"eye\": %" PRIu64
        ", \"reflection\": %" PRIu64 ", \"refraction\": %" PRIu64
        ", \"feeler\": %" PRIu64 "}, \"tests\": %" PRIu64
        ", \"escapes\": %" PRIu64 "}\n",
        c->eye, c->reflection, c->refraction, c->feeler, c->tests,
        c->escapes];
  return json;
}

@end
