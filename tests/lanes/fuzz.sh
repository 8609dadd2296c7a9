#!/usr/bin/env bash
# A minute of fuzzing finds nothing: the model parser, the NFF reader, the
# options and the whole tool under the sanitizers, two at a time.
. "$ROOT/tests/test.sh"

"$ROOT/tests/fuzz/run" 30 "$TMP/found" 1 || true
for target in model nff options tool; do
  log=$TMP/found/$target.log
  runs=$(awk '/^stat::number_of_executed_units/ { print $2 }' "$log")
  pass "$target: ${runs:-no} inputs" test "${runs:-0}" -gt 100
  found=("$TMP"/found/crash-"$target"-*)
  if [ -e "${found[0]}" ]; then
    mkdir -p "$ROOT/build/found"
    cp "${found[@]}" "$ROOT/build/found"
  fi
  pass "$target: none of them is a defect" \
    bash -c '[ ! -e "$1" ] || { tail -n 60 "$2"; false; }' bash \
    "${found[0]}" "$log"
done
test_done
