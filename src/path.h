// path.h - paths of files as the system has them: only a slash separates, and
// only a slash in front makes a path absolute. (GNUstep's own methods also
// take a backslash, C: and ~ for something else than letters.)

#ifndef PATH_H
#define PATH_H

#import <Foundation/Foundation.h>

static inline BOOL
path_is_absolute(NSString *path)
{
  return [path hasPrefix: @"/"];
}

/** The folder that a path names its file in, "" if it names none
    (autoreleased). */
static inline NSString *
path_folder(NSString *path)
{
  NSRange slash = [path rangeOfString: @"/" options: NSBackwardsSearch];

  return slash.length == 0 ? @""
    : [path substringToIndex: slash.location ? slash.location : 1];
}

/** The path of a name in a folder, which may be "" (autoreleased). */
static inline NSString *
path_in(NSString *folder, NSString *name)
{
  return [folder length] == 0 ? name
    : [folder hasSuffix: @"/"] ? [folder stringByAppendingString: name]
    : [NSString stringWithFormat: @"%@/%@", folder, name];
}

#endif
