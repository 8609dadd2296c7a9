// material_t.h - what a surface does with light: `material name { … }`.

#import "block_t.h"

@interface material_t : NSObject
{
@public
  NSString *name;
  struct k_vec ambient;         // per channel; divided by the path's length
  struct k_vec diffuse;
  struct k_vec specular;        // of highlights and of mirror reflection
  double shininess;             // exponent of the highlights, >= 0
  double alpha;                 // 0 opaque … 1 clear
  double ior;                   // index of refraction, > 0
}

+ (const struct attribute *) attributes;
- (id) initWithBlock: (block_t *)block;

@end
