# shellcheck shell=bash
# test.sh - assertions for test scripts: . "$ROOT/tests/test.sh". Each prints
# one TAP line; one that fails shows what it found. The last line of a script
# is test_done. The runner sets ROOT (the source tree), RAYTRACE (the tool to
# test), BUILD (the build it is of), PROGRAMS (where the programs tests/*/*.c
# are) and TMP (a folder of the script's own, removed afterwards).

test_count=0 test_failures=0

# pass TEXT COMMAND…: the command succeeds; its output is shown otherwise.
pass()
{
  local text=$1 output status=0
  shift
  output=$("$@" 2>&1) || status=$?
  test_line "$status" "$text" "\$ $*"$'\n'"$output"$'\n'"exit status $status"
}

# status WANT TEXT COMMAND…: the command exits with this status.
status()
{
  local want=$1 text=$2 output status=0
  shift 2
  output=$("$@" 2>&1) || status=$?
  test_line "$((status != want))" "$text" \
    "\$ $*"$'\n'"$output"$'\n'"exit status $status, want $want"
}

# same GOT WANT TEXT: two strings are equal.
same()
{
  local status=0
  [ "$1" = "$2" ] || status=1
  test_line "$status" "$3" "got:"$'\n'"$1"$'\n'"want:"$'\n'"$2"
}

# skip WHY: instead of an assertion that cannot be made here.
skip()
{
  test_count=$((test_count + 1))
  echo "ok $test_count # SKIP $1"
}

# The complete scenes of the source tree, one a line: all of scenes/, and what
# has a camera in models/.
scene_files()
{
  printf '%s\n' "$ROOT"/scenes/*.mdl
  grep -rlE '^[[:space:]]*camera' --include='*.mdl' "$ROOT"/models | sort
}

# test_line STATUS TEXT DETAILS
test_line()
{
  test_count=$((test_count + 1))
  if [ "$1" = 0 ]; then
    echo "ok $test_count - $2"
  else
    test_failures=$((test_failures + 1))
    echo "not ok $test_count - $2"
    printf '%s\n' "$3" | sed 's/^/# /'
  fi
}

test_done()
{
  echo "1..$test_count"
  [ "$test_failures" = 0 ]
}
