// pebble.h - a shape that the kernel has to ask.

#ifndef PEBBLE_H
#define PEBBLE_H

#import "compiler_t.h"
#import "sphere_t.h"

/** A sphere that the kernel does not know. */
@interface pebble_t : sphere_t
@end

@implementation pebble_t

- (BOOL) compile: (compiler_t *)compiler
{
  return NO;
}

@end

#endif
