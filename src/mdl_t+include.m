#import "mdl_t.h"
#import "diag_t.h"
#include <errno.h>

// Files of includes of files of includes come to an end here.
#define DEEPEST_INCLUDE 256
#define MOST_INCLUDES 65536

@implementation mdl_t (include)

/** Reads the path after `include`; *at is where it starts, with its quote.
    NO, with a fault, if there is none. */
- (BOOL) readPath: (struct token *)path at: (const char **)at
{
  struct cursor here = text->cursor;

  token_skip_space(&text->cursor);
  *at = text->cursor.at;
  if (**at != '"')
    {
      *path = token_next(&text->cursor);
      if (!token_is_word(*path))
        {
          text->cursor = here;
          FAULT(*at, @"expected the path of a file to include, found %@",
                [self quote: *path]);
          return NO;
        }
      return YES;
    }
  path->at = *at + 1;
  path->length = strcspn(path->at, "\"\n");

  BOOL is_closed = path->at[path->length] == '"';

  text->cursor.at = path->at + path->length + is_closed;
  if (!is_closed || path->length == 0)
    {
      FAULT(*at, is_closed ? @"expected the path of a file to include,"
            @" found \"\"" : @"expected another \" at the end of the path,"
            @" found the end of the line");
      return NO;
    }
  return YES;
}

/** Where to look for a file, in this order (autoreleased). */
- (NSArray *) candidates: (NSString *)path
{
  if ([path isAbsolutePath])
    {
      return [NSArray arrayWithObject: path];
    }

  NSMutableArray *candidates = [NSMutableArray array];
  NSString *folder = [[text source]->name stringByDeletingLastPathComponent];

  [candidates addObject: [folder length] == 0 ? path
    : [folder stringByAppendingPathComponent: path]];
  for (folder in include_path)
    {
      [candidates addObject: [folder stringByAppendingPathComponent: path]];
    }
  return candidates;
}

/** The names that could have been meant: files where it was looked for. */
- (NSArray *) neighbours: (NSString *)path
{
  NSMutableArray *names = [NSMutableArray array];
  NSFileManager *manager = [NSFileManager defaultManager];
  NSString *prefix = [path stringByDeletingLastPathComponent];

  for (NSString *candidate in [self candidates: path])
    {
      NSString *folder = [candidate stringByDeletingLastPathComponent];
      NSArray *found = [manager contentsOfDirectoryAtPath:
        [folder length] ? folder : @"." error: NULL];
      for (NSString *other in
           [found sortedArrayUsingSelector: @selector(compare:)])
        {
          [names addObject: [prefix stringByAppendingPathComponent: other]];
        }
    }
  return names;
}

/** The file (autoreleased), or nil with a fault. */
- (source_t *) find: (struct token)token at: (const char *)at
{
  NSString *path = token_string(token);
  NSError *error = nil, *reason = nil;

  for (NSString *candidate in [self candidates: path])
    {
      source_t *source = [[source_t alloc] initWithFile: candidate
                                                  error: &error];
      if (source)
        {
          return [source autorelease];
        }
      if ([error code] != ENOENT && [error code] != ENOTDIR && reason == nil)
        {
          reason = error;
        }
    }
  if (reason == nil)
    {
      FAULT(at, @"expected a file to include, found none of the name %@%@",
            [self quote: token],
            [self suggest: token among: [self neighbours: path]]);
    }
  else
    {
      FAULT(at, @"expected a file to include, %@ cannot be read: %s",
            [self quote: token], strerror((int)[reason code]));
    }
  return nil;
}

/** Whether one more file may be included; a fault if not. */
- (BOOL) allowsAnother: (const char *)at
{
  if (include_count == MOST_INCLUDES || [text depth] == DEEPEST_INCLUDE)
    {
      FAULT(at, @"too much to include, expected at most %d files in all and"
            @" %d inside each other", MOST_INCLUDES, DEEPEST_INCLUDE);
      return NO;
    }
  include_count++;
  return YES;
}

/** Whether this file may be included here; a fault if not. */
- (BOOL) allows: (source_t *)source path: (struct token)path
             at: (const char *)at
{
  if ([text isReading: source])
    {
      FAULT(at, @"expected another file to include, %@ is being read already",
            [self quote: path]);
      return NO;
    }
  if (![text hasRoomFor: source])
    {
      FAULT(at, @"too much to include, expected less than 4 GB in all");
      return NO;
    }
  return YES;
}

- (void) readInclude
{
  NSAutoreleasePool *pool = [NSAutoreleasePool new];
  struct token path;
  const char *at;
  source_t *source = nil;

  if ([self readPath: &path at: &at] && [self allowsAnother: at])
    {
      source = [self find: path at: at];
    }
  if (source == nil || ![self allows: source path: path at: at])
    {
      store->is_partial = YES;
    }
  else if (![self enter: source from: cursor_order(&text->cursor, at)])
    {
      [text leave];
    }
  [pool drain];
}

- (void) refuseInclude
{
  struct token path;
  const char *at;

  if ([self readPath: &path at: &at])
    {
      FAULT(at, @"include in a block, expected an attribute%@ or '}'",
            [self owner]);
    }
}

@end
