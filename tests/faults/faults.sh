#!/usr/bin/env bash
# Kills at random moments of a run: never half a file or a lost old one. With
# FAULTS=all a hundred of each signal.
. "$ROOT/tests/test.sh"
set -m # jobs get SIGINT

cd "$TMP" || exit
cat >pin.mdl <<'MDL'
camera cam { pixeldim 9 6 worlddim 4 3 viewpoint 2 1.5 4 }
material grey { ambient 2 2 2 diffuse .5 .5 .5 specular .3 .3 .3 }
light lamp { location 0 3 3 emissivity 3 3 3 }
sphere ball { material grey center 1 1.5 -2 radius 1 }
polygon wall { material grey vertex 0 0 -3 vertex 4 0 -3 vertex 4 3 -3 }
MDL
kills=8
if [ "${FAULTS-}" = all ]; then
  kills=100
fi

# kill_some SIGNAL STATUS: at moments spread over the whole run
mkdir old
"$RAYTRACE" pin.mdl -o old/out.exr && cp old/out.exr want.exr
"$RAYTRACE" pin.mdl -r 500x400 -o new.exr
kill_some()
{
  local i status lost='' hidden=0 killed=0
  for ((i = 0; i < kills; i++)); do
    cp want.exr old/out.exr
    status=0
    "$RAYTRACE" pin.mdl -r 500x400 -o old/out.exr >err.txt 2>&1 &
    sleep "0.$(printf %03d $((RANDOM % 200)))"
    kill -"$1" $! 2>/dev/null || true
    wait $! 2>/dev/null || status=$?
    if [ $status = "$2" ]; then killed=$((killed + 1)); fi
    if [ $status != "$2" ] && [ $status != 0 ]; then
      lost+="kill $i: status $status $(cat err.txt)"$'\n'
    fi
    cmp -s old/out.exr want.exr || cmp -s old/out.exr new.exr ||
      lost+="kill $i: neither the old nor the new file"$'\n'
    hidden=$((hidden + $(find old -name '.raytrace-*' | wc -l)))
    rm -f old/.raytrace-*
  done
  same "$lost" "" "SIG$1: $kills at random moments, $killed in time, 0 lost"
  if [ "$1" != KILL ]; then
    same "$hidden" 0 "SIG$1: nothing is beside it"
  else
    pass "SIGKILL: at most one hidden file each ($hidden)" \
      test "$hidden" -le "$kills"
  fi
}
kill_some INT 130
kill_some TERM 143
kill_some KILL 137
test_done
