// test.h - assertions for test programs. Each prints one TAP line; one that
// fails adds where it stands and what was found. main makes its own
// autorelease pool and ends with `return test_done();`.

#ifndef TEST_H
#define TEST_H

#include <math.h>
#include <stdarg.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define TEST_FORMAT(n) \
  __attribute__((unused, format(printf, n, n + 1)))

static int test_count, test_failures;

/** The condition holds. */
#define PASS(condition, ...) \
  test_line((condition) ? 1 : 0, __FILE__, __LINE__, #condition, __VA_ARGS__)

/** Two doubles are the same bits: 0.0 is not -0.0. */
#define PASS_BITS(got, want, ...) \
  test_double(got, want, 0, 'b', __FILE__, __LINE__, __VA_ARGS__)

/** Two doubles are at most `tolerance` apart. */
#define PASS_NEAR(got, want, tolerance, ...) \
  test_double(got, want, tolerance, 'n', __FILE__, __LINE__, __VA_ARGS__)

/** At most n - 1 doubles lie between the two. */
#define PASS_ULPS(got, want, n, ...) \
  test_double(got, want, n, 'u', __FILE__, __LINE__, __VA_ARGS__)

/** So large a part of what is allowed is at most all of it. */
#define PASS_PART(part, ...) \
  test_double(part, 0, 1, 'p', __FILE__, __LINE__, __VA_ARGS__)

/** Instead of an assertion that cannot be made here. */
#define SKIP(...) test_skip(__VA_ARGS__)

static TEST_FORMAT(5) int
test_line(int passed, const char *file, int line, const char *condition,
          const char *format, ...)
{
  va_list arguments;

  test_count++;
  test_failures += !passed;
  printf("%s %d - ", passed ? "ok" : "not ok", test_count);
  va_start(arguments, format);
  vprintf(format, arguments);
  va_end(arguments);
  if (!passed)
    {
      printf("\n# %s:%d: %s", file, line, condition);
    }
  printf("\n");
  fflush(stdout);       // a crash later must not lose it
  return passed;
}

/** The number of a double in the order of all doubles. */
static __attribute__((unused)) int64_t
test_ordinal(double x)
{
  int64_t bits;

  memcpy(&bits, &x, sizeof bits);
  return bits < 0 ? INT64_MIN - bits : bits;
}

static TEST_FORMAT(7) int
test_double(double got, double want, double tolerance, char kind,
            const char *file, int line, const char *format, ...)
{
  char text[1024], difference[256];
  va_list arguments;
  int passed;
  // Unsigned: the distance of the farthest two fits.
  uint64_t ulps = test_ordinal(got) > test_ordinal(want)
    ? (uint64_t)test_ordinal(got) - (uint64_t)test_ordinal(want)
    : (uint64_t)test_ordinal(want) - (uint64_t)test_ordinal(got);

  if (kind == 'b')
    passed = memcmp(&got, &want, sizeof got) == 0;
  else if (kind == 'p')
    passed = got <= tolerance;
  else if (kind == 'n')
    passed = got == want || fabs(got - want) <= tolerance;
  else
    passed = !isnan(got) && !isnan(want) && (double)ulps <= tolerance;

  va_start(arguments, format);
  vsnprintf(text, sizeof text, format, arguments);
  va_end(arguments);
  snprintf(difference, sizeof difference,
           "got %.17g (%a), want %.17g (%a): %g apart, %.0f ulps",
           got, got, want, want, fabs(got - want), (double)ulps);
  test_line(passed, file, line, difference, "%s", text);
  if (getenv("TEST_TELL"))      // for tests/stability/extremes
    {
      printf("# tell\t%.17g\t%.17g\t%g\t%.0f\t%g\t%c\n", got, want,
             fabs(got - want), (double)ulps, tolerance, kind);
    }
  return passed;
}

static TEST_FORMAT(1) void
test_skip(const char *format, ...)
{
  va_list arguments;

  printf("ok %d # SKIP ", ++test_count);
  va_start(arguments, format);
  vprintf(format, arguments);
  va_end(arguments);
  printf("\n");
}

/** Prints the plan; what main returns. */
static __attribute__((unused)) int
test_done(void)
{
  printf("1..%d\n", test_count);
  return test_failures != 0;
}

#endif
