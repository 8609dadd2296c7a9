// quality_found.h - made by bench/trade/run: what the rungs of --quality cost on
// the suite, and how far off they are.

static const struct { const char *rays, *time, *error; } quality_found[] = {
  { "185267", "0.03 s", "0.0771" },
  { "862014", "0.08 s", "0.0320" },
  { "3789532", "0.26 s", "0.0129" },
  { "20555119", "1.58 s", "0.0061" },
  { "115941508", "10.17 s", "0.0036" }
};
