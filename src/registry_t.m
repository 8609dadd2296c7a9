#import "registry_t.h"
#import "object_t.h"
#import <objc/runtime.h>

@implementation registry_t

+ (Class) shapeForWord: (NSString *)word
{
  Class found = NSClassFromString([word stringByAppendingString: @"_t"]);

  return [found conformsToProtocol: @protocol(object_t)] ? found : Nil;
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
      if ([name hasSuffix: @"_t"]
          && class_conformsToProtocol(classes[i], @protocol(object_t)))
        {
          [words addObject: [name substringToIndex: [name length] - 2]];
        }
    }
  free(classes);
  return [words sortedArrayUsingSelector: @selector(compare:)];
}

@end
