#!/usr/bin/env bash
# Every scene has the sum of pixels that tests/golden/SHA256SUMS has: from gcc
# and clang, at -O0, -O2 and -O3, for any x86-64 and for x86-64-v3, from both
# engines, with 1, 2 and 7 threads. Takes long: it makes twelve builds.
. "$ROOT/tests/test.sh"

hash=$ROOT/build/$BUILD/tests/golden/exrhash
cd "$ROOT" || exit

# sums BUILD ENGINE THREADS: as in SHA256SUMS.
sums()
{
  local scene
  while read -r _ scene; do
    RAYTRACE=$ROOT/build/$1/raytrace tests/golden/render "$scene" \
      "$TMP/one.exr" --engine "$2" -j "$3"
    echo "$("$hash" "$TMP/one.exr") $scene"
  done <tests/golden/SHA256SUMS
}

pass "there are sums" test "$(wc -l <tests/golden/SHA256SUMS)" -gt 10
marches=(x86-64)
if grep -qw avx2 /proc/cpuinfo && grep -qw bmi2 /proc/cpuinfo; then
  marches+=(x86-64-v3)
else
  skip "this machine cannot run x86-64-v3"
fi
for compiler in gcc clang-16; do
  for level in 0 2 3; do
    for march in "${marches[@]}"; do
      name=matrix-$compiler-O$level-$march
      pass "$name builds without a warning" make -s -j"$(nproc)" \
        BUILD="$name" CC=$compiler OPT="-O$level -march=$march"
      for engine in fast notes; do
        for threads in 1 2 7; do
          same "$(sums "$name" $engine $threads)" \
            "$(cat tests/golden/SHA256SUMS)" "$name, $engine, -j $threads"
        done
      done
      rm -rf "build/$name"
    done
  done
done
test_done
