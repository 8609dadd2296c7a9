// job_t.h - one run of the program: from the options to a file, step by step.
// Each step needs the ones before it and says by NSError how it failed; it
// prints nothing, except for the bar.

#import "options_t.h"
#import "render_t.h"
#import "stats_t.h"

@class brightest_t, diag_t, image_t, model_t, outfile_t;

@interface job_t : NSObject
{
@public
  stats_t *stats;
  diag_t *diag;         // what there is to say of the scene, after load:
  NSUInteger nanCount;  // numbers of the picture that were NaN, after trace:
@protected
  options_t *options;
  outfile_t *outfile;   // nil: nothing is to be written
  model_t *model;
  NSString *text;  // what to write in place of a picture
  NSString *sceneHash;
  image_t *image;
  brightest_t *brightest;       // model->cut's
  BOOL isTimed;                 // by --time-limit, which keepSamples forgets
}

- (id) init: (options_t *)options;

/** Opens the output, so that nobody waits for a picture that cannot be
    written; before that sees that the folders to include from are there. */
- (BOOL) open: (NSError **)error;

/** Reads the scene. */
- (BOOL) load: (NSError **)error;

/** The scene in a few words (autoreleased). */
- (NSString *) summary;

/** With --plan: what the picture takes. */
- (BOOL) plan: (NSError **)error;

/** Computes the picture. */
- (BOOL) trace: (NSError **)error;

/** Writes the picture or, with --format-scene or --plan, that text. */
- (BOOL) write: (NSError **)error;

@end

@interface job_t (choices)

- (BOOL) explains;
- (unsigned) threads;

/** The channels of the file beside its colour: a knob that leaves an error
    brings its own. */
- (unsigned) aovs;

/** The share of error.sampling's intervals that hold the true colour. */
- (double) confidence;

- (struct render_options) renderOptions;
- (struct shade_choice) choice;

/** Tells the model which branches of the ray tree it may do without, and what
    they might be worth. */
- (void) setCut;

/** The picture as what is written wants it. */
- (enum keep) keep;

/** Whether a window's pixels and their file fit into the memory there is. */
- (BOOL) hasRoomFor: (struct window)w error: (NSError **)error;

@end
