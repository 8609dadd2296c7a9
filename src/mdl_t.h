// mdl_t.h - reads model files in the tracer's own format (docs/format.md).
// mdl_t.m reads the sequence of blocks and directives, mdl_t+block.m a block
// up to its brace, mdl_t+attributes.m what is in it, mdl_t+include.m finds
// includes, mdl_t+refuse.m tells the faults in a block, and mdl_t+resume.m
// finds the place where to go on after one.
//
// One fault is told once. What it brings about is found by looking ahead: a
// word that is missing here and too much there has changed its place.

#import "reader_t.h"

@interface mdl_t : reader_t
{
  NSArray *include_path;
  NSArray *path_folders;        // the same as real folders (fence.h)
  NSArray *folders;             // and the scene's own
  NSArray *keywords;            // when they have been asked for
  unsigned include_count;       // that were tried
  BOOL is_too_much;             // more is to be included than may be
  struct kind kind;             // of the block that is being read; its table
                                // is NULL outside of blocks
  struct token name;            // and its name; of length 0 if it has none
  unsigned open_braces;         // opened by mistake: so many closing ones
                                // are no fault
  const char *next_brace;       // the last answer of isClosed
  const char *told;             // a fault here has been told already
}

/** The folders of `path` are those where includes are looked for after the
    folder of the including file. */
- (id) init: (text_t *)text into: (store_t *)store diag: (diag_t *)diag
includePath: (NSArray *)path;

/** Reads a model from its first file. */
- (void) read: (source_t *)source;

/** Goes on reading in another file, which is included at a place of the text.
    NO, with a fault, if it is no text. NFF is read at once. */
- (BOOL) enter: (source_t *)source from: (unsigned)order;

/** Goes on after something that is no keyword. What that and the words behind
    it were meant to be must not be missed later. */
- (void) resumeAfter: (struct token)t;

/** Whether a word may be the path of an include. */
- (BOOL) isPath: (struct token)t;

@end

@interface mdl_t (block)

/** Reads a block, from behind its keyword. */
- (void) readBlock: (unsigned)kind_number keyword: (struct token)keyword;

/** Notes that a block cannot be used. */
- (void) spoil: (struct record *)record;

@end

@interface mdl_t (attributes)

/** Reads a block's attributes and past its closing brace. */
- (void) readAttributesOf: (struct record *)record
                  keyword: (struct token)keyword;

@end

@interface mdl_t (include)

/** Reads an include, from behind that word. */
- (void) readInclude;

/** The same in a block, where it is a fault. */
- (void) refuseInclude;

@end

@interface mdl_t (resume)

/** After a fault outside of blocks: goes on to a directive or to a block of a
    known kind, or behind the next block in braces. Returns the name of that
    block, if it has one. */
- (struct token) resumeOutside;

/** After a fault in a block: goes on to the next attribute, directive or
    closing brace, or to where a block of a known kind starts. Returns how
    many words it went past, not counting what is in braces. */
- (unsigned) resumeInside;

/** Whether `word name {` starts here. */
- (BOOL) looksLikeBlock: (struct cursor)cursor;

/** The same, and the word is a block word. */
- (BOOL) isBlockAt: (struct cursor)cursor;

/** The same, when the word is also an attribute of the block that is being
    read: what follows the brace tells. */
- (BOOL) isBlockNotAttributeAt: (struct cursor)cursor;

/** Whether an attribute of the block that is being read starts here. */
- (BOOL) isAttributeAt: (struct cursor)cursor;

/** Whether a brace is closed before one is opened. */
- (BOOL) isClosed;

/** Whether something that belongs in the block follows its closing brace.
    `is_told`: what was expected in place of the brace is missing. */
- (BOOL) isTooEarly: (BOOL)is_told;

/** Whether something follows that does not belong in the block, so that it
    ends here without a brace. */
- (BOOL) isEnd;

/** Whether a keyword or directive has changed places with the closing brace
    before it. The brace, which is at the cursor, is told with it. */
- (BOOL) isBeforeBrace: (struct token)t;

/** How many words there are before the next attribute, brace, directive or
    block; at most sixteen. */
- (unsigned) wordsAt: (struct cursor)cursor;

/** Whether the token is `include` or `background`. */
- (BOOL) isDirective: (struct token)t;

@end
