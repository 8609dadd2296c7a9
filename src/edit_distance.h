// edit_distance.h - how many slips of the hand lie between two words.

#ifndef EDIT_DISTANCE_H
#define EDIT_DISTANCE_H

#import <Foundation/Foundation.h>

/** The fewest letters to insert, leave out, replace or swap with their
    neighbour to make one word of the other, capitals apart; NSNotFound if it
    is more than `most`. */
NSUInteger edit_distance(NSString *a, NSString *b, NSUInteger most);

#endif
