// prism.h - solids for the stability tests: an outline moved along its normal.

#ifndef PRISM_H
#define PRISM_H

#include "battery.h"

struct prism
{
  unsigned n;                   // corners of the outline
  const double *x, *y;
  double size;                  // of everything
  struct k_vec o, a, b, c;      // where the origin and the axes go
};

static const double square_x[] = { -1, 1, 1, -1 };
static const double square_y[] = { -1, -1, 1, 1 };
static const double L_x[] = { -1, 1, 1, 0, 0, -1 };
static const double L_y[] = { -1, -1, 0, 0, 1, 1 };

/** Along the axes, or turned at random when `random` is given. */
static inline struct prism
prism_of(unsigned n, const double *x, const double *y, double size,
         struct k_vec o, struct support_random *random)
{
  struct prism prism = { n, x, y, size, o, { 1, 0, 0 }, { 0, 1, 0 },
                         { 0, 0, 1 } };

  if (random)
    {
      prism.c = support_direction(random);
      battery_across(prism.c, &prism.a, &prism.b);
    }
  return prism;
}

static inline struct prism
prism_cube(double size, struct k_vec o, struct support_random *random)
{
  return prism_of(4, square_x, square_y, size, o, random);
}

static inline struct k_vec
prism_place(const struct prism *p, double x, double y, double z)
{
  struct k_vec v = k_along(p->o, p->size * x, p->a);

  return k_along(k_along(v, p->size * y, p->b), p->size * z, p->c);
}

/** Corner i of the lower (-1) or upper (+1) outline. */
static inline struct k_vec
prism_corner(const struct prism *p, unsigned i, double z)
{
  return prism_place(p, p->x[i % p->n], p->y[i % p->n], z);
}

/** The faces, all outwards or, inside out, all inwards: then each goes the
    other way round from the same first vertex. */
static inline NSString *
prism_text(const struct run *run, const struct prism *p, const char *material,
           const char *solid, int is_inside_out)
{
  NSMutableString *text = [NSMutableString string];
  char name[40], more[40];

  snprintf(more, sizeof more, "solid %s", solid);
  for (unsigned f = 0; f < p->n + 2; f++)
    {
      struct k_vec v[16], turned[16];
      unsigned n = f < p->n ? 4 : p->n;
      for (unsigned i = 0; i < n; i++)
        {
          v[i] = f < p->n
            ? prism_corner(p, f + (i == 1 || i == 2), i < 2 ? -1 : 1)
            : f == p->n ? prism_corner(p, i, 1)
            : prism_corner(p, n - 1 - i, -1);
        }
      for (unsigned i = 0; i < n; i++)
        {
          turned[i] = is_inside_out ? v[(n - i) % n] : v[i];
        }
      snprintf(name, sizeof name, "%s%u", solid, f);
      [text appendString: battery_polygon(run, name, material, more, n,
                                          turned)];
    }
  return text;
}

#endif
