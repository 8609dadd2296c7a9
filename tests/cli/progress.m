// The bar, and the numbers of --stats.

#import "progress_t.h"
#import "stats_t.h"
#include "test.h"
#include <unistd.h>

static void
test_line_of(double done, double seconds, NSString *want)
{
  NSString *line = [progress_t line: done after: seconds];

  PASS([line isEqual: want], "'%s'", [line UTF8String]);
}

static void
test_stats(void)
{
  stats_t *stats = [[[stats_t alloc] init] autorelease];

  usleep(2000);
  [stats ended: PHASE_TRACE];
  PASS(stats->seconds[PHASE_TRACE] >= 0.002, "time passes");
  [stats ended: PHASE_WRITE];
  PASS(stats->seconds[PHASE_WRITE] < stats->seconds[PHASE_TRACE],
       "each phase has its own");
  for (int i = 0; i < PHASES; i++)
    {
      stats->seconds[i] = i + 0.25;
    }
  stats->seconds[PHASE_WRITE] = 12345.0000004;
  stats->counters = (struct counters){ .eye = UINT64_MAX, .reflection = 2,
                                       .refraction = 3, .feeler = 4,
                                       .tests = 5, .escapes = 6 };
  PASS([[stats json] isEqual:
         @"{\"seconds\": {\"load\": 0.250000, \"build\": 1.250000, \"trace\": "
         @"2.250000, \"write\": 12345.000000}, \"rays\": {\"eye\": "
         @"18446744073709551615, \"reflection\": 2, \"refraction\": 3, "
         @"\"feeler\": 4}, \"tests\": 5, \"escapes\": 6}\n"],
       "JSON");
  PASS([[stats text] isEqual:
         @"load               0.250000 s\n"
         @"build              1.250000 s\n"
         @"trace              2.250000 s\n"
         @"write          12345.000000 s\n"
         @"eye        18446744073709551615 rays\n"
         @"reflection                2 rays\n"
         @"refraction                3 rays\n"
         @"feeler                    4 rays\n"
         @"tests                     5\n"
         @"escapes                   6\n"], "text");
}

int
main(void)
{
  NSAutoreleasePool *pool = [[NSAutoreleasePool alloc] init];

  test_line_of(0, 1, @"  0 % [                              ]");
  test_line_of(0.5, 10,
               @" 50 % [###############               ] 0:00:10 left");
  test_line_of(0.25, 1234.5,
               @" 25 % [#######                       ] 1:01:44 left");
  test_line_of(1, 3, @"100 % [##############################] 0:00:00 left");
  test_stats();
  [pool release];
  return test_done();
}
