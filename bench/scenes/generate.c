/* generate.c - writes a scene to standard output.

   usage: generate SCENE SIZE SIDE nff|mdl|lens

   SIDE is the number of columns and of rows. lens prints the lens of a scene
   that has one, for those who read NFF, which has none.

   The scenes are the classic ones of Haines, "A Proposal for Standard
   Graphics Environments" (IEEE CG&A 7:11, 1987), made from his descriptions,
   and a few that have what those lack.

     flake N      spheres on spheres: 9^0 + ... + 9^N of them
     tetra N      a tetrahedron of tetrahedra: 4^N triangles
     mountain N   fractal ground of 2 * 4^N triangles, four glass spheres
     gears N      N^3 gears of concave polygons, some transparent
     room N       a closed room with N * N blocks and two spheres
     lattice N    N^3 clear spheres
     lens N       N * N spheres through a lens */

#include "emit.h"

#include <stdlib.h>
#include <string.h>

static const struct
{
  const char *name;
  void (*make) (struct emit *to, int size);
} scenes[] = {
  { "flake", scene_flake },
  { "tetra", scene_tetra },
  { "mountain", scene_mountain },
  { "gears", scene_gears },
  { "room", scene_room },
  { "lattice", scene_lattice },
  { "lens", scene_lens }
};

int
main (int argc, char **argv)
{
  static const char *const formats[] = { "nff", "mdl", "lens" };
  struct emit to = { .out = stdout };
  unsigned format = 0, i;

  for (; argc == 5 && format < 3; format++)
    if (strcmp (argv[4], formats[format]) == 0)
      break;
  for (i = 0; argc == 5 && format < 3 && i < sizeof scenes / sizeof *scenes;
       i++)
    if (strcmp (argv[1], scenes[i].name) == 0)
      {
        to.format = format;
        to.side = atoi (argv[3]);
        scenes[i].make (&to, atoi (argv[2]));
        return fclose (stdout) == 0 ? 0 : 4;
      }
  fputs ("generate: see the top of generate.c\n", stderr);
  return 2;
}
