/* emit.c - see emit.h. */

#include "emit.h"

#include <math.h>

/* Tachyon's reader of NFF knows one angle only: a window as high as it is
   far away, from the first row to one past the last. */
static double
angle (int side)
{
  return 2 * atan (0.5 * (side - 1) / side) * 180 / acos (-1);
}

void
emit_view (struct emit *to, const struct emit_view *view)
{
  const struct point *p = &view->from, *q = &view->at, *u = &view->up;

  if (to->format == EMIT_LENS && view->exposure > 0)
    fprintf (to->out, "%g %g %d\n", view->focus, view->fstop,
             view->exposure);
  if (to->format == EMIT_NFF)
    fprintf (to->out, "b %g %g %g\nv\nfrom %g %g %g\nat %g %g %g\n"
             "up %g %g %g\nangle %.9g\nhither 0.01\nresolution %d %d\n",
             view->background.r, view->background.g, view->background.b,
             p->x, p->y, p->z, q->x, q->y, q->z, u->x, u->y, u->z,
             angle (to->side), to->side, to->side);
  if (to->format != EMIT_MDL)
    return;
  fprintf (to->out, "background %g %g %g\ncamera eye\n{\n"
           "  pixeldim %d %d\n  viewpoint %g %g %g\n  lookat %g %g %g\n"
           "  up %g %g %g\n  angle %.9g\n",
           view->background.r, view->background.g, view->background.b,
           to->side, to->side, p->x, p->y, p->z, q->x, q->y, q->z,
           u->x, u->y, u->z, angle (to->side));
  if (view->exposure > 0)
    fprintf (to->out, "  focus %g\n  fstop %g\n  exposure %d\n",
             view->focus, view->fstop, view->exposure);
  fputs ("}\n", to->out);
}

void
emit_lights (struct emit *to, const struct point *place, int count)
{
  double e = 1 / sqrt (count);
  int i;

  for (i = 0; i < count; i++)
    {
      const struct point *p = &place[i];

      if (to->format == EMIT_NFF)
        fprintf (to->out, "l %g %g %g %.6g %.6g %.6g\n", p->x, p->y, p->z,
                 e, e, e);
      if (to->format == EMIT_MDL)
        fprintf (to->out, "light l%ld { location %g %g %g "
                 "emissivity %.6g %.6g %.6g falloff 0 }\n", ++to->lights,
                 p->x, p->y, p->z, e, e, e);
    }
}

void
emit_material (struct emit *to, struct emit_material m)
{
  to->materials++;
  if (to->format == EMIT_NFF)
    fprintf (to->out, "f %g %g %g %g %g %g %g %g\n", m.r, m.g, m.b,
             m.kd, m.ks, m.shine, m.clear, m.ior);
  if (to->format == EMIT_MDL)
    fprintf (to->out, "material m%ld { diffuse %.17g %.17g %.17g "
             "specular %.17g %.17g %.17g shininess %g alpha %g ior %g }\n",
             to->materials, m.kd * m.r, m.kd * m.g, m.kd * m.b, m.ks * m.r,
             m.ks * m.g, m.ks * m.b, m.shine, m.clear, m.ior);
}

void
emit_sphere (struct emit *to, struct point c, double radius)
{
  to->shapes++;
  if (to->format == EMIT_NFF)
    fprintf (to->out, "s %g %g %g %g\n", c.x, c.y, c.z, radius);
  if (to->format == EMIT_MDL)
    fprintf (to->out, "sphere s%ld { material m%ld center %g %g %g "
             "radius %g }\n", to->shapes, to->materials, c.x, c.y, c.z,
             radius);
}

void
emit_polygon (struct emit *to, const struct point *corner, int count)
{
  int i;

  to->shapes++;
  if (to->format == EMIT_NFF)
    {
      fprintf (to->out, "p %d\n", count);
      for (i = 0; i < count; i++)
        fprintf (to->out, "%g %g %g\n", corner[i].x, corner[i].y,
                 corner[i].z);
    }
  if (to->format != EMIT_MDL)
    return;
  fprintf (to->out, "polygon p%ld { material m%ld", to->shapes,
           to->materials);
  if (to->inSolid)
    fprintf (to->out, " solid d%ld", to->solids);
  for (i = 0; i < count; i++)
    fprintf (to->out, " vertex %g %g %g", corner[i].x, corner[i].y,
             corner[i].z);
  fputs (" }\n", to->out);
}

void
emit_solid_begin (struct emit *to)
{
  to->solids++;
  to->inSolid = 1;
}

void
emit_solid_end (struct emit *to)
{
  to->inSolid = 0;
}
