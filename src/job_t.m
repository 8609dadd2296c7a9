// job_t.m

#import "job_t.h"
#import "brightest_t.h"
#import "camera_t.h"
#import "compiler_t.h"
#import "diag_t.h"
#import "errors.h"
#import "exr_channel.h"
#import "exr_t.h"
#import "explain_t.h"
#import "fast_t.h"
#import "machine.h"
#import "model_t.h"
#import "notes_t.h"
#import "outfile_t.h"
#import "parser_t.h"
#import "plan_t.h"
#import "png_t.h"
#import "ppm_t.h"
#import "progress_t.h"
#import "sha256.h"
#include "batches.h"
#include "clock.h"
#include "version.h"
#include <unistd.h>

@implementation job_t

- (id) init: (options_t *)someOptions
{
  self = [super init];
  if (self)
    {
      options = [someOptions retain];
      stats = [[stats_t alloc] init];
      diag = [[diag_t alloc] init];
    }
  return self;
}

- (void) dealloc
{
  [options release];
  [stats release];
  [diag release];
  [outfile release];
  [model release];
  [text release];
  [sceneHash release];
  [brightest release];
  [image release];
  [super dealloc];
}

- (BOOL) open: (NSError **)error
{
  NSString *path = options->settings.output;

  if (options->settings.check)
    {
      return YES;
    }
  outfile = [[outfile_t alloc] init: path ? path : @"-" error: error];
  return outfile != nil;
}

- (BOOL) explains
{
  return options->settings.explain[0] != NO_CROP;
}

/** The channels of the file beside its colour: a knob that leaves an error
    brings its own. */
- (unsigned) aovs
{
  const struct settings *settings = &options->settings;
  BOOL is_cut = settings->min_weight >= 0 || settings->max_error > 0;

  return (unsigned)settings->aovs | (is_cut ? AOV_TRUNCATION : 0)
    | (settings->noise > 0 ? AOV_SAMPLING | AOV_SAMPLES : 0)
    | (isTimed ? AOV_SAMPLING : 0);
}

/** Whether somebody beside the kernel asks all objects. */
- (BOOL) wantsObjects
{
  const struct settings *settings = &options->settings;

  return settings->engine != ENGINE_FAST || settings->check
    || settings->format_scene || [self explains]
    || ([self aovs] & AOV_TRUNCATION);  // brightest_t does
}

- (BOOL) load: (NSError **)error
{
  const struct settings *settings = &options->settings;
  struct parse_options how = {
    .polygon_test = (enum polygon_test)settings->polygon_test,
    .max_depth = (unsigned)settings->max_depth
  };
  NSArray *includes = [settings->includes
                        arrayByAddingObjectsFromArray: machine_models()];
  NSAutoreleasePool *pool = [[NSAutoreleasePool alloc] init];
  BOOL needs_hash = options->format == FORMAT_EXR;
  NSError *reason = nil;
  NSData *bytes = nil;

  how.compiler = [self wantsObjects] ? nil
    : [[[compiler_t alloc] init] autorelease];

  model = [[parser_t modelFromFile: options->scene
                       includePath: includes
                           options: how
                              diag: diag
                              text: needs_hash ? &bytes : NULL
                         canonical: settings->format_scene ? &text : NULL
                             error: &reason] retain];
  [text retain];
  sceneHash = needs_hash && model ? [sha256_of(bytes) retain] : nil;
  [reason retain];
  [pool release];               // and with it the scene's text
  [reason autorelease];
  if (model == nil && error)
    {
      *error = reason
        ? error_saying(STATUS_FILE, @"cannot read '%@': %@", options->scene,
                       error_text(reason))
        : error_saying(STATUS_SCENE, @"'%@' has faults", options->scene);
    }
  [stats ended: PHASE_LOAD];
  return model != nil;
}

- (NSString *) summary
{
  const uint64_t *size = options->settings.size;
  camera_t *camera = model->camera;
  unsigned long objects = model->object_count;
  unsigned long lights = [model->lights count];

  return [NSString stringWithFormat: @"'%@': %lu object%s, %lu light%s, "
                   @"%u x %u pixels", options->scene,
                   objects, objects == 1 ? "" : "s",
                   lights, lights == 1 ? "" : "s",
                   size[0] ? (unsigned)size[0] : camera->columns,
                   size[0] ? (unsigned)size[1] : camera->rows];
}

/** The window of --explain, and whether it is not too much. */
- (BOOL) setExplained: (struct window *)window error: (NSError **)error
{
  const struct settings *settings = &options->settings;
  const uint64_t *at = settings->explain;
  camera_t *camera = model->camera;
  uint64_t rays = settings->samples * camera->exposure;

  if (at[0] >= camera->columns || at[1] >= camera->rows)
    {
      *error = error_saying(STATUS_USAGE, @"option '--explain' goes beyond the "
                            @"picture of %u x %u pixels", camera->columns,
                            camera->rows);
      return NO;
    }
  if (rays > EXPLAIN_MOST)
    {
      *error = error_saying(STATUS_USAGE, @"option '--explain' tells of at most"
                            @" %u rays, and the pixel has %llu: give smaller"
                            @" --samples or --exposure", EXPLAIN_MOST,
                            (unsigned long long)rays);
      return NO;
    }
  *window = (struct window){ (unsigned)at[0], (unsigned)at[1],
                             (unsigned)at[0] + 1, (unsigned)at[1] + 1 };
  return YES;
}

/** What the options change of the camera, and whether they suit it. */
- (BOOL) setCamera: (struct window *)window error: (NSError **)error
{
  const struct settings *settings = &options->settings;
  const uint64_t *size = settings->size, *crop = settings->crop;
  camera_t *camera = model->camera;

  if (size[0])
    {
      [camera resizeTo: (unsigned)size[0] : (unsigned)size[1]];
    }
  if ([options isGiven: "exposure"] && !camera->has_lens)
    {
      *error = error_saying(STATUS_USAGE, @"option '--exposure' needs a "
                            @"camera with a lens: focus, fstop, exposure");
      return NO;
    }
  if (settings->exposure && camera->has_lens)
    {
      camera->exposure = (unsigned)settings->exposure;
    }
  if (settings->no_depth_of_field && camera->has_lens)
    {
      camera->has_lens = NO;
      camera->exposure = 1;
    }
  *window = (struct window){ 0, 0, camera->columns, camera->rows };
  if ([self explains])
    {
      return [self setExplained: window error: error];
    }
  if (crop[0] == NO_CROP)
    {
      return YES;
    }
  if (crop[2] > camera->columns || crop[3] > camera->rows)
    {
      *error = error_saying(STATUS_USAGE, @"option '--crop' goes beyond the "
                            @"picture of %u x %u pixels", camera->columns,
                            camera->rows);
      return NO;
    }
  *window = (struct window){ (unsigned)crop[0], (unsigned)crop[1],
                             (unsigned)crop[2], (unsigned)crop[3] };
  return YES;
}

- (unsigned) threads
{
  const struct settings *settings = &options->settings;

  return settings->threads ? (unsigned)settings->threads : machine_cores();
}

- (fast_t *) newFastEngine: (NSError **)error
{
  NSString *names[] = { nil, @"avx2", @"base" };

  return [[fast_t alloc] initWithModel: model
                          instructions: names[options->settings.isa]
                               threads: [self threads] error: error];
}

/** The engine that is asked for, with the model in it (not autoreleased). */
- (id <engine_t>) newEngine: (NSError **)error
{
  return [self explains] ? [[explain_t alloc] initWithModel: model]
    : options->settings.engine == ENGINE_FAST ? [self newFastEngine: error]
    : [[notes_t alloc] initWithModel: model];
}

- (BOOL) wantsBar
{
  const struct settings *settings = &options->settings;

  return settings->progress == PROGRESS_BAR
    || (settings->progress == PROGRESS_AUTO && !settings->quiet
        && isatty(STDERR_FILENO));
}

/** What --time-limit had time for becomes what was asked for, so that the file
    says how to get it again; it is told too. */
- (void) keepSamples: (unsigned)samples
{
  struct settings *settings = &options->settings;

  stats->noise = noise_facts_of(image, HUGE_VAL);
  stats->noise.rays = stats->noise.pixels * samples;
  settings->time_limit = 0;
  settings->samples = samples;
  settings->exposure = model->camera->has_lens ? 1 : 0;
  if (samples == 0)
    {
      fputs("raytrace: warning: --time-limit was too short for one ray through"
            " each pixel: parts of the picture are copies of others\n", stderr);
    }
  else if (!settings->quiet)
    {
      fprintf(stderr, "raytrace: --time-limit: %u ray%s through each pixel",
              samples, samples == 1 ? "" : "s");
      if (samples > 1)
        {
          fprintf(stderr, ", stated error %.2g", stats->noise.rms);
        }
      fputs("\n", stderr);
    }
}

- (struct render_options) renderOptions
{
  const struct settings *settings = &options->settings;
  struct render_options how = {
    .threads = [self threads],
    .stack = [render_t stackFor: model->max_depth],
    .seed = settings->seed,
    .until = settings->time_limit > 0 ? clock_seconds() + settings->time_limit
      : 0,
    .samples = (unsigned)settings->samples,
    .sampler = (enum sampler)settings->sampler,
    .noise = settings->noise,
    .errors = student_quantile(settings->confidence > 0
                               ? settings->confidence : 0.95, BATCHES_FREEDOM),
    .max_samples = settings->max_samples ? (unsigned)settings->max_samples
    : 65536
  };

  return how;
}

- (struct shade_choice) choice
{
  const struct settings *settings = &options->settings;
  struct shade_choice choice = {
    settings->fresnel == 1, settings->no_shadows == 1,
    settings->no_reflection == 1, settings->no_refraction == 1
  };

  return choice;
}

/** Tells the model which branches of the ray tree it may do without, and what
    they might be worth. */
- (void) setCut
{
  const struct settings *settings = &options->settings;
  BOOL is_bound = settings->max_error > 0;
  struct cut_rule *cut = &model->cut;

  cut->is_on = ([self aovs] & AOV_TRUNCATION) != 0;
  if (!cut->is_on)
    {
      return;
    }
  if (is_bound && ![options isGiven: "max-depth"])
    {
      model->max_depth = CUT_BOUND_GENERATIONS;
    }
  cut->generations = is_bound || model->max_depth > CUT_GENERATIONS
    ? model->max_depth : CUT_GENERATIONS;
  cut->min_weight = settings->min_weight;
  cut->max_error = is_bound ? settings->max_error : -1;
  brightest = [[brightest_t alloc] initWithModel: model
                                     generations: cut->generations];
  cut->most = brightest->most;
  cut->most_count = brightest->count;
}

/** The picture as what is written wants it. */
- (enum keep) keep
{
  return [self explains] ? KEEP_DOUBLES
    : options->format == FORMAT_EXR ? KEEP_FLOATS : KEEP_BYTES;
}

/** What a pixel takes at most, from the first ray to the file, which is made
    whole in memory and may be as large as what goes into it. */
- (size_t) bytesOfPixel
{
  const struct exr_channel *found[EXR_CHANNELS];
  unsigned aovs = [self aovs];

  return [image_t bytesOfPixel: [self keep]]
    + (aovs & AOV_SURFACES ? sizeof(struct surface_pixel) : 0)
    + (aovs & AOV_TRUNCATION ? sizeof(double) : 0)
    + (aovs & AOV_SAMPLING ? sizeof(double) : 0)
    + (aovs & AOV_SAMPLES ? sizeof(double) : 0)
    + (isTimed ? sizeof(struct timed_pixel) : 0)
    + (options->format == FORMAT_EXR
       ? sizeof(float) * exr_channels(found, aovs)
       : 3);            // a byte each
}

/** Whether a window's pixels and their file fit into the memory there is. */
- (BOOL) hasRoomFor: (struct window)w error: (NSError **)error
{
  unsigned columns = w.x1 - w.x0, rows = w.y1 - w.y0;
  double needed = (double)columns * rows * [self bytesOfPixel];
  double memory = machine_memory();

  if (needed > memory)
    {
      *error = error_saying(STATUS_FILE, @"not enough memory for %u x %u pixels: "
                            @"they and their file take %.0f bytes, and the "
                            @"program may have %.0f in all", columns, rows,
                            needed, memory);
    }
  return needed <= memory;
}

- (BOOL) plan: (NSError **)error
{
  struct window window;

  if (![self setCamera: &window error: error])
    {
      return NO;
    }
  // A few rays tell enough, and this thread's stack is not for deep ones.
  unsigned depth = model->max_depth;
  model->choice = [self choice];
  model->max_depth = MIN(depth, 1000);
  fast_t *engine = [self newFastEngine: error];
  if (engine == nil)
    {
      return NO;
    }
  text = [[plan_t of: model engine: engine window: window
             options: [self renderOptions] depth: depth] retain];
  [engine release];
  return YES;
}

- (BOOL) trace: (NSError **)error
{
  const struct settings *settings = &options->settings;
  struct window window;

  if (![self setCamera: &window error: error])
    {
      return NO;
    }
  isTimed = settings->time_limit > 0;
  if (![self hasRoomFor: window error: error])
    {
      return NO;
    }
  image = [[image_t alloc] init: model->camera->columns
                               : model->camera->rows
                         window: window
                           keep: [self keep]
                       surfaces: (settings->aovs & AOV_SURFACES) != 0
                          error: error];
  if (image == nil
      || (([self aovs] & AOV_TRUNCATION)
          && ![image addPlane: PLANE_TRUNCATION error: error]))
    {
      return NO;
    }
  if ((settings->noise > 0 || isTimed)
      && ![image addPlane: PLANE_SAMPLING error: error])
    {
      return NO;
    }
  if (settings->noise > 0 && ![image addPlane: PLANE_SAMPLES error: error])
    {
      return NO;
    }
  [self setCut];
  if ([render_t stackFor: model->max_depth] > machine_memory())
    {
      *error = error_saying(STATUS_FILE, @"not enough memory for %u generations "
                            @"of rays: a thread's stack takes %zu bytes, and the "
                            @"program may have %.0f in all", model->max_depth,
                            [render_t stackFor: model->max_depth],
                            machine_memory());
      return NO;
    }
  model->choice = [self choice];
  id <engine_t> engine = [self newEngine: error];
  if (engine == nil)
    {
      return NO;
    }
  if (settings->engine == ENGINE_FAST && ![self explains])
    {
      k_scene_facts(((fast_t *)engine)->scene, &stats->scene);
    }
  render_t *render = [[render_t alloc] init: engine camera: model->camera
                                       into: image
                                    options: [self renderOptions]];
  [stats ended: PHASE_BUILD];
  progress_t *bar = nil;
  if ([self wantsBar])
    {
      bar = [(progress_t *)[progress_t alloc] init: render];
    }
  if (settings->time_limit > 0)
    {
      [render runTimed];
      [self keepSamples: [render samplesDone]];
    }
  else
    {
      [render run];
    }
  [bar stop];
  [bar release];
  stats->counters = render->counters;
  [render release];
  nanCount = image->nanCount;
  if (settings->noise > 0)
    {
      stats->noise = noise_facts_of(image, settings->noise);
    }
  text = [self explains] ? [[(explain_t *)engine textOf: image] retain] : nil;
  [engine release];
  [stats errorsOf: image];
  [stats ended: PHASE_TRACE];
  return YES;
}

- (NSData *) exr: (NSError **)error
{
  NSString *seed = [NSString stringWithFormat: @"%llu",
                             (unsigned long long)options->settings.seed];
  NSDictionary *attributes =
    [NSDictionary dictionaryWithObjectsAndKeys:
                    @"raytrace " RAYTRACE_VERSION, @"software",
                  @RAYTRACE_VERSION, @"raytrace:version",
                  [options pictureOptions], @"raytrace:options",
                  seed, @"raytrace:seed",
                  sceneHash, @"raytrace:sceneSHA256", nil];

  return [exr_t fileOf: image
                  aovs: [self aovs]
            attributes: attributes
                 error: error];
}

- (BOOL) write: (NSError **)error
{
  NSData *file = text ? [text dataUsingEncoding: NSUTF8StringEncoding]
    : options->format == FORMAT_EXR ? [self exr: error]
    : options->format == FORMAT_PNG ? [png_t fileOf: image error: error]
    : [ppm_t fileOf: image];
  BOOL isWritten = file && [outfile write: file error: error];

  [stats ended: PHASE_WRITE];
  return isWritten;
}

@end
