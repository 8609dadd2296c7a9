// shell.m - shells_close: which faces close a volume and how they have to be
// turned. Plain C, on indices.

#import "support.h"
#include "shell.h"
#include "test.h"

/** Faces of up to 6 corners, with the arrays that shell_face points to. */
struct body
{
  unsigned count;
  struct shell_face faces[64];
  double at[64][3][6];
  const double *arrays[64][3];
};

static void
add(struct body *b, unsigned n, const struct k_vec *v)
{
  unsigned f = b->count++;

  for (unsigned i = 0; i < n; i++)
    {
      b->at[f][0][i] = v[i].x;
      b->at[f][1][i] = v[i].y;
      b->at[f][2][i] = v[i].z;
    }
  for (int axis = 0; axis < 3; axis++)
    {
      b->arrays[f][axis] = b->at[f][axis];
    }
  b->faces[f].n = n;
  b->faces[f].vertex = b->arrays[f];
}

/** A box; each bit of `turned` winds a face the other way round. Untouched
    they are all outward. */
static void
add_box(struct body *b, struct k_vec least, struct k_vec most,
        unsigned turned)
{
  static const int faces[6][4] = {
    { 0, 2, 3, 1 }, { 4, 5, 7, 6 }, { 0, 1, 5, 4 },
    { 2, 6, 7, 3 }, { 0, 4, 6, 2 }, { 1, 3, 7, 5 }
  };

  for (int f = 0; f < 6; f++)
    {
      struct k_vec v[4];
      for (int i = 0; i < 4; i++)
        {
          int corner = faces[f][turned >> f & 1 ? 3 - i : i];
          v[i] = k_vec(corner & 1 ? most.x : least.x,
                       corner & 2 ? most.y : least.y,
                       corner & 4 ? most.z : least.z);
        }
      add(b, 4, v);
    }
}

static struct k_vec
cube_corner(double x)
{
  return k_vec(x, x, x);
}

/** How many faces from `first` on are not turned as the bits say. */
static unsigned
unlike(const struct body *b, unsigned first, unsigned turned)
{
  unsigned wrong = 0;

  for (unsigned f = 0; f < 6; f++)
    {
      wrong += b->faces[first + f].is_turned != (int)(turned >> f & 1);
    }
  return wrong;
}

static void
boxes(void)
{
  struct shell_edge open;
  unsigned wrong = 0;
  struct body b;

  for (unsigned turned = 0; turned < 64; turned++)
    {
      for (int k = -300; k <= 300; k += 100)
        {
          double s = ldexp(1, k);
          b.count = 0;
          add_box(&b, cube_corner(-s), cube_corner(s), turned);
          wrong += shells_close(b.faces, b.count, &open) != 1;
          wrong += unlike(&b, 0, turned);
        }
    }
  PASS(wrong == 0, "a box is closed whichever way its faces are wound, and"
       " those are turned that need it: %u", wrong);

  wrong = 0;
  for (unsigned turned = 0; turned < 64; turned++)
    {
      b.count = 0;
      add_box(&b, cube_corner(-1), cube_corner(1), turned);
      add_box(&b, cube_corner(-3), cube_corner(3), 63 - turned);
      add_box(&b, cube_corner(-2), cube_corner(2), turned ^ 21);
      add_box(&b, k_vec(4, 0, 0), k_vec(5, 1, 1), turned ^ 42);
      wrong += shells_close(b.faces, b.count, &open) != 4;
      wrong += unlike(&b, 0, turned);
      wrong += unlike(&b, 6, 63 - turned);
      wrong += unlike(&b, 12, 63 ^ turned ^ 21);
      wrong += unlike(&b, 18, turned ^ 42);
      wrong += b.faces[0].shell == b.faces[6].shell
        || b.faces[6].shell == b.faces[12].shell
        || b.faces[0].shell != b.faces[5].shell;
    }
  PASS(wrong == 0, "a shell in an odd number of others is a cavity, others"
       " are not: %u", wrong);
}

static void
add_triangle(struct body *b, struct k_vec p, struct k_vec q, struct k_vec r,
             int is_turned)
{
  struct k_vec v[3] = { p, is_turned ? r : q, is_turned ? q : r };

  add(b, 3, v);
}

/** Turns everything at random, so that points on a face are off it by
    rounding. */
static void
tilt(struct body *b, struct support_random *random)
{
  struct k_vec x = support_direction(random);
  struct k_vec y = k_unit(k_cross(x, support_direction(random)));
  struct k_vec z = k_cross(x, y);

  for (unsigned f = 0; f < b->count; f++)
    {
      for (unsigned i = 0; i < b->faces[f].n; i++)
        {
          double *at[3] = { &b->at[f][0][i], &b->at[f][1][i],
                            &b->at[f][2][i] };
          struct k_vec v = k_add(k_add(k_scale(x, *at[0]),
                                       k_scale(y, *at[1])),
                                 k_scale(z, *at[2]));
          *at[0] = v.x;
          *at[1] = v.y;
          *at[2] = v.z;
        }
    }
}

/** Shells that stand on another's face, outside or inside, with some of their
    corners or with all. */
static void
touching(void)
{
  struct shell_edge open;
  unsigned wrong[5] = { 0 };

  for (unsigned seed = 0; seed < 200; seed++)
    {
      struct support_random random = support_seed(seed);
      unsigned turned = 64 * support_unit(&random);
      double a = support_between(&random, -2, 1);
      struct body b[5];
      for (int k = 0; k < 5; k++)
        {
          b[k].count = 0;
          add_box(&b[k], cube_corner(-3), cube_corner(3), turned);
        }
      add_box(&b[0], k_vec(a, -1, 3), k_vec(a + 1, 1, 4), 0);
      add_box(&b[1], k_vec(a, -1, -3), k_vec(a + 1, 1, 2), 63);
      add_box(&b[2], k_vec(-1, -3, a), k_vec(1, 3, a + 1), 63);
      for (int k = 0; k < 8; k++)
        {
          // An octahedron with a corner in the middle of each face.
          struct k_vec x = k_vec(k & 1 ? 3 : -3, 0, 0);
          struct k_vec y = k_vec(0, k & 2 ? 3 : -3, 0);
          struct k_vec z = k_vec(0, 0, k & 4 ? 3 : -3);
          add_triangle(&b[3], x, y, z, __builtin_popcount(k) % 2);
        }
      // A tetrahedron with four of the corners: its edges are diagonals.
      struct k_vec p = k_vec(3, 3, 3), q = k_vec(3, -3, -3);
      struct k_vec r = k_vec(-3, 3, -3), s = k_vec(-3, -3, 3);
      add_triangle(&b[4], p, q, r, 1);
      add_triangle(&b[4], p, r, s, 1);
      add_triangle(&b[4], p, s, q, 1);
      add_triangle(&b[4], q, s, r, 1);
      for (int k = 0; k < 5; k++)
        {
          unsigned faces_turned = 0;
          if (seed % 2)
            {
              tilt(&b[k], &random);
            }
          wrong[k] += shells_close(b[k].faces, b[k].count, &open) != 2
            || unlike(&b[k], 0, turned);
          for (unsigned f = 6; f < b[k].count; f++)
            {
              faces_turned += b[k].faces[f].is_turned;
            }
          wrong[k] += faces_turned != 0;
        }
    }
  PASS(wrong[0] == 0, "a box that stands on another is outside: %u",
       wrong[0]);
  PASS(wrong[1] == 0, "one that stands on its floor is a cavity: %u",
       wrong[1]);
  PASS(wrong[2] == 0, "and one between two walls: %u", wrong[2]);
  PASS(wrong[3] == 0, "and an octahedron that touches every face: %u",
       wrong[3]);
  PASS(wrong[4] == 0, "and a tetrahedron whose edges all lie on it: %u",
       wrong[4]);
}

/** Boxes in a box, so many that it is of use not to ask them two by two. */
static void
many(void)
{
  enum { SIDE = 27, BOXES = SIDE * SIDE * SIDE, FACES = 6 * (BOXES + 1) };
  struct shell_face *faces = calloc(FACES, sizeof *faces);
  struct body *bodies = calloc(BOXES + 1, sizeof *bodies);
  struct shell_edge open;
  unsigned wrong = 0;

  for (unsigned i = 0; i <= BOXES; i++)
    {
      struct k_vec at = k_vec(i % SIDE, i / SIDE % SIDE,
                              i / (SIDE * SIDE) % SIDE);
      bodies[i].count = 0;
      add_box(&bodies[i], i ? at : cube_corner(-1),
              i ? k_add(at, cube_corner(0.5)) : cube_corner(SIDE), i % 64);
      memcpy(&faces[6 * i], bodies[i].faces, 6 * sizeof *faces);
    }
  int shells = shells_close(faces, FACES, &open);
  for (unsigned f = 0; f < FACES; f++)
    {
      unsigned turned = f / 6 % 64 >> f % 6 & 1;
      wrong += faces[f].is_turned != (int)(f < 6 ? turned : !turned);
    }
  PASS(shells == BOXES + 1 && wrong == 0, "%u boxes in a box are %d shells,"
       " all but one cavities: %u", BOXES, shells, wrong);
  free(faces);
  free(bodies);
}

static void
faults(void)
{
  struct shell_edge open = { 0 };
  struct body b = { 0 };

  add_box(&b, cube_corner(-1), cube_corner(1), 0);
  for (unsigned f = 0; f < 6; f++)
    {
      struct body less = { 0 };
      for (unsigned g = 0; g < 6; g++)
        {
          struct k_vec v[4];
          for (int i = 0; i < 4; i++)
            {
              v[i] = k_vec(b.at[g][0][i], b.at[g][1][i], b.at[g][2][i]);
            }
          if (g != f)
            {
              add(&less, 4, v);
            }
        }
      int shells = shells_close(less.faces, less.count, &open);
      // The edge that is named is one of the missing face's.
      int ends = 0;
      for (int i = 0; i < 4; i++)
        {
          struct k_vec v = k_vec(b.at[f][0][i], b.at[f][1][i], b.at[f][2][i]);
          ends += k_is_equal(v, open.a) + k_is_equal(v, open.b);
        }
      PASS(shells == 0 && open.faces == 1 && ends == 2
           && open.face < less.count, "a box without face %u is open there",
           f);
    }
  struct k_vec again[4];
  for (int i = 0; i < 4; i++)
    {
      again[i] = k_vec(b.at[0][0][i], b.at[0][1][i], b.at[0][2][i]);
    }
  add(&b, 4, again);
  PASS(shells_close(b.faces, b.count, &open) == 0 && open.faces == 3,
       "an edge in three faces is not closed");

  // The projective plane, of 6 points and 10 triangles: every edge is in two
  // faces, but it has one side only.
  static const int projective[10][3] = {
    { 0, 1, 2 }, { 0, 2, 3 }, { 0, 3, 4 }, { 0, 4, 5 }, { 0, 5, 1 },
    { 1, 2, 4 }, { 2, 3, 5 }, { 3, 4, 1 }, { 4, 5, 2 }, { 5, 1, 3 }
  };
  static const struct k_vec six[6] = {
    { 0, 0, 1 }, { 1, 0, 0 }, { 0.3, 0.9, 0 }, { -0.8, 0.6, 0 },
    { -0.8, -0.6, 0 }, { 0.3, -0.9, 0.5 }
  };
  struct body p = { 0 };
  for (int f = 0; f < 10; f++)
    {
      struct k_vec v[3];
      for (int i = 0; i < 3; i++)
        {
          v[i] = six[projective[f][i]];
        }
      add(&p, 3, v);
    }
  PASS(shells_close(p.faces, p.count, &open) == 0 && open.faces == 2,
       "a surface with one side only is refused");
}

/** A box whose top has a square hole that a well goes down from: the top is
    one polygon with a bridge, which does not count as an edge. */
static void
bridge(void)
{
  struct body b = { 0 };
  struct shell_edge open;
  double o = 3, i = 1;
  // 10 corners are more than a face of `struct body` holds.
  static double x[10], y[10], z[10];
  const struct k_vec top[10] = {
    { -o, -o, o }, { o, -o, o }, { o, o, o }, { -o, o, o }, { -o, -o, o },
    { -i, -i, o }, { -i, i, o }, { i, i, o }, { i, -i, o }, { -i, -i, o }
  };

  add_box(&b, cube_corner(-o), cube_corner(o), 0);
  static const double *arrays[3] = { x, y, z };
  for (int k = 0; k < 10; k++)
    {
      x[k] = top[k].x;
      y[k] = top[k].y;
      z[k] = top[k].z;
    }
  b.faces[1].n = 10;            // the face at z = 3
  b.faces[1].vertex = arrays;
  add_box(&b, k_vec(-i, -i, 0), k_vec(i, i, o), 0);
  b.faces[7] = b.faces[11];     // the well has no lid
  b.count = 11;
  int shells = shells_close(b.faces, b.count, &open);
  PASS(shells == 1, "a box with a well in it is one shell: %d", shells);
  unsigned wrong = 0;
  for (unsigned f = 0; f < 11; f++)
    {
      // The well's faces were outward of the well: now they face into it.
      wrong += b.faces[f].is_turned != (f >= 6);
    }
  PASS(wrong == 0, "its outside is outward and the well's walls face into"
       " it: %u", wrong);
}

int
main(void)
{
  NSAutoreleasePool *pool = [[NSAutoreleasePool alloc] init];

  boxes();
  touching();
  many();
  faults();
  bridge();
  [pool release];
  return test_done();
}
