// quality_found.h - made by bench/trade/run: what the rungs of --quality cost on
// the suite, and how far off they are.

static const struct { const char *rays, *time, *error; } quality_found[] = {
  { "-", "-", "-" },
  { "-", "-", "-" },
  { "-", "-", "-" },
  { "-", "-", "-" },
  { "-", "-", "-" }
};
