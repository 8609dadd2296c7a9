#!/usr/bin/env bash
# SIGKILL in the one moment in which a file has a name that is not its own:
# the old file is whole, and what stays beside it disturbs nobody.
. "$ROOT/tests/test.sh"

cd "$TMP" || exit
case $BUILD in *sanitize* | fuzz | thread*)
  skip "the sanitizers are loaded first or not at all"
  test_done
  exit ;;
esac
cat >pin.mdl <<'MDL'
camera cam { pixeldim 40 30 worlddim 4 3 viewpoint 2 1.5 4 }
material grey { ambient 2 2 2 }
sphere ball { material grey center 1 1.5 -2 radius 1 }
MDL
gcc -shared -fPIC -O1 -o no_rename.so "$ROOT/tests/faults/harness/no_rename.c"
"$RAYTRACE" pin.mdl -r 20x10 -o old.exr
"$RAYTRACE" pin.mdl -o new.exr
mkdir here
cp old.exr here/x.exr

# killed: exit status of a run that is killed before rename
killed()
{
  local status=0
  LD_PRELOAD=./no_rename.so "$RAYTRACE" pin.mdl -o here/x.exr || status=$?
  echo $status
}
same "$(killed 2>/dev/null)" 137 "killed before rename"
pass "the old file is as it was" cmp here/x.exr old.exr
same "$(find here -name '.raytrace-*.tmp' | wc -l)" 1 "one file is beside it"
pass "that is the new one, whole" cmp here/.raytrace-*.tmp new.exr
same "$(killed 2>/dev/null) $(find here -name '.raytrace-*.tmp' | wc -l)" \
  "137 2" "another one gets another name"
status 0 "the next run does not care" "$RAYTRACE" pin.mdl -o here/x.exr
pass "and replaces the old file" cmp here/x.exr new.exr
same "$(find here -name '.raytrace-*.tmp' | wc -l)" 2 "it removes no file of \
others"

# A file that is not there yet has no such moment.
LD_PRELOAD=./no_rename.so "$RAYTRACE" pin.mdl -o here/fresh.exr
pass "a new file is never renamed" cmp here/fresh.exr new.exr
test_done
