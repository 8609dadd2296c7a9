#!/usr/bin/env bash
# --time-limit: in time, and the same picture again with --samples; the error it
# states.
. "$ROOT/tests/test.sh"

cd "$TMP" || exit
pixels=$PROGRAMS/golden/exrcompare

# colors FILE: the channels B, G and R of 40 x 30 pixels
colors()
{
  "$pixels" --pixels "$1" | head -c 14400 | od -An -v -tf4 -w4
}

for name in still-life depth-of-field; do
  scene=$ROOT/scenes/$name.mdl
  extra=()
  if [ $name = depth-of-field ]; then
    extra=(--exposure 1)
  fi
  said=$("$RAYTRACE" "$scene" -r 40x30 --time-limit 0.1 -o limited.exr 2>&1)
  rays=$(sed -nE 's/.*time-limit: ([0-9]+) rays? .*/\1/p' <<<"$said")
  pass "$name: some rays: $said" test "${rays:-0}" -gt 0
  "$RAYTRACE" "$scene" -q -r 40x30 --samples "$rays" "${extra[@]}" -o again.exr
  same "$(colors limited.exr | md5sum)" "$(colors again.exr | md5sum)" \
    "$name: --samples gives the same colours"
  same "$(strings limited.exr | grep -- --samples)" \
    "$(strings again.exr | grep -- --samples)" "$name: and the options say it"
  # The error: the fourth plane, of one half-width for each pixel.
  "$RAYTRACE" "$scene" -q -r 40x30 --samples 2048 "${extra[@]}" --seed 7 \
    -o reference.exr
  colors limited.exr >limited
  colors reference.exr >reference
  "$pixels" --pixels limited.exr | tail -c 4800 | od -An -v -tf4 -w4 >errors
  # Noisy: those that state more than half a ray.
  read -r held noisy <<<"$(paste limited reference | awk -v n=1200 -v rays="$rays" '
    NR == FNR { h[NR] = $1; next }
    { i = (FNR - 1) % n + 1; d = $1 - $2; d = d < 0 ? -d : d
      if (d > most[i]) most[i] = d }
    END { for (i = 1; i <= n; i++) if (h[i] * rays > 0.5001) {
        noisy++; held += most[i] <= h[i] + 0.0001 }
      print held / noisy, noisy }' errors -)"
  pass "$name: intervals hold $held of $noisy noisy pixels" \
    awk "BEGIN { exit !($noisy > 200 && $held > .88 && $held < .995) }"
done
"$RAYTRACE" "$scene" -q -r 40x30 --time-limit 0.3 --confidence 0.875 \
  -o sure.exr
pass "the confidence is in the file" grep -qa '0\.875raytrace:' sure.exr
read -ra options <<<"$(strings sure.exr | grep -o -- '--samples.*')"
options[-1]=${options[-1]%raytrace:*}
pass "the options that the file states are taken: ${options[*]}" \
  "$RAYTRACE" "$scene" -q -r 40x30 "${options[@]}" -o again.exr
same "$(colors again.exr | md5sum)" "$(colors sure.exr | md5sum)" \
  "and give the same colours"
said=$("$RAYTRACE" "$scene" -r 4000x3000 --time-limit 0.001 -o short.ppm 2>&1)
status 0 "too short is told: $said" grep -q "too short" <<<"$said"
pass "and the picture is whole" test "$(wc -c <short.ppm)" -gt 36000000
said=$("$RAYTRACE" "$scene" --time-limit 1 --samples 4 -o x.ppm 2>&1)
same "$?" 2 "not with samples: $said"
test_done
