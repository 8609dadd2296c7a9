// numbers.m - numbers as they stand in a model. N10.

#define _GNU_SOURCE
#import "test.h"
#import "load.h"
#include "number.h"
#include <errno.h>

static locale_t c_locale;

static enum number_result
read_text(const char *text, double *value)
{
  return number_read(text, strlen(text), c_locale, value);
}

static void
test_good(void)
{
  static const struct
  {
    const char *text;
    double value;
  } good[] = {
    { "0", 0.0 }, { "-0", -0.0 }, { "-0.0", -0.0 }, { "+0", 0.0 },
    { "+1", 1 }, { "1.", 1 }, { ".5", .5 }, { "-.5", -.5 }, { "+.5e1", 5 },
    { "1e3", 1000 }, { "1E+3", 1000 }, { "1e-3", .001 }, { "007", 7 },
    { "0x1p-3", .125 }, { "0X1.8P1", 3 }, { "-0xA", -10 }, { "0x.8", .5 },
    { "0.1", 0.1 }, { "0.30000000000000004", 0.30000000000000004 },
    { "9007199254740993", 9007199254740992 }, { "0e999", 0 },
    { "0x1p400", 0x1p400 }, { "-0x1p400", -0x1p400 },
    { "0x1p-400", 0x1p-400 }, { "123456789012345678", 123456789012345678 },
    { "1e22", 1e22 }, { "1e23", 1e23 },
    { "0.000000000000000000000000000000000000001", 1e-39 },
    { "3.14159265358979323846264338327950288", 3.14159265358979323846 },
  };

  for (unsigned i = 0; i < sizeof good / sizeof *good; i++)
    {
      double value = 0;
      PASS(read_text(good[i].text, &value) == NUMBER_GOOD
           && memcmp(&value, &good[i].value, sizeof value) == 0,
           "N10 %s is a number", good[i].text);
    }
}

static void
test_bad(void)
{
  static const struct
  {
    const char *text;
    enum number_result result;
  } bad[] = {
    { "nan", NUMBER_NONE }, { "-nan", NUMBER_NONE }, { "NaN", NUMBER_NONE },
    { "nan(1)", NUMBER_NONE }, { "inf", NUMBER_NONE }, { "-inf", NUMBER_NONE },
    { "infinity", NUMBER_NONE }, { "INF", NUMBER_NONE },
    { "1e400", NUMBER_TOO_LARGE }, { "-1e400", NUMBER_TOO_LARGE },
    { "1e308", NUMBER_TOO_LARGE }, { "0x1p1024", NUMBER_TOO_LARGE },
    { "0x1.0000000000001p400", NUMBER_TOO_LARGE },
    { "1e-400", NUMBER_TOO_SMALL }, { "-1e-400", NUMBER_TOO_SMALL },
    { "4.9e-324", NUMBER_TOO_SMALL }, { "0x1p-2000", NUMBER_TOO_SMALL },
    { "0x1.fffffffffffffp-401", NUMBER_TOO_SMALL },
    { "1,5", NUMBER_NONE }, { "1e", NUMBER_NONE }, { "1e+", NUMBER_NONE },
    { "3.5abc", NUMBER_NONE }, { "", NUMBER_NONE }, { "+", NUMBER_NONE },
    { "-", NUMBER_NONE }, { ".", NUMBER_NONE }, { "+-1", NUMBER_NONE },
    { "--1", NUMBER_NONE }, { "1.2.3", NUMBER_NONE }, { "0x", NUMBER_NONE },
    { "1_000", NUMBER_NONE }, { "1'000", NUMBER_NONE }, { "e5", NUMBER_NONE },
    { "\xD9\xA1", NUMBER_NONE }, { "1/2", NUMBER_NONE }, { "1-", NUMBER_NONE },
  };

  for (unsigned i = 0; i < sizeof bad / sizeof *bad; i++)
    {
      double value = 0;
      PASS(read_text(bad[i].text, &value) == bad[i].result,
           "N10 '%s' is not a number of a model", bad[i].text);
    }
}

/** A word of the text goes to its end and no further. */
static void
test_ends(void)
{
  static const char *const texts[] = { "1 5", "1{5", "1}", "1#5", "1\n5" };

  for (unsigned i = 0; i < 5; i++)
    {
      double value = 0;
      PASS(number_read(texts[i], 1, c_locale, &value) == NUMBER_GOOD
           && value == 1, "1 ends before %.1s", i == 4 ? "newline"
           : texts[i] + 1);
    }
}

static void
test_whole(void)
{
  static const struct
  {
    const char *text;
    enum number_result result;
    double value;
  } cases[] = {
    { "0", NUMBER_GOOD, 0 }, { "42", NUMBER_GOOD, 42 },
    { "0007", NUMBER_GOOD, 7 }, { "1000000", NUMBER_GOOD, 1000000 },
    { "99999999999999999999999999", NUMBER_GOOD, 1e15 },
    { "+1", NUMBER_NOT_WHOLE, 0 }, { "-1", NUMBER_NOT_WHOLE, 0 },
    { "1.0", NUMBER_NOT_WHOLE, 0 }, { "1e3", NUMBER_NOT_WHOLE, 0 },
    { "0x10", NUMBER_NOT_WHOLE, 0 }, { "one", NUMBER_NONE, 0 },
    { "", NUMBER_NONE, 0 }, { "nan", NUMBER_NONE, 0 },
  };

  for (unsigned i = 0; i < sizeof cases / sizeof *cases; i++)
    {
      double value = 0;
      enum number_result result
        = number_read_whole(cases[i].text, strlen(cases[i].text), c_locale,
                            &value);
      PASS(result == cases[i].result
           && (result != NUMBER_GOOD || value == cases[i].value),
           "'%s' as a whole number", cases[i].text);
    }
}

static uint64_t
next_random(uint64_t *state)
{
  *state += 0x9E3779B97F4A7C15;
  uint64_t z = (*state ^ *state >> 30) * 0xBF58476D1CE4E5B9;
  z = (z ^ z >> 27) * 0x94D049BB133111EB;
  return z ^ z >> 31;
}

/** A number as people write it, of up to 20 digits. */
static void
random_decimal(uint64_t *state, char *text)
{
  unsigned digits = 1 + next_random(state) % 20;
  unsigned point = next_random(state) % (digits + 2);
  static const char *const signs[] = { "", "", "-", "+" };

  text += sprintf(text, "%s", signs[next_random(state) % 4]);
  for (unsigned i = 0; i < digits; i++)
    {
      if (i == point)
        {
          *text++ = '.';
        }
      *text++ = '0' + next_random(state) % 10;
    }
  *text = '\0';
  if (next_random(state) % 4 == 0)
    {
      sprintf(text, "e%d", (int)(next_random(state) % 80) - 40);
    }
}

static void
test_same_as_strtod(void)
{
  unsigned different = 0, unread = 0;
  uint64_t state = 1;

  for (unsigned i = 0; i < 1000000; i++)
    {
      char text[64];
      double value, want;
      if (i % 4 == 3)
        {
          snprintf(text, sizeof text, "%.*g", 1 + (int)(i / 4 % 17),
                   ldexp((double)next_random(&state),
                         (int)(next_random(&state) % 200) - 160));
        }
      else
        {
          random_decimal(&state, text);
        }
      want = strtod_l(text, NULL, c_locale);
      unread += read_text(text, &value) != NUMBER_GOOD;
      different += memcmp(&value, &want, sizeof value) != 0;
      if (memcmp(&value, &want, sizeof value) != 0 && different < 5)
        {
          printf("# %s: %.17g, strtod %.17g\n", text, value, want);
        }
    }
  PASS(unread == 0, "a million numbers can be read");
  PASS(different == 0, "and have the bits that strtod gives");
}

static void
test_write(void)
{
  static const struct
  {
    double value;
    const char *text;
  } cases[] = {
    { 0, "0" }, { -0.0, "-0" }, { 0.1, "0.1" }, { 1.0 / 3,
      "0.3333333333333333" }, { 0.1 + 0.2, "0.30000000000000004" },
    { 1e22, "1e+22" }, { 2.56, "2.56" }, { 640, "640" },
  };
  unsigned different = 0;
  uint64_t state = 2;
  char text[32];

  for (unsigned i = 0; i < sizeof cases / sizeof *cases; i++)
    {
      number_write(cases[i].value, c_locale, text);
      PASS(strcmp(text, cases[i].text) == 0, "%.17g is written %s",
           cases[i].value, cases[i].text);
    }
  for (unsigned i = 0; i < 100000; i++)
    {
      double value = ldexp((double)(int64_t)next_random(&state),
                           (int)(next_random(&state) % 700) - 400), back;
      number_write(value, c_locale, text);
      different += read_text(text, &back) != NUMBER_GOOD
        || memcmp(&back, &value, sizeof value) != 0;
    }
  PASS(different == 0, "what is written reads back as the same bits");
}

/** The user's locale has no say in it. */
static void
test_locale(void)
{
  static const char *const names[] = {
    "de_DE.UTF-8", "fr_FR.UTF-8", "de_DE", "ru_RU.UTF-8"
  };
  double value = 0;
  char text[32];

  for (unsigned i = 0; i < 4; i++)
    {
      if (setlocale(LC_ALL, names[i]))
        {
          number_write(0.5, c_locale, text);
          PASS(read_text("1.5e0", &value) == NUMBER_GOOD && value == 1.5
               && strcmp(text, "0.5") == 0, "in the locale %s", names[i]);
          setlocale(LC_ALL, "C");
          return;
        }
    }
  SKIP("no locale with a decimal comma is installed");
}

int
main(void)
{
  NSAutoreleasePool *pool = [[NSAutoreleasePool alloc] init];

  c_locale = newlocale(LC_ALL_MASK, "C", NULL);
  test_good();
  test_bad();
  test_ends();
  test_whole();
  test_same_as_strtod();
  test_write();
  test_locale();
  freelocale(c_locale);
  [pool release];
  return test_done();
}
