// outfile_t.h - a file to be written that appears complete or not at all.
//
// It is opened before the work begins, so that a folder that does not exist,
// or that may not be written to, is noticed then. Until the last moment the
// file has no name: whatever ends the program leaves nothing behind, and an
// older file of that name as it was. Where the file system cannot do that,
// the file is made beside its place when it is written, then renamed.
//
// No call gives a nameless file the name of another one. So when an older file
// is replaced, the whole new one has a name beside it between two calls
// (.raytrace-PID-RANDOM.tmp). Signals wait that long; SIGKILL does not.
//
// What is not an ordinary file (a device, a pipe) is written to directly. A
// symbolic link stays; what it points to is replaced.

#import <Foundation/Foundation.h>

@interface outfile_t : NSObject
{
  NSString *path;       // as the user knows it
  NSString *target;     // what it is behind all symbolic links
  mode_t mode;          // permissions, before the umask
  BOOL is_direct;       // a device, a pipe, standard output
  BOOL is_old;          // there is a file now, whose permissions are kept
  int fd;               // -1: is to be made when it is written
}

/** path "-" is standard output. nil with an NSError in *error if it cannot be
    written to. */
- (id) init: (NSString *)path error: (NSError **)error;

/** Writes all the bytes and puts the file in its place. To be called once.
    NO with an NSError in *error if that failed. */
- (BOOL) write: (NSData *)data error: (NSError **)error;

@end
