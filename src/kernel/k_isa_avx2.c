// Tracing for x86-64 with AVX2 and FMA; the flags are in the GNUmakefile.
// Elsewhere there is nothing here.
#if defined(__AVX2__) && defined(__FMA__)
#define K_ISA k_isa_avx2
#define K_ISA_NAME "avx2"
#define K_CLOSEST closest_avx2
#define K_AMBIENT k_ambient_avx2
#include "k_trace.inc.c"
#else
typedef int k_no_avx2;
#endif
