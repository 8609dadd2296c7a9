// k_ambient.inc.c - the colours of eye rays in a scene without lights, mirrors
// and glass, compiled once for each instruction set by the k_ambient_*.c. There
// is no more than ambient, and there are no rays but the eye's: the search is
// compiled for those alone.

#define K_ONLY_AMBIENT
#include "k_beam.inc.c"
#include "../shade.h"

__attribute__((flatten)) void
K_AMBIENT(const struct k_scene *scene, struct eye_ray *eye, unsigned n,
          const struct k_media *const *media, struct counters *counters)
{
  struct k_ray rays[K_MANY];

  (void)media;                  // nothing that a ray could be in
  counters->eye += n;
  for (unsigned i = 0; i < n; i++)
    {
      k_ray_start(&rays[i], eye[i].o, eye[i].d, NULL, counters);
    }
  k_find_many(scene, rays, n, 0);
  for (unsigned i = 0; i < n; i++)
    {
      const struct k_hit *hit = &rays[i].hit;
      if (!hit->surface)
        {
          eye[i].color = scene->settings.background;
          continue;
        }
      k_count_hit(&rays[i]);
      eye[i].color
        = shade_ambient(scene->materials[hit->surface->material].ambient,
                        hit->t);
    }
}
