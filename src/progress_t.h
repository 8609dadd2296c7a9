// progress_t.h - a bar on standard error that shows how much of a picture is
// done and how long the rest will take. It lives on a thread of its own and
// asks the renderer five times a second.

#import "render_t.h"

@interface progress_t : NSObject
{
  render_t *render;
  double started;       // seconds, of the clock that only goes forward
  NSConditionLock *phase;       // see progress_t.m
}

/** Begins to show. */
- (id) init: (render_t *)render;

/** Removes the bar; returns when that is done. */
- (void) stop;

/** The line as it stands when the part `done` (0 to 1) took `seconds`;
    without a line break (autoreleased). */
+ (NSString *) line: (double)done after: (double)seconds;

@end
