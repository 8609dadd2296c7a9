# svg.awk - what plots have in common: awk -f bench/svg.awk -f PLOT.awk. They set
# wide, high, left, right, top, bottom and the ends of the axes x0, x1, y0, y1.

function floor(v) { return int(v) - (v < int(v)) }
function x(v) { return left + (wide - left - right) * (v - x0) / (x1 - x0) }
function y(v) { return high - bottom - (high - top - bottom) * (v - y0) / (y1 - y0) }
function words(px, py, anchor, what, color) {
  printf "<text x=\"%.1f\" y=\"%.1f\" text-anchor=\"%s\" fill=\"%s\">%s</text>\n",
    px, py, anchor, color ? color : "#333", what
}
function rule(ax, ay, bx, by, color) {
  printf "<line x1=\"%.1f\" y1=\"%.1f\" x2=\"%.1f\" y2=\"%.1f\" stroke=\"%s\"/>\n",
    ax, ay, bx, by, color ? color : "#ccc"
}
