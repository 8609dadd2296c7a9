#!/usr/bin/env bash
# The tool refuses to start where doubles are computed otherwise: a library
# that changes the environment before main, flags that change the operations.
. "$ROOT/tests/test.sh"
cd "$TMP" || exit
export ASAN_OPTIONS=$ASAN_OPTIONS:verify_asan_link_order=0

cat >scene.mdl <<'MDL'
camera cam { pixeldim 4 3 worlddim 4 3 viewpoint 2 1.5 4 }
sphere ball { material grey center 2 1.5 -2 radius 1 }
material grey { ambient 2 2 2 }
MDL
pass "the library is made" gcc -shared -fPIC -O1 -o preload.so \
  "$ROOT/tests/arithmetic/preload/preload.c" -lm

# render HOW: with the library and FLOATS=HOW
render()
{
  LD_PRELOAD=$TMP/preload.so FLOATS=$1 "$RAYTRACE" scene.mdl -q -o out.ppm
}

# refused HOW WHY
refused()
{
  status 4 "$1: refused" render "$1"
  same "$(render "$1" 2>&1)" "raytrace: this machine's arithmetic $2: the\
 picture would be another one" "$1: the message says why"
  pass "$1: no file" test ! -e out.ppm
}

pass "the library alone changes nothing" render none
pass "there is a picture" rm out.ppm
for mode in up down zero; do
  refused $mode "does not round to nearest"
done
case $(uname -m) in
  x86_64)
    refused ftz "does not keep the smallest numbers (flush to zero)"
    refused daz "does not read the smallest numbers (denormals are zero)"
    ;;
  *) skip "flush to zero is set for x86-64 only" ;;
esac

# built WANT COMPILER FLAG…: what is said of a program that is built so
built()
{
  same "$("${@:2}" -o probe "$ROOT/tests/arithmetic/probe.c" -lm 2>&1 &&
    ./probe)" "$1" "${*:2}"
}
for compiler in gcc clang-16; do
  for level in -O0 -O1 -O2 -O3; do
    built fine "$compiler" $level -std=gnu11 -ffp-contract=off
  done
done
built "is not that of the compiler, which rounds otherwise" \
  clang-16 -O2 -std=gnu11 -ffp-contract=on
if grep -qw fma /proc/cpuinfo; then
  for compiler in gcc clang-16; do
    built "does not round after every operation" \
      "$compiler" -O2 -std=gnu11 -mfma -ffp-contract=fast
  done
else
  skip "this machine has no fused multiply-add"
fi
built "does not read the smallest numbers (denormals are zero)" \
  gcc -O0 -std=gnu11 -ffp-contract=off -Wl,--whole-archive \
  "$(gcc -print-file-name=crtfastmath.o)" -Wl,--no-whole-archive
test_done
