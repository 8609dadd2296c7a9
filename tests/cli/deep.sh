#!/usr/bin/env bash
# A million generations between two mirrors end, and no stack is too small.
. "$ROOT/tests/test.sh"

cd "$TMP" || exit
cat >mirrors.mdl <<'MDL'
camera c { pixeldim 2 1 worlddim 2 1 viewpoint 1 .5 5 }
material m { ambient 1 1 1 diffuse 1 1 1 specular .9 .9 .9 }
plane a { material m normal 0 0 1 point 0 0 -1 }
plane b { material m normal 0 0 -1 point 0 0 10 }
MDL
most=1000000
if [ "$BUILD" = sanitize ]; then
  most=20000
fi
for engine in fast notes; do
  # An object for each of them takes its time.
  [ $engine = fast ] || [ $most = 20000 ] || most=100000
  status 0 "$engine: $most generations" "$RAYTRACE" mirrors.mdl -q -j 2 \
    --engine $engine --max-depth $most -o $engine.ppm
  "$RAYTRACE" mirrors.mdl -q --engine $engine --max-depth 2000 -o some.ppm
  pass "$engine: with 0.9 each, 2000 are as many" cmp $engine.ppm some.ppm
done
"$RAYTRACE" mirrors.mdl -q -j 2 --engine notes --max-depth 15000 -o notes.exr
"$RAYTRACE" mirrors.mdl -q -j 1 --max-depth 15000 -o fast.exr
pass "15000 generations: both engines, the same bytes" cmp notes.exr fast.exr
# A sanitizer's own memory does not go into a limit.
if [ "$BUILD" != sanitize ]; then
  said=$( (ulimit -v 1000000 && "$RAYTRACE" mirrors.mdl --max-depth 1000000 \
    -o x.ppm) 2>&1)
  same "$?" 4 "refused when the machine has less: $said"
fi
pass "--plan of it" "$RAYTRACE" mirrors.mdl --plan --max-depth 1000000
test_done
