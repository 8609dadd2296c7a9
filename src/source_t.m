#import "source_t.h"
#include "grow.h"
#include "utf8.h"
#include <errno.h>
#include <fcntl.h>
#include <limits.h>
#include <sys/stat.h>
#include <unistd.h>

#define STEP 512                // bytes between checkpoints
#define CHUNK (1 << 20)         // bytes to read at once

static const char byte_order_mark[] = "\xEF\xBB\xBF";

/** Line and column of a byte. */
struct checkpoint
{
  int line, column;
};

/** Reads until the end or a NUL into memory of its own, with a NUL after it.
    NULL and errno if that cannot be done. */
static char *
read_all(int fd, size_t expected, size_t *size)
{
  size_t capacity = expected + 2, used = 0;
  char *buffer = malloc(capacity);
  ssize_t got = 1;

  while (buffer && got > 0)
    {
      got = read(fd, buffer + used, MIN(capacity - used - 1, CHUNK));
      if (got > 0)
        {
          BOOL has_nul = memchr(buffer + used, '\0', got) != NULL;
          used += got;
          got = has_nul ? 0 : got;
        }
      else if (got < 0 && errno == EINTR)
        {
          got = 1;
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
  char *buffer = read_all(fd, expected, &size);

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

- (id) initWithFile: (NSString *)path error: (NSError **)error
{
  if ((self = [super init]))
    {
      int fd = open([path UTF8String], O_RDONLY | O_CLOEXEC);
      BOOL is_read = fd >= 0 && [self readFrom: fd];
      int reason = errno;

      if (fd >= 0)
        {
          close(fd);
        }
      if (!is_read)
        {
          *error = [NSError errorWithDomain: NSPOSIXErrorDomain code: reason
                                   userInfo: nil];
          [self release];
          return nil;
        }
      name = [path copy];
    }
  return self;
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
