// quality.m

#import "quality.h"
#import "options_t.h"
#include "quality_found.h"

const struct quality quality_table[QUALITIES] = {
  { "draft", 1, 4, 0.1 },
  { "low", 4, 4, 1 / 32. },
  { "medium", 16, 4, 1 / 64. },
  { "high", 64, 4, 1 / 255. },
  { "reference", 256, 4, 1 / 1000. }
};

void
quality_apply(options_t *options)
{
  struct settings *settings = &options->settings;

  if (settings->quality >= QUALITIES)
    {
      return;
    }
  const struct quality *quality = &quality_table[settings->quality];
  if (![options isGiven: "samples"] && ![options isGiven: "noise"])
    {
      settings->samples = quality->samples;
    }
  if (![options isGiven: "exposure"] && ![options isGiven: "noise"])
    {
      settings->exposure = quality->exposure;
    }
  if (![options isGiven: "max-error"] && ![options isGiven: "min-weight"])
    {
      settings->max_error = quality->max_error;
    }
}

NSString *
quality_text(void)
{
  NSMutableString *text = [NSMutableString stringWithString:
    @"quality    samples  exposure  max-error      rays      time  RMS error\n"];

  for (unsigned i = 0; i < QUALITIES; i++)
    {
      const struct quality *q = &quality_table[i];
      [text appendFormat: @"%-10s %7llu %9llu %10.4f %9s %9s %10s\n", q->name,
            (unsigned long long)q->samples, (unsigned long long)q->exposure,
            q->max_error, quality_found[i].rays, quality_found[i].time,
            quality_found[i].error];
    }
  [text appendString: @"Rays and time are those of the suite of docs/trade.md,"
        @" all its scenes, and the\nerror is the root of the mean square over"
        @" all its pixels. exposure is for a lens.\n"];
  return text;
}
