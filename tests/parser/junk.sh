#!/usr/bin/env bash
# Files that are no models, some of them very large: located messages, soon,
# and never a crash.
. "$ROOT/tests/test.sh"

cd "$TMP" || exit

# refused FILE FIRST-LINE TEXT: exit status 3 within 60 s, and what the first
# line of the messages starts with.
refused()
{
  local status=0 first
  timeout 60 "$RAYTRACE" --check "$1" >out 2>err || status=$?
  first=$(head -n 1 err)
  same "$status $(head -c ${#2} <<<"$first")" "3 $2" "$3"
  if [ "$(wc -l <err)" -gt 200 ] || [ "$(wc -c <err)" -gt 50000 ]; then
    pass "$3: not too long" false
  fi
}

megabytes=25
if [ "$BUILD" = sanitize ]; then
  megabytes=5
fi

# fill FILE TEXT: as many copies of it
fill()
{
  yes -- "$2" | head -c "${megabytes}M" >"$1"
}

: >empty.mdl
refused empty.mdl "empty.mdl:1:1: error: expected a camera" "an empty file"
head -c 100000 "$RAYTRACE" >program.mdl
refused program.mdl "program.mdl:1:" "a program"
printf '\377\376c\0' >utf16.mdl
refused utf16.mdl "utf16.mdl:1:1: error: expected text in UTF-8" "UTF-16"
refused /dev/zero "/dev/zero:1:1: error: expected text in UTF-8" "zeros for ever"
refused /dev/null "/dev/null:1:1: error: expected a camera" "nothing"
mkfifo pipe
yes 'sphere {' | head -c 100000 >pipe &
refused pipe "pipe:1:8: error: expected a name" "a pipe"
wait

fill words.mdl 'junk and more junk'
refused words.mdl "words.mdl:1:1: error: unknown keyword 'junk'" \
  "$megabytes MB of words"
fill blocks.mdl 'x{}'
refused blocks.mdl "blocks.mdl:1:1: error: unknown keyword 'x'" \
  "$megabytes MB of unknown blocks"
fill cameras.mdl 'camera c { pixeldim 0 0 }'
refused cameras.mdl "cameras.mdl:1:1: error: expected viewpoint" \
  "$megabytes MB of faulty cameras"
fill includes.mdl 'include none'
refused includes.mdl "includes.mdl:1:9: error: expected a file" \
  "$megabytes MB of missing includes"
fill open.mdl '{'
refused open.mdl "open.mdl:1:1: error: expected a keyword" \
  "$megabytes MB of opening braces"
fill close.mdl '}'
refused close.mdl "close.mdl:1:1: error: expected a block" \
  "$megabytes MB of closing braces"
{ printf 'sphere s { '; yes 'raduis 1' | head -c "${megabytes}M"; } >one.mdl
refused one.mdl "one.mdl:1:12: error: unknown attribute 'raduis'" \
  "$megabytes MB of attributes in one block"
yes 1 | head -c "${megabytes}M" | tr -d '\n' >word.mdl
refused word.mdl "word.mdl:1:1: error: unknown keyword" \
  "a word of $megabytes MB"
{ printf 'sphere s { radius '; cat word.mdl; } >number.mdl
refused number.mdl "number.mdl:1:" "a number of $megabytes MB"
fill nff.nff 's 1 2'
refused nff.nff "nff.nff:1:1: error: expected an f" "$megabytes MB of bad NFF"
head -c "${megabytes}M" /dev/urandom >random.mdl
refused random.mdl "random.mdl:" "$megabytes MB of random bytes"
base64 -w 0 random.mdl | head -c "${megabytes}M" >base64.mdl
refused base64.mdl "base64.mdl:1:1: error: unknown keyword" \
  "$megabytes MB in base 64"
tr -dc ' -~\n' <random.mdl >printable.mdl
refused printable.mdl "printable.mdl:" "random printable characters"

test_done
