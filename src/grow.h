// grow.h - arrays, also those that get longer: room for one more item at the
// end. Without memory they raise an exception, which ends the program (main.m).

#ifndef GROW_H
#define GROW_H

#import <Foundation/Foundation.h>

/** Raises NSMallocException: there is no memory for so many items. */
static inline void
raise_no_memory(size_t count)
{
  [NSException raise: NSMallocException format: @"no memory for %zu items",
               count];
}

/** An array of items that are zero, to be freed. Raises NSMallocException
    without memory. */
static inline void *
new_array(size_t count, size_t size)
{
  void *array = calloc(count, size);

  if (array == NULL && count > 0)
    {
      raise_no_memory(count);
    }
  return array;
}

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
          raise_no_memory(wanted);
        }
      *array = larger;
      *capacity = (unsigned)wanted;
    }
}

#endif
