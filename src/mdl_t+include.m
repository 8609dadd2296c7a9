#import "mdl_t.h"
#import "diag_t.h"
#import "errors.h"
#import "fence.h"
#include "grow.h"
#import "path.h"
#include <errno.h>
#include <limits.h>

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
      *path = token_peek(text->cursor);
      if (!token_is_word(*path) || [self isBlockAt: text->cursor])
        {
          text->cursor = here;
          FAULT(*at, @"expected the path of a file to include, found %@",
                [self quote: *path]);
          path->length = 0;
          return NO;
        }
      token_next(&text->cursor);
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

/** After a fault of an include: goes past what may be more of its path, or
    the block that it was meant to be. */
- (void) resumeBehind: (struct token)path
{
  struct cursor behind = text->cursor;
  struct token t = token_next(&behind);

  if (token_is_word(path)
      && (token_is(t, "{") || [store kindFor: path] != KIND_UNKNOWN))
    {
      [self resumeAfter: path];
      return;
    }
  if (token_is_brace(t))
    {
      t = token_peek(behind);
    }
  else
    {
      behind = text->cursor;
    }
  if (token_is_word(t) && ![self isDirective: t]
      && [store kindFor: t] == KIND_UNKNOWN
      && ![self looksLikeBlock: behind])
    {
      token_next(&behind);
      text->cursor = behind;
    }
}

/** Where to look for a file, in this order (autoreleased). */
- (NSArray *) candidates: (NSString *)path
{
  if (path_is_absolute(path))
    {
      return [NSArray arrayWithObject: path];
    }

  NSMutableArray *candidates = [NSMutableArray array];
  NSString *folder = path_folder([text source]->name);

  [candidates addObject: path_in(folder, path)];
  for (folder in include_path)
    {
      [candidates addObject: path_in(folder, path)];
    }
  return candidates;
}

/** Where the file of a path may be: an absolute path names one of the include
    path's folders or is refused. */
- (NSArray *) foldersFor: (NSString *)path
{
  return path_is_absolute(path) ? path_folders : folders;
}

/** The names that could have been meant: files where it was looked for, and
    may be. */
- (NSArray *) neighbours: (NSString *)path
{
  NSMutableArray *names = [NSMutableArray array];
  NSFileManager *manager = [NSFileManager defaultManager];
  NSString *prefix = path_folder(path);

  for (NSString *candidate in [self candidates: path])
    {
      NSString *folder = fence_folder(path_folder(candidate));
      NSArray *found = folder && fence_holds([self foldersFor: path], folder)
        ? [manager contentsOfDirectoryAtPath: folder error: NULL] : nil;
      for (NSString *other in
           [found sortedArrayUsingSelector: @selector(compare:)])
        {
          [names addObject: path_in(prefix, other)];
        }
    }
  return names;
}

/** The file (autoreleased), or nil with a fault. */
- (source_t *) find: (struct token)token at: (const char *)at
{
  if (token.length >= PATH_MAX)
    {
      FAULT(at, @"expected a path of at most %d bytes, found %@",
            PATH_MAX - 1, [self quote: token]);
      return nil;
    }
  NSString *path = token_string(token);
  NSError *error = nil, *reason = nil;
  BOOL isOutside = NO;

  for (NSString *candidate in [self candidates: path])
    {
      source_t *source
        = [[source_t alloc] initWithInclude: candidate
                                         in: [self foldersFor: path]
                                      error: &error];
      if (source)
        {
          return [source autorelease];
        }
      if ([error code] == ENOMEM)
        {
          raise_no_memory(1);
        }
      isOutside |= [error code] == EXDEV;
      if ([error code] != ENOENT && [error code] != ENOTDIR
          && [error code] != EXDEV && reason == nil)
        {
          reason = error;
        }
    }
  if (isOutside)
    {
      FAULT(at, @"expected a file in the scene's folder, %@ lies outside of it;"
            @" 'raytrace --include-path DIR' allows what is in DIR",
            [self quote: token]);
    }
  else if (reason == nil)
    {
      FAULT(at, @"expected a file to include, found none of the name %@%@",
            [self quote: token],
            [self suggest: token among: [self neighbours: path]]);
    }
  else
    {
      FAULT(at, @"expected a file to include, %@ cannot be read: %@",
            [self quote: token], error_text(reason));
    }
  return nil;
}

/** Whether one more file may be included. A fault for the first that may
    not. */
- (BOOL) allowsAnother: (const char *)at
{
  if (include_count < MOST_INCLUDES && [text depth] < DEEPEST_INCLUDE)
    {
      include_count++;
      return YES;
    }
  if (!is_too_much)
    {
      FAULT(at, @"too much to include, expected at most %d files in all and"
            @" %d inside each other", MOST_INCLUDES, DEEPEST_INCLUDE);
    }
  is_too_much = YES;
  return NO;
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
  if (![text hasRoomFor: source] && !is_too_much)
    {
      FAULT(at, @"too much to include, expected less than 4 GB in all");
      is_too_much = YES;
    }
  else if (![text hasRoomAgainFor: source] && !is_too_much)
    {
      FAULT(at, @"too much to include, expected at most 64 MB of files that"
            @" have been included before");
      is_too_much = YES;
    }
  return [text hasRoomFor: source] && [text hasRoomAgainFor: source];
}

- (void) readInclude
{
  NSAutoreleasePool *pool = [NSAutoreleasePool new];
  struct token path = { NULL, 0 };
  const char *at;
  source_t *source = nil;

  if ([self readPath: &path at: &at] && [self allowsAnother: at])
    {
      source = [self find: path at: at];
    }
  if (source == nil || ![self allows: source path: path at: at])
    {
      store->is_partial = YES;
      [self resumeBehind: path];
    }
  else if (![self enter: source from: cursor_order(&text->cursor, at)])
    {
      [text leave];
    }
  [pool drain];
}

- (void) refuseInclude
{
  struct token path = { NULL, 0 };
  const char *at;

  if ([self readPath: &path at: &at])
    {
      FAULT(at, @"include in a block, expected an attribute%@ or '}'",
            [self owner]);
    }
}

@end
