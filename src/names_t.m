#import "names_t.h"
#include "grow.h"

@implementation names_t

- (void) dealloc
{
  free(text);
  [super dealloc];
}

- (unsigned) add: (struct token)name
{
  unsigned at = length;

  while (capacity - length <= name.length)
    {
      grow((void **)&text, capacity, &capacity, 1);
    }
  memcpy(text + at, name.at, name.length);
  text[at + name.length] = '\0';
  length += name.length + 1;
  return at;
}

- (NSString *) nameAt: (unsigned)at
{
  return [NSString stringWithUTF8String: text + at];
}

@end
