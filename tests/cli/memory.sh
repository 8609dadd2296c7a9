#!/usr/bin/env bash
# Memory that is short: at any moment it is one message and status 4, and no
# file.
. "$ROOT/tests/test.sh"

cd "$TMP" || exit
if [ "$BUILD" = sanitize ]; then
  skip "the sanitizers need all addresses"
  test_done
  exit
fi

cat >pin.mdl <<'MDL'
camera cam { pixeldim 8 6 worlddim 4 3 viewpoint 2 1.5 4 }
material grey { ambient 2 2 2 }
MDL
for ((i = 0; i < 6000; i++)); do
  echo "sphere s$i { material grey center $i 0 0 radius .4 }"
  echo "polygon p$i { material grey vertex $i 0 0 vertex $i 1 0 vertex $i 1 1 }"
done >>pin.mdl

# limited KILOBYTES ARGUMENT…: status and messages, with so much to be had.
limited()
{
  local status=0 limit=$1
  shift
  (ulimit -v "$limit" && exec "$RAYTRACE" "$@") >out.txt 2>err.txt || status=$?
  echo "$status $(cat out.txt err.txt)"
}

# Less than that does not start: the libraries do not fit.
least=60000
until [ "$(limited $least --version | head -c 1)" = 0 ]; do
  least=$((least + 1000))
done

# too_large BYTES ARGUMENT…: refused with that number, in no time.
too_large()
{
  local bytes=$1
  shift
  same "$(limited $((least + 60000)) pin.mdl -r 9000x9000 "$@")" \
    "4 raytrace: not enough memory for 9000 x 9000 pixels: they and their file \
take $bytes bytes, and the program may have $(((least + 60000) * 1024)) in all" \
    "a picture that is too large: $*"
}
too_large 486000000 -o x.ppm
too_large 486000000 -o x.png
too_large 1944000000 -o x.exr
too_large 6804000000 -o x.exr --aov depth,normal,object
too_large 3888000000 -o x.exr --noise .1
too_large 10692000000 -o x.exr --time-limit 1
too_large 2916000000 -o x.exr --max-error .1

# The machine's own memory: pixels that just fit, but not with their file.
side=$(awk '/^MemTotal/ { print int(sqrt(.97 * $2 * 1024 / 12)) }' /proc/meminfo)
said=$(timeout 10 "$RAYTRACE" pin.mdl -r "${side}x$side" -o x.exr 2>&1)
same "$? ${said%%:*}" "4 raytrace" "the machine has less: $said"
pass "with its number" grep -q "take $((side * side * 24)) bytes" <<<"$said"

# A container's, in a namespace with such a limit.
in_container()
{
  # shellcheck disable=SC2016
  unshare -m -r bash -c '
    mount -t tmpfs none /sys/fs/cgroup && mkdir /sys/fs/cgroup/memory &&
    echo "$2" >/sys/fs/cgroup/"$1" && shift 2 && "$@"' bash "$@"
}
if in_container memory.max 1 true 2>/dev/null; then
  for file in memory.max memory/memory.limit_in_bytes; do
    said=$(in_container $file 100000000 "$RAYTRACE" pin.mdl -r 9000x9000 \
      -o x.ppm 2>&1)
    same "$? ${said#*take }" "4 486000000 bytes, and the program may have \
100000000 in all" "a container has less: $file"
  done
  pass "a container without a limit" in_container memory.max max \
    "$RAYTRACE" pin.mdl -o x.ppm
  rm x.ppm
else
  skip "a container of one's own needs unshare"
fi

# From too little to enough.
odd='' enough=0
for ((limit = least; enough < 2 && limit < least + 100000; limit += 500)); do
  said=$(limited $limit pin.mdl -j 1 -r 1000x1000 -o x.ppm)
  case $said in
    "0 ") enough=$((enough + 1)) ;;
    "4 raytrace: not enough memory"* | "4 Virtual memory exhausted"*) ;;
    "4 raytrace: cannot read 'pin.mdl': Cannot allocate memory") ;;
    *) odd+="$limit: $said"$'\n' ;;
  esac
done
same "$odd" "" "too little memory: status 4"
same "$enough" 2 "until it is enough"
rm x.ppm
limited $((least + 2000)) pin.mdl -o x.ppm >/dev/null
pass "no file is left" test -z "$(find . -name '*.ppm' -o -name '.*.tmp')"
test_done
