// errors.h - errors as values: made where something fails, told by main. The
// code of ours is the status the program ends with.

#import <Foundation/Foundation.h>

enum status
{
  STATUS_DONE = 0,
  STATUS_USAGE = 2,     // the arguments
  STATUS_SCENE = 3,     // the model file
  STATUS_FILE = 4       // reading or writing it, or memory
};

/** An error (autoreleased) that says this. */
NSError *error_saying(enum status status, NSString *format, ...)
  __attribute__((format(NSString, 2, 3)));

/** What to tell the user of an error: its own text, or the operating
    system's for one of the NSPOSIXErrorDomain. */
NSString *error_text(NSError *error);
