// shell_orient.h - which side of each shell is outside: for shells_close.

#ifndef SHELL_ORIENT_H
#define SHELL_ORIENT_H

#include "shell.h"

/** The faces of each shell are turned alike: turns every shell outwards, or
    inwards if it is in an odd number of others. 0 when there is no memory. */
int shells_orient(struct shell_face *faces, unsigned count, unsigned shells);

#endif
