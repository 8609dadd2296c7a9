// The search through the tree for x86-64 with AVX2 and FMA; the flags are in
// the GNUmakefile. Elsewhere there is nothing here.
#if defined(__AVX2__) && defined(__FMA__)
#define K_CLOSEST k_closest_avx2
#include "k_bvh_trace.inc.c"

const struct k_isa k_isa_avx2 = { "avx2", k_closest_avx2 };
#else
typedef int k_no_avx2;
#endif
