#include "nff_solids.h"
#include "grow.h"

// Fewer faces close no volume.
#define FEWEST_FACES 4

/** An edge between two vertices a < b, in the hash table. */
struct edge
{
  unsigned a, b;
  unsigned forward, backward;   // faces that have it from a to b, b to a
  unsigned face;                // one of them
};

/** What is known while looking. */
struct search
{
  struct nff_face *faces;
  unsigned count;
  const struct value *values;
  unsigned *vertices;   // of all corners, face by face: a number of a value
  unsigned *parents;    // of all faces: connected ones have one root
  struct edge *edges;   // hash table; forward and backward 0: empty
  size_t mask;
  BOOL any_fill;        // fills are not told apart
};

static size_t
mix(size_t hash, uint64_t more)
{
  hash = (hash ^ more) * 0x9E3779B97F4A7C15;
  return hash ^ hash >> 32;
}

static BOOL
is_same_point(const struct value *p, const struct value *q)
{
  return p[0].number == q[0].number && p[1].number == q[1].number
    && p[2].number == q[2].number;
}

static size_t
hash_point(const struct value *p)
{
  size_t hash = 0;

  for (int axis = 0; axis < 3; axis++)
    {
      double x = p[axis].number + 0.0;  // -0 as +0
      uint64_t bits;
      memcpy(&bits, &x, sizeof bits);
      hash = mix(hash, bits);
    }
  return hash;
}

/** Gives all corners at one point the same number. */
static void
number_vertices(struct search *s)
{
  unsigned *table = new_array(s->mask + 1, sizeof *table);
  unsigned corner = 0;

  for (unsigned f = 0; f < s->count; f++)
    {
      for (unsigned i = 0; i < s->faces[f].count; i++)
        {
          unsigned value = s->faces[f].vertex + 3 * i;
          const struct value *p = &s->values[value];
          size_t slot = hash_point(p) & s->mask;
          while (table[slot] && !is_same_point(&s->values[table[slot] - 1], p))
            {
              slot = (slot + 1) & s->mask;
            }
          table[slot] = table[slot] ? table[slot] : value + 1;
          s->vertices[corner++] = table[slot];
        }
    }
  free(table);
}

static unsigned
root(unsigned *parents, unsigned face)
{
  while (parents[face] != face)
    {
      face = parents[face] = parents[parents[face]];
    }
  return face;
}

static BOOL
may_join(const struct search *s, unsigned f, unsigned g)
{
  const struct nff_face *a = &s->faces[f], *b = &s->faces[g];

  return a->alpha == b->alpha && a->ior == b->ior
    && (s->any_fill || a->fill == b->fill);
}

/** Notes the edge of a face, and that the face is connected with others that
    have it. */
static void
add_edge(struct search *s, unsigned face, unsigned from, unsigned to)
{
  unsigned a = MIN(from, to), b = MAX(from, to);
  size_t slot = mix(mix(0, a), b) & s->mask;
  struct edge *edge;

  if (a == b)
    {
      return;
    }
  for (;; slot = (slot + 1) & s->mask)
    {
      edge = &s->edges[slot];
      if (edge->forward + edge->backward == 0)
        {
          *edge = (struct edge){ .a = a, .b = b, .face = face };
          break;
        }
      if (edge->a == a && edge->b == b && may_join(s, edge->face, face))
        {
          s->parents[root(s->parents, face)] = root(s->parents, edge->face);
          break;
        }
    }
  edge->forward += from < to;
  edge->backward += from > to;
}

static void
add_edges(struct search *s)
{
  unsigned *v = s->vertices;

  for (unsigned f = 0; f < s->count; f++)
    {
      unsigned n = s->faces[f].count;
      s->parents[f] = f;
      for (unsigned i = 0; i < n && s->faces[f].solid == 0; i++)
        {
          add_edge(s, f, v[i], v[i + 1 == n ? 0 : i + 1]);
        }
      v += n;
    }
}

/** Numbers the connected parts that are closed, from *solids on. */
static void
number_solids(struct search *s, unsigned *solids)
{
  unsigned *sizes = new_array(s->count, sizeof *sizes);
  unsigned *numbers = new_array(s->count, sizeof *numbers);

  for (unsigned f = 0; f < s->count; f++)
    {
      sizes[root(s->parents, f)]++;
    }
  for (size_t i = 0; i <= s->mask; i++)
    {
      struct edge *edge = &s->edges[i];
      if (edge->forward + edge->backward > 0
          && (edge->forward != 1 || edge->backward != 1))
        {
          sizes[root(s->parents, edge->face)] = 0;
        }
    }
  for (unsigned f = 0; f < s->count; f++)
    {
      unsigned r = root(s->parents, f);
      if (sizes[r] >= FEWEST_FACES && s->faces[f].solid == 0)
        {
          numbers[r] = numbers[r] ? numbers[r] : ++*solids;
          s->faces[f].solid = numbers[r];
        }
    }
  free(numbers);
  free(sizes);
}

void
nff_find_solids(struct nff_face *faces, unsigned count,
                const struct value *values)
{
  struct search s = { .faces = faces, .count = count, .values = values };
  size_t corners = 0;
  unsigned solids = 0;

  for (unsigned f = 0; f < count; f++)
    {
      corners += faces[f].count;
    }
  if (corners == 0)
    {
      return;
    }
  for (s.mask = 1; s.mask < 2 * corners; s.mask = 2 * s.mask + 1)
    {
    }
  s.vertices = new_array(corners, sizeof *s.vertices);
  s.parents = new_array(count, sizeof *s.parents);
  s.edges = new_array(s.mask + 1, sizeof *s.edges);
  number_vertices(&s);
  for (int pass = 0; pass < 2; pass++)
    {
      s.any_fill = pass == 1;
      memset(s.edges, 0, (s.mask + 1) * sizeof *s.edges);
      add_edges(&s);
      number_solids(&s, &solids);
    }
  free(s.edges);
  free(s.parents);
  free(s.vertices);
}
