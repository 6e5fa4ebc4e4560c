# Written by gridbench tradeoff. Run it in its folder: gnuplot tradeoff.gp

reset
set terminal svg size 1100,1240 font 'DejaVu Sans,15' noenhanced background rgb 'white'
set output 'balls.svg'
set encoding utf8
set logscale xy
set border 3 lc rgb '#444444'
set tics nomirror
set grid lc rgb '#d4d4d4' lw 1 dt 1
set multiplot
set key at screen 0.05, screen 0.925 left top Left reverse vertical maxrows 2 samplen 2

unset label; unset arrow; unset object
set lmargin at screen 0.115; set rmargin at screen 0.735
set bmargin at screen 0.5; set tmargin at screen 0.855
set xrange [482.505:13894.6]; set yrange [9.53674e-08:0.072608]
set xlabel 'million nearest hits a second  (more is better)'; set ylabel 'wrong hits  (less is better)' offset -1.5
set label 'balls: speed against accuracy (GPU)' at screen 0.02, screen 0.9774 font ',20'
set label '1024x1024 primary and 1,048,576 random rays a scene; 2,097,152 in all compared with brute force in double; pictures of 512x512' at screen 0.02, screen 0.9516
set xtics ('500' 500, '1000' 1000, '2000' 2000, '5000' 5000, '10000' 10000)
set ytics ("none of\n2,097,152" 2.38419e-07, '0.0001 %%' 1e-6, '0.001 %%' 1e-5, '0.01 %%' 1e-4, '0.1 %%' 1e-3, '1 %%' 1e-2)
set object rectangle from graph 0, graph 0 to graph 1, first 4.05312e-07 fs solid noborder fc rgb '#eeeeee' behind
set arrow from first 11578.8,0.00131989 to graph 1.0,0.7041 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.7041 to graph 1.015,0.7041 nohead lw 0.8 lc rgb '#999999'
set label 'fast, study: irregular exact' at graph 1.02,0.7041 left
set arrow from first 11517.8,7.86781e-05 to graph 1.0,0.4959 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.4959 to graph 1.015,0.4959 nohead lw 0.8 lc rgb '#999999'
set label 'fast: irregular exact' at graph 1.02,0.4959 left
set arrow from first 10354.9,2.38419e-07 to graph 1.0,0.0677 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.0677 to graph 1.015,0.0677 nohead lw 0.8 lc rgb '#999999'
set label 'robust: irregular exact' at graph 1.02,0.0677 left
$hits0 << END
614.473 7.86781e-05
615.055 7.86781e-05
2065.49 7.86781e-05
2137.09 7.86781e-05
2214.35 7.86781e-05
2556.01 7.86781e-05
631.983 7.86781e-05
635.088 7.86781e-05
2123.79 7.86781e-05
2194.41 7.86781e-05
2565.51 7.86781e-05
2893.42 7.86781e-05
636.562 7.86781e-05
635.821 7.86781e-05
2138.97 7.86781e-05
2180.68 7.86781e-05
5710.2 7.86781e-05
5747.76 7.86781e-05
11371.9 7.86781e-05
11517.8 7.86781e-05
END
$hits1 << END
2031.05 0.0290365
2039.9 0.0187826
2371.74 0.0146103
2590.25 0.00238228
600.009 0.0271492
602.696 0.026958
2099.84 0.0290365
2106.52 0.0187826
2642.47 0.0146103
2946.5 0.00238228
600.548 0.0271497
602.458 0.0269585
2118.92 0.0290432
2086.8 0.018836
5629.76 0.0205107
5540.75 0.00504303
11560.4 0.0112848
11578.8 0.00131989
END
$hits2 << END
1933.96 2.38419e-07
1975.88 2.38419e-07
2048.13 2.38419e-07
2373.2 2.38419e-07
580.736 2.38419e-07
1994.22 2.38419e-07
2061.79 2.38419e-07
2301.61 2.38419e-07
2685.13 2.38419e-07
579.006 2.38419e-07
1997.5 2.38419e-07
2033.51 2.38419e-07
5214.51 2.38419e-07
5246.24 2.38419e-07
10119.8 2.38419e-07
10354.9 2.38419e-07
1296 2.38419e-07
1819.13 2.38419e-07
2120.22 2.38419e-07
END
$hits3 << END
1666.1 0.0289831
1655.53 0.0187221
1854.02 0.0145469
2020.91 0.00230742
1677.74 0.0289831
1678.3 0.0187221
2027.97 0.0145469
2248.62 0.00230742
1715.74 0.0289898
1708.22 0.0187755
4285.08 0.0204487
4240.71 0.00497007
8647.05 0.0112219
8554.5 0.00124645
END
$hits4 << END
1200.05 1.76606e-07
1254.06 1.76606e-07
1510.25 1.76606e-07
1775.23 1.76606e-07
1219.91 1.76606e-07
1265.61 1.76606e-07
1626.49 1.76606e-07
1926.34 1.76606e-07
1207.08 1.76606e-07
1223.99 1.76606e-07
2981.62 1.76606e-07
3023.72 1.76606e-07
6755.59 1.76606e-07
7107.26 1.76606e-07
END
$hits5 << END
1107.46 0.0289831
1114.37 0.0187221
1423.58 0.0145473
1612.52 0.00230789
1101.89 0.0289831
1108.71 0.0187221
1549.75 0.0145473
1747.16 0.00230789
1089.14 0.0289898
1077.47 0.0187755
2672.65 0.0204492
2619.24 0.00497055
6335.04 0.0112219
6376.34 0.00124693
END
$hits_front << END
10354.9 2.38419e-07
11517.8 7.86781e-05
11578.8 0.00131989
END
plot $hits0 with points pt 7 ps 1.3 lw 1.6 lc rgb '#d55e00' title 'fast', \
     $hits1 with points pt 6 ps 1.3 lw 1.6 lc rgb '#d55e00' title 'fast, study''s rule', \
     $hits2 with points pt 5 ps 1.3 lw 1.6 lc rgb '#0072b2' title 'robust', \
     $hits3 with points pt 4 ps 1.3 lw 1.6 lc rgb '#0072b2' title 'robust, study''s rule', \
     $hits4 with points pt 9 ps 1.3 lw 1.6 lc rgb '#009e73' title 'double', \
     $hits5 with points pt 8 ps 1.3 lw 1.6 lc rgb '#009e73' title 'double, study''s rule', \
     NaN with lines lw 1.8 dt '-' lc rgb '#222222' title 'Pareto front', \
     $hits_front with fsteps lw 1.8 dt '-' lc rgb '#222222' notitle, \
     $hits_front with points pt 6 ps 2.6 lw 1.6 lc rgb '#222222' notitle
unset key

unset label; unset arrow; unset object
set lmargin at screen 0.115; set rmargin at screen 0.735
set bmargin at screen 0.065; set tmargin at screen 0.42
set xrange [74.5032:2536.53]; set yrange [0.000118929:0.115361]
set xlabel 'pictures a second  (more is better)'; set ylabel 'picture: RMSE of a channel  (less is better)' offset -1.5
set xtics ('100' 100, '200' 200, '500' 500, '1000' 1000, '2000' 2000)
set ytics ("same\nbits" 0.000297324, '10⁻³' 1e-3, '10⁻²' 1e-2, '10⁻¹' 1e-1)
set object rectangle from graph 0, graph 0 to graph 1, first 0.00050545 fs solid noborder fc rgb '#eeeeee' behind
set arrow from first 2113.77,0.00827444 to graph 1.0,0.6169 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.6169 to graph 1.015,0.6169 nohead lw 0.8 lc rgb '#999999'
set label 'fast: irregular exact' at graph 1.02,0.6169 left
set arrow from first 1926.99,0.00237859 to graph 1.0,0.4356 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.4356 to graph 1.015,0.4356 nohead lw 0.8 lc rgb '#999999'
set label 'robust: irregular exact' at graph 1.02,0.4356 left
set arrow from first 1378.11,0.00022024 to graph 1.0,0.0896 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.0896 to graph 1.015,0.0896 nohead lw 0.8 lc rgb '#999999'
set label 'double: irregular exact' at graph 1.02,0.0896 left
$picture0 << END
99.6602 0.00827444
97.427 0.00827444
282.333 0.00827444
284.093 0.00827444
701.252 0.00827444
739.979 0.00827444
97.445 0.00827444
98.07 0.00827444
267.105 0.00827444
271.46 0.00827444
770.428 0.00827444
823.886 0.00827444
99.3888 0.00827444
100.504 0.00827444
269.953 0.00827444
269.738 0.00827444
998.781 0.00827444
1021.88 0.00827444
1864.56 0.00827444
2113.77 0.00827444
END
$picture1 << END
257.821 0.0461445
261.056 0.0362782
720.908 0.031464
732.091 0.0143035
89.4039 0.0449199
90.4945 0.0447801
244.591 0.0461445
252.709 0.0362782
803.691 0.031464
833.181 0.0143035
90.6002 0.0449199
91.5634 0.0447801
253.972 0.0461444
254.771 0.0363106
970.497 0.0379602
983.884 0.0199202
1829.52 0.0284014
2074.07 0.0121297
END
$picture2 << END
277.634 0.00237859
283.614 0.00237859
665.177 0.00237859
707.239 0.00237859
96.2343 0.00237859
264.141 0.00237859
270.427 0.00237859
732.225 0.00237859
802.188 0.00237859
100.141 0.00237859
262.811 0.00237859
271.796 0.00237859
946.253 0.00237859
979.413 0.00237859
1799.08 0.00237859
1926.99 0.00237859
152.946 0.00237859
336.263 0.00237859
345.441 0.00237859
END
$picture3 << END
245.452 0.0456435
250.35 0.035578
620.051 0.030595
612.576 0.0119613
236.947 0.0456435
237.89 0.035578
719.166 0.030595
730.108 0.0119613
245.179 0.0456438
244.332 0.035613
880.98 0.0372447
893.703 0.0183495
1643.7 0.0274202
1798.66 0.00929436
END
$picture4 << END
189.479 0.00022024
194.812 0.00022024
469.691 0.00022024
502.79 0.00022024
181.99 0.00022024
186.589 0.00022024
497.043 0.00022024
541.21 0.00022024
186.398 0.00022024
189.486 0.00022024
644.488 0.00022024
665.646 0.00022024
1246.91 0.00022024
1378.11 0.00022024
END
$picture5 << END
175.164 0.0456007
174.278 0.0355195
451.388 0.0305118
467.696 0.0117333
167.845 0.0456007
168.905 0.0355195
499.336 0.0305118
525.078 0.0117333
171.834 0.045601
170.35 0.0355545
597.914 0.0371784
600.684 0.0182034
1216.38 0.0273262
1315.68 0.00899837
END
$picture_front << END
1378.11 0.00022024
1926.99 0.00237859
2113.77 0.00827444
END
plot $picture0 with points pt 7 ps 1.3 lw 1.6 lc rgb '#d55e00' title 'fast', \
     $picture1 with points pt 6 ps 1.3 lw 1.6 lc rgb '#d55e00' title 'fast, study''s rule', \
     $picture2 with points pt 5 ps 1.3 lw 1.6 lc rgb '#0072b2' title 'robust', \
     $picture3 with points pt 4 ps 1.3 lw 1.6 lc rgb '#0072b2' title 'robust, study''s rule', \
     $picture4 with points pt 9 ps 1.3 lw 1.6 lc rgb '#009e73' title 'double', \
     $picture5 with points pt 8 ps 1.3 lw 1.6 lc rgb '#009e73' title 'double, study''s rule', \
     NaN with lines lw 1.8 dt '-' lc rgb '#222222' title 'Pareto front', \
     $picture_front with fsteps lw 1.8 dt '-' lc rgb '#222222' notitle, \
     $picture_front with points pt 6 ps 2.6 lw 1.6 lc rgb '#222222' notitle
unset multiplot
unset output

reset
set terminal pngcairo size 1100,1240 font 'DejaVu Sans,12' noenhanced background rgb 'white'
set output 'balls.png'
set encoding utf8
set logscale xy
set border 3 lc rgb '#444444'
set tics nomirror
set grid lc rgb '#d4d4d4' lw 1 dt 1
set multiplot
set key at screen 0.05, screen 0.925 left top Left reverse vertical maxrows 2 samplen 2

unset label; unset arrow; unset object
set lmargin at screen 0.115; set rmargin at screen 0.735
set bmargin at screen 0.5; set tmargin at screen 0.855
set xrange [482.505:13894.6]; set yrange [9.53674e-08:0.072608]
set xlabel 'million nearest hits a second  (more is better)'; set ylabel 'wrong hits  (less is better)' offset -1.5
set label 'balls: speed against accuracy (GPU)' at screen 0.02, screen 0.9774 font ',20'
set label '1024x1024 primary and 1,048,576 random rays a scene; 2,097,152 in all compared with brute force in double; pictures of 512x512' at screen 0.02, screen 0.9516
set xtics ('500' 500, '1000' 1000, '2000' 2000, '5000' 5000, '10000' 10000)
set ytics ("none of\n2,097,152" 2.38419e-07, '0.0001 %%' 1e-6, '0.001 %%' 1e-5, '0.01 %%' 1e-4, '0.1 %%' 1e-3, '1 %%' 1e-2)
set object rectangle from graph 0, graph 0 to graph 1, first 4.05312e-07 fs solid noborder fc rgb '#eeeeee' behind
set arrow from first 11578.8,0.00131989 to graph 1.0,0.7041 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.7041 to graph 1.015,0.7041 nohead lw 0.8 lc rgb '#999999'
set label 'fast, study: irregular exact' at graph 1.02,0.7041 left
set arrow from first 11517.8,7.86781e-05 to graph 1.0,0.4959 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.4959 to graph 1.015,0.4959 nohead lw 0.8 lc rgb '#999999'
set label 'fast: irregular exact' at graph 1.02,0.4959 left
set arrow from first 10354.9,2.38419e-07 to graph 1.0,0.0677 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.0677 to graph 1.015,0.0677 nohead lw 0.8 lc rgb '#999999'
set label 'robust: irregular exact' at graph 1.02,0.0677 left
$hits0 << END
614.473 7.86781e-05
615.055 7.86781e-05
2065.49 7.86781e-05
2137.09 7.86781e-05
2214.35 7.86781e-05
2556.01 7.86781e-05
631.983 7.86781e-05
635.088 7.86781e-05
2123.79 7.86781e-05
2194.41 7.86781e-05
2565.51 7.86781e-05
2893.42 7.86781e-05
636.562 7.86781e-05
635.821 7.86781e-05
2138.97 7.86781e-05
2180.68 7.86781e-05
5710.2 7.86781e-05
5747.76 7.86781e-05
11371.9 7.86781e-05
11517.8 7.86781e-05
END
$hits1 << END
2031.05 0.0290365
2039.9 0.0187826
2371.74 0.0146103
2590.25 0.00238228
600.009 0.0271492
602.696 0.026958
2099.84 0.0290365
2106.52 0.0187826
2642.47 0.0146103
2946.5 0.00238228
600.548 0.0271497
602.458 0.0269585
2118.92 0.0290432
2086.8 0.018836
5629.76 0.0205107
5540.75 0.00504303
11560.4 0.0112848
11578.8 0.00131989
END
$hits2 << END
1933.96 2.38419e-07
1975.88 2.38419e-07
2048.13 2.38419e-07
2373.2 2.38419e-07
580.736 2.38419e-07
1994.22 2.38419e-07
2061.79 2.38419e-07
2301.61 2.38419e-07
2685.13 2.38419e-07
579.006 2.38419e-07
1997.5 2.38419e-07
2033.51 2.38419e-07
5214.51 2.38419e-07
5246.24 2.38419e-07
10119.8 2.38419e-07
10354.9 2.38419e-07
1296 2.38419e-07
1819.13 2.38419e-07
2120.22 2.38419e-07
END
$hits3 << END
1666.1 0.0289831
1655.53 0.0187221
1854.02 0.0145469
2020.91 0.00230742
1677.74 0.0289831
1678.3 0.0187221
2027.97 0.0145469
2248.62 0.00230742
1715.74 0.0289898
1708.22 0.0187755
4285.08 0.0204487
4240.71 0.00497007
8647.05 0.0112219
8554.5 0.00124645
END
$hits4 << END
1200.05 1.76606e-07
1254.06 1.76606e-07
1510.25 1.76606e-07
1775.23 1.76606e-07
1219.91 1.76606e-07
1265.61 1.76606e-07
1626.49 1.76606e-07
1926.34 1.76606e-07
1207.08 1.76606e-07
1223.99 1.76606e-07
2981.62 1.76606e-07
3023.72 1.76606e-07
6755.59 1.76606e-07
7107.26 1.76606e-07
END
$hits5 << END
1107.46 0.0289831
1114.37 0.0187221
1423.58 0.0145473
1612.52 0.00230789
1101.89 0.0289831
1108.71 0.0187221
1549.75 0.0145473
1747.16 0.00230789
1089.14 0.0289898
1077.47 0.0187755
2672.65 0.0204492
2619.24 0.00497055
6335.04 0.0112219
6376.34 0.00124693
END
$hits_front << END
10354.9 2.38419e-07
11517.8 7.86781e-05
11578.8 0.00131989
END
plot $hits0 with points pt 7 ps 1.3 lw 1.6 lc rgb '#d55e00' title 'fast', \
     $hits1 with points pt 6 ps 1.3 lw 1.6 lc rgb '#d55e00' title 'fast, study''s rule', \
     $hits2 with points pt 5 ps 1.3 lw 1.6 lc rgb '#0072b2' title 'robust', \
     $hits3 with points pt 4 ps 1.3 lw 1.6 lc rgb '#0072b2' title 'robust, study''s rule', \
     $hits4 with points pt 9 ps 1.3 lw 1.6 lc rgb '#009e73' title 'double', \
     $hits5 with points pt 8 ps 1.3 lw 1.6 lc rgb '#009e73' title 'double, study''s rule', \
     NaN with lines lw 1.8 dt '-' lc rgb '#222222' title 'Pareto front', \
     $hits_front with fsteps lw 1.8 dt '-' lc rgb '#222222' notitle, \
     $hits_front with points pt 6 ps 2.6 lw 1.6 lc rgb '#222222' notitle
unset key

unset label; unset arrow; unset object
set lmargin at screen 0.115; set rmargin at screen 0.735
set bmargin at screen 0.065; set tmargin at screen 0.42
set xrange [74.5032:2536.53]; set yrange [0.000118929:0.115361]
set xlabel 'pictures a second  (more is better)'; set ylabel 'picture: RMSE of a channel  (less is better)' offset -1.5
set xtics ('100' 100, '200' 200, '500' 500, '1000' 1000, '2000' 2000)
set ytics ("same\nbits" 0.000297324, '10⁻³' 1e-3, '10⁻²' 1e-2, '10⁻¹' 1e-1)
set object rectangle from graph 0, graph 0 to graph 1, first 0.00050545 fs solid noborder fc rgb '#eeeeee' behind
set arrow from first 2113.77,0.00827444 to graph 1.0,0.6169 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.6169 to graph 1.015,0.6169 nohead lw 0.8 lc rgb '#999999'
set label 'fast: irregular exact' at graph 1.02,0.6169 left
set arrow from first 1926.99,0.00237859 to graph 1.0,0.4356 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.4356 to graph 1.015,0.4356 nohead lw 0.8 lc rgb '#999999'
set label 'robust: irregular exact' at graph 1.02,0.4356 left
set arrow from first 1378.11,0.00022024 to graph 1.0,0.0896 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.0896 to graph 1.015,0.0896 nohead lw 0.8 lc rgb '#999999'
set label 'double: irregular exact' at graph 1.02,0.0896 left
$picture0 << END
99.6602 0.00827444
97.427 0.00827444
282.333 0.00827444
284.093 0.00827444
701.252 0.00827444
739.979 0.00827444
97.445 0.00827444
98.07 0.00827444
267.105 0.00827444
271.46 0.00827444
770.428 0.00827444
823.886 0.00827444
99.3888 0.00827444
100.504 0.00827444
269.953 0.00827444
269.738 0.00827444
998.781 0.00827444
1021.88 0.00827444
1864.56 0.00827444
2113.77 0.00827444
END
$picture1 << END
257.821 0.0461445
261.056 0.0362782
720.908 0.031464
732.091 0.0143035
89.4039 0.0449199
90.4945 0.0447801
244.591 0.0461445
252.709 0.0362782
803.691 0.031464
833.181 0.0143035
90.6002 0.0449199
91.5634 0.0447801
253.972 0.0461444
254.771 0.0363106
970.497 0.0379602
983.884 0.0199202
1829.52 0.0284014
2074.07 0.0121297
END
$picture2 << END
277.634 0.00237859
283.614 0.00237859
665.177 0.00237859
707.239 0.00237859
96.2343 0.00237859
264.141 0.00237859
270.427 0.00237859
732.225 0.00237859
802.188 0.00237859
100.141 0.00237859
262.811 0.00237859
271.796 0.00237859
946.253 0.00237859
979.413 0.00237859
1799.08 0.00237859
1926.99 0.00237859
152.946 0.00237859
336.263 0.00237859
345.441 0.00237859
END
$picture3 << END
245.452 0.0456435
250.35 0.035578
620.051 0.030595
612.576 0.0119613
236.947 0.0456435
237.89 0.035578
719.166 0.030595
730.108 0.0119613
245.179 0.0456438
244.332 0.035613
880.98 0.0372447
893.703 0.0183495
1643.7 0.0274202
1798.66 0.00929436
END
$picture4 << END
189.479 0.00022024
194.812 0.00022024
469.691 0.00022024
502.79 0.00022024
181.99 0.00022024
186.589 0.00022024
497.043 0.00022024
541.21 0.00022024
186.398 0.00022024
189.486 0.00022024
644.488 0.00022024
665.646 0.00022024
1246.91 0.00022024
1378.11 0.00022024
END
$picture5 << END
175.164 0.0456007
174.278 0.0355195
451.388 0.0305118
467.696 0.0117333
167.845 0.0456007
168.905 0.0355195
499.336 0.0305118
525.078 0.0117333
171.834 0.045601
170.35 0.0355545
597.914 0.0371784
600.684 0.0182034
1216.38 0.0273262
1315.68 0.00899837
END
$picture_front << END
1378.11 0.00022024
1926.99 0.00237859
2113.77 0.00827444
END
plot $picture0 with points pt 7 ps 1.3 lw 1.6 lc rgb '#d55e00' title 'fast', \
     $picture1 with points pt 6 ps 1.3 lw 1.6 lc rgb '#d55e00' title 'fast, study''s rule', \
     $picture2 with points pt 5 ps 1.3 lw 1.6 lc rgb '#0072b2' title 'robust', \
     $picture3 with points pt 4 ps 1.3 lw 1.6 lc rgb '#0072b2' title 'robust, study''s rule', \
     $picture4 with points pt 9 ps 1.3 lw 1.6 lc rgb '#009e73' title 'double', \
     $picture5 with points pt 8 ps 1.3 lw 1.6 lc rgb '#009e73' title 'double, study''s rule', \
     NaN with lines lw 1.8 dt '-' lc rgb '#222222' title 'Pareto front', \
     $picture_front with fsteps lw 1.8 dt '-' lc rgb '#222222' notitle, \
     $picture_front with points pt 6 ps 2.6 lw 1.6 lc rgb '#222222' notitle
unset multiplot
unset output

reset
set terminal svg size 1100,1240 font 'DejaVu Sans,15' noenhanced background rgb 'white'
set output 'gears.svg'
set encoding utf8
set logscale xy
set border 3 lc rgb '#444444'
set tics nomirror
set grid lc rgb '#d4d4d4' lw 1 dt 1
set multiplot
set key at screen 0.05, screen 0.925 left top Left reverse vertical maxrows 2 samplen 2

unset label; unset arrow; unset object
set lmargin at screen 0.115; set rmargin at screen 0.735
set bmargin at screen 0.5; set tmargin at screen 0.855
set xrange [560.321:9909.67]; set yrange [9.53674e-08:0.00213861]
set xlabel 'million nearest hits a second  (more is better)'; set ylabel 'wrong hits  (less is better)' offset -1.5
set label 'gears: speed against accuracy (GPU)' at screen 0.02, screen 0.9774 font ',20'
set label '1024x1024 primary and 1,048,576 random rays a scene; 2,097,152 in all compared with brute force in double; pictures of 512x512' at screen 0.02, screen 0.9516
set xtics ('700' 700, '1000' 1000, '1500' 1500, '2000' 2000, '3000' 3000, '5000' 5000, '7000' 7000)
set ytics ("none of\n2,097,152" 2.38419e-07, '0.0001 %%' 1e-6, '0.001 %%' 1e-5, '0.01 %%' 1e-4, '0.1 %%' 1e-3)
set object rectangle from graph 0, graph 0 to graph 1, first 4.05312e-07 fs solid noborder fc rgb '#eeeeee' behind
set arrow from first 8258.06,3.21865e-07 to graph 1.0,0.1214 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.1214 to graph 1.015,0.1214 nohead lw 0.8 lc rgb '#999999'
set label 'fast: irregular exact' at graph 1.02,0.1214 left
$hits0 << END
1317.17 3.21865e-07
1368.9 3.21865e-07
2537.7 3.21865e-07
2727.6 3.21865e-07
2516.36 3.21865e-07
2864.59 3.21865e-07
1302.07 3.21865e-07
1347.2 3.21865e-07
2644.82 3.21865e-07
2865.46 3.21865e-07
2839.39 3.21865e-07
3320.97 3.21865e-07
1326.29 3.21865e-07
1360.71 3.21865e-07
2981.08 3.21865e-07
3245 3.21865e-07
2921.28 3.21865e-07
2794 3.21865e-07
6336.27 3.21865e-07
8258.06 3.21865e-07
END
$hits1 << END
1293.59 0.000182629
1349 0.000171185
2509.52 0.000133038
2680.52 6.19888e-05
2485.81 0.00069952
2827.39 0.000184536
1269.04 0.000182629
1317.36 0.000171185
2614.54 0.000133038
2800.09 6.19888e-05
2837.92 0.00069952
3275.49 0.000184536
1306.62 0.000182629
1342.37 0.000171185
2781.07 0.000366688
3017.45 6.34193e-05
2900.98 0.000855446
2813.07 0.000384808
6241.52 0.000174046
7970.81 2.00272e-05
END
$hits2 << END
1120.06 2.38419e-07
1165.98 2.38419e-07
2217.65 2.38419e-07
2414.65 2.38419e-07
2174.17 2.38419e-07
2546.87 2.38419e-07
1112.51 2.38419e-07
1145.03 2.38419e-07
2285.63 2.38419e-07
2493 2.38419e-07
2469.14 2.38419e-07
2901.36 2.38419e-07
1140.47 2.38419e-07
1173.58 2.38419e-07
2505.68 2.38419e-07
2727.83 2.38419e-07
2577.52 2.38419e-07
2449.67 2.38419e-07
5495.22 2.38419e-07
7021.97 2.38419e-07
1932.02 2.38419e-07
1998.48 2.38419e-07
2833.5 2.38419e-07
END
$hits3 << END
1049.53 0.000182629
1083.15 0.000171185
1937.27 0.000133038
2091.46 6.19888e-05
1899.54 0.00069952
2126.83 0.000184536
1045.25 0.000182629
1083.78 0.000171185
1981.02 0.000133038
2141.91 6.19888e-05
2128.9 0.00069952
2427.17 0.000184536
1070.15 0.000182629
1105.61 0.000171185
2222.01 0.000366688
2366.95 6.34193e-05
2264.78 0.000855446
2127.72 0.000384808
4805.75 0.000174046
5991.59 2.00272e-05
END
$hits4 << END
741.039 1.76606e-07
763.405 1.76606e-07
1390.09 1.76606e-07
1508.45 1.76606e-07
1399.33 1.76606e-07
1659.43 1.76606e-07
733.763 1.76606e-07
758.949 1.76606e-07
1435.52 1.76606e-07
1546.75 1.76606e-07
1563.4 1.76606e-07
1838.78 1.76606e-07
769.59 1.76606e-07
770.459 1.76606e-07
1689.03 1.76606e-07
1766.47 1.76606e-07
1643.29 1.76606e-07
1513.5 1.76606e-07
3747.48 1.76606e-07
4767.64 1.76606e-07
END
$hits5 << END
672.385 0.000182629
693.635 0.000171185
1272.44 0.000133038
1375.94 6.19888e-05
1301.4 0.00069952
1512.49 0.000184536
681.715 0.000182629
701.933 0.000171185
1304.1 0.000133038
1405.36 6.19888e-05
1437.32 0.00069952
1679.25 0.000184536
707.778 0.000182629
716.256 0.000171185
1528.89 0.000366688
1607.22 6.34193e-05
1505.67 0.000855446
1363.54 0.000384808
3454.54 0.000174046
4411.12 2.00272e-05
END
$hits_front << END
8258.06 3.21865e-07
END
plot $hits0 with points pt 7 ps 1.3 lw 1.6 lc rgb '#d55e00' title 'fast', \
     $hits1 with points pt 6 ps 1.3 lw 1.6 lc rgb '#d55e00' title 'fast, study''s rule', \
     $hits2 with points pt 5 ps 1.3 lw 1.6 lc rgb '#0072b2' title 'robust', \
     $hits3 with points pt 4 ps 1.3 lw 1.6 lc rgb '#0072b2' title 'robust, study''s rule', \
     $hits4 with points pt 9 ps 1.3 lw 1.6 lc rgb '#009e73' title 'double', \
     $hits5 with points pt 8 ps 1.3 lw 1.6 lc rgb '#009e73' title 'double, study''s rule', \
     NaN with lines lw 1.8 dt '-' lc rgb '#222222' title 'Pareto front', \
     $hits_front with fsteps lw 1.8 dt '-' lc rgb '#222222' notitle, \
     $hits_front with points pt 6 ps 2.6 lw 1.6 lc rgb '#222222' notitle
unset key

unset label; unset arrow; unset object
set lmargin at screen 0.115; set rmargin at screen 0.735
set bmargin at screen 0.065; set tmargin at screen 0.42
set xrange [113.476:2570.25]; set yrange [6.7499e-05:0.0151955]
set xlabel 'pictures a second  (more is better)'; set ylabel 'picture: RMSE of a channel  (less is better)' offset -1.5
set xtics ('200' 200, '500' 500, '1000' 1000, '2000' 2000)
set ytics ("same\nbits" 0.000168747, '10⁻³' 1e-3, '10⁻²' 1e-2)
set object rectangle from graph 0, graph 0 to graph 1, first 0.000286871 fs solid noborder fc rgb '#eeeeee' behind
set arrow from first 2141.88,0.0036314 to graph 1.0,0.7357 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.7357 to graph 1.015,0.7357 nohead lw 0.8 lc rgb '#999999'
set label 'fast: irregular exact' at graph 1.02,0.7357 left
set arrow from first 1663.03,0.00160758 to graph 1.0,0.5853 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.5853 to graph 1.015,0.5853 nohead lw 0.8 lc rgb '#999999'
set label 'robust: irregular exact' at graph 1.02,0.5853 left
set arrow from first 1311.76,0.000124998 to graph 1.0,0.1138 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.1138 to graph 1.015,0.1138 nohead lw 0.8 lc rgb '#999999'
set label 'double: irregular exact' at graph 1.02,0.1138 left
$picture0 << END
267.135 0.0036314
273.539 0.0036314
646.074 0.0036314
683.121 0.0036314
926.913 0.0036314
1088.81 0.0036314
265.695 0.0036314
269.172 0.0036314
592.944 0.0036314
658.879 0.0036314
876.455 0.0036314
1024.05 0.0036314
269.548 0.0036314
269.922 0.0036314
715.43 0.0036314
717.484 0.0036314
752.978 0.0036314
758.461 0.0036314
1779 0.0036314
2141.88 0.0036314
END
$picture1 << END
251.176 0.00473662
260.603 0.00475973
604.284 0.00396118
648.26 0.00436168
895.672 0.006064
1023.68 0.00475632
243.189 0.00473662
253.89 0.00475973
573.237 0.00396118
614.443 0.00436168
845.759 0.006064
988.924 0.00475632
250.431 0.00473662
257.677 0.00475973
683.611 0.00438677
652.563 0.00436168
719.202 0.00607821
708.682 0.00554194
1676.05 0.00390205
2079.31 0.00387509
END
$picture2 << END
196.347 0.00160758
205.664 0.00160758
522.846 0.00160758
573.73 0.00160758
774.222 0.00160758
902.03 0.00160758
200.972 0.00160758
210.922 0.00160758
494.047 0.00160758
552.627 0.00160758
748.128 0.00160758
864.768 0.00160758
210.801 0.00160758
212.721 0.00160758
570.265 0.00160758
577.271 0.00160758
612.494 0.00160758
606.689 0.00160758
1380.61 0.00160758
1663.03 0.00160758
393.76 0.00160758
578.028 0.00160758
652.673 0.00160758
END
$picture3 << END
182.952 0.00344683
193.459 0.00347858
473.205 0.00223184
530.597 0.00289851
689.132 0.00515237
816.887 0.00346756
190.623 0.00344683
196.752 0.00347858
474.478 0.00223184
515.626 0.00289851
720.477 0.00515237
820.749 0.00346756
199.748 0.00344683
197.884 0.00347858
546.645 0.00292125
547.621 0.00289851
580.889 0.00517295
580.326 0.0044849
1299.92 0.00214856
1588.15 0.00209923
END
$picture4 << END
143.772 0.000124998
147.267 0.000124998
368.714 0.000124998
415.802 0.000124998
597.925 0.000124998
708.441 0.000124998
142.302 0.000124998
145.237 0.000124998
344.049 0.000124998
391.423 0.000124998
549.152 0.000124998
646.341 0.000124998
152.686 0.000124998
146.028 0.000124998
400.042 0.000124998
390.878 0.000124998
431.321 0.000124998
431.798 0.000124998
1027.05 0.000124998
1311.76 0.000124998
END
$picture5 << END
138.649 0.00304899
143.88 0.00308483
354.316 0.00157317
394.207 0.00241185
564.417 0.00489516
660.982 0.0030724
136.172 0.00304899
139.502 0.00308483
338.197 0.00157317
374.17 0.00241185
541.979 0.00489516
634.196 0.0030724
147.925 0.00304899
143.285 0.00308483
388.739 0.00245508
380.665 0.00241185
413.076 0.00491682
415.476 0.00418689
1004.82 0.00142465
1259.22 0.00134998
END
$picture_front << END
1311.76 0.000124998
1663.03 0.00160758
2141.88 0.0036314
END
plot $picture0 with points pt 7 ps 1.3 lw 1.6 lc rgb '#d55e00' title 'fast', \
     $picture1 with points pt 6 ps 1.3 lw 1.6 lc rgb '#d55e00' title 'fast, study''s rule', \
     $picture2 with points pt 5 ps 1.3 lw 1.6 lc rgb '#0072b2' title 'robust', \
     $picture3 with points pt 4 ps 1.3 lw 1.6 lc rgb '#0072b2' title 'robust, study''s rule', \
     $picture4 with points pt 9 ps 1.3 lw 1.6 lc rgb '#009e73' title 'double', \
     $picture5 with points pt 8 ps 1.3 lw 1.6 lc rgb '#009e73' title 'double, study''s rule', \
     NaN with lines lw 1.8 dt '-' lc rgb '#222222' title 'Pareto front', \
     $picture_front with fsteps lw 1.8 dt '-' lc rgb '#222222' notitle, \
     $picture_front with points pt 6 ps 2.6 lw 1.6 lc rgb '#222222' notitle
unset multiplot
unset output

reset
set terminal pngcairo size 1100,1240 font 'DejaVu Sans,12' noenhanced background rgb 'white'
set output 'gears.png'
set encoding utf8
set logscale xy
set border 3 lc rgb '#444444'
set tics nomirror
set grid lc rgb '#d4d4d4' lw 1 dt 1
set multiplot
set key at screen 0.05, screen 0.925 left top Left reverse vertical maxrows 2 samplen 2

unset label; unset arrow; unset object
set lmargin at screen 0.115; set rmargin at screen 0.735
set bmargin at screen 0.5; set tmargin at screen 0.855
set xrange [560.321:9909.67]; set yrange [9.53674e-08:0.00213861]
set xlabel 'million nearest hits a second  (more is better)'; set ylabel 'wrong hits  (less is better)' offset -1.5
set label 'gears: speed against accuracy (GPU)' at screen 0.02, screen 0.9774 font ',20'
set label '1024x1024 primary and 1,048,576 random rays a scene; 2,097,152 in all compared with brute force in double; pictures of 512x512' at screen 0.02, screen 0.9516
set xtics ('700' 700, '1000' 1000, '1500' 1500, '2000' 2000, '3000' 3000, '5000' 5000, '7000' 7000)
set ytics ("none of\n2,097,152" 2.38419e-07, '0.0001 %%' 1e-6, '0.001 %%' 1e-5, '0.01 %%' 1e-4, '0.1 %%' 1e-3)
set object rectangle from graph 0, graph 0 to graph 1, first 4.05312e-07 fs solid noborder fc rgb '#eeeeee' behind
set arrow from first 8258.06,3.21865e-07 to graph 1.0,0.1214 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.1214 to graph 1.015,0.1214 nohead lw 0.8 lc rgb '#999999'
set label 'fast: irregular exact' at graph 1.02,0.1214 left
$hits0 << END
1317.17 3.21865e-07
1368.9 3.21865e-07
2537.7 3.21865e-07
2727.6 3.21865e-07
2516.36 3.21865e-07
2864.59 3.21865e-07
1302.07 3.21865e-07
1347.2 3.21865e-07
2644.82 3.21865e-07
2865.46 3.21865e-07
2839.39 3.21865e-07
3320.97 3.21865e-07
1326.29 3.21865e-07
1360.71 3.21865e-07
2981.08 3.21865e-07
3245 3.21865e-07
2921.28 3.21865e-07
2794 3.21865e-07
6336.27 3.21865e-07
8258.06 3.21865e-07
END
$hits1 << END
1293.59 0.000182629
1349 0.000171185
2509.52 0.000133038
2680.52 6.19888e-05
2485.81 0.00069952
2827.39 0.000184536
1269.04 0.000182629
1317.36 0.000171185
2614.54 0.000133038
2800.09 6.19888e-05
2837.92 0.00069952
3275.49 0.000184536
1306.62 0.000182629
1342.37 0.000171185
2781.07 0.000366688
3017.45 6.34193e-05
2900.98 0.000855446
2813.07 0.000384808
6241.52 0.000174046
7970.81 2.00272e-05
END
$hits2 << END
1120.06 2.38419e-07
1165.98 2.38419e-07
2217.65 2.38419e-07
2414.65 2.38419e-07
2174.17 2.38419e-07
2546.87 2.38419e-07
1112.51 2.38419e-07
1145.03 2.38419e-07
2285.63 2.38419e-07
2493 2.38419e-07
2469.14 2.38419e-07
2901.36 2.38419e-07
1140.47 2.38419e-07
1173.58 2.38419e-07
2505.68 2.38419e-07
2727.83 2.38419e-07
2577.52 2.38419e-07
2449.67 2.38419e-07
5495.22 2.38419e-07
7021.97 2.38419e-07
1932.02 2.38419e-07
1998.48 2.38419e-07
2833.5 2.38419e-07
END
$hits3 << END
1049.53 0.000182629
1083.15 0.000171185
1937.27 0.000133038
2091.46 6.19888e-05
1899.54 0.00069952
2126.83 0.000184536
1045.25 0.000182629
1083.78 0.000171185
1981.02 0.000133038
2141.91 6.19888e-05
2128.9 0.00069952
2427.17 0.000184536
1070.15 0.000182629
1105.61 0.000171185
2222.01 0.000366688
2366.95 6.34193e-05
2264.78 0.000855446
2127.72 0.000384808
4805.75 0.000174046
5991.59 2.00272e-05
END
$hits4 << END
741.039 1.76606e-07
763.405 1.76606e-07
1390.09 1.76606e-07
1508.45 1.76606e-07
1399.33 1.76606e-07
1659.43 1.76606e-07
733.763 1.76606e-07
758.949 1.76606e-07
1435.52 1.76606e-07
1546.75 1.76606e-07
1563.4 1.76606e-07
1838.78 1.76606e-07
769.59 1.76606e-07
770.459 1.76606e-07
1689.03 1.76606e-07
1766.47 1.76606e-07
1643.29 1.76606e-07
1513.5 1.76606e-07
3747.48 1.76606e-07
4767.64 1.76606e-07
END
$hits5 << END
672.385 0.000182629
693.635 0.000171185
1272.44 0.000133038
1375.94 6.19888e-05
1301.4 0.00069952
1512.49 0.000184536
681.715 0.000182629
701.933 0.000171185
1304.1 0.000133038
1405.36 6.19888e-05
1437.32 0.00069952
1679.25 0.000184536
707.778 0.000182629
716.256 0.000171185
1528.89 0.000366688
1607.22 6.34193e-05
1505.67 0.000855446
1363.54 0.000384808
3454.54 0.000174046
4411.12 2.00272e-05
END
$hits_front << END
8258.06 3.21865e-07
END
plot $hits0 with points pt 7 ps 1.3 lw 1.6 lc rgb '#d55e00' title 'fast', \
     $hits1 with points pt 6 ps 1.3 lw 1.6 lc rgb '#d55e00' title 'fast, study''s rule', \
     $hits2 with points pt 5 ps 1.3 lw 1.6 lc rgb '#0072b2' title 'robust', \
     $hits3 with points pt 4 ps 1.3 lw 1.6 lc rgb '#0072b2' title 'robust, study''s rule', \
     $hits4 with points pt 9 ps 1.3 lw 1.6 lc rgb '#009e73' title 'double', \
     $hits5 with points pt 8 ps 1.3 lw 1.6 lc rgb '#009e73' title 'double, study''s rule', \
     NaN with lines lw 1.8 dt '-' lc rgb '#222222' title 'Pareto front', \
     $hits_front with fsteps lw 1.8 dt '-' lc rgb '#222222' notitle, \
     $hits_front with points pt 6 ps 2.6 lw 1.6 lc rgb '#222222' notitle
unset key

unset label; unset arrow; unset object
set lmargin at screen 0.115; set rmargin at screen 0.735
set bmargin at screen 0.065; set tmargin at screen 0.42
set xrange [113.476:2570.25]; set yrange [6.7499e-05:0.0151955]
set xlabel 'pictures a second  (more is better)'; set ylabel 'picture: RMSE of a channel  (less is better)' offset -1.5
set xtics ('200' 200, '500' 500, '1000' 1000, '2000' 2000)
set ytics ("same\nbits" 0.000168747, '10⁻³' 1e-3, '10⁻²' 1e-2)
set object rectangle from graph 0, graph 0 to graph 1, first 0.000286871 fs solid noborder fc rgb '#eeeeee' behind
set arrow from first 2141.88,0.0036314 to graph 1.0,0.7357 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.7357 to graph 1.015,0.7357 nohead lw 0.8 lc rgb '#999999'
set label 'fast: irregular exact' at graph 1.02,0.7357 left
set arrow from first 1663.03,0.00160758 to graph 1.0,0.5853 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.5853 to graph 1.015,0.5853 nohead lw 0.8 lc rgb '#999999'
set label 'robust: irregular exact' at graph 1.02,0.5853 left
set arrow from first 1311.76,0.000124998 to graph 1.0,0.1138 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.1138 to graph 1.015,0.1138 nohead lw 0.8 lc rgb '#999999'
set label 'double: irregular exact' at graph 1.02,0.1138 left
$picture0 << END
267.135 0.0036314
273.539 0.0036314
646.074 0.0036314
683.121 0.0036314
926.913 0.0036314
1088.81 0.0036314
265.695 0.0036314
269.172 0.0036314
592.944 0.0036314
658.879 0.0036314
876.455 0.0036314
1024.05 0.0036314
269.548 0.0036314
269.922 0.0036314
715.43 0.0036314
717.484 0.0036314
752.978 0.0036314
758.461 0.0036314
1779 0.0036314
2141.88 0.0036314
END
$picture1 << END
251.176 0.00473662
260.603 0.00475973
604.284 0.00396118
648.26 0.00436168
895.672 0.006064
1023.68 0.00475632
243.189 0.00473662
253.89 0.00475973
573.237 0.00396118
614.443 0.00436168
845.759 0.006064
988.924 0.00475632
250.431 0.00473662
257.677 0.00475973
683.611 0.00438677
652.563 0.00436168
719.202 0.00607821
708.682 0.00554194
1676.05 0.00390205
2079.31 0.00387509
END
$picture2 << END
196.347 0.00160758
205.664 0.00160758
522.846 0.00160758
573.73 0.00160758
774.222 0.00160758
902.03 0.00160758
200.972 0.00160758
210.922 0.00160758
494.047 0.00160758
552.627 0.00160758
748.128 0.00160758
864.768 0.00160758
210.801 0.00160758
212.721 0.00160758
570.265 0.00160758
577.271 0.00160758
612.494 0.00160758
606.689 0.00160758
1380.61 0.00160758
1663.03 0.00160758
393.76 0.00160758
578.028 0.00160758
652.673 0.00160758
END
$picture3 << END
182.952 0.00344683
193.459 0.00347858
473.205 0.00223184
530.597 0.00289851
689.132 0.00515237
816.887 0.00346756
190.623 0.00344683
196.752 0.00347858
474.478 0.00223184
515.626 0.00289851
720.477 0.00515237
820.749 0.00346756
199.748 0.00344683
197.884 0.00347858
546.645 0.00292125
547.621 0.00289851
580.889 0.00517295
580.326 0.0044849
1299.92 0.00214856
1588.15 0.00209923
END
$picture4 << END
143.772 0.000124998
147.267 0.000124998
368.714 0.000124998
415.802 0.000124998
597.925 0.000124998
708.441 0.000124998
142.302 0.000124998
145.237 0.000124998
344.049 0.000124998
391.423 0.000124998
549.152 0.000124998
646.341 0.000124998
152.686 0.000124998
146.028 0.000124998
400.042 0.000124998
390.878 0.000124998
431.321 0.000124998
431.798 0.000124998
1027.05 0.000124998
1311.76 0.000124998
END
$picture5 << END
138.649 0.00304899
143.88 0.00308483
354.316 0.00157317
394.207 0.00241185
564.417 0.00489516
660.982 0.0030724
136.172 0.00304899
139.502 0.00308483
338.197 0.00157317
374.17 0.00241185
541.979 0.00489516
634.196 0.0030724
147.925 0.00304899
143.285 0.00308483
388.739 0.00245508
380.665 0.00241185
413.076 0.00491682
415.476 0.00418689
1004.82 0.00142465
1259.22 0.00134998
END
$picture_front << END
1311.76 0.000124998
1663.03 0.00160758
2141.88 0.0036314
END
plot $picture0 with points pt 7 ps 1.3 lw 1.6 lc rgb '#d55e00' title 'fast', \
     $picture1 with points pt 6 ps 1.3 lw 1.6 lc rgb '#d55e00' title 'fast, study''s rule', \
     $picture2 with points pt 5 ps 1.3 lw 1.6 lc rgb '#0072b2' title 'robust', \
     $picture3 with points pt 4 ps 1.3 lw 1.6 lc rgb '#0072b2' title 'robust, study''s rule', \
     $picture4 with points pt 9 ps 1.3 lw 1.6 lc rgb '#009e73' title 'double', \
     $picture5 with points pt 8 ps 1.3 lw 1.6 lc rgb '#009e73' title 'double, study''s rule', \
     NaN with lines lw 1.8 dt '-' lc rgb '#222222' title 'Pareto front', \
     $picture_front with fsteps lw 1.8 dt '-' lc rgb '#222222' notitle, \
     $picture_front with points pt 6 ps 2.6 lw 1.6 lc rgb '#222222' notitle
unset multiplot
unset output

reset
set terminal svg size 1100,1240 font 'DejaVu Sans,15' noenhanced background rgb 'white'
set output 'mount.svg'
set encoding utf8
set logscale xy
set border 3 lc rgb '#444444'
set tics nomirror
set grid lc rgb '#d4d4d4' lw 1 dt 1
set multiplot
set key at screen 0.05, screen 0.925 left top Left reverse vertical maxrows 2 samplen 2

unset label; unset arrow; unset object
set lmargin at screen 0.115; set rmargin at screen 0.735
set bmargin at screen 0.5; set tmargin at screen 0.855
set xrange [347.528:8265.18]; set yrange [9.53674e-08:0.000991821]
set xlabel 'million nearest hits a second  (more is better)'; set ylabel 'wrong hits  (less is better)' offset -1.5
set label 'mount: speed against accuracy (GPU)' at screen 0.02, screen 0.9774 font ',20'
set label '1024x1024 primary and 1,048,576 random rays a scene; 2,097,152 in all compared with brute force in double; pictures of 512x512' at screen 0.02, screen 0.9516
set xtics ('500' 500, '1000' 1000, '2000' 2000, '5000' 5000)
set ytics ("none of\n2,097,152" 2.38419e-07, '0.0001 %%' 1e-6, '0.001 %%' 1e-5, '0.01 %%' 1e-4)
set object rectangle from graph 0, graph 0 to graph 1, first 4.05312e-07 fs solid noborder fc rgb '#eeeeee' behind
set arrow from first 6887.65,2.00272e-05 to graph 1.0,0.5781 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.5781 to graph 1.015,0.5781 nohead lw 0.8 lc rgb '#999999'
set label 'fast, study: irregular exact' at graph 1.02,0.5781 left
set arrow from first 6595.81,3.21865e-07 to graph 1.0,0.1315 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.1315 to graph 1.015,0.1315 nohead lw 0.8 lc rgb '#999999'
set label 'fast: irregular exact' at graph 1.02,0.1315 left
$hits0 << END
2745.42 3.21865e-07
2887.68 3.21865e-07
2266.66 3.21865e-07
2504.34 3.21865e-07
2764.53 3.21865e-07
3005.27 3.21865e-07
2847.16 3.21865e-07
3029.03 3.21865e-07
2837.3 3.21865e-07
3200.47 3.21865e-07
3310.57 3.21865e-07
3720.25 3.21865e-07
2667.75 3.21865e-07
2871.74 3.21865e-07
916.793 3.21865e-07
968.307 3.21865e-07
1951.93 3.21865e-07
2049.47 3.21865e-07
5715.68 3.21865e-07
6595.81 3.21865e-07
END
$hits1 << END
2893.29 0.000134945
3049.32 0.000113964
2386.86 5.91278e-05
2609.23 2.24113e-05
2929.25 0.000191212
3144.87 6.58035e-05
3029.59 0.000134945
3180.12 0.000113964
2990.46 5.91278e-05
3302.73 2.24113e-05
3526.47 0.000191212
3876.03 6.58035e-05
2830.2 0.000210762
3015.09 0.00019598
929.18 0.000182629
979.304 0.000395775
2016.24 0.000291824
2098.9 0.000396729
6131.74 2.00272e-05
6887.65 2.00272e-05
END
$hits2 << END
2363.45 2.38419e-07
2470.82 2.38419e-07
2048.45 2.38419e-07
2278.88 2.38419e-07
2452.24 2.38419e-07
2679.86 2.38419e-07
2508.46 2.38419e-07
2639.28 2.38419e-07
2504.05 2.38419e-07
2864.59 2.38419e-07
2920.37 2.38419e-07
3293.76 2.38419e-07
2324.38 2.38419e-07
2498.42 2.38419e-07
792.072 2.38419e-07
839.731 2.38419e-07
1726.09 2.38419e-07
1813.84 2.38419e-07
4919.01 2.38419e-07
5717.18 2.38419e-07
417.034 2.38419e-07
1188.45 2.38419e-07
2886.03 2.38419e-07
1493.49 2.38419e-07
2440.27 2.38419e-07
END
$hits3 << END
2123.79 0.000134945
2218.48 0.000113964
1821.15 5.91278e-05
1956.65 2.24113e-05
2200.97 0.000191212
2359.79 6.58035e-05
2220.81 0.000134945
2298.06 0.000113964
2156.22 5.91278e-05
2364.64 2.24113e-05
2556.8 0.000191212
2824.22 6.58035e-05
2076.49 0.000210762
2190.37 0.00019598
665.61 0.000182629
693.297 0.000395775
1479.3 0.000291824
1540.65 0.000396729
4586.79 2.00272e-05
5183.99 2.00272e-05
END
$hits4 << END
1443.75 1.76606e-07
1528.64 1.76606e-07
1248.35 1.76606e-07
1412.87 1.76606e-07
1491.93 1.76606e-07
1641.07 1.76606e-07
1475.04 1.76606e-07
1554.68 1.76606e-07
1434.55 1.76606e-07
1636.8 1.76606e-07
1669.11 1.76606e-07
1879.11 1.76606e-07
1373.06 1.76606e-07
1469.22 1.76606e-07
502.943 1.76606e-07
506.496 1.76606e-07
974.687 1.76606e-07
1020.56 1.76606e-07
3108.77 1.76606e-07
3540.96 1.76606e-07
END
$hits5 << END
1279.4 0.000134945
1332.33 0.000113964
1178.98 5.91278e-05
1296.38 2.24113e-05
1379.01 0.000191212
1495.57 6.58035e-05
1374.67 0.000134945
1440.86 0.000113964
1357.27 5.91278e-05
1509.56 2.24113e-05
1607.97 0.000191212
1763.85 6.58035e-05
1272.96 0.000210762
1352.85 0.00019598
441.814 0.000182629
444.36 0.000395775
891.925 0.000291824
920.101 0.000396729
3105.38 2.00272e-05
3455.45 2.00272e-05
END
$hits_front << END
6595.81 3.21865e-07
6887.65 2.00272e-05
END
plot $hits0 with points pt 7 ps 1.3 lw 1.6 lc rgb '#d55e00' title 'fast', \
     $hits1 with points pt 6 ps 1.3 lw 1.6 lc rgb '#d55e00' title 'fast, study''s rule', \
     $hits2 with points pt 5 ps 1.3 lw 1.6 lc rgb '#0072b2' title 'robust', \
     $hits3 with points pt 4 ps 1.3 lw 1.6 lc rgb '#0072b2' title 'robust, study''s rule', \
     $hits4 with points pt 9 ps 1.3 lw 1.6 lc rgb '#009e73' title 'double', \
     $hits5 with points pt 8 ps 1.3 lw 1.6 lc rgb '#009e73' title 'double, study''s rule', \
     NaN with lines lw 1.8 dt '-' lc rgb '#222222' title 'Pareto front', \
     $hits_front with fsteps lw 1.8 dt '-' lc rgb '#222222' notitle, \
     $hits_front with points pt 6 ps 2.6 lw 1.6 lc rgb '#222222' notitle
unset key

unset label; unset arrow; unset object
set lmargin at screen 0.115; set rmargin at screen 0.735
set bmargin at screen 0.065; set tmargin at screen 0.42
set xrange [116.601:3286.88]; set yrange [2.30065e-05:0.0130213]
set xlabel 'pictures a second  (more is better)'; set ylabel 'picture: RMSE of a channel  (less is better)' offset -1.5
set xtics ('200' 200, '500' 500, '1000' 1000, '2000' 2000)
set ytics ("same\nbits" 5.75161e-05, '10⁻³' 1e-3, '10⁻²' 1e-2)
set object rectangle from graph 0, graph 0 to graph 1, first 9.77774e-05 fs solid noborder fc rgb '#eeeeee' behind
set arrow from first 2739.07,0.00461404 to graph 1.0,0.8848 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.8848 to graph 1.015,0.8848 nohead lw 0.8 lc rgb '#999999'
set label 'fast, study: irregular exact' at graph 1.02,0.8848 left
set arrow from first 2532.41,0.00457071 to graph 1.0,0.8348 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.8348 to graph 1.015,0.8348 nohead lw 0.8 lc rgb '#999999'
set label 'fast: irregular exact' at graph 1.02,0.8348 left
set arrow from first 2193.14,0.000886952 to graph 1.0,0.5762 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.5762 to graph 1.015,0.5762 nohead lw 0.8 lc rgb '#999999'
set label 'robust, study: irregular exact' at graph 1.02,0.5762 left
set arrow from first 2169.84,0.000623504 to graph 1.0,0.5206 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.5206 to graph 1.015,0.5206 nohead lw 0.8 lc rgb '#999999'
set label 'robust: irregular exact' at graph 1.02,0.5206 left
set arrow from first 1763.05,4.26045e-05 to graph 1.0,0.0972 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.0972 to graph 1.015,0.0972 nohead lw 0.8 lc rgb '#999999'
set label 'double: irregular exact' at graph 1.02,0.0972 left
$picture0 << END
1034.05 0.00457071
1088.05 0.00457071
921.583 0.00457071
1096.03 0.00457071
1125.44 0.00457071
1292.76 0.00457071
1033.33 0.00457071
1094.92 0.00457071
923.574 0.00457071
1132.16 0.00457071
1138.31 0.00457071
1353.63 0.00457071
1014.71 0.00457071
1074.22 0.00457071
363.207 0.00457071
365.468 0.00457071
672.68 0.00457071
693.765 0.00457071
2220.88 0.00457071
2532.41 0.00457071
END
$picture1 << END
1139.8 0.00483632
1181.34 0.00477375
1071.42 0.00465629
1220.46 0.00462388
1258.96 0.00520851
1413.45 0.00470737
1137.11 0.00483632
1179.29 0.00477375
1099.73 0.00465629
1278.9 0.00462388
1292.76 0.00520851
1481.53 0.00470737
1086.2 0.00483632
1141.39 0.00477375
391.472 0.0046012
399.479 0.00460682
743.799 0.00496839
755.047 0.00472853
2447.53 0.00459381
2739.07 0.00461404
END
$picture2 << END
888.368 0.000623504
932.305 0.000623504
844.181 0.000623504
1009.5 0.000623504
1009.69 0.000623504
1163.7 0.000623504
879.438 0.000623504
923.898 0.000623504
833.736 0.000623504
1031.08 0.000623504
1013.59 0.000623504
1204.56 0.000623504
862.307 0.000623504
919.143 0.000623504
323.134 0.000623504
327.325 0.000623504
587.482 0.000623504
601.33 0.000623504
1885.82 0.000623504
2169.84 0.000623504
139.921 0.000623504
449.258 0.000623504
1227.32 0.000623504
593.465 0.000623504
702.119 0.000623504
END
$picture3 << END
895.592 0.00170222
935.322 0.00151537
865.247 0.00105972
971.459 0.000906763
1011.92 0.00257412
1124.63 0.0012872
952.798 0.00170222
983.942 0.00151537
934.981 0.00105972
1076.81 0.000906763
1085.71 0.00257412
1242.94 0.0012872
889.632 0.00170222
941.035 0.00151537
340.325 0.000817549
344.976 0.000824845
632.963 0.00204512
636.857 0.00134789
1976.47 0.000774903
2193.14 0.000886952
END
$picture4 << END
674.932 4.26045e-05
711.066 4.26045e-05
722.126 4.26045e-05
879.786 4.26045e-05
823.323 4.26045e-05
970.073 4.26045e-05
662.541 4.26045e-05
691.51 4.26045e-05
721.844 4.26045e-05
897.473 4.26045e-05
833.709 4.26045e-05
990.462 4.26045e-05
645.274 4.26045e-05
689.341 4.26045e-05
253.211 4.26045e-05
256.526 4.26045e-05
475.792 4.26045e-05
483.005 4.26045e-05
1548.03 4.26045e-05
1763.05 4.26045e-05
END
$picture5 << END
689.845 0.00158392
719 0.00138115
778.895 0.00085688
896.877 0.000658378
862.024 0.00249747
975.553 0.00112611
707.029 0.00158392
737.115 0.00138115
823.974 0.00085688
967.97 0.000658378
903.155 0.00249747
1056.64 0.00112611
653.33 0.00158392
694.444 0.00138115
263.916 0.000528801
268.342 0.000540012
500.576 0.00194775
508.081 0.00119501
1631.09 0.000460129
1838.88 0.000630814
END
$picture_front << END
1763.05 4.26045e-05
2169.84 0.000623504
2193.14 0.000886952
2532.41 0.00457071
2739.07 0.00461404
END
plot $picture0 with points pt 7 ps 1.3 lw 1.6 lc rgb '#d55e00' title 'fast', \
     $picture1 with points pt 6 ps 1.3 lw 1.6 lc rgb '#d55e00' title 'fast, study''s rule', \
     $picture2 with points pt 5 ps 1.3 lw 1.6 lc rgb '#0072b2' title 'robust', \
     $picture3 with points pt 4 ps 1.3 lw 1.6 lc rgb '#0072b2' title 'robust, study''s rule', \
     $picture4 with points pt 9 ps 1.3 lw 1.6 lc rgb '#009e73' title 'double', \
     $picture5 with points pt 8 ps 1.3 lw 1.6 lc rgb '#009e73' title 'double, study''s rule', \
     NaN with lines lw 1.8 dt '-' lc rgb '#222222' title 'Pareto front', \
     $picture_front with fsteps lw 1.8 dt '-' lc rgb '#222222' notitle, \
     $picture_front with points pt 6 ps 2.6 lw 1.6 lc rgb '#222222' notitle
unset multiplot
unset output

reset
set terminal pngcairo size 1100,1240 font 'DejaVu Sans,12' noenhanced background rgb 'white'
set output 'mount.png'
set encoding utf8
set logscale xy
set border 3 lc rgb '#444444'
set tics nomirror
set grid lc rgb '#d4d4d4' lw 1 dt 1
set multiplot
set key at screen 0.05, screen 0.925 left top Left reverse vertical maxrows 2 samplen 2

unset label; unset arrow; unset object
set lmargin at screen 0.115; set rmargin at screen 0.735
set bmargin at screen 0.5; set tmargin at screen 0.855
set xrange [347.528:8265.18]; set yrange [9.53674e-08:0.000991821]
set xlabel 'million nearest hits a second  (more is better)'; set ylabel 'wrong hits  (less is better)' offset -1.5
set label 'mount: speed against accuracy (GPU)' at screen 0.02, screen 0.9774 font ',20'
set label '1024x1024 primary and 1,048,576 random rays a scene; 2,097,152 in all compared with brute force in double; pictures of 512x512' at screen 0.02, screen 0.9516
set xtics ('500' 500, '1000' 1000, '2000' 2000, '5000' 5000)
set ytics ("none of\n2,097,152" 2.38419e-07, '0.0001 %%' 1e-6, '0.001 %%' 1e-5, '0.01 %%' 1e-4)
set object rectangle from graph 0, graph 0 to graph 1, first 4.05312e-07 fs solid noborder fc rgb '#eeeeee' behind
set arrow from first 6887.65,2.00272e-05 to graph 1.0,0.5781 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.5781 to graph 1.015,0.5781 nohead lw 0.8 lc rgb '#999999'
set label 'fast, study: irregular exact' at graph 1.02,0.5781 left
set arrow from first 6595.81,3.21865e-07 to graph 1.0,0.1315 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.1315 to graph 1.015,0.1315 nohead lw 0.8 lc rgb '#999999'
set label 'fast: irregular exact' at graph 1.02,0.1315 left
$hits0 << END
2745.42 3.21865e-07
2887.68 3.21865e-07
2266.66 3.21865e-07
2504.34 3.21865e-07
2764.53 3.21865e-07
3005.27 3.21865e-07
2847.16 3.21865e-07
3029.03 3.21865e-07
2837.3 3.21865e-07
3200.47 3.21865e-07
3310.57 3.21865e-07
3720.25 3.21865e-07
2667.75 3.21865e-07
2871.74 3.21865e-07
916.793 3.21865e-07
968.307 3.21865e-07
1951.93 3.21865e-07
2049.47 3.21865e-07
5715.68 3.21865e-07
6595.81 3.21865e-07
END
$hits1 << END
2893.29 0.000134945
3049.32 0.000113964
2386.86 5.91278e-05
2609.23 2.24113e-05
2929.25 0.000191212
3144.87 6.58035e-05
3029.59 0.000134945
3180.12 0.000113964
2990.46 5.91278e-05
3302.73 2.24113e-05
3526.47 0.000191212
3876.03 6.58035e-05
2830.2 0.000210762
3015.09 0.00019598
929.18 0.000182629
979.304 0.000395775
2016.24 0.000291824
2098.9 0.000396729
6131.74 2.00272e-05
6887.65 2.00272e-05
END
$hits2 << END
2363.45 2.38419e-07
2470.82 2.38419e-07
2048.45 2.38419e-07
2278.88 2.38419e-07
2452.24 2.38419e-07
2679.86 2.38419e-07
2508.46 2.38419e-07
2639.28 2.38419e-07
2504.05 2.38419e-07
2864.59 2.38419e-07
2920.37 2.38419e-07
3293.76 2.38419e-07
2324.38 2.38419e-07
2498.42 2.38419e-07
792.072 2.38419e-07
839.731 2.38419e-07
1726.09 2.38419e-07
1813.84 2.38419e-07
4919.01 2.38419e-07
5717.18 2.38419e-07
417.034 2.38419e-07
1188.45 2.38419e-07
2886.03 2.38419e-07
1493.49 2.38419e-07
2440.27 2.38419e-07
END
$hits3 << END
2123.79 0.000134945
2218.48 0.000113964
1821.15 5.91278e-05
1956.65 2.24113e-05
2200.97 0.000191212
2359.79 6.58035e-05
2220.81 0.000134945
2298.06 0.000113964
2156.22 5.91278e-05
2364.64 2.24113e-05
2556.8 0.000191212
2824.22 6.58035e-05
2076.49 0.000210762
2190.37 0.00019598
665.61 0.000182629
693.297 0.000395775
1479.3 0.000291824
1540.65 0.000396729
4586.79 2.00272e-05
5183.99 2.00272e-05
END
$hits4 << END
1443.75 1.76606e-07
1528.64 1.76606e-07
1248.35 1.76606e-07
1412.87 1.76606e-07
1491.93 1.76606e-07
1641.07 1.76606e-07
1475.04 1.76606e-07
1554.68 1.76606e-07
1434.55 1.76606e-07
1636.8 1.76606e-07
1669.11 1.76606e-07
1879.11 1.76606e-07
1373.06 1.76606e-07
1469.22 1.76606e-07
502.943 1.76606e-07
506.496 1.76606e-07
974.687 1.76606e-07
1020.56 1.76606e-07
3108.77 1.76606e-07
3540.96 1.76606e-07
END
$hits5 << END
1279.4 0.000134945
1332.33 0.000113964
1178.98 5.91278e-05
1296.38 2.24113e-05
1379.01 0.000191212
1495.57 6.58035e-05
1374.67 0.000134945
1440.86 0.000113964
1357.27 5.91278e-05
1509.56 2.24113e-05
1607.97 0.000191212
1763.85 6.58035e-05
1272.96 0.000210762
1352.85 0.00019598
441.814 0.000182629
444.36 0.000395775
891.925 0.000291824
920.101 0.000396729
3105.38 2.00272e-05
3455.45 2.00272e-05
END
$hits_front << END
6595.81 3.21865e-07
6887.65 2.00272e-05
END
plot $hits0 with points pt 7 ps 1.3 lw 1.6 lc rgb '#d55e00' title 'fast', \
     $hits1 with points pt 6 ps 1.3 lw 1.6 lc rgb '#d55e00' title 'fast, study''s rule', \
     $hits2 with points pt 5 ps 1.3 lw 1.6 lc rgb '#0072b2' title 'robust', \
     $hits3 with points pt 4 ps 1.3 lw 1.6 lc rgb '#0072b2' title 'robust, study''s rule', \
     $hits4 with points pt 9 ps 1.3 lw 1.6 lc rgb '#009e73' title 'double', \
     $hits5 with points pt 8 ps 1.3 lw 1.6 lc rgb '#009e73' title 'double, study''s rule', \
     NaN with lines lw 1.8 dt '-' lc rgb '#222222' title 'Pareto front', \
     $hits_front with fsteps lw 1.8 dt '-' lc rgb '#222222' notitle, \
     $hits_front with points pt 6 ps 2.6 lw 1.6 lc rgb '#222222' notitle
unset key

unset label; unset arrow; unset object
set lmargin at screen 0.115; set rmargin at screen 0.735
set bmargin at screen 0.065; set tmargin at screen 0.42
set xrange [116.601:3286.88]; set yrange [2.30065e-05:0.0130213]
set xlabel 'pictures a second  (more is better)'; set ylabel 'picture: RMSE of a channel  (less is better)' offset -1.5
set xtics ('200' 200, '500' 500, '1000' 1000, '2000' 2000)
set ytics ("same\nbits" 5.75161e-05, '10⁻³' 1e-3, '10⁻²' 1e-2)
set object rectangle from graph 0, graph 0 to graph 1, first 9.77774e-05 fs solid noborder fc rgb '#eeeeee' behind
set arrow from first 2739.07,0.00461404 to graph 1.0,0.8848 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.8848 to graph 1.015,0.8848 nohead lw 0.8 lc rgb '#999999'
set label 'fast, study: irregular exact' at graph 1.02,0.8848 left
set arrow from first 2532.41,0.00457071 to graph 1.0,0.8348 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.8348 to graph 1.015,0.8348 nohead lw 0.8 lc rgb '#999999'
set label 'fast: irregular exact' at graph 1.02,0.8348 left
set arrow from first 2193.14,0.000886952 to graph 1.0,0.5762 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.5762 to graph 1.015,0.5762 nohead lw 0.8 lc rgb '#999999'
set label 'robust, study: irregular exact' at graph 1.02,0.5762 left
set arrow from first 2169.84,0.000623504 to graph 1.0,0.5206 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.5206 to graph 1.015,0.5206 nohead lw 0.8 lc rgb '#999999'
set label 'robust: irregular exact' at graph 1.02,0.5206 left
set arrow from first 1763.05,4.26045e-05 to graph 1.0,0.0972 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.0972 to graph 1.015,0.0972 nohead lw 0.8 lc rgb '#999999'
set label 'double: irregular exact' at graph 1.02,0.0972 left
$picture0 << END
1034.05 0.00457071
1088.05 0.00457071
921.583 0.00457071
1096.03 0.00457071
1125.44 0.00457071
1292.76 0.00457071
1033.33 0.00457071
1094.92 0.00457071
923.574 0.00457071
1132.16 0.00457071
1138.31 0.00457071
1353.63 0.00457071
1014.71 0.00457071
1074.22 0.00457071
363.207 0.00457071
365.468 0.00457071
672.68 0.00457071
693.765 0.00457071
2220.88 0.00457071
2532.41 0.00457071
END
$picture1 << END
1139.8 0.00483632
1181.34 0.00477375
1071.42 0.00465629
1220.46 0.00462388
1258.96 0.00520851
1413.45 0.00470737
1137.11 0.00483632
1179.29 0.00477375
1099.73 0.00465629
1278.9 0.00462388
1292.76 0.00520851
1481.53 0.00470737
1086.2 0.00483632
1141.39 0.00477375
391.472 0.0046012
399.479 0.00460682
743.799 0.00496839
755.047 0.00472853
2447.53 0.00459381
2739.07 0.00461404
END
$picture2 << END
888.368 0.000623504
932.305 0.000623504
844.181 0.000623504
1009.5 0.000623504
1009.69 0.000623504
1163.7 0.000623504
879.438 0.000623504
923.898 0.000623504
833.736 0.000623504
1031.08 0.000623504
1013.59 0.000623504
1204.56 0.000623504
862.307 0.000623504
919.143 0.000623504
323.134 0.000623504
327.325 0.000623504
587.482 0.000623504
601.33 0.000623504
1885.82 0.000623504
2169.84 0.000623504
139.921 0.000623504
449.258 0.000623504
1227.32 0.000623504
593.465 0.000623504
702.119 0.000623504
END
$picture3 << END
895.592 0.00170222
935.322 0.00151537
865.247 0.00105972
971.459 0.000906763
1011.92 0.00257412
1124.63 0.0012872
952.798 0.00170222
983.942 0.00151537
934.981 0.00105972
1076.81 0.000906763
1085.71 0.00257412
1242.94 0.0012872
889.632 0.00170222
941.035 0.00151537
340.325 0.000817549
344.976 0.000824845
632.963 0.00204512
636.857 0.00134789
1976.47 0.000774903
2193.14 0.000886952
END
$picture4 << END
674.932 4.26045e-05
711.066 4.26045e-05
722.126 4.26045e-05
879.786 4.26045e-05
823.323 4.26045e-05
970.073 4.26045e-05
662.541 4.26045e-05
691.51 4.26045e-05
721.844 4.26045e-05
897.473 4.26045e-05
833.709 4.26045e-05
990.462 4.26045e-05
645.274 4.26045e-05
689.341 4.26045e-05
253.211 4.26045e-05
256.526 4.26045e-05
475.792 4.26045e-05
483.005 4.26045e-05
1548.03 4.26045e-05
1763.05 4.26045e-05
END
$picture5 << END
689.845 0.00158392
719 0.00138115
778.895 0.00085688
896.877 0.000658378
862.024 0.00249747
975.553 0.00112611
707.029 0.00158392
737.115 0.00138115
823.974 0.00085688
967.97 0.000658378
903.155 0.00249747
1056.64 0.00112611
653.33 0.00158392
694.444 0.00138115
263.916 0.000528801
268.342 0.000540012
500.576 0.00194775
508.081 0.00119501
1631.09 0.000460129
1838.88 0.000630814
END
$picture_front << END
1763.05 4.26045e-05
2169.84 0.000623504
2193.14 0.000886952
2532.41 0.00457071
2739.07 0.00461404
END
plot $picture0 with points pt 7 ps 1.3 lw 1.6 lc rgb '#d55e00' title 'fast', \
     $picture1 with points pt 6 ps 1.3 lw 1.6 lc rgb '#d55e00' title 'fast, study''s rule', \
     $picture2 with points pt 5 ps 1.3 lw 1.6 lc rgb '#0072b2' title 'robust', \
     $picture3 with points pt 4 ps 1.3 lw 1.6 lc rgb '#0072b2' title 'robust, study''s rule', \
     $picture4 with points pt 9 ps 1.3 lw 1.6 lc rgb '#009e73' title 'double', \
     $picture5 with points pt 8 ps 1.3 lw 1.6 lc rgb '#009e73' title 'double, study''s rule', \
     NaN with lines lw 1.8 dt '-' lc rgb '#222222' title 'Pareto front', \
     $picture_front with fsteps lw 1.8 dt '-' lc rgb '#222222' notitle, \
     $picture_front with points pt 6 ps 2.6 lw 1.6 lc rgb '#222222' notitle
unset multiplot
unset output

reset
set terminal svg size 1100,1240 font 'DejaVu Sans,15' noenhanced background rgb 'white'
set output 'rings.svg'
set encoding utf8
set logscale xy
set border 3 lc rgb '#444444'
set tics nomirror
set grid lc rgb '#d4d4d4' lw 1 dt 1
set multiplot
set key at screen 0.05, screen 0.925 left top Left reverse vertical maxrows 2 samplen 2

unset label; unset arrow; unset object
set lmargin at screen 0.115; set rmargin at screen 0.735
set bmargin at screen 0.5; set tmargin at screen 0.855
set xrange [275.818:6183.13]; set yrange [9.53674e-08:0.0598156]
set xlabel 'million nearest hits a second  (more is better)'; set ylabel 'wrong hits  (less is better)' offset -1.5
set label 'rings: speed against accuracy (GPU)' at screen 0.02, screen 0.9774 font ',20'
set label '1024x1024 primary and 1,048,576 random rays a scene; 2,097,152 in all compared with brute force in double; pictures of 512x512' at screen 0.02, screen 0.9516
set xtics ('500' 500, '1000' 1000, '2000' 2000, '5000' 5000)
set ytics ("none of\n2,097,152" 2.38419e-07, '0.0001 %%' 1e-6, '0.001 %%' 1e-5, '0.01 %%' 1e-4, '0.1 %%' 1e-3, '1 %%' 1e-2)
set object rectangle from graph 0, graph 0 to graph 1, first 4.05312e-07 fs solid noborder fc rgb '#eeeeee' behind
set arrow from first 5152.61,0.00862455 to graph 1.0,0.8549 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.8549 to graph 1.015,0.8549 nohead lw 0.8 lc rgb '#999999'
set label 'fast, study: irregular exact' at graph 1.02,0.8549 left
set arrow from first 4947.23,0.000258923 to graph 1.0,0.5923 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.5923 to graph 1.015,0.5923 nohead lw 0.8 lc rgb '#999999'
set label 'fast: irregular exact' at graph 1.02,0.5923 left
set arrow from first 3324.17,2.38419e-07 to graph 1.0,0.0686 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.0686 to graph 1.015,0.0686 nohead lw 0.8 lc rgb '#999999'
set label 'robust: irregular exact' at graph 1.02,0.0686 left
$hits0 << END
2022.47 0.000258923
2289.71 0.000258923
1890.72 0.000258923
2337.15 0.000258923
2091.73 0.000258923
2596.2 0.000258923
2086.87 0.000258923
2389.03 0.000258923
2140.44 0.000258923
2713.48 0.000258923
2333.57 0.000258923
2958.2 0.000258923
2058.23 0.000258923
2358.94 0.000258923
1624.35 0.000258923
1938.88 0.000258923
1621.62 0.000258923
1925.49 0.000258923
4103.44 0.000258923
4947.23 0.000258923
END
$hits1 << END
2112.57 0.00740767
2406.32 0.00626707
1996.95 0.0239263
2419.2 0.010325
2239.48 0.0226121
2688.88 0.0121698
2194.41 0.00740767
2492.72 0.00626707
2279.12 0.0239263
2809.09 0.010325
2483.08 0.0226121
3084.34 0.0121698
2161.12 0.00840855
2477.36 0.00634432
1719.34 0.0187721
2040.16 0.0170641
1707.51 0.0174308
2015.19 0.0124621
4301.67 0.0168166
5152.61 0.00862455
END
$hits2 << END
1418.04 2.38419e-07
1619.57 2.38419e-07
1351.68 2.38419e-07
1665.13 2.38419e-07
1483.59 2.38419e-07
1842.5 2.38419e-07
1444.03 2.38419e-07
1647.13 2.38419e-07
1473.71 2.38419e-07
1838.32 2.38419e-07
1582.46 2.38419e-07
2015.87 2.38419e-07
1426.21 2.38419e-07
1635.62 2.38419e-07
1122.71 2.38419e-07
1339.85 2.38419e-07
1131.55 2.38419e-07
1338.75 2.38419e-07
2732.6 2.38419e-07
3324.17 2.38419e-07
330.982 2.38419e-07
825.39 2.38419e-07
1970.65 2.38419e-07
1061.14 2.38419e-07
1332.28 2.38419e-07
END
$hits3 << END
1524.16 0.00717831
1706.89 0.00603485
1499.34 0.0237164
1767.09 0.0100956
1643.95 0.0224056
1974.15 0.011939
1558.45 0.00717831
1745.72 0.00603485
1623.34 0.0237164
1971.78 0.0100956
1759.78 0.0224056
2153.24 0.011939
1530.61 0.00818014
1733.53 0.00611162
1226.35 0.0185757
1450.01 0.0168576
1223.21 0.0172191
1438.68 0.0122404
2954.47 0.0166078
3539.62 0.00839329
END
$hits4 << END
829.622 1.76606e-07
944.146 1.76606e-07
848.923 1.76606e-07
1091.01 1.76606e-07
910.728 1.76606e-07
1173.85 1.76606e-07
833.611 1.76606e-07
955.921 1.76606e-07
868.383 1.76606e-07
1115.45 1.76606e-07
929.272 1.76606e-07
1196.81 1.76606e-07
819.005 1.76606e-07
941.433 1.76606e-07
620.412 1.76606e-07
741.743 1.76606e-07
627.181 1.76606e-07
752.276 1.76606e-07
1622.3 1.76606e-07
1996.04 1.76606e-07
END
$hits5 << END
865.367 0.00717831
971.566 0.00603533
923.654 0.0237164
1138.07 0.0100975
996.306 0.0224056
1220.86 0.01194
901.421 0.00717831
1019.51 0.00603533
994.627 0.0237164
1217.28 0.010098
1056.04 0.0224056
1323.26 0.01194
889.19 0.00818014
1000.47 0.0061121
683.3 0.01858
810.658 0.0168648
686.363 0.0172191
813.526 0.0122404
1783.68 0.0166078
2142.75 0.00839329
END
$hits_front << END
3324.17 2.38419e-07
4947.23 0.000258923
5152.61 0.00862455
END
plot $hits0 with points pt 7 ps 1.3 lw 1.6 lc rgb '#d55e00' title 'fast', \
     $hits1 with points pt 6 ps 1.3 lw 1.6 lc rgb '#d55e00' title 'fast, study''s rule', \
     $hits2 with points pt 5 ps 1.3 lw 1.6 lc rgb '#0072b2' title 'robust', \
     $hits3 with points pt 4 ps 1.3 lw 1.6 lc rgb '#0072b2' title 'robust, study''s rule', \
     $hits4 with points pt 9 ps 1.3 lw 1.6 lc rgb '#009e73' title 'double', \
     $hits5 with points pt 8 ps 1.3 lw 1.6 lc rgb '#009e73' title 'double, study''s rule', \
     NaN with lines lw 1.8 dt '-' lc rgb '#222222' title 'Pareto front', \
     $hits_front with fsteps lw 1.8 dt '-' lc rgb '#222222' notitle, \
     $hits_front with points pt 6 ps 2.6 lw 1.6 lc rgb '#222222' notitle
unset key

unset label; unset arrow; unset object
set lmargin at screen 0.115; set rmargin at screen 0.735
set bmargin at screen 0.065; set tmargin at screen 0.42
set xrange [43.9524:986.688]; set yrange [5.1533e-05:0.137565]
set xlabel 'pictures a second  (more is better)'; set ylabel 'picture: RMSE of a channel  (less is better)' offset -1.5
set xtics ('50' 50, '100' 100, '200' 200, '500' 500)
set ytics ("same\nbits" 0.000128833, '10⁻³' 1e-3, '10⁻²' 1e-2, '10⁻¹' 1e-1)
set object rectangle from graph 0, graph 0 to graph 1, first 0.000219015 fs solid noborder fc rgb '#eeeeee' behind
set arrow from first 822.24,0.0362936 to graph 1.0,0.8311 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.8311 to graph 1.015,0.8311 nohead lw 0.8 lc rgb '#999999'
set label 'fast, study: irregular exact' at graph 1.02,0.8311 left
set arrow from first 808.937,0.0240238 to graph 1.0,0.7788 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.7788 to graph 1.015,0.7788 nohead lw 0.8 lc rgb '#999999'
set label 'fast: irregular exact' at graph 1.02,0.7788 left
set arrow from first 553.275,0.00103066 to graph 1.0,0.3797 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.3797 to graph 1.015,0.3797 nohead lw 0.8 lc rgb '#999999'
set label 'robust: irregular exact' at graph 1.02,0.3797 left
set arrow from first 327.06,9.54315e-05 to graph 1.0,0.0781 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.0781 to graph 1.015,0.0781 nohead lw 0.8 lc rgb '#999999'
set label 'double: irregular exact' at graph 1.02,0.0781 left
$picture0 << END
345.935 0.0240238
400.503 0.0240238
462.984 0.0240238
590.636 0.0240238
481.895 0.0240238
641.104 0.0240238
351.459 0.0240238
383.656 0.0240238
437.756 0.0240238
569.486 0.0240238
463.259 0.0240238
611.868 0.0240238
335.171 0.0240238
391.368 0.0240238
403.747 0.0240238
476.24 0.0240238
384.757 0.0240238
455.208 0.0240238
664.412 0.0240238
808.937 0.0240238
END
$picture1 << END
358.721 0.031695
413.42 0.0299714
466.801 0.0550258
597.422 0.0382588
491.57 0.0514004
644.197 0.039666
353.871 0.031695
408.754 0.0299714
448.839 0.0550258
586.558 0.0382588
472.648 0.0514004
627.687 0.039666
347.682 0.0316957
402.063 0.0299867
414.456 0.0433867
494.032 0.0431926
393.75 0.0454266
472.733 0.0385494
691.706 0.0462884
822.24 0.0362936
END
$picture2 << END
250.829 0.00103066
285.117 0.00103066
315.567 0.00103066
400.046 0.00103066
328.529 0.00103066
425.165 0.00103066
249.022 0.00103066
289.133 0.00103066
317.069 0.00103066
424.068 0.00103066
334.776 0.00103066
439.738 0.00103066
250.112 0.00103066
286.02 0.00103066
308.453 0.00103066
357.253 0.00103066
292.422 0.00103066
349.666 0.00103066
455.506 0.00103066
553.275 0.00103066
52.7429 0.00103066
145.528 0.00103066
410.029 0.00103066
300.339 0.00103066
299.478 0.00103066
END
$picture3 << END
262.134 0.0213945
293.367 0.0185577
337.637 0.0501279
418.582 0.0301143
339.268 0.0460152
438.479 0.0320801
262.164 0.0213945
295.173 0.0185577
342.999 0.0501279
437.283 0.0301143
350.167 0.0460152
458.897 0.0320801
257.634 0.0213955
298.096 0.0185824
322.797 0.0367042
374.866 0.0363681
297.971 0.0389699
358.931 0.0306253
486.836 0.0402303
560.739 0.0278109
END
$picture4 << END
154.412 9.54315e-05
174.856 9.54315e-05
201.453 9.54315e-05
259.573 9.54315e-05
207.998 9.54315e-05
266.768 9.54315e-05
154.246 9.54315e-05
174.253 9.54315e-05
201.626 9.54315e-05
264.784 9.54315e-05
206.977 9.54315e-05
270.778 9.54315e-05
151.932 9.54315e-05
172.315 9.54315e-05
187.818 9.54315e-05
216.16 9.54315e-05
178.691 9.54315e-05
212.267 9.54315e-05
279.18 9.54315e-05
327.06 9.54315e-05
END
$picture5 << END
159.892 0.0213712
181.968 0.0185352
215.584 0.0501203
269.183 0.0301081
210.862 0.0460158
279.33 0.0321056
160.243 0.0213712
180.505 0.0185352
214.32 0.0501203
274.51 0.0301087
211.134 0.0460158
283.382 0.0321056
157.683 0.0213723
180.605 0.0185599
197.435 0.0367162
227.587 0.0363944
185.411 0.0389679
220.264 0.0306294
293.155 0.0402296
340.848 0.0278065
END
$picture_front << END
327.06 9.54315e-05
553.275 0.00103066
808.937 0.0240238
822.24 0.0362936
END
plot $picture0 with points pt 7 ps 1.3 lw 1.6 lc rgb '#d55e00' title 'fast', \
     $picture1 with points pt 6 ps 1.3 lw 1.6 lc rgb '#d55e00' title 'fast, study''s rule', \
     $picture2 with points pt 5 ps 1.3 lw 1.6 lc rgb '#0072b2' title 'robust', \
     $picture3 with points pt 4 ps 1.3 lw 1.6 lc rgb '#0072b2' title 'robust, study''s rule', \
     $picture4 with points pt 9 ps 1.3 lw 1.6 lc rgb '#009e73' title 'double', \
     $picture5 with points pt 8 ps 1.3 lw 1.6 lc rgb '#009e73' title 'double, study''s rule', \
     NaN with lines lw 1.8 dt '-' lc rgb '#222222' title 'Pareto front', \
     $picture_front with fsteps lw 1.8 dt '-' lc rgb '#222222' notitle, \
     $picture_front with points pt 6 ps 2.6 lw 1.6 lc rgb '#222222' notitle
unset multiplot
unset output

reset
set terminal pngcairo size 1100,1240 font 'DejaVu Sans,12' noenhanced background rgb 'white'
set output 'rings.png'
set encoding utf8
set logscale xy
set border 3 lc rgb '#444444'
set tics nomirror
set grid lc rgb '#d4d4d4' lw 1 dt 1
set multiplot
set key at screen 0.05, screen 0.925 left top Left reverse vertical maxrows 2 samplen 2

unset label; unset arrow; unset object
set lmargin at screen 0.115; set rmargin at screen 0.735
set bmargin at screen 0.5; set tmargin at screen 0.855
set xrange [275.818:6183.13]; set yrange [9.53674e-08:0.0598156]
set xlabel 'million nearest hits a second  (more is better)'; set ylabel 'wrong hits  (less is better)' offset -1.5
set label 'rings: speed against accuracy (GPU)' at screen 0.02, screen 0.9774 font ',20'
set label '1024x1024 primary and 1,048,576 random rays a scene; 2,097,152 in all compared with brute force in double; pictures of 512x512' at screen 0.02, screen 0.9516
set xtics ('500' 500, '1000' 1000, '2000' 2000, '5000' 5000)
set ytics ("none of\n2,097,152" 2.38419e-07, '0.0001 %%' 1e-6, '0.001 %%' 1e-5, '0.01 %%' 1e-4, '0.1 %%' 1e-3, '1 %%' 1e-2)
set object rectangle from graph 0, graph 0 to graph 1, first 4.05312e-07 fs solid noborder fc rgb '#eeeeee' behind
set arrow from first 5152.61,0.00862455 to graph 1.0,0.8549 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.8549 to graph 1.015,0.8549 nohead lw 0.8 lc rgb '#999999'
set label 'fast, study: irregular exact' at graph 1.02,0.8549 left
set arrow from first 4947.23,0.000258923 to graph 1.0,0.5923 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.5923 to graph 1.015,0.5923 nohead lw 0.8 lc rgb '#999999'
set label 'fast: irregular exact' at graph 1.02,0.5923 left
set arrow from first 3324.17,2.38419e-07 to graph 1.0,0.0686 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.0686 to graph 1.015,0.0686 nohead lw 0.8 lc rgb '#999999'
set label 'robust: irregular exact' at graph 1.02,0.0686 left
$hits0 << END
2022.47 0.000258923
2289.71 0.000258923
1890.72 0.000258923
2337.15 0.000258923
2091.73 0.000258923
2596.2 0.000258923
2086.87 0.000258923
2389.03 0.000258923
2140.44 0.000258923
2713.48 0.000258923
2333.57 0.000258923
2958.2 0.000258923
2058.23 0.000258923
2358.94 0.000258923
1624.35 0.000258923
1938.88 0.000258923
1621.62 0.000258923
1925.49 0.000258923
4103.44 0.000258923
4947.23 0.000258923
END
$hits1 << END
2112.57 0.00740767
2406.32 0.00626707
1996.95 0.0239263
2419.2 0.010325
2239.48 0.0226121
2688.88 0.0121698
2194.41 0.00740767
2492.72 0.00626707
2279.12 0.0239263
2809.09 0.010325
2483.08 0.0226121
3084.34 0.0121698
2161.12 0.00840855
2477.36 0.00634432
1719.34 0.0187721
2040.16 0.0170641
1707.51 0.0174308
2015.19 0.0124621
4301.67 0.0168166
5152.61 0.00862455
END
$hits2 << END
1418.04 2.38419e-07
1619.57 2.38419e-07
1351.68 2.38419e-07
1665.13 2.38419e-07
1483.59 2.38419e-07
1842.5 2.38419e-07
1444.03 2.38419e-07
1647.13 2.38419e-07
1473.71 2.38419e-07
1838.32 2.38419e-07
1582.46 2.38419e-07
2015.87 2.38419e-07
1426.21 2.38419e-07
1635.62 2.38419e-07
1122.71 2.38419e-07
1339.85 2.38419e-07
1131.55 2.38419e-07
1338.75 2.38419e-07
2732.6 2.38419e-07
3324.17 2.38419e-07
330.982 2.38419e-07
825.39 2.38419e-07
1970.65 2.38419e-07
1061.14 2.38419e-07
1332.28 2.38419e-07
END
$hits3 << END
1524.16 0.00717831
1706.89 0.00603485
1499.34 0.0237164
1767.09 0.0100956
1643.95 0.0224056
1974.15 0.011939
1558.45 0.00717831
1745.72 0.00603485
1623.34 0.0237164
1971.78 0.0100956
1759.78 0.0224056
2153.24 0.011939
1530.61 0.00818014
1733.53 0.00611162
1226.35 0.0185757
1450.01 0.0168576
1223.21 0.0172191
1438.68 0.0122404
2954.47 0.0166078
3539.62 0.00839329
END
$hits4 << END
829.622 1.76606e-07
944.146 1.76606e-07
848.923 1.76606e-07
1091.01 1.76606e-07
910.728 1.76606e-07
1173.85 1.76606e-07
833.611 1.76606e-07
955.921 1.76606e-07
868.383 1.76606e-07
1115.45 1.76606e-07
929.272 1.76606e-07
1196.81 1.76606e-07
819.005 1.76606e-07
941.433 1.76606e-07
620.412 1.76606e-07
741.743 1.76606e-07
627.181 1.76606e-07
752.276 1.76606e-07
1622.3 1.76606e-07
1996.04 1.76606e-07
END
$hits5 << END
865.367 0.00717831
971.566 0.00603533
923.654 0.0237164
1138.07 0.0100975
996.306 0.0224056
1220.86 0.01194
901.421 0.00717831
1019.51 0.00603533
994.627 0.0237164
1217.28 0.010098
1056.04 0.0224056
1323.26 0.01194
889.19 0.00818014
1000.47 0.0061121
683.3 0.01858
810.658 0.0168648
686.363 0.0172191
813.526 0.0122404
1783.68 0.0166078
2142.75 0.00839329
END
$hits_front << END
3324.17 2.38419e-07
4947.23 0.000258923
5152.61 0.00862455
END
plot $hits0 with points pt 7 ps 1.3 lw 1.6 lc rgb '#d55e00' title 'fast', \
     $hits1 with points pt 6 ps 1.3 lw 1.6 lc rgb '#d55e00' title 'fast, study''s rule', \
     $hits2 with points pt 5 ps 1.3 lw 1.6 lc rgb '#0072b2' title 'robust', \
     $hits3 with points pt 4 ps 1.3 lw 1.6 lc rgb '#0072b2' title 'robust, study''s rule', \
     $hits4 with points pt 9 ps 1.3 lw 1.6 lc rgb '#009e73' title 'double', \
     $hits5 with points pt 8 ps 1.3 lw 1.6 lc rgb '#009e73' title 'double, study''s rule', \
     NaN with lines lw 1.8 dt '-' lc rgb '#222222' title 'Pareto front', \
     $hits_front with fsteps lw 1.8 dt '-' lc rgb '#222222' notitle, \
     $hits_front with points pt 6 ps 2.6 lw 1.6 lc rgb '#222222' notitle
unset key

unset label; unset arrow; unset object
set lmargin at screen 0.115; set rmargin at screen 0.735
set bmargin at screen 0.065; set tmargin at screen 0.42
set xrange [43.9524:986.688]; set yrange [5.1533e-05:0.137565]
set xlabel 'pictures a second  (more is better)'; set ylabel 'picture: RMSE of a channel  (less is better)' offset -1.5
set xtics ('50' 50, '100' 100, '200' 200, '500' 500)
set ytics ("same\nbits" 0.000128833, '10⁻³' 1e-3, '10⁻²' 1e-2, '10⁻¹' 1e-1)
set object rectangle from graph 0, graph 0 to graph 1, first 0.000219015 fs solid noborder fc rgb '#eeeeee' behind
set arrow from first 822.24,0.0362936 to graph 1.0,0.8311 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.8311 to graph 1.015,0.8311 nohead lw 0.8 lc rgb '#999999'
set label 'fast, study: irregular exact' at graph 1.02,0.8311 left
set arrow from first 808.937,0.0240238 to graph 1.0,0.7788 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.7788 to graph 1.015,0.7788 nohead lw 0.8 lc rgb '#999999'
set label 'fast: irregular exact' at graph 1.02,0.7788 left
set arrow from first 553.275,0.00103066 to graph 1.0,0.3797 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.3797 to graph 1.015,0.3797 nohead lw 0.8 lc rgb '#999999'
set label 'robust: irregular exact' at graph 1.02,0.3797 left
set arrow from first 327.06,9.54315e-05 to graph 1.0,0.0781 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.0781 to graph 1.015,0.0781 nohead lw 0.8 lc rgb '#999999'
set label 'double: irregular exact' at graph 1.02,0.0781 left
$picture0 << END
345.935 0.0240238
400.503 0.0240238
462.984 0.0240238
590.636 0.0240238
481.895 0.0240238
641.104 0.0240238
351.459 0.0240238
383.656 0.0240238
437.756 0.0240238
569.486 0.0240238
463.259 0.0240238
611.868 0.0240238
335.171 0.0240238
391.368 0.0240238
403.747 0.0240238
476.24 0.0240238
384.757 0.0240238
455.208 0.0240238
664.412 0.0240238
808.937 0.0240238
END
$picture1 << END
358.721 0.031695
413.42 0.0299714
466.801 0.0550258
597.422 0.0382588
491.57 0.0514004
644.197 0.039666
353.871 0.031695
408.754 0.0299714
448.839 0.0550258
586.558 0.0382588
472.648 0.0514004
627.687 0.039666
347.682 0.0316957
402.063 0.0299867
414.456 0.0433867
494.032 0.0431926
393.75 0.0454266
472.733 0.0385494
691.706 0.0462884
822.24 0.0362936
END
$picture2 << END
250.829 0.00103066
285.117 0.00103066
315.567 0.00103066
400.046 0.00103066
328.529 0.00103066
425.165 0.00103066
249.022 0.00103066
289.133 0.00103066
317.069 0.00103066
424.068 0.00103066
334.776 0.00103066
439.738 0.00103066
250.112 0.00103066
286.02 0.00103066
308.453 0.00103066
357.253 0.00103066
292.422 0.00103066
349.666 0.00103066
455.506 0.00103066
553.275 0.00103066
52.7429 0.00103066
145.528 0.00103066
410.029 0.00103066
300.339 0.00103066
299.478 0.00103066
END
$picture3 << END
262.134 0.0213945
293.367 0.0185577
337.637 0.0501279
418.582 0.0301143
339.268 0.0460152
438.479 0.0320801
262.164 0.0213945
295.173 0.0185577
342.999 0.0501279
437.283 0.0301143
350.167 0.0460152
458.897 0.0320801
257.634 0.0213955
298.096 0.0185824
322.797 0.0367042
374.866 0.0363681
297.971 0.0389699
358.931 0.0306253
486.836 0.0402303
560.739 0.0278109
END
$picture4 << END
154.412 9.54315e-05
174.856 9.54315e-05
201.453 9.54315e-05
259.573 9.54315e-05
207.998 9.54315e-05
266.768 9.54315e-05
154.246 9.54315e-05
174.253 9.54315e-05
201.626 9.54315e-05
264.784 9.54315e-05
206.977 9.54315e-05
270.778 9.54315e-05
151.932 9.54315e-05
172.315 9.54315e-05
187.818 9.54315e-05
216.16 9.54315e-05
178.691 9.54315e-05
212.267 9.54315e-05
279.18 9.54315e-05
327.06 9.54315e-05
END
$picture5 << END
159.892 0.0213712
181.968 0.0185352
215.584 0.0501203
269.183 0.0301081
210.862 0.0460158
279.33 0.0321056
160.243 0.0213712
180.505 0.0185352
214.32 0.0501203
274.51 0.0301087
211.134 0.0460158
283.382 0.0321056
157.683 0.0213723
180.605 0.0185599
197.435 0.0367162
227.587 0.0363944
185.411 0.0389679
220.264 0.0306294
293.155 0.0402296
340.848 0.0278065
END
$picture_front << END
327.06 9.54315e-05
553.275 0.00103066
808.937 0.0240238
822.24 0.0362936
END
plot $picture0 with points pt 7 ps 1.3 lw 1.6 lc rgb '#d55e00' title 'fast', \
     $picture1 with points pt 6 ps 1.3 lw 1.6 lc rgb '#d55e00' title 'fast, study''s rule', \
     $picture2 with points pt 5 ps 1.3 lw 1.6 lc rgb '#0072b2' title 'robust', \
     $picture3 with points pt 4 ps 1.3 lw 1.6 lc rgb '#0072b2' title 'robust, study''s rule', \
     $picture4 with points pt 9 ps 1.3 lw 1.6 lc rgb '#009e73' title 'double', \
     $picture5 with points pt 8 ps 1.3 lw 1.6 lc rgb '#009e73' title 'double, study''s rule', \
     NaN with lines lw 1.8 dt '-' lc rgb '#222222' title 'Pareto front', \
     $picture_front with fsteps lw 1.8 dt '-' lc rgb '#222222' notitle, \
     $picture_front with points pt 6 ps 2.6 lw 1.6 lc rgb '#222222' notitle
unset multiplot
unset output

reset
set terminal svg size 1100,1240 font 'DejaVu Sans,15' noenhanced background rgb 'white'
set output 'teapot.svg'
set encoding utf8
set logscale xy
set border 3 lc rgb '#444444'
set tics nomirror
set grid lc rgb '#d4d4d4' lw 1 dt 1
set multiplot
set key at screen 0.05, screen 0.925 left top Left reverse vertical maxrows 2 samplen 2

unset label; unset arrow; unset object
set lmargin at screen 0.115; set rmargin at screen 0.735
set bmargin at screen 0.5; set tmargin at screen 0.855
set xrange [928.558:9790.02]; set yrange [9.53674e-08:0.000944138]
set xlabel 'million nearest hits a second  (more is better)'; set ylabel 'wrong hits  (less is better)' offset -1.5
set label 'teapot: speed against accuracy (GPU)' at screen 0.02, screen 0.9774 font ',20'
set label '1024x1024 primary and 1,048,576 random rays a scene; 2,097,152 in all compared with brute force in double; pictures of 512x512' at screen 0.02, screen 0.9516
set xtics ('1000' 1000, '1500' 1500, '2000' 2000, '3000' 3000, '5000' 5000, '7000' 7000)
set ytics ("none of\n2,097,152" 2.38419e-07, '0.0001 %%' 1e-6, '0.001 %%' 1e-5, '0.01 %%' 1e-4)
set object rectangle from graph 0, graph 0 to graph 1, first 4.05312e-07 fs solid noborder fc rgb '#eeeeee' behind
set arrow from first 8158.35,3.21865e-07 to graph 1.0,0.1322 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.1322 to graph 1.015,0.1322 nohead lw 0.8 lc rgb '#999999'
set label 'fast: irregular exact' at graph 1.02,0.1322 left
$hits0 << END
2268.86 3.21865e-07
2309.8 3.21865e-07
2762.09 3.21865e-07
2974.18 3.21865e-07
2922.19 3.21865e-07
3196.41 3.21865e-07
2284.84 3.21865e-07
2344.93 3.21865e-07
3112.46 3.21865e-07
3366.17 3.21865e-07
3430.31 3.21865e-07
3782.74 3.21865e-07
2276.19 3.21865e-07
2307.36 3.21865e-07
2572.16 3.21865e-07
2579.65 3.21865e-07
2827.39 3.21865e-07
3060.71 3.21865e-07
7370.22 3.21865e-07
8158.35 3.21865e-07
END
$hits1 << END
2059.84 0.000369549
2077.54 0.000362873
2733.06 0.000377655
2914.4 0.000377178
2898.03 0.000349998
3102.74 0.000195026
2088.66 0.000369549
2152.53 0.000362873
3118.98 0.000377655
3359.44 0.000377178
3437.14 0.000349998
3818.22 0.000195026
2072.68 0.000369549
2126.89 0.000362873
2567.32 0.000284672
2563.91 0.00029707
2835.22 0.000234604
3040.41 0.000130653
7551.1 0.000305176
8029.4 0.000103474
END
$hits2 << END
1853.97 2.38419e-07
1869.09 2.38419e-07
2438.64 2.38419e-07
2643.54 2.38419e-07
2534.95 2.38419e-07
2773.19 2.38419e-07
1921.76 2.38419e-07
1937.39 2.38419e-07
2782.49 2.38419e-07
3015.37 2.38419e-07
3003.48 2.38419e-07
3292.6 2.38419e-07
1894.38 2.38419e-07
1926.11 2.38419e-07
2262.98 2.38419e-07
2249.55 2.38419e-07
2469.98 2.38419e-07
2661.58 2.38419e-07
6233.81 2.38419e-07
7040.07 2.38419e-07
1126.42 2.38419e-07
2917.77 2.38419e-07
1770 2.38419e-07
2840.87 2.38419e-07
END
$hits3 << END
1596.38 0.000369549
1618.77 0.000362873
2089.93 0.000377655
2192.72 0.000377178
2198.46 0.000349998
2376.39 0.000195026
1672.22 0.000369549
1718.48 0.000362873
2300.15 0.000377655
2434.56 0.000377178
2609.85 0.000349998
2819.48 0.000195026
1651.86 0.000369549
1675.17 0.000362873
1912.45 0.000284672
1907.5 0.00029707
2137.65 0.000234604
2267.21 0.000130653
5536.07 0.000305176
5939.46 0.000103474
END
$hits4 << END
1326.21 1.76606e-07
1341.3 1.76606e-07
1496.87 1.76606e-07
1632.32 1.76606e-07
1584.56 1.76606e-07
1731.42 1.76606e-07
1352.32 1.76606e-07
1392.34 1.76606e-07
1627.58 1.76606e-07
1778.12 1.76606e-07
1815.75 1.76606e-07
2001.47 1.76606e-07
1325.86 1.76606e-07
1356.21 1.76606e-07
1321.61 1.76606e-07
1314.85 1.76606e-07
1481.51 1.76606e-07
1579.41 1.76606e-07
4082.48 1.76606e-07
4595.79 1.76606e-07
END
$hits5 << END
1114.27 0.000369549
1131.12 0.000362873
1367.96 0.000377655
1480.74 0.000377178
1451.84 0.000349998
1580.32 0.000195503
1205.08 0.000369549
1219.55 0.000362873
1477.83 0.000377655
1595.09 0.000377178
1683.13 0.000349998
1836.82 0.000195503
1164.55 0.000369549
1204.91 0.000362873
1166.37 0.000284672
1151.98 0.00029707
1316.75 0.000234604
1400.31 0.00013113
3947.95 0.000305176
4273.9 0.000103474
END
$hits_front << END
8158.35 3.21865e-07
END
plot $hits0 with points pt 7 ps 1.3 lw 1.6 lc rgb '#d55e00' title 'fast', \
     $hits1 with points pt 6 ps 1.3 lw 1.6 lc rgb '#d55e00' title 'fast, study''s rule', \
     $hits2 with points pt 5 ps 1.3 lw 1.6 lc rgb '#0072b2' title 'robust', \
     $hits3 with points pt 4 ps 1.3 lw 1.6 lc rgb '#0072b2' title 'robust, study''s rule', \
     $hits4 with points pt 9 ps 1.3 lw 1.6 lc rgb '#009e73' title 'double', \
     $hits5 with points pt 8 ps 1.3 lw 1.6 lc rgb '#009e73' title 'double, study''s rule', \
     NaN with lines lw 1.8 dt '-' lc rgb '#222222' title 'Pareto front', \
     $hits_front with fsteps lw 1.8 dt '-' lc rgb '#222222' notitle, \
     $hits_front with points pt 6 ps 2.6 lw 1.6 lc rgb '#222222' notitle
unset key

unset label; unset arrow; unset object
set lmargin at screen 0.115; set rmargin at screen 0.735
set bmargin at screen 0.065; set tmargin at screen 0.42
set xrange [134.554:2255.37]; set yrange [2.14846e-05:0.0175858]
set xlabel 'pictures a second  (more is better)'; set ylabel 'picture: RMSE of a channel  (less is better)' offset -1.5
set xtics ('150' 150, '200' 200, '300' 300, '500' 500, '700' 700, '1000' 1000, '1500' 1500, '2000' 2000)
set ytics ("same\nbits" 5.37116e-05, '10⁻³' 1e-3, '10⁻²' 1e-2)
set object rectangle from graph 0, graph 0 to graph 1, first 9.13098e-05 fs solid noborder fc rgb '#eeeeee' behind
set arrow from first 1879.47,0.000832694 to graph 1.0,0.5453 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.5453 to graph 1.015,0.5453 nohead lw 0.8 lc rgb '#999999'
set label 'fast: irregular exact' at graph 1.02,0.5453 left
set arrow from first 1549.41,0.000429693 to graph 1.0,0.4466 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.4466 to graph 1.015,0.4466 nohead lw 0.8 lc rgb '#999999'
set label 'robust: irregular exact' at graph 1.02,0.4466 left
set arrow from first 1302.68,3.97864e-05 to graph 1.0,0.0919 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.0919 to graph 1.015,0.0919 nohead lw 0.8 lc rgb '#999999'
set label 'double: irregular exact' at graph 1.02,0.0919 left
$picture0 << END
385.498 0.000832694
397.78 0.000832694
791.277 0.000832694
937.198 0.000832694
847.709 0.000832694
968.064 0.000832694
391.08 0.000832694
405.617 0.000832694
770.689 0.000832694
898.295 0.000832694
851.89 0.000832694
1007.87 0.000832694
379.436 0.000832694
388.348 0.000832694
715.855 0.000832694
746.285 0.000832694
745.112 0.000832694
828.693 0.000832694
1489.73 0.000832694
1879.47 0.000832694
END
$picture1 << END
339.324 0.00680517
347.003 0.00673666
736.627 0.00687082
867.498 0.00703431
769.894 0.00680154
893.751 0.00395185
344.463 0.00680517
351.491 0.00673666
722.611 0.00687082
841.822 0.00703431
785.139 0.00680154
927.627 0.00395185
333.287 0.00680517
337.911 0.00673666
647.614 0.00564691
684.828 0.0054363
697.029 0.00474342
762.998 0.00264172
1423.04 0.00607057
1745.13 0.00294927
END
$picture2 << END
320.42 0.000429693
328.924 0.000429693
668.422 0.000429693
789.858 0.000429693
717.978 0.000429693
811.688 0.000429693
329.058 0.000429693
339.238 0.000429693
654.656 0.000429693
784.763 0.000429693
729.373 0.000429693
858.657 0.000429693
319.942 0.000429693
324.912 0.000429693
609.318 0.000429693
637.832 0.000429693
635.639 0.000429693
697.438 0.000429693
1240.08 0.000429693
1549.41 0.000429693
161.465 0.000429693
612.074 0.000429693
686.964 0.000429693
780.53 0.000429693
END
$picture3 << END
285.686 0.0067695
291.058 0.00670134
597.436 0.00683399
709.552 0.00699834
638.484 0.00676407
730.823 0.00388701
297.059 0.0067695
303.033 0.00670134
610.184 0.00683399
718.324 0.00699834
661.433 0.00676407
783.245 0.00388701
290.223 0.0067695
294.414 0.00670134
561.656 0.00560204
586.27 0.0053897
591.53 0.00468955
652.797 0.0025437
1209.69 0.00602856
1447.36 0.00286181
END
$picture4 << END
240.785 3.97864e-05
247.233 3.97864e-05
548.564 3.97864e-05
657.687 3.97864e-05
559.065 3.97864e-05
647.979 3.97864e-05
248.17 3.97864e-05
252.901 3.97864e-05
535.103 3.97864e-05
637.341 3.97864e-05
565.08 3.97864e-05
668.293 3.97864e-05
236.692 3.97864e-05
242.012 3.97864e-05
479.207 3.97864e-05
505.41 3.97864e-05
494.69 3.97864e-05
545.938 3.97864e-05
1020.84 3.97864e-05
1302.68 3.97864e-05
END
$picture5 << END
228.529 0.00675584
234.941 0.00668754
519.872 0.00682047
622.065 0.00698514
528.042 0.0067504
619.855 0.00386319
234.16 0.00675584
240.868 0.00668754
516.777 0.00682047
627.802 0.00698514
547.525 0.0067504
662.05 0.00386319
227.673 0.00675584
231.214 0.00668754
454.269 0.00558553
485.557 0.00537259
483.627 0.00466981
533.185 0.00250715
1013.95 0.00601323
1270.33 0.00282937
END
$picture_front << END
1302.68 3.97864e-05
1549.41 0.000429693
1879.47 0.000832694
END
plot $picture0 with points pt 7 ps 1.3 lw 1.6 lc rgb '#d55e00' title 'fast', \
     $picture1 with points pt 6 ps 1.3 lw 1.6 lc rgb '#d55e00' title 'fast, study''s rule', \
     $picture2 with points pt 5 ps 1.3 lw 1.6 lc rgb '#0072b2' title 'robust', \
     $picture3 with points pt 4 ps 1.3 lw 1.6 lc rgb '#0072b2' title 'robust, study''s rule', \
     $picture4 with points pt 9 ps 1.3 lw 1.6 lc rgb '#009e73' title 'double', \
     $picture5 with points pt 8 ps 1.3 lw 1.6 lc rgb '#009e73' title 'double, study''s rule', \
     NaN with lines lw 1.8 dt '-' lc rgb '#222222' title 'Pareto front', \
     $picture_front with fsteps lw 1.8 dt '-' lc rgb '#222222' notitle, \
     $picture_front with points pt 6 ps 2.6 lw 1.6 lc rgb '#222222' notitle
unset multiplot
unset output

reset
set terminal pngcairo size 1100,1240 font 'DejaVu Sans,12' noenhanced background rgb 'white'
set output 'teapot.png'
set encoding utf8
set logscale xy
set border 3 lc rgb '#444444'
set tics nomirror
set grid lc rgb '#d4d4d4' lw 1 dt 1
set multiplot
set key at screen 0.05, screen 0.925 left top Left reverse vertical maxrows 2 samplen 2

unset label; unset arrow; unset object
set lmargin at screen 0.115; set rmargin at screen 0.735
set bmargin at screen 0.5; set tmargin at screen 0.855
set xrange [928.558:9790.02]; set yrange [9.53674e-08:0.000944138]
set xlabel 'million nearest hits a second  (more is better)'; set ylabel 'wrong hits  (less is better)' offset -1.5
set label 'teapot: speed against accuracy (GPU)' at screen 0.02, screen 0.9774 font ',20'
set label '1024x1024 primary and 1,048,576 random rays a scene; 2,097,152 in all compared with brute force in double; pictures of 512x512' at screen 0.02, screen 0.9516
set xtics ('1000' 1000, '1500' 1500, '2000' 2000, '3000' 3000, '5000' 5000, '7000' 7000)
set ytics ("none of\n2,097,152" 2.38419e-07, '0.0001 %%' 1e-6, '0.001 %%' 1e-5, '0.01 %%' 1e-4)
set object rectangle from graph 0, graph 0 to graph 1, first 4.05312e-07 fs solid noborder fc rgb '#eeeeee' behind
set arrow from first 8158.35,3.21865e-07 to graph 1.0,0.1322 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.1322 to graph 1.015,0.1322 nohead lw 0.8 lc rgb '#999999'
set label 'fast: irregular exact' at graph 1.02,0.1322 left
$hits0 << END
2268.86 3.21865e-07
2309.8 3.21865e-07
2762.09 3.21865e-07
2974.18 3.21865e-07
2922.19 3.21865e-07
3196.41 3.21865e-07
2284.84 3.21865e-07
2344.93 3.21865e-07
3112.46 3.21865e-07
3366.17 3.21865e-07
3430.31 3.21865e-07
3782.74 3.21865e-07
2276.19 3.21865e-07
2307.36 3.21865e-07
2572.16 3.21865e-07
2579.65 3.21865e-07
2827.39 3.21865e-07
3060.71 3.21865e-07
7370.22 3.21865e-07
8158.35 3.21865e-07
END
$hits1 << END
2059.84 0.000369549
2077.54 0.000362873
2733.06 0.000377655
2914.4 0.000377178
2898.03 0.000349998
3102.74 0.000195026
2088.66 0.000369549
2152.53 0.000362873
3118.98 0.000377655
3359.44 0.000377178
3437.14 0.000349998
3818.22 0.000195026
2072.68 0.000369549
2126.89 0.000362873
2567.32 0.000284672
2563.91 0.00029707
2835.22 0.000234604
3040.41 0.000130653
7551.1 0.000305176
8029.4 0.000103474
END
$hits2 << END
1853.97 2.38419e-07
1869.09 2.38419e-07
2438.64 2.38419e-07
2643.54 2.38419e-07
2534.95 2.38419e-07
2773.19 2.38419e-07
1921.76 2.38419e-07
1937.39 2.38419e-07
2782.49 2.38419e-07
3015.37 2.38419e-07
3003.48 2.38419e-07
3292.6 2.38419e-07
1894.38 2.38419e-07
1926.11 2.38419e-07
2262.98 2.38419e-07
2249.55 2.38419e-07
2469.98 2.38419e-07
2661.58 2.38419e-07
6233.81 2.38419e-07
7040.07 2.38419e-07
1126.42 2.38419e-07
2917.77 2.38419e-07
1770 2.38419e-07
2840.87 2.38419e-07
END
$hits3 << END
1596.38 0.000369549
1618.77 0.000362873
2089.93 0.000377655
2192.72 0.000377178
2198.46 0.000349998
2376.39 0.000195026
1672.22 0.000369549
1718.48 0.000362873
2300.15 0.000377655
2434.56 0.000377178
2609.85 0.000349998
2819.48 0.000195026
1651.86 0.000369549
1675.17 0.000362873
1912.45 0.000284672
1907.5 0.00029707
2137.65 0.000234604
2267.21 0.000130653
5536.07 0.000305176
5939.46 0.000103474
END
$hits4 << END
1326.21 1.76606e-07
1341.3 1.76606e-07
1496.87 1.76606e-07
1632.32 1.76606e-07
1584.56 1.76606e-07
1731.42 1.76606e-07
1352.32 1.76606e-07
1392.34 1.76606e-07
1627.58 1.76606e-07
1778.12 1.76606e-07
1815.75 1.76606e-07
2001.47 1.76606e-07
1325.86 1.76606e-07
1356.21 1.76606e-07
1321.61 1.76606e-07
1314.85 1.76606e-07
1481.51 1.76606e-07
1579.41 1.76606e-07
4082.48 1.76606e-07
4595.79 1.76606e-07
END
$hits5 << END
1114.27 0.000369549
1131.12 0.000362873
1367.96 0.000377655
1480.74 0.000377178
1451.84 0.000349998
1580.32 0.000195503
1205.08 0.000369549
1219.55 0.000362873
1477.83 0.000377655
1595.09 0.000377178
1683.13 0.000349998
1836.82 0.000195503
1164.55 0.000369549
1204.91 0.000362873
1166.37 0.000284672
1151.98 0.00029707
1316.75 0.000234604
1400.31 0.00013113
3947.95 0.000305176
4273.9 0.000103474
END
$hits_front << END
8158.35 3.21865e-07
END
plot $hits0 with points pt 7 ps 1.3 lw 1.6 lc rgb '#d55e00' title 'fast', \
     $hits1 with points pt 6 ps 1.3 lw 1.6 lc rgb '#d55e00' title 'fast, study''s rule', \
     $hits2 with points pt 5 ps 1.3 lw 1.6 lc rgb '#0072b2' title 'robust', \
     $hits3 with points pt 4 ps 1.3 lw 1.6 lc rgb '#0072b2' title 'robust, study''s rule', \
     $hits4 with points pt 9 ps 1.3 lw 1.6 lc rgb '#009e73' title 'double', \
     $hits5 with points pt 8 ps 1.3 lw 1.6 lc rgb '#009e73' title 'double, study''s rule', \
     NaN with lines lw 1.8 dt '-' lc rgb '#222222' title 'Pareto front', \
     $hits_front with fsteps lw 1.8 dt '-' lc rgb '#222222' notitle, \
     $hits_front with points pt 6 ps 2.6 lw 1.6 lc rgb '#222222' notitle
unset key

unset label; unset arrow; unset object
set lmargin at screen 0.115; set rmargin at screen 0.735
set bmargin at screen 0.065; set tmargin at screen 0.42
set xrange [134.554:2255.37]; set yrange [2.14846e-05:0.0175858]
set xlabel 'pictures a second  (more is better)'; set ylabel 'picture: RMSE of a channel  (less is better)' offset -1.5
set xtics ('150' 150, '200' 200, '300' 300, '500' 500, '700' 700, '1000' 1000, '1500' 1500, '2000' 2000)
set ytics ("same\nbits" 5.37116e-05, '10⁻³' 1e-3, '10⁻²' 1e-2)
set object rectangle from graph 0, graph 0 to graph 1, first 9.13098e-05 fs solid noborder fc rgb '#eeeeee' behind
set arrow from first 1879.47,0.000832694 to graph 1.0,0.5453 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.5453 to graph 1.015,0.5453 nohead lw 0.8 lc rgb '#999999'
set label 'fast: irregular exact' at graph 1.02,0.5453 left
set arrow from first 1549.41,0.000429693 to graph 1.0,0.4466 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.4466 to graph 1.015,0.4466 nohead lw 0.8 lc rgb '#999999'
set label 'robust: irregular exact' at graph 1.02,0.4466 left
set arrow from first 1302.68,3.97864e-05 to graph 1.0,0.0919 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.0919 to graph 1.015,0.0919 nohead lw 0.8 lc rgb '#999999'
set label 'double: irregular exact' at graph 1.02,0.0919 left
$picture0 << END
385.498 0.000832694
397.78 0.000832694
791.277 0.000832694
937.198 0.000832694
847.709 0.000832694
968.064 0.000832694
391.08 0.000832694
405.617 0.000832694
770.689 0.000832694
898.295 0.000832694
851.89 0.000832694
1007.87 0.000832694
379.436 0.000832694
388.348 0.000832694
715.855 0.000832694
746.285 0.000832694
745.112 0.000832694
828.693 0.000832694
1489.73 0.000832694
1879.47 0.000832694
END
$picture1 << END
339.324 0.00680517
347.003 0.00673666
736.627 0.00687082
867.498 0.00703431
769.894 0.00680154
893.751 0.00395185
344.463 0.00680517
351.491 0.00673666
722.611 0.00687082
841.822 0.00703431
785.139 0.00680154
927.627 0.00395185
333.287 0.00680517
337.911 0.00673666
647.614 0.00564691
684.828 0.0054363
697.029 0.00474342
762.998 0.00264172
1423.04 0.00607057
1745.13 0.00294927
END
$picture2 << END
320.42 0.000429693
328.924 0.000429693
668.422 0.000429693
789.858 0.000429693
717.978 0.000429693
811.688 0.000429693
329.058 0.000429693
339.238 0.000429693
654.656 0.000429693
784.763 0.000429693
729.373 0.000429693
858.657 0.000429693
319.942 0.000429693
324.912 0.000429693
609.318 0.000429693
637.832 0.000429693
635.639 0.000429693
697.438 0.000429693
1240.08 0.000429693
1549.41 0.000429693
161.465 0.000429693
612.074 0.000429693
686.964 0.000429693
780.53 0.000429693
END
$picture3 << END
285.686 0.0067695
291.058 0.00670134
597.436 0.00683399
709.552 0.00699834
638.484 0.00676407
730.823 0.00388701
297.059 0.0067695
303.033 0.00670134
610.184 0.00683399
718.324 0.00699834
661.433 0.00676407
783.245 0.00388701
290.223 0.0067695
294.414 0.00670134
561.656 0.00560204
586.27 0.0053897
591.53 0.00468955
652.797 0.0025437
1209.69 0.00602856
1447.36 0.00286181
END
$picture4 << END
240.785 3.97864e-05
247.233 3.97864e-05
548.564 3.97864e-05
657.687 3.97864e-05
559.065 3.97864e-05
647.979 3.97864e-05
248.17 3.97864e-05
252.901 3.97864e-05
535.103 3.97864e-05
637.341 3.97864e-05
565.08 3.97864e-05
668.293 3.97864e-05
236.692 3.97864e-05
242.012 3.97864e-05
479.207 3.97864e-05
505.41 3.97864e-05
494.69 3.97864e-05
545.938 3.97864e-05
1020.84 3.97864e-05
1302.68 3.97864e-05
END
$picture5 << END
228.529 0.00675584
234.941 0.00668754
519.872 0.00682047
622.065 0.00698514
528.042 0.0067504
619.855 0.00386319
234.16 0.00675584
240.868 0.00668754
516.777 0.00682047
627.802 0.00698514
547.525 0.0067504
662.05 0.00386319
227.673 0.00675584
231.214 0.00668754
454.269 0.00558553
485.557 0.00537259
483.627 0.00466981
533.185 0.00250715
1013.95 0.00601323
1270.33 0.00282937
END
$picture_front << END
1302.68 3.97864e-05
1549.41 0.000429693
1879.47 0.000832694
END
plot $picture0 with points pt 7 ps 1.3 lw 1.6 lc rgb '#d55e00' title 'fast', \
     $picture1 with points pt 6 ps 1.3 lw 1.6 lc rgb '#d55e00' title 'fast, study''s rule', \
     $picture2 with points pt 5 ps 1.3 lw 1.6 lc rgb '#0072b2' title 'robust', \
     $picture3 with points pt 4 ps 1.3 lw 1.6 lc rgb '#0072b2' title 'robust, study''s rule', \
     $picture4 with points pt 9 ps 1.3 lw 1.6 lc rgb '#009e73' title 'double', \
     $picture5 with points pt 8 ps 1.3 lw 1.6 lc rgb '#009e73' title 'double, study''s rule', \
     NaN with lines lw 1.8 dt '-' lc rgb '#222222' title 'Pareto front', \
     $picture_front with fsteps lw 1.8 dt '-' lc rgb '#222222' notitle, \
     $picture_front with points pt 6 ps 2.6 lw 1.6 lc rgb '#222222' notitle
unset multiplot
unset output

reset
set terminal svg size 1100,1240 font 'DejaVu Sans,15' noenhanced background rgb 'white'
set output 'tetra.svg'
set encoding utf8
set logscale xy
set border 3 lc rgb '#444444'
set tics nomirror
set grid lc rgb '#d4d4d4' lw 1 dt 1
set multiplot
set key at screen 0.05, screen 0.925 left top Left reverse vertical maxrows 2 samplen 2

unset label; unset arrow; unset object
set lmargin at screen 0.115; set rmargin at screen 0.735
set bmargin at screen 0.5; set tmargin at screen 0.855
set xrange [579.968:6999.84]; set yrange [9.53674e-08:0.0014317]
set xlabel 'million nearest hits a second  (more is better)'; set ylabel 'wrong hits  (less is better)' offset -1.5
set label 'tetra: speed against accuracy (GPU)' at screen 0.02, screen 0.9774 font ',20'
set label '1024x1024 primary and 1,048,576 random rays a scene; 2,097,152 in all compared with brute force in double; pictures of 512x512' at screen 0.02, screen 0.9516
set xtics ('700' 700, '1000' 1000, '1500' 1500, '2000' 2000, '3000' 3000, '5000' 5000)
set ytics ("none of\n2,097,152" 2.38419e-07, '0.0001 %%' 1e-6, '0.001 %%' 1e-5, '0.01 %%' 1e-4, '0.1 %%' 1e-3)
set object rectangle from graph 0, graph 0 to graph 1, first 4.05312e-07 fs solid noborder fc rgb '#eeeeee' behind
set arrow from first 5833.2,9.53674e-07 to graph 1.0,0.2394 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.2394 to graph 1.015,0.2394 nohead lw 0.8 lc rgb '#999999'
set label 'fast: irregular exact' at graph 1.02,0.2394 left
set arrow from first 4937.91,2.38419e-07 to graph 1.0,0.0953 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.0953 to graph 1.015,0.0953 nohead lw 0.8 lc rgb '#999999'
set label 'robust: irregular exact' at graph 1.02,0.0953 left
$hits0 << END
2643.01 9.53674e-07
2890.23 9.53674e-07
2037.68 9.53674e-07
2357.07 9.53674e-07
3340.61 9.53674e-07
3684.28 9.53674e-07
2596.51 9.53674e-07
2849.02 9.53674e-07
2251.63 9.53674e-07
2697.4 9.53674e-07
3594.76 9.53674e-07
4047.43 9.53674e-07
2394.88 9.53674e-07
2679.75 9.53674e-07
1981.68 9.53674e-07
1598.79 9.53674e-07
2745.42 9.53674e-07
2544.89 9.53674e-07
5427.41 9.53674e-07
5833.2 9.53674e-07
END
$hits1 << END
2656.61 9.53674e-07
2893.29 2.3365e-05
1979.34 9.53674e-07
2315.19 3.29018e-05
3118.09 9.53674e-07
3471 3.57628e-05
2657.15 9.53674e-07
2907.28 2.3365e-05
2232.61 9.53674e-07
2685.79 3.29018e-05
3361.17 9.53674e-07
3801.61 3.57628e-05
2466.63 9.53674e-07
2753.96 3.76701e-05
1992.64 9.53674e-07
1588.21 0.000572681
2714.16 9.53674e-07
2532.79 0.000368595
5231.58 9.53674e-07
5753.31 7.62939e-06
END
$hits2 << END
2153.17 2.38419e-07
2340.57 2.38419e-07
1694.88 2.38419e-07
1983.29 2.38419e-07
2713.71 2.38419e-07
3022.32 2.38419e-07
2153.81 2.38419e-07
2349.38 2.38419e-07
1870.85 2.38419e-07
2251.86 2.38419e-07
2917.64 2.38419e-07
3278.11 2.38419e-07
1998.48 2.38419e-07
2222.54 2.38419e-07
1698 2.38419e-07
1358.06 2.38419e-07
2309.48 2.38419e-07
2150.77 2.38419e-07
4557.12 2.38419e-07
4937.91 2.38419e-07
695.962 2.38419e-07
1493.19 2.38419e-07
2445.01 2.38419e-07
1381.54 2.38419e-07
1709.92 2.38419e-07
END
$hits3 << END
1895.53 2.38419e-07
2046.72 2.24113e-05
1479.07 2.38419e-07
1739.56 3.19481e-05
2297.74 2.38419e-07
2553.32 3.48091e-05
1895.53 2.38419e-07
2063.41 2.24113e-05
1628.14 2.38419e-07
1935.27 3.19481e-05
2434.2 2.38419e-07
2723.4 3.48091e-05
1770.48 2.38419e-07
1953.56 3.67165e-05
1446.36 2.38419e-07
1126.53 0.000571728
1942.27 2.38419e-07
1804.55 0.000367641
3906.53 2.38419e-07
4267.78 6.67572e-06
END
$hits4 << END
1322.65 1.76606e-07
1427.18 1.76606e-07
1013.02 1.76606e-07
1201.15 1.76606e-07
1648.12 1.76606e-07
1834.66 1.76606e-07
1324.47 1.76606e-07
1418.65 1.76606e-07
1122.73 1.76606e-07
1341.41 1.76606e-07
1767.52 1.76606e-07
1981.26 1.76606e-07
1215.95 1.76606e-07
1336.32 1.76606e-07
1017.97 1.76606e-07
808.458 1.76606e-07
1365.05 1.76606e-07
1253.53 1.76606e-07
2897.52 1.76606e-07
3025.67 1.76606e-07
END
$hits5 << END
1156.86 1.76606e-07
1231.74 2.24113e-05
934.626 1.76606e-07
1100.63 3.19481e-05
1437.48 1.76606e-07
1601.52 3.48091e-05
1207.19 1.76606e-07
1293.24 2.24113e-05
1039.91 1.76606e-07
1238.87 3.19481e-05
1575.27 1.76606e-07
1767.99 3.48091e-05
1106.47 1.76606e-07
1210.42 3.67165e-05
901.185 1.76606e-07
705.302 0.000571728
1203.03 1.76606e-07
1090.29 0.000367641
2614.12 1.76606e-07
2773.42 6.67572e-06
END
$hits_front << END
4937.91 2.38419e-07
5833.2 9.53674e-07
END
plot $hits0 with points pt 7 ps 1.3 lw 1.6 lc rgb '#d55e00' title 'fast', \
     $hits1 with points pt 6 ps 1.3 lw 1.6 lc rgb '#d55e00' title 'fast, study''s rule', \
     $hits2 with points pt 5 ps 1.3 lw 1.6 lc rgb '#0072b2' title 'robust', \
     $hits3 with points pt 4 ps 1.3 lw 1.6 lc rgb '#0072b2' title 'robust, study''s rule', \
     $hits4 with points pt 9 ps 1.3 lw 1.6 lc rgb '#009e73' title 'double', \
     $hits5 with points pt 8 ps 1.3 lw 1.6 lc rgb '#009e73' title 'double, study''s rule', \
     NaN with lines lw 1.8 dt '-' lc rgb '#222222' title 'Pareto front', \
     $hits_front with fsteps lw 1.8 dt '-' lc rgb '#222222' notitle, \
     $hits_front with points pt 6 ps 2.6 lw 1.6 lc rgb '#222222' notitle
unset key

unset label; unset arrow; unset object
set lmargin at screen 0.115; set rmargin at screen 0.735
set bmargin at screen 0.065; set tmargin at screen 0.42
set xrange [1151.11:11101.2]; set yrange [1.38018e-05:0.0057173]
set xlabel 'pictures a second  (more is better)'; set ylabel 'picture: RMSE of a channel  (less is better)' offset -1.5
set xtics ('1500' 1500, '2000' 2000, '3000' 3000, '5000' 5000, '7000' 7000, '10000' 10000)
set ytics ("same\nbits" 3.45046e-05, '10⁻⁴' 1e-4, '10⁻³' 1e-3)
set object rectangle from graph 0, graph 0 to graph 1, first 5.86579e-05 fs solid noborder fc rgb '#eeeeee' behind
set arrow from first 9251.04,0.00135754 to graph 1.0,0.7614 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.7614 to graph 1.015,0.7614 nohead lw 0.8 lc rgb '#999999'
set label 'fast: irregular exact' at graph 1.02,0.7614 left
set arrow from first 7738.98,0.000276037 to graph 1.0,0.4971 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.4971 to graph 1.015,0.4971 nohead lw 0.8 lc rgb '#999999'
set label 'robust: irregular box' at graph 1.02,0.4971 left
set arrow from first 5879.59,2.5559e-05 to graph 1.0,0.1022 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.1022 to graph 1.015,0.1022 nohead lw 0.8 lc rgb '#999999'
set label 'double: irregular exact' at graph 1.02,0.1022 left
$picture0 << END
5214.42 0.00135754
5526.08 0.00135754
4513.94 0.00135754
5574.38 0.00135754
7277.6 0.00135754
8592.25 0.00135754
5037.07 0.00135754
5340.05 0.00135754
4118.89 0.00135754
5072.23 0.00135754
7291.18 0.00135754
8282.53 0.00135754
4825.51 0.00135754
5059.09 0.00135754
4078.57 0.00135754
3242.37 0.00135754
5960.33 0.00135754
6082.13 0.00135754
9118.76 0.00135754
9251.04 0.00135754
END
$picture1 << END
4615.95 0.00135754
4928.24 0.00135754
4254.59 0.00135754
5388.86 0.00135754
6569.27 0.00135754
7769.77 0.00135754
4478.36 0.00135754
4975.32 0.00135754
3788.34 0.00135754
4764.45 0.00135754
6248.75 0.00135754
7476.08 0.00135754
4321.07 0.00135754
4832.97 0.00135754
3895.05 0.00135754
3081.55 0.00167885
5460.42 0.00135754
5854.25 0.00228692
8095.85 0.00135754
8241.03 0.00135754
END
$picture2 << END
4212.16 0.000276037
4716.27 0.000276037
3852.32 0.000276037
4992.81 0.000276037
6092.81 0.000276037
7212.09 0.000276037
4267.38 0.000276037
4498.34 0.000276037
3718.91 0.000276037
4676.04 0.000276037
6031.65 0.000276037
7035.12 0.000276037
3959.71 0.000276037
4453.47 0.000276037
3587.83 0.000276037
2800.68 0.000276037
5126.31 0.000276037
5065.65 0.000276037
7738.98 0.000276037
7607.11 0.000276037
1381.34 0.000276037
2930.42 0.000276037
4935.25 0.000276037
3416.05 0.000276037
3016.41 0.000276037
END
$picture3 << END
4018.26 0.000276037
4293.76 0.000276037
3525.1 0.000276037
4526.36 0.000276037
5177.27 0.000276037
6164.92 0.000276037
3952.69 0.000276037
4359.65 0.000276037
3371.82 0.000276037
4296.12 0.000276037
4996.8 0.000276037
6082.13 0.000276037
3736.7 0.000276037
4110.76 0.000276037
3430.3 0.000276037
2635.8 0.00102558
4740.59 0.000276037
4804.74 0.00186099
6783.16 0.000276037
6909.13 0.000276037
END
$picture4 << END
3043.14 2.5559e-05
3437.84 2.5559e-05
3055.64 2.5559e-05
3987.5 2.5559e-05
4213.29 2.5559e-05
4953.24 2.5559e-05
2983.29 2.5559e-05
3288.44 2.5559e-05
2812.28 2.5559e-05
3538.67 2.5559e-05
4027.06 2.5559e-05
4708.45 2.5559e-05
2843.75 2.5559e-05
3149.57 2.5559e-05
2689.56 2.5559e-05
2109.92 2.5559e-05
3532.27 2.5559e-05
3676.47 2.5559e-05
5847.68 2.5559e-05
5879.59 2.5559e-05
END
$picture5 << END
2925.48 2.5559e-05
3152.43 2.5559e-05
2842.46 2.5559e-05
3705.68 2.5559e-05
3669.56 2.5559e-05
4405.75 2.5559e-05
2893.52 2.5559e-05
3107.29 2.5559e-05
2675.28 2.5559e-05
3436.71 2.5559e-05
3686.45 2.5559e-05
4383.5 2.5559e-05
2708.68 2.5559e-05
2966.87 2.5559e-05
2557.28 2.5559e-05
2015.35 0.000987729
3313.89 2.5559e-05
3445.8 0.0018404
5559.51 2.5559e-05
5577.37 2.5559e-05
END
$picture_front << END
5879.59 2.5559e-05
7738.98 0.000276037
9251.04 0.00135754
END
plot $picture0 with points pt 7 ps 1.3 lw 1.6 lc rgb '#d55e00' title 'fast', \
     $picture1 with points pt 6 ps 1.3 lw 1.6 lc rgb '#d55e00' title 'fast, study''s rule', \
     $picture2 with points pt 5 ps 1.3 lw 1.6 lc rgb '#0072b2' title 'robust', \
     $picture3 with points pt 4 ps 1.3 lw 1.6 lc rgb '#0072b2' title 'robust, study''s rule', \
     $picture4 with points pt 9 ps 1.3 lw 1.6 lc rgb '#009e73' title 'double', \
     $picture5 with points pt 8 ps 1.3 lw 1.6 lc rgb '#009e73' title 'double, study''s rule', \
     NaN with lines lw 1.8 dt '-' lc rgb '#222222' title 'Pareto front', \
     $picture_front with fsteps lw 1.8 dt '-' lc rgb '#222222' notitle, \
     $picture_front with points pt 6 ps 2.6 lw 1.6 lc rgb '#222222' notitle
unset multiplot
unset output

reset
set terminal pngcairo size 1100,1240 font 'DejaVu Sans,12' noenhanced background rgb 'white'
set output 'tetra.png'
set encoding utf8
set logscale xy
set border 3 lc rgb '#444444'
set tics nomirror
set grid lc rgb '#d4d4d4' lw 1 dt 1
set multiplot
set key at screen 0.05, screen 0.925 left top Left reverse vertical maxrows 2 samplen 2

unset label; unset arrow; unset object
set lmargin at screen 0.115; set rmargin at screen 0.735
set bmargin at screen 0.5; set tmargin at screen 0.855
set xrange [579.968:6999.84]; set yrange [9.53674e-08:0.0014317]
set xlabel 'million nearest hits a second  (more is better)'; set ylabel 'wrong hits  (less is better)' offset -1.5
set label 'tetra: speed against accuracy (GPU)' at screen 0.02, screen 0.9774 font ',20'
set label '1024x1024 primary and 1,048,576 random rays a scene; 2,097,152 in all compared with brute force in double; pictures of 512x512' at screen 0.02, screen 0.9516
set xtics ('700' 700, '1000' 1000, '1500' 1500, '2000' 2000, '3000' 3000, '5000' 5000)
set ytics ("none of\n2,097,152" 2.38419e-07, '0.0001 %%' 1e-6, '0.001 %%' 1e-5, '0.01 %%' 1e-4, '0.1 %%' 1e-3)
set object rectangle from graph 0, graph 0 to graph 1, first 4.05312e-07 fs solid noborder fc rgb '#eeeeee' behind
set arrow from first 5833.2,9.53674e-07 to graph 1.0,0.2394 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.2394 to graph 1.015,0.2394 nohead lw 0.8 lc rgb '#999999'
set label 'fast: irregular exact' at graph 1.02,0.2394 left
set arrow from first 4937.91,2.38419e-07 to graph 1.0,0.0953 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.0953 to graph 1.015,0.0953 nohead lw 0.8 lc rgb '#999999'
set label 'robust: irregular exact' at graph 1.02,0.0953 left
$hits0 << END
2643.01 9.53674e-07
2890.23 9.53674e-07
2037.68 9.53674e-07
2357.07 9.53674e-07
3340.61 9.53674e-07
3684.28 9.53674e-07
2596.51 9.53674e-07
2849.02 9.53674e-07
2251.63 9.53674e-07
2697.4 9.53674e-07
3594.76 9.53674e-07
4047.43 9.53674e-07
2394.88 9.53674e-07
2679.75 9.53674e-07
1981.68 9.53674e-07
1598.79 9.53674e-07
2745.42 9.53674e-07
2544.89 9.53674e-07
5427.41 9.53674e-07
5833.2 9.53674e-07
END
$hits1 << END
2656.61 9.53674e-07
2893.29 2.3365e-05
1979.34 9.53674e-07
2315.19 3.29018e-05
3118.09 9.53674e-07
3471 3.57628e-05
2657.15 9.53674e-07
2907.28 2.3365e-05
2232.61 9.53674e-07
2685.79 3.29018e-05
3361.17 9.53674e-07
3801.61 3.57628e-05
2466.63 9.53674e-07
2753.96 3.76701e-05
1992.64 9.53674e-07
1588.21 0.000572681
2714.16 9.53674e-07
2532.79 0.000368595
5231.58 9.53674e-07
5753.31 7.62939e-06
END
$hits2 << END
2153.17 2.38419e-07
2340.57 2.38419e-07
1694.88 2.38419e-07
1983.29 2.38419e-07
2713.71 2.38419e-07
3022.32 2.38419e-07
2153.81 2.38419e-07
2349.38 2.38419e-07
1870.85 2.38419e-07
2251.86 2.38419e-07
2917.64 2.38419e-07
3278.11 2.38419e-07
1998.48 2.38419e-07
2222.54 2.38419e-07
1698 2.38419e-07
1358.06 2.38419e-07
2309.48 2.38419e-07
2150.77 2.38419e-07
4557.12 2.38419e-07
4937.91 2.38419e-07
695.962 2.38419e-07
1493.19 2.38419e-07
2445.01 2.38419e-07
1381.54 2.38419e-07
1709.92 2.38419e-07
END
$hits3 << END
1895.53 2.38419e-07
2046.72 2.24113e-05
1479.07 2.38419e-07
1739.56 3.19481e-05
2297.74 2.38419e-07
2553.32 3.48091e-05
1895.53 2.38419e-07
2063.41 2.24113e-05
1628.14 2.38419e-07
1935.27 3.19481e-05
2434.2 2.38419e-07
2723.4 3.48091e-05
1770.48 2.38419e-07
1953.56 3.67165e-05
1446.36 2.38419e-07
1126.53 0.000571728
1942.27 2.38419e-07
1804.55 0.000367641
3906.53 2.38419e-07
4267.78 6.67572e-06
END
$hits4 << END
1322.65 1.76606e-07
1427.18 1.76606e-07
1013.02 1.76606e-07
1201.15 1.76606e-07
1648.12 1.76606e-07
1834.66 1.76606e-07
1324.47 1.76606e-07
1418.65 1.76606e-07
1122.73 1.76606e-07
1341.41 1.76606e-07
1767.52 1.76606e-07
1981.26 1.76606e-07
1215.95 1.76606e-07
1336.32 1.76606e-07
1017.97 1.76606e-07
808.458 1.76606e-07
1365.05 1.76606e-07
1253.53 1.76606e-07
2897.52 1.76606e-07
3025.67 1.76606e-07
END
$hits5 << END
1156.86 1.76606e-07
1231.74 2.24113e-05
934.626 1.76606e-07
1100.63 3.19481e-05
1437.48 1.76606e-07
1601.52 3.48091e-05
1207.19 1.76606e-07
1293.24 2.24113e-05
1039.91 1.76606e-07
1238.87 3.19481e-05
1575.27 1.76606e-07
1767.99 3.48091e-05
1106.47 1.76606e-07
1210.42 3.67165e-05
901.185 1.76606e-07
705.302 0.000571728
1203.03 1.76606e-07
1090.29 0.000367641
2614.12 1.76606e-07
2773.42 6.67572e-06
END
$hits_front << END
4937.91 2.38419e-07
5833.2 9.53674e-07
END
plot $hits0 with points pt 7 ps 1.3 lw 1.6 lc rgb '#d55e00' title 'fast', \
     $hits1 with points pt 6 ps 1.3 lw 1.6 lc rgb '#d55e00' title 'fast, study''s rule', \
     $hits2 with points pt 5 ps 1.3 lw 1.6 lc rgb '#0072b2' title 'robust', \
     $hits3 with points pt 4 ps 1.3 lw 1.6 lc rgb '#0072b2' title 'robust, study''s rule', \
     $hits4 with points pt 9 ps 1.3 lw 1.6 lc rgb '#009e73' title 'double', \
     $hits5 with points pt 8 ps 1.3 lw 1.6 lc rgb '#009e73' title 'double, study''s rule', \
     NaN with lines lw 1.8 dt '-' lc rgb '#222222' title 'Pareto front', \
     $hits_front with fsteps lw 1.8 dt '-' lc rgb '#222222' notitle, \
     $hits_front with points pt 6 ps 2.6 lw 1.6 lc rgb '#222222' notitle
unset key

unset label; unset arrow; unset object
set lmargin at screen 0.115; set rmargin at screen 0.735
set bmargin at screen 0.065; set tmargin at screen 0.42
set xrange [1151.11:11101.2]; set yrange [1.38018e-05:0.0057173]
set xlabel 'pictures a second  (more is better)'; set ylabel 'picture: RMSE of a channel  (less is better)' offset -1.5
set xtics ('1500' 1500, '2000' 2000, '3000' 3000, '5000' 5000, '7000' 7000, '10000' 10000)
set ytics ("same\nbits" 3.45046e-05, '10⁻⁴' 1e-4, '10⁻³' 1e-3)
set object rectangle from graph 0, graph 0 to graph 1, first 5.86579e-05 fs solid noborder fc rgb '#eeeeee' behind
set arrow from first 9251.04,0.00135754 to graph 1.0,0.7614 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.7614 to graph 1.015,0.7614 nohead lw 0.8 lc rgb '#999999'
set label 'fast: irregular exact' at graph 1.02,0.7614 left
set arrow from first 7738.98,0.000276037 to graph 1.0,0.4971 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.4971 to graph 1.015,0.4971 nohead lw 0.8 lc rgb '#999999'
set label 'robust: irregular box' at graph 1.02,0.4971 left
set arrow from first 5879.59,2.5559e-05 to graph 1.0,0.1022 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.1022 to graph 1.015,0.1022 nohead lw 0.8 lc rgb '#999999'
set label 'double: irregular exact' at graph 1.02,0.1022 left
$picture0 << END
5214.42 0.00135754
5526.08 0.00135754
4513.94 0.00135754
5574.38 0.00135754
7277.6 0.00135754
8592.25 0.00135754
5037.07 0.00135754
5340.05 0.00135754
4118.89 0.00135754
5072.23 0.00135754
7291.18 0.00135754
8282.53 0.00135754
4825.51 0.00135754
5059.09 0.00135754
4078.57 0.00135754
3242.37 0.00135754
5960.33 0.00135754
6082.13 0.00135754
9118.76 0.00135754
9251.04 0.00135754
END
$picture1 << END
4615.95 0.00135754
4928.24 0.00135754
4254.59 0.00135754
5388.86 0.00135754
6569.27 0.00135754
7769.77 0.00135754
4478.36 0.00135754
4975.32 0.00135754
3788.34 0.00135754
4764.45 0.00135754
6248.75 0.00135754
7476.08 0.00135754
4321.07 0.00135754
4832.97 0.00135754
3895.05 0.00135754
3081.55 0.00167885
5460.42 0.00135754
5854.25 0.00228692
8095.85 0.00135754
8241.03 0.00135754
END
$picture2 << END
4212.16 0.000276037
4716.27 0.000276037
3852.32 0.000276037
4992.81 0.000276037
6092.81 0.000276037
7212.09 0.000276037
4267.38 0.000276037
4498.34 0.000276037
3718.91 0.000276037
4676.04 0.000276037
6031.65 0.000276037
7035.12 0.000276037
3959.71 0.000276037
4453.47 0.000276037
3587.83 0.000276037
2800.68 0.000276037
5126.31 0.000276037
5065.65 0.000276037
7738.98 0.000276037
7607.11 0.000276037
1381.34 0.000276037
2930.42 0.000276037
4935.25 0.000276037
3416.05 0.000276037
3016.41 0.000276037
END
$picture3 << END
4018.26 0.000276037
4293.76 0.000276037
3525.1 0.000276037
4526.36 0.000276037
5177.27 0.000276037
6164.92 0.000276037
3952.69 0.000276037
4359.65 0.000276037
3371.82 0.000276037
4296.12 0.000276037
4996.8 0.000276037
6082.13 0.000276037
3736.7 0.000276037
4110.76 0.000276037
3430.3 0.000276037
2635.8 0.00102558
4740.59 0.000276037
4804.74 0.00186099
6783.16 0.000276037
6909.13 0.000276037
END
$picture4 << END
3043.14 2.5559e-05
3437.84 2.5559e-05
3055.64 2.5559e-05
3987.5 2.5559e-05
4213.29 2.5559e-05
4953.24 2.5559e-05
2983.29 2.5559e-05
3288.44 2.5559e-05
2812.28 2.5559e-05
3538.67 2.5559e-05
4027.06 2.5559e-05
4708.45 2.5559e-05
2843.75 2.5559e-05
3149.57 2.5559e-05
2689.56 2.5559e-05
2109.92 2.5559e-05
3532.27 2.5559e-05
3676.47 2.5559e-05
5847.68 2.5559e-05
5879.59 2.5559e-05
END
$picture5 << END
2925.48 2.5559e-05
3152.43 2.5559e-05
2842.46 2.5559e-05
3705.68 2.5559e-05
3669.56 2.5559e-05
4405.75 2.5559e-05
2893.52 2.5559e-05
3107.29 2.5559e-05
2675.28 2.5559e-05
3436.71 2.5559e-05
3686.45 2.5559e-05
4383.5 2.5559e-05
2708.68 2.5559e-05
2966.87 2.5559e-05
2557.28 2.5559e-05
2015.35 0.000987729
3313.89 2.5559e-05
3445.8 0.0018404
5559.51 2.5559e-05
5577.37 2.5559e-05
END
$picture_front << END
5879.59 2.5559e-05
7738.98 0.000276037
9251.04 0.00135754
END
plot $picture0 with points pt 7 ps 1.3 lw 1.6 lc rgb '#d55e00' title 'fast', \
     $picture1 with points pt 6 ps 1.3 lw 1.6 lc rgb '#d55e00' title 'fast, study''s rule', \
     $picture2 with points pt 5 ps 1.3 lw 1.6 lc rgb '#0072b2' title 'robust', \
     $picture3 with points pt 4 ps 1.3 lw 1.6 lc rgb '#0072b2' title 'robust, study''s rule', \
     $picture4 with points pt 9 ps 1.3 lw 1.6 lc rgb '#009e73' title 'double', \
     $picture5 with points pt 8 ps 1.3 lw 1.6 lc rgb '#009e73' title 'double, study''s rule', \
     NaN with lines lw 1.8 dt '-' lc rgb '#222222' title 'Pareto front', \
     $picture_front with fsteps lw 1.8 dt '-' lc rgb '#222222' notitle, \
     $picture_front with points pt 6 ps 2.6 lw 1.6 lc rgb '#222222' notitle
unset multiplot
unset output

reset
set terminal svg size 1100,1240 font 'DejaVu Sans,15' noenhanced background rgb 'white'
set output 'tree.svg'
set encoding utf8
set logscale xy
set border 3 lc rgb '#444444'
set tics nomirror
set grid lc rgb '#d4d4d4' lw 1 dt 1
set multiplot
set key at screen 0.05, screen 0.925 left top Left reverse vertical maxrows 2 samplen 2

unset label; unset arrow; unset object
set lmargin at screen 0.115; set rmargin at screen 0.735
set bmargin at screen 0.5; set tmargin at screen 0.855
set xrange [651.237:16268.8]; set yrange [9.53674e-08:0.0328958]
set xlabel 'million nearest hits a second  (more is better)'; set ylabel 'wrong hits  (less is better)' offset -1.5
set label 'tree: speed against accuracy (GPU)' at screen 0.02, screen 0.9774 font ',20'
set label '1024x1024 primary and 1,048,576 random rays a scene; 2,097,152 in all compared with brute force in double; pictures of 512x512' at screen 0.02, screen 0.9516
set xtics ('1000' 1000, '2000' 2000, '5000' 5000, '10000' 10000)
set ytics ("none of\n2,097,152" 2.38419e-07, '0.0001 %%' 1e-6, '0.001 %%' 1e-5, '0.01 %%' 1e-4, '0.1 %%' 1e-3, '1 %%' 1e-2)
set object rectangle from graph 0, graph 0 to graph 1, first 4.05312e-07 fs solid noborder fc rgb '#eeeeee' behind
set arrow from first 13557.3,0.0130477 to graph 1.0,0.9275 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.9275 to graph 1.015,0.9275 nohead lw 0.8 lc rgb '#999999'
set label 'fast, study: irregular exact' at graph 1.02,0.9275 left
set arrow from first 13391.1,0.00126839 to graph 1.0,0.7447 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.7447 to graph 1.015,0.7447 nohead lw 0.8 lc rgb '#999999'
set label 'fast: irregular exact' at graph 1.02,0.7447 left
set arrow from first 8814.53,2.38419e-07 to graph 1.0,0.0719 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.0719 to graph 1.015,0.0719 nohead lw 0.8 lc rgb '#999999'
set label 'robust: irregular exact' at graph 1.02,0.0719 left
$hits0 << END
875.12 0.00126934
898.147 0.00126934
1504.22 0.00126934
1555.42 0.00126934
885.323 0.00126934
906.307 0.00126934
1622.3 0.00126934
1696.51 0.00126934
889.396 0.00126934
909.603 0.00126934
4157.85 0.00126934
4350.5 0.00126934
12571.6 0.00126934
13391.1 0.00126839
END
$hits1 << END
869.143 0.00209665
896.783 0.00218582
1579.18 0.00253057
1609.63 0.00226974
885.251 0.00209665
899.713 0.00218582
1703.92 0.00253057
1761.29 0.00226974
890.883 0.00209713
913.216 0.00207329
4148.64 0.00177336
4320.96 0.00159454
12775 0.0131583
13557.3 0.0130477
END
$hits2 << END
784.374 2.38419e-07
806.527 2.38419e-07
1177.03 2.38419e-07
1219.07 2.38419e-07
783.249 2.38419e-07
795.881 2.38419e-07
1263.05 2.38419e-07
1310.62 2.38419e-07
815.621 2.38419e-07
832.605 2.38419e-07
3320.97 2.38419e-07
3447.27 2.38419e-07
8499.03 2.38419e-07
8814.53 2.38419e-07
988.253 2.38419e-07
1296.38 2.38419e-07
END
$hits3 << END
783.745 0.000859737
805.922 0.00095129
1250.9 0.00127172
1268.95 0.00100994
781.484 0.000859737
798.694 0.00095129
1353.35 0.00127172
1400.49 0.00100994
811.702 0.000860214
833.357 0.000838757
3329.74 0.000521183
3456.9 0.000339508
8725.34 0.0119157
9212.26 0.0118027
END
$hits4 << END
978.836 1.76606e-07
1032.53 1.76606e-07
959.813 1.76606e-07
1025.68 1.76606e-07
2166.19 1.76606e-07
2256.59 1.76606e-07
6331.98 1.76606e-07
6530.09 1.76606e-07
END
$hits5 << END
1029.55 0.00127172
1060.57 0.00100994
1064.07 0.00127172
1110.84 0.00100994
2179.74 0.000521183
2281.26 0.000339508
6688.03 0.0119157
6914.54 0.0118027
END
$hits_front << END
8814.53 2.38419e-07
13391.1 0.00126839
13557.3 0.0130477
END
plot $hits0 with points pt 7 ps 1.3 lw 1.6 lc rgb '#d55e00' title 'fast', \
     $hits1 with points pt 6 ps 1.3 lw 1.6 lc rgb '#d55e00' title 'fast, study''s rule', \
     $hits2 with points pt 5 ps 1.3 lw 1.6 lc rgb '#0072b2' title 'robust', \
     $hits3 with points pt 4 ps 1.3 lw 1.6 lc rgb '#0072b2' title 'robust, study''s rule', \
     $hits4 with points pt 9 ps 1.3 lw 1.6 lc rgb '#009e73' title 'double', \
     $hits5 with points pt 8 ps 1.3 lw 1.6 lc rgb '#009e73' title 'double, study''s rule', \
     NaN with lines lw 1.8 dt '-' lc rgb '#222222' title 'Pareto front', \
     $hits_front with fsteps lw 1.8 dt '-' lc rgb '#222222' notitle, \
     $hits_front with points pt 6 ps 2.6 lw 1.6 lc rgb '#222222' notitle
unset key

unset label; unset arrow; unset object
set lmargin at screen 0.115; set rmargin at screen 0.735
set bmargin at screen 0.065; set tmargin at screen 0.42
set xrange [128.349:5359.44]; set yrange [4.99422e-05:0.104973]
set xlabel 'pictures a second  (more is better)'; set ylabel 'picture: RMSE of a channel  (less is better)' offset -1.5
set xtics ('200' 200, '500' 500, '1000' 1000, '2000' 2000, '5000' 5000)
set ytics ("same\nbits" 0.000124856, '10⁻³' 1e-3, '10⁻²' 1e-2, '10⁻¹' 1e-1)
set object rectangle from graph 0, graph 0 to graph 1, first 0.000212255 fs solid noborder fc rgb '#eeeeee' behind
set arrow from first 4466.2,0.0419684 to graph 1.0,0.8802 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.8802 to graph 1.015,0.8802 nohead lw 0.8 lc rgb '#999999'
set label 'fast, study: irregular exact' at graph 1.02,0.8802 left
set arrow from first 4406.37,0.0197771 to graph 1.0,0.7818 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.7818 to graph 1.015,0.7818 nohead lw 0.8 lc rgb '#999999'
set label 'fast: irregular exact' at graph 1.02,0.7818 left
set arrow from first 3161.04,0.000998845 to graph 1.0,0.3916 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.3916 to graph 1.015,0.3916 nohead lw 0.8 lc rgb '#999999'
set label 'robust: irregular exact' at graph 1.02,0.3916 left
set arrow from first 2729.97,9.24856e-05 to graph 1.0,0.0805 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.0805 to graph 1.015,0.0805 nohead lw 0.8 lc rgb '#999999'
set label 'double: irregular exact' at graph 1.02,0.0805 left
$picture0 << END
167.096 0.0197771
168.267 0.0197771
1214.54 0.0197771
1267.03 0.0197771
162.229 0.0197771
166.536 0.0197771
1060.51 0.0197771
1108.67 0.0197771
168.302 0.0197771
174.031 0.0197771
1181.97 0.0197771
1228.14 0.0197771
4035.9 0.0197771
4406.37 0.0197771
END
$picture1 << END
164.634 0.0201229
171.099 0.0201961
1215.1 0.0210265
1269.96 0.0208214
162.666 0.0201229
167.314 0.0201961
1076.73 0.0210265
1126.41 0.0208214
169.808 0.0201229
172.323 0.0201108
1176.63 0.0200881
1226.5 0.0200283
4045.83 0.0419892
4466.2 0.0419684
END
$picture2 << END
159.214 0.000998845
162.601 0.000998845
948.749 0.000998845
1006.64 0.000998845
154.019 0.000998845
159.838 0.000998845
876.332 0.000998845
895.207 0.000998845
160.385 0.000998845
165.989 0.000998845
938.747 0.000998845
984 0.000998845
2867.5 0.000998845
3161.04 0.000998845
249.948 0.000998845
371.374 0.000998845
END
$picture3 << END
159.078 0.00408026
164.23 0.00446055
971.251 0.00726785
1011.69 0.00665447
154.875 0.00408026
159.439 0.00446055
893.216 0.00726785
908.612 0.00665447
160.5 0.00408026
165.782 0.00405698
953.935 0.00376376
988.826 0.00345327
2903.47 0.0370767
3231.98 0.0370432
END
$picture4 << END
783.012 9.24856e-05
821.005 9.24856e-05
710.116 9.24856e-05
737.898 9.24856e-05
760.081 9.24856e-05
789.341 9.24856e-05
2434.37 9.24856e-05
2729.97 9.24856e-05
END
$picture5 << END
790.158 0.00721073
826.918 0.00658548
719.217 0.00721073
740.521 0.00658548
780.799 0.00365225
796.362 0.00332386
2438.55 0.0370679
2770.14 0.0370337
END
$picture_front << END
2729.97 9.24856e-05
3161.04 0.000998845
4406.37 0.0197771
4466.2 0.0419684
END
plot $picture0 with points pt 7 ps 1.3 lw 1.6 lc rgb '#d55e00' title 'fast', \
     $picture1 with points pt 6 ps 1.3 lw 1.6 lc rgb '#d55e00' title 'fast, study''s rule', \
     $picture2 with points pt 5 ps 1.3 lw 1.6 lc rgb '#0072b2' title 'robust', \
     $picture3 with points pt 4 ps 1.3 lw 1.6 lc rgb '#0072b2' title 'robust, study''s rule', \
     $picture4 with points pt 9 ps 1.3 lw 1.6 lc rgb '#009e73' title 'double', \
     $picture5 with points pt 8 ps 1.3 lw 1.6 lc rgb '#009e73' title 'double, study''s rule', \
     NaN with lines lw 1.8 dt '-' lc rgb '#222222' title 'Pareto front', \
     $picture_front with fsteps lw 1.8 dt '-' lc rgb '#222222' notitle, \
     $picture_front with points pt 6 ps 2.6 lw 1.6 lc rgb '#222222' notitle
unset multiplot
unset output

reset
set terminal pngcairo size 1100,1240 font 'DejaVu Sans,12' noenhanced background rgb 'white'
set output 'tree.png'
set encoding utf8
set logscale xy
set border 3 lc rgb '#444444'
set tics nomirror
set grid lc rgb '#d4d4d4' lw 1 dt 1
set multiplot
set key at screen 0.05, screen 0.925 left top Left reverse vertical maxrows 2 samplen 2

unset label; unset arrow; unset object
set lmargin at screen 0.115; set rmargin at screen 0.735
set bmargin at screen 0.5; set tmargin at screen 0.855
set xrange [651.237:16268.8]; set yrange [9.53674e-08:0.0328958]
set xlabel 'million nearest hits a second  (more is better)'; set ylabel 'wrong hits  (less is better)' offset -1.5
set label 'tree: speed against accuracy (GPU)' at screen 0.02, screen 0.9774 font ',20'
set label '1024x1024 primary and 1,048,576 random rays a scene; 2,097,152 in all compared with brute force in double; pictures of 512x512' at screen 0.02, screen 0.9516
set xtics ('1000' 1000, '2000' 2000, '5000' 5000, '10000' 10000)
set ytics ("none of\n2,097,152" 2.38419e-07, '0.0001 %%' 1e-6, '0.001 %%' 1e-5, '0.01 %%' 1e-4, '0.1 %%' 1e-3, '1 %%' 1e-2)
set object rectangle from graph 0, graph 0 to graph 1, first 4.05312e-07 fs solid noborder fc rgb '#eeeeee' behind
set arrow from first 13557.3,0.0130477 to graph 1.0,0.9275 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.9275 to graph 1.015,0.9275 nohead lw 0.8 lc rgb '#999999'
set label 'fast, study: irregular exact' at graph 1.02,0.9275 left
set arrow from first 13391.1,0.00126839 to graph 1.0,0.7447 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.7447 to graph 1.015,0.7447 nohead lw 0.8 lc rgb '#999999'
set label 'fast: irregular exact' at graph 1.02,0.7447 left
set arrow from first 8814.53,2.38419e-07 to graph 1.0,0.0719 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.0719 to graph 1.015,0.0719 nohead lw 0.8 lc rgb '#999999'
set label 'robust: irregular exact' at graph 1.02,0.0719 left
$hits0 << END
875.12 0.00126934
898.147 0.00126934
1504.22 0.00126934
1555.42 0.00126934
885.323 0.00126934
906.307 0.00126934
1622.3 0.00126934
1696.51 0.00126934
889.396 0.00126934
909.603 0.00126934
4157.85 0.00126934
4350.5 0.00126934
12571.6 0.00126934
13391.1 0.00126839
END
$hits1 << END
869.143 0.00209665
896.783 0.00218582
1579.18 0.00253057
1609.63 0.00226974
885.251 0.00209665
899.713 0.00218582
1703.92 0.00253057
1761.29 0.00226974
890.883 0.00209713
913.216 0.00207329
4148.64 0.00177336
4320.96 0.00159454
12775 0.0131583
13557.3 0.0130477
END
$hits2 << END
784.374 2.38419e-07
806.527 2.38419e-07
1177.03 2.38419e-07
1219.07 2.38419e-07
783.249 2.38419e-07
795.881 2.38419e-07
1263.05 2.38419e-07
1310.62 2.38419e-07
815.621 2.38419e-07
832.605 2.38419e-07
3320.97 2.38419e-07
3447.27 2.38419e-07
8499.03 2.38419e-07
8814.53 2.38419e-07
988.253 2.38419e-07
1296.38 2.38419e-07
END
$hits3 << END
783.745 0.000859737
805.922 0.00095129
1250.9 0.00127172
1268.95 0.00100994
781.484 0.000859737
798.694 0.00095129
1353.35 0.00127172
1400.49 0.00100994
811.702 0.000860214
833.357 0.000838757
3329.74 0.000521183
3456.9 0.000339508
8725.34 0.0119157
9212.26 0.0118027
END
$hits4 << END
978.836 1.76606e-07
1032.53 1.76606e-07
959.813 1.76606e-07
1025.68 1.76606e-07
2166.19 1.76606e-07
2256.59 1.76606e-07
6331.98 1.76606e-07
6530.09 1.76606e-07
END
$hits5 << END
1029.55 0.00127172
1060.57 0.00100994
1064.07 0.00127172
1110.84 0.00100994
2179.74 0.000521183
2281.26 0.000339508
6688.03 0.0119157
6914.54 0.0118027
END
$hits_front << END
8814.53 2.38419e-07
13391.1 0.00126839
13557.3 0.0130477
END
plot $hits0 with points pt 7 ps 1.3 lw 1.6 lc rgb '#d55e00' title 'fast', \
     $hits1 with points pt 6 ps 1.3 lw 1.6 lc rgb '#d55e00' title 'fast, study''s rule', \
     $hits2 with points pt 5 ps 1.3 lw 1.6 lc rgb '#0072b2' title 'robust', \
     $hits3 with points pt 4 ps 1.3 lw 1.6 lc rgb '#0072b2' title 'robust, study''s rule', \
     $hits4 with points pt 9 ps 1.3 lw 1.6 lc rgb '#009e73' title 'double', \
     $hits5 with points pt 8 ps 1.3 lw 1.6 lc rgb '#009e73' title 'double, study''s rule', \
     NaN with lines lw 1.8 dt '-' lc rgb '#222222' title 'Pareto front', \
     $hits_front with fsteps lw 1.8 dt '-' lc rgb '#222222' notitle, \
     $hits_front with points pt 6 ps 2.6 lw 1.6 lc rgb '#222222' notitle
unset key

unset label; unset arrow; unset object
set lmargin at screen 0.115; set rmargin at screen 0.735
set bmargin at screen 0.065; set tmargin at screen 0.42
set xrange [128.349:5359.44]; set yrange [4.99422e-05:0.104973]
set xlabel 'pictures a second  (more is better)'; set ylabel 'picture: RMSE of a channel  (less is better)' offset -1.5
set xtics ('200' 200, '500' 500, '1000' 1000, '2000' 2000, '5000' 5000)
set ytics ("same\nbits" 0.000124856, '10⁻³' 1e-3, '10⁻²' 1e-2, '10⁻¹' 1e-1)
set object rectangle from graph 0, graph 0 to graph 1, first 0.000212255 fs solid noborder fc rgb '#eeeeee' behind
set arrow from first 4466.2,0.0419684 to graph 1.0,0.8802 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.8802 to graph 1.015,0.8802 nohead lw 0.8 lc rgb '#999999'
set label 'fast, study: irregular exact' at graph 1.02,0.8802 left
set arrow from first 4406.37,0.0197771 to graph 1.0,0.7818 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.7818 to graph 1.015,0.7818 nohead lw 0.8 lc rgb '#999999'
set label 'fast: irregular exact' at graph 1.02,0.7818 left
set arrow from first 3161.04,0.000998845 to graph 1.0,0.3916 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.3916 to graph 1.015,0.3916 nohead lw 0.8 lc rgb '#999999'
set label 'robust: irregular exact' at graph 1.02,0.3916 left
set arrow from first 2729.97,9.24856e-05 to graph 1.0,0.0805 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.0805 to graph 1.015,0.0805 nohead lw 0.8 lc rgb '#999999'
set label 'double: irregular exact' at graph 1.02,0.0805 left
$picture0 << END
167.096 0.0197771
168.267 0.0197771
1214.54 0.0197771
1267.03 0.0197771
162.229 0.0197771
166.536 0.0197771
1060.51 0.0197771
1108.67 0.0197771
168.302 0.0197771
174.031 0.0197771
1181.97 0.0197771
1228.14 0.0197771
4035.9 0.0197771
4406.37 0.0197771
END
$picture1 << END
164.634 0.0201229
171.099 0.0201961
1215.1 0.0210265
1269.96 0.0208214
162.666 0.0201229
167.314 0.0201961
1076.73 0.0210265
1126.41 0.0208214
169.808 0.0201229
172.323 0.0201108
1176.63 0.0200881
1226.5 0.0200283
4045.83 0.0419892
4466.2 0.0419684
END
$picture2 << END
159.214 0.000998845
162.601 0.000998845
948.749 0.000998845
1006.64 0.000998845
154.019 0.000998845
159.838 0.000998845
876.332 0.000998845
895.207 0.000998845
160.385 0.000998845
165.989 0.000998845
938.747 0.000998845
984 0.000998845
2867.5 0.000998845
3161.04 0.000998845
249.948 0.000998845
371.374 0.000998845
END
$picture3 << END
159.078 0.00408026
164.23 0.00446055
971.251 0.00726785
1011.69 0.00665447
154.875 0.00408026
159.439 0.00446055
893.216 0.00726785
908.612 0.00665447
160.5 0.00408026
165.782 0.00405698
953.935 0.00376376
988.826 0.00345327
2903.47 0.0370767
3231.98 0.0370432
END
$picture4 << END
783.012 9.24856e-05
821.005 9.24856e-05
710.116 9.24856e-05
737.898 9.24856e-05
760.081 9.24856e-05
789.341 9.24856e-05
2434.37 9.24856e-05
2729.97 9.24856e-05
END
$picture5 << END
790.158 0.00721073
826.918 0.00658548
719.217 0.00721073
740.521 0.00658548
780.799 0.00365225
796.362 0.00332386
2438.55 0.0370679
2770.14 0.0370337
END
$picture_front << END
2729.97 9.24856e-05
3161.04 0.000998845
4406.37 0.0197771
4466.2 0.0419684
END
plot $picture0 with points pt 7 ps 1.3 lw 1.6 lc rgb '#d55e00' title 'fast', \
     $picture1 with points pt 6 ps 1.3 lw 1.6 lc rgb '#d55e00' title 'fast, study''s rule', \
     $picture2 with points pt 5 ps 1.3 lw 1.6 lc rgb '#0072b2' title 'robust', \
     $picture3 with points pt 4 ps 1.3 lw 1.6 lc rgb '#0072b2' title 'robust, study''s rule', \
     $picture4 with points pt 9 ps 1.3 lw 1.6 lc rgb '#009e73' title 'double', \
     $picture5 with points pt 8 ps 1.3 lw 1.6 lc rgb '#009e73' title 'double, study''s rule', \
     NaN with lines lw 1.8 dt '-' lc rgb '#222222' title 'Pareto front', \
     $picture_front with fsteps lw 1.8 dt '-' lc rgb '#222222' notitle, \
     $picture_front with points pt 6 ps 2.6 lw 1.6 lc rgb '#222222' notitle
unset multiplot
unset output

reset
set terminal svg size 1100,1240 font 'DejaVu Sans,15' noenhanced background rgb 'white'
set output 'tradeoff.svg'
set encoding utf8
set logscale xy
set border 3 lc rgb '#444444'
set tics nomirror
set grid lc rgb '#d4d4d4' lw 1 dt 1
set multiplot
set key at screen 0.05, screen 0.925 left top Left reverse vertical maxrows 2 samplen 2

unset label; unset arrow; unset object
set lmargin at screen 0.115; set rmargin at screen 0.735
set bmargin at screen 0.5; set tmargin at screen 0.855
set xrange [563.394:9569.76]; set yrange [1.36239e-08:0.0198679]
set xlabel 'million nearest hits a second  (more is better)'; set ylabel 'wrong hits  (less is better)' offset -1.5
set label 'mean of 7 scenes: speed against accuracy (GPU)' at screen 0.02, screen 0.9774 font ',20'
set label '1024x1024 primary and 1,048,576 random rays a scene; 14,680,064 in all compared with brute force in double; pictures of 512x512' at screen 0.02, screen 0.9516
set xtics ('700' 700, '1000' 1000, '1500' 1500, '2000' 2000, '3000' 3000, '5000' 5000, '7000' 7000)
set ytics ("none of\n14,680,064" 3.40598e-08, '0.00001 %%' 1e-7, '0.0001 %%' 1e-6, '0.001 %%' 1e-5, '0.01 %%' 1e-4, '0.1 %%' 1e-3, '1 %%' 1e-2)
set object rectangle from graph 0, graph 0 to graph 1, first 5.79017e-08 fs solid noborder fc rgb '#eeeeee' behind
set arrow from first 7974.8,0.00330618 to graph 1.0,0.8736 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.8736 to graph 1.015,0.8736 nohead lw 0.8 lc rgb '#999999'
set label 'fast, study: irregular exact' at graph 1.02,0.8736 left
set arrow from first 7933.37,0.000229563 to graph 1.0,0.6857 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.6857 to graph 1.015,0.6857 nohead lw 0.8 lc rgb '#999999'
set label 'fast: irregular exact' at graph 1.02,0.6857 left
set arrow from first 6365.42,3.40598e-08 to graph 1.0,0.0646 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.0646 to graph 1.015,0.0646 nohead lw 0.8 lc rgb '#999999'
set label 'robust: irregular exact' at graph 1.02,0.0646 left
$hits0 << END
1410.93 0.000229699
1477.46 0.000229699
1958.79 0.000229699
2153.54 0.000229699
2410.69 0.000229699
2700.14 0.000229699
1429.74 0.000229699
1505.69 0.000229699
2148.97 0.000229699
2393.01 0.000229699
2728.49 0.000229699
3099.27 0.000229699
1404.28 0.000229699
1478.81 0.000229699
1711.68 0.000229699
1747.88 0.000229699
2894.96 0.000229699
2992.2 0.000229699
7031.52 0.000229699
7933.37 0.000229563
END
$hits1 << END
1394.34 0.00538867
1462.3 0.00519807
1967.73 0.00794717
2144.89 0.00454112
2464.31 0.00585638
2710.04 0.00247186
1424.37 0.00538867
1496.78 0.00519807
2175.55 0.00794717
2389.08 0.00454112
2782.9 0.00585638
3131.01 0.00247186
1398.44 0.00554262
1474.42 0.00522232
1710.87 0.00724963
1732.14 0.00561462
2916.53 0.00587109
3001.3 0.0029115
7155.52 0.00596571
7974.8 0.00330618
END
$hits2 << END
1191.67 3.40598e-08
1246.67 3.40598e-08
1684.58 3.40598e-08
1858.4 3.40598e-08
2007.01 3.40598e-08
2264.06 3.40598e-08
1206.54 3.40598e-08
1265.51 3.40598e-08
1829.43 3.40598e-08
2038.5 3.40598e-08
2248.63 3.40598e-08
2565.63 3.40598e-08
1183.53 3.40598e-08
1247.65 3.40598e-08
1457.16 3.40598e-08
1484.33 3.40598e-08
2427.91 3.40598e-08
2503.2 3.40598e-08
5635.31 3.40598e-08
6365.42 3.40598e-08
704.987 3.40598e-08
1788.65 3.40598e-08
1456.77 3.40598e-08
1988.64 3.40598e-08
END
$hits3 << END
1117.15 0.00516919
1164.27 0.00497798
1548.53 0.00773273
1673.77 0.00432321
1871.86 0.00563785
2053.86 0.00224808
1129.87 0.00516919
1180.51 0.00497798
1655.27 0.00773273
1807.67 0.00432321
2077.48 0.00563785
2315.54 0.00224808
1109.11 0.00532327
1161.67 0.00500216
1320.12 0.00703709
1327.86 0.00539998
2191.51 0.00565297
2239.88 0.00268997
5224.64 0.00574923
5795.57 0.00308466
END
$hits4 << END
734.316 2.52295e-08
768.215 2.52295e-08
1055.13 2.52295e-08
1180.34 2.52295e-08
1329.45 2.52295e-08
1518.46 2.52295e-08
739.899 2.52295e-08
775.88 2.52295e-08
1111.15 2.52295e-08
1245.66 2.52295e-08
1428.69 2.52295e-08
1643.58 2.52295e-08
724.721 2.52295e-08
760.515 2.52295e-08
899.899 2.52295e-08
903.708 2.52295e-08
1444.48 2.52295e-08
1481.94 2.52295e-08
3703.9 2.52295e-08
4165.13 2.52295e-08
END
$hits5 << END
676.073 0.00516919
702.844 0.00497804
1005.16 0.00773273
1103.82 0.00432348
1274.73 0.00563792
1425.37 0.00224836
700.143 0.00516919
729.596 0.00497804
1068.6 0.00773273
1174.56 0.00432355
1402.45 0.00563792
1581.12 0.00224836
683.517 0.00532327
715.425 0.00500223
841.67 0.00703771
838.052 0.005401
1357.75 0.00565304
1375.39 0.00269011
3633.85 0.00574923
4023.46 0.00308473
END
$hits_front << END
6365.42 3.40598e-08
7933.37 0.000229563
7974.8 0.00330618
END
plot $hits0 with points pt 7 ps 1.3 lw 1.6 lc rgb '#d55e00' title 'fast', \
     $hits1 with points pt 6 ps 1.3 lw 1.6 lc rgb '#d55e00' title 'fast, study''s rule', \
     $hits2 with points pt 5 ps 1.3 lw 1.6 lc rgb '#0072b2' title 'robust', \
     $hits3 with points pt 4 ps 1.3 lw 1.6 lc rgb '#0072b2' title 'robust, study''s rule', \
     $hits4 with points pt 9 ps 1.3 lw 1.6 lc rgb '#009e73' title 'double', \
     $hits5 with points pt 8 ps 1.3 lw 1.6 lc rgb '#009e73' title 'double, study''s rule', \
     NaN with lines lw 1.8 dt '-' lc rgb '#222222' title 'Pareto front', \
     $hits_front with fsteps lw 1.8 dt '-' lc rgb '#222222' notitle, \
     $hits_front with points pt 6 ps 2.6 lw 1.6 lc rgb '#222222' notitle
unset key

unset label; unset arrow; unset object
set lmargin at screen 0.115; set rmargin at screen 0.735
set bmargin at screen 0.065; set tmargin at screen 0.42
set xrange [165.994:3065.87]; set yrange [6.25401e-05:0.0710163]
set xlabel 'pictures a second  (more is better)'; set ylabel 'picture: RMSE of a channel  (less is better)' offset -1.5
set xtics ('200' 200, '300' 300, '500' 500, '700' 700, '1000' 1000, '1500' 1500, '2000' 2000, '3000' 3000)
set ytics ("same\nbits" 0.00015635, '10⁻³' 1e-3, '10⁻²' 1e-2)
set object rectangle from graph 0, graph 0 to graph 1, first 0.000265795 fs solid noborder fc rgb '#eeeeee' behind
set arrow from first 2554.89,0.0123829 to graph 1.0,0.7517 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.7517 to graph 1.015,0.7517 nohead lw 0.8 lc rgb '#999999'
set label 'fast: irregular exact' at graph 1.02,0.7517 left
set arrow from first 2032.6,0.0012508 to graph 1.0,0.4258 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.4258 to graph 1.015,0.4258 nohead lw 0.8 lc rgb '#999999'
set label 'robust: irregular exact' at graph 1.02,0.4258 left
set arrow from first 1553.09,0.000115815 to graph 1.0,0.0876 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.0876 to graph 1.015,0.0876 nohead lw 0.8 lc rgb '#999999'
set label 'double: irregular exact' at graph 1.02,0.0876 left
$picture0 << END
415.625 0.0123829
433.79 0.0123829
645.016 0.0123829
729.968 0.0123829
1148.85 0.0123829
1321.48 0.0123829
413.208 0.0123829
429.919 0.0123829
614.204 0.0123829
706.092 0.0123829
1129.51 0.0123829
1305.62 0.0123829
407.812 0.0123829
426.271 0.0123829
542.99 0.0123829
544.471 0.0123829
1003.08 0.0123829
1061.15 0.0123829
2223.09 0.0123829
2554.89 0.0123829
END
$picture1 << END
397.917 0.0224395
418.114 0.0220541
631.845 0.0284065
718.338 0.0216447
1136.95 0.0244543
1292.26 0.0180228
394.713 0.0224395
417.384 0.0220541
608.296 0.0284065
694.799 0.0216447
1118.79 0.0244543
1291.26 0.0180228
390.935 0.0224396
412.223 0.022057
532.031 0.0253287
531.184 0.0228696
987.46 0.0238868
1045.29 0.0183197
2190.47 0.0261517
2507.83 0.0216219
END
$picture2 << END
352.403 0.0012508
370.235 0.0012508
553.191 0.0012508
636.098 0.0012508
952.058 0.0012508
1092.7 0.0012508
352.791 0.0012508
369.559 0.0012508
537.348 0.0012508
627.544 0.0012508
953.515 0.0012508
1103.07 0.0012508
351.037 0.0012508
369.139 0.0012508
472.239 0.0012508
474.808 0.0012508
843.8 0.0012508
887.692 0.0012508
1789.28 0.0012508
2032.6 0.0012508
199.193 0.0012508
542.074 0.0012508
573.162 0.0012508
634.608 0.0012508
END
$picture3 << END
336.666 0.0189295
351.438 0.0184437
527.521 0.0258171
601.511 0.0179318
898.019 0.0213317
1016.94 0.0133382
343.331 0.0189295
359.492 0.0184437
528.319 0.0258171
601.293 0.0179318
925.481 0.0213317
1057.55 0.0133382
338.996 0.0189297
353.979 0.0184472
462.881 0.0223219
461.116 0.0194443
824.122 0.0206086
866.815 0.0137238
1743.55 0.0232584
1966.03 0.0179105
END
$picture4 << END
240.102 0.000115815
252.868 0.000115815
413.819 0.000115815
482.548 0.000115815
707.466 0.000115815
816.965 0.000115815
239.644 0.000115815
249.975 0.000115815
401.308 0.000115815
467.177 0.000115815
692.161 0.000115815
804.352 0.000115815
237.751 0.000115815
247.555 0.000115815
344.941 0.000115815
344.375 0.000115815
609.894 0.000115815
645.484 0.000115815
1346.93 0.000115815
1553.09 0.000115815
END
$picture5 << END
234.265 0.0188937
245.575 0.0184077
407.737 0.0257929
466.768 0.0178971
685.187 0.0213012
788.936 0.0132958
235.048 0.0188937
245.171 0.0184077
401.616 0.0257929
462.584 0.0178972
690.596 0.0213012
802.468 0.0132958
232.019 0.0188939
241.682 0.0184113
338.855 0.0222991
337.928 0.0194207
602.097 0.0205768
633.317 0.0136759
1346.71 0.0232304
1538.26 0.0178721
END
$picture_front << END
1553.09 0.000115815
2032.6 0.0012508
2554.89 0.0123829
END
plot $picture0 with points pt 7 ps 1.3 lw 1.6 lc rgb '#d55e00' title 'fast', \
     $picture1 with points pt 6 ps 1.3 lw 1.6 lc rgb '#d55e00' title 'fast, study''s rule', \
     $picture2 with points pt 5 ps 1.3 lw 1.6 lc rgb '#0072b2' title 'robust', \
     $picture3 with points pt 4 ps 1.3 lw 1.6 lc rgb '#0072b2' title 'robust, study''s rule', \
     $picture4 with points pt 9 ps 1.3 lw 1.6 lc rgb '#009e73' title 'double', \
     $picture5 with points pt 8 ps 1.3 lw 1.6 lc rgb '#009e73' title 'double, study''s rule', \
     NaN with lines lw 1.8 dt '-' lc rgb '#222222' title 'Pareto front', \
     $picture_front with fsteps lw 1.8 dt '-' lc rgb '#222222' notitle, \
     $picture_front with points pt 6 ps 2.6 lw 1.6 lc rgb '#222222' notitle
unset multiplot
unset output

reset
set terminal pngcairo size 1100,1240 font 'DejaVu Sans,12' noenhanced background rgb 'white'
set output 'tradeoff.png'
set encoding utf8
set logscale xy
set border 3 lc rgb '#444444'
set tics nomirror
set grid lc rgb '#d4d4d4' lw 1 dt 1
set multiplot
set key at screen 0.05, screen 0.925 left top Left reverse vertical maxrows 2 samplen 2

unset label; unset arrow; unset object
set lmargin at screen 0.115; set rmargin at screen 0.735
set bmargin at screen 0.5; set tmargin at screen 0.855
set xrange [563.394:9569.76]; set yrange [1.36239e-08:0.0198679]
set xlabel 'million nearest hits a second  (more is better)'; set ylabel 'wrong hits  (less is better)' offset -1.5
set label 'mean of 7 scenes: speed against accuracy (GPU)' at screen 0.02, screen 0.9774 font ',20'
set label '1024x1024 primary and 1,048,576 random rays a scene; 14,680,064 in all compared with brute force in double; pictures of 512x512' at screen 0.02, screen 0.9516
set xtics ('700' 700, '1000' 1000, '1500' 1500, '2000' 2000, '3000' 3000, '5000' 5000, '7000' 7000)
set ytics ("none of\n14,680,064" 3.40598e-08, '0.00001 %%' 1e-7, '0.0001 %%' 1e-6, '0.001 %%' 1e-5, '0.01 %%' 1e-4, '0.1 %%' 1e-3, '1 %%' 1e-2)
set object rectangle from graph 0, graph 0 to graph 1, first 5.79017e-08 fs solid noborder fc rgb '#eeeeee' behind
set arrow from first 7974.8,0.00330618 to graph 1.0,0.8736 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.8736 to graph 1.015,0.8736 nohead lw 0.8 lc rgb '#999999'
set label 'fast, study: irregular exact' at graph 1.02,0.8736 left
set arrow from first 7933.37,0.000229563 to graph 1.0,0.6857 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.6857 to graph 1.015,0.6857 nohead lw 0.8 lc rgb '#999999'
set label 'fast: irregular exact' at graph 1.02,0.6857 left
set arrow from first 6365.42,3.40598e-08 to graph 1.0,0.0646 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.0646 to graph 1.015,0.0646 nohead lw 0.8 lc rgb '#999999'
set label 'robust: irregular exact' at graph 1.02,0.0646 left
$hits0 << END
1410.93 0.000229699
1477.46 0.000229699
1958.79 0.000229699
2153.54 0.000229699
2410.69 0.000229699
2700.14 0.000229699
1429.74 0.000229699
1505.69 0.000229699
2148.97 0.000229699
2393.01 0.000229699
2728.49 0.000229699
3099.27 0.000229699
1404.28 0.000229699
1478.81 0.000229699
1711.68 0.000229699
1747.88 0.000229699
2894.96 0.000229699
2992.2 0.000229699
7031.52 0.000229699
7933.37 0.000229563
END
$hits1 << END
1394.34 0.00538867
1462.3 0.00519807
1967.73 0.00794717
2144.89 0.00454112
2464.31 0.00585638
2710.04 0.00247186
1424.37 0.00538867
1496.78 0.00519807
2175.55 0.00794717
2389.08 0.00454112
2782.9 0.00585638
3131.01 0.00247186
1398.44 0.00554262
1474.42 0.00522232
1710.87 0.00724963
1732.14 0.00561462
2916.53 0.00587109
3001.3 0.0029115
7155.52 0.00596571
7974.8 0.00330618
END
$hits2 << END
1191.67 3.40598e-08
1246.67 3.40598e-08
1684.58 3.40598e-08
1858.4 3.40598e-08
2007.01 3.40598e-08
2264.06 3.40598e-08
1206.54 3.40598e-08
1265.51 3.40598e-08
1829.43 3.40598e-08
2038.5 3.40598e-08
2248.63 3.40598e-08
2565.63 3.40598e-08
1183.53 3.40598e-08
1247.65 3.40598e-08
1457.16 3.40598e-08
1484.33 3.40598e-08
2427.91 3.40598e-08
2503.2 3.40598e-08
5635.31 3.40598e-08
6365.42 3.40598e-08
704.987 3.40598e-08
1788.65 3.40598e-08
1456.77 3.40598e-08
1988.64 3.40598e-08
END
$hits3 << END
1117.15 0.00516919
1164.27 0.00497798
1548.53 0.00773273
1673.77 0.00432321
1871.86 0.00563785
2053.86 0.00224808
1129.87 0.00516919
1180.51 0.00497798
1655.27 0.00773273
1807.67 0.00432321
2077.48 0.00563785
2315.54 0.00224808
1109.11 0.00532327
1161.67 0.00500216
1320.12 0.00703709
1327.86 0.00539998
2191.51 0.00565297
2239.88 0.00268997
5224.64 0.00574923
5795.57 0.00308466
END
$hits4 << END
734.316 2.52295e-08
768.215 2.52295e-08
1055.13 2.52295e-08
1180.34 2.52295e-08
1329.45 2.52295e-08
1518.46 2.52295e-08
739.899 2.52295e-08
775.88 2.52295e-08
1111.15 2.52295e-08
1245.66 2.52295e-08
1428.69 2.52295e-08
1643.58 2.52295e-08
724.721 2.52295e-08
760.515 2.52295e-08
899.899 2.52295e-08
903.708 2.52295e-08
1444.48 2.52295e-08
1481.94 2.52295e-08
3703.9 2.52295e-08
4165.13 2.52295e-08
END
$hits5 << END
676.073 0.00516919
702.844 0.00497804
1005.16 0.00773273
1103.82 0.00432348
1274.73 0.00563792
1425.37 0.00224836
700.143 0.00516919
729.596 0.00497804
1068.6 0.00773273
1174.56 0.00432355
1402.45 0.00563792
1581.12 0.00224836
683.517 0.00532327
715.425 0.00500223
841.67 0.00703771
838.052 0.005401
1357.75 0.00565304
1375.39 0.00269011
3633.85 0.00574923
4023.46 0.00308473
END
$hits_front << END
6365.42 3.40598e-08
7933.37 0.000229563
7974.8 0.00330618
END
plot $hits0 with points pt 7 ps 1.3 lw 1.6 lc rgb '#d55e00' title 'fast', \
     $hits1 with points pt 6 ps 1.3 lw 1.6 lc rgb '#d55e00' title 'fast, study''s rule', \
     $hits2 with points pt 5 ps 1.3 lw 1.6 lc rgb '#0072b2' title 'robust', \
     $hits3 with points pt 4 ps 1.3 lw 1.6 lc rgb '#0072b2' title 'robust, study''s rule', \
     $hits4 with points pt 9 ps 1.3 lw 1.6 lc rgb '#009e73' title 'double', \
     $hits5 with points pt 8 ps 1.3 lw 1.6 lc rgb '#009e73' title 'double, study''s rule', \
     NaN with lines lw 1.8 dt '-' lc rgb '#222222' title 'Pareto front', \
     $hits_front with fsteps lw 1.8 dt '-' lc rgb '#222222' notitle, \
     $hits_front with points pt 6 ps 2.6 lw 1.6 lc rgb '#222222' notitle
unset key

unset label; unset arrow; unset object
set lmargin at screen 0.115; set rmargin at screen 0.735
set bmargin at screen 0.065; set tmargin at screen 0.42
set xrange [165.994:3065.87]; set yrange [6.25401e-05:0.0710163]
set xlabel 'pictures a second  (more is better)'; set ylabel 'picture: RMSE of a channel  (less is better)' offset -1.5
set xtics ('200' 200, '300' 300, '500' 500, '700' 700, '1000' 1000, '1500' 1500, '2000' 2000, '3000' 3000)
set ytics ("same\nbits" 0.00015635, '10⁻³' 1e-3, '10⁻²' 1e-2)
set object rectangle from graph 0, graph 0 to graph 1, first 0.000265795 fs solid noborder fc rgb '#eeeeee' behind
set arrow from first 2554.89,0.0123829 to graph 1.0,0.7517 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.7517 to graph 1.015,0.7517 nohead lw 0.8 lc rgb '#999999'
set label 'fast: irregular exact' at graph 1.02,0.7517 left
set arrow from first 2032.6,0.0012508 to graph 1.0,0.4258 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.4258 to graph 1.015,0.4258 nohead lw 0.8 lc rgb '#999999'
set label 'robust: irregular exact' at graph 1.02,0.4258 left
set arrow from first 1553.09,0.000115815 to graph 1.0,0.0876 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.0876 to graph 1.015,0.0876 nohead lw 0.8 lc rgb '#999999'
set label 'double: irregular exact' at graph 1.02,0.0876 left
$picture0 << END
415.625 0.0123829
433.79 0.0123829
645.016 0.0123829
729.968 0.0123829
1148.85 0.0123829
1321.48 0.0123829
413.208 0.0123829
429.919 0.0123829
614.204 0.0123829
706.092 0.0123829
1129.51 0.0123829
1305.62 0.0123829
407.812 0.0123829
426.271 0.0123829
542.99 0.0123829
544.471 0.0123829
1003.08 0.0123829
1061.15 0.0123829
2223.09 0.0123829
2554.89 0.0123829
END
$picture1 << END
397.917 0.0224395
418.114 0.0220541
631.845 0.0284065
718.338 0.0216447
1136.95 0.0244543
1292.26 0.0180228
394.713 0.0224395
417.384 0.0220541
608.296 0.0284065
694.799 0.0216447
1118.79 0.0244543
1291.26 0.0180228
390.935 0.0224396
412.223 0.022057
532.031 0.0253287
531.184 0.0228696
987.46 0.0238868
1045.29 0.0183197
2190.47 0.0261517
2507.83 0.0216219
END
$picture2 << END
352.403 0.0012508
370.235 0.0012508
553.191 0.0012508
636.098 0.0012508
952.058 0.0012508
1092.7 0.0012508
352.791 0.0012508
369.559 0.0012508
537.348 0.0012508
627.544 0.0012508
953.515 0.0012508
1103.07 0.0012508
351.037 0.0012508
369.139 0.0012508
472.239 0.0012508
474.808 0.0012508
843.8 0.0012508
887.692 0.0012508
1789.28 0.0012508
2032.6 0.0012508
199.193 0.0012508
542.074 0.0012508
573.162 0.0012508
634.608 0.0012508
END
$picture3 << END
336.666 0.0189295
351.438 0.0184437
527.521 0.0258171
601.511 0.0179318
898.019 0.0213317
1016.94 0.0133382
343.331 0.0189295
359.492 0.0184437
528.319 0.0258171
601.293 0.0179318
925.481 0.0213317
1057.55 0.0133382
338.996 0.0189297
353.979 0.0184472
462.881 0.0223219
461.116 0.0194443
824.122 0.0206086
866.815 0.0137238
1743.55 0.0232584
1966.03 0.0179105
END
$picture4 << END
240.102 0.000115815
252.868 0.000115815
413.819 0.000115815
482.548 0.000115815
707.466 0.000115815
816.965 0.000115815
239.644 0.000115815
249.975 0.000115815
401.308 0.000115815
467.177 0.000115815
692.161 0.000115815
804.352 0.000115815
237.751 0.000115815
247.555 0.000115815
344.941 0.000115815
344.375 0.000115815
609.894 0.000115815
645.484 0.000115815
1346.93 0.000115815
1553.09 0.000115815
END
$picture5 << END
234.265 0.0188937
245.575 0.0184077
407.737 0.0257929
466.768 0.0178971
685.187 0.0213012
788.936 0.0132958
235.048 0.0188937
245.171 0.0184077
401.616 0.0257929
462.584 0.0178972
690.596 0.0213012
802.468 0.0132958
232.019 0.0188939
241.682 0.0184113
338.855 0.0222991
337.928 0.0194207
602.097 0.0205768
633.317 0.0136759
1346.71 0.0232304
1538.26 0.0178721
END
$picture_front << END
1553.09 0.000115815
2032.6 0.0012508
2554.89 0.0123829
END
plot $picture0 with points pt 7 ps 1.3 lw 1.6 lc rgb '#d55e00' title 'fast', \
     $picture1 with points pt 6 ps 1.3 lw 1.6 lc rgb '#d55e00' title 'fast, study''s rule', \
     $picture2 with points pt 5 ps 1.3 lw 1.6 lc rgb '#0072b2' title 'robust', \
     $picture3 with points pt 4 ps 1.3 lw 1.6 lc rgb '#0072b2' title 'robust, study''s rule', \
     $picture4 with points pt 9 ps 1.3 lw 1.6 lc rgb '#009e73' title 'double', \
     $picture5 with points pt 8 ps 1.3 lw 1.6 lc rgb '#009e73' title 'double, study''s rule', \
     NaN with lines lw 1.8 dt '-' lc rgb '#222222' title 'Pareto front', \
     $picture_front with fsteps lw 1.8 dt '-' lc rgb '#222222' notitle, \
     $picture_front with points pt 6 ps 2.6 lw 1.6 lc rgb '#222222' notitle
unset multiplot
unset output
$line0 << END
1 40.2836
2 14.1937
4 14.0511
8 12.0315
16 10.082
32 6.53824
64 3.52592
128 2.97386
256 2.89485
END
$chosen0 << END
138.128 1.41395
END
$line1 << END
1 424.505
2 116.346
4 77.9138
8 17.1434
16 4.8623
32 2.53962
64 1.74298
128 1.73002
256 1.53216
END
$chosen1 << END
93.6537 1.10861
END
$line2 << END
1 137.827
2 18.7823
4 7.14688
8 2.22589
16 1.07261
32 0.814784
64 0.990592
128 1.68502
256 1.42426
END
$chosen2 << END
43.323 0.859328
END
$line3 << END
1 92.261
2 35.3972
4 18.9599
8 6.87155
16 3.50733
32 2.43885
64 2.49971
128 3.32957
256 3.33914
END
$chosen3 << END
50.6645 2.35203
END
$line4 << END
1 55.4358
2 23.7675
4 15.0448
8 6.19331
16 3.04022
32 1.63379
64 1.26605
128 1.45568
256 1.28118
END
$chosen4 << END
50.4685 1.232
END
$line5 << END
1 5.33472
2 1.88778
4 0.723936
8 0.341248
16 0.212032
32 0.202624
64 0.200288
128 0.292736
256 0.33152
END
$chosen5 << END
30 0.138656
END
$line6 << END
1 42.1025
2 16.9993
4 13.6842
8 12.0534
16 8.82157
32 6.65648
64 6.15002
128 4.00083
256 2.6927
END
$chosen6 << END
278.218 0.993408
END

reset
set terminal svg size 1100,760 font 'DejaVu Sans,15' noenhanced background rgb 'white'
set output 'division.svg'
set encoding utf8
set logscale xy
set border 3 lc rgb '#444444'
set tics nomirror
set grid lc rgb '#d4d4d4' lw 1 dt 1
set label 'Time against division (GPU)' at screen 0.02, screen 0.9632 font ',20'
set label 'uniform grids, exact overlap, robust; pictures of 512x512 with shadows and mirrors; ringed: --division auto' at screen 0.02, screen 0.9211
set lmargin at screen 0.09; set rmargin at screen 0.88; set bmargin at screen 0.10; set tmargin at screen 0.89
unset key
set xrange [0.909091:306.04]; set yrange [0.106658:551.856]
set xlabel 'voxels an axis'; set ylabel 'ms a picture'
set xtics (1, 2, 4, 8, 16, 32, 64, 128, 256, 512, 1024)
set ytics ('1' 1, '10' 10, '100' 100)
set arrow from first 16, graph 0 to first 16, graph 1 nohead lw 1.5 dt '-' lc rgb '#444444'
set label '16: what the founding study found enough' at first 16, graph 0.97 offset 1,0 left
set arrow from first 256,2.89485 to graph 1.0,0.4707 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.4707 to graph 1.015,0.4707 nohead lw 0.8 lc rgb '#999999'
set label 'balls' at graph 1.02,0.4707 left
set arrow from first 256,1.53216 to graph 1.0,0.3807 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.3807 to graph 1.015,0.3807 nohead lw 0.8 lc rgb '#999999'
set label 'gears' at graph 1.02,0.3807 left
set arrow from first 256,1.42426 to graph 1.0,0.3357 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.3357 to graph 1.015,0.3357 nohead lw 0.8 lc rgb '#999999'
set label 'mount' at graph 1.02,0.3357 left
set arrow from first 256,3.33914 to graph 1.0,0.5157 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.5157 to graph 1.015,0.5157 nohead lw 0.8 lc rgb '#999999'
set label 'rings' at graph 1.02,0.5157 left
set arrow from first 256,1.28118 to graph 1.0,0.2907 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.2907 to graph 1.015,0.2907 nohead lw 0.8 lc rgb '#999999'
set label 'teapot' at graph 1.02,0.2907 left
set arrow from first 256,0.33152 to graph 1.0,0.1326 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.1326 to graph 1.015,0.1326 nohead lw 0.8 lc rgb '#999999'
set label 'tetra' at graph 1.02,0.1326 left
set arrow from first 256,2.6927 to graph 1.0,0.4257 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.4257 to graph 1.015,0.4257 nohead lw 0.8 lc rgb '#999999'
set label 'tree' at graph 1.02,0.4257 left
plot $line0 with linespoints pt 7 ps 1.2 lw 2 dt 1 lc rgb '#000000', \
     $chosen0 with points pt 7 ps 1.2 lc rgb '#000000', \
     $chosen0 with points pt 6 ps 2.8 lw 2 lc rgb '#000000', \
     $line1 with linespoints pt 5 ps 1.2 lw 2 dt '--' lc rgb '#d55e00', \
     $chosen1 with points pt 5 ps 1.2 lc rgb '#d55e00', \
     $chosen1 with points pt 6 ps 2.8 lw 2 lc rgb '#d55e00', \
     $line2 with linespoints pt 9 ps 1.2 lw 2 dt '.' lc rgb '#0072b2', \
     $chosen2 with points pt 9 ps 1.2 lc rgb '#0072b2', \
     $chosen2 with points pt 6 ps 2.8 lw 2 lc rgb '#0072b2', \
     $line3 with linespoints pt 11 ps 1.2 lw 2 dt '_.' lc rgb '#009e73', \
     $chosen3 with points pt 11 ps 1.2 lc rgb '#009e73', \
     $chosen3 with points pt 6 ps 2.8 lw 2 lc rgb '#009e73', \
     $line4 with linespoints pt 13 ps 1.2 lw 2 dt '-..' lc rgb '#cc79a7', \
     $chosen4 with points pt 13 ps 1.2 lc rgb '#cc79a7', \
     $chosen4 with points pt 6 ps 2.8 lw 2 lc rgb '#cc79a7', \
     $line5 with linespoints pt 6 ps 1.2 lw 2 dt '__' lc rgb '#56b4e9', \
     $chosen5 with points pt 6 ps 1.2 lc rgb '#56b4e9', \
     $chosen5 with points pt 6 ps 2.8 lw 2 lc rgb '#56b4e9', \
     $line6 with linespoints pt 4 ps 1.2 lw 2 dt '_..' lc rgb '#e69f00', \
     $chosen6 with points pt 4 ps 1.2 lc rgb '#e69f00', \
     $chosen6 with points pt 6 ps 2.8 lw 2 lc rgb '#e69f00'
unset output

reset
set terminal pngcairo size 1100,760 font 'DejaVu Sans,12' noenhanced background rgb 'white'
set output 'division.png'
set encoding utf8
set logscale xy
set border 3 lc rgb '#444444'
set tics nomirror
set grid lc rgb '#d4d4d4' lw 1 dt 1
set label 'Time against division (GPU)' at screen 0.02, screen 0.9632 font ',20'
set label 'uniform grids, exact overlap, robust; pictures of 512x512 with shadows and mirrors; ringed: --division auto' at screen 0.02, screen 0.9211
set lmargin at screen 0.09; set rmargin at screen 0.88; set bmargin at screen 0.10; set tmargin at screen 0.89
unset key
set xrange [0.909091:306.04]; set yrange [0.106658:551.856]
set xlabel 'voxels an axis'; set ylabel 'ms a picture'
set xtics (1, 2, 4, 8, 16, 32, 64, 128, 256, 512, 1024)
set ytics ('1' 1, '10' 10, '100' 100)
set arrow from first 16, graph 0 to first 16, graph 1 nohead lw 1.5 dt '-' lc rgb '#444444'
set label '16: what the founding study found enough' at first 16, graph 0.97 offset 1,0 left
set arrow from first 256,2.89485 to graph 1.0,0.4707 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.4707 to graph 1.015,0.4707 nohead lw 0.8 lc rgb '#999999'
set label 'balls' at graph 1.02,0.4707 left
set arrow from first 256,1.53216 to graph 1.0,0.3807 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.3807 to graph 1.015,0.3807 nohead lw 0.8 lc rgb '#999999'
set label 'gears' at graph 1.02,0.3807 left
set arrow from first 256,1.42426 to graph 1.0,0.3357 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.3357 to graph 1.015,0.3357 nohead lw 0.8 lc rgb '#999999'
set label 'mount' at graph 1.02,0.3357 left
set arrow from first 256,3.33914 to graph 1.0,0.5157 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.5157 to graph 1.015,0.5157 nohead lw 0.8 lc rgb '#999999'
set label 'rings' at graph 1.02,0.5157 left
set arrow from first 256,1.28118 to graph 1.0,0.2907 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.2907 to graph 1.015,0.2907 nohead lw 0.8 lc rgb '#999999'
set label 'teapot' at graph 1.02,0.2907 left
set arrow from first 256,0.33152 to graph 1.0,0.1326 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.1326 to graph 1.015,0.1326 nohead lw 0.8 lc rgb '#999999'
set label 'tetra' at graph 1.02,0.1326 left
set arrow from first 256,2.6927 to graph 1.0,0.4257 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.4257 to graph 1.015,0.4257 nohead lw 0.8 lc rgb '#999999'
set label 'tree' at graph 1.02,0.4257 left
plot $line0 with linespoints pt 7 ps 1.2 lw 2 dt 1 lc rgb '#000000', \
     $chosen0 with points pt 7 ps 1.2 lc rgb '#000000', \
     $chosen0 with points pt 6 ps 2.8 lw 2 lc rgb '#000000', \
     $line1 with linespoints pt 5 ps 1.2 lw 2 dt '--' lc rgb '#d55e00', \
     $chosen1 with points pt 5 ps 1.2 lc rgb '#d55e00', \
     $chosen1 with points pt 6 ps 2.8 lw 2 lc rgb '#d55e00', \
     $line2 with linespoints pt 9 ps 1.2 lw 2 dt '.' lc rgb '#0072b2', \
     $chosen2 with points pt 9 ps 1.2 lc rgb '#0072b2', \
     $chosen2 with points pt 6 ps 2.8 lw 2 lc rgb '#0072b2', \
     $line3 with linespoints pt 11 ps 1.2 lw 2 dt '_.' lc rgb '#009e73', \
     $chosen3 with points pt 11 ps 1.2 lc rgb '#009e73', \
     $chosen3 with points pt 6 ps 2.8 lw 2 lc rgb '#009e73', \
     $line4 with linespoints pt 13 ps 1.2 lw 2 dt '-..' lc rgb '#cc79a7', \
     $chosen4 with points pt 13 ps 1.2 lc rgb '#cc79a7', \
     $chosen4 with points pt 6 ps 2.8 lw 2 lc rgb '#cc79a7', \
     $line5 with linespoints pt 6 ps 1.2 lw 2 dt '__' lc rgb '#56b4e9', \
     $chosen5 with points pt 6 ps 1.2 lc rgb '#56b4e9', \
     $chosen5 with points pt 6 ps 2.8 lw 2 lc rgb '#56b4e9', \
     $line6 with linespoints pt 4 ps 1.2 lw 2 dt '_..' lc rgb '#e69f00', \
     $chosen6 with points pt 4 ps 1.2 lc rgb '#e69f00', \
     $chosen6 with points pt 6 ps 2.8 lw 2 lc rgb '#e69f00'
unset output
