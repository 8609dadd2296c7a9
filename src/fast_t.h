// fast_t.h - the fast engine: the model's objects describe themselves once to
// the kernel (kernel/k.h), which then traces without objects. A shape that
// does not describe itself is asked through its hits: as ever.

#import "engine_t.h"

@class compiler_t, model_t;

struct k_scene;

@interface fast_t : NSObject <engine_t>
{
@public
  struct k_scene *scene;        // the compiler's
@protected
  model_t *model;
  compiler_t *compiler;
  struct user *users;           // the shapes that did not
  unsigned user_count;
}

/** Takes what the model has passed on, so a model that passes on serves but one
    engine. `instructions` names an instruction set, nil is the best there is;
    `threads` build the tree. nil with an error when memory is short or the
    machine does not have the instructions. */
- (id) initWithModel: (model_t *)aModel instructions: (NSString *)instructions
            threads: (unsigned)threads
               error: (NSError **)error;

@end
