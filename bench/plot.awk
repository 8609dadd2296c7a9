# plot.awk - draws time against size: the trace of the sphere flake, both
# axes logarithmic, as SVG. usage: awk -f plot.awk RESULT.tsv > RESULT.svg

BEGIN {
  FS = "\t"
  wide = 720; high = 480; left = 80; right = 140; top = 50; bottom = 60
  split("fast embree povray tachyon", programs, " ")
  split("#c0392b #2471a3 #1e8449 #7d6608", colors, " ")
  names["fast"] = "raytrace"; names["embree"] = "Embree peer"
  names["povray"] = "POV-Ray"; names["tachyon"] = "Tachyon"
}

/^# (commit|machine)/ { note = note (note ? "; " : "") substr($0, 3) }
/^#/ || $1 == "scene" { next }
$4 > most { most = $4 }
$1 ~ /^flake/ && $19 != "WRONG" {
  key = $3 SUBSEP $4
  i = ++count[key]
  size[key, i] = $2; value[key, i] = $5
  if (least == "" || $5 < least) least = $5
  if ($5 > worst) worst = $5
  if (small == "" || $2 < small) small = $2
  if ($2 > large) large = $2
}

function log10(v) { return log(v) / log(10) }
function floor(v) { return int(v) - (v < int(v)) }
function x(v) {
  return left + (wide - left - right) * (log10(v) - x0) / (x1 - x0)
}
function y(v) {
  return high - bottom - (high - top - bottom) * (log10(v) - y0) / (y1 - y0)
}
function words(px, py, anchor, what, color) {
  printf "<text x=\"%.1f\" y=\"%.1f\" text-anchor=\"%s\" " \
    "fill=\"%s\">%s</text>\n", px, py, anchor, (color ? color : "#333"), what
}
function line(ax, ay, bx, by, color) {
  printf "<line x1=\"%.1f\" y1=\"%.1f\" x2=\"%.1f\" y2=\"%.1f\" " \
    "stroke=\"%s\"/>\n", ax, ay, bx, by, color
}

END {
  x0 = floor(log10(small ? small : 1)); x1 = floor(log10(large + 1)) + 1
  y0 = floor(log10(least ? least : 1)); y1 = floor(log10(worst + 1e-9)) + 1
  printf "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 %d %d\" " \
    "font-family=\"sans-serif\" font-size=\"13\">\n", wide, high
  printf "<rect width=\"%d\" height=\"%d\" fill=\"#fff\"/>\n", wide, high
  words(left, 22, "start", "Sphere flake: seconds of tracing, " most \
    (most == 1 ? " thread" : " threads"))
  printf "<g font-size=\"10\">"
  words(left, 38, "start", note, "#777")
  print "</g>"
  for (e = x0; e <= x1; e++) {
    line(x(10 ^ e), y(10 ^ y0), x(10 ^ e), y(10 ^ y1), "#ddd")
    label = e < 3 ? 10 ^ e : e < 6 ? 10 ^ (e - 3) " 000" \
      : 10 ^ (e - 6) " 000 000"
    words(x(10 ^ e), high - bottom + 20, "middle", label)
  }
  for (e = y0; e <= y1; e++) {
    line(x(10 ^ x0), y(10 ^ e), x(10 ^ x1), y(10 ^ e), "#ddd")
    words(left - 8, y(10 ^ e) + 4, "end", sprintf("%g s", 10 ^ e))
  }
  words((left + wide - right) / 2, high - 15, "middle", "spheres")
  for (p = 1; p <= 4; p++) {
    key = programs[p] SUBSEP most
    if (!count[key]) continue
    printf "<polyline fill=\"none\" stroke=\"%s\" stroke-width=\"2\" points=\"",
      colors[p]
    for (i = 1; i <= count[key]; i++)
      printf "%.1f,%.1f ", x(size[key, i]), y(value[key, i])
    print "\"/>"
    for (i = 1; i <= count[key]; i++)
      printf "<circle cx=\"%.1f\" cy=\"%.1f\" r=\"3.5\" fill=\"%s\"/>\n",
        x(size[key, i]), y(value[key, i]), colors[p]
    i = count[key]
    # Names that would touch are moved apart.
    py = y(value[key, i]) + 4
    for (q = 1; q < p; q++)
      if ((q in placed) && py - placed[q] < 15 && placed[q] - py < 15)
        py = placed[q] + 15
    placed[p] = py
    words(x(size[key, i]) + 8, py, "start", names[programs[p]], colors[p])
  }
  print "</svg>"
}
