#!/usr/bin/env bash
# Allocations that fail one by one, from the first of main on: a message and
# status 4, or the same picture without it; never a crash, a hang or half a
# file. With FAULTS=all every allocation.
. "$ROOT/tests/test.sh"

cd "$TMP" || exit
case $BUILD in *sanitize* | fuzz | thread*)
  skip "the sanitizers have an allocator of their own"
  test_done
  exit ;;
esac
echo 'material grey { ambient 2 2 2 diffuse .5 .5 .5 specular .3 .3 .3 }' \
  >grey.mdl
cat >pin.mdl <<'MDL'
include "grey.mdl"
camera cam { pixeldim 9 6 worlddim 4 3 viewpoint 2 1.5 4 }
light lamp { location 0 3 3 emissivity 3 3 3 }
sphere ball { material grey center 1 1.5 -2 radius 1 }
polygon wall { material grey vertex 0 0 -3 vertex 4 0 -3 vertex 4 3 -3 }
MDL
most=60
if [ "${FAULTS-}" = all ]; then
  most=1000000
fi

gcc -shared -fPIC -O1 -o short.so "$ROOT/tests/faults/harness/short.c" -ldl
for engine in fast notes; do
  for suffix in ppm exr; do
    run=("$RAYTRACE" pin.mdl -j 1 --engine $engine -o out.$suffix)
    "${run[@]}" && mv out.$suffix want.$suffix
    FAIL_COUNT=count.txt LD_PRELOAD=./short.so "${run[@]}"
    total=$(cat count.txt) refused=0 without=0 odd=''
    step=$(((total + most - 1) / most))
    for ((n = 1 + RANDOM % step; n <= total; n += step)); do
      rm -f out.$suffix
      status=0
      FAIL_AT=$n LD_PRELOAD=./short.so timeout 10 "${run[@]}" >err.txt 2>&1 ||
        status=$?
      if [ $status = 0 ] && cmp -s out.$suffix want.$suffix; then
        without=$((without + 1))
      elif [ $status = 4 ] && [ -s err.txt ] && ! [ -e out.$suffix ]; then
        refused=$((refused + 1))
      else
        odd+="allocation $n: status $status, $(head -c 200 err.txt)"$'\n'
      fi
    done
    same "$odd" "" "$engine, .$suffix: of $total allocations \
$((refused + without)) failed one at a time: $refused refused, $without done \
without, 0 lost"
    pass "$engine, .$suffix: some were refused" test "$refused" -gt 0
  done
done
test_done
