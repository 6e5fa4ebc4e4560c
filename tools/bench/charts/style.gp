# What every chart has in common; read before the chart's own script. Marks of a kind differ in shape and in lightness,
# so that they are told apart in grey and by the colour-blind.

index_of(name, list) = sum [i = 1:words(list)] (word(list, i) eq name ? i : 0)
smaller(a, b) = a < b ? a : b
larger(a, b) = a > b ? a : b
power(exponent) = 10.0 ** exponent
grouped(n) = n < 1000 ? sprintf('%d', n) : grouped(n / 1000) . sprintf(',%03d', n % 1000)

# A chart begins with `eval begin` and its terminal. `outputs` may list where charts are written, in pairs: NAME PATH …
begin = "reset; set encoding utf8; set datafile separator ','; set datafile columnheaders; set datafile missing NaN; \
  set border 3 lc rgb '#444444'; set tics nomirror; set grid lc rgb '#d4d4d4' lw 1 dt 1"
terminal(kind, width, height) = sprintf("set terminal %s size %d, %d font 'DejaVu Sans,%d' noenhanced \
  background rgb 'white'", kind eq 'svg' ? 'svg' : 'pngcairo', width, height, kind eq 'svg' ? 15 : 12)
if (!exists('outputs')) outputs = ''
output_of(name) = index_of(name, outputs) > 0 ? word(outputs, index_of(name, outputs) + 1) : name

# Precisions, and Embree's two.
precisions = 'fast robust double auto embree embree-robust'
precision_colors = '#ee9a3a #003f7f #2f9e7a #f2c80f #cc79a7 #000000'
precision_points = '7 5 9 13 6 4'
precision_dashes = '1 1 1 2 2 2'
precision_index(name) = index_of(name, precisions)
precision_color(name) = word(precision_colors, precision_index(name))
precision_dash(name) = int(word(precision_dashes, precision_index(name)))
precision_point(name) = int(word(precision_points, precision_index(name)))
# Scenes, by their numbers.
scene_color(i) = word('#000000 #d55e00 #0072b2 #009e73 #cc79a7 #56b4e9 #e69f00 #666666', (i - 1) % 8 + 1)
scene_point(i) = int(word('7 5 9 11 13 6 4 8', (i - 1) % 8 + 1))
