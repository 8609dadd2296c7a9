#import "explain_t.h"
#import "model_t.h"
#import "witness_text.h"

@implementation explain_t

- (id) initWithModel: (model_t *)aModel
{
  if ((self = [super initWithModel: aModel]))
    {
      rays = [[NSMutableArray alloc] init];
    }
  return self;
}

- (void) dealloc
{
  [rays release];
  [super dealloc];
}

- (Class) rayClass
{
  return [witness_t class];
}

- (ray_t *) rayAt: (struct k_vec)o : (struct k_vec)d
{
  ray_t *ray = [super rayAt: o : d];

  [rays addObject: ray];
  return ray;
}

/** As a file may hold it. */
static double
finite_of(double c)
{
  return isnan(c) ? 0 : isinf(c) ? copysign(FLT_MAX, c) : c;
}

- (NSString *) textOf: (image_t *)image
{
  struct k_vec color = image->pixels->color;
  const double *errors = image->planes[PLANE_TRUNCATION];
  struct witness_text to = { [NSMutableString string], model, 0 };
  NSUInteger count = [rays count];
  double share = 1 / (double)count;

  [to.text appendFormat: @"pixel %u,%u of %u x %u: %lu ray%s\n",
      image->window.x0, image->window.y0, image->columns, image->rows,
      (unsigned long)count, count == 1 ? "" : "s"];
  for (NSUInteger i = 0; i < count; i++)
    {
      NSAutoreleasePool *pool = [[NSAutoreleasePool alloc] init];
      NSString *name = [NSString stringWithFormat: @"%lu",
                                 (unsigned long)(i + 1)];
      witness_tell(&to, [rays objectAtIndex: i], name,
                   k_vec(share, share, share), share);
      [pool release];
    }
  [to.text appendFormat: @"\n"];
  witness_tell_vec(&to, @"pixel", k_vec(finite_of(color.x), finite_of(color.y),
                                           finite_of(color.z)));
  if (errors)
    {
      witness_tell_number(&to, @"off at most", errors[0]);
    }
  return to.text;
}

@end
