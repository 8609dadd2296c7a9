#!/usr/bin/env bash
# What the pages name exists: links, files, methods, functions and options;
# and the calls of raytrace in README.md work as they stand.
. "$ROOT/tests/test.sh"
cd "$ROOT" || exit
shopt -s nullglob

pages=(README.md docs/*.md)
folders='src|docs|scenes|models|tests|tools|bench'

# links PAGE: prints links that lead nowhere, or to no heading.
links()
{
  perl -CSD -Mutf8 -e '
    my ($page) = @ARGV;
    (my $folder = $page) =~ s{[^/]*$}{};
    sub text { my $t = ""; open my $f, "<:utf8", $_[0] or return; local $/; <$f> }
    # The name that a heading has as the target of a link.
    sub anchors {
      my %seen;
      my $t = text(shift);
      $t =~ s/^```.*?^```//gms;
      for ($t =~ /^#+ +(.*)$/gm) {
        my $a = lc; $a =~ s/[^\w\- ]//g; $a =~ tr/ /-/; $seen{$a} = 1;
      }
      \%seen
    }
    my $text = text($page);
    $text =~ s/^```.*?^```//gms;
    my $bad = 0;
    while ($text =~ /\]\(([^)\s]+)\)|(?:src|href)="([^"]+)"/g) {
      my $link = $1 // $2;
      next if $link =~ /^https?:/;
      my ($file, $anchor) = split /#/, $link, 2;
      my $target = length $file ? "$folder$file" : $page;
      1 while $target =~ s{[^/]+/\.\./}{};
      my $ok = -e $target && (!$anchor || anchors($target)->{$anchor});
      print("$link\n"), $bad = 1 unless $ok;
    }
    exit $bad' "$1"
}

# names PAGE: prints names in `…` that are in no source: `src/x.m`, `src/x.m
# -method:`, `src/x.h function`, `-method:with:`.
names()
{
  FOLDERS=$folders perl -CSD -Mutf8 -e '
    sub text { open my $f, "<:utf8", $_[0] or return ""; local $/; <$f> }
    # All methods that a file declares or defines, as `-name:with:`.
    sub methods {
      my (%all, $t);
      $t = text(shift);
      while ($t =~ /^([-+]) \([^)]*\)\s*([^;{]*)/gm) {
        my ($sign, $rest) = ($1, $2);
        $rest =~ s/__attribute__.*//s;
        my $name = "";
        if ($rest =~ /:/) {
          $name .= "$1:" while $rest =~ /(\w*)\s*:\s*\([^)]*\)\s*\w+/g;
        } else {
          ($name) = $rest =~ /(\w+)/;
        }
        $all{"$sign$name"} = 1;
      }
      \%all
    }
    my %everywhere;
    for my $file (glob "src/*.h src/*.m docs/new-object.md") {
      $everywhere{$_} = 1 for keys %{methods($file)};
    }
    # The page makes a class of its own.
    my $page = text($ARGV[0]);
    my %made = map { $_ => 1 } $page =~ /^```\w+ (\S+)$/gm;
    $page =~ s/^```.*?^```//gms;
    my $bad = 0;
    while ($page =~ /`([^`\n]+(?:\n[^`\n]+)?)`/g) {
      (my $name = $1) =~ s/\s+/ /g;
      if ($name =~ m{^((?:$ENV{FOLDERS})/[^\s*…]*)(?: ([-+]?[\w:]+))?$}) {
        my ($file, $what) = ($1, $2);
        next if $made{$file};
        my $ok = -e $file;
        if ($ok && defined $what) {
          $ok = $what =~ /^[-+]/ ? methods($file)->{$what}
            : text($file) =~ /\b\Q$what\E\b/;
        }
        print("$name\n"), $bad = 1 unless $ok;
      } elsif ($name =~ /^[-+][a-z]\w*:[\w:]*$/) {
        print("$name\n"), $bad = 1 unless $everywhere{$name};
      }
    }
    exit $bad' "$1"
}

# options PAGE: prints options that neither raytrace nor our scripts have.
options()
{
  local option bad=0
  while read -r option; do
    if ! grep -qF -- "$option" "$TMP/options"; then
      echo "$option"
      bad=1
    fi
  done < <(perl -ne 'next if /apt-get|make |git /;
    print "$1\n" while /(?<![\w-])(--[a-z][a-z-]+)/g' "$1" | sort -u)
  return $bad
}

"$RAYTRACE" --help >"$TMP/options"
sed -sn '2,20p' check tests/run tests/fuzz/run >>"$TMP/options"

pass "there are pages" test ${#pages[@]} -gt 4
for page in "${pages[@]}"; do
  pass "links of $page" links "$page"
  pass "names in $page" names "$page"
  pass "options in $page" options "$page"
done

# A raytrace beside the scenes that makes small pictures, and everything else
# that a command of the README may ask for.
place=$TMP/place
mkdir "$place"
for name in models scenes docs tests; do ln -s "$ROOT/$name" "$place/$name"; done
cat >"$place/raytrace" <<'END'
#!/bin/sh
exec "$RAYTRACE" "$@" -r 32x24 # the last -r holds
END
chmod +x "$place/raytrace"
export RAYTRACE

# The command blocks of the README that call raytrace with a scene.
mkdir "$TMP/blocks"
BLOCKS=$TMP/blocks perl -e '
  my ($n, $block) = (0, "");
  sub done {
    if ($block =~ m{^\./raytrace (?!SCENE)}m) {
      open my $f, ">", sprintf "$ENV{BLOCKS}/%02d", ++$n or die;
      print $f $block;
    }
    $block = "";
  }
  while (<>) { if (s/^    +//) { $block .= $_ } elsif (/\S/) { done() } }
  done()' README.md
blocks=("$TMP"/blocks/*)
pass "README.md calls raytrace" test ${#blocks[@]} -gt 0
run_block()
{
  cd "$place" && bash -euo pipefail "$1"
}
for block in "${blocks[@]}"; do
  pass "README.md: $(grep -m 1 raytrace "$block")" run_block "$block"
done

# The scene of the README, and the mistakes in it.
sed -n '/^    camera eye /,/^    sphere ball /s/^    //p' README.md \
  >"$place/ball.mdl"
cd "$place" || exit
pass "the scene of README.md is rendered" ./raytrace ball.mdl -o ball.ppm
sed -i 's/location 0 4 3/location 0 4/; s/material red  /material rde  /' ball.mdl
same "$("$RAYTRACE" --check ball.mdl 2>&1)" \
  "$(sed -n '/^    ball.mdl:/,/^$/s/^    //p' "$ROOT/README.md")" \
  "README.md shows the messages there are"
test_done
