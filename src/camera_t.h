// camera_t.h - the camera: `camera name { … }`, and the rays that leave it.
// Notes, "depth of field".

#import "block_t.h"
#include "eye_ray.h"
#include "kernel/k_bounds.h"

@class ray_t;

/** One of the rays of a picture. Everything random about it is a function of
    these numbers and of nothing else. */
struct sample
{
  unsigned column, row; // row 0 is the BOTTOM row
  double right, up;     // place in the pixel, in spacings from its point
  double u, v;          // place on the lens, each in [-1, 1]
};

@interface camera_t : NSObject
{
@public
  unsigned columns, rows;       // of the picture
  unsigned exposure;            // rays per sample; 1 without a lens
  BOOL has_lens;
@protected
  struct k_vec viewpoint;
  BOOL is_lookat;
  struct k_vec ahead, right, up;        // unit; the window's axes
  double width, height;         // of the window
  double pixel;                 // from a row to the next, of such a window
  double aperture, focus;       // lens: half side or radius; distance
  BOOL lens_is_disc;
}

+ (const struct attribute *) attributes;
- (id) initWithBlock: (block_t *)block;

/** Another number of columns and rows for the same window. */
- (void) resizeTo: (unsigned)newColumns : (unsigned)newRows;

/** A box round all points where rays start. */
- (struct k_bounds) lensBox;

/** Starting points and unit directions of at most EYE_RAYS rays. */
- (void) rays: (struct eye_ray *)rays : (unsigned)count
           of: (const struct sample *)samples;

/** The same of one. */
- (void) ray: (struct sample)sample
         pos: (struct k_vec *)pos dir: (struct k_vec *)dir;

/** The same through the centre of the lens, as if it were a pinhole. */
- (void) centralRay: (struct sample)sample
                pos: (struct k_vec *)pos dir: (struct k_vec *)dir;

@end

/** Whether rays start anywhere on a lens. Not in a program made with
    -DPLAIN_SCENES: bench/absent. */
static inline BOOL
camera_has_lens(const camera_t *camera)
{
#ifdef PLAIN_SCENES
  return NO;
#else
  return camera->has_lens;
#endif
}
