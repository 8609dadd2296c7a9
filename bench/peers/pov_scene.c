/* pov_scene.c - writes a scene for POV-Ray.

   usage: pov_scene SCENE.nff [FOCUS FSTOP EXPOSURE] > SCENE.pov

   Polygons become meshes, one for each solid or run of one material: what
   POV-Ray traces fastest. Clear objects cast no shadow. */

#include "nff.h"

#include <stdio.h>
#include <stdlib.h>

static void
write_camera (const struct nff *s, int argc, char **argv)
{
  double right[3], up[3], ahead[3], wide, high;

  /* Our outermost pixels are on the window's edge, POV-Ray's half a pixel
     inside it. */
  nff_window (s, right, up, ahead);
  wide = 2.0 * s->columns / (s->columns - 1);
  high = 2.0 * s->rows / (s->rows - 1);
  printf ("camera { perspective location <%.9g,%.9g,%.9g>\n"
          "  direction <%.12g,%.12g,%.12g> right <%.12g,%.12g,%.12g>\n"
          "  up <%.12g,%.12g,%.12g>\n", s->from[0], s->from[1], s->from[2],
          ahead[0], ahead[1], ahead[2], right[0] * wide, right[1] * wide,
          right[2] * wide, up[0] * high, up[1] * high, up[2] * high);
  if (argc == 5)
    {
      double focus = atof (argv[2]);

      printf ("  aperture %g blur_samples %d confidence 0.99 variance 0\n"
              "  focal_point <%.12g,%.12g,%.12g>\n", 4 / atof (argv[3]),
              atoi (argv[4]), s->from[0] + focus * ahead[0],
              s->from[1] + focus * ahead[1], s->from[2] + focus * ahead[2]);
    }
  puts ("}");
}

/* A mirror's own colour is dimmed by its diffuse share once more, and what
   a clear one reflects comes on top of that. */
static void
write_material (const struct nff_material *m, size_t i)
{
  double d[3];
  int k;

  for (k = 0; k < 3; k++)
    {
      d[k] = m->kd * m->color[k];
      if (m->ks > 0)
        d[k] *= d[k];
    }
  printf ("#declare T%zu = texture { pigment { rgb <%.9g,%.9g,%.9g> "
          "transmit %.9g }\n  finish { ambient 0 diffuse 1", i,
          d[0], d[1], d[2], m->clear);
  if (m->ks > 0)
    printf (" phong %.9g phong_size %.9g",
            m->ks * (m->color[0] + m->color[1] + m->color[2]) / 3, m->shine);
  if (m->clear > 0)
    printf (" conserve_energy");
  if (m->ks > 0 || m->clear > 0)
    {
      double r = m->ks * m->color[0], g = m->ks * m->color[1];
      double b = m->ks * m->color[2], c = m->clear;

      if (c > 0)
        printf (" reflection { rgb <%.9g,%.9g,%.9g> rgb <%.9g,%.9g,%.9g> "
                "fresnel }", r * (1 - c), g * (1 - c), b * (1 - c),
                r * (1 - c) + c, g * (1 - c) + c, b * (1 - c) + c);
      else
        printf (" reflection { rgb <%.9g,%.9g,%.9g> }", r, g, b);
    }
  printf (" } }\n#declare I%zu = interior { ior %.9g }\n", i,
          m->ior > 0 ? m->ior : 1);
}

/* What follows the shape. Opaque things have an inside as well, which
   nothing ever sees. */
static void
write_look (const struct nff *s, uint32_t material)
{
  printf (" texture { T%u }", material);
  if (s->material[material].clear > 0)
    printf (" interior { I%u } no_shadow", material);
  puts (" }");
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
      printf ("triangle {");
      for (k = 0; k < 3; k++)
        printf ("%s<%.9g,%.9g,%.9g>", k ? "," : "", c[3 * triangle[i][k]],
                c[3 * triangle[i][k] + 1], c[3 * triangle[i][k] + 2]);
      puts ("}");
    }
  free (triangle);
}

int
main (int argc, char **argv)
{
  struct nff s;
  size_t i;

  if (argc != 2 && argc != 5)
    return 2;
  nff_read (&s, argv[1]);
  nff_solids (&s);
  puts ("#version 3.7;\nglobal_settings { assumed_gamma 1 "
        "max_trace_level 6 adc_bailout 0 }");
  printf ("background { rgb <%.9g,%.9g,%.9g> }\n", s.background[0],
          s.background[1], s.background[2]);
  write_camera (&s, argc, argv);
  for (i = 0; i < s.lights; i++)
    printf ("light_source { <%.9g,%.9g,%.9g> rgb <%.9g,%.9g,%.9g> }\n",
            s.light[i].place[0], s.light[i].place[1], s.light[i].place[2],
            s.light[i].color[0], s.light[i].color[1], s.light[i].color[2]);
  for (i = 0; i < s.materials; i++)
    write_material (&s.material[i], i);
  for (i = 0; i < s.spheres; i++)
    {
      const float *c = s.sphere + 4 * i;

      printf ("sphere { <%.9g,%.9g,%.9g>,%.9g", c[0], c[1], c[2], c[3]);
      write_look (&s, s.sphereMaterial[i]);
    }
  for (i = 0; i < s.polygons;)
    {
      const struct nff_polygon first = s.polygon[i];

      puts ("mesh {");
      do
        write_triangles (&s, &s.polygon[i++]);
      while (i < s.polygons && s.polygon[i].material == first.material
             && s.polygon[i].solid == first.solid);
      write_look (&s, first.material);
    }
  return fclose (stdout) == 0 ? 0 : 4;
}
