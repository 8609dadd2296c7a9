// version.h - the one place that says which version this is.

#define RAYTRACE_VERSION "0.1.0"
