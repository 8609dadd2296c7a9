#!/usr/bin/env bash
# The table of docs/stability.md is that of the battery as it is: every id has
# checks and passes.
. "$ROOT/tests/test.sh"

if [ "$BUILD" != default ]; then
  skip "the table is of the default build"
  test_done
  exit
fi
pass "every id of the battery passes" \
  sh -c '"$0/tests/stability/extremes" >"$1"' "$ROOT" "$TMP/table.md"
sed '1,/<!-- table -->/d; /<!-- end -->/,$d' "$ROOT/docs/stability.md" \
  >"$TMP/page.md"
same "$(grep -c '| pass |$' "$TMP/page.md")" 114 "the page has all 114"
pass "the page says what was found" diff "$TMP/page.md" "$TMP/table.md"

test_done
