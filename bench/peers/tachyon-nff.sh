# tachyon-nff.sh - Tachyon as its reader of NFF understands the scene:
# mirrored, with light of its own. For the load and the whole process.

tachyon-nff_install() { tachyon_install; }
tachyon-nff_prepare() { :; }

tachyon-nff_command()
{
  tachyon_command "$@"
  command[1]=$at/$1.nff
}

tachyon-nff_read() { tachyon_read "$1"; }
