// stats_t.h - what a run took: seconds by phase, and the counters of the
// rays. --stats shows it.

#import <Foundation/Foundation.h>
#import "image_t.h"
#include "counters.h"
#include "kernel/k.h"
#import "noise_facts.h"

enum phase
{
  PHASE_LOAD,           // reading the scene
  PHASE_BUILD,          // getting ready: the kernel's tree, the picture
  PHASE_TRACE,
  PHASE_WRITE,          // making the file's bytes and writing them
  PHASES
};

@interface stats_t : NSObject
{
@public
  double seconds[PHASES];
  struct counters counters;
  BOOL has_truncation;  // error.truncation is known: the largest of a pixel and
  double truncation_most, truncation_mean;      // the mean
  struct k_facts scene; // of the fast engine; isa NULL: there is none
  struct noise_facts noise;     // of --noise, --time-limit; pixels 0: none
@protected
  double mark;          // when the last phase ended
}

/** Takes over what the picture says of its errors. */
- (void) errorsOf: (image_t *)image;

/** The time since the last call, or since init, belonged to this phase. */
- (void) ended: (enum phase)phase;

/** Lines for people (autoreleased). */
- (NSString *) text;

/** One line, a JSON object (autoreleased):
    {"seconds": {"load": …, "build": …, "trace": …, "write": …},
    "rays": {"eye": …, "reflection": …, "refraction": …, "feeler": …},
    "tests": …, "escapes": …, "compensated": …, "ties": …, "critical": …,
    "unbalanced": …, "rays_per_second": …}, and of the fast engine
    "nodes": …, "nodes_per_ray": …, "tests_per_ray": …, "tree": {"nodes": …,
    "depth": …, "cost": …, "bytes": …, "isa": "…"}, when branches are cut
    "error": {"truncation": {"most": …, "mean": …}}, and with --noise
    or --time-limit "noise": {"pixels": …, "rays": …, "largest": …, "rms": …,
    "capped": …} */
- (NSString *) json;

@end
