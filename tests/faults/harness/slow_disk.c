// slow_disk.c - preloaded: files are written in pieces of 64 KB, with a pause
// before each and before and behind whatever else is done to a file, so that
// there is time between any two system calls.

#define _GNU_SOURCE
#include <dlfcn.h>
#include <stdio.h>
#include <unistd.h>

#define PIECE 65536
#define PAUSE 2000              // microseconds

/** What is called so behind this file. */
#define THEIRS(name) ((__typeof__(&name))dlsym(RTLD_NEXT, #name))

/** Its result, with a pause before and behind. */
#define SLOWLY(call) \
  ({ usleep(PAUSE); __typeof__(call) result = call; usleep(PAUSE); result; })

ssize_t
write(int fd, const void *bytes, size_t count)
{
  if (fd > STDERR_FILENO)
    {
      usleep(PAUSE);
      count = count < PIECE ? count : PIECE;
    }
  return THEIRS(write)(fd, bytes, count);
}

int
fsync(int fd)
{
  return SLOWLY(THEIRS(fsync)(fd));
}

int
linkat(int from, const char *old, int to, const char *new, int flags)
{
  return SLOWLY(THEIRS(linkat)(from, old, to, new, flags));
}

int
rename(const char *old, const char *new)
{
  return SLOWLY(THEIRS(rename)(old, new));
}
