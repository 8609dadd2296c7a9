// probe - prints what arithmetic_fault says of the way this program was built,
// "fine" if nothing; flags.sh builds it in several.

#include "../../src/arithmetic.c"
#include <stdio.h>

int
main(void)
{
  const char *fault = arithmetic_fault();

  puts(fault ? fault : "fine");
  return 0;
}
