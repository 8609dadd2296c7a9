#import "camera_t.h"
#include "trig.h"

@implementation camera_t

+ (const struct attribute *) attributes
{
  static const struct attribute table[] = {
    { .name = "pixeldim", .kind = ATTRIBUTE_WHOLE_PAIR, .is_required = 1,
      .range = RANGE_BETWEEN, .least = 1, .most = 1000000 },
    { .name = "worlddim", .kind = ATTRIBUTE_PAIR, .range = RANGE_POSITIVE },
    { .name = "viewpoint", .kind = ATTRIBUTE_POINT, .is_required = 1 },
    { .name = "lookat", .kind = ATTRIBUTE_POINT },
    { .name = "up", .kind = ATTRIBUTE_VECTOR },
    { .name = "angle", .kind = ATTRIBUTE_NUMBER,
      .range = RANGE_STRICTLY_BETWEEN, .least = 0, .most = 180 },
    { .name = "focus", .kind = ATTRIBUTE_NUMBER, .range = RANGE_POSITIVE },
    { .name = "fstop", .kind = ATTRIBUTE_NUMBER, .range = RANGE_POSITIVE },
    { .name = "exposure", .kind = ATTRIBUTE_WHOLE,
      .range = RANGE_BETWEEN, .least = 1, .most = 1000000000 },
    { .name = "aperture", .kind = ATTRIBUTE_WORD, .words = "square disc" },
    { .name = NULL }
  };
  return table;
}

/** Three attributes that come together or not at all: YES if all are there.
    The first that is missing is a fault. */
- (BOOL) has: (const char *)a : (const char *)b : (const char *)c
          in: (block_t *)block
{
  const char *all[3] = { a, b, c };
  const char *given = NULL, *missing = NULL;

  for (int i = 2; i >= 0; i--)
    {
      if ([block count: all[i]])
        {
          given = all[i];
        }
      else
        {
          missing = all[i];
        }
    }
  if (given && missing)
    {
      [block fault: [block place] : @"camera '%@' has '%s' but no '%s':"
        @" '%s', '%s' and '%s' go together", [block name], given, missing,
             a, b, c];
    }
  return given && !missing;
}

- (void) readLookat: (block_t *)block
{
  struct k_vec there = [block vector: "lookat" at: 0];
  struct k_vec up_hint = k_unit([block vector: "up" at: 0]);

  if (k_is_equal(there, viewpoint))
    {
      [block fault: [block placeOfValue: "lookat" at: 0]
                  : @"'lookat' is the viewpoint itself, expected another"
        @" point"];
      return;
    }
  ahead = k_unit(k_sub(there, viewpoint));
  right = k_cross(ahead, up_hint);
  if (k_length(right) <= 0x1p-26)
    {
      [block fault: [block placeOfValue: "up" at: 0]
                  : @"'up' is parallel to the line of sight, expected a"
        @" vector across it"];
      return;
    }
  right = k_unit(right);
  up = k_cross(right, ahead);
  height = 2 * trig_tan_degrees([block number: "angle" at: 0] / 2);
}

- (void) readWindow: (block_t *)block
{
  right = k_vec(1, 0, 0);
  up = k_vec(0, 1, 0);
  if (![block count: "worlddim"])
    {
      [block fault: [block place]
                  : @"camera '%@' has no 'worlddim' (width and height of the"
        @" window)", [block name]];
      return;
    }
  width = [block number: "worlddim" at: 0];
  height = [block number: "worlddim" at: 1];
  if (!(viewpoint.z > 0))
    {
      [block fault: [block placeOfValue: "viewpoint" at: 2]
                  : @"the viewpoint's z is %.6g, expected more than 0: the"
        @" window is the plane z = 0", viewpoint.z];
    }
}

- (void) readLens: (block_t *)block
{
  has_lens = [self has: "focus" : "fstop" : "exposure" in: block];
  exposure = 1;
  if (has_lens)
    {
      aperture = 1 / [block number: "fstop" at: 0];
      focus = [block number: "focus" at: 0];
      exposure = [block number: "exposure" at: 0];
      lens_is_disc = [[block word: "aperture"] isEqual: @"disc"];
    }
  else if ([block count: "aperture"] && ![block count: "focus"]
           && ![block count: "fstop"] && ![block count: "exposure"])
    {
      [block fault: [block placeOf: "aperture" at: 0]
                  : @"'aperture' without a lens: 'focus', 'fstop' and"
        @" 'exposure' are needed too"];
    }
}

- (id) initWithBlock: (block_t *)block
{
  if ((self = [super init]))
    {
      columns = [block number: "pixeldim" at: 0];
      rows = [block number: "pixeldim" at: 1];
      viewpoint = [block vector: "viewpoint" at: 0];
      is_lookat = [block count: "lookat"] || [block count: "up"]
        || [block count: "angle"];
      if (!is_lookat)
        {
          [self readWindow: block];
        }
      else if ([self has: "lookat" : "up" : "angle" in: block])
        {
          [self readLookat: block];
        }
      if (is_lookat && [block count: "worlddim"])
        {
          [block fault: [block placeOf: "worlddim" at: 0]
                      : @"'worlddim' with 'lookat': the window is given by"
            @" 'angle'"];
        }
      [self readLens: block];
      [self resizeTo: columns : rows];
    }
  return self;
}

/** How many spacings there are between the first and the last of n columns
    or rows; a single one has the spacing of two. */
static double
spacings(unsigned n)
{
  return n == 1 ? 1 : n - 1;
}

- (void) resizeTo: (unsigned)newColumns : (unsigned)newRows
{
  columns = newColumns;
  rows = newRows;
  pixel = height / spacings(rows);
}

/** The unit directions from the viewpoint through places in the window, of at
    most EYE_RAYS. One step for all before the next: many processors do two or
    more at once. */
static void
direct(const camera_t *self, const struct sample *samples, unsigned count,
       struct eye_ray *rays)
{
  double x[EYE_RAYS], y[EYE_RAYS], z[EYE_RAYS], length[EYE_RAYS];
  double across = spacings(self->columns), upward = spacings(self->rows);
  struct k_vec ahead = self->ahead, right = self->right, up = self->up;
  struct k_vec eye = self->viewpoint;
  BOOL is_far = NO;

  for (unsigned n = 0; n < count; n++)
    {
      // Column and row counted from the first one, in spacings; the middle of
      // a window with only one.
      x[n] = (self->columns == 1 ? 0.5 : samples[n].column)
        + samples[n].right;
      y[n] = (self->rows == 1 ? 0.5 : samples[n].row) + samples[n].up;
    }
  for (unsigned n = 0; n < count; n++)
    {
      if (self->is_lookat)
        {
          double i = (x[n] - across / 2) * self->pixel;
          double j = (y[n] - upward / 2) * self->pixel;
          x[n] = ahead.x + (right.x * i + up.x * j);
          y[n] = ahead.y + (right.y * i + up.y * j);
          z[n] = ahead.z + (right.z * i + up.z * j);
        }
      else
        {
          x[n] = self->width * x[n] / across - eye.x;
          y[n] = self->height * y[n] / upward - eye.y;
          z[n] = 0 - eye.z;
        }
      double l2 = x[n] * x[n] + y[n] * y[n] + z[n] * z[n];
      is_far |= !(l2 > 0x1p-900 && l2 < 0x1p900);
      length[n] = sqrt(l2);
    }
  for (unsigned n = 0; n < count; n++)
    {
      rays[n].d = k_vec(x[n], y[n], z[n]);
    }
  for (unsigned n = 0; n < count; n++)
    {
      // k_unit, with its square root taken above.
      rays[n].d = is_far ? k_unit(rays[n].d) : k_div(rays[n].d, length[n]);
      rays[n].o = eye;
    }
}

/** The point of the unit disc for a point of the square [-1, 1]^2: squares
    go to circles (Shirley and Chiu, "A Low Distortion Map Between Disk and
    Square", 1997). */
static void
disc_from_square(double *u, double *v)
{
  double a = *u, b = *v;

  if (fabs(a) > fabs(b))
    {
      double phi = (TRIG_PI / 4) * (b / a);
      *u = a * trig_cos(phi);
      *v = a * trig_sin(phi);
    }
  else if (b != 0)
    {
      double phi = (TRIG_PI / 4) * (a / b);
      *u = b * trig_sin(phi);
      *v = b * trig_cos(phi);
    }
}

- (struct k_bounds) lensBox
{
  struct k_bounds box = { viewpoint, viewpoint };

  if (has_lens)
    {
      double a = 2 * aperture;  // at least its diagonal
      struct k_vec corner = k_vec(a, a, a);
      box.least = k_sub(viewpoint, corner);
      box.most = k_add(viewpoint, corner);
    }
  return box;
}

- (void) centralRay: (struct sample)sample
                pos: (struct k_vec *)pos dir: (struct k_vec *)dir
{
  struct eye_ray ray;

  direct(self, &sample, 1, &ray);
  *pos = ray.o;
  *dir = ray.d;
}

- (void) ray: (struct sample)sample
         pos: (struct k_vec *)pos dir: (struct k_vec *)dir
{
  struct eye_ray ray;

  [self rays: &ray : 1 of: &sample];
  *pos = ray.o;
  *dir = ray.d;
}

/** Notes: du, dv move the starting point, and the direction focus * dir back
    by as much; divided by focus, so that no focus is too far. */
- (void) rays: (struct eye_ray *)rays : (unsigned)count
           of: (const struct sample *)samples
{
  direct(self, samples, count, rays);
  for (unsigned n = 0; camera_has_lens(self) && n < count; n++)
    {
      double u = samples[n].u, v = samples[n].v;
      if (lens_is_disc)
        {
          disc_from_square(&u, &v);
        }
      struct k_vec lens = k_add(k_scale(right, aperture * u),
                                k_scale(up, aperture * v));
      rays[n].o = k_add(viewpoint, lens);
      rays[n].d = k_unit(k_sub(rays[n].d, k_div(lens, focus)));
    }
}

@end
