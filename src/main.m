// main.m - arguments, model, picture, file: job_t does it. Here alone are
// errors told and is the program ended.

#import "diag_t.h"
#import "errors.h"
#import "help.h"
#import "job_t.h"
#import "outfile_t.h"
#import "quality.h"
#include "arithmetic.h"
#include "kernel/k.h"
#include "large.h"
#include "version.h"
#include <errno.h>
#include <fcntl.h>
#include <signal.h>
#include <stdio.h>
#include <unistd.h>

/** Until it is complete nothing has a name (outfile_t), so the program may
    end at any time. */
static void
interrupted(int number)
{
  static const char clear[] = "\r\033[K"; // the bar, the terminal's ^C
  static const char message[] = "raytrace: interrupted\n";

  if (isatty(STDERR_FILENO))
    {
      (void)!write(STDERR_FILENO, clear, sizeof clear - 1);
    }
  (void)!write(STDERR_FILENO, message, sizeof message - 1);
  _exit(128 + number);
}

/** Nothing can be allocated any more. */
static void
lack_memory(void)
{
  static const char message[] = "raytrace: not enough memory\n";

  (void)!write(STDERR_FILENO, message, sizeof message - 1);
  _exit(STATUS_FILE);
}

// Until there is a pool: GNUstep makes what it needs, and nothing else can fail.
static volatile sig_atomic_t is_starting = 1;

/** Foundation raises an exception when memory is short, and so do we (grow.h),
    on whatever thread. */
static void
raised(NSException *exception)
{
  if ([[exception name] isEqual: NSMallocException] || errno == ENOMEM
      || is_starting)
    {
      lack_memory();
    }
  fprintf(stderr, "raytrace: %s\n", [[exception description] UTF8String]);
}

/** libobjc aborts when there is no memory for an object, and other libraries
    use what they were not given: errno still tells why. */
static void
broken(int number)
{
  if (errno == ENOMEM || is_starting)
    {
      lack_memory();
    }
  signal(number, SIG_DFL);
}

/** A closed pipe and a file that grows too large are errors of write. A
    signal that our caller ignores (nohup) stays ignored. */
static void
handle_signals(void)
{
  static const int ends[] = { SIGINT, SIGTERM, SIGHUP };

  signal(SIGPIPE, SIG_IGN);
  signal(SIGXFSZ, SIG_IGN);
  signal(SIGABRT, broken);
  signal(SIGSEGV, broken);
  signal(SIGBUS, broken);
  for (unsigned i = 0; i < sizeof ends / sizeof *ends; i++)
    {
      if (signal(ends[i], interrupted) == SIG_IGN)
        {
          signal(ends[i], SIG_IGN);
        }
    }
}

/** If a standard file is closed, no other may get its number, and writing to
    it has to fail. */
static void
keep_standard_files(void)
{
  for (int fd = STDIN_FILENO; fd <= STDERR_FILENO; fd++)
    {
      if (fcntl(fd, F_GETFD) < 0)
        {
          (void)!open("/dev/null", fd == STDIN_FILENO ? O_WRONLY : O_RDONLY);
        }
    }
}

static void
tell(NSString *text)
{
  fprintf(stderr, "raytrace: %s\n", [text UTF8String]);
}

static int
fail(NSError *error)
{
  tell(error_text(error));
  return (int)[error code];
}

static int
show(NSString *text)
{
  NSData *data = [text dataUsingEncoding: NSUTF8StringEncoding];
  NSError *error = nil;
  outfile_t *out = [[[outfile_t alloc] init: @"-" error: &error] autorelease];

  return [out write: data error: &error] ? STATUS_DONE : fail(error);
}

/** Tells what there is to tell of the scene; the status if it has faults. */
static int
report(job_t *job, const struct settings *settings)
{
  BOOL hasFaults = [job->diag faultCount] > 0;

  if (hasFaults || !settings->quiet)
    {
      fputs([[job->diag report] UTF8String], stderr);
    }
  [job->diag close];
  return hasFaults ? STATUS_SCENE : STATUS_DONE;
}

static int
run(job_t *job, const struct settings *settings)
{
  NSError *error = nil;

  if (arithmetic_fault())
    {
      tell([NSString stringWithFormat: @"this machine's arithmetic %s: the"
                     @" picture would be another one", arithmetic_fault()]);
      return STATUS_FILE;
    }
  if (![job open: &error])
    {
      return fail(error);
    }
  BOOL isLoaded = [job load: &error];
  if (report(job, settings) != STATUS_DONE)
    {
      return STATUS_SCENE;
    }
  if (!isLoaded)
    {
      return fail(error);
    }
  if (settings->verbose)
    {
      tell([job summary]);
    }
  BOOL isDone = settings->check || settings->format_scene
    || (settings->plan ? [job plan: &error] : [job trace: &error]);
  if (!isDone)
    {
      return fail(error);
    }
  if (job->nanCount > 0 && !settings->quiet)
    {
      tell([NSString stringWithFormat: @"warning: %lu numbers of the picture "
                     @"were not a number (NaN); they are 0 now",
                     (unsigned long)job->nanCount]);
    }
  if (!settings->check && ![job write: &error])
    {
      return fail(error);
    }
  if (settings->stats)
    {
      fputs([settings->stats == STATS_JSON ? [job->stats json]
              : [job->stats text] UTF8String], stderr);
    }
  return STATUS_DONE;
}

int
main(int argc, char **argv)
{
  large_give_back();
  keep_standard_files();
  handle_signals();
  NSSetUncaughtExceptionHandler(raised);
  NSAutoreleasePool *pool = [[NSAutoreleasePool alloc] init];
  // A thread that made it, and could not, would keep the runtime's lock.
  [NSNotificationCenter defaultCenter];
  is_starting = 0;
  options_t *options = [[[options_t alloc] init] autorelease];
  NSString *wrong = [options read: argc : argv];
  int status;

  if (wrong)
    {
      tell(wrong);
      status = STATUS_USAGE;
    }
  else if (options->settings.help)
    {
      status = show(help_text());
    }
  else if (options->settings.show_quality)
    {
      status = show(quality_text());
    }
  else if (options->settings.version)
    {
      status = show([NSString stringWithFormat: @"raytrace %s\n"
                              @"instructions of the fast engine: %s\n",
                              RAYTRACE_VERSION, k_isa_best()]);
    }
  else
    {
      job_t *job = [[[job_t alloc] init: options] autorelease];
      status = run(job, &options->settings);
    }
  if (status != STATUS_DONE)
    {
      [pool release];   // what is not complete is removed
    }
  return status;        // a large scene goes faster with the program
}
