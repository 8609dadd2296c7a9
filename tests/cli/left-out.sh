#!/usr/bin/env bash
# --no-shadows, --no-reflection, --no-refraction, --no-depth-of-field and
# --fresnel: both engines, the same bytes; and what they leave out.
. "$ROOT/tests/test.sh"

cd "$TMP" || exit
scene=$ROOT/scenes/still-life.mdl
for option in --no-shadows --no-reflection --no-refraction --fresnel=exact; do
  "$RAYTRACE" "$scene" -q -r 32x24 $option -o fast.exr
  "$RAYTRACE" "$scene" -q -r 32x24 $option --engine notes -o notes.exr
  pass "$option: both engines, the same bytes" cmp fast.exr notes.exr
  "$RAYTRACE" "$scene" -q -r 32x24 -o whole.exr
  status 1 "$option is seen" cmp -s fast.exr whole.exr
  pass "$option is in the file" grep -qa -- "${option%=*}" fast.exr
done
lens=$ROOT/scenes/depth-of-field.mdl
"$RAYTRACE" "$lens" -q -r 32x24 --no-depth-of-field -o pinhole.ppm
sed -E '/^ *(focus|fstop|exposure|aperture) /d' "$lens" >pinhole.mdl
"$RAYTRACE" pinhole.mdl -q -r 32x24 -I "${lens%/*}" -o sharp.ppm
pass "--no-depth-of-field is the picture of a pinhole" cmp pinhole.ppm sharp.ppm
test_done
