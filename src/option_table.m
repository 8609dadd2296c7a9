// option_table.m - all options of the command line.

#import "option.h"
#include "batches.h"
#include <stddef.h>

#define AT(member) offsetof(struct settings, member)
#define MILLION 1000000

const struct option option_table[] = {
  { .heading = "Output",
    .letter = 'o', .name = "output", .value = "FILE", .kind = OPTION_TEXT,
    .offset = AT(output),
    .help = "write the picture to FILE: .exr (float, linear), .png or .ppm"
            " (8 bits); - is standard output, as .ppm" },
  { .name = "aov", .value = "LIST", .kind = OPTION_WORDS, .offset = AT(aovs),
    .words = "depth normal object error.truncation",
    .help = "more channels for an .exr: depth (Z), normal (N.X N.Y N.Z),"
            " object (id), error.truncation (what rays that are not traced"
            " could change at most), with commas between" },

  { .heading = "Picture",
    .letter = 'r', .name = "resolution", .value = "WxH",
    .kind = OPTION_WHOLE, .offset = AT(size), .count = 2, .separator = 'x',
    .least = 1, .most = MILLION, .is_shaping = YES,
    .help = "columns and rows, in place of the camera's pixeldim" },
  { .name = "crop", .value = "X0,Y0,X1,Y1", .kind = OPTION_WHOLE,
    .offset = AT(crop), .count = 4, .separator = ',', .most = MILLION,
    .standard = NO_CROP,
    .help = "only the pixels from column X0 and row Y0, counted from the top"
            " left corner, up to but without X1 and Y1" },
  { .name = "quality", .value = "WORD", .kind = OPTION_WORD,
    .offset = AT(quality), .words = "draft low medium high reference",
    .standard = UINT64_MAX,
    .help = "samples, exposure and max-error that go together: draft, low,"
            " medium, high or reference; what is given itself wins" },
  { .name = "show-quality", .kind = OPTION_FLAG, .offset = AT(show_quality),
    .help = "what each quality sets, its time and its error, on standard"
            " output" },
  { .name = "samples", .value = "N", .kind = OPTION_WHOLE,
    .offset = AT(samples), .count = 1, .least = 1, .most = MILLION,
    .standard = 1, .is_shaping = YES, .help = "rays through each pixel" },
  { .name = "sampler", .value = "WORD", .kind = OPTION_WORD,
    .offset = AT(sampler), .words = "owen random stratified grid",
    .is_shaping = YES,
    .help = "where in a pixel and on the lens rays go: owen, spread evenly;"
            " random, as in the notes; stratified, one in each of N parts;"
            " grid (N is 1, 4, 9 ...), regular, and random on the lens" },
  { .name = "exposure", .value = "N", .kind = OPTION_WHOLE,
    .offset = AT(exposure), .count = 1, .least = 1, .most = 1000 * MILLION,
    .is_shaping = YES,
    .help = "rays through the lens for each sample, in place of the"
            " camera's exposure" },
  { .name = "noise", .value = "E", .kind = OPTION_NUMBER,
    .offset = AT(noise), .low = 0, .high = 1e9, .is_above_low = YES,
    .is_shaping = YES,
    .help = "as many rays through each pixel, and through the lens, as make"
            " its error at most E; an .exr then has the channels"
            " error.sampling and samples" },
  { .name = "confidence", .value = "C", .kind = OPTION_NUMBER,
    .offset = AT(confidence), .low = 0.5, .high = 0.9999, .is_shaping = YES,
    .help = "the share of pixels whose error is at most what --noise or"
            " --time-limit states, 0.95 unless given" },
  { .name = "max-samples", .value = "N", .kind = OPTION_WHOLE,
    .offset = AT(max_samples), .count = 1, .least = BATCHES,
    .most = 1000 * MILLION, .is_shaping = YES,
    .help = "most rays through a pixel with --noise, 65536 unless given" },
  { .name = "time-limit", .value = "S", .kind = OPTION_NUMBER,
    .offset = AT(time_limit), .high = 1e6, .is_above_low = YES,
    .help = "the best picture in S seconds of tracing: as many rays through"
            " each pixel as there is time for; --samples with the number that"
            " is told, and --exposure 1 with a lens, gives it again" },
  { .name = "seed", .value = "N", .kind = OPTION_WHOLE, .offset = AT(seed),
    .count = 1, .most = UINT64_MAX,
    .help = "another seed, other random numbers" },

  { .heading = "Tracing",
    .name = "max-depth", .value = "N", .kind = OPTION_WHOLE,
    .offset = AT(max_depth), .count = 1, .most = MILLION, .standard = 5,
    .is_shaping = YES,
    .help = "deepest generation of reflected and refracted rays; eye rays"
            " are generation 0" },
  { .name = "min-weight", .value = "W", .kind = OPTION_NUMBER,
    .offset = AT(min_weight), .high = 1, .usual = -1, .is_shaping = YES,
    .help = "trace no reflected or refracted ray that is worth less than W of"
            " the colour of its eye ray; writes error.truncation too" },
  { .name = "max-error", .value = "E", .kind = OPTION_NUMBER,
    .offset = AT(max_error), .high = 1e6, .is_above_low = YES, .usual = -1,
    .is_shaping = YES,
    .help = "trace only as many of them, and send only as many feelers, as it"
            " takes for no channel of a pixel to be off by more than E from the"
            " picture of 20 generations, or of --max-depth; writes error.truncation"
            " too" },
  { .name = "fresnel", .value = "WORD", .kind = OPTION_WORD,
    .offset = AT(fresnel), .words = "schlick exact", .is_shaping = YES,
    .help = "how much clear surfaces reflect: schlick, the notes'"
            " approximation, or exact, by Fresnel's equations" },
  { .name = "no-shadows", .kind = OPTION_FLAG, .offset = AT(no_shadows),
    .is_shaping = YES, .help = "send no shadow feelers: all lights reach" },
  { .name = "no-reflection", .kind = OPTION_FLAG,
    .offset = AT(no_reflection), .is_shaping = YES,
    .help = "trace no reflected rays: what they bring back is black" },
  { .name = "no-refraction", .kind = OPTION_FLAG,
    .offset = AT(no_refraction), .is_shaping = YES,
    .help = "trace no refracted rays: what they bring back is black" },
  { .name = "no-depth-of-field", .kind = OPTION_FLAG,
    .offset = AT(no_depth_of_field), .is_shaping = YES,
    .help = "make the lens a pinhole" },
  { .name = "polygon-test", .value = "WORD", .kind = OPTION_WORD,
    .offset = AT(polygon_test), .words = "crossings edges angles",
    .is_shaping = YES,
    .help = "how to tell that a point is in a polygon: crossings, edges"
            " (convex polygons only) or angles" },
  { .name = "engine", .value = "WORD", .kind = OPTION_WORD,
    .offset = AT(engine), .words = "fast notes",
    .help = "who traces: fast, the kernel, or notes, the objects of the"
            " notes; the picture is the same" },
  { .name = "isa", .value = "WORD", .kind = OPTION_WORD,
    .offset = AT(isa), .words = "best avx2 base",
    .help = "the processor's instructions that the fast engine uses: avx2,"
            " base, or the best there are; the picture is the same" },
  { .letter = 'j', .name = "threads", .value = "N", .kind = OPTION_WHOLE,
    .offset = AT(threads), .count = 1, .most = 1024,
    .help = "threads that trace, 0 for one per core; the picture does not"
            " depend on it" },

  { .heading = "Scene",
    .letter = 'I', .name = "include-path", .value = "DIR",
    .kind = OPTION_TEXTS, .offset = AT(includes),
    .help = "look for included files in DIR too, and allow what is there; may be"
            " repeated" },
  { .name = "check", .kind = OPTION_FLAG, .offset = AT(check),
    .help = "only read the scene and tell its faults" },
  { .name = "format-scene", .kind = OPTION_FLAG, .offset = AT(format_scene),
    .help = "write the scene in canonical form, to FILE or standard"
            " output" },
  { .name = "plan", .kind = OPTION_FLAG, .offset = AT(plan),
    .help = "trace nothing; write what the scene has, which work it does"
            " without, and about how many rays it will be" },
  { .name = "explain", .value = "X,Y", .kind = OPTION_WHOLE,
    .offset = AT(explain), .count = 2, .separator = ',', .most = MILLION,
    .standard = NO_CROP,
    .help = "write how the pixel in column X and row Y, counted from the top"
            " left corner, gets its colour: every ray and every term, by the"
            " notes engine" },

  { .heading = "Messages, on standard error",
    .name = "stats", .value = "WORD", .kind = OPTION_WORD,
    .offset = AT(stats), .words = "none text json", .may_be_bare = YES,
    .help = "tell times and numbers of rays at the end: text, which WORD may"
            " be left out for, or json, one object" },
  { .name = "progress", .value = "WORD", .kind = OPTION_WORD,
    .offset = AT(progress), .words = "auto bar none",
    .help = "show how much is done: bar, none, or auto: a bar on a terminal"
            " and nothing elsewhere" },
  { .letter = 'q', .name = "quiet", .kind = OPTION_FLAG, .offset = AT(quiet),
    .help = "no warnings, no bar unless asked for" },
  { .letter = 'v', .name = "verbose", .kind = OPTION_FLAG,
    .offset = AT(verbose), .help = "tell what was read" },
  { .letter = 'h', .name = "help", .kind = OPTION_FLAG, .offset = AT(help),
    .help = "this text, on standard output" },
  { .name = "version", .kind = OPTION_FLAG, .offset = AT(version),
    .help = "the version, on standard output" },
  { .name = NULL }
};
