#!/usr/bin/env bash
# Every scene gives the same bytes with 1, 2 and 7 threads.
. "$ROOT/tests/test.sh"

mapfile -t scenes < <(scene_files)
pass "there are scenes" test ${#scenes[@]} -gt 0
for scene in "${scenes[@]}"; do
  name=${scene#"$ROOT"/}
  rm -f "$TMP"/*.exr
  for threads in 1 2 7; do
    pass "$name with $threads threads" \
      "$RAYTRACE" "$scene" -r 64x48 -j $threads \
      --aov depth,normal,object -o "$TMP/$threads.exr"
  done
  pass "$name: 2 threads give the bytes of 1" cmp "$TMP"/{1,2}.exr
  pass "$name: 7 threads give the bytes of 1" cmp "$TMP"/{1,7}.exr
done
test_done
