#!/usr/bin/env bash
# Standard files that are closed, full or slow, and what may not be read or
# written: the exit status is right, the picture whole or not there, and
# nothing hangs.
. "$ROOT/tests/test.sh"

cd "$TMP" || exit
cat >pin.mdl <<'MDL'
camera cam { pixeldim 40 30 worlddim 4 3 viewpoint 2 1.5 4 }
material grey { ambient 2 2 2 diffuse .5 .5 .5 specular .3 .3 .3 }
light lamp { location 0 3 3 emissivity 3 3 3 }
sphere ball { material grey center 1 1.5 -2 radius 1 }
MDL
echo 'bogus x { }' >bad.mdl

# with FILES COMMAND…: the exit status, with such redirections (no message of
# the shell's own), 124 after 20 s.
with()
{
  local status=0 files=$1
  shift
  bash -c "exec timeout 20 \"\$@\" $files" bash "$@" >out.txt 2>err.txt ||
    status=$?
  echo $status
}

for suffix in ppm exr png; do
  "$RAYTRACE" pin.mdl -o want.$suffix
  for files in '0<&-' '1>&-' '2>&-' '0<&- 1>&- 2>&-' '2>/dev/full' \
    '1>/dev/full' '1>&- 2>/dev/full'; do
    rm -f out.$suffix
    same "$(with "$files" "$RAYTRACE" pin.mdl -v --stats --progress bar \
      -o out.$suffix)" 0 ".$suffix, $files: done"
    pass ".$suffix, $files: the picture is whole" cmp out.$suffix want.$suffix
  done
done
rm -f out.*

# Faults of the user's keep their status when nobody is told.
for files in '2>&-' '2>/dev/full'; do
  same "$(with "$files" "$RAYTRACE" bad.mdl -o x.ppm)" 3 "a bad scene, $files"
  same "$(with "$files" "$RAYTRACE" --nope)" 2 "a bad option, $files"
  same "$(with "$files" "$RAYTRACE" none.mdl -o x.ppm)" 4 "no scene, $files"
  same "$(with "$files" "$RAYTRACE" pin.mdl -o no/x.ppm)" 4 "no folder, $files"
done

# What goes to standard output is a failure when it does not get there.
for files in '1>&-:Bad file descriptor' '1>/dev/full:No space left on device'
do
  for what in '--help' '--version' '--show-quality' 'pin.mdl -o -' \
    'pin.mdl --plan' 'pin.mdl --explain 3,3' 'pin.mdl --format-scene'; do
    read -ra arguments <<<"$what"
    same "$(with "${files%%:*}" "$RAYTRACE" "${arguments[@]}") \
$(cat err.txt)" \
      "4 raytrace: cannot write to standard output: ${files#*:}" \
      "$what, ${files%%:*}"
  done
done

# A reader that is slow and one that leaves
status=0
"$PROGRAMS/faults/slow_pipe" 400 "$RAYTRACE" pin.mdl -r 400x300 -o - \
  >slow.ppm || status=$?
same "$status" 0 "a pipe that is full and does not block"
"$RAYTRACE" pin.mdl -r 400x300 -o - >fast.ppm
pass "gets all of the picture" cmp slow.ppm fast.ppm
pass "which is larger than a pipe" test "$(stat -c %s fast.ppm)" -gt 70000
timeout 20 "$RAYTRACE" pin.mdl -r 400x300 -o - 2>err.txt | head -c 10 >head.txt
same "${PIPESTATUS[0]} $(cat err.txt)" \
  "4 raytrace: cannot write to standard output: Broken pipe" \
  "a reader that leaves"

# Without permission. Root has it always, but for these capabilities.
plain=()
if [ "$(id -u)" = 0 ]; then
  plain=(setpriv --bounding-set '-dac_override,-dac_read_search')
fi
touch nothing && chmod 000 nothing
if "${plain[@]}" cat nothing 2>/dev/null; then
  skip "permissions do not hold here"
  test_done
  exit
fi
# refuses MESSAGE TEXT COMMAND…
refuses()
{
  local status=0 want=$1 text=$2
  shift 2
  "${plain[@]}" "$@" >out.txt 2>err.txt || status=$?
  same "$status $(head -n 1 out.txt err.txt -q)" "$want" "$text"
}
cp pin.mdl shut.mdl && chmod 000 shut.mdl
refuses "4 raytrace: cannot read 'shut.mdl': Permission denied" \
  "a scene without permission" "$RAYTRACE" shut.mdl -o x.ppm
{ cat pin.mdl; echo 'include shut.mdl'; } >outer.mdl
refuses "3 outer.mdl:5:9: error: expected a file to include, 'shut.mdl' \
cannot be read: Permission denied" \
  "an included file without permission" "$RAYTRACE" outer.mdl -o x.ppm
mkdir closed && cp pin.mdl closed && chmod 000 closed
refuses "4 raytrace: cannot read 'closed/pin.mdl': Permission denied" \
  "a scene in a folder without permission" "$RAYTRACE" closed/pin.mdl -o x.ppm
pass "no file is made" test ! -e x.ppm
mkdir locked && cp want.exr locked/old.exr && chmod 555 locked
for name in old new; do
  refuses "4 raytrace: cannot write 'locked/$name.exr': Permission denied" \
    "a folder that is read only, $name" "$RAYTRACE" pin.mdl -o locked/$name.exr
done
same "$(ls -A locked)" old.exr "nothing is made of them"
pass "the old one is as it was" cmp want.exr locked/old.exr
cp want.exr mine.exr && chmod 444 mine.exr
refuses "4 raytrace: cannot write 'mine.exr': Permission denied" \
  "a file that is read only" "$RAYTRACE" pin.mdl -o mine.exr
pass "is as it was" cmp want.exr mine.exr
chmod 755 closed locked
test_done
