// k_trace.c - tracing, by the scene's instruction set.

#include "k_scene.h"

void
k_trace(const struct k_scene *scene, struct eye_ray *rays, unsigned n,
        const struct k_media *const *media, struct counters *counters)
{
  int is_plain = k_is_plain(scene);
  k_trace_eye *trace = is_plain ? scene->isa->ambient : scene->isa->trace;

  for (unsigned i = 0; is_plain && cut_is_on(&scene->settings.cut) && i < n;
       i++)
    {
      rays[i].error = 0;        // there is nothing to cut
    }
  for (unsigned i = 0; i < n; i += K_MANY)
    {
      trace(scene, &rays[i], n - i < K_MANY ? n - i : K_MANY,
            media ? &media[i] : NULL, counters);
    }
}

struct k_surface_hit
k_first_hit(const struct k_scene *scene, struct k_vec o, struct k_vec d,
            const struct k_media *media)
{
  return scene->isa->first_hit(scene, o, d, media);
}
