// option.h - the table of the command line's options. For options_t.

#import "options_t.h"

enum option_kind
{
  OPTION_FLAG,          // no value: sets 1
  OPTION_WHOLE,         // `count` whole numbers with `separator` between
  OPTION_NUMBER,        // a number, or two with a / between: a fraction
  OPTION_WORD,          // one of `words`: sets its place, from 0
  OPTION_WORDS,         // some of `words` with commas: sets a sum of bits
  OPTION_TEXT,          // any text but none
  OPTION_TEXTS          // the same, may be repeated
};

struct option
{
  const char *heading;  // of --help, before the first option of a group
  char letter;          // 0: none
  const char *name;
  const char *value;    // what --help calls its value
  const char *help;
  enum option_kind kind;
  size_t offset;        // in struct settings
  const char *words;
  uint64_t least, most; // of each whole number
  double low, high;     // of OPTION_NUMBER
  BOOL is_above_low;    // which may not be low itself
  unsigned count;       // of numbers
  char separator;
  uint64_t standard;    // what holds when it is not given; out of range:
                        // there is nothing to tell of it
  double usual;         // the same for OPTION_NUMBER
  BOOL is_shaping;      // a picture depends on it
  BOOL may_be_bare;     // its value may be left out: the second word holds
};

/** Ended by an option without a name. */
extern const struct option option_table[];

/** The option that is written so: "--threads", "-j"; NULL if there is none. */
const struct option *option_written(NSString *text);

/** "--threads" (autoreleased). */
NSString *option_name(const struct option *option);

/** Sets what holds when no option is given. */
void option_reset(struct settings *settings);

/** Whether the next argument is its value when there is none behind a "=". */
BOOL option_wants_value(const struct option *option);

/** Takes the option with its value, nil for none, into settings. nil, or what
    is wrong with it (autoreleased). */
NSString *option_take(const struct option *option, NSString *value,
                      struct settings *settings);

/** What is set, in the form in which it is given; nil for what is not. */
NSString *option_value(const struct option *option,
                       const struct settings *settings);
