# gnuplot -e "data='FILE.csv'; out='FILE.png'" style.gp peers.gp: Masu's rate over each peer's, a panel for each kind of
# rays and a line for each scene and what was built of it.
# Columns: kind, line from below, scene, over CWBVH, over cuBQL, over OptiX, over hagrid.

eval begin
eval terminal('png', 1100, 430)
set output out
stats data using (column('line')) nooutput name 'line'
set border 1 lc rgb '#444444'
set logscale x 2
set xrange [0.6:18]
set yrange [0.4:line_max + 0.6]
set xtics (1, 2, 4, 8, 16) format '%g ×'
array scenes[100]
stats data using (scenes[int(column('line'))] = strcol('scene'), 1) nooutput
set grid xtics lc rgb '#d4d4d4' lw 1 dt 1, ytics lc rgb '#eeeeee'
set label 1 'Masu’s rays per second over other tracers’, on an H200 (to the right, Masu is faster)' \
  at screen 0.012, 0.955 font ',15'
set label 2 'through what gridbuild --structure fastest builds; left of the line, the other tracer is faster' at screen 0.012, 0.895
set key at screen 0.99, 0.05 right bottom maxrows 1 samplen 0.5 width -1
set tmargin at screen 0.78
set bmargin at screen 0.19
set multiplot
do for [i = 1:3] {
  kind = word('primary diffuse random', i)
  set lmargin at screen 0.205 + (i - 1) * 0.27
  set rmargin at screen 0.205 + (i - 1) * 0.27 + 0.24
  set label 3 kind.' rays' at graph 0, 1.06 font ',13'
  set arrow 1 from 1, graph 0 to 1, graph 1 nohead lw 2 lc rgb 'black'
  if (i > 1) { unset label 1; unset label 2; unset key }
  set ytics scale 0 ()
  do for [k = 1:int(line_max)] { set ytics add (i == 1 ? scenes[k] : '' k) }
  is_kind(_) = strcol('kind') eq kind
  plot data using (is_kind(0) ? column('optix') : NaN):(column('line')) \
         with points pt 7 ps 1.7 lc rgb '#9a9a9a' title 'OptiX 9.0, software', \
       data using (is_kind(0) ? column('hagrid') : NaN):(column('line')) \
         with points pt 8 ps 1.8 lw 1.6 lc rgb '#0072b2' title 'hagrid’s best', \
       data using (is_kind(0) ? column('cubql') : NaN):(column('line')) \
         with points pt 9 ps 1.6 lc rgb '#d55e00' title 'cuBQL’s best', \
       data using (is_kind(0) ? column('cwbvh') : NaN):(column('line')) \
         with points pt 5 ps 1.2 lc rgb 'black' title 'CWBVH with Masu’s test'
}
unset multiplot
