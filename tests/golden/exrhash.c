// exrhash.c - the SHA-256 of the pixels of an OpenEXR picture.
// usage: exrhash PICTURE
//
// However the file is packed: of "COLUMNS ROWS", and for each channel, in the
// order of their names, of its name and of the bits of its values row by row
// from the top, 32 each, the least significant byte first. Exit status: 0, or 2
// for a file that cannot be read.

#include "exrread.h"
#include <nettle/sha2.h>

static void
hash_text(struct sha256_ctx *hash, const char *text)
{
  sha256_update(hash, strlen(text) + 1, (const uint8_t *)text);
}

int
main(int count, char **words)
{
  struct sha256_ctx hash;
  uint8_t digest[SHA256_DIGEST_SIZE];
  char size[64];

  if (count != 2)
    {
      fprintf(stderr, "usage: exrhash PICTURE\n");
      return 2;
    }
  struct picture picture = read_picture(words[1]);
  snprintf(size, sizeof size, "%d %d", picture.width, picture.height);
  sha256_init(&hash);
  hash_text(&hash, size);
  for (int c = 0; c < picture.count; c++)
    {
      const struct channel *channel = &picture.channels[c];
      hash_text(&hash, channel->name);
      for (size_t i = 0; i < (size_t)picture.width * picture.height; i++)
        {
          uint32_t bits = channel->values[i];
          const uint8_t bytes[4] = { bits, bits >> 8, bits >> 16, bits >> 24 };
          sha256_update(&hash, sizeof bytes, bytes);
        }
    }
  sha256_digest(&hash, sizeof digest, digest);
  for (unsigned i = 0; i < sizeof digest; i++)
    {
      printf("%02x", digest[i]);
    }
  printf("\n");
  release(&picture);
  return 0;
}
