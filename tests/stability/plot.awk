# plot.awk - a table, one column against the others, as SVG.
# usage: awk -v title=T -v down=WHAT [-v linear=1] \
#   -f bench/svg.awk -f tests/stability/plot.awk TABLE
# The first line names the columns; the axes are logarithmic, with linear the
# one upwards not and the one across counts powers of two.

BEGIN {
  FS = "\t"
  wide = 720; high = 400; left = 80; right = 20; top = 60; bottom = 50
  split("#c0392b #1e8449 #2471a3 #7d6608", colors, " ")
}
function scaled(v) { return linear ? v : log(v) / log(10) }
NR == 1 { for (i = 1; i <= NF; i++) name[i] = $i; columns = NF; next }
{
  rows++
  across[rows] = linear ? $1 : log($1) / log(10)
  for (i = 2; i <= NF; i++) {
    if ($i == "-") { value[rows, i] = "-"; continue }
    value[rows, i] = scaled($i)
    if (seen++ == 0 || value[rows, i] < y0) y0 = value[rows, i]
    if (seen == 1 || value[rows, i] > y1) y1 = value[rows, i]
  }
}
END {
  x0 = across[1]; x1 = across[rows]
  if (x0 > x1) { t = x0; x0 = x1; x1 = t }
  if (linear) { y0 = 0; y1 = 1 }
  else { y0 = floor(y0); y1 = -floor(-y1); x0 = floor(x0); x1 = -floor(-x1) }
  printf "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 %d %d\" " \
    "font-family=\"sans-serif\" font-size=\"12\">\n", wide, high
  printf "<rect width=\"%d\" height=\"%d\" fill=\"#fff\"/>\n", wide, high
  printf "<text x=\"%d\" y=\"20\" font-size=\"15\" fill=\"#111\">%s</text>\n",
    left, title
  step = linear ? 50 : x1 - x0 > 9 ? 3 : 1
  for (v = x0; v <= x1 + 1e-9; v += step) {
    rule(x(v), y(y0), x(v), y(y1))
    words(x(v), high - bottom + 18, "middle", linear ? "2^" v : "10^" v)
  }
  for (v = y0; v <= y1 + 1e-9; v += linear ? 0.25 : 3) {
    rule(x(x0), y(v), x(x1), y(v))
    words(left - 8, y(v) + 4, "end", linear ? 100 * v " %" : "10^" v)
  }
  words((left + wide - right) / 2, high - 10, "middle", name[1])
  words(left, top - 20, "start", down)
  for (i = 2; i <= columns; i++) {
    points = ""
    for (r = 1; r <= rows; r++) {
      if (value[r, i] == "-") continue
      points = points sprintf("%.1f,%.1f ", x(across[r]), y(value[r, i]))
    }
    printf "<polyline points=\"%s\" fill=\"none\" stroke=\"%s\" " \
      "stroke-width=\"2\"/>\n", points, colors[i - 1]
    words(wide - right - 150 * (columns - i), top - 20, "end", name[i],
          colors[i - 1])
  }
  print "</svg>"
}
