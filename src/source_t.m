#import "source_t.h"
#import "fence.h"
#include "grow.h"
#include "large.h"
#include "utf8.h"
#include <errno.h>
#include <fcntl.h>
#include <limits.h>
#include <poll.h>
#include <sys/stat.h>
#include <unistd.h>

#define STEP 64                 // bytes between checkpoints
#define CHUNK (1 << 20)         // bytes to read at once
#define PATIENCE 3000           // milliseconds for a pipe to be written to

static const char byte_order_mark[] = "\xEF\xBB\xBF";

/** Line and column of a byte. */
struct checkpoint
{
  int line, column;
};

/** Reads a piece, 0 at the end, as soon as there is one: the file does not
    block. A pipe that has no writer is at its end; *is_awaited: one may come.
    Then, if none does in time, it is -1 and ETIMEDOUT. */
static ssize_t
read_some(int fd, char *buffer, size_t size, BOOL *is_awaited)
{
  struct pollfd ready = { .fd = fd, .events = POLLIN };
  int patience = PATIENCE;

  for (;;)
    {
      ssize_t got = read(fd, buffer, size);

      if (got > 0 || (got == 0 && !*is_awaited)
          || (got < 0 && errno != EINTR && errno != EAGAIN))
        {
          return got;
        }
      if (got == 0 && patience == 0)
        {
          errno = ETIMEDOUT;
          return -1;
        }
      patience = poll(&ready, 1, got < 0 ? -1 : patience) == 0 ? 0 : patience;
      *is_awaited &= !(ready.revents & POLLHUP);
    }
}

/** Reads until the end or a NUL into memory of its own, with a NUL after it.
    NULL and errno if that cannot be done. */
static char *
read_all(int fd, size_t expected, BOOL is_awaited, size_t *size)
{
  size_t capacity = expected + 2, used = 0;
  char *buffer = malloc(capacity);
  ssize_t got = 1;

  if (buffer)
    {
      large_pages(buffer, capacity);
    }
  while (buffer && got > 0)
    {
      got = read_some(fd, buffer + used, MIN(capacity - used - 1, CHUNK),
                      &is_awaited);
      if (got > 0)
        {
          BOOL has_nul = memchr(buffer + used, '\0', got) != NULL;
          used += got;
          got = has_nul ? 0 : got;
          is_awaited = NO;
        }
      if (got < 0 || used >= UINT_MAX)
        {
          errno = got < 0 ? errno : EFBIG;
          free(buffer);
          return NULL;
        }
      if (used + 1 == capacity)
        {
          char *larger = realloc(buffer, capacity *= 2);
          if (larger == NULL)
            {
              free(buffer);
            }
          buffer = larger;
        }
    }
  if (buffer)
    {
      buffer[used] = '\0';
    }
  *size = used;
  return buffer;
}

@implementation source_t

- (BOOL) readFrom: (int)fd
{
  struct stat status;
  size_t size;

  if (fstat(fd, &status) != 0)
    {
      return NO;
    }
  device = status.st_dev;
  inode = status.st_ino;

  size_t expected = S_ISREG(status.st_mode) && status.st_size < UINT_MAX
    ? status.st_size : CHUNK;
  BOOL is_awaited = S_ISFIFO(status.st_mode) && fd != STDIN_FILENO;
  char *buffer = read_all(fd, expected, is_awaited, &size);

  if (buffer == NULL)
    {
      return NO;
    }
  bytes = [[NSData alloc] initWithBytesNoCopy: buffer length: size
                                 freeWhenDone: YES];
  text = buffer;
  if (strncmp(text, byte_order_mark, 3) == 0)
    {
      text += 3;
      size -= 3;
    }
  length = (unsigned)utf8_valid(text, strnlen(text, size));
  is_text = length == size;
  return YES;
}

/** What the operating system's words for an error do not say. */
static NSError *
error_of(int reason)
{
  NSString *text = reason == EINVAL ? @"Not an ordinary file"
    : reason == ETIMEDOUT ? @"Nobody writes to this pipe" : nil;
  NSDictionary *info = text == nil ? nil
    : [NSDictionary dictionaryWithObject: text
                                  forKey: NSLocalizedDescriptionKey];

  return [NSError errorWithDomain: NSPOSIXErrorDomain code: reason
                         userInfo: info];
}

/** Reads what has been opened, unless that failed, and closes it. */
- (id) initWithFile: (int)fd name: (NSString *)path error: (NSError **)error
{
  int reason = errno;

  if ((self = [super init]))
    {
      BOOL is_read = fd >= 0 && [self readFrom: fd];

      reason = fd >= 0 ? errno : reason;
      if (fd > STDIN_FILENO)
        {
          close(fd);
        }
      if (!is_read)
        {
          *error = error_of(reason);
          [self release];
          return nil;
        }
      name = [path copy];
    }
  return self;
}

- (id) initWithScene: (NSString *)path error: (NSError **)error
{
  int fd = [path isEqual: @"-"] ? STDIN_FILENO
    : open([path UTF8String], O_RDONLY | O_CLOEXEC | O_NONBLOCK);

  return [self initWithFile: fd name: path error: error];
}

- (id) initWithInclude: (NSString *)path in: (NSArray *)folders
                 error: (NSError **)error
{
  return [self initWithFile: fence_open(path, folders) name: path
                      error: error];
}

- (void) dealloc
{
  [name release];
  [bytes release];
  free(checkpoints);
  [super dealloc];
}

- (NSData *) bytes
{
  return bytes;
}

- (NSData *) characters
{
  NSUInteger mark = text - (const char *)[bytes bytes];

  return mark == 0 ? bytes
    : [bytes subdataWithRange: NSMakeRange(mark, [bytes length] - mark)];
}

/** Counts from one place to another one after it. */
static void
count(const char *from, const char *to, struct checkpoint *c)
{
  for (; from < to; from++)
    {
      c->column += utf8_is_first(*from);
      if (*from == '\n')
        {
          c->line++;
          c->column = 1;
        }
    }
}

- (void) find: (unsigned)offset line: (int *)line column: (int *)column
{
  while (checkpoint_count <= offset / STEP)
    {
      unsigned n = checkpoint_count;
      struct checkpoint next = { 1, 1 };

      if (n > 0)
        {
          next = checkpoints[n - 1];
          count(text + (n - 1) * STEP, text + n * STEP, &next);
        }
      grow((void **)&checkpoints, n, &checkpoint_capacity, sizeof next);
      checkpoints[checkpoint_count++] = next;
    }

  struct checkpoint here = checkpoints[offset / STEP];

  count(text + offset / STEP * STEP, text + offset, &here);
  *line = here.line;
  *column = here.column;
}

@end
