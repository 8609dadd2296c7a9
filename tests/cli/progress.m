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
  stats->counters = (struct counters){ .eye = UINT64_MAX - 100,
                                       .reflection = 2, .refraction = 3,
                                       .feeler = 4, .tests = 5,
                                       .escapes = 6, .compensated = 7,
                                       .ties = 8, .critical = 9,
                                       .unbalanced = 10 };
  PASS([[stats json] isEqual:
         @"{\"seconds\": {\"load\": 0.250000, \"build\": 1.250000, \"trace\": "
         @"2.250000, \"write\": 12345.000000}, \"rays\": {\"eye\": "
         @"18446744073709551515, \"reflection\": 2, \"refraction\": 3, "
         @"\"feeler\": 4}, \"tests\": 5, \"escapes\": 6, "
         @"\"compensated\": 7, \"ties\": 8, \"critical\": 9, "
         @"\"unbalanced\": 10, "
         @"\"rays_per_second\": 8198552921648689152}\n"],
       "JSON");
  PASS([[stats text] isEqual:
         @"load               0.250000 s\n"
         @"build              1.250000 s\n"
         @"trace              2.250000 s\n"
         @"write          12345.000000 s\n"
         @"eye        18446744073709551515 rays\n"
         @"reflection                2 rays\n"
         @"refraction                3 rays\n"
         @"feeler                    4 rays\n"
         @"tests                     5\n"
         @"escapes                   6\n"
         @"compensated               7\n"
         @"ties                      8\n"
         @"critical                  9\n"
         @"unbalanced               10\n"
         @"speed      8198552921648689152 rays/s\n"], "text");

  stats->counters = (struct counters){ .eye = 4, .tests = 6, .nodes = 10 };
  stats->scene = (struct k_facts){ .nodes = 7, .depth = 3, .cost = 1.5,
                                   .bytes = 4096, .isa = "base" };
  PASS([[stats json] hasSuffix:
         @", \"nodes\": 10, \"nodes_per_ray\": 2.500000, \"tests_per_ray\": "
         @"1.500000, \"tree\": {\"nodes\": 7, \"depth\": 3, \"cost\": "
         @"1.500000, \"bytes\": 4096, \"isa\": \"base\"}}\n"],
       "JSON of the fast engine");
  PASS([[stats text] hasSuffix:
         @"nodes              2.500000 per ray\n"
         @"tests              1.500000 per ray\n"
         @"tree                      7 nodes, 3 deep, cost 1.500000\n"
         @"scene                  4096 bytes\n"],
       "text of the fast engine");
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
