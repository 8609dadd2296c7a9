// witness_text.h - the text of --explain: a ray that remembers, and all that
// it spawned, term by term. Numbers have as many digits as read back as the
// same double.

#import "witness_t.h"

/** A text while it is written. */
struct witness_text
{
  NSMutableString *text;
  model_t *model;
  unsigned depth;       // of the ray that is told: its lines are indented
};

/** A ray of that name, whose weight in the pixel is W. What may be lacking
    counts `share` times. */
void witness_tell(struct witness_text *to, witness_t *ray, NSString *name,
                  struct k_vec W, double share);

/** A line: the label, and behind it three numbers or one. */
void witness_tell_vec(struct witness_text *to, NSString *label,
                      struct k_vec v);
void witness_tell_number(struct witness_text *to, NSString *label,
                         double number);
