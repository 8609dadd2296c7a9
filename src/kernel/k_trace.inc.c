// k_trace.inc.c - the colour of rays: what -[ray_t trace:] does, in plain C,
// compiled once for each instruction set by the k_isa_*.c. The formulas are
// those of shade.h in both.
//
// Rays are traced up to K_MANY at a time, which go much the same way: eye rays
// of pixels side by side, then what they spawn. Each step of -trace: is taken
// for all of them before the next, so that the search can look for the hits of
// all at once (k_beam.inc.c). No ray takes notice of the others.

#include "k_escape.inc.c"
#include "../shade.h"
#include <alloca.h>

/** A ray from where `ray` has hit something. */
static inline __attribute__((always_inline)) void
spawn(struct k_ray *child, const struct k_ray *ray, struct k_vec d,
      int through, const struct k_media *media)
{
  int came_from_inside = !(k_dot(ray->hit.N, ray->d) < 0);

  k_ray_start(child, ray->hit.P, d, media, ray->counters);
  child->dis = ray->dis;
  child->from = ray->hit.surface;
  child->starts_inside = came_from_inside != through;
  child->slack = child->from->slack + 16 * K_U * k_norm1(child->o);
}

/** What a ray has hit, and what is known of the colour there. */
struct point
{
  const struct k_ray *ray;
  const struct k_material *m;
  int is_mirror;
  struct k_vec Ns;              // the normal on the ray's side
  struct k_vec A;               // ambient
  struct k_vec color, highlights, reflected, refracted;
  double R;                     // how much is reflected, where it is clear
  struct k_vec t;               // refracted direction
  struct k_media entered;
  const struct k_media *inside; // what the refracted ray is in
  struct cut *cut;              // of the ray, and of what it spawns, if
  struct cut_pair pair;         // branches are cut
};

static inline __attribute__((always_inline)) void
point_start(const struct k_scene *scene, struct point *p, struct k_ray *ray)
{
  const struct k_vec black = k_vec(0, 0, 0);
  struct k_vec N = ray->hit.N;

  ray->dis += ray->hit.t;
  p->ray = ray;
  p->m = &scene->materials[ray->hit.surface->material];
  p->is_mirror = !k_is_zero(p->m->specular);
  p->Ns = k_dot(N, ray->d) < 0 ? N : k_scale(N, -1.0);
  p->A = shade_ambient(p->m->ambient, ray->dis);
  p->color = p->A;
  p->highlights = p->reflected = p->refracted = black;
  p->R = 0;
}

/** Whether a point faces a light that is *r away in the direction *L. */
static inline __attribute__((always_inline)) int
faces(const struct point *p, const struct k_light *light, struct k_vec *L,
      double *r)
{
  *L = k_unit_length(k_sub(light->location, p->ray->hit.P), r);
  return *r > 0 && k_dot(p->Ns, *L) > 0;
}

/** The feeler to it. */
static inline __attribute__((always_inline)) void
feel(const struct point *p, const struct k_light *light, struct k_vec L,
     double r, struct k_ray *feeler)
{
  spawn(feeler, p->ray, L, 0, p->ray->media);
  feeler->is_feeler = 1;
  feeler->end = r;
  feeler->end_slack = 16 * K_U * (k_norm1(feeler->o)
                                  + k_norm1(light->location));
}

/** Finds what is in the way of n feelers to one light. */
static inline __attribute__((always_inline)) void
find_blockers(const struct k_scene *scene, struct k_ray *feelers, unsigned n)
{
  if (n && !scene->settings.choice.no_shadows)
    {
      feelers->counters->feeler += n;
      k_find_many(scene, feelers, n, 1);
    }
}

/** The highlight of light e that arrives from L. */
static inline __attribute__((always_inline)) struct k_vec
highlight(const struct point *p, struct k_vec sum, struct k_vec e,
          struct k_vec L)
{
  return shade_highlight(sum, p->m->specular, e, p->Ns, L, k_neg(p->ray->d),
                         p->m->shininess);
}

/** Adds what one light gives to all points; `feelers` and `of` have room for
    as many. */
static inline void
light_up(const struct k_scene *scene, const struct k_light *light,
         struct point *points, unsigned count, struct k_ray *feelers,
         unsigned *of)
{
  unsigned n = 0;

  for (unsigned i = 0; i < count; i++)
    {
      struct point *p = &points[i];
      struct k_vec L;
      double r;
      if (faces(p, light, &L, &r))
        {
          feel(p, light, L, r, &feelers[n]);
          of[n++] = i;
        }
      else
        {
          p->color = shade_shadow(p->color, p->A);
        }
    }
  find_blockers(scene, feelers, n);
  for (unsigned j = 0; j < n; j++)
    {
      struct point *p = &points[of[j]];
      if (feelers[j].hit.surface)
        {
          p->color = shade_shadow(p->color, p->A);
          continue;
        }
      struct k_vec L = feelers[j].d;
      struct k_vec e = shade_falloff(light->emissivity, feelers[j].end,
                                     light->falloff);
      p->color = shade_lit(p->color, p->m->diffuse, e, k_dot(p->Ns, L));
      if (p->is_mirror)
        {
          p->highlights = highlight(p, p->highlights, e, L);
        }
    }
}

/** What a light gives where it arrives. */
struct arrival
{
  struct k_vec e, lit, highlight;       // no highlight until it is asked for
};

/** Whether a feeler is not worth it: -[ray_t takesAsLit:::]. */
static inline __attribute__((always_inline)) int
is_feeler_cut(struct point *p, struct k_vec L, struct arrival *a)
{
  struct k_vec off = cut_feeler_off(p->m->diffuse, p->is_mirror, p->m->alpha,
                                    a->lit,
                                    shade_shadow(k_vec(0, 0, 0), p->A));

  if (!cut_is_left(p->cut, off))
    {
      return 0;
    }
  if (p->is_mirror)
    {
      a->highlight = highlight(p, a->highlight, a->e, L);
      off = k_add(off, a->highlight);
    }
  return cut_feeler_is(p->cut, off);
}

/** light_up where feelers may be cut. */
static inline void
light_up_cut(const struct k_scene *scene, const struct k_light *light,
             struct point *points, unsigned count, struct k_ray *feelers,
             unsigned *of)
{
  const struct k_vec black = k_vec(0, 0, 0);
  struct arrival arrivals[count];
  unsigned n = 0;

  for (unsigned i = 0; i < count; i++)
    {
      struct point *p = &points[i];
      struct arrival *a = &arrivals[n];
      struct k_vec L;
      double r;
      if (!faces(p, light, &L, &r))
        {
          p->color = shade_shadow(p->color, p->A);
          continue;
        }
      a->e = shade_falloff(light->emissivity, r, light->falloff);
      a->lit = shade_lit(black, p->m->diffuse, a->e, k_dot(p->Ns, L));
      a->highlight = black;
      if (is_feeler_cut(p, L, a))
        {
          p->color = k_add(p->color, a->lit);
          p->highlights = k_add(p->highlights, a->highlight);
          continue;
        }
      feel(p, light, L, r, &feelers[n]);
      of[n++] = i;
    }
  find_blockers(scene, feelers, n);
  for (unsigned j = 0; j < n; j++)
    {
      struct point *p = &points[of[j]];
      if (feelers[j].hit.surface)
        {
          p->color = shade_shadow(p->color, p->A);
          continue;
        }
      p->color = k_add(p->color, arrivals[j].lit);
      if (p->is_mirror)
        {
          p->highlights = highlight(p, p->highlights, arrivals[j].e,
                                    feelers[j].d);
        }
    }
}

/** -[ray_t refractAt:…]: the refracted direction, what the ray is in after it
    (*room is room for that) and how much is reflected. */
static inline void
refract(const struct k_scene *scene, struct point *p, struct k_media *room)
{
  const struct k_ray *ray = p->ray;
  unsigned medium = ray->hit.surface->medium;
  double ior = p->m->ior;
  int goes_in = k_dot(ray->hit.N, ray->d) < 0;
  double n_i = ray->media ? ray->media->ior : 1;
  double n_t = ior;
  int tir, is_critical;

  p->inside = ray->media;
  if (medium && goes_in)
    {
      p->entered.medium = medium;
      p->entered.ior = ior;
      p->entered.below = ray->media;
      p->inside = &p->entered;
    }
  else if (medium)
    {
      p->inside = k_media_leave(ray->media, medium, room);
      n_i = ior;
      n_t = p->inside ? p->inside->ior : 1;
      ray->counters->unbalanced += p->inside == ray->media;
    }
  struct k_vec T = shade_refract_near(ray->d, p->Ns, n_t / n_i, &tir,
                                      &is_critical);
  if (__builtin_expect(is_critical, 0))
    {
      ray->counters->critical++;
    }
  p->R = tir ? 1 : scene->settings.choice.exact_fresnel
    ? shade_fresnel(ray->d, p->Ns, T, n_i, n_t)
    : shade_schlick(ray->d, p->Ns, T, n_i, n_t);
  p->t = medium && n_i != n_t ? shade_renew(T) : ray->d;
}

static void trace(const struct k_scene *scene, struct k_ray *rays, unsigned n,
                  unsigned depth, struct k_vec *colors);
static void trace_cut(const struct k_scene *scene, struct k_ray *rays,
                      unsigned n, unsigned depth, struct k_vec *colors,
                      struct cut *cuts);

// From this generation on each ray is traced by itself: few are left by then,
// and what one level takes of the stack may be taken a thousand times.
#define TOGETHER 16

/** The colours of the next generation; 0 when there is none any more. With
    cuts, one for each child, when branches are cut. */
static inline __attribute__((always_inline)) int
trace_children(const struct k_scene *scene, struct k_ray *children,
               unsigned n, unsigned depth, struct k_vec *colors,
               struct cut *cuts)
{
  unsigned each = depth < TOGETHER ? n : 1;

  if (n == 0 || depth == scene->settings.max_depth)
    {
      return 0;
    }
  for (unsigned i = 0; i < n; i += each)
    {
      if (cuts)
        {
          trace_cut(scene, &children[i], each, depth + 1, &colors[i],
                    &cuts[i]);
        }
      else
        {
          trace(scene, &children[i], each, depth + 1, &colors[i]);
        }
    }
  return 1;
}

/** Whether a ray that a point would spawn is not worth it: -[ray_t
    cuts:of:in:as:]. *cut is what it is cut as otherwise. */
static inline __attribute__((always_inline)) int
is_cut(const struct k_scene *scene, struct point *p, enum cut_which which,
       unsigned depth, struct cut *cut)
{
  return cut_is(&scene->settings.cut, p->cut, &p->pair, which,
                depth == scene->settings.max_depth, cut);
}

/** What comes along the reflected rays of the points that have one. */
static inline __attribute__((always_inline)) void
reflect_all(const struct k_scene *scene, struct point *points, unsigned count,
            unsigned depth, struct k_ray *children, unsigned *of, int cuts_too)
{
  struct k_vec colors[count];
  struct cut cuts[cuts_too ? count : 1];
  unsigned n = 0;

  for (unsigned i = 0; i < count; i++)
    {
      struct point *p = &points[i];
      if ((p->is_mirror || p->R > 0)
          && !(cuts_too && is_cut(scene, p, CUT_REFLECTED, depth, &cuts[n])))
        {
          struct k_vec d = shade_renew(shade_reflect(p->ray->d, p->Ns));
          spawn(&children[n], p->ray, d, 0, p->ray->media);
          of[n++] = i;
        }
    }
  if (trace_children(scene, children, n, depth, colors,
                     cuts_too ? cuts : NULL))
    {
      children->counters->reflection += n;
      for (unsigned j = 0; j < n; j++)
        {
          points[of[j]].reflected = colors[j];
          if (cuts_too)
            {
              cut_add(points[of[j]].cut, &cuts[j]);
            }
        }
    }
}

/** The same along the refracted rays. */
static inline __attribute__((always_inline)) void
refract_all(const struct k_scene *scene, struct point *points, unsigned count,
            unsigned depth, struct k_ray *children, unsigned *of, int cuts_too)
{
  struct k_vec colors[count];
  struct cut cuts[cuts_too ? count : 1];
  unsigned n = 0;

  for (unsigned i = 0; i < count; i++)
    {
      struct point *p = &points[i];
      if (p->m->alpha > 0 && p->R < 1
          && !(cuts_too && is_cut(scene, p, CUT_REFRACTED, depth, &cuts[n])))
        {
          spawn(&children[n], p->ray, p->t, 1, p->inside);
          of[n++] = i;
        }
    }
  if (trace_children(scene, children, n, depth, colors,
                     cuts_too ? cuts : NULL))
    {
      children->counters->refraction += n;
      for (unsigned j = 0; j < n; j++)
        {
          points[of[j]].refracted = colors[j];
          if (cuts_too)
            {
              cut_add(points[of[j]].cut, &cuts[j]);
            }
        }
    }
}

static inline __attribute__((always_inline)) struct k_vec
point_color(const struct point *p)
{
  struct k_vec color = p->color;

  if (p->is_mirror)
    {
      color = shade_mirror(color, p->m->diffuse, p->m->specular,
                           p->reflected);
    }
  if (p->m->alpha > 0)
    {
      color = shade_blend(color, p->m->alpha, p->R, p->refracted,
                          p->reflected);
    }
  return k_add(color, p->highlights);
}

/** -[ray_t trace:], step by step, of n rays at once; with cuts, one for each
    of them, when branches are cut. Compiled for both. */
static inline __attribute__((always_inline)) void
trace_either(const struct k_scene *scene, struct k_ray *rays, unsigned n,
             unsigned depth, struct k_vec *colors, struct cut *cuts)
{
  struct point points[n];
  struct k_ray children[n];
  unsigned of[n], count = 0;
  int is_clear = 0, has_branches = 0;

  k_find_many(scene, rays, n, 0);
  for (unsigned i = 0; i < n; i++)
    {
      struct k_ray *ray = &rays[i];
      if (!ray->hit.surface)
        {
          colors[i] = scene->settings.background;
          continue;
        }
      k_count_hit(ray);
      finish_hit(ray);
      if (ray->media && any_is_left(scene, ray))
        {
          forget_media_left(scene, ray, alloca(k_media_depth(ray->media)
                                               * sizeof(struct k_media)));
        }
      point_start(scene, &points[count], ray);
      if (cuts)
        {
          points[count].cut = &cuts[i];
        }
      is_clear |= points[count].m->alpha > 0;
      has_branches |= points[count].is_mirror | is_clear;
      count++;
    }
  if (count == 0)
    {
      return;
    }
  for (uint32_t i = 0; !cuts && i < scene->light_count; i++)
    {
      light_up(scene, &scene->lights[i], points, count, children, of);
    }
  for (unsigned i = 0; is_clear && i < count; i++)
    {
      struct point *p = &points[i];
      if (p->m->alpha > 0)
        {
          // Room for taking something out from under the top.
          const struct k_media *media = p->ray->media;
          unsigned medium = p->ray->hit.surface->medium;
          refract(scene, p, media && media->medium != medium
                  ? alloca(k_media_depth(media) * sizeof *media) : NULL);
        }
    }
  for (unsigned i = 0; cuts && has_branches && i < count; i++)
    {
      struct point *p = &points[i];
      if (!p->is_mirror && p->m->alpha == 0)
        {
          continue;
        }
      cut_pair(&p->pair, &scene->settings.cut, p->cut, p->m->specular,
               p->m->alpha, p->R, depth + 1, p->ray->dis);
    }
  if (has_branches && !scene->settings.choice.no_reflection)
    {
      reflect_all(scene, points, count, depth, children, of, cuts != NULL);
    }
  if (is_clear && !scene->settings.choice.no_refraction)
    {
      refract_all(scene, points, count, depth, children, of, cuts != NULL);
    }
  // With cuts last: feelers get what the branches leave of the error.
  for (uint32_t i = 0; cuts && i < scene->light_count; i++)
    {
      (scene->settings.cut.max_error > 0 && !scene->settings.choice.no_shadows
       ? light_up_cut : light_up)(scene, &scene->lights[i], points, count,
                                  children, of);
    }
  for (unsigned i = 0; i < count; i++)
    {
      colors[points[i].ray - rays] = point_color(&points[i]);
    }
}

static void
trace(const struct k_scene *scene, struct k_ray *rays, unsigned n,
      unsigned depth, struct k_vec *colors)
{
  trace_either(scene, rays, n, depth, colors, NULL);
}

static void
trace_cut(const struct k_scene *scene, struct k_ray *rays, unsigned n,
          unsigned depth, struct k_vec *colors, struct cut *cuts)
{
  trace_either(scene, rays, n, depth, colors, cuts);
}

/** The colours of n eye rays, and what is cut of them. */
static void
trace_eye_cut(const struct k_scene *scene, struct k_ray *rays,
              struct eye_ray *eye, unsigned n, struct k_vec *colors)
{
  const struct cut whole = cut_eye(&scene->settings.cut);
  struct cut cuts[K_MANY];

  for (unsigned i = 0; i < n; i++)
    {
      cuts[i] = whole;
    }
  trace_cut(scene, rays, n, 0, colors, cuts);
  for (unsigned i = 0; i < n; i++)
    {
      eye[i].error = cuts[i].error;
    }
}

/** The colours of n <= K_MANY eye rays. */
static void
trace_eye(const struct k_scene *scene, struct eye_ray *eye, unsigned n,
          const struct k_media *const *media, struct counters *counters)
{
  struct k_ray rays[K_MANY];
  struct k_vec colors[K_MANY];

  counters->eye += n;
  for (unsigned i = 0; i < n; i++)
    {
      k_ray_start(&rays[i], eye[i].o, eye[i].d, media ? media[i] : NULL,
                  counters);
    }
  if (cut_is_on(&scene->settings.cut))
    {
      trace_eye_cut(scene, rays, eye, n, colors);
    }
  else
    {
      trace(scene, rays, n, 0, colors);
    }
  for (unsigned i = 0; i < n; i++)
    {
      eye[i].color = colors[i];
    }
}

static struct k_surface_hit
first_hit(const struct k_scene *scene, struct k_vec o, struct k_vec d,
          const struct k_media *media)
{
  struct counters nobody_counts = { 0 };
  struct k_surface_hit first = { HUGE_VAL, { 0, 0, 0 }, 0 };
  struct k_ray ray;

  k_ray_start(&ray, o, d, media, &nobody_counts);
  K_CLOSEST(scene, &ray);
  if (ray.hit.surface)
    {
      finish_hit(&ray);
      first.t = ray.hit.t;
      first.N = ray.hit.N;
      first.number = ray.hit.surface->number;
    }
  return first;
}

const struct k_isa K_ISA = {
  K_ISA_NAME, K_CLOSEST, k_find_many, trace_eye, K_AMBIENT, first_hit
};
