// quality_found.h - made by bench/trade/run: what the rungs of --quality cost on
// the suite, and how far off they are.

static const struct { const char *rays, *time, *error; } quality_found[] = {
  { "169786", "0.01 s", "0.0775" },
  { "798997", "0.06 s", "0.0318" },
  { "3535178", "0.22 s", "0.0127" },
  { "19530200", "1.45 s", "0.0061" },
  { "111828499", "5.36 s", "0.0037" }
};
