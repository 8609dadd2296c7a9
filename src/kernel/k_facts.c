// k_facts.c - what a scene consists of, for --plan and --stats.

#include "k_scene.h"
#include <string.h>

static size_t
bytes_of(const struct k_scene *scene)
{
  size_t bytes = sizeof *scene
    + scene->material_count * sizeof *scene->materials
    + scene->light_count * sizeof *scene->lights
    + scene->sphere_count * sizeof *scene->spheres
    + scene->plane_count * sizeof *scene->planes
    + scene->polygon_count * sizeof *scene->polygons
    + scene->convex_count * sizeof *scene->convex
    + scene->face_count * sizeof *scene->faces
    + scene->user_count * sizeof *scene->users
    + scene->media_count * sizeof *scene->media
    + scene->tree.node_count * sizeof *scene->tree.nodes
    + scene->tree.ref_count * sizeof *scene->tree.refs;

  for (uint32_t i = 0; i < scene->polygon_count; i++)
    {
      const struct k_polygon *p = &scene->polygons[i];
      bytes += 3 * (p->n + 5) * sizeof(double);
      bytes += p->grid ? sizeof *p->grid + p->grid->side * p->grid->side / 4
        : 0;
    }
  return bytes;
}

void
k_scene_facts(const struct k_scene *scene, struct k_facts *facts)
{
  memset(facts, 0, sizeof *facts);
  facts->spheres = scene->sphere_count;
  facts->planes = scene->plane_count;
  facts->polygons = scene->polygon_count;
  facts->convex = scene->convex_count;
  facts->users = scene->user_count;
  facts->media = scene->media_count - 1;
  facts->nodes = scene->tree.node_count;
  facts->depth = scene->tree.depth;
  facts->cost = scene->tree.cost;
  facts->bytes = bytes_of(scene);
  facts->isa = scene->isa->name;
  facts->has_mirrors = scene->has_mirrors;
  facts->has_clear = scene->has_clear;
}
