// k_escape.inc.c - the escape rule: a ray that has left something it is in
// without meeting its surface, through an edge where rounding leaves a gap,
// forgets it: -[ray_t forgetMediaLeft].

#include "k_beam.inc.c"
#include "k_media.h"

/** P and N of the nearest hit, which had no need of them before. */
static void
finish_hit(struct k_ray *ray)
{
  struct k_hit *hit = &ray->hit;

  if (hit->finish == K_FINISH_PLANE)
    {
      hit->P = k_plane_point(hit->plane, ray->o, ray->d, hit->t);
      hit->N = hit->plane->n;
    }
  else if (hit->finish == K_FINISH_SPHERE)
    {
      hit->N = k_unit(hit->N);
      hit->P = k_along(hit->sphere->center, hit->sphere->radius, hit->N);
    }
  hit->finish = K_FINISHED;
}

#define FEW_FACES 8             // shapes of a medium asked one after the other

/** Asks only what has the medium: whether the ray comes out of it again. */
static int
leaves(const struct k_scene *scene, const struct k_ray *ray, unsigned medium)
{
  struct k_ray probe = *ray;
  const struct k_medium *m = &scene->media[medium];

  probe.hit.t = HUGE_VAL;
  probe.hit.surface = NULL;
  if (m->count > FEW_FACES)
    {
      probe.only = medium;      // the faces of a solid
      K_CLOSEST(scene, &probe);
    }
  for (uint32_t i = 0; i < m->count && m->count <= FEW_FACES; i++)
    {
      k_ref_ask(scene, scene->medium_refs[m->first + i], &probe);
    }
  ray->counters->tests++;
  if (!probe.hit.surface)
    {
      return 0;
    }
  finish_hit(&probe);
  return k_dot(probe.hit.N, ray->d) > 0;
}

/** Whether the ray, whose nearest hit is known, has no way out of something it
    is in. */
static int
is_left(const struct k_scene *scene, const struct k_ray *ray,
        const struct k_media *m)
{
  return ray->hit.surface->medium != m->medium
    && scene->media[m->medium].is_bounded && !leaves(scene, ray, m->medium);
}

static int
any_is_left(const struct k_scene *scene, const struct k_ray *ray)
{
  for (const struct k_media *m = ray->media; m; m = m->below)
    {
      if (is_left(scene, ray, m))
        {
          return 1;
        }
    }
  return 0;
}

/** Takes those media off the stack: -[ray_t forgetMediaLeft]. What stays is
    copied to `room`. */
static void
forget_media_left(const struct k_scene *scene, struct k_ray *ray,
                  struct k_media *room)
{
  const struct k_media *kept = NULL;
  struct k_media *last = NULL;

  for (const struct k_media *m = ray->media; m; m = m->below)
    {
      if (is_left(scene, ray, m))
        {
          ray->counters->escapes++;
          continue;
        }
      *room = *m;
      room->below = NULL;
      if (last)
        {
          last->below = room;
        }
      else
        {
          kept = room;
        }
      last = room++;
    }
  ray->media = kept;
}
