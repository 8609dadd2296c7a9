// no_rename.c - preloaded: SIGKILL in the moment before a file takes the place
// of another one.

#include <signal.h>
#include <stdio.h>

int
rename(const char *from, const char *to)
{
  (void)from;
  (void)to;
  return raise(SIGKILL);
}
