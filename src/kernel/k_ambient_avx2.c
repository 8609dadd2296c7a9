// Tracing without lights, mirrors and glass for x86-64 with AVX2 and FMA; the
// flags are in the GNUmakefile. Elsewhere there is nothing here.
#if defined(__AVX2__) && defined(__FMA__)
#define K_AMBIENT k_ambient_avx2
#define K_CLOSEST closest_avx2
#include "k_ambient.inc.c"
#else
typedef int k_no_ambient_avx2;
#endif
