#!/usr/bin/env bash
# The pixels of every scene have the SHA-256 of tests/golden/SHA256SUMS on
# 64-bit ARM too, as qemu computes it: from gcc and clang, without
# optimisation and with, with 1, 2 and 7 threads, from both engines.
. "$ROOT/tests/test.sh"

sums=$ROOT/tests/golden/SHA256SUMS
ways=("-j 1" "-j 2" "-j 7" "--engine notes -j 2")

# same_pixels BUILD WAY
same_pixels()
{
  local options
  read -ra options <<<"$2"
  RAYTRACE=$ROOT/build/$1/run "$ROOT/tests/golden/hash" "${options[@]}" |
    diff "$sums" -
}

export PROGRAMS
for compiler in gcc clang; do
  for level in O0 O2 O3; do
    build=arm64-$compiler-$level
    failures=$test_failures
    pass "$build builds" "$ROOT/tools/arm64" "$compiler" "$level"
    if [ "$test_failures" != "$failures" ]; then
      continue
    fi
    same "$(od -An -tx1 -j18 -N2 "$ROOT/build/$build/raytrace")" " b7 00" \
      "$build is for 64-bit ARM"
    for way in "${ways[@]}"; do
      pass "$build $way: $(wc -l <"$sums") scenes" same_pixels "$build" "$way"
    done
  done
done
test_done
