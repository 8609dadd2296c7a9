/* nff.c - see nff.h. */

#include "nff.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static void
fail (const char *path, const char *what)
{
  fprintf (stderr, "%s: %s\n", path, what);
  exit (3);
}

/* The whole file, with a 0 at the end. */
static char *
read_text (const char *path)
{
  FILE *in = fopen (path, "rb");
  long size = -1;
  char *text = NULL;

  if (in != NULL && fseek (in, 0, SEEK_END) == 0)
    size = ftell (in);
  if (size >= 0)
    text = malloc (size + 1);
  if (text == NULL)
    fail (path, "cannot be read");
  rewind (in);
  if (fread (text, 1, size, in) != (size_t) size)
    fail (path, "cannot be read");
  text[size] = 0;
  fclose (in);
  return text;
}

static const char *
skip (const char *p)
{
  while (*p == ' ' || *p == '\n' || *p == '\t' || *p == '\r')
    p++;
  return p;
}

/* A decimal number; to within a rounding of a float, without strtof. */
static const char *
number (const char *p, float *value)
{
  static const double power[] = {
    1e0, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8, 1e9, 1e10, 1e11, 1e12,
    1e13, 1e14, 1e15, 1e16, 1e17, 1e18, 1e19, 1e20, 1e21, 1e22
  };
  uint64_t digits = 0;
  int places = 0, seen = 0, negative, point = 0;
  const char *start = p = skip (p);

  negative = *p == '-';
  p += *p == '-' || *p == '+';
  for (;; p++)
    {
      if (*p >= '0' && *p <= '9')
        {
          if (digits < UINT64_MAX / 10 - 1)
            digits = 10 * digits + (*p - '0'), places -= point;
          else
            places += !point;
          seen = 1;
        }
      else if (*p == '.' && !point)
        point = 1;
      else
        break;
    }
  if (seen && (*p == 'e' || *p == 'E'))
    {
      char *end;

      places += (int) strtol (p + 1, &end, 10);
      p = end;
    }
  if (!seen || places < -22 || places > 22)
    {
      char *end;

      *value = strtof (start, &end);
      return end == start ? NULL : end;
    }
  double v = places < 0 ? digits / power[-places] : digits * power[places];
  *value = (float) (negative ? -v : v);
  return p;
}

static const char *
numbers (const char *p, float *value, int count)
{
  while (p != NULL && count-- > 0)
    p = number (p, value++);
  return p;
}

/* The array with room for count more of size bytes each. */
static void *
room (void *array, size_t *has, size_t need, size_t size)
{
  if (need <= *has)
    return array;
  *has = need > 2 * *has ? need + 64 : 2 * *has;
  array = realloc (array, *has * size);
  if (array == NULL)
    fail ("scene", "no memory");
  return array;
}

static const char *
read_view (struct nff *s, const char *p)
{
  static const char *const word[] = {
    "from", "at", "up", "angle", "hither", "resolution"
  };
  float value[3], hither;
  float *to[] = { s->from, s->at, s->up, &s->angle, &hither, value };
  static const int count[] = { 3, 3, 3, 1, 1, 2 };
  int i;

  for (i = 0; i < 6 && p != NULL; i++)
    {
      p = skip (p);
      if (strncmp (p, word[i], strlen (word[i])) != 0)
        return NULL;
      p = numbers (p + strlen (word[i]), to[i], count[i]);
    }
  s->columns = value[0];
  s->rows = value[1];
  return p;
}

static const char *
read_light (struct nff *s, const char *p)
{
  s->light = room (s->light, &s->lightRoom, s->lights + 1, sizeof *s->light);
  struct nff_light *l = &s->light[s->lights++];

  p = numbers (p, l->place, 3);
  l->color[0] = -1;
  if (p != NULL && strchr ("0123456789.-", *skip (p)) != NULL && *skip (p))
    p = numbers (p, l->color, 3);
  return p;
}

static const char *
read_polygon (struct nff *s, const char *p, int patch)
{
  float count, normal[3];
  uint32_t i;

  p = number (p, &count);
  if (p == NULL || count < 3)
    return NULL;
  s->polygon = room (s->polygon, &s->polygonRoom, s->polygons + 1,
                     sizeof *s->polygon);
  s->corner = room (s->corner, &s->cornerRoom, s->corners + (size_t) count,
                    3 * sizeof *s->corner);
  s->polygon[s->polygons++] = (struct nff_polygon) {
    .first = s->corners, .count = count, .material = s->materials - 1
  };
  for (i = 0; i < count && p != NULL; i++)
    {
      p = numbers (p, s->corner + 3 * s->corners++, 3);
      if (patch)
        p = numbers (p, normal, 3);
    }
  return p;
}

static const char *
read_sphere (struct nff *s, const char *p)
{
  s->sphere = room (s->sphere, &s->sphereRoom, s->spheres + 1,
                    4 * sizeof *s->sphere);
  s->sphereMaterial = room (s->sphereMaterial, &s->sphereMaterialRoom,
                            s->spheres + 1, sizeof *s->sphereMaterial);
  s->sphereMaterial[s->spheres] = s->materials - 1;
  return numbers (p, s->sphere + 4 * s->spheres++, 4);
}

static const char *
read_entity (struct nff *s, const char *p)
{
  switch (*p++)
    {
    case 'b':
      return numbers (p, s->background, 3);
    case 'v':
      return read_view (s, p);
    case 'l':
      return read_light (s, p);
    case 'f':
      s->material = room (s->material, &s->materialRoom, s->materials + 1,
                          sizeof *s->material);
      return numbers (p, s->material[s->materials++].color, 8);
    case 's':
      return s->materials ? read_sphere (s, p) : NULL;
    case 'p':
      return s->materials ? read_polygon (s, p + (*p == 'p'), *p == 'p')
                          : NULL;
    case '#':
      return p + strcspn (p, "\n");
    default:
      return NULL;
    }
}

void
nff_read (struct nff *s, const char *path)
{
  char *text = read_text (path);
  const char *p;
  size_t i;

  memset (s, 0, sizeof *s);
  for (p = skip (text); *p; p = skip (p))
    {
      p = read_entity (s, p);
      if (p == NULL)
        fail (path, "has something in it that is not known");
    }
  free (text);
  for (i = 0; i < s->lights; i++)
    if (s->light[i].color[0] < 0)
      s->light[i].color[0] = s->light[i].color[1] = s->light[i].color[2]
        = 1 / sqrt (s->lights);
}

void
nff_free_shapes (struct nff *s)
{
  free (s->sphere);
  free (s->sphereMaterial);
  free (s->polygon);
  free (s->corner);
  s->sphere = s->corner = NULL;
  s->sphereMaterial = NULL;
  s->polygon = NULL;
}

static void
cross (const double a[3], const double b[3], double to[3])
{
  to[0] = a[1] * b[2] - a[2] * b[1];
  to[1] = a[2] * b[0] - a[0] * b[2];
  to[2] = a[0] * b[1] - a[1] * b[0];
}

static void
resize (double v[3], double length)
{
  double f = length / sqrt (v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);

  v[0] *= f;
  v[1] *= f;
  v[2] *= f;
}

void
nff_window (const struct nff *s, double right[3], double up[3],
            double ahead[3])
{
  double u[3] = { s->up[0], s->up[1], s->up[2] };
  double half = tan (s->angle * acos (-1) / 360);
  int k;

  for (k = 0; k < 3; k++)
    ahead[k] = (double) s->at[k] - s->from[k];
  resize (ahead, 1);
  cross (ahead, u, right);
  cross (right, ahead, up);
  resize (up, half);
  resize (right, half * (s->columns - 1) / (s->rows - 1));
}
