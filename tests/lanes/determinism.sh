#!/usr/bin/env bash
# Every scene gives the same bytes, colours, depths, normals and object
# numbers, with 1, 2 and 7 threads, from both engines, with every instruction
# set; and the same numbers of what happened near the edge.
. "$ROOT/tests/test.sh"

# What is compared with one thread of the fast engine.
declare -A ways=(
  ["2 threads"]="-j 2"
  ["7 threads"]="-j 7"
  ["the notes engine"]="--engine notes"
  ["the base instructions"]="--isa base"
)

# render SCENE OUT OPTION...
render()
{
  "$RAYTRACE" "$1" -q -r 64x48 --aov depth,normal,object -o "$2" "${@:3}" \
    --stats=json 2>"$TMP/stats.json" &&
    grep -o '"escapes".*"unbalanced": [0-9]*' "$TMP/stats.json" >"$2.edges"
}

# same_bytes SCENE OPTION...: renders the bytes of one.exr.
same_bytes()
{
  rm -f "$TMP/other.exr"
  render "$1" "$TMP/other.exr" "${@:2}" && cmp "$TMP"/{one,other}.exr &&
    cmp "$TMP"/{one,other}.exr.edges
}

mapfile -t scenes < <(scene_files)
pass "there are scenes" test ${#scenes[@]} -gt 0
for scene in "${scenes[@]}"; do
  name=${scene#"$ROOT"/}
  pass "$name with 1 thread" render "$scene" "$TMP/one.exr" -j 1
  for way in "${!ways[@]}"; do
    read -ra options <<<"${ways[$way]}"
    pass "$name: $way: the same bytes" same_bytes "$scene" "${options[@]}"
  done
done
test_done
