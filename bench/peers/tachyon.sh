# tachyon.sh - Tachyon, from its own format, in which it can be told the
# angle and the materials. Parsing is the load, preprocessing the build. It
# does not count rays.

tachyon_install() { need tachyon tachyon; }

tachyon_prepare() { "$bin/tachyon_scene" "$at/$1.nff" > "$at/$1.dat"; }

# As deep as the others, highlights as theirs, clear things without shadow.
tachyon_command()
{
  command=(tachyon "$at/$1.dat" -fullshade -raydepth 6 -numthreads "$2"
    -shade_phong -shadow_filter_off -format PPM -o "$3")
}

tachyon_read()
{
  tr '\r' '\n' < "$1" | awk '
    /Scene Parsing Time:/ { load = $4 }
    /Preprocessing Time:/ { build = $3 }
    /Ray Tracing Time:/   { trace = $4 }
    END { print load, build, trace, 0, 0, 0, 0 }'
}
