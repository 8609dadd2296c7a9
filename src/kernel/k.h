// k.h - the only door of the kernel: a scene as plain C arrays, built once,
// and rays traced in it without objects, messages or allocation. What a ray
// does is what ray_t does, in the same arithmetic: both engines give the same
// bytes. The kernel neither prints nor exits.

#ifndef K_H
#define K_H

#include <stddef.h>
#include <stdint.h>
#include "../counters.h"
#include "../cut.h"
#include "../eye_ray.h"
#include "../shade.h"
#include "k_bounds.h"
#include "k_plane_hit.h"

struct k_scene;
struct k_ray;

enum k_status
{
  K_OK,
  K_NO_MEMORY,
  K_NO_ISA              // the machine does not have it
};

struct k_material
{
  struct k_vec ambient, diffuse, specular;
  double shininess, alpha, ior;
};

struct k_light
{
  struct k_vec location, emissivity;
  int falloff;
};

/** What every surface has, whatever its shape. */
struct k_surface
{
  unsigned number;      // of the object, from 1: ties, and what is shown
  unsigned material;    // from k_add_material
  unsigned medium;      // what a ray is in behind it, from k_add_medium; 0
                        // for a thin sheet
  double slack;         // as in object_t
};

/** A shape that the kernel does not know is asked through this function; it
    changes the ray's hit when it has a nearer one. */
struct k_user
{
  void (*hits)(void *object, const struct k_surface *s, struct k_ray *ray);
  void *object;
  struct k_bounds box;
};

/** The name of the instruction set that this machine gets. */
const char *k_isa_best(void);

// Building. Every k_add_ copies what it is given; K_NO_MEMORY is remembered
// and told by k_scene_finish.

struct k_scene *k_scene_new(void);
void k_scene_free(struct k_scene *scene);

/** Something a ray can be in; bounded: it has to come out again. */
unsigned k_add_medium(struct k_scene *scene, int is_bounded);
unsigned k_add_material(struct k_scene *scene, const struct k_material *m);
void k_add_light(struct k_scene *scene, const struct k_light *light);
void k_add_sphere(struct k_scene *scene, struct k_surface s,
                  struct k_vec center, double radius);
/** Makes room for up to so many spheres, which takes less time than to make it
    little by little. */
void k_expect_spheres(struct k_scene *scene, size_t count);

void k_add_plane(struct k_scene *scene, struct k_surface s,
                 struct k_plane plane);

/** A polygon; test as in model_t's enum polygon_test. With a medium it is a
    face of a clear solid that is not clipped. */
void k_add_polygon(struct k_scene *scene, struct k_surface s,
                   struct k_plane plane, struct k_vec newell, unsigned n,
                   const double *const vertex[3], int test);

/** A clear convex solid of n faces. */
void k_add_convex(struct k_scene *scene, unsigned n,
                  const struct k_surface *s, const struct k_plane *plane,
                  struct k_bounds box, unsigned medium);

void k_add_user(struct k_scene *scene, struct k_surface s,
                struct k_user user);

struct k_settings
{
  struct k_vec background;
  unsigned max_depth;
  struct cut_rule cut;
  struct shade_choice choice;
  unsigned threads;     // that build the tree
  const char *isa;      // instruction set; NULL: the best there is
};

/** Builds the tree. Nothing may be added afterwards. */
enum k_status k_scene_finish(struct k_scene *scene,
                             struct k_settings settings);

/** What a finished scene consists of. */
struct k_facts
{
  uint32_t spheres, planes, polygons, convex, users, media;
  uint32_t nodes, depth;        // of the tree
  double cost;                  // what a ray through the scene's box expects
                                // to ask: nodes and shapes, by their surfaces
  size_t bytes;                 // of everything
  const char *isa;              // instruction set in use
  int has_mirrors, has_clear;   // materials that make rays
};

void k_scene_facts(const struct k_scene *scene, struct k_facts *facts);

// Tracing; any number of threads at once.

/** One entry of the media a ray is in, and what is below it. */
struct k_media
{
  unsigned medium;
  double ior;
  const struct k_media *below;
};

/** What an eye ray hits first. */
struct k_surface_hit
{
  double t;
  struct k_vec N;
  unsigned number;      // 0: nothing
};

/** The colours of n eye rays; faster when they go much the same way. What
    each starts in is media[i]; media NULL: all in nothing. */
void k_trace(const struct k_scene *scene, struct eye_ray *rays, unsigned n,
             const struct k_media *const *media, struct counters *counters);

struct k_surface_hit k_first_hit(const struct k_scene *scene, struct k_vec o,
                                 struct k_vec d,
                                 const struct k_media *media);

#endif
