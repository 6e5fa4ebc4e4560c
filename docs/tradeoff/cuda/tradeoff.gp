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
set xrange [569.678:15845.9]; set yrange [9.53674e-08:0.072608]
set xlabel 'million nearest hits a second  (more is better)'; set ylabel 'wrong hits  (less is better)' offset -1.5
set label 'balls: speed against accuracy (GPU)' at screen 0.02, screen 0.9774 font ',20'
set label '1024x1024 primary and 1,048,576 random rays a scene; 2,097,152 in all compared with brute force in double; pictures of 512x512' at screen 0.02, screen 0.9516
set xtics ('1000' 1000, '2000' 2000, '5000' 5000, '10000' 10000)
set ytics ("none of\n2,097,152" 2.38419e-07, '0.0001 %%' 1e-6, '0.001 %%' 1e-5, '0.01 %%' 1e-4, '0.1 %%' 1e-3, '1 %%' 1e-2)
set object rectangle from graph 0, graph 0 to graph 1, first 4.05312e-07 fs solid noborder fc rgb '#eeeeee' behind
set arrow from first 13204.9,0.00206089 to graph 1.0,0.7370 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.7370 to graph 1.015,0.7370 nohead lw 0.8 lc rgb '#999999'
set label 'fast, study: irregular exact' at graph 1.02,0.7370 left
set arrow from first 12918.6,7.86781e-05 to graph 1.0,0.4959 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.4959 to graph 1.015,0.4959 nohead lw 0.8 lc rgb '#999999'
set label 'fast: irregular exact' at graph 1.02,0.4959 left
set arrow from first 12040.4,2.38419e-07 to graph 1.0,0.0677 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.0677 to graph 1.015,0.0677 nohead lw 0.8 lc rgb '#999999'
set label 'robust: irregular exact' at graph 1.02,0.0677 left
$hits0 << END
734.132 7.86781e-05
729.54 7.86781e-05
2759.29 7.86781e-05
2807.04 7.86781e-05
3572.03 7.86781e-05
3635.03 7.86781e-05
757.484 7.86781e-05
757.887 7.86781e-05
2958.07 7.86781e-05
2996.75 7.86781e-05
5134.44 7.86781e-05
5341.59 7.86781e-05
756.679 7.86781e-05
756.208 7.86781e-05
2998.26 7.86781e-05
3054.44 7.86781e-05
6709.25 7.86781e-05
6677.81 7.86781e-05
11970 7.86781e-05
12918.6 7.86781e-05
END
$hits1 << END
1699.28 0.0290365
1712.42 0.0187826
1700.42 0.0146103
1737.99 0.00238228
1958.17 0.0290365
1965.8 0.0187826
2449.3 0.0146103
2752.8 0.00238228
1978.33 0.0290432
1956.24 0.018836
5356.87 0.0205107
5224.49 0.00504303
12435.7 0.0118799
13204.9 0.00206089
END
$hits2 << END
684.228 2.38419e-07
683.614 2.38419e-07
2592.4 2.38419e-07
2628.17 2.38419e-07
3331.44 2.38419e-07
3399.88 2.38419e-07
691.293 2.38419e-07
692.17 2.38419e-07
2770.26 2.38419e-07
2831.79 2.38419e-07
4729.45 2.38419e-07
4955.09 2.38419e-07
691.272 2.38419e-07
687.753 2.38419e-07
2805.84 2.38419e-07
2846.3 2.38419e-07
6180.89 2.38419e-07
6198.43 2.38419e-07
11160.8 2.38419e-07
12040.4 2.38419e-07
1878.04 2.38419e-07
1952.45 2.38419e-07
2392.79 2.38419e-07
END
$hits3 << END
1578.91 0.0289831
1598.79 0.0187221
1544.02 0.0145469
1590.26 0.00230742
1772.2 0.0289831
1790.06 0.0187221
2256.05 0.0145469
2520.71 0.00230742
1801.48 0.0289898
1774.41 0.0187755
4703.65 0.0204487
4615.21 0.00497007
10844.9 0.0118194
11734.3 0.00199032
END
$hits4 << END
1658.01 1.76606e-07
1700.2 1.76606e-07
2448.75 1.76606e-07
2546.27 1.76606e-07
1640.61 1.76606e-07
1676.5 1.76606e-07
2914.4 1.76606e-07
3072.48 1.76606e-07
1620.17 1.76606e-07
1639.67 1.76606e-07
3491.34 1.76606e-07
3513.24 1.76606e-07
7203.34 1.76606e-07
7662.34 1.76606e-07
END
$hits5 << END
1039.31 0.0289831
1045.56 0.0187221
1103.47 0.0145473
1155.37 0.00230789
1025.59 0.0289831
1031.19 0.0187221
1373.57 0.0145473
1507.27 0.00230789
1002.2 0.0289898
985.756 0.0187755
2485.34 0.0204492
2448.3 0.00497055
6421.32 0.0118194
6830.94 0.0019908
END
$hits_front << END
12040.4 2.38419e-07
12918.6 7.86781e-05
13204.9 0.00206089
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
set xrange [81.721:2487.23]; set yrange [0.00011954:0.115364]
set xlabel 'pictures a second  (more is better)'; set ylabel 'picture: RMSE of a channel  (less is better)' offset -1.5
set xtics ('100' 100, '200' 200, '500' 500, '1000' 1000, '2000' 2000)
set ytics ("same\nbits" 0.00029885, '10⁻³' 1e-3, '10⁻²' 1e-2, '10⁻¹' 1e-1)
set object rectangle from graph 0, graph 0 to graph 1, first 0.000508045 fs solid noborder fc rgb '#eeeeee' behind
set arrow from first 2072.69,0.00827507 to graph 1.0,0.6166 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.6166 to graph 1.015,0.6166 nohead lw 0.8 lc rgb '#999999'
set label 'fast: irregular exact' at graph 1.02,0.6166 left
set arrow from first 1963.8,0.0023908 to graph 1.0,0.4359 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.4359 to graph 1.015,0.4359 nohead lw 0.8 lc rgb '#999999'
set label 'robust: irregular exact' at graph 1.02,0.4359 left
set arrow from first 1346.34,0.00022137 to graph 1.0,0.0897 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.0897 to graph 1.015,0.0897 nohead lw 0.8 lc rgb '#999999'
set label 'double: irregular exact' at graph 1.02,0.0897 left
$picture0 << END
102.137 0.00827507
102.841 0.00827507
289.057 0.00827507
292.982 0.00827507
710.081 0.00827507
760.543 0.00827507
102.336 0.00827507
102.603 0.00827507
270.198 0.00827507
279.202 0.00827507
778.137 0.00827507
819.995 0.00827507
99.9231 0.00827507
103.394 0.00827507
275.889 0.00827507
282.657 0.00827507
989.452 0.00827507
1030.88 0.00827507
1919.42 0.00827507
2072.69 0.00827507
END
$picture1 << END
255.142 0.0461457
259.141 0.03628
733.826 0.0314662
751.456 0.0143082
248.006 0.0461457
246.207 0.03628
795.551 0.0314662
834.07 0.0143082
251.085 0.0461456
252.576 0.0363124
964.209 0.0379616
963.642 0.019923
1780.93 0.0287262
2013.66 0.013948
END
$picture2 << END
98.0652 0.0023908
99.8173 0.0023908
280.403 0.0023908
288.815 0.0023908
683.943 0.0023908
733.498 0.0023908
101.47 0.0023908
99.2497 0.0023908
265.199 0.0023908
276.602 0.0023908
742.986 0.0023908
784.665 0.0023908
101.088 0.0023908
101.774 0.0023908
273.813 0.0023908
279.247 0.0023908
971.251 0.0023908
998.343 0.0023908
1816.65 0.0023908
1963.8 0.0023908
153.931 0.0023908
338.71 0.0023908
362.996 0.0023908
END
$picture3 << END
258.395 0.0456436
259.001 0.0355789
700.03 0.0305959
701.459 0.0119635
245.441 0.0456436
245.784 0.0355789
758.035 0.0305959
770.618 0.0119635
248.256 0.0456439
250.515 0.0356138
911.56 0.0372451
917.953 0.0183509
1680.11 0.0277669
1867.79 0.0115891
END
$picture4 << END
192.921 0.00022137
198.118 0.00022137
507.066 0.00022137
544.834 0.00022137
185.636 0.00022137
189.254 0.00022137
515.584 0.00022137
562.74 0.00022137
188.305 0.00022137
192.303 0.00022137
657.341 0.00022137
675.324 0.00022137
1260.33 0.00022137
1346.34 0.00022137
END
$picture5 << END
175.124 0.0456007
174.063 0.0355195
449.182 0.0305118
469.325 0.0117333
169.673 0.0456007
169.015 0.0355195
504.276 0.0305118
524.954 0.0117333
171.322 0.045601
170.453 0.0355545
598.018 0.0371784
605.045 0.0182034
1174.64 0.0276717
1242.59 0.0113399
END
$picture_front << END
1346.34 0.00022137
1963.8 0.0023908
2072.69 0.00827507
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
set xrange [569.678:15845.9]; set yrange [9.53674e-08:0.072608]
set xlabel 'million nearest hits a second  (more is better)'; set ylabel 'wrong hits  (less is better)' offset -1.5
set label 'balls: speed against accuracy (GPU)' at screen 0.02, screen 0.9774 font ',20'
set label '1024x1024 primary and 1,048,576 random rays a scene; 2,097,152 in all compared with brute force in double; pictures of 512x512' at screen 0.02, screen 0.9516
set xtics ('1000' 1000, '2000' 2000, '5000' 5000, '10000' 10000)
set ytics ("none of\n2,097,152" 2.38419e-07, '0.0001 %%' 1e-6, '0.001 %%' 1e-5, '0.01 %%' 1e-4, '0.1 %%' 1e-3, '1 %%' 1e-2)
set object rectangle from graph 0, graph 0 to graph 1, first 4.05312e-07 fs solid noborder fc rgb '#eeeeee' behind
set arrow from first 13204.9,0.00206089 to graph 1.0,0.7370 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.7370 to graph 1.015,0.7370 nohead lw 0.8 lc rgb '#999999'
set label 'fast, study: irregular exact' at graph 1.02,0.7370 left
set arrow from first 12918.6,7.86781e-05 to graph 1.0,0.4959 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.4959 to graph 1.015,0.4959 nohead lw 0.8 lc rgb '#999999'
set label 'fast: irregular exact' at graph 1.02,0.4959 left
set arrow from first 12040.4,2.38419e-07 to graph 1.0,0.0677 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.0677 to graph 1.015,0.0677 nohead lw 0.8 lc rgb '#999999'
set label 'robust: irregular exact' at graph 1.02,0.0677 left
$hits0 << END
734.132 7.86781e-05
729.54 7.86781e-05
2759.29 7.86781e-05
2807.04 7.86781e-05
3572.03 7.86781e-05
3635.03 7.86781e-05
757.484 7.86781e-05
757.887 7.86781e-05
2958.07 7.86781e-05
2996.75 7.86781e-05
5134.44 7.86781e-05
5341.59 7.86781e-05
756.679 7.86781e-05
756.208 7.86781e-05
2998.26 7.86781e-05
3054.44 7.86781e-05
6709.25 7.86781e-05
6677.81 7.86781e-05
11970 7.86781e-05
12918.6 7.86781e-05
END
$hits1 << END
1699.28 0.0290365
1712.42 0.0187826
1700.42 0.0146103
1737.99 0.00238228
1958.17 0.0290365
1965.8 0.0187826
2449.3 0.0146103
2752.8 0.00238228
1978.33 0.0290432
1956.24 0.018836
5356.87 0.0205107
5224.49 0.00504303
12435.7 0.0118799
13204.9 0.00206089
END
$hits2 << END
684.228 2.38419e-07
683.614 2.38419e-07
2592.4 2.38419e-07
2628.17 2.38419e-07
3331.44 2.38419e-07
3399.88 2.38419e-07
691.293 2.38419e-07
692.17 2.38419e-07
2770.26 2.38419e-07
2831.79 2.38419e-07
4729.45 2.38419e-07
4955.09 2.38419e-07
691.272 2.38419e-07
687.753 2.38419e-07
2805.84 2.38419e-07
2846.3 2.38419e-07
6180.89 2.38419e-07
6198.43 2.38419e-07
11160.8 2.38419e-07
12040.4 2.38419e-07
1878.04 2.38419e-07
1952.45 2.38419e-07
2392.79 2.38419e-07
END
$hits3 << END
1578.91 0.0289831
1598.79 0.0187221
1544.02 0.0145469
1590.26 0.00230742
1772.2 0.0289831
1790.06 0.0187221
2256.05 0.0145469
2520.71 0.00230742
1801.48 0.0289898
1774.41 0.0187755
4703.65 0.0204487
4615.21 0.00497007
10844.9 0.0118194
11734.3 0.00199032
END
$hits4 << END
1658.01 1.76606e-07
1700.2 1.76606e-07
2448.75 1.76606e-07
2546.27 1.76606e-07
1640.61 1.76606e-07
1676.5 1.76606e-07
2914.4 1.76606e-07
3072.48 1.76606e-07
1620.17 1.76606e-07
1639.67 1.76606e-07
3491.34 1.76606e-07
3513.24 1.76606e-07
7203.34 1.76606e-07
7662.34 1.76606e-07
END
$hits5 << END
1039.31 0.0289831
1045.56 0.0187221
1103.47 0.0145473
1155.37 0.00230789
1025.59 0.0289831
1031.19 0.0187221
1373.57 0.0145473
1507.27 0.00230789
1002.2 0.0289898
985.756 0.0187755
2485.34 0.0204492
2448.3 0.00497055
6421.32 0.0118194
6830.94 0.0019908
END
$hits_front << END
12040.4 2.38419e-07
12918.6 7.86781e-05
13204.9 0.00206089
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
set xrange [81.721:2487.23]; set yrange [0.00011954:0.115364]
set xlabel 'pictures a second  (more is better)'; set ylabel 'picture: RMSE of a channel  (less is better)' offset -1.5
set xtics ('100' 100, '200' 200, '500' 500, '1000' 1000, '2000' 2000)
set ytics ("same\nbits" 0.00029885, '10⁻³' 1e-3, '10⁻²' 1e-2, '10⁻¹' 1e-1)
set object rectangle from graph 0, graph 0 to graph 1, first 0.000508045 fs solid noborder fc rgb '#eeeeee' behind
set arrow from first 2072.69,0.00827507 to graph 1.0,0.6166 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.6166 to graph 1.015,0.6166 nohead lw 0.8 lc rgb '#999999'
set label 'fast: irregular exact' at graph 1.02,0.6166 left
set arrow from first 1963.8,0.0023908 to graph 1.0,0.4359 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.4359 to graph 1.015,0.4359 nohead lw 0.8 lc rgb '#999999'
set label 'robust: irregular exact' at graph 1.02,0.4359 left
set arrow from first 1346.34,0.00022137 to graph 1.0,0.0897 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.0897 to graph 1.015,0.0897 nohead lw 0.8 lc rgb '#999999'
set label 'double: irregular exact' at graph 1.02,0.0897 left
$picture0 << END
102.137 0.00827507
102.841 0.00827507
289.057 0.00827507
292.982 0.00827507
710.081 0.00827507
760.543 0.00827507
102.336 0.00827507
102.603 0.00827507
270.198 0.00827507
279.202 0.00827507
778.137 0.00827507
819.995 0.00827507
99.9231 0.00827507
103.394 0.00827507
275.889 0.00827507
282.657 0.00827507
989.452 0.00827507
1030.88 0.00827507
1919.42 0.00827507
2072.69 0.00827507
END
$picture1 << END
255.142 0.0461457
259.141 0.03628
733.826 0.0314662
751.456 0.0143082
248.006 0.0461457
246.207 0.03628
795.551 0.0314662
834.07 0.0143082
251.085 0.0461456
252.576 0.0363124
964.209 0.0379616
963.642 0.019923
1780.93 0.0287262
2013.66 0.013948
END
$picture2 << END
98.0652 0.0023908
99.8173 0.0023908
280.403 0.0023908
288.815 0.0023908
683.943 0.0023908
733.498 0.0023908
101.47 0.0023908
99.2497 0.0023908
265.199 0.0023908
276.602 0.0023908
742.986 0.0023908
784.665 0.0023908
101.088 0.0023908
101.774 0.0023908
273.813 0.0023908
279.247 0.0023908
971.251 0.0023908
998.343 0.0023908
1816.65 0.0023908
1963.8 0.0023908
153.931 0.0023908
338.71 0.0023908
362.996 0.0023908
END
$picture3 << END
258.395 0.0456436
259.001 0.0355789
700.03 0.0305959
701.459 0.0119635
245.441 0.0456436
245.784 0.0355789
758.035 0.0305959
770.618 0.0119635
248.256 0.0456439
250.515 0.0356138
911.56 0.0372451
917.953 0.0183509
1680.11 0.0277669
1867.79 0.0115891
END
$picture4 << END
192.921 0.00022137
198.118 0.00022137
507.066 0.00022137
544.834 0.00022137
185.636 0.00022137
189.254 0.00022137
515.584 0.00022137
562.74 0.00022137
188.305 0.00022137
192.303 0.00022137
657.341 0.00022137
675.324 0.00022137
1260.33 0.00022137
1346.34 0.00022137
END
$picture5 << END
175.124 0.0456007
174.063 0.0355195
449.182 0.0305118
469.325 0.0117333
169.673 0.0456007
169.015 0.0355195
504.276 0.0305118
524.954 0.0117333
171.322 0.045601
170.453 0.0355545
598.018 0.0371784
605.045 0.0182034
1174.64 0.0276717
1242.59 0.0113399
END
$picture_front << END
1346.34 0.00022137
1963.8 0.0023908
2072.69 0.00827507
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
set xrange [476.947:13022.5]; set yrange [9.53674e-08:0.00213861]
set xlabel 'million nearest hits a second  (more is better)'; set ylabel 'wrong hits  (less is better)' offset -1.5
set label 'gears: speed against accuracy (GPU)' at screen 0.02, screen 0.9774 font ',20'
set label '1024x1024 primary and 1,048,576 random rays a scene; 2,097,152 in all compared with brute force in double; pictures of 512x512' at screen 0.02, screen 0.9516
set xtics ('500' 500, '1000' 1000, '2000' 2000, '5000' 5000, '10000' 10000)
set ytics ("none of\n2,097,152" 2.38419e-07, '0.0001 %%' 1e-6, '0.001 %%' 1e-5, '0.01 %%' 1e-4, '0.1 %%' 1e-3)
set object rectangle from graph 0, graph 0 to graph 1, first 4.05312e-07 fs solid noborder fc rgb '#eeeeee' behind
set arrow from first 10852.1,3.21865e-07 to graph 1.0,0.1214 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.1214 to graph 1.015,0.1214 nohead lw 0.8 lc rgb '#999999'
set label 'fast: irregular exact' at graph 1.02,0.1214 left
$hits0 << END
1946.31 3.21865e-07
2003.85 3.21865e-07
3621.57 3.21865e-07
3795.89 3.21865e-07
3773.59 3.21865e-07
4026.05 3.21865e-07
1857.23 3.21865e-07
1901.63 3.21865e-07
3811.12 3.21865e-07
3906.3 3.21865e-07
4615.86 3.21865e-07
4882 3.21865e-07
1921.71 3.21865e-07
1918.28 3.21865e-07
4290.97 3.21865e-07
4482.93 3.21865e-07
4752.77 3.21865e-07
3873.06 3.21865e-07
8198.15 3.21865e-07
10852.1 3.21865e-07
END
$hits1 << END
708.942 0.000182629
736.641 0.000171185
1825.62 0.000133038
1951.7 6.19888e-05
1694.58 0.00069952
1844.21 0.000184536
720.318 0.000182629
749.026 0.000171185
2023.65 0.000133038
2194.41 6.19888e-05
2285.95 0.00069952
2607.15 0.000184536
737.204 0.000182629
751.887 0.000171185
2296.21 0.000366688
2401.2 6.34193e-05
2113.31 0.000855446
1659.98 0.000384808
6534 0.000231743
7719.2 5.53131e-05
END
$hits2 << END
1668.39 2.38419e-07
1728.63 2.38419e-07
3254.34 2.38419e-07
3406.59 2.38419e-07
3495.63 2.38419e-07
3736.59 2.38419e-07
1697.65 2.38419e-07
1734.86 2.38419e-07
3559.61 2.38419e-07
3731.27 2.38419e-07
4271.95 2.38419e-07
4633.81 2.38419e-07
1738.08 2.38419e-07
1743.07 2.38419e-07
3870.77 2.38419e-07
4055.95 2.38419e-07
4447.64 2.38419e-07
3676.02 2.38419e-07
8150.23 2.38419e-07
10048.5 2.38419e-07
3105.38 2.38419e-07
2412.25 2.38419e-07
3933.26 2.38419e-07
END
$hits3 << END
572.337 0.000182629
587.145 0.000171185
1519.18 0.000133038
1635.95 6.19888e-05
1503.91 0.00069952
1665.97 0.000184536
581.245 0.000182629
607.845 0.000171185
1673.16 0.000133038
1852.61 6.19888e-05
1972.43 0.00069952
2280.07 0.000184536
600.24 0.000182629
613.099 0.000171185
1922.67 0.000366688
1973.62 6.34193e-05
1732.56 0.000855446
1321.37 0.000384808
5416.65 0.000231743
6615.12 5.53131e-05
END
$hits4 << END
1053.41 1.76606e-07
1083.9 1.76606e-07
2179.3 1.76606e-07
2313.31 1.76606e-07
2392.61 1.76606e-07
2571.96 1.76606e-07
1010.25 1.76606e-07
1040.27 1.76606e-07
2106.52 1.76606e-07
2244 1.76606e-07
2550.73 1.76606e-07
2771.08 1.76606e-07
1062.9 1.76606e-07
1040.15 1.76606e-07
2399.53 1.76606e-07
2447.93 1.76606e-07
2563.2 1.76606e-07
2072.09 1.76606e-07
5274.95 1.76606e-07
5969.21 1.76606e-07
END
$hits5 << END
956.548 0.000133038
1037.16 6.19888e-05
1024.4 0.00069952
1148.77 0.000184536
944.296 0.000133038
1029.97 6.19888e-05
1143.06 0.00069952
1301.51 0.000184536
1102.2 0.000366688
1112.27 6.34193e-05
988.924 0.000855446
719.693 0.000384808
3195.63 0.000231743
3690.51 5.53131e-05
END
$hits_front << END
10852.1 3.21865e-07
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
set xrange [120.921:2498]; set yrange [7.86585e-05:0.0151955]
set xlabel 'pictures a second  (more is better)'; set ylabel 'picture: RMSE of a channel  (less is better)' offset -1.5
set xtics ('200' 200, '500' 500, '1000' 1000, '2000' 2000)
set ytics ("same\nbits" 0.000196646, '10⁻³' 1e-3, '10⁻²' 1e-2)
set object rectangle from graph 0, graph 0 to graph 1, first 0.000334299 fs solid noborder fc rgb '#eeeeee' behind
set arrow from first 2081.67,0.0036314 to graph 1.0,0.7281 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.7281 to graph 1.015,0.7281 nohead lw 0.8 lc rgb '#999999'
set label 'fast: irregular exact' at graph 1.02,0.7281 left
set arrow from first 1690.83,0.00160758 to graph 1.0,0.5732 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.5732 to graph 1.015,0.5732 nohead lw 0.8 lc rgb '#999999'
set label 'robust: irregular exact' at graph 1.02,0.5732 left
set arrow from first 1306.93,0.000145664 to graph 1.0,0.1171 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.1171 to graph 1.015,0.1171 nohead lw 0.8 lc rgb '#999999'
set label 'double: irregular exact' at graph 1.02,0.1171 left
$picture0 << END
259.614 0.0036314
271.541 0.0036314
624.727 0.0036314
689.57 0.0036314
949.037 0.0036314
1092.92 0.0036314
262.495 0.0036314
270.453 0.0036314
592.407 0.0036314
645.77 0.0036314
893.647 0.0036314
1021.11 0.0036314
274.005 0.0036314
275.018 0.0036314
727.744 0.0036314
693.505 0.0036314
753.704 0.0036314
755.561 0.0036314
1686.27 0.0036314
2081.67 0.0036314
END
$picture1 << END
245.042 0.00473662
252.226 0.00475973
591.586 0.00396118
658.545 0.00436168
906.668 0.006064
1073.99 0.00475632
245.597 0.00473662
248.343 0.00475973
552.55 0.00396118
610.255 0.00436168
856.282 0.006064
967.399 0.00475632
247.619 0.00473662
255.073 0.00475973
678.417 0.00438677
661.629 0.00436168
691.324 0.00607821
706.404 0.00554194
1559.3 0.00401656
1975.22 0.0040382
END
$picture2 << END
212.008 0.00160758
215.581 0.00160758
547.411 0.00160758
601.008 0.00160758
820.769 0.00160758
959.325 0.00160758
209.048 0.00160758
212.732 0.00160758
503.976 0.00160758
552.209 0.00160758
782.583 0.00160758
898.424 0.00160758
213.791 0.00160758
218.191 0.00160758
578.928 0.00160758
589.289 0.00160758
617.944 0.00160758
633.413 0.00160758
1410.07 0.00160758
1690.83 0.00160758
414.941 0.00160758
622.51 0.00160758
694.536 0.00160758
END
$picture3 << END
192.373 0.00344683
198.887 0.00347858
487.42 0.00223184
551.089 0.00289851
743.251 0.00515237
889.933 0.00346756
191.566 0.00344683
198.54 0.00347858
478.078 0.00223184
523.758 0.00289851
735.83 0.00515237
831.449 0.00346756
194.816 0.00344683
200.601 0.00347858
535.82 0.00292125
544.093 0.00289851
578.777 0.00517295
572.073 0.0044849
1280.79 0.00235013
1599.2 0.00238596
END
$picture4 << END
150.302 0.000145664
152.394 0.000145664
388.715 0.000145664
442.729 0.000145664
627.963 0.000145664
760.508 0.000145664
145.105 0.000145664
150.603 0.000145664
370.656 0.000145664
410.024 0.000145664
589.88 0.000145664
697.126 0.000145664
159.341 0.000145664
153.643 0.000145664
426.045 0.000145664
416.455 0.000145664
453.319 0.000145664
455.334 0.000145664
1040.59 0.000145664
1306.93 0.000145664
END
$picture5 << END
376.333 0.00157317
412.7 0.00241185
584.331 0.00489516
690.06 0.0030724
348.26 0.00157317
389.85 0.00241185
565.62 0.00489516
658.02 0.0030724
411 0.00245508
392.924 0.00241185
432.216 0.00491682
428.934 0.00418689
988.24 0.0017136
1241.31 0.00176242
END
$picture_front << END
1306.93 0.000145664
1690.83 0.00160758
2081.67 0.0036314
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
set xrange [476.947:13022.5]; set yrange [9.53674e-08:0.00213861]
set xlabel 'million nearest hits a second  (more is better)'; set ylabel 'wrong hits  (less is better)' offset -1.5
set label 'gears: speed against accuracy (GPU)' at screen 0.02, screen 0.9774 font ',20'
set label '1024x1024 primary and 1,048,576 random rays a scene; 2,097,152 in all compared with brute force in double; pictures of 512x512' at screen 0.02, screen 0.9516
set xtics ('500' 500, '1000' 1000, '2000' 2000, '5000' 5000, '10000' 10000)
set ytics ("none of\n2,097,152" 2.38419e-07, '0.0001 %%' 1e-6, '0.001 %%' 1e-5, '0.01 %%' 1e-4, '0.1 %%' 1e-3)
set object rectangle from graph 0, graph 0 to graph 1, first 4.05312e-07 fs solid noborder fc rgb '#eeeeee' behind
set arrow from first 10852.1,3.21865e-07 to graph 1.0,0.1214 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.1214 to graph 1.015,0.1214 nohead lw 0.8 lc rgb '#999999'
set label 'fast: irregular exact' at graph 1.02,0.1214 left
$hits0 << END
1946.31 3.21865e-07
2003.85 3.21865e-07
3621.57 3.21865e-07
3795.89 3.21865e-07
3773.59 3.21865e-07
4026.05 3.21865e-07
1857.23 3.21865e-07
1901.63 3.21865e-07
3811.12 3.21865e-07
3906.3 3.21865e-07
4615.86 3.21865e-07
4882 3.21865e-07
1921.71 3.21865e-07
1918.28 3.21865e-07
4290.97 3.21865e-07
4482.93 3.21865e-07
4752.77 3.21865e-07
3873.06 3.21865e-07
8198.15 3.21865e-07
10852.1 3.21865e-07
END
$hits1 << END
708.942 0.000182629
736.641 0.000171185
1825.62 0.000133038
1951.7 6.19888e-05
1694.58 0.00069952
1844.21 0.000184536
720.318 0.000182629
749.026 0.000171185
2023.65 0.000133038
2194.41 6.19888e-05
2285.95 0.00069952
2607.15 0.000184536
737.204 0.000182629
751.887 0.000171185
2296.21 0.000366688
2401.2 6.34193e-05
2113.31 0.000855446
1659.98 0.000384808
6534 0.000231743
7719.2 5.53131e-05
END
$hits2 << END
1668.39 2.38419e-07
1728.63 2.38419e-07
3254.34 2.38419e-07
3406.59 2.38419e-07
3495.63 2.38419e-07
3736.59 2.38419e-07
1697.65 2.38419e-07
1734.86 2.38419e-07
3559.61 2.38419e-07
3731.27 2.38419e-07
4271.95 2.38419e-07
4633.81 2.38419e-07
1738.08 2.38419e-07
1743.07 2.38419e-07
3870.77 2.38419e-07
4055.95 2.38419e-07
4447.64 2.38419e-07
3676.02 2.38419e-07
8150.23 2.38419e-07
10048.5 2.38419e-07
3105.38 2.38419e-07
2412.25 2.38419e-07
3933.26 2.38419e-07
END
$hits3 << END
572.337 0.000182629
587.145 0.000171185
1519.18 0.000133038
1635.95 6.19888e-05
1503.91 0.00069952
1665.97 0.000184536
581.245 0.000182629
607.845 0.000171185
1673.16 0.000133038
1852.61 6.19888e-05
1972.43 0.00069952
2280.07 0.000184536
600.24 0.000182629
613.099 0.000171185
1922.67 0.000366688
1973.62 6.34193e-05
1732.56 0.000855446
1321.37 0.000384808
5416.65 0.000231743
6615.12 5.53131e-05
END
$hits4 << END
1053.41 1.76606e-07
1083.9 1.76606e-07
2179.3 1.76606e-07
2313.31 1.76606e-07
2392.61 1.76606e-07
2571.96 1.76606e-07
1010.25 1.76606e-07
1040.27 1.76606e-07
2106.52 1.76606e-07
2244 1.76606e-07
2550.73 1.76606e-07
2771.08 1.76606e-07
1062.9 1.76606e-07
1040.15 1.76606e-07
2399.53 1.76606e-07
2447.93 1.76606e-07
2563.2 1.76606e-07
2072.09 1.76606e-07
5274.95 1.76606e-07
5969.21 1.76606e-07
END
$hits5 << END
956.548 0.000133038
1037.16 6.19888e-05
1024.4 0.00069952
1148.77 0.000184536
944.296 0.000133038
1029.97 6.19888e-05
1143.06 0.00069952
1301.51 0.000184536
1102.2 0.000366688
1112.27 6.34193e-05
988.924 0.000855446
719.693 0.000384808
3195.63 0.000231743
3690.51 5.53131e-05
END
$hits_front << END
10852.1 3.21865e-07
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
set xrange [120.921:2498]; set yrange [7.86585e-05:0.0151955]
set xlabel 'pictures a second  (more is better)'; set ylabel 'picture: RMSE of a channel  (less is better)' offset -1.5
set xtics ('200' 200, '500' 500, '1000' 1000, '2000' 2000)
set ytics ("same\nbits" 0.000196646, '10⁻³' 1e-3, '10⁻²' 1e-2)
set object rectangle from graph 0, graph 0 to graph 1, first 0.000334299 fs solid noborder fc rgb '#eeeeee' behind
set arrow from first 2081.67,0.0036314 to graph 1.0,0.7281 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.7281 to graph 1.015,0.7281 nohead lw 0.8 lc rgb '#999999'
set label 'fast: irregular exact' at graph 1.02,0.7281 left
set arrow from first 1690.83,0.00160758 to graph 1.0,0.5732 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.5732 to graph 1.015,0.5732 nohead lw 0.8 lc rgb '#999999'
set label 'robust: irregular exact' at graph 1.02,0.5732 left
set arrow from first 1306.93,0.000145664 to graph 1.0,0.1171 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.1171 to graph 1.015,0.1171 nohead lw 0.8 lc rgb '#999999'
set label 'double: irregular exact' at graph 1.02,0.1171 left
$picture0 << END
259.614 0.0036314
271.541 0.0036314
624.727 0.0036314
689.57 0.0036314
949.037 0.0036314
1092.92 0.0036314
262.495 0.0036314
270.453 0.0036314
592.407 0.0036314
645.77 0.0036314
893.647 0.0036314
1021.11 0.0036314
274.005 0.0036314
275.018 0.0036314
727.744 0.0036314
693.505 0.0036314
753.704 0.0036314
755.561 0.0036314
1686.27 0.0036314
2081.67 0.0036314
END
$picture1 << END
245.042 0.00473662
252.226 0.00475973
591.586 0.00396118
658.545 0.00436168
906.668 0.006064
1073.99 0.00475632
245.597 0.00473662
248.343 0.00475973
552.55 0.00396118
610.255 0.00436168
856.282 0.006064
967.399 0.00475632
247.619 0.00473662
255.073 0.00475973
678.417 0.00438677
661.629 0.00436168
691.324 0.00607821
706.404 0.00554194
1559.3 0.00401656
1975.22 0.0040382
END
$picture2 << END
212.008 0.00160758
215.581 0.00160758
547.411 0.00160758
601.008 0.00160758
820.769 0.00160758
959.325 0.00160758
209.048 0.00160758
212.732 0.00160758
503.976 0.00160758
552.209 0.00160758
782.583 0.00160758
898.424 0.00160758
213.791 0.00160758
218.191 0.00160758
578.928 0.00160758
589.289 0.00160758
617.944 0.00160758
633.413 0.00160758
1410.07 0.00160758
1690.83 0.00160758
414.941 0.00160758
622.51 0.00160758
694.536 0.00160758
END
$picture3 << END
192.373 0.00344683
198.887 0.00347858
487.42 0.00223184
551.089 0.00289851
743.251 0.00515237
889.933 0.00346756
191.566 0.00344683
198.54 0.00347858
478.078 0.00223184
523.758 0.00289851
735.83 0.00515237
831.449 0.00346756
194.816 0.00344683
200.601 0.00347858
535.82 0.00292125
544.093 0.00289851
578.777 0.00517295
572.073 0.0044849
1280.79 0.00235013
1599.2 0.00238596
END
$picture4 << END
150.302 0.000145664
152.394 0.000145664
388.715 0.000145664
442.729 0.000145664
627.963 0.000145664
760.508 0.000145664
145.105 0.000145664
150.603 0.000145664
370.656 0.000145664
410.024 0.000145664
589.88 0.000145664
697.126 0.000145664
159.341 0.000145664
153.643 0.000145664
426.045 0.000145664
416.455 0.000145664
453.319 0.000145664
455.334 0.000145664
1040.59 0.000145664
1306.93 0.000145664
END
$picture5 << END
376.333 0.00157317
412.7 0.00241185
584.331 0.00489516
690.06 0.0030724
348.26 0.00157317
389.85 0.00241185
565.62 0.00489516
658.02 0.0030724
411 0.00245508
392.924 0.00241185
432.216 0.00491682
428.934 0.00418689
988.24 0.0017136
1241.31 0.00176242
END
$picture_front << END
1306.93 0.000145664
1690.83 0.00160758
2081.67 0.0036314
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
set xrange [373.075:9161.6]; set yrange [9.53674e-08:0.000991821]
set xlabel 'million nearest hits a second  (more is better)'; set ylabel 'wrong hits  (less is better)' offset -1.5
set label 'mount: speed against accuracy (GPU)' at screen 0.02, screen 0.9774 font ',20'
set label '1024x1024 primary and 1,048,576 random rays a scene; 2,097,152 in all compared with brute force in double; pictures of 512x512' at screen 0.02, screen 0.9516
set xtics ('500' 500, '1000' 1000, '2000' 2000, '5000' 5000)
set ytics ("none of\n2,097,152" 2.38419e-07, '0.0001 %%' 1e-6, '0.001 %%' 1e-5, '0.01 %%' 1e-4)
set object rectangle from graph 0, graph 0 to graph 1, first 4.05312e-07 fs solid noborder fc rgb '#eeeeee' behind
set arrow from first 7634.67,3.21865e-07 to graph 1.0,0.1315 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.1315 to graph 1.015,0.1315 nohead lw 0.8 lc rgb '#999999'
set label 'fast: irregular exact' at graph 1.02,0.1315 left
$hits0 << END
3361.17 3.21865e-07
3564.26 3.21865e-07
2714.61 3.21865e-07
2936.73 3.21865e-07
3386.17 3.21865e-07
3709.1 3.21865e-07
3535.61 3.21865e-07
3734.67 3.21865e-07
3435.88 3.21865e-07
3733.61 3.21865e-07
4191.62 3.21865e-07
4751.05 3.21865e-07
3237.62 3.21865e-07
3495.81 3.21865e-07
787.541 3.21865e-07
844.699 3.21865e-07
2113.38 3.21865e-07
2226.47 3.21865e-07
6813.89 3.21865e-07
7634.67 3.21865e-07
END
$hits1 << END
1147.62 0.000134945
1215.66 0.000113964
1642.09 5.91278e-05
1827.6 2.24113e-05
1840.28 0.000191212
2059.65 6.58035e-05
1270.15 0.000134945
1331.03 0.000113964
2156.71 5.91278e-05
2514.81 2.24113e-05
2247.08 0.000191212
2604.56 6.58035e-05
1204.64 0.000210762
1272 0.00019598
687.155 0.000182629
712.743 0.000395775
1142.8 0.000291824
1188.71 0.000396729
4006.85 5.34058e-05
4559.34 3.14713e-05
END
$hits2 << END
3015.92 2.38419e-07
3192.05 2.38419e-07
2509.9 2.38419e-07
2740.26 2.38419e-07
3092.2 2.38419e-07
3418.14 2.38419e-07
3167.06 2.38419e-07
3370.5 2.38419e-07
3243.55 2.38419e-07
3552.47 2.38419e-07
3809.57 2.38419e-07
4348.77 2.38419e-07
2914.01 2.38419e-07
3151.98 2.38419e-07
749.223 2.38419e-07
798.246 2.38419e-07
1920.41 2.38419e-07
2031.87 2.38419e-07
6127.15 2.38419e-07
6933.56 2.38419e-07
447.69 2.38419e-07
1460.64 2.38419e-07
3727.45 2.38419e-07
1617.85 2.38419e-07
2846.79 2.38419e-07
END
$hits3 << END
894.518 0.000134945
936.536 0.000113964
1403.76 5.91278e-05
1581.73 2.24113e-05
1523.38 0.000191212
1718.75 6.58035e-05
987.657 0.000134945
1034.44 0.000113964
1797.92 5.91278e-05
2132.64 2.24113e-05
1837.9 0.000191212
2141.07 6.58035e-05
934.44 0.000210762
988.432 0.00019598
550.422 0.000182629
571.12 0.000395775
908.355 0.000291824
946.751 0.000396729
3291.61 5.34058e-05
3753.49 3.14713e-05
END
$hits4 << END
1807.64 1.76606e-07
1916.76 1.76606e-07
1735.91 1.76606e-07
1938.59 1.76606e-07
2053.26 1.76606e-07
2308.91 1.76606e-07
1853.13 1.76606e-07
1942.96 1.76606e-07
1922.89 1.76606e-07
2180.61 1.76606e-07
2226.47 1.76606e-07
2526.45 1.76606e-07
1673.2 1.76606e-07
1810.89 1.76606e-07
559.071 1.76606e-07
562.348 1.76606e-07
1087.41 1.76606e-07
1144.99 1.76606e-07
3721.73 1.76606e-07
4243.74 1.76606e-07
END
$hits5 << END
500.519 0.000134945
523.785 0.000113964
908.04 5.91278e-05
1065.63 2.24113e-05
925.506 0.000191212
1067.14 6.58035e-05
549.223 0.000134945
572.722 0.000113964
998.476 5.91278e-05
1182.06 2.24113e-05
1009.29 0.000191212
1173.98 6.58035e-05
519.752 0.000210762
546.917 0.00019598
507.763 0.000291824
528.819 0.000396729
1807.59 5.34058e-05
2066.73 3.14713e-05
END
$hits_front << END
7634.67 3.21865e-07
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
set xrange [127.237:3347.62]; set yrange [3.11752e-05:0.013019]
set xlabel 'pictures a second  (more is better)'; set ylabel 'picture: RMSE of a channel  (less is better)' offset -1.5
set xtics ('200' 200, '500' 500, '1000' 1000, '2000' 2000)
set ytics ("same\nbits" 7.7938e-05, '10⁻³' 1e-3, '10⁻²' 1e-2)
set object rectangle from graph 0, graph 0 to graph 1, first 0.000132495 fs solid noborder fc rgb '#eeeeee' behind
set arrow from first 2789.68,0.00463004 to graph 1.0,0.8765 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.8765 to graph 1.015,0.8765 nohead lw 0.8 lc rgb '#999999'
set label 'fast, study: irregular exact' at graph 1.02,0.8765 left
set arrow from first 2588.63,0.00456969 to graph 1.0,0.8265 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.8265 to graph 1.015,0.8265 nohead lw 0.8 lc rgb '#999999'
set label 'fast: irregular exact' at graph 1.02,0.8265 left
set arrow from first 2338.9,0.000971559 to graph 1.0,0.5699 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.5699 to graph 1.015,0.5699 nohead lw 0.8 lc rgb '#999999'
set label 'robust, study: irregular exact' at graph 1.02,0.5699 left
set arrow from first 2300.67,0.000623504 to graph 1.0,0.4964 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.4964 to graph 1.015,0.4964 nohead lw 0.8 lc rgb '#999999'
set label 'robust: irregular exact' at graph 1.02,0.4964 left
set arrow from first 1811.07,5.77319e-05 to graph 1.0,0.1021 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.1021 to graph 1.015,0.1021 nohead lw 0.8 lc rgb '#999999'
set label 'double: irregular exact' at graph 1.02,0.1021 left
$picture0 << END
1065.97 0.00456969
1135.54 0.00456969
986.057 0.00456969
1178.44 0.00456969
1190.11 0.00456969
1367.38 0.00456969
1063.87 0.00456969
1114.84 0.00456969
940.017 0.00456969
1152.5 0.00456969
1158.69 0.00456969
1368.81 0.00456969
1047.29 0.00456969
1112.38 0.00456969
375.732 0.00456969
378.132 0.00456969
690.913 0.00456969
703.621 0.00456969
2314.47 0.00456969
2588.63 0.00456969
END
$picture1 << END
1150.5 0.00483535
1200.17 0.00477278
1122.08 0.00465529
1303.82 0.00462287
1315.29 0.00520761
1490.65 0.00470638
1159 0.00483535
1212.46 0.00477278
1118.91 0.00465529
1299.48 0.00462287
1309.83 0.00520761
1528.79 0.00470638
1105.41 0.00483535
1167.83 0.00477278
403.678 0.00460019
410.752 0.00460581
760.323 0.00496746
767.684 0.00472754
2500.6 0.00463625
2789.68 0.00463004
END
$picture2 << END
964.088 0.000623504
1013.56 0.000623504
918.282 0.000623504
1099.04 0.000623504
1097.03 0.000623504
1264.72 0.000623504
955.511 0.000623504
997.705 0.000623504
884.47 0.000623504
1092.5 0.000623504
1073 0.000623504
1288.71 0.000623504
936.979 0.000623504
994.936 0.000623504
344.299 0.000623504
350.942 0.000623504
624.887 0.000623504
639.791 0.000623504
2055.52 0.000623504
2300.67 0.000623504
152.685 0.000623504
486.988 0.000623504
1337.99 0.000623504
648.462 0.000623504
721.761 0.000623504
END
$picture3 << END
956.709 0.00170222
999.78 0.00151537
1028.74 0.00105972
1188.76 0.000906763
1160.29 0.00257412
1317.34 0.0012872
972.46 0.00170222
1002.12 0.00151537
1005.05 0.00105972
1174.9 0.000906763
1151.82 0.00257412
1335.13 0.0012872
910.548 0.00170222
965.521 0.00151537
342.459 0.000817549
351.641 0.000824845
643.89 0.00204512
647.492 0.00134789
2118.5 0.00100073
2338.9 0.000971559
END
$picture4 << END
727.453 5.77319e-05
771.796 5.77319e-05
779.223 5.77319e-05
961.391 5.77319e-05
891.687 5.77319e-05
1055.89 5.77319e-05
718.623 5.77319e-05
754.159 5.77319e-05
760.989 5.77319e-05
951.411 5.77319e-05
891.663 5.77319e-05
1073.11 5.77319e-05
691.539 5.77319e-05
742.49 5.77319e-05
274.13 5.77319e-05
278.868 5.77319e-05
506.498 5.77319e-05
516.393 5.77319e-05
1648.55 5.77319e-05
1811.07 5.77319e-05
END
$picture5 << END
726.406 0.00158392
768.645 0.00138115
785.706 0.00085688
900.528 0.000658378
876.701 0.00249747
983.661 0.00112611
745.912 0.00158392
777.109 0.00138115
844.823 0.00085688
985.057 0.000658378
942.8 0.00249747
1085.11 0.00112611
699.702 0.00158392
738.891 0.00138115
524.293 0.00194775
532.958 0.00119501
1630.15 0.000782748
1776.78 0.000745097
END
$picture_front << END
1811.07 5.77319e-05
2300.67 0.000623504
2338.9 0.000971559
2588.63 0.00456969
2789.68 0.00463004
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
set xrange [373.075:9161.6]; set yrange [9.53674e-08:0.000991821]
set xlabel 'million nearest hits a second  (more is better)'; set ylabel 'wrong hits  (less is better)' offset -1.5
set label 'mount: speed against accuracy (GPU)' at screen 0.02, screen 0.9774 font ',20'
set label '1024x1024 primary and 1,048,576 random rays a scene; 2,097,152 in all compared with brute force in double; pictures of 512x512' at screen 0.02, screen 0.9516
set xtics ('500' 500, '1000' 1000, '2000' 2000, '5000' 5000)
set ytics ("none of\n2,097,152" 2.38419e-07, '0.0001 %%' 1e-6, '0.001 %%' 1e-5, '0.01 %%' 1e-4)
set object rectangle from graph 0, graph 0 to graph 1, first 4.05312e-07 fs solid noborder fc rgb '#eeeeee' behind
set arrow from first 7634.67,3.21865e-07 to graph 1.0,0.1315 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.1315 to graph 1.015,0.1315 nohead lw 0.8 lc rgb '#999999'
set label 'fast: irregular exact' at graph 1.02,0.1315 left
$hits0 << END
3361.17 3.21865e-07
3564.26 3.21865e-07
2714.61 3.21865e-07
2936.73 3.21865e-07
3386.17 3.21865e-07
3709.1 3.21865e-07
3535.61 3.21865e-07
3734.67 3.21865e-07
3435.88 3.21865e-07
3733.61 3.21865e-07
4191.62 3.21865e-07
4751.05 3.21865e-07
3237.62 3.21865e-07
3495.81 3.21865e-07
787.541 3.21865e-07
844.699 3.21865e-07
2113.38 3.21865e-07
2226.47 3.21865e-07
6813.89 3.21865e-07
7634.67 3.21865e-07
END
$hits1 << END
1147.62 0.000134945
1215.66 0.000113964
1642.09 5.91278e-05
1827.6 2.24113e-05
1840.28 0.000191212
2059.65 6.58035e-05
1270.15 0.000134945
1331.03 0.000113964
2156.71 5.91278e-05
2514.81 2.24113e-05
2247.08 0.000191212
2604.56 6.58035e-05
1204.64 0.000210762
1272 0.00019598
687.155 0.000182629
712.743 0.000395775
1142.8 0.000291824
1188.71 0.000396729
4006.85 5.34058e-05
4559.34 3.14713e-05
END
$hits2 << END
3015.92 2.38419e-07
3192.05 2.38419e-07
2509.9 2.38419e-07
2740.26 2.38419e-07
3092.2 2.38419e-07
3418.14 2.38419e-07
3167.06 2.38419e-07
3370.5 2.38419e-07
3243.55 2.38419e-07
3552.47 2.38419e-07
3809.57 2.38419e-07
4348.77 2.38419e-07
2914.01 2.38419e-07
3151.98 2.38419e-07
749.223 2.38419e-07
798.246 2.38419e-07
1920.41 2.38419e-07
2031.87 2.38419e-07
6127.15 2.38419e-07
6933.56 2.38419e-07
447.69 2.38419e-07
1460.64 2.38419e-07
3727.45 2.38419e-07
1617.85 2.38419e-07
2846.79 2.38419e-07
END
$hits3 << END
894.518 0.000134945
936.536 0.000113964
1403.76 5.91278e-05
1581.73 2.24113e-05
1523.38 0.000191212
1718.75 6.58035e-05
987.657 0.000134945
1034.44 0.000113964
1797.92 5.91278e-05
2132.64 2.24113e-05
1837.9 0.000191212
2141.07 6.58035e-05
934.44 0.000210762
988.432 0.00019598
550.422 0.000182629
571.12 0.000395775
908.355 0.000291824
946.751 0.000396729
3291.61 5.34058e-05
3753.49 3.14713e-05
END
$hits4 << END
1807.64 1.76606e-07
1916.76 1.76606e-07
1735.91 1.76606e-07
1938.59 1.76606e-07
2053.26 1.76606e-07
2308.91 1.76606e-07
1853.13 1.76606e-07
1942.96 1.76606e-07
1922.89 1.76606e-07
2180.61 1.76606e-07
2226.47 1.76606e-07
2526.45 1.76606e-07
1673.2 1.76606e-07
1810.89 1.76606e-07
559.071 1.76606e-07
562.348 1.76606e-07
1087.41 1.76606e-07
1144.99 1.76606e-07
3721.73 1.76606e-07
4243.74 1.76606e-07
END
$hits5 << END
500.519 0.000134945
523.785 0.000113964
908.04 5.91278e-05
1065.63 2.24113e-05
925.506 0.000191212
1067.14 6.58035e-05
549.223 0.000134945
572.722 0.000113964
998.476 5.91278e-05
1182.06 2.24113e-05
1009.29 0.000191212
1173.98 6.58035e-05
519.752 0.000210762
546.917 0.00019598
507.763 0.000291824
528.819 0.000396729
1807.59 5.34058e-05
2066.73 3.14713e-05
END
$hits_front << END
7634.67 3.21865e-07
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
set xrange [127.237:3347.62]; set yrange [3.11752e-05:0.013019]
set xlabel 'pictures a second  (more is better)'; set ylabel 'picture: RMSE of a channel  (less is better)' offset -1.5
set xtics ('200' 200, '500' 500, '1000' 1000, '2000' 2000)
set ytics ("same\nbits" 7.7938e-05, '10⁻³' 1e-3, '10⁻²' 1e-2)
set object rectangle from graph 0, graph 0 to graph 1, first 0.000132495 fs solid noborder fc rgb '#eeeeee' behind
set arrow from first 2789.68,0.00463004 to graph 1.0,0.8765 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.8765 to graph 1.015,0.8765 nohead lw 0.8 lc rgb '#999999'
set label 'fast, study: irregular exact' at graph 1.02,0.8765 left
set arrow from first 2588.63,0.00456969 to graph 1.0,0.8265 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.8265 to graph 1.015,0.8265 nohead lw 0.8 lc rgb '#999999'
set label 'fast: irregular exact' at graph 1.02,0.8265 left
set arrow from first 2338.9,0.000971559 to graph 1.0,0.5699 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.5699 to graph 1.015,0.5699 nohead lw 0.8 lc rgb '#999999'
set label 'robust, study: irregular exact' at graph 1.02,0.5699 left
set arrow from first 2300.67,0.000623504 to graph 1.0,0.4964 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.4964 to graph 1.015,0.4964 nohead lw 0.8 lc rgb '#999999'
set label 'robust: irregular exact' at graph 1.02,0.4964 left
set arrow from first 1811.07,5.77319e-05 to graph 1.0,0.1021 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.1021 to graph 1.015,0.1021 nohead lw 0.8 lc rgb '#999999'
set label 'double: irregular exact' at graph 1.02,0.1021 left
$picture0 << END
1065.97 0.00456969
1135.54 0.00456969
986.057 0.00456969
1178.44 0.00456969
1190.11 0.00456969
1367.38 0.00456969
1063.87 0.00456969
1114.84 0.00456969
940.017 0.00456969
1152.5 0.00456969
1158.69 0.00456969
1368.81 0.00456969
1047.29 0.00456969
1112.38 0.00456969
375.732 0.00456969
378.132 0.00456969
690.913 0.00456969
703.621 0.00456969
2314.47 0.00456969
2588.63 0.00456969
END
$picture1 << END
1150.5 0.00483535
1200.17 0.00477278
1122.08 0.00465529
1303.82 0.00462287
1315.29 0.00520761
1490.65 0.00470638
1159 0.00483535
1212.46 0.00477278
1118.91 0.00465529
1299.48 0.00462287
1309.83 0.00520761
1528.79 0.00470638
1105.41 0.00483535
1167.83 0.00477278
403.678 0.00460019
410.752 0.00460581
760.323 0.00496746
767.684 0.00472754
2500.6 0.00463625
2789.68 0.00463004
END
$picture2 << END
964.088 0.000623504
1013.56 0.000623504
918.282 0.000623504
1099.04 0.000623504
1097.03 0.000623504
1264.72 0.000623504
955.511 0.000623504
997.705 0.000623504
884.47 0.000623504
1092.5 0.000623504
1073 0.000623504
1288.71 0.000623504
936.979 0.000623504
994.936 0.000623504
344.299 0.000623504
350.942 0.000623504
624.887 0.000623504
639.791 0.000623504
2055.52 0.000623504
2300.67 0.000623504
152.685 0.000623504
486.988 0.000623504
1337.99 0.000623504
648.462 0.000623504
721.761 0.000623504
END
$picture3 << END
956.709 0.00170222
999.78 0.00151537
1028.74 0.00105972
1188.76 0.000906763
1160.29 0.00257412
1317.34 0.0012872
972.46 0.00170222
1002.12 0.00151537
1005.05 0.00105972
1174.9 0.000906763
1151.82 0.00257412
1335.13 0.0012872
910.548 0.00170222
965.521 0.00151537
342.459 0.000817549
351.641 0.000824845
643.89 0.00204512
647.492 0.00134789
2118.5 0.00100073
2338.9 0.000971559
END
$picture4 << END
727.453 5.77319e-05
771.796 5.77319e-05
779.223 5.77319e-05
961.391 5.77319e-05
891.687 5.77319e-05
1055.89 5.77319e-05
718.623 5.77319e-05
754.159 5.77319e-05
760.989 5.77319e-05
951.411 5.77319e-05
891.663 5.77319e-05
1073.11 5.77319e-05
691.539 5.77319e-05
742.49 5.77319e-05
274.13 5.77319e-05
278.868 5.77319e-05
506.498 5.77319e-05
516.393 5.77319e-05
1648.55 5.77319e-05
1811.07 5.77319e-05
END
$picture5 << END
726.406 0.00158392
768.645 0.00138115
785.706 0.00085688
900.528 0.000658378
876.701 0.00249747
983.661 0.00112611
745.912 0.00158392
777.109 0.00138115
844.823 0.00085688
985.057 0.000658378
942.8 0.00249747
1085.11 0.00112611
699.702 0.00158392
738.891 0.00138115
524.293 0.00194775
532.958 0.00119501
1630.15 0.000782748
1776.78 0.000745097
END
$picture_front << END
1811.07 5.77319e-05
2300.67 0.000623504
2338.9 0.000971559
2588.63 0.00456969
2789.68 0.00463004
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
set xrange [364.339:7302.06]; set yrange [9.53674e-08:0.0598156]
set xlabel 'million nearest hits a second  (more is better)'; set ylabel 'wrong hits  (less is better)' offset -1.5
set label 'rings: speed against accuracy (GPU)' at screen 0.02, screen 0.9774 font ',20'
set label '1024x1024 primary and 1,048,576 random rays a scene; 2,097,152 in all compared with brute force in double; pictures of 512x512' at screen 0.02, screen 0.9516
set xtics ('500' 500, '1000' 1000, '2000' 2000, '5000' 5000)
set ytics ("none of\n2,097,152" 2.38419e-07, '0.0001 %%' 1e-6, '0.001 %%' 1e-5, '0.01 %%' 1e-4, '0.1 %%' 1e-3, '1 %%' 1e-2)
set object rectangle from graph 0, graph 0 to graph 1, first 4.05312e-07 fs solid noborder fc rgb '#eeeeee' behind
set arrow from first 6085.05,0.000258923 to graph 1.0,0.5923 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.5923 to graph 1.015,0.5923 nohead lw 0.8 lc rgb '#999999'
set label 'fast: irregular exact' at graph 1.02,0.5923 left
set arrow from first 5323.8,2.38419e-07 to graph 1.0,0.0686 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.0686 to graph 1.015,0.0686 nohead lw 0.8 lc rgb '#999999'
set label 'robust: irregular exact' at graph 1.02,0.0686 left
$hits0 << END
2525.96 0.000258923
2835.34 0.000258923
2243.31 0.000258923
2561.6 0.000258923
2533.97 0.000258923
2955.67 0.000258923
2599.4 0.000258923
2943.72 0.000258923
2661.14 0.000258923
3237.3 0.000258923
2910.25 0.000258923
3584.53 0.000258923
2491.58 0.000258923
2810.65 0.000258923
1827.09 0.000258923
2180.03 0.000258923
1826.28 0.000258923
2137.93 0.000258923
4833.04 0.000258923
6085.05 0.000258923
END
$hits1 << END
1249.26 0.00740767
1433.33 0.00626707
1441.71 0.0239263
1738.96 0.010325
1581.2 0.0226121
1955.71 0.0121698
1355.95 0.00740767
1577.47 0.00626707
1767.04 0.0239263
2258.07 0.010325
1881.87 0.0226121
2456.56 0.0121698
1330.73 0.00840855
1535.77 0.00634432
1217.08 0.0187721
1414 0.0170641
1240.13 0.0174308
1420.07 0.0124621
3356.35 0.0219607
4366.74 0.0106969
END
$hits2 << END
2348.03 2.38419e-07
2615.89 2.38419e-07
1943.25 2.38419e-07
2240.47 2.38419e-07
2202 2.38419e-07
2565.41 2.38419e-07
2413.14 2.38419e-07
2730.78 2.38419e-07
2347.95 2.38419e-07
2868.1 2.38419e-07
2546.18 2.38419e-07
3167.52 2.38419e-07
2325.7 2.38419e-07
2621.02 2.38419e-07
1709.65 2.38419e-07
2016.31 2.38419e-07
1713.18 2.38419e-07
2018.17 2.38419e-07
4233.59 2.38419e-07
5323.8 2.38419e-07
437.207 2.38419e-07
1298.85 2.38419e-07
3038.43 2.38419e-07
1373.81 2.38419e-07
1859.44 2.38419e-07
END
$hits3 << END
1238.89 0.00717831
1407.38 0.00603485
1329.71 0.0237164
1575.99 0.0100956
1468.3 0.0224056
1782.86 0.011939
1305.47 0.00717831
1498.82 0.00603485
1580.4 0.0237164
1983.48 0.0100956
1678.52 0.0224056
2149.78 0.011939
1285.65 0.00818014
1464 0.00611162
1160.3 0.0185757
1334.8 0.0168576
1180 0.0172191
1344.08 0.0122404
2959.4 0.0217538
3761.9 0.010457
END
$hits4 << END
1300.5 1.76606e-07
1454.22 1.76606e-07
1234.53 1.76606e-07
1475.34 1.76606e-07
1364.25 1.76606e-07
1645.43 1.76606e-07
1275.79 1.76606e-07
1444.22 1.76606e-07
1252.36 1.76606e-07
1526.29 1.76606e-07
1361.14 1.76606e-07
1695.28 1.76606e-07
1229.22 1.76606e-07
1386.42 1.76606e-07
854.312 1.76606e-07
1015.1 1.76606e-07
877.123 1.76606e-07
1029.58 1.76606e-07
2253.8 1.76606e-07
2852.12 1.76606e-07
END
$hits5 << END
591.197 0.00717831
671.599 0.00603533
789.239 0.0237164
1011.14 0.0100975
835.034 0.0224056
1079.97 0.01194
610.438 0.00717831
694.37 0.00603533
811.31 0.0237164
1043.92 0.010098
853.145 0.0224056
1115.47 0.01194
595.722 0.00818014
674.815 0.0061121
557.592 0.01858
641.334 0.0168648
569.205 0.0172191
646.63 0.0122404
1462.27 0.0217538
1875.83 0.0104575
END
$hits_front << END
5323.8 2.38419e-07
6085.05 0.000258923
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
set xrange [51.6168:1180.77]; set yrange [5.15415e-05:0.137565]
set xlabel 'pictures a second  (more is better)'; set ylabel 'picture: RMSE of a channel  (less is better)' offset -1.5
set xtics ('100' 100, '200' 200, '500' 500, '1000' 1000)
set ytics ("same\nbits" 0.000128854, '10⁻³' 1e-3, '10⁻²' 1e-2, '10⁻¹' 1e-1)
set object rectangle from graph 0, graph 0 to graph 1, first 0.000219051 fs solid noborder fc rgb '#eeeeee' behind
set arrow from first 983.971,0.0240238 to graph 1.0,0.7788 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.7788 to graph 1.015,0.7788 nohead lw 0.8 lc rgb '#999999'
set label 'fast: irregular exact' at graph 1.02,0.7788 left
set arrow from first 832.737,0.00103083 to graph 1.0,0.3797 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.3797 to graph 1.015,0.3797 nohead lw 0.8 lc rgb '#999999'
set label 'robust: irregular exact' at graph 1.02,0.3797 left
set arrow from first 509.074,9.54472e-05 to graph 1.0,0.0781 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.0781 to graph 1.015,0.0781 nohead lw 0.8 lc rgb '#999999'
set label 'double: irregular exact' at graph 1.02,0.0781 left
$picture0 << END
348.329 0.0240238
399.632 0.0240238
458.278 0.0240238
599.474 0.0240238
487.353 0.0240238
640.525 0.0240238
340.059 0.0240238
393.76 0.0240238
437.149 0.0240238
572.521 0.0240238
464.712 0.0240238
607.021 0.0240238
344.489 0.0240238
388.721 0.0240238
402.261 0.0240238
473.723 0.0240238
380.017 0.0240238
449.758 0.0240238
708.055 0.0240238
983.971 0.0240238
END
$picture1 << END
361.644 0.0316948
409.175 0.0299718
478.171 0.0550258
614.59 0.0382589
497.334 0.0514003
647.157 0.0396658
356.89 0.0316948
407.395 0.0299718
454.882 0.0550258
575.083 0.0382589
472.97 0.0514003
620.286 0.0396658
353.115 0.0316956
404.196 0.0299871
419.453 0.0433868
485.821 0.0431929
390.153 0.0454264
462.011 0.0385493
731.524 0.0516801
982.367 0.0386257
END
$picture2 << END
341.21 0.00103083
386.36 0.00103083
426.557 0.00103083
544.558 0.00103083
447.317 0.00103083
581.351 0.00103083
334.246 0.00103083
382.582 0.00103083
405.691 0.00103083
530.912 0.00103083
428.563 0.00103083
563.377 0.00103083
333.074 0.00103083
376.298 0.00103083
395.02 0.00103083
462.409 0.00103083
378.986 0.00103083
442.153 0.00103083
632.667 0.00103083
832.737 0.00103083
61.9402 0.00103083
184.08 0.00103083
585.734 0.00103083
372.823 0.00103083
361.159 0.00103083
END
$picture3 << END
336.982 0.0213945
384.572 0.0185578
430.032 0.0501279
540.733 0.0301143
444.006 0.0460153
586.834 0.0320802
340.047 0.0213945
380.49 0.0185578
406.151 0.0501279
519.197 0.0301143
423.35 0.0460153
567.933 0.0320802
331.319 0.0213956
378.082 0.0185825
398.149 0.0367043
454.269 0.0363682
365.917 0.03897
446.084 0.0306254
648.824 0.0463472
835.603 0.0308365
END
$picture4 << END
204.576 9.54472e-05
231.466 9.54472e-05
272.759 9.54472e-05
357.969 9.54472e-05
282.857 9.54472e-05
379.723 9.54472e-05
201.449 9.54472e-05
229.047 9.54472e-05
260.182 9.54472e-05
344.239 9.54472e-05
271.413 9.54472e-05
362.605 9.54472e-05
198.307 9.54472e-05
228.27 9.54472e-05
241.186 9.54472e-05
284.261 9.54472e-05
232.401 9.54472e-05
272.193 9.54472e-05
392.727 9.54472e-05
509.074 9.54472e-05
END
$picture5 << END
205.026 0.0213712
234.719 0.0185352
274.863 0.0501203
347.814 0.0301081
276.233 0.0460158
371.475 0.0321056
204.691 0.0213712
234.73 0.0185352
266.082 0.0501203
342.106 0.0301087
269.385 0.0460158
363.943 0.0321056
201.773 0.0213723
232.304 0.0185599
247.519 0.0367162
290.646 0.0363944
231.192 0.0389679
277.078 0.0306294
400.364 0.0463478
509.448 0.0308645
END
$picture_front << END
509.074 9.54472e-05
832.737 0.00103083
983.971 0.0240238
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
set xrange [364.339:7302.06]; set yrange [9.53674e-08:0.0598156]
set xlabel 'million nearest hits a second  (more is better)'; set ylabel 'wrong hits  (less is better)' offset -1.5
set label 'rings: speed against accuracy (GPU)' at screen 0.02, screen 0.9774 font ',20'
set label '1024x1024 primary and 1,048,576 random rays a scene; 2,097,152 in all compared with brute force in double; pictures of 512x512' at screen 0.02, screen 0.9516
set xtics ('500' 500, '1000' 1000, '2000' 2000, '5000' 5000)
set ytics ("none of\n2,097,152" 2.38419e-07, '0.0001 %%' 1e-6, '0.001 %%' 1e-5, '0.01 %%' 1e-4, '0.1 %%' 1e-3, '1 %%' 1e-2)
set object rectangle from graph 0, graph 0 to graph 1, first 4.05312e-07 fs solid noborder fc rgb '#eeeeee' behind
set arrow from first 6085.05,0.000258923 to graph 1.0,0.5923 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.5923 to graph 1.015,0.5923 nohead lw 0.8 lc rgb '#999999'
set label 'fast: irregular exact' at graph 1.02,0.5923 left
set arrow from first 5323.8,2.38419e-07 to graph 1.0,0.0686 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.0686 to graph 1.015,0.0686 nohead lw 0.8 lc rgb '#999999'
set label 'robust: irregular exact' at graph 1.02,0.0686 left
$hits0 << END
2525.96 0.000258923
2835.34 0.000258923
2243.31 0.000258923
2561.6 0.000258923
2533.97 0.000258923
2955.67 0.000258923
2599.4 0.000258923
2943.72 0.000258923
2661.14 0.000258923
3237.3 0.000258923
2910.25 0.000258923
3584.53 0.000258923
2491.58 0.000258923
2810.65 0.000258923
1827.09 0.000258923
2180.03 0.000258923
1826.28 0.000258923
2137.93 0.000258923
4833.04 0.000258923
6085.05 0.000258923
END
$hits1 << END
1249.26 0.00740767
1433.33 0.00626707
1441.71 0.0239263
1738.96 0.010325
1581.2 0.0226121
1955.71 0.0121698
1355.95 0.00740767
1577.47 0.00626707
1767.04 0.0239263
2258.07 0.010325
1881.87 0.0226121
2456.56 0.0121698
1330.73 0.00840855
1535.77 0.00634432
1217.08 0.0187721
1414 0.0170641
1240.13 0.0174308
1420.07 0.0124621
3356.35 0.0219607
4366.74 0.0106969
END
$hits2 << END
2348.03 2.38419e-07
2615.89 2.38419e-07
1943.25 2.38419e-07
2240.47 2.38419e-07
2202 2.38419e-07
2565.41 2.38419e-07
2413.14 2.38419e-07
2730.78 2.38419e-07
2347.95 2.38419e-07
2868.1 2.38419e-07
2546.18 2.38419e-07
3167.52 2.38419e-07
2325.7 2.38419e-07
2621.02 2.38419e-07
1709.65 2.38419e-07
2016.31 2.38419e-07
1713.18 2.38419e-07
2018.17 2.38419e-07
4233.59 2.38419e-07
5323.8 2.38419e-07
437.207 2.38419e-07
1298.85 2.38419e-07
3038.43 2.38419e-07
1373.81 2.38419e-07
1859.44 2.38419e-07
END
$hits3 << END
1238.89 0.00717831
1407.38 0.00603485
1329.71 0.0237164
1575.99 0.0100956
1468.3 0.0224056
1782.86 0.011939
1305.47 0.00717831
1498.82 0.00603485
1580.4 0.0237164
1983.48 0.0100956
1678.52 0.0224056
2149.78 0.011939
1285.65 0.00818014
1464 0.00611162
1160.3 0.0185757
1334.8 0.0168576
1180 0.0172191
1344.08 0.0122404
2959.4 0.0217538
3761.9 0.010457
END
$hits4 << END
1300.5 1.76606e-07
1454.22 1.76606e-07
1234.53 1.76606e-07
1475.34 1.76606e-07
1364.25 1.76606e-07
1645.43 1.76606e-07
1275.79 1.76606e-07
1444.22 1.76606e-07
1252.36 1.76606e-07
1526.29 1.76606e-07
1361.14 1.76606e-07
1695.28 1.76606e-07
1229.22 1.76606e-07
1386.42 1.76606e-07
854.312 1.76606e-07
1015.1 1.76606e-07
877.123 1.76606e-07
1029.58 1.76606e-07
2253.8 1.76606e-07
2852.12 1.76606e-07
END
$hits5 << END
591.197 0.00717831
671.599 0.00603533
789.239 0.0237164
1011.14 0.0100975
835.034 0.0224056
1079.97 0.01194
610.438 0.00717831
694.37 0.00603533
811.31 0.0237164
1043.92 0.010098
853.145 0.0224056
1115.47 0.01194
595.722 0.00818014
674.815 0.0061121
557.592 0.01858
641.334 0.0168648
569.205 0.0172191
646.63 0.0122404
1462.27 0.0217538
1875.83 0.0104575
END
$hits_front << END
5323.8 2.38419e-07
6085.05 0.000258923
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
set xrange [51.6168:1180.77]; set yrange [5.15415e-05:0.137565]
set xlabel 'pictures a second  (more is better)'; set ylabel 'picture: RMSE of a channel  (less is better)' offset -1.5
set xtics ('100' 100, '200' 200, '500' 500, '1000' 1000)
set ytics ("same\nbits" 0.000128854, '10⁻³' 1e-3, '10⁻²' 1e-2, '10⁻¹' 1e-1)
set object rectangle from graph 0, graph 0 to graph 1, first 0.000219051 fs solid noborder fc rgb '#eeeeee' behind
set arrow from first 983.971,0.0240238 to graph 1.0,0.7788 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.7788 to graph 1.015,0.7788 nohead lw 0.8 lc rgb '#999999'
set label 'fast: irregular exact' at graph 1.02,0.7788 left
set arrow from first 832.737,0.00103083 to graph 1.0,0.3797 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.3797 to graph 1.015,0.3797 nohead lw 0.8 lc rgb '#999999'
set label 'robust: irregular exact' at graph 1.02,0.3797 left
set arrow from first 509.074,9.54472e-05 to graph 1.0,0.0781 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.0781 to graph 1.015,0.0781 nohead lw 0.8 lc rgb '#999999'
set label 'double: irregular exact' at graph 1.02,0.0781 left
$picture0 << END
348.329 0.0240238
399.632 0.0240238
458.278 0.0240238
599.474 0.0240238
487.353 0.0240238
640.525 0.0240238
340.059 0.0240238
393.76 0.0240238
437.149 0.0240238
572.521 0.0240238
464.712 0.0240238
607.021 0.0240238
344.489 0.0240238
388.721 0.0240238
402.261 0.0240238
473.723 0.0240238
380.017 0.0240238
449.758 0.0240238
708.055 0.0240238
983.971 0.0240238
END
$picture1 << END
361.644 0.0316948
409.175 0.0299718
478.171 0.0550258
614.59 0.0382589
497.334 0.0514003
647.157 0.0396658
356.89 0.0316948
407.395 0.0299718
454.882 0.0550258
575.083 0.0382589
472.97 0.0514003
620.286 0.0396658
353.115 0.0316956
404.196 0.0299871
419.453 0.0433868
485.821 0.0431929
390.153 0.0454264
462.011 0.0385493
731.524 0.0516801
982.367 0.0386257
END
$picture2 << END
341.21 0.00103083
386.36 0.00103083
426.557 0.00103083
544.558 0.00103083
447.317 0.00103083
581.351 0.00103083
334.246 0.00103083
382.582 0.00103083
405.691 0.00103083
530.912 0.00103083
428.563 0.00103083
563.377 0.00103083
333.074 0.00103083
376.298 0.00103083
395.02 0.00103083
462.409 0.00103083
378.986 0.00103083
442.153 0.00103083
632.667 0.00103083
832.737 0.00103083
61.9402 0.00103083
184.08 0.00103083
585.734 0.00103083
372.823 0.00103083
361.159 0.00103083
END
$picture3 << END
336.982 0.0213945
384.572 0.0185578
430.032 0.0501279
540.733 0.0301143
444.006 0.0460153
586.834 0.0320802
340.047 0.0213945
380.49 0.0185578
406.151 0.0501279
519.197 0.0301143
423.35 0.0460153
567.933 0.0320802
331.319 0.0213956
378.082 0.0185825
398.149 0.0367043
454.269 0.0363682
365.917 0.03897
446.084 0.0306254
648.824 0.0463472
835.603 0.0308365
END
$picture4 << END
204.576 9.54472e-05
231.466 9.54472e-05
272.759 9.54472e-05
357.969 9.54472e-05
282.857 9.54472e-05
379.723 9.54472e-05
201.449 9.54472e-05
229.047 9.54472e-05
260.182 9.54472e-05
344.239 9.54472e-05
271.413 9.54472e-05
362.605 9.54472e-05
198.307 9.54472e-05
228.27 9.54472e-05
241.186 9.54472e-05
284.261 9.54472e-05
232.401 9.54472e-05
272.193 9.54472e-05
392.727 9.54472e-05
509.074 9.54472e-05
END
$picture5 << END
205.026 0.0213712
234.719 0.0185352
274.863 0.0501203
347.814 0.0301081
276.233 0.0460158
371.475 0.0321056
204.691 0.0213712
234.73 0.0185352
266.082 0.0501203
342.106 0.0301087
269.385 0.0460158
363.943 0.0321056
201.773 0.0213723
232.304 0.0185599
247.519 0.0367162
290.646 0.0363944
231.192 0.0389679
277.078 0.0306294
400.364 0.0463478
509.448 0.0308645
END
$picture_front << END
509.074 9.54472e-05
832.737 0.00103083
983.971 0.0240238
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
set xrange [399.311:11215.5]; set yrange [9.53674e-08:0.000944138]
set xlabel 'million nearest hits a second  (more is better)'; set ylabel 'wrong hits  (less is better)' offset -1.5
set label 'teapot: speed against accuracy (GPU)' at screen 0.02, screen 0.9774 font ',20'
set label '1024x1024 primary and 1,048,576 random rays a scene; 2,097,152 in all compared with brute force in double; pictures of 512x512' at screen 0.02, screen 0.9516
set xtics ('500' 500, '1000' 1000, '2000' 2000, '5000' 5000, '10000' 10000)
set ytics ("none of\n2,097,152" 2.38419e-07, '0.0001 %%' 1e-6, '0.001 %%' 1e-5, '0.01 %%' 1e-4)
set object rectangle from graph 0, graph 0 to graph 1, first 4.05312e-07 fs solid noborder fc rgb '#eeeeee' behind
set arrow from first 9346.26,3.21865e-07 to graph 1.0,0.1322 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.1322 to graph 1.015,0.1322 nohead lw 0.8 lc rgb '#999999'
set label 'fast: irregular exact' at graph 1.02,0.1322 left
$hits0 << END
3505.35 3.21865e-07
3519.85 3.21865e-07
3246.45 3.21865e-07
3423.32 3.21865e-07
3858.46 3.21865e-07
4046.68 3.21865e-07
3437.32 3.21865e-07
3538.85 3.21865e-07
3878.79 3.21865e-07
4233.59 3.21865e-07
4951.72 3.21865e-07
5339.42 3.21865e-07
3329.57 3.21865e-07
3444.55 3.21865e-07
2974.31 3.21865e-07
2856.47 3.21865e-07
3495.25 3.21865e-07
3646.56 3.21865e-07
8792.06 3.21865e-07
9346.26 3.21865e-07
END
$hits1 << END
1055.02 0.000369549
1087.63 0.000362873
1804.36 0.000377655
1937.96 0.000377178
1988.23 0.000349998
2165.41 0.000195026
1088.82 0.000369549
1117.37 0.000362873
2278.64 0.000377655
2503.57 0.000377178
2547.07 0.000349998
2878.05 0.000195026
1070.73 0.000369549
1100.67 0.000362873
1401.12 0.000284672
1423.95 0.00029707
1675.77 0.000234604
1796.69 0.000130653
5269.44 0.000281334
5763.94 0.000110626
END
$hits2 << END
3026.51 2.38419e-07
3104.21 2.38419e-07
3039.7 2.38419e-07
3193.45 2.38419e-07
3527.23 2.38419e-07
3719.62 2.38419e-07
3129.7 2.38419e-07
3194.23 2.38419e-07
3728.3 2.38419e-07
3966.35 2.38419e-07
4592.89 2.38419e-07
4915.32 2.38419e-07
3052.3 2.38419e-07
3131.35 2.38419e-07
2792.45 2.38419e-07
2701.51 2.38419e-07
3275 2.38419e-07
3414.58 2.38419e-07
8299.9 2.38419e-07
8759.16 2.38419e-07
1509.07 2.38419e-07
4393.67 2.38419e-07
1889.52 2.38419e-07
3778.38 2.38419e-07
END
$hits3 << END
843.015 0.000369549
872.789 0.000362873
1564.1 0.000377655
1708.85 0.000377178
1688.03 0.000349998
1857.7 0.000195026
888.25 0.000369549
912.592 0.000362873
1926.23 0.000377655
2146.89 0.000377178
2136.18 0.000349998
2426 0.000195026
869.201 0.000369549
895.668 0.000362873
1078.39 0.000284672
1101.76 0.00029707
1308.47 0.000234604
1394.86 0.000130653
4345.6 0.000281334
4779.11 0.000110626
END
$hits4 << END
2161.41 1.76606e-07
2211.51 1.76606e-07
2155.72 1.76606e-07
2290.35 1.76606e-07
2461.35 1.76606e-07
2608.09 1.76606e-07
2161.19 1.76606e-07
2236.65 1.76606e-07
2229.12 1.76606e-07
2371.4 1.76606e-07
2699.84 1.76606e-07
2892.53 1.76606e-07
2034.27 1.76606e-07
2119.47 1.76606e-07
1581.12 1.76606e-07
1539.31 1.76606e-07
1852.35 1.76606e-07
1940.26 1.76606e-07
5066.56 1.76606e-07
5346.82 1.76606e-07
END
$hits5 << END
479.173 0.000369549
494.272 0.000362873
1031.9 0.000377655
1152.59 0.000377178
1083.28 0.000349998
1217.48 0.000195503
503.608 0.000369549
517.306 0.000362873
1062.67 0.000377655
1196.7 0.000377178
1196.74 0.000349998
1357.3 0.000195503
491.05 0.000369549
507.056 0.000362873
619.597 0.000284672
631.216 0.00029707
745.973 0.000234604
787.787 0.00013113
2496.23 0.000281334
2772.48 0.000110626
END
$hits_front << END
9346.26 3.21865e-07
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
set xrange [137.469:2169.01]; set yrange [2.14846e-05:0.0175858]
set xlabel 'pictures a second  (more is better)'; set ylabel 'picture: RMSE of a channel  (less is better)' offset -1.5
set xtics ('150' 150, '200' 200, '300' 300, '500' 500, '700' 700, '1000' 1000, '1500' 1500, '2000' 2000)
set ytics ("same\nbits" 5.37116e-05, '10⁻³' 1e-3, '10⁻²' 1e-2)
set object rectangle from graph 0, graph 0 to graph 1, first 9.13098e-05 fs solid noborder fc rgb '#eeeeee' behind
set arrow from first 1807.51,0.000832694 to graph 1.0,0.5453 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.5453 to graph 1.015,0.5453 nohead lw 0.8 lc rgb '#999999'
set label 'fast: irregular exact' at graph 1.02,0.5453 left
set arrow from first 1546.95,0.000429693 to graph 1.0,0.4466 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.4466 to graph 1.015,0.4466 nohead lw 0.8 lc rgb '#999999'
set label 'robust: irregular exact' at graph 1.02,0.4466 left
set arrow from first 1314.68,3.97864e-05 to graph 1.0,0.0919 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.0919 to graph 1.015,0.0919 nohead lw 0.8 lc rgb '#999999'
set label 'double: irregular exact' at graph 1.02,0.0919 left
$picture0 << END
370.736 0.000832694
380.629 0.000832694
761.232 0.000832694
911.56 0.000832694
812.744 0.000832694
934.929 0.000832694
389.126 0.000832694
403.034 0.000832694
762.567 0.000832694
887.887 0.000832694
844.252 0.000832694
981.374 0.000832694
376.801 0.000832694
385.199 0.000832694
718.03 0.000832694
750.661 0.000832694
747.055 0.000832694
820.984 0.000832694
1520.31 0.000832694
1807.51 0.000832694
END
$picture1 << END
343.467 0.00680517
352.53 0.00673666
750.193 0.00687082
878.526 0.00703431
768.321 0.00680154
898.505 0.00395185
350.812 0.00680517
359.377 0.00673666
719.963 0.00687082
852.079 0.00703431
808.453 0.00680154
934.204 0.00395185
340.707 0.00680517
345.03 0.00673666
661.936 0.00564691
704.052 0.0054363
710.727 0.00474342
782.307 0.00264172
1466.38 0.00529647
1688.37 0.00288016
END
$picture2 << END
328.91 0.000429693
336.04 0.000429693
678.316 0.000429693
817.568 0.000429693
729.831 0.000429693
831.007 0.000429693
330.779 0.000429693
342.285 0.000429693
669.08 0.000429693
794.679 0.000429693
742.578 0.000429693
855.366 0.000429693
321.029 0.000429693
327.674 0.000429693
620.409 0.000429693
647.052 0.000429693
645.97 0.000429693
706.374 0.000429693
1301.81 0.000429693
1546.95 0.000429693
164.963 0.000429693
646.396 0.000429693
698.744 0.000429693
816.053 0.000429693
END
$picture3 << END
291.169 0.0067695
299.511 0.00670134
628.773 0.00683399
762.253 0.00699834
676.215 0.00676407
781.384 0.00388701
299.02 0.0067695
303.932 0.00670134
632.743 0.00683399
749.614 0.00699834
672.866 0.00676407
815.647 0.00388701
292.409 0.0067695
294.251 0.00670134
572.04 0.00560204
605.492 0.0053897
609.578 0.00468955
661.559 0.0025437
1270.02 0.00525394
1437.18 0.00279052
END
$picture4 << END
255.475 3.97864e-05
262.407 3.97864e-05
580.208 3.97864e-05
699.418 3.97864e-05
591.53 3.97864e-05
694.937 3.97864e-05
262.471 3.97864e-05
268.894 3.97864e-05
567.656 3.97864e-05
681.023 3.97864e-05
609.853 3.97864e-05
723.599 3.97864e-05
253.295 3.97864e-05
258.701 3.97864e-05
502.46 3.97864e-05
533.313 3.97864e-05
522.21 3.97864e-05
575.487 3.97864e-05
1109.69 3.97864e-05
1314.68 3.97864e-05
END
$picture5 << END
252.203 0.00675584
257.214 0.00668754
551.983 0.00682047
660.842 0.00698514
569.736 0.0067504
663.989 0.00386319
253.896 0.00675584
260.061 0.00668754
543.865 0.00682047
660.969 0.00698514
589.157 0.0067504
702.341 0.00386319
246.321 0.00675584
250.084 0.00668754
481.392 0.00558553
517.633 0.00537259
514.819 0.00466981
567.521 0.00250715
1085.6 0.00523634
1266.87 0.00275724
END
$picture_front << END
1314.68 3.97864e-05
1546.95 0.000429693
1807.51 0.000832694
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
set xrange [399.311:11215.5]; set yrange [9.53674e-08:0.000944138]
set xlabel 'million nearest hits a second  (more is better)'; set ylabel 'wrong hits  (less is better)' offset -1.5
set label 'teapot: speed against accuracy (GPU)' at screen 0.02, screen 0.9774 font ',20'
set label '1024x1024 primary and 1,048,576 random rays a scene; 2,097,152 in all compared with brute force in double; pictures of 512x512' at screen 0.02, screen 0.9516
set xtics ('500' 500, '1000' 1000, '2000' 2000, '5000' 5000, '10000' 10000)
set ytics ("none of\n2,097,152" 2.38419e-07, '0.0001 %%' 1e-6, '0.001 %%' 1e-5, '0.01 %%' 1e-4)
set object rectangle from graph 0, graph 0 to graph 1, first 4.05312e-07 fs solid noborder fc rgb '#eeeeee' behind
set arrow from first 9346.26,3.21865e-07 to graph 1.0,0.1322 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.1322 to graph 1.015,0.1322 nohead lw 0.8 lc rgb '#999999'
set label 'fast: irregular exact' at graph 1.02,0.1322 left
$hits0 << END
3505.35 3.21865e-07
3519.85 3.21865e-07
3246.45 3.21865e-07
3423.32 3.21865e-07
3858.46 3.21865e-07
4046.68 3.21865e-07
3437.32 3.21865e-07
3538.85 3.21865e-07
3878.79 3.21865e-07
4233.59 3.21865e-07
4951.72 3.21865e-07
5339.42 3.21865e-07
3329.57 3.21865e-07
3444.55 3.21865e-07
2974.31 3.21865e-07
2856.47 3.21865e-07
3495.25 3.21865e-07
3646.56 3.21865e-07
8792.06 3.21865e-07
9346.26 3.21865e-07
END
$hits1 << END
1055.02 0.000369549
1087.63 0.000362873
1804.36 0.000377655
1937.96 0.000377178
1988.23 0.000349998
2165.41 0.000195026
1088.82 0.000369549
1117.37 0.000362873
2278.64 0.000377655
2503.57 0.000377178
2547.07 0.000349998
2878.05 0.000195026
1070.73 0.000369549
1100.67 0.000362873
1401.12 0.000284672
1423.95 0.00029707
1675.77 0.000234604
1796.69 0.000130653
5269.44 0.000281334
5763.94 0.000110626
END
$hits2 << END
3026.51 2.38419e-07
3104.21 2.38419e-07
3039.7 2.38419e-07
3193.45 2.38419e-07
3527.23 2.38419e-07
3719.62 2.38419e-07
3129.7 2.38419e-07
3194.23 2.38419e-07
3728.3 2.38419e-07
3966.35 2.38419e-07
4592.89 2.38419e-07
4915.32 2.38419e-07
3052.3 2.38419e-07
3131.35 2.38419e-07
2792.45 2.38419e-07
2701.51 2.38419e-07
3275 2.38419e-07
3414.58 2.38419e-07
8299.9 2.38419e-07
8759.16 2.38419e-07
1509.07 2.38419e-07
4393.67 2.38419e-07
1889.52 2.38419e-07
3778.38 2.38419e-07
END
$hits3 << END
843.015 0.000369549
872.789 0.000362873
1564.1 0.000377655
1708.85 0.000377178
1688.03 0.000349998
1857.7 0.000195026
888.25 0.000369549
912.592 0.000362873
1926.23 0.000377655
2146.89 0.000377178
2136.18 0.000349998
2426 0.000195026
869.201 0.000369549
895.668 0.000362873
1078.39 0.000284672
1101.76 0.00029707
1308.47 0.000234604
1394.86 0.000130653
4345.6 0.000281334
4779.11 0.000110626
END
$hits4 << END
2161.41 1.76606e-07
2211.51 1.76606e-07
2155.72 1.76606e-07
2290.35 1.76606e-07
2461.35 1.76606e-07
2608.09 1.76606e-07
2161.19 1.76606e-07
2236.65 1.76606e-07
2229.12 1.76606e-07
2371.4 1.76606e-07
2699.84 1.76606e-07
2892.53 1.76606e-07
2034.27 1.76606e-07
2119.47 1.76606e-07
1581.12 1.76606e-07
1539.31 1.76606e-07
1852.35 1.76606e-07
1940.26 1.76606e-07
5066.56 1.76606e-07
5346.82 1.76606e-07
END
$hits5 << END
479.173 0.000369549
494.272 0.000362873
1031.9 0.000377655
1152.59 0.000377178
1083.28 0.000349998
1217.48 0.000195503
503.608 0.000369549
517.306 0.000362873
1062.67 0.000377655
1196.7 0.000377178
1196.74 0.000349998
1357.3 0.000195503
491.05 0.000369549
507.056 0.000362873
619.597 0.000284672
631.216 0.00029707
745.973 0.000234604
787.787 0.00013113
2496.23 0.000281334
2772.48 0.000110626
END
$hits_front << END
9346.26 3.21865e-07
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
set xrange [137.469:2169.01]; set yrange [2.14846e-05:0.0175858]
set xlabel 'pictures a second  (more is better)'; set ylabel 'picture: RMSE of a channel  (less is better)' offset -1.5
set xtics ('150' 150, '200' 200, '300' 300, '500' 500, '700' 700, '1000' 1000, '1500' 1500, '2000' 2000)
set ytics ("same\nbits" 5.37116e-05, '10⁻³' 1e-3, '10⁻²' 1e-2)
set object rectangle from graph 0, graph 0 to graph 1, first 9.13098e-05 fs solid noborder fc rgb '#eeeeee' behind
set arrow from first 1807.51,0.000832694 to graph 1.0,0.5453 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.5453 to graph 1.015,0.5453 nohead lw 0.8 lc rgb '#999999'
set label 'fast: irregular exact' at graph 1.02,0.5453 left
set arrow from first 1546.95,0.000429693 to graph 1.0,0.4466 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.4466 to graph 1.015,0.4466 nohead lw 0.8 lc rgb '#999999'
set label 'robust: irregular exact' at graph 1.02,0.4466 left
set arrow from first 1314.68,3.97864e-05 to graph 1.0,0.0919 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.0919 to graph 1.015,0.0919 nohead lw 0.8 lc rgb '#999999'
set label 'double: irregular exact' at graph 1.02,0.0919 left
$picture0 << END
370.736 0.000832694
380.629 0.000832694
761.232 0.000832694
911.56 0.000832694
812.744 0.000832694
934.929 0.000832694
389.126 0.000832694
403.034 0.000832694
762.567 0.000832694
887.887 0.000832694
844.252 0.000832694
981.374 0.000832694
376.801 0.000832694
385.199 0.000832694
718.03 0.000832694
750.661 0.000832694
747.055 0.000832694
820.984 0.000832694
1520.31 0.000832694
1807.51 0.000832694
END
$picture1 << END
343.467 0.00680517
352.53 0.00673666
750.193 0.00687082
878.526 0.00703431
768.321 0.00680154
898.505 0.00395185
350.812 0.00680517
359.377 0.00673666
719.963 0.00687082
852.079 0.00703431
808.453 0.00680154
934.204 0.00395185
340.707 0.00680517
345.03 0.00673666
661.936 0.00564691
704.052 0.0054363
710.727 0.00474342
782.307 0.00264172
1466.38 0.00529647
1688.37 0.00288016
END
$picture2 << END
328.91 0.000429693
336.04 0.000429693
678.316 0.000429693
817.568 0.000429693
729.831 0.000429693
831.007 0.000429693
330.779 0.000429693
342.285 0.000429693
669.08 0.000429693
794.679 0.000429693
742.578 0.000429693
855.366 0.000429693
321.029 0.000429693
327.674 0.000429693
620.409 0.000429693
647.052 0.000429693
645.97 0.000429693
706.374 0.000429693
1301.81 0.000429693
1546.95 0.000429693
164.963 0.000429693
646.396 0.000429693
698.744 0.000429693
816.053 0.000429693
END
$picture3 << END
291.169 0.0067695
299.511 0.00670134
628.773 0.00683399
762.253 0.00699834
676.215 0.00676407
781.384 0.00388701
299.02 0.0067695
303.932 0.00670134
632.743 0.00683399
749.614 0.00699834
672.866 0.00676407
815.647 0.00388701
292.409 0.0067695
294.251 0.00670134
572.04 0.00560204
605.492 0.0053897
609.578 0.00468955
661.559 0.0025437
1270.02 0.00525394
1437.18 0.00279052
END
$picture4 << END
255.475 3.97864e-05
262.407 3.97864e-05
580.208 3.97864e-05
699.418 3.97864e-05
591.53 3.97864e-05
694.937 3.97864e-05
262.471 3.97864e-05
268.894 3.97864e-05
567.656 3.97864e-05
681.023 3.97864e-05
609.853 3.97864e-05
723.599 3.97864e-05
253.295 3.97864e-05
258.701 3.97864e-05
502.46 3.97864e-05
533.313 3.97864e-05
522.21 3.97864e-05
575.487 3.97864e-05
1109.69 3.97864e-05
1314.68 3.97864e-05
END
$picture5 << END
252.203 0.00675584
257.214 0.00668754
551.983 0.00682047
660.842 0.00698514
569.736 0.0067504
663.989 0.00386319
253.896 0.00675584
260.061 0.00668754
543.865 0.00682047
660.969 0.00698514
589.157 0.0067504
702.341 0.00386319
246.321 0.00675584
250.084 0.00668754
481.392 0.00558553
517.633 0.00537259
514.819 0.00466981
567.521 0.00250715
1085.6 0.00523634
1266.87 0.00275724
END
$picture_front << END
1314.68 3.97864e-05
1546.95 0.000429693
1807.51 0.000832694
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
set xrange [366.124:7847.05]; set yrange [9.53674e-08:0.0014317]
set xlabel 'million nearest hits a second  (more is better)'; set ylabel 'wrong hits  (less is better)' offset -1.5
set label 'tetra: speed against accuracy (GPU)' at screen 0.02, screen 0.9774 font ',20'
set label '1024x1024 primary and 1,048,576 random rays a scene; 2,097,152 in all compared with brute force in double; pictures of 512x512' at screen 0.02, screen 0.9516
set xtics ('500' 500, '1000' 1000, '2000' 2000, '5000' 5000)
set ytics ("none of\n2,097,152" 2.38419e-07, '0.0001 %%' 1e-6, '0.001 %%' 1e-5, '0.01 %%' 1e-4, '0.1 %%' 1e-3)
set object rectangle from graph 0, graph 0 to graph 1, first 4.05312e-07 fs solid noborder fc rgb '#eeeeee' behind
set arrow from first 6539.21,9.53674e-07 to graph 1.0,0.2394 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.2394 to graph 1.015,0.2394 nohead lw 0.8 lc rgb '#999999'
set label 'fast: irregular exact' at graph 1.02,0.2394 left
set arrow from first 5996.52,2.38419e-07 to graph 1.0,0.0953 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.0953 to graph 1.015,0.0953 nohead lw 0.8 lc rgb '#999999'
set label 'robust: irregular exact' at graph 1.02,0.0953 left
$hits0 << END
3047.19 9.53674e-07
3162.32 9.53674e-07
2645.35 9.53674e-07
2892.14 9.53674e-07
4069.8 9.53674e-07
4332.67 9.53674e-07
3019.95 9.53674e-07
3163.85 9.53674e-07
3001.28 9.53674e-07
3299.57 9.53674e-07
4374.9 9.53674e-07
4764.87 9.53674e-07
2686.12 9.53674e-07
2889.34 9.53674e-07
2032.69 9.53674e-07
1525.09 9.53674e-07
2821.06 9.53674e-07
2453.06 9.53674e-07
6318.55 9.53674e-07
6539.21 9.53674e-07
END
$hits1 << END
1203.93 9.53674e-07
1301.92 2.3365e-05
1150.02 9.53674e-07
1461.94 3.29018e-05
1704.85 9.53674e-07
2022.34 3.57628e-05
1283.79 9.53674e-07
1390.12 2.3365e-05
1356.85 9.53674e-07
1789.23 3.29018e-05
1925.38 9.53674e-07
2303.31 3.57628e-05
1234.53 9.53674e-07
1350.28 3.76701e-05
1280.1 9.53674e-07
977.755 0.000572681
1780.24 9.53674e-07
1720.47 0.000368595
3368.77 9.53674e-07
3520.6 7.15256e-06
END
$hits2 << END
2687.22 2.38419e-07
2807.76 2.38419e-07
2396.9 2.38419e-07
2676.8 2.38419e-07
3609.8 2.38419e-07
3896.55 2.38419e-07
2774.83 2.38419e-07
2887.3 2.38419e-07
2774.36 2.38419e-07
3111.58 2.38419e-07
3920.32 2.38419e-07
4310.73 2.38419e-07
2473.9 2.38419e-07
2654.14 2.38419e-07
1928.04 2.38419e-07
1487.93 2.38419e-07
2634.72 2.38419e-07
2324.14 2.38419e-07
5844.12 2.38419e-07
5996.52 2.38419e-07
654.431 2.38419e-07
1644.86 2.38419e-07
3120.02 2.38419e-07
1692.87 2.38419e-07
2275.24 2.38419e-07
END
$hits3 << END
889.806 2.38419e-07
968.307 2.24113e-05
918.926 2.38419e-07
1217.91 3.19481e-05
1347.37 2.38419e-07
1609.19 3.48091e-05
975.02 2.38419e-07
1054.85 2.24113e-05
1083.63 2.38419e-07
1473.25 3.19481e-05
1537.57 2.38419e-07
1862.19 3.48091e-05
937.675 2.38419e-07
1022.07 3.67165e-05
1007.78 2.38419e-07
769.708 0.000571728
1393.97 2.38419e-07
1344.63 0.000367641
2721.03 2.38419e-07
2851.25 6.19888e-06
END
$hits4 << END
1620.01 1.76606e-07
1678.65 1.76606e-07
1574.25 1.76606e-07
1762 1.76606e-07
2301.12 1.76606e-07
2464.22 1.76606e-07
1587.06 1.76606e-07
1649.83 1.76606e-07
1626.93 1.76606e-07
1845.25 1.76606e-07
2330.58 1.76606e-07
2504.82 1.76606e-07
1431.76 1.76606e-07
1515.35 1.76606e-07
1168.28 1.76606e-07
895.864 1.76606e-07
1557.56 1.76606e-07
1347.48 1.76606e-07
3444.91 1.76606e-07
3550.74 1.76606e-07
END
$hits5 << END
525.132 1.76606e-07
568.588 2.24113e-05
573.599 1.76606e-07
777.008 3.19481e-05
805.803 1.76606e-07
964.843 3.48091e-05
568.627 1.76606e-07
613.984 2.24113e-05
621.672 1.76606e-07
830.811 3.19481e-05
872.929 1.76606e-07
1042.02 3.48091e-05
544.98 1.76606e-07
591.875 3.67165e-05
574.64 1.76606e-07
439.349 0.000571728
796.084 1.76606e-07
764.197 0.000367641
1517.35 1.76606e-07
1589.71 6.19888e-06
END
$hits_front << END
5996.52 2.38419e-07
6539.21 9.53674e-07
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
set xrange [1209.27:11065.2]; set yrange [1.38018e-05:0.0057173]
set xlabel 'pictures a second  (more is better)'; set ylabel 'picture: RMSE of a channel  (less is better)' offset -1.5
set xtics ('1500' 1500, '2000' 2000, '3000' 3000, '5000' 5000, '7000' 7000, '10000' 10000)
set ytics ("same\nbits" 3.45046e-05, '10⁻⁴' 1e-4, '10⁻³' 1e-3)
set object rectangle from graph 0, graph 0 to graph 1, first 5.86579e-05 fs solid noborder fc rgb '#eeeeee' behind
set arrow from first 9221.01,0.00135754 to graph 1.0,0.7614 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.7614 to graph 1.015,0.7614 nohead lw 0.8 lc rgb '#999999'
set label 'fast: irregular exact' at graph 1.02,0.7614 left
set arrow from first 8127.44,0.000276037 to graph 1.0,0.4971 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.4971 to graph 1.015,0.4971 nohead lw 0.8 lc rgb '#999999'
set label 'robust: irregular exact' at graph 1.02,0.4971 left
set arrow from first 6125.05,2.5559e-05 to graph 1.0,0.1022 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.1022 to graph 1.015,0.1022 nohead lw 0.8 lc rgb '#999999'
set label 'double: irregular exact' at graph 1.02,0.1022 left
$picture0 << END
4857.01 0.00135754
5367.57 0.00135754
4312.72 0.00135754
5437.62 0.00135754
6933.66 0.00135754
8187.06 0.00135754
5058.27 0.00135754
5523.15 0.00135754
4091.39 0.00135754
5083.78 0.00135754
6839.57 0.00135754
7869.55 0.00135754
4575.4 0.00135754
5082.95 0.00135754
4158.35 0.00135754
3274.31 0.00135754
6009.62 0.00135754
6027 0.00135754
9071.12 0.00135754
9221.01 0.00135754
END
$picture1 << END
4707.03 0.00135754
5150.82 0.00135754
4363.92 0.00135754
5390.72 0.00135754
6476.68 0.00135754
7767.83 0.00135754
4699.95 0.00135754
5100.38 0.00135754
3834.36 0.00135754
4948.54 0.00135754
6391.9 0.00135754
7631.26 0.00135754
4468.75 0.00135754
4903.5 0.00135754
3990.04 0.00135754
3079.42 0.00167885
5546.68 0.00135754
5817.2 0.00228692
8549.93 0.00135754
8531.26 0.00135754
END
$picture2 << END
4466.2 0.000276037
4999.2 0.000276037
4071.66 0.000276037
5106.21 0.000276037
6490.13 0.000276037
7445.79 0.000276037
4368.8 0.000276037
4712 0.000276037
3722.45 0.000276037
4631 0.000276037
6053.86 0.000276037
6984.8 0.000276037
4096.75 0.000276037
4479 0.000276037
3631.19 0.000276037
2858.84 0.000276037
5348.28 0.000276037
5264.49 0.000276037
8025.17 0.000276037
8127.44 0.000276037
1451.13 0.000276037
3067.33 0.000276037
5323.68 0.000276037
3488.5 0.000276037
3087.94 0.000276037
END
$picture3 << END
3832 0.000276037
4125.96 0.000276037
3495.13 0.000276037
4768.81 0.000276037
5304.7 0.000276037
6488.79 0.000276037
3721.57 0.000276037
3929.83 0.000276037
3271.57 0.000276037
4133.05 0.000276037
5132.21 0.000276037
6246.25 0.000276037
3392.68 0.000276037
3832.47 0.000276037
3173.88 0.000276037
2479.57 0.00102558
4492.52 0.000276037
4557.39 0.00186099
6981.68 0.000276037
7218.76 0.000276037
END
$picture4 << END
3247.43 2.5559e-05
3529.88 2.5559e-05
3278.77 2.5559e-05
4293.17 2.5559e-05
4359.65 2.5559e-05
5367.57 2.5559e-05
3157.2 2.5559e-05
3382.03 2.5559e-05
2930.42 2.5559e-05
3786.04 2.5559e-05
4306.19 2.5559e-05
5138.96 2.5559e-05
2922.75 2.5559e-05
3256.9 2.5559e-05
2794.67 2.5559e-05
2213.96 2.5559e-05
3707 2.5559e-05
3856.12 2.5559e-05
5882.91 2.5559e-05
6125.05 2.5559e-05
END
$picture5 << END
3116.59 2.5559e-05
3442.01 2.5559e-05
2941.45 2.5559e-05
3828.25 2.5559e-05
3923.41 2.5559e-05
4714.85 2.5559e-05
2981.59 2.5559e-05
3334.76 2.5559e-05
2795.17 2.5559e-05
3578.38 2.5559e-05
3961.21 2.5559e-05
4690.08 2.5559e-05
2833.95 2.5559e-05
3174.85 2.5559e-05
2690.72 2.5559e-05
2113.34 0.000987729
3481.51 2.5559e-05
3676.47 0.0018404
5644.87 2.5559e-05
5933.17 2.5559e-05
END
$picture_front << END
6125.05 2.5559e-05
8127.44 0.000276037
9221.01 0.00135754
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
set xrange [366.124:7847.05]; set yrange [9.53674e-08:0.0014317]
set xlabel 'million nearest hits a second  (more is better)'; set ylabel 'wrong hits  (less is better)' offset -1.5
set label 'tetra: speed against accuracy (GPU)' at screen 0.02, screen 0.9774 font ',20'
set label '1024x1024 primary and 1,048,576 random rays a scene; 2,097,152 in all compared with brute force in double; pictures of 512x512' at screen 0.02, screen 0.9516
set xtics ('500' 500, '1000' 1000, '2000' 2000, '5000' 5000)
set ytics ("none of\n2,097,152" 2.38419e-07, '0.0001 %%' 1e-6, '0.001 %%' 1e-5, '0.01 %%' 1e-4, '0.1 %%' 1e-3)
set object rectangle from graph 0, graph 0 to graph 1, first 4.05312e-07 fs solid noborder fc rgb '#eeeeee' behind
set arrow from first 6539.21,9.53674e-07 to graph 1.0,0.2394 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.2394 to graph 1.015,0.2394 nohead lw 0.8 lc rgb '#999999'
set label 'fast: irregular exact' at graph 1.02,0.2394 left
set arrow from first 5996.52,2.38419e-07 to graph 1.0,0.0953 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.0953 to graph 1.015,0.0953 nohead lw 0.8 lc rgb '#999999'
set label 'robust: irregular exact' at graph 1.02,0.0953 left
$hits0 << END
3047.19 9.53674e-07
3162.32 9.53674e-07
2645.35 9.53674e-07
2892.14 9.53674e-07
4069.8 9.53674e-07
4332.67 9.53674e-07
3019.95 9.53674e-07
3163.85 9.53674e-07
3001.28 9.53674e-07
3299.57 9.53674e-07
4374.9 9.53674e-07
4764.87 9.53674e-07
2686.12 9.53674e-07
2889.34 9.53674e-07
2032.69 9.53674e-07
1525.09 9.53674e-07
2821.06 9.53674e-07
2453.06 9.53674e-07
6318.55 9.53674e-07
6539.21 9.53674e-07
END
$hits1 << END
1203.93 9.53674e-07
1301.92 2.3365e-05
1150.02 9.53674e-07
1461.94 3.29018e-05
1704.85 9.53674e-07
2022.34 3.57628e-05
1283.79 9.53674e-07
1390.12 2.3365e-05
1356.85 9.53674e-07
1789.23 3.29018e-05
1925.38 9.53674e-07
2303.31 3.57628e-05
1234.53 9.53674e-07
1350.28 3.76701e-05
1280.1 9.53674e-07
977.755 0.000572681
1780.24 9.53674e-07
1720.47 0.000368595
3368.77 9.53674e-07
3520.6 7.15256e-06
END
$hits2 << END
2687.22 2.38419e-07
2807.76 2.38419e-07
2396.9 2.38419e-07
2676.8 2.38419e-07
3609.8 2.38419e-07
3896.55 2.38419e-07
2774.83 2.38419e-07
2887.3 2.38419e-07
2774.36 2.38419e-07
3111.58 2.38419e-07
3920.32 2.38419e-07
4310.73 2.38419e-07
2473.9 2.38419e-07
2654.14 2.38419e-07
1928.04 2.38419e-07
1487.93 2.38419e-07
2634.72 2.38419e-07
2324.14 2.38419e-07
5844.12 2.38419e-07
5996.52 2.38419e-07
654.431 2.38419e-07
1644.86 2.38419e-07
3120.02 2.38419e-07
1692.87 2.38419e-07
2275.24 2.38419e-07
END
$hits3 << END
889.806 2.38419e-07
968.307 2.24113e-05
918.926 2.38419e-07
1217.91 3.19481e-05
1347.37 2.38419e-07
1609.19 3.48091e-05
975.02 2.38419e-07
1054.85 2.24113e-05
1083.63 2.38419e-07
1473.25 3.19481e-05
1537.57 2.38419e-07
1862.19 3.48091e-05
937.675 2.38419e-07
1022.07 3.67165e-05
1007.78 2.38419e-07
769.708 0.000571728
1393.97 2.38419e-07
1344.63 0.000367641
2721.03 2.38419e-07
2851.25 6.19888e-06
END
$hits4 << END
1620.01 1.76606e-07
1678.65 1.76606e-07
1574.25 1.76606e-07
1762 1.76606e-07
2301.12 1.76606e-07
2464.22 1.76606e-07
1587.06 1.76606e-07
1649.83 1.76606e-07
1626.93 1.76606e-07
1845.25 1.76606e-07
2330.58 1.76606e-07
2504.82 1.76606e-07
1431.76 1.76606e-07
1515.35 1.76606e-07
1168.28 1.76606e-07
895.864 1.76606e-07
1557.56 1.76606e-07
1347.48 1.76606e-07
3444.91 1.76606e-07
3550.74 1.76606e-07
END
$hits5 << END
525.132 1.76606e-07
568.588 2.24113e-05
573.599 1.76606e-07
777.008 3.19481e-05
805.803 1.76606e-07
964.843 3.48091e-05
568.627 1.76606e-07
613.984 2.24113e-05
621.672 1.76606e-07
830.811 3.19481e-05
872.929 1.76606e-07
1042.02 3.48091e-05
544.98 1.76606e-07
591.875 3.67165e-05
574.64 1.76606e-07
439.349 0.000571728
796.084 1.76606e-07
764.197 0.000367641
1517.35 1.76606e-07
1589.71 6.19888e-06
END
$hits_front << END
5996.52 2.38419e-07
6539.21 9.53674e-07
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
set xrange [1209.27:11065.2]; set yrange [1.38018e-05:0.0057173]
set xlabel 'pictures a second  (more is better)'; set ylabel 'picture: RMSE of a channel  (less is better)' offset -1.5
set xtics ('1500' 1500, '2000' 2000, '3000' 3000, '5000' 5000, '7000' 7000, '10000' 10000)
set ytics ("same\nbits" 3.45046e-05, '10⁻⁴' 1e-4, '10⁻³' 1e-3)
set object rectangle from graph 0, graph 0 to graph 1, first 5.86579e-05 fs solid noborder fc rgb '#eeeeee' behind
set arrow from first 9221.01,0.00135754 to graph 1.0,0.7614 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.7614 to graph 1.015,0.7614 nohead lw 0.8 lc rgb '#999999'
set label 'fast: irregular exact' at graph 1.02,0.7614 left
set arrow from first 8127.44,0.000276037 to graph 1.0,0.4971 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.4971 to graph 1.015,0.4971 nohead lw 0.8 lc rgb '#999999'
set label 'robust: irregular exact' at graph 1.02,0.4971 left
set arrow from first 6125.05,2.5559e-05 to graph 1.0,0.1022 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.1022 to graph 1.015,0.1022 nohead lw 0.8 lc rgb '#999999'
set label 'double: irregular exact' at graph 1.02,0.1022 left
$picture0 << END
4857.01 0.00135754
5367.57 0.00135754
4312.72 0.00135754
5437.62 0.00135754
6933.66 0.00135754
8187.06 0.00135754
5058.27 0.00135754
5523.15 0.00135754
4091.39 0.00135754
5083.78 0.00135754
6839.57 0.00135754
7869.55 0.00135754
4575.4 0.00135754
5082.95 0.00135754
4158.35 0.00135754
3274.31 0.00135754
6009.62 0.00135754
6027 0.00135754
9071.12 0.00135754
9221.01 0.00135754
END
$picture1 << END
4707.03 0.00135754
5150.82 0.00135754
4363.92 0.00135754
5390.72 0.00135754
6476.68 0.00135754
7767.83 0.00135754
4699.95 0.00135754
5100.38 0.00135754
3834.36 0.00135754
4948.54 0.00135754
6391.9 0.00135754
7631.26 0.00135754
4468.75 0.00135754
4903.5 0.00135754
3990.04 0.00135754
3079.42 0.00167885
5546.68 0.00135754
5817.2 0.00228692
8549.93 0.00135754
8531.26 0.00135754
END
$picture2 << END
4466.2 0.000276037
4999.2 0.000276037
4071.66 0.000276037
5106.21 0.000276037
6490.13 0.000276037
7445.79 0.000276037
4368.8 0.000276037
4712 0.000276037
3722.45 0.000276037
4631 0.000276037
6053.86 0.000276037
6984.8 0.000276037
4096.75 0.000276037
4479 0.000276037
3631.19 0.000276037
2858.84 0.000276037
5348.28 0.000276037
5264.49 0.000276037
8025.17 0.000276037
8127.44 0.000276037
1451.13 0.000276037
3067.33 0.000276037
5323.68 0.000276037
3488.5 0.000276037
3087.94 0.000276037
END
$picture3 << END
3832 0.000276037
4125.96 0.000276037
3495.13 0.000276037
4768.81 0.000276037
5304.7 0.000276037
6488.79 0.000276037
3721.57 0.000276037
3929.83 0.000276037
3271.57 0.000276037
4133.05 0.000276037
5132.21 0.000276037
6246.25 0.000276037
3392.68 0.000276037
3832.47 0.000276037
3173.88 0.000276037
2479.57 0.00102558
4492.52 0.000276037
4557.39 0.00186099
6981.68 0.000276037
7218.76 0.000276037
END
$picture4 << END
3247.43 2.5559e-05
3529.88 2.5559e-05
3278.77 2.5559e-05
4293.17 2.5559e-05
4359.65 2.5559e-05
5367.57 2.5559e-05
3157.2 2.5559e-05
3382.03 2.5559e-05
2930.42 2.5559e-05
3786.04 2.5559e-05
4306.19 2.5559e-05
5138.96 2.5559e-05
2922.75 2.5559e-05
3256.9 2.5559e-05
2794.67 2.5559e-05
2213.96 2.5559e-05
3707 2.5559e-05
3856.12 2.5559e-05
5882.91 2.5559e-05
6125.05 2.5559e-05
END
$picture5 << END
3116.59 2.5559e-05
3442.01 2.5559e-05
2941.45 2.5559e-05
3828.25 2.5559e-05
3923.41 2.5559e-05
4714.85 2.5559e-05
2981.59 2.5559e-05
3334.76 2.5559e-05
2795.17 2.5559e-05
3578.38 2.5559e-05
3961.21 2.5559e-05
4690.08 2.5559e-05
2833.95 2.5559e-05
3174.85 2.5559e-05
2690.72 2.5559e-05
2113.34 0.000987729
3481.51 2.5559e-05
3676.47 0.0018404
5644.87 2.5559e-05
5933.17 2.5559e-05
END
$picture_front << END
6125.05 2.5559e-05
8127.44 0.000276037
9221.01 0.00135754
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
set xrange [620.113:16633.6]; set yrange [9.53674e-08:0.0170791]
set xlabel 'million nearest hits a second  (more is better)'; set ylabel 'wrong hits  (less is better)' offset -1.5
set label 'tree: speed against accuracy (GPU)' at screen 0.02, screen 0.9774 font ',20'
set label '1024x1024 primary and 1,048,576 random rays a scene; 2,097,152 in all compared with brute force in double; pictures of 512x512' at screen 0.02, screen 0.9516
set xtics ('1000' 1000, '2000' 2000, '5000' 5000, '10000' 10000)
set ytics ("none of\n2,097,152" 2.38419e-07, '0.0001 %%' 1e-6, '0.001 %%' 1e-5, '0.01 %%' 1e-4, '0.1 %%' 1e-3, '1 %%' 1e-2)
set object rectangle from graph 0, graph 0 to graph 1, first 4.05312e-07 fs solid noborder fc rgb '#eeeeee' behind
set arrow from first 13861.3,0.00682402 to graph 1.0,0.9242 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.9242 to graph 1.015,0.9242 nohead lw 0.8 lc rgb '#999999'
set label 'fast, study: irregular exact' at graph 1.02,0.9242 left
set arrow from first 13277.1,0.00126934 to graph 1.0,0.7851 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.7851 to graph 1.015,0.7851 nohead lw 0.8 lc rgb '#999999'
set label 'fast: irregular exact' at graph 1.02,0.7851 left
set arrow from first 12224.6,2.38419e-07 to graph 1.0,0.0758 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.0758 to graph 1.015,0.0758 nohead lw 0.8 lc rgb '#999999'
set label 'robust: irregular exact' at graph 1.02,0.0758 left
$hits0 << END
1540.25 0.00126934
1599.26 0.00126934
2893.04 0.00126934
3008.45 0.00126934
1618.61 0.00126934
1649.04 0.00126934
2607.67 0.00126934
2738.77 0.00126934
1640.66 0.00126934
1680.02 0.00126934
4278.09 0.00126934
4502.95 0.00126934
12632.2 0.00126934
13277.1 0.00126934
END
$hits1 << END
891.877 0.00209665
916.306 0.00218582
1524.73 0.00253057
1560.86 0.00226974
952.53 0.00209665
976.954 0.00218582
1473.71 0.00253057
1532.11 0.00226974
990.853 0.00209713
1012.31 0.00207329
4256.69 0.00177336
4466.13 0.00159454
12473.5 0.00683165
13861.3 0.00682402
END
$hits2 << END
1584.56 2.38419e-07
1631.55 2.38419e-07
2579.35 2.38419e-07
2681.62 2.38419e-07
1617.21 2.38419e-07
1654.41 2.38419e-07
2433.03 2.38419e-07
2532.4 2.38419e-07
1663.14 2.38419e-07
1675.86 2.38419e-07
4180.13 2.38419e-07
4351.95 2.38419e-07
11389.6 2.38419e-07
12224.6 2.38419e-07
974.73 2.38419e-07
1831.89 2.38419e-07
2023.84 2.38419e-07
END
$hits3 << END
906.069 0.000859737
933.881 0.00095129
1373.86 0.00127172
1405.84 0.00100994
950.748 0.000859737
971.695 0.00095129
1338.1 0.00127172
1381.74 0.00100994
1013.91 0.000860214
1024.7 0.000838757
3796.33 0.000521183
3962.51 0.000339508
10741.8 0.00557613
12445.1 0.00557041
END
$hits4 << END
885.55 1.76606e-07
910.526 1.76606e-07
1852.29 1.76606e-07
1937.27 1.76606e-07
900.727 1.76606e-07
921.835 1.76606e-07
1439.78 1.76606e-07
1502.36 1.76606e-07
978.178 1.76606e-07
998.446 1.76606e-07
2601.98 1.76606e-07
2743.01 1.76606e-07
7637.34 1.76606e-07
8062 1.76606e-07
END
$hits5 << END
1009.47 0.00127172
1042.17 0.00100994
744.135 0.00127172
765.214 0.00100994
2122.9 0.000521183
2239.32 0.000339508
6829.51 0.00557613
7656.07 0.00557041
END
$hits_front << END
12224.6 2.38419e-07
13277.1 0.00126934
13861.3 0.00682402
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
set xrange [106.121:4828.12]; set yrange [4.99422e-05:0.0739815]
set xlabel 'pictures a second  (more is better)'; set ylabel 'picture: RMSE of a channel  (less is better)' offset -1.5
set xtics ('200' 200, '500' 500, '1000' 1000, '2000' 2000)
set ytics ("same\nbits" 0.000124856, '10⁻³' 1e-3, '10⁻²' 1e-2)
set object rectangle from graph 0, graph 0 to graph 1, first 0.000212255 fs solid noborder fc rgb '#eeeeee' behind
set arrow from first 4023.43,0.0295917 to graph 1.0,0.8745 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.8745 to graph 1.015,0.8745 nohead lw 0.8 lc rgb '#999999'
set label 'fast, study: irregular exact' at graph 1.02,0.8745 left
set arrow from first 4013.1,0.0197771 to graph 1.0,0.8193 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.8193 to graph 1.015,0.8193 nohead lw 0.8 lc rgb '#999999'
set label 'fast: irregular exact' at graph 1.02,0.8193 left
set arrow from first 3347.62,0.000998845 to graph 1.0,0.4103 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.4103 to graph 1.015,0.4103 nohead lw 0.8 lc rgb '#999999'
set label 'robust: irregular exact' at graph 1.02,0.4103 left
set arrow from first 2620.55,9.24856e-05 to graph 1.0,0.0844 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.0844 to graph 1.015,0.0844 nohead lw 0.8 lc rgb '#999999'
set label 'double: irregular exact' at graph 1.02,0.0844 left
$picture0 << END
160.059 0.0197771
163.793 0.0197771
1188.08 0.0197771
1235.28 0.0197771
158.843 0.0197771
163.311 0.0197771
1036.48 0.0197771
1084.92 0.0197771
167.207 0.0197771
169.099 0.0197771
1150.25 0.0197771
1187.54 0.0197771
3606.46 0.0197771
4013.1 0.0197771
END
$picture1 << END
159.435 0.0201229
161.842 0.0201961
1199.66 0.0210265
1242 0.0208214
158.871 0.0201229
163.468 0.0201961
1048.41 0.0210265
1090.75 0.0208214
163.417 0.0201229
168.213 0.0201108
1147.5 0.0200881
1194.62 0.0200283
3588.24 0.0295926
4023.43 0.0295917
END
$picture2 << END
168.413 0.000998845
171.805 0.000998845
1065.86 0.000998845
1118.43 0.000998845
164.207 0.000998845
170.344 0.000998845
1001.83 0.000998845
1024.05 0.000998845
169.693 0.000998845
176.378 0.000998845
1069.91 0.000998845
1117.35 0.000998845
2983.86 0.000998845
3347.62 0.000998845
156.84 0.000998845
268.286 0.000998845
412.868 0.000998845
END
$picture3 << END
167.784 0.00408026
170.175 0.00446055
1072.48 0.00726785
1114.52 0.00665447
166.903 0.00408026
169.431 0.00446055
997.258 0.00726785
1037.72 0.00665447
170.552 0.00408026
174.982 0.00405698
1077.18 0.00376376
1115.75 0.00345327
3088.56 0.0220597
3416.05 0.0220531
END
$picture4 << END
127.345 9.24856e-05
132.687 9.24856e-05
862.999 9.24856e-05
903.546 9.24856e-05
129.126 9.24856e-05
131.052 9.24856e-05
754.341 9.24856e-05
797.435 9.24856e-05
132.732 9.24856e-05
135.772 9.24856e-05
853.847 9.24856e-05
892.092 9.24856e-05
2360.81 9.24856e-05
2620.55 9.24856e-05
END
$picture5 << END
869.792 0.00721073
894.566 0.00658548
766.665 0.00721073
802.291 0.00658548
856.12 0.00365225
884.791 0.00332386
2394.09 0.0220455
2660.03 0.0220357
END
$picture_front << END
2620.55 9.24856e-05
3347.62 0.000998845
4013.1 0.0197771
4023.43 0.0295917
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
set xrange [620.113:16633.6]; set yrange [9.53674e-08:0.0170791]
set xlabel 'million nearest hits a second  (more is better)'; set ylabel 'wrong hits  (less is better)' offset -1.5
set label 'tree: speed against accuracy (GPU)' at screen 0.02, screen 0.9774 font ',20'
set label '1024x1024 primary and 1,048,576 random rays a scene; 2,097,152 in all compared with brute force in double; pictures of 512x512' at screen 0.02, screen 0.9516
set xtics ('1000' 1000, '2000' 2000, '5000' 5000, '10000' 10000)
set ytics ("none of\n2,097,152" 2.38419e-07, '0.0001 %%' 1e-6, '0.001 %%' 1e-5, '0.01 %%' 1e-4, '0.1 %%' 1e-3, '1 %%' 1e-2)
set object rectangle from graph 0, graph 0 to graph 1, first 4.05312e-07 fs solid noborder fc rgb '#eeeeee' behind
set arrow from first 13861.3,0.00682402 to graph 1.0,0.9242 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.9242 to graph 1.015,0.9242 nohead lw 0.8 lc rgb '#999999'
set label 'fast, study: irregular exact' at graph 1.02,0.9242 left
set arrow from first 13277.1,0.00126934 to graph 1.0,0.7851 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.7851 to graph 1.015,0.7851 nohead lw 0.8 lc rgb '#999999'
set label 'fast: irregular exact' at graph 1.02,0.7851 left
set arrow from first 12224.6,2.38419e-07 to graph 1.0,0.0758 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.0758 to graph 1.015,0.0758 nohead lw 0.8 lc rgb '#999999'
set label 'robust: irregular exact' at graph 1.02,0.0758 left
$hits0 << END
1540.25 0.00126934
1599.26 0.00126934
2893.04 0.00126934
3008.45 0.00126934
1618.61 0.00126934
1649.04 0.00126934
2607.67 0.00126934
2738.77 0.00126934
1640.66 0.00126934
1680.02 0.00126934
4278.09 0.00126934
4502.95 0.00126934
12632.2 0.00126934
13277.1 0.00126934
END
$hits1 << END
891.877 0.00209665
916.306 0.00218582
1524.73 0.00253057
1560.86 0.00226974
952.53 0.00209665
976.954 0.00218582
1473.71 0.00253057
1532.11 0.00226974
990.853 0.00209713
1012.31 0.00207329
4256.69 0.00177336
4466.13 0.00159454
12473.5 0.00683165
13861.3 0.00682402
END
$hits2 << END
1584.56 2.38419e-07
1631.55 2.38419e-07
2579.35 2.38419e-07
2681.62 2.38419e-07
1617.21 2.38419e-07
1654.41 2.38419e-07
2433.03 2.38419e-07
2532.4 2.38419e-07
1663.14 2.38419e-07
1675.86 2.38419e-07
4180.13 2.38419e-07
4351.95 2.38419e-07
11389.6 2.38419e-07
12224.6 2.38419e-07
974.73 2.38419e-07
1831.89 2.38419e-07
2023.84 2.38419e-07
END
$hits3 << END
906.069 0.000859737
933.881 0.00095129
1373.86 0.00127172
1405.84 0.00100994
950.748 0.000859737
971.695 0.00095129
1338.1 0.00127172
1381.74 0.00100994
1013.91 0.000860214
1024.7 0.000838757
3796.33 0.000521183
3962.51 0.000339508
10741.8 0.00557613
12445.1 0.00557041
END
$hits4 << END
885.55 1.76606e-07
910.526 1.76606e-07
1852.29 1.76606e-07
1937.27 1.76606e-07
900.727 1.76606e-07
921.835 1.76606e-07
1439.78 1.76606e-07
1502.36 1.76606e-07
978.178 1.76606e-07
998.446 1.76606e-07
2601.98 1.76606e-07
2743.01 1.76606e-07
7637.34 1.76606e-07
8062 1.76606e-07
END
$hits5 << END
1009.47 0.00127172
1042.17 0.00100994
744.135 0.00127172
765.214 0.00100994
2122.9 0.000521183
2239.32 0.000339508
6829.51 0.00557613
7656.07 0.00557041
END
$hits_front << END
12224.6 2.38419e-07
13277.1 0.00126934
13861.3 0.00682402
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
set xrange [106.121:4828.12]; set yrange [4.99422e-05:0.0739815]
set xlabel 'pictures a second  (more is better)'; set ylabel 'picture: RMSE of a channel  (less is better)' offset -1.5
set xtics ('200' 200, '500' 500, '1000' 1000, '2000' 2000)
set ytics ("same\nbits" 0.000124856, '10⁻³' 1e-3, '10⁻²' 1e-2)
set object rectangle from graph 0, graph 0 to graph 1, first 0.000212255 fs solid noborder fc rgb '#eeeeee' behind
set arrow from first 4023.43,0.0295917 to graph 1.0,0.8745 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.8745 to graph 1.015,0.8745 nohead lw 0.8 lc rgb '#999999'
set label 'fast, study: irregular exact' at graph 1.02,0.8745 left
set arrow from first 4013.1,0.0197771 to graph 1.0,0.8193 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.8193 to graph 1.015,0.8193 nohead lw 0.8 lc rgb '#999999'
set label 'fast: irregular exact' at graph 1.02,0.8193 left
set arrow from first 3347.62,0.000998845 to graph 1.0,0.4103 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.4103 to graph 1.015,0.4103 nohead lw 0.8 lc rgb '#999999'
set label 'robust: irregular exact' at graph 1.02,0.4103 left
set arrow from first 2620.55,9.24856e-05 to graph 1.0,0.0844 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.0844 to graph 1.015,0.0844 nohead lw 0.8 lc rgb '#999999'
set label 'double: irregular exact' at graph 1.02,0.0844 left
$picture0 << END
160.059 0.0197771
163.793 0.0197771
1188.08 0.0197771
1235.28 0.0197771
158.843 0.0197771
163.311 0.0197771
1036.48 0.0197771
1084.92 0.0197771
167.207 0.0197771
169.099 0.0197771
1150.25 0.0197771
1187.54 0.0197771
3606.46 0.0197771
4013.1 0.0197771
END
$picture1 << END
159.435 0.0201229
161.842 0.0201961
1199.66 0.0210265
1242 0.0208214
158.871 0.0201229
163.468 0.0201961
1048.41 0.0210265
1090.75 0.0208214
163.417 0.0201229
168.213 0.0201108
1147.5 0.0200881
1194.62 0.0200283
3588.24 0.0295926
4023.43 0.0295917
END
$picture2 << END
168.413 0.000998845
171.805 0.000998845
1065.86 0.000998845
1118.43 0.000998845
164.207 0.000998845
170.344 0.000998845
1001.83 0.000998845
1024.05 0.000998845
169.693 0.000998845
176.378 0.000998845
1069.91 0.000998845
1117.35 0.000998845
2983.86 0.000998845
3347.62 0.000998845
156.84 0.000998845
268.286 0.000998845
412.868 0.000998845
END
$picture3 << END
167.784 0.00408026
170.175 0.00446055
1072.48 0.00726785
1114.52 0.00665447
166.903 0.00408026
169.431 0.00446055
997.258 0.00726785
1037.72 0.00665447
170.552 0.00408026
174.982 0.00405698
1077.18 0.00376376
1115.75 0.00345327
3088.56 0.0220597
3416.05 0.0220531
END
$picture4 << END
127.345 9.24856e-05
132.687 9.24856e-05
862.999 9.24856e-05
903.546 9.24856e-05
129.126 9.24856e-05
131.052 9.24856e-05
754.341 9.24856e-05
797.435 9.24856e-05
132.732 9.24856e-05
135.772 9.24856e-05
853.847 9.24856e-05
892.092 9.24856e-05
2360.81 9.24856e-05
2620.55 9.24856e-05
END
$picture5 << END
869.792 0.00721073
894.566 0.00658548
766.665 0.00721073
802.291 0.00658548
856.12 0.00365225
884.791 0.00332386
2394.09 0.0220455
2660.03 0.0220357
END
$picture_front << END
2620.55 9.24856e-05
3347.62 0.000998845
4013.1 0.0197771
4023.43 0.0295917
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
set xrange [527.255:10955.1]; set yrange [1.36239e-08:0.0198679]
set xlabel 'million nearest hits a second  (more is better)'; set ylabel 'wrong hits  (less is better)' offset -1.5
set label 'mean of 7 scenes: speed against accuracy (GPU)' at screen 0.02, screen 0.9774 font ',20'
set label '1024x1024 primary and 1,048,576 random rays a scene; 14,680,064 in all compared with brute force in double; pictures of 512x512' at screen 0.02, screen 0.9516
set xtics ('1000' 1000, '2000' 2000, '5000' 5000, '10000' 10000)
set ytics ("none of\n14,680,064" 3.40598e-08, '0.00001 %%' 1e-7, '0.0001 %%' 1e-6, '0.001 %%' 1e-5, '0.01 %%' 1e-4, '0.1 %%' 1e-3, '1 %%' 1e-2)
set object rectangle from graph 0, graph 0 to graph 1, first 5.79017e-08 fs solid noborder fc rgb '#eeeeee' behind
set arrow from first 9129.26,0.000229699 to graph 1.0,0.6857 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.6857 to graph 1.015,0.6857 nohead lw 0.8 lc rgb '#999999'
set label 'fast: irregular exact' at graph 1.02,0.6857 left
set arrow from first 8365.7,3.40598e-08 to graph 1.0,0.0646 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.0646 to graph 1.015,0.0646 nohead lw 0.8 lc rgb '#999999'
set label 'robust: irregular exact' at graph 1.02,0.0646 left
$hits0 << END
1830.44 0.000229699
1896.33 0.000229699
2600.82 0.000229699
2775.62 0.000229699
3400.19 0.000229699
3639.76 0.000229699
1849.78 0.000229699
1929.45 0.000229699
2949.57 0.000229699
3175.96 0.000229699
3998.18 0.000229699
4380.39 0.000229699
1783.4 0.000229699
1865.53 0.000229699
2105.81 0.000229699
2107.31 0.000229699
3394.36 0.000229699
3372.19 0.000229699
8089.93 0.000229699
9129.26 0.000229699
END
$hits1 << END
853.508 0.00538867
898.074 0.00519807
1451.77 0.00794717
1606.15 0.00454112
1713.3 0.00585638
1896.53 0.00247186
903.535 0.00538867
950.267 0.00519807
1719.67 0.00794717
1949.97 0.00454112
2084.69 0.00585638
2405.74 0.00247186
889.555 0.00554262
932.561 0.00522232
1313.67 0.00724963
1311.45 0.00561462
2137.31 0.00587109
2134.86 0.0029115
5876.33 0.00589139
6642.91 0.00282662
END
$hits2 << END
1678.12 3.40598e-08
1746.38 3.40598e-08
2412.08 3.40598e-08
2582.75 3.40598e-08
3075.76 3.40598e-08
3307.46 3.40598e-08
1720.18 3.40598e-08
1789.51 3.40598e-08
2771.56 3.40598e-08
3002.18 3.40598e-08
3647.25 3.40598e-08
4020.17 3.40598e-08
1659.72 3.40598e-08
1733.87 3.40598e-08
1992.25 3.40598e-08
1993.62 3.40598e-08
3176.37 3.40598e-08
3171.44 3.40598e-08
7474.64 3.40598e-08
8365.7 3.40598e-08
903.654 3.40598e-08
2635.25 3.40598e-08
1800.49 3.40598e-08
2628.46 3.40598e-08
END
$hits3 << END
740.226 0.00516919
775.806 0.00497798
1286.44 0.00773273
1437.31 0.00432321
1489.02 0.00563785
1655.76 0.00224808
777.192 0.00516919
816.375 0.00497798
1495.37 0.00773273
1712.05 0.00432321
1796.25 0.00563785
2074.12 0.00224808
764.005 0.00532327
801.105 0.00500216
1135.74 0.00703709
1127.74 0.00539998
1796.89 0.00565297
1784.71 0.00268997
4948.68 0.00567368
5659.07 0.00260305
END
$hits4 << END
991.863 2.52295e-08
1030.07 2.52295e-08
1567.69 2.52295e-08
1701.77 2.52295e-08
2086.53 2.52295e-08
2269.15 2.52295e-08
989.848 2.52295e-08
1030.14 2.52295e-08
1602.9 2.52295e-08
1751.2 2.52295e-08
2137.84 2.52295e-08
2350.96 2.52295e-08
953.683 2.52295e-08
993.975 2.52295e-08
1188.78 2.52295e-08
1178.37 2.52295e-08
1811.76 2.52295e-08
1801.35 2.52295e-08
4583.3 2.52295e-08
5058.33 2.52295e-08
END
$hits5 << END
816.744 0.00773273
933.79 0.00432348
963.314 0.00563792
1093.76 0.00224836
841.783 0.00773273
963.204 0.00432355
1007.13 0.00563792
1157.29 0.00224836
637.677 0.00703771
632.706 0.005401
984.364 0.00565304
970.735 0.00269011
2815.67 0.00567368
3181.3 0.00260319
END
$hits_front << END
8365.7 3.40598e-08
9129.26 0.000229699
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
set xrange [179.454:3080.76]; set yrange [6.27072e-05:0.0710169]
set xlabel 'pictures a second  (more is better)'; set ylabel 'picture: RMSE of a channel  (less is better)' offset -1.5
set xtics ('200' 200, '300' 300, '500' 500, '700' 700, '1000' 1000, '1500' 1500, '2000' 2000, '3000' 3000)
set ytics ("same\nbits" 0.000156768, '10⁻³' 1e-3, '10⁻²' 1e-2)
set object rectangle from graph 0, graph 0 to graph 1, first 0.000266505 fs solid noborder fc rgb '#eeeeee' behind
set arrow from first 2567.3,0.0123829 to graph 1.0,0.7516 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.7516 to graph 1.015,0.7516 nohead lw 0.8 lc rgb '#999999'
set label 'fast: irregular exact' at graph 1.02,0.7516 left
set arrow from first 2222.38,0.00125414 to graph 1.0,0.4260 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.4260 to graph 1.015,0.4260 nohead lw 0.8 lc rgb '#999999'
set label 'robust: irregular exact' at graph 1.02,0.4260 left
set arrow from first 1656.56,0.000116124 to graph 1.0,0.0876 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.0876 to graph 1.015,0.0876 nohead lw 0.8 lc rgb '#999999'
set label 'double: irregular exact' at graph 1.02,0.0876 left
$picture0 << END
410.15 0.0123829
433.172 0.0123829
637.687 0.0123829
734.995 0.0123829
1147.32 0.0123829
1317.31 0.0123829
414.892 0.0123829
436.756 0.0123829
613.194 0.0123829
706.315 0.0123829
1122.18 0.0123829
1286.39 0.0123829
408.299 0.0123829
430.049 0.0123829
549.616 0.0123829
546.689 0.0123829
1001.58 0.0123829
1054.34 0.0123829
2217.68 0.0123829
2567.3 0.0123829
END
$picture1 << END
398.377 0.0224393
418.546 0.022054
636.386 0.0284068
724.535 0.0216451
1146.14 0.0244547
1313.6 0.0180233
399.956 0.0224393
418.237 0.022054
607.65 0.0284068
693.814 0.0216451
1125.4 0.0244547
1290.16 0.0180233
393.954 0.0224395
413.377 0.0220569
534.41 0.025329
532.633 0.02287
984.198 0.023887
1039.62 0.0183201
2172.66 0.025183
2512.31 0.0193097
END
$picture2 << END
382.039 0.00125414
401.949 0.00125414
599.915 0.00125414
690.062 0.00125414
1048.25 0.00125414
1199.86 0.00125414
380.734 0.00125414
395.912 0.00125414
570.27 0.00125414
661.694 0.00125414
1026.9 0.00125414
1177.12 0.00125414
375.251 0.00125414
393.627 0.00125414
503.836 0.00125414
507.851 0.00125414
912.155 0.00125414
958.504 0.00125414
1941.13 0.00125414
2222.38 0.00125414
215.344 0.00125414
596.963 0.00125414
615.16 0.00125414
681.641 0.00125414
END
$picture3 << END
358.233 0.0189297
374.724 0.0184439
574.06 0.0258172
663.744 0.017932
1004.4 0.0213319
1154.09 0.0133385
358.274 0.0189297
371.414 0.0184439
556.594 0.0258172
634.103 0.017932
990.699 0.0213319
1144.27 0.0133385
348.414 0.0189299
365.911 0.0184474
476.971 0.0223219
478.22 0.0194445
866.477 0.0206087
908.351 0.0137241
1873.45 0.0221679
2142 0.0150525
END
$picture4 << END
259.068 0.000116124
271.389 0.000116124
452.113 0.000116124
531.785 0.000116124
781.941 0.000116124
920.488 0.000116124
257.058 0.000116124
268.828 0.000116124
434.556 0.000116124
506.803 0.000116124
759.521 0.000116124
892.943 0.000116124
254.961 0.000116124
266.453 0.000116124
372.151 0.000116124
373.697 0.000116124
665.768 0.000116124
703.835 0.000116124
1443.93 0.000116124
1656.56 0.000116124
END
$picture5 << END
435.279 0.0257929
497.316 0.0178971
741.789 0.0213012
854.048 0.0132958
426.768 0.0257929
490.411 0.0178972
746.854 0.0213012
864.378 0.0132958
363.658 0.0222991
362.402 0.0194207
648.19 0.0205768
684.976 0.0136759
1410.64 0.0221386
1608.98 0.0150145
END
$picture_front << END
1656.56 0.000116124
2222.38 0.00125414
2567.3 0.0123829
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
set xrange [527.255:10955.1]; set yrange [1.36239e-08:0.0198679]
set xlabel 'million nearest hits a second  (more is better)'; set ylabel 'wrong hits  (less is better)' offset -1.5
set label 'mean of 7 scenes: speed against accuracy (GPU)' at screen 0.02, screen 0.9774 font ',20'
set label '1024x1024 primary and 1,048,576 random rays a scene; 14,680,064 in all compared with brute force in double; pictures of 512x512' at screen 0.02, screen 0.9516
set xtics ('1000' 1000, '2000' 2000, '5000' 5000, '10000' 10000)
set ytics ("none of\n14,680,064" 3.40598e-08, '0.00001 %%' 1e-7, '0.0001 %%' 1e-6, '0.001 %%' 1e-5, '0.01 %%' 1e-4, '0.1 %%' 1e-3, '1 %%' 1e-2)
set object rectangle from graph 0, graph 0 to graph 1, first 5.79017e-08 fs solid noborder fc rgb '#eeeeee' behind
set arrow from first 9129.26,0.000229699 to graph 1.0,0.6857 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.6857 to graph 1.015,0.6857 nohead lw 0.8 lc rgb '#999999'
set label 'fast: irregular exact' at graph 1.02,0.6857 left
set arrow from first 8365.7,3.40598e-08 to graph 1.0,0.0646 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.0646 to graph 1.015,0.0646 nohead lw 0.8 lc rgb '#999999'
set label 'robust: irregular exact' at graph 1.02,0.0646 left
$hits0 << END
1830.44 0.000229699
1896.33 0.000229699
2600.82 0.000229699
2775.62 0.000229699
3400.19 0.000229699
3639.76 0.000229699
1849.78 0.000229699
1929.45 0.000229699
2949.57 0.000229699
3175.96 0.000229699
3998.18 0.000229699
4380.39 0.000229699
1783.4 0.000229699
1865.53 0.000229699
2105.81 0.000229699
2107.31 0.000229699
3394.36 0.000229699
3372.19 0.000229699
8089.93 0.000229699
9129.26 0.000229699
END
$hits1 << END
853.508 0.00538867
898.074 0.00519807
1451.77 0.00794717
1606.15 0.00454112
1713.3 0.00585638
1896.53 0.00247186
903.535 0.00538867
950.267 0.00519807
1719.67 0.00794717
1949.97 0.00454112
2084.69 0.00585638
2405.74 0.00247186
889.555 0.00554262
932.561 0.00522232
1313.67 0.00724963
1311.45 0.00561462
2137.31 0.00587109
2134.86 0.0029115
5876.33 0.00589139
6642.91 0.00282662
END
$hits2 << END
1678.12 3.40598e-08
1746.38 3.40598e-08
2412.08 3.40598e-08
2582.75 3.40598e-08
3075.76 3.40598e-08
3307.46 3.40598e-08
1720.18 3.40598e-08
1789.51 3.40598e-08
2771.56 3.40598e-08
3002.18 3.40598e-08
3647.25 3.40598e-08
4020.17 3.40598e-08
1659.72 3.40598e-08
1733.87 3.40598e-08
1992.25 3.40598e-08
1993.62 3.40598e-08
3176.37 3.40598e-08
3171.44 3.40598e-08
7474.64 3.40598e-08
8365.7 3.40598e-08
903.654 3.40598e-08
2635.25 3.40598e-08
1800.49 3.40598e-08
2628.46 3.40598e-08
END
$hits3 << END
740.226 0.00516919
775.806 0.00497798
1286.44 0.00773273
1437.31 0.00432321
1489.02 0.00563785
1655.76 0.00224808
777.192 0.00516919
816.375 0.00497798
1495.37 0.00773273
1712.05 0.00432321
1796.25 0.00563785
2074.12 0.00224808
764.005 0.00532327
801.105 0.00500216
1135.74 0.00703709
1127.74 0.00539998
1796.89 0.00565297
1784.71 0.00268997
4948.68 0.00567368
5659.07 0.00260305
END
$hits4 << END
991.863 2.52295e-08
1030.07 2.52295e-08
1567.69 2.52295e-08
1701.77 2.52295e-08
2086.53 2.52295e-08
2269.15 2.52295e-08
989.848 2.52295e-08
1030.14 2.52295e-08
1602.9 2.52295e-08
1751.2 2.52295e-08
2137.84 2.52295e-08
2350.96 2.52295e-08
953.683 2.52295e-08
993.975 2.52295e-08
1188.78 2.52295e-08
1178.37 2.52295e-08
1811.76 2.52295e-08
1801.35 2.52295e-08
4583.3 2.52295e-08
5058.33 2.52295e-08
END
$hits5 << END
816.744 0.00773273
933.79 0.00432348
963.314 0.00563792
1093.76 0.00224836
841.783 0.00773273
963.204 0.00432355
1007.13 0.00563792
1157.29 0.00224836
637.677 0.00703771
632.706 0.005401
984.364 0.00565304
970.735 0.00269011
2815.67 0.00567368
3181.3 0.00260319
END
$hits_front << END
8365.7 3.40598e-08
9129.26 0.000229699
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
set xrange [179.454:3080.76]; set yrange [6.27072e-05:0.0710169]
set xlabel 'pictures a second  (more is better)'; set ylabel 'picture: RMSE of a channel  (less is better)' offset -1.5
set xtics ('200' 200, '300' 300, '500' 500, '700' 700, '1000' 1000, '1500' 1500, '2000' 2000, '3000' 3000)
set ytics ("same\nbits" 0.000156768, '10⁻³' 1e-3, '10⁻²' 1e-2)
set object rectangle from graph 0, graph 0 to graph 1, first 0.000266505 fs solid noborder fc rgb '#eeeeee' behind
set arrow from first 2567.3,0.0123829 to graph 1.0,0.7516 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.7516 to graph 1.015,0.7516 nohead lw 0.8 lc rgb '#999999'
set label 'fast: irregular exact' at graph 1.02,0.7516 left
set arrow from first 2222.38,0.00125414 to graph 1.0,0.4260 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.4260 to graph 1.015,0.4260 nohead lw 0.8 lc rgb '#999999'
set label 'robust: irregular exact' at graph 1.02,0.4260 left
set arrow from first 1656.56,0.000116124 to graph 1.0,0.0876 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.0876 to graph 1.015,0.0876 nohead lw 0.8 lc rgb '#999999'
set label 'double: irregular exact' at graph 1.02,0.0876 left
$picture0 << END
410.15 0.0123829
433.172 0.0123829
637.687 0.0123829
734.995 0.0123829
1147.32 0.0123829
1317.31 0.0123829
414.892 0.0123829
436.756 0.0123829
613.194 0.0123829
706.315 0.0123829
1122.18 0.0123829
1286.39 0.0123829
408.299 0.0123829
430.049 0.0123829
549.616 0.0123829
546.689 0.0123829
1001.58 0.0123829
1054.34 0.0123829
2217.68 0.0123829
2567.3 0.0123829
END
$picture1 << END
398.377 0.0224393
418.546 0.022054
636.386 0.0284068
724.535 0.0216451
1146.14 0.0244547
1313.6 0.0180233
399.956 0.0224393
418.237 0.022054
607.65 0.0284068
693.814 0.0216451
1125.4 0.0244547
1290.16 0.0180233
393.954 0.0224395
413.377 0.0220569
534.41 0.025329
532.633 0.02287
984.198 0.023887
1039.62 0.0183201
2172.66 0.025183
2512.31 0.0193097
END
$picture2 << END
382.039 0.00125414
401.949 0.00125414
599.915 0.00125414
690.062 0.00125414
1048.25 0.00125414
1199.86 0.00125414
380.734 0.00125414
395.912 0.00125414
570.27 0.00125414
661.694 0.00125414
1026.9 0.00125414
1177.12 0.00125414
375.251 0.00125414
393.627 0.00125414
503.836 0.00125414
507.851 0.00125414
912.155 0.00125414
958.504 0.00125414
1941.13 0.00125414
2222.38 0.00125414
215.344 0.00125414
596.963 0.00125414
615.16 0.00125414
681.641 0.00125414
END
$picture3 << END
358.233 0.0189297
374.724 0.0184439
574.06 0.0258172
663.744 0.017932
1004.4 0.0213319
1154.09 0.0133385
358.274 0.0189297
371.414 0.0184439
556.594 0.0258172
634.103 0.017932
990.699 0.0213319
1144.27 0.0133385
348.414 0.0189299
365.911 0.0184474
476.971 0.0223219
478.22 0.0194445
866.477 0.0206087
908.351 0.0137241
1873.45 0.0221679
2142 0.0150525
END
$picture4 << END
259.068 0.000116124
271.389 0.000116124
452.113 0.000116124
531.785 0.000116124
781.941 0.000116124
920.488 0.000116124
257.058 0.000116124
268.828 0.000116124
434.556 0.000116124
506.803 0.000116124
759.521 0.000116124
892.943 0.000116124
254.961 0.000116124
266.453 0.000116124
372.151 0.000116124
373.697 0.000116124
665.768 0.000116124
703.835 0.000116124
1443.93 0.000116124
1656.56 0.000116124
END
$picture5 << END
435.279 0.0257929
497.316 0.0178971
741.789 0.0213012
854.048 0.0132958
426.768 0.0257929
490.411 0.0178972
746.854 0.0213012
864.378 0.0132958
363.658 0.0222991
362.402 0.0194207
648.19 0.0205768
684.976 0.0136759
1410.64 0.0221386
1608.98 0.0150145
END
$picture_front << END
1656.56 0.000116124
2222.38 0.00125414
2567.3 0.0123829
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
1 39.588
2 13.9146
4 13.7928
8 11.8924
16 10.0183
32 6.49642
64 3.46243
128 2.95238
256 2.75485
END
$chosen0 << END
138.128 1.36333
END
$line1 << END
1 349.623
2 102.29
4 73.7268
8 15.5846
16 4.63862
32 2.40998
64 1.66387
128 1.6064
256 1.43981
END
$chosen1 << END
93.6537 1.0424
END
$line2 << END
1 124.244
2 17.2364
4 6.54944
8 2.05344
16 0.986624
32 0.747392
64 0.909888
128 1.54211
256 1.3855
END
$chosen2 << END
43.323 0.790688
END
$line3 << END
1 84.4838
2 30.7039
4 16.1446
8 5.43242
16 2.58826
32 1.70726
64 1.83635
128 2.68224
256 2.76886
END
$chosen3 << END
50.6645 1.72013
END
$line4 << END
1 54.3519
2 23.1744
4 14.9679
8 6.06198
16 2.97584
32 1.54704
64 1.22314
128 1.43114
256 1.22541
END
$chosen4 << END
50.4685 1.20336
END
$line5 << END
1 5.24493
2 1.77488
4 0.68912
8 0.326016
16 0.200032
32 0.18784
64 0.19584
128 0.286656
256 0.32384
END
$chosen5 << END
30 0.134304
END
$line6 << END
1 40.5049
2 16.3583
4 13.1704
8 11.3965
16 8.3512
32 6.37594
64 5.82054
128 3.72736
256 2.42208
END
$chosen6 << END
278.218 0.894112
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
set xrange [0.909091:306.04]; set yrange [0.103311:454.51]
set xlabel 'voxels an axis'; set ylabel 'ms a picture'
set xtics (1, 2, 4, 8, 16, 32, 64, 128, 256, 512, 1024)
set ytics ('1' 1, '10' 10, '100' 100)
set arrow from first 16, graph 0 to first 16, graph 1 nohead lw 1.5 dt '-' lc rgb '#444444'
set label '16: what the founding study found enough' at first 16, graph 0.97 offset 1,0 left
set arrow from first 256,2.75485 to graph 1.0,0.4748 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.4748 to graph 1.015,0.4748 nohead lw 0.8 lc rgb '#999999'
set label 'balls' at graph 1.02,0.4748 left
set arrow from first 256,1.43981 to graph 1.0,0.3848 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.3848 to graph 1.015,0.3848 nohead lw 0.8 lc rgb '#999999'
set label 'gears' at graph 1.02,0.3848 left
set arrow from first 256,1.3855 to graph 1.0,0.3398 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.3398 to graph 1.015,0.3398 nohead lw 0.8 lc rgb '#999999'
set label 'mount' at graph 1.02,0.3398 left
set arrow from first 256,2.76886 to graph 1.0,0.5198 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.5198 to graph 1.015,0.5198 nohead lw 0.8 lc rgb '#999999'
set label 'rings' at graph 1.02,0.5198 left
set arrow from first 256,1.22541 to graph 1.0,0.2948 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.2948 to graph 1.015,0.2948 nohead lw 0.8 lc rgb '#999999'
set label 'teapot' at graph 1.02,0.2948 left
set arrow from first 256,0.32384 to graph 1.0,0.1362 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.1362 to graph 1.015,0.1362 nohead lw 0.8 lc rgb '#999999'
set label 'tetra' at graph 1.02,0.1362 left
set arrow from first 256,2.42208 to graph 1.0,0.4298 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.4298 to graph 1.015,0.4298 nohead lw 0.8 lc rgb '#999999'
set label 'tree' at graph 1.02,0.4298 left
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
set xrange [0.909091:306.04]; set yrange [0.103311:454.51]
set xlabel 'voxels an axis'; set ylabel 'ms a picture'
set xtics (1, 2, 4, 8, 16, 32, 64, 128, 256, 512, 1024)
set ytics ('1' 1, '10' 10, '100' 100)
set arrow from first 16, graph 0 to first 16, graph 1 nohead lw 1.5 dt '-' lc rgb '#444444'
set label '16: what the founding study found enough' at first 16, graph 0.97 offset 1,0 left
set arrow from first 256,2.75485 to graph 1.0,0.4748 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.4748 to graph 1.015,0.4748 nohead lw 0.8 lc rgb '#999999'
set label 'balls' at graph 1.02,0.4748 left
set arrow from first 256,1.43981 to graph 1.0,0.3848 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.3848 to graph 1.015,0.3848 nohead lw 0.8 lc rgb '#999999'
set label 'gears' at graph 1.02,0.3848 left
set arrow from first 256,1.3855 to graph 1.0,0.3398 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.3398 to graph 1.015,0.3398 nohead lw 0.8 lc rgb '#999999'
set label 'mount' at graph 1.02,0.3398 left
set arrow from first 256,2.76886 to graph 1.0,0.5198 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.5198 to graph 1.015,0.5198 nohead lw 0.8 lc rgb '#999999'
set label 'rings' at graph 1.02,0.5198 left
set arrow from first 256,1.22541 to graph 1.0,0.2948 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.2948 to graph 1.015,0.2948 nohead lw 0.8 lc rgb '#999999'
set label 'teapot' at graph 1.02,0.2948 left
set arrow from first 256,0.32384 to graph 1.0,0.1362 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.1362 to graph 1.015,0.1362 nohead lw 0.8 lc rgb '#999999'
set label 'tetra' at graph 1.02,0.1362 left
set arrow from first 256,2.42208 to graph 1.0,0.4298 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.4298 to graph 1.015,0.4298 nohead lw 0.8 lc rgb '#999999'
set label 'tree' at graph 1.02,0.4298 left
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
