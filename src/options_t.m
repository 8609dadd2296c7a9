// options_t.m

#import "options_t.h"
#import "diag_t.h"
#import "option.h"
#import "quality.h"
#include "ray_places.h"
#include "attribute_check.h"
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

/** Options are not abbreviated, since one that is new might change what is
    meant; but those that begin so are suggested, or else the nearest. */
static NSString *
unknown_option(NSString *name)
{
  NSMutableArray *names = [NSMutableArray array];
  NSMutableArray *longer = [NSMutableArray array];

  for (const struct option *o = option_table; o->name; o++)
    {
      [names addObject: option_name(o)];
      if ([name length] > 2 && [option_name(o) hasPrefix: name])
        {
          [longer addObject: [NSString stringWithFormat: @"'%@'",
                                       option_name(o)]];
        }
    }
  NSString *meant = [longer count] == 0
    ? [diag_t suggestionFor: name among: names]
    : [NSString stringWithFormat: @"; did you mean %@?",
                attribute_list(longer, @"or")];

  return [NSString stringWithFormat: @"unknown option '%@'%@", name, meant];
}

/** What a path stands for; - is the standard file `fd`. */
static BOOL
is_there(NSString *path, int fd, struct stat *now)
{
  return ([path isEqual: @"-"] ? fstat(fd, now)
          : stat([path UTF8String], now)) == 0;
}

/** Whether a path names a folder, or can name nothing else. */
static BOOL
is_folder(NSString *path)
{
  struct stat now;

  return [path hasSuffix: @"/"]
    || (is_there(path, STDOUT_FILENO, &now) && S_ISDIR(now.st_mode));
}

/** Whether what is read and what is written are one file. */
static BOOL
is_same_file(NSString *input, NSString *output)
{
  struct stat one, two;

  return is_there(input, STDIN_FILENO, &one)
    && is_there(output, STDOUT_FILENO, &two)
    && one.st_dev == two.st_dev && one.st_ino == two.st_ino
    && S_ISREG(one.st_mode);
}

static BOOL
is_square(uint64_t n)
{
  uint64_t root = llround(sqrt(n));

  return root * root == n;
}

@implementation options_t

- (id) init
{
  self = [super init];
  if (self)
    {
      option_reset(&settings);
      settings.includes = [[NSMutableArray alloc] init];
      given = [[NSMutableSet alloc] init];
    }
  return self;
}

- (void) dealloc
{
  [settings.output release];
  [settings.includes release];
  [scene release];
  [given release];
  [super dealloc];
}

/** --name, --name=value, --name value. *next is what follows, nil for
    nothing; it becomes nil when it is taken as the value. */
- (NSString *) readLong: (NSString *)argument next: (NSString **)next
{
  NSRange equals = [argument rangeOfString: @"="];
  NSString *name = argument, *value = nil;

  if (equals.length > 0)
    {
      name = [argument substringToIndex: equals.location];
      value = [argument substringFromIndex: NSMaxRange(equals)];
    }
  const struct option *option = option_written(name);
  if (option == NULL)
    {
      return unknown_option(name);
    }
  if (value == nil && option_wants_value(option))
    {
      value = *next;
      *next = nil;
    }
  [given addObject: option_name(option)];
  return option_take(option, value, &settings);
}

/** -q, -qv, -j4, -j 4. */
- (NSString *) readShort: (NSString *)argument next: (NSString **)next
{
  for (NSUInteger i = 1; i < [argument length]; i++)
    {
      NSString *letter = [argument substringWithRange: NSMakeRange(i, 1)];
      NSString *name = [@"-" stringByAppendingString: letter];
      const struct option *option = option_written(name);
      NSString *value = nil;
      if (option == NULL)
        {
          return [NSString stringWithFormat: @"unknown option '%@'", name];
        }
      if (option_wants_value(option))
        {
          value = [argument substringFromIndex: i + 1];
          if ([value length] == 0)
            {
              value = *next;
              *next = nil;
            }
          i = [argument length];
        }
      [given addObject: option_name(option)];
      NSString *wrong = option_take(option, value, &settings);
      if (wrong)
        {
          return wrong;
        }
    }
  return nil;
}

/** What each argument by itself says. */
- (NSString *) readAll: (NSArray *)arguments
{
  NSUInteger count = [arguments count];
  BOOL areOptions = YES;

  for (NSUInteger i = 0; i < count; i++)
    {
      NSString *argument = [arguments objectAtIndex: i];
      NSString *next = i + 1 < count ? [arguments objectAtIndex: i + 1] : nil;
      NSString *following = next, *wrong = nil;

      if (areOptions && [argument isEqual: @"--"])
        {
          areOptions = NO;
        }
      else if (areOptions && [argument hasPrefix: @"--"])
        {
          wrong = [self readLong: argument next: &next];
        }
      else if (areOptions && [argument hasPrefix: @"-"]
               && [argument length] > 1)
        {
          wrong = [self readShort: argument next: &next];
        }
      else if (scene)
        {
          wrong = [NSString stringWithFormat:
                              @"one scene at a time, not '%@' and '%@'",
                            scene, argument];
        }
      else
        {
          scene = [argument copy];
        }
      if (wrong)
        {
          return wrong;
        }
      i += next != following;
    }
  return nil;
}

- (enum format) formatOfOutput
{
  NSString *name = [settings.output lowercaseString];

  return [name hasSuffix: @".exr"] ? FORMAT_EXR
    : [name hasSuffix: @".png"] ? FORMAT_PNG
    : [name hasSuffix: @".ppm"] || [name isEqual: @"-"] ? FORMAT_PPM
    : FORMAT_NONE;
}

/** What is missing, or does not go together. */
- (NSString *) disagreement
{
  const uint64_t *crop = settings.crop;

  if (settings.help || settings.version || settings.show_quality)
    {
      return nil;
    }
  if (scene == nil)
    {
      return @"no scene given; see 'raytrace --help'";
    }
  BOOL explains = settings.explain[0] != NO_CROP;
  if (settings.check + settings.format_scene + settings.plan + explains > 1)
    {
      return @"options '--check', '--format-scene', '--plan' and '--explain'"
        @" exclude each other";
    }
  if (explains && crop[0] != NO_CROP)
    {
      return @"options '--crop' and '--explain' exclude each other";
    }
  if (explains && (settings.noise > 0 || settings.time_limit > 0))
    {
      return @"option '--explain' tells of a known number of rays: without"
        @" '--noise' and '--time-limit'";
    }
  if (crop[0] != NO_CROP && (crop[0] >= crop[2] || crop[1] >= crop[3]))
    {
      return @"option '--crop' takes X0,Y0,X1,Y1 with X0 < X1 and Y0 < Y1";
    }
  if (settings.sampler == SAMPLER_GRID && !is_square(settings.samples))
    {
      return [NSString stringWithFormat: @"sampler grid takes a square number "
                       @"of samples (1, 4, 9, 16 ...), not %llu",
                       (unsigned long long)settings.samples];
    }
  if (settings.noise > 0
      && ([self isGiven: "samples"] || settings.exposure))
    {
      return @"option '--noise' finds the number of rays itself: without"
        @" '--samples' and '--exposure'";
    }
  if (settings.noise > 0 && settings.sampler != SAMPLER_OWEN
      && settings.sampler != SAMPLER_RANDOM)
    {
      return @"option '--noise' takes the samplers owen and random";
    }
  if (settings.time_limit > 0
      && (settings.noise > 0 || settings.samples > 1
          || [self isGiven: "samples"] || settings.exposure
          || settings.sampler == SAMPLER_STRATIFIED
          || settings.sampler == SAMPLER_GRID || settings.aovs
          || settings.max_error > 0 || settings.min_weight >= 0))
    {
      return @"option '--time-limit' finds the number of rays itself: without"
        @" '--samples', '--exposure', '--noise', '--aov', '--max-error' and"
        @" '--min-weight', and with sampler owen or random";
    }
  if (settings.noise == 0 && settings.max_samples)
    {
      return @"option '--max-samples' needs '--noise'";
    }
  if (settings.noise == 0 && settings.time_limit == 0
      && settings.confidence > 0)
    {
      return @"option '--confidence' needs '--noise' or '--time-limit'";
    }
  if (settings.check || settings.format_scene || settings.plan || explains)
    {
      return nil;
    }
  if (settings.output == nil)
    {
      return @"no output given: -o FILE, or -o - for standard output";
    }
  format = [self formatOfOutput];
  if (is_folder(settings.output))
    {
      return nil;       // outfile_t says so
    }
  if (format == FORMAT_NONE)
    {
      return [NSString stringWithFormat: @"output '%@' has an unknown suffix; "
                       @"known are .exr, .png and .ppm", settings.output];
    }
  if (is_same_file(scene, settings.output))
    {
      return [NSString stringWithFormat: @"output '%@' is the scene itself",
                       settings.output];
    }
  if (settings.aovs && format != FORMAT_EXR)
    {
      return @"option '--aov' needs an output in .exr";
    }
  return nil;
}

- (NSString *) read: (int)argc : (char **)argv
{
  NSMutableArray *arguments = [NSMutableArray array];

  for (int i = 1; i < argc; i++)
    {
      NSString *argument = [NSString stringWithUTF8String: argv[i]];
      if (argument == nil)
        {
          return [NSString stringWithFormat: @"argument %d is not UTF-8", i];
        }
      [arguments addObject: argument];
    }
  NSString *wrong = [self readAll: arguments];
  quality_apply(self);
  return wrong ? wrong : [self disagreement];
}

- (BOOL) isGiven: (const char *)name
{
  return [given containsObject: [NSString stringWithFormat: @"--%s", name]];
}

- (NSString *) pictureOptions
{
  NSMutableArray *words = [NSMutableArray array];
  // What would be refused: --noise finds the samples itself, and it alone can
  // be given again with a confidence.
  const char *without = settings.noise > 0 ? "samples" : "confidence";

  for (const struct option *o = option_table; o->name; o++)
    {
      NSString *value = o->is_shaping ? option_value(o, &settings) : nil;
      if (value && strcmp(o->name, without) != 0)
        {
          [words addObject: option_name(o)];
          if (o->kind != OPTION_FLAG)
            {
              [words addObject: value];
            }
        }
    }
  return [words componentsJoinedByString: @" "];
}

@end
