// k_scene.h - the scene inside the kernel: arrays of shapes, and the tree.

#ifndef K_SCENE_H
#define K_SCENE_H

#include "k_polygon_grid.h"
#include "k_ray.h"

struct k_sphere
{
  struct k_vec center;
  double radius;
  struct k_surface s;
};

struct k_flat                   // an unbounded plane
{
  struct k_plane plane;
  struct k_surface s;
};

struct k_polygon
{
  struct k_plane plane;
  struct k_vec newell;
  const double *vertex[3];      // into k_scene.vertices
  unsigned n;
  int test;
  double grazing;               // k_polygon_grazing
  struct k_polygon_grid *grid;  // or NULL
  struct k_surface s;
};

struct k_convex
{
  unsigned first, n;            // its faces, in k_scene.faces
  unsigned medium;
  struct k_bounds box;
};

struct k_user_shape
{
  struct k_user user;
  struct k_surface s;
};

enum k_kind
{
  K_SPHERE,
  K_POLYGON,
  K_CONVEX,
  K_USER,
  K_PLANE               // never in the tree
};

/** What a ray can be in: the shapes that bound it. */
struct k_medium
{
  uint32_t first, count;        // in k_scene.medium_refs
  int is_bounded;
};

/** A shape in the tree. */
struct k_ref
{
  uint32_t kind : 3;
  uint32_t index : 29;
};

#define K_WIDTH 8               // children of a node
#define K_LEAF 0x80000000u      // a child that is a leaf:
#define K_DEEPEST 96            // no tree has more levels
#define K_LEAF_MOST 8           // 1 + bits 0-2 shapes from bits 3-30 of refs

/** A node: the boxes of up to 8 children, as floats rounded outwards, in
    coordinates relative to k_tree.center times k_tree.scale; a box that is
    not there is inside out. 224 bytes. */
struct k_node
{
  float bounds[6][K_WIDTH];     // least x y z, most x y z
  uint32_t child[K_WIDTH];      // index of a node, or a leaf
};

_Static_assert(sizeof(struct k_node) == 224, "3.5 cache lines");

struct k_tree
{
  struct k_node *nodes;         // nodes[0] is the root; NULL: no tree
  uint32_t node_count;
  struct k_ref *refs;           // shapes, in the order of the leaves
  uint32_t ref_count;
  struct k_vec center;          // and the scale behind it: k_float_o
  double scale;                 // a power of two
  unsigned depth;
  double cost;                  // see k_facts
};

struct k_scene
{
  struct k_material *materials;
  struct k_light *lights;
  struct k_sphere *spheres;
  struct k_flat *planes;
  struct k_polygon *polygons;
  struct k_convex *convex;
  struct k_flat *faces;         // of convex solids
  struct k_user_shape *users;
  uint32_t *unbounded;          // users without a box
  double **vertices;            // one piece per polygon: x…, y…, z…
  struct k_medium *media;       // media[0]: none
  struct k_ref *medium_refs;
  uint32_t material_count, light_count, sphere_count, plane_count,
    polygon_count, convex_count, face_count, user_count, unbounded_count,
    vertices_count, media_count;
  uint32_t material_room, light_room, sphere_room, plane_room, polygon_room,
    convex_room, face_room, user_room, unbounded_room, vertices_room,
    media_room;
  int is_short_of_memory;
  int has_mirrors, has_clear;   // materials that make rays
  struct k_tree tree;
  struct k_settings settings;
  const struct k_isa *isa;
};

#define K_MANY EYE_RAYS         // rays that are traced together, at most

/** The colours of up to K_MANY eye rays, and what they start in. */
typedef void k_trace_eye(const struct k_scene *scene, struct eye_ray *rays,
                         unsigned n, const struct k_media *const *media,
                         struct counters *counters);

/** Those where k_is_plain. */
k_trace_eye k_ambient_base, k_ambient_avx2;

/** What an instruction set provides: the search for one ray and for up to
    K_MANY, feelers that go to one light or none of them; the colours of up to
    K_MANY eye rays, in any scene and in one that is plain, and what one of them
    hits. */
struct k_isa
{
  const char *name;
  void (*closest)(const struct k_scene *scene, struct k_ray *ray);
  void (*find)(const struct k_scene *scene, struct k_ray *rays, unsigned n,
               int are_feelers);
  k_trace_eye *trace, *ambient;
  struct k_surface_hit (*first_hit)(const struct k_scene *scene,
                                    struct k_vec o, struct k_vec d,
                                    const struct k_media *media);
};

/** Makes scene->tree of everything with a box. */
enum k_status k_tree_make(struct k_scene *scene, unsigned threads);

/** The instruction set for this machine, or the one named; NULL: none. */
const struct k_isa *k_isa_find(const char *name);

/** Whether light goes no further than ambient in this scene. A program made with
    -DPLAIN_SCENES knows no others: bench/absent. */
static inline int
k_is_plain(const struct k_scene *scene)
{
#ifdef PLAIN_SCENES
  return 1;
#else
  return !(scene->light_count || scene->has_mirrors || scene->has_clear);
#endif
}

/** Whether a shape with this box goes into the tree: it has one, no larger
    than scenes can be. */
static inline int
k_has_box(struct k_bounds b)
{
  return !k_is_unbounded(b)
    && k_max2(k_norm_max(b.least), k_norm_max(b.most)) < 0x1p500;
}

static inline int
k_is_opaque(const struct k_scene *scene, const struct k_surface *s)
{
  return scene->materials[s->material].alpha == 0;
}

#endif
