// k_ray.h - a ray on its way through the scene, and the rules that say which
// of the surfaces it meets counts: those of ray_t, for the kernel's shapes.

#ifndef K_RAY_H
#define K_RAY_H

#include "k.h"
#include "k_shear.h"

/** How P and N of a hit are found when it has turned out to be the nearest. */
enum k_finish
{
  K_FINISHED,           // they are there
  K_FINISH_PLANE,       // P on the plane, N its normal
  K_FINISH_SPHERE       // on the sphere, N along N as it stands
};

struct k_sphere;

struct k_hit
{
  double t;
  const struct k_surface *surface;      // NULL: nothing
  struct k_vec P, N;
  enum k_finish finish;
  int is_compensated;                   // as in ray_t's struct hit
  const struct k_plane *plane;          // K_FINISH_PLANE
  const struct k_sphere *sphere;        // K_FINISH_SPHERE
};

struct k_ray
{
  struct k_vec o, d;            // read four doubles at a time: k_float_o
  double dis;                   // of the path before o
  struct k_shear shear;         // see k_ray_shear
  int has_shear;
  const struct k_surface *from; // the surface it starts on, or NULL
  int starts_inside;
  double slack;
  int is_feeler;
  double end, end_slack;
  const struct k_media *media;
  unsigned only;                // the one medium whose surface is asked; 0: all
  struct k_hit hit;
  const struct k_surface *tied; // the one that won, where two were last met at
                                // the same t
  struct counters *counters;
};

/** A ray from o along d that has hit nothing yet. */
static inline void
k_ray_start(struct k_ray *ray, struct k_vec o, struct k_vec d,
            const struct k_media *media, struct counters *counters)
{
  ray->o = o;
  ray->d = d;
  ray->has_shear = 0;
  ray->dis = 0;
  ray->from = NULL;
  ray->starts_inside = 0;
  ray->slack = 0;
  ray->is_feeler = 0;
  ray->end = HUGE_VAL;
  ray->end_slack = 0;
  ray->media = media;
  ray->only = 0;
  ray->hit.t = HUGE_VAL;
  ray->hit.surface = NULL;
  ray->tied = NULL;
  ray->counters = counters;
}

/** What holds in a scene without lights, mirrors and glass: the search that is
    compiled for these (k_ambient.inc.c) is told, and leaves out the rest. */
#ifdef K_ONLY_AMBIENT
#define K_AMBIENT_MEANS(holds) \
  do \
    { \
      if (!(holds)) \
        { \
          __builtin_unreachable(); \
        } \
    } \
  while (0)
#else
#define K_AMBIENT_MEANS(holds) ((void)0)
#endif

/** There are no rays but the eye's, and nothing that they could be in. */
static inline void
k_assume_eye(const struct k_ray *ray)
{
  K_AMBIENT_MEANS(!ray->from && !ray->is_feeler && ray->end == HUGE_VAL
                  && !ray->only && !ray->media);
}

/** How a polygon sees the ray: for the first one that asks. */
static inline const struct k_shear *
k_ray_shear(struct k_ray *ray)
{
  if (!ray->has_shear)
    {
      ray->shear = k_shear(ray->d);
      ray->has_shear = 1;
    }
  return &ray->shear;
}

/** The farthest at which anything is of interest still. */
static inline double
k_ray_reach(const struct k_ray *ray)
{
  k_assume_eye(ray);
  return ray->is_feeler ? ray->end : ray->hit.t;
}

/** -[ray_t wants:] */
static inline int
k_wants(const struct k_ray *ray, double t)
{
  k_assume_eye(ray);
  return t > 0 && t <= ray->hit.t && t < ray->end;
}

/** Whether a surface met at t with N.d = n_dot_d passes through the place
    where the ray starts. */
static inline int
k_is_start(const struct k_ray *ray, const struct k_surface *s, double t,
           double n_dot_d)
{
  return ray->from && t * fabs(n_dot_d) <= ray->slack + s->slack;
}

/** Whether it is, for a feeler, as far as the light or farther. */
static inline int
k_is_end(const struct k_ray *ray, const struct k_surface *s, double t,
         double n_dot_d)
{
  return ray->is_feeler
    && !((ray->end - t) * fabs(n_dot_d) > ray->end_slack + s->slack);
}

/** Whether it is nearer than the hit so far; equal t: the lower number. */
static inline int
k_is_nearer(struct k_ray *ray, const struct k_surface *s, double t)
{
  if (t < ray->hit.t)
    {
      return 1;
    }
  if (__builtin_expect(t == ray->hit.t, 0))
    {
      const struct k_surface *other = ray->hit.surface;
      const struct k_surface *first = s->number < other->number ? s : other;
      ray->tied = s == other ? ray->tied : first;
      return first != other;
    }
  return 0;
}

/** -[ray_t countHit] */
static inline void
k_count_hit(const struct k_ray *ray)
{
  if (ray->tied == ray->hit.surface)
    {
      ray->counters->ties++;
    }
  if (ray->hit.is_compensated)
    {
      ray->counters->compensated++;
    }
}

/** -[ray_t exits:…] with everything known. */
static inline int
k_exits(struct k_ray *ray, const struct k_surface *s, double t,
        struct k_vec N, struct k_vec P)
{
  if (k_is_end(ray, s, t, k_dot(N, ray->d)) || !k_is_nearer(ray, s, t))
    {
      return 0;
    }
  ray->hit.t = t;
  ray->hit.surface = s;
  ray->hit.N = N;
  ray->hit.P = P;
  ray->hit.finish = K_FINISHED;
  ray->hit.is_compensated = 0;
  return 1;
}

/** -[ray_t meets:…] with everything known. */
static inline int
k_meets(struct k_ray *ray, const struct k_surface *s, double t,
        struct k_vec N, struct k_vec P)
{
  return t > 0 && !k_is_start(ray, s, t, k_dot(N, ray->d))
    && k_exits(ray, s, t, N, P);
}

/** The same for something flat; the point waits. */
static inline __attribute__((always_inline)) int
k_meets_plane(struct k_ray *ray, const struct k_surface *s, double t,
              const struct k_plane *plane)
{
  double n_dot_d = k_dot(plane->n, ray->d);

  if (!(t > 0) || k_is_start(ray, s, t, n_dot_d)
      || k_is_end(ray, s, t, n_dot_d) || !k_is_nearer(ray, s, t))
    {
      return 0;
    }
  ray->hit.t = t;
  ray->hit.surface = s;
  ray->hit.plane = plane;
  ray->hit.finish = K_FINISH_PLANE;
  ray->hit.is_compensated = 0;
  return 1;
}

#endif
