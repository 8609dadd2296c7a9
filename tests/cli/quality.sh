#!/usr/bin/env bash
# --quality sets what it says, and what is given itself wins; the rungs cost
# at least twice as much each and are more accurate.
. "$ROOT/tests/test.sh"

cd "$TMP" || exit
scene=$ROOT/scenes/still-life.mdl
lens=$ROOT/scenes/depth-of-field.mdl
small="-q -r 32x24"

# made OPTION…: a picture's bytes
made()
{
  # shellcheck disable=SC2086
  "$RAYTRACE" $small -o out.ppm "$@" && sha256sum <out.ppm
}

same "$(made "$scene" --quality low)" \
  "$(made "$scene" --samples 4 --max-error 1/32)" "low"
same "$(made "$lens" --quality draft)" \
  "$(made "$lens" --samples 1 --exposure 4 --max-error 0.1)" "draft, with a lens"
same "$(made "$scene" --quality high --samples 2)" \
  "$(made "$scene" --samples 2 --max-error 1/255)" "given samples win"
same "$(made "$scene" --max-error 0.5 --quality medium)" \
  "$(made "$scene" --samples 16 --max-error 0.5)" "a given error wins"
said=$("$RAYTRACE" "$scene" --quality best -o x.ppm 2>&1)
same "$?" 2 "no other word: $said"

"$RAYTRACE" --show-quality >ladder.txt
for name in draft low medium high reference; do
  pass "--show-quality tells of $name" grep -q "^$name  *[0-9]" ladder.txt
done
awk '/^(draft|low|medium|high|reference) / {
    if (n++ && ($5 + 0 < 2 * rays || $7 + 0 >= error)) bad = 1
    rays = $5; error = $7
  } END { exit bad || n != 5 }' ladder.txt
same "$?" 0 "each rung costs twice as many rays and is more accurate"
test_done
