#import "text_t.h"
#import "diag_t.h"
#include "grow.h"

/** A piece of a file, up to the next segment: the order of its first byte
    and where that is. */
struct segment
{
  unsigned order;
  unsigned source;
  unsigned offset;
};

/** A file that is being read: when it is the innermost, its cursor is
    text_t's. */
struct open_file
{
  unsigned source;
  struct cursor cursor;
};

#define MOST_REPEATED ((size_t)64 << 20)

/** The same for two sources of one file (autoreleased). */
static NSString *
file_of(source_t *source)
{
  return [NSString stringWithFormat: @"%llu %llu",
                   (unsigned long long)source->device,
                   (unsigned long long)source->inode];
}

@implementation text_t

- (id) init: (diag_t *)theDiag
{
  if ((self = [super init]))
    {
      diag = theDiag;
      sources = [NSMutableArray new];
      files = [NSMutableSet new];
    }
  return self;
}

- (void) dealloc
{
  [sources release];
  [files release];
  free(segments);
  free(open_files);
  [super dealloc];
}

- (void) addSegment: (unsigned)order
{
  struct segment segment = {
    order, open_files[open_count - 1].source,
    (unsigned)(cursor.at - cursor.text)
  };

  grow((void **)&segments, segment_count, &segment_capacity, sizeof segment);
  segments[segment_count++] = segment;
}

- (BOOL) hasRoomFor: (source_t *)source
{
  // One more for the place after the last character.
  return source->length < UINT_MAX - total;
}

- (BOOL) hasRoomAgainFor: (source_t *)source
{
  return ![files containsObject: file_of(source)]
    || repeated + source->length <= MOST_REPEATED;
}

- (void) enter: (source_t *)source from: (unsigned)includer
{
  unsigned start = open_count ? cursor_order(&cursor, cursor.at) : 0;
  struct place none = { .file = -1 };

  total += source->length + 1;
  repeated += [files containsObject: file_of(source)] ? source->length : 0;
  [files addObject: file_of(source)];
  source->file = [diag addFile: source->name text: [source characters]
                      includer: open_count ? [self placeAt: includer] : none];
  [sources addObject: source];
  if (open_count)
    {
      open_files[open_count - 1].cursor = cursor;
    }
  grow((void **)&open_files, open_count, &open_capacity, sizeof *open_files);
  cursor.at = cursor.text = source->text;
  cursor.shift = start;
  open_files[open_count++].source = [sources count] - 1;
  [self addSegment: start];
}

- (BOOL) leave
{
  if (open_count == 1)
    {
      return NO;
    }

  source_t *source = [self source];
  unsigned end = cursor.shift + source->length + 1;

  open_count--;
  cursor = open_files[open_count - 1].cursor;
  cursor.shift = end - (unsigned)(cursor.at - cursor.text);
  [self addSegment: end];
  return YES;
}

- (source_t *) source
{
  return [sources objectAtIndex: open_files[open_count - 1].source];
}

- (double) partRead
{
  return (cursor.at - cursor.text + 1) / ([self source]->length + 1.0);
}

- (unsigned) depth
{
  return open_count - 1;
}

- (BOOL) isReading: (source_t *)source
{
  for (unsigned i = 0; i < open_count; i++)
    {
      source_t *other = [sources objectAtIndex: open_files[i].source];
      if (other->device == source->device && other->inode == source->inode)
        {
          return YES;
        }
    }
  return NO;
}

/** The piece of a file in which the place of that order is. */
- (const struct segment *) segmentAt: (unsigned)order
{
  unsigned first = 0, last = segment_count;     // it is in first … last - 1

  while (last - first > 1)
    {
      unsigned middle = first + (last - first) / 2;
      if (segments[middle].order <= order)
        {
          first = middle;
        }
      else
        {
          last = middle;
        }
    }

  return &segments[first];
}

- (source_t *) sourceAt: (unsigned)order
{
  return [sources objectAtIndex: [self segmentAt: order]->source];
}

- (struct place) placeAt: (unsigned)order
{
  const struct segment *segment = [self segmentAt: order];
  source_t *source = [sources objectAtIndex: segment->source];
  struct place place = { .file = source->file, .order = order };

  [source find: segment->offset + (order - segment->order)
          line: &place.line column: &place.column];
  return place;
}

- (unsigned) endOfFirst
{
  return cursor.shift + [self source]->length;
}

- (NSData *) bytes
{
  if ([sources count] == 1)
    {
      return [(source_t *)[sources objectAtIndex: 0] bytes];
    }

  NSMutableData *all = [NSMutableData data];

  for (source_t *source in sources)
    {
      [all appendData: [source bytes]];
    }
  return all;
}

@end
