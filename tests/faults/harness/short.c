// short.c - preloaded: the allocation number $FAIL_AT of the program, counted
// from where main begins, fails; 0: none does, and the number of all is written
// to the file $FAIL_COUNT at the end.

#define _GNU_SOURCE
#include <dlfcn.h>
#include <errno.h>
#include <stdio.h>
#include <stdlib.h>

void *__libc_malloc(size_t);
void *__libc_calloc(size_t, size_t);
void *__libc_realloc(void *, size_t);
void *__libc_memalign(size_t, size_t);

static long count, fail_at;
static int is_on;

static int
fails(void)
{
  if (is_on && __atomic_add_fetch(&count, 1, __ATOMIC_RELAXED) == fail_at)
    {
      errno = ENOMEM;
      return 1;
    }
  return 0;
}

void *
malloc(size_t size)
{
  return fails() ? NULL : __libc_malloc(size);
}

void *
calloc(size_t n, size_t size)
{
  return fails() ? NULL : __libc_calloc(n, size);
}

void *
realloc(void *old, size_t size)
{
  return fails() ? NULL : __libc_realloc(old, size);
}

void *
aligned_alloc(size_t unit, size_t size)
{
  return fails() ? NULL : __libc_memalign(unit, size);
}

static int (*their_main)(int, char **, char **);

static int
main_begins(int argc, char **argv, char **environment)
{
  fail_at = getenv("FAIL_AT") ? atol(getenv("FAIL_AT")) : 0;
  is_on = 1;
  return their_main(argc, argv, environment);
}

/** What calls main is called with ours instead. */
int
__libc_start_main(int (*main)(int, char **, char **), int argc, char **argv,
                  void (*init)(void), void (*fini)(void),
                  void (*linker_fini)(void), void *stack_end)
{
  int (*real)(int (*)(int, char **, char **), int, char **, void (*)(void),
              void (*)(void), void (*)(void), void *)
    = dlsym(RTLD_NEXT, "__libc_start_main");

  their_main = main;
  return real(main_begins, argc, argv, init, fini, linker_fini, stack_end);
}

static __attribute__((destructor)) void
end(void)
{
  FILE *out = getenv("FAIL_COUNT") ? fopen(getenv("FAIL_COUNT"), "w") : NULL;

  is_on = 0;
  if (out)
    {
      fprintf(out, "%ld\n", count);
      fclose(out);
    }
}
