// polygon.m - polygon_t: every shape the notes draw and some more, all three
// point-in-polygon tests against the even-odd rule in the plane. Notes,
// "bounded planes".

#import "support.h"
#include "kernel/k_polygon_hit.h"
#include "test.h"

struct outline
{
  const char *name;
  int is_convex;
  unsigned n;
  double at[16][2];
};

static const struct outline outlines[] = {
  { "triangle", 1, 3, { { 0, 0 }, { 3, 0 }, { 1, 2 } } },
  { "square", 1, 4, { { 0, 0 }, { 2, 0 }, { 2, 2 }, { 0, 2 } } },
  { "hexagon", 1, 6, { { 1, 0 }, { 2, 0 }, { 3, 1.5 }, { 2, 3 }, { 1, 3 },
    { 0, 1.5 } } },
  { "square the other way round", 1, 4,
    { { 0, 2 }, { 2, 2 }, { 2, 0 }, { 0, 0 } } },
  { "square with vertices repeated", 1, 8,
    { { 0, 0 }, { 0, 0 }, { 2, 0 }, { 2, 2 }, { 2, 2 }, { 2, 2 }, { 0, 2 },
      { 0, 0 } } },
  { "square with collinear vertices", 1, 7,
    { { 0, 0 }, { 0.5, 0 }, { 1, 0 }, { 2, 0 }, { 2, 2 }, { 1.5, 2 },
      { 0, 2 } } },
  { "L", 0, 6, { { 0, 0 }, { 2, 0 }, { 2, 1 }, { 1, 1 }, { 1, 2 },
    { 0, 2 } } },
  { "U", 0, 8, { { 0, 0 }, { 3, 0 }, { 3, 3 }, { 2, 3 }, { 2, 1 }, { 1, 1 },
    { 1, 3 }, { 0, 3 } } },
  { "U the other way round", 0, 8, { { 0, 3 }, { 1, 3 }, { 1, 1 }, { 2, 1 },
    { 2, 3 }, { 3, 3 }, { 3, 0 }, { 0, 0 } } },
  { "arrow", 0, 4, { { 0, 0 }, { 3, 1.5 }, { 0, 3 }, { 1, 1.5 } } },
  { "star", 0, 10, { { 1.5, 0 }, { 1.9, 1 }, { 3, 1 }, { 2.1, 1.7 },
    { 2.4, 2.9 }, { 1.5, 2.2 }, { 0.6, 2.9 }, { 0.9, 1.7 }, { 0, 1 },
    { 1.1, 1 } } },
  { "spiral", 0, 16, { { 0, 0 }, { 3, 0 }, { 3, 3 }, { 0, 3 }, { 0, 1 },
    { 2, 1 }, { 2, 2 }, { 1, 2 }, { 1, 1.75 }, { 1.75, 1.75 },
    { 1.75, 1.25 }, { 0.25, 1.25 }, { 0.25, 2.75 }, { 2.75, 2.75 },
    { 2.75, 0.25 }, { 0, 0.25 } } },
  { "frame: a hole by a bridge", 0, 10,
    { { 0, 0 }, { 3, 0 }, { 3, 3 }, { 0, 3 }, { 0, 0 }, { 1, 1 }, { 1, 2 },
      { 2, 2 }, { 2, 1 }, { 1, 1 } } }
};

/** The even-odd rule; *away is how far the point is from the outline. */
static int
is_inside(const struct outline *o, double a, double b, double *away)
{
  int inside = 0;

  *away = HUGE_VAL;
  for (unsigned i = 0; i < o->n; i++)
    {
      const double *p = o->at[i], *q = o->at[(i + 1) % o->n];
      double ex = q[0] - p[0], ey = q[1] - p[1], l2 = ex * ex + ey * ey;
      double s = l2 ? ((a - p[0]) * ex + (b - p[1]) * ey) / l2 : 0;
      s = fmin(fmax(s, 0), 1);
      *away = fmin(*away, hypot(a - p[0] - s * ex, b - p[1] - s * ey));
      if ((p[1] > b) != (q[1] > b)
          && a < p[0] + (b - p[1]) / (q[1] - p[1]) * ex)
        {
          inside = !inside;
        }
    }
  return inside;
}

/** Where the outline's plane stands: c + a u + b w. */
struct frame
{
  struct k_vec c, u, w, n;
};

static struct frame
frame_of(uint64_t i, double offset)
{
  struct support_random random = support_seed(i);
  struct frame f;
  struct k_vec other;

  f.c = support_point(&random, offset);
  f.u = support_direction(&random);
  other = support_direction(&random);
  f.n = q_double(q_unit(q_cross(q_of(f.u), q_of(other))));
  f.w = k_cross(f.n, f.u);
  return f;
}

/** Upright in z = 0: the frame of hand-made cases. */
static const struct frame flat = { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 },
                                   { 0, 0, 1 } };

static struct k_vec
at(const struct frame *f, double a, double b)
{
  return k_along(k_along(f->c, a, f->u), b, f->w);
}

static model_t *
model_of(const struct outline *o, const struct frame *f,
         enum polygon_test test)
{
  NSMutableString *text = [NSMutableString stringWithUTF8String:
    SUPPORT_CAMERA "material m { }\npolygon p { material m"];
  struct parse_options options = support_options();

  for (unsigned i = 0; i < o->n; i++)
    {
      struct k_vec v = at(f, o->at[i][0], o->at[i][1]);
      [text appendFormat: @" vertex %.17g %.17g %.17g", v.x, v.y, v.z];
    }
  [text appendString: @" }\n"];
  options.polygon_test = test;
  return support_model_with(options, text);
}

/** Random points of the plane, seen under random angles; those so near to
    the outline that their rounding counts are left out. */
static void
even_odd(enum polygon_test test, const char *test_name)
{
  unsigned total = 0, all_wrong = 0;

  for (unsigned k = 0; k < sizeof outlines / sizeof *outlines; k++)
    {
      const struct outline *o = &outlines[k];
      unsigned wrong = 0, inside_count = 0;
      if (test == POLYGON_EDGES && !o->is_convex)
        {
          continue;
        }
      for (unsigned i = 0; i < 20; i++)
        {
          NSAutoreleasePool *pool = [[NSAutoreleasePool alloc] init];
          double offset = i < 10 ? 1 : 1000;
          struct frame f = i == 0 ? flat : frame_of(i, offset);
          model_t *model = model_of(o, &f, test);
          struct support_random random = support_seed(i + 1000 * k);
          for (unsigned j = 0; j < 150; j++)
            {
              double a = support_between(&random, -0.5, 3.5);
              double b = support_between(&random, -0.5, 3.5);
              struct k_vec d = support_direction(&random);
              double away, cosine = fabs(k_dot(d, f.n));
              int inside = is_inside(o, a, b, &away);
              if (cosine < 1e-3 || away < 64 * K_U * offset / cosine)
                {
                  continue;
                }
              struct k_vec eye = k_along(at(&f, a, b), -3, d);
              struct hit hit = support_hit(model, eye, d);
              inside_count += inside;
              total++;
              wrong += inside != (hit.object != nil);
              wrong += inside && hit.object
                && fabs(hit.t - 3) > 64 * K_U * offset / cosine;
            }
          [pool release];
        }
      all_wrong += wrong;
      if (wrong || inside_count < 300)
        {
          PASS(0, "%s by %s: %u wrong of %u inside", o->name, test_name,
               wrong, inside_count);
        }
    }
  PASS(all_wrong == 0 && total > 10000, "random points by %s agree with the"
       " even-odd rule: %u of %u wrong", test_name, all_wrong, total);
}

static void
known(void)
{
  model_t *model = model_of(&outlines[1], &flat, POLYGON_CROSSINGS);
  polygon_t *p = (polygon_t *)support_object(model, "p");
  struct hit hit = support_hit(model, k_vec(1, 1, 4), k_vec(0, 0, -1));

  PASS(hit.t == 4 && support_same(hit.P, k_vec(1, 1, 0)), "through the"
       " middle");
  PASS(support_same(hit.N, k_vec(0, 0, 1)), "its normal is right-handed"
       " round the vertices");
  hit = support_hit(model, k_vec(1, 1, -4), k_vec(0, 0, 1));
  PASS(hit.t == 4 && support_same(hit.N, k_vec(0, 0, 1)), "from behind");
  PASS(support_same(p->plane.q, k_vec(0, 0, 0)), "its plane goes through the"
       " first vertex");
  PASS([p isConvex] && p->count == 4, "a square is convex, of 4 corners");
  PASS([p medium] == nil && p->solid == nil, "a polygon by itself is thin");
  model = model_of(&outlines[3], &flat, POLYGON_CROSSINGS);
  hit = support_hit(model, k_vec(1, 1, 4), k_vec(0, 0, -1));
  PASS(support_same(hit.N, k_vec(0, 0, -1)), "the other way round it is"
       " turned");
  model = model_of(&outlines[4], &flat, POLYGON_CROSSINGS);
  p = (polygon_t *)support_object(model, "p");
  PASS(p->count == 4, "repeated vertices are dropped: %u left", p->count);
  model = model_of(&outlines[5], &flat, POLYGON_CROSSINGS);
  p = (polygon_t *)support_object(model, "p");
  PASS(p->count == 7 && support_same(p->plane.n, k_vec(0, 0, 1)),
       "collinear ones are kept and do no harm");
  PASS(support_number(model, k_vec(1, 1, 4), k_vec(1, 0, 0)) == 0,
       "a parallel ray does not hit");
  PASS(support_number(model, k_vec(-1, 1, 0), k_vec(1, 0, 0)) == 0,
       "not even edge on");
  for (unsigned k = 0; k < sizeof outlines / sizeof *outlines; k++)
    {
      model = model_of(&outlines[k], &flat, POLYGON_CROSSINGS);
      p = (polygon_t *)support_object(model, "p");
      PASS([p isConvex] == outlines[k].is_convex, "%s is%s convex",
           outlines[k].name, outlines[k].is_convex ? "" : " not");
    }
}

/** Which of the three tests a polygon uses: crossings looks along the ray and
    needs no point, the notes' two look at the point itself. */
static void
chosen(void)
{
  const enum polygon_test tests[] = { POLYGON_CROSSINGS, POLYGON_EDGES,
                                      POLYGON_ANGLES };

  for (int i = 0; i < 3; i++)
    {
      model_t *model = model_of(&outlines[1], &flat, tests[i]);
      polygon_t *p = (polygon_t *)support_object(model, "p");
      ray_t *ray = support_ray(model, k_vec(1, 1, 4), k_vec(0.1, 0, -1));
      double t = support_hit(model, k_vec(1, 1, 4), k_vec(0.1, 0, -1)).t;
      PASS([p holds: ray at: t], "test %d: the point is inside", i);
      PASS([p holds: ray at: 10 * t] == (i == 0), "test %d: it looks at the"
           " %s", i, i == 0 ? "ray" : "point");
    }
  // The sum of the angles against the sides: only one of them can do this.
  const double x[6] = { 0, 2, 2, 1, 1, 0 }, y[6] = { 0, 0, 1, 1, 2, 2 };
  const double z[6] = { 0 };
  const double *const l[3] = { x, y, z };
  struct k_vec N = { 0, 0, 1 };
  PASS(k_polygon_angles(k_vec(0.5, 1.5, 0), N, 6, l)
       && !k_polygon_angles(k_vec(1.5, 1.5, 0), N, 6, l),
       "angles of an L");
  PASS(!k_polygon_edges(k_vec(0.5, 1.5, 0), N, 6, l), "edges cannot do an L");
}

/** Convex with corners on its sides, tilted and rounded: still convex. */
static void
rounded_convex(void)
{
  unsigned wrong = 0;

  for (unsigned i = 0; i < 300; i++)
    {
      NSAutoreleasePool *pool = [[NSAutoreleasePool alloc] init];
      struct frame f = frame_of(i, i % 2 ? 1 : 100);
      model_t *model = model_of(&outlines[5], &f, POLYGON_CROSSINGS);
      polygon_t *p = (polygon_t *)support_object(model, "p");
      wrong += ![p isConvex];
      [pool release];
    }
  PASS(wrong == 0, "rounding does not make a square with corners on its"
       " sides concave: %u", wrong);
}

/** The same corners from another start, or the other way round: the same
    hits. */
static void
order(void)
{
  unsigned wrong = 0, turned = 0;

  for (unsigned k = 0; k < sizeof outlines / sizeof *outlines; k++)
    {
      NSAutoreleasePool *pool = [[NSAutoreleasePool alloc] init];
      struct outline moved = outlines[k], back = outlines[k];
      unsigned n = moved.n;
      for (unsigned i = 0; i < n; i++)
        {
          memcpy(moved.at[i], outlines[k].at[(i + 2) % n], 16);
          memcpy(back.at[i], outlines[k].at[n - 1 - i], 16);
        }
      model_t *m = model_of(&outlines[k], &flat, POLYGON_CROSSINGS);
      model_t *m_moved = model_of(&moved, &flat, POLYGON_CROSSINGS);
      model_t *m_back = model_of(&back, &flat, POLYGON_CROSSINGS);
      for (unsigned j = 0; j < 500; j++)
        {
          struct support_random random = support_seed(j);
          // A grid of quarters: on edges and through corners too.
          struct k_vec aim = k_vec(floor(support_between(&random, -2, 14)) / 4,
                                   floor(support_between(&random, -2, 14)) / 4,
                                   0);
          struct k_vec o = k_vec(floor(support_between(&random, -2, 14)) / 4,
                                 floor(support_between(&random, -2, 14)) / 4,
                                 2);
          struct k_vec d = k_sub(aim, o);
          struct hit a = support_hit(m, o, d), b = support_hit(m_moved, o, d);
          struct hit c = support_hit(m_back, o, d);
          wrong += (a.object != nil) != (b.object != nil)
            || (a.object && (a.t != b.t || !support_same(a.N, b.N)));
          turned += (a.object != nil) != (c.object != nil)
            || (a.object && (a.t != c.t || !k_is_equal(a.N, k_neg(c.N))));
        }
      [pool release];
    }
  PASS(wrong == 0, "the first vertex may be any: %u", wrong);
  PASS(turned == 0, "the other way round only turns the normal: %u", turned);
}

/** Tiles of a floor: a ray at an edge or a corner hits exactly one of them;
    a bridge of a frame is never seen. */
static void
shared_edges(void)
{
  NSMutableString *text = [NSMutableString stringWithUTF8String:
    SUPPORT_CAMERA "material m { }\n"];
  unsigned leaks = 0, doubles = 0, shown = 0;
  struct support_random random = support_seed(1);
  double x[5][5], y[5][5];

  // A net of 4 x 4 quadrilaterals, each of two triangles, in z = 0.
  for (int i = 0; i < 5; i++)
    {
      for (int j = 0; j < 5; j++)
        {
          x[i][j] = i + support_between(&random, -0.3, 0.3);
          y[i][j] = j + support_between(&random, -0.3, 0.3);
        }
    }
  for (int i = 0; i < 4; i++)
    {
      for (int j = 0; j < 4; j++)
        {
          [text appendFormat: @"polygon a%d%d { material m vertex %.17g %.17g"
            @" 0 vertex %.17g %.17g 0 vertex %.17g %.17g 0 }\n"
            @"polygon b%d%d { material m vertex %.17g %.17g 0"
            @" vertex %.17g %.17g 0 vertex %.17g %.17g 0 }\n",
            i, j, x[i][j], y[i][j], x[i + 1][j], y[i + 1][j],
            x[i + 1][j + 1], y[i + 1][j + 1],
            i, j, x[i + 1][j + 1], y[i + 1][j + 1], x[i][j + 1], y[i][j + 1],
            x[i][j], y[i][j]];
        }
    }
  model_t *model = support_model_with(support_options(), text);
  for (unsigned k = 0; k < 20000; k++)
    {
      NSAutoreleasePool *pool = [[NSAutoreleasePool alloc] init];
      random = support_seed(k);
      int i = 1 + (int)(3 * support_unit(&random));
      int j = 1 + (int)(3 * support_unit(&random));
      int di = (int)(2 * support_unit(&random));
      double s = k % 4 ? support_unit(&random) : 0;     // corners too
      struct k_vec aim = k_vec(x[i][j] + s * (x[i - di][j - 1] - x[i][j]),
                               y[i][j] + s * (y[i - di][j - 1] - y[i][j]), 0);
      struct k_vec o = k_add(k_vec(2, 2, 0), support_point(&random, 3));
      unsigned hits = 0;
      struct k_vec d = k_sub(aim, o);
      ray_t *ray = support_ray(model, o, d);
      for (polygon_t *p in model->objects)
        {
          hits += [p holds: ray at: 0];
        }
      leaks += hits == 0;
      doubles += hits > 1;
      [pool release];
    }
  PASS(leaks == 0, "no ray gets through a shared edge or corner: %u", leaks);
  PASS(doubles == 0, "none hits two of the polygons at it: %u", doubles);
  model = model_of(&outlines[12], &flat, POLYGON_CROSSINGS);
  for (unsigned k = 0; k < 5000; k++)
    {
      random = support_seed(k);
      double s = support_unit(&random);
      struct k_vec aim = k_vec(s, s, 0);
      struct k_vec o = k_vec(support_between(&random, -1, 4),
                             support_between(&random, -1, 4), 3);
      shown += support_number(model, o, k_sub(aim, o)) != 1;
    }
  PASS(shown == 0, "the bridge to a hole does not show: %u", shown);
}

static void
faults(void)
{
#define WITH(text) SUPPORT_CAMERA "material m { }\npolygon p { material m " \
  text " }"
  PASS(support_faults(WITH("vertex 0 0 0 vertex 1 0 0")) != nil,
       "two vertices are too few");
  PASS(support_faults(WITH("vertex 0 0 0 vertex 1 0 0 vertex 3 0 0")) != nil,
       "on a line: no area");
  PASS(support_faults(WITH("vertex 0 0 0 vertex 1 2 3 vertex 0 0 0"
                           " vertex 1 2 3")) != nil, "there and back: no"
       " area");
  PASS(support_faults(WITH("vertex .1 .2 .3 vertex .2 .4 .6"
                           " vertex .3 .6 .9")) != nil,
       "on a tilted line: no area but that of rounding");
  PASS(support_faults(WITH("vertex 0 0 0 vertex 1 0 0 vertex 1 1 .001"
                           " vertex 0 1 0")) != nil, "1e-3 off its plane");
  PASS(support_faults(WITH("vertex 0 0 0 vertex 1 0 0 vertex 1 1 .00001"
                           " vertex 0 1 0")) == nil, "1e-5 off is taken");
  struct parse_options edges = { .polygon_test = POLYGON_EDGES,
                                 .max_depth = 5 };
  NSString *report = nil;
  model_t *model = support_parse
    (@SUPPORT_CAMERA "material m { }\npolygon p { material m vertex 0 0 0"
     " vertex 2 0 0 vertex 2 1 0 vertex 1 1 0 vertex 1 2 0 vertex 0 2 0 }",
     edges, &report);
  PASS(model == nil && [report rangeOfString: @"convex"].length > 0,
       "the test by edges takes convex polygons only");
}

/** A vertex farther than 1e-4 of the extent off the plane, by its own
    distance to the plane through the first vertex. */
static void
planarity(void)
{
  unsigned wrong = 0;

  for (int k = -30; k <= 30; k += 10)
    {
      for (int i = 0; i < 2; i++)
        {
          // The normal of this square is tilted by half the lift: the lifted
          // corner is half of it off the plane through the first one.
          double s = ldexp(1, k), lift = (i ? 2.02e-4 : 1.98e-4) * s;
          NSString *text = [NSString stringWithFormat:
            @SUPPORT_CAMERA "material m { }\npolygon p { material m"
            " vertex 0 0 0 vertex %.17g 0 0 vertex %.17g %.17g %.17g"
            " vertex 0 %.17g 0 }", s, s, s, lift, s];
          NSString *report = nil;
          struct parse_options options = support_options();
          model_t *model = support_parse(text, options, &report);
          quad h = lift / s;
          struct q_vec n = q_unit(q_vec(-h / 2, -h / 2, 1));
          quad off = q_dot(n, q_vec(1, 1, h));
          // The square's other corners are as far off on the other side.
          wrong += (model == nil) != (q_abs(off) > 1e-4
                                      || q_abs(n.x) > 1e-4);
        }
    }
  PASS(wrong == 0, "1e-4 of the extent is the limit, at every scale: %u",
       wrong);
}

/** A plane that is known from a corner so far away that rounding puts it
    anywhere is not taken over. */
static void
far_corner(void)
{
  model_t *model = support_model
    (SUPPORT_CAMERA "material m { alpha .5 ior 1.5 }\n"
     "polygon far { material m vertex 0 0x1p91 1 vertex 1 0 1 vertex 0 1 1 }\n"
     "polygon near { material m vertex 1 0 1 vertex 0 0 0 vertex 0 1 1 }");
  struct hit hit = support_hit(model, k_vec(0.25, 0.25, 5), k_vec(0, 0, -1));
  struct k_vec off = k_sub(hit.N, k_scale(k_vec(1, 1, -1), 1 / sqrt(3)));

  PASS(hit.object->number == 2 && fabs(hit.t - 4.5) < 8 * K_U * 5,
       "a polygon beside one with a far corner is hit where it is: %g", hit.t);
  PASS(k_norm_max(off) < 4 * K_U, "and keeps its normal");
}

int
main(void)
{
  NSAutoreleasePool *pool = [[NSAutoreleasePool alloc] init];

  known();
  chosen();
  rounded_convex();
  even_odd(POLYGON_CROSSINGS, "crossings");
  even_odd(POLYGON_ANGLES, "angles");
  even_odd(POLYGON_EDGES, "edges");
  order();
  shared_edges();
  faults();
  planarity();
  far_corner();
  [pool release];
  return test_done();
}
