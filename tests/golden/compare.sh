#!/usr/bin/env bash
# compare.sh - the comparer of golden pictures finds what differs, and says
# where.
. "$ROOT/tests/test.sh"

compare=$PROGRAMS/golden/exrcompare
cd "$TMP" || exit

cat >scene.mdl <<'END'
camera eye
{
   pixeldim  8 6
   worlddim  4 3
   viewpoint 2 1.5 4
}
material dull
{
   ambient 1 2 3
}
sphere ball
{
   material dull
   center   2 1.5 -2
   radius   .9
}
END
sed 's/ambient 1 2 3/ambient 1 2.25 3/' scene.mdl >greener.mdl
for name in scene greener; do
  "$RAYTRACE" -q --aov depth,object $name.mdl -o $name.exr
done
"$RAYTRACE" -q --aov depth,object -r 9x6 scene.mdl -o wider.exr
"$RAYTRACE" -q --aov depth scene.mdl -o fewer.exr
"$RAYTRACE" -q --aov depth,object --crop 1,0,8,6 scene.mdl -o cropped.exr

pass "a picture equals itself" "$compare" scene.exr scene.exr
status 1 "another colour is another picture" \
  "$compare" scene.exr greener.exr difference.ppm

"$compare" scene.exr greener.exr >said
same "$(grep -c . said)" 2 "the comparer says two lines"
pass "it names the first pixel, its channel and both values" grep -qE \
  '^first at column 3, row 2 from the top, channel G: expected [0-9.]+ \(0x[0-9a-f]{8}\), found ' said
pass "it counts pixels, in all and by channel" \
  grep -qE '^4 of 48 pixels differ: B 0 G 4 R 0 Z 0 id 0$' said
same "$(head -c 9 difference.ppm | tr '\n' ' ')" "P6 24 6 2" \
  "the difference picture is three wide"
same "$(tail -c +13 difference.ppm | od -An -v -tx1 | tr -d ' \n' |
  grep -o ffffff | wc -l)" 4 "it is white where the pixels differ"

for other in wider fewer cropped; do
  status 1 "$other: not of one form" "$compare" scene.exr $other.exr
done
"$compare" scene.exr fewer.exr >said
same "$(cat said)" "expected: 8 x 6 pixels from 0 0, of 8 x 6, channels B G R Z id(uint)
   found: 8 x 6 pixels from 0 0, of 8 x 6, channels B G R Z" \
  "it says what the forms are"

status 2 "a file that is no picture" "$compare" scene.exr scene.mdl
status 2 "a file that is not there" "$compare" scene.exr nothing.exr
head -c 500 scene.exr >half.exr
status 2 "half a picture" "$compare" scene.exr half.exr

# A NaN is one number among others: the same bits or not.
if command -v oiiotool >/dev/null; then
  oiiotool scene.exr --ch R,G,B --mulc 0 -d float -o black.exr
  oiiotool black.exr --mulc inf -d float -o nan.exr
  pass "a picture of NaN equals itself" "$compare" nan.exr nan.exr
  status 1 "a picture of NaN is not black" "$compare" black.exr nan.exr
else
  skip "no oiiotool to make a NaN"
  skip "no oiiotool to make a NaN"
fi

test_done
