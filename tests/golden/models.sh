#!/usr/bin/env bash
# models.sh - each part in models/ can be included as its opening comment
# says, and the solids are closed.
. "$ROOT/tests/test.sh"

cd "$TMP" || exit
cat >camera.inc <<'END'
camera eye
{
   pixeldim  40 30
   viewpoint 0 3 5
   lookat    0 .5 0
   up        0 1 0
   angle     24
}
light lamp
{
   location   -3 6 5
   emissivity 8 8 8
}
END

# includes FILE MATERIAL…: a scene that includes the file and defines these
# materials renders.
includes()
{
  local file=$1 material
  shift
  {
    echo "include camera.inc"
    echo "include $file"
    for material in "$@"; do
      echo "material $material { ambient 1 1 1 alpha 1 ior 1.5 }"
    done
    echo "background 1 1 1"
  } >scene.mdl
  "$RAYTRACE" scene.mdl -o scene.exr
}

for file in "$ROOT"/models/solids/*.mdl; do
  name=${file##*/}
  pass "solids/$name" includes "solids/$name" "${name%.mdl}"
done
pass "materials.mdl" includes materials.mdl
pass "chequered-floor.mdl" \
  includes chequered-floor.mdl dark-tile light-tile floor

test_done
