// quality.h - --quality: a few settings that go together, each at least twice as
// dear as the one before and clearly more accurate. What they cost and how far
// off they are was measured: bench/trade/run, docs/trade.md.

#import <Foundation/Foundation.h>

@class options_t;

enum { QUALITIES = 5 };

/** One rung of the ladder, and what it was measured to be (quality_found.h). */
struct quality
{
  const char *name;
  uint64_t samples, exposure;
  double max_error;
};

extern const struct quality quality_table[QUALITIES];

/** Sets what the quality asked for sets, but not what was given itself. */
void quality_apply(options_t *options);

/** The text of --show-quality (autoreleased). */
NSString *quality_text(void);
