#import "material_t.h"

@implementation material_t

+ (const struct attribute *) attributes
{
  static const struct attribute table[] = {
    { .name = "ambient", .kind = ATTRIBUTE_COLOR },
    { .name = "diffuse", .kind = ATTRIBUTE_COLOR },
    { .name = "specular", .kind = ATTRIBUTE_COLOR },
    { .name = "shininess", .kind = ATTRIBUTE_NUMBER,
      .range = RANGE_NOT_NEGATIVE },
    { .name = "alpha", .kind = ATTRIBUTE_NUMBER,
      .range = RANGE_BETWEEN, .least = 0, .most = 1 },
    { .name = "ior", .kind = ATTRIBUTE_NUMBER, .range = RANGE_POSITIVE },
    { .name = NULL }
  };
  return table;
}

- (id) initWithBlock: (block_t *)block
{
  if ((self = [super init]))
    {
      const struct k_vec black = k_vec(0, 0, 0);

      name = [[block name] copy];
      ambient = [block vector: "ambient" or: black];
      diffuse = [block vector: "diffuse" or: black];
      specular = [block vector: "specular" or: black];
      shininess = [block number: "shininess" or: 32];
      alpha = [block number: "alpha" or: 0];
      ior = [block number: "ior" or: 1];
    }
  return self;
}

- (void) dealloc
{
  [name release];
  [super dealloc];
}

@end
