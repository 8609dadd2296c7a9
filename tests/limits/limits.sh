#!/usr/bin/env bash
# Scenes that are large in one way: a million lights, a polygon of a million
# corners, a solid of many faces, tokens of 10 MB, files that include files.
# Both engines give the same bytes, or there is one located message. The sizes
# are a tenth of that with sanitizers; the solid's always, but for LIMITS=all.
. "$ROOT/tests/test.sh"

cd "$TMP" || exit
many=1000000 faces=100000
if [ "$BUILD" = sanitize ]; then
  many=100000 faces=10000
fi
if [ "${LIMITS-}" = all ]; then
  faces=1000000
fi

start()
{
  cat <<'MDL'
camera c { pixeldim 2 2 worlddim 2 2 viewpoint 1 1 5 }
material m { ambient 1 1 1 diffuse .5 .5 .5 }
material g { alpha .9 ior 1.3 }
MDL
}

# rendered NAME: NAME.mdl by both engines, the same bytes.
rendered()
{
  status 0 "$1: fast" timeout 100 "$RAYTRACE" "$1.mdl" -o fast.exr
  status 0 "$1: notes" timeout 100 "$RAYTRACE" "$1.mdl" --engine notes \
    -o notes.exr
  pass "$1: the same bytes" cmp fast.exr notes.exr
}

# refused NAME WHAT: one message of that start, and it is short.
refused()
{
  local status=0 said
  said=$(timeout 20 "$RAYTRACE" "$1.mdl" -o x.ppm 2>&1) || status=$?
  same "$status" 3 "$1: status 3"
  same "${said:0:${#2}}" "$2" "$1: says where and what"
  pass "$1: in few words" test "${#said}" -lt 1000
  pass "$1: no file" test ! -e x.ppm
}

{
  start
  awk -v n=$many 'BEGIN {
    for (i = 0; i < n; i++)
      printf "light l%d { location %d %d 9 emissivity 1e-6 1e-6 1e-6 }\n", i,
        i % 1000 - 500, i / 1000 - 500
    print "sphere s { material m center 1 1 -1 radius 1.5 }"
  }'
} >lights.mdl
rendered lights

# Every pixel's ray meets the disc: all is what the material sends.
{
  start
  awk -v n=$many 'BEGIN {
    printf "polygon disc { material m"
    for (i = 0; i < n; i++) {
      a = 6.283185307179586 * i / n
      printf " vertex %.17g %.17g -1", 1 + 2 * cos(a), 1 + 2 * sin(a)
    }
    print " }"
  }'
} >corners.mdl
rendered corners
same "$("$RAYTRACE" corners.mdl --explain 0,0 | sed -n \
  "s/^hits *polygon '\(.*\)' (object \([0-9]*\)).*/\1 \2/p")" "disc 1" \
  "corners: the disc is hit"

{
  start
  awk -v faces=$faces 'BEGIN {
    P = 6.283185307179586
    across = 500; round = faces / 2 / across
    for (j = 0; j < round; j++)
      for (i = 0; i < across; i++) {
        for (q = 0; q < 4; q++) {
          a = P * ((j + (q == 1 || q == 2)) % round) / round
          b = P * ((i + (q > 1)) % across) / across
          r = 1 + .5 * cos(b)
          v[q] = sprintf(" vertex %.17g %.17g %.17g", 1 + r * cos(a),
            1 + r * sin(a), -1 + .5 * sin(b))
        }
        n++
        printf "polygon p%d { solid ring material g%s%s%s }\n", n, v[0], v[1],
          v[2]
        printf "polygon q%d { solid ring material g%s%s%s }\n", n, v[0], v[2],
          v[3]
      }
  }'
} >ring.mdl
rendered ring
rm -f ./*.exr lights.mdl corners.mdl ring.mdl

# Tokens of 10 MB.
letters=$(head -c 10000000 /dev/zero | tr '\0' a)
threes=$(head -c 10000000 /dev/zero | tr '\0' 3)
{ start; echo "sphere $letters { material m center 1 1 -1 radius 1 }"; } \
  >name.mdl
rendered name
{ start; echo "sphere s { material m center 1 1 -1 radius .$threes }"; } \
  >digits.mdl
rendered digits
{ start; echo "sphere s { material m center 1 1 -1 radius $threes }"; } \
  >number.mdl
refused number "number.mdl:4:44: error: expected a number > 0 for radius"
{ start; echo "sphere s { material $letters center 1 1 -1 radius 1 }"; } \
  >material.mdl
refused material "material.mdl:4:21: error: unknown material 'aaaa"
{ start; echo "$letters s { }"; } >word.mdl
refused word "word.mdl:4:1: error: unknown keyword 'aaaa"
{ start; echo "include \"$letters\""; } >path.mdl
refused path "path.mdl:4:9: error: expected a path of at most 4095 bytes"
{ start; printf 'include "%s' "$letters"; } >quote.mdl
refused quote "quote.mdl:4:9: error: expected another \" at the end of the path"
rm -f ./*.mdl

# Files that include one another.
chain()
{
  local i
  for ((i = 0; i < $1; i++)); do
    echo "include \"link$((i + 1)).mdl\"" >"link$i.mdl"
  done
  { start; echo "sphere s { material m center 1 1 -1 radius 1 }"; } \
    >"link$1.mdl"
}
chain 255
status 0 "255 files inside each other" "$RAYTRACE" link0.mdl -o x.ppm
rm -f x.ppm
chain 1000
status 3 "1000 are refused" "$RAYTRACE" link0.mdl -o x.ppm
same "$("$RAYTRACE" link0.mdl -o x.ppm 2>&1 | grep error)" \
  "link256.mdl:1:9: error: too much to include, expected at most 65536 files \
in all and 256 inside each other" "and it is said where"

# A file that is included again and again is in memory as often.
head -c 1000000 /dev/zero | tr '\0' '#' >large.inc
{ start; yes 'include "large.inc"' | head -n 3000; } >often.mdl
status=0 most=unlimited
[ "$BUILD" = sanitize ] || most=1000000
said=$( (ulimit -v $most
  timeout 20 "$RAYTRACE" often.mdl -o x.ppm) 2>&1) || status=$?
same "$status" 3 "a file of 1 MB, 3000 times, is refused within 1 GB"
same "$(head -n 1 <<<"$said")" "often.mdl:72:9: error: too much to include, \
expected at most 64 MB of files that have been included before" \
  "where it gets too much"
test_done
