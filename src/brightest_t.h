// brightest_t.h - the most that a ray of a scene can bring back, from its
// ambient colours, lights and background: what a branch that is cut (cut.h)
// might have been worth.
//
// A surface of its own gives, per channel, at most
//   (1 - alpha) m (ambient/dis (1 + 0.1 lights) + sum of diffuse e)
//   + sum of specular e,    m = diffuse for a mirror, otherwise 1,
// where e is a light's emissivity over r^falloff with r its distance from the
// surface, and of what comes back along its rays the part
//   k = (1 - alpha) specular + alpha.
// So b(0) = max(background, own) and b(g + 1) = max(background,
// own + k b(g)) bound a ray that g + 1 generations may follow.

#import <Foundation/Foundation.h>
#include "cut.h"

@class model_t;

@interface brightest_t : NSObject
{
@public
  struct cut_most *most;        // [g], as in struct cut_rule
  unsigned count;
}

/** For a picture with that many generations after the eye rays. The table ends
    where it does not grow any more. */
- (id) initWithModel: (model_t *)model generations: (unsigned)generations;

@end
