#!/usr/bin/env bash
# --noise: the same bytes for any number of threads, from both engines, with
# every instruction set, and of a part; what the file and --stats tell.
. "$ROOT/tests/test.sh"

cd "$TMP" || exit
scene=$ROOT/scenes/depth-of-field.mdl

# render OUT OPTION…
render()
{
  "$RAYTRACE" "$scene" -q -r 40x25 --noise 1/16 -o "$@"
}

render one.exr -j 1 --stats=json 2>stats.json
render one.ppm
for way in "-j 2" "-j 7" "--engine notes" "--isa base"; do
  read -ra options <<<"$way"
  render other.exr "${options[@]}"
  pass "$way: the same bytes" cmp one.exr other.exr
done
read -ra options <<<"$(strings one.exr | grep -o -- '^--resolution.*')"
options[-1]=${options[-1]%raytrace:*}
pass "the options that the file states are taken" \
  "$RAYTRACE" "$scene" -q "${options[@]}" -o other.exr
pass "and give the same bytes" cmp one.exr other.exr
render part.ppm --crop 7,3,29,22
same "$(tail -c 1254 part.ppm | md5sum)" "$(for ((y = 3; y < 22; y++)); do
  tail -c +$((13 + 3 * (40 * y + 7) + 1)) one.ppm | head -c 66
done | md5sum)" "a part is that of the whole"
pass "--stats: no pixel above the limit" grep -q '"capped": 0}' stats.json
pass "--stats: all pixels" grep -q '"noise": {"pixels": 1000, ' stats.json
same "$(grep -o '"eye": [0-9]*' stats.json | grep -o '[0-9]*')" \
  "$(grep -o '"pixels": 1000, "rays": [0-9]*' stats.json |
    grep -o '[0-9]*$')" "the rays that pixels state are those that were traced"
render few.exr --max-samples 8 --stats=json 2>few.json
pass "--max-samples 8: all rays are those" grep -q '"rays": 8000,' few.json
pass "and pixels above the limit are counted" \
  grep -qE '"capped": [1-9][0-9]*}' few.json
test_done
