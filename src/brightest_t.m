#import "brightest_t.h"
#import "grow.h"
#import "light_t.h"
#import "material_t.h"
#import "model_t.h"

/** What the surfaces of one material give and pass on. */
struct source
{
  material_t *material;
  struct cut_most own;          // b = own + passed on * what comes back
  struct k_vec passed;
};

/** a b for colours, where nothing of anything is nothing. */
static struct k_vec
part(struct k_vec a, struct k_vec b)
{
  return k_vec(a.x == 0 || b.x == 0 ? 0 : a.x * b.x,
               a.y == 0 || b.y == 0 ? 0 : a.y * b.y,
               a.z == 0 || b.z == 0 ? 0 : a.z * b.z);
}

/** The most that a light sheds on an object. */
static struct k_vec
light_on(light_t *light, object_t *object)
{
  double rounding = object->slack + 16 * K_U * k_norm1(light->location);
  double r = [object distanceFrom: light->location] * (1 - 0x1p-30) - rounding;
  double fall = light->falloff == 0 ? 1 : k_max2(r, 0);

  fall = light->falloff == 2 ? fall * fall : fall;
  return part(light->emissivity, k_vec(1 / fall, 1 / fall, 1 / fall));
}

static void
add_object(struct source *source, object_t *object, NSArray *lights)
{
  const material_t *m = source->material;
  struct k_vec light = k_vec(0, 0, 0);
  BOOL is_mirror = !k_is_zero(m->specular);

  for (light_t *l in lights)
    {
      light = k_add(light, light_on(l, object));
    }
  struct k_vec diffuse = part(m->diffuse, light);
  diffuse = is_mirror ? part(m->diffuse, diffuse) : diffuse;
  double own = 1 - m->alpha;
  struct k_vec rest = k_add(part(k_vec(own, own, own), diffuse),
                            part(m->specular, light));
  source->own.rest = cut_larger(source->own.rest, rest);
}

static struct source
source_of(material_t *m, NSUInteger lights)
{
  BOOL is_mirror = !k_is_zero(m->specular);
  struct k_vec ambient = k_scale(m->ambient, 1 + 0.1 * lights);
  struct source source = { .material = m };

  ambient = is_mirror ? k_mul(m->diffuse, ambient) : ambient;
  source.own.ambient = k_scale(ambient, 1 - m->alpha);
  source.passed = k_add(k_scale(m->specular, 1 - m->alpha),
                        k_vec(m->alpha, m->alpha, m->alpha));
  return source;
}

@implementation brightest_t

/** All materials that are seen, with what their objects give. */
static struct source *
sources_of(model_t *model, unsigned *count)
{
  NSMapTable *places = NSCreateMapTable(NSNonOwnedPointerMapKeyCallBacks,
                                        NSIntegerMapValueCallBacks, 0);
  struct source *sources = new_array([model->materials count] + 1,
                                     sizeof *sources);
  NSUInteger lights = [model->lights count];
  struct source *source = NULL;

  *count = 0;
  for (object_t *object in model->objects)
    {
      material_t *material = object->material;
      if (source == NULL || source->material != material)
        {
          uintptr_t place = (uintptr_t)NSMapGet(places, material);
          if (place == 0)
            {
              sources[(*count)++] = source_of(material, lights);
              place = *count;
              NSMapInsert(places, material, (void *)place);
            }
          source = &sources[place - 1];
        }
      add_object(source, object, model->lights);
    }
  NSFreeMapTable(places);
  return sources;
}

/** Takes out what passes nothing on; *most is then no less than what it gives.
    Returns how many are left. */
static unsigned
leave_dull(struct source *sources, unsigned count, struct cut_most *most)
{
  unsigned left = 0;

  for (unsigned i = 0; i < count; i++)
    {
      if (!k_is_zero(sources[i].passed))
        {
          sources[left++] = sources[i];
          continue;
        }
      most->ambient = cut_larger(most->ambient, sources[i].own.ambient);
      most->rest = cut_larger(most->rest, sources[i].own.rest);
    }
  return left;
}

static BOOL
is_same(struct cut_most a, struct cut_most b)
{
  return k_is_equal(a.ambient, b.ambient) && k_is_equal(a.rest, b.rest);
}

- (id) initWithModel: (model_t *)model generations: (unsigned)generations
{
  if ((self = [super init]))
    {
      unsigned sources_count;
      struct source *sources = sources_of(model, &sources_count);
      struct cut_most before = { { 0, 0, 0 }, { 0, 0, 0 } }, now;
      struct cut_most dull = { { 0, 0, 0 }, model->background };
      unsigned room = 0;

      sources_count = leave_dull(sources, sources_count, &dull);
      for (unsigned g = 0; g <= generations; g++, before = now)
        {
          now = dull;
          for (unsigned i = 0; i < sources_count; i++)
            {
              const struct source *s = &sources[i];
              now.ambient = cut_larger(now.ambient,
                                   k_add(s->own.ambient,
                                         part(s->passed, before.ambient)));
              now.rest = cut_larger(now.rest,
                                k_add(s->own.rest,
                                      part(s->passed, before.rest)));
            }
          if (g > 0 && is_same(now, before))
            {
              break;
            }
          grow((void **)&most, count, &room, sizeof *most);
          most[count++] = now;
        }
      free(sources);
    }
  return self;
}

- (void) dealloc
{
  free(most);
  [super dealloc];
}

@end
