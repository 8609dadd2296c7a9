#import "render_t.h"
#import "camera_t.h"

// Bytes of a thread's stack: rays are traced by recursion, and deep ones in
// many media at once need more than threads commonly have. A generation takes
// about 1 KB in either engine, and several times that without optimisation or
// with sanitizers; only what is used becomes memory.
#if defined(__SANITIZE_ADDRESS__) || !defined(__OPTIMIZE__)
#define STACK_GENERATION ((size_t)24 << 10)
#else
#define STACK_GENERATION ((size_t)4 << 10)
#endif

@implementation render_t

+ (size_t) stackFor: (unsigned)generations
{
  size_t size = generations * STACK_GENERATION;

  return MAX(size, RENDER_STACK_LEAST);
}

- (id) init: (id <engine_t>)anEngine camera: (camera_t *)aCamera
       into: (image_t *)anImage options: (struct render_options)someOptions
{
  if ((self = [super init]))
    {
      engine = [anEngine retain];
      camera = [aCamera retain];
      image = [anImage retain];
      lock = [[NSLock alloc] init];
      options = someOptions;
      options.stack = MAX(options.stack, RENDER_STACK_LEAST);
      [self cover: image->window];
      all_tiles = tile_count;
    }
  return self;
}

- (void) dealloc
{
  [image release];
  [camera release];
  [engine release];
  [lock release];
  free(pilots.at);
  free(timed);
  free(tile_shown);
  free(tile_is_added);
  [super dealloc];
}

/** Rays that are to be traced together, of the pixels of one block; what has
    come back for each of these. Only when all has, it goes into the picture. */
struct bundle
{
  struct sample samples[EYE_RAYS];
  unsigned char pixels[EYE_RAYS];       // whose ray it is
  unsigned count;
  struct k_vec colors[EYE_RAYS];        // sums, pixel by pixel
  double errors[EYE_RAYS];              // likewise; if anybody asks
};

/** Whether errors of rays that are not traced are added up. */
static inline BOOL
has_errors(const image_t *image)
{
#ifdef NO_CUTS
  return NO;                    // cut.h
#else
  return image->planes[PLANE_TRUNCATION] != NULL;
#endif
}

/** Traces a bundle and adds each colour to its pixel's, in order. */
static void
trace(const render_t *self, struct bundle *bundle, struct counters *count)
{
  struct eye_ray rays[EYE_RAYS];

  [self->camera rays: rays : bundle->count of: bundle->samples];
  [self->engine trace: rays : bundle->count counters: count];
  for (unsigned i = 0; i < bundle->count; i++)
    {
      struct k_vec *color = &bundle->colors[bundle->pixels[i]];
      *color = k_add(*color, rays[i].color);
    }
  for (unsigned i = 0; has_errors(self->image) && i < bundle->count; i++)
    {
      bundle->errors[bundle->pixels[i]] += rays[i].error;
    }
  bundle->count = 0;
}

static inline void
add(const render_t *self, unsigned pixel, const struct sample *sample,
    struct bundle *bundle, struct counters *count)
{
  bundle->samples[bundle->count] = *sample;
  bundle->pixels[bundle->count++] = pixel;
  if (bundle->count == EYE_RAYS)
    {
      trace(self, bundle, count);
    }
}

/** All rays of a pixel go into the bundle. */
static inline void
add_all(const render_t *self, unsigned pixel, struct sample sample,
        struct ray_places *places, struct bundle *bundle,
        struct counters *count)
{
  if (places->rays == 1 && !places->has_lens)
    {
      add(self, pixel, &sample, bundle, count);
      return;
    }
  ray_places_begin(places, sample.column, sample.row, 0);
  for (uint64_t ray = 0; ray < places->rays; ray++)
    {
      ray_places_set(places, ray, &sample);
      add(self, pixel, &sample, bundle, count);
    }
}

- (struct ray_places) places
{
  unsigned exposure = camera->exposure;
  struct ray_places places = {
    .sampler = options.sampler, .seed = options.seed,
    .samples = options.samples, .exposure = exposure,
    .rays = (uint64_t)options.samples * exposure,
    .moves_in_pixel = options.samples > 1,
    .has_lens = camera_has_lens(camera)
  };

  return places;
}

/** The pixels of a window, which is at most a block; each colour is the mean of
    all its rays. */
- (void) pixelsOf: (struct window)w counters: (struct counters *)count
{
  struct ray_places places = [self places];
  double rays = (double)places.rays;
  unsigned across = w.x1 - w.x0, pixels = across * (w.y1 - w.y0), pixel = 0;
  double *errors = image->planes[PLANE_TRUNCATION];
  struct bundle bundle;

  NSAssert(pixels <= EYE_RAYS, @"a block of pixels is too large");
  bundle.count = 0;
  memset(bundle.colors, 0, sizeof bundle.colors);
  memset(bundle.errors, 0, sizeof bundle.errors);
  for (unsigned y = w.y0; y < w.y1; y++)
    {
      for (unsigned x = w.x0; x < w.x1; x++, pixel++)
        {
          struct sample sample = { .column = x, .row = image->rows - 1 - y };
          add_all(self, pixel, sample, &places, &bundle, count);
        }
    }
  trace(self, &bundle, count);
  for (unsigned i = 0; rays > 1 && i < pixels; i++)
    {
      bundle.colors[i] = k_div(bundle.colors[i], rays);
      bundle.errors[i] /= rays;
    }
  for (unsigned y = w.y0, i = 0; y < w.y1; y++, i += across)
    {
      [image put: &bundle.colors[i] : across at: w.x0 : y];
      if (errors)
        {
          memcpy(&errors[image_at(image, w.x0, y)], &bundle.errors[i],
                 across * sizeof *errors);
        }
    }
}

/** What the rays through the middle of each pixel and of the lens hit. */
- (void) surfacesOf: (struct window)w
{
  for (unsigned y = w.y0; y < w.y1; y++)
    {
      for (unsigned x = w.x0; x < w.x1; x++)
        {
          struct sample sample = { .column = x, .row = image->rows - 1 - y };
          struct k_vec o, d;
          [camera centralRay: sample pos: &o dir: &d];
          *[image surfaceAt: x : y] = [engine surfaceAt: o : d];
        }
    }
}

/** A tile, in blocks whose rays go much the same way. */
- (void) tile: (unsigned)tile counters: (struct counters *)count
{
  struct window w = [self windowOf: tile];

  for (unsigned y = w.y0; y < w.y1; y += BLOCK_DOWN)
    {
      for (unsigned x = w.x0; x < w.x1; x += BLOCK_ACROSS)
        {
          struct window block = { x, y, MIN(x + BLOCK_ACROSS, w.x1),
                                  MIN(y + BLOCK_DOWN, w.y1) };
          if (image->surfaces)
            {
              [self surfacesOf: block];
            }
          if (options.noise > 0)
            {
              [self adaptivePixelsOf: block counters: count];
            }
          else
            {
              [self pixelsOf: block counters: count];
            }
        }
    }
}

- (void) work
{
  NSAutoreleasePool *pool = [[NSAutoreleasePool alloc] init];
  struct counters mine = { 0 };
  unsigned tile;

  while ((tile = __atomic_fetch_add(&next_tile, 1, __ATOMIC_RELAXED))
         < tile_count)
    {
      [self tile: tile counters: &mine];
      __atomic_fetch_add(&tiles_done, 1, __ATOMIC_RELAXED);
    }
  [lock lock];
  counters_add(&counters, &mine);
  [lock unlock];
  [pool release];
}

- (double) done
{
  return all_tiles ? (double)__atomic_load_n(&tiles_done, __ATOMIC_RELAXED)
    / all_tiles : 1;
}

- (void) run
{
  if (options.noise > 0)
    {
      [self runAdaptive];
    }
  else
    {
      [self inThreads: @selector(work)];
    }
}

@end
