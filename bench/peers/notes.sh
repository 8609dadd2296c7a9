# notes.sh - this program's other engine: the objects of the notes.

notes_install() { fast_install; }
notes_prepare() { :; }

notes_command()
{
  fast_command "$@"
  command+=(--engine notes)
}

notes_read() { json "$1"; }
