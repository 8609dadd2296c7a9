#!/usr/bin/env bash
# The pixels of every scene have the SHA-256 of tests/golden/SHA256SUMS from
# gcc and clang, without optimisation and with, for any x86-64 and for those
# with AVX2, with 1, 2 and 7 threads, from both engines and all instruction
# sets.
. "$ROOT/tests/test.sh"

sums=$ROOT/tests/golden/SHA256SUMS
ways=("-j 1" "-j 2" "-j 7" "--isa base -j 2" "--engine notes -j 2")

# same_pixels BUILD WAY
same_pixels()
{
  local options
  read -ra options <<<"$2"
  RAYTRACE=$ROOT/build/$1/raytrace "$ROOT/tests/golden/hash" "${options[@]}" |
    diff "$sums" -
}

export PROGRAMS
for compiler in gcc clang; do
  for level in O0 O2 O3; do
    for machine in "" -v3; do
      build=$compiler-$level$machine
      if [ -n "$machine" ] && ! grep -qw avx2 /proc/cpuinfo; then
        skip "$build: this machine has no AVX2"
        continue
      fi
      pass "$build builds" make -s -C "$ROOT" -j"$(nproc)" BUILD="$build"
      for way in "${ways[@]}"; do
        pass "$build $way: $(wc -l <"$sums") scenes" same_pixels "$build" "$way"
      done
    done
  done
done
test_done
