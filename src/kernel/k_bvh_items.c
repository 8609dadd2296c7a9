// k_bvh_items.c - what goes into the tree: the boxes of all shapes that have
// one, as floats, in coordinates in which floats are fine enough.

#include "k_bvh_build.h"
#include "k_float.h"
#include "k_parallel.h"
#include "../large.h"
#include <pthread.h>
#include <stdlib.h>

/** The box of a polygon in the world, as its class has it. */
static struct k_bounds
box_of_polygon(const struct k_polygon *p)
{
  struct k_bounds box = k_nothing();

  for (unsigned i = 0; i < p->n; i++)
    {
      box = k_bounds_include(box, k_vec(p->vertex[0][i], p->vertex[1][i],
                                        p->vertex[2][i]));
    }
  return k_bounds_pad(box);
}

static inline struct k_bounds
box_of_sphere(const struct k_sphere *s)
{
  struct k_vec r = k_vec(s->radius, s->radius, s->radius);
  struct k_bounds box = { k_sub(s->center, r), k_add(s->center, r) };

  return k_bounds_pad(box);
}

static inline struct k_bounds
box_of(const struct k_scene *scene, struct k_ref ref)
{
  return ref.kind == K_SPHERE ? box_of_sphere(&scene->spheres[ref.index])
    : ref.kind == K_POLYGON ? box_of_polygon(&scene->polygons[ref.index])
    : ref.kind == K_CONVEX ? scene->convex[ref.index].box
    : scene->users[ref.index].user.box;
}

#define PIECE 8192              // shapes that a thread takes at once

/** All shapes that go into the tree, in the order of their kinds. */
struct shapes
{
  const struct k_scene *scene;
  uint32_t counts[K_USER + 1], count;
  uint32_t *users;              // those with a box
  struct k_tree *tree;
  struct k_item *items;
  uint32_t next;                // piece, atomic
  struct k_bounds all;          // the box of their boxes
  pthread_mutex_t lock;         // of that
};

static struct k_ref
ref_of(const struct shapes *s, uint32_t i)
{
  struct k_ref ref = { K_SPHERE, 0 };

  for (; i >= s->counts[ref.kind]; ref.kind++)
    {
      i -= s->counts[ref.kind];
    }
  ref.index = ref.kind == K_USER ? s->users[i] : i;
  return ref;
}

/** A piece that nobody has taken: its first and the one after its last. */
static int
take(struct shapes *s, uint32_t *first, uint32_t *end)
{
  uint32_t pieces = (s->count + PIECE - 1) / PIECE;
  uint32_t i = k_take(&s->next, pieces);

  *first = i * PIECE;
  *end = i + 1 < pieces ? *first + PIECE : s->count;
  return i < pieces;
}

static void
measure(void *context, unsigned thread)
{
  struct shapes *s = context;
  struct k_bounds all = k_nothing();
  uint32_t i, end;

  (void)thread;
  while (take(s, &i, &end))
    {
      for (; i < end; i++)
        {
          all = k_bounds_join(all, box_of(s->scene, ref_of(s, i)));
        }
    }
  pthread_mutex_lock(&s->lock);
  s->all = k_bounds_join(s->all, all);
  pthread_mutex_unlock(&s->lock);
}

/** Puts every box into the tree's coordinates. */
static void
convert(void *context, unsigned thread)
{
  struct shapes *s = context;
  const struct k_tree *tree = s->tree;
  uint32_t i, end;

  (void)thread;
  while (take(s, &i, &end))
    {
      for (; i < end; i++)
        {
          struct k_item *item = &s->items[i];
          item->ref = ref_of(s, i);
          item->zero = 0;
          struct k_bounds box = box_of(s->scene, item->ref);
          struct k_vec least = k_scale(k_sub(box.least, tree->center),
                                       tree->scale);
          struct k_vec most = k_scale(k_sub(box.most, tree->center),
                                      tree->scale);
          for (int axis = 0; axis < 3; axis++)
            {
              item->least[axis] = k_float_below(k_component(least, axis));
              item->most[axis] = k_float_above(k_component(most, axis));
            }
        }
    }
}

/** Counts what goes into the tree. 0: no memory. */
static int
count_shapes(struct shapes *s)
{
  const struct k_scene *scene = s->scene;
  uint32_t *boxed = &s->counts[K_USER];

  s->counts[K_SPHERE] = scene->sphere_count;
  s->counts[K_POLYGON] = scene->polygon_count;
  s->counts[K_CONVEX] = scene->convex_count;
  s->users = malloc((scene->user_count + 1) * sizeof *s->users);
  for (uint32_t i = 0; s->users && i < scene->user_count; i++)
    {
      if (k_has_box(scene->users[i].user.box))
        {
          s->users[(*boxed)++] = i;
        }
    }
  for (int kind = K_SPHERE; kind <= K_USER; kind++)
    {
      s->count += s->counts[kind];
    }
  return s->users != NULL;
}

enum k_status
k_tree_make(struct k_scene *scene, unsigned threads)
{
  struct k_tree *tree = &scene->tree;
  struct shapes s = { .scene = scene, .tree = tree, .all = k_nothing(),
                      .lock = PTHREAD_MUTEX_INITIALIZER };
  enum k_status status = count_shapes(&s) ? K_OK : K_NO_MEMORY;

  if (s.count)
    {
      threads = s.count > PIECE ? threads : 1;
      s.items = large_new(s.count * sizeof *s.items);
      status = K_NO_MEMORY;
    }
  if (s.items)
    {
      k_in_parallel(threads, measure, &s);
      tree->center = k_scale(k_add(s.all.least, s.all.most), 0.5);
      double size = k_exponent_scale(k_sub(s.all.most, s.all.least));
      tree->scale = size > 0 ? 1 / size : 1;
      s.next = 0;
      k_in_parallel(threads, convert, &s);
      status = k_bvh_build(tree, s.items, s.count, threads);
    }
  free(s.items);
  free(s.users);
  return status;
}
