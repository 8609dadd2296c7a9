#!/usr/bin/env bash
# The files the tool writes, as other programs see them.
. "$ROOT/tests/test.sh"

cd "$TMP" || exit
cat >pin.mdl <<'MDL'
camera cam { pixeldim 40 30 worlddim 4 3 viewpoint 2 1.5 4 }
material grey { ambient 2 2 2 diffuse .5 .5 .5 specular .3 .3 .3 }
material glass { ambient 1 1 1 alpha .9 ior 1.5 }
light lamp { location 0 3 3 emissivity 3 3 3 }
sphere ball { material grey center 1 1.5 -2 radius 1 }
sphere drop { material glass center 3 1.5 -2 radius 1 }
MDL
all=depth,normal,object
"$RAYTRACE" pin.mdl --aov $all --seed 7 --samples 4 -o all.exr
"$RAYTRACE" pin.mdl --samples 4 --seed 7 -o color.exr
"$RAYTRACE" pin.mdl --samples 4 --seed 7 -o color.png
"$RAYTRACE" pin.mdl --samples 4 --seed 7 -o color.ppm

# The same bytes on every run
mkdir again
cp pin.mdl again/other.mdl
"$RAYTRACE" again/other.mdl --aov $all --seed=7 --samples=4 -j 3 \
  --progress none -o again/all.exr
"$RAYTRACE" again/other.mdl --seed 7 --samples 4 -j 5 -o again/color.png
pass "an EXR is the same on every run" cmp all.exr again/all.exr
pass "a PNG is the same on every run" cmp color.png again/color.png
"$RAYTRACE" pin.mdl --aov $all --seed 8 --samples 4 -o again/seed.exr
status 1 "another seed is another picture" cmp -s all.exr again/seed.exr

# has PROGRAM: whether it is there; otherwise skips.
has()
{
  command -v "$1" >/dev/null && return
  skip "$1 is not installed"
  return 1
}

hash=$(sha256sum <pin.mdl)
if has exrheader; then
  exrheader all.exr >header.txt
  for line in 'software (type string): "raytrace ' \
    'raytrace:version (type string): "' \
    'raytrace:seed (type string): "7"' \
    'raytrace:options (type string): "--samples 4 --sampler owen --max-dept' \
    "raytrace:sceneSHA256 (type string): \"${hash%% *}\"" \
    'dataWindow (type box2i): (0 0) - (39 29)' \
    'displayWindow (type box2i): (0 0) - (39 29)' \
    'compression (type compression): zip'; do
    pass "exrheader: $line" grep -qF "$line" header.txt
  done
  same "$(sed -nE 's/^    ([A-Za-z.]+), .*/\1/p' header.txt | tr '\n' ' ')" \
    "B G N.X N.Y N.Z R Z id " "exrheader: the channels"
  same "$(grep -ciE 'date|time' header.txt)" 0 "exrheader: no date"
fi
if has exrinfo; then
  pass "exrinfo reads it" exrinfo all.exr
fi
if has exrcheck; then
  pass "exrcheck finds no fault" exrcheck all.exr color.exr
fi
if has oiiotool; then
  same "$(oiiotool all.exr --ch R,G,B --diff color.exr 2>&1 | tail -n 1)" \
    PASS "oiiotool: the colours are the same with and without AOVs"
  oiiotool --info -v --stats all.exr >info.txt
  pass "oiiotool reads it" grep -q '40 x   30, 8 channel' info.txt
  pass "oiiotool finds no NaN" grep -qE 'NanCount:( 0){8}' info.txt
  pass "oiiotool finds no infinity" grep -qE 'InfCount:( 0){8}' info.txt
  same "$(oiiotool color.png --diff color.ppm 2>&1 | tail -n 1)" PASS \
    "oiiotool: PNG and PPM are the same picture"
fi
if has pnmfile; then
  same "$(pnmfile color.ppm | tr -d '\t')" \
    "color.ppm:PPM raw, 40 by 30  maxval 255" "pnmfile knows the PPM"
fi
if has pngtopnm; then
  pngtopnm color.png | cmp - color.ppm
  same "$?" 0 "pngtopnm makes the PPM of the PNG"
fi

# A part is the same pixels
"$RAYTRACE" pin.mdl --aov $all --seed 7 --samples 4 --crop 7,5,31,24 \
  -o part.exr
"$RAYTRACE" pin.mdl --seed 7 --samples 4 --crop 7,5,31,24 -o part.ppm
"$RAYTRACE" pin.mdl --seed 7 --samples 4 --crop 7,5,31,24 -o part.png
{
  printf 'P6\n24 19\n255\n'
  for y in {5..23}; do
    tail -c +$((1 + 13 + 3 * (40 * y + 7))) color.ppm | head -c $((3 * 24))
  done
} >cut.ppm
pass "a part of a PPM is cut out of the whole" cmp cut.ppm part.ppm
if has exrheader; then
  exrheader part.exr >header.txt
  pass "the data window is the part" \
    grep -qF 'dataWindow (type box2i): (7 5) - (30 23)' header.txt
  pass "the display window is the whole" \
    grep -qF 'displayWindow (type box2i): (0 0) - (39 29)' header.txt
fi
if has oiiotool; then
  oiiotool all.exr --crop 24x19+7+5 -o cut.exr
  oiiotool cut.exr part.exr --diff >diff.txt 2>&1
  same "$?" 0 "oiiotool: a part of an EXR is cut out of the whole"
fi
if has pngtopnm; then
  pngtopnm part.png | cmp - part.ppm
  same "$?" 0 "a part of a PNG is its pixels"
fi

# What a pixel hit, known exactly: the axis of the left sphere goes through
# the pixel, the corner sees nothing.
cat >axis.mdl <<'MDL'
camera cam { pixeldim 3 3 worlddim 2 2 viewpoint 1 1 4 }
material grey { ambient 2 2 2 }
sphere far { material grey center 1 1 -9 radius 1 }
sphere near { material grey center 1 1 -2 radius .5 }
MDL
"$RAYTRACE" axis.mdl --aov $all -o axis.exr
if has oiiotool; then
  # Channels R G B Z id N.X N.Y N.Z; oiiotool divides id by 2^32 - 1.
  oiiotool axis.exr --mulc 1,1,1,1,4294967295,1,1,1 -o scaled.exr
  oiiotool --dumpdata scaled.exr >dump.txt
  near=$(sed -n 's/^ *Pixel (1, 1): //p' dump.txt)
  corner=$(sed -n 's/^ *Pixel (0, 0): //p' dump.txt)
  pass "the middle hits the near sphere, object 2: $near" \
    grep -qE ' 5\.50* 2\.0* -?0\.0* -?0\.0* 1\.0*$' <<<"$near"
  pass "the corner hits nothing: $corner" \
    grep -qE ' 340282346[0-9]{30}\.0* 0\.0* 0\.0* 0\.0* 0\.0*$' <<<"$corner"
fi

"$RAYTRACE" pin.mdl -r 1000000x1000000 -o large.ppm 2>err.txt
same "$? $(grep -c 'not enough memory for 1000000 x 1000000 pixels' err.txt)" \
  "4 1" "a picture larger than the memory"
pass "leaves no file" test ! -e large.ppm
test_done
