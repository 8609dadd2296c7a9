// Tracing without lights, mirrors and glass for any machine.
#define K_AMBIENT k_ambient_base
#define K_CLOSEST closest_base
#include "k_ambient.inc.c"
