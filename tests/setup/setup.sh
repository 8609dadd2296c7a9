#!/usr/bin/env bash
# ./raytrace in a tree of its own, with make, apt-get, dpkg-query, id and sudo
# replaced by scripts that note how they were called.
. "$ROOT/tests/test.sh"

tree="$TMP/a tree" bin=$TMP/bin
mkdir -p "$tree/src/kernel" "$tree/tools" "$bin"
cp "$ROOT/raytrace" "$tree"
cp "$ROOT/tools/setup" "$tree/tools"
touch -d "1 hour ago" "$tree"/{GNUmakefile,tools/flags.mk,src/a.m,src/b.m} \
  "$tree/src/kernel" "$tree/src"

stub()
{
  cat >"$bin/$1"
  chmod +x "$bin/$1"
}
stub make <<'END'
#!/bin/sh
echo make >>"$TMP/calls"
if [ -e "$TMP/make-fails" ]; then echo "a.m:1: error"; exit 2; fi
mkdir -p build/default
printf '#!/bin/sh\nprintf "[%%s]" "$@"\nexit 7\n' >build/default/raytrace
chmod +x build/default/raytrace
END
stub apt-get <<'END'
#!/bin/sh
echo "apt-get $*" >>"$TMP/calls"
if [ -e "$TMP/apt-fails" ]; then echo "E: no such archive"; exit 100; fi
END
stub dpkg-query <<'END'
#!/bin/sh
shift 3
for package; do
  case " $MISSING " in
    *" $package "*) ;;
    *) printf '%s:installed ' "$package" ;;
  esac
done
END
stub id <<'END'
#!/bin/sh
echo "$USER_ID"
END
stub sudo <<'END'
#!/bin/sh
exit 1
END

# calls SCENE…: calls ./raytrace, leaves $stdout, $stderr, $calls and $code.
calls()
{
  rm -f "$TMP/calls"
  code=0
  stdout=$(PATH=$bin:$PATH MISSING=${MISSING-} USER_ID=${USER_ID-0} \
    setsid "$tree/raytrace" "$@" 2>"$TMP/stderr") || code=$?
  stderr=$(<"$TMP/stderr")
  calls=$(cat "$TMP/calls" 2>/dev/null) || true
}

calls "a b" -o - ""
same "$calls" make "the first call builds"
same "$stdout" "[a b][-o][-][]" "stdout and arguments are the tool's"
same "$code" 7 "so is the exit status"
same "$stderr" "raytrace: building (less than a minute, once)" \
  "it says that it builds"

calls x
same "$calls" "" "the second call goes straight to the tool"

sleep 0.02
touch "$tree/src/a.m"
calls x
same "$calls$stderr" make "a changed file is built, without a word"
sleep 0.02
rm "$tree/src/b.m"
calls x
same "$calls" make "a removed file makes it build"
sleep 0.02
touch -d "1 hour ago" "$tree/src/kernel/old.c"
calls x
same "$calls" make "so does an added one, however old"
sleep 0.02
touch "$tree/tools/flags.mk"
calls x
same "$calls" make "so do other flags"
calls x
same "$calls" "" "and then it is settled"

ln -s "$tree/raytrace" "$TMP/link"
stdout=$("$TMP/link" y) || true
same "$stdout" "[y]" "a symbolic link to it works"

sleep 0.02
touch "$tree/src/a.m" "$TMP/make-fails"
calls x
same "$code $stdout" "5 " "a failed build: status 5, nothing on stdout"
same "$stderr" $'a.m:1: error\nraytrace: the build failed' "and why"
rm "$TMP/make-fails"
calls x
same "$calls" make "the next call tries again"

rm -r "$tree/build"
MISSING="gobjc nettle-dev" calls x
same "$(grep -c "^apt-get .*install .*gobjc nettle-dev$" <<<"$calls")" 1 \
  "what is missing is installed, and nothing else"
pass "it says what" grep -q "installing.*: gobjc nettle-dev$" <<<"$stderr"

rm -r "$tree/build"
touch "$TMP/apt-fails"
MISSING=gobjc calls x
same "$code" 5 "apt-get fails: status 5"
pass "it shows the log" grep -q "E: no such archive" <<<"$stderr"
same "$(tail -n 1 <<<"$stderr")" \
  "raytrace: apt-get could not install: gobjc" "and says so"

MISSING=gobjc USER_ID=1000 calls x
same "$code $calls" "5 " "without rights nothing is tried"
same "$stderr" \
  "raytrace: to be installed first, as root: apt-get install gobjc" \
  "but said in one line"
USER_ID=1000 calls x
same "$stdout" "[x]" "and nothing is needed when nothing is missing"
test_done
