#!/usr/bin/env bash
# --explain on the command line: where the text goes, that it tells of the very
# pixel, and what is wrong.
. "$ROOT/tests/test.sh"

cd "$TMP" || exit
cat >pin.mdl <<'MDL'
camera cam { pixeldim 8 6 worlddim 4 3 viewpoint 2 1.5 4 }
background .2 .3 .4
material grey { ambient 2 2 2 diffuse .5 .5 .5 specular .7 .6 .5 }
material glass { ambient 1 1 1 alpha .9 ior 1.5 }
light lamp { location 0 3 3 emissivity 3 3 3 }
sphere ball { material grey center 1 1.5 -2 radius 1 }
sphere drop { material glass center 3 1.5 -2 radius 1 }
plane floor { material grey normal 0 1 0 point 0 0 0 }
MDL

# wrong MESSAGE ARGUMENT…
wrong()
{
  local message=$1 status=0
  shift
  "$RAYTRACE" "$@" >out.txt 2>err.txt || status=$?
  same "$status: $(cat out.txt err.txt)" "2: raytrace: $message" "$*"
}

"$RAYTRACE" pin.mdl --explain 2,3 >text.txt 2>err.txt
same "$? $(cat err.txt)" "0 " "the text is on standard output, alone"
same "$(head -n 1 text.txt)" "pixel 2,3 of 8 x 6: 1 ray" "which says of what"
"$RAYTRACE" pin.mdl --explain 2,3 -o file.txt
pass "or in a file" cmp text.txt file.txt
"$RAYTRACE" pin.mdl --explain 2,3 --engine fast -j 7 -o file.txt
pass "whatever engine and threads" cmp text.txt file.txt

# The pixel of the text as a background is the pixel of the picture.
for options in "" "--max-depth 9" "--samples 4 --seed 3"; do
  for at in 0,0 2,3 5,3 7,5; do
    x=${at%,*} y=${at#*,}
    # shellcheck disable=SC2086
    color=$("$RAYTRACE" pin.mdl --explain $at $options |
      sed -n 's/^pixel   *//p')
    echo "camera c { pixeldim 8 6 worlddim 4 3 viewpoint 2 1.5 4 }
      background $color" >flat.mdl
    "$RAYTRACE" flat.mdl --crop "$x,$y,$((x + 1)),$((y + 1))" -o flat.exr
    for engine in fast notes; do
      # shellcheck disable=SC2086
      "$RAYTRACE" pin.mdl --crop "$x,$y,$((x + 1)),$((y + 1))" $options \
        --engine $engine -o part.exr
      pass "pixel $at, $engine${options:+, $options}" \
        "$PROGRAMS/golden/exrcompare" part.exr flat.exr
    done
  done
done
"$RAYTRACE" pin.mdl --explain 0,0 --samples 4 >text.txt
same "$(grep -c '^ray [0-9]* .* eye, generation 0$' text.txt)" 4 "every sample"

off=$("$RAYTRACE" pin.mdl --explain 5,3 --max-error 0.1 |
  sed -n 's/^off at most *//p')
pass "what a cut leaves is told, and is not more than asked for: $off" \
  awk -v off="$off" 'BEGIN { exit !(off > 0 && off <= 0.1) }'

wrong "option '--explain' goes beyond the picture of 8 x 6 pixels" \
  pin.mdl --explain 8,0
wrong "option '--explain' goes beyond the picture of 8 x 3 pixels" \
  pin.mdl -r 8x3 --explain 0,3
wrong "option '--explain' takes X,Y, whole numbers from 0 to 1000000, not '1'" \
  pin.mdl --explain 1
wrong "option '--explain' tells of at most 4096 rays, and the pixel has 4097: \
give smaller --samples or --exposure" pin.mdl --explain 0,0 --samples 4097
for option in '--noise .1' '--time-limit .01'; do
  # shellcheck disable=SC2086
  wrong "option '--explain' tells of a known number of rays: without '--noise' \
and '--time-limit'" pin.mdl --explain 0,0 $option
done
wrong "options '--crop' and '--explain' exclude each other" \
  pin.mdl --explain 0,0 --crop 0,0,1,1
test_done
