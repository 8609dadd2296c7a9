// block_state.h - what is known of the block that is being read, and the part
// of its reader that sees to the faults. For mdl_t+attributes.m, which reads,
// and mdl_t+refuse.m, which refuses.

#ifndef BLOCK_STATE_H
#define BLOCK_STATE_H

#import "mdl_t.h"

// More stray words than this are not one attribute with its values.
#define MOST_STRAY 4

/** What the attributes of one block were. */
struct block_state
{
  struct record *record;
  uint64_t given;       // bits of the table's attributes
  uint64_t excused;     // those that an unknown one was meant to be
  unsigned stray[MOST_STRAY + 1];       // how many more groups of so many
                        // words have no attribute: each may be a missing one
  const struct attribute *last; // the attribute just given; NULL after a fault
  const char *told;     // a brace at which there was a fault
  unsigned inner;       // braces opened by mistake
  BOOL is_closed;       // by a brace that came too early
};

static inline uint64_t
attribute_bit(const struct attribute *a, const struct attribute *table)
{
  return (uint64_t)1 << (a - table);
}

@interface mdl_t (refuse)

/** Goes on after an attribute whose values, from `start`, are wrong. */
- (void) resumeAfter: (const struct attribute *)a from: (struct cursor)start
               state: (struct block_state *)state;

/** An attribute that was given before. */
- (void) refuseSecond: (const struct attribute *)a word: (struct token)t
                state: (struct block_state *)state;

/** Something else than an attribute or a brace. */
- (void) refuse: (struct token)t state: (struct block_state *)state;

/** An opening brace, which may stand for an attribute. */
- (void) openInside: (struct token)brace state: (struct block_state *)state;

/** A closing brace. NO if the block goes on: that is a fault. */
- (BOOL) close: (struct token)brace state: (struct block_state *)state;

/** Something that cannot be in a block, where its closing brace should be. */
- (void) missBrace: (struct token)t state: (struct block_state *)state;

/** Notes a fault for the attributes that are missing, unless that follows from
    another one. */
- (void) requireAttributes: (struct block_state *)state
                   keyword: (struct token)keyword;

@end

#endif
