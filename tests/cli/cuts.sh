#!/usr/bin/env bash
# --max-depth, --min-weight and --max-error, and the errors they tell.
. "$ROOT/tests/test.sh"

cd "$TMP" || exit
cat >pin.mdl <<'MDL'
camera cam { pixeldim 40 30 worlddim 4 3 viewpoint 2 1.5 4 }
background .2 .3 .4
material grey { ambient 2 2 2 diffuse .5 .5 .5 specular .7 .6 .5 }
material glass { ambient 1 1 1 alpha .9 ior 1.5 }
light lamp { location 0 3 3 emissivity 3 3 3 }
sphere ball { material grey center 1 1.5 -2 radius 1 }
sphere drop { material glass center 3 1.5 -2 radius 1 }
plane floor { material grey normal 0 1 0 point 0 0 0 }
MDL

# of NAME ARGUMENT…: that number of the statistics.
of()
{
  local name=$1
  shift
  "$RAYTRACE" pin.mdl --stats=json -o out.exr "$@" 2>&1 |
    sed -E "s/.*\"$name\": ([-+.0-9e]+).*/\\1/"
}

# below A B: A <= B.
below()
{
  awk -v a="$1" -v b="$2" 'BEGIN { exit !(a + 0 <= b + 0) }'
}

for error in 0.1 1/255 1e-6; do
  pass "--max-error $error is kept" below "$(of most --max-error $error)" \
    "$(awk "BEGIN { print $error }")"
  pass "which is in the file" grep -qa error.truncation out.exr
  "$RAYTRACE" pin.mdl --max-error $error --engine notes -j 2 -o notes.exr
  pass "both engines: the same bytes" cmp out.exr notes.exr
done
pass "less error, more rays" below "$(of reflection --max-error 0.1)" \
  "$(of reflection --max-error 1e-6)"
pass "more weight, fewer rays" below "$(of reflection --min-weight 0.5)" \
  "$(of reflection --min-weight 0.01)"
pass "more depth, less error" \
  below "$(of most --aov error.truncation --max-depth 6)" \
  "$(of most --aov error.truncation --max-depth 2)"

"$RAYTRACE" pin.mdl -o plain.exr
status 1 "no error is told unless asked for" grep -qa error.truncation plain.exr
"$RAYTRACE" pin.mdl --min-weight 0 -o all.ppm
"$RAYTRACE" pin.mdl -o plain.ppm
pass "--min-weight 0 cuts nothing" cmp all.ppm plain.ppm
"$RAYTRACE" pin.mdl --max-error 0.01 --crop 5,6,25,20 -o crop.exr
pass "with a crop" test -s crop.exr
"$RAYTRACE" pin.mdl --max-error 0.003921568627450980 -o decimal.exr
"$RAYTRACE" pin.mdl --max-error=1/255 -o fraction.exr
pass "1/255 is the number" cmp decimal.exr fraction.exr

for bad in -1 2 x 1e 1/0 1/2/3 nan inf '' ' .5' 0x; do
  said=$("$RAYTRACE" pin.mdl -o x.exr --min-weight "$bad" 2>&1)
  same "$? $said" "2 raytrace: option '--min-weight' takes a number from 0 to \
1, or a fraction such as 1/255, not '$bad'" "--min-weight '$bad'"
done
said=$("$RAYTRACE" pin.mdl -o x.exr --max-error 0 2>&1)
same "$? $said" "2 raytrace: option '--max-error' takes a number above 0 up to \
1000000, or a fraction such as 1/255, not '0'" "--max-error 0"
test ! -e x.exr
same "$?" 0 "nothing is written"

test_done
