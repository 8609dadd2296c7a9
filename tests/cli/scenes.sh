#!/usr/bin/env bash
# Scenes that cannot be read, or have faults; --check and --format-scene.
. "$ROOT/tests/test.sh"

cd "$TMP" || exit
cat >good.mdl <<'MDL'
camera cam { pixeldim 8 6 worlddim 4 3 viewpoint 2 1.5 4 }
material grey { ambient 2 2 2 }
sphere ball { material grey center 2 1.5 -2 radius 1 }
MDL
sed 's/grey center/gray center/' good.mdl >bad.mdl
mkdir folder

# says STATUS MESSAGE ARGUMENT…: no output, this on standard error.
says()
{
  local want="$1 $2" status=0
  shift 2
  "$RAYTRACE" "$@" >out.txt 2>err.txt || status=$?
  same "$status $(cat out.txt err.txt)" "$want" "$*"
}

for how in '-o x.exr' --check --format-scene; do
  # shellcheck disable=SC2086
  says 4 "raytrace: cannot read 'none.mdl': No such file or directory" \
    none.mdl $how
  # shellcheck disable=SC2086
  says 4 "raytrace: cannot read 'folder': Is a directory" folder $how
  # shellcheck disable=SC2086
  says 4 "raytrace: cannot read 'good.mdl/x': Not a directory" good.mdl/x $how
  status=0
  # shellcheck disable=SC2086
  "$RAYTRACE" bad.mdl $how >out.txt 2>err.txt || status=$?
  same "$status $(cat out.txt; head -n 1 err.txt)" "3 bad.mdl:3:24: error: \
unknown material 'gray' for sphere 'ball'; did you mean 'grey'?" \
    "a fault, $how"
  # shellcheck disable=SC2086
  "$RAYTRACE" -q bad.mdl $how 2>&1 | cmp -s - err.txt
  same "$?" 0 "the same with -q, $how"
done
pass "no file is made" test ! -e x.exr

says 0 "" --check good.mdl
says 0 "" --check good.mdl -o x.exr
pass "--check makes no file" test ! -e x.exr

"$RAYTRACE" --format-scene good.mdl >canonical.mdl 2>err.txt
same "$? $(cat err.txt)" "0 " "--format-scene, to standard output"
pass "what it writes is a scene" "$RAYTRACE" --check canonical.mdl
says 0 "" --format-scene good.mdl -o canonical-2.mdl
pass "the same to a file of any name" cmp canonical.mdl canonical-2.mdl
"$RAYTRACE" --format-scene canonical.mdl | cmp - canonical.mdl
same "$?" 0 "canonical form stays as it is"
"$RAYTRACE" good.mdl -o good.ppm
"$RAYTRACE" canonical.mdl -o canonical.ppm
pass "and gives the same picture" cmp good.ppm canonical.ppm

# The plan: all that the scene has, and no picture.
"$RAYTRACE" --plan good.mdl -j 3 --isa base >plan.txt 2>err.txt
same "$? $(cat err.txt)" "0 " "--plan, to standard output"
line()
{
  pass "the plan says: $1" grep -qxF -- "$1" plan.txt
}
line "picture   8 x 6 pixels, 48 traced, 1 ray through each"
line "shapes    1 sphere"
line "lights    0"
line "media     0"
line "tree      1 node, 1 deep"
line "left out  shadow feelers (no light); mirror rays and highlights \
(nothing specular); refraction and media (nothing transparent); the \
polygons' view along each ray (no polygon); lens samples (pinhole)"
pass "the plan says what a picture takes" grep -qE '^memory    [0-9]+ bytes for'\
' the scene, 144 for a picture of 8 bits, 576 for an \.exr$' plan.txt
line "rays      about 48: 48 eye, 0 reflection, 0 refraction, 0 feeler"
line "threads   3, instructions base"
pass "the largest picture is planned as soon" timeout 20 "$RAYTRACE" --plan \
  good.mdl -r 1000000x1000000
same "$("$RAYTRACE" --plan good.mdl -r 1000000x1000000 | grep ^rays)" \
  "rays      about 1e+12: 1e+12 eye, 0 reflection, 0 refraction, 0 feeler" \
  "from a part of it"

# Where included files are looked for
mkdir parts
echo 'material paint { ambient 1 1 1 }' >parts/paint.inc
{
  cat good.mdl
  echo 'include paint.inc'
} >user.mdl
status 3 "an included file is not found" "$RAYTRACE" --check user.mdl
pass "-I finds it" "$RAYTRACE" -I parts --check user.mdl
pass "so does the second of two" "$RAYTRACE" -I . -I parts --check user.mdl
says 4 "raytrace: cannot include from 'none': No such file or directory" \
  --check -I parts -I none user.mdl
says 4 "raytrace: cannot include from 'good.mdl': Not a directory" \
  -I good.mdl good.mdl -o x.exr
pass "no file is made" test ! -e x.exr

# Pipes and standard input
says 0 "" --check - <good.mdl
pass "- includes from the folder it is called in" "$RAYTRACE" -I parts \
  --check - <user.mdl
says 0 "" --check /dev/stdin <good.mdl
says 0 "" --check <(cat good.mdl)
says 0 "" --check <(sleep 0.3; head -n 1 good.mdl
  sleep 0.3; tail -n 2 good.mdl)
says 4 "raytrace: cannot read '-': Is a directory" --check - <folder
mkfifo pipe
{ sleep 0.3; cat good.mdl >pipe; } &
says 0 "" --check pipe
wait
sleep 4 >pipe & # a writer that says nothing
sleep 0.1
timeout 3.5 "$RAYTRACE" --check pipe >out.txt 2>err.txt
same "$?" 124 "a pipe waits for its writer"
wait
says 4 "raytrace: cannot read 'pipe': Nobody writes to this pipe" --check pipe
for name in pipe /dev/zero /dev/null; do # allowed, and still no files
  { cat good.mdl; echo "include $name"; } >odd.mdl
  says 3 "odd.mdl:4:9: error: expected a file to include, '$name' cannot be \
read: Not an ordinary file
   4 | include $name
     |         ^" --check -I /dev odd.mdl
done

# NFF, whatever its suffix is written with
printf '%s\n' v 'from 2 1 5' 'at 0 0 0' 'up 0 1 0' 'angle 40' \
  'resolution 8 6' >view.nff
for name in VIEW.NFF View.Nff; do
  cp view.nff $name
  says 0 "" --check $name
done

# Other names
cp good.mdl 'größe und "mehr".mdl'
for locale in C C.UTF-8; do
  rm -f 'Bild ü.exr'
  LC_ALL=$locale "$RAYTRACE" 'größe und "mehr".mdl' -o 'Bild ü.exr'
  pass "names in UTF-8, locale $locale" test -s 'Bild ü.exr'
done
says 4 "raytrace: cannot read 'nichts ü.mdl': No such file or directory" \
  --check 'nichts ü.mdl'

"$RAYTRACE" -v good.mdl -o x.exr 2>err.txt
same "$(cat err.txt)" \
  "raytrace: 'good.mdl': 1 object, 0 lights, 8 x 6 pixels" \
  "-v tells what was read"
echo 'light l { location 0 0 0 emissivity 1 1 1 }' >>user.mdl
"$RAYTRACE" -v -I parts user.mdl -r 5x4 -o x.exr 2>err.txt
same "$(cat err.txt)" \
  "raytrace: 'user.mdl': 1 object, 1 light, 5 x 4 pixels" \
  "and of the picture's size"
test_done
