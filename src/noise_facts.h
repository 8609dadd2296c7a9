// noise_facts.h - what a picture says of its own errors, in numbers for --stats.

#ifndef NOISE_FACTS_H
#define NOISE_FACTS_H

#import "image_t.h"

struct noise_facts
{
  uint64_t pixels, rays;
  double largest, rms;  // of the stated errors, at most the largest float
  uint64_t capped;      // pixels whose stated error is above the limit
};

/** Of a picture with the planes PLANE_SAMPLING and PLANE_SAMPLES; without the
    latter no rays. */
struct noise_facts noise_facts_of(image_t *image, double limit);

#endif
