#import "witness_t.h"
#import "grow.h"
#import "light_t.h"
#import "model_t.h"

@implementation witness_t

- (id) init: (vec_t *)aPos : (vec_t *)aDir
       from: (ray_t *)aParent through: (BOOL)through
{
  if ((self = [super init: aPos : aDir from: aParent through: through]))
    {
      parent = (witness_t *)aParent;
      is_through = through;
    }
  return self;
}

- (id) initFeeler: (vec_t *)aPos : (vec_t *)aDir : (double)r
             from: (ray_t *)aParent to: (light_t *)light
{
  if ((self = [super initFeeler: aPos : aDir : r from: aParent to: light]))
    {
      ASSIGN(parent->feeler, self);
    }
  return self;
}

- (void) dealloc
{
  [branches[CUT_REFLECTED].ray release];
  [branches[CUT_REFRACTED].ray release];
  [start release];
  [feeler release];
  free(lights);
  [super dealloc];
}

- (BOOL) sees: (light_t *)light in: (model_t *)model from: (vec_t *)P
             : (struct k_vec)Ns : (struct k_vec *)L : (struct k_vec *)e
{
  BOOL is_lit = [super sees: light in: model from: P : Ns : L : e];
  struct seen_light seen = { .is_lit = is_lit, .L = *L };

  if (is_lit)
    {
      seen.e = *e;
      seen.r = k_length(k_sub(light->location, P->v));
      seen.is_cut = is_feeler_cut;
      seen.loss = feeler_loss;
      is_feeler_cut = NO;
    }
  if (feeler)
    {
      seen.blocker = feeler->hit.object;
      DESTROY(feeler);
    }
  if (lights == NULL)
    {
      lights = new_array([model->lights count], sizeof *lights);
    }
  lights[light_count++] = seen;
  return is_lit;
}

- (BOOL) cutsFeeler: (struct k_vec)off
{
  is_feeler_cut = [super cutsFeeler: off];
  feeler_loss = cut_loss(cut.weight, off);
  return is_feeler_cut;
}

- (vec_t *) refractAt: (vec_t *)Ns inside: (media_t **)inside
          reflectance: (double *)reflectance of: (model_t *)model
{
  struct counters before = *counters;
  vec_t *t = [super refractAt: Ns inside: inside reflectance: reflectance
                           of: model];

  is_critical = counters->critical > before.critical;
  is_unbalanced = counters->unbalanced > before.unbalanced;
  R = *reflectance;
  return t;
}

- (BOOL) cuts: (enum cut_which)which of: (struct cut_pair *)pair
           in: (model_t *)model as: (struct cut *)branch
{
  BOOL is_cut = [super cuts: which of: pair in: model as: branch];
  struct seen_branch *seen = &branches[which];

  seen->is_left_out = which == CUT_REFLECTED ? model->choice.no_reflection
    : model->choice.no_refraction;
  seen->is_cut = is_cut && !seen->is_left_out;
  seen->loss = seen->is_cut ? pair->loss[which] : 0;
  return is_cut;
}

- (vec_t *) trace: (model_t *)model
{
  ASSIGN(start, media);
  vec_t *result = [super trace: model];
  color = result->v;
  if (parent)
    {
      ASSIGN(parent->branches[is_through ? CUT_REFRACTED : CUT_REFLECTED].ray,
             self);
    }
  return result;
}

@end
