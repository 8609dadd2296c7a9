# table.awk - shows a result of bench/run on a terminal.

BEGIN { FS = "\t" }

/^#/ { print substr($0, 3); next }
$1 == "scene" {
  print "seconds, medians; ratio: its trace over this program's, with the range"
  printf "%-13s %8s %-11s %2s %8s %7s %7s %8s %7s %7s  %-20s %6s %s\n",
    "scene", "shapes", "program", "j", "trace", "load", "build", "whole",
    "MB", "Mrays", "ratio", "RMS", "picture"
  next
}
{
  rays = ($13 + $14 + $15 + $16) / 1e6
  printf "%-13s %8s %-11s %2d %8.4f %7.4f %7.4f %8.4f %7.1f %7s  " \
    "%-20s %6s %s\n", $1, $2, $3, $4, $5, $8, $9, $10, $12,
    (rays > 0 ? sprintf("%.3f", rays) : "-"),
    ($3 == "fast" ? "" : sprintf("%.2f (%.2f-%.2f)", $20, $21, $22)),
    ($3 == "fast" ? "" : sprintf("%.4f", $17)), ($19 == "ok" ? "" : $19)
}
