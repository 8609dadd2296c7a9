#import "model_t.h"
#import "compiler_t.h"
#import "material_t.h"
#import <objc/runtime.h>

@implementation model_t (Passing)

/** Whether instances of the class have nothing to do when the model is
    complete. */
static BOOL
is_complete(Class class)
{
  SEL complete = @selector(complete:model:diag:);

  return [class methodForSelector: complete]
    == [object_t methodForSelector: complete];
}

- (BOOL) passOn: (object_t *)object
{
  Class class = object_getClass(object);

  if (compiler == nil)
    {
      return NO;
    }
  if (class != last_class)
    {
      last_class = class;
      last_compile = !is_complete(class) ? NULL
        : (BOOL (*)(id, SEL, compiler_t *))(void (*)(void))
        [class instanceMethodForSelector: @selector(compile:)];
    }
  // Rays may start in a clear object.
  return last_compile && object->material->alpha == 0
    && last_compile(object, @selector(compile:), compiler);
}

- (void) expect: (double)count
{
  if (last_compile && count < UINT_MAX)
    {
      [last_class prepare: (NSUInteger)count for: compiler];
    }
}

@end
