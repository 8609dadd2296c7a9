#import "witness_text.h"
#import "light_t.h"
#import "material_t.h"
#import "model_t.h"
#import "object_t.h"
#include "number.h"
#include "shade.h"

enum { COLUMN = 14, DEEPEST = 20 };     // deeper rays are indented no further

static NSString *
number(double x)
{
  locale_t c = newlocale(LC_ALL_MASK, "C", (locale_t)0);
  char text[32];

  number_write(x, c, text);
  freelocale(c);
  return [NSString stringWithUTF8String: text];
}

static NSString *
three(struct k_vec v)
{
  return [NSString stringWithFormat: @"%@ %@ %@", number(v.x), number(v.y),
                   number(v.z)];
}

/** "sphere 'ball' (object 3)" (autoreleased). */
static NSString *
name_of(object_t *object)
{
  NSString *class = NSStringFromClass([object class]);

  if ([class hasSuffix: @"_t"])
    {
      class = [class substringToIndex: [class length] - 2];
    }
  return [NSString stringWithFormat: @"%@ '%@' (object %u)", class,
                   [object name], object->number];
}

static void
tell(struct witness_text *to, NSString *label, NSString *rest)
{
  unsigned indent = 2 * MIN(to->depth, DEEPEST);

  [to->text appendFormat: @"%*s%-*s%@\n", (int)indent, "", COLUMN,
      [label UTF8String], rest];
}

void
witness_tell_vec(struct witness_text *to, NSString *label, struct k_vec v)
{
  tell(to, label, three(v));
}

void
witness_tell_number(struct witness_text *to, NSString *label, double x)
{
  tell(to, label, number(x));
}

/** A term: what it is worth, and how much of that is in the pixel. */
static void
tell_term(struct witness_text *to, NSString *label, struct k_vec value,
          struct k_vec weight)
{
  tell(to, label, [NSString stringWithFormat: @"value %@ weight %@",
                            three(value), three(weight)]);
}

/** What a ray is in, from the top of the stack down (autoreleased). */
static NSString *
media_text(media_t *media)
{
  NSMutableArray *words = [NSMutableArray array];

  for (; media; media = media->below)
    {
      [words addObject: [NSString stringWithFormat: @"%@ ior %@",
                                  name_of(media->object),
                                  number(media->ior)]];
    }
  return [words count] ? [words componentsJoinedByString: @", in "] : @"air";
}

/** Where the ray is near the edge of what is certain: counters.h. */
static void
tell_edges(struct witness_text *to, witness_t *ray)
{
  NSMutableArray *words = [NSMutableArray array];

  if (ray->hit.is_compensated)
    {
      [words addObject: @"compensated"];
    }
  if (ray->tie == ray->hit.t)
    {
      [words addObject: @"tie"];
    }
  if (ray->start != ray->media)
    {
      [words addObject: @"escape"];
    }
  if (ray->is_critical)
    {
      [words addObject: @"critical"];
    }
  if (ray->is_unbalanced)
    {
      [words addObject: @"unbalanced"];
    }
  if ([words count])
    {
      tell(to, @"near the edge", [words componentsJoinedByString: @", "]);
    }
}

/** Where the ray goes and what it hits. */
static void
tell_path(struct witness_text *to, witness_t *ray)
{
  witness_tell_vec(to, @"starts at", ray->pos->v);
  witness_tell_vec(to, @"dir", ray->dir->v);
  tell(to, @"in", media_text(ray->start));
  if (ray->start != ray->media)
    {
      tell(to, @"still in", media_text(ray->media));
    }
  if (ray->hit.object == nil)
    {
      tell(to, @"hits", @"nothing");
      return;
    }
  tell(to, @"hits", [NSString stringWithFormat: @"%@ from %s",
                              name_of(ray->hit.object),
                              k_dot(ray->hit.N, ray->dir->v) < 0 ? "outside"
                              : "inside"]);
  witness_tell_number(to, @"t", ray->hit.t);
  witness_tell_number(to, @"dis", ray->dis);
  witness_tell_vec(to, @"P", ray->hit.P);
  witness_tell_vec(to, @"N", ray->hit.N);
  tell_edges(to, ray);
}

/** What was not traced, and the most that the pixel is off for it. */
static NSString *
with_error(NSString *text, double error)
{
  return [text stringByAppendingFormat: @", pixel off by at most %@",
               number(error)];
}

/** What one light gives, in the terms of shade.h: `local` is the weight of
    ambient and diffuse light, W that of highlights. */
static void
tell_light(struct witness_text *to, witness_t *ray, unsigned i,
           struct k_vec local, struct k_vec W, double share)
{
  const struct k_vec black = k_vec(0, 0, 0);
  const struct seen_light *seen = &ray->lights[i];
  material_t *m = ray->hit.object->material;
  struct k_vec N = ray->hit.N, D = ray->dir->v;
  struct k_vec Ns = k_dot(N, D) < 0 ? N : k_scale(N, -1.0);
  NSString *label = [NSString stringWithFormat: @"light %u", i + 1];

  if (!seen->is_lit)
    {
      tell(to, label, seen->blocker
           ? [@"in shadow of " stringByAppendingString: name_of(seen->blocker)]
           : @"in shadow of the surface itself");
      tell_term(to, @"  shadow",
                shade_shadow(black, shade_ambient(m->ambient, ray->dis)),
                local);
      return;
    }
  double n_dot_l = k_dot(Ns, seen->L);
  NSString *text = [NSString stringWithFormat: @"%@lit, r %@, Ns.L %@",
                             seen->is_cut ? @"taken to be " : @"",
                             number(seen->r), number(n_dot_l)];
  tell(to, label, seen->is_cut ? with_error(text, seen->loss * share) : text);
  tell_term(to, @"  diffuse",
            shade_lit(black, m->diffuse, seen->e, n_dot_l), local);
  if (!k_is_zero(m->specular))
    {
      tell_term(to, @"  highlight",
                shade_highlight(black, m->specular, seen->e, Ns, seen->L,
                                k_neg(D), m->shininess), W);
    }
}

/** The line of the reflected or the refracted ray. */
static void
tell_branch(struct witness_text *to, NSString *label, witness_t *ray,
            const struct seen_branch *branch, struct k_vec weight,
            double share)
{
  model_t *model = to->model;

  if (branch->ray && ray->depth < model->max_depth)
    {
      tell_term(to, label, branch->ray->color, weight);
      return;
    }
  NSString *why = branch->is_left_out ? @"left out"
    : branch->ray || ray->depth == model->max_depth
    ? @"black, too deep" : branch->is_cut ? @"cut" : nil;
  if (why == nil)
    {
      return;                   // there is none
    }
  if (branch->is_cut)
    {
      why = with_error(why, branch->loss * share);
    }
  tell(to, label, [NSString stringWithFormat: @"%@, weight %@", why,
                            three(weight)]);
}

/** The terms of the colour at the hit point, and the rays that it spawned. */
static void
tell_terms(struct witness_text *to, witness_t *ray, NSString *name,
           struct k_vec W, double share)
{
  material_t *m = ray->hit.object->material;
  const struct seen_branch *reflected = &ray->branches[CUT_REFLECTED];
  const struct seen_branch *refracted = &ray->branches[CUT_REFRACTED];
  BOOL is_mirror = !k_is_zero(m->specular);
  double R = ray->R, alpha = m->alpha, bounce = alpha * R;
  struct k_vec own = k_scale(W, 1 - alpha);
  struct k_vec local = is_mirror ? k_mul(own, m->diffuse) : own;
  struct k_vec mirror = k_add(k_mul(own, m->specular), k_scale(W, bounce));
  struct k_vec through = k_scale(W, alpha * (1 - R));

  tell_term(to, @"ambient", shade_ambient(m->ambient, ray->dis), local);
  for (unsigned i = 0; i < [to->model->lights count]; i++)
    {
      tell_light(to, ray, i, local, W, share);
    }
  if (alpha > 0)
    {
      witness_tell_number(to, @"R", R);
    }
  if (is_mirror || R > 0)
    {
      tell_branch(to, @"reflection", ray, reflected, mirror, share);
    }
  if (alpha > 0 && R < 1)
    {
      tell_branch(to, @"refraction", ray, refracted, through, share);
    }
  witness_tell_vec(to, @"color", ray->color);
  if (ray->depth == to->model->max_depth)
    {
      return;
    }
  to->depth++;
  if (reflected->ray)
    {
      witness_tell(to, reflected->ray, [name stringByAppendingString: @"r"],
                   mirror, share);
    }
  if (refracted->ray)
    {
      witness_tell(to, refracted->ray, [name stringByAppendingString: @"t"],
                   through, share);
    }
  to->depth--;
}

void
witness_tell(struct witness_text *to, witness_t *ray, NSString *name,
             struct k_vec W, double share)
{
  const char *kind = ray->depth == 0 ? "eye"
    : ray->is_through ? "refraction" : "reflection";

  [to->text appendString: @"\n"];
  tell(to, [@"ray " stringByAppendingString: name],
       [NSString stringWithFormat: @"%s, generation %u", kind, ray->depth]);
  witness_tell_vec(to, @"weight", W);
  tell_path(to, ray);
  if (ray->hit.object)
    {
      tell_terms(to, ray, name, W, share);
    }
  else
    {
      tell_term(to, @"background", ray->color, W);
    }
}
