// k_leaf_many.inc.c - a shape asked by many rays of a beam, four at a time. The
// arithmetic is that of k_leaf.h, lane by lane and in the same order, where a
// ray clearly misses and where it clearly hits; any other ray asks by itself.

/** The rays in doubles, by coordinate: what a shape is asked with. */
struct k_many
{
  double o[3][K_MANY], d[3][K_MANY];
  double reach[K_MANY];         // nothing farther is wanted
  double slack[K_MANY], end_slack[K_MANY];      // of the rays
  double Sx[K_MANY], Sy[K_MANY];        // as in k_shear
  int kx, ky, kz;               // likewise, of all but the odd rays
  uint32_t odd;
  uint64_t from;                // bit number % 64 of surfaces they start on
};

struct d4_vec
{
  d4 x, y, z;
};

static inline struct d4_vec
d4_vec_load(const double v[3][K_MANY], unsigned i)
{
  struct d4_vec r = { d4_load(&v[0][i]), d4_load(&v[1][i]),
                      d4_load(&v[2][i]) };
  return r;
}

static inline struct d4_vec
d4_vec_all(struct k_vec v)
{
  struct d4_vec r = { d4_all(v.x), d4_all(v.y), d4_all(v.z) };
  return r;
}

static inline struct d4_vec
d4_vec_sub(struct d4_vec a, struct d4_vec b)
{
  struct d4_vec r = { d4_sub(a.x, b.x), d4_sub(a.y, b.y), d4_sub(a.z, b.z) };
  return r;
}

static inline struct d4_vec
d4_vec_along(struct d4_vec a, d4 t, struct d4_vec d)
{
  struct d4_vec r = { d4_add(a.x, d4_mul(t, d.x)),
                      d4_add(a.y, d4_mul(t, d.y)),
                      d4_add(a.z, d4_mul(t, d.z)) };
  return r;
}

static inline d4
d4_vec_dot(struct d4_vec a, struct d4_vec b)
{
  return d4_add(d4_add(d4_mul(a.x, b.x), d4_mul(a.y, b.y)),
                d4_mul(a.z, b.z));
}

static inline d4
d4_vec_norm1(struct d4_vec a)
{
  return d4_add(d4_add(d4_abs(a.x), d4_abs(a.y)), d4_abs(a.z));
}

/** k_shear of n rays, of which one at least runs along z most. */
static inline void
k_many_shear(struct k_many *many, unsigned n, int x, int y, int z)
{
  many->kx = x;
  many->ky = y;
  many->kz = z;
  many->odd = 0;
  for (unsigned i = 0; i < n; i += 4)
    {
      d4 dx = d4_load(&many->d[x][i]), dy = d4_load(&many->d[y][i]);
      d4 dz = d4_load(&many->d[z][i]);
      d4_store(&many->Sx[i], d4_div(dx, dz));
      d4_store(&many->Sy[i], d4_div(dy, dz));
      // As steep along another axis is odd, too: which k_shear takes is its.
      unsigned is_along = d4_gt(d4_abs(dz), d4_abs(dx))
        & d4_gt(d4_abs(dz), d4_abs(dy));
      many->odd |= (~is_along & 15u) << i;
    }
}

/** What has come of it: who has hit the shape, and who has to ask by itself. */
struct k_told
{
  uint32_t hits, others;
};

/** k_sphere_ask. Clear is a miss, or a near root that is wanted and neither
    where the ray starts nor where the light is. */
static inline struct k_told
k_sphere_many(const struct k_sphere *sphere, const struct k_many *many,
              struct k_ray *rays, uint32_t lanes, int are_feelers)
{
  const struct d4_vec center = d4_vec_all(sphere->center);
  const double r = sphere->radius;
  const d4 r2 = d4_all(r * r), zero = d4_all(0), two_r = d4_all(2 * r);
  const d4 slack = d4_all(sphere->s.slack);
  const d4 size = d4_all(k_norm1(sphere->center) + r);
  struct k_told told = { 0, 0 };

  if (many->from >> (sphere->s.number & 63) & 1)
    {
      told.others = lanes;      // perhaps the far side of where they start
      return told;
    }
  for (unsigned i = 0; i < K_MANY; i += 4)
    {
      unsigned here = lanes >> i & 15;
      if (!here)
        {
          continue;
        }
      struct d4_vec o = d4_vec_load(many->o, i), d = d4_vec_load(many->d, i);
      struct d4_vec f = d4_vec_sub(o, center);
      d4 b = d4_neg(d4_vec_dot(f, d)), ff = d4_vec_dot(f, f);
      struct d4_vec p = d4_vec_along(f, b, d);
      d4 discriminant = d4_sub(r2, d4_vec_dot(p, p));
      unsigned others = here & d4_gt(d4_mul(d4_all(0x1p-10), ff),
                                     d4_abs(d4_sub(ff, r2)));
      unsigned hits = here & ~others & d4_ge(discriminant, zero);
      if (hits)
        {
          d4 s = d4_sqrt(discriminant), t0 = d4_sub(b, s);
          d4 reach = d4_load(&many->reach[i]);
          hits &= d4_gt(d4_add(b, s), zero) & d4_ge(reach, t0);
          // More than enough for what k_sphere_root calls sure.
          d4 sure = d4_sub(s, d4_mul(d4_all(0x1.01p-48),
                                     d4_add(d4_vec_norm1(o), size)));
          unsigned is_clear = d4_gt(t0, zero) & d4_gt(reach, t0)
            & d4_gt(d4_mul(t0, sure),
                    d4_mul(two_r, d4_add(d4_load(&many->slack[i]), slack)));
          if (are_feelers)
            {
              d4 room = d4_mul(d4_sub(reach, t0), sure);
              d4 least = d4_add(d4_load(&many->end_slack[i]), slack);
              is_clear &= d4_gt(room, d4_mul(two_r, least));
            }
          others |= hits & ~is_clear;
          hits &= is_clear;
          double t[4], v[3][4];
          if (hits && !are_feelers)
            {
              struct d4_vec N = d4_vec_along(p, d4_neg(s), d);
              d4_store(v[0], N.x);
              d4_store(v[1], N.y);
              d4_store(v[2], N.z);
            }
          d4_store(t, t0);
          for (unsigned left = hits; left; left &= left - 1)
            {
              unsigned j = __builtin_ctz(left);
              struct k_hit *hit = &rays[i + j].hit;
              hit->t = t[j];
              hit->surface = &sphere->s;
              if (!are_feelers)
                {
                  hit->N = k_vec(v[0][j], v[1][j], v[2][j]);
                  hit->finish = K_FINISH_SPHERE;
                  hit->is_compensated = 0;
                  hit->sphere = sphere;
                }
            }
        }
      told.hits |= hits << i;
      told.others |= others << i;
    }
  return told;
}

/** k_polygon_crossings for four rays that run along the same axis most. */
static inline unsigned
k_polygon_crossings_of_4(const struct k_many *many, unsigned i, unsigned n,
                         const double *const vertex[3])
{
  const double *vx = vertex[many->kx];
  const double *vy = vertex[many->ky];
  const double *vz = vertex[many->kz];
  const d4 ox = d4_load(&many->o[many->kx][i]);
  const d4 oy = d4_load(&many->o[many->ky][i]);
  const d4 oz = d4_load(&many->o[many->kz][i]);
  const d4 Sx = d4_load(&many->Sx[i]), Sy = d4_load(&many->Sy[i]);
  const d4 zero = d4_all(0);
  d4 wz = d4_sub(d4_all(vz[n - 1]), oz);
  d4 X0 = d4_sub(d4_sub(d4_all(vx[n - 1]), ox), d4_mul(Sx, wz));
  d4 Y0 = d4_sub(d4_sub(d4_all(vy[n - 1]), oy), d4_mul(Sy, wz));
  unsigned above0 = d4_ge(Y0, zero), is_inside = 0;

  for (unsigned v = 0; v < n; v++)
    {
      wz = d4_sub(d4_all(vz[v]), oz);
      d4 X1 = d4_sub(d4_sub(d4_all(vx[v]), ox), d4_mul(Sx, wz));
      d4 Y1 = d4_sub(d4_sub(d4_all(vy[v]), oy), d4_mul(Sy, wz));
      unsigned above1 = d4_ge(Y1, zero);
      if (above0 != above1)
        {
          // One determinant for both ways: k_polygon_crossings_4.
          d4 left = d4_mul(X0, Y1), right = d4_mul(Y0, X1);
          is_inside ^= (above0 ^ above1)
            & ((d4_gt(left, right) & above1) | (d4_gt(right, left) & ~above1));
        }
      X0 = X1;
      Y0 = Y1;
      above0 = above1;
    }
  return is_inside;
}

// Polygons of more corners are asked by each ray, which may have a grid for it.
#define FEW_CORNERS 8

/** k_polygon_ask. Clear is a miss, or a hit that is wanted and neither where
    the ray starts nor where the light is, of a ray that does not graze. */
static inline struct k_told
k_polygon_many(const struct k_polygon *polygon, const struct k_many *many,
               struct k_ray *rays, uint32_t lanes, int are_feelers)
{
  const struct d4_vec n = d4_vec_all(polygon->plane.n);
  const struct d4_vec q = d4_vec_all(polygon->plane.q);
  const d4 zero = d4_all(0), grazing = d4_all(polygon->grazing);
  const d4 slack = d4_all(polygon->s.slack);
  struct k_told told = { 0, 0 };

  if (polygon->s.medium || polygon->test != 0
      || (many->from >> (polygon->s.number & 63) & 1))
    {
      told.others = lanes;
      return told;
    }
  for (unsigned i = 0; i < K_MANY; i += 4)
    {
      unsigned here = lanes >> i & 15;
      if (!here)
        {
          continue;
        }
      d4 n_dot_d = d4_vec_dot(n, d4_vec_load(many->d, i));
      d4 ahead = d4_vec_dot(n, d4_vec_sub(q, d4_vec_load(many->o, i)));
      d4 t = d4_div(ahead, n_dot_d), steep = d4_abs(n_dot_d);
      d4 reach = d4_load(&many->reach[i]);
      unsigned others = d4_gt(grazing, steep) & here;
      unsigned hits = here & ~others & d4_gt(t, zero) & d4_ge(reach, t);
      unsigned is_clear = d4_gt(reach, t)
        & d4_gt(d4_mul(t, steep), d4_add(d4_load(&many->slack[i]), slack));
      if (are_feelers)
        {
          is_clear &= d4_gt(d4_mul(d4_sub(reach, t), steep),
                            d4_add(d4_load(&many->end_slack[i]), slack));
        }
      is_clear &= polygon->n <= FEW_CORNERS ? ~(many->odd >> i) : 0;
      others |= hits & ~is_clear;
      hits &= is_clear;
      if (hits)
        {
          hits &= k_polygon_crossings_of_4(many, i, polygon->n,
                                           polygon->vertex);
        }
      double at[4];
      d4_store(at, t);
      for (unsigned left = hits; left; left &= left - 1)
        {
          unsigned j = __builtin_ctz(left);
          struct k_hit *hit = &rays[i + j].hit;
          hit->t = at[j];
          hit->surface = &polygon->s;
          hit->finish = K_FINISH_PLANE;
          hit->is_compensated = 0;
          hit->plane = &polygon->plane;
        }
      told.hits |= hits << i;
      told.others |= others << i;
    }
  return told;
}

/** Asks one shape; feelers skip what is clear. */
static inline struct k_told
k_ref_many(const struct k_scene *scene, struct k_ref ref,
           const struct k_many *many, struct k_ray *rays, uint32_t lanes,
           int are_feelers)
{
  struct k_told told = { 0, lanes };

  if (ref.kind == K_SPHERE)
    {
      const struct k_sphere *sphere = &scene->spheres[ref.index];
      lanes = are_feelers && !k_is_opaque(scene, &sphere->s) ? 0 : lanes;
      told = k_sphere_many(sphere, many, rays, lanes, are_feelers);
    }
  else if (ref.kind == K_POLYGON)
    {
      const struct k_polygon *polygon = &scene->polygons[ref.index];
      lanes = are_feelers && !k_is_opaque(scene, &polygon->s) ? 0 : lanes;
      told = k_polygon_many(polygon, many, rays, lanes, are_feelers);
    }
  return told;
}
