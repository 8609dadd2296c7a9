// k_bvh_items.c - what goes into the tree: the boxes of all shapes that have
// one, as floats, in coordinates in which floats are fine enough.

#include "k_bvh_build.h"
#include "k_float.h"
#include <stdlib.h>

/** The box of a shape in the world, as its class has it. */
static struct k_bounds
box_of(const struct k_scene *scene, struct k_ref ref)
{
  struct k_bounds box = k_nothing();

  switch ((enum k_kind)ref.kind)
    {
    case K_SPHERE:
      {
        const struct k_sphere *s = &scene->spheres[ref.index];
        struct k_vec r = k_vec(s->radius, s->radius, s->radius);
        box.least = k_sub(s->center, r);
        box.most = k_add(s->center, r);
        return k_bounds_pad(box);
      }
    case K_POLYGON:
      {
        const struct k_polygon *p = &scene->polygons[ref.index];
        for (unsigned i = 0; i < p->n; i++)
          {
            box = k_bounds_include(box, k_vec(p->vertex[0][i],
                                              p->vertex[1][i],
                                              p->vertex[2][i]));
          }
        return k_bounds_pad(box);
      }
    case K_CONVEX:
      return scene->convex[ref.index].box;
    case K_USER:
      return scene->users[ref.index].user.box;
    case K_PLANE:
      break;
    }
  return k_unbounded();
}

static uint32_t
gather(const struct k_scene *scene, struct k_item *items)
{
  const uint32_t counts[] = { scene->sphere_count, scene->polygon_count,
                              scene->convex_count, scene->user_count };
  uint32_t n = 0;

  for (int kind = K_SPHERE; kind <= K_USER; kind++)
    {
      for (uint32_t i = 0; i < counts[kind]; i++)
        {
          struct k_ref ref = { kind, i };
          if (kind != K_USER || k_has_box(scene->users[i].user.box))
            {
              items[n++].ref = ref;
            }
        }
    }
  return n;
}

/** Chooses the tree's coordinates and puts every box into them. */
static void
normalise(const struct k_scene *scene, struct k_tree *tree,
          struct k_item *items, uint32_t n)
{
  struct k_bounds all = k_nothing();

  for (uint32_t i = 0; i < n; i++)
    {
      struct k_bounds box = box_of(scene, items[i].ref);
      all = k_bounds_include(k_bounds_include(all, box.least), box.most);
    }
  tree->center = k_scale(k_add(all.least, all.most), 0.5);
  double size = k_exponent_scale(k_sub(all.most, all.least));
  tree->scale = size > 0 ? 1 / size : 1;
  for (uint32_t i = 0; i < n; i++)
    {
      struct k_bounds box = box_of(scene, items[i].ref);
      struct k_vec least = k_scale(k_sub(box.least, tree->center),
                                   tree->scale);
      struct k_vec most = k_scale(k_sub(box.most, tree->center),
                                  tree->scale);
      for (int axis = 0; axis < 3; axis++)
        {
          items[i].least[axis] = k_float_below(k_component(least, axis));
          items[i].most[axis] = k_float_above(k_component(most, axis));
        }
      items[i].nothing = 0;
    }
}

enum k_status
k_tree_make(struct k_scene *scene, unsigned threads)
{
  struct k_tree *tree = &scene->tree;
  uint32_t room = scene->sphere_count + scene->polygon_count
    + scene->convex_count + scene->user_count;
  struct k_item *items = malloc((room + 1) * sizeof *items);
  enum k_status status = K_OK;

  if (!items)
    {
      return K_NO_MEMORY;
    }
  tree->ref_count = gather(scene, items);
  if (tree->ref_count)
    {
      normalise(scene, tree, items, tree->ref_count);
      status = k_bvh_build(tree, items, tree->ref_count, threads);
      tree->refs = malloc(tree->ref_count * sizeof *tree->refs);
      if (!tree->refs)
        {
          status = K_NO_MEMORY;
        }
      for (uint32_t i = 0; tree->refs && i < tree->ref_count; i++)
        {
          tree->refs[i] = items[i].ref;
        }
    }
  free(items);
  return status;
}
