// media_t.h - the media a ray is in: the notes' inside flag ("bounded
// planes", last page), kept as a stack so that a bubble in glass works. One
// media_t is one entry and what is below it; it does not change once made, so
// rays share it. nil is the empty stack: air.

#import <Foundation/Foundation.h>

@interface media_t : NSObject
{
@public
  id object;            // what the ray is in; not retained: the model's
  double ior;           // its index of refraction
  media_t *below;       // what it was in before; retained
}

/** The index of refraction of the medium on top; 1 in air. */
+ (double) ior: (media_t *)media;

/** Whether the object is in the stack. */
+ (BOOL) media: (media_t *)media has: (id)object;

/** The stack with the object on top (autoreleased). */
+ (media_t *) enter: (id)object : (double)ior over: (media_t *)media;

/** The stack without its topmost entry of the object: the same stack when it
    has none (autoreleased, or what was given). */
+ (media_t *) leave: (id)object from: (media_t *)media;

@end
