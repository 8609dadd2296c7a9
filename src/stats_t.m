// stats_t.m

#import "stats_t.h"
#include "clock.h"
#include "number.h"
#include <float.h>
#include <inttypes.h>

static const char *const phase_names[PHASES] = {
  "load", "build", "trace", "write"
};

/** Six digits behind the point, whatever the locale. */
static NSString *
text_of(double number)
{
  unsigned long micro = lround(number * 1e6);

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

- (void) errorsOf: (image_t *)image
{
  const double *errors = image->planes[PLANE_TRUNCATION];
  size_t count = (size_t)[image width] * [image height];
  double most = 0, sum = 0;

  has_truncation = errors != NULL;
  for (size_t i = 0; errors && i < count; i++)
    {
      most = MAX(most, errors[i]);
      sum += errors[i];
    }
  truncation_most = most;
  truncation_mean = sum / count;
}

/** A number that may be infinite (autoreleased): as JSON has none, the largest
    double stands for it. */
static NSString *
error_text_of(double error)
{
  char text[32];
  locale_t c = newlocale(LC_ALL_MASK, "C", (locale_t)0);

  number_write(MIN(error, DBL_MAX), c, text);
  freelocale(c);
  return [NSString stringWithUTF8String: text];
}

/** 0 when nothing was traced. */
- (double) perRay: (uint64_t)count
{
  uint64_t rays = counters_rays(&counters);

  return rays ? (double)count / rays : 0;
}

- (double) raysPerSecond
{
  double t = seconds[PHASE_TRACE];

  return t > 0 ? counters_rays(&counters) / t : 0;
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
  [text appendFormat: @"compensated%16" PRIu64 "\n", c->compensated];
  [text appendFormat: @"ties       %16" PRIu64 "\n", c->ties];
  [text appendFormat: @"critical   %16" PRIu64 "\n", c->critical];
  [text appendFormat: @"unbalanced %16" PRIu64 "\n", c->unbalanced];
  [text appendFormat: @"speed      %16.0f rays/s\n", [self raysPerSecond]];
  if (has_truncation)
    {
      [text appendFormat: @"truncation %16@ at most, mean %@\n",
            error_text_of(truncation_most), error_text_of(truncation_mean)];
    }
  if (scene.isa)
    {
      [text appendFormat: @"nodes      %16@ per ray\n",
            text_of([self perRay: c->nodes])];
      [text appendFormat: @"tests      %16@ per ray\n",
            text_of([self perRay: c->tests])];
      [text appendFormat: @"tree       %16u nodes, %u deep, cost %@\n",
            scene.nodes, scene.depth, text_of(scene.cost)];
      [text appendFormat: @"scene      %16zu bytes\n", scene.bytes];
    }
  if (noise.pixels)
    {
      [text appendFormat: @"noise      %16" PRIu64 " pixels\n", noise.pixels];
      [text appendFormat: @"           %16" PRIu64 " rays through them\n",
            noise.rays];
      [text appendFormat: @"           %16@ largest stated error\n",
            error_text_of(noise.largest)];
      [text appendFormat: @"           %16@ root of their mean square\n",
            error_text_of(noise.rms)];
      [text appendFormat: @"           %16" PRIu64 " pixels above the limit\n",
            noise.capped];
    }
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
        ", \"escapes\": %" PRIu64 ", \"compensated\": %" PRIu64
        ", \"ties\": %" PRIu64 ", \"critical\": %" PRIu64
        ", \"unbalanced\": %" PRIu64 ", \"rays_per_second\": %.0f",
        c->eye, c->reflection, c->refraction, c->feeler, c->tests,
        c->escapes, c->compensated, c->ties, c->critical, c->unbalanced,
        [self raysPerSecond]];
  if (scene.isa)
    {
      [json appendFormat: @", \"nodes\": %" PRIu64 ", \"nodes_per_ray\": %@"
            @", \"tests_per_ray\": %@, \"tree\": {\"nodes\": %u,"
            @" \"depth\": %u, \"cost\": %@, \"bytes\": %zu,"
            @" \"isa\": \"%s\"}", c->nodes,
            text_of([self perRay: c->nodes]),
            text_of([self perRay: c->tests]), scene.nodes, scene.depth,
            text_of(scene.cost), scene.bytes, scene.isa];
    }
  if (has_truncation)
    {
      [json appendFormat: @", \"error\": {\"truncation\": {\"most\": %@,"
            @" \"mean\": %@}}", error_text_of(truncation_most),
            error_text_of(truncation_mean)];
    }
  if (noise.pixels)
    {
      [json appendFormat: @", \"noise\": {\"pixels\": %" PRIu64
            @", \"rays\": %" PRIu64 @", \"largest\": %@, \"rms\": %@,"
            @" \"capped\": %" PRIu64 "}", noise.pixels, noise.rays,
            error_text_of(noise.largest), error_text_of(noise.rms),
            noise.capped];
    }
  [json appendString: @"}\n"];
  return json;
}

@end
