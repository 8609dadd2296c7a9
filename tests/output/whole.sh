#!/usr/bin/env bash
# A file appears complete or not at all: full disks, signals. Nothing stays
# beside it, and an older file is as it was. Without permission:
# tests/faults/streams.sh.
. "$ROOT/tests/test.sh"
set -m # jobs get SIGINT

cd "$TMP" || exit
cat >pin.mdl <<'MDL'
camera cam { pixeldim 40 30 worlddim 4 3 viewpoint 2 1.5 4 }
material grey { ambient 2 2 2 diffuse .5 .5 .5 specular .3 .3 .3 }
light lamp { location 0 3 3 emissivity 3 3 3 }
sphere ball { material grey center 1 1.5 -2 radius 1 }
sphere drop { material grey center 3 1.5 -2 radius 1 }
MDL
"$RAYTRACE" pin.mdl -o want.exr

# folder_is TEXT WANT FOLDER: the names in the folder, hidden ones too.
folder_is()
{
  same "$(find "$3" -mindepth 1 -printf '%P\n' | sort | tr '\n' ' ')" "$2" "$1"
}

# fails MESSAGE TEXT COMMAND…: status 4 and this message.
fails()
{
  local want=$1 text=$2 status=0
  shift 2
  "$@" >out.txt 2>err.txt || status=$?
  same "$status $(cat out.txt err.txt)" "4 raytrace: $want" "$text"
}

# Places that cannot be written to, noticed before there is a scene
mkdir taken.exr
touch file
for output in taken.exr . .. none/ x.exr/ file/x.exr none/x.exr; do
  case $output in
    taken.exr | . | .. | */) why='Is a directory' ;;
    file*) why='Not a directory' ;;
    *) why='No such file or directory' ;;
  esac
  fails "cannot write '$output': $why" "$output" \
    "$RAYTRACE" none.mdl -o $output
done
folder_is "nothing is made of them" \
  "err.txt file out.txt pin.mdl taken.exr want.exr " .

# in_small_disk SIZE COMMAND…: in a namespace of its own, with such a disk
# (an option of tmpfs) at ./disk.
mkdir disk
in_small_disk()
{
  # shellcheck disable=SC2016
  unshare -m -r bash -c '
    mount -t tmpfs -o "$1" none disk && shift && "$@"' bash "$@"
}
if in_small_disk size=4k true 2>/dev/null; then
  for suffix in exr png ppm; do
    fails "cannot write 'disk/x.$suffix': No space left on device" \
      "a full disk, .$suffix" in_small_disk size=4k \
      "$RAYTRACE" pin.mdl -r 400x300 --samples 2 -o disk/x.$suffix
  done
  # shellcheck disable=SC2016
  in_small_disk size=64k bash -c '
    cp want.exr disk/x.exr
    "$1" pin.mdl -r 400x300 --samples 2 -o disk/x.exr 2>/dev/null
    echo $? && ls -A disk && cmp want.exr disk/x.exr' bash "$RAYTRACE" \
    >disk.txt
  same "$(cat disk.txt)" $'4\nx.exr' \
    "an older file on it is as it was, and nothing else is there"
  fails "cannot write 'disk/x.exr': Read-only file system" \
    "a disk that is read only" in_small_disk size=64k,ro \
    "$RAYTRACE" pin.mdl -o disk/x.exr
else
  skip "a disk of one's own needs unshare"
fi

# A file may not grow beyond 8 blocks.
mkdir limit
cp want.exr limit/old.exr
for name in old new; do
  # shellcheck disable=SC2016
  fails "cannot write 'limit/$name.exr': File too large" \
    "a file that may not grow, $name" \
    bash -c 'ulimit -f 8; exec "$@"' bash \
    "$RAYTRACE" pin.mdl -r 400x300 -o limit/$name.exr
done
pass "the old one is as it was" cmp want.exr limit/old.exr
folder_is "and nothing is beside it" "old.exr " limit

# Signals, at several moments: while the scene is read and while it is
# traced, which takes minutes here.
mkdir signal
cp want.exr signal/old.exr
long=(pin.mdl -r 2000x2000 --samples 1000)
for name in INT:130 TERM:143 HUP:129 KILL:137; do
  for output in new old; do
    for after in 0.02 0.3; do
      status=0
      "$RAYTRACE" "${long[@]}" -o signal/$output.exr >out.txt 2>err.txt &
      sleep $after
      kill -"${name%:*}" $!
      wait $! 2>/dev/null || status=$?
      case $name:$after in
        KILL*) said= ;;
        *) said='raytrace: interrupted' ;;
      esac
      if [ $after = 0.02 ] && [ -z "$(cat err.txt)" ]; then
        said= # it had not begun
      fi
      same "$status $(cat err.txt out.txt)" "${name#*:} $said" \
        "SIG${name%:*} after $after s, $output"
    done
  done
  folder_is "SIG${name%:*} leaves nothing" "old.exr " signal
  pass "SIG${name%:*} leaves the old file as it was" cmp want.exr signal/old.exr
done

# A signal that the caller ignores
(
  trap '' HUP
  "$RAYTRACE" pin.mdl -r 200x200 --samples 9 -o signal/nohup.ppm &
  sleep 0.2
  kill -HUP $!
  wait $!
)
same "$?" 0 "nohup: SIGHUP that is ignored stays ignored"
pass "nohup: the picture is there" test -s signal/nohup.ppm

# While the file is written: to a pipe that nobody empties.
mkfifo pipe
ln -s pipe pipe.ppm
# shellcheck disable=SC2217
sleep 5 <pipe &
reader=$!
status=0
"$RAYTRACE" pin.mdl -r 400x300 -o pipe.ppm 2>err.txt &
sleep 1
kill -INT $!
wait $! || status=$?
same "$status $(cat err.txt)" "130 raytrace: interrupted" \
  "SIGINT while a full pipe is written to"
kill $reader

# While the output is opened: a pipe that nobody reads.
status=0
"$RAYTRACE" pin.mdl -o pipe.ppm 2>err.txt &
sleep 0.3
kill -INT $!
wait $! || status=$?
same "$status $(cat err.txt)" "130 raytrace: interrupted" \
  "SIGINT while a pipe waits for its reader"
test_done
