# povray.sh - POV-Ray 3.7. Its parse time is the load, its bounding time the
# build, its trace time the trace; it prints them with three decimals.

povray_install() { need povray povray; }

povray_prepare()
{
  "$bin/pov_scene" "$at/$1.nff" $(cat "$at/$1.lens") > "$at/$1.pov"
}

# No antialiasing, no window, no progress, the pixels as they are.
povray_command()
{
  local side
  side=$(awk '$1 == "resolution" { print $2; exit }' "$at/$1.nff")
  command=(povray +I"$at/$1.pov" +O"$3" +FP +W"$side" +H"$side" -D -A -V
    File_Gamma=1 +WT"$2")
}

povray_read()
{
  awk '
    function seconds() { sub(/.*\(/, ""); return $1 }
    /Parse Time:/    { load = seconds() }
    /Bounding Time:/ { build = seconds() }
    /Trace Time:/    { trace = seconds() }
    /^Rays:/             { rays = $2 }
    /^Reflected Rays:/   { reflected = $3 }
    /^Refracted Rays:/   { refracted = $3 }
    /^Shadow Ray Tests:/ { feelers = $4 }
    END {
      print load, build, trace, rays - reflected - refracted, reflected + 0,
        refracted + 0, feelers + 0
    }' "$1"
}
