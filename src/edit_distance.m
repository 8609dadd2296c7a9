#include "edit_distance.h"

// Longer words are not compared.
#define LONGEST 64

static NSUInteger
least(NSUInteger a, NSUInteger b)
{
  return a < b ? a : b;
}

NSUInteger
edit_distance(NSString *first, NSString *second, NSUInteger most)
{
  // The rows of the table for all of a's first i letters: i - 2, i - 1, i.
  NSUInteger rows[3][LONGEST + 1];
  unichar a[LONGEST], b[LONGEST];
  NSString *small[2] = { [first lowercaseString], [second lowercaseString] };
  NSUInteger m = [small[0] length], n = [small[1] length];

  if (m > LONGEST || n > LONGEST || (m > n ? m - n : n - m) > most)
    {
      return NSNotFound;
    }
  [small[0] getCharacters: a];
  [small[1] getCharacters: b];
  for (NSUInteger j = 0; j <= n; j++)
    {
      rows[0][j] = j;
    }
  for (NSUInteger i = 1; i <= m; i++)
    {
      NSUInteger *before = rows[(i + 1) % 3], *last = rows[(i - 1) % 3];
      NSUInteger *row = rows[i % 3];

      row[0] = i;
      for (NSUInteger j = 1; j <= n; j++)
        {
          row[j] = least(last[j - 1] + (a[i - 1] != b[j - 1]),
                         least(last[j], row[j - 1]) + 1);
          if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
            {
              row[j] = least(row[j], before[j - 2] + 1);
            }
        }
    }
  return rows[m % 3][n] <= most ? rows[m % 3][n] : NSNotFound;
}
