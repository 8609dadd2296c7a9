// errors.h - errors as values: made where something fails, told by main.

#import <Foundation/Foundation.h>

/** An error (autoreleased) that says this. */
NSError *error_saying(NSString *format, ...)
  __attribute__((format(NSString, 1, 2)));

/** What to tell the user of an error: its own text, or the operating
    system's for one of the NSPOSIXErrorDomain. */
NSString *error_text(NSError *error);
