// fuzz.m - what libFuzzer calls with each input it makes up. The environment
// says what the input is for, FUZZ=model, nff, options or tool:
//
//   model    a model file: read, written in canonical form, read again, which
//            has to give the same text; then a small picture from both engines
//   nff      the same with a file in NFF
//   options  arguments, one a line
//   tool     a line of arguments, then a model, or NFF if it begins with the
//            entity v: the whole run, to a file
//
// A picture that differs between the engines, or in what they count, a number
// that is not finite and a file that is no file are crashes, as is whatever a
// sanitizer finds.

#define _GNU_SOURCE     // memmem
#import "camera_t.h"
#import "diag_t.h"
#import "fast_t.h"
#import "image_t.h"
#import "job_t.h"
#import "model_t.h"
#import "notes_t.h"
#import "object_t.h"
#import "parser_t.h"
#import "render_t.h"
#include <fcntl.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#define SIDE 4                  // pixels of a picture, each way
#define MOST_WORK 4000          // objects times lights of a scene to trace

int LLVMFuzzerInitialize(int *argc, char ***argv);
int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

static char folder[4096];      // of its own, in $TMP
static const char *target;

static NSString *
path_of(const char *name)
{
  return [NSString stringWithFormat: @"%s/%s", folder, name];
}

/** The input has shown a defect: libFuzzer keeps it. */
static void
require(BOOL condition, const char *what)
{
  if (!condition)
    {
      fprintf(stderr, "fuzz: %s\n", what);
      abort();
    }
}

static void
save(NSString *path, const void *bytes, size_t size)
{
  int fd = open([path UTF8String], O_WRONLY | O_CREAT | O_TRUNC, 0600);

  require(fd >= 0 && write(fd, bytes, size) == (ssize_t)size, "no room");
  close(fd);
}

static image_t *
picture(model_t *model, id <engine_t> engine, struct counters *counters)
{
  struct render_options how = { .threads = 1, .seed = 1, .samples = 1 };
  struct window all = { 0, 0, SIDE, SIDE };
  image_t *image = [[[image_t alloc] init: SIDE : SIDE window: all
                                 surfaces: YES error: NULL] autorelease];
  render_t *render = [[render_t alloc] init: engine camera: model->camera
                                       into: image options: how];

  [render run];
  *counters = render->counters;
  [render release];
  return image;
}

/** Both engines give the same bits, and a file gets finite ones. */
static void
trace(model_t *model)
{
  if ([model->objects count] * ([model->lights count] + 1) > MOST_WORK)
    {
      return;
    }
  [model->camera resizeTo: SIDE : SIDE];
  model->camera->exposure = MIN(model->camera->exposure, 2);

  struct counters one, two;
  notes_t *notes = [[[notes_t alloc] initWithModel: model] autorelease];
  fast_t *fast = [[[fast_t alloc] initWithModel: model instructions: nil
                                        threads: 1 error: NULL] autorelease];
  require(fast != nil, "no memory for a small scene");
  image_t *a = picture(model, notes, &one), *b = picture(model, fast, &two);

  require(one.eye == two.eye && one.reflection == two.reflection
          && one.refraction == two.refraction && one.feeler == two.feeler
          && counters_same_edges(&one, &two), "the engines count other rays");
  for (unsigned i = 0; i < SIDE * SIDE; i++)
    {
      require(memcmp(&a->pixels[i].color, &b->pixels[i].color,
                     sizeof(struct k_vec)) == 0
              && a->surfaces[i].object == b->surfaces[i].object,
              "the engines give other pixels");
    }
  for (unsigned i = 0; i < SIDE * SIDE; i++)
    {
      struct k_vec c = a->pixels[i].color;
      require(isfinite(image_float(c.x)) && isfinite(image_float(c.y))
              && isfinite(image_float(c.z)), "not finite");
    }
}

/** The model of a file; nil if it has faults. *canonical: its text. */
static model_t *
read_model(NSString *path, NSString **canonical)
{
  struct parse_options how = { .max_depth = 5 };
  diag_t *diag = [[[diag_t alloc] init] autorelease];
  NSError *error = nil;
  NSData *text = nil;
  model_t *model = [parser_t modelFromFile: path
                               includePath: [NSArray array] options: how
                                      diag: diag text: &text
                                 canonical: canonical error: &error];

  require((model == nil) == ([diag faultCount] > 0 || error != nil),
          "a model with faults, or none without");
  require([[diag report] length] < 200000, "a report without end");
  [diag close];
  return model;
}

static void
one_scene(const uint8_t *data, size_t size, const char *name)
{
  NSString *path = path_of(name), *text = nil, *again = nil;

  save(path, data, size);
  model_t *model = read_model(path, &text);
  if (model == nil)
    {
      return;
    }
  NSData *bytes = [text dataUsingEncoding: NSUTF8StringEncoding];
  save(path_of("again.mdl"), [bytes bytes], [bytes length]);
  require(read_model(path_of("again.mdl"), &again) != nil
          && [text isEqual: again], "canonical form is not canonical");
  trace(model);
}

/** What `count` arguments say; nil if they are wrong. At most 60 are taken:
    words of the text, apart at `separators`. */
static options_t *
read_options(char *text, const char *separators, const char *first[],
             unsigned count)
{
  char *argv[64] = { "raytrace" }, *rest = NULL;
  int argc = 1;

  for (unsigned i = 0; i < count; i++)
    {
      argv[argc++] = (char *)first[i];
    }
  for (char *word = strtok_r(text, separators, &rest); word && argc < 60;
       word = strtok_r(NULL, separators, &rest))
    {
      argv[argc++] = word;
    }
  options_t *options = [[[options_t alloc] init] autorelease];
  NSString *wrong = [options read: argc : argv];
  require(wrong == nil || [wrong length] > 0, "wrong, but not what");
  return wrong ? nil : options;
}

/** Whether a run may take long by right, as no option bounds it. */
static BOOL
takes_long(const options_t *options)
{
  const struct settings *s = &options->settings;
  BOOL is_deep = s->max_depth > 8
    || (s->max_error > 0 && ![options isGiven: "max-depth"]);

  return s->size[0] * s->size[1] > 256 || s->samples > 4 || s->exposure > 4
    || s->threads > 4 || is_deep || s->time_limit > .05
    || (s->noise > 0 && (s->max_samples == 0 || s->max_samples > 64));
}

static void
one_run(const uint8_t *data, size_t size)
{
  static const char *const outputs[] = { "out.exr", "out.png", "out.ppm" };
  const uint8_t *end = memchr(data, '\n', size);
  size_t line = end ? (size_t)(end - data) : size;
  BOOL is_nff = size - line > 2 && memcmp(data + line, "\nv\n", 3) == 0;
  NSString *scene = path_of(is_nff ? "tool.nff" : "tool.mdl");
  NSString *out = path_of(outputs[size % 3]);
  const char *first[] = { [scene UTF8String], "-o", [out UTF8String],
                          "-r", "5x3", "--progress=none" };
  char *text = strndup((const char *)data, line);
  options_t *options = read_options(text, " ", first,
                                    sizeof first / sizeof *first);

  free(text);
  if (options == nil || ![options->settings.output isEqual: out]
      || ![options->scene isEqual: scene])
    {
      return;
    }
  struct settings *s = &options->settings;
  if (s->help || s->version || s->show_quality || takes_long(options))
    {
      return;
    }
  if (s->exposure == 0 && memmem(data, size, "exposure", 8))
    {
      s->exposure = 1;
    }
  save(scene, data + line, size - line);
  unlink([out UTF8String]);
  job_t *job = [[[job_t alloc] init: options] autorelease];
  NSError *error = nil;
  BOOL isLoaded = [job open: &error] && [job load: &error];
  [job->diag report];
  [job->diag close];
  if (!isLoaded)
    {
      require(access([out UTF8String], F_OK) != 0, "a file of a faulty scene");
      return;
    }
  BOOL isDone = s->check || s->format_scene
    || (s->plan ? [job plan: &error] : [job trace: &error]);
  BOOL isWritten = isDone && !s->check && [job write: &error];
  require(isWritten == (access([out UTF8String], F_OK) == 0),
          "a file that should not be, or none");
  require(isDone || error, "failed, but not why");
  [job->stats text];
  [job->stats json];
}

int
LLVMFuzzerInitialize(int *argc, char ***argv)
{
  const char *place = getenv("TMP");

  target = getenv("FUZZ");
  snprintf(folder, sizeof folder, "%s/fuzz-XXXXXX", place ? place : "/tmp");
  require(target && mkdtemp(folder), "FUZZ is not set");
  return 0;
}

int
LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
  NSAutoreleasePool *pool = [[NSAutoreleasePool alloc] init];

  if (strcmp(target, "model") == 0)
    {
      one_scene(data, size, "scene.mdl");
    }
  else if (strcmp(target, "nff") == 0)
    {
      one_scene(data, size, "scene.nff");
    }
  else if (strcmp(target, "options") == 0)
    {
      char *text = strndup((const char *)data, size);
      [read_options(text, "\n", NULL, 0) pictureOptions];
      free(text);
    }
  else
    {
      one_run(data, size);
    }
  [pool release];
  return 0;
}
