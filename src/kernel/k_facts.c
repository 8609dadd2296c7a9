// k_facts.c - what a scene consists of, for --plan and --stats.

#include "k_scene.h"
#include <string.h>

static double
half_area(const struct k_node *node, int i)
{
  double x = (double)node->bounds[3][i] - node->bounds[0][i];
  double y = (double)node->bounds[4][i] - node->bounds[1][i];
  double z = (double)node->bounds[5][i] - node->bounds[2][i];

  return x < 0 ? 0 : x * y + y * z + z * x;
}

/** The surface area heuristic's cost of the tree: one for a node, one for a
    shape, by the chance that a ray through the root's box meets their box. */
static double
cost_of(const struct k_tree *tree)
{
  struct k_bounds all = k_nothing();
  double sum = 0;

  for (uint32_t n = 0; n < tree->node_count; n++)
    {
      const struct k_node *node = &tree->nodes[n];
      for (int i = 0; i < K_WIDTH; i++)
        {
          uint32_t child = node->child[i];
          sum += half_area(node, i) * (child & K_LEAF ? (child & 7) + 1 : 1);
          if (n == 0 && half_area(node, i) > 0)
            {
              all = k_bounds_include(all, k_vec(node->bounds[0][i],
                                                node->bounds[1][i],
                                                node->bounds[2][i]));
              all = k_bounds_include(all, k_vec(node->bounds[3][i],
                                                node->bounds[4][i],
                                                node->bounds[5][i]));
            }
        }
    }
  struct k_vec e = k_sub(all.most, all.least);
  double area = e.x * e.y + e.y * e.z + e.z * e.x;
  return area > 0 ? 1 + sum / area : 0;
}

static size_t
bytes_of(const struct k_scene *scene)
{
  size_t bytes = sizeof *scene
    + scene->material_room * sizeof *scene->materials
    + scene->light_room * sizeof *scene->lights
    + scene->sphere_room * sizeof *scene->spheres
    + scene->plane_room * sizeof *scene->planes
    + scene->polygon_room * sizeof *scene->polygons
    + scene->convex_room * sizeof *scene->convex
    + scene->face_room * sizeof *scene->faces
    + scene->user_room * sizeof *scene->users
    + scene->media_room * sizeof *scene->media
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
  facts->cost = cost_of(&scene->tree);
  facts->bytes = bytes_of(scene);
  facts->isa = scene->isa->name;
  facts->has_mirrors = scene->has_mirrors;
  facts->has_clear = scene->has_clear;
}
