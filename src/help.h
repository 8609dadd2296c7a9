// help.h - the text of --help, made from the table of options.

#import <Foundation/Foundation.h>

/** Lines of at most 79 columns (autoreleased). */
NSString *help_text(void);
