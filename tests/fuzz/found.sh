#!/usr/bin/env bash
# What fuzzing has found once: each file of tests/fuzz/found gives the same
# picture and the same rays from both engines, or is refused by both. And what
# it has to begin with: words.dict has every option there is.
. "$ROOT/tests/test.sh"

# run_of ENGINE FILE: exit status, rays and picture.
run_of()
{
  local status=0
  rm -f "$TMP/out.ppm"
  timeout 5 "$RAYTRACE" "$2" -q -r 4x4 -o "$TMP/out.ppm" --engine "$1" \
    --stats=json 2>"$TMP/err.txt" || status=$?
  echo "$status $(grep -o '"rays": {[^}]*}' "$TMP/err.txt")"
  [ ! -e "$TMP/out.ppm" ] || cksum <"$TMP/out.ppm"
}

for file in "$ROOT"/tests/fuzz/found/*; do
  notes=$(run_of notes "$file")
  same "$(run_of fast "$file")" "$notes" "${file##*/}: both engines alike"
  pass "${file##*/}: drawn or refused" grep -qE '^[03] ' <<<"$notes"
done

options=$("$RAYTRACE" --help | sed -nE 's/^  (-.,|   ) --([a-z-]+).*/"--\2"/p')
pass "there are options" test "$(wc -w <<<"$options")" -gt 20
same "$(grep -vxFf "$ROOT/tests/fuzz/words.dict" <<<"$options")" "" \
  "words.dict has them all"
test_done
