// sphere.m - sphere_t: both roots, the point and the normal, against 113
// bits. Notes, "transmission".

#import "support.h"
#include "test.h"

static model_t *
ball(struct k_vec center, double radius)
{
  return support_model
    (SUPPORT_CAMERA "material m { alpha 1 }\n"
     "sphere s { material m center %a %a %a radius %a }",
     center.x, center.y, center.z, radius);
}

/** Both distances along the line o + t d, to all digits. */
static int
roots(struct k_vec o, struct k_vec d, struct k_vec c, double r, quad *t0,
      quad *t1)
{
  struct q_vec D = q_of(d), f = q_sub(q_of(o), q_of(c));
  quad a = q_dot(D, D), b = q_dot(f, D), k = q_dot(f, f) - (quad)r * r;
  quad discriminant = b * b - a * k;

  if (discriminant < 0)
    {
      return 0;
    }
  *t0 = (-b - q_sqrt(discriminant)) / a;
  *t1 = (-b + q_sqrt(discriminant)) / a;
  return 1;
}

static void
known(void)
{
  model_t *model = ball(k_vec(1, 2, 3), 2);
  struct hit hit = support_hit(model, k_vec(1, 2, 9), k_vec(0, 0, -1));

  PASS(hit.t == 4 && support_same(hit.P, k_vec(1, 2, 5))
       && support_same(hit.N, k_vec(0, 0, 1)), "from outside: the near root");
  hit = support_hit(model, k_vec(1, 2, 3.5), k_vec(0, 0, -1));
  PASS(hit.t == 2.5 && support_same(hit.P, k_vec(1, 2, 1))
       && support_same(hit.N, k_vec(0, 0, -1)), "from inside: the far root,"
       " normal outward");
  PASS(support_number(model, k_vec(1, 2, 9), k_vec(0, 0, 1)) == 0,
       "nothing behind the eye");
  PASS(support_number(model, k_vec(3.0001, 2, 9), k_vec(0, 0, -1)) == 0,
       "beside it");
  PASS(support_hit(model, k_vec(3, 2, 9), k_vec(0, 0, -1)).t == 6,
       "a tangent is a hit");
  PASS(support_number(model, k_vec(3 + 0x1p-50, 2, 9), k_vec(0, 0, -1)) == 0,
       "the next double beyond it is not");
  hit = support_hit(model, k_vec(1, 2, 5), k_vec(0, 0, -1));
  PASS(hit.t == 4, "an eye on it does not hit it at 0, but the far side");
  PASS(support_number(model, k_vec(1, 2, 5), k_vec(0, 0, 1)) == 0,
       "an eye on it that looks away hits nothing");
  PASS(hit.object->number == 1 && [[hit.object name] isEqual: @"s"]
       && hit.object->material == [model->materials objectForKey: @"m"],
       "the object knows its name, number and material");
}

/** Errors: of t those of the nearest point b and of the half chord s. With
    rho = distance / radius: u rho r for b, and u rho r over the half chord in
    radii for s (discriminant r^2 - p^2, p right to u rho r). */
static void
random_rays(void)
{
  unsigned wrong = 0, t_off = 0, N_off = 0, P_off = 0, outside = 0;
  unsigned counted = 0;

  for (unsigned i = 0; i < 300; i++)
    {
      NSAutoreleasePool *pool = [[NSAutoreleasePool alloc] init];
      struct support_random random = support_seed(i);
      struct k_vec c = support_point(&random, 5);
      double r = exp2(support_between(&random, -6, 6));
      model_t *model = ball(c, r);
      struct k_bounds box = [(sphere_t *)support_object(model, "s") bounds];
      for (unsigned j = 0; j < 100; j++)
        {
          double rho = exp2(support_between(&random, -4, 8));
          struct k_vec o = k_along(c, rho * r, support_direction(&random));
          struct k_vec aim
            = k_along(c, r * 1.2 * support_unit(&random),
                      support_direction(&random));
          struct k_vec d = k_unit(k_sub(aim, o));
          quad t0 = 0, t1 = 0;
          int meets = roots(o, d, c, r, &t0, &t1);
          quad t = t0 > 0 ? t0 : t1;
          struct hit hit = support_hit(model, o, d);
          double half = (t1 - t0) / (2 * r);    // half chord, in radii
          double size = rho * r + k_norm1(c) + k_norm1(o);
          if (fabs(rho - 1) < 1e-9 || (meets && half < 1e-5))
            {
              continue;         // eye on the surface, or almost a tangent
            }
          counted++;
          meets = meets && t > 0;
          wrong += meets != (hit.object != nil);
          if (meets && hit.object)
            {
              double bound = 8 * K_U * size / half;
              struct q_vec P = q_add(q_of(o), q_scale(q_of(d), t));
              struct q_vec N = q_unit(q_sub(P, q_of(c)));
              t_off += q_abs(hit.t - t) > bound;
              P_off += q_apart(hit.P, P) > bound;
              N_off += q_apart(hit.N, N) > bound / r;
              struct q_vec v = q_sub(q_of(hit.P), q_of(c));
              quad off = q_sqrt(q_dot(v, v)) - r;
              outside += q_abs(off) > 4 * K_U * (k_norm1(c) + r);
              outside += hit.P.x < box.least.x || hit.P.x > box.most.x
                || hit.P.y < box.least.y || hit.P.y > box.most.y
                || hit.P.z < box.least.z || hit.P.z > box.most.z;
            }
        }
      [pool release];
    }
  PASS(counted > 25000, "enough of them count: %u", counted);
  PASS(wrong == 0, "hit or miss is right: %u", wrong);
  PASS(t_off == 0, "so is the distance: %u", t_off);
  PASS(P_off == 0, "the point: %u", P_off);
  PASS(N_off == 0, "the normal: %u", N_off);
  PASS(outside == 0, "the point is on the sphere, and in its box: %u",
       outside);
}

/** From just above or just below the surface: the near root is right to a few
    u of itself, which o - c alone does not give. */
static void
near_surface(void)
{
  const struct k_vec c = { 1, 2, 3 };
  const double r = 1000;
  model_t *model = ball(c, r);
  unsigned wrong = 0, N_off = 0;

  for (unsigned i = 0; i < 20000; i++)
    {
      struct support_random random = support_seed(i);
      double h = exp2(support_between(&random, -30, -2));
      int is_inside = i % 2;
      struct k_vec up = support_direction(&random);
      struct k_vec o = k_along(c, is_inside ? r - h : r + h, up);
      struct k_vec d = support_direction(&random);
      double cosine = k_dot(d, up);
      if (fabs(cosine) < 0.1)
        {
          continue;
        }
      d = (cosine > 0) == is_inside ? d : k_neg(d);
      quad t0 = 0, t1 = 0;
      roots(o, d, c, r, &t0, &t1);
      quad t = is_inside ? t1 : t0;
      struct hit hit = support_hit(model, o, d);
      // d is unit to 3 u only; the roots here are of d as it is.
      wrong += q_abs(hit.t - t) > 16 * (quad)K_U * t;
      struct q_vec N = q_unit(q_sub(q_add(q_of(o), q_scale(q_of(d), t)),
                                    q_of(c)));
      N_off += q_apart(hit.N, N) > 16 * K_U;
    }
  PASS(wrong == 0, "from next to the surface: t to 16 u: %u", wrong);
  PASS(N_off == 0, "and the normal: %u", N_off);
}

static void
containment(void)
{
  model_t *model = ball(k_vec(1, 2, 3), 5);
  sphere_t *s = (sphere_t *)support_object(model, "s");
  unsigned wrong = 0;

  PASS([s contains: k_vec(1, 2, 3)], "its centre is inside");
  PASS(![s contains: k_vec(4, 6, 3)], "its surface is not");
  PASS([s contains: k_vec(4, nextafter(6, 0), 3)], "just below it is");
  PASS(![s contains: k_vec(4, nextafter(6, 7), 3)], "just above is not");
  PASS([s medium] == s, "a sphere is its own medium");
  for (unsigned i = 0; i < 20000; i++)
    {
      struct support_random random = support_seed(i);
      double h = exp2(support_between(&random, -50, 2));
      double side = support_unit(&random) < 0.5 ? -1 : 1;
      struct k_vec P = k_along(k_vec(1, 2, 3), 5 + side * h,
                               support_direction(&random));
      struct q_vec f = q_sub(q_of(P), q_of(k_vec(1, 2, 3)));
      wrong += [s contains: P] != (q_dot(f, f) < 25);
    }
  PASS(wrong == 0, "contains: is exact: %u", wrong);
}

/** From the inner side of the sphere: -2 (P - c).d, for any number of
    reflections. */
static void
inside_mirror(void)
{
  model_t *model = support_model
    (SUPPORT_CAMERA "material m { specular 1 1 1 }\n"
     "sphere s { material m center 0 0 0 radius 1 }");
  unsigned wrong = 0;

  for (unsigned i = 0; i < 500; i++)
    {
      struct support_random random = support_seed(i);
      struct k_vec o = k_scale(support_direction(&random),
                               0.99 * support_unit(&random));
      struct k_vec d = support_direction(&random);
      // All chords are as long as the first whole one.
      double b = k_dot(o, d);
      double half = sqrt(1 - (k_dot(o, o) - b * b));
      vec_t *pos = [vec_t vec: o], *dir = [vec_t vec: d];
      ray_t *ray = [[(ray_t *)[ray_t alloc] init: pos : dir] autorelease];
      [model find_closest: ray];
      double first = ray->hit.t;
      wrong += fabs(first - (half - b)) > 64 * K_U / half;
      for (unsigned k = 0; k < 50 && half > 1e-3; k++)
        {
          vec_t *P = [vec_t vec: ray->hit.P];
          vec_t *N = [vec_t vec: ray->hit.N];
          vec_t *r = [vec_t vec: shade_renew([ray->dir reflect: N]->v)];
          ray = [[(ray_t *)[ray_t alloc] init: P : r from: ray through: NO]
                  autorelease];
          [model find_closest: ray];
          wrong += ray->hit.object == nil;
          wrong += fabs(ray->hit.t - 2 * half) > 64 * (k + 2) * K_U / half;
          wrong += fabs(k_length(ray->hit.P) - 1) > 4 * K_U;
        }
    }
  PASS(wrong == 0, "50 chords in a mirror ball are of one length: %u", wrong);
}

/** Flat on the inner side: the far end of the shortest chords is found too.
    The start is not quite on the sphere, so a chord of length l is right to
    a few u of the radius. */
static void
short_chords(void)
{
  model_t *model = support_model
    (SUPPORT_CAMERA "material m { specular 1 1 1 }\n"
     "sphere s { material m center 0 0 0 radius 1 }");
  unsigned wrong = 0;

  for (unsigned i = 0; i < 2000; i++)
    {
      struct support_random random = support_seed(i);
      struct k_vec N = support_direction(&random);
      struct k_vec along = k_unit(k_cross(N, support_direction(&random)));
      double flat = exp2(support_between(&random, -45, 0));
      // A ray that has come to the inner side from the middle.
      ray_t *ray = support_ray(model, k_vec(0, 0, 0), N);
      [model find_closest: ray];
      vec_t *P = [vec_t vec: ray->hit.P];
      vec_t *d = [vec_t vec: k_unit(k_along(along, -flat, ray->hit.N))];
      ray_t *on = [(ray_t *)[ray_t alloc] init: P : d from: ray through: NO];
      [model find_closest: on];
      double chord = -2 * k_dot(P->v, d->v);
      wrong += on->hit.object == nil || fabs(on->hit.t - chord) > 8 * K_U;
      [on release];
    }
  PASS(wrong == 0, "from the inner side every ray finds the far side: %u",
       wrong);
}

static void
faults(void)
{
#define WITH(text) SUPPORT_CAMERA "material m { }\nsphere s { " text " }"
  PASS(support_faults(WITH("material m center 0 0 0")) != nil,
       "a sphere needs a radius");
  PASS(support_faults(WITH("material m radius 1")) != nil, "a center");
  PASS(support_faults(WITH("center 0 0 0 radius 1")) != nil, "a material");
  PASS(support_faults(WITH("material m center 0 0 0 radius 0")) != nil,
       "radius 0 is a fault");
  PASS(support_faults(WITH("material m center 0 0 0 radius -1")) != nil,
       "a negative one too");
  PASS(support_faults(WITH("material n center 0 0 0 radius 1")) != nil,
       "an unknown material");
  PASS(support_faults(WITH("radius 1 center 0 0 0 material m")) == nil,
       "the order does not matter");
}

int
main(void)
{
  NSAutoreleasePool *pool = [[NSAutoreleasePool alloc] init];

  known();
  random_rays();
  near_surface();
  containment();
  inside_mirror();
  short_chords();
  faults();
  [pool release];
  return test_done();
}
