/* tachyon_scene.c - writes a scene for Tachyon.

   usage: tachyon_scene SCENE.nff > SCENE.dat

   Tachyon has no refraction: what is clear lets rays through as they are.
   It knows one share of mirrored light for all colours, here their mean,
   and always adds the whole surface colour to what comes through. */

#include "nff.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

/* Its pixels count from 1 on, from the window's left and bottom edge, and
   its camera is left-handed: the window's left is on our right. */
static void
write_camera (const struct nff *s)
{
  double right[3], up[3], ahead[3];
  double high = tan (s->angle * acos (-1) / 360);
  double wide = high * (s->columns - 1) / (s->rows - 1);
  double step = 2 * high / (s->rows - 1);

  nff_window (s, right, up, ahead);
  printf ("CAMERA\n  ZOOM 1\n  ASPECTRATIO 1\n  ANTIALIASING 0\n"
          "  RAYDEPTH 6\n  CENTER %.9g %.9g %.9g\n  VIEWDIR %.9g %.9g %.9g\n"
          "  UPDIR %.9g %.9g %.9g\n  FRUSTUM %.9g %.9g %.9g %.9g\n"
          "END_CAMERA\n", s->from[0], s->from[1], s->from[2],
          ahead[0], ahead[1], ahead[2], up[0], up[1], up[2],
          wide + step, wide + step - s->columns * step,
          -high - step, -high - step + s->rows * step);
}

static void
write_material (const struct nff_material *m, size_t i)
{
  double d[3], ks = m->ks * (m->color[0] + m->color[1] + m->color[2]) / 3;
  int k;

  for (k = 0; k < 3; k++)
    {
      d[k] = m->kd * m->color[k];
      if (m->ks > 0)
        d[k] *= d[k];
      d[k] *= 1 - m->clear;
    }
  printf ("TEXDEF m%zu AMBIENT 0 DIFFUSE 1 SPECULAR %.9g OPACITY %.9g "
          "PHONG PLASTIC %.9g PHONG_SIZE %.9g COLOR %.9g %.9g %.9g "
          "TEXFUNC 0\n", i, ks, 1 - m->clear, ks, m->shine, d[0], d[1],
          d[2]);
}

static void
write_triangles (const struct nff *s, const struct nff_polygon *p)
{
  const float *c = s->corner + 3 * p->first;
  uint32_t (*triangle)[3] = malloc (p->count * sizeof *triangle), i;
  int k;

  if (triangle == NULL)
    exit (4);
  nff_clip (c, p->count, triangle);
  for (i = 0; i < p->count - 2; i++)
    {
      printf ("TRI");
      for (k = 0; k < 3; k++)
        printf (" V%d %.9g %.9g %.9g", k, c[3 * triangle[i][k]],
                c[3 * triangle[i][k] + 1], c[3 * triangle[i][k] + 2]);
      printf (" m%u\n", p->material);
    }
  free (triangle);
}

int
main (int argc, char **argv)
{
  struct nff s;
  size_t i;

  if (argc != 2)
    return 2;
  nff_read (&s, argv[1]);
  printf ("BEGIN_SCENE\nRESOLUTION %d %d\n", s.columns, s.rows);
  write_camera (&s);
  printf ("BACKGROUND %.9g %.9g %.9g\n", s.background[0], s.background[1],
          s.background[2]);
  for (i = 0; i < s.lights; i++)
    printf ("LIGHT CENTER %.9g %.9g %.9g RAD 1e-6 COLOR %.9g %.9g %.9g\n",
            s.light[i].place[0], s.light[i].place[1], s.light[i].place[2],
            s.light[i].color[0], s.light[i].color[1], s.light[i].color[2]);
  for (i = 0; i < s.materials; i++)
    write_material (&s.material[i], i);
  for (i = 0; i < s.spheres; i++)
    {
      const float *c = s.sphere + 4 * i;

      printf ("SPHERE CENTER %.9g %.9g %.9g RAD %.9g m%u\n", c[0], c[1],
              c[2], c[3], s.sphereMaterial[i]);
    }
  for (i = 0; i < s.polygons; i++)
    write_triangles (&s, &s.polygon[i]);
  puts ("END_SCENE");
  return fclose (stdout) == 0 ? 0 : 4;
}
