#define _GNU_SOURCE     // O_PATH
#import "fence.h"
#include "grow.h"
#include <errno.h>
#include <fcntl.h>
#include <limits.h>
#include <stdio.h>
#include <stdlib.h>
#include <sys/stat.h>
#include <unistd.h>

NSString *
fence_folder(NSString *path)
{
  char *real = realpath([path length] ? [path UTF8String] : ".", NULL);
  NSString *folder = real ? [NSString stringWithUTF8String: real] : nil;

  if (real == NULL && errno == ENOMEM)
    {
      raise_no_memory(1);       // not that there is none
    }
  free(real);
  return folder;
}

BOOL
fence_holds(NSArray *folders, NSString *real)
{
  for (NSString *folder in folders)
    {
      NSString *inside = [folder hasSuffix: @"/"] ? folder
        : [folder stringByAppendingString: @"/"];
      if ([real isEqual: folder] || [real hasPrefix: inside])
        {
          return YES;
        }
    }
  return NO;
}

/** 0, or why what the handle stands for is not to be opened; `name` is the
    handle's own. Asked of the handle and not of the path, which somebody might
    change in between. */
static int
refusal(int handle, const char *name, NSArray *folders)
{
  char real[PATH_MAX + 1];
  ssize_t length = readlink(name, real, PATH_MAX);
  struct stat status;

  if (length < 0 || fstat(handle, &status) != 0)
    {
      return errno;
    }
  real[length] = '\0';
  NSString *place = [NSString stringWithUTF8String: real];
  return !place || !fence_holds(folders, place) ? EXDEV
    : !S_ISREG(status.st_mode) && !S_ISDIR(status.st_mode) ? EINVAL : 0;
}

int
fence_open(NSString *path, NSArray *folders)
{
  int handle = open([path UTF8String], O_PATH | O_CLOEXEC), fd = -1;
  char name[64];

  if (handle < 0)
    {
      return -1;
    }
  snprintf(name, sizeof name, "/proc/self/fd/%d", handle);
  int reason = refusal(handle, name, folders);
  if (reason == 0)
    {
      fd = open(name, O_RDONLY | O_CLOEXEC | O_NONBLOCK);
      reason = errno;
    }
  close(handle);
  errno = reason;
  return fd;
}
