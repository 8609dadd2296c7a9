#!/usr/bin/env bash
# Every option, right and wrong: what it says, how it exits. A wrong command
# line is one line on standard error, nothing on standard output, status 2,
# and no file.
. "$ROOT/tests/test.sh"

cd "$TMP" || exit
cat >pin.mdl <<'MDL'
camera cam { pixeldim 8 6 worlddim 4 3 viewpoint 2 1.5 4 }
material grey { ambient 2 2 2 diffuse .5 .5 .5 }
light lamp { location 0 3 3 emissivity 1 1 1 }
sphere ball { material grey center 2 1.5 -2 radius 1 }
MDL
{
  grep -v camera pin.mdl
  echo 'camera cam { pixeldim 8 6 worlddim 4 3 viewpoint 2 1.5 4'
  echo '  focus 6 fstop 8 exposure 2 }'
} >lens.mdl

# wrong MESSAGE ARGUMENT…
wrong()
{
  local message=$1 status=0
  shift
  "$RAYTRACE" "$@" >out.txt 2>err.txt || status=$?
  same "$status: $(cat out.txt err.txt)" "2: raytrace: $message" "$*"
}

# right ARGUMENT…: traces in silence.
right()
{
  local status=0
  rm -f ok.exr
  "$RAYTRACE" -o ok.exr "$@" >out.txt 2>&1 || status=$?
  [ -s ok.exr ] || status="$status, no file"
  same "$status: $(cat out.txt)" "0: " "$*"
}

# Names
wrong "unknown option '--treads'; did you mean '--threads'?" --treads 4
wrong "unknown option '--crpo'; did you mean '--crop'?" --crpo=0,0,1,1
wrong "unknown option '--xyzzy'" --xyzzy
wrong "unknown option '-Z'" -Z
wrong "unknown option '-Z'" -qZ
wrong "unknown option '--thread'; did you mean '--threads'?" --thread 4
wrong "unknown option '--out'; did you mean '--output'?" --out x.exr
wrong "unknown option '--form'; did you mean '--format-scene'?" --form
wrong "unknown option '--res'; did you mean '--resolution'?" --res=8x6
wrong "unknown option '--sample'; did you mean '--samples' or '--sampler'?" \
  --sample 4
wrong "unknown option '--s'; did you mean '--show-quality', '--samples', '--sampler', '--seed' \
or '--stats'?" --s
wrong "unknown option '--'" --=4
wrong "no scene given; see 'raytrace --help'"
wrong "no scene given; see 'raytrace --help'" -o x.exr
wrong "one scene at a time, not 'a' and 'b'" a b
wrong "one scene at a time, not '--check' and '-q'" -- --check -q
wrong "unknown option '--Check'; did you mean '--check'?" --Check

# Values
whole='a whole number from'
wrong "option '--output' needs a FILE" pin.mdl -o
wrong "option '--output' takes a FILE, not ''" pin.mdl -o ''
wrong "option '--include-path' needs a DIR" pin.mdl -I
wrong "option '--include-path' takes a DIR, not ''" pin.mdl --include-path=
wrong "option '--threads' needs $whole 0 to 1024" -j
wrong "option '--threads' needs $whole 0 to 1024" -qj
for bad in x 1025 -1 +1 1.5 1e2 0x4 ' 1' '1 ' '' 99999999999999999999; do
  wrong "option '--threads' takes $whole 0 to 1024, not '$bad'" \
    "--threads=$bad" pin.mdl
done
wrong "option '--samples' takes $whole 1 to 1000000, not '0'" --samples 0
wrong "option '--exposure' takes $whole 1 to 1000000000, not '0'" --exposure 0
wrong "option '--max-depth' takes $whole 0 to 1000000, not '1000001'" \
  --max-depth 1000001
huge=18446744073709551616
wrong "option '--seed' takes $whole 0 to 18446744073709551615, not '$huge'" \
  --seed $huge
for bad in 64 64x 64X48 x48 0x48 64x0 64x48x2 64,48 1000001x1 64x-1; do
  wrong "option '--resolution' takes WxH, whole numbers from 1 to 1000000, \
not '$bad'" -r "$bad"
done
for bad in 1,2,3 1,2,3,4,5 a 1,2,3,-4 1,2,3,4x; do
  wrong "option '--crop' takes X0,Y0,X1,Y1, whole numbers from 0 to 1000000, \
not '$bad'" --crop "$bad"
done
for bad in 0,0,0,0 3,0,3,5 5,0,3,5 0,4,8,4; do
  wrong "option '--crop' takes X0,Y0,X1,Y1 with X0 < X1 and Y0 < Y1" \
    --crop $bad pin.mdl -o x.exr
done
for bad in 0,0,9,6 0,0,8,7 8,0,9,6; do
  wrong "option '--crop' goes beyond the picture of 8 x 6 pixels" \
    --crop $bad pin.mdl -o x.exr
done
wrong "option '--sampler' takes one of owen, random, \
stratified, grid, not 'gird'; \
did you mean 'grid'?" --sampler gird
wrong "option '--sampler' takes one of owen, random, \
stratified, grid, not 'sobol'" \
  --sampler sobol
wrong "option '--engine' takes one of fast, notes, not 'slow'" --engine slow
wrong "option '--isa' takes one of best, avx2, base, not 'sse9'" --isa sse9
wrong "option '--polygon-test' takes one of crossings, edges, angles, not \
'edge'; did you mean 'edges'?" --polygon-test edge
wrong "option '--progress' takes one of auto, bar, none, not 'on'" \
  --progress on
wrong "option '--stats' takes one of none, text, json, not 'xml'" --stats=xml
for bad in '' 'depth,' ,depth depth,objekt 'depth normal' all depth,depth \
  object,depth,object; do
  wrong "option '--aov' takes some of depth, normal, object, error.truncation, with commas \
between and each once, not '$bad'" --aov "$bad"
done
for flag in check format-scene plan quiet verbose help version; do
  wrong "option '--$flag' takes no value, but got 'yes'" --$flag=yes
done
wrong "argument 2 is not UTF-8" pin.mdl $'\xff'

# What does not go together
wrong "no output given: -o FILE, or -o - for standard output" pin.mdl
for bad in x.jpg x x.exrx exr /dev/null; do
  wrong "output '$bad' has an unknown suffix; known are .exr, .png and .ppm" \
    pin.mdl -o $bad
done
for bad in x.png x.ppm -; do
  wrong "option '--aov' needs an output in .exr" pin.mdl --aov depth -o $bad
done
wrong "sampler grid takes a square number of samples (1, 4, 9, 16 ...), \
not 8" pin.mdl --sampler grid --samples 8 -o x.exr
for pair in '--check --format-scene' '--check --plan' \
  '--format-scene --plan' '--plan --explain=0,0'; do
  read -ra both <<<"$pair"
  wrong "options '--check', '--format-scene', '--plan' and '--explain' exclude \
each other" pin.mdl "${both[@]}"
done
for n in 1 4; do
  wrong "option '--noise' finds the number of rays itself: without '--samples' \
and '--exposure'" pin.mdl --noise .1 --samples $n -o x.exr
done
for bad in stratified grid; do
  wrong "option '--noise' takes the samplers owen and random" \
    pin.mdl --noise .1 --sampler $bad -o x.exr
done
wrong "option '--confidence' needs '--noise' or '--time-limit'" pin.mdl --confidence .9 -o x.exr
wrong "option '--max-samples' needs '--noise'" pin.mdl --max-samples 99 \
  -o x.exr
wrong "option '--exposure' needs a camera with a lens: focus, fstop, exposure" \
  pin.mdl --exposure 4 -o x.exr
same "$(ls)" "$(printf '%s\n' err.txt lens.mdl out.txt pin.mdl)" \
  "a wrong command line leaves no file"

# What is right
right pin.mdl
right -- pin.mdl
right -r 5x4 pin.mdl
right -r5x4 pin.mdl
right --resolution=1x1 pin.mdl
right -j 0 pin.mdl
right -j1 pin.mdl
right --threads 7 pin.mdl
right --seed 18446744073709551615 pin.mdl
right --max-depth 0 pin.mdl
right --max-depth=1000000 pin.mdl
right --samples 3 pin.mdl
right --samples 9 --sampler grid pin.mdl
right --sampler random pin.mdl
right --sampler owen --samples 3 lens.mdl
right --sampler stratified --samples 3 lens.mdl
right --noise 1/8 --confidence .9 lens.mdl
right -q --time-limit .05 --confidence .9 lens.mdl
right --noise .1 --sampler random --max-samples 100 pin.mdl
right --exposure 3 lens.mdl
right --crop 0,0,8,6 pin.mdl
right --crop 7,5,8,6 pin.mdl
right --aov depth pin.mdl
right --aov object,depth,normal pin.mdl
right --engine notes pin.mdl
right --engine fast pin.mdl
right --isa base pin.mdl
right --isa best pin.mdl
right --polygon-test crossings pin.mdl
right --polygon-test edges pin.mdl
right --polygon-test angles pin.mdl
right -I . pin.mdl
right -I . --include-path=.. pin.mdl
right --progress auto pin.mdl
right --progress none pin.mdl
right --stats=none pin.mdl
right -q pin.mdl
right -qj2 pin.mdl

"$RAYTRACE" -r 3x3 --resolution 5x4 pin.mdl -o x.exr -o last.ppm
same "$(head -c 10 last.ppm)" "$(printf 'P6\n5 4\n255')" \
  "of an option given twice the last one holds"
pass "and the first file is not made" test ! -e x.exr
test_done
