// slow_pipe.c - slow_pipe MILLISECONDS COMMAND...: runs the command with a
// pipe for standard output that does not block the writer, and begins to empty
// it, to its own standard output, that much later. Its exit status is that of
// the command.

#include <fcntl.h>
#include <stdio.h>
#include <stdlib.h>
#include <sys/wait.h>
#include <unistd.h>

int
main(int argc, char **argv)
{
  char bytes[4096];
  int ends[2], status;
  ssize_t count;

  if (argc < 3 || pipe(ends) != 0
      || fcntl(ends[1], F_SETFL, O_NONBLOCK | O_WRONLY) != 0)
    {
      perror("slow_pipe");
      return 125;
    }
  pid_t child = fork();
  if (child == 0)
    {
      dup2(ends[1], STDOUT_FILENO);
      close(ends[0]);
      close(ends[1]);
      execvp(argv[2], argv + 2);
      _exit(126);
    }
  close(ends[1]);
  usleep(1000 * atoi(argv[1]));
  while ((count = read(ends[0], bytes, sizeof bytes)) > 0)
    {
      if (write(STDOUT_FILENO, bytes, count) != count)
        {
          return 125;
        }
    }
  waitpid(child, &status, 0);
  return WIFEXITED(status) ? WEXITSTATUS(status) : 124;
}
