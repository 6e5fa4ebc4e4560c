# gnuplot -e "out='FILE.png'" style.gp lesson.gp, in the folder of SCENE.dat: what a ray costs in uniform grids.
# Columns, separated by blanks: voxels per axis, tests, cells and nanoseconds per ray.

eval begin
set datafile separator whitespace
set datafile nocolumnheaders
eval terminal('png', 900, 430)
set output out
set multiplot
set label 1 'What a camera ray costs in uniform grids (lower is better)' at screen 0.02, screen 0.955 font ',15'
set logscale x 2
set logscale y 10
set xlabel 'voxels per axis'
set ylabel 'per ray' offset 1
set xtics (2, 4, 8, 16, 32, 64, 128)
set format y '%.0f'
set key top right
set xrange [1.8:140]
set yrange [1:100000]
set tmargin at screen 0.83
set bmargin at screen 0.14
do for [i = 1:2] {
  data = word('teapot balls', i) . '.dat'
  set lmargin at screen 0.5 * i - 0.38
  set rmargin at screen 0.5 * i - 0.03
  stats data using 4 nooutput name 'time'
  stats data using ($4 == time_min ? (fastest = $1) : 0) nooutput
  set label 2 sprintf('%s: %d³ is the fastest', word('teapot balls', i), int(fastest)) at graph 0, graph 1.05 font ',13'
  set label 3 '' at first fastest, first time_min point pt 6 ps 3 lw 2
  plot data using 1:2 with linespoints lw 1.5 dt 2 pt 6 ps 1.3 lc rgb '#0072b2' title 'primitives tested', \
       data using 1:3 with linespoints lw 1.5 dt 4 pt 4 ps 1.3 lc rgb '#009e73' title 'cells visited', \
       data using 1:4 with linespoints lw 3 dt 1 pt 9 ps 1.6 lc rgb 'black' title 'nanoseconds'
  unset label 1
}
unset multiplot
