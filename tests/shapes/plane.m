// plane.m - plane_t: distance, point, normal, parallel rays.

#import "support.h"
#include "test.h"

static model_t *
plane(struct k_vec n, struct k_vec q)
{
  return support_model
    (SUPPORT_CAMERA "material m { alpha 1 }\n"
     "plane p { material m normal %a %a %a point %a %a %a }",
     n.x, n.y, n.z, q.x, q.y, q.z);
}

static void
known(void)
{
  model_t *model = plane(k_vec(0, 0, 3), k_vec(7, 8, 2));
  struct hit hit = support_hit(model, k_vec(1, 2, 5), k_vec(0, 0, -1));

  PASS(hit.t == 3 && support_same(hit.P, k_vec(1, 2, 2)), "straight on");
  PASS(support_same(hit.N, k_vec(0, 0, 1)), "its normal is made unit");
  hit = support_hit(model, k_vec(1, 2, -5), k_vec(0, 0, 1));
  PASS(hit.t == 7 && support_same(hit.N, k_vec(0, 0, 1)),
       "from behind, with the same normal");
  PASS(support_number(model, k_vec(1, 2, 5), k_vec(0, 0, 1)) == 0,
       "nothing behind the eye");
  PASS(support_number(model, k_vec(1, 2, 5), k_vec(0.6, 0.8, 0)) == 0,
       "a parallel ray never hits");
  PASS(support_number(model, k_vec(1, 2, 2), k_vec(0.6, 0.8, 0)) == 0,
       "not even within the plane");
  PASS(support_number(model, k_vec(1, 2, 2), k_vec(0, 0, -1)) == 0,
       "an eye on it does not hit it at 0");
  hit = support_hit(model, k_vec(0, 0, 5), k_vec(1, 0, -0x1p-40));
  PASS_ULPS(hit.t, 3 * 0x1p40, 4, "an almost parallel one hits far away");
  PASS(k_is_unbounded([(plane_t *)hit.object bounds]), "it has no bounds");
  plane_t *p = (plane_t *)hit.object;
  PASS([p contains: k_vec(0, 0, 1.9)] && ![p contains: k_vec(0, 0, 2)]
       && ![p contains: k_vec(0, 0, 2.1)], "inside is behind it");
  PASS([p medium] == p, "it is its own medium");
}

static void
normals(void)
{
  struct k_vec n = k_unit(k_vec(1, -2, 0.5));
  const int scales[] = { -390, -100, -1, 1, 100, 390 };
  unsigned unlike = 0;

  for (int i = 0; i < 6; i++)
    {
      model_t *model = plane(k_scale(n, ldexp(1, scales[i])), k_vec(1, 1, 1));
      struct hit hit = support_hit(model, k_vec(9, -9, 9),
                                   k_vec(-0.5, 0.75, -0.2));
      struct hit same = support_hit(plane(n, k_vec(1, 1, 1)),
                                    k_vec(9, -9, 9),
                                    k_vec(-0.5, 0.75, -0.2));
      unlike += hit.t != same.t || !support_same(hit.N, same.N)
        || !support_same(hit.P, same.P);
    }
  PASS(unlike == 0, "the normal's length does not matter: %u", unlike);
}

/** t = n.(q - o) / n.d: a few roundings of |q - o| above, and of 1 below,
    which count t times, over |cos|. */
static void
random_rays(void)
{
  unsigned wrong = 0, t_off = 0, P_off = 0, on_plane = 0, turned = 0;

  for (unsigned i = 0; i < 400; i++)
    {
      NSAutoreleasePool *pool = [[NSAutoreleasePool alloc] init];
      struct support_random random = support_seed(i);
      double size = exp2(support_between(&random, -20, 40));
      struct k_vec n = support_direction(&random);
      struct k_vec q = support_point(&random, size);
      model_t *model = plane(n, q), *back = plane(k_neg(n), q);
      plane_t *p = (plane_t *)support_object(model, "p");
      struct q_vec N = q_of(p->plane.n);        // as rounded
      for (unsigned j = 0; j < 40; j++)
        {
          struct k_vec o = k_add(q, support_point(&random, 1));
          struct k_vec d = support_direction(&random);
          quad cosine = q_dot(N, q_of(d));
          quad t = q_dot(N, q_sub(q_of(q), q_of(o))) / cosine;
          struct hit hit = support_hit(model, o, d);
          struct hit other = support_hit(back, o, d);
          double bound = 8 * K_U * (k_norm1(k_sub(q, o)) + q_abs(t))
            / q_abs(cosine);
          if (q_abs(t) <= bound)
            {
              continue;
            }
          wrong += (t > 0) != (hit.object != nil);
          turned += hit.t != other.t || (hit.object
            && !support_same(hit.N, k_neg(other.N)));
          if (t > 0 && hit.object)
            {
              double rounding = 4 * K_U * (k_norm1(q) + k_norm1(o)
                                           + (double)t);
              struct q_vec P = q_add(q_of(o), q_scale(q_of(d), t));
              quad off = q_dot(N, q_sub(q_of(hit.P), q_of(q)));
              t_off += q_abs(hit.t - t) > bound;
              P_off += q_apart(hit.P, P) > bound + 2 * rounding;
              on_plane += q_abs(off) > rounding;
            }
        }
      [pool release];
    }
  PASS(wrong == 0, "hit or miss is right: %u", wrong);
  PASS(t_off == 0, "so is the distance: %u", t_off);
  PASS(P_off == 0, "the point: %u", P_off);
  PASS(on_plane == 0, "it is on the plane, as near as can be: %u", on_plane);
  PASS(turned == 0, "the opposite normal is the same plane: %u", turned);
}

/** From far away the point is as near to the plane as where it lies allows,
    not as where the eye is. */
static void
from_afar(void)
{
  struct k_vec n = k_unit(k_vec(3, -2, 7)), q = k_vec(0.5, 0.25, -0.125);
  model_t *model = plane(n, q);
  plane_t *p = (plane_t *)support_object(model, "p");
  struct q_vec N = q_of(p->plane.n);
  unsigned off = 0, hits = 0;

  for (unsigned i = 0; i < 5000; i++)
    {
      struct support_random random = support_seed(i);
      struct k_vec o = k_scale(support_direction(&random), 0x1p40);
      struct hit hit = support_hit(model, o, k_sub(q, o));
      if (hit.object && fabs(k_dot(n, o)) > 0x1p36)
        {
          quad side = q_dot(N, q_sub(q_of(hit.P), q_of(q)));
          hits++;
          off += q_abs(side) > 8 * K_U * (k_norm1(hit.P) + k_norm1(q));
        }
    }
  PASS(hits > 4000 && off == 0, "seen from 2^40 away the point is on the"
       " plane: %u of %u not", off, hits);
}

/** Rays that leave a plane never meet it, or another plane in its place. */
static void
leaving(void)
{
  unsigned again = 0;

  for (unsigned i = 0; i < 400; i++)
    {
      NSAutoreleasePool *pool = [[NSAutoreleasePool alloc] init];
      struct support_random random = support_seed(i);
      double size = exp2(support_between(&random, -20, 40));
      struct k_vec n = support_direction(&random);
      struct k_vec q = support_point(&random, size);
      model_t *model = support_model
        (SUPPORT_CAMERA "material m { }\n"
         "plane p { material m normal %a %a %a point %a %a %a }\n"
         "plane r { material m normal %a %a %a point %a %a %a }\n",
         n.x, n.y, n.z, q.x, q.y, q.z, -n.x, -n.y, -n.z, q.x, q.y, q.z);
      for (unsigned j = 0; j < 40; j++)
        {
          struct k_vec o = k_add(q, support_point(&random, 1));
          ray_t *ray = support_ray(model, o, support_direction(&random));
          [model find_closest: ray];
          if (ray->hit.object == nil)
            {
              continue;
            }
          struct k_vec N = ray->hit.N, d = ray->dir->v;
          N = k_dot(N, d) < 0 ? N : k_neg(N);
          vec_t *P = [vec_t vec: ray->hit.P];
          vec_t *r = [vec_t vec: shade_reflect(d, N)];
          ray_t *child = [(ray_t *)[ray_t alloc] init: P : r from: ray
                                              through: NO];
          [model find_closest: child];
          again += child->hit.object != nil;
          [child release];
          child = [(ray_t *)[ray_t alloc] init: P : ray->dir from: ray
                                       through: YES];
          [model find_closest: child];
          again += child->hit.object != nil;
          [child release];
        }
      [pool release];
    }
  PASS(again == 0, "no ray meets the plane it leaves: %u", again);
}

static void
faults(void)
{
#define WITH(text) SUPPORT_CAMERA "material m { }\nplane p { " text " }"
  PASS(support_faults(WITH("material m normal 0 0 0 point 0 0 0")) != nil,
       "a normal of 0 is a fault");
  PASS(support_faults(WITH("material m normal 0 0 1")) != nil,
       "a plane needs a point");
  PASS(support_faults(WITH("material m point 0 0 1")) != nil, "a normal");
  PASS(support_faults(WITH("material m normal 0 0 2 point 0 0 0")) == nil,
       "which need not be unit");
}

int
main(void)
{
  NSAutoreleasePool *pool = [[NSAutoreleasePool alloc] init];

  known();
  normals();
  random_rays();
  from_afar();
  leaving();
  faults();
  [pool release];
  return test_done();
}
