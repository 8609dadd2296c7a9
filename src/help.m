// help.m

#import "help.h"
#import "option.h"

enum { COLUMN = 27, WIDTH = 79 };

/** The words, broken into lines that begin in COLUMN. The first line goes
    behind what stands there already. */
static void
append_wrapped(NSMutableString *text, NSUInteger used, NSString *words)
{
  for (NSString *word in [words componentsSeparatedByString: @" "])
    {
      if (used < COLUMN || used + 1 + [word length] > WIDTH)
        {
          if (used >= COLUMN)
            {
              [text appendString: @"\n"];
              used = 0;
            }
          [text appendFormat: @"%*s", (int)(COLUMN - used), ""];
          used = COLUMN;
        }
      else
        {
          [text appendString: @" "];
          used++;
        }
      [text appendString: word];
      used += [word length];
    }
  [text appendString: @"\n"];
}

/** "  -j, --threads N". */
static NSString *
synopsis(const struct option *option)
{
  NSString *letter = option->letter
    ? [NSString stringWithFormat: @"-%c, ", option->letter] : @"    ";
  NSString *value = @"";

  if (option->value)
    {
      value = [NSString stringWithFormat: option->may_be_bare ? @"[=%s]"
                        : @" %s", option->value];
    }
  return [NSString stringWithFormat: @"  %@%@%@", letter,
                   option_name(option), value];
}

NSString *
help_text(void)
{
  NSMutableString *text = [NSMutableString stringWithString:
    @"usage: raytrace [OPTION]... SCENE -o FILE\n"
    @"Traces the rays of a scene (.mdl or .nff, - is standard input) and"
    @" writes the\npicture.\n"];
  struct settings standard;

  memset(&standard, 0, sizeof standard);
  option_reset(&standard);
  for (const struct option *o = option_table; o->name; o++)
    {
      NSString *left = synopsis(o);
      NSString *value = option_value(o, &standard);
      NSString *help = [NSString stringWithUTF8String: o->help];

      if (o->heading)
        {
          [text appendFormat: @"\n%s:\n", o->heading];
        }
      if (value)
        {
          help = [help stringByAppendingFormat: @" (default %@)", value];
        }
      if ([left length] + 2 > COLUMN)
        {
          left = [left stringByAppendingString: @"\n"];
        }
      [text appendString: left];
      append_wrapped(text, [left hasSuffix: @"\n"] ? 0 : [left length], help);
    }
  [text appendString:
    @"\nExit status: 0 done, 2 wrong arguments, 3 faults in the scene, 4 a"
    @" file cannot\nbe read or written or memory is short, 130 interrupted"
    @" (128 + the signal).\n"];
  return text;
}
