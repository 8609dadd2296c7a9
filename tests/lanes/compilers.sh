#!/usr/bin/env bash
# Every scene gives the same bytes, colours, depths, normals and object
# numbers, from gcc -O3 (the build under test), gcc -O0 and clang -O2.
. "$ROOT/tests/test.sh"

mapfile -t scenes < <(scene_files)
render()
{
  "$ROOT/build/$1/raytrace" "$2" -r 64x48 --aov depth,normal,object -o "$3"
}

pass "there are scenes" test ${#scenes[@]} -gt 0
for scene in "${scenes[@]}"; do
  name=${scene#"$ROOT"/}
  pass "$BUILD renders $name" render "$BUILD" "$scene" \
    "$TMP/${name//\//_}.exr"
done

for build in gcc-O0 clang-O2; do
  pass "$build builds without a warning" \
    make -s -C "$ROOT" -j"$(nproc)" BUILD=$build
  for scene in "${scenes[@]}"; do
    name=${scene#"$ROOT"/}
    rm -f "$TMP/other.exr"
    render $build "$scene" "$TMP/other.exr"
    pass "$build gives the bytes of $BUILD for $name" \
      cmp "$TMP/${name//\//_}.exr" "$TMP/other.exr"
  done
done
test_done
