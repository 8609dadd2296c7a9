// open_solids_t.h - what is said of solids that are not closed. A face that
// names the wrong solid opens two of them: that is one fault, told at the
// name. For solid_t.

#import <Foundation/Foundation.h>
#include "shell.h"

@class diag_t;

@interface open_solids_t : NSObject
{
  NSMutableArray *solids;       // of open_solid_t, as they were added
}

/** Adds a solid that is not closed: the polygons that name it (retained), and
    an open edge. */
- (void) add: (NSArray *)faces edge: (struct shell_edge)edge;

/** Notes the faults. */
- (void) tell: (diag_t *)diag;

@end
