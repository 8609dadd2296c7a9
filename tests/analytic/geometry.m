// geometry.m - pictures whose every pixel has a closed form by Euclid: the
// outline, depth and normal of a sphere, a mirror image, the shadow of a
// ball, the blur of an edge out of focus.

#import "support.h"
#include "test.h"

/** Where the ray from o along d (unit) meets a sphere first, or -1. */
static quad
sphere(struct q_vec o, struct q_vec d, struct q_vec c, quad r)
{
  struct q_vec f = q_sub(o, c);
  quad b = -q_dot(f, d);
  struct q_vec p = q_add(f, q_scale(d, b));
  quad discriminant = r * r - q_dot(p, p);

  return discriminant < 0 || b < 0 ? -1 : b - q_sqrt(discriminant);
}

enum { N = 96 };

static struct q_vec
direction(struct k_vec eye, double w, double h, unsigned x, unsigned y)
{
  return q_unit(q_sub(q_vec((quad)w * x / (N - 1),
                            (quad)h * (N - 1 - y) / (N - 1), 0), q_of(eye)));
}

static void
outline(void)
{
  const struct k_vec eye = { 2, 1, 4 }, center = { 1, 2, -3 };
  model_t *model = support_model
    ("camera cam { pixeldim %d %d worlddim 4 3 viewpoint 2 1 4 }\n"
     "material m { ambient 1 1 1 }\n"
     "sphere s { material m center 1 2 -3 radius 2 }\n", N, N);
  image_t *image = support_picture(model, support_render_options());
  unsigned wrong = 0, area = 0, depth = 0, normal = 0, color = 0;

  for (unsigned y = 0; y < N; y++)
    {
      for (unsigned x = 0; x < N; x++)
        {
          struct q_vec d = direction(eye, 4, 3, x, y);
          struct q_vec to = q_sub(q_of(center), q_of(eye));
          // Inside the outline: the angle to the centre is below
          // asin(radius / distance).
          quad l2 = q_dot(to, to), along = q_dot(to, d);
          quad cosine2 = along * along / l2, limit2 = 1 - 4 / l2;
          struct surface_pixel *s = [image surfaceAt: x : y];
          if (q_abs(cosine2 - limit2) < 1e-12)
            {
              continue;
            }
          int is_in = cosine2 > limit2;
          wrong += is_in != (s->object == 1);
          area += is_in;
          if (is_in && s->object == 1)
            {
              quad half = q_sqrt(4 - (l2 - along * along)), t = along - half;
              struct q_vec N1 = q_scale(q_sub(q_scale(d, t), to), 0.5);
              double bound = 128 * K_U / (double)half;
              depth += q_abs(s->depth - t) > bound;
              normal += q_apart(s->N, N1) > bound;
              color += fabs([image pixelAt: x : y]->color.x - (double)(1 / t))
                > bound;
            }
        }
    }
  PASS(area > 500 && area < N * N - 500, "a sphere in perspective: %u"
       " pixels", area);
  PASS(wrong == 0, "its outline is the cone of angle asin(radius/distance):"
       " %u pixels wrong", wrong);
  PASS(depth == 0, "its depth: %u", depth);
  PASS(normal == 0, "its normal: %u", normal);
  PASS(color == 0, "ambient over depth: %u", color);
}

/** A ball over a mirror: the mirror shows what an eye under it would see. */
static void
mirror(void)
{
  const struct k_vec eye = { 2, 2.5, 5 }, under = { 2, -2.5, 5 };
  model_t *model = support_model
    ("background .125 .25 .5\n"
     "camera cam { pixeldim %d %d worlddim 4 3 viewpoint 2 2.5 5 }\n"
     "material ball { ambient 6 6 6 }\n"
     "material mirror { specular 1 1 1 }\n"
     "plane floor { material mirror normal 0 1 0 point 0 0 0 }\n"
     "sphere s { material ball center 2 1 -3 radius .9 }\n", N, N);
  image_t *image = support_picture(model, support_render_options());
  unsigned wrong = 0, direct = 0, seen = 0, sky = 0;

  for (unsigned y = 0; y < N; y++)
    {
      for (unsigned x = 0; x < N; x++)
        {
          struct q_vec d = direction(eye, 4, 3, x, y);
          struct q_vec up = q_vec(d.x, -d.y, d.z);
          struct q_vec c = q_vec(2, 1, -3), r = q_of(under);
          quad t = sphere(q_of(eye), d, c, (quad)0.9);
          quad u = d.y < 0 ? sphere(r, up, c, (quad)0.9) : -1;
          double got = [image pixelAt: x : y]->color.x, want = 0.125;
          struct q_vec f = q_sub(t >= 0 ? q_of(eye) : r, c);
          struct q_vec way = t >= 0 ? d : up;
          quad b = q_dot(f, way), miss2 = q_dot(f, f) - b * b;
          if (q_abs(miss2 - (quad)0.81) < 1e-6)
            {
              continue;         // too near to an outline
            }
          if (t >= 0)
            {
              want = 6 / t;
              direct++;
            }
          else if (u >= 0)
            {
              want = 6 / u;
              seen++;
            }
          else
            {
              sky++;
            }
          wrong += !(fabs(got - want) <= 1e-12);
        }
    }
  PASS(direct > 300 && seen > 300 && sky > 300, "ball, mirror image and sky"
       " are seen: %u, %u, %u", direct, seen, sky);
  PASS(wrong == 0, "the mirror image is what an eye under the mirror sees:"
       " %u pixels wrong", wrong);
}

/** A ball's shadow on the floor: 1.1 A in it, A and diffuse light outside. */
static void
shadow(void)
{
  const struct k_vec eye = { 2, 4, 6 };
  model_t *model = support_model
    ("camera cam { pixeldim %d %d worlddim 4 3 viewpoint 2 4 6 }\n"
     "material floor { ambient 5 5 5 diffuse .5 .5 .5 }\n"
     "material ball { }\n"
     "light l { location 6 6 -2 emissivity 8 8 8 }\n"
     "plane floor { material floor normal 0 1 0 point 0 0 0 }\n"
     "sphere s { material ball center 3 1.5 -3 radius 1 }\n", N, N);
  image_t *image = support_picture(model, support_render_options());
  unsigned wrong = 0, dark = 0, lit = 0;

  for (unsigned y = 0; y < N; y++)
    {
      for (unsigned x = 0; x < N; x++)
        {
          if ([image surfaceAt: x : y]->object != 1)
            {
              continue;
            }
          struct q_vec d = direction(eye, 4, 3, x, y);
          quad t = -4 / d.y;
          struct q_vec P = q_add(q_of(eye), q_scale(d, t));
          struct q_vec l = q_sub(q_vec(6, 6, -2), P);
          quad r = q_sqrt(q_dot(l, l));
          struct q_vec L = q_scale(l, 1 / r);
          struct q_vec f = q_sub(q_vec(3, 1.5, -3), P);
          quad along = q_dot(f, L), off2 = q_dot(f, f) - along * along;
          if (q_abs(off2 - 1) < 1e-9)
            {
              continue;
            }
          int is_dark = off2 < 1 && along > 0 && along < r;
          double want = is_dark ? 5 / t * (quad)1.1
            : 5 / t + (quad)0.5 * 8 * L.y / r;
          double got = [image pixelAt: x : y]->color.x;
          wrong += !(fabs(got - want) <= 1e-14 * (1 + k_norm1(q_double(P))));
          dark += is_dark;
          lit += !is_dark;
        }
    }
  PASS(dark > 200 && lit > 2000, "a shadow is seen: %u dark, %u lit pixels",
       dark, lit);
  PASS(wrong == 0, "1.1 ambient/dis in the shadow's cone, diffuse light"
       " outside: %u pixels wrong", wrong);
}

/** An edge at depth D under a lens of half side a in focus at F: through the
    pixel of central direction d, lens point (u, v) sees the plane at
    M s + (1 - s) (u, v), M = F d and s = D over its depth. So the edge is
    blurred over a |1 - s| to both sides, and within the share of lens points
    that see the one side grows evenly. */
static void
blur(double focus, const char *aperture)
{
  enum { COLUMNS = 161, EXPOSURE = 1500 };
  const double a = 0.25, depth = 9, edge = 2.05;
  model_t *model = support_model
    ("camera cam { pixeldim %d 1 worlddim 4 1 viewpoint 2 .5 3 fstop 4"
     " focus %.17g exposure %d aperture %s }\n"
     "material white { ambient 1 1 1 }\n"
     "polygon p { material white vertex %.17g -90 -6 vertex 99 -90 -6"
     " vertex 99 90 -6 vertex %.17g 90 -6 }\n",
     COLUMNS, focus, EXPOSURE, aperture, edge, edge);
  image_t *image = support_picture(model, support_render_options());
  int is_disc = strcmp(aperture, "disc") == 0;
  unsigned wrong = 0, sharp = 0, blurred = 0, share_off = 0;

  for (unsigned x = 0; x < COLUMNS; x++)
    {
      double px = 4.0 * x / (COLUMNS - 1) - 2;
      double length = sqrt(px * px + 9);
      double s = depth / (focus * 3 / length);
      double middle = 2 + focus * px / length * s;
      double w = a * fabs(1 - s), side = (middle - edge) / w;
      double got = [image pixelAt: x : 0]->color.x;
      // Ambient 1 over a distance of 8.9 to 13 or so: hit rays are counted
      // by whether there is any and whether all are.
      double least = 1 / (depth + 6), most = 1 / (depth - 0.01);
      if (fabs(fabs(side) - 1) < 1e-9)
        {
          continue;
        }
      if (side < -1 || side > 1)
        {
          sharp++;
          wrong += side < 0 ? got != 0 : !(got > least && got < most);
          continue;
        }
      blurred++;
      // The share of the lens that sees white, of a square or a disc.
      double share = is_disc
        ? 0.5 + (side * sqrt(1 - side * side) + asin(side)) / M_PI
        : (1 + side) / 2;
      double dis = sqrt(pow(depth, 2) + pow(depth * px / 3, 2));
      double sigma = sqrt(share * (1 - share) / EXPOSURE);
      // Lens points change dis by less than 1 in 50.
      share_off += fabs(got * dis - share) > 5 * sigma + 0.02 * share;
      // Not too near to the rim some rays must see each side.
      wrong += fabs(side) < 0.95 && !(got > 0 && got * dis < 0.999);
    }
  PASS(blurred >= 3 && sharp > 30, "focus %g, %s: %u pixels are blurred",
       focus, aperture, blurred);
  PASS(wrong == 0, "focus %g, %s: the blur is a |1 - s| wide, sharp outside:"
       " %u wrong", focus, aperture, wrong);
  PASS(share_off == 0, "focus %g, %s: within it light grows with the lens's"
       " area: %u wrong", focus, aperture, share_off);
}

int
main(void)
{
  NSAutoreleasePool *pool = [[NSAutoreleasePool alloc] init];

  outline();
  mirror();
  shadow();
  blur(4, "square");
  blur(4, "disc");
  blur(30, "square");
  blur(30, "disc");
  [pool release];
  return test_done();
}
