# stated.awk - the error that was stated against the one that was reached, as
# SVG, both axes logarithmic. Below the line the statement holds. For the knobs
# of the tree of rays it is the largest of a picture; for --noise the RMS error.
# usage: awk -f bench/svg.awk -f bench/trade/stated.awk trade.tsv

BEGIN {
  FS = "\t"
  wide = 640; high = 480; left = 80; right = 150; top = 50; bottom = 50
  split("max-depth min-weight max-error noise", knobs, " ")
  split("#c0392b #e67e22 #2471a3 #1e8449", colors, " ")
  x0 = y0 = 99; x1 = y1 = -99
}
$10 != "-" && $10 > 0 && ($3 == "noise" ? $7 : $8) > 0 {
  n++
  knob[n] = $3
  stated[n] = log($10) / log(10)
  reached[n] = log($3 == "noise" ? $7 : $8) / log(10)
  if (stated[n] < x0) x0 = stated[n]
  if (stated[n] > x1) x1 = stated[n]
  if (reached[n] < y0) y0 = reached[n]
  if (reached[n] > y1) y1 = reached[n]
}
END {
  x0 = floor(x0); x1 = -floor(-x1); y0 = floor(y0); y1 = -floor(-y1)
  printf "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 %d %d\" " \
    "font-family=\"sans-serif\" font-size=\"12\">\n", wide, high
  printf "<rect width=\"%d\" height=\"%d\" fill=\"#fff\"/>\n", wide, high
  printf "<text x=\"%d\" y=\"24\" font-size=\"15\" fill=\"#111\">error reached against error stated</text>\n", left
  for (v = x0; v <= x1; v++) {
    rule(x(v), y(y0), x(v), y(y1)); words(x(v), high - bottom + 18, "middle", "10^" v)
  }
  for (v = y0; v <= y1; v++) {
    rule(x(x0), y(v), x(x1), y(v)); words(left - 8, y(v) + 4, "end", "10^" v)
  }
  least = x0 > y0 ? x0 : y0; most = x1 < y1 ? x1 : y1
  rule(x(least), y(least), x(most), y(most), "#333")
  words((left + wide - right) / 2, high - 10, "middle", "stated")
  words(left, top - 8, "start", "reached")
  for (k = 1; k in knobs; k++) {
    words(wide - right + 12, top + 18 * k, "start", knobs[k], colors[k])
    for (i = 1; i <= n; i++)
      if (knob[i] == knobs[k])
        printf "<circle cx=\"%.1f\" cy=\"%.1f\" r=\"3\" fill=\"%s\" fill-opacity=\".7\"/>\n",
          x(stated[i]), y(reached[i]), colors[k]
  }
  print "</svg>"
}
