// job_t.m

#import "job_t.h"
#import "brightest_t.h"
#import "camera_t.h"
#import "compiler_t.h"
#import "diag_t.h"
#import "errors.h"
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
#include "version.h"
#include <errno.h>
#include <string.h>
#include <sys/stat.h>
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

/** Whether all of --include-path are folders: a name that is mistyped would
    only be missed by who knows what should be in it. */
- (BOOL) hasIncludePath: (NSError **)error
{
  for (NSString *folder in options->settings.includes)
    {
      struct stat now;
      int reason = stat([folder UTF8String], &now) != 0 ? errno
        : S_ISDIR(now.st_mode) ? 0 : ENOTDIR;
      if (reason)
        {
          *error = error_saying(STATUS_FILE, @"cannot include from '%@': %s",
                                folder, strerror(reason));
          return NO;
        }
    }
  return YES;
}

- (BOOL) open: (NSError **)error
{
  NSString *path = options->settings.output;

  if (![self hasIncludePath: error])
    {
      return NO;
    }
  if (options->settings.check)
    {
      return YES;
    }
  outfile = [[outfile_t alloc] init: path ? path : @"-" error: error];
  return outfile != nil;
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
  NSMutableDictionary *attributes =
    [NSMutableDictionary dictionaryWithObjectsAndKeys:
                    @"raytrace " RAYTRACE_VERSION, @"software",
                  @RAYTRACE_VERSION, @"raytrace:version",
                  [options pictureOptions], @"raytrace:options",
                  seed, @"raytrace:seed",
                  sceneHash, @"raytrace:sceneSHA256", nil];
  if ([self aovs] & AOV_SAMPLING)
    {
      [attributes setObject: [NSString stringWithFormat: @"%.15g",
                                       [self confidence]]
                     forKey: @"raytrace:confidence"];
    }

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
