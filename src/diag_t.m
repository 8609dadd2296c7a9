#import "diag_t.h"
#include "edit_distance.h"
#include "excerpt.h"

// Of a longer chain of includes only the ends are shown.
#define CHAIN 8

/** A file that messages may be about. */
@interface diag_file_t : NSObject
{
@public
  NSString *name;
  NSData *text;
  struct place includer;
}
@end

@implementation diag_file_t

- (void) dealloc
{
  [name release];
  [text release];
  [super dealloc];
}

@end

@implementation diag_t

- (id) init
{
  if ((self = [super init]))
    {
      files = [NSMutableArray new];
      faults = [fault_list_t new];
      warnings = [fault_list_t new];
    }
  return self;
}

- (void) dealloc
{
  [files release];
  [faults release];
  [warnings release];
  [super dealloc];
}

- (int) addFile: (NSString *)name
           text: (NSData *)text
       includer: (struct place)includer
{
  diag_file_t *file = [[diag_file_t alloc] init];

  file->name = [name copy];
  file->text = [text retain];
  file->includer = includer;
  [files addObject: file];
  [file release];
  return (int)[files count] - 1;
}

static void
add(fault_list_t *list, struct place place, NSString *format, va_list values)
{
  if ([list wants: place.order])
    {
      NSString *message = [[NSString alloc] initWithFormat: format
                                                 arguments: values];
      [list add: message at: place];
      [message release];
    }
}

- (void) fault: (struct place)place : (NSString *)format, ...
{
  va_list values;

  va_start(values, format);
  add(faults, place, format, values);
  va_end(values);
}

- (void) warn: (struct place)place : (NSString *)format, ...
{
  va_list values;

  va_start(values, format);
  add(warnings, place, format, values);
  va_end(values);
}

- (BOOL) wantsFault: (unsigned long)order
{
  return [faults wants: order];
}

- (NSUInteger) faultCount
{
  return faults->count;
}

- (NSString *) nameOf: (struct place)place
{
  diag_file_t *file = [files objectAtIndex: place.file];

  return [NSString stringWithFormat: @"%@:%d:%d", file->name, place.line,
                   place.column];
}

/** Where the file was included, innermost first. */
- (void) appendChainOf: (diag_file_t *)file to: (NSMutableString *)report
{
  NSMutableArray *chain = [NSMutableArray array];

  for (; file->includer.file >= 0;
       file = [files objectAtIndex: file->includer.file])
    {
      [chain addObject: [self nameOf: file->includer]];
    }

  NSUInteger n = [chain count];
  NSString *lead = @"In file included from ";

  for (NSUInteger i = 0; i < n; i++)
    {
      if (n > CHAIN && i == CHAIN / 2)
        {
          i = n - CHAIN / 2;
          [report appendFormat: @"                 ... %lu more ...\n",
                  (unsigned long)(n - CHAIN)];
        }
      [report appendFormat: @"%@%@%@\n", lead, [chain objectAtIndex: i],
              i == n - 1 ? @":" : @","];
      lead = @"                 from ";
    }
}

- (void) append: (fault_list_t *)list as: (NSString *)kind
             to: (NSMutableString *)report
{
  int last_file = -1;

  for (fault_t *fault in list->shown)
    {
      struct place place = fault->place;
      if (place.file < 0)
        {
          [report appendFormat: @"%@: %@\n", kind, fault->message];
          continue;
        }
      diag_file_t *file = [files objectAtIndex: place.file];
      if (place.file != last_file)
        {
          [self appendChainOf: file to: report];
          last_file = place.file;
        }
      [report appendFormat: @"%@: %@: %@\n%@", [self nameOf: place], kind,
              fault->message, excerpt(file->text, place.line, place.column)];
    }

  NSUInteger more = list->count - [list->shown count];

  if (more)
    {
      [report appendFormat: @"%lu more %@%s\n", (unsigned long)more, kind,
              more == 1 ? "" : "s"];
    }
}

- (NSString *) report
{
  NSMutableString *report = [NSMutableString string];

  [self append: faults as: @"error" to: report];
  if (faults->count == 0)
    {
      [self append: warnings as: @"warning" to: report];
    }
  return report;
}

- (void) close
{
  for (diag_file_t *file in files)
    {
      [file->text release];
      file->text = nil;
    }
}

/** Near enough: one slip in three letters. */
+ (NSString *) nearestTo: (NSString *)word among: (NSArray *)words
{
  NSUInteger fewest = NSNotFound;
  NSString *nearest = nil;

  for (NSString *candidate in words)
    {
      NSUInteger longer = MAX([word length], [candidate length]);
      NSUInteger distance = edit_distance(word, candidate, longer / 3);
      if (distance < fewest)
        {
          fewest = distance;
          nearest = candidate;
        }
    }
  return nearest;
}

+ (NSString *) suggestionFor: (NSString *)word among: (NSArray *)words
{
  NSString *nearest = [self nearestTo: word among: words];

  return nearest == nil ? @""
    : [NSString stringWithFormat: @"; did you mean '%@'?", nearest];
}

@end
