#!/usr/bin/env bash
# run.sh - every scene, small, is to the last bit the picture that is kept
# here: colour, depth, normal and object number of each pixel. On a failure
# the picture and the difference stay in build/golden/. tests/golden/update
# makes the kept ones anew, on purpose.
. "$ROOT/tests/test.sh"

compare=$PROGRAMS/golden/exrcompare
failed=$ROOT/build/golden/$BUILD
rm -rf "$failed"

# is_golden SCENE GOLDEN
is_golden()
{
  local name=${1%.mdl}
  name=${name##*/}
  if ! [ -e "$2" ]; then
    echo "there is no ${2#"$ROOT"/}: tests/golden/update makes it"
    return 1
  fi
  "$ROOT/tests/golden/render" "$1" "$TMP/$name.exr" || return
  if ! "$compare" "$2" "$TMP/$name.exr" "$TMP/$name.ppm"; then
    mkdir -p "$failed"
    mv "$TMP/$name".* "$failed"
    echo "found: $failed/$name.exr"
    if [ -e "$failed/$name.ppm" ]; then
      echo "expected, found, where they differ: $failed/$name.ppm"
    fi
    return 1
  fi
}

while read -r scene; do
  name=${scene##*/}
  pass "${scene#"$ROOT"/}" \
    is_golden "$scene" "$ROOT/tests/golden/${name%.mdl}.exr"
done < <(scene_files)

# The hashes that other compilers are compared with are of these pictures.
while read -r sum name; do
  is=$("$compare" --pixels "$ROOT/tests/golden/${name%.mdl}.exr" | sha256sum)
  same "${is%% *}" "$sum" "SHA256SUMS has $name"
done <"$ROOT/tests/golden/SHA256SUMS"
same "$(sed 's/.* //' "$ROOT/tests/golden/SHA256SUMS")" \
  "$(cd "$ROOT/scenes" && printf '%s\n' *.mdl)" "and all of scenes/"

strays=
for golden in "$ROOT"/tests/golden/*.exr; do
  name=${golden##*/}
  [ -e "$ROOT/scenes/${name%.exr}.mdl" ] || strays+=" $name"
done
same "$strays" "" "no golden picture without its scene"

test_done
