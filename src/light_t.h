// light_t.h - a light, a point: `light name { … }`.

#import "block_t.h"

@interface light_t : NSObject
{
@public
  struct k_vec location;
  struct k_vec emissivity;      // per channel, >= 0
  int falloff;                  // light is divided by r^falloff: 0, 1 or 2
}

+ (const struct attribute *) attributes;
- (id) initWithBlock: (block_t *)block;

@end
