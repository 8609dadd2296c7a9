# shellcheck shell=bash
# render.sh - how a golden picture is made, for run.sh and update.

# golden_render SCENE OUT: small, with what each eye ray hit, few lens rays.
golden_render()
{
  "$RAYTRACE" -q -r 64x48 --exposure 4 --aov depth,normal,object "$1" -o "$2"
}
