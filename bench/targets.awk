# targets.awk - holds a result of bench/run against what was set out to
# reach. A wrong picture does not count, nor one that was less work.

BEGIN { FS = "\t" }

/^#/ || $1 == "scene" { next }
$19 == "WRONG" { wrong = wrong " " $1 "/" $3; next }
$19 == "no-refraction" { next }
{
  row[$1, $3, $4] = 1
  trace[$1, $3, $4] = $5; load[$1, $3, $4] = $8; build[$1, $3, $4] = $9
  whole[$1, $3, $4] = $10; memory[$1, $3, $4] = $12; ratio[$1, $3, $4] = $20
  if ($4 > most) most = $4
  if ($3 == "fast") scenes[++n] = $1 SUBSEP $4
}

function tell(what, goal, has, isMet) {
  printf "%-58s %-12s %-24s %s\n", what, goal, has,
    isMet == "" ? "" : isMet ? "met" : "NOT MET"
}
function least(program, j,    i, part, best) {
  best = ""
  for (i = 1; i <= n; i++) {
    split(scenes[i], part, SUBSEP)
    if (part[2] == j && ((part[1], program, j) in row) \
        && (best == "" || ratio[part[1], program, j] < best)) {
      best = ratio[part[1], program, j]
      where = part[1]
    }
  }
  return best
}
function mean(program, j,    i, part, sum, m) {
  for (i = 1; i <= n; i++) {
    split(scenes[i], part, SUBSEP)
    if (part[2] == j && ((part[1], program, j) in row) \
        && ratio[part[1], program, j] > 0) {
      sum += log(ratio[part[1], program, j]); m++
    }
  }
  return m ? exp(sum / m) : 0
}

END {
  j = most
  printf "\n%-58s %-12s %-24s\n", "target", "at least", "is"
  split("povray tachyon", peer, " ")
  for (p = 1; p <= 2; p++)
    if ((v = least(peer[p], j)) != "")
      tell("trace against " peer[p] ", slowest scene", "10",
           sprintf("%.2f (%s)", v, where), v >= 10)
  for (t = 1; t <= most; t++)
    if ((v = least("embree", t)) != "") {
      tell("trace against embree, " t " thread(s), geometric mean", "1.5",
           sprintf("%.2f", mean("embree", t)), mean("embree", t) >= 1.5)
      tell("trace against embree, " t " thread(s), slowest scene", "1",
           sprintf("%.2f (%s)", v, where), v >= 1)
    }
  if (("flake6", "fast", j) in row) {
    mine = whole["flake6", "fast", j]
    if (("flake6", "povray", j) in row)
      tell("whole process, 597,871 spheres, against povray", "6",
           sprintf("%.2f", whole["flake6", "povray", j] / mine),
           whole["flake6", "povray", j] / mine >= 6)
    if (("flake6", "tachyon-nff", j) in row) {
      v = whole["flake6", "tachyon-nff", j] / mine
      tell("the same against tachyon from NFF", "6", sprintf("%.2f", v),
           v >= 6)
      v = load["flake6", "tachyon-nff", j] / load["flake6", "fast", j]
      tell("load of that NFF against tachyon", "1.7",
           sprintf("%.2f (%.3f s)", v, load["flake6", "fast", j]), v >= 1.7)
      tell("memory, MB: under 200 and under tachyon's", "< 200",
           sprintf("%.0f (tachyon %.0f)", memory["flake6", "fast", j],
                   memory["flake6", "tachyon-nff", j]),
           memory["flake6", "fast", j] < 200 && memory["flake6", "fast", j] \
             < memory["flake6", "tachyon-nff", j])
    }
    if (("flake6", "embree", j) in row) {
      v = build["flake6", "embree", j] / build["flake6", "fast", j]
      tell("build of its tree against embree", "2",
           sprintf("%.2f (%.3f s)", v, build["flake6", "fast", j]), v >= 2)
    }
    if (("flake4", "fast", j) in row) {
      v = trace["flake6", "fast", j] / trace["flake4", "fast", j]
      tell("growth of trace, 7,381 to 597,871 spheres", "< 2.2",
           sprintf("%.2f", v), v < 2.2)
    }
  }
  for (i = 1; i <= n; i++) {
    split(scenes[i], part, SUBSEP)
    if (part[2] == 2 && ((part[1], "fast", 1) in row)) {
      v = trace[part[1], "fast", 1] / trace[part[1], "fast", 2]
      if (slowest == "" || v < slowest) { slowest = v; where = part[1] }
    }
  }
  if (slowest != "")
    tell("2 threads against 1, worst scene", "1.95",
         sprintf("%.2f (%s)", slowest, where), slowest >= 1.95)
  if (("flake7", "fast", j) in row)
    tell("5,380,840 spheres, memory in MB", "< 4096",
         sprintf("%.0f", memory["flake7", "fast", j]),
         memory["flake7", "fast", j] < 4096)
  if (("cbox", "notes", j) in row)
    tell("the notes' engine on cbox: times the fast one's", "",
         sprintf("%.1f", ratio["cbox", "notes", j]), "")
  if (wrong != "") print "wrong pictures, not counted:" wrong
}
