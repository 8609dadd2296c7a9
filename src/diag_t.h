// diag_t.h - the faults of a model: collected while it is read, told in the
// order of the text when that is done, each with its place, its line and a
// caret:
//
//   scene.mdl:12:12: error: unknown material 'glas' for sphere 'ball'; did you mean 'glass'?
//     12 |   material glas
//        |            ^
//
// It prints nothing; main does. The caller owns what it makes.

#import <Foundation/Foundation.h>
#import "fault_list_t.h"
#include "place.h"

@interface diag_t : NSObject
{
  NSMutableArray *files;
  fault_list_t *faults;
  fault_list_t *warnings;
}

/** Makes a file known and returns its number. `name` is how messages call
    it, `text` its bytes (they are quoted in messages; retained), `includer`
    the place of the include directive that read it (file -1: none). */
- (int) addFile: (NSString *)name
           text: (NSData *)text
       includer: (struct place)includer;

/** Notes a fault. Two faults at one place are one: the first stays. */
- (void) fault: (struct place)place : (NSString *)format, ...
  __attribute__((format(NSString, 2, 3)));

/** Notes a warning, which does not stop anything. */
- (void) warn: (struct place)place : (NSString *)format, ...
  __attribute__((format(NSString, 2, 3)));

/** Whether a fault at this place of the text will be shown. If not it is
    noted by this, and needs no message: for those who find many. */
- (BOOL) wantsFault: (unsigned long)order;

/** How many faults so far. */
- (NSUInteger) faultCount;

/** How a place is called in messages: "scene.mdl:12:12" (autoreleased). */
- (NSString *) nameOf: (struct place)place;

/** All messages as they are shown, in the order of the text: up to 20
    faults, then how many more. If there are none, likewise the warnings:
    beside a fault they may come of it. */
- (NSString *) report;

/** Gives back the texts of the files: all that there was to tell is told. */
- (void) close;

/** The nearest of `words` to `word`, when it is near enough to be a slip of
    the hand: nil if none is. */
+ (NSString *) nearestTo: (NSString *)word among: (NSArray *)words;

/** The same as "; did you mean 'x'?"; otherwise the empty string. */
+ (NSString *) suggestionFor: (NSString *)word among: (NSArray *)words;

@end
