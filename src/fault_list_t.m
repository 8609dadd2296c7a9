#import "fault_list_t.h"

#define SHOWN 20

@implementation fault_t

- (void) dealloc
{
  [message release];
  [super dealloc];
}

@end

@implementation fault_list_t

- (id) init
{
  if ((self = [super init]))
    {
      shown = [NSMutableArray new];
    }
  return self;
}

- (void) dealloc
{
  [shown release];
  [super dealloc];
}

- (BOOL) wants: (unsigned long)order
{
  fault_t *last = [shown lastObject];

  if ([shown count] < SHOWN || order < last->place.order)
    {
      return YES;
    }
  if (order != last->place.order && order != last_counted)
    {
      last_counted = order;
      count++;
    }
  return NO;
}

- (void) add: (NSString *)message at: (struct place)place
{
  if (![self wants: place.order])
    {
      return;
    }

  NSUInteger i = [shown count];

  for (; i > 0; i--)
    {
      fault_t *other = [shown objectAtIndex: i - 1];
      if (other->place.order == place.order && place.file >= 0)
        {
          return;
        }
      if (other->place.order <= place.order)
        {
          break;
        }
    }
  fault_t *fault = [[fault_t alloc] init];
  fault->place = place;
  fault->message = [message copy];
  [shown insertObject: fault atIndex: i];
  [fault release];
  count++;
  if ([shown count] > SHOWN)
    {
      [shown removeLastObject];
    }
}

@end
