// messages.m - how faults are told: in the order of the text, twenty of them,
// each with its line and a caret that stands where it belongs.

#import "test.h"
#import "load.h"
#include "excerpt.h"

static struct place
place(int file, int line, int column, unsigned long order)
{
  return (struct place){ .file = file, .line = line, .column = column,
                         .order = order };
}

static diag_t *
diag_with(const char *text)
{
  diag_t *diag = [[[diag_t alloc] init] autorelease];

  [diag addFile: @"a.mdl" text: [NSData dataWithBytes: text
                                               length: strlen(text)]
       includer: place(-1, 0, 0, 0)];
  return diag;
}

static void
test_order(void)
{
  diag_t *diag = diag_with("one\ntwo\nthree\n");

  [diag warn: place(0, 1, 1, 0) : @"a warning"];
  [diag fault: place(0, 3, 2, 9) : @"number %d", 3];
  [diag fault: place(0, 1, 1, 0) : @"number %d", 1];
  [diag fault: place(0, 2, 3, 6) : @"number %d", 2];
  [diag fault: place(0, 2, 3, 6) : @"another at the same place"];
  PASS([diag faultCount] == 3, "two faults at one place are one");
  PASS(is_text([diag report],
               "a.mdl:1:1: error: number 1\n"
               "   1 | one\n"
               "     | ^\n"
               "a.mdl:2:3: error: number 2\n"
               "   2 | two\n"
               "     |   ^\n"
               "a.mdl:3:2: error: number 3\n"
               "   3 | three\n"
               "     |  ^\n"),
       "in the order of the text, without the warning");
}

static unsigned
count(NSString *text, NSString *part)
{
  return (unsigned)[[text componentsSeparatedByString: part] count] - 1;
}

static void
test_limit(void)
{
  for (unsigned n = 19; n <= 22; n++)
    {
      diag_t *diag = diag_with("x\n"), *mild = diag_with("x\n");
      for (unsigned i = n; i > 0; i--)          // the last ones first
        {
          [diag fault: place(0, 1, 1, i) : @"number %u.", i];
          [mild warn: place(0, 1, 1, i) : @"number %u.", i];
        }
      NSString *report = [[diag report]
                           stringByAppendingString: [mild report]];
      PASS([diag faultCount] == n && count(report, @": error: ") == MIN(n, 20)
           && count(report, @": warning: ") == MIN(n, 20)
           && count(report, @"number 20.") == (n >= 20 ? 2 : 0)
           && count(report, @"number 21.") == 0, "%u faults", n);
      PASS(count(report, @"\n1 more error\n") == (n == 21)
           && count(report, @"\n2 more errors\n") == (n == 22)
           && count(report, @"\n1 more warning\n") == (n == 21)
           && count(report, @"\n2 more warnings\n") == (n == 22),
           "what is said of the others of %u", n);
    }
  PASS([[[[[diag_t alloc] init] autorelease] report] length] == 0,
       "no faults, no report");
}

static void
test_excerpt(void)
{
  static const struct
  {
    const char *text;
    int line, column;
    const char *want, *what;
  } cases[] = {
    { "abc", 1, 2, "   1 | abc\n     |  ^\n", "a line without an end" },
    { "abc\n", 2, 1, "   2 |\n     | ^\n", "the end of the file" },
    { "", 1, 1, "   1 |\n     | ^\n", "an empty file" },
    { "a\n\tb\tc\n", 2, 4, "   2 | \tb\tc\n     | \t \t^\n", "tabs" },
    { "a\xC3\xBC" "b", 1, 3, "   1 | a\xC3\xBC" "b\n     |   ^\n",
      "two bytes are a character" },
    { "\xE7\x90\x83 x", 1, 3, "   1 | \xE7\x90\x83 x\n     |    ^\n",
      "wide characters take two columns" },
    { "e\xCC\x81x", 1, 3, "   1 | e\xCC\x81x\n     |  ^\n",
      "combining marks take none" },
    { "ab\r\ncd\r\n", 1, 3, "   1 | ab\n     |   ^\n", "CR LF" },
    { "a\x1B[31mb", 1, 7, "   1 | a\xEF\xBF\xBD[31mb\n     |       ^\n",
      "control characters are not sent to the terminal" },
    { "\n\n\n\n\n\n\n\n\nten", 10, 1, "  10 | ten\n     | ^\n",
      "numbers are aligned" },
  };

  for (unsigned i = 0; i < sizeof cases / sizeof *cases; i++)
    {
      NSData *text = [NSData dataWithBytes: cases[i].text
                                    length: strlen(cases[i].text)];
      PASS(is_text(excerpt(text, cases[i].line, cases[i].column),
                   cases[i].want), "%s", cases[i].what);
    }
}

/** The character above the caret. */
static unichar
pointed_at(NSString *excerpt)
{
  NSArray *lines = [excerpt componentsSeparatedByString: @"\n"];
  NSUInteger caret = [[lines objectAtIndex: 1] length] - 1;

  return [[lines objectAtIndex: 0] characterAtIndex: caret];
}

static void
test_long_lines(void)
{
  NSMutableData *line = [NSMutableData dataWithLength: 1000000];
  char *bytes = [line mutableBytes];
  static const int columns[] = {
    1, 2, 59, 60, 61, 62, 119, 120, 121, 500000, 999879, 999880, 999881,
    999940, 999999, 1000000
  };

  for (unsigned i = 0; i < sizeof columns / sizeof *columns; i++)
    {
      memset(bytes, '-', [line length]);
      bytes[columns[i] - 1] = 'X';
      NSString *shown = excerpt(line, 1, columns[i]);
      PASS(pointed_at(shown) == 'X' && [shown length] < 300,
           "column %d of a very long line", columns[i]);
    }
}

/** One line more for each place: its column counts characters. */
static void
test_columns(void)
{
  struct load load = load_text(CAMERA "\t\xC3\xBC\t{ }\n"
                               "# \xE7\x90\x83\n\xF0\x9F\x94\xAE\xF0\x9F\x94\xAE"
                               " } \t}\r\n");

  PASS(count(load.report, @"text.mdl:2:2: error:") == 1
       && count(load.report, @"text.mdl:4:1: error:") == 1,
       "a tab and a character are one column each");
  PASS(load.faults == 3, "and all are told");
}

int
main(void)
{
  NSAutoreleasePool *pool = [[NSAutoreleasePool alloc] init];

  test_order();
  test_limit();
  test_excerpt();
  test_long_lines();
  test_columns();
  [pool release];
  return test_done();
}
