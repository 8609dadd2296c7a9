# embree.sh - the peer on Embree, see bench/embree_peer.cpp.

embree_install()
{
  need libembree-dev /usr/include/embree3/rtcore.h
  need g++ g++
  make -s -f bench/tools.mk || fail "the Embree peer does not build"
}

embree_prepare() { :; }

embree_command()
{
  command=("$bin/embree_peer" "$at/$1.nff" "$3" "$2" $(cat "$at/$1.lens"))
}

embree_read() { json "$1"; }
