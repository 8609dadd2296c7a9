// k_trace.c - the colour of a ray: what -[ray_t trace:] does, as a recursion
// of plain C. The formulas are those of shade.h in both.

#include "k_leaf.h"
#include "../shade.h"
#include <alloca.h>

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
      hit->P = k_along(hit->center, hit->radius, hit->N);
    }
  hit->finish = K_FINISHED;
}

/** Asks only what has the medium: whether the ray comes out of it again. */
static int
leaves(const struct k_scene *scene, const struct k_ray *ray, unsigned medium)
{
  struct k_ray probe = *ray;
  const struct k_medium *m = &scene->media[medium];

  probe.hit.t = HUGE_VAL;
  probe.hit.surface = NULL;
  for (uint32_t i = 0; i < m->count; i++)
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

static unsigned
media_depth(const struct k_media *media)
{
  unsigned depth = 0;

  for (; media; media = media->below)
    {
      depth++;
    }
  return depth;
}

/** The media without the topmost entry of `medium`; entries above it are
    copied to `room`. */
static const struct k_media *
media_leave(const struct k_media *media, unsigned medium,
            struct k_media *room)
{
  const struct k_media *m = media, *left;
  struct k_media *last = NULL;

  if (!k_media_has(media, medium))
    {
      return media;
    }
  left = NULL;
  for (; m->medium != medium; m = m->below)
    {
      *room = *m;
      if (last)
        {
          last->below = room;
        }
      else
        {
          left = room;
        }
      last = room++;
    }
  if (last)
    {
      last->below = m->below;
      return left;
    }
  return m->below;
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

static struct k_vec trace(const struct k_scene *scene, struct k_ray *ray,
                          double dis, unsigned depth);

/** A ray from where `ray` has hit something. */
static void
spawn(const struct k_scene *scene, struct k_ray *child,
      const struct k_ray *ray, struct k_vec d, int through,
      const struct k_media *media)
{
  int came_from_inside = !(k_dot(ray->hit.N, ray->d) < 0);

  k_ray_start(child, ray->hit.P, d, media, ray->counters,
              scene->polygon_count > 0);
  child->from = ray->hit.surface;
  child->starts_inside = came_from_inside != through;
  child->slack = child->from->slack + 16 * K_U * k_norm1(child->o);
}

/** Whether light reaches the hit point: -[ray_t sees:…]. */
static int
sees(const struct k_scene *scene, const struct k_ray *ray,
     const struct k_light *light, struct k_vec Ns, struct k_vec *L,
     struct k_vec *e)
{
  struct k_vec l = k_sub(light->location, ray->hit.P);
  double r = k_length(l);
  struct k_ray feeler;

  *L = k_unit(l);
  if (!(r > 0 && k_dot(Ns, *L) > 0))
    {
      return 0;
    }
  spawn(scene, &feeler, ray, *L, 0, ray->media);
  feeler.is_feeler = 1;
  feeler.end = r;
  feeler.end_slack = 16 * K_U * (k_norm1(feeler.o)
                                 + k_norm1(light->location));
  ray->counters->feeler++;
  scene->isa->closest(scene, &feeler);
  *e = shade_falloff(light->emissivity, r, light->falloff);
  return feeler.hit.surface == NULL;
}

/** What comes along the reflected ray. */
static struct k_vec
reflection(const struct k_scene *scene, const struct k_ray *ray,
           struct k_vec Ns, double dis, unsigned depth)
{
  struct k_ray child;

  ray->counters->reflection += depth < scene->settings.max_depth;
  spawn(scene, &child, ray, shade_renew(shade_reflect(ray->d, Ns)), 0,
        ray->media);
  return trace(scene, &child, dis, depth + 1);
}

static struct k_vec
refraction(const struct k_scene *scene, const struct k_ray *ray, struct k_vec t,
           const struct k_media *inside, double dis, unsigned depth)
{
  struct k_ray child;

  ray->counters->refraction += depth < scene->settings.max_depth;
  spawn(scene, &child, ray, t, 1, inside);
  return trace(scene, &child, dis, depth + 1);
}

/** -[ray_t refractAt:…]: the refracted direction, what the ray is in after it
    (*entered and *room are room for that) and how much is reflected. */
static struct k_vec
refract(const struct k_scene *scene, const struct k_ray *ray,
        struct k_vec Ns, struct k_media *entered, struct k_media *room,
        const struct k_media **inside, double *R)
{
  unsigned medium = ray->hit.surface->medium;
  double ior = scene->materials[ray->hit.surface->material].ior;
  int goes_in = k_dot(ray->hit.N, ray->d) < 0;
  double n_i = ray->media ? ray->media->ior : 1;
  double n_t = ior;
  int tir;

  *inside = ray->media;
  if (medium && goes_in)
    {
      entered->medium = medium;
      entered->ior = ior;
      entered->below = ray->media;
      *inside = entered;
    }
  else if (medium)
    {
      *inside = media_leave(ray->media, medium, room);
      n_i = ior;
      n_t = *inside ? (*inside)->ior : 1;
    }
  struct k_vec T = shade_refract(ray->d, Ns, n_t / n_i, &tir);
  *R = tir ? 1 : shade_schlick(ray->d, Ns, T, n_i, n_t);
  return medium && n_i != n_t ? shade_renew(T) : ray->d;
}

/** -[ray_t trace:], step by step. */
static struct k_vec
trace(const struct k_scene *scene, struct k_ray *ray, double dis, unsigned depth)
{
  const struct k_vec black = k_vec(0, 0, 0);

  if (depth > scene->settings.max_depth)
    {
      return black;
    }
  scene->isa->closest(scene, ray);
  if (!ray->hit.surface)
    {
      return scene->settings.background;
    }
  finish_hit(ray);
  if (ray->media && any_is_left(scene, ray))
    {
      forget_media_left(scene, ray, alloca(media_depth(ray->media)
                                           * sizeof(struct k_media)));
    }
  dis += ray->hit.t;

  const struct k_material *m = &scene->materials[ray->hit.surface->material];
  int is_mirror = !k_is_zero(m->specular);
  struct k_vec N = ray->hit.N;
  struct k_vec Ns = k_dot(N, ray->d) < 0 ? N : k_scale(N, -1.0);
  struct k_vec V = k_neg(ray->d);
  struct k_vec A = shade_ambient(m->ambient, dis);
  struct k_vec color = A;
  struct k_vec highlights = black;

  for (uint32_t i = 0; i < scene->light_count; i++)
    {
      struct k_vec L, e;
      if (sees(scene, ray, &scene->lights[i], Ns, &L, &e))
        {
          color = shade_lit(color, m->diffuse, e, k_dot(Ns, L));
          if (is_mirror)
            {
              highlights = shade_highlight(highlights, m->specular, e, Ns, L,
                                           V, m->shininess);
            }
        }
      else
        {
          color = shade_shadow(color, A);
        }
    }

  struct k_vec reflected = black, refracted = black, t = ray->d;
  struct k_media entered;
  const struct k_media *inside = NULL;
  double R = 0;

  if (m->alpha > 0)
    {
      // Room for taking something out from under the top.
      int is_top = !ray->media
        || ray->media->medium == ray->hit.surface->medium;
      struct k_media *room = is_top ? NULL
        : alloca(media_depth(ray->media) * sizeof *room);
      t = refract(scene, ray, Ns, &entered, room, &inside, &R);
    }
  if (is_mirror || R > 0)
    {
      reflected = reflection(scene, ray, Ns, dis, depth);
    }
  if (is_mirror)
    {
      color = shade_mirror(color, m->diffuse, m->specular, reflected);
    }
  if (m->alpha > 0)
    {
      if (R < 1)
        {
          refracted = refraction(scene, ray, t, inside, dis, depth);
        }
      color = shade_blend(color, m->alpha, R, refracted, reflected);
    }
  return k_add(color, highlights);
}

struct k_vec
k_trace(const struct k_scene *scene, struct k_vec o, struct k_vec d,
        const struct k_media *media, struct counters *counters)
{
  struct k_ray ray;

  counters->eye++;
  k_ray_start(&ray, o, d, media, counters, scene->polygon_count > 0);
  return trace(scene, &ray, 0, 0);
}

struct k_surface_hit
k_first_hit(const struct k_scene *scene, struct k_vec o, struct k_vec d,
            const struct k_media *media)
{
  struct counters nobody_counts = { 0 };
  struct k_surface_hit first = { HUGE_VAL, { 0, 0, 0 }, 0 };
  struct k_ray ray;

  k_ray_start(&ray, o, d, media, &nobody_counts, scene->polygon_count > 0);
  scene->isa->closest(scene, &ray);
  if (ray.hit.surface)
    {
      finish_hit(&ray);
      first.t = ray.hit.t;
      first.N = ray.hit.N;
      first.number = ray.hit.surface->number;
    }
  return first;
}
