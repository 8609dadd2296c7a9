#!/usr/bin/env bash
# --format-scene: the same model, always written in the same way.
. "$ROOT/tests/test.sh"

cd "$TMP" || exit

while read -r file; do
  name=${file#"$ROOT"/}
  "$RAYTRACE" --format-scene "$file" >once.mdl
  "$RAYTRACE" --format-scene once.mdl >twice.mdl
  pass "$name: its canonical form stays as it is" cmp once.mdl twice.mdl
  "$RAYTRACE" -q "$file" -r 16x12 -o given.ppm
  "$RAYTRACE" -q once.mdl -r 16x12 -o once.ppm
  pass "$name: and gives the same picture" cmp given.ppm once.ppm
done < <(scene_files)

cat >messy.mdl <<'MDL'
# Comments go.
include "parts.inc"
sphere b { radius 0x1p-3 material m center 1e2 -0 .1 }  sphere a{
material m center 1 1 1 radius 1}background 0 .5 1
camera c { worlddim 4. 3 viewpoint 2 1.5 +4 pixeldim 008 6 }
MDL
cat >parts.inc <<'MDL'
light l { falloff 1 emissivity 1 1 1 location 0 0.30000000000000004 0 }
polygon p { vertex 0 0 0 solid s material m vertex 1 0 0 vertex 0 1 0 }
polygon q { vertex 0 0 0 solid s material m vertex 0 1 0 vertex 0 0 1 }
polygon r { vertex 0 0 0 solid s material m vertex 0 0 1 vertex 1 0 0 }
polygon t { vertex 1 0 0 solid s material m vertex 0 0 1 vertex 0 1 0 }
material m { ior 1.5 alpha 0.50 ambient 1 2 3 }
MDL
same "$("$RAYTRACE" --format-scene messy.mdl)" "background 0 0.5 1

camera c
{
  pixeldim 8 6
  worlddim 4 3
  viewpoint 2 1.5 4
}

light l
{
  location 0 0.30000000000000004 0
  emissivity 1 1 1
  falloff 1
}

material m
{
  ambient 1 2 3
  alpha 0.5
  ior 1.5
}

polygon p
{
  material m
  vertex 0 0 0
  vertex 1 0 0
  vertex 0 1 0
  solid s
}

polygon q
{
  material m
  vertex 0 0 0
  vertex 0 1 0
  vertex 0 0 1
  solid s
}

polygon r
{
  material m
  vertex 0 0 0
  vertex 0 0 1
  vertex 1 0 0
  solid s
}

polygon t
{
  material m
  vertex 1 0 0
  vertex 0 0 1
  vertex 0 1 0
  solid s
}

sphere b
{
  material m
  center 100 -0 0.1
  radius 0.125
}

sphere a
{
  material m
  center 1 1 1
  radius 1
}" "order, numbers and white space are all the same in canonical form"

test_done
