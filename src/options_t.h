// options_t.h - the command line: read by one table of options, from which
// the text of --help is made as well.

#import <Foundation/Foundation.h>

enum format
{
  FORMAT_NONE,          // no picture is written
  FORMAT_EXR,
  FORMAT_PNG,
  FORMAT_PPM
};

enum progress
{
  PROGRESS_AUTO,        // a bar when standard error is a terminal
  PROGRESS_BAR,
  PROGRESS_NONE
};

enum stats
{
  STATS_NONE,
  STATS_TEXT,
  STATS_JSON
};

enum engine
{
  ENGINE_FAST,
  ENGINE_NOTES
};

enum isa
{
  ISA_BEST,
  ISA_AVX2,
  ISA_BASE
};

#define NO_CROP UINT64_MAX

/** What the options say. Numbers are 64 bits, so that one reader serves all;
    they are within the range that --help gives. */
struct settings
{
  NSString *output;             // nil: not given; "-": standard output
  uint64_t size[2];             // columns, rows; 0 0: the model's
  uint64_t crop[4];             // x0 y0 x1 y1; x0 NO_CROP: not given
  uint64_t explain[2];          // x y; x NO_CROP: not given
  uint64_t aovs;                // sum of enum aov
  uint64_t seed, samples, sampler, exposure;    // exposure 0: the model's
  double noise, confidence;     // 0: not given
  uint64_t max_samples;         // 0: not given
  uint64_t max_depth, polygon_test, engine, isa;
  uint64_t fresnel;             // 1: exact
  uint64_t no_shadows, no_reflection, no_refraction, no_depth_of_field;
  uint64_t quality;             // place in quality_table; more: not given
  uint64_t show_quality;
  double time_limit;            // seconds; 0: none
  double min_weight, max_error; // less than 0: not given
  uint64_t threads;             // 0: all cores
  NSMutableArray *includes;     // folders, in the order given
  uint64_t check, format_scene, plan;
  uint64_t stats, progress, quiet, verbose, help, version;
};

@interface options_t : NSObject
{
@public
  struct settings settings;
  enum format format;           // of the output, by its suffix
  NSString *scene;              // nil with --help and --version only
@protected
  NSMutableSet *given;          // names of options
}

/** Reads the arguments of main. Afterwards they are complete and agree with
    each other. nil, or what is wrong with them (autoreleased). */
- (NSString *) read: (int)argc : (char **)argv;

/** Whether the option of this name was given. */
- (BOOL) isGiven: (const char *)name;

/** The options that a picture depends on beside its scene, written so that
    they give the same picture again. --seed is not among them. */
- (NSString *) pictureOptions;

@end
