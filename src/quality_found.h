// quality_found.h - made by bench/trade/run: what the rungs of --quality cost on
// the suite, and how far off they are.

static const struct { const char *rays, *time, *error; } quality_found[] = {
  { "155631", "0.01 s", "0.0776" },
  { "760355", "0.05 s", "0.0309" },
  { "3410574", "0.20 s", "0.0114" },
  { "19137752", "1.20 s", "0.0046" },
  { "111838351", "7.76 s", "0.0023" }
};
