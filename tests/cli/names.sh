#!/usr/bin/env bash
# Names of files are what the system makes of them: nothing in them but a
# slash separates, and nothing is a pattern or a format. And a scene is not
# written over by its own picture.
. "$ROOT/tests/test.sh"

mkdir "$TMP/here" && cd "$TMP/here" || exit
cat >scene.mdl <<'MDL'
camera cam { pixeldim 4 3 worlddim 4 3 viewpoint 2 1.5 4 }
include "part.mdl"
sphere ball { material grey center 1 1.5 -2 radius 1 }
MDL
echo 'material grey { ambient 2 2 2 }' >part.mdl
"$RAYTRACE" scene.mdl -o want.ppm
cp want.ppm ../want.ppm

names=('a\b' 'C:x' '~' '~root' '@a' '%s%n%@' 'a b' $'a\nb' '*' "q'q" '-')
for name in "${names[@]}"; do
  for file in "$name.ppm" "./$name.ppm"; do
    case $file in -*) continue ;; esac
    rm -f ./*.ppm
    for again in new old; do
      status 0 "$again, $file" "$RAYTRACE" scene.mdl -o "$file"
      pass "$again, $file is there" cmp ../want.ppm "$file"
    done
    same "$(find . -maxdepth 1 -name '*.ppm' -printf '%P,') $(find . -name '.?*' | wc -l)" \
      "$name.ppm, 0" "$file and nothing else"
  done
  mkdir "./$name" && cp scene.mdl part.mdl "./$name"
  status 0 "a scene in $name" "$RAYTRACE" "./$name/scene.mdl" -o "./$name/x.ppm"
  pass "its picture is there" cmp ../want.ppm "./$name/x.ppm"
  cp part.mdl "./$name.inc"
  cat scene.mdl >"./$name.mdl"
  sed -i '2d' "./$name.mdl"
  printf 'include "%s.inc"\n' "$name" >>"./$name.mdl"
  case $name in *$'\n'*) continue ;; esac      # a path ends with its line
  status 0 "includes $name.inc" "$RAYTRACE" "./$name.mdl" -o "../x.ppm"
done
rm -f ./*.ppm

# The scene as its own output: refused, by whatever name.
cp scene.mdl scene.ppm
ln -s scene.mdl link.ppm
ln scene.mdl hard.png
for pair in scene.ppm:scene.ppm scene.mdl:link.ppm scene.mdl:hard.png \
  link.ppm:../here/link.ppm; do
  said=$("$RAYTRACE" "${pair%:*}" -o "${pair#*:}" 2>&1)
  same "$? $said" \
    "2 raytrace: output '${pair#*:}' is the scene itself" "$pair is refused"
done
pass "the scene is as it was" cmp scene.ppm scene.mdl
same "$(grep -c camera scene.mdl)" 1 "and not empty"
said=$("$RAYTRACE" - -o scene.ppm <scene.ppm 2>&1)
same "$? $said" "2 raytrace: output 'scene.ppm' is the scene itself" \
  "on standard input too"
said=$("$RAYTRACE" scene.mdl -o - 2>&1 >>scene.mdl)
same "$? $said" "2 raytrace: output '-' is the scene itself" \
  "and on standard output"
cp scene.mdl ./-
"$RAYTRACE" - -o - <scene.mdl >../dash.ppm
pass "a file of the name - is neither" cmp ../want.ppm ../dash.ppm
rm ./-
pass "the scene is as it was" cmp scene.ppm scene.mdl
status 0 "in canonical form it may be" "$RAYTRACE" scene.mdl --format-scene \
  -o scene.mdl
pass "and is a scene still" "$RAYTRACE" scene.mdl --check
test_done
