#!/usr/bin/env bash
# --help and the man page tell the truth: they name the same options, and the
# tool knows them all.
. "$ROOT/tests/test.sh"

cd "$TMP" || exit
page=$ROOT/docs/raytrace.1

"$RAYTRACE" --help >help.txt 2>err.txt
same "$? $(cat err.txt)" "0 " "--help succeeds and is on standard output"
"$RAYTRACE" -h | cmp - help.txt
same "$?" 0 "-h is the same"
same "$(awk 'length > 79' help.txt)" "" "no line is longer than 79"
pass "it says how to call it" grep -q '^usage: raytrace .*SCENE -o FILE$' \
  help.txt

names=$(sed -nE 's/^  (-.,|   ) --([a-z-]+).*/\2/p' help.txt | sort)
pass "--help names them" test "$(wc -w <<<"$names")" -gt 20
same "$(sed -nE 's/^\.It .*Fl -([a-z-]+).*/\1/p' "$page" | sort)" "$names" \
  "the man page names the same"
for name in $names; do
  said=$("$RAYTRACE" "--$name=" 2>&1 >/dev/null)
  same "${said/unknown/}" "$said" "the tool knows --$name"
done

# What an option takes is in its help: the tool tells its words.
for name in $names; do
  words=$("$RAYTRACE" "--$name=?" 2>&1 |
    sed -nE "s/, (not|with commas) .*//; s/.* takes (one|some) of //p")
  text=$(tr -s ' \n' ' ' <help.txt | sed -E "s/.* --${name}[ =[]/ /; s/ --.*//")
  for word in ${words//,/}; do
    pass "--help says that --$name takes $word" grep -qwe "$word" <<<"$text"
  done
done

letters=$(sed -nE 's/^  -(.), .*/\1/p' help.txt | sort)
same "$(sed -nE 's/^\.It Fl (.)[ ,].*/\1/p' "$page" | sort)" "$letters" \
  "the man page names the same letters"
for letter in $letters; do
  said=$("$RAYTRACE" "-$letter" 2>&1 >/dev/null)
  same "${said/unknown/}" "$said" "the tool knows -$letter"
done

for status in 0 2 3 4 130; do
  pass "--help tells exit status $status" \
    grep -qE "(^|[ ,:])$status [a-z]" help.txt
  pass "the man page tells exit status $status" grep -q "^.It $status$" "$page"
done

same "$("$RAYTRACE" --version | head -1)" \
  "raytrace $(sed -n 's/.*_VERSION "\(.*\)"/\1/p' "$ROOT/src/version.h")" \
  "--version"
pass "which names the instructions" \
  grep -qE '^instructions of the fast engine: (avx2|base)$' \
  <("$RAYTRACE" --version)
same "$("$RAYTRACE" --help --version nonsense.mdl)" "$(cat help.txt)" \
  "--help before anything else"

if command -v mandoc >/dev/null; then
  same "$(mandoc -Tlint "$page")" "" "mandoc finds no fault in the man page"
else
  skip "mandoc is not installed"
fi
test_done
