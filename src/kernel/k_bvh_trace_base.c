// The search through the tree for any machine (on x86-64: SSE2).
#define K_CLOSEST k_closest_base
#include "k_bvh_trace.inc.c"

const struct k_isa k_isa_base = { "base", k_closest_base };
