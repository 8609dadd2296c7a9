#!/usr/bin/env bash
# docs/format.md: its examples are models, it has every attribute and every
# entity, and the message that it shows is told.
. "$ROOT/tests/test.sh"

page=$ROOT/docs/format.md
cd "$TMP" || exit

# The examples between ```SUFFIX and ```, as 1.SUFFIX, 2.SUFFIX …
for suffix in mdl nff; do
  awk -v suffix="$suffix" '
    /^```/ { inside = $0 == "```" suffix; if (inside) n++; next }
    inside { print >(n "." suffix) }' "$page"
done
for example in *.mdl *.nff; do
  pass "example $example is a model" "$RAYTRACE" --check "$example"
done
pass "there are three" test -e 1.mdl -a -e 2.mdl -a -e 1.nff

# Attributes, as the tables of the classes have them.
for class in camera light material plane sphere polygon; do
  section=$(awk -v heading="### $class" '
    /^##/ { inside = $0 == heading } inside' "$page")
  while read -r attribute; do
    pass "$class: $attribute is described" \
      grep -q "^| \`$attribute\` |" <<<"$section"
  done < <(sed -n 's/.*{ \.name = "\([a-z]*\)".*/\1/p' "$ROOT/src/${class}_t.m")
done

cat >ball.mdl <<'MDL'
camera eye { pixeldim 320 240 worlddim 4 3 viewpoint 2 1.5 5 }
material red { ambient 1 .3 .3 }
sphere ball { material red center 2 1 radius 1 }
MDL
"$RAYTRACE" --check ball.mdl 2>message
while IFS= read -r line; do
  pass "the page shows: $line" grep -qF -- "    $line" "$page"
done <message

test_done
