// parser_t.h - a model file (.mdl or any other suffix; .nff is Haines' Neutral
// File Format) made into a model_t.

#import <Foundation/Foundation.h>
#import "model_t.h"

@class compiler_t, diag_t;

/** How a model is to be read. */
struct parse_options
{
  enum polygon_test polygon_test;
  unsigned max_depth;
  compiler_t *compiler; // gets what the model need not keep; nil: it keeps all
};

@interface parser_t : NSObject

/** Reads, checks and completes the model. nil if there were faults (diag has
    them) or if the file itself could not be read (*error, NSPOSIXErrorDomain;
    diag is then empty). `includePath`: folders where include looks after the
    folder of the including file. `text`, if not NULL, receives the bytes of
    all files in the order they were read, for the picture's SHA-256
    (autoreleased). `canonical`, if not NULL, receives the model in canonical
    form (autoreleased). */
+ (model_t *) modelFromFile: (NSString *)path
                includePath: (NSArray *)includePath
                    options: (struct parse_options)options
                       diag: (diag_t *)diag
                       text: (NSData **)text
                  canonical: (NSString **)canonical
                      error: (NSError **)error;

@end
