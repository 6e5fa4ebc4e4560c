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
set xrange [570.505:16185]; set yrange [9.53674e-08:0.072608]
set xlabel 'million nearest hits a second  (more is better)'; set ylabel 'wrong hits  (less is better)' offset -1.5
set label 'balls: speed against accuracy (GPU)' at screen 0.02, screen 0.9774 font ',20'
set label '1024x1024 primary and 1,048,576 random rays a scene; 2,097,152 in all compared with brute force in double; pictures of 512x512' at screen 0.02, screen 0.9516
set xtics ('1000' 1000, '2000' 2000, '5000' 5000, '10000' 10000)
set ytics ("none of\n2,097,152" 2.38419e-07, '0.0001 %%' 1e-6, '0.001 %%' 1e-5, '0.01 %%' 1e-4, '0.1 %%' 1e-3, '1 %%' 1e-2)
set object rectangle from graph 0, graph 0 to graph 1, first 4.05312e-07 fs solid noborder fc rgb '#eeeeee' behind
set arrow from first 13487.5,0.00206089 to graph 1.0,0.7370 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.7370 to graph 1.015,0.7370 nohead lw 0.8 lc rgb '#999999'
set label 'fast, study: irregular exact' at graph 1.02,0.7370 left
set arrow from first 13482,7.86781e-05 to graph 1.0,0.4959 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.4959 to graph 1.015,0.4959 nohead lw 0.8 lc rgb '#999999'
set label 'fast: irregular exact' at graph 1.02,0.4959 left
set arrow from first 12745.2,2.38419e-07 to graph 1.0,0.0677 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.0677 to graph 1.015,0.0677 nohead lw 0.8 lc rgb '#999999'
set label 'robust: irregular exact' at graph 1.02,0.0677 left
$hits0 << END
736.583 7.86781e-05
734.231 7.86781e-05
2721.03 7.86781e-05
2765.47 7.86781e-05
3561.74 7.86781e-05
3621.37 7.86781e-05
755.772 7.86781e-05
749.154 7.86781e-05
2952.47 7.86781e-05
2971.21 7.86781e-05
5202.51 7.86781e-05
5410.39 7.86781e-05
750.664 7.86781e-05
750.639 7.86781e-05
2994.97 7.86781e-05
3043.37 7.86781e-05
6657.46 7.86781e-05
6708.57 7.86781e-05
12740.3 7.86781e-05
13482 7.86781e-05
END
$hits1 << END
1704.89 0.0290365
1712.02 0.0187826
1681.01 0.0146103
1703.74 0.00238228
1948.45 0.0290365
1955.31 0.0187826
2454.53 0.0146103
2755.7 0.00238228
1975.52 0.0290432
1958.52 0.018836
5376.21 0.0205107
5297.98 0.00504303
12581.3 0.0118799
13487.5 0.00206089
END
$hits2 << END
684.606 2.38419e-07
687.371 2.38419e-07
2576.81 2.38419e-07
2637.69 2.38419e-07
3322.15 2.38419e-07
3404.82 2.38419e-07
692.799 2.38419e-07
694.627 2.38419e-07
2790.07 2.38419e-07
2842.47 2.38419e-07
4837.68 2.38419e-07
5076.77 2.38419e-07
692.352 2.38419e-07
696.821 2.38419e-07
2832.15 2.38419e-07
2862.33 2.38419e-07
6175.65 2.38419e-07
6229.07 2.38419e-07
11959.1 2.38419e-07
12745.2 2.38419e-07
1874.6 2.38419e-07
1908.5 2.38419e-07
2385.47 2.38419e-07
END
$hits3 << END
1573.08 0.0289831
1580.78 0.0187221
1526.79 0.0145469
1553.46 0.00230742
1772.87 0.0289831
1782.27 0.0187221
2255.27 0.0145469
2546.27 0.00230742
1798.02 0.0289898
1769.47 0.0187755
4721.61 0.0204487
4651.57 0.00497007
11053.5 0.0118194
11922.1 0.00199032
END
$hits4 << END
1641.6 1.76606e-07
1679.16 1.76606e-07
2374.66 1.76606e-07
2473.34 1.76606e-07
1619.45 1.76606e-07
1660.32 1.76606e-07
2850.13 1.76606e-07
2985.01 1.76606e-07
1604.74 1.76606e-07
1625.11 1.76606e-07
3373.62 1.76606e-07
3396.18 1.76606e-07
6981.57 1.76606e-07
7436.29 1.76606e-07
END
$hits5 << END
1028.23 0.0289831
1034.69 0.0187221
1106.69 0.0145473
1144.45 0.00230789
1029.73 0.0289831
1039.74 0.0187221
1381.95 0.0145473
1521.51 0.00230789
1006.99 0.0289898
990.523 0.0187755
2519.94 0.0204492
2469.42 0.00497055
6526.84 0.0118194
6959.33 0.0019908
END
$hits_front << END
12745.2 2.38419e-07
13482 7.86781e-05
13487.5 0.00206089
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
set xrange [82.2095:2510.88]; set yrange [0.00011954:0.115364]
set xlabel 'pictures a second  (more is better)'; set ylabel 'picture: RMSE of a channel  (less is better)' offset -1.5
set xtics ('100' 100, '200' 200, '500' 500, '1000' 1000, '2000' 2000)
set ytics ("same\nbits" 0.00029885, '10⁻³' 1e-3, '10⁻²' 1e-2, '10⁻¹' 1e-1)
set object rectangle from graph 0, graph 0 to graph 1, first 0.000508045 fs solid noborder fc rgb '#eeeeee' behind
set arrow from first 2092.4,0.00827507 to graph 1.0,0.6166 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.6166 to graph 1.015,0.6166 nohead lw 0.8 lc rgb '#999999'
set label 'fast: irregular exact' at graph 1.02,0.6166 left
set arrow from first 1947.89,0.0023908 to graph 1.0,0.4359 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.4359 to graph 1.015,0.4359 nohead lw 0.8 lc rgb '#999999'
set label 'robust: irregular exact' at graph 1.02,0.4359 left
set arrow from first 1353.4,0.00022137 to graph 1.0,0.0897 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.0897 to graph 1.015,0.0897 nohead lw 0.8 lc rgb '#999999'
set label 'double: irregular exact' at graph 1.02,0.0897 left
$picture0 << END
101.636 0.00827507
101.663 0.00827507
285.602 0.00827507
291.305 0.00827507
710.293 0.00827507
738.089 0.00827507
101.484 0.00827507
102.79 0.00827507
270.962 0.00827507
277.951 0.00827507
782.975 0.00827507
824.124 0.00827507
101.061 0.00827507
102.903 0.00827507
275.059 0.00827507
283.352 0.00827507
1005.83 0.00827507
1025.03 0.00827507
1948.38 0.00827507
2092.4 0.00827507
END
$picture1 << END
258.194 0.0461457
260.51 0.03628
714.418 0.0314662
738.422 0.0143082
246.819 0.0461457
250.861 0.03628
809.861 0.0314662
848.932 0.0143082
252.142 0.0461456
253.921 0.0363124
952.281 0.0379616
958.883 0.019923
1791.55 0.0287262
2013.92 0.013948
END
$picture2 << END
98.6514 0.0023908
101.047 0.0023908
280.234 0.0023908
289.29 0.0023908
685.021 0.0023908
718.819 0.0023908
101.205 0.0023908
102.22 0.0023908
266.525 0.0023908
273.82 0.0023908
753.301 0.0023908
798.658 0.0023908
101.623 0.0023908
101.068 0.0023908
272.797 0.0023908
280.813 0.0023908
977.231 0.0023908
1009.89 0.0023908
1826.42 0.0023908
1947.89 0.0023908
155.963 0.0023908
337.503 0.0023908
347.77 0.0023908
END
$picture3 << END
254.755 0.0456436
258.421 0.0355789
679.006 0.0305959
677.186 0.0119635
243.566 0.0456436
244.693 0.0355789
737.969 0.0305959
775.32 0.0119635
245.999 0.0456439
247.601 0.0356138
905.403 0.0372451
920.361 0.0183509
1688.28 0.0277669
1874.51 0.0115891
END
$picture4 << END
194.44 0.00022137
198.985 0.00022137
507.354 0.00022137
542.073 0.00022137
184.199 0.00022137
189.171 0.00022137
517.684 0.00022137
559.143 0.00022137
189.584 0.00022137
192.268 0.00022137
659.339 0.00022137
685.683 0.00022137
1261.56 0.00022137
1353.4 0.00022137
END
$picture5 << END
176.684 0.0456007
176.247 0.0355195
457.936 0.0305118
476.547 0.0117333
168.643 0.0456007
168.94 0.0355195
505.525 0.0305118
531.344 0.0117333
172.319 0.045601
169.923 0.0355545
602.62 0.0371784
606.244 0.0182034
1181.79 0.0276717
1247.41 0.0113399
END
$picture_front << END
1353.4 0.00022137
1947.89 0.0023908
2092.4 0.00827507
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
set xrange [570.505:16185]; set yrange [9.53674e-08:0.072608]
set xlabel 'million nearest hits a second  (more is better)'; set ylabel 'wrong hits  (less is better)' offset -1.5
set label 'balls: speed against accuracy (GPU)' at screen 0.02, screen 0.9774 font ',20'
set label '1024x1024 primary and 1,048,576 random rays a scene; 2,097,152 in all compared with brute force in double; pictures of 512x512' at screen 0.02, screen 0.9516
set xtics ('1000' 1000, '2000' 2000, '5000' 5000, '10000' 10000)
set ytics ("none of\n2,097,152" 2.38419e-07, '0.0001 %%' 1e-6, '0.001 %%' 1e-5, '0.01 %%' 1e-4, '0.1 %%' 1e-3, '1 %%' 1e-2)
set object rectangle from graph 0, graph 0 to graph 1, first 4.05312e-07 fs solid noborder fc rgb '#eeeeee' behind
set arrow from first 13487.5,0.00206089 to graph 1.0,0.7370 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.7370 to graph 1.015,0.7370 nohead lw 0.8 lc rgb '#999999'
set label 'fast, study: irregular exact' at graph 1.02,0.7370 left
set arrow from first 13482,7.86781e-05 to graph 1.0,0.4959 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.4959 to graph 1.015,0.4959 nohead lw 0.8 lc rgb '#999999'
set label 'fast: irregular exact' at graph 1.02,0.4959 left
set arrow from first 12745.2,2.38419e-07 to graph 1.0,0.0677 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.0677 to graph 1.015,0.0677 nohead lw 0.8 lc rgb '#999999'
set label 'robust: irregular exact' at graph 1.02,0.0677 left
$hits0 << END
736.583 7.86781e-05
734.231 7.86781e-05
2721.03 7.86781e-05
2765.47 7.86781e-05
3561.74 7.86781e-05
3621.37 7.86781e-05
755.772 7.86781e-05
749.154 7.86781e-05
2952.47 7.86781e-05
2971.21 7.86781e-05
5202.51 7.86781e-05
5410.39 7.86781e-05
750.664 7.86781e-05
750.639 7.86781e-05
2994.97 7.86781e-05
3043.37 7.86781e-05
6657.46 7.86781e-05
6708.57 7.86781e-05
12740.3 7.86781e-05
13482 7.86781e-05
END
$hits1 << END
1704.89 0.0290365
1712.02 0.0187826
1681.01 0.0146103
1703.74 0.00238228
1948.45 0.0290365
1955.31 0.0187826
2454.53 0.0146103
2755.7 0.00238228
1975.52 0.0290432
1958.52 0.018836
5376.21 0.0205107
5297.98 0.00504303
12581.3 0.0118799
13487.5 0.00206089
END
$hits2 << END
684.606 2.38419e-07
687.371 2.38419e-07
2576.81 2.38419e-07
2637.69 2.38419e-07
3322.15 2.38419e-07
3404.82 2.38419e-07
692.799 2.38419e-07
694.627 2.38419e-07
2790.07 2.38419e-07
2842.47 2.38419e-07
4837.68 2.38419e-07
5076.77 2.38419e-07
692.352 2.38419e-07
696.821 2.38419e-07
2832.15 2.38419e-07
2862.33 2.38419e-07
6175.65 2.38419e-07
6229.07 2.38419e-07
11959.1 2.38419e-07
12745.2 2.38419e-07
1874.6 2.38419e-07
1908.5 2.38419e-07
2385.47 2.38419e-07
END
$hits3 << END
1573.08 0.0289831
1580.78 0.0187221
1526.79 0.0145469
1553.46 0.00230742
1772.87 0.0289831
1782.27 0.0187221
2255.27 0.0145469
2546.27 0.00230742
1798.02 0.0289898
1769.47 0.0187755
4721.61 0.0204487
4651.57 0.00497007
11053.5 0.0118194
11922.1 0.00199032
END
$hits4 << END
1641.6 1.76606e-07
1679.16 1.76606e-07
2374.66 1.76606e-07
2473.34 1.76606e-07
1619.45 1.76606e-07
1660.32 1.76606e-07
2850.13 1.76606e-07
2985.01 1.76606e-07
1604.74 1.76606e-07
1625.11 1.76606e-07
3373.62 1.76606e-07
3396.18 1.76606e-07
6981.57 1.76606e-07
7436.29 1.76606e-07
END
$hits5 << END
1028.23 0.0289831
1034.69 0.0187221
1106.69 0.0145473
1144.45 0.00230789
1029.73 0.0289831
1039.74 0.0187221
1381.95 0.0145473
1521.51 0.00230789
1006.99 0.0289898
990.523 0.0187755
2519.94 0.0204492
2469.42 0.00497055
6526.84 0.0118194
6959.33 0.0019908
END
$hits_front << END
12745.2 2.38419e-07
13482 7.86781e-05
13487.5 0.00206089
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
set xrange [82.2095:2510.88]; set yrange [0.00011954:0.115364]
set xlabel 'pictures a second  (more is better)'; set ylabel 'picture: RMSE of a channel  (less is better)' offset -1.5
set xtics ('100' 100, '200' 200, '500' 500, '1000' 1000, '2000' 2000)
set ytics ("same\nbits" 0.00029885, '10⁻³' 1e-3, '10⁻²' 1e-2, '10⁻¹' 1e-1)
set object rectangle from graph 0, graph 0 to graph 1, first 0.000508045 fs solid noborder fc rgb '#eeeeee' behind
set arrow from first 2092.4,0.00827507 to graph 1.0,0.6166 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.6166 to graph 1.015,0.6166 nohead lw 0.8 lc rgb '#999999'
set label 'fast: irregular exact' at graph 1.02,0.6166 left
set arrow from first 1947.89,0.0023908 to graph 1.0,0.4359 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.4359 to graph 1.015,0.4359 nohead lw 0.8 lc rgb '#999999'
set label 'robust: irregular exact' at graph 1.02,0.4359 left
set arrow from first 1353.4,0.00022137 to graph 1.0,0.0897 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.0897 to graph 1.015,0.0897 nohead lw 0.8 lc rgb '#999999'
set label 'double: irregular exact' at graph 1.02,0.0897 left
$picture0 << END
101.636 0.00827507
101.663 0.00827507
285.602 0.00827507
291.305 0.00827507
710.293 0.00827507
738.089 0.00827507
101.484 0.00827507
102.79 0.00827507
270.962 0.00827507
277.951 0.00827507
782.975 0.00827507
824.124 0.00827507
101.061 0.00827507
102.903 0.00827507
275.059 0.00827507
283.352 0.00827507
1005.83 0.00827507
1025.03 0.00827507
1948.38 0.00827507
2092.4 0.00827507
END
$picture1 << END
258.194 0.0461457
260.51 0.03628
714.418 0.0314662
738.422 0.0143082
246.819 0.0461457
250.861 0.03628
809.861 0.0314662
848.932 0.0143082
252.142 0.0461456
253.921 0.0363124
952.281 0.0379616
958.883 0.019923
1791.55 0.0287262
2013.92 0.013948
END
$picture2 << END
98.6514 0.0023908
101.047 0.0023908
280.234 0.0023908
289.29 0.0023908
685.021 0.0023908
718.819 0.0023908
101.205 0.0023908
102.22 0.0023908
266.525 0.0023908
273.82 0.0023908
753.301 0.0023908
798.658 0.0023908
101.623 0.0023908
101.068 0.0023908
272.797 0.0023908
280.813 0.0023908
977.231 0.0023908
1009.89 0.0023908
1826.42 0.0023908
1947.89 0.0023908
155.963 0.0023908
337.503 0.0023908
347.77 0.0023908
END
$picture3 << END
254.755 0.0456436
258.421 0.0355789
679.006 0.0305959
677.186 0.0119635
243.566 0.0456436
244.693 0.0355789
737.969 0.0305959
775.32 0.0119635
245.999 0.0456439
247.601 0.0356138
905.403 0.0372451
920.361 0.0183509
1688.28 0.0277669
1874.51 0.0115891
END
$picture4 << END
194.44 0.00022137
198.985 0.00022137
507.354 0.00022137
542.073 0.00022137
184.199 0.00022137
189.171 0.00022137
517.684 0.00022137
559.143 0.00022137
189.584 0.00022137
192.268 0.00022137
659.339 0.00022137
685.683 0.00022137
1261.56 0.00022137
1353.4 0.00022137
END
$picture5 << END
176.684 0.0456007
176.247 0.0355195
457.936 0.0305118
476.547 0.0117333
168.643 0.0456007
168.94 0.0355195
505.525 0.0305118
531.344 0.0117333
172.319 0.045601
169.923 0.0355545
602.62 0.0371784
606.244 0.0182034
1181.79 0.0276717
1247.41 0.0113399
END
$picture_front << END
1353.4 0.00022137
1947.89 0.0023908
2092.4 0.00827507
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
set xrange [474.577:13120.3]; set yrange [9.53674e-08:0.00213861]
set xlabel 'million nearest hits a second  (more is better)'; set ylabel 'wrong hits  (less is better)' offset -1.5
set label 'gears: speed against accuracy (GPU)' at screen 0.02, screen 0.9774 font ',20'
set label '1024x1024 primary and 1,048,576 random rays a scene; 2,097,152 in all compared with brute force in double; pictures of 512x512' at screen 0.02, screen 0.9516
set xtics ('500' 500, '1000' 1000, '2000' 2000, '5000' 5000, '10000' 10000)
set ytics ("none of\n2,097,152" 2.38419e-07, '0.0001 %%' 1e-6, '0.001 %%' 1e-5, '0.01 %%' 1e-4, '0.1 %%' 1e-3)
set object rectangle from graph 0, graph 0 to graph 1, first 4.05312e-07 fs solid noborder fc rgb '#eeeeee' behind
set arrow from first 10933.6,3.21865e-07 to graph 1.0,0.1214 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.1214 to graph 1.015,0.1214 nohead lw 0.8 lc rgb '#999999'
set label 'fast: irregular exact' at graph 1.02,0.1214 left
$hits0 << END
1955.77 3.21865e-07
2036.61 3.21865e-07
3568.72 3.21865e-07
3707.42 3.21865e-07
3801.39 3.21865e-07
4007.09 3.21865e-07
1822.93 3.21865e-07
1889.35 3.21865e-07
3745.56 3.21865e-07
3848.49 3.21865e-07
4589.68 3.21865e-07
4766.6 3.21865e-07
1917.88 3.21865e-07
1869.47 3.21865e-07
4110.13 3.21865e-07
4382.21 3.21865e-07
4689.85 3.21865e-07
3836.78 3.21865e-07
9363.62 3.21865e-07
10933.6 3.21865e-07
END
$hits1 << END
716.248 0.000182629
743.899 0.000171185
1834.51 0.000133038
1944 6.19888e-05
1702.81 0.00069952
1843.13 0.000184536
719.622 0.000182629
747.795 0.000171185
2022.15 0.000133038
2186.57 6.19888e-05
2294.2 0.00069952
2613.6 0.000184536
734.956 0.000182629
752.941 0.000171185
2292.27 0.000366688
2393.4 6.34193e-05
2118.71 0.000855446
1660.44 0.000384808
6469.5 0.000231743
7676.7 5.53131e-05
END
$hits2 << END
1680.63 2.38419e-07
1694.75 2.38419e-07
3208.3 2.38419e-07
3366.86 2.38419e-07
3481.51 2.38419e-07
3718.57 2.38419e-07
1702.23 2.38419e-07
1744.42 2.38419e-07
3481.33 2.38419e-07
3618.17 2.38419e-07
4264.72 2.38419e-07
4502.34 2.38419e-07
1772.01 2.38419e-07
1736.79 2.38419e-07
3722.16 2.38419e-07
3988.8 2.38419e-07
4330.67 2.38419e-07
3535.22 2.38419e-07
8617.49 2.38419e-07
9843.2 2.38419e-07
3066.73 2.38419e-07
2366.18 2.38419e-07
3913.53 2.38419e-07
END
$hits3 << END
569.492 0.000182629
592.63 0.000171185
1516.41 0.000133038
1638.69 6.19888e-05
1490.95 0.00069952
1660.95 0.000184536
584.251 0.000182629
607.771 0.000171185
1693.48 0.000133038
1849 6.19888e-05
1984.8 0.00069952
2272.32 0.000184536
598.88 0.000182629
608.392 0.000171185
1898.38 0.000366688
1966.98 6.34193e-05
1723.63 0.000855446
1326.18 0.000384808
5370.92 0.000231743
6572 5.53131e-05
END
$hits4 << END
1057.29 1.76606e-07
1084.3 1.76606e-07
2146.19 1.76606e-07
2264.31 1.76606e-07
2356.82 1.76606e-07
2533.38 1.76606e-07
1007.19 1.76606e-07
1041.33 1.76606e-07
2101.79 1.76606e-07
2216.23 1.76606e-07
2522.94 1.76606e-07
2723.74 1.76606e-07
1063.55 1.76606e-07
1038.65 1.76606e-07
2337.23 1.76606e-07
2385.47 1.76606e-07
2478.2 1.76606e-07
2007.97 1.76606e-07
4866.78 1.76606e-07
5561.91 1.76606e-07
END
$hits5 << END
954.639 0.000133038
1038.13 6.19888e-05
1022.56 0.00069952
1145.17 0.000184536
952.863 0.000133038
1032.65 6.19888e-05
1148.67 0.00069952
1308.47 0.000184536
1103.58 0.000366688
1117.96 6.34193e-05
992.579 0.000855446
721.016 0.000384808
3200.16 0.000231743
3690.3 5.53131e-05
END
$hits_front << END
10933.6 3.21865e-07
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
set xrange [120.293:2467.43]; set yrange [7.86585e-05:0.0151955]
set xlabel 'pictures a second  (more is better)'; set ylabel 'picture: RMSE of a channel  (less is better)' offset -1.5
set xtics ('200' 200, '500' 500, '1000' 1000, '2000' 2000)
set ytics ("same\nbits" 0.000196646, '10⁻³' 1e-3, '10⁻²' 1e-2)
set object rectangle from graph 0, graph 0 to graph 1, first 0.000334299 fs solid noborder fc rgb '#eeeeee' behind
set arrow from first 2056.19,0.0036314 to graph 1.0,0.7281 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.7281 to graph 1.015,0.7281 nohead lw 0.8 lc rgb '#999999'
set label 'fast: irregular exact' at graph 1.02,0.7281 left
set arrow from first 1724.23,0.00160758 to graph 1.0,0.5732 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.5732 to graph 1.015,0.5732 nohead lw 0.8 lc rgb '#999999'
set label 'robust: irregular exact' at graph 1.02,0.5732 left
set arrow from first 1308.13,0.000145664 to graph 1.0,0.1171 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.1171 to graph 1.015,0.1171 nohead lw 0.8 lc rgb '#999999'
set label 'double: irregular exact' at graph 1.02,0.1171 left
$picture0 << END
256.999 0.0036314
269.41 0.0036314
629.747 0.0036314
702.879 0.0036314
933.672 0.0036314
1069.66 0.0036314
269.397 0.0036314
264.788 0.0036314
592.719 0.0036314
659.896 0.0036314
899.774 0.0036314
1004.21 0.0036314
266.42 0.0036314
281.263 0.0036314
729.405 0.0036314
715.379 0.0036314
758.553 0.0036314
753.25 0.0036314
1705.97 0.0036314
2056.19 0.0036314
END
$picture1 << END
246.105 0.00473662
244.572 0.00475973
586.49 0.00396118
644.795 0.00436168
908.538 0.006064
1057.31 0.00475632
241.65 0.00473662
249.201 0.00475973
558.775 0.00396118
615.097 0.00436168
853.053 0.006064
977.938 0.00475632
243.334 0.00473662
254.34 0.00475973
668.177 0.00438677
671.263 0.00436168
699.291 0.00607821
702.785 0.00554194
1586.21 0.00401656
1988.93 0.0040382
END
$picture2 << END
209.108 0.00160758
217.91 0.00160758
550.903 0.00160758
610.232 0.00160758
799.169 0.00160758
958.856 0.00160758
205.478 0.00160758
215.029 0.00160758
517.282 0.00160758
562.658 0.00160758
763.481 0.00160758
903.179 0.00160758
217.441 0.00160758
215.164 0.00160758
573.542 0.00160758
590.159 0.00160758
628.054 0.00160758
610.84 0.00160758
1387.29 0.00160758
1724.23 0.00160758
421.051 0.00160758
616.105 0.00160758
671.19 0.00160758
END
$picture3 << END
192.888 0.00344683
201.45 0.00347858
492.443 0.00223184
543.036 0.00289851
743.091 0.00515237
895.648 0.00346756
194.288 0.00344683
197.812 0.00347858
480.85 0.00223184
533.276 0.00289851
728.778 0.00515237
850.297 0.00346756
200.653 0.00344683
202.242 0.00347858
553.667 0.00292125
538.338 0.00289851
600.028 0.00517295
594.174 0.0044849
1314.52 0.00235013
1613.32 0.00238596
END
$picture4 << END
149.155 0.000145664
156.291 0.000145664
390.854 0.000145664
436.721 0.000145664
636.444 0.000145664
748.895 0.000145664
144.351 0.000145664
151.965 0.000145664
369.08 0.000145664
403.434 0.000145664
597.686 0.000145664
702.119 0.000145664
157.869 0.000145664
153.823 0.000145664
421.642 0.000145664
411.96 0.000145664
455.772 0.000145664
456.625 0.000145664
1048.83 0.000145664
1308.13 0.000145664
END
$picture5 << END
369.853 0.00157317
413.551 0.00241185
588.866 0.00489516
697.063 0.0030724
349.501 0.00157317
392.839 0.00241185
565.131 0.00489516
665.602 0.0030724
409.895 0.00245508
396.478 0.00241185
436.752 0.00491682
433.612 0.00418689
989.923 0.0017136
1213.4 0.00176242
END
$picture_front << END
1308.13 0.000145664
1724.23 0.00160758
2056.19 0.0036314
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
set xrange [474.577:13120.3]; set yrange [9.53674e-08:0.00213861]
set xlabel 'million nearest hits a second  (more is better)'; set ylabel 'wrong hits  (less is better)' offset -1.5
set label 'gears: speed against accuracy (GPU)' at screen 0.02, screen 0.9774 font ',20'
set label '1024x1024 primary and 1,048,576 random rays a scene; 2,097,152 in all compared with brute force in double; pictures of 512x512' at screen 0.02, screen 0.9516
set xtics ('500' 500, '1000' 1000, '2000' 2000, '5000' 5000, '10000' 10000)
set ytics ("none of\n2,097,152" 2.38419e-07, '0.0001 %%' 1e-6, '0.001 %%' 1e-5, '0.01 %%' 1e-4, '0.1 %%' 1e-3)
set object rectangle from graph 0, graph 0 to graph 1, first 4.05312e-07 fs solid noborder fc rgb '#eeeeee' behind
set arrow from first 10933.6,3.21865e-07 to graph 1.0,0.1214 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.1214 to graph 1.015,0.1214 nohead lw 0.8 lc rgb '#999999'
set label 'fast: irregular exact' at graph 1.02,0.1214 left
$hits0 << END
1955.77 3.21865e-07
2036.61 3.21865e-07
3568.72 3.21865e-07
3707.42 3.21865e-07
3801.39 3.21865e-07
4007.09 3.21865e-07
1822.93 3.21865e-07
1889.35 3.21865e-07
3745.56 3.21865e-07
3848.49 3.21865e-07
4589.68 3.21865e-07
4766.6 3.21865e-07
1917.88 3.21865e-07
1869.47 3.21865e-07
4110.13 3.21865e-07
4382.21 3.21865e-07
4689.85 3.21865e-07
3836.78 3.21865e-07
9363.62 3.21865e-07
10933.6 3.21865e-07
END
$hits1 << END
716.248 0.000182629
743.899 0.000171185
1834.51 0.000133038
1944 6.19888e-05
1702.81 0.00069952
1843.13 0.000184536
719.622 0.000182629
747.795 0.000171185
2022.15 0.000133038
2186.57 6.19888e-05
2294.2 0.00069952
2613.6 0.000184536
734.956 0.000182629
752.941 0.000171185
2292.27 0.000366688
2393.4 6.34193e-05
2118.71 0.000855446
1660.44 0.000384808
6469.5 0.000231743
7676.7 5.53131e-05
END
$hits2 << END
1680.63 2.38419e-07
1694.75 2.38419e-07
3208.3 2.38419e-07
3366.86 2.38419e-07
3481.51 2.38419e-07
3718.57 2.38419e-07
1702.23 2.38419e-07
1744.42 2.38419e-07
3481.33 2.38419e-07
3618.17 2.38419e-07
4264.72 2.38419e-07
4502.34 2.38419e-07
1772.01 2.38419e-07
1736.79 2.38419e-07
3722.16 2.38419e-07
3988.8 2.38419e-07
4330.67 2.38419e-07
3535.22 2.38419e-07
8617.49 2.38419e-07
9843.2 2.38419e-07
3066.73 2.38419e-07
2366.18 2.38419e-07
3913.53 2.38419e-07
END
$hits3 << END
569.492 0.000182629
592.63 0.000171185
1516.41 0.000133038
1638.69 6.19888e-05
1490.95 0.00069952
1660.95 0.000184536
584.251 0.000182629
607.771 0.000171185
1693.48 0.000133038
1849 6.19888e-05
1984.8 0.00069952
2272.32 0.000184536
598.88 0.000182629
608.392 0.000171185
1898.38 0.000366688
1966.98 6.34193e-05
1723.63 0.000855446
1326.18 0.000384808
5370.92 0.000231743
6572 5.53131e-05
END
$hits4 << END
1057.29 1.76606e-07
1084.3 1.76606e-07
2146.19 1.76606e-07
2264.31 1.76606e-07
2356.82 1.76606e-07
2533.38 1.76606e-07
1007.19 1.76606e-07
1041.33 1.76606e-07
2101.79 1.76606e-07
2216.23 1.76606e-07
2522.94 1.76606e-07
2723.74 1.76606e-07
1063.55 1.76606e-07
1038.65 1.76606e-07
2337.23 1.76606e-07
2385.47 1.76606e-07
2478.2 1.76606e-07
2007.97 1.76606e-07
4866.78 1.76606e-07
5561.91 1.76606e-07
END
$hits5 << END
954.639 0.000133038
1038.13 6.19888e-05
1022.56 0.00069952
1145.17 0.000184536
952.863 0.000133038
1032.65 6.19888e-05
1148.67 0.00069952
1308.47 0.000184536
1103.58 0.000366688
1117.96 6.34193e-05
992.579 0.000855446
721.016 0.000384808
3200.16 0.000231743
3690.3 5.53131e-05
END
$hits_front << END
10933.6 3.21865e-07
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
set xrange [120.293:2467.43]; set yrange [7.86585e-05:0.0151955]
set xlabel 'pictures a second  (more is better)'; set ylabel 'picture: RMSE of a channel  (less is better)' offset -1.5
set xtics ('200' 200, '500' 500, '1000' 1000, '2000' 2000)
set ytics ("same\nbits" 0.000196646, '10⁻³' 1e-3, '10⁻²' 1e-2)
set object rectangle from graph 0, graph 0 to graph 1, first 0.000334299 fs solid noborder fc rgb '#eeeeee' behind
set arrow from first 2056.19,0.0036314 to graph 1.0,0.7281 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.7281 to graph 1.015,0.7281 nohead lw 0.8 lc rgb '#999999'
set label 'fast: irregular exact' at graph 1.02,0.7281 left
set arrow from first 1724.23,0.00160758 to graph 1.0,0.5732 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.5732 to graph 1.015,0.5732 nohead lw 0.8 lc rgb '#999999'
set label 'robust: irregular exact' at graph 1.02,0.5732 left
set arrow from first 1308.13,0.000145664 to graph 1.0,0.1171 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.1171 to graph 1.015,0.1171 nohead lw 0.8 lc rgb '#999999'
set label 'double: irregular exact' at graph 1.02,0.1171 left
$picture0 << END
256.999 0.0036314
269.41 0.0036314
629.747 0.0036314
702.879 0.0036314
933.672 0.0036314
1069.66 0.0036314
269.397 0.0036314
264.788 0.0036314
592.719 0.0036314
659.896 0.0036314
899.774 0.0036314
1004.21 0.0036314
266.42 0.0036314
281.263 0.0036314
729.405 0.0036314
715.379 0.0036314
758.553 0.0036314
753.25 0.0036314
1705.97 0.0036314
2056.19 0.0036314
END
$picture1 << END
246.105 0.00473662
244.572 0.00475973
586.49 0.00396118
644.795 0.00436168
908.538 0.006064
1057.31 0.00475632
241.65 0.00473662
249.201 0.00475973
558.775 0.00396118
615.097 0.00436168
853.053 0.006064
977.938 0.00475632
243.334 0.00473662
254.34 0.00475973
668.177 0.00438677
671.263 0.00436168
699.291 0.00607821
702.785 0.00554194
1586.21 0.00401656
1988.93 0.0040382
END
$picture2 << END
209.108 0.00160758
217.91 0.00160758
550.903 0.00160758
610.232 0.00160758
799.169 0.00160758
958.856 0.00160758
205.478 0.00160758
215.029 0.00160758
517.282 0.00160758
562.658 0.00160758
763.481 0.00160758
903.179 0.00160758
217.441 0.00160758
215.164 0.00160758
573.542 0.00160758
590.159 0.00160758
628.054 0.00160758
610.84 0.00160758
1387.29 0.00160758
1724.23 0.00160758
421.051 0.00160758
616.105 0.00160758
671.19 0.00160758
END
$picture3 << END
192.888 0.00344683
201.45 0.00347858
492.443 0.00223184
543.036 0.00289851
743.091 0.00515237
895.648 0.00346756
194.288 0.00344683
197.812 0.00347858
480.85 0.00223184
533.276 0.00289851
728.778 0.00515237
850.297 0.00346756
200.653 0.00344683
202.242 0.00347858
553.667 0.00292125
538.338 0.00289851
600.028 0.00517295
594.174 0.0044849
1314.52 0.00235013
1613.32 0.00238596
END
$picture4 << END
149.155 0.000145664
156.291 0.000145664
390.854 0.000145664
436.721 0.000145664
636.444 0.000145664
748.895 0.000145664
144.351 0.000145664
151.965 0.000145664
369.08 0.000145664
403.434 0.000145664
597.686 0.000145664
702.119 0.000145664
157.869 0.000145664
153.823 0.000145664
421.642 0.000145664
411.96 0.000145664
455.772 0.000145664
456.625 0.000145664
1048.83 0.000145664
1308.13 0.000145664
END
$picture5 << END
369.853 0.00157317
413.551 0.00241185
588.866 0.00489516
697.063 0.0030724
349.501 0.00157317
392.839 0.00241185
565.131 0.00489516
665.602 0.0030724
409.895 0.00245508
396.478 0.00241185
436.752 0.00491682
433.612 0.00418689
989.923 0.0017136
1213.4 0.00176242
END
$picture_front << END
1308.13 0.000145664
1724.23 0.00160758
2056.19 0.0036314
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
set xrange [366.019:8967.3]; set yrange [9.53674e-08:0.000991821]
set xlabel 'million nearest hits a second  (more is better)'; set ylabel 'wrong hits  (less is better)' offset -1.5
set label 'mount: speed against accuracy (GPU)' at screen 0.02, screen 0.9774 font ',20'
set label '1024x1024 primary and 1,048,576 random rays a scene; 2,097,152 in all compared with brute force in double; pictures of 512x512' at screen 0.02, screen 0.9516
set xtics ('500' 500, '1000' 1000, '2000' 2000, '5000' 5000)
set ytics ("none of\n2,097,152" 2.38419e-07, '0.0001 %%' 1e-6, '0.001 %%' 1e-5, '0.01 %%' 1e-4)
set object rectangle from graph 0, graph 0 to graph 1, first 4.05312e-07 fs solid noborder fc rgb '#eeeeee' behind
set arrow from first 7472.75,3.21865e-07 to graph 1.0,0.1315 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.1315 to graph 1.015,0.1315 nohead lw 0.8 lc rgb '#999999'
set label 'fast: irregular exact' at graph 1.02,0.1315 left
$hits0 << END
3213.18 3.21865e-07
3391.25 3.21865e-07
2594.87 3.21865e-07
2799.85 3.21865e-07
3206.42 3.21865e-07
3534.65 3.21865e-07
3366.69 3.21865e-07
3575.34 3.21865e-07
3356.69 3.21865e-07
3699.67 3.21865e-07
3918.21 3.21865e-07
4455.2 3.21865e-07
3064.86 3.21865e-07
3310.23 3.21865e-07
841.835 3.21865e-07
890.447 3.21865e-07
1980.9 3.21865e-07
2085.87 3.21865e-07
6635.21 3.21865e-07
7472.75 3.21865e-07
END
$hits1 << END
1167.85 0.000134945
1225.45 0.000113964
1640.04 5.91278e-05
1826.33 2.24113e-05
1848.43 0.000191212
2071.43 6.58035e-05
1270.82 0.000134945
1325.14 0.000113964
2154.58 5.91278e-05
2501.09 2.24113e-05
2235.73 0.000191212
2589.13 6.58035e-05
1202.94 0.000210762
1264.95 0.00019598
688.396 0.000182629
713.946 0.000395775
1142.06 0.000291824
1189.42 0.000396729
3999.76 5.34058e-05
4567.61 3.14713e-05
END
$hits2 << END
2904.71 2.38419e-07
3024.55 2.38419e-07
2404.2 2.38419e-07
2622.07 2.38419e-07
2942.79 2.38419e-07
3257.9 2.38419e-07
3108.33 2.38419e-07
3296.75 2.38419e-07
3163.55 2.38419e-07
3553.24 2.38419e-07
3671.69 2.38419e-07
4151 2.38419e-07
2817.66 2.38419e-07
3039.56 2.38419e-07
785.201 2.38419e-07
830.495 2.38419e-07
1848.53 2.38419e-07
1953.44 2.38419e-07
6124.86 2.38419e-07
6868.16 2.38419e-07
439.223 2.38419e-07
1416.38 2.38419e-07
3555.94 2.38419e-07
1559.64 2.38419e-07
2762.2 2.38419e-07
END
$hits3 << END
892.095 0.000134945
930.684 0.000113964
1393.76 5.91278e-05
1578.12 2.24113e-05
1520.63 0.000191212
1722.86 6.58035e-05
981.813 0.000134945
1031.38 0.000113964
1801.58 5.91278e-05
2134.65 2.24113e-05
1844.63 0.000191212
2145.13 6.58035e-05
933.335 0.000210762
988.641 0.00019598
551.882 0.000182629
570.896 0.000395775
909.225 0.000291824
948.203 0.000396729
3275.16 5.34058e-05
3751.99 3.14713e-05
END
$hits4 << END
1793.39 1.76606e-07
1873.8 1.76606e-07
1708.94 1.76606e-07
1916.2 1.76606e-07
2016.74 1.76606e-07
2279.59 1.76606e-07
1827.3 1.76606e-07
1923.46 1.76606e-07
1900.48 1.76606e-07
2163.55 1.76606e-07
2202.89 1.76606e-07
2516.84 1.76606e-07
1650.24 1.76606e-07
1787.91 1.76606e-07
557.421 1.76606e-07
557.981 1.76606e-07
1065.19 1.76606e-07
1125.55 1.76606e-07
3720.47 1.76606e-07
4207.5 1.76606e-07
END
$hits5 << END
506.707 0.000134945
528.789 0.000113964
907.713 5.91278e-05
1060.44 2.24113e-05
929.351 0.000191212
1069.92 6.58035e-05
550.016 0.000134945
574.328 0.000113964
1001.9 5.91278e-05
1181.13 2.24113e-05
1013.11 0.000191212
1175.34 6.58035e-05
519.879 0.000210762
547.027 0.00019598
509.568 0.000291824
529.854 0.000396729
1809.94 5.34058e-05
2070.32 3.14713e-05
END
$hits_front << END
7472.75 3.21865e-07
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
set xrange [126.933:3334.82]; set yrange [3.11752e-05:0.013019]
set xlabel 'pictures a second  (more is better)'; set ylabel 'picture: RMSE of a channel  (less is better)' offset -1.5
set xtics ('200' 200, '500' 500, '1000' 1000, '2000' 2000)
set ytics ("same\nbits" 7.7938e-05, '10⁻³' 1e-3, '10⁻²' 1e-2)
set object rectangle from graph 0, graph 0 to graph 1, first 0.000132495 fs solid noborder fc rgb '#eeeeee' behind
set arrow from first 2779.01,0.00463004 to graph 1.0,0.8765 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.8765 to graph 1.015,0.8765 nohead lw 0.8 lc rgb '#999999'
set label 'fast, study: irregular exact' at graph 1.02,0.8765 left
set arrow from first 2602.22,0.00456969 to graph 1.0,0.8265 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.8265 to graph 1.015,0.8265 nohead lw 0.8 lc rgb '#999999'
set label 'fast: irregular exact' at graph 1.02,0.8265 left
set arrow from first 2353.16,0.000971559 to graph 1.0,0.5699 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.5699 to graph 1.015,0.5699 nohead lw 0.8 lc rgb '#999999'
set label 'robust, study: irregular exact' at graph 1.02,0.5699 left
set arrow from first 2306.78,0.000623504 to graph 1.0,0.4964 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.4964 to graph 1.015,0.4964 nohead lw 0.8 lc rgb '#999999'
set label 'robust: irregular exact' at graph 1.02,0.4964 left
set arrow from first 1806.99,5.77319e-05 to graph 1.0,0.1021 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.1021 to graph 1.015,0.1021 nohead lw 0.8 lc rgb '#999999'
set label 'double: irregular exact' at graph 1.02,0.1021 left
$picture0 << END
1073.44 0.00456969
1127.3 0.00456969
972.157 0.00456969
1163.27 0.00456969
1185.55 0.00456969
1362.67 0.00456969
1065.72 0.00456969
1116.43 0.00456969
928.928 0.00456969
1151.61 0.00456969
1154.29 0.00456969
1378.84 0.00456969
1045.36 0.00456969
1109.57 0.00456969
375.47 0.00456969
380.263 0.00456969
691.128 0.00456969
708.2 0.00456969
2303.55 0.00456969
2602.22 0.00456969
END
$picture1 << END
1149.36 0.00483535
1198.93 0.00477278
1113.05 0.00465529
1297.11 0.00462287
1311.92 0.00520761
1485.76 0.00470638
1156.29 0.00483535
1210.54 0.00477278
1117.59 0.00465529
1303.28 0.00462287
1310.16 0.00520761
1519.72 0.00470638
1110.52 0.00483535
1164.26 0.00477278
403.6 0.00460019
409.229 0.00460581
758.921 0.00496746
768.267 0.00472754
2462.76 0.00463625
2779.01 0.00463004
END
$picture2 << END
963.911 0.000623504
1005.66 0.000623504
909.91 0.000623504
1090.56 0.000623504
1092.01 0.000623504
1272.19 0.000623504
950.977 0.000623504
1001.19 0.000623504
876.993 0.000623504
1091.4 0.000623504
1079.15 0.000623504
1277.23 0.000623504
933.306 0.000623504
988.709 0.000623504
347.326 0.000623504
351.314 0.000623504
625.188 0.000623504
636.092 0.000623504
2070.91 0.000623504
2306.78 0.000623504
152.319 0.000623504
487.983 0.000623504
1339.08 0.000623504
643.944 0.000623504
716.712 0.000623504
END
$picture3 << END
961.095 0.00170222
999.011 0.00151537
1016.43 0.00105972
1166.74 0.000906763
1144.94 0.00257412
1315.9 0.0012872
971.279 0.00170222
1013.79 0.00151537
1002.53 0.00105972
1171.77 0.000906763
1150.76 0.00257412
1336.44 0.0012872
907.688 0.00170222
960.237 0.00151537
343.621 0.000817549
351.479 0.000824845
643.878 0.00204512
651.597 0.00134789
2131.21 0.00100073
2353.16 0.000971559
END
$picture4 << END
727.776 5.77319e-05
771.034 5.77319e-05
783.325 5.77319e-05
963.373 5.77319e-05
898.352 5.77319e-05
1061.08 5.77319e-05
714.679 5.77319e-05
751.309 5.77319e-05
762.509 5.77319e-05
950.661 5.77319e-05
887.682 5.77319e-05
1067.06 5.77319e-05
699.966 5.77319e-05
746.949 5.77319e-05
275.008 5.77319e-05
278.396 5.77319e-05
507.545 5.77319e-05
509.772 5.77319e-05
1637.58 5.77319e-05
1806.99 5.77319e-05
END
$picture5 << END
732.091 0.00158392
772.099 0.00138115
792.663 0.00085688
905.748 0.000658378
890.036 0.00249747
996.075 0.00112611
747.25 0.00158392
775.549 0.00138115
841.73 0.00085688
986.582 0.000658378
924.941 0.00249747
1063.58 0.00112611
699.403 0.00158392
739.979 0.00138115
527.613 0.00194775
535.728 0.00119501
1605.69 0.000782748
1753.65 0.000745097
END
$picture_front << END
1806.99 5.77319e-05
2306.78 0.000623504
2353.16 0.000971559
2602.22 0.00456969
2779.01 0.00463004
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
set xrange [366.019:8967.3]; set yrange [9.53674e-08:0.000991821]
set xlabel 'million nearest hits a second  (more is better)'; set ylabel 'wrong hits  (less is better)' offset -1.5
set label 'mount: speed against accuracy (GPU)' at screen 0.02, screen 0.9774 font ',20'
set label '1024x1024 primary and 1,048,576 random rays a scene; 2,097,152 in all compared with brute force in double; pictures of 512x512' at screen 0.02, screen 0.9516
set xtics ('500' 500, '1000' 1000, '2000' 2000, '5000' 5000)
set ytics ("none of\n2,097,152" 2.38419e-07, '0.0001 %%' 1e-6, '0.001 %%' 1e-5, '0.01 %%' 1e-4)
set object rectangle from graph 0, graph 0 to graph 1, first 4.05312e-07 fs solid noborder fc rgb '#eeeeee' behind
set arrow from first 7472.75,3.21865e-07 to graph 1.0,0.1315 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.1315 to graph 1.015,0.1315 nohead lw 0.8 lc rgb '#999999'
set label 'fast: irregular exact' at graph 1.02,0.1315 left
$hits0 << END
3213.18 3.21865e-07
3391.25 3.21865e-07
2594.87 3.21865e-07
2799.85 3.21865e-07
3206.42 3.21865e-07
3534.65 3.21865e-07
3366.69 3.21865e-07
3575.34 3.21865e-07
3356.69 3.21865e-07
3699.67 3.21865e-07
3918.21 3.21865e-07
4455.2 3.21865e-07
3064.86 3.21865e-07
3310.23 3.21865e-07
841.835 3.21865e-07
890.447 3.21865e-07
1980.9 3.21865e-07
2085.87 3.21865e-07
6635.21 3.21865e-07
7472.75 3.21865e-07
END
$hits1 << END
1167.85 0.000134945
1225.45 0.000113964
1640.04 5.91278e-05
1826.33 2.24113e-05
1848.43 0.000191212
2071.43 6.58035e-05
1270.82 0.000134945
1325.14 0.000113964
2154.58 5.91278e-05
2501.09 2.24113e-05
2235.73 0.000191212
2589.13 6.58035e-05
1202.94 0.000210762
1264.95 0.00019598
688.396 0.000182629
713.946 0.000395775
1142.06 0.000291824
1189.42 0.000396729
3999.76 5.34058e-05
4567.61 3.14713e-05
END
$hits2 << END
2904.71 2.38419e-07
3024.55 2.38419e-07
2404.2 2.38419e-07
2622.07 2.38419e-07
2942.79 2.38419e-07
3257.9 2.38419e-07
3108.33 2.38419e-07
3296.75 2.38419e-07
3163.55 2.38419e-07
3553.24 2.38419e-07
3671.69 2.38419e-07
4151 2.38419e-07
2817.66 2.38419e-07
3039.56 2.38419e-07
785.201 2.38419e-07
830.495 2.38419e-07
1848.53 2.38419e-07
1953.44 2.38419e-07
6124.86 2.38419e-07
6868.16 2.38419e-07
439.223 2.38419e-07
1416.38 2.38419e-07
3555.94 2.38419e-07
1559.64 2.38419e-07
2762.2 2.38419e-07
END
$hits3 << END
892.095 0.000134945
930.684 0.000113964
1393.76 5.91278e-05
1578.12 2.24113e-05
1520.63 0.000191212
1722.86 6.58035e-05
981.813 0.000134945
1031.38 0.000113964
1801.58 5.91278e-05
2134.65 2.24113e-05
1844.63 0.000191212
2145.13 6.58035e-05
933.335 0.000210762
988.641 0.00019598
551.882 0.000182629
570.896 0.000395775
909.225 0.000291824
948.203 0.000396729
3275.16 5.34058e-05
3751.99 3.14713e-05
END
$hits4 << END
1793.39 1.76606e-07
1873.8 1.76606e-07
1708.94 1.76606e-07
1916.2 1.76606e-07
2016.74 1.76606e-07
2279.59 1.76606e-07
1827.3 1.76606e-07
1923.46 1.76606e-07
1900.48 1.76606e-07
2163.55 1.76606e-07
2202.89 1.76606e-07
2516.84 1.76606e-07
1650.24 1.76606e-07
1787.91 1.76606e-07
557.421 1.76606e-07
557.981 1.76606e-07
1065.19 1.76606e-07
1125.55 1.76606e-07
3720.47 1.76606e-07
4207.5 1.76606e-07
END
$hits5 << END
506.707 0.000134945
528.789 0.000113964
907.713 5.91278e-05
1060.44 2.24113e-05
929.351 0.000191212
1069.92 6.58035e-05
550.016 0.000134945
574.328 0.000113964
1001.9 5.91278e-05
1181.13 2.24113e-05
1013.11 0.000191212
1175.34 6.58035e-05
519.879 0.000210762
547.027 0.00019598
509.568 0.000291824
529.854 0.000396729
1809.94 5.34058e-05
2070.32 3.14713e-05
END
$hits_front << END
7472.75 3.21865e-07
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
set xrange [126.933:3334.82]; set yrange [3.11752e-05:0.013019]
set xlabel 'pictures a second  (more is better)'; set ylabel 'picture: RMSE of a channel  (less is better)' offset -1.5
set xtics ('200' 200, '500' 500, '1000' 1000, '2000' 2000)
set ytics ("same\nbits" 7.7938e-05, '10⁻³' 1e-3, '10⁻²' 1e-2)
set object rectangle from graph 0, graph 0 to graph 1, first 0.000132495 fs solid noborder fc rgb '#eeeeee' behind
set arrow from first 2779.01,0.00463004 to graph 1.0,0.8765 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.8765 to graph 1.015,0.8765 nohead lw 0.8 lc rgb '#999999'
set label 'fast, study: irregular exact' at graph 1.02,0.8765 left
set arrow from first 2602.22,0.00456969 to graph 1.0,0.8265 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.8265 to graph 1.015,0.8265 nohead lw 0.8 lc rgb '#999999'
set label 'fast: irregular exact' at graph 1.02,0.8265 left
set arrow from first 2353.16,0.000971559 to graph 1.0,0.5699 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.5699 to graph 1.015,0.5699 nohead lw 0.8 lc rgb '#999999'
set label 'robust, study: irregular exact' at graph 1.02,0.5699 left
set arrow from first 2306.78,0.000623504 to graph 1.0,0.4964 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.4964 to graph 1.015,0.4964 nohead lw 0.8 lc rgb '#999999'
set label 'robust: irregular exact' at graph 1.02,0.4964 left
set arrow from first 1806.99,5.77319e-05 to graph 1.0,0.1021 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.1021 to graph 1.015,0.1021 nohead lw 0.8 lc rgb '#999999'
set label 'double: irregular exact' at graph 1.02,0.1021 left
$picture0 << END
1073.44 0.00456969
1127.3 0.00456969
972.157 0.00456969
1163.27 0.00456969
1185.55 0.00456969
1362.67 0.00456969
1065.72 0.00456969
1116.43 0.00456969
928.928 0.00456969
1151.61 0.00456969
1154.29 0.00456969
1378.84 0.00456969
1045.36 0.00456969
1109.57 0.00456969
375.47 0.00456969
380.263 0.00456969
691.128 0.00456969
708.2 0.00456969
2303.55 0.00456969
2602.22 0.00456969
END
$picture1 << END
1149.36 0.00483535
1198.93 0.00477278
1113.05 0.00465529
1297.11 0.00462287
1311.92 0.00520761
1485.76 0.00470638
1156.29 0.00483535
1210.54 0.00477278
1117.59 0.00465529
1303.28 0.00462287
1310.16 0.00520761
1519.72 0.00470638
1110.52 0.00483535
1164.26 0.00477278
403.6 0.00460019
409.229 0.00460581
758.921 0.00496746
768.267 0.00472754
2462.76 0.00463625
2779.01 0.00463004
END
$picture2 << END
963.911 0.000623504
1005.66 0.000623504
909.91 0.000623504
1090.56 0.000623504
1092.01 0.000623504
1272.19 0.000623504
950.977 0.000623504
1001.19 0.000623504
876.993 0.000623504
1091.4 0.000623504
1079.15 0.000623504
1277.23 0.000623504
933.306 0.000623504
988.709 0.000623504
347.326 0.000623504
351.314 0.000623504
625.188 0.000623504
636.092 0.000623504
2070.91 0.000623504
2306.78 0.000623504
152.319 0.000623504
487.983 0.000623504
1339.08 0.000623504
643.944 0.000623504
716.712 0.000623504
END
$picture3 << END
961.095 0.00170222
999.011 0.00151537
1016.43 0.00105972
1166.74 0.000906763
1144.94 0.00257412
1315.9 0.0012872
971.279 0.00170222
1013.79 0.00151537
1002.53 0.00105972
1171.77 0.000906763
1150.76 0.00257412
1336.44 0.0012872
907.688 0.00170222
960.237 0.00151537
343.621 0.000817549
351.479 0.000824845
643.878 0.00204512
651.597 0.00134789
2131.21 0.00100073
2353.16 0.000971559
END
$picture4 << END
727.776 5.77319e-05
771.034 5.77319e-05
783.325 5.77319e-05
963.373 5.77319e-05
898.352 5.77319e-05
1061.08 5.77319e-05
714.679 5.77319e-05
751.309 5.77319e-05
762.509 5.77319e-05
950.661 5.77319e-05
887.682 5.77319e-05
1067.06 5.77319e-05
699.966 5.77319e-05
746.949 5.77319e-05
275.008 5.77319e-05
278.396 5.77319e-05
507.545 5.77319e-05
509.772 5.77319e-05
1637.58 5.77319e-05
1806.99 5.77319e-05
END
$picture5 << END
732.091 0.00158392
772.099 0.00138115
792.663 0.00085688
905.748 0.000658378
890.036 0.00249747
996.075 0.00112611
747.25 0.00158392
775.549 0.00138115
841.73 0.00085688
986.582 0.000658378
924.941 0.00249747
1063.58 0.00112611
699.403 0.00158392
739.979 0.00138115
527.613 0.00194775
535.728 0.00119501
1605.69 0.000782748
1753.65 0.000745097
END
$picture_front << END
1806.99 5.77319e-05
2306.78 0.000623504
2353.16 0.000971559
2602.22 0.00456969
2779.01 0.00463004
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
set xrange [353.24:7070.33]; set yrange [9.53674e-08:0.0598156]
set xlabel 'million nearest hits a second  (more is better)'; set ylabel 'wrong hits  (less is better)' offset -1.5
set label 'rings: speed against accuracy (GPU)' at screen 0.02, screen 0.9774 font ',20'
set label '1024x1024 primary and 1,048,576 random rays a scene; 2,097,152 in all compared with brute force in double; pictures of 512x512' at screen 0.02, screen 0.9516
set xtics ('500' 500, '1000' 1000, '2000' 2000, '5000' 5000)
set ytics ("none of\n2,097,152" 2.38419e-07, '0.0001 %%' 1e-6, '0.001 %%' 1e-5, '0.01 %%' 1e-4, '0.1 %%' 1e-3, '1 %%' 1e-2)
set object rectangle from graph 0, graph 0 to graph 1, first 4.05312e-07 fs solid noborder fc rgb '#eeeeee' behind
set arrow from first 5891.94,0.000258923 to graph 1.0,0.5923 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.5923 to graph 1.015,0.5923 nohead lw 0.8 lc rgb '#999999'
set label 'fast: irregular exact' at graph 1.02,0.5923 left
set arrow from first 4737.31,2.38419e-07 to graph 1.0,0.0686 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.0686 to graph 1.015,0.0686 nohead lw 0.8 lc rgb '#999999'
set label 'robust: irregular exact' at graph 1.02,0.0686 left
$hits0 << END
2437.82 0.000258923
2728.85 0.000258923
2152.04 0.000258923
2441.91 0.000258923
2402.52 0.000258923
2818.15 0.000258923
2515.49 0.000258923
2838.9 0.000258923
2535.73 0.000258923
3091.47 0.000258923
2760.34 0.000258923
3405.53 0.000258923
2389.3 0.000258923
2710.68 0.000258923
1730.37 0.000258923
2058.94 0.000258923
1754.5 0.000258923
2048.45 0.000258923
4713.46 0.000258923
5891.94 0.000258923
END
$hits1 << END
1251.48 0.00740767
1437.86 0.00626707
1439.12 0.0239263
1725.49 0.010325
1572.4 0.0226121
1956.65 0.0121698
1371.99 0.00740767
1573.87 0.00626707
1765.76 0.0239263
2265.72 0.010325
1878.95 0.0226121
2458.4 0.0121698
1332.06 0.00840855
1528.86 0.00634432
1218.48 0.0187721
1414.94 0.0170641
1241.31 0.0174308
1422.84 0.0124621
3345.55 0.0219607
4355.13 0.0106969
END
$hits2 << END
2138.35 2.38419e-07
2397.78 2.38419e-07
1763.81 2.38419e-07
2028.73 2.38419e-07
1971.54 2.38419e-07
2333.65 2.38419e-07
2235.35 2.38419e-07
2477.64 2.38419e-07
2052.68 2.38419e-07
2505.29 2.38419e-07
2246.92 2.38419e-07
2756.16 2.38419e-07
2117.48 2.38419e-07
2392.87 2.38419e-07
1525.97 2.38419e-07
1798.76 2.38419e-07
1548.66 2.38419e-07
1792.76 2.38419e-07
3747.91 2.38419e-07
4737.31 2.38419e-07
423.888 2.38419e-07
1225.09 2.38419e-07
2720.24 2.38419e-07
1240.84 2.38419e-07
1719.16 2.38419e-07
END
$hits3 << END
1195.63 0.00717831
1351.87 0.00603485
1300.03 0.0237164
1546.46 0.0100956
1428.86 0.0224056
1759.4 0.011939
1301.79 0.00717831
1479.67 0.00603485
1563.14 0.0237164
1979.7 0.0100956
1672.65 0.0224056
2132.43 0.011939
1272 0.00818014
1449.75 0.00611162
1154.68 0.0185757
1324.9 0.0168576
1174.35 0.0172191
1330.92 0.0122404
2916.6 0.0217538
3727.45 0.010457
END
$hits4 << END
1226.76 1.76606e-07
1366.16 1.76606e-07
1111.46 1.76606e-07
1330.68 1.76606e-07
1227.75 1.76606e-07
1500.61 1.76606e-07
1232.74 1.76606e-07
1378.4 1.76606e-07
1160.59 1.76606e-07
1425.32 1.76606e-07
1265.27 1.76606e-07
1579.03 1.76606e-07
1171.46 1.76606e-07
1320.54 1.76606e-07
812.87 1.76606e-07
962.632 1.76606e-07
833.547 1.76606e-07
977.216 1.76606e-07
2094.6 1.76606e-07
2656.4 1.76606e-07
END
$hits5 << END
586.636 0.00717831
664.841 0.00603533
775.4 0.0237164
989.88 0.0100975
821.294 0.0224056
1065.05 0.01194
609.762 0.00717831
695.682 0.00603533
811.31 0.0237164
1044.9 0.010098
851.925 0.0224056
1115.68 0.01194
594.043 0.00818014
676.256 0.0061121
557.037 0.01858
640.801 0.0168648
569.675 0.0172191
647.097 0.0122404
1458.14 0.0217538
1869.41 0.0104575
END
$hits_front << END
4737.31 2.38419e-07
5891.94 0.000258923
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
set xrange [48.8761:1182.18]; set yrange [5.1556e-05:0.137565]
set xlabel 'pictures a second  (more is better)'; set ylabel 'picture: RMSE of a channel  (less is better)' offset -1.5
set xtics ('50' 50, '100' 100, '200' 200, '500' 500, '1000' 1000)
set ytics ("same\nbits" 0.00012889, '10⁻³' 1e-3, '10⁻²' 1e-2, '10⁻¹' 1e-1)
set object rectangle from graph 0, graph 0 to graph 1, first 0.000219113 fs solid noborder fc rgb '#eeeeee' behind
set arrow from first 985.154,0.0386257 to graph 1.0,0.8390 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.8390 to graph 1.015,0.8390 nohead lw 0.8 lc rgb '#999999'
set label 'fast, study: irregular exact' at graph 1.02,0.8390 left
set arrow from first 974.251,0.0240238 to graph 1.0,0.7788 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.7788 to graph 1.015,0.7788 nohead lw 0.8 lc rgb '#999999'
set label 'fast: irregular exact' at graph 1.02,0.7788 left
set arrow from first 796.445,0.00103112 to graph 1.0,0.3797 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.3797 to graph 1.015,0.3797 nohead lw 0.8 lc rgb '#999999'
set label 'robust: irregular exact' at graph 1.02,0.3797 left
set arrow from first 482.693,9.54741e-05 to graph 1.0,0.0781 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.0781 to graph 1.015,0.0781 nohead lw 0.8 lc rgb '#999999'
set label 'double: irregular exact' at graph 1.02,0.0781 left
$picture0 << END
354.779 0.0240238
400.098 0.0240238
470.024 0.0240238
597.4 0.0240238
483.582 0.0240238
643.124 0.0240238
352.606 0.0240238
399.677 0.0240238
436.599 0.0240238
574.017 0.0240238
465.363 0.0240238
606.55 0.0240238
341.337 0.0240238
389.684 0.0240238
407.043 0.0240238
480.303 0.0240238
382.512 0.0240238
443.363 0.0240238
712.642 0.0240238
974.251 0.0240238
END
$picture1 << END
359.836 0.0316948
410.33 0.0299718
474.793 0.0550258
611.079 0.0382589
496.727 0.0514003
651.029 0.0396658
358.503 0.0316948
406.124 0.0299718
452.839 0.0550258
579.274 0.0382589
477.733 0.0514003
628.899 0.0396658
353.903 0.0316956
401.976 0.0299871
420.276 0.0433868
486.254 0.0431929
393.048 0.0454264
462.49 0.0385493
732.74 0.0516801
985.154 0.0386257
END
$picture2 << END
332.235 0.00103112
365.07 0.00103112
405.959 0.00103112
518.336 0.00103112
426.942 0.00103112
554.284 0.00103112
317.991 0.00103112
365.279 0.00103112
388.648 0.00103112
496.236 0.00103112
411.086 0.00103112
534.965 0.00103112
315.577 0.00103112
357.191 0.00103112
381.432 0.00103112
437.97 0.00103112
357.764 0.00103112
425.175 0.00103112
600.536 0.00103112
796.445 0.00103112
58.6514 0.00103112
178.779 0.00103112
549.529 0.00103112
359.927 0.00103112
349.658 0.00103112
END
$picture3 << END
340.148 0.0213945
379.239 0.0185578
428.752 0.0501279
538.996 0.0301143
452.321 0.0460152
578.791 0.0320803
333.404 0.0213945
381.144 0.0185578
414.736 0.0501279
515.448 0.0301143
419.875 0.0460152
557.23 0.0320803
335.874 0.0213955
374.288 0.0185825
395.44 0.0367043
459.464 0.0363682
370.203 0.03897
437.767 0.0306254
633.192 0.0463472
822.653 0.0308364
END
$picture4 << END
199.813 9.54741e-05
226.179 9.54741e-05
258.414 9.54741e-05
339.889 9.54741e-05
266.324 9.54741e-05
357.58 9.54741e-05
196.648 9.54741e-05
222.547 9.54741e-05
249.393 9.54741e-05
329.072 9.54741e-05
259.994 9.54741e-05
347.184 9.54741e-05
193.764 9.54741e-05
221.394 9.54741e-05
234.098 9.54741e-05
273.95 9.54741e-05
223.342 9.54741e-05
263.571 9.54741e-05
374.215 9.54741e-05
482.693 9.54741e-05
END
$picture5 << END
206.169 0.0213712
233.263 0.0185352
276.107 0.0501203
352.046 0.0301081
278.647 0.0460158
373.513 0.0321056
204.182 0.0213712
231.636 0.0185352
267.06 0.0501203
342.028 0.0301087
267.949 0.0460158
364.057 0.0321056
202.927 0.0213723
229.02 0.0185599
244.536 0.0367162
288.622 0.0363944
230.948 0.0389679
275.658 0.0306294
396.725 0.0463478
503.456 0.0308645
END
$picture_front << END
482.693 9.54741e-05
796.445 0.00103112
974.251 0.0240238
985.154 0.0386257
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
set xrange [353.24:7070.33]; set yrange [9.53674e-08:0.0598156]
set xlabel 'million nearest hits a second  (more is better)'; set ylabel 'wrong hits  (less is better)' offset -1.5
set label 'rings: speed against accuracy (GPU)' at screen 0.02, screen 0.9774 font ',20'
set label '1024x1024 primary and 1,048,576 random rays a scene; 2,097,152 in all compared with brute force in double; pictures of 512x512' at screen 0.02, screen 0.9516
set xtics ('500' 500, '1000' 1000, '2000' 2000, '5000' 5000)
set ytics ("none of\n2,097,152" 2.38419e-07, '0.0001 %%' 1e-6, '0.001 %%' 1e-5, '0.01 %%' 1e-4, '0.1 %%' 1e-3, '1 %%' 1e-2)
set object rectangle from graph 0, graph 0 to graph 1, first 4.05312e-07 fs solid noborder fc rgb '#eeeeee' behind
set arrow from first 5891.94,0.000258923 to graph 1.0,0.5923 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.5923 to graph 1.015,0.5923 nohead lw 0.8 lc rgb '#999999'
set label 'fast: irregular exact' at graph 1.02,0.5923 left
set arrow from first 4737.31,2.38419e-07 to graph 1.0,0.0686 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.0686 to graph 1.015,0.0686 nohead lw 0.8 lc rgb '#999999'
set label 'robust: irregular exact' at graph 1.02,0.0686 left
$hits0 << END
2437.82 0.000258923
2728.85 0.000258923
2152.04 0.000258923
2441.91 0.000258923
2402.52 0.000258923
2818.15 0.000258923
2515.49 0.000258923
2838.9 0.000258923
2535.73 0.000258923
3091.47 0.000258923
2760.34 0.000258923
3405.53 0.000258923
2389.3 0.000258923
2710.68 0.000258923
1730.37 0.000258923
2058.94 0.000258923
1754.5 0.000258923
2048.45 0.000258923
4713.46 0.000258923
5891.94 0.000258923
END
$hits1 << END
1251.48 0.00740767
1437.86 0.00626707
1439.12 0.0239263
1725.49 0.010325
1572.4 0.0226121
1956.65 0.0121698
1371.99 0.00740767
1573.87 0.00626707
1765.76 0.0239263
2265.72 0.010325
1878.95 0.0226121
2458.4 0.0121698
1332.06 0.00840855
1528.86 0.00634432
1218.48 0.0187721
1414.94 0.0170641
1241.31 0.0174308
1422.84 0.0124621
3345.55 0.0219607
4355.13 0.0106969
END
$hits2 << END
2138.35 2.38419e-07
2397.78 2.38419e-07
1763.81 2.38419e-07
2028.73 2.38419e-07
1971.54 2.38419e-07
2333.65 2.38419e-07
2235.35 2.38419e-07
2477.64 2.38419e-07
2052.68 2.38419e-07
2505.29 2.38419e-07
2246.92 2.38419e-07
2756.16 2.38419e-07
2117.48 2.38419e-07
2392.87 2.38419e-07
1525.97 2.38419e-07
1798.76 2.38419e-07
1548.66 2.38419e-07
1792.76 2.38419e-07
3747.91 2.38419e-07
4737.31 2.38419e-07
423.888 2.38419e-07
1225.09 2.38419e-07
2720.24 2.38419e-07
1240.84 2.38419e-07
1719.16 2.38419e-07
END
$hits3 << END
1195.63 0.00717831
1351.87 0.00603485
1300.03 0.0237164
1546.46 0.0100956
1428.86 0.0224056
1759.4 0.011939
1301.79 0.00717831
1479.67 0.00603485
1563.14 0.0237164
1979.7 0.0100956
1672.65 0.0224056
2132.43 0.011939
1272 0.00818014
1449.75 0.00611162
1154.68 0.0185757
1324.9 0.0168576
1174.35 0.0172191
1330.92 0.0122404
2916.6 0.0217538
3727.45 0.010457
END
$hits4 << END
1226.76 1.76606e-07
1366.16 1.76606e-07
1111.46 1.76606e-07
1330.68 1.76606e-07
1227.75 1.76606e-07
1500.61 1.76606e-07
1232.74 1.76606e-07
1378.4 1.76606e-07
1160.59 1.76606e-07
1425.32 1.76606e-07
1265.27 1.76606e-07
1579.03 1.76606e-07
1171.46 1.76606e-07
1320.54 1.76606e-07
812.87 1.76606e-07
962.632 1.76606e-07
833.547 1.76606e-07
977.216 1.76606e-07
2094.6 1.76606e-07
2656.4 1.76606e-07
END
$hits5 << END
586.636 0.00717831
664.841 0.00603533
775.4 0.0237164
989.88 0.0100975
821.294 0.0224056
1065.05 0.01194
609.762 0.00717831
695.682 0.00603533
811.31 0.0237164
1044.9 0.010098
851.925 0.0224056
1115.68 0.01194
594.043 0.00818014
676.256 0.0061121
557.037 0.01858
640.801 0.0168648
569.675 0.0172191
647.097 0.0122404
1458.14 0.0217538
1869.41 0.0104575
END
$hits_front << END
4737.31 2.38419e-07
5891.94 0.000258923
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
set xrange [48.8761:1182.18]; set yrange [5.1556e-05:0.137565]
set xlabel 'pictures a second  (more is better)'; set ylabel 'picture: RMSE of a channel  (less is better)' offset -1.5
set xtics ('50' 50, '100' 100, '200' 200, '500' 500, '1000' 1000)
set ytics ("same\nbits" 0.00012889, '10⁻³' 1e-3, '10⁻²' 1e-2, '10⁻¹' 1e-1)
set object rectangle from graph 0, graph 0 to graph 1, first 0.000219113 fs solid noborder fc rgb '#eeeeee' behind
set arrow from first 985.154,0.0386257 to graph 1.0,0.8390 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.8390 to graph 1.015,0.8390 nohead lw 0.8 lc rgb '#999999'
set label 'fast, study: irregular exact' at graph 1.02,0.8390 left
set arrow from first 974.251,0.0240238 to graph 1.0,0.7788 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.7788 to graph 1.015,0.7788 nohead lw 0.8 lc rgb '#999999'
set label 'fast: irregular exact' at graph 1.02,0.7788 left
set arrow from first 796.445,0.00103112 to graph 1.0,0.3797 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.3797 to graph 1.015,0.3797 nohead lw 0.8 lc rgb '#999999'
set label 'robust: irregular exact' at graph 1.02,0.3797 left
set arrow from first 482.693,9.54741e-05 to graph 1.0,0.0781 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.0781 to graph 1.015,0.0781 nohead lw 0.8 lc rgb '#999999'
set label 'double: irregular exact' at graph 1.02,0.0781 left
$picture0 << END
354.779 0.0240238
400.098 0.0240238
470.024 0.0240238
597.4 0.0240238
483.582 0.0240238
643.124 0.0240238
352.606 0.0240238
399.677 0.0240238
436.599 0.0240238
574.017 0.0240238
465.363 0.0240238
606.55 0.0240238
341.337 0.0240238
389.684 0.0240238
407.043 0.0240238
480.303 0.0240238
382.512 0.0240238
443.363 0.0240238
712.642 0.0240238
974.251 0.0240238
END
$picture1 << END
359.836 0.0316948
410.33 0.0299718
474.793 0.0550258
611.079 0.0382589
496.727 0.0514003
651.029 0.0396658
358.503 0.0316948
406.124 0.0299718
452.839 0.0550258
579.274 0.0382589
477.733 0.0514003
628.899 0.0396658
353.903 0.0316956
401.976 0.0299871
420.276 0.0433868
486.254 0.0431929
393.048 0.0454264
462.49 0.0385493
732.74 0.0516801
985.154 0.0386257
END
$picture2 << END
332.235 0.00103112
365.07 0.00103112
405.959 0.00103112
518.336 0.00103112
426.942 0.00103112
554.284 0.00103112
317.991 0.00103112
365.279 0.00103112
388.648 0.00103112
496.236 0.00103112
411.086 0.00103112
534.965 0.00103112
315.577 0.00103112
357.191 0.00103112
381.432 0.00103112
437.97 0.00103112
357.764 0.00103112
425.175 0.00103112
600.536 0.00103112
796.445 0.00103112
58.6514 0.00103112
178.779 0.00103112
549.529 0.00103112
359.927 0.00103112
349.658 0.00103112
END
$picture3 << END
340.148 0.0213945
379.239 0.0185578
428.752 0.0501279
538.996 0.0301143
452.321 0.0460152
578.791 0.0320803
333.404 0.0213945
381.144 0.0185578
414.736 0.0501279
515.448 0.0301143
419.875 0.0460152
557.23 0.0320803
335.874 0.0213955
374.288 0.0185825
395.44 0.0367043
459.464 0.0363682
370.203 0.03897
437.767 0.0306254
633.192 0.0463472
822.653 0.0308364
END
$picture4 << END
199.813 9.54741e-05
226.179 9.54741e-05
258.414 9.54741e-05
339.889 9.54741e-05
266.324 9.54741e-05
357.58 9.54741e-05
196.648 9.54741e-05
222.547 9.54741e-05
249.393 9.54741e-05
329.072 9.54741e-05
259.994 9.54741e-05
347.184 9.54741e-05
193.764 9.54741e-05
221.394 9.54741e-05
234.098 9.54741e-05
273.95 9.54741e-05
223.342 9.54741e-05
263.571 9.54741e-05
374.215 9.54741e-05
482.693 9.54741e-05
END
$picture5 << END
206.169 0.0213712
233.263 0.0185352
276.107 0.0501203
352.046 0.0301081
278.647 0.0460158
373.513 0.0321056
204.182 0.0213712
231.636 0.0185352
267.06 0.0501203
342.028 0.0301087
267.949 0.0460158
364.057 0.0321056
202.927 0.0213723
229.02 0.0185599
244.536 0.0367162
288.622 0.0363944
230.948 0.0389679
275.658 0.0306294
396.725 0.0463478
503.456 0.0308645
END
$picture_front << END
482.693 9.54741e-05
796.445 0.00103112
974.251 0.0240238
985.154 0.0386257
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
set xrange [406.748:11204.3]; set yrange [9.53674e-08:0.000944138]
set xlabel 'million nearest hits a second  (more is better)'; set ylabel 'wrong hits  (less is better)' offset -1.5
set label 'teapot: speed against accuracy (GPU)' at screen 0.02, screen 0.9774 font ',20'
set label '1024x1024 primary and 1,048,576 random rays a scene; 2,097,152 in all compared with brute force in double; pictures of 512x512' at screen 0.02, screen 0.9516
set xtics ('500' 500, '1000' 1000, '2000' 2000, '5000' 5000, '10000' 10000)
set ytics ("none of\n2,097,152" 2.38419e-07, '0.0001 %%' 1e-6, '0.001 %%' 1e-5, '0.01 %%' 1e-4)
set object rectangle from graph 0, graph 0 to graph 1, first 4.05312e-07 fs solid noborder fc rgb '#eeeeee' behind
set arrow from first 9336.94,3.21865e-07 to graph 1.0,0.1322 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.1322 to graph 1.015,0.1322 nohead lw 0.8 lc rgb '#999999'
set label 'fast: irregular exact' at graph 1.02,0.1322 left
$hits0 << END
3431.02 3.21865e-07
3489.67 3.21865e-07
3188.01 3.21865e-07
3342.31 3.21865e-07
3780.56 3.21865e-07
3960.36 3.21865e-07
3411.56 3.21865e-07
3488.37 3.21865e-07
3881.54 3.21865e-07
4133.72 3.21865e-07
4850.57 3.21865e-07
5223.66 3.21865e-07
3286.99 3.21865e-07
3355.14 3.21865e-07
2838.41 3.21865e-07
2753.04 3.21865e-07
3363.58 3.21865e-07
3497.68 3.21865e-07
8867 3.21865e-07
9336.94 3.21865e-07
END
$hits1 << END
1063.15 0.000369549
1091.32 0.000362873
1802.62 0.000377655
1938.3 0.000377178
2010.18 0.000349998
2191.99 0.000195026
1095.61 0.000369549
1128.57 0.000362873
2266.66 0.000377655
2512.59 0.000377178
2534.07 0.000349998
2890.1 0.000195026
1070.81 0.000369549
1100.65 0.000362873
1396.67 0.000284672
1425.84 0.00029707
1684.73 0.000234604
1787.28 0.000130653
5272.41 0.000281334
5728.17 0.000110626
END
$hits2 << END
2983.52 2.38419e-07
3017.87 2.38419e-07
2973.5 2.38419e-07
3124.33 2.38419e-07
3471.37 2.38419e-07
3676.02 2.38419e-07
3074.21 2.38419e-07
3138.25 2.38419e-07
3654.29 2.38419e-07
3885.46 2.38419e-07
4432 2.38419e-07
4783.65 2.38419e-07
2963.28 2.38419e-07
3042.1 2.38419e-07
2626.06 2.38419e-07
2550.54 2.38419e-07
3089.43 2.38419e-07
3221.23 2.38419e-07
8024.49 2.38419e-07
8415 2.38419e-07
1489.76 2.38419e-07
4302.52 2.38419e-07
1860.71 2.38419e-07
3691.96 2.38419e-07
END
$hits3 << END
840.065 0.000369549
866.5 0.000362873
1548.73 0.000377655
1692.96 0.000377178
1701.39 0.000349998
1874.71 0.000195026
887.096 0.000369549
913.101 0.000362873
1930.31 0.000377655
2165.91 0.000377178
2144.29 0.000349998
2442.18 0.000195026
865.939 0.000369549
891.755 0.000362873
1080.77 0.000284672
1102.95 0.00029707
1311.43 0.000234604
1391.54 0.000130653
4356.87 0.000281334
4734.23 0.000110626
END
$hits4 << END
2130.56 1.76606e-07
2168.34 1.76606e-07
2129.87 1.76606e-07
2268.62 1.76606e-07
2424.3 1.76606e-07
2587.8 1.76606e-07
2135.77 1.76606e-07
2213.68 1.76606e-07
2227.98 1.76606e-07
2362.59 1.76606e-07
2659.63 1.76606e-07
2861.46 1.76606e-07
1998.54 1.76606e-07
2082.56 1.76606e-07
1526.15 1.76606e-07
1489.56 1.76606e-07
1805.2 1.76606e-07
1877.93 1.76606e-07
4875.83 1.76606e-07
5071.27 1.76606e-07
END
$hits5 << END
488.098 0.000369549
500.527 0.000362873
1030.31 0.000377655
1151.19 0.000377178
1091.92 0.000349998
1226.05 0.000195503
505.976 0.000369549
518.309 0.000362873
1069.09 0.000377655
1205.57 0.000377178
1203.18 0.000349998
1365.79 0.000195503
491.142 0.000369549
507.527 0.000362873
620.724 0.000284672
633.596 0.00029707
748.572 0.000234604
788.612 0.00013113
2503.67 0.000281334
2773.42 0.000110626
END
$hits_front << END
9336.94 3.21865e-07
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
set xrange [136.515:2185.31]; set yrange [2.14846e-05:0.0175858]
set xlabel 'pictures a second  (more is better)'; set ylabel 'picture: RMSE of a channel  (less is better)' offset -1.5
set xtics ('150' 150, '200' 200, '300' 300, '500' 500, '700' 700, '1000' 1000, '1500' 1500, '2000' 2000)
set ytics ("same\nbits" 5.37116e-05, '10⁻³' 1e-3, '10⁻²' 1e-2)
set object rectangle from graph 0, graph 0 to graph 1, first 9.13098e-05 fs solid noborder fc rgb '#eeeeee' behind
set arrow from first 1821.1,0.000832694 to graph 1.0,0.5453 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.5453 to graph 1.015,0.5453 nohead lw 0.8 lc rgb '#999999'
set label 'fast: irregular exact' at graph 1.02,0.5453 left
set arrow from first 1538.65,0.000429693 to graph 1.0,0.4466 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.4466 to graph 1.015,0.4466 nohead lw 0.8 lc rgb '#999999'
set label 'robust: irregular exact' at graph 1.02,0.4466 left
set arrow from first 1323.26,3.97864e-05 to graph 1.0,0.0919 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.0919 to graph 1.015,0.0919 nohead lw 0.8 lc rgb '#999999'
set label 'double: irregular exact' at graph 1.02,0.0919 left
$picture0 << END
370.616 0.000832694
381.745 0.000832694
777.46 0.000832694
919.955 0.000832694
835.45 0.000832694
937.875 0.000832694
391.207 0.000832694
403.987 0.000832694
766.795 0.000832694
897.006 0.000832694
854.015 0.000832694
1010.61 0.000832694
373.58 0.000832694
386.451 0.000832694
719.166 0.000832694
751.004 0.000832694
747.178 0.000832694
823.432 0.000832694
1522.98 0.000832694
1821.1 0.000832694
END
$picture1 << END
343.981 0.00680517
349.98 0.00673666
753.937 0.00687082
865.771 0.00703431
789.958 0.00680154
909.223 0.00395185
351.219 0.00680517
359.505 0.00673666
718.752 0.00687082
862.114 0.00703431
799.623 0.00680154
945.421 0.00395185
337.058 0.00680517
344.137 0.00673666
660.62 0.00564691
704.275 0.0054363
715.103 0.00474342
777.865 0.00264172
1483.5 0.00529647
1682.37 0.00288016
END
$picture2 << END
326.698 0.000429693
333.259 0.000429693
694.599 0.000429693
808.996 0.000429693
747.127 0.000429693
847.092 0.000429693
327.122 0.000429693
337.845 0.000429693
671.768 0.000429693
798.397 0.000429693
735.537 0.000429693
860.193 0.000429693
318.721 0.000429693
324.942 0.000429693
618.984 0.000429693
644.039 0.000429693
648.622 0.000429693
708.521 0.000429693
1291.8 0.000429693
1538.65 0.000429693
163.818 0.000429693
644.621 0.000429693
725.784 0.000429693
820.493 0.000429693
END
$picture3 << END
292.122 0.0067695
299.421 0.00670134
643.492 0.00683399
744.812 0.00699834
672.346 0.00676407
785.373 0.00388701
300.022 0.0067695
308.337 0.00670134
632.143 0.00683399
753.773 0.00699834
704.434 0.00676407
832.556 0.00388701
293.593 0.0067695
296.245 0.00670134
574.627 0.00560204
601.03 0.0053897
615.498 0.00468955
667.223 0.0025437
1282.31 0.00525394
1416.14 0.00279052
END
$picture4 << END
256.488 3.97864e-05
262.645 3.97864e-05
583.502 3.97864e-05
702.119 3.97864e-05
599.441 3.97864e-05
699.34 3.97864e-05
262.402 3.97864e-05
271.35 3.97864e-05
567.254 3.97864e-05
683.63 3.97864e-05
609.719 3.97864e-05
717.566 3.97864e-05
252.362 3.97864e-05
257.721 3.97864e-05
501.645 3.97864e-05
529.779 3.97864e-05
523.16 3.97864e-05
576.143 3.97864e-05
1102.68 3.97864e-05
1323.26 3.97864e-05
END
$picture5 << END
250.923 0.00675584
256.997 0.00668754
557.24 0.00682047
663.398 0.00698514
574.122 0.0067504
672.215 0.00386319
254.102 0.00675584
260.081 0.00668754
547.708 0.00682047
664.059 0.00698514
591.947 0.0067504
706.999 0.00386319
246.527 0.00675584
248.081 0.00668754
483.559 0.00558553
515.506 0.00537259
516.708 0.00466981
569.259 0.00250715
1092.92 0.00523634
1256.94 0.00275724
END
$picture_front << END
1323.26 3.97864e-05
1538.65 0.000429693
1821.1 0.000832694
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
set xrange [406.748:11204.3]; set yrange [9.53674e-08:0.000944138]
set xlabel 'million nearest hits a second  (more is better)'; set ylabel 'wrong hits  (less is better)' offset -1.5
set label 'teapot: speed against accuracy (GPU)' at screen 0.02, screen 0.9774 font ',20'
set label '1024x1024 primary and 1,048,576 random rays a scene; 2,097,152 in all compared with brute force in double; pictures of 512x512' at screen 0.02, screen 0.9516
set xtics ('500' 500, '1000' 1000, '2000' 2000, '5000' 5000, '10000' 10000)
set ytics ("none of\n2,097,152" 2.38419e-07, '0.0001 %%' 1e-6, '0.001 %%' 1e-5, '0.01 %%' 1e-4)
set object rectangle from graph 0, graph 0 to graph 1, first 4.05312e-07 fs solid noborder fc rgb '#eeeeee' behind
set arrow from first 9336.94,3.21865e-07 to graph 1.0,0.1322 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.1322 to graph 1.015,0.1322 nohead lw 0.8 lc rgb '#999999'
set label 'fast: irregular exact' at graph 1.02,0.1322 left
$hits0 << END
3431.02 3.21865e-07
3489.67 3.21865e-07
3188.01 3.21865e-07
3342.31 3.21865e-07
3780.56 3.21865e-07
3960.36 3.21865e-07
3411.56 3.21865e-07
3488.37 3.21865e-07
3881.54 3.21865e-07
4133.72 3.21865e-07
4850.57 3.21865e-07
5223.66 3.21865e-07
3286.99 3.21865e-07
3355.14 3.21865e-07
2838.41 3.21865e-07
2753.04 3.21865e-07
3363.58 3.21865e-07
3497.68 3.21865e-07
8867 3.21865e-07
9336.94 3.21865e-07
END
$hits1 << END
1063.15 0.000369549
1091.32 0.000362873
1802.62 0.000377655
1938.3 0.000377178
2010.18 0.000349998
2191.99 0.000195026
1095.61 0.000369549
1128.57 0.000362873
2266.66 0.000377655
2512.59 0.000377178
2534.07 0.000349998
2890.1 0.000195026
1070.81 0.000369549
1100.65 0.000362873
1396.67 0.000284672
1425.84 0.00029707
1684.73 0.000234604
1787.28 0.000130653
5272.41 0.000281334
5728.17 0.000110626
END
$hits2 << END
2983.52 2.38419e-07
3017.87 2.38419e-07
2973.5 2.38419e-07
3124.33 2.38419e-07
3471.37 2.38419e-07
3676.02 2.38419e-07
3074.21 2.38419e-07
3138.25 2.38419e-07
3654.29 2.38419e-07
3885.46 2.38419e-07
4432 2.38419e-07
4783.65 2.38419e-07
2963.28 2.38419e-07
3042.1 2.38419e-07
2626.06 2.38419e-07
2550.54 2.38419e-07
3089.43 2.38419e-07
3221.23 2.38419e-07
8024.49 2.38419e-07
8415 2.38419e-07
1489.76 2.38419e-07
4302.52 2.38419e-07
1860.71 2.38419e-07
3691.96 2.38419e-07
END
$hits3 << END
840.065 0.000369549
866.5 0.000362873
1548.73 0.000377655
1692.96 0.000377178
1701.39 0.000349998
1874.71 0.000195026
887.096 0.000369549
913.101 0.000362873
1930.31 0.000377655
2165.91 0.000377178
2144.29 0.000349998
2442.18 0.000195026
865.939 0.000369549
891.755 0.000362873
1080.77 0.000284672
1102.95 0.00029707
1311.43 0.000234604
1391.54 0.000130653
4356.87 0.000281334
4734.23 0.000110626
END
$hits4 << END
2130.56 1.76606e-07
2168.34 1.76606e-07
2129.87 1.76606e-07
2268.62 1.76606e-07
2424.3 1.76606e-07
2587.8 1.76606e-07
2135.77 1.76606e-07
2213.68 1.76606e-07
2227.98 1.76606e-07
2362.59 1.76606e-07
2659.63 1.76606e-07
2861.46 1.76606e-07
1998.54 1.76606e-07
2082.56 1.76606e-07
1526.15 1.76606e-07
1489.56 1.76606e-07
1805.2 1.76606e-07
1877.93 1.76606e-07
4875.83 1.76606e-07
5071.27 1.76606e-07
END
$hits5 << END
488.098 0.000369549
500.527 0.000362873
1030.31 0.000377655
1151.19 0.000377178
1091.92 0.000349998
1226.05 0.000195503
505.976 0.000369549
518.309 0.000362873
1069.09 0.000377655
1205.57 0.000377178
1203.18 0.000349998
1365.79 0.000195503
491.142 0.000369549
507.527 0.000362873
620.724 0.000284672
633.596 0.00029707
748.572 0.000234604
788.612 0.00013113
2503.67 0.000281334
2773.42 0.000110626
END
$hits_front << END
9336.94 3.21865e-07
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
set xrange [136.515:2185.31]; set yrange [2.14846e-05:0.0175858]
set xlabel 'pictures a second  (more is better)'; set ylabel 'picture: RMSE of a channel  (less is better)' offset -1.5
set xtics ('150' 150, '200' 200, '300' 300, '500' 500, '700' 700, '1000' 1000, '1500' 1500, '2000' 2000)
set ytics ("same\nbits" 5.37116e-05, '10⁻³' 1e-3, '10⁻²' 1e-2)
set object rectangle from graph 0, graph 0 to graph 1, first 9.13098e-05 fs solid noborder fc rgb '#eeeeee' behind
set arrow from first 1821.1,0.000832694 to graph 1.0,0.5453 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.5453 to graph 1.015,0.5453 nohead lw 0.8 lc rgb '#999999'
set label 'fast: irregular exact' at graph 1.02,0.5453 left
set arrow from first 1538.65,0.000429693 to graph 1.0,0.4466 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.4466 to graph 1.015,0.4466 nohead lw 0.8 lc rgb '#999999'
set label 'robust: irregular exact' at graph 1.02,0.4466 left
set arrow from first 1323.26,3.97864e-05 to graph 1.0,0.0919 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.0919 to graph 1.015,0.0919 nohead lw 0.8 lc rgb '#999999'
set label 'double: irregular exact' at graph 1.02,0.0919 left
$picture0 << END
370.616 0.000832694
381.745 0.000832694
777.46 0.000832694
919.955 0.000832694
835.45 0.000832694
937.875 0.000832694
391.207 0.000832694
403.987 0.000832694
766.795 0.000832694
897.006 0.000832694
854.015 0.000832694
1010.61 0.000832694
373.58 0.000832694
386.451 0.000832694
719.166 0.000832694
751.004 0.000832694
747.178 0.000832694
823.432 0.000832694
1522.98 0.000832694
1821.1 0.000832694
END
$picture1 << END
343.981 0.00680517
349.98 0.00673666
753.937 0.00687082
865.771 0.00703431
789.958 0.00680154
909.223 0.00395185
351.219 0.00680517
359.505 0.00673666
718.752 0.00687082
862.114 0.00703431
799.623 0.00680154
945.421 0.00395185
337.058 0.00680517
344.137 0.00673666
660.62 0.00564691
704.275 0.0054363
715.103 0.00474342
777.865 0.00264172
1483.5 0.00529647
1682.37 0.00288016
END
$picture2 << END
326.698 0.000429693
333.259 0.000429693
694.599 0.000429693
808.996 0.000429693
747.127 0.000429693
847.092 0.000429693
327.122 0.000429693
337.845 0.000429693
671.768 0.000429693
798.397 0.000429693
735.537 0.000429693
860.193 0.000429693
318.721 0.000429693
324.942 0.000429693
618.984 0.000429693
644.039 0.000429693
648.622 0.000429693
708.521 0.000429693
1291.8 0.000429693
1538.65 0.000429693
163.818 0.000429693
644.621 0.000429693
725.784 0.000429693
820.493 0.000429693
END
$picture3 << END
292.122 0.0067695
299.421 0.00670134
643.492 0.00683399
744.812 0.00699834
672.346 0.00676407
785.373 0.00388701
300.022 0.0067695
308.337 0.00670134
632.143 0.00683399
753.773 0.00699834
704.434 0.00676407
832.556 0.00388701
293.593 0.0067695
296.245 0.00670134
574.627 0.00560204
601.03 0.0053897
615.498 0.00468955
667.223 0.0025437
1282.31 0.00525394
1416.14 0.00279052
END
$picture4 << END
256.488 3.97864e-05
262.645 3.97864e-05
583.502 3.97864e-05
702.119 3.97864e-05
599.441 3.97864e-05
699.34 3.97864e-05
262.402 3.97864e-05
271.35 3.97864e-05
567.254 3.97864e-05
683.63 3.97864e-05
609.719 3.97864e-05
717.566 3.97864e-05
252.362 3.97864e-05
257.721 3.97864e-05
501.645 3.97864e-05
529.779 3.97864e-05
523.16 3.97864e-05
576.143 3.97864e-05
1102.68 3.97864e-05
1323.26 3.97864e-05
END
$picture5 << END
250.923 0.00675584
256.997 0.00668754
557.24 0.00682047
663.398 0.00698514
574.122 0.0067504
672.215 0.00386319
254.102 0.00675584
260.081 0.00668754
547.708 0.00682047
664.059 0.00698514
591.947 0.0067504
706.999 0.00386319
246.527 0.00675584
248.081 0.00668754
483.559 0.00558553
515.506 0.00537259
516.708 0.00466981
569.259 0.00250715
1092.92 0.00523634
1256.94 0.00275724
END
$picture_front << END
1323.26 3.97864e-05
1538.65 0.000429693
1821.1 0.000832694
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
set xrange [366.326:7480.57]; set yrange [9.53674e-08:0.0014317]
set xlabel 'million nearest hits a second  (more is better)'; set ylabel 'wrong hits  (less is better)' offset -1.5
set label 'tetra: speed against accuracy (GPU)' at screen 0.02, screen 0.9774 font ',20'
set label '1024x1024 primary and 1,048,576 random rays a scene; 2,097,152 in all compared with brute force in double; pictures of 512x512' at screen 0.02, screen 0.9516
set xtics ('500' 500, '1000' 1000, '2000' 2000, '5000' 5000)
set ytics ("none of\n2,097,152" 2.38419e-07, '0.0001 %%' 1e-6, '0.001 %%' 1e-5, '0.01 %%' 1e-4, '0.1 %%' 1e-3)
set object rectangle from graph 0, graph 0 to graph 1, first 4.05312e-07 fs solid noborder fc rgb '#eeeeee' behind
set arrow from first 6233.81,9.53674e-07 to graph 1.0,0.2394 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.2394 to graph 1.015,0.2394 nohead lw 0.8 lc rgb '#999999'
set label 'fast: irregular exact' at graph 1.02,0.2394 left
set arrow from first 5706.23,2.38419e-07 to graph 1.0,0.0953 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.0953 to graph 1.015,0.0953 nohead lw 0.8 lc rgb '#999999'
set label 'robust: irregular exact' at graph 1.02,0.0953 left
$hits0 << END
2797.46 9.53674e-07
2934.75 9.53674e-07
2482.61 9.53674e-07
2756.39 9.53674e-07
3781.21 9.53674e-07
4032.24 9.53674e-07
2826.53 9.53674e-07
2928.98 9.53674e-07
2830.2 9.53674e-07
3158.97 9.53674e-07
4057.71 9.53674e-07
4381.63 9.53674e-07
2556.11 9.53674e-07
2698.4 9.53674e-07
1978.56 9.53674e-07
1505.43 9.53674e-07
2701.96 9.53674e-07
2378.28 9.53674e-07
6118.57 9.53674e-07
6233.81 9.53674e-07
END
$hits1 << END
1221.21 9.53674e-07
1323.37 2.3365e-05
1153.8 9.53674e-07
1467.31 3.29018e-05
1719.29 9.53674e-07
2028.54 3.57628e-05
1287.09 9.53674e-07
1388.5 2.3365e-05
1354.08 9.53674e-07
1787.91 3.29018e-05
1932.7 9.53674e-07
2298.62 3.57628e-05
1235.01 9.53674e-07
1345.52 3.76701e-05
1284.89 9.53674e-07
978.324 0.000572681
1785.43 9.53674e-07
1719.07 0.000368595
3368.25 9.53674e-07
3498.05 7.15256e-06
END
$hits2 << END
2499.66 2.38419e-07
2601.25 2.38419e-07
2284.84 2.38419e-07
2528.39 2.38419e-07
3374.67 2.38419e-07
3622.98 2.38419e-07
2552.92 2.38419e-07
2657.8 2.38419e-07
2616 2.38419e-07
2952.21 2.38419e-07
3689.05 2.38419e-07
3978.87 2.38419e-07
2297.09 2.38419e-07
2432.39 2.38419e-07
1813.24 2.38419e-07
1430.57 2.38419e-07
2471.56 2.38419e-07
2182.93 2.38419e-07
5471.36 2.38419e-07
5706.23 2.38419e-07
648.249 2.38419e-07
1564.29 2.38419e-07
2888.96 2.38419e-07
1605.53 2.38419e-07
2181.7 2.38419e-07
END
$hits3 << END
889.396 2.38419e-07
963.552 2.24113e-05
917.216 2.38419e-07
1213.63 3.19481e-05
1330.92 2.38419e-07
1605.05 3.48091e-05
970.386 2.38419e-07
1056.93 2.24113e-05
1089.22 2.38419e-07
1475.4 3.19481e-05
1540.86 2.38419e-07
1857.49 3.48091e-05
935.267 2.38419e-07
1020.79 3.67165e-05
1003.95 2.38419e-07
771.593 0.000571728
1396.64 2.38419e-07
1347.48 0.000367641
2695.29 2.38419e-07
2833.13 6.19888e-06
END
$hits4 << END
1581.58 1.76606e-07
1637.17 1.76606e-07
1536.96 1.76606e-07
1726.31 1.76606e-07
2258.62 1.76606e-07
2414.47 1.76606e-07
1556.93 1.76606e-07
1626.53 1.76606e-07
1606.59 1.76606e-07
1828.72 1.76606e-07
2306.55 1.76606e-07
2468.68 1.76606e-07
1405.66 1.76606e-07
1491.9 1.76606e-07
1146.74 1.76606e-07
870.344 1.76606e-07
1527.04 1.76606e-07
1320.54 1.76606e-07
3427.44 1.76606e-07
3538.09 1.76606e-07
END
$hits5 << END
532.748 1.76606e-07
576.572 2.24113e-05
576.46 1.76606e-07
777.34 3.19481e-05
814.284 1.76606e-07
972.59 3.48091e-05
570.553 1.76606e-07
615.87 2.24113e-05
623.683 1.76606e-07
832.933 3.19481e-05
875.483 1.76606e-07
1038.95 3.48091e-05
547.15 1.76606e-07
592.619 3.67165e-05
576.161 1.76606e-07
439.591 0.000571728
798.499 1.76606e-07
764.518 0.000367641
1511.79 1.76606e-07
1590.22 6.19888e-06
END
$hits_front << END
5706.23 2.38419e-07
6233.81 9.53674e-07
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
set xrange [1235.9:11439.9]; set yrange [1.38018e-05:0.0057173]
set xlabel 'pictures a second  (more is better)'; set ylabel 'picture: RMSE of a channel  (less is better)' offset -1.5
set xtics ('1500' 1500, '2000' 2000, '3000' 3000, '5000' 5000, '7000' 7000, '10000' 10000)
set ytics ("same\nbits" 3.45046e-05, '10⁻⁴' 1e-4, '10⁻³' 1e-3)
set object rectangle from graph 0, graph 0 to graph 1, first 5.86579e-05 fs solid noborder fc rgb '#eeeeee' behind
set arrow from first 9533.25,0.00135754 to graph 1.0,0.7614 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.7614 to graph 1.015,0.7614 nohead lw 0.8 lc rgb '#999999'
set label 'fast: irregular exact' at graph 1.02,0.7614 left
set arrow from first 8043.76,0.000276037 to graph 1.0,0.4971 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.4971 to graph 1.015,0.4971 nohead lw 0.8 lc rgb '#999999'
set label 'robust: irregular exact' at graph 1.02,0.4971 left
set arrow from first 6268.81,2.5559e-05 to graph 1.0,0.1022 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.1022 to graph 1.015,0.1022 nohead lw 0.8 lc rgb '#999999'
set label 'double: irregular exact' at graph 1.02,0.1022 left
$picture0 << END
5063.19 0.00135754
5510.49 0.00135754
4479 0.00135754
5645.89 0.00135754
6907.6 0.00135754
8282.53 0.00135754
5033.83 0.00135754
5343.71 0.00135754
4075.38 0.00135754
4992.01 0.00135754
6977 0.00135754
8278.15 0.00135754
4683.05 0.00135754
5037.07 0.00135754
4146.76 0.00135754
3270.88 0.00135754
6033.98 0.00135754
6206.55 0.00135754
9191.18 0.00135754
9533.25 0.00135754
END
$picture1 << END
4724.11 0.00135754
5210.94 0.00135754
4230.4 0.00135754
5489.2 0.00135754
6778.74 0.00135754
7923.43 0.00135754
4765.17 0.00135754
5104.54 0.00135754
3923.41 0.00135754
4897.35 0.00135754
6398.44 0.00135754
7424.57 0.00135754
4377.36 0.00135754
4833.72 0.00135754
3905.76 0.00135754
3096.82 0.00167885
5715.07 0.00135754
5798.85 0.00228692
8514.99 0.00135754
8642.15 0.00135754
END
$picture2 << END
4530.96 0.000276037
4936.81 0.000276037
4090.31 0.000276037
5138.11 0.000276037
6258.76 0.000276037
7472.5 0.000276037
4142.91 0.000276037
4566.71 0.000276037
3651.55 0.000276037
4615.27 0.000276037
6125.05 0.000276037
7082.96 0.000276037
4052.13 0.000276037
4558.72 0.000276037
3588.24 0.000276037
2822.43 0.000276037
5242.41 0.000276037
5254.75 0.000276037
8016.93 0.000276037
8043.76 0.000276037
1483.08 0.000276037
3138.18 0.000276037
5296.61 0.000276037
3533.87 0.000276037
3163.28 0.000276037
END
$picture3 << END
3910.65 0.000276037
4158.35 0.000276037
3571.02 0.000276037
4695.72 0.000276037
5245.93 0.000276037
6377.55 0.000276037
3684.27 0.000276037
4092.46 0.000276037
3326.24 0.000276037
4299.08 0.000276037
5035.45 0.000276037
5996.93 0.000276037
3529.48 0.000276037
3884.4 0.000276037
3135.35 0.000276037
2459.86 0.00102558
4428.23 0.000276037
4599.65 0.00186099
7038.29 0.000276037
7358.14 0.000276037
END
$picture4 << END
3203.81 2.5559e-05
3512.42 2.5559e-05
3258.94 2.5559e-05
4287.28 2.5559e-05
4361.48 2.5559e-05
5302.9 2.5559e-05
3143.86 2.5559e-05
3424.28 2.5559e-05
2932.9 2.5559e-05
3720.68 2.5559e-05
4275.55 2.5559e-05
5112.89 2.5559e-05
2975.34 2.5559e-05
3237.67 2.5559e-05
2787.69 2.5559e-05
2196.84 2.5559e-05
3662.25 2.5559e-05
3779.63 2.5559e-05
5967.16 2.5559e-05
6268.81 2.5559e-05
END
$picture5 << END
3087.94 2.5559e-05
3445.42 2.5559e-05
2984.43 2.5559e-05
3910.65 2.5559e-05
3986.99 2.5559e-05
4748.52 2.5559e-05
3048.78 2.5559e-05
3354.08 2.5559e-05
2783.96 2.5559e-05
3564.91 2.5559e-05
3922.43 2.5559e-05
4676.74 2.5559e-05
2891.38 2.5559e-05
3167.76 2.5559e-05
2694.2 2.5559e-05
2114.49 0.000987729
3494.35 2.5559e-05
3646.02 0.0018404
5632.66 2.5559e-05
5821.54 2.5559e-05
END
$picture_front << END
6268.81 2.5559e-05
8043.76 0.000276037
9533.25 0.00135754
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
set xrange [366.326:7480.57]; set yrange [9.53674e-08:0.0014317]
set xlabel 'million nearest hits a second  (more is better)'; set ylabel 'wrong hits  (less is better)' offset -1.5
set label 'tetra: speed against accuracy (GPU)' at screen 0.02, screen 0.9774 font ',20'
set label '1024x1024 primary and 1,048,576 random rays a scene; 2,097,152 in all compared with brute force in double; pictures of 512x512' at screen 0.02, screen 0.9516
set xtics ('500' 500, '1000' 1000, '2000' 2000, '5000' 5000)
set ytics ("none of\n2,097,152" 2.38419e-07, '0.0001 %%' 1e-6, '0.001 %%' 1e-5, '0.01 %%' 1e-4, '0.1 %%' 1e-3)
set object rectangle from graph 0, graph 0 to graph 1, first 4.05312e-07 fs solid noborder fc rgb '#eeeeee' behind
set arrow from first 6233.81,9.53674e-07 to graph 1.0,0.2394 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.2394 to graph 1.015,0.2394 nohead lw 0.8 lc rgb '#999999'
set label 'fast: irregular exact' at graph 1.02,0.2394 left
set arrow from first 5706.23,2.38419e-07 to graph 1.0,0.0953 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.0953 to graph 1.015,0.0953 nohead lw 0.8 lc rgb '#999999'
set label 'robust: irregular exact' at graph 1.02,0.0953 left
$hits0 << END
2797.46 9.53674e-07
2934.75 9.53674e-07
2482.61 9.53674e-07
2756.39 9.53674e-07
3781.21 9.53674e-07
4032.24 9.53674e-07
2826.53 9.53674e-07
2928.98 9.53674e-07
2830.2 9.53674e-07
3158.97 9.53674e-07
4057.71 9.53674e-07
4381.63 9.53674e-07
2556.11 9.53674e-07
2698.4 9.53674e-07
1978.56 9.53674e-07
1505.43 9.53674e-07
2701.96 9.53674e-07
2378.28 9.53674e-07
6118.57 9.53674e-07
6233.81 9.53674e-07
END
$hits1 << END
1221.21 9.53674e-07
1323.37 2.3365e-05
1153.8 9.53674e-07
1467.31 3.29018e-05
1719.29 9.53674e-07
2028.54 3.57628e-05
1287.09 9.53674e-07
1388.5 2.3365e-05
1354.08 9.53674e-07
1787.91 3.29018e-05
1932.7 9.53674e-07
2298.62 3.57628e-05
1235.01 9.53674e-07
1345.52 3.76701e-05
1284.89 9.53674e-07
978.324 0.000572681
1785.43 9.53674e-07
1719.07 0.000368595
3368.25 9.53674e-07
3498.05 7.15256e-06
END
$hits2 << END
2499.66 2.38419e-07
2601.25 2.38419e-07
2284.84 2.38419e-07
2528.39 2.38419e-07
3374.67 2.38419e-07
3622.98 2.38419e-07
2552.92 2.38419e-07
2657.8 2.38419e-07
2616 2.38419e-07
2952.21 2.38419e-07
3689.05 2.38419e-07
3978.87 2.38419e-07
2297.09 2.38419e-07
2432.39 2.38419e-07
1813.24 2.38419e-07
1430.57 2.38419e-07
2471.56 2.38419e-07
2182.93 2.38419e-07
5471.36 2.38419e-07
5706.23 2.38419e-07
648.249 2.38419e-07
1564.29 2.38419e-07
2888.96 2.38419e-07
1605.53 2.38419e-07
2181.7 2.38419e-07
END
$hits3 << END
889.396 2.38419e-07
963.552 2.24113e-05
917.216 2.38419e-07
1213.63 3.19481e-05
1330.92 2.38419e-07
1605.05 3.48091e-05
970.386 2.38419e-07
1056.93 2.24113e-05
1089.22 2.38419e-07
1475.4 3.19481e-05
1540.86 2.38419e-07
1857.49 3.48091e-05
935.267 2.38419e-07
1020.79 3.67165e-05
1003.95 2.38419e-07
771.593 0.000571728
1396.64 2.38419e-07
1347.48 0.000367641
2695.29 2.38419e-07
2833.13 6.19888e-06
END
$hits4 << END
1581.58 1.76606e-07
1637.17 1.76606e-07
1536.96 1.76606e-07
1726.31 1.76606e-07
2258.62 1.76606e-07
2414.47 1.76606e-07
1556.93 1.76606e-07
1626.53 1.76606e-07
1606.59 1.76606e-07
1828.72 1.76606e-07
2306.55 1.76606e-07
2468.68 1.76606e-07
1405.66 1.76606e-07
1491.9 1.76606e-07
1146.74 1.76606e-07
870.344 1.76606e-07
1527.04 1.76606e-07
1320.54 1.76606e-07
3427.44 1.76606e-07
3538.09 1.76606e-07
END
$hits5 << END
532.748 1.76606e-07
576.572 2.24113e-05
576.46 1.76606e-07
777.34 3.19481e-05
814.284 1.76606e-07
972.59 3.48091e-05
570.553 1.76606e-07
615.87 2.24113e-05
623.683 1.76606e-07
832.933 3.19481e-05
875.483 1.76606e-07
1038.95 3.48091e-05
547.15 1.76606e-07
592.619 3.67165e-05
576.161 1.76606e-07
439.591 0.000571728
798.499 1.76606e-07
764.518 0.000367641
1511.79 1.76606e-07
1590.22 6.19888e-06
END
$hits_front << END
5706.23 2.38419e-07
6233.81 9.53674e-07
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
set xrange [1235.9:11439.9]; set yrange [1.38018e-05:0.0057173]
set xlabel 'pictures a second  (more is better)'; set ylabel 'picture: RMSE of a channel  (less is better)' offset -1.5
set xtics ('1500' 1500, '2000' 2000, '3000' 3000, '5000' 5000, '7000' 7000, '10000' 10000)
set ytics ("same\nbits" 3.45046e-05, '10⁻⁴' 1e-4, '10⁻³' 1e-3)
set object rectangle from graph 0, graph 0 to graph 1, first 5.86579e-05 fs solid noborder fc rgb '#eeeeee' behind
set arrow from first 9533.25,0.00135754 to graph 1.0,0.7614 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.7614 to graph 1.015,0.7614 nohead lw 0.8 lc rgb '#999999'
set label 'fast: irregular exact' at graph 1.02,0.7614 left
set arrow from first 8043.76,0.000276037 to graph 1.0,0.4971 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.4971 to graph 1.015,0.4971 nohead lw 0.8 lc rgb '#999999'
set label 'robust: irregular exact' at graph 1.02,0.4971 left
set arrow from first 6268.81,2.5559e-05 to graph 1.0,0.1022 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.1022 to graph 1.015,0.1022 nohead lw 0.8 lc rgb '#999999'
set label 'double: irregular exact' at graph 1.02,0.1022 left
$picture0 << END
5063.19 0.00135754
5510.49 0.00135754
4479 0.00135754
5645.89 0.00135754
6907.6 0.00135754
8282.53 0.00135754
5033.83 0.00135754
5343.71 0.00135754
4075.38 0.00135754
4992.01 0.00135754
6977 0.00135754
8278.15 0.00135754
4683.05 0.00135754
5037.07 0.00135754
4146.76 0.00135754
3270.88 0.00135754
6033.98 0.00135754
6206.55 0.00135754
9191.18 0.00135754
9533.25 0.00135754
END
$picture1 << END
4724.11 0.00135754
5210.94 0.00135754
4230.4 0.00135754
5489.2 0.00135754
6778.74 0.00135754
7923.43 0.00135754
4765.17 0.00135754
5104.54 0.00135754
3923.41 0.00135754
4897.35 0.00135754
6398.44 0.00135754
7424.57 0.00135754
4377.36 0.00135754
4833.72 0.00135754
3905.76 0.00135754
3096.82 0.00167885
5715.07 0.00135754
5798.85 0.00228692
8514.99 0.00135754
8642.15 0.00135754
END
$picture2 << END
4530.96 0.000276037
4936.81 0.000276037
4090.31 0.000276037
5138.11 0.000276037
6258.76 0.000276037
7472.5 0.000276037
4142.91 0.000276037
4566.71 0.000276037
3651.55 0.000276037
4615.27 0.000276037
6125.05 0.000276037
7082.96 0.000276037
4052.13 0.000276037
4558.72 0.000276037
3588.24 0.000276037
2822.43 0.000276037
5242.41 0.000276037
5254.75 0.000276037
8016.93 0.000276037
8043.76 0.000276037
1483.08 0.000276037
3138.18 0.000276037
5296.61 0.000276037
3533.87 0.000276037
3163.28 0.000276037
END
$picture3 << END
3910.65 0.000276037
4158.35 0.000276037
3571.02 0.000276037
4695.72 0.000276037
5245.93 0.000276037
6377.55 0.000276037
3684.27 0.000276037
4092.46 0.000276037
3326.24 0.000276037
4299.08 0.000276037
5035.45 0.000276037
5996.93 0.000276037
3529.48 0.000276037
3884.4 0.000276037
3135.35 0.000276037
2459.86 0.00102558
4428.23 0.000276037
4599.65 0.00186099
7038.29 0.000276037
7358.14 0.000276037
END
$picture4 << END
3203.81 2.5559e-05
3512.42 2.5559e-05
3258.94 2.5559e-05
4287.28 2.5559e-05
4361.48 2.5559e-05
5302.9 2.5559e-05
3143.86 2.5559e-05
3424.28 2.5559e-05
2932.9 2.5559e-05
3720.68 2.5559e-05
4275.55 2.5559e-05
5112.89 2.5559e-05
2975.34 2.5559e-05
3237.67 2.5559e-05
2787.69 2.5559e-05
2196.84 2.5559e-05
3662.25 2.5559e-05
3779.63 2.5559e-05
5967.16 2.5559e-05
6268.81 2.5559e-05
END
$picture5 << END
3087.94 2.5559e-05
3445.42 2.5559e-05
2984.43 2.5559e-05
3910.65 2.5559e-05
3986.99 2.5559e-05
4748.52 2.5559e-05
3048.78 2.5559e-05
3354.08 2.5559e-05
2783.96 2.5559e-05
3564.91 2.5559e-05
3922.43 2.5559e-05
4676.74 2.5559e-05
2891.38 2.5559e-05
3167.76 2.5559e-05
2694.2 2.5559e-05
2114.49 0.000987729
3494.35 2.5559e-05
3646.02 0.0018404
5632.66 2.5559e-05
5821.54 2.5559e-05
END
$picture_front << END
6268.81 2.5559e-05
8043.76 0.000276037
9533.25 0.00135754
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
set xrange [623.106:16518.2]; set yrange [9.53674e-08:0.0170791]
set xlabel 'million nearest hits a second  (more is better)'; set ylabel 'wrong hits  (less is better)' offset -1.5
set label 'tree: speed against accuracy (GPU)' at screen 0.02, screen 0.9774 font ',20'
set label '1024x1024 primary and 1,048,576 random rays a scene; 2,097,152 in all compared with brute force in double; pictures of 512x512' at screen 0.02, screen 0.9516
set xtics ('1000' 1000, '2000' 2000, '5000' 5000, '10000' 10000)
set ytics ("none of\n2,097,152" 2.38419e-07, '0.0001 %%' 1e-6, '0.001 %%' 1e-5, '0.01 %%' 1e-4, '0.1 %%' 1e-3, '1 %%' 1e-2)
set object rectangle from graph 0, graph 0 to graph 1, first 4.05312e-07 fs solid noborder fc rgb '#eeeeee' behind
set arrow from first 13765.2,0.00682402 to graph 1.0,0.9242 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.9242 to graph 1.015,0.9242 nohead lw 0.8 lc rgb '#999999'
set label 'fast, study: irregular exact' at graph 1.02,0.9242 left
set arrow from first 13404.8,0.00126934 to graph 1.0,0.7851 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.7851 to graph 1.015,0.7851 nohead lw 0.8 lc rgb '#999999'
set label 'fast: irregular exact' at graph 1.02,0.7851 left
set arrow from first 11831.7,2.38419e-07 to graph 1.0,0.0758 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.0758 to graph 1.015,0.0758 nohead lw 0.8 lc rgb '#999999'
set label 'robust: irregular exact' at graph 1.02,0.0758 left
$hits0 << END
1563.84 0.00126934
1603.92 0.00126934
2988.15 0.00126934
3076.81 0.00126934
1629.72 0.00126934
1652.95 0.00126934
2503.76 0.00126934
2624.27 0.00126934
1660.19 0.00126934
1711.61 0.00126934
3824.24 0.00126934
4051.18 0.00126934
12767.6 0.00126934
13404.8 0.00126934
END
$hits1 << END
895.57 0.00209665
918.424 0.00218582
1522.68 0.00253057
1564.59 0.00226974
949.715 0.00209665
974.354 0.00218582
1482.68 0.00253057
1529.07 0.00226974
989.297 0.00209713
1012.48 0.00207329
4231.4 0.00177336
4472.23 0.00159454
12487.8 0.00683165
13765.2 0.00682402
END
$hits2 << END
1556.97 2.38419e-07
1599.49 2.38419e-07
2605.49 2.38419e-07
2720.24 2.38419e-07
1588.67 2.38419e-07
1635.7 2.38419e-07
2129.59 2.38419e-07
2214.88 2.38419e-07
1659.52 2.38419e-07
1699.23 2.38419e-07
3526.47 2.38419e-07
3686.35 2.38419e-07
11105.9 2.38419e-07
11831.7 2.38419e-07
965.895 2.38419e-07
1748.98 2.38419e-07
1994.64 2.38419e-07
END
$hits3 << END
886.604 0.000859737
909.237 0.00095129
1363.12 0.00127172
1397.89 0.00100994
941.623 0.000859737
963.241 0.00095129
1331.25 0.00127172
1377.79 0.00100994
1002.32 0.000860214
1016.17 0.000838757
3748.34 0.000521183
3924.78 0.000339508
10719 0.00557613
12158.8 0.00557041
END
$hits4 << END
892.241 1.76606e-07
912.376 1.76606e-07
1824.4 1.76606e-07
1910.61 1.76606e-07
898.751 1.76606e-07
924.814 1.76606e-07
1284.84 1.76606e-07
1330.14 1.76606e-07
979.216 1.76606e-07
1011.26 1.76606e-07
2271.22 1.76606e-07
2401.03 1.76606e-07
7300.43 1.76606e-07
7601.02 1.76606e-07
END
$hits5 << END
999.192 0.00127172
1038.14 0.00100994
747.727 0.00127172
768.246 0.00100994
2119.33 0.000521183
2244 0.000339508
6741 0.00557613
7601.02 0.00557041
END
$hits_front << END
11831.7 2.38419e-07
13404.8 0.00126934
13765.2 0.00682402
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
set xrange [104.699:4833.72]; set yrange [4.99422e-05:0.0739815]
set xlabel 'pictures a second  (more is better)'; set ylabel 'picture: RMSE of a channel  (less is better)' offset -1.5
set xtics ('200' 200, '500' 500, '1000' 1000, '2000' 2000)
set ytics ("same\nbits" 0.000124856, '10⁻³' 1e-3, '10⁻²' 1e-2)
set object rectangle from graph 0, graph 0 to graph 1, first 0.000212255 fs solid noborder fc rgb '#eeeeee' behind
set arrow from first 4028.1,0.0295917 to graph 1.0,0.8745 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.8745 to graph 1.015,0.8745 nohead lw 0.8 lc rgb '#999999'
set label 'fast, study: irregular exact' at graph 1.02,0.8745 left
set arrow from first 4026.54,0.0197771 to graph 1.0,0.8193 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.8193 to graph 1.015,0.8193 nohead lw 0.8 lc rgb '#999999'
set label 'fast: irregular exact' at graph 1.02,0.8193 left
set arrow from first 3193.01,0.000998845 to graph 1.0,0.4103 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.4103 to graph 1.015,0.4103 nohead lw 0.8 lc rgb '#999999'
set label 'robust: irregular exact' at graph 1.02,0.4103 left
set arrow from first 2532.41,9.24856e-05 to graph 1.0,0.0844 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.0844 to graph 1.015,0.0844 nohead lw 0.8 lc rgb '#999999'
set label 'double: irregular exact' at graph 1.02,0.0844 left
$picture0 << END
161.651 0.0197771
164.521 0.0197771
1188.57 0.0197771
1240.33 0.0197771
160.045 0.0197771
161.627 0.0197771
1058.68 0.0197771
1090.18 0.0197771
164.412 0.0197771
168.954 0.0197771
1140.18 0.0197771
1212.18 0.0197771
3626.97 0.0197771
4026.54 0.0197771
END
$picture1 << END
160.078 0.0201229
163.259 0.0201961
1184.61 0.0210265
1241.75 0.0208214
159.981 0.0201229
162.409 0.0201961
1065.64 0.0210265
1102.8 0.0208214
163.858 0.0201229
168.015 0.0201108
1158.01 0.0200881
1201.97 0.0200283
3635.83 0.0295926
4028.1 0.0295917
END
$picture2 << END
165.383 0.000998845
170.776 0.000998845
1047.25 0.000998845
1096.53 0.000998845
160.822 0.000998845
165.833 0.000998845
962.01 0.000998845
991.808 0.000998845
166.928 0.000998845
172.743 0.000998845
1044.7 0.000998845
1076.4 0.000998845
2924.39 0.000998845
3193.01 0.000998845
157.15 0.000998845
266.736 0.000998845
410.068 0.000998845
END
$picture3 << END
166.18 0.00408026
169.612 0.00446055
1067.94 0.00726785
1118.23 0.00665447
162.849 0.00408026
165.612 0.00446055
984.126 0.00726785
1006.73 0.00665447
167.099 0.00408026
172.388 0.00405698
1049.64 0.00376376
1091.47 0.00345327
2948.67 0.0220597
3255.55 0.0220531
END
$picture4 << END
130.067 9.24856e-05
131.369 9.24856e-05
858.376 9.24856e-05
905.035 9.24856e-05
125.639 9.24856e-05
129.058 9.24856e-05
761.765 9.24856e-05
793.286 9.24856e-05
131.689 9.24856e-05
135.897 9.24856e-05
831.711 9.24856e-05
871.103 9.24856e-05
2281.02 9.24856e-05
2532.41 9.24856e-05
END
$picture5 << END
877.955 0.00721073
904.748 0.00658548
779.265 0.00721073
806.575 0.00658548
837.556 0.00365225
872.319 0.00332386
2346.45 0.0220455
2597.46 0.0220357
END
$picture_front << END
2532.41 9.24856e-05
3193.01 0.000998845
4026.54 0.0197771
4028.1 0.0295917
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
set xrange [623.106:16518.2]; set yrange [9.53674e-08:0.0170791]
set xlabel 'million nearest hits a second  (more is better)'; set ylabel 'wrong hits  (less is better)' offset -1.5
set label 'tree: speed against accuracy (GPU)' at screen 0.02, screen 0.9774 font ',20'
set label '1024x1024 primary and 1,048,576 random rays a scene; 2,097,152 in all compared with brute force in double; pictures of 512x512' at screen 0.02, screen 0.9516
set xtics ('1000' 1000, '2000' 2000, '5000' 5000, '10000' 10000)
set ytics ("none of\n2,097,152" 2.38419e-07, '0.0001 %%' 1e-6, '0.001 %%' 1e-5, '0.01 %%' 1e-4, '0.1 %%' 1e-3, '1 %%' 1e-2)
set object rectangle from graph 0, graph 0 to graph 1, first 4.05312e-07 fs solid noborder fc rgb '#eeeeee' behind
set arrow from first 13765.2,0.00682402 to graph 1.0,0.9242 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.9242 to graph 1.015,0.9242 nohead lw 0.8 lc rgb '#999999'
set label 'fast, study: irregular exact' at graph 1.02,0.9242 left
set arrow from first 13404.8,0.00126934 to graph 1.0,0.7851 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.7851 to graph 1.015,0.7851 nohead lw 0.8 lc rgb '#999999'
set label 'fast: irregular exact' at graph 1.02,0.7851 left
set arrow from first 11831.7,2.38419e-07 to graph 1.0,0.0758 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.0758 to graph 1.015,0.0758 nohead lw 0.8 lc rgb '#999999'
set label 'robust: irregular exact' at graph 1.02,0.0758 left
$hits0 << END
1563.84 0.00126934
1603.92 0.00126934
2988.15 0.00126934
3076.81 0.00126934
1629.72 0.00126934
1652.95 0.00126934
2503.76 0.00126934
2624.27 0.00126934
1660.19 0.00126934
1711.61 0.00126934
3824.24 0.00126934
4051.18 0.00126934
12767.6 0.00126934
13404.8 0.00126934
END
$hits1 << END
895.57 0.00209665
918.424 0.00218582
1522.68 0.00253057
1564.59 0.00226974
949.715 0.00209665
974.354 0.00218582
1482.68 0.00253057
1529.07 0.00226974
989.297 0.00209713
1012.48 0.00207329
4231.4 0.00177336
4472.23 0.00159454
12487.8 0.00683165
13765.2 0.00682402
END
$hits2 << END
1556.97 2.38419e-07
1599.49 2.38419e-07
2605.49 2.38419e-07
2720.24 2.38419e-07
1588.67 2.38419e-07
1635.7 2.38419e-07
2129.59 2.38419e-07
2214.88 2.38419e-07
1659.52 2.38419e-07
1699.23 2.38419e-07
3526.47 2.38419e-07
3686.35 2.38419e-07
11105.9 2.38419e-07
11831.7 2.38419e-07
965.895 2.38419e-07
1748.98 2.38419e-07
1994.64 2.38419e-07
END
$hits3 << END
886.604 0.000859737
909.237 0.00095129
1363.12 0.00127172
1397.89 0.00100994
941.623 0.000859737
963.241 0.00095129
1331.25 0.00127172
1377.79 0.00100994
1002.32 0.000860214
1016.17 0.000838757
3748.34 0.000521183
3924.78 0.000339508
10719 0.00557613
12158.8 0.00557041
END
$hits4 << END
892.241 1.76606e-07
912.376 1.76606e-07
1824.4 1.76606e-07
1910.61 1.76606e-07
898.751 1.76606e-07
924.814 1.76606e-07
1284.84 1.76606e-07
1330.14 1.76606e-07
979.216 1.76606e-07
1011.26 1.76606e-07
2271.22 1.76606e-07
2401.03 1.76606e-07
7300.43 1.76606e-07
7601.02 1.76606e-07
END
$hits5 << END
999.192 0.00127172
1038.14 0.00100994
747.727 0.00127172
768.246 0.00100994
2119.33 0.000521183
2244 0.000339508
6741 0.00557613
7601.02 0.00557041
END
$hits_front << END
11831.7 2.38419e-07
13404.8 0.00126934
13765.2 0.00682402
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
set xrange [104.699:4833.72]; set yrange [4.99422e-05:0.0739815]
set xlabel 'pictures a second  (more is better)'; set ylabel 'picture: RMSE of a channel  (less is better)' offset -1.5
set xtics ('200' 200, '500' 500, '1000' 1000, '2000' 2000)
set ytics ("same\nbits" 0.000124856, '10⁻³' 1e-3, '10⁻²' 1e-2)
set object rectangle from graph 0, graph 0 to graph 1, first 0.000212255 fs solid noborder fc rgb '#eeeeee' behind
set arrow from first 4028.1,0.0295917 to graph 1.0,0.8745 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.8745 to graph 1.015,0.8745 nohead lw 0.8 lc rgb '#999999'
set label 'fast, study: irregular exact' at graph 1.02,0.8745 left
set arrow from first 4026.54,0.0197771 to graph 1.0,0.8193 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.8193 to graph 1.015,0.8193 nohead lw 0.8 lc rgb '#999999'
set label 'fast: irregular exact' at graph 1.02,0.8193 left
set arrow from first 3193.01,0.000998845 to graph 1.0,0.4103 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.4103 to graph 1.015,0.4103 nohead lw 0.8 lc rgb '#999999'
set label 'robust: irregular exact' at graph 1.02,0.4103 left
set arrow from first 2532.41,9.24856e-05 to graph 1.0,0.0844 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.0844 to graph 1.015,0.0844 nohead lw 0.8 lc rgb '#999999'
set label 'double: irregular exact' at graph 1.02,0.0844 left
$picture0 << END
161.651 0.0197771
164.521 0.0197771
1188.57 0.0197771
1240.33 0.0197771
160.045 0.0197771
161.627 0.0197771
1058.68 0.0197771
1090.18 0.0197771
164.412 0.0197771
168.954 0.0197771
1140.18 0.0197771
1212.18 0.0197771
3626.97 0.0197771
4026.54 0.0197771
END
$picture1 << END
160.078 0.0201229
163.259 0.0201961
1184.61 0.0210265
1241.75 0.0208214
159.981 0.0201229
162.409 0.0201961
1065.64 0.0210265
1102.8 0.0208214
163.858 0.0201229
168.015 0.0201108
1158.01 0.0200881
1201.97 0.0200283
3635.83 0.0295926
4028.1 0.0295917
END
$picture2 << END
165.383 0.000998845
170.776 0.000998845
1047.25 0.000998845
1096.53 0.000998845
160.822 0.000998845
165.833 0.000998845
962.01 0.000998845
991.808 0.000998845
166.928 0.000998845
172.743 0.000998845
1044.7 0.000998845
1076.4 0.000998845
2924.39 0.000998845
3193.01 0.000998845
157.15 0.000998845
266.736 0.000998845
410.068 0.000998845
END
$picture3 << END
166.18 0.00408026
169.612 0.00446055
1067.94 0.00726785
1118.23 0.00665447
162.849 0.00408026
165.612 0.00446055
984.126 0.00726785
1006.73 0.00665447
167.099 0.00408026
172.388 0.00405698
1049.64 0.00376376
1091.47 0.00345327
2948.67 0.0220597
3255.55 0.0220531
END
$picture4 << END
130.067 9.24856e-05
131.369 9.24856e-05
858.376 9.24856e-05
905.035 9.24856e-05
125.639 9.24856e-05
129.058 9.24856e-05
761.765 9.24856e-05
793.286 9.24856e-05
131.689 9.24856e-05
135.897 9.24856e-05
831.711 9.24856e-05
871.103 9.24856e-05
2281.02 9.24856e-05
2532.41 9.24856e-05
END
$picture5 << END
877.955 0.00721073
904.748 0.00658548
779.265 0.00721073
806.575 0.00658548
837.556 0.00365225
872.319 0.00332386
2346.45 0.0220455
2597.46 0.0220357
END
$picture_front << END
2532.41 9.24856e-05
3193.01 0.000998845
4026.54 0.0197771
4028.1 0.0295917
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
set xrange [528.755:10888.4]; set yrange [1.36239e-08:0.0198679]
set xlabel 'million nearest hits a second  (more is better)'; set ylabel 'wrong hits  (less is better)' offset -1.5
set label 'mean of 7 scenes: speed against accuracy (GPU)' at screen 0.02, screen 0.9774 font ',20'
set label '1024x1024 primary and 1,048,576 random rays a scene; 14,680,064 in all compared with brute force in double; pictures of 512x512' at screen 0.02, screen 0.9516
set xtics ('1000' 1000, '2000' 2000, '5000' 5000, '10000' 10000)
set ytics ("none of\n14,680,064" 3.40598e-08, '0.00001 %%' 1e-7, '0.0001 %%' 1e-6, '0.001 %%' 1e-5, '0.01 %%' 1e-4, '0.1 %%' 1e-3, '1 %%' 1e-2)
set object rectangle from graph 0, graph 0 to graph 1, first 5.79017e-08 fs solid noborder fc rgb '#eeeeee' behind
set arrow from first 9073.65,0.000229699 to graph 1.0,0.6857 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.6857 to graph 1.015,0.6857 nohead lw 0.8 lc rgb '#999999'
set label 'fast: irregular exact' at graph 1.02,0.6857 left
set arrow from first 8115.76,3.40598e-08 to graph 1.0,0.0646 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.0646 to graph 1.015,0.0646 nohead lw 0.8 lc rgb '#999999'
set label 'robust: irregular exact' at graph 1.02,0.0646 left
$hits0 << END
1785.61 0.000229699
1860.67 0.000229699
2534.16 0.000229699
2696.21 0.000229699
3321 0.000229699
3549.76 0.000229699
1805.66 0.000229699
1875.98 0.000229699
2890.35 0.000229699
3111.41 0.000229699
3858.22 0.000229699
4211.57 0.000229699
1745.29 0.000229699
1813.79 0.000229699
2077.78 0.000229699
2088.73 0.000229699
3242.87 0.000229699
3234.8 0.000229699
8242.34 0.000229699
9073.65 0.000229699
END
$hits1 << END
862.447 0.00538867
904.168 0.00519807
1454.17 0.00794717
1604.66 0.00454112
1715.82 0.00585638
1897.43 0.00247186
905.906 0.00538867
951.053 0.00519807
1715.32 0.00794717
1946.96 0.00454112
2085.84 0.00585638
2405.22 0.00247186
888.25 0.00554262
931.881 0.00522232
1313.45 0.00724963
1311.89 0.00561462
2139.98 0.00587109
2138.55 0.0029115
5874.89 0.00589139
6638.35 0.00282662
END
$hits2 << END
1623.96 3.40598e-08
1677.36 3.40598e-08
2328.23 3.40598e-08
2492.05 3.40598e-08
2972.03 3.40598e-08
3206.79 3.40598e-08
1671.64 3.40598e-08
1737.35 3.40598e-08
2666.27 3.40598e-08
2898.26 3.40598e-08
3459.16 3.40598e-08
3779.89 3.40598e-08
1615.83 3.40598e-08
1681.1 3.40598e-08
1930.18 3.40598e-08
1946.17 3.40598e-08
2974.81 3.40598e-08
2961.73 3.40598e-08
7345.21 3.40598e-08
8115.76 3.40598e-08
889.997 3.40598e-08
2532.25 3.40598e-08
1726.16 3.40598e-08
2555.75 3.40598e-08
END
$hits3 << END
731.568 0.00516919
767.378 0.00497798
1273.87 0.00773273
1422.92 0.00432321
1476.07 0.00563785
1647.17 0.00224808
773.839 0.00516919
814.672 0.00497798
1495.61 0.00773273
1710.65 0.00432321
1798 0.00563785
2074.63 0.00224808
761.754 0.00532327
798.752 0.00500216
1130.89 0.00703709
1124.71 0.00539998
1793.36 0.00565297
1783.02 0.00268997
4935.95 0.00567368
5627.36 0.00260305
END
$hits4 << END
978.96 2.52295e-08
1012.59 2.52295e-08
1529.1 2.52295e-08
1659.37 2.52295e-08
2022.51 2.52295e-08
2208.03 2.52295e-08
979.692 2.52295e-08
1020.55 2.52295e-08
1576.03 2.52295e-08
1724.41 2.52295e-08
2061.02 2.52295e-08
2262.64 2.52295e-08
943.155 2.52295e-08
982.891 2.52295e-08
1164.99 2.52295e-08
1154.27 2.52295e-08
1730.51 2.52295e-08
1720.7 2.52295e-08
4407.38 2.52295e-08
4849.14 2.52295e-08
END
$hits5 << END
812.592 0.00773273
927.673 0.00432348
962.881 0.00563792
1091.76 0.00224836
844.678 0.00773273
967.261 0.00432355
1010.94 0.00563792
1161.15 0.00224836
639.004 0.00703771
634.506 0.005401
988.128 0.00565304
973.048 0.00269011
2816.65 0.00567368
3186 0.00260319
END
$hits_front << END
8115.76 3.40598e-08
9073.65 0.000229699
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
set xrange [178.904:3096.91]; set yrange [6.27089e-05:0.0710169]
set xlabel 'pictures a second  (more is better)'; set ylabel 'picture: RMSE of a channel  (less is better)' offset -1.5
set xtics ('200' 200, '300' 300, '500' 500, '700' 700, '1000' 1000, '1500' 1500, '2000' 2000, '3000' 3000)
set ytics ("same\nbits" 0.000156772, '10⁻³' 1e-3, '10⁻²' 1e-2)
set object rectangle from graph 0, graph 0 to graph 1, first 0.000266513 fs solid noborder fc rgb '#eeeeee' behind
set arrow from first 2580.76,0.0123829 to graph 1.0,0.7516 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.7516 to graph 1.015,0.7516 nohead lw 0.8 lc rgb '#999999'
set label 'fast: irregular exact' at graph 1.02,0.7516 left
set arrow from first 2192.89,0.00125418 to graph 1.0,0.4260 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.4260 to graph 1.015,0.4260 nohead lw 0.8 lc rgb '#999999'
set label 'robust: irregular exact' at graph 1.02,0.4260 left
set arrow from first 1643.87,0.000116128 to graph 1.0,0.0876 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.0876 to graph 1.015,0.0876 nohead lw 0.8 lc rgb '#999999'
set label 'double: irregular exact' at graph 1.02,0.0876 left
$picture0 << END
413.413 0.0123829
432.658 0.0123829
644.64 0.0123829
740.066 0.0123829
1146.76 0.0123829
1311.29 0.0123829
418.062 0.0123829
435.137 0.0123829
613.138 0.0123829
706.377 0.0123829
1132.36 0.0123829
1301.12 0.0123829
407.353 0.0123829
430.826 0.0123829
549.014 0.0123829
550.724 0.0123829
1005.18 0.0123829
1059.82 0.0123829
2233.22 0.0123829
2580.76 0.0123829
END
$picture1 << END
398.485 0.0224393
416.644 0.022054
633.302 0.0284068
723.034 0.0216451
1151.42 0.0244547
1313.79 0.0180233
401.134 0.0224393
418.867 0.022054
610.169 0.0284068
696.955 0.0216451
1130.34 0.0244547
1296.04 0.0180233
391.6 0.0224395
413.25 0.0220569
532.134 0.025329
534.288 0.02287
991.212 0.023887
1037.99 0.0183201
2182.04 0.025183
2518.26 0.0193097
END
$picture2 << END
380.333 0.00125418
398.638 0.00125418
596.262 0.00125418
685.098 0.00125418
1032.38 0.00125418
1189.7 0.00125418
371.696 0.00125418
393.145 0.00125418
565.692 0.00125418
653.661 0.00125418
1014.47 0.00125418
1168.72 0.00125418
371.574 0.00125418
388.759 0.00125418
498.827 0.00125418
501.758 0.00125418
902.495 0.00125418
944.113 0.00125418
1917.85 0.00125418
2192.89 0.00125418
214.685 0.00125418
593.466 0.00125418
614.193 0.00125418
672.577 0.00125418
END
$picture3 << END
359.017 0.0189297
375.286 0.0184439
575.379 0.0258172
656.128 0.017932
997.735 0.0213318
1145.46 0.0133386
357.29 0.0189297
374.233 0.0184439
557.195 0.0258172
636.442 0.017932
986.171 0.0213318
1137.74 0.0133386
350.966 0.0189299
367.523 0.0184474
476.429 0.0223219
475.378 0.0194445
867.748 0.0206087
911.442 0.0137241
1869.12 0.0221679
2129.52 0.0150524
END
$picture4 << END
258.194 0.000116128
271.626 0.000116128
451.164 0.000116128
526.752 0.000116128
778.545 0.000116128
910.054 0.000116128
255.545 0.000116128
268.869 0.000116128
429.64 0.000116128
500.227 0.000116128
756.51 0.000116128
884.429 0.000116128
254.59 0.000116128
265.507 0.000116128
369.911 0.000116128
370.34 0.000116128
659.533 0.000116128
696.857 0.000116128
1429.03 0.000116128
1643.87 0.000116128
END
$picture5 << END
438.148 0.0257929
501.372 0.0178971
750.735 0.0213012
863.14 0.0132958
426.65 0.0257929
490.759 0.0178972
745.61 0.0213012
865.974 0.0132958
363.258 0.0222991
362.318 0.0194207
649.004 0.0205768
684.332 0.0136759
1404.2 0.0221386
1587.41 0.0150145
END
$picture_front << END
1643.87 0.000116128
2192.89 0.00125418
2580.76 0.0123829
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
set xrange [528.755:10888.4]; set yrange [1.36239e-08:0.0198679]
set xlabel 'million nearest hits a second  (more is better)'; set ylabel 'wrong hits  (less is better)' offset -1.5
set label 'mean of 7 scenes: speed against accuracy (GPU)' at screen 0.02, screen 0.9774 font ',20'
set label '1024x1024 primary and 1,048,576 random rays a scene; 14,680,064 in all compared with brute force in double; pictures of 512x512' at screen 0.02, screen 0.9516
set xtics ('1000' 1000, '2000' 2000, '5000' 5000, '10000' 10000)
set ytics ("none of\n14,680,064" 3.40598e-08, '0.00001 %%' 1e-7, '0.0001 %%' 1e-6, '0.001 %%' 1e-5, '0.01 %%' 1e-4, '0.1 %%' 1e-3, '1 %%' 1e-2)
set object rectangle from graph 0, graph 0 to graph 1, first 5.79017e-08 fs solid noborder fc rgb '#eeeeee' behind
set arrow from first 9073.65,0.000229699 to graph 1.0,0.6857 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.6857 to graph 1.015,0.6857 nohead lw 0.8 lc rgb '#999999'
set label 'fast: irregular exact' at graph 1.02,0.6857 left
set arrow from first 8115.76,3.40598e-08 to graph 1.0,0.0646 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.0646 to graph 1.015,0.0646 nohead lw 0.8 lc rgb '#999999'
set label 'robust: irregular exact' at graph 1.02,0.0646 left
$hits0 << END
1785.61 0.000229699
1860.67 0.000229699
2534.16 0.000229699
2696.21 0.000229699
3321 0.000229699
3549.76 0.000229699
1805.66 0.000229699
1875.98 0.000229699
2890.35 0.000229699
3111.41 0.000229699
3858.22 0.000229699
4211.57 0.000229699
1745.29 0.000229699
1813.79 0.000229699
2077.78 0.000229699
2088.73 0.000229699
3242.87 0.000229699
3234.8 0.000229699
8242.34 0.000229699
9073.65 0.000229699
END
$hits1 << END
862.447 0.00538867
904.168 0.00519807
1454.17 0.00794717
1604.66 0.00454112
1715.82 0.00585638
1897.43 0.00247186
905.906 0.00538867
951.053 0.00519807
1715.32 0.00794717
1946.96 0.00454112
2085.84 0.00585638
2405.22 0.00247186
888.25 0.00554262
931.881 0.00522232
1313.45 0.00724963
1311.89 0.00561462
2139.98 0.00587109
2138.55 0.0029115
5874.89 0.00589139
6638.35 0.00282662
END
$hits2 << END
1623.96 3.40598e-08
1677.36 3.40598e-08
2328.23 3.40598e-08
2492.05 3.40598e-08
2972.03 3.40598e-08
3206.79 3.40598e-08
1671.64 3.40598e-08
1737.35 3.40598e-08
2666.27 3.40598e-08
2898.26 3.40598e-08
3459.16 3.40598e-08
3779.89 3.40598e-08
1615.83 3.40598e-08
1681.1 3.40598e-08
1930.18 3.40598e-08
1946.17 3.40598e-08
2974.81 3.40598e-08
2961.73 3.40598e-08
7345.21 3.40598e-08
8115.76 3.40598e-08
889.997 3.40598e-08
2532.25 3.40598e-08
1726.16 3.40598e-08
2555.75 3.40598e-08
END
$hits3 << END
731.568 0.00516919
767.378 0.00497798
1273.87 0.00773273
1422.92 0.00432321
1476.07 0.00563785
1647.17 0.00224808
773.839 0.00516919
814.672 0.00497798
1495.61 0.00773273
1710.65 0.00432321
1798 0.00563785
2074.63 0.00224808
761.754 0.00532327
798.752 0.00500216
1130.89 0.00703709
1124.71 0.00539998
1793.36 0.00565297
1783.02 0.00268997
4935.95 0.00567368
5627.36 0.00260305
END
$hits4 << END
978.96 2.52295e-08
1012.59 2.52295e-08
1529.1 2.52295e-08
1659.37 2.52295e-08
2022.51 2.52295e-08
2208.03 2.52295e-08
979.692 2.52295e-08
1020.55 2.52295e-08
1576.03 2.52295e-08
1724.41 2.52295e-08
2061.02 2.52295e-08
2262.64 2.52295e-08
943.155 2.52295e-08
982.891 2.52295e-08
1164.99 2.52295e-08
1154.27 2.52295e-08
1730.51 2.52295e-08
1720.7 2.52295e-08
4407.38 2.52295e-08
4849.14 2.52295e-08
END
$hits5 << END
812.592 0.00773273
927.673 0.00432348
962.881 0.00563792
1091.76 0.00224836
844.678 0.00773273
967.261 0.00432355
1010.94 0.00563792
1161.15 0.00224836
639.004 0.00703771
634.506 0.005401
988.128 0.00565304
973.048 0.00269011
2816.65 0.00567368
3186 0.00260319
END
$hits_front << END
8115.76 3.40598e-08
9073.65 0.000229699
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
set xrange [178.904:3096.91]; set yrange [6.27089e-05:0.0710169]
set xlabel 'pictures a second  (more is better)'; set ylabel 'picture: RMSE of a channel  (less is better)' offset -1.5
set xtics ('200' 200, '300' 300, '500' 500, '700' 700, '1000' 1000, '1500' 1500, '2000' 2000, '3000' 3000)
set ytics ("same\nbits" 0.000156772, '10⁻³' 1e-3, '10⁻²' 1e-2)
set object rectangle from graph 0, graph 0 to graph 1, first 0.000266513 fs solid noborder fc rgb '#eeeeee' behind
set arrow from first 2580.76,0.0123829 to graph 1.0,0.7516 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.7516 to graph 1.015,0.7516 nohead lw 0.8 lc rgb '#999999'
set label 'fast: irregular exact' at graph 1.02,0.7516 left
set arrow from first 2192.89,0.00125418 to graph 1.0,0.4260 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.4260 to graph 1.015,0.4260 nohead lw 0.8 lc rgb '#999999'
set label 'robust: irregular exact' at graph 1.02,0.4260 left
set arrow from first 1643.87,0.000116128 to graph 1.0,0.0876 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.0876 to graph 1.015,0.0876 nohead lw 0.8 lc rgb '#999999'
set label 'double: irregular exact' at graph 1.02,0.0876 left
$picture0 << END
413.413 0.0123829
432.658 0.0123829
644.64 0.0123829
740.066 0.0123829
1146.76 0.0123829
1311.29 0.0123829
418.062 0.0123829
435.137 0.0123829
613.138 0.0123829
706.377 0.0123829
1132.36 0.0123829
1301.12 0.0123829
407.353 0.0123829
430.826 0.0123829
549.014 0.0123829
550.724 0.0123829
1005.18 0.0123829
1059.82 0.0123829
2233.22 0.0123829
2580.76 0.0123829
END
$picture1 << END
398.485 0.0224393
416.644 0.022054
633.302 0.0284068
723.034 0.0216451
1151.42 0.0244547
1313.79 0.0180233
401.134 0.0224393
418.867 0.022054
610.169 0.0284068
696.955 0.0216451
1130.34 0.0244547
1296.04 0.0180233
391.6 0.0224395
413.25 0.0220569
532.134 0.025329
534.288 0.02287
991.212 0.023887
1037.99 0.0183201
2182.04 0.025183
2518.26 0.0193097
END
$picture2 << END
380.333 0.00125418
398.638 0.00125418
596.262 0.00125418
685.098 0.00125418
1032.38 0.00125418
1189.7 0.00125418
371.696 0.00125418
393.145 0.00125418
565.692 0.00125418
653.661 0.00125418
1014.47 0.00125418
1168.72 0.00125418
371.574 0.00125418
388.759 0.00125418
498.827 0.00125418
501.758 0.00125418
902.495 0.00125418
944.113 0.00125418
1917.85 0.00125418
2192.89 0.00125418
214.685 0.00125418
593.466 0.00125418
614.193 0.00125418
672.577 0.00125418
END
$picture3 << END
359.017 0.0189297
375.286 0.0184439
575.379 0.0258172
656.128 0.017932
997.735 0.0213318
1145.46 0.0133386
357.29 0.0189297
374.233 0.0184439
557.195 0.0258172
636.442 0.017932
986.171 0.0213318
1137.74 0.0133386
350.966 0.0189299
367.523 0.0184474
476.429 0.0223219
475.378 0.0194445
867.748 0.0206087
911.442 0.0137241
1869.12 0.0221679
2129.52 0.0150524
END
$picture4 << END
258.194 0.000116128
271.626 0.000116128
451.164 0.000116128
526.752 0.000116128
778.545 0.000116128
910.054 0.000116128
255.545 0.000116128
268.869 0.000116128
429.64 0.000116128
500.227 0.000116128
756.51 0.000116128
884.429 0.000116128
254.59 0.000116128
265.507 0.000116128
369.911 0.000116128
370.34 0.000116128
659.533 0.000116128
696.857 0.000116128
1429.03 0.000116128
1643.87 0.000116128
END
$picture5 << END
438.148 0.0257929
501.372 0.0178971
750.735 0.0213012
863.14 0.0132958
426.65 0.0257929
490.759 0.0178972
745.61 0.0213012
865.974 0.0132958
363.258 0.0222991
362.318 0.0194207
649.004 0.0205768
684.332 0.0136759
1404.2 0.0221386
1587.41 0.0150145
END
$picture_front << END
1643.87 0.000116128
2192.89 0.00125418
2580.76 0.0123829
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
1 39.443
2 14.1773
4 13.8456
8 11.7499
16 9.89635
32 6.41178
64 3.45674
128 2.96294
256 2.87546
END
$chosen0 << END
138.128 1.39117
END
$line1 << END
1 350.537
2 102.444
4 74.4464
8 15.7334
16 4.58906
32 2.37501
64 1.63872
128 1.6231
256 1.48989
END
$chosen1 << END
93.6537 1.04291
END
$line2 << END
1 124.329
2 17.4077
4 6.56515
8 2.04925
16 0.994368
32 0.746784
64 0.91696
128 1.55293
256 1.39526
END
$chosen2 << END
43.323 0.786048
END
$line3 << END
1 84.8913
2 31.1784
4 17.0499
8 5.5935
16 2.7392
32 1.81974
64 1.92925
128 2.77834
256 2.85994
END
$chosen3 << END
50.6645 1.80413
END
$line4 << END
1 54.8518
2 23.1941
4 14.9092
8 6.10432
16 3.00067
32 1.5513
64 1.2361
128 1.37782
256 1.21878
END
$chosen4 << END
50.4685 1.18051
END
$line5 << END
1 5.21101
2 1.77565
4 0.674272
8 0.318656
16 0.20256
32 0.1888
64 0.194624
128 0.282976
256 0.316128
END
$chosen5 << END
30 0.133824
END
$line6 << END
1 40.6277
2 16.3407
4 13.0248
8 11.5423
16 8.31392
32 6.36333
64 5.85562
128 3.74902
256 2.43862
END
$chosen6 << END
278.218 0.911968
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
set xrange [0.909091:306.04]; set yrange [0.102942:455.698]
set xlabel 'voxels an axis'; set ylabel 'ms a picture'
set xtics (1, 2, 4, 8, 16, 32, 64, 128, 256, 512, 1024)
set ytics ('1' 1, '10' 10, '100' 100)
set arrow from first 16, graph 0 to first 16, graph 1 nohead lw 1.5 dt '-' lc rgb '#444444'
set label '16: what the founding study found enough' at first 16, graph 0.97 offset 1,0 left
set arrow from first 256,2.87546 to graph 1.0,0.5194 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.5194 to graph 1.015,0.5194 nohead lw 0.8 lc rgb '#999999'
set label 'balls' at graph 1.02,0.5194 left
set arrow from first 256,1.48989 to graph 1.0,0.3844 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.3844 to graph 1.015,0.3844 nohead lw 0.8 lc rgb '#999999'
set label 'gears' at graph 1.02,0.3844 left
set arrow from first 256,1.39526 to graph 1.0,0.3394 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.3394 to graph 1.015,0.3394 nohead lw 0.8 lc rgb '#999999'
set label 'mount' at graph 1.02,0.3394 left
set arrow from first 256,2.85994 to graph 1.0,0.4744 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.4744 to graph 1.015,0.4744 nohead lw 0.8 lc rgb '#999999'
set label 'rings' at graph 1.02,0.4744 left
set arrow from first 256,1.21878 to graph 1.0,0.2944 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.2944 to graph 1.015,0.2944 nohead lw 0.8 lc rgb '#999999'
set label 'teapot' at graph 1.02,0.2944 left
set arrow from first 256,0.316128 to graph 1.0,0.1336 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.1336 to graph 1.015,0.1336 nohead lw 0.8 lc rgb '#999999'
set label 'tetra' at graph 1.02,0.1336 left
set arrow from first 256,2.43862 to graph 1.0,0.4294 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.4294 to graph 1.015,0.4294 nohead lw 0.8 lc rgb '#999999'
set label 'tree' at graph 1.02,0.4294 left
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
set xrange [0.909091:306.04]; set yrange [0.102942:455.698]
set xlabel 'voxels an axis'; set ylabel 'ms a picture'
set xtics (1, 2, 4, 8, 16, 32, 64, 128, 256, 512, 1024)
set ytics ('1' 1, '10' 10, '100' 100)
set arrow from first 16, graph 0 to first 16, graph 1 nohead lw 1.5 dt '-' lc rgb '#444444'
set label '16: what the founding study found enough' at first 16, graph 0.97 offset 1,0 left
set arrow from first 256,2.87546 to graph 1.0,0.5194 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.5194 to graph 1.015,0.5194 nohead lw 0.8 lc rgb '#999999'
set label 'balls' at graph 1.02,0.5194 left
set arrow from first 256,1.48989 to graph 1.0,0.3844 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.3844 to graph 1.015,0.3844 nohead lw 0.8 lc rgb '#999999'
set label 'gears' at graph 1.02,0.3844 left
set arrow from first 256,1.39526 to graph 1.0,0.3394 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.3394 to graph 1.015,0.3394 nohead lw 0.8 lc rgb '#999999'
set label 'mount' at graph 1.02,0.3394 left
set arrow from first 256,2.85994 to graph 1.0,0.4744 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.4744 to graph 1.015,0.4744 nohead lw 0.8 lc rgb '#999999'
set label 'rings' at graph 1.02,0.4744 left
set arrow from first 256,1.21878 to graph 1.0,0.2944 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.2944 to graph 1.015,0.2944 nohead lw 0.8 lc rgb '#999999'
set label 'teapot' at graph 1.02,0.2944 left
set arrow from first 256,0.316128 to graph 1.0,0.1336 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.1336 to graph 1.015,0.1336 nohead lw 0.8 lc rgb '#999999'
set label 'tetra' at graph 1.02,0.1336 left
set arrow from first 256,2.43862 to graph 1.0,0.4294 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.4294 to graph 1.015,0.4294 nohead lw 0.8 lc rgb '#999999'
set label 'tree' at graph 1.02,0.4294 left
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
