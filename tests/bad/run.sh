#!/usr/bin/env bash
# Every diagnostic, whole: what `raytrace --check FILE` says of each file here
# stands in FILE.expected (without the file's suffix); *.inc are included by
# others.
. "$ROOT/tests/test.sh"

cd "$ROOT/tests/bad" || exit

count=0
for file in *.mdl *.nff; do
  expected=${file%.*}.expected
  status=0
  "$RAYTRACE" --check "$file" >"$TMP/out" 2>"$TMP/err" || status=$?
  want=0
  if grep -q ': error: ' "$expected"; then
    want=3
  fi
  cat "$TMP/out" >>"$TMP/err"
  same "$status $(cat "$TMP/err")" "$want $(cat "$expected")" "$file"
  count=$((count + 1))
done

orphans=0
for expected in *.expected; do
  if ! [ -e "${expected%.*}.mdl" ] && ! [ -e "${expected%.*}.nff" ]; then
    echo "# no file for $expected"
    orphans=$((orphans + 1))
  fi
done
same "$orphans" 0 "every expected message has its file"
pass "there are $count files" test "$count" -gt 100

test_done
