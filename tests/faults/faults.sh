#!/usr/bin/env bash
# Kills at random moments of each phase of a run: never half a file or a lost
# old one. A run is stopped first and asked which phase it is in, so that as
# many as are wanted are killed in each: two, and with FAULTS=all 25, which
# makes a hundred of each signal.
. "$ROOT/tests/test.sh"
set -m # jobs get SIGINT

cd "$TMP" || exit
kills=2 spheres=100000
if [ "${FAULTS-}" = all ]; then
  kills=25
fi
if [ "$BUILD" = sanitize ]; then
  spheres=20000
fi
{
  cat <<'MDL'
camera cam { pixeldim 9 6 worlddim 4 3 viewpoint 2 1.5 4 }
material grey { ambient 2 2 2 diffuse .5 .5 .5 specular .3 .3 .3 }
light lamp { location 0 3 3 emissivity 3 3 3 }
polygon wall { material grey vertex 0 0 -3 vertex 4 0 -3 vertex 4 3 -3 }
MDL
  awk -v n=$spheres 'BEGIN {
    for (i = 0; i < n; i++)
      printf "sphere s%d { material grey center %.3f %.3f %.3f radius .01 }\n",
        i, 4 * rand(), 3 * rand(), -3 * rand()
  }'
} >many.mdl
mkdir old

# One thread, messages that tell where it is, and time between all that is done
# to a file.
slow=
case $BUILD in *sanitize* | fuzz | thread*) ;; # are loaded first or not at all
  *) gcc -shared -fPIC -O1 -o slow.so "$ROOT/tests/faults/harness/slow_disk.c" \
    -ldl && slow=$PWD/slow.so ;;
esac
run=(env LD_PRELOAD="$slow" "$RAYTRACE" many.mdl -j 1 -r 1000x800 --max-depth 0
  --no-shadows -v --progress bar)
declare -A seconds
for suffix in exr ppm; do # packing takes long, or writing
  "$RAYTRACE" many.mdl -o want.$suffix
  "${run[@]}" --stats=json -o new.$suffix 2>err.txt
  for name in load build trace write; do
    seconds[$name.$suffix]=$(sed -nE "s/.*\"$name\": ([0-9.]+).*/\1/p" err.txt)
  done
done

# in_phase PID: sets phase to the one that it is in. The scene is told of when
# it is loaded; the bar has a thread while there is tracing and is cleared at
# its end.
in_phase()
{
  local said tasks=("/proc/$1/task/"*)
  said=$(<err.txt)
  if [ ${#tasks[@]} -gt 1 ]; then
    phase=trace
  elif [[ $said == *$'\e[K' ]]; then
    phase=write
  elif [ -n "$said" ]; then
    phase=build
  else
    phase=load
  fi
}

# kill_in PHASE SIGNAL STATUS SUFFIX: a run, at a random moment after the phase
# has begun. Sets phase to the one that it was killed in, "" for none.
kill_in()
{
  local status pid file=old/out.$4
  cp want.$4 $file
  : >err.txt
  "${run[@]}" -o $file 2>err.txt &
  pid=$!
  until ! [ -e /proc/$pid/exe ] || { in_phase $pid && [ $phase = "$1" ]; }; do
    sleep 0.001
  done
  sleep "$(awk -v most="${seconds[$1.$4]}" -v part=$RANDOM \
    'BEGIN { print most * part / 32768 }')"
  kill -STOP $pid 2>/dev/null
  in_phase $pid
  kill -"$2" $pid 2>/dev/null
  kill -CONT $pid 2>/dev/null
  status=147
  while [ $status = 147 ]; do # that it was stopped
    status=0
    wait $pid 2>/dev/null || status=$?
  done
  if [ $status = 0 ]; then
    phase=
  elif [ $status != "$3" ]; then
    lost+="$1: status $status $(tail -c 200 err.txt)"$'\n'
  fi
  cmp -s $file want.$4 || cmp -s $file new.$4 ||
    lost+="$1: neither the old nor the new $file"$'\n'
}

# kill_some SIGNAL STATUS
kill_some()
{
  local suffixes=(exr ppm)
  local name tries phase lost='' told='' few='' hidden=0
  local -A killed=([load]=0 [build]=0 [trace]=0 [write]=0)
  for name in load build trace write; do
    for ((tries = 0; killed[$name] < kills && tries < 10 * kills; tries++)); do
      kill_in $name "$1" "$2" "${suffixes[tries % 2]}"
      if [ -n "$phase" ]; then killed[$phase]=$((killed[$phase] + 1)); fi
      hidden=$((hidden + $(find old -name '.raytrace-*' | wc -l)))
      rm -f old/.raytrace-*
    done
    told+=" ${killed[$name]} in $name,"
    [ "${killed[$name]}" -ge $kills ] || few+="$name "
  done
  same "$lost" "" "SIG$1:$told 0 lost"
  same "$few" "" "SIG$1: at least $kills in each"
  if [ "$1" != KILL ]; then
    same "$hidden" 0 "SIG$1: nothing is beside it"
  else
    pass "SIGKILL: at most one hidden file each ($hidden)" \
      test "$hidden" -le "${killed[write]}"
  fi
}
kill_some INT 130
kill_some TERM 143
kill_some KILL 137
test_done
