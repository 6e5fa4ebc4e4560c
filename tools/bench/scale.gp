# The chart of gridbench scale, from the scale.csv that it writes: speed-up against workers, with the ideal line.
# To run it by hand in the folder of scale.csv: gnuplot PATH/scale.gp

if (!exists('outputs')) outputs = ''
index_of(name, list) = sum [i = 1:words(list)] (word(list, i) eq name ? i : 0)
output_of(name) = index_of(name, outputs) > 0 ? word(outputs, index_of(name, outputs) + 1) : name
terminal(kind) = sprintf("set terminal %s size 900, 600 font 'DejaVu Sans,%d' noenhanced background rgb 'white'", \
  kind eq 'svg' ? 'svg' : 'pngcairo', kind eq 'svg' ? 15 : 12)
of(work, scaling) = sprintf("< awk -F, 'NR > 1 && $1 == \"%s\" && $2 == \"%s\"' scale.csv", work, scaling)

do for [kind in 'svg png'] {
  reset
  set encoding utf8
  eval terminal(kind)
  set output output_of('scale.' . kind)
  set datafile separator ','
  stats 'scale.csv' using 3 every ::1 nooutput name 'workers'
  set border 3 lc rgb '#444444'; set tics nomirror; set grid lc rgb '#d4d4d4' lw 1 dt 1
  set xlabel 'workers (GPUs, or threads)'; set ylabel 'speed-up'
  set xrange [0.9:workers_max + 0.1]; set yrange [0:workers_max * 1.1]; set xtics 1
  set key top left reverse Left
  plot x with lines lc rgb '#999999' dt 2 title 'ideal', \
    of('views', 'strong') using 3:6 with linespoints lw 2 pt 7 lc rgb '#0072b2' title 'views', \
    of('views', 'weak') using 3:6 with linespoints lw 2 dt 3 pt 6 lc rgb '#0072b2' title 'views, weak', \
    of('large view', 'strong') using 3:6 with linespoints lw 2 pt 5 lc rgb '#d55e00' title 'one large view', \
    of('large view', 'weak') using 3:6 with linespoints lw 2 dt 3 pt 4 lc rgb '#d55e00' title 'one large view, weak', \
    of('list', 'strong') using 3:6 with linespoints lw 2 pt 9 lc rgb '#009e73' title 'list of rays', \
    of('list', 'weak') using 3:6 with linespoints lw 2 dt 3 pt 8 lc rgb '#009e73' title 'list of rays, weak'
  unset output
}
