#!/usr/bin/env bash
# Every scene gives the same bytes, colours, depths, normals and object
# numbers, from gcc -O3 (the build under test), gcc -O0 and clang -O2.
. "$ROOT/tests/test.sh"

mapfile -t scenes < <(scene_files)

# render BUILD SCENE OUT
render()
{
  "$ROOT/build/$1/raytrace" "$2" -r 64x48 --aov depth,normal,object -o "$3"
}

# same_bytes BUILD SCENE FILE: the build renders the file's bytes.
same_bytes()
{
  rm -f "$TMP/other.exr"
  render "$1" "$2" "$TMP/other.exr" && cmp "$3" "$TMP/other.exr"
}

pass "there are scenes" test ${#scenes[@]} -gt 0
for i in "${!scenes[@]}"; do
  pass "${scenes[i]#"$ROOT"/} renders" \
    render "$BUILD" "${scenes[i]}" "$TMP/$i.exr"
done

for other in gcc-O0 clang-O2; do
  failures=$test_failures
  pass "$other builds without a warning" \
    make -s -C "$ROOT" -j"$(nproc)" BUILD=$other
  if [ "$test_failures" != "$failures" ]; then
    continue
  fi
  for i in "${!scenes[@]}"; do
    pass "$other renders the same bytes of ${scenes[i]#"$ROOT"/}" \
      same_bytes $other "${scenes[i]}" "$TMP/$i.exr"
  done
done
test_done
