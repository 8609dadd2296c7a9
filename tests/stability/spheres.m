// spheres.m - stability: where rays meet spheres. S01 to S18.

#include "battery.h"
#include "kernel/k_sphere_hit.h"

// One sphere and one eye ray, with the distance in closed form.

struct single
{
  const char *id;
  struct k_vec center;
  double radius;
  struct k_vec o, d;
  double t;                     // HUGE_VAL: a miss
  double tolerance;             // relative; negative: in ulps
};

static const struct single singles[] = {
  { "S01 far, on the axis", { 0, 0, 1e8 }, 1, { 0, 0, 0 }, { 0, 0, 1 },
    99999999, -0.0 },
  { "S02 far, off the axis", { .5, 0, 1e8 }, 1, { 0, 0, 0 }, { 0, 0, 1 },
    99999999.133974596, -1 },
  { "S03 farther", { .5, 0, 1e12 }, 1, { 0, 0, 0 }, { 0, 0, 1 },
    999999999999.13397, -1 },
  { "S05 tiny", { 5e-10, 0, 1 }, 1e-9, { 0, 0, 0 }, { 0, 0, 1 },
    .9999999991339746, -1 },
  { "S06 huge, looking down", { 0, -1e9, 0 }, 1e9, { 0, 1, 0 }, { 0, -1, 0 },
    1, -1 },
  { "S07 huge, slope 1e-3", { 0, -1e9, 0 }, 1e9, { 0, 1, 0 }, { 1, -1e-3, 0 },
    1000.5010008760017, 1e-12 },
  { "S08 huge, slope 6e-5", { 0, -1e9, 0 }, 1e9, { 0, 1, 0 }, { 1, -6e-5, 0 },
    20000.000036499997, 1e-11 },
  { "S09 huger, slope 1e-3", { 0, -1e12, 0 }, 1e12, { 0, 1, 0 },
    { 1, -1e-3, 0 }, 1000.001000000625, 1e-11 },
  { "S10 tangent", { 0, 0, 0 }, 1, { 0, 1, -5 }, { 0, 0, 1 }, 5, -0.0 },
  { "S11 tangent, one ulp outside", { 0, 0, 0 }, 1, { 0, 1 + 2 * U, -5 },
    { 0, 0, 1 }, HUGE_VAL, 0 },
  { "S12 tangent, one ulp inside", { 0, 0, 0 }, 1, { 0, 1 - U, -5 },
    { 0, 0, 1 }, 4.9999999850988388, 2e-10 },   // 1e-9 absolute
  { "S14 from inside", { 0, 0, 0 }, 1, { .5, 0, 0 }, { 1, 0, 0 }, .5, -0.0 },
  { "S17 1e-12 from the wall", { 0, 0, 0 }, 1, { 1 - 1e-12, 0, 0 },
    { 1, 0, 0 }, 9.999778782798785e-13, 2 * U / 9.999778782798785e-13 }
};

static const struct single *single;     // the one that is run

static void
run_single(struct run *run)
{
  model_t *model = support_model(BATTERY_HEAD "sphere s { material m center"
                                 N3 "radius %a }", AT_V(run, single->center),
                                 IN(run, single->radius));

  note_hit(run, battery_hit(run, model, single->o, single->d));
}

static void
test_singles(void)
{
  for (size_t i = 0; i < sizeof singles / sizeof *singles; i++)
    {
      single = &singles[i];
      struct run run = battery_run(single->id, run_single);
      if (single->t == HUGE_VAL)
        {
          PASS(run.note[0] == HUGE_VAL, "%s: a miss", single->id);
        }
      else if (single->tolerance > 0)
        {
          PASS_NEAR(run.note[0], single->t, single->tolerance * single->t,
                    "%s: t = %.17g", single->id, single->t);
        }
      else
        {
          PASS_ULPS(run.note[0], single->t, -single->tolerance,
                    "%s: t = %.17g", single->id, single->t);
        }
      if (strncmp(single->id, "S02", 3) == 0
          || strncmp(single->id, "S03", 3) == 0)
        {
          double tolerance = single->id[2] == '2' ? 1e-7 : 1e-3;
          PASS_NEAR(run.note[1], -.5, tolerance, "%s: N.x", single->id);
          PASS_NEAR(run.note[2], 0, tolerance, "%s: N.y", single->id);
          PASS_NEAR(run.note[3], -.8660254037844386, tolerance, "%s: N.z",
                    single->id);
        }
    }
}

// Sweeps over random rays, against four times the precision

struct roots
{
  quad t0, t1;
  quad b;                       // distance of the line from the center
  struct q_vec n0, n1;          // unit normals at the roots
};

/** 0 for a miss. */
static int
reference_roots(struct k_vec o, struct k_vec d, struct k_vec center,
                double radius, struct roots *roots)
{
  struct q_vec D = q_unit(q_of(d));
  struct q_vec f = q_sub(q_of(o), q_of(center));
  quad tca = -q_dot(f, D), r = radius;
  struct q_vec p = q_add(f, q_scale(D, tca));
  quad discriminant = r * r - q_dot(p, p);

  roots->b = q_sqrt(q_dot(p, p));
  if (discriminant < 0)
    {
      return 0;
    }
  quad s = q_sqrt(discriminant);
  roots->t0 = tca - s;
  roots->t1 = tca + s;
  roots->n0 = q_scale(q_add(p, q_scale(D, -s)), 1 / r);
  roots->n1 = q_scale(q_add(p, q_scale(D, s)), 1 / r);
  return 1;
}

struct sweep
{
  unsigned wrong;               // hit for miss or miss for hit
  unsigned undecidable;         // of those, nearer to the edge than 4 u rho
  double t, n;                  // largest error over its bound
};

/** A ray that passes the center of a sphere of radius 1 at the distance b
    after about rho. */
static void
sweep_ray(struct run *run, struct support_random *random, double rho,
          double b, struct sweep *sweep)
{
  struct k_vec o = support_point(random, 1), across, other, p;
  struct k_vec ahead = support_direction(random);
  struct roots roots = { 0 };
  double t0, t1, s, phi = support_between(random, 0, 2 * M_PI);

  battery_across(ahead, &across, &other);
  across = k_along(k_scale(across, cos(phi)), sin(phi), other);
  // unit as near as doubles can: the rounding of k_unit would count too
  struct k_vec d = q_double(q_unit(q_of(k_along(k_scale(ahead, rho), b,
                                                across))));
  struct k_vec center = k_along(o, rho, ahead);
  int expected = reference_roots(o, d, center, 1, &roots);
  o = battery_put(run, o);
  d = battery_turn(run, d);
  center = battery_put(run, center);
  int is_hit = k_sphere_hit(o, d, center, IN(run, 1), &t0, &t1, &p, &s)
    != 0;
  note_number(run, is_hit);
  double delta = 1 - (double)roots.b;
  if (is_hit != expected)
    {
      sweep->wrong++;
      sweep->undecidable += fabs(delta) < 4 * U * rho;
    }
  if (is_hit && expected)
    {
      struct k_vec n0 = k_sphere_normal(p, s, -1, d);
      struct k_vec n1 = k_sphere_normal(p, s, +1, d);
      double bound = 4 * U * rho * (1 + 1 / sqrt(2 * delta));
      note_length(run, t0);
      note_length(run, t1);
      note_direction(run, n0);
      note_direction(run, n1);
      t0 = fabs((double)(t0 / run->scale - roots.t0));
      t1 = fabs((double)(t1 / run->scale - roots.t1));
      sweep->t = battery_max(sweep->t, battery_max(t0, t1) / bound);
      n0 = battery_turn(run, n0);
      n1 = battery_turn(run, n1);
      sweep->n = battery_max(sweep->n,
                             battery_max(q_apart(n0, roots.n0),
                                         q_apart(n1, roots.n1)) / bound);
    }
}

static void
report_sweep(const struct run *run, const char *id, double rho, unsigned rays,
             struct sweep sweep)
{
  if (!run->is_told)
    {
      return;
    }
  unsigned wrong = sweep.wrong - (rho > 1e10 ? sweep.undecidable : 0);
  PASS(wrong == 0, "%s: %u hits or misses wrong of %u", id, wrong, rays);
  PASS_PART(sweep.t, "%s: t within its bound (%.2f of it)", id, sweep.t);
  PASS_PART(sweep.n, "%s: N within its bound (%.2f of it)", id, sweep.n);
}

static void
run_S04(struct run *run)
{
  const unsigned rays = 10000 / run->share;

  for (int e = 0; e <= 12; e++)
    {
      struct support_random random = support_seed(e);
      struct sweep sweep = { 0 };
      char id[40];
      for (unsigned i = 0; i < rays; i++)
        {
          sweep_ray(run, &random, pow(10, e),
                    support_between(&random, 0, 1.2), &sweep);
        }
      snprintf(id, sizeof id, "S04 at 1e%d radii", e);
      report_sweep(run, id, pow(10, e), rays, sweep);
    }
}

static void
run_S13(struct run *run)
{
  const unsigned rays = 1000 / run->share;

  for (int k = 1; k <= 13; k++)
    {
      struct support_random random = support_seed(k);
      struct sweep sweep = { 0 };
      char id[40];
      for (unsigned i = 0; i < rays; i++)
        {
          sweep_ray(run, &random, 10, 1 - pow(10, -k), &sweep);
        }
      snprintf(id, sizeof id, "S13 1e-%d from grazing", k);
      report_sweep(run, id, 10, rays, sweep);
    }
}

// Rays that start on the sphere

static model_t *
ball(const struct run *run, struct k_vec center, double radius)
{
  return support_model(BATTERY_HEAD "sphere s { material glass center" N3
                       "radius %a }", AT_V(run, center), IN(run, radius));
}

static void
run_S15(struct run *run)
{
  model_t *model = ball(run, k_vec(0, 0, 0), 1);
  unsigned hits = 0;

  for (unsigned i = 0; i < 1000; i++)
    {
      struct support_random random = support_seed(i);
      ray_t *ray = battery_ray(run, model, k_vec(3, 0, 0), k_vec(-1, 0, 0));
      [model find_closest: ray];
      struct k_vec d = battery_above(&random, k_vec(1, 0, 0), i ? 0 : 1e-8);
      ray_t *away = battery_spawn(ray, battery_turn(run, d), NO);
      [model find_closest: away];
      hits += away->hit.object != nil;
    }
  note_number(run, hits);
}

static void
run_S16(struct run *run)
{
  model_t *model = ball(run, k_vec(0, 0, 0), 1);
  ray_t *ray = battery_ray(run, model, k_vec(3, 0, 0), k_vec(-1, 0, 0));

  [model find_closest: ray];
  struct k_vec d = battery_turn(run, k_unit(k_vec(-1, .3, .1)));
  ray_t *inside = battery_spawn(ray, d, YES);
  [model find_closest: inside];
  note_hit(run, inside->hit);
}

/** Self-hit storm: from a random point of the sphere out (reflected) and in
    (refracted), then from the far wall out and back in. */
static void
storm(struct run *run, model_t *model, struct k_vec center, double radius,
      unsigned rays, unsigned *false_hits, unsigned *missed)
{
  for (unsigned i = 0; i < rays; i++)
    {
      NSAutoreleasePool *pool = [[NSAutoreleasePool alloc] init];
      struct support_random random = support_seed(i);
      struct k_vec from = support_direction(&random);
      struct k_vec to = support_direction(&random);
      struct k_vec o = k_along(center, 3 * radius, from);
      struct k_vec goal = k_along(center, .9 * radius, to);
      ray_t *ray = battery_ray(run, model, o, k_sub(goal, o));
      [model find_closest: ray];
      if (ray->hit.object == nil)       // at 1e6 radii off, by rounding
        {
          [pool release];
          continue;
        }
      struct k_vec N = battery_turn(run, ray->hit.N);
      struct k_vec up = battery_above(&random, N, 0);
      struct k_vec down = k_neg(battery_above(&random, N, 0));
      ray_t *out = battery_spawn(ray, battery_turn(run, up), NO);
      [model find_closest: out];
      *false_hits += out->hit.object != nil;
      ray_t *in = battery_spawn(ray, battery_turn(run, down), YES);
      [model find_closest: in];
      note_hit(run, in->hit);
      if (in->hit.object == nil)
        {
          ++*missed;
          [pool release];
          continue;
        }
      N = battery_turn(run, in->hit.N);
      up = battery_above(&random, N, 0);
      down = k_neg(battery_above(&random, N, 0));
      out = battery_spawn(in, battery_turn(run, up), YES);
      [model find_closest: out];
      *false_hits += out->hit.object != nil;
      in = battery_spawn(in, battery_turn(run, down), NO);
      [model find_closest: in];
      note_hit(run, in->hit);
      *missed += in->hit.object == nil;
      [pool release];
    }
}

static void
run_S18(struct run *run)
{
  static const double offsets[] = { 0, 1e3, 1e6 };
  unsigned false_hits = 0, missed = 0;

  for (int e = -9; e <= 9; e++)
    {
      for (int i = 0; i < 3; i++)
        {
          double radius = pow(10, e), off = offsets[i] * radius;
          struct k_vec center = k_vec(off, -.7 * off, .3 * off);
          storm(run, ball(run, center, radius), center, radius,
                1000 / run->share, &false_hits, &missed);
        }
    }
  if (run->is_told)
    {
      PASS(false_hits == 0, "S18 %u false hits of 114000 rays that leave a"
           " sphere's surface", false_hits);
      PASS(missed == 0, "S18 %u far walls missed by 114000 rays", missed);
    }
}

int
main(void)
{
  NSAutoreleasePool *pool = [[NSAutoreleasePool alloc] init];

  test_singles();
  battery_run_share("S04 ratio sweep", run_S04, 10, 1);
  battery_run_share("S13 grazing sweep", run_S13, 1, 1);
  struct run run = battery_run("S15 on the surface, going away", run_S15);
  PASS(run.note[0] == 0, "S15 %g of 1000 rays that leave the surface meet it",
       run.note[0]);
  run = battery_run("S16 on the surface, going in", run_S16);
  PASS_ULPS(run.note[0], 1.9069251784911848, 2, "S16 the far side");
  battery_run_share("S18 self-hit storm", run_S18, 10, 1);
  [pool release];
  return test_done();
}
