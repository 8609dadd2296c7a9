// machine.m

#define _GNU_SOURCE     // sched_getaffinity
#import "machine.h"
#import "path.h"
#include <limits.h>
#include <math.h>
#include <sched.h>
#include <stdio.h>
#include <sys/resource.h>
#include <unistd.h>

unsigned
machine_cores(void)
{
  cpu_set_t cores;

  return sched_getaffinity(0, sizeof cores, &cores) == 0
    ? (unsigned)CPU_COUNT(&cores) : 1;
}

/** The number in a file; infinite if there is none. */
static double
number_in(const char *path)
{
  FILE *file = fopen(path, "r");
  unsigned long long number;
  BOOL is_there = file && fscanf(file, "%llu", &number) == 1;

  if (file)
    {
      fclose(file);
    }
  return is_there ? number : INFINITY;
}

double
machine_memory(void)
{
  // What a container may have, as it is seen from inside: cgroups 2 and 1.
  const double container
    = fmin(number_in("/sys/fs/cgroup/memory.max"),
           number_in("/sys/fs/cgroup/memory/memory.limit_in_bytes"));
  double memory = (double)sysconf(_SC_PHYS_PAGES) * sysconf(_SC_PAGESIZE);
  struct rlimit limit;

  if (getrlimit(RLIMIT_AS, &limit) == 0 && limit.rlim_cur != RLIM_INFINITY
      && (double)limit.rlim_cur < memory)
    {
      memory = limit.rlim_cur;
    }
  return fmin(memory, container);
}

NSArray *
machine_models(void)
{
  static NSString *const places[] = {
    @"../share/raytrace/models", @"../models", @"../../models"
  };
  NSMutableArray *found = [NSMutableArray array];
  char program[PATH_MAX + 1];
  ssize_t length = readlink("/proc/self/exe", program, PATH_MAX);

  program[length > 0 ? length : 0] = '\0';
  NSString *folder = path_folder([NSString stringWithUTF8String: program]);
  for (unsigned i = 0; i < sizeof places / sizeof *places; i++)
    {
      NSString *models = path_in(folder, places[i]);
      if (access([models UTF8String], R_OK) == 0)
        {
          [found addObject: models];
        }
    }
  return found;
}
