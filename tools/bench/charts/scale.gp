# The chart of gridbench scale, from the scale.csv that it writes: speed-up against workers, with the ideal line.
# To run it by hand in the folder of scale.csv: gnuplot PATH/style.gp PATH/scale.gp

if (!exists('data')) data = 'scale.csv'
works = "'views' 'large view' 'list'"
titles = "'views' 'one large view' 'list of rays'"
is_of(work, scaling) = strcol('work') eq work && strcol('scaling') eq scaling
do for [kind in 'svg png'] {
  eval begin
  eval terminal(kind, 900, 600)
  set output output_of('scale.' . kind)
  stats data using (column('workers')) nooutput name 'workers'
  set title 'Speed-up by workers (higher is better)'
  set xlabel 'workers (GPUs, or threads)'; set ylabel 'speed-up'
  set xrange [0.9:workers_max + 0.1]; set yrange [0:workers_max * 1.1]; set xtics 1
  set key top left reverse Left
  plot x with lines lc rgb '#999999' dt 2 title 'ideal', \
    for [i = 1:3] for [weak = 0:1] data \
      using (is_of(word(works, i), weak ? 'weak' : 'strong') ? column('workers') : NaN):(column('speedup')) \
      with linespoints lw 2 dt 1 + 2 * weak pt int(word('7 5 9', i)) - weak lc rgb scene_color(i + 1) \
      title word(titles, i) . (weak ? ', weak' : '')
  unset output
}
