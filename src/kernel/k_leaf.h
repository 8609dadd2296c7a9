// k_leaf.h - each of the kernel's shapes asked by a ray: line for line what
// hits: of the class does (sphere_t, plane_t, polygon_t, solid_t).

#ifndef K_LEAF_H
#define K_LEAF_H

#include "k_media.h"
#include "k_polygon_hit.h"
#include "k_scene.h"
#include "k_simd.h"
#include "k_sphere_hit.h"

static inline void
k_sphere_far_side(const struct k_sphere *sphere, struct k_ray *ray)
{
  double t = -2 * k_dot(k_sub(ray->o, sphere->center), ray->d);

  t = t > 0 ? t : 0;
  struct k_vec N = k_unit(k_sub(k_along(ray->o, t, ray->d), sphere->center));
  k_exits(ray, &sphere->s, t, N, k_along(sphere->center, sphere->radius, N));
}

/** One root of a sphere. Whether it is at the start or at the light hangs on
    N.d, which is side s / r but for rounding: when that leaves no doubt, the
    normal waits until the hit has turned out to be the nearest. */
static inline void
k_sphere_root(const struct k_sphere *sphere, struct k_ray *ray, double t,
              int side, struct k_vec p, double s, int is_compensated)
{
  if (!k_wants(ray, t))
    {
      return;
    }
  struct k_vec v = k_along(p, side * s, ray->d);
  double sure = s - 0x1p-48 * (k_norm1(ray->o) + k_norm1(sphere->center)
                               + sphere->radius);
  double r2 = 2 * sphere->radius;
  if ((!ray->from || t * sure > r2 * (ray->slack + sphere->s.slack))
      && (!ray->is_feeler
          || (ray->end - t) * sure > r2 * (ray->end_slack + sphere->s.slack)))
    {
      if (k_is_nearer(ray, &sphere->s, t))
        {
          ray->hit.t = t;
          ray->hit.surface = &sphere->s;
          ray->hit.N = v;
          ray->hit.finish = K_FINISH_SPHERE;
          ray->hit.is_compensated = is_compensated;
          ray->hit.sphere = sphere;
        }
      return;
    }
  struct k_vec N = k_unit(v);
  if (k_meets(ray, &sphere->s, t, N,
              k_along(sphere->center, sphere->radius, N)))
    {
      ray->hit.is_compensated = is_compensated;
    }
}

static inline void
k_sphere_ask(const struct k_sphere *sphere, struct k_ray *ray)
{
  double t0, t1, s;
  struct k_vec p;

  if (ray->from == &sphere->s)
    {
      if (ray->starts_inside)
        {
          k_sphere_far_side(sphere, ray);
        }
      return;
    }
  int how = k_sphere_hit(ray->o, ray->d, sphere->center, sphere->radius,
                         &t0, &t1, &p, &s);
  if (how)
    {
      int is_compensated = how == K_SPHERE_COMPENSATED;
      k_sphere_root(sphere, ray, t0, -1, p, s, is_compensated);
      k_sphere_root(sphere, ray, t1, +1, p, s, is_compensated);
    }
}

static inline __attribute__((always_inline)) void
k_plane_ask(const struct k_scene *scene, const struct k_flat *flat,
            struct k_ray *ray)
{
  double t;

  k_assume_eye(ray);
  if ((!ray->is_feeler || k_is_opaque(scene, &flat->s))
      && ray->from != &flat->s
      && k_plane_hit(&flat->plane, ray->o, ray->d, &t) && k_wants(ray, t))
    {
      k_meets_plane(ray, &flat->s, t, &flat->plane);
    }
}

/** k_polygon_crossings, four edges at a time. The vertices have the last one
    before the first and four times after it. One determinant serves edges that
    go up and down: taken from the other end it is the same with the other
    sign, to the last bit. */
static inline int
k_polygon_crossings_4(struct k_vec o, const struct k_shear *shear, unsigned n,
                      const double *const vertex[3])
{
  const double *vx = vertex[shear->kx];
  const double *vy = vertex[shear->ky];
  const double *vz = vertex[shear->kz];
  const d4 ox = d4_all(k_component(o, shear->kx));
  const d4 oy = d4_all(k_component(o, shear->ky));
  const d4 oz = d4_all(k_component(o, shear->kz));
  const d4 Sx = d4_all(shear->Sx), Sy = d4_all(shear->Sy), zero = d4_all(0);
  unsigned crosses = 0;

  for (unsigned i = 0; i < n; i += 4)
    {
      d4 wz = d4_sub(d4_load(vz + i - 1), oz);
      d4 Y0 = d4_sub(d4_sub(d4_load(vy + i - 1), oy), d4_mul(Sy, wz));
      d4 X0 = d4_sub(d4_sub(d4_load(vx + i - 1), ox), d4_mul(Sx, wz));
      wz = d4_sub(d4_load(vz + i), oz);
      d4 Y1 = d4_sub(d4_sub(d4_load(vy + i), oy), d4_mul(Sy, wz));
      unsigned above0 = d4_ge(Y0, zero), above1 = d4_ge(Y1, zero);
      if (above0 != above1)
        {
          d4 X1 = d4_sub(d4_sub(d4_load(vx + i), ox), d4_mul(Sx, wz));
          d4 left = d4_mul(X0, Y1), right = d4_mul(Y0, X1);
          crosses ^= (above0 ^ above1)
            & ((d4_gt(left, right) & above1)
               | (d4_gt(right, left) & ~above1));
        }
    }
  return __builtin_popcount(crosses) & 1;
}

static inline int
k_polygon_holds(const struct k_polygon *polygon, struct k_ray *ray,
                double t)
{
  switch (polygon->test)
    {
    case 1:
      return k_polygon_edges(k_along(ray->o, t, ray->d), polygon->newell,
                             polygon->n, polygon->vertex);
    case 2:
      return k_polygon_angles(k_along(ray->o, t, ray->d), polygon->newell,
                              polygon->n, polygon->vertex);
    default:
      if (polygon->grid)
        {
          enum k_cell cell = k_polygon_grid_at(polygon->grid, &polygon->plane,
                                               ray->o, ray->d, t);
          if (cell != K_CELL_MIXED)
            {
              return cell == K_CELL_IN;
            }
        }
      return k_polygon_crossings_4(ray->o, k_ray_shear(ray), polygon->n,
                                   polygon->vertex);
    }
}

/** Where the ray meets the polygon's plane: -[polygon_t meetsPlane:at:] */
static inline int
k_polygon_plane_hit(const struct k_polygon *polygon, const struct k_ray *ray,
                    double *t)
{
  return k_plane_hit(&polygon->plane, ray->o, ray->d, t)
    && (polygon->test != 0
        || k_polygon_settle(&polygon->plane, ray->o, ray->d,
                            polygon->grazing, polygon->n, polygon->vertex,
                            t));
}

/** A face of a clear solid that is not convex: -[solid_t search:isInside:]. */
static inline void
k_face_ask(const struct k_polygon *face, struct k_ray *ray)
{
  int is_inside = k_media_has(ray->media, face->s.medium);
  int comes_from_it = ray->from && ray->from->medium == face->s.medium;
  int goes_out = is_inside || (comes_from_it && ray->starts_inside);
  double t;

  if (ray->from == &face->s
      || ((is_inside || comes_from_it)
          && (k_dot(face->plane.n, ray->d) > 0) != goes_out)
      || !k_polygon_plane_hit(face, ray, &t))
    {
      return;
    }
  double tolerance = ray->slack + face->s.slack;
  double off = fabs(k_dot(face->plane.n, k_sub(face->plane.q, ray->o)));
  int stands_on_it = is_inside && ray->from && off <= tolerance
    && fabs(t) <= 16 * tolerance;
  if (stands_on_it && k_polygon_holds(face, ray, t))
    {
      k_exits(ray, &face->s, t > 0 ? t : 0, face->plane.n, ray->o);
    }
  else if (!stands_on_it && k_wants(ray, t) && k_polygon_holds(face, ray, t))
    {
      k_meets_plane(ray, &face->s, t, &face->plane);
    }
}

static inline void
k_polygon_ask(const struct k_polygon *polygon, struct k_ray *ray)
{
  double t;

  K_AMBIENT_MEANS(!polygon->s.medium);
  if (polygon->s.medium)
    {
      k_face_ask(polygon, ray);
    }
  else if (ray->from != &polygon->s
           && k_polygon_plane_hit(polygon, ray, &t)
           && k_wants(ray, t) && k_polygon_holds(polygon, ray, t))
    {
      k_meets_plane(ray, &polygon->s, t, &polygon->plane);
    }
}

/** -[solid_t clip:isInside:] */
static inline void
k_convex_ask(const struct k_scene *scene, const struct k_convex *solid,
             struct k_ray *ray)
{
  const struct k_flat *faces = &scene->faces[solid->first];
  const struct k_flat *in = NULL, *out = NULL;
  double t_in = -HUGE_VAL, t_out = HUGE_VAL, t;
  int is_inside = k_media_has(ray->media, solid->medium);

  if (!is_inside && ray->from && ray->from->medium == solid->medium
      && !ray->starts_inside)
    {
      return;
    }
  for (unsigned i = 0; i < solid->n; i++)
    {
      const struct k_flat *face = &faces[i];
      double n_dot_d = k_dot(face->plane.n, ray->d);
      double ahead = k_dot(face->plane.n, k_sub(face->plane.q, ray->o));
      if (n_dot_d == 0)
        {
          if (ahead < 0 && !is_inside)
            {
              return;
            }
          continue;
        }
      t = ahead / n_dot_d;
      if (n_dot_d < 0 && t > t_in)
        {
          t_in = t;
          in = face;
        }
      else if (n_dot_d > 0 && t < t_out && ray->from != &face->s)
        {
          t_out = t;
          out = face;
        }
    }
  if (is_inside && out)
    {
      t = t_out > 0 ? t_out : 0;
      k_exits(ray, &out->s, t, out->plane.n,
              k_plane_point(&out->plane, ray->o, ray->d, t));
    }
  else if (!is_inside && in && out && t_in <= t_out
           && !k_meets_plane(ray, &in->s, t_in, &in->plane))
    {
      k_meets_plane(ray, &out->s, t_out, &out->plane);
    }
}

/** What a ray is in behind a shape of the tree. */
static inline unsigned
k_ref_medium(const struct k_scene *scene, struct k_ref ref)
{
  return ref.kind == K_SPHERE ? scene->spheres[ref.index].s.medium
    : ref.kind == K_POLYGON ? scene->polygons[ref.index].s.medium
    : ref.kind == K_CONVEX ? scene->convex[ref.index].medium
    : scene->users[ref.index].s.medium;
}

/** Asks a shape of a kind of which a scene has few. */
static __attribute__((noinline)) void
k_rare_ask(const struct k_scene *scene, struct k_ref ref, struct k_ray *ray)
{
  const struct k_user_shape *u;

  k_assume_eye(ray);
  K_AMBIENT_MEANS(ref.kind != K_CONVEX);
  switch ((enum k_kind)ref.kind)
    {
    case K_CONVEX:
      if (!ray->is_feeler)
        {
          k_convex_ask(scene, &scene->convex[ref.index], ray);
        }
      break;
    case K_USER:
      u = &scene->users[ref.index];
      if (!ray->is_feeler || k_is_opaque(scene, &u->s))
        {
          u->user.hits(u->user.object, &u->s, ray);
        }
      break;
    case K_PLANE:
      k_plane_ask(scene, &scene->planes[ref.index], ray);
      break;
    case K_SPHERE:
    case K_POLYGON:             // not rare: k_ref_ask
      break;
    }
}

/** Asks one shape of the tree; feelers skip what is clear. */
static inline void
k_ref_ask(const struct k_scene *scene, struct k_ref ref, struct k_ray *ray)
{
  k_assume_eye(ray);
  if (ref.kind == K_SPHERE)
    {
      const struct k_sphere *sphere = &scene->spheres[ref.index];
      if (!ray->is_feeler || k_is_opaque(scene, &sphere->s))
        {
          k_sphere_ask(sphere, ray);
        }
    }
  else if (ref.kind == K_POLYGON)
    {
      const struct k_polygon *polygon = &scene->polygons[ref.index];
      if (!ray->is_feeler || k_is_opaque(scene, &polygon->s))
        {
          k_polygon_ask(polygon, ray);
        }
    }
  else
    {
      k_rare_ask(scene, ref, ray);
    }
}

#endif
