# gnuplot -e "data='FILE.csv'; out='FILE.png'; title='TEXT'; floor=1e-7" style.gp accuracy.gp: a panel for each sweep,
# shares of failures against the parameter, a line for each mode in the file. Both axes are logarithmic. Shares of zero
# lie in a band at `floor`, lines above each other; a parameter of zero lies left of the others.
# Columns: sweep, parameter, step, mode, share.

eval begin
power_text(e) = e < -2 || e > 3 ? sprintf('1e%d', e) : sprintf('%g', power(e))
sweeps = ''
known = ''
modes = ''
array parameters[100]
stats data using (index_of(strcol('sweep'), sweeps) > 0 ? 0 \
  : (sweeps = sweeps . ' ' . strcol('sweep'), parameters[words(sweeps)] = strcol('parameter'), 0)) nooutput
stats data using (index_of(strcol('mode'), known) > 0 ? 0 : (known = known . ' ' . strcol('mode'), 0)) nooutput
do for [mode in precisions] { if (index_of(mode, known) > 0) { modes = modes . ' ' . mode } }
n = words(sweeps)
columns = 4
rows = ceil(n / real(columns))
width = 1216
height = 80 + 205 * rows
eval terminal('png', width, height)
set output out
set multiplot
unset key

set label 1 title at screen 12.0 / width, screen 1 - 18.0 / height font ',13'
do for [i = 1:words(modes)] {
  mode = word(modes, i)
  set label (10 + i) mode at screen (20.0 + 150 * (i - 1)) / width, screen 1 - 44.0 / height font ',10' \
    point pt precision_point(mode) ps 1.2 lw 1.5 lc rgb precision_color(mode) offset 1, 0
}

band = floor * 1.6 ** words(modes)
is_of(sweep) = strcol('sweep') eq sweep
x_of(step) = step > 0 ? step : zero_x
drawn(mode, share) = share > 0 ? share : floor * 1.6 ** (words(modes) - index_of(mode, modes))
do for [i = 1:n] {
  sweep = word(sweeps, i)
  unset logscale
  set autoscale
  stats data using (is_of(sweep) && column('step') > 0 ? column('step') : NaN) nooutput name 'step'
  has_zero = 0
  stats data using (is_of(sweep) && column('step') == 0 ? (has_zero = 1) : 0) nooutput
  decades = log10(step_max / step_min)
  zero_x = step_min / power(0.15 * decades)
  set logscale xy
  set xrange [(has_zero ? zero_x : step_min) / power(0.04 * decades) : step_max * power(0.04 * decades)]
  set yrange [floor / 2 : 2]

  row = (i - 1) / columns
  left = (i - 1) % columns * 296.0 + 58
  top = 92.0 + 205 * row
  set lmargin at screen left / width
  set rmargin at screen (left + 228) / width
  set tmargin at screen 1 - (top - 2) / height
  set bmargin at screen 1 - (top + 120) / height
  set xtics nomirror font ',8' ()
  if (has_zero) { set xtics add ('0' zero_x) }
  if (decades < 2.5) {
    do for [e = floor(log10(step_min)):ceil(log10(step_max))] { do for [f in '1 2 5'] {
      set xtics add (sprintf('%g', f * power(e)) f * power(e))
    } }
  } else {
    by = ceil(decades / 5)
    do for [e = by * ceil((log10(step_min) - 0.01) / by):floor(log10(step_max) + 0.01):by] {
      set xtics add (power_text(e) power(e))
    }
  }
  set ytics nomirror font ',8' ('none' sqrt(floor * band), '100 %%' 1)
  do for [e = ceil(log10(band)):-1] { set ytics add ((e % 2 == 0 ? power_text(e + 2) . ' %%' : '') power(e)) }
  set object 1 rectangle from graph 0, graph 0 to graph 1, first band fs solid noborder fc rgb '#eeeeee' behind
  set label 2 sweep at screen left / width, screen 1 - (top - 14) / height font ',10'
  set label 3 parameters[i] at screen (left + 114) / width, screen 1 - (top + 152) / height center font ',8'
  plot for [mode in modes] data using \
    (is_of(sweep) && strcol('mode') eq mode ? x_of(column('step')) : NaN):(drawn(mode, column('share'))) \
    with linespoints pt precision_point(mode) ps 0.7 lw 1.6 dt precision_dash(mode) lc rgb precision_color(mode)
  unset label 1
  do for [k = 1:words(modes)] { unset label (10 + k) }
}
unset multiplot
