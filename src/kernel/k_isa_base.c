// Tracing for any machine (on x86-64: SSE2).
#define K_ISA k_isa_base
#define K_ISA_NAME "base"
#define K_CLOSEST closest_base
#define K_AMBIENT k_ambient_base
#include "k_trace.inc.c"
