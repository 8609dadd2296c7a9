// sha256.h - the SHA-256 of some bytes, by nettle.

#import <Foundation/Foundation.h>

/** 64 hexadecimal digits (autoreleased). */
NSString *sha256_of(NSData *data);
