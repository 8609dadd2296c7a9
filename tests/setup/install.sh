#!/usr/bin/env bash
# make install: the installed tool works from any folder, wherever it is moved
# to; make uninstall takes everything away.
. "$ROOT/tests/test.sh"

make_quietly()
{
  make -s -C "$ROOT" BUILD="$BUILD" PREFIX="/a prefix" DESTDIR="$TMP" "$@"
}

pass "make install" make_quietly install
for file in bin/raytrace lib/libraytrace.so share/man/man1/raytrace.1 \
  share/doc/raytrace/README.md share/doc/raytrace/LICENSE \
  share/raytrace/models/materials.mdl; do
  pass "$file is there" test -s "$TMP/a prefix/$file"
done

cp -r "$TMP/a prefix" "$TMP/moved"
cd "$TMP" || exit
for page in README.md docs/format.md docs/new-object.md; do
  folder=$(dirname "moved/share/doc/raytrace/$page") broken=
  while read -r link; do
    [ -e "$folder/$link" ] || broken+="$link "
  done < <(perl -ne 'while (/\]\(([^)#]+)/g) { print "$1\n" if $1 !~ /:/ }' \
    "moved/share/doc/raytrace/$page")
  same "$broken" "" "the links of the installed $page"
done
pass "the installed scenes are rendered" moved/bin/raytrace --check \
  moved/share/doc/raytrace/scenes/walls.mdl
version=$(sed -n 's/.*RAYTRACE_VERSION "\(.*\)"/\1/p' "$ROOT/src/version.h")
same "$(moved/bin/raytrace --version | head -n 1)" "raytrace $version" \
  "the installed tool runs"
pass "with the library installed beside it" \
  grep -q "$TMP/moved/bin/../lib/libraytrace" <(ldd moved/bin/raytrace)
cat >scene.mdl <<'MDL'
include materials.mdl
camera cam { pixeldim 4 3 worlddim 4 3 viewpoint 2 1.5 4 }
MDL
pass "it finds the installed models" moved/bin/raytrace scene.mdl -o scene.ppm

pass "make uninstall" make_quietly uninstall
same "$(find "$TMP/a prefix" ! -type d)" "" "nothing is left"
test_done
