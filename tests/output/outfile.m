// Files that appear complete or not at all: in a file system that has files
// without a name, in one that has none, and where they cannot get a name.

#define _GNU_SOURCE     // O_TMPFILE
#import "errors.h"
#import "outfile_t.h"
#include "test.h"
#include <errno.h>
#include <fcntl.h>
#include <signal.h>
#include <stdlib.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <unistd.h>

enum { MISSING_NOTHING, MISSING_NAMELESS, MISSING_LINK };

static int missing;

/** In place of the C library's. */
int
open(const char *path, int flags, ...)
{
  va_list arguments;

  va_start(arguments, flags);
  mode_t mode = va_arg(arguments, mode_t);
  va_end(arguments);
  if (missing == MISSING_NAMELESS && (flags & O_TMPFILE) == O_TMPFILE)
    {
      errno = EOPNOTSUPP;
      return -1;
    }
  return syscall(SYS_openat, AT_FDCWD, path, flags, mode);
}

/** In place of the C library's. */
int
linkat(int fromFolder, const char *from, int toFolder, const char *to,
       int flags)
{
  if (missing == MISSING_LINK)
    {
      errno = ENOENT;
      return -1;
    }
  return syscall(SYS_linkat, fromFolder, from, toFolder, to, flags);
}

static NSString *folder;

static NSString *
in_folder(NSString *name)
{
  return [folder stringByAppendingPathComponent: name];
}

static NSData *
data_of(NSString *text)
{
  return [text dataUsingEncoding: NSUTF8StringEncoding];
}

static NSString *
content_of(NSString *name)
{
  NSData *data = [NSData dataWithContentsOfFile: in_folder(name)];

  return [[[NSString alloc] initWithData: data
                                encoding: NSUTF8StringEncoding] autorelease];
}

static unsigned
mode_of(NSString *name)
{
  struct stat now = { .st_mode = 0 };

  stat([in_folder(name) UTF8String], &now);
  return now.st_mode & 07777;
}

/** All that is in the folder, hidden files too, sorted. */
static NSString *
listing(void)
{
  NSArray *names = [[NSFileManager defaultManager]
                     contentsOfDirectoryAtPath: folder error: NULL];

  return [[names sortedArrayUsingSelector: @selector(compare:)]
           componentsJoinedByString: @" "];
}

static outfile_t *
open_in_folder(NSString *name, NSError **error)
{
  return [[[outfile_t alloc] init: in_folder(name) error: error] autorelease];
}

static void
test_new(void)
{
  outfile_t *file = open_in_folder(@"new", NULL);
  NSString *before = listing();

  PASS([before isEqual: @""], "nothing is there before it is written");
  PASS([file write: data_of(@"text") error: NULL], "it is written");
  PASS([content_of(@"new") isEqual: @"text"], "with its content");
  PASS(mode_of(@"new") == 0640, "and the permissions of the umask");
  PASS([listing() isEqual: @"new"], "and nothing beside it: %s",
       [listing() UTF8String]);
}

static void
test_old(void)
{
  NSString *path = in_folder(@"new");

  chmod([path UTF8String], 0604);
  NSAutoreleasePool *pool = [[NSAutoreleasePool alloc] init];
  open_in_folder(@"new", NULL);
  [pool release];
  PASS([content_of(@"new") isEqual: @"text"],
       "a file that is opened and not written stays as it was");
  outfile_t *file = open_in_folder(@"new", NULL);
  PASS([file write: data_of(@"other") error: NULL], "it is replaced");
  PASS([content_of(@"new") isEqual: @"other"], "by the other content");
  PASS(mode_of(@"new") == 0604, "and keeps its permissions");
  PASS([listing() isEqual: @"new"], "with nothing beside it: %s",
       [listing() UTF8String]);
}

static void
test_links(void)
{
  NSString *link = in_folder(@"link"), *dangling = in_folder(@"dangling");
  NSString *loop = in_folder(@"loop");
  NSError *error = nil;
  struct stat now;

  symlink("new", [link UTF8String]);
  symlink([in_folder(@"made") UTF8String], [dangling UTF8String]);
  symlink("loop", [loop UTF8String]);
  PASS([open_in_folder(@"link", NULL) write: data_of(@"through") error: NULL]
       && [content_of(@"new") isEqual: @"through"],
       "what a symbolic link points to is replaced");
  PASS(lstat([link UTF8String], &now) == 0 && S_ISLNK(now.st_mode),
       "the link stays");
  PASS([open_in_folder(@"dangling", NULL) write: data_of(@"x") error: NULL]
       && [content_of(@"made") isEqual: @"x"],
       "or made, if it is not there");
  BOOL isOpen = open_in_folder(@"loop", &error) != nil;
  PASS(!isOpen && [error_text(error) hasSuffix:
                    @"loop': Too many levels of symbolic links"],
       "a link to itself: %s", [error_text(error) UTF8String]);
  unlink([link UTF8String]);
  unlink([dangling UTF8String]);
  unlink([loop UTF8String]);
  unlink([in_folder(@"made") UTF8String]);
}

static void
test_refused(NSString *path, NSString *reason)
{
  NSError *error = nil;
  outfile_t *file = [[outfile_t alloc] init: path error: &error];
  NSString *want = [NSString stringWithFormat: @"cannot write '%@': %@", path,
                             reason];

  PASS(file == nil && [error code] == STATUS_FILE
       && [error_text(error) isEqual: want], "refused before it is written: "
       "%s", [error_text(error) UTF8String]);
  [file release];
}

static void
test_devices(void)
{
  NSError *error = nil;
  outfile_t *null = [[[outfile_t alloc] init: @"/dev/null" error: NULL]
                      autorelease];
  outfile_t *full = [[[outfile_t alloc] init: @"/dev/full" error: NULL]
                      autorelease];
  struct stat now;

  PASS([null write: data_of(@"text") error: NULL], "/dev/null takes all");
  PASS(stat("/dev/null", &now) == 0 && S_ISCHR(now.st_mode),
       "and is what it was");
  BOOL isWritten = [full write: data_of(@"text") error: &error];
  PASS(!isWritten
       && [error_text(error) isEqual:
            @"cannot write '/dev/full': No space left on device"],
       "/dev/full does not: %s", [error_text(error) UTF8String]);
}

/** No file has room for more than `limit` bytes: as if the disk were full. */
static void
test_full(NSString *name, NSString *before)
{
  NSError *error = nil;
  NSString *listed = listing();
  NSMutableData *data = [NSMutableData dataWithLength: 100000];

  signal(SIGXFSZ, SIG_IGN);
  struct rlimit old, limit;
  getrlimit(RLIMIT_FSIZE, &old);
  limit = (struct rlimit){ 50000, old.rlim_max };
  setrlimit(RLIMIT_FSIZE, &limit);
  BOOL isWritten = [open_in_folder(name, NULL) write: data error: &error];
  setrlimit(RLIMIT_FSIZE, &old);
  PASS(!isWritten && [error_text(error) hasSuffix: @"File too large"],
       "no room for %s: %s", [name UTF8String],
       [error_text(error) UTF8String]);
  PASS([content_of(name) isEqual: before], "it is as it was");
  PASS([listing() isEqual: listed], "and nothing is left beside it: %s",
       [listing() UTF8String]);
}

static void
test_all(void)
{
  test_new();
  test_old();
  test_links();
  test_refused(folder, @"Is a directory");
  test_refused(in_folder(@"none/file"), @"No such file or directory");
  test_refused(in_folder(@"new/file"), @"Not a directory");
  test_devices();
  test_full(@"new", @"through");
  test_full(@"none", @"");
  unlink([in_folder(@"new") UTF8String]);
}

int
main(void)
{
  NSAutoreleasePool *pool = [[NSAutoreleasePool alloc] init];
  static const char *const ways[] = {
    "files without a name", "no such files", "files that cannot be named"
  };
  const char *temporary = getenv("TMP") ? getenv("TMP") : "/tmp";
  char made[4096];

  snprintf(made, sizeof made, "%s/outfile-XXXXXX", temporary);
  folder = [NSString stringWithUTF8String: mkdtemp(made)];
  umask(027);
  for (missing = 0; missing < 3; missing++)
    {
      PASS([listing() isEqual: @""], "%s:", ways[missing]);
      test_all();
    }
  rmdir(made);
  [pool release];
  return test_done();
}
