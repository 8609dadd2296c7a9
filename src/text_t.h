// text_t.h - the text of a whole model: its files in the order in which they
// are read, each include in its place. A place in it is one number, its
// order: what comes later in this text has a larger one.

#import "source_t.h"
#include "place.h"
#include "token.h"

@class diag_t;

@interface text_t : NSObject
{
@public
  struct cursor cursor;         // where reading goes on
@protected
  diag_t *diag;                 // not retained: lives as long as the load
  NSMutableArray *sources;
  NSMutableSet *files;          // what sources are of, each once
  size_t repeated;              // bytes of sources that are there again
  unsigned total;               // the orders that all sources need
  struct segment *segments;     // pieces of files, in order
  unsigned segment_count, segment_capacity;
  struct open_file *open_files; // those being read, the innermost last
  unsigned open_count, open_capacity;
}

- (id) init: (diag_t *)diag;

/** Goes on reading at the start of this file, for which there has to be room;
    `includer` is the order of what includes it. */
- (void) enter: (source_t *)source from: (unsigned)includer;

/** Whether there are orders enough for this file: for 4 GB of text in all. */
- (BOOL) hasRoomFor: (source_t *)source;

/** Whether a file that has been read before may be read once more: all such
    take 64 MB at most. */
- (BOOL) hasRoomAgainFor: (source_t *)source;

/** Goes back to the file that includes the one that is being read, behind
    its include. NO if there is none. */
- (BOOL) leave;

/** The file that is being read. */
- (source_t *) source;

/** What part of it has been read: more than 0, at most 1. */
- (double) partRead;

/** How deep its include is nested; 0 for the first file. */
- (unsigned) depth;

/** Whether this file is being read, or one that includes another. */
- (BOOL) isReading: (source_t *)source;

/** The file in which the place of that order is. */
- (source_t *) sourceAt: (unsigned)order;

/** Where the place of that order is. */
- (struct place) placeAt: (unsigned)order;

/** The order of the place after the last character of the first file. Only
    when everything is read. */
- (unsigned) endOfFirst;

/** The bytes of all files (autoreleased, or its own). */
- (NSData *) bytes;

@end
