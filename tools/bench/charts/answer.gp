# gnuplot -e "data='FILE.csv'; out='FILE.png'; machine='NAME'" style.gp answer.gp: the time to an answer over the number of
# rays, preparing included: a panel for each number of triangles, a line for each tracer.
# Columns: panel, triangles, line (of the names below), rays, seconds.

eval begin
eval terminal('png', 1100, 340)
set output out
array names[6] = ["Masu", "Masu, high", "Embree, medium", "Embree, high", "cuBQL, median", "cuBQL, SAH"]
colors = '#000000 #0072b2 #d55e00 #e69f00 #d55e00 #e69f00'
set logscale xy
set xrange [1e3:1e9]
set format x '10^{%T}'
set format y '10^{%T}'
set xtics 100
set termoption enhanced
array sizes[100]
stats data using (column('rays') == 1000 && column('line') == 1 ? (sizes[int(column('panel'))] = column('triangles')) : 0) nooutput
stats data using (column('panel')) nooutput name 'panel'
array lines_there[6] = [0, 0, 0, 0, 0, 0]
stats data using (lines_there[int(column('line'))] = 1) nooutput
there = ''
do for [k = 1:6] { if (lines_there[k]) { there = there.' '.k } }
set label 1 'Seconds from arrays in host memory to the last of so many rays, '.machine at screen 0.012, 0.94 font ',15'
set tmargin at screen 0.78
set bmargin at screen 0.24
set multiplot
do for [i = 1:panel_max] {
  set lmargin at screen 0.05 + (i - 1) * 0.95 / panel_max
  set rmargin at screen 0.05 + i * 0.95 / panel_max - 0.045
  set label 2 grouped(int(sizes[i])).' triangles' at graph 0, 1.07 font ',13'
  if (i > 1) { unset label 1; unset key } else { set key at screen 0.99, 0.05 right bottom maxrows 1 samplen 2 }
  plot for [k in there] data \
    using (column('panel') == i && column('line') == k ? column('rays') : NaN):(column('seconds')) \
    with lines lw 2 lc rgb word(colors, int(k)) dt int(word('1 2 1 2 1 2', int(k))) title names[int(k)]
}
unset multiplot
