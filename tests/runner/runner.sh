#!/usr/bin/env bash
# The runner counts what it says it counts: it is fed tests that are broken in
# every way it knows of.
. "$ROOT/tests/test.sh"

fixtures=$ROOT/tests/runner/fixtures

# runs FIXTURE STATUS COUNTS [PATTERN]…: the runner's status, its last line, and
# lines that have to be there.
runs()
{
  local fixture=$1 want=$2 counts=$3 output status=0 pattern
  shift 3
  output=$("$ROOT/tests/run" --build "$BUILD" --limit "${limit-60}" \
    "$fixtures/$fixture") || status=$?
  same "exit status $status, $(tail -n 1 <<<"$output")" \
    "exit status $want, $counts" "$fixture: counts"
  for pattern in "$@"; do
    pass "$fixture: says $pattern" grep -qe "$pattern" <<<"$output"
  done
}

runs passes.m 0 "6 passed, 0 failed" "1 skipped" "SKIP one of 1"
runs passes.sh 0 "3 passed, 0 failed" "1 skipped"
runs fails.m 1 "1 passed, 6 failed" "fails.m:8: 1 + 1 == 3" \
  "want -0 (-0x0p+0)"
runs fails.sh 1 "0 passed, 3 failed" "No such file" "want 3" "got:"
runs does_not_compile.m 1 "0 passed, 1 failed" "does not compile" \
  noSuchMethod
runs crashes.m 1 "1 passed, 1 failed" "killed by signal 6"
runs stops_early.m 1 "1 passed, 1 failed" "prints 0 plans"
runs asserts_nothing.m 1 "0 passed, 1 failed" "asserts nothing"
runs wrong_plan.sh 1 "1 passed, 1 failed" "plans 2 assertions and makes 1"
runs wrong_status.sh 1 "1 passed, 1 failed" "exit status 3"
runs hides_failure.sh 1 "0 passed, 1 failed"
limit=1 runs hangs.sh 1 "1 passed, 1 failed" "did not end within 1 s"
runs not_executable.sh 1 "0 passed, 1 failed" "is not executable"
if [ "$BUILD" = sanitize ]; then
  runs reads_too_far.m 1 "0 passed, 1 failed" "trips a sanitizer" \
    heap-buffer-overflow
  runs overflows.m 1 "1 passed, 1 failed" "exit status 99" \
    "signed integer overflow"
  if [ "$LEAKS" = 1 ]; then
    runs leaks.m 1 "1 passed, 1 failed" "exit status 99" \
      "detected memory leaks"
  fi
fi

status 2 "a wrong option" "$ROOT/tests/run" --no-such-option
status 2 "no such file" "$ROOT/tests/run" no-such-file
status 2 "an option without its value" "$ROOT/tests/run" --build
test_done
