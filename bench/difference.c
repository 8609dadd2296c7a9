/* difference.c - how far apart two 8-bit PPM pictures are.

   usage: difference A.ppm B.ppm [mirrored]

   Prints the root of the mean square of all channels' differences, and the
   share of pixels in which a channel is more than 0.1 off; 1 is white. With
   a third argument B has left and right swapped. */

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

struct picture
{
  int columns, rows;
  unsigned char *byte;
};

/* The next number of the header; comments go to the end of their line. */
static int
header (FILE *in)
{
  int c, value = 0;

  while ((c = getc (in)) == '#' || c == ' ' || c == '\n')
    if (c == '#')
      while ((c = getc (in)) != '\n' && c != EOF)
        continue;
  for (; c >= '0' && c <= '9'; c = getc (in))
    value = 10 * value + c - '0';
  return value;
}

static struct picture
read_picture (const char *path)
{
  FILE *in = fopen (path, "rb");
  struct picture p = { 0 };
  size_t size;

  if (in != NULL && getc (in) == 'P' && getc (in) == '6')
    {
      p.columns = header (in);
      p.rows = header (in);
      if (header (in) == 255)
        {
          size = (size_t) 3 * p.columns * p.rows;
          p.byte = malloc (size + 1);
          if (p.byte != NULL && fread (p.byte, 1, size, in) == size)
            {
              fclose (in);
              return p;
            }
        }
    }
  fprintf (stderr, "difference: %s is not a whole 8-bit PPM\n", path);
  exit (4);
}

int
main (int argc, char **argv)
{
  if (argc != 3 && argc != 4)
    return 2;
  struct picture a = read_picture (argv[1]), b = read_picture (argv[2]);
  size_t pixels = (size_t) a.columns * a.rows, off = 0, i;
  double sum = 0;
  int k;

  if (a.columns != b.columns || a.rows != b.rows)
    {
      fputs ("difference: the pictures have different sizes\n", stderr);
      return 1;
    }
  for (i = 0; i < pixels; i++)
    {
      size_t x = i % a.columns;
      size_t j = argc == 4 ? i - x + a.columns - 1 - x : i;
      double worst = 0;

      for (k = 0; k < 3; k++)
        {
          double d = abs (a.byte[3 * i + k] - b.byte[3 * j + k]) / 255.0;

          sum += d * d;
          worst = fmax (worst, d);
        }
      off += worst > 0.1;
    }
  printf ("%.4f %.4f\n", sqrt (sum / (3 * pixels)), (double) off / pixels);
  return 0;
}
