# The charts of gridbench tradeoff, from the charts.csv that it writes: SCENE.svg and .png for each scene and
# tradeoff.svg and .png for the mean of all scenes, speed against accuracy; division.svg and .png, time against division.
# To run it by hand in the folder of charts.csv: gnuplot PATH/style.gp PATH/tradeoff.gp

if (!exists('data')) data = 'charts.csv'

# --- Helpers

decimal(exponent) = sprintf(sprintf('%%.%df', exponent < 0 ? -exponent : 0), power(exponent))

# Ticks of a logarithmic axis: the longer it is, the fewer a decade.
log_ticks(axis, from, to) = sprintf("set %stics (); do for [e = %d:%d] { do for [f in '%s'] { \
  set %stics add (sprintf('%%g', f * power(e)) f * power(e)) } }", axis, floor(log10(from)), ceil(log10(to)), \
  to / from > 2e3 ? '1' : to / from > 14 ? '1 2 5' : '1 1.5 2 3 5 7', axis)

# Labels to the right of the plot, each at the height of its point or near it: point i of n is (px[i], py[i]), with the
# text pt[i], on a logarithmic y axis from y_low to y_high. From bottom to top, low() moves labels up until each is `gap`
# above the one below; high() moves those beyond the top down again. Heights are parts of the plot's height.
array px[1000]; array py[1000]; array pt[1000]
height(i) = log(py[i] / y_low) / log(y_high / y_low)
rank(i) = 1 + sum [j = 1:n] (py[j] < py[i] || (py[j] == py[i] && j < i))
ranked(k) = sum [i = 1:n] (rank(i) == k ? i : 0)
low(k) = k < 1 ? -gap : larger(height(ranked(k)), low(k - 1) + gap)
high(k) = k > n ? 1 + gap : smaller(low(k), high(k + 1) - gap)
set_labels = "do for [i = 1:n] { \
  set arrow from first px[i], first py[i] to graph 1.0, graph high(rank(i)) nohead lw 0.8 lc rgb '#999999'; \
  set arrow from graph 1.0, graph high(rank(i)) to graph 1.015, graph high(rank(i)) nohead lw 0.8 lc rgb '#999999'; \
  set label pt[i] at graph 1.02, graph high(rank(i)) left offset name_offset, 0 }"

# --- What is in the file

eval begin
scenes = '' # of the mean, the scene is `all`
stats data using (index_of(strcol('scene'), scenes) > 0 ? 0 : (scenes = scenes . ' ' . strcol('scene'), 0)) nooutput
number_of_scenes = words(scenes) - (index_of('all', scenes) > 0)
stats data using (backend = strcol('backend') eq 'cuda' ? 'GPU' : 'CPU, ' . strcol('threads') . (column('threads') == 1 ? ' thread' : ' threads'), \
  primary_size = strcol('primary_size'), random_rays = column('random_rays'), picture_size = strcol('picture_size'), 0) \
  nooutput

# --- Speed against accuracy: hits above, the picture below

structures = 'none x balance irregular bvh'
structure_titles = "'uniform grid' '--merge x' '--merge balance' 'irregular grid' 'hierarchy'"
filled = '5 13 11 9 7' # point types: proven
open = '4 12 10 8 6'   # first cell hit
is_first_cell(_) = strcol('stop_rule') eq 'first-cell-hit'
# A method is the indices of a precision and a structure and 1 for first cell hit, else 0, such as 241.
method_of(_) = sprintf('%d%d%d', precision_index(strcol('precision')), index_of(strcol('merge'), structures), \
  is_first_cell(0))
color_of(method) = word(precision_colors, int(method[1:1]))
point_of(method) = int(word(method[3:3] eq '1' ? open : filled, int(method[2:2])))
grid_of(_) = (strcol('merge') eq 'none' ? 'uniform' : strcol('merge') eq 'bvh' ? 'hierarchy' : strcol('merge')) . ' ' \
  . (strcol('merge') eq 'bvh' ? '' : (strcol('merge') eq 'irregular' && strcol('division') eq 'auto' ? '' \
    : strcol('division') . ' ') . strcol('overlap'))
label_of(_) = strcol('precision') . (is_first_cell(0) ? ', first cell hit' : '') . ': ' . grid_of(0)

is_hits(panel) = panel eq 'hits'
speed(panel) = is_hits(panel) ? column('mrays') : 1e3 / column('picture_ms')
error(panel) = is_hits(panel) \
  ? (column('missed') + column('false_hits') + column('wrong_primitives')) / column('rays_compared') \
  : column('picture_rmse')
is_in_front(panel) = column(panel . '_front') == 1
is_of(scene) = strcol('scene') eq scene
# Rows far slower than the fastest would leave no room for the others.
is_shown(scene, panel) = is_of(scene) && speed(panel) >= slowest
front_speed(scene, panel) = is_shown(scene, panel) && is_in_front(panel) ? speed(panel) : NaN
# An error of zero has no place on a logarithmic axis: it lies in a band at the bottom, precisions beside each other.
drawn_error(panel) = error(panel) > 0 ? error(panel) : zero * 1.35 ** (2 - precision_index(strcol('precision')))

do for [scene in scenes] { do for [kind in 'svg png'] {
  eval begin
  set logscale xy
  eval terminal(kind, 1100, 1240)
  set output output_of((scene eq 'all' ? 'tradeoff' : scene) . '.' . kind)
  stats data using (is_of(scene) ? column('rays_compared') : NaN) nooutput name 'compared'
  set multiplot
  set lmargin at screen 0.115
  set rmargin at screen 0.695
  set key at screen 0.05, screen 0.935 left top Left reverse vertical maxrows 3 samplen 2
  do for [panel in 'hits picture'] {
    unset label
    unset arrow
    unset object
    set autoscale # stats leaves out what is outside the axes
    if (is_hits(panel)) {
      set label (scene eq 'all' ? sprintf('mean of %d scenes', number_of_scenes) : scene) . ', ' . backend \
        . ': to the right is faster, lower is more accurate' at screen 0.02, screen 0.977 font ',20'
      set label sprintf('%s primary and %s random rays a scene; %s in all compared with brute force in double; ' \
        . 'pictures of %s', primary_size, grouped(int(random_rays)), grouped(int(compared_max)), picture_size) \
        at screen 0.02, screen 0.952
      set bmargin at screen 0.50
      set tmargin at screen 0.855
      x_title = 'million closest hits per second'
      y_title = 'wrong hits'
    } else {
      unset key
      set bmargin at screen 0.065
      set tmargin at screen 0.42
      x_title = 'pictures per second'
      y_title = 'picture: RMSE of a channel'
    }

    stats data using (is_of(scene) ? speed(panel) : NaN) nooutput name 'scene'
    slowest = scene_max / 20
    stats data using (is_shown(scene, panel) ? speed(panel) : NaN) nooutput name 'shown'
    methods = ''
    stats data using (is_shown(scene, panel) && index_of(method_of(0), methods) == 0 \
      ? (methods = methods . ' ' . method_of(0), 1) : 1) nooutput
    error_min = 0 # of those above zero; none where it stays zero
    error_max = 0
    stats data using (is_shown(scene, panel) && error(panel) > 0 ? (error_max = larger(error_max, error(panel)), \
      error_min = error_min > 0 ? smaller(error_min, error(panel)) : error(panel), 1) : 1) nooutput
    zero = is_hits(panel) ? 0.5 / compared_max : error_min > 0 ? error_min / 8 : 1e-9
    y_low = zero / 2.5
    y_high = larger(zero * 40, error_max * 2.5)
    n = 0
    stats data using (is_shown(scene, panel) && is_in_front(panel) \
      ? (n = n + 1, px[n] = speed(panel), py[n] = drawn_error(panel), pt[n] = label_of(0), 1) : 1) nooutput
    set xrange [shown_min / 1.2 : shown_max * 1.2]
    set yrange [y_low : y_high]

    set xlabel x_title . '  (more is better)'
    # Not as ylabel: wide tick labels would push that out of the picture.
    set label y_title . '  (less is better)' at screen 0.018, graph 0.5 center rotate by 90
    eval log_ticks('x', shown_min, shown_max)
    set ytics ((is_hits(panel) ? "none of\n" . grouped(int(compared_max)) : "same\nbits") zero)
    do for [e = ceil(log10(zero * 2)) : floor(log10(y_high))] {
      set ytics add ((is_hits(panel) ? decimal(e + 2) . ' %%' : e < -4 ? sprintf('1e%d', e) : decimal(e)) power(e))
    }
    set object rectangle from graph 0, graph 0 to graph 1, first zero * 1.7 fs solid noborder fc rgb '#eeeeee' behind

    gap = 0.05
    name_offset = 0
    eval set_labels
    plot for [method in methods] data \
        using (is_shown(scene, panel) && method_of(0) eq method ? speed(panel) : NaN):(drawn_error(panel)) \
        with points pt point_of(method) ps 1.3 lw 1.6 lc rgb color_of(method) notitle, \
      for [precision in 'robust double'] NaN with points pt 7 ps 1.3 lc rgb precision_color(precision) title precision, \
      for [i = 1:5] NaN with points pt int(word(filled, i)) ps 1.3 lc rgb '#666666' title word(structure_titles, i), \
      NaN with points pt 6 ps 1.3 lw 1.6 lc rgb '#666666' title 'open: first cell hit', \
      NaN with lines lw 1.8 dt '-' lc rgb '#222222' title 'Pareto front', \
      data using (front_speed(scene, panel)):(drawn_error(panel)) smooth unique \
        with fsteps lw 1.8 dt '-' lc rgb '#222222' notitle, \
      data using (front_speed(scene, panel)):(drawn_error(panel)) \
        with points pt 6 ps 2.6 lw 1.6 lc rgb '#222222' notitle
  }
  unset multiplot
  unset output
} }

# --- Time against division: uniform grids, exact overlap, proven, in robust precision or what a scene has instead

is_curve(_) = strcol('merge') eq 'none' && strcol('overlap') eq 'exact' && strcol('stop_rule') eq 'proven'
is_automatic(_) = strcol('division') eq 'auto'
eval begin
curves = '' # SCENE/PRECISION
stats data using (is_curve(0) && !is_automatic(0) && !is_of('all') \
  ? (curves = curves . ' ' . strcol('scene') . '/' . strcol('precision'), 1) : 1) nooutput
has_curve(scene, precision) = index_of(scene . '/' . precision, curves) > 0
precision_of(scene) = has_curve(scene, 'robust') ? 'robust' : 'double'
is_line(scene, automatic) = is_of(scene) && is_curve(0) && strcol('precision') eq precision_of(scene) \
  && is_automatic(0) == automatic
voxels_an_axis(_) = column('voxels') ** (1 / 3.0)

if (curves ne '') { do for [kind in 'svg png'] {
  eval begin
  set logscale xy
  eval terminal(kind, 1100, 760)
  set output output_of('division.' . kind)
  n = 0
  x_high = 1
  y_low = 1e99
  y_high = 0
  do for [scene in scenes] { if (has_curve(scene, precision_of(scene))) {
    n = n + 1
    px[n] = 0
    pt[n] = scene
    stats data using (is_line(scene, 0) && voxels_an_axis(0) > px[n] \
      ? (px[n] = voxels_an_axis(0), py[n] = column('picture_ms'), 1) : 1) nooutput
    stats data using (is_line(scene, 0) || is_line(scene, 1) ? (x_high = larger(x_high, voxels_an_axis(0)), \
      y_low = smaller(y_low, column('picture_ms') / 1.3), y_high = larger(y_high, column('picture_ms') * 1.3), 1) : 1) \
      nooutput
    ms = 0 # of the automatic division, where it was measured
    stats data using (is_line(scene, 1) ? (voxels = voxels_an_axis(0), ms = column('picture_ms'), 1) : 1) nooutput
    if (ms > 0) {
      set label '' at first voxels, first ms point pt scene_point(n) ps 1.2 lc rgb scene_color(n)
      set label '' at first voxels, first ms point pt 6 ps 2.8 lw 2 lc rgb scene_color(n)
    }
  } }
  set xrange [1 / 1.1 : x_high * 1.1]
  set yrange [y_low : y_high]
  set lmargin at screen 0.09
  set rmargin at screen 0.88
  set bmargin at screen 0.10
  set tmargin at screen 0.89
  unset key
  set label sprintf('Time per picture by division, %s (lower is better)', backend) at screen 0.02, screen 0.963 font ',20'
  set label sprintf('uniform grids, exact overlap, %s; pictures of %s with shadows and mirrors; ringed: --division auto, its voxels cubes', \
    precision_of(pt[1]), picture_size) at screen 0.02, screen 0.921
  set label 'ms per picture' at screen 0.018, graph 0.5 center rotate by 90
  set xlabel 'voxels per axis'
  set xtics (1, 2, 4, 8, 16, 32, 64, 128, 256, 512, 1024)
  eval log_ticks('y', y_low, y_high)
  set arrow from first 16, graph 0 to first 16, graph 1 nohead lw 1.5 dt '-' lc rgb '#444444'
  set label '16: the division of the 2012 thesis' at first 16, graph 0.97 offset 1, 0 left
  gap = 0.045
  name_offset = 2
  eval set_labels
  # Each name with its line's own mark.
  do for [i = 1:n] { set label '' at graph 1.03, graph high(rank(i)) point pt scene_point(i) ps 1.2 lc rgb scene_color(i) }
  plot for [i = 1:n] data using (is_line(pt[i], 0) ? voxels_an_axis(0) : NaN):(column('picture_ms')) smooth unique \
    with linespoints pt scene_point(i) ps 1.2 lw 2 lc rgb scene_color(i)
  unset output
} }
