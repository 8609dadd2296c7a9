#import "light_t.h"

@implementation light_t

+ (const struct attribute *) attributes
{
  static const struct attribute table[] = {
    { .name = "location", .kind = ATTRIBUTE_POINT, .is_required = 1 },
    { .name = "emissivity", .kind = ATTRIBUTE_COLOR, .is_required = 1 },
    { .name = "falloff", .kind = ATTRIBUTE_WHOLE,
      .range = RANGE_BETWEEN, .least = 0, .most = 2 },
    { .name = NULL }
  };
  return table;
}

- (id) initWithBlock: (block_t *)block
{
  if ((self = [super init]))
    {
      location = [block vector: "location" at: 0];
      emissivity = [block vector: "emissivity" at: 0];
      falloff = (int)[block number: "falloff" or: 1];
    }
  return self;
}

@end
