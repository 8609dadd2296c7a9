#import "ray_t.h"
#import "light_t.h"
#import "material_t.h"
#import "model_t.h"
#import "object_t.h"
#import "ray_steps.h"
#include "shade.h"

@implementation ray_t

- (id) init: (vec_t *)start : (vec_t *)direction
{
  if ((self = [super init]))
    {
      struct k_vec d = direction->v;

      pos = [start retain];
      dir = [direction retain];
      inverse = k_vec(1 / d.x, 1 / d.y, 1 / d.z);
      shear = k_shear(d);
      end = HUGE_VAL;
      hit.t = HUGE_VAL;
      tie = -1;
      counters = &own_counters;
    }
  return self;
}

- (id) init: (vec_t *)start : (vec_t *)direction
       from: (ray_t *)parent through: (BOOL)through
{
  if ((self = [self init: start : direction]))
    {
      BOOL came_from_inside = !(k_dot(parent->hit.N, parent->dir->v) < 0);

      dis = parent->dis;
      media = [parent->media retain];
      depth = parent->depth + 1;
      counters = parent->counters;
      from = parent->hit.object;
      starts_inside = came_from_inside != through;
      slack = from->slack + 16 * K_U * k_norm1(start->v);
    }
  return self;
}

- (id) initFeeler: (vec_t *)start : (vec_t *)direction : (double)r
             from: (ray_t *)parent to: (light_t *)light
{
  if ((self = [self init: start : direction from: parent through: NO]))
    {
      is_feeler = YES;
      end = r;
      end_slack = 16 * K_U * (k_norm1(start->v) + k_norm1(light->location));
    }
  return self;
}

- (void) dealloc
{
  [pos release];
  [dir release];
  [media release];
  [super dealloc];
}

// What the object says of its hits

- (BOOL) wants: (double)t
{
  return t > 0 && t <= hit.t && t < end;
}

/** Keeps a hit that is known to be in front if it is the nearest. */
- (BOOL) exits: (object_t *)object at: (double)t normal: (struct k_vec)N
         point: (struct k_vec)P
{
  if (is_feeler)
    {
      // As far as the light, as near as can be told, is not before it.
      double before = (end - t) * fabs(k_dot(N, dir->v));
      if (!(before > end_slack + object->slack))
        {
          return NO;
        }
    }
  if (t == hit.t && object != hit.object)
    {
      tie = t;
    }
  if (!(t < hit.t || (t == hit.t && object->number < hit.object->number)))
    {
      return NO;
    }
  hit.t = t;
  hit.object = object;
  hit.P = P;
  hit.N = N;
  hit.is_compensated = NO;
  return YES;
}

- (BOOL) meets: (object_t *)object at: (double)t normal: (struct k_vec)N
         point: (struct k_vec)P
{
  if (!(t > 0))
    {
      return NO;
    }
  // The surface passes through the place where the ray starts, as near as
  // can be told: it is met at t = 0. Its distance from there is t |N.dir|.
  if (from && t * fabs(k_dot(N, dir->v)) <= slack + object->slack)
    {
      return NO;
    }
  return [self exits: object at: t normal: N point: P];
}

- (BOOL) meets: (object_t *)object at: (double)t normal: (struct k_vec)N
{
  return [self meets: object at: t normal: N
               point: k_along(pos->v, t, dir->v)];
}

- (BOOL) leaves: (object_t *)object at: (double *)t
{
  ray_t *probe = [[ray_t alloc] init: pos : dir];

  probe->media = [media retain];
  probe->from = from;
  probe->starts_inside = starts_inside;
  probe->slack = slack;
  [(id <object_t>)object hits: probe];
  counters->tests++;
  *t = probe->hit.t;
  BOOL is_exit = probe->hit.object && k_dot(probe->hit.N, dir->v) > 0;
  [probe release];
  return is_exit;
}

/** Counts a hit that is near the edge of what is certain. */
- (void) countHit
{
  counters->ties += tie == hit.t;
  counters->compensated += hit.is_compensated;
}

- (void) forgetMediaLeft
{
  media_t *kept = media;

  for (media_t *m = media; m; m = m->below)
    {
      double t;
      BOOL is_hit = [hit.object medium] == m->object;
      if (!is_hit && !k_is_unbounded([m->object bounds])
          && ![self leaves: m->object at: &t])
        {
          kept = [media_t leave: m->object from: kept];
          counters->escapes++;
        }
    }
  if (kept != media)
    {
      [kept retain];
      [media release];
      media = kept;
    }
}

// Tracing

- (BOOL) cutsFeeler: (struct k_vec)off
{
  return cut_feeler_is(&cut, off);
}

/** Whether light e from L is taken to arrive at the hit point, because it
    makes too little of a difference. */
- (BOOL) takesAsLit: (struct k_vec)Ns : (struct k_vec)L : (struct k_vec)e
{
  const struct k_vec black = k_vec(0, 0, 0);
  material_t *m = hit.object->material;
  BOOL is_mirror = !k_is_zero(m->specular);
  struct k_vec lit = shade_lit(black, m->diffuse, e, k_dot(Ns, L));
  struct k_vec shadow = shade_shadow(black, shade_ambient(m->ambient, dis));
  struct k_vec off = cut_feeler_off(m->diffuse, is_mirror, m->alpha, lit,
                                    shadow);

  if (is_mirror)
    {
      off = shade_highlight(off, m->specular, e, Ns, L, k_neg(dir->v),
                            m->shininess);
    }
  return [self cutsFeeler: off];
}

- (BOOL) sees: (light_t *)light in: (model_t *)model from: (vec_t *)P
             : (struct k_vec)Ns : (struct k_vec *)L : (struct k_vec *)e
{
  struct k_vec l = k_sub(light->location, P->v);
  double r = k_length(l);

  *L = k_unit(l);
  if (!(r > 0 && k_dot(Ns, *L) > 0))
    {
      return NO;
    }
  *e = shade_falloff(light->emissivity, r, light->falloff);
  if (model->choice.no_shadows
      || (cut_is_on(&model->cut) && model->cut.max_error > 0
          && [self takesAsLit: Ns : *L : *e]))
    {
      return YES;
    }
  ray_t *feeler = [(ray_t *)[[self class] alloc]
                    initFeeler: P : [vec_t vec: *L] : r from: self to: light];
  counters->feeler++;
  [model find_closest: feeler];
  BOOL is_lit = feeler->hit.object == nil;
  [feeler release];
  return is_lit;
}

/** Whether a ray that would be spawned is not wanted, or not worth it; if not,
    *branch is what it is as a branch. */
- (BOOL) cuts: (enum cut_which)which of: (struct cut_pair *)pair
           in: (model_t *)model as: (struct cut *)branch
{
  if (which == CUT_REFLECTED ? model->choice.no_reflection
      : model->choice.no_refraction)
    {
      return YES;
    }
  return cut_is_on(&model->cut)
    && cut_is(&model->cut, &cut, pair, which, depth == model->max_depth,
              branch);
}

/** What comes along the reflected ray. */
- (struct k_vec) reflectionFrom: (vec_t *)P : (vec_t *)Ns
                             in: (model_t *)model
                             as: (const struct cut *)branch
{
  vec_t *r = [vec_t vec: shade_renew([dir reflect: Ns]->v)];
  ray_t *reflection = [(ray_t *)[[self class] alloc] init: P : r
                                                     from: self through: NO];

  counters->reflection += depth < model->max_depth;
  reflection->cut = *branch;
  struct k_vec color = [reflection trace: model]->v;
  cut_add(&cut, &reflection->cut);
  [reflection release];
  return color;
}

/** What comes along the refracted ray, which runs along t in `inside`. */
- (struct k_vec) refractionFrom: (vec_t *)P : (vec_t *)t
                             in: (model_t *)model media: (media_t *)inside
                             as: (const struct cut *)branch
{
  ray_t *refraction = [(ray_t *)[[self class] alloc] init: P : t
                                                     from: self through: YES];

  counters->refraction += depth < model->max_depth;
  [inside retain];
  [refraction->media release];
  refraction->media = inside;
  refraction->cut = *branch;
  struct k_vec color = [refraction trace: model]->v;
  cut_add(&cut, &refraction->cut);
  [refraction release];
  return color;
}

- (vec_t *) refractAt: (vec_t *)Ns inside: (media_t **)inside
          reflectance: (double *)R of: (model_t *)model
{
  object_t *medium = [hit.object medium];
  double ior = hit.object->material->ior;
  BOOL goes_in = k_dot(hit.N, dir->v) < 0;
  double n_i = [media_t ior: media];
  double n_t = ior;
  int tir, is_critical;

  *inside = media;
  if (medium && goes_in)
    {
      *inside = [media_t enter: medium : ior over: media];
    }
  else if (medium)
    {
      *inside = [media_t leave: medium from: media];
      n_i = ior;
      n_t = [media_t ior: *inside];
      counters->unbalanced += *inside == media;
    }
  struct k_vec T = shade_refract_near(dir->v, Ns->v, n_t / n_i, &tir,
                                      &is_critical);
  counters->critical += is_critical;
  *R = tir ? 1 : model->choice.exact_fresnel
    ? shade_fresnel(dir->v, Ns->v, T, n_i, n_t)
    : shade_schlick(dir->v, Ns->v, T, n_i, n_t);
  return medium && n_i != n_t ? [vec_t vec: shade_renew(T)] : dir;
}

- (vec_t *) trace: (model_t *)model
{
  if (depth > model->max_depth)
    {
      return [vec_t vec: k_vec(0, 0, 0)];
    }
  [model find_closest: self];
  if (hit.object == nil)
    {
      return [vec_t vec: model->background];
    }
  [self countHit];
  [self forgetMediaLeft];
  dis += hit.t;

  material_t *m = hit.object->material;
  BOOL is_mirror = !k_is_zero(m->specular);
  vec_t *P = [vec_t vec: hit.P];
  vec_t *N = [vec_t vec: hit.N];
  vec_t *Ns = [N dot: dir] < 0 ? N : [N scale: -1.0];
  struct k_vec V = k_neg(dir->v);

  // One reflection ray serves the mirror and the transparent surface.
  struct k_vec reflected = k_vec(0, 0, 0);
  struct k_vec refracted = k_vec(0, 0, 0);
  double R = 0;
  media_t *inside = nil;
  vec_t *t = nil;
  struct cut_pair pair = { 0 };
  struct cut branch = { 0 };

  if (m->alpha > 0)
    {
      t = [self refractAt: Ns inside: &inside reflectance: &R of: model];
    }
  if (cut_is_on(&model->cut))
    {
      cut_pair(&pair, &model->cut, &cut, m->specular, m->alpha, R, depth + 1,
               dis);
    }
  if ((is_mirror || R > 0)
      && ![self cuts: CUT_REFLECTED of: &pair in: model as: &branch])
    {
      reflected = [self reflectionFrom: P : Ns in: model as: &branch];
    }
  if (m->alpha > 0 && R < 1
      && ![self cuts: CUT_REFRACTED of: &pair in: model as: &branch])
    {
      refracted = [self refractionFrom: P : t in: model media: inside
                                    as: &branch];
    }

  // Lights come last: their feelers get what the branches leave of the error.
  struct k_vec A = shade_ambient(m->ambient, dis);
  struct k_vec color = A;
  struct k_vec highlights = k_vec(0, 0, 0);

  for (light_t *light in model->lights)
    {
      struct k_vec L, e;
      if ([self sees: light in: model from: P : Ns->v : &L : &e])
        {
          color = shade_lit(color, m->diffuse, e, k_dot(Ns->v, L));
          if (is_mirror)
            {
              highlights = shade_highlight(highlights, m->specular, e,
                                           Ns->v, L, V, m->shininess);
            }
        }
      else
        {
          color = shade_shadow(color, A);
        }
    }

  if (is_mirror)
    {
      color = shade_mirror(color, m->diffuse, m->specular, reflected);
    }
  if (m->alpha > 0)
    {
      color = shade_blend(color, m->alpha, R, refracted, reflected);
    }
  return [vec_t vec: k_add(color, highlights)];
}

@end
