// sha256.m

#import "sha256.h"
#include <nettle/sha2.h>

NSString *
sha256_of(NSData *data)
{
  struct sha256_ctx context;
  uint8_t digest[SHA256_DIGEST_SIZE];
  NSMutableString *text = [NSMutableString string];

  sha256_init(&context);
  sha256_update(&context, [data length], [data bytes]);
  sha256_digest(&context, sizeof digest, digest);
  for (unsigned i = 0; i < sizeof digest; i++)
    {
      [text appendFormat: @"%02x", digest[i]];
    }
  return text;
}
