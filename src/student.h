// student.h - how many standard errors wide an interval has to be that holds
// the true mean at a stated rate, when the error is itself taken from few
// numbers ("Student", "The probable error of a mean", 1908).

#ifndef STUDENT_H
#define STUDENT_H

#include <math.h>

/** The share of such intervals of t standard errors to each side, from an even
    number of degrees of freedom, that hold the mean. The sum is finite
    (Abramowitz and Stegun, 26.7.4). */
static inline double
student_share(double t, unsigned freedom)
{
  double cos2 = freedom / (freedom + t * t), term = 1, sum = 1;

  for (unsigned k = 2; k < freedom; k += 2)
    {
      term *= cos2 * (k - 1) / k;
      sum += term;
    }
  return t / sqrt(freedom + t * t) * sum;
}

/** The t of a share below 1, by halving: 0 to 10^6. */
static inline double
student_quantile(double share, unsigned freedom)
{
  double low = 0, high = 1e6;

  for (int i = 0; i < 100; i++)
    {
      double t = (low + high) / 2;
      if (student_share(t, freedom) < share)
        {
          low = t;
        }
      else
        {
          high = t;
        }
    }
  return high;
}

#endif
