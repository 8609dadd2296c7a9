#!/usr/bin/env bash
# docs/new-object.md works as it stands: its class, put into a copy of the
# tree, is built by make alone; its scene shows cylinders where they are, with
# the depths and normals of closed forms; its messages are those of the tool.
. "$ROOT/tests/test.sh"

page=$ROOT/docs/new-object.md
copy=$TMP/tree
tool=$copy/build/$BUILD/raytrace

# block TITLE: the code block of the page with that title.
block()
{
  TITLE=$1 perl -ne 'if ($in) { exit 0 if /^```$/; print }
    $in = 1 if /^```\w+ \Q$ENV{TITLE}\E$/; END { $? = !$in }' "$page"
}

# A copy of what make needs, with what it has made already.
mkdir -p "$copy/build/$BUILD" "$copy/tests/docs"
cp -a "$ROOT"/{GNUmakefile,tools,src} "$copy"
cp -a "$ROOT"/tests/{random.h,support.h,test.h,programs.mk} "$copy/tests"
for made in "$ROOT/build/$BUILD"/*; do
  [ "${made##*/}" = tests ] || cp -a "$made" "$copy/build/$BUILD"
done

status 3 "before, a cylinder is an unknown block" \
  "$tool" --check <(block columns.mdl)
for file in src/cylinder_t.h src/cylinder_t.m; do
  block $file >"$copy/$file"
  pass "the page has $file" test -s "$copy/$file"
done
block columns.mdl >"$copy/columns.mdl"
pass "the page has columns.mdl" test -s "$copy/columns.mdl"
pass "make builds it without a warning" make -s -C "$copy" BUILD="$BUILD"

cd "$copy" || exit
pass "the scene has no faults" "$tool" --check columns.mdl
pass "the scene is rendered" "$tool" columns.mdl -r 80x60 -o columns.ppm
"$tool" columns.mdl -r 80x60 -j 7 -o again.ppm
pass "with 7 threads it is the same" cmp columns.ppm again.ppm
pass "its canonical form is read back" "$tool" --format-scene columns.mdl \
  -o formatted.mdl
"$tool" formatted.mdl -r 80x60 -o formatted.ppm
pass "and gives the same picture" cmp columns.ppm formatted.ppm

# The messages of the page.
block broken.mdl >"$TMP/broken" && mv "$TMP/broken" broken.mdl
block "./raytrace --check broken.mdl" >expected
"$tool" --check broken.mdl >found 2>&1
same "$(cat found)" "$(cat expected)" "the page shows the messages there are"
for word in columns.mdl broken.mdl; do
  pass "the page calls raytrace with $word" \
    grep -qE "^    \./raytrace $word|./raytrace --check $word" "$page"
done

# Depths, normals and objects against closed forms.
cat >tests/docs/cylinders.m <<'END'
#import "support.h"
#import "cylinder_t.h"
#import "registry_t.h"
#include "test.h"

/** How far P is from the side, the nearer cap; negative inside of each. */
static void
distances(cylinder_t *c, struct k_vec P, double *side, double *cap, double *h)
{
  struct k_vec v = k_sub(P, c->from);

  *h = k_dot(v, c->axis);
  *side = k_length(k_along(v, -*h, c->axis)) - c->radius;
  *cap = *h < c->height / 2 ? -*h : *h - c->height;
}

static BOOL
is_inside(cylinder_t *c, struct k_vec P)
{
  double side, cap, h;

  distances(c, P, &side, &cap, &h);
  return side < -1e-9 && cap < -1e-9;
}

/** P lies on the surface and N is right there. */
static BOOL
is_on(cylinder_t *c, struct k_vec P, struct k_vec N)
{
  double side, cap, h;
  struct k_vec want = c->axis;

  distances(c, P, &side, &cap, &h);
  if (fabs(side) < 1e-12)
    {
      want = k_unit(k_sub(k_sub(P, c->from), k_scale(c->axis, h)));
    }
  else if (h < c->height / 2)
    {
      want = k_neg(want);
    }
  return fabs(k_max2(side, cap)) < 1e-12
    && k_norm_max(k_sub(N, want)) < 1e-9;
}

int
main(void)
{
  NSAutoreleasePool *pool = [NSAutoreleasePool new];
  NSString *text = [NSString stringWithContentsOfFile: @"columns.mdl"];
  model_t *model = support_model_with(support_options(), text);
  image_t *image;
  unsigned seen[8] = { 0 }, off = 0, through = 0;

  PASS([[registry_t words] containsObject: @"cylinder"], "it is registered");
  [model->camera resizeTo: 80 : 60];
  image = support_picture(model, support_render_options());
  for (unsigned y = 0; y < 60; y++)
    {
      for (unsigned x = 0; x < 80; x++)
        {
          struct surface_pixel s = *[image surfaceAt: x : y];
          struct sample sample = { .column = x, .row = 59 - y };
          struct k_vec o, d;
          [model->camera ray: sample pos: &o dir: &d];
          seen[s.object]++;
          for (cylinder_t *c in model->objects)
            {
              if (![c isKindOfClass: [cylinder_t class]])
                {
                  continue;
                }
              if (c->number == s.object)
                {
                  off += !is_on(c, k_along(o, s.depth, d), s.N)
                    || k_dot(s.N, d) > 0;
                }
              double end = s.depth < 12 ? s.depth : 12;
              for (double t = 0.002; t < end; t += 0.01)
                {
                  through += is_inside(c, k_along(o, t, d));
                }
            }
        }
    }
  PASS(seen[2] > 100 && seen[3] > 50 && seen[4] > 50,
       "the picture shows all three: %u, %u and %u pixels", seen[2], seen[3],
       seen[4]);
  PASS(off == 0, "every hit lies on the cylinder, with its normal");
  PASS(through == 0, "no ray goes through one unseen");

  // The column: axis x = -1.5, z = -1, radius 0.45, from 0 to 2.6.
  struct hit side = support_hit(model, k_vec(-1.5, 1, 4), k_vec(0, 0, -1));
  PASS_NEAR(side.t, 4.55, 1e-15, "the side from the front");
  PASS(k_norm_max(k_sub(side.N, k_vec(0, 0, 1))) < 1e-15, "its normal");
  struct hit edge = support_hit(model, k_vec(-1.77, 1, 4), k_vec(0, 0, -1));
  PASS_NEAR(edge.t, 5 - 0.36, 1e-14, "beside the axis: 3 4 5");
  PASS_NEAR(edge.N.z, 0.8, 1e-14, "its normal");
  struct hit top = support_hit(model, k_vec(-1.4, 5, -1.2), k_vec(0, -1, 0));
  PASS_NEAR(top.t, 2.4, 1e-15, "the top along the axis");
  PASS(k_is_equal(top.N, k_vec(0, 1, 0)), "its normal");
  PASS(support_number(model, k_vec(-1.5, 2.7, 4), k_vec(0, 0, -1)) == 0,
       "above it there is nothing");
  PASS(support_number(model, k_vec(-1.96, 1, 4), k_vec(0, 0, -1)) == 0,
       "beside it there is nothing");

  // The rod is glass: an eye in its middle is in it, and sees its inside.
  cylinder_t *rod = (cylinder_t *)support_object(model, "rod");
  struct k_vec middle = k_along(rod->from, rod->height / 2, rod->axis);
  struct hit wall = support_hit(model, middle, k_vec(0, 1, 0));
  PASS([rod contains: middle], "the middle of the rod is inside");
  PASS(![rod contains: k_vec(0, 2, 0)], "a point above it is not");
  PASS(wall.object == rod, "from there its wall is seen");
  PASS_NEAR(wall.t, rod->radius, 1e-15, "from inside");
  PASS(wall.N.y > 0, "the normal points outwards");
  [pool release];
  return test_done();
}
END
program=build/$BUILD/tests/docs/cylinders
make -s -f tests/programs.mk BUILD="$BUILD" "$program" || cat "$program.log"
while read -r line; do
  case $line in
    ok*) test_line 0 "${line#*- }" ;;
    not*) test_line 1 "${line#*- }" "see tests/docs/new-object.sh" ;;
    '#'*) echo "$line" ;;
    1..*) finished=yes ;;
  esac
done < <("$program")
same "${finished-}" yes "the program that looks at the hits ends"
test_done
