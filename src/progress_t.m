// progress_t.m

#import "progress_t.h"
#include "clock.h"
#include <stdio.h>

enum { PHASE_SHOWN, PHASE_STOPPING, PHASE_GONE };
enum { BAR = 30 };

@implementation progress_t

- (id) init: (render_t *)aRender
{
  self = [super init];
  if (self)
    {
      render = [aRender retain];
      started = clock_seconds();
      phase = [[NSConditionLock alloc] initWithCondition: PHASE_SHOWN];
      [NSThread detachNewThreadSelector: @selector(show:)
                               toTarget: self
                             withObject: nil];
    }
  return self;
}

- (void) dealloc
{
  [phase release];
  [render release];
  [super dealloc];
}

+ (NSString *) line: (double)done after: (double)seconds
{
  int filled = (int)(done * BAR);
  NSMutableString *line = [NSMutableString string];

  [line appendFormat: @"%3d %% [", (int)(done * 100)];
  for (int i = 0; i < BAR; i++)
    {
      [line appendString: i < filled ? @"#" : @" "];
    }
  [line appendString: @"]"];
  if (done > 0)
    {
      unsigned long left = lround(seconds * (1 - done) / done);
      [line appendFormat: @" %lu:%02lu:%02lu left", left / 3600,
            left / 60 % 60, left % 60];
    }
  return line;
}

/** The cursor rests in front of the bar, so that whatever else is written
    begins there. */
- (void) showOnce
{
  NSAutoreleasePool *pool = [[NSAutoreleasePool alloc] init];
  NSString *line = [progress_t line: [render done]
                              after: clock_seconds() - started];

  fprintf(stderr, "%s\033[K\r", [line UTF8String]);
  fflush(stderr);
  [pool release];
}

/** Whether stop: was sent; waits a little for it. */
- (BOOL) isStopping
{
  NSAutoreleasePool *pool = [[NSAutoreleasePool alloc] init];
  NSDate *soon = [NSDate dateWithTimeIntervalSinceNow: 0.2];
  BOOL isStopping = [phase lockWhenCondition: PHASE_STOPPING
                                  beforeDate: soon];

  [pool release];
  return isStopping;
}

/** The thread. */
- (void) show: (id)unused
{
  while (![self isStopping])
    {
      [self showOnce];
    }
  fputs("\033[K", stderr);
  fflush(stderr);
  [phase unlockWithCondition: PHASE_GONE];
}

- (void) stop
{
  [phase lockWhenCondition: PHASE_SHOWN];
  [phase unlockWithCondition: PHASE_STOPPING];
  [phase lockWhenCondition: PHASE_GONE];
  [phase unlock];
}

@end
