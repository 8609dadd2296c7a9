// kernel.h - what the tests of the kernel share: the search as each
// instruction set does it, and as plain C without any; a loop over all shapes
// to compare it with; rays, and rays that start where others have hit.

#ifndef KERNEL_H
#define KERNEL_H

#import "support.h"

/** How many times fewer rays there are in a build that is not optimised. */
#if defined(__OPTIMIZE__) && !defined(__SANITIZE_ADDRESS__)
#define KERNEL_FEWER 1
#else
#define KERNEL_FEWER 10
#endif

// Without the instruction sets the operations of k_simd.h are plain C: what a
// machine gets that is not an x86-64.
#undef __AVX2__
#undef __SSE2__
#define K_ISA kernel_plain
#define K_ISA_NAME "plain C"
#define K_CLOSEST closest_plain
#define K_AMBIENT NULL
#include "kernel/k_trace.inc.c"

/** The instruction sets of this machine and plain C; how many. */
static inline unsigned
kernel_isas(const struct k_isa *isas[4])
{
  const char *names[] = { NULL, "avx2", "base" };
  unsigned count = 0;

  for (unsigned i = 0; i < 3; i++)
    {
      const struct k_isa *isa = k_isa_find(names[i]);
      int is_known = isa == NULL;
      for (unsigned j = 0; j < count; j++)
        {
          is_known |= isas[j] == isa;
        }
      if (!is_known)
        {
          isas[count++] = isa;
        }
    }
  isas[count++] = &kernel_plain;
  return count;
}

// Shapes

/** How many shapes of a kind there are. */
static inline uint32_t
kernel_count(const struct k_scene *scene, enum k_kind kind)
{
  const uint32_t counts[] = { scene->sphere_count, scene->polygon_count,
                              scene->convex_count, scene->user_count,
                              scene->plane_count };
  return counts[kind];
}

/** The box of a shape, not larger than it is. */
static inline struct k_bounds
kernel_box(const struct k_scene *scene, struct k_ref ref)
{
  struct k_bounds box = k_nothing();

  if (ref.kind == K_SPHERE)
    {
      const struct k_sphere *s = &scene->spheres[ref.index];
      struct k_vec r = k_vec(s->radius, s->radius, s->radius);
      box.least = k_sub(s->center, r);
      box.most = k_add(s->center, r);
      return box;
    }
  if (ref.kind == K_POLYGON)
    {
      const struct k_polygon *p = &scene->polygons[ref.index];
      for (unsigned i = 0; i < p->n; i++)
        {
          box = k_bounds_include(box, k_vec(p->vertex[0][i], p->vertex[1][i],
                                            p->vertex[2][i]));
        }
      return box;
    }
  return ref.kind == K_CONVEX ? scene->convex[ref.index].box
    : ref.kind == K_USER ? scene->users[ref.index].user.box : k_unbounded();
}

// Rays

static inline struct k_ray
kernel_ray(struct k_vec o, struct k_vec d, struct counters *counters)
{
  struct k_ray ray;

  memset(&ray, 0, sizeof ray);
  k_ray_start(&ray, o, d, NULL, counters);
  return ray;
}

/** What k_trace.c does with the nearest hit: P and N. */
static inline void
kernel_finish(struct k_ray *ray)
{
  struct k_hit *hit = &ray->hit;

  if (hit->surface && hit->finish == K_FINISH_PLANE)
    {
      hit->P = k_plane_point(hit->plane, ray->o, ray->d, hit->t);
      hit->N = hit->plane->n;
    }
  else if (hit->surface && hit->finish == K_FINISH_SPHERE)
    {
      hit->N = k_unit(hit->N);
      hit->P = k_along(hit->sphere->center, hit->sphere->radius, hit->N);
    }
  hit->finish = K_FINISHED;
}

/** A ray along d from where the other one, which is finished, has hit. */
static inline struct k_ray
kernel_child(const struct k_ray *ray, struct k_vec d, int through)
{
  struct k_ray child = kernel_ray(ray->hit.P, d, ray->counters);
  int came_from_inside = !(k_dot(ray->hit.N, ray->d) < 0);

  child.from = ray->hit.surface;
  child.starts_inside = came_from_inside != through;
  child.slack = child.from->slack + 16 * K_U * k_norm1(child.o);
  return child;
}

/** The same to a light. */
static inline struct k_ray
kernel_feeler(const struct k_ray *ray, struct k_vec light)
{
  struct k_vec l = k_sub(light, ray->hit.P);
  struct k_ray feeler = kernel_child(ray, k_unit(l), 0);

  feeler.is_feeler = 1;
  feeler.end = k_length(l);
  feeler.end_slack = 16 * K_U * (k_norm1(feeler.o) + k_norm1(light));
  return feeler;
}

/** What the search has to find: every shape is asked, in no tree's order. */
static inline void
kernel_ask_all(const struct k_scene *scene, struct k_ray *ray)
{
  for (int kind = K_PLANE; kind >= K_SPHERE; kind--)
    {
      uint32_t count = kernel_count(scene, kind);
      for (uint32_t i = 0; i < count; i++)
        {
          struct k_ref ref = { kind, i };
          k_ref_ask(scene, ref, ray);
          if (ray->is_feeler && ray->hit.surface)
            {
              return;
            }
        }
    }
}

/** Whether two finished rays have hit the same, to the bit; feelers: whether
    both or neither has hit. */
static inline int
kernel_agree(const struct k_ray *a, const struct k_ray *b)
{
  if (!a->hit.surface || !b->hit.surface || a->is_feeler)
    {
      return !a->hit.surface == !b->hit.surface;
    }
  return a->hit.surface == b->hit.surface
    && memcmp(&a->hit.t, &b->hit.t, sizeof a->hit.t) == 0
    && support_same(a->hit.N, b->hit.N) && support_same(a->hit.P, b->hit.P);
}

/** To the log: a ray that is not as it should be. */
static inline void
kernel_show(const char *what, const struct k_ray *ray,
            const struct k_ray *wanted)
{
  printf("# %s: from (%a %a %a) along (%a %a %a)%s: object %u at %a,"
         " not %u at %a\n", what, ray->o.x, ray->o.y, ray->o.z, ray->d.x,
         ray->d.y, ray->d.z, ray->is_feeler ? ", a feeler" : "",
         ray->hit.surface ? ray->hit.surface->number : 0, ray->hit.t,
         wanted->hit.surface ? wanted->hit.surface->number : 0,
         wanted->hit.t);
}

#endif
