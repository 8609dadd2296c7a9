#import "noise_facts.h"
#include <float.h>

struct noise_facts
noise_facts_of(image_t *image, double limit)
{
  struct noise_facts facts = {
    .pixels = (uint64_t)[image width] * [image height]
  };
  double squares = 0;

  for (uint64_t i = 0; i < facts.pixels; i++)
    {
      double error = MIN(image->planes[PLANE_SAMPLING][i], FLT_MAX);
      facts.rays += image->planes[PLANE_SAMPLES]
        ? (uint64_t)image->planes[PLANE_SAMPLES][i] : 0;
      facts.largest = MAX(facts.largest, error);
      facts.capped += error > limit;
      squares += error * error;
    }
  facts.rms = sqrt(squares / facts.pixels);
  return facts;
}
