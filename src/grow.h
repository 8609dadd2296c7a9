// grow.h - arrays that get longer: room for one more item at the end.

#ifndef GROW_H
#define GROW_H

#import <Foundation/Foundation.h>

/** Makes room for the item number `count` in an array of items of `size`
    bytes; the capacity doubles. Raises NSMallocException without memory. */
static inline void
grow(void **array, unsigned count, unsigned *capacity, size_t size)
{
  if (count == *capacity)
    {
      size_t wanted = count ? 2 * (size_t)count : 16;
      void *larger = wanted <= UINT_MAX ? realloc(*array, wanted * size) : NULL;

      if (larger == NULL)
        {
          [NSException raise: NSMallocException
                      format: @"no memory for %zu items", wanted];
        }
      *array = larger;
      *capacity = (unsigned)wanted;
    }
}

#endif
