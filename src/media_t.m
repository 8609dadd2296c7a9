#import "media_t.h"

@implementation media_t

+ (double) ior: (media_t *)media
{
  return media ? media->ior : 1;
}

+ (BOOL) media: (media_t *)media has: (id)object
{
  while (media && media->object != object)
    {
      media = media->below;
    }
  return media != nil;
}

+ (media_t *) enter: (id)object : (double)ior over: (media_t *)media
{
  media_t *entered = [[[media_t alloc] init] autorelease];

  entered->object = object;
  entered->ior = ior;
  entered->below = [media retain];
  return entered;
}

+ (media_t *) leave: (id)object from: (media_t *)media
{
  if (media == nil)
    {
      return nil;
    }
  if (media->object == object)
    {
      return media->below;
    }
  media_t *left = [media_t leave: object from: media->below];
  return left == media->below ? media
    : [media_t enter: media->object : media->ior over: left];
}

- (void) dealloc
{
  [below release];
  [super dealloc];
}

@end
