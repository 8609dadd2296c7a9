# plot.awk - error against time of one scene, a line for each knob, as SVG; the
# front (nothing is both faster and nearer) has rings. Both axes logarithmic.
# usage: awk -v scene=NAME [-v list='KNOB|KNOB...'] \
#   -f bench/svg.awk -f bench/trade/plot.awk trade.tsv

BEGIN {
  FS = "\t"
  wide = 740; high = 440; left = 80; right = 180; top = 50; bottom = 50
  if (!list) list = "max-depth|min-weight|max-error|owen|stratified|random|noise|quality"
  split(list, knobs, "|")
  split("#c0392b #e67e22 #d4ac0d #1e8449 #16a085 #7f8c8d #2471a3 #8e44ad #6e2c00 #117864 #5d6d7e #d81b60", colors, " ")
}
$2 == scene && $7 > 0 && $6 > 0 && $3 !~ /reference$/ {
  i = ++count[$3]
  time[$3, i] = log($6) / log(10); error[$3, i] = log($7) / log(10)
  if (!seen++) { x0 = x1 = time[$3, i]; y0 = y1 = error[$3, i] }
  if (time[$3, i] < x0) x0 = time[$3, i]
  if (time[$3, i] > x1) x1 = time[$3, i]
  if (error[$3, i] < y0) y0 = error[$3, i]
  if (error[$3, i] > y1) y1 = error[$3, i]
  kind[$3] = $1
}
# Whether another setting measured against the same reference beats it.
function beaten(k, i,   a, j, b) {
  for (a in count)
    for (j = 1; j <= count[a]; j++)
      if (kind[a] == kind[k] && time[a, j] <= time[k, i] && error[a, j] < error[k, i]) return 1
  return 0
}
END {
  x0 = floor(x0); x1 = -floor(-x1); y0 = floor(y0); y1 = -floor(-y1)
  if (x0 == x1) x1++
  if (y0 == y1) y1++
  printf "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 %d %d\" " \
    "font-family=\"sans-serif\" font-size=\"12\">\n", wide, high
  printf "<rect width=\"%d\" height=\"%d\" fill=\"#fff\"/>\n", wide, high
  printf "<text x=\"%d\" y=\"24\" font-size=\"15\" fill=\"#111\">%s: error against time</text>\n", left, scene
  for (v = x0; v <= x1; v++) {
    rule(x(v), y(y0), x(v), y(y1)); words(x(v), high - bottom + 18, "middle", "10^" v)
  }
  for (v = y0; v <= y1; v++) {
    rule(x(x0), y(v), x(x1), y(v)); words(left - 8, y(v) + 4, "end", "10^" v)
  }
  words((left + wide - right) / 2, high - 10, "middle", "seconds")
  words(left, top - 8, "start", "RMS error")
  for (k = 1; k in knobs; k++) {
    knob = knobs[k]; points = ""
    for (i = 1; i <= count[knob]; i++) {
      px = x(time[knob, i]); py = y(error[knob, i])
      points = points sprintf("%.1f,%.1f ", px, py)
      printf "<circle cx=\"%.1f\" cy=\"%.1f\" r=\"%d\" fill=\"%s\" stroke=\"%s\"/>\n",
        px, py, beaten(knob, i) ? 2 : 5, beaten(knob, i) ? colors[k] : "none", colors[k]
    }
    if (!count[knob]) continue
    printf "<polyline points=\"%s\" fill=\"none\" stroke=\"%s\" stroke-width=\"1.5\"/>\n", points, colors[k]
    words(wide - right + 12, top + 18 * k, "start", knob, colors[k])
  }
  print "</svg>"
}
