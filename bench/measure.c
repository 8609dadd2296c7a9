/* measure.c - runs a command and says what it took.

   usage: measure LOG COMMAND [ARGUMENT]...

   What the command prints goes to LOG. Prints seconds from start to end,
   seconds of processor, the most memory it had in KiB (as /usr/bin/time
   does) and its exit status. */

#define _GNU_SOURCE
#include <fcntl.h>
#include <stdio.h>
#include <stdlib.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

static double
seconds (struct timeval t)
{
  return t.tv_sec + 1e-6 * t.tv_usec;
}

int
main (int argc, char **argv)
{
  struct timespec start, end;
  struct rusage use;
  int status, log;
  pid_t child;

  if (argc < 3)
    return 2;
  log = open (argv[1], O_WRONLY | O_CREAT | O_TRUNC, 0666);
  if (log < 0)
    {
      perror (argv[1]);
      return 4;
    }
  clock_gettime (CLOCK_MONOTONIC, &start);
  child = fork ();
  if (child == 0)
    {
      int nothing = open ("/dev/null", O_RDONLY);

      dup2 (nothing, 0);
      dup2 (log, 1);
      dup2 (log, 2);
      execvp (argv[2], argv + 2);
      perror (argv[2]);
      _exit (127);
    }
  if (child < 0 || wait4 (child, &status, 0, &use) != child)
    {
      perror ("measure");
      return 4;
    }
  clock_gettime (CLOCK_MONOTONIC, &end);
  printf ("%.6f %.6f %ld %d\n",
          (end.tv_sec - start.tv_sec) + 1e-9 * (end.tv_nsec - start.tv_nsec),
          seconds (use.ru_utime) + seconds (use.ru_stime), use.ru_maxrss,
          WIFEXITED (status) ? WEXITSTATUS (status)
                             : 128 + WTERMSIG (status));
  return 0;
}
