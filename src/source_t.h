// source_t.h - the text of one file, read whole.

#import <Foundation/Foundation.h>
#include <sys/types.h>

@interface source_t : NSObject
{
@public
  NSString *name;       // how messages call the file
  const char *text;     // without a byte order mark
  unsigned length;      // up to the first thing that is no text, or the end
  BOOL is_text;         // that was the end, and text[length] is NUL
  dev_t device;         // these two tell whether it is the same file
  ino_t inode;
  int file;             // diag_t's number for it; set by text_t
  BOOL is_told_again;   // it was included before, and that has been told
@protected
  NSData *bytes;
  struct checkpoint *checkpoints;       // line and column every so many bytes
  unsigned checkpoint_count, checkpoint_capacity;
}

/** Reads a scene: a file, a pipe, or standard input, which "-" is. For somebody
    to write to a named pipe it waits three seconds. nil with an NSError of the
    NSPOSIXErrorDomain in *error if it cannot be read. At a NUL byte, which no
    text has, it stops. */
- (id) initWithScene: (NSString *)path error: (NSError **)error;

/** The same with a file that is included: an ordinary one that lies in one of
    the folders (fence_folder); the error is EXDEV if it lies elsewhere. */
- (id) initWithInclude: (NSString *)path in: (NSArray *)folders
                 error: (NSError **)error;

/** What was read, as it is in the file. */
- (NSData *) bytes;

/** The same without the byte order mark. */
- (NSData *) characters;

/** Line and column (in characters) of the character at an offset, both from
    1; the offset `length` is the place after the last one. */
- (void) find: (unsigned)offset line: (int *)line column: (int *)column;

@end
