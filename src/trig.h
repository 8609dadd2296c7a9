// trig.h - sine, cosine and tangent for setting up cameras and lenses, from
// + - * / alone, so that a field of view has the same bits on every machine.

#ifndef TRIG_H
#define TRIG_H

#define TRIG_PI 3.14159265358979323846

/** sin x for |x| <= pi/4: Taylor's series, good to about one ulp. */
static inline double
trig_sin(double x)
{
  double x2 = x * x, sum = 0;

  for (int n = 20; n >= 2; n -= 2)
    {
      sum = x2 / (n * (n + 1)) * (1 - sum);
    }
  return x * (1 - sum);
}

/** cos x for |x| <= pi/4. */
static inline double
trig_cos(double x)
{
  double x2 = x * x, sum = 0;

  for (int n = 19; n >= 1; n -= 2)
    {
      sum = x2 / (n * (n + 1)) * (1 - sum);
    }
  return 1 - sum;
}

/** The tangent of an angle in degrees, 0 < degrees < 90. */
static inline double
trig_tan_degrees(double degrees)
{
  double x = (degrees > 45 ? 90 - degrees : degrees) * (TRIG_PI / 180);

  return degrees == 45 ? 1
    : degrees > 45 ? trig_cos(x) / trig_sin(x) : trig_sin(x) / trig_cos(x);
}

#endif
