#!/usr/bin/env bash
# A small measurement of the knobs: every bound holds, and every rung of
# --quality costs twice the rays of the one below and is more accurate.
. "$ROOT/tests/test.sh"

if [ "$BUILD" != default ]; then
  skip "the ladder is measured with the default build"
  test_done
  exit
fi
pass "bounds and rungs" "$ROOT/bench/trade/run" --small
test_done
