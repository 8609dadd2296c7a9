#import "registry_t.h"
#import "object_t.h"
#import <objc/runtime.h>

/** Whether a class or one it inherits from adopts the protocol object_t. (The
    protocol is looked up by name: clang's @protocol() is not the one that the
    runtime knows.) */
static BOOL
is_shape(Class c)
{
  Protocol *protocol = objc_getProtocol("object_t");

  while (c && !class_conformsToProtocol(c, protocol))
    {
      c = class_getSuperclass(c);
    }
  return c != Nil;
}

@implementation registry_t

+ (Class) shapeForWord: (NSString *)word
{
  Class found = NSClassFromString([word stringByAppendingString: @"_t"]);

  return is_shape(found) ? found : Nil;
}

+ (NSArray *) words
{
  NSMutableArray *words = [NSMutableArray array];
  int count = objc_getClassList(NULL, 0);
  Class *classes = calloc(count, sizeof *classes);

  count = objc_getClassList(classes, count);
  for (int i = 0; i < count; i++)
    {
      NSString *name = NSStringFromClass(classes[i]);
      if ([name hasSuffix: @"_t"] && is_shape(classes[i]))
        {
          [words addObject: [name substringToIndex: [name length] - 2]];
        }
    }
  free(classes);
  return [words sortedArrayUsingSelector: @selector(compare:)];
}

@end
