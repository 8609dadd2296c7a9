// excerpt.h - the line of a text that a message is about, and a caret.

#ifndef EXCERPT_H
#define EXCERPT_H

#import <Foundation/Foundation.h>

/** The line and, below it, a caret under the character in that column (both
    from 1), each with a newline (autoreleased):

  12 |   material glas
     |            ^

    Tabs and wide characters keep the caret where it belongs; of a very long
    line only what is round the column is shown. */
NSString *excerpt(NSData *text, int line, int column);

#endif
