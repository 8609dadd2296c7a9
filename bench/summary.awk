# summary.awk - from the lines of bench/run to one line for each scene,
# program and number of threads: medians, and the ratio to this program.
# usage: awk -f summary.awk PICTURES RAW > RESULT.tsv

BEGIN { OFS = "\t" }

# PICTURES: scene program RMS off
FNR == NR { rms[$1, $2] = $3; off[$1, $2] = $4; next }

$2 == "shapes" { shapes[$3] = $4; clear[$3] = $5; next }

# RAW: scene program threads round whole processor memory status
#      load build trace eye reflection refraction feeler
$4 == 0 { next }
{
  key = $1 SUBSEP $2 SUBSEP $3
  if (!(key in count)) order[++keys] = key
  i = ++count[key]
  whole[key, i] = $5; memory[key, i] = $7
  load[key, i] = $9; build[key, i] = $10; trace[key, i] = $11
  cpu[key, i] = $6
  rays[key] = $12 OFS $13 OFS $14 OFS $15
}

# The value a share of the way up the sorted values of key; sets lowest and
# highest as well.
function median(values, key,    n, i, j, v, sorted) {
  n = count[key]
  for (i = 1; i <= n; i++) {
    v = values[key, i]
    for (j = i; j > 1 && sorted[j - 1] > v; j--) sorted[j] = sorted[j - 1]
    sorted[j] = v
  }
  lowest = sorted[1]; highest = sorted[n]
  return n % 2 ? sorted[(n + 1) / 2] : (sorted[n / 2] + sorted[n / 2 + 1]) / 2
}

# Each round's ratio: the runs of a round follow each other.
function ratios(values, key, ours,    i) {
  for (i = 1; i <= count[key]; i++)
    ratio[key, i] = values[ours, i] > 0 ? values[key, i] / values[ours, i] : 0
}

# Tachyon has no refraction: a clear scene is less work for it. Read from NFF
# its light is another, and the rays through a lens are where chance put them.
function verdict(scene, program,    most) {
  if (!((scene, program) in rms)) return "-"
  if (program ~ /^tachyon/ && clear[scene]) return "no-refraction"
  most = program == "notes" ? 0 : program == "tachyon-nff" ? 0.2 : \
    scene ~ /^lens/ ? 0.05 : program == "embree" ? 0.01 : 0.04
  return rms[scene, program] > most ? "WRONG" : "ok"
}

END {
  print "scene", "shapes", "program", "threads", "trace", "trace_min",
    "trace_max", "load", "build", "whole", "processor", "memory_mb", "eye",
    "reflection", "refraction", "feeler", "rms", "off", "picture", "ratio",
    "ratio_min", "ratio_max", "whole_ratio"
  for (k = 1; k <= keys; k++) {
    key = order[k]
    split(key, part, SUBSEP)
    ours = part[1] SUBSEP "fast" SUBSEP part[3]
    t = median(trace, key); low = lowest; high = highest
    ratios(whole, key, ours); w = median(ratio, key)
    ratios(trace, key, ours); r = median(ratio, key)
    rlow = lowest; rhigh = highest
    isOurs = part[2] == "fast"
    print part[1], shapes[part[1]], part[2], part[3], t, low, high,
      median(load, key), median(build, key), median(whole, key),
      median(cpu, key), sprintf("%.1f", median(memory, key) / 1024), rays[key],
      isOurs ? 0 : rms[part[1], part[2]], isOurs ? 0 : off[part[1], part[2]],
      isOurs ? "ok" : verdict(part[1], part[2]), sprintf("%.3f", r),
      sprintf("%.3f", rlow), sprintf("%.3f", rhigh), sprintf("%.3f", w)
  }
}
