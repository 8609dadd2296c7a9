// k_scene.c - gathering a scene.

#include "k_polygon_hit.h"
#include "k_scene.h"
#include "../large.h"
#include <stdlib.h>
#include <string.h>

/** Makes an array longer. 0: no memory. */
static int
grow(struct k_scene *scene, void *array, uint32_t *room, size_t size)
{
  char **items = array;
  uint32_t more = *room ? 2 * *room : 16;
  char *grown = realloc(*items, more * size);

  if (!grown)
    {
      scene->is_short_of_memory = 1;
      return 0;
    }
  *items = grown;
  *room = more;
  return 1;
}

/** Room for one more in an array; NULL when memory is short. */
#define ONE_MORE(scene, many, one) \
  ((scene)->one##_count < (scene)->one##_room \
     || grow(scene, &(scene)->many, &(scene)->one##_room, \
             sizeof *(scene)->many) \
   ? &(scene)->many[(scene)->one##_count++] : NULL)

struct k_scene *
k_scene_new(void)
{
  struct k_scene *scene = calloc(1, sizeof *scene);

  if (scene)
    {
      k_add_medium(scene, 0);   // 0: none
    }
  return scene;
}

void
k_scene_free(struct k_scene *scene)
{
  if (!scene)
    {
      return;
    }
  for (uint32_t i = 0; i < scene->vertices_count; i++)
    {
      free(scene->vertices[i]);
    }
  for (uint32_t i = 0; i < scene->polygon_count; i++)
    {
      free(scene->polygons[i].grid);
    }
  free(scene->vertices);
  free(scene->materials);
  free(scene->lights);
  free(scene->spheres);
  free(scene->planes);
  free(scene->polygons);
  free(scene->convex);
  free(scene->faces);
  free(scene->users);
  free(scene->unbounded);
  free(scene->media);
  free(scene->medium_refs);
  free(scene->tree.nodes);
  free(scene->tree.refs);
  free(scene);
}

unsigned
k_add_medium(struct k_scene *scene, int is_bounded)
{
  struct k_medium *m = ONE_MORE(scene, media, media);

  if (!m)
    {
      return 0;
    }
  memset(m, 0, sizeof *m);
  m->is_bounded = is_bounded;
  return scene->media_count - 1;
}

unsigned
k_add_material(struct k_scene *scene, const struct k_material *material)
{
  struct k_material *m = ONE_MORE(scene, materials, material);

  if (!m)
    {
      return 0;
    }
  *m = *material;
  return scene->material_count - 1;
}

void
k_add_light(struct k_scene *scene, const struct k_light *light)
{
  struct k_light *l = ONE_MORE(scene, lights, light);

  if (l)
    {
      *l = *light;
    }
}

void
k_add_sphere(struct k_scene *scene, struct k_surface s, struct k_vec center,
             double radius)
{
  struct k_sphere *sphere = ONE_MORE(scene, spheres, sphere);

  if (sphere)
    {
      sphere->center = center;
      sphere->radius = radius;
      sphere->s = s;
    }
}

void
k_expect_spheres(struct k_scene *scene, size_t count)
{
  size_t room = scene->sphere_count + count;
  struct k_sphere *spheres = room > scene->sphere_room && room < UINT32_MAX
    ? large_new(room * sizeof *spheres) : NULL;

  if (spheres)
    {
      if (scene->sphere_count)
        {
          memcpy(spheres, scene->spheres,
                 scene->sphere_count * sizeof *spheres);
        }
      free(scene->spheres);
      scene->spheres = spheres;
      scene->sphere_room = room;
    }
}

void
k_add_plane(struct k_scene *scene, struct k_surface s, struct k_plane plane)
{
  struct k_flat *flat = ONE_MORE(scene, planes, plane);

  if (flat)
    {
      flat->plane = plane;
      flat->s = s;
    }
}

void
k_add_polygon(struct k_scene *scene, struct k_surface s,
              struct k_plane plane, struct k_vec newell, unsigned n,
              const double *const vertex[3], int test)
{
  struct k_polygon *polygon = ONE_MORE(scene, polygons, polygon);
  double **vertices = ONE_MORE(scene, vertices, vertices);
  unsigned padded = n + 5;      // see k_polygon_crossings_4
  double *copy = malloc(3 * padded * sizeof *copy);

  if (!polygon || !vertices || !copy)
    {
      scene->is_short_of_memory = 1;
      free(copy);
      scene->polygon_count -= polygon != NULL;
      scene->vertices_count -= vertices != NULL;
      return;
    }
  *vertices = copy;
  for (int axis = 0; axis < 3; axis++)
    {
      double *v = copy + axis * padded + 1;
      memcpy(v, vertex[axis], n * sizeof *v);
      v[-1] = v[n - 1];
      for (unsigned i = n; i < n + 4; i++)
        {
          v[i] = v[n - 1];
        }
      polygon->vertex[axis] = v;
    }
  polygon->plane = plane;
  polygon->newell = newell;
  polygon->n = n;
  polygon->test = test;
  polygon->grazing = k_polygon_grazing(&plane, n, polygon->vertex);
  polygon->grid = test == 0 && polygon->grazing == K_GRAZING
    ? k_polygon_grid(&plane, n, polygon->vertex) : NULL;
  polygon->s = s;
}

void
k_add_convex(struct k_scene *scene, unsigned n, const struct k_surface *s,
             const struct k_plane *plane, struct k_bounds box,
             unsigned medium)
{
  struct k_convex *convex = ONE_MORE(scene, convex, convex);

  if (!convex)
    {
      return;
    }
  convex->first = scene->face_count;
  convex->n = n;
  convex->medium = medium;
  convex->box = box;
  for (unsigned i = 0; i < n; i++)
    {
      struct k_flat *face = ONE_MORE(scene, faces, face);
      if (!face)
        {
          return;
        }
      face->plane = plane[i];
      face->s = s[i];
    }
}

void
k_add_user(struct k_scene *scene, struct k_surface s, struct k_user user)
{
  struct k_user_shape *shape = ONE_MORE(scene, users, user);

  if (!shape)
    {
      return;
    }
  shape->user = user;
  shape->s = s;
  // One of k_nothing() is not asked at all.
  if (!k_has_box(user.box) && !(user.box.least.x > user.box.most.x))
    {
      uint32_t *at = ONE_MORE(scene, unbounded, unbounded);
      if (at)
        {
          *at = scene->user_count - 1;
        }
    }
}

/** Calls f for every shape that bounds a medium. */
#define LIST(medium, kind, index) \
  do \
    { \
      if (medium) \
        { \
          f(scene, medium, kind, index); \
        } \
    } \
  while (0)

static void
each_in_medium(struct k_scene *scene,
               void (*f)(struct k_scene *, unsigned, enum k_kind, uint32_t))
{
  for (uint32_t i = 0; i < scene->sphere_count; i++)
    {
      LIST(scene->spheres[i].s.medium, K_SPHERE, i);
    }
  for (uint32_t i = 0; i < scene->plane_count; i++)
    {
      LIST(scene->planes[i].s.medium, K_PLANE, i);
    }
  for (uint32_t i = 0; i < scene->polygon_count; i++)
    {
      LIST(scene->polygons[i].s.medium, K_POLYGON, i);
    }
  for (uint32_t i = 0; i < scene->convex_count; i++)
    {
      LIST(scene->convex[i].medium, K_CONVEX, i);
    }
  for (uint32_t i = 0; i < scene->user_count; i++)
    {
      LIST(scene->users[i].s.medium, K_USER, i);
    }
}

#undef LIST

static void
count_medium(struct k_scene *scene, unsigned medium, enum k_kind kind,
             uint32_t index)
{
  (void)kind;
  (void)index;
  scene->media[medium].count++;
}

static void
fill_medium(struct k_scene *scene, unsigned medium, enum k_kind kind,
            uint32_t index)
{
  struct k_medium *m = &scene->media[medium];
  struct k_ref ref = { kind, index };

  scene->medium_refs[m->first + m->count++] = ref;
}

static enum k_status
list_media(struct k_scene *scene)
{
  uint32_t total = 0;

  if (scene->media_count <= 1)
    {
      return K_OK;      // not even one
    }
  each_in_medium(scene, count_medium);
  for (uint32_t i = 0; i < scene->media_count; i++)
    {
      struct k_medium *m = &scene->media[i];
      m->first = total;
      total += m->count;
      m->count = 0;
    }
  scene->medium_refs = malloc((total + 1) * sizeof *scene->medium_refs);
  if (!scene->medium_refs)
    {
      return K_NO_MEMORY;
    }
  each_in_medium(scene, fill_medium);
  return K_OK;
}

enum k_status
k_scene_finish(struct k_scene *scene, struct k_settings settings)
{
  scene->settings = settings;
  for (uint32_t i = 0; i < scene->material_count; i++)
    {
      scene->has_mirrors |= !k_is_zero(scene->materials[i].specular);
      scene->has_clear |= scene->materials[i].alpha > 0;
    }
  scene->isa = k_isa_find(settings.isa);
  if (!scene->isa)
    {
      return K_NO_ISA;
    }
  if (scene->is_short_of_memory || list_media(scene) != K_OK)
    {
      return K_NO_MEMORY;
    }
  return k_tree_make(scene, settings.threads);
}
