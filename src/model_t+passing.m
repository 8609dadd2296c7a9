#import "model_t.h"
#import "block_t.h"
#import "compiler_t.h"
#import "material_t.h"
#import <objc/runtime.h>

@implementation model_t (Passing)

typedef BOOL (*compile_t)(id, SEL, block_t *, unsigned, compiler_t *);

/** How blocks of the class are passed on; NULL if they are not. Its objects
    have nothing to do when the model is complete; and it says how itself, since
    what inherits from it may be something else. */
static compile_t
compile_of(Class class)
{
  SEL complete = @selector(complete:model:diag:);
  SEL compile = @selector(compileBlock:number:for:);
  IMP its = [class methodForSelector: compile];
  BOOL is_its_own = its != [[class superclass] methodForSelector: compile];
  BOOL is_complete = [class methodForSelector: complete]
    == [object_t methodForSelector: complete];

  return is_its_own && is_complete ? (compile_t)(void (*)(void))its : NULL;
}

- (BOOL) passOn: (block_t *)block of: (Class)class
{
  SEL compile = @selector(compileBlock:number:for:);

  if (compiler == nil || [block material]->alpha > 0)   // rays may start in it
    {
      return NO;
    }
  if (class != last_class)
    {
      last_class = class;
      last_compile = compile_of(class);
    }
  if (last_compile == NULL
      || !last_compile(class, compile, block, object_count + 1, compiler))
    {
      return NO;
    }
  object_count++;
  return YES;
}

- (void) expect: (double)count
{
  if (last_compile && count < UINT_MAX)
    {
      [last_class prepare: (NSUInteger)count for: compiler];
    }
}

@end
