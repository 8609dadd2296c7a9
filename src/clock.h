// clock.h - seconds on a clock that only goes forward.

#ifndef CLOCK_H
#define CLOCK_H

#include <time.h>

static inline double
clock_seconds(void)
{
  struct timespec now;

  clock_gettime(CLOCK_MONOTONIC, &now);
  return now.tv_sec + now.tv_nsec * 1e-9;
}

#endif
