// outfile_t.m

#define _GNU_SOURCE     // O_TMPFILE
#import "outfile_t.h"
#import "errors.h"
#import "path.h"
#include <errno.h>
#include <fcntl.h>
#include <poll.h>
#include <limits.h>
#include <pthread.h>
#include <signal.h>
#include <stdio.h>
#include <string.h>
#include <sys/random.h>
#include <sys/stat.h>
#include <unistd.h>

/** What a path is behind all symbolic links; it need not exist. nil with
    errno when they go round in circles. */
static NSString *
follow(NSString *path)
{
  char next[PATH_MAX + 1];
  ssize_t length;

  for (int links = 0;
       path && (length = readlink([path UTF8String], next, PATH_MAX)) >= 0;
       links++)
    {
      next[length] = '\0';
      NSString *there = [NSString stringWithUTF8String: next];
      path = links >= 40 || there == nil ? nil
        : path_is_absolute(there) ? there : path_in(path_folder(path), there);
      errno = ELOOP;
    }
  return path;
}

static NSString *
folder_of(NSString *path)
{
  NSString *folder = path_folder(path);

  return [folder length] ? folder : @".";
}

/** Writes all of it; waits for a pipe that is full, also when it was opened
    not to block. NO: errno says why. */
static BOOL
write_all(int fd, NSData *data)
{
  const char *bytes = [data bytes];
  size_t left = [data length];

  while (left > 0)
    {
      ssize_t count = write(fd, bytes, left);
      if (count < 0 && errno == EAGAIN)
        {
          struct pollfd room = { .fd = fd, .events = POLLOUT };
          poll(&room, 1, -1);
        }
      else if (count < 0 && errno != EINTR)
        {
          return NO;
        }
      if (count > 0)
        {
          bytes += count;
          left -= count;
        }
    }
  return YES;
}

@implementation outfile_t

- (BOOL) fail: (NSError **)error
{
  int reason = errno;

  if (error)
    {
      NSString *name = [path isEqual: @"-"] ? @"to standard output"
        : [NSString stringWithFormat: @"'%@'", path];
      *error = error_saying(STATUS_FILE, @"cannot write %@: %s", name,
                            strerror(reason));
    }
  return NO;
}

- (BOOL) close
{
  int closing = fd;

  fd = -1;
  return closing < 0 || close(closing) == 0;
}

/** A name in the target's folder for the moment before it is renamed. */
- (NSString *) nameBeside
{
  uint64_t random = 0;

  (void)!getrandom(&random, sizeof random, 0);
  NSString *name = [NSString stringWithFormat: @".raytrace-%d-%llx.tmp",
                             getpid(), (unsigned long long)random];
  return path_in(folder_of(target), name);
}

/** An ordinary file, or none yet: opened without a name. Where that cannot be
    done, makes a file with a name and removes it, to see that it can. */
- (BOOL) openNameless
{
  fd = open([folder_of(target) UTF8String], O_TMPFILE | O_WRONLY | O_CLOEXEC,
            mode);
  if (fd < 0 && (errno == EOPNOTSUPP || errno == EISDIR || errno == EINVAL))
    {
      const char *name = [[self nameBeside] UTF8String];
      int probe = open(name, O_CREAT | O_EXCL | O_WRONLY | O_CLOEXEC, mode);
      return probe >= 0 && unlink(name) == 0 && close(probe) == 0;
    }
  return fd >= 0;
}

- (BOOL) open
{
  struct stat now;

  if ([path isEqual: @"-"])
    {
      is_direct = YES;
      fd = dup(STDOUT_FILENO);
      return fd >= 0;
    }
  if ([path hasSuffix: @"/"])
    {
      errno = EISDIR;
      return NO;
    }
  target = [follow(path) copy];
  if (target == nil)
    {
      return NO;
    }
  mode = 0666;
  if (stat([target UTF8String], &now) < 0)
    {
      return errno == ENOENT && [self openNameless];
    }
  if (S_ISDIR(now.st_mode))
    {
      errno = EISDIR;
      return NO;
    }
  is_direct = !S_ISREG(now.st_mode);
  if (is_direct)
    {
      fd = open([target UTF8String], O_WRONLY | O_CLOEXEC);
      return fd >= 0;
    }
  is_old = YES;
  mode = now.st_mode & 0777;
  return access([target UTF8String], W_OK) == 0 && [self openNameless];
}

- (id) init: (NSString *)name error: (NSError **)error
{
  self = [super init];
  if (self)
    {
      path = [name copy];
      fd = -1;
      if (![self open])
        {
          [self fail: error];
          [self release];
          return nil;
        }
    }
  return self;
}

- (void) dealloc
{
  [self close];
  [path release];
  [target release];
  [super dealloc];
}

/** Writes an ordinary file's bytes and sees that they are on the disk. */
- (BOOL) fillFile: (NSData *)data
{
  if (is_old)
    {
      fchmod(fd, mode); // some file systems have no permissions
    }
  return write_all(fd, data) && fsync(fd) == 0;
}

/** Gives the nameless file its name. There is no call that does so in place of
    another file, so then it gets a name beside it first: *beside. */
- (BOOL) link: (NSString **)beside
{
  char nameless[64];

  snprintf(nameless, sizeof nameless, "/proc/self/fd/%d", fd);
  if (linkat(AT_FDCWD, nameless, AT_FDCWD, [target UTF8String],
             AT_SYMLINK_FOLLOW) == 0)
    {
      return YES;
    }
  *beside = [self nameBeside];
  return errno == EEXIST
    && linkat(AT_FDCWD, nameless, AT_FDCWD, [*beside UTF8String],
              AT_SYMLINK_FOLLOW) == 0;
}

/** Makes a file with a name. */
- (BOOL) make: (NSString *)name with: (NSData *)data
{
  [self close];
  fd = open([name UTF8String], O_CREAT | O_EXCL | O_WRONLY | O_CLOEXEC, mode);
  return fd >= 0 && [self fillFile: data] && [self close];
}

/** All that happens while there is a file under a name not its own. */
- (BOOL) place: (NSData *)data
{
  NSString *beside = nil;
  BOOL isPlaced = fd >= 0 && [self link: &beside];

  if (!isPlaced)
    {
      beside = [self nameBeside];
      isPlaced = [self make: beside with: data];
    }
  if (isPlaced && beside)
    {
      isPlaced = rename([beside UTF8String], [target UTF8String]) == 0;
    }
  if (!isPlaced)
    {
      int reason = errno;
      unlink([beside UTF8String]);
      errno = reason;
    }
  return isPlaced;
}

- (BOOL) write: (NSData *)data error: (NSError **)error
{
  sigset_t all, before;

  if (is_direct)
    {
      return (write_all(fd, data) && [self close]) || [self fail: error];
    }
  if (fd >= 0 && ![self fillFile: data])
    {
      return [self fail: error];
    }
  sigfillset(&all);
  pthread_sigmask(SIG_BLOCK, &all, &before);
  BOOL isPlaced = [self place: data] || [self fail: error];
  pthread_sigmask(SIG_SETMASK, &before, NULL);
  return isPlaced;
}

@end
