// machine.h - what the program finds round itself.

#import <Foundation/Foundation.h>

/** How many cores this process may run on. */
unsigned machine_cores(void);

/** Bytes of memory that the program may have: all of the machine's, or less if
    there is a limit: ulimit -v, or that of a container (cgroups). */
double machine_memory(void);

/** The folders of the program's own models, installed or in the source tree
    (autoreleased). */
NSArray *machine_models(void);
