#!/usr/bin/env bash
# --time-limit: in time, and the same picture again with --samples.
. "$ROOT/tests/test.sh"

cd "$TMP" || exit
for name in still-life depth-of-field; do
  scene=$ROOT/scenes/$name.mdl
  extra=()
  if [ $name = depth-of-field ]; then
    extra=(--exposure 1)
  fi
  said=$("$RAYTRACE" "$scene" -r 40x30 --time-limit 0.3 -o limited.exr 2>&1)
  rays=$(sed -nE 's/.*time-limit: ([0-9]+) rays? .*/\1/p' <<<"$said")
  pass "$name: some rays: $said" test "${rays:-0}" -gt 0
  "$RAYTRACE" "$scene" -q -r 40x30 --samples "$rays" "${extra[@]}" -o again.exr
  pass "$name: --samples gives the same bytes" cmp limited.exr again.exr
done
said=$("$RAYTRACE" "$scene" -r 4000x3000 --time-limit 0.001 -o short.ppm 2>&1)
status 0 "too short is told: $said" grep -q "too short" <<<"$said"
pass "and the picture is whole" test "$(wc -c <short.ppm)" -gt 36000000
said=$("$RAYTRACE" "$scene" --time-limit 1 --samples 4 -o x.ppm 2>&1)
same "$?" 2 "not with samples: $said"
test_done
