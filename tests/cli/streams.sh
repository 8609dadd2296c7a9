#!/usr/bin/env bash
# Standard input, output and error: what is written where, and what happens
# when they are closed, full or broken.
. "$ROOT/tests/test.sh"

cd "$TMP" || exit
cat >pin.mdl <<'MDL'
camera cam { pixeldim 300 200 worlddim 3 2 viewpoint 1.5 1 4 }
material grey { ambient 2 2 2 diffuse .5 .5 .5 specular .2 .2 .2 }
light lamp { location 0 3 3 emissivity 1 1 1 }
sphere ball { material grey center 1.5 1 -2 radius 1 }
MDL
"$RAYTRACE" pin.mdl -o file.ppm 2>err.txt >out.txt
same "$? $(cat err.txt out.txt)" "0 " "a picture is written in silence"

"$RAYTRACE" pin.mdl -o - >out.ppm 2>err.txt
same "$? $(cat err.txt)" "0 " "-o - is silent too"
pass "and writes the same PPM to standard output" cmp file.ppm out.ppm
"$RAYTRACE" pin.mdl -o - | cmp - file.ppm
same "$?" 0 "through a pipe too"
mkfifo pipe
cat pipe >from_pipe.ppm &
"$RAYTRACE" pin.mdl -o /dev/stdout >pipe 2>err.txt
same "$? $(cat err.txt)" \
  "2 raytrace: output '/dev/stdout' has an unknown suffix; known are .exr, \
.png and .ppm" "a suffix is wanted of any other name"
wait
ln -s pipe pipe.ppm
cat pipe >from_pipe.ppm &
pass "a named pipe" "$RAYTRACE" pin.mdl -o pipe.ppm
wait
pass "takes the same bytes" cmp from_pipe.ppm file.ppm
pass "and stays a pipe" test -p pipe

# says STATUS MESSAGE: compares with what the last command left.
says()
{
  same "$status $(cat err.txt)" "$1 raytrace: $2" "$3"
}

status=0
"$RAYTRACE" pin.mdl -o - >&- 2>err.txt || status=$?
says 4 "cannot write to standard output: Bad file descriptor" \
  "-o - with standard output closed"
status=0
"$RAYTRACE" --help >&- 2>err.txt || status=$?
says 4 "cannot write to standard output: Bad file descriptor" \
  "--help with standard output closed"
status=0
"$RAYTRACE" pin.mdl -o - >/dev/full 2>err.txt || status=$?
says 4 "cannot write to standard output: No space left on device" \
  "-o - to a full disk"
status=0
"$RAYTRACE" --format-scene pin.mdl >/dev/full 2>err.txt || status=$?
says 4 "cannot write to standard output: No space left on device" \
  "--format-scene to a full disk"
{
  status=0
  "$RAYTRACE" pin.mdl -o - 2>err.txt || status=$?
  echo $status >status.txt
} | head -c 10 >head.txt
status=$(cat status.txt)
says 4 "cannot write to standard output: Broken pipe" "-o - to a broken pipe"
same "$(head -n 1 head.txt)" P6 "whose reader got what it wanted"

rm -f other.ppm
"$RAYTRACE" pin.mdl -o other.ppm <&- >&- 2>&-
pass "a file with all three closed" cmp file.ppm other.ppm
status=0
"$RAYTRACE" none.mdl -o other.ppm <&- >&- 2>&- || status=$?
same $status 4 "an error with all three closed"

# --stats and --progress
"$RAYTRACE" pin.mdl -o - --stats=json 2>json.txt >out.ppm
pass "--stats does not go to standard output" cmp file.ppm out.ppm
n='[0-9]+' s='[0-9]+\.[0-9]{6}'
pass "--stats=json is one object on one line" grep -qE "^\{\"seconds\": \
\{\"load\": $s, \"build\": $s, \"trace\": $s, \"write\": $s\}, \"rays\": \
\{\"eye\": 60000, \"reflection\": $n, \"refraction\": 0, \"feeler\": $n\}, \
\"tests\": $n, \"escapes\": 0, \"compensated\": $n, \"ties\": $n, \
\"critical\": 0, \"unbalanced\": 0, \"rays_per_second\": $n, \
\"nodes\": $n, \
\"nodes_per_ray\": $s, \"tests_per_ray\": $s, \"tree\": \{\"nodes\": $n, \
\"depth\": $n, \"cost\": $s, \"bytes\": $n, \"isa\": \"[a-z0-9]+\"\}\}$" json.txt
same "$(wc -l <json.txt)" 1 "and nothing else"
"$RAYTRACE" -q pin.mdl -o - --stats 2>text.txt >out.ppm
pass "--stats is text" grep -qE '^eye +60000 rays$' text.txt
same "$(wc -l <text.txt)" 19 "of nineteen lines, with -q too"
"$RAYTRACE" --check pin.mdl --stats=json 2>json.txt
pass "--check --stats=json: no rays" grep -q '"eye": 0' json.txt

"$RAYTRACE" pin.mdl -o - --progress bar 2>bar.txt >out.ppm
pass "--progress bar does not go to standard output" cmp file.ppm out.ppm
same "$(tail -c 3 bar.txt)" $'\e[K' "the bar is removed at the end"
for how in auto none; do
  "$RAYTRACE" pin.mdl -o - --progress $how 2>bar.txt >out.ppm
  same "$(cat bar.txt)" "" "--progress $how shows nothing in a pipe"
done
if script -qec true /dev/null </dev/null >/dev/null 2>&1; then
  slow="pin.mdl -o x.ppm -r 1500x1000 --engine notes"
  script -qec "'$RAYTRACE' $slow" /dev/null \
    </dev/null >bar.txt
  pass "on a terminal there is a bar" grep -q '%.*\[.*\]' bar.txt
  script -qec "'$RAYTRACE' -q $slow" /dev/null \
    </dev/null >bar.txt
  same "$(cat bar.txt)" "" "but not with -q"
else
  skip "script is not installed"
fi
test_done
