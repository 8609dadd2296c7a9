# fast.sh - this program; bench/run says what a driver has to define.

fast_install()
{
  [ -x "$tool" ] || fail "$tool is not there: make"
}

fast_prepare() { :; }

# From the NFF file, as the others; what has no NFF from its own.
fast_command()
{
  local scene=$at/$1.nff
  if [ -s "$at/$1.lens" ] || [ ! -s "$scene" ]; then scene=$at/$1.mdl; fi
  command=("$tool" "$scene" -o "$3" -j "$2" -q --stats=json)
  if [ -n "$engine_option" ]; then command+=(--engine fast); fi
}

fast_read() { json "$1"; }
