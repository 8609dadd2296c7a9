// eye_ray.h - one ray from the eye, as the renderer asks an engine for it.

#ifndef EYE_RAY_H
#define EYE_RAY_H

#include "kernel/k_vec.h"

/** How many rays an engine is best asked for at once. */
#define EYE_RAYS 32

struct eye_ray
{
  struct k_vec o, d;            // from o along the unit d
  struct k_vec color;           // what comes back along it
  double error;                 // most that cut branches could change of it,
                                // of any channel; only if the model asks
};

#endif
