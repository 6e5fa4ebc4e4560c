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
set xrange [0.928743:16.4066]; set yrange [3.05176e-06:0.0717163]
set xlabel 'million nearest hits a second  (more is better)'; set ylabel 'wrong hits  (less is better)' offset -1.5
set label 'balls: speed against accuracy (CPU, 2 threads)' at screen 0.02, screen 0.9774 font ',20'
set label '256x256 primary and 65,536 random rays a scene; 65,536 in all compared with brute force in double; pictures of 128x128' at screen 0.02, screen 0.9516
set xtics ('1' 1, '1.5' 1.5, '2' 2, '3' 3, '5' 5, '7' 7, '10' 10, '15' 15)
set ytics ("none of\n65,536" 7.62939e-06, '0.01 %%' 1e-4, '0.1 %%' 1e-3, '1 %%' 1e-2)
set object rectangle from graph 0, graph 0 to graph 1, first 1.297e-05 fs solid noborder fc rgb '#eeeeee' behind
set arrow from first 13.6721,0.00192261 to graph 1.0,0.6404 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.6404 to graph 1.015,0.6404 nohead lw 0.8 lc rgb '#999999'
set label 'fast, study: irregular exact' at graph 1.02,0.6404 left
set arrow from first 13.0364,0.000106812 to graph 1.0,0.3532 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.3532 to graph 1.015,0.3532 nohead lw 0.8 lc rgb '#999999'
set label 'fast: irregular exact' at graph 1.02,0.3532 left
set arrow from first 10.9795,5.6514e-06 to graph 1.0,0.0612 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.0612 to graph 1.015,0.0612 nohead lw 0.8 lc rgb '#999999'
set label 'double: irregular exact' at graph 1.02,0.0612 left
$hits0 << END
2.74717 0.000106812
2.87336 0.000106812
4.77824 0.000106812
4.59642 0.000106812
1.70226 0.000106812
1.75687 0.000106812
3.22751 0.000106812
3.55392 0.000106812
1.88595 0.000106812
1.907 0.000106812
4.66287 0.000106812
4.81223 0.000106812
12.2052 0.000106812
13.0364 0.000106812
END
$hits1 << END
3.0032 0.0286865
2.96351 0.0184937
4.95194 0.0145111
5.08379 0.00234985
1.86049 0.0286865
1.82533 0.0184937
3.21248 0.0145111
3.8139 0.00234985
2.1109 0.0286865
2.04195 0.0185394
4.91166 0.0203094
4.87522 0.00489807
12.9333 0.0109406
13.6721 0.00192261
END
$hits2 << END
1.4332 7.62939e-06
1.51505 7.62939e-06
3.77759 7.62939e-06
4.05507 7.62939e-06
1.11706 7.62939e-06
1.17375 7.62939e-06
2.64647 7.62939e-06
3.03504 7.62939e-06
1.15187 7.62939e-06
1.18694 7.62939e-06
3.32211 7.62939e-06
3.35569 7.62939e-06
9.72981 7.62939e-06
10.6862 7.62939e-06
2.05388 7.62939e-06
2.58587 7.62939e-06
END
$hits3 << END
1.66189 0.028595
1.74359 0.0184021
4.45416 0.0144196
4.02638 0.00224304
1.31524 0.028595
1.28122 0.0184021
3.41224 0.0144196
3.46015 0.00224304
1.11449 0.028595
1.29888 0.0184479
3.63938 0.0202179
3.53646 0.00479126
11.1487 0.0108337
11.7582 0.0018158
END
$hits4 << END
2.21087 5.6514e-06
2.08633 5.6514e-06
3.86993 5.6514e-06
4.01594 5.6514e-06
1.49061 5.6514e-06
1.55415 5.6514e-06
3.08249 5.6514e-06
3.2092 5.6514e-06
1.59193 5.6514e-06
1.61946 5.6514e-06
3.84896 5.6514e-06
3.81162 5.6514e-06
6.54828 5.6514e-06
10.9795 5.6514e-06
END
$hits5 << END
2.53425 0.028595
2.45388 0.0184021
4.39991 0.0144196
4.33522 0.00224304
1.64844 0.028595
1.61922 0.0184021
3.46597 0.0144196
3.52963 0.00224304
1.79643 0.028595
1.73465 0.0184479
4.30982 0.0202179
4.15656 0.00479126
11.6994 0.0108337
11.9735 0.0018158
END
$hits_front << END
10.9795 5.6514e-06
13.0364 0.000106812
13.6721 0.00192261
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
set xrange [5.77289:106.608]; set yrange [0.000114844:0.116291]
set xlabel 'pictures a second  (more is better)'; set ylabel 'picture: RMSE of a channel  (less is better)' offset -1.5
set xtics ('7' 7, '10' 10, '15' 15, '20' 20, '30' 30, '50' 50, '70' 70, '100' 100)
set ytics ("same\nbits" 0.000287109, '10⁻³' 1e-3, '10⁻²' 1e-2, '10⁻¹' 1e-1)
set object rectangle from graph 0, graph 0 to graph 1, first 0.000488086 fs solid noborder fc rgb '#eeeeee' behind
set arrow from first 88.8404,0.013808 to graph 1.0,0.6921 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.6921 to graph 1.015,0.6921 nohead lw 0.8 lc rgb '#999999'
set label 'fast, study: irregular exact' at graph 1.02,0.6921 left
set arrow from first 83.8937,0.00918705 to graph 1.0,0.6332 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.6332 to graph 1.015,0.6332 nohead lw 0.8 lc rgb '#999999'
set label 'fast: irregular exact' at graph 1.02,0.6332 left
set arrow from first 74.3559,0.000212674 to graph 1.0,0.0890 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.0890 to graph 1.015,0.0890 nohead lw 0.8 lc rgb '#999999'
set label 'double: irregular exact' at graph 1.02,0.0890 left
$picture0 << END
20.6767 0.00918705
21.6328 0.00918705
35.1246 0.00918705
37.3399 0.00918705
13.8559 0.00918705
14.532 0.00918705
27.0017 0.00918705
28.5468 0.00918705
15.4887 0.00918705
15.7007 0.00918705
33.2764 0.00918705
33.9689 0.00918705
78.1607 0.00918705
83.8937 0.00918705
END
$picture1 << END
22.9477 0.0465164
23.2184 0.0368519
38.4197 0.0318397
39.0944 0.015151
15.0702 0.0465164
15.2254 0.0368519
27.784 0.0318397
29.5255 0.015151
17.0422 0.0465164
16.7621 0.0368933
36.0944 0.0379429
36.1067 0.0203198
83.3326 0.0284441
88.8404 0.013808
END
$picture2 << END
11.8154 0.00229687
12.4321 0.00229687
30.0935 0.00229687
32.2541 0.00229687
9.5453 0.00229687
9.68314 0.00229687
23.7809 0.00229687
25.5087 0.00229687
6.92747 0.00229687
9.96794 0.00229687
26.5142 0.00229687
27.1465 0.00229687
65.7213 0.00229687
71.3769 0.00229687
15.6578 0.00229687
20.3036 0.00229687
END
$picture3 << END
12.7865 0.0460029
12.9041 0.0361277
30.5062 0.0307557
32.6201 0.0126211
10.0038 0.0460029
10.2331 0.0361277
25.0008 0.0307557
25.8009 0.0126211
6.93156 0.0460029
9.88975 0.0361705
26.7749 0.0370789
26.9942 0.0184932
71.26 0.0271408
75.6053 0.010539
END
$picture4 << END
19.66 0.000212674
20.3226 0.000212674
30.9724 0.000212674
32.432 0.000212674
13.7302 0.000212674
14.0985 0.000212674
25.9158 0.000212674
27.3071 0.000212674
14.8055 0.000212674
15.1025 0.000212674
31.4117 0.000212674
32.0051 0.000212674
71.3533 0.000212674
74.3559 0.000212674
END
$picture5 << END
17.9716 0.0459663
18.5727 0.036073
32.4516 0.0306826
32.0431 0.0124275
12.7601 0.0459663
12.8115 0.036073
25.9844 0.0306826
26.5161 0.0124275
13.521 0.0459663
13.5311 0.0361159
29.8434 0.0370265
29.8333 0.0183749
73.4861 0.0270553
75.9416 0.010294
END
$picture_front << END
74.3559 0.000212674
83.8937 0.00918705
88.8404 0.013808
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
set xrange [0.928743:16.4066]; set yrange [3.05176e-06:0.0717163]
set xlabel 'million nearest hits a second  (more is better)'; set ylabel 'wrong hits  (less is better)' offset -1.5
set label 'balls: speed against accuracy (CPU, 2 threads)' at screen 0.02, screen 0.9774 font ',20'
set label '256x256 primary and 65,536 random rays a scene; 65,536 in all compared with brute force in double; pictures of 128x128' at screen 0.02, screen 0.9516
set xtics ('1' 1, '1.5' 1.5, '2' 2, '3' 3, '5' 5, '7' 7, '10' 10, '15' 15)
set ytics ("none of\n65,536" 7.62939e-06, '0.01 %%' 1e-4, '0.1 %%' 1e-3, '1 %%' 1e-2)
set object rectangle from graph 0, graph 0 to graph 1, first 1.297e-05 fs solid noborder fc rgb '#eeeeee' behind
set arrow from first 13.6721,0.00192261 to graph 1.0,0.6404 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.6404 to graph 1.015,0.6404 nohead lw 0.8 lc rgb '#999999'
set label 'fast, study: irregular exact' at graph 1.02,0.6404 left
set arrow from first 13.0364,0.000106812 to graph 1.0,0.3532 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.3532 to graph 1.015,0.3532 nohead lw 0.8 lc rgb '#999999'
set label 'fast: irregular exact' at graph 1.02,0.3532 left
set arrow from first 10.9795,5.6514e-06 to graph 1.0,0.0612 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.0612 to graph 1.015,0.0612 nohead lw 0.8 lc rgb '#999999'
set label 'double: irregular exact' at graph 1.02,0.0612 left
$hits0 << END
2.74717 0.000106812
2.87336 0.000106812
4.77824 0.000106812
4.59642 0.000106812
1.70226 0.000106812
1.75687 0.000106812
3.22751 0.000106812
3.55392 0.000106812
1.88595 0.000106812
1.907 0.000106812
4.66287 0.000106812
4.81223 0.000106812
12.2052 0.000106812
13.0364 0.000106812
END
$hits1 << END
3.0032 0.0286865
2.96351 0.0184937
4.95194 0.0145111
5.08379 0.00234985
1.86049 0.0286865
1.82533 0.0184937
3.21248 0.0145111
3.8139 0.00234985
2.1109 0.0286865
2.04195 0.0185394
4.91166 0.0203094
4.87522 0.00489807
12.9333 0.0109406
13.6721 0.00192261
END
$hits2 << END
1.4332 7.62939e-06
1.51505 7.62939e-06
3.77759 7.62939e-06
4.05507 7.62939e-06
1.11706 7.62939e-06
1.17375 7.62939e-06
2.64647 7.62939e-06
3.03504 7.62939e-06
1.15187 7.62939e-06
1.18694 7.62939e-06
3.32211 7.62939e-06
3.35569 7.62939e-06
9.72981 7.62939e-06
10.6862 7.62939e-06
2.05388 7.62939e-06
2.58587 7.62939e-06
END
$hits3 << END
1.66189 0.028595
1.74359 0.0184021
4.45416 0.0144196
4.02638 0.00224304
1.31524 0.028595
1.28122 0.0184021
3.41224 0.0144196
3.46015 0.00224304
1.11449 0.028595
1.29888 0.0184479
3.63938 0.0202179
3.53646 0.00479126
11.1487 0.0108337
11.7582 0.0018158
END
$hits4 << END
2.21087 5.6514e-06
2.08633 5.6514e-06
3.86993 5.6514e-06
4.01594 5.6514e-06
1.49061 5.6514e-06
1.55415 5.6514e-06
3.08249 5.6514e-06
3.2092 5.6514e-06
1.59193 5.6514e-06
1.61946 5.6514e-06
3.84896 5.6514e-06
3.81162 5.6514e-06
6.54828 5.6514e-06
10.9795 5.6514e-06
END
$hits5 << END
2.53425 0.028595
2.45388 0.0184021
4.39991 0.0144196
4.33522 0.00224304
1.64844 0.028595
1.61922 0.0184021
3.46597 0.0144196
3.52963 0.00224304
1.79643 0.028595
1.73465 0.0184479
4.30982 0.0202179
4.15656 0.00479126
11.6994 0.0108337
11.9735 0.0018158
END
$hits_front << END
10.9795 5.6514e-06
13.0364 0.000106812
13.6721 0.00192261
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
set xrange [5.77289:106.608]; set yrange [0.000114844:0.116291]
set xlabel 'pictures a second  (more is better)'; set ylabel 'picture: RMSE of a channel  (less is better)' offset -1.5
set xtics ('7' 7, '10' 10, '15' 15, '20' 20, '30' 30, '50' 50, '70' 70, '100' 100)
set ytics ("same\nbits" 0.000287109, '10⁻³' 1e-3, '10⁻²' 1e-2, '10⁻¹' 1e-1)
set object rectangle from graph 0, graph 0 to graph 1, first 0.000488086 fs solid noborder fc rgb '#eeeeee' behind
set arrow from first 88.8404,0.013808 to graph 1.0,0.6921 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.6921 to graph 1.015,0.6921 nohead lw 0.8 lc rgb '#999999'
set label 'fast, study: irregular exact' at graph 1.02,0.6921 left
set arrow from first 83.8937,0.00918705 to graph 1.0,0.6332 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.6332 to graph 1.015,0.6332 nohead lw 0.8 lc rgb '#999999'
set label 'fast: irregular exact' at graph 1.02,0.6332 left
set arrow from first 74.3559,0.000212674 to graph 1.0,0.0890 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.0890 to graph 1.015,0.0890 nohead lw 0.8 lc rgb '#999999'
set label 'double: irregular exact' at graph 1.02,0.0890 left
$picture0 << END
20.6767 0.00918705
21.6328 0.00918705
35.1246 0.00918705
37.3399 0.00918705
13.8559 0.00918705
14.532 0.00918705
27.0017 0.00918705
28.5468 0.00918705
15.4887 0.00918705
15.7007 0.00918705
33.2764 0.00918705
33.9689 0.00918705
78.1607 0.00918705
83.8937 0.00918705
END
$picture1 << END
22.9477 0.0465164
23.2184 0.0368519
38.4197 0.0318397
39.0944 0.015151
15.0702 0.0465164
15.2254 0.0368519
27.784 0.0318397
29.5255 0.015151
17.0422 0.0465164
16.7621 0.0368933
36.0944 0.0379429
36.1067 0.0203198
83.3326 0.0284441
88.8404 0.013808
END
$picture2 << END
11.8154 0.00229687
12.4321 0.00229687
30.0935 0.00229687
32.2541 0.00229687
9.5453 0.00229687
9.68314 0.00229687
23.7809 0.00229687
25.5087 0.00229687
6.92747 0.00229687
9.96794 0.00229687
26.5142 0.00229687
27.1465 0.00229687
65.7213 0.00229687
71.3769 0.00229687
15.6578 0.00229687
20.3036 0.00229687
END
$picture3 << END
12.7865 0.0460029
12.9041 0.0361277
30.5062 0.0307557
32.6201 0.0126211
10.0038 0.0460029
10.2331 0.0361277
25.0008 0.0307557
25.8009 0.0126211
6.93156 0.0460029
9.88975 0.0361705
26.7749 0.0370789
26.9942 0.0184932
71.26 0.0271408
75.6053 0.010539
END
$picture4 << END
19.66 0.000212674
20.3226 0.000212674
30.9724 0.000212674
32.432 0.000212674
13.7302 0.000212674
14.0985 0.000212674
25.9158 0.000212674
27.3071 0.000212674
14.8055 0.000212674
15.1025 0.000212674
31.4117 0.000212674
32.0051 0.000212674
71.3533 0.000212674
74.3559 0.000212674
END
$picture5 << END
17.9716 0.0459663
18.5727 0.036073
32.4516 0.0306826
32.0431 0.0124275
12.7601 0.0459663
12.8115 0.036073
25.9844 0.0306826
26.5161 0.0124275
13.521 0.0459663
13.5311 0.0361159
29.8434 0.0370265
29.8333 0.0183749
73.4861 0.0270553
75.9416 0.010294
END
$picture_front << END
74.3559 0.000212674
83.8937 0.00918705
88.8404 0.013808
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
set xrange [0.516432:10.1584]; set yrange [3.05176e-06:0.00156403]
set xlabel 'million nearest hits a second  (more is better)'; set ylabel 'wrong hits  (less is better)' offset -1.5
set label 'gears: speed against accuracy (CPU, 2 threads)' at screen 0.02, screen 0.9774 font ',20'
set label '256x256 primary and 65,536 random rays a scene; 65,536 in all compared with brute force in double; pictures of 128x128' at screen 0.02, screen 0.9516
set xtics ('0.7' 0.7, '1' 1, '1.5' 1.5, '2' 2, '3' 3, '5' 5, '7' 7, '10' 10)
set ytics ("none of\n65,536" 7.62939e-06, '0.01 %%' 1e-4, '0.1 %%' 1e-3)
set object rectangle from graph 0, graph 0 to graph 1, first 1.297e-05 fs solid noborder fc rgb '#eeeeee' behind
set arrow from first 8.46537,7.62939e-06 to graph 1.0,0.1469 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.1469 to graph 1.015,0.1469 nohead lw 0.8 lc rgb '#999999'
set label 'robust, study: irregular exact' at graph 1.02,0.1469 left
$hits0 << END
3.10264 1.02997e-05
1.94648 1.02997e-05
3.01788 1.02997e-05
2.77287 1.02997e-05
2.97655 1.02997e-05
3.44333 1.02997e-05
2.0758 1.02997e-05
1.90277 1.02997e-05
1.45693 1.02997e-05
1.73148 1.02997e-05
1.77528 1.02997e-05
1.75061 1.02997e-05
1.82662 1.02997e-05
1.94149 1.02997e-05
3.14652 1.02997e-05
2.41898 1.02997e-05
2.16719 1.02997e-05
2.08429 1.02997e-05
6.16326 1.02997e-05
6.97581 1.02997e-05
END
$hits1 << END
1.35834 0.000152588
0.902649 0.000152588
2.42245 7.62939e-05
2.59165 3.05176e-05
2.84831 0.00050354
3.40061 0.000152588
0.985031 0.000152588
0.774894 0.000152588
1.3704 7.62939e-05
1.56507 3.05176e-05
1.9412 0.00050354
1.90357 0.000152588
0.817112 0.000152588
0.898309 0.000152588
2.30898 0.000289917
2.16265 3.05176e-05
1.79334 0.00062561
1.43891 0.000366211
5.07845 0.000183105
6.68814 1.02997e-05
END
$hits2 << END
3.30255 7.62939e-06
2.37961 7.62939e-06
3.87774 7.62939e-06
3.44922 7.62939e-06
3.68249 7.62939e-06
3.60111 7.62939e-06
2.01966 7.62939e-06
1.95158 7.62939e-06
1.73186 7.62939e-06
2.02886 7.62939e-06
2.08913 7.62939e-06
1.87302 7.62939e-06
2.04644 7.62939e-06
1.85607 7.62939e-06
2.85417 7.62939e-06
3.2306 7.62939e-06
2.74302 7.62939e-06
2.13163 7.62939e-06
6.77465 7.62939e-06
7.11999 7.62939e-06
0.619718 7.62939e-06
2.89317 7.62939e-06
1.79727 7.62939e-06
2.69487 7.62939e-06
END
$hits3 << END
1.00555 0.000152588
0.938219 0.000152588
2.71731 7.62939e-05
2.80349 3.05176e-05
3.33392 0.00050354
2.9709 0.000152588
0.882789 0.000152588
0.968017 0.000152588
1.50801 7.62939e-05
1.63646 3.05176e-05
2.05952 0.00050354
2.34731 0.000152588
0.936215 0.000152588
0.953883 0.000152588
2.53318 0.000289917
2.10259 3.05176e-05
2.36674 0.00062561
1.75259 0.000366211
6.39664 0.000183105
8.46537 7.62939e-06
END
$hits4 << END
2.28873 5.6514e-06
2.37414 5.6514e-06
3.70649 5.6514e-06
3.24007 5.6514e-06
3.10941 5.6514e-06
2.89217 5.6514e-06
1.52712 5.6514e-06
1.68835 5.6514e-06
1.87355 5.6514e-06
1.58828 5.6514e-06
1.79106 5.6514e-06
2.28704 5.6514e-06
1.88546 5.6514e-06
1.94422 5.6514e-06
3.0757 5.6514e-06
2.85029 5.6514e-06
2.53524 5.6514e-06
2.2831 5.6514e-06
6.52662 5.6514e-06
7.04215 5.6514e-06
END
$hits5 << END
1.10151 0.000152588
1.22591 0.000152588
2.17591 7.62939e-05
2.50221 3.05176e-05
3.35525 0.00050354
2.58955 0.000152588
1.24449 0.000152588
1.11576 0.000152588
1.6847 7.62939e-05
1.51213 3.05176e-05
1.71515 0.00050354
1.96218 0.000152588
1.32651 0.000152588
1.26576 0.000152588
2.60428 0.000289917
2.05371 3.05176e-05
1.91655 0.00062561
1.7838 0.000366211
6.85112 0.000183105
6.3033 5.6514e-06
END
$hits_front << END
8.46537 7.62939e-06
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
set xrange [1.05847:62.8978]; set yrange [2.21854e-08:0.0161019]
set xlabel 'pictures a second  (more is better)'; set ylabel 'picture: RMSE of a channel  (less is better)' offset -1.5
set xtics ('2' 2, '5' 5, '10' 10, '20' 20, '50' 50)
set ytics ("same\nbits" 5.54636e-08, '10⁻⁶' 1e-6, '10⁻⁵' 1e-5, '10⁻⁴' 1e-4, '10⁻³' 1e-3, '10⁻²' 1e-2)
set object rectangle from graph 0, graph 0 to graph 1, first 9.42882e-08 fs solid noborder fc rgb '#eeeeee' behind
set arrow from first 52.4149,0.00319435 to graph 1.0,0.8801 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.8801 to graph 1.015,0.8801 nohead lw 0.8 lc rgb '#999999'
set label 'fast: irregular exact' at graph 1.02,0.8801 left
set arrow from first 38.7925,4.10842e-08 to graph 1.0,0.0457 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.0457 to graph 1.015,0.0457 nohead lw 0.8 lc rgb '#999999'
set label 'double: irregular exact' at graph 1.02,0.0457 left
$picture0 << END
14.0548 0.00319435
9.18241 0.00319435
17.4531 0.00319435
17.8667 0.00319435
19.9333 0.00319435
26.1269 0.00319435
9.33752 0.00319435
8.29321 0.00319435
12.4802 0.00319435
11.5866 0.00319435
12.6994 0.00319435
12.8478 0.00319435
10.8332 0.00319435
8.35147 0.00319435
20.6928 0.00319435
18.8201 0.00319435
15.8774 0.00319435
12.5903 0.00319435
30.9448 0.00319435
52.4149 0.00319435
END
$picture1 << END
9.68014 0.00383996
6.36382 0.00383912
17.9826 0.00319435
17.5548 0.0042878
20.8964 0.00642127
22.9677 0.00454316
5.9016 0.00383996
6.34026 0.00383912
10.1886 0.00319435
9.50962 0.0042878
13.7308 0.00642127
13.8831 0.00454316
5.85511 0.00383996
6.38983 0.00383912
17.5717 0.00365496
16.7113 0.0042878
12.1537 0.00644074
11.0535 0.00561794
28.1495 0.00393563
38.1761 0.00367835
END
$picture2 << END
5.82173 4.43709e-07
4.33189 4.43709e-07
14.5264 4.43709e-07
15.6831 4.43709e-07
16.2996 4.43709e-07
21.1684 4.43709e-07
4.0196 4.43709e-07
4.1223 4.43709e-07
9.02692 4.43709e-07
10.0803 4.43709e-07
9.88014 4.43709e-07
13.185 4.43709e-07
4.58801 4.43709e-07
4.02398 4.43709e-07
13.6447 4.43709e-07
12.1148 4.43709e-07
11.2028 4.43709e-07
12.0346 4.43709e-07
33.6281 4.43709e-07
33.7023 4.43709e-07
1.27016 4.43709e-07
9.0489 4.43709e-07
13.2388 4.43709e-07
15.8082 4.43709e-07
END
$picture3 << END
4.26621 0.00213107
4.38343 0.00212955
16.6477 4.43709e-07
14.0685 0.00286034
18.7569 0.00557035
16.855 0.00323054
4.12729 0.00213107
4.29118 0.00212955
10.1698 4.43709e-07
8.67595 0.00286034
10.9349 0.00557035
13.6121 0.00323054
4.35786 0.00213107
4.21666 0.00212955
12.6241 0.00177614
14.1758 0.00286034
12.5003 0.00559278
11.4167 0.00462139
30.8204 0.00229898
29.2428 0.00182387
END
$picture4 << END
3.98949 4.10842e-08
4.13683 4.10842e-08
12.6175 4.10842e-08
15.3282 4.10842e-08
13.4456 4.10842e-08
20.5483 4.10842e-08
3.90915 4.10842e-08
4.21744 4.10842e-08
10.3187 4.10842e-08
10.597 4.10842e-08
10.6185 4.10842e-08
13.3507 4.10842e-08
4.2033 4.10842e-08
4.29348 4.10842e-08
13.9728 4.10842e-08
11.7674 4.10842e-08
11.4801 4.10842e-08
10.3533 4.10842e-08
31.7457 4.10842e-08
38.7925 4.10842e-08
END
$picture5 << END
4.16158 0.00213107
3.97722 0.00212955
13.5712 4.10842e-08
16.6797 0.00286034
19.5749 0.00557035
19.5203 0.00323054
4.09064 0.00213107
4.28934 0.00212955
10.7602 4.10842e-08
10.0831 0.00286034
11.4619 0.00557035
10.3824 0.00323054
4.26754 0.00213107
4.151 0.00212955
14.501 0.00177613
12.3672 0.00286034
10.7986 0.00559278
11.0732 0.00462139
26.8545 0.00229898
37.6107 0.00182387
END
$picture_front << END
38.7925 4.10842e-08
52.4149 0.00319435
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
set xrange [0.516432:10.1584]; set yrange [3.05176e-06:0.00156403]
set xlabel 'million nearest hits a second  (more is better)'; set ylabel 'wrong hits  (less is better)' offset -1.5
set label 'gears: speed against accuracy (CPU, 2 threads)' at screen 0.02, screen 0.9774 font ',20'
set label '256x256 primary and 65,536 random rays a scene; 65,536 in all compared with brute force in double; pictures of 128x128' at screen 0.02, screen 0.9516
set xtics ('0.7' 0.7, '1' 1, '1.5' 1.5, '2' 2, '3' 3, '5' 5, '7' 7, '10' 10)
set ytics ("none of\n65,536" 7.62939e-06, '0.01 %%' 1e-4, '0.1 %%' 1e-3)
set object rectangle from graph 0, graph 0 to graph 1, first 1.297e-05 fs solid noborder fc rgb '#eeeeee' behind
set arrow from first 8.46537,7.62939e-06 to graph 1.0,0.1469 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.1469 to graph 1.015,0.1469 nohead lw 0.8 lc rgb '#999999'
set label 'robust, study: irregular exact' at graph 1.02,0.1469 left
$hits0 << END
3.10264 1.02997e-05
1.94648 1.02997e-05
3.01788 1.02997e-05
2.77287 1.02997e-05
2.97655 1.02997e-05
3.44333 1.02997e-05
2.0758 1.02997e-05
1.90277 1.02997e-05
1.45693 1.02997e-05
1.73148 1.02997e-05
1.77528 1.02997e-05
1.75061 1.02997e-05
1.82662 1.02997e-05
1.94149 1.02997e-05
3.14652 1.02997e-05
2.41898 1.02997e-05
2.16719 1.02997e-05
2.08429 1.02997e-05
6.16326 1.02997e-05
6.97581 1.02997e-05
END
$hits1 << END
1.35834 0.000152588
0.902649 0.000152588
2.42245 7.62939e-05
2.59165 3.05176e-05
2.84831 0.00050354
3.40061 0.000152588
0.985031 0.000152588
0.774894 0.000152588
1.3704 7.62939e-05
1.56507 3.05176e-05
1.9412 0.00050354
1.90357 0.000152588
0.817112 0.000152588
0.898309 0.000152588
2.30898 0.000289917
2.16265 3.05176e-05
1.79334 0.00062561
1.43891 0.000366211
5.07845 0.000183105
6.68814 1.02997e-05
END
$hits2 << END
3.30255 7.62939e-06
2.37961 7.62939e-06
3.87774 7.62939e-06
3.44922 7.62939e-06
3.68249 7.62939e-06
3.60111 7.62939e-06
2.01966 7.62939e-06
1.95158 7.62939e-06
1.73186 7.62939e-06
2.02886 7.62939e-06
2.08913 7.62939e-06
1.87302 7.62939e-06
2.04644 7.62939e-06
1.85607 7.62939e-06
2.85417 7.62939e-06
3.2306 7.62939e-06
2.74302 7.62939e-06
2.13163 7.62939e-06
6.77465 7.62939e-06
7.11999 7.62939e-06
0.619718 7.62939e-06
2.89317 7.62939e-06
1.79727 7.62939e-06
2.69487 7.62939e-06
END
$hits3 << END
1.00555 0.000152588
0.938219 0.000152588
2.71731 7.62939e-05
2.80349 3.05176e-05
3.33392 0.00050354
2.9709 0.000152588
0.882789 0.000152588
0.968017 0.000152588
1.50801 7.62939e-05
1.63646 3.05176e-05
2.05952 0.00050354
2.34731 0.000152588
0.936215 0.000152588
0.953883 0.000152588
2.53318 0.000289917
2.10259 3.05176e-05
2.36674 0.00062561
1.75259 0.000366211
6.39664 0.000183105
8.46537 7.62939e-06
END
$hits4 << END
2.28873 5.6514e-06
2.37414 5.6514e-06
3.70649 5.6514e-06
3.24007 5.6514e-06
3.10941 5.6514e-06
2.89217 5.6514e-06
1.52712 5.6514e-06
1.68835 5.6514e-06
1.87355 5.6514e-06
1.58828 5.6514e-06
1.79106 5.6514e-06
2.28704 5.6514e-06
1.88546 5.6514e-06
1.94422 5.6514e-06
3.0757 5.6514e-06
2.85029 5.6514e-06
2.53524 5.6514e-06
2.2831 5.6514e-06
6.52662 5.6514e-06
7.04215 5.6514e-06
END
$hits5 << END
1.10151 0.000152588
1.22591 0.000152588
2.17591 7.62939e-05
2.50221 3.05176e-05
3.35525 0.00050354
2.58955 0.000152588
1.24449 0.000152588
1.11576 0.000152588
1.6847 7.62939e-05
1.51213 3.05176e-05
1.71515 0.00050354
1.96218 0.000152588
1.32651 0.000152588
1.26576 0.000152588
2.60428 0.000289917
2.05371 3.05176e-05
1.91655 0.00062561
1.7838 0.000366211
6.85112 0.000183105
6.3033 5.6514e-06
END
$hits_front << END
8.46537 7.62939e-06
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
set xrange [1.05847:62.8978]; set yrange [2.21854e-08:0.0161019]
set xlabel 'pictures a second  (more is better)'; set ylabel 'picture: RMSE of a channel  (less is better)' offset -1.5
set xtics ('2' 2, '5' 5, '10' 10, '20' 20, '50' 50)
set ytics ("same\nbits" 5.54636e-08, '10⁻⁶' 1e-6, '10⁻⁵' 1e-5, '10⁻⁴' 1e-4, '10⁻³' 1e-3, '10⁻²' 1e-2)
set object rectangle from graph 0, graph 0 to graph 1, first 9.42882e-08 fs solid noborder fc rgb '#eeeeee' behind
set arrow from first 52.4149,0.00319435 to graph 1.0,0.8801 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.8801 to graph 1.015,0.8801 nohead lw 0.8 lc rgb '#999999'
set label 'fast: irregular exact' at graph 1.02,0.8801 left
set arrow from first 38.7925,4.10842e-08 to graph 1.0,0.0457 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.0457 to graph 1.015,0.0457 nohead lw 0.8 lc rgb '#999999'
set label 'double: irregular exact' at graph 1.02,0.0457 left
$picture0 << END
14.0548 0.00319435
9.18241 0.00319435
17.4531 0.00319435
17.8667 0.00319435
19.9333 0.00319435
26.1269 0.00319435
9.33752 0.00319435
8.29321 0.00319435
12.4802 0.00319435
11.5866 0.00319435
12.6994 0.00319435
12.8478 0.00319435
10.8332 0.00319435
8.35147 0.00319435
20.6928 0.00319435
18.8201 0.00319435
15.8774 0.00319435
12.5903 0.00319435
30.9448 0.00319435
52.4149 0.00319435
END
$picture1 << END
9.68014 0.00383996
6.36382 0.00383912
17.9826 0.00319435
17.5548 0.0042878
20.8964 0.00642127
22.9677 0.00454316
5.9016 0.00383996
6.34026 0.00383912
10.1886 0.00319435
9.50962 0.0042878
13.7308 0.00642127
13.8831 0.00454316
5.85511 0.00383996
6.38983 0.00383912
17.5717 0.00365496
16.7113 0.0042878
12.1537 0.00644074
11.0535 0.00561794
28.1495 0.00393563
38.1761 0.00367835
END
$picture2 << END
5.82173 4.43709e-07
4.33189 4.43709e-07
14.5264 4.43709e-07
15.6831 4.43709e-07
16.2996 4.43709e-07
21.1684 4.43709e-07
4.0196 4.43709e-07
4.1223 4.43709e-07
9.02692 4.43709e-07
10.0803 4.43709e-07
9.88014 4.43709e-07
13.185 4.43709e-07
4.58801 4.43709e-07
4.02398 4.43709e-07
13.6447 4.43709e-07
12.1148 4.43709e-07
11.2028 4.43709e-07
12.0346 4.43709e-07
33.6281 4.43709e-07
33.7023 4.43709e-07
1.27016 4.43709e-07
9.0489 4.43709e-07
13.2388 4.43709e-07
15.8082 4.43709e-07
END
$picture3 << END
4.26621 0.00213107
4.38343 0.00212955
16.6477 4.43709e-07
14.0685 0.00286034
18.7569 0.00557035
16.855 0.00323054
4.12729 0.00213107
4.29118 0.00212955
10.1698 4.43709e-07
8.67595 0.00286034
10.9349 0.00557035
13.6121 0.00323054
4.35786 0.00213107
4.21666 0.00212955
12.6241 0.00177614
14.1758 0.00286034
12.5003 0.00559278
11.4167 0.00462139
30.8204 0.00229898
29.2428 0.00182387
END
$picture4 << END
3.98949 4.10842e-08
4.13683 4.10842e-08
12.6175 4.10842e-08
15.3282 4.10842e-08
13.4456 4.10842e-08
20.5483 4.10842e-08
3.90915 4.10842e-08
4.21744 4.10842e-08
10.3187 4.10842e-08
10.597 4.10842e-08
10.6185 4.10842e-08
13.3507 4.10842e-08
4.2033 4.10842e-08
4.29348 4.10842e-08
13.9728 4.10842e-08
11.7674 4.10842e-08
11.4801 4.10842e-08
10.3533 4.10842e-08
31.7457 4.10842e-08
38.7925 4.10842e-08
END
$picture5 << END
4.16158 0.00213107
3.97722 0.00212955
13.5712 4.10842e-08
16.6797 0.00286034
19.5749 0.00557035
19.5203 0.00323054
4.09064 0.00213107
4.28934 0.00212955
10.7602 4.10842e-08
10.0831 0.00286034
11.4619 0.00557035
10.3824 0.00323054
4.26754 0.00213107
4.151 0.00212955
14.501 0.00177613
12.3672 0.00286034
10.7986 0.00559278
11.0732 0.00462139
26.8545 0.00229898
37.6107 0.00182387
END
$picture_front << END
38.7925 4.10842e-08
52.4149 0.00319435
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
set xrange [0.355347:5.73434]; set yrange [3.05176e-06:0.001297]
set xlabel 'million nearest hits a second  (more is better)'; set ylabel 'wrong hits  (less is better)' offset -1.5
set label 'mount: speed against accuracy (CPU, 2 threads)' at screen 0.02, screen 0.9774 font ',20'
set label '256x256 primary and 65,536 random rays a scene; 65,536 in all compared with brute force in double; pictures of 128x128' at screen 0.02, screen 0.9516
set xtics ('0.5' 0.5, '0.7' 0.7, '1' 1, '1.5' 1.5, '2' 2, '3' 3, '5' 5)
set ytics ("none of\n65,536" 7.62939e-06, '0.01 %%' 1e-4, '0.1 %%' 1e-3)
set object rectangle from graph 0, graph 0 to graph 1, first 1.297e-05 fs solid noborder fc rgb '#eeeeee' behind
set arrow from first 4.77862,1.52588e-05 to graph 1.0,0.2659 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.2659 to graph 1.015,0.2659 nohead lw 0.8 lc rgb '#999999'
set label 'double, study: irregular exact' at graph 1.02,0.2659 left
set arrow from first 4.21658,1.02997e-05 to graph 1.0,0.2010 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.2010 to graph 1.015,0.2010 nohead lw 0.8 lc rgb '#999999'
set label 'fast: irregular exact' at graph 1.02,0.2010 left
$hits0 << END
2.35525 1.02997e-05
2.8274 1.02997e-05
2.17885 1.02997e-05
2.25081 1.02997e-05
2.3143 1.02997e-05
2.80997 1.02997e-05
2.42899 1.02997e-05
2.55888 1.02997e-05
1.71182 1.02997e-05
1.69447 1.02997e-05
1.96658 1.02997e-05
2.25527 1.02997e-05
2.14095 1.02997e-05
2.64704 1.02997e-05
0.813528 1.02997e-05
0.720542 1.02997e-05
1.60904 1.02997e-05
1.47201 1.02997e-05
4.21185 1.02997e-05
4.21658 1.02997e-05
END
$hits1 << END
1.95001 6.10352e-05
1.60351 4.57764e-05
2.02111 1.52588e-05
2.26219 1.02997e-05
2.41881 0.000213623
2.62219 7.62939e-05
1.54333 6.10352e-05
1.70553 4.57764e-05
1.30294 1.52588e-05
1.59647 1.02997e-05
1.71197 0.000213623
2.12206 7.62939e-05
1.50583 0.000183105
1.8769 0.000167847
0.426416 0.000198364
0.438295 0.000473022
0.877206 0.000350952
1.09481 0.000518799
3.63859 6.10352e-05
4.08161 1.52588e-05
END
$hits2 << END
1.71106 7.62939e-06
1.95017 7.62939e-06
1.99536 7.62939e-06
2.78088 7.62939e-06
2.04091 7.62939e-06
2.22748 7.62939e-06
1.5397 7.62939e-06
1.65045 7.62939e-06
1.42076 7.62939e-06
1.46637 7.62939e-06
1.62568 7.62939e-06
1.76584 7.62939e-06
1.40586 7.62939e-06
1.3713 7.62939e-06
0.498221 7.62939e-06
0.484174 7.62939e-06
0.888959 7.62939e-06
0.927413 7.62939e-06
3.23775 7.62939e-06
3.72515 7.62939e-06
0.727874 7.62939e-06
2.53162 7.62939e-06
1.06426 7.62939e-06
1.596 7.62939e-06
END
$hits3 << END
2.04379 6.10352e-05
1.82244 4.57764e-05
2.06421 1.52588e-05
2.02684 7.62939e-06
2.9291 0.000213623
2.38013 7.62939e-05
1.61658 6.10352e-05
1.73576 4.57764e-05
1.65517 1.52588e-05
1.50468 7.62939e-06
2.13497 0.000213623
2.07782 7.62939e-05
1.68338 0.000183105
1.74141 0.000167847
0.451192 0.000198364
0.484768 0.000473022
1.15752 0.000350952
1.12712 0.000518799
4.29663 6.10352e-05
4.19722 1.52588e-05
END
$hits4 << END
2.04422 5.6514e-06
2.1958 5.6514e-06
2.00908 5.6514e-06
1.73613 5.6514e-06
2.57832 5.6514e-06
2.51293 5.6514e-06
2.05312 5.6514e-06
1.69239 5.6514e-06
1.63623 5.6514e-06
1.24696 5.6514e-06
1.56246 5.6514e-06
1.72934 5.6514e-06
1.66673 5.6514e-06
1.76929 5.6514e-06
0.545563 5.6514e-06
0.512671 5.6514e-06
0.928442 5.6514e-06
0.990434 5.6514e-06
3.27585 5.6514e-06
3.76936 5.6514e-06
END
$hits5 << END
1.93761 6.10352e-05
2.24592 4.57764e-05
1.74416 1.52588e-05
1.83893 5.6514e-06
2.60212 0.000213623
2.605 7.62939e-05
2.57041 6.10352e-05
1.97564 4.57764e-05
1.52446 1.52588e-05
1.53212 5.6514e-06
1.7929 0.000213623
2.12249 7.62939e-05
1.58922 0.000183105
1.87769 0.000167847
0.507583 0.000198364
0.499972 0.000473022
0.983284 0.000350952
1.01003 0.000518799
4.66964 6.10352e-05
4.77862 1.52588e-05
END
$hits_front << END
4.21658 1.02997e-05
4.77862 1.52588e-05
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
set xrange [7.54349:62.5759]; set yrange [5.91674e-06:0.0144206]
set xlabel 'pictures a second  (more is better)'; set ylabel 'picture: RMSE of a channel  (less is better)' offset -1.5
set xtics ('10' 10, '15' 15, '20' 20, '30' 30, '50' 50)
set ytics ("same\nbits" 1.47919e-05, '10⁻⁴' 1e-4, '10⁻³' 1e-3, '10⁻²' 1e-2)
set object rectangle from graph 0, graph 0 to graph 1, first 2.51461e-05 fs solid noborder fc rgb '#eeeeee' behind
set arrow from first 52.1466,0.000118335 to graph 1.0,0.3841 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.3841 to graph 1.015,0.3841 nohead lw 0.8 lc rgb '#999999'
set label 'robust: irregular exact' at graph 1.02,0.3841 left
set arrow from first 45.6166,1.09569e-05 to graph 1.0,0.0790 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.0790 to graph 1.015,0.0790 nohead lw 0.8 lc rgb '#999999'
set label 'double, study: irregular exact' at graph 1.02,0.0790 left
$picture0 << END
24.6803 0.00517964
28.6255 0.00517964
25.8686 0.00517964
25.9035 0.00517964
28.0422 0.00517964
38.2089 0.00517964
26.145 0.00517964
30.1868 0.00517964
22.6596 0.00517964
24.188 0.00517964
21.8445 0.00517964
24.2191 0.00517964
22.9566 0.00517964
24.5694 0.00517964
15.1884 0.00517964
10.4257 0.00517964
26.1484 0.00517964
18.8323 0.00517964
39.0789 0.00517964
43.6962 0.00517964
END
$picture1 << END
29.0578 0.00531405
27.1389 0.00531405
27.9761 0.00519279
33.9587 0.00517964
32.0359 0.00576825
43.2645 0.00551613
24.5086 0.00531405
25.2688 0.00531405
33.5472 0.00519279
23.03 0.00517964
26.4479 0.00576825
34.3337 0.00551613
23.5067 0.00531405
25.0386 0.00531405
10.0018 0.00519239
9.41682 0.00520441
18.0194 0.00576825
20.0571 0.0055394
44.4436 0.00531712
47.7213 0.00517964
END
$picture2 << END
20.8835 0.000118335
21.9153 0.000118335
22.5282 0.000118335
32.9115 0.000118335
23.7591 0.000118335
37.1302 0.000118335
22.7046 0.000118335
31.35 0.000118335
16.3797 0.000118335
20.2175 0.000118335
20.2545 0.000118335
23.0875 0.000118335
21.578 0.000118335
28.3872 0.000118335
9.25535 0.000118335
10.2717 0.000118335
20.3756 0.000118335
14.7124 0.000118335
37.1616 0.000118335
52.1466 0.000118335
12.3343 0.000118335
27.4461 0.000118335
14.2044 0.000118335
19.0338 0.000118335
END
$picture3 << END
27.5428 0.00159667
31.7246 0.00159667
34.4434 0.000387878
24.8317 0.000118335
29.5456 0.00254127
39.4198 0.0019008
26.3829 0.00159667
23.3408 0.00159667
21.3202 0.000387878
22.3649 0.000118335
25.599 0.00254127
28.5478 0.0019008
22.0006 0.00159667
22.3074 0.00159667
9.69857 0.000382429
10.4522 0.000520823
22.658 0.00254127
16.9578 0.0019673
50.4006 0.00120712
45.6119 0.000118335
END
$picture4 << END
24.235 1.09569e-05
25.1755 1.09569e-05
21.4576 1.09569e-05
23.9969 1.09569e-05
25.9422 1.09569e-05
36.4246 1.09569e-05
33.0034 1.09569e-05
24.3572 1.09569e-05
22.1777 1.09569e-05
25.9372 1.09569e-05
22.5561 1.09569e-05
31.8707 1.09569e-05
25.0221 1.09569e-05
23.4407 1.09569e-05
9.05219 1.09569e-05
9.49873 1.09569e-05
15.5161 1.09569e-05
20.7013 1.09569e-05
45.4729 1.09569e-05
43.061 1.09569e-05
END
$picture5 << END
28.6959 0.00159428
27.4882 0.00159428
26.4361 0.000369387
36.3994 1.09569e-05
30.5351 0.00253977
32.6376 0.00189879
25.9453 0.00159428
26.5219 0.00159428
22.7827 0.000369387
31.3733 1.09569e-05
26.8674 0.00253977
27.9639 0.00189879
27.7732 0.00159428
35.9247 0.00159428
11.9984 0.00036366
11.3696 0.000509379
23.0433 0.00253977
19.7708 0.00196593
49.8581 0.0012013
45.6166 1.09569e-05
END
$picture_front << END
45.6166 1.09569e-05
52.1466 0.000118335
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
set xrange [0.355347:5.73434]; set yrange [3.05176e-06:0.001297]
set xlabel 'million nearest hits a second  (more is better)'; set ylabel 'wrong hits  (less is better)' offset -1.5
set label 'mount: speed against accuracy (CPU, 2 threads)' at screen 0.02, screen 0.9774 font ',20'
set label '256x256 primary and 65,536 random rays a scene; 65,536 in all compared with brute force in double; pictures of 128x128' at screen 0.02, screen 0.9516
set xtics ('0.5' 0.5, '0.7' 0.7, '1' 1, '1.5' 1.5, '2' 2, '3' 3, '5' 5)
set ytics ("none of\n65,536" 7.62939e-06, '0.01 %%' 1e-4, '0.1 %%' 1e-3)
set object rectangle from graph 0, graph 0 to graph 1, first 1.297e-05 fs solid noborder fc rgb '#eeeeee' behind
set arrow from first 4.77862,1.52588e-05 to graph 1.0,0.2659 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.2659 to graph 1.015,0.2659 nohead lw 0.8 lc rgb '#999999'
set label 'double, study: irregular exact' at graph 1.02,0.2659 left
set arrow from first 4.21658,1.02997e-05 to graph 1.0,0.2010 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.2010 to graph 1.015,0.2010 nohead lw 0.8 lc rgb '#999999'
set label 'fast: irregular exact' at graph 1.02,0.2010 left
$hits0 << END
2.35525 1.02997e-05
2.8274 1.02997e-05
2.17885 1.02997e-05
2.25081 1.02997e-05
2.3143 1.02997e-05
2.80997 1.02997e-05
2.42899 1.02997e-05
2.55888 1.02997e-05
1.71182 1.02997e-05
1.69447 1.02997e-05
1.96658 1.02997e-05
2.25527 1.02997e-05
2.14095 1.02997e-05
2.64704 1.02997e-05
0.813528 1.02997e-05
0.720542 1.02997e-05
1.60904 1.02997e-05
1.47201 1.02997e-05
4.21185 1.02997e-05
4.21658 1.02997e-05
END
$hits1 << END
1.95001 6.10352e-05
1.60351 4.57764e-05
2.02111 1.52588e-05
2.26219 1.02997e-05
2.41881 0.000213623
2.62219 7.62939e-05
1.54333 6.10352e-05
1.70553 4.57764e-05
1.30294 1.52588e-05
1.59647 1.02997e-05
1.71197 0.000213623
2.12206 7.62939e-05
1.50583 0.000183105
1.8769 0.000167847
0.426416 0.000198364
0.438295 0.000473022
0.877206 0.000350952
1.09481 0.000518799
3.63859 6.10352e-05
4.08161 1.52588e-05
END
$hits2 << END
1.71106 7.62939e-06
1.95017 7.62939e-06
1.99536 7.62939e-06
2.78088 7.62939e-06
2.04091 7.62939e-06
2.22748 7.62939e-06
1.5397 7.62939e-06
1.65045 7.62939e-06
1.42076 7.62939e-06
1.46637 7.62939e-06
1.62568 7.62939e-06
1.76584 7.62939e-06
1.40586 7.62939e-06
1.3713 7.62939e-06
0.498221 7.62939e-06
0.484174 7.62939e-06
0.888959 7.62939e-06
0.927413 7.62939e-06
3.23775 7.62939e-06
3.72515 7.62939e-06
0.727874 7.62939e-06
2.53162 7.62939e-06
1.06426 7.62939e-06
1.596 7.62939e-06
END
$hits3 << END
2.04379 6.10352e-05
1.82244 4.57764e-05
2.06421 1.52588e-05
2.02684 7.62939e-06
2.9291 0.000213623
2.38013 7.62939e-05
1.61658 6.10352e-05
1.73576 4.57764e-05
1.65517 1.52588e-05
1.50468 7.62939e-06
2.13497 0.000213623
2.07782 7.62939e-05
1.68338 0.000183105
1.74141 0.000167847
0.451192 0.000198364
0.484768 0.000473022
1.15752 0.000350952
1.12712 0.000518799
4.29663 6.10352e-05
4.19722 1.52588e-05
END
$hits4 << END
2.04422 5.6514e-06
2.1958 5.6514e-06
2.00908 5.6514e-06
1.73613 5.6514e-06
2.57832 5.6514e-06
2.51293 5.6514e-06
2.05312 5.6514e-06
1.69239 5.6514e-06
1.63623 5.6514e-06
1.24696 5.6514e-06
1.56246 5.6514e-06
1.72934 5.6514e-06
1.66673 5.6514e-06
1.76929 5.6514e-06
0.545563 5.6514e-06
0.512671 5.6514e-06
0.928442 5.6514e-06
0.990434 5.6514e-06
3.27585 5.6514e-06
3.76936 5.6514e-06
END
$hits5 << END
1.93761 6.10352e-05
2.24592 4.57764e-05
1.74416 1.52588e-05
1.83893 5.6514e-06
2.60212 0.000213623
2.605 7.62939e-05
2.57041 6.10352e-05
1.97564 4.57764e-05
1.52446 1.52588e-05
1.53212 5.6514e-06
1.7929 0.000213623
2.12249 7.62939e-05
1.58922 0.000183105
1.87769 0.000167847
0.507583 0.000198364
0.499972 0.000473022
0.983284 0.000350952
1.01003 0.000518799
4.66964 6.10352e-05
4.77862 1.52588e-05
END
$hits_front << END
4.21658 1.02997e-05
4.77862 1.52588e-05
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
set xrange [7.54349:62.5759]; set yrange [5.91674e-06:0.0144206]
set xlabel 'pictures a second  (more is better)'; set ylabel 'picture: RMSE of a channel  (less is better)' offset -1.5
set xtics ('10' 10, '15' 15, '20' 20, '30' 30, '50' 50)
set ytics ("same\nbits" 1.47919e-05, '10⁻⁴' 1e-4, '10⁻³' 1e-3, '10⁻²' 1e-2)
set object rectangle from graph 0, graph 0 to graph 1, first 2.51461e-05 fs solid noborder fc rgb '#eeeeee' behind
set arrow from first 52.1466,0.000118335 to graph 1.0,0.3841 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.3841 to graph 1.015,0.3841 nohead lw 0.8 lc rgb '#999999'
set label 'robust: irregular exact' at graph 1.02,0.3841 left
set arrow from first 45.6166,1.09569e-05 to graph 1.0,0.0790 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.0790 to graph 1.015,0.0790 nohead lw 0.8 lc rgb '#999999'
set label 'double, study: irregular exact' at graph 1.02,0.0790 left
$picture0 << END
24.6803 0.00517964
28.6255 0.00517964
25.8686 0.00517964
25.9035 0.00517964
28.0422 0.00517964
38.2089 0.00517964
26.145 0.00517964
30.1868 0.00517964
22.6596 0.00517964
24.188 0.00517964
21.8445 0.00517964
24.2191 0.00517964
22.9566 0.00517964
24.5694 0.00517964
15.1884 0.00517964
10.4257 0.00517964
26.1484 0.00517964
18.8323 0.00517964
39.0789 0.00517964
43.6962 0.00517964
END
$picture1 << END
29.0578 0.00531405
27.1389 0.00531405
27.9761 0.00519279
33.9587 0.00517964
32.0359 0.00576825
43.2645 0.00551613
24.5086 0.00531405
25.2688 0.00531405
33.5472 0.00519279
23.03 0.00517964
26.4479 0.00576825
34.3337 0.00551613
23.5067 0.00531405
25.0386 0.00531405
10.0018 0.00519239
9.41682 0.00520441
18.0194 0.00576825
20.0571 0.0055394
44.4436 0.00531712
47.7213 0.00517964
END
$picture2 << END
20.8835 0.000118335
21.9153 0.000118335
22.5282 0.000118335
32.9115 0.000118335
23.7591 0.000118335
37.1302 0.000118335
22.7046 0.000118335
31.35 0.000118335
16.3797 0.000118335
20.2175 0.000118335
20.2545 0.000118335
23.0875 0.000118335
21.578 0.000118335
28.3872 0.000118335
9.25535 0.000118335
10.2717 0.000118335
20.3756 0.000118335
14.7124 0.000118335
37.1616 0.000118335
52.1466 0.000118335
12.3343 0.000118335
27.4461 0.000118335
14.2044 0.000118335
19.0338 0.000118335
END
$picture3 << END
27.5428 0.00159667
31.7246 0.00159667
34.4434 0.000387878
24.8317 0.000118335
29.5456 0.00254127
39.4198 0.0019008
26.3829 0.00159667
23.3408 0.00159667
21.3202 0.000387878
22.3649 0.000118335
25.599 0.00254127
28.5478 0.0019008
22.0006 0.00159667
22.3074 0.00159667
9.69857 0.000382429
10.4522 0.000520823
22.658 0.00254127
16.9578 0.0019673
50.4006 0.00120712
45.6119 0.000118335
END
$picture4 << END
24.235 1.09569e-05
25.1755 1.09569e-05
21.4576 1.09569e-05
23.9969 1.09569e-05
25.9422 1.09569e-05
36.4246 1.09569e-05
33.0034 1.09569e-05
24.3572 1.09569e-05
22.1777 1.09569e-05
25.9372 1.09569e-05
22.5561 1.09569e-05
31.8707 1.09569e-05
25.0221 1.09569e-05
23.4407 1.09569e-05
9.05219 1.09569e-05
9.49873 1.09569e-05
15.5161 1.09569e-05
20.7013 1.09569e-05
45.4729 1.09569e-05
43.061 1.09569e-05
END
$picture5 << END
28.6959 0.00159428
27.4882 0.00159428
26.4361 0.000369387
36.3994 1.09569e-05
30.5351 0.00253977
32.6376 0.00189879
25.9453 0.00159428
26.5219 0.00159428
22.7827 0.000369387
31.3733 1.09569e-05
26.8674 0.00253977
27.9639 0.00189879
27.7732 0.00159428
35.9247 0.00159428
11.9984 0.00036366
11.3696 0.000509379
23.0433 0.00253977
19.7708 0.00196593
49.8581 0.0012013
45.6166 1.09569e-05
END
$picture_front << END
45.6166 1.09569e-05
52.1466 0.000118335
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
set xrange [0.231554:4.00495]; set yrange [3.05176e-06:0.0588608]
set xlabel 'million nearest hits a second  (more is better)'; set ylabel 'wrong hits  (less is better)' offset -1.5
set label 'rings: speed against accuracy (CPU, 2 threads)' at screen 0.02, screen 0.9774 font ',20'
set label '256x256 primary and 65,536 random rays a scene; 65,536 in all compared with brute force in double; pictures of 128x128' at screen 0.02, screen 0.9516
set xtics ('0.3' 0.3, '0.5' 0.5, '0.7' 0.7, '1' 1, '1.5' 1.5, '2' 2, '3' 3)
set ytics ("none of\n65,536" 7.62939e-06, '0.01 %%' 1e-4, '0.1 %%' 1e-3, '1 %%' 1e-2)
set object rectangle from graph 0, graph 0 to graph 1, first 1.297e-05 fs solid noborder fc rgb '#eeeeee' behind
set arrow from first 3.33746,7.62939e-06 to graph 1.0,0.0929 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.0929 to graph 1.015,0.0929 nohead lw 0.8 lc rgb '#999999'
set label 'robust: uniform 32 exact' at graph 1.02,0.0929 left
$hits0 << END
0.755424 0.000259399
0.868589 0.000259399
1.1341 0.000259399
1.54459 0.000259399
1.33622 0.000259399
1.79104 0.000259399
0.748481 0.000259399
0.850116 0.000259399
0.895694 0.000259399
1.19428 0.000259399
1.06508 0.000259399
1.78116 0.000259399
0.730463 0.000259399
1.0163 0.000259399
0.512522 0.000259399
0.743034 0.000259399
0.482018 0.000259399
0.689263 0.000259399
1.99483 0.000259399
2.518 0.000259399
END
$hits1 << END
0.74792 0.00686646
0.987517 0.00610352
1.4332 0.0235443
1.58619 0.00991821
1.27253 0.0219116
2.19643 0.0118256
0.861225 0.00686646
0.897891 0.00610352
1.21089 0.0235443
1.33944 0.00991821
1.03254 0.0219116
1.42951 0.0118256
0.753862 0.00785828
0.956223 0.00624084
0.527634 0.0185242
0.713274 0.0170288
0.480853 0.0169067
0.685264 0.0122986
1.87549 0.0207214
2.72872 0.00959778
END
$hits2 << END
1.07964 7.62939e-06
1.35927 7.62939e-06
1.57321 7.62939e-06
1.67083 7.62939e-06
1.34434 7.62939e-06
1.99996 7.62939e-06
0.970095 7.62939e-06
1.11631 7.62939e-06
0.985171 7.62939e-06
1.16179 7.62939e-06
1.13342 7.62939e-06
1.39837 7.62939e-06
0.962149 7.62939e-06
1.3065 7.62939e-06
0.87642 7.62939e-06
0.888869 7.62939e-06
0.818953 7.62939e-06
0.886068 7.62939e-06
2.3973 7.62939e-06
2.56414 7.62939e-06
0.277865 7.62939e-06
0.81406 7.62939e-06
3.33746 7.62939e-06
1.62138 7.62939e-06
2.02786 7.62939e-06
END
$hits3 << END
1.14328 0.00662231
1.54753 0.00582886
1.52449 0.0233154
1.7793 0.00970459
1.52142 0.021698
1.89214 0.0115967
0.96508 0.00662231
1.24273 0.00582886
1.33868 0.0233154
1.30404 0.00970459
1.52697 0.021698
1.30844 0.0115967
0.998555 0.00762939
1.21881 0.00596619
0.898055 0.0183563
0.980411 0.016861
0.811374 0.0166779
0.954829 0.0120697
2.75326 0.0205231
3.19632 0.0093689
END
$hits4 << END
1.26311 5.6514e-06
1.77158 5.6514e-06
1.41374 5.6514e-06
1.7833 5.6514e-06
1.55704 5.6514e-06
1.72749 5.6514e-06
1.14696 5.6514e-06
1.27435 5.6514e-06
0.901396 5.6514e-06
1.11048 5.6514e-06
1.32597 5.6514e-06
1.30506 5.6514e-06
1.2224 5.6514e-06
1.426 5.6514e-06
0.861017 5.6514e-06
1.22099 5.6514e-06
0.851127 5.6514e-06
1.22923 5.6514e-06
2.34886 5.6514e-06
2.78652 5.6514e-06
END
$hits5 << END
1.2337 0.00662231
1.38016 0.00582886
1.3731 0.0233154
1.66307 0.00971985
1.68839 0.021698
2.36076 0.0115967
1.26699 0.00662231
1.5136 0.00582886
1.18264 0.0233154
1.37969 0.00970459
1.37159 0.021698
1.58978 0.0115967
1.31597 0.00762939
1.53596 0.00596619
0.835844 0.0183716
1.35212 0.0168762
0.86583 0.0166779
1.03337 0.0120697
2.86931 0.0205231
3.01159 0.0093689
END
$hits_front << END
3.33746 7.62939e-06
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
set xrange [1.87996:29.0194]; set yrange [3.10144e-05:0.137335]
set xlabel 'pictures a second  (more is better)'; set ylabel 'picture: RMSE of a channel  (less is better)' offset -1.5
set xtics ('2' 2, '3' 3, '5' 5, '7' 7, '10' 10, '15' 15, '20' 20)
set ytics ("same\nbits" 7.75359e-05, '10⁻³' 1e-3, '10⁻²' 1e-2, '10⁻¹' 1e-1)
set object rectangle from graph 0, graph 0 to graph 1, first 0.000131811 fs solid noborder fc rgb '#eeeeee' behind
set arrow from first 24.1829,0.000620287 to graph 1.0,0.3568 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.3568 to graph 1.015,0.3568 nohead lw 0.8 lc rgb '#999999'
set label 'robust: uniform 32 exact' at graph 1.02,0.3568 left
set arrow from first 22.7965,5.7434e-05 to graph 1.0,0.0734 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.0734 to graph 1.015,0.0734 nohead lw 0.8 lc rgb '#999999'
set label 'double: irregular exact' at graph 1.02,0.0734 left
$picture0 << END
5.82436 0.0245371
7.18913 0.0245371
8.64484 0.0245371
11.6694 0.0245371
9.25706 0.0245371
16.3456 0.0245371
5.87134 0.0245371
8.21525 0.0245371
7.29802 0.0245371
9.75656 0.0245371
8.0445 0.0245371
14.1031 0.0245371
5.58565 0.0245371
7.27394 0.0245371
4.98505 0.0245371
6.85973 0.0245371
4.57646 0.0245371
6.33985 0.0245371
14.703 0.0245371
18.5386 0.0245371
END
$picture1 << END
6.17198 0.0325513
7.11273 0.0309071
9.13011 0.0549339
14.1496 0.0378821
8.68201 0.0510348
12.6383 0.0400519
6.23876 0.0325513
6.99947 0.0309071
7.80968 0.0549339
12.8167 0.0378821
7.90144 0.0510348
10.9664 0.0400519
5.86742 0.0325541
6.54934 0.0309071
6.30212 0.0430485
6.42981 0.0427338
5.07215 0.0450923
6.14392 0.0387686
16.943 0.0515727
16.5347 0.0385781
END
$picture2 << END
9.7009 0.000620287
8.66796 0.000620287
9.42501 0.000620287
13.7649 0.000620287
11.8884 0.000620287
12.8388 0.000620287
8.49764 0.000620287
8.92665 0.000620287
7.31168 0.000620287
9.56527 0.000620287
8.80058 0.000620287
12.1377 0.000620287
7.20909 0.000620287
10.3498 0.000620287
7.35202 0.000620287
10.7826 0.000620287
6.80475 0.000620287
9.19558 0.000620287
12.7905 0.000620287
19.5783 0.000620287
2.25595 0.000620287
6.51561 0.000620287
24.1829 0.000620287
15.5477 0.000620287
19.0516 0.000620287
END
$picture3 << END
10.1462 0.0224825
9.26449 0.019705
10.3995 0.0500998
11.8236 0.0290847
11.8368 0.0457432
14.493 0.0323349
7.7348 0.0224825
8.37045 0.019705
8.4386 0.0500998
10.9711 0.0290847
11.8362 0.0457432
10.2143 0.0323349
7.7612 0.0224865
9.7227 0.019705
8.16598 0.0360749
7.7832 0.035728
7.39625 0.0385456
9.68638 0.0307357
13.5991 0.0462929
24.0835 0.0306985
END
$picture4 << END
11.1183 5.7434e-05
13.5616 5.7434e-05
11.4933 5.7434e-05
13.2367 5.7434e-05
11.3212 5.7434e-05
12.6149 5.7434e-05
9.50002 5.7434e-05
9.95932 5.7434e-05
8.50272 5.7434e-05
10.4534 5.7434e-05
11.8551 5.7434e-05
12.5488 5.7434e-05
8.27749 5.7434e-05
10.2786 5.7434e-05
8.09873 5.7434e-05
10.7711 5.7434e-05
8.03502 5.7434e-05
9.81303 5.7434e-05
19.3159 5.7434e-05
22.7965 5.7434e-05
END
$picture5 << END
10.8553 0.0224738
9.7181 0.0196934
11.5982 0.0500977
15.8652 0.0290847
12.2239 0.0457408
15.8149 0.0323289
9.7855 0.0224738
10.8214 0.0196934
9.60341 0.0500977
9.42116 0.0290894
10.366 0.0457408
14.3468 0.0323289
9.88786 0.0224779
10.3912 0.0196934
8.0544 0.0360477
9.9076 0.0358389
8.23123 0.0385421
10.8708 0.0307286
21.1306 0.0462913
17.4741 0.0306909
END
$picture_front << END
22.7965 5.7434e-05
24.1829 0.000620287
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
set xrange [0.231554:4.00495]; set yrange [3.05176e-06:0.0588608]
set xlabel 'million nearest hits a second  (more is better)'; set ylabel 'wrong hits  (less is better)' offset -1.5
set label 'rings: speed against accuracy (CPU, 2 threads)' at screen 0.02, screen 0.9774 font ',20'
set label '256x256 primary and 65,536 random rays a scene; 65,536 in all compared with brute force in double; pictures of 128x128' at screen 0.02, screen 0.9516
set xtics ('0.3' 0.3, '0.5' 0.5, '0.7' 0.7, '1' 1, '1.5' 1.5, '2' 2, '3' 3)
set ytics ("none of\n65,536" 7.62939e-06, '0.01 %%' 1e-4, '0.1 %%' 1e-3, '1 %%' 1e-2)
set object rectangle from graph 0, graph 0 to graph 1, first 1.297e-05 fs solid noborder fc rgb '#eeeeee' behind
set arrow from first 3.33746,7.62939e-06 to graph 1.0,0.0929 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.0929 to graph 1.015,0.0929 nohead lw 0.8 lc rgb '#999999'
set label 'robust: uniform 32 exact' at graph 1.02,0.0929 left
$hits0 << END
0.755424 0.000259399
0.868589 0.000259399
1.1341 0.000259399
1.54459 0.000259399
1.33622 0.000259399
1.79104 0.000259399
0.748481 0.000259399
0.850116 0.000259399
0.895694 0.000259399
1.19428 0.000259399
1.06508 0.000259399
1.78116 0.000259399
0.730463 0.000259399
1.0163 0.000259399
0.512522 0.000259399
0.743034 0.000259399
0.482018 0.000259399
0.689263 0.000259399
1.99483 0.000259399
2.518 0.000259399
END
$hits1 << END
0.74792 0.00686646
0.987517 0.00610352
1.4332 0.0235443
1.58619 0.00991821
1.27253 0.0219116
2.19643 0.0118256
0.861225 0.00686646
0.897891 0.00610352
1.21089 0.0235443
1.33944 0.00991821
1.03254 0.0219116
1.42951 0.0118256
0.753862 0.00785828
0.956223 0.00624084
0.527634 0.0185242
0.713274 0.0170288
0.480853 0.0169067
0.685264 0.0122986
1.87549 0.0207214
2.72872 0.00959778
END
$hits2 << END
1.07964 7.62939e-06
1.35927 7.62939e-06
1.57321 7.62939e-06
1.67083 7.62939e-06
1.34434 7.62939e-06
1.99996 7.62939e-06
0.970095 7.62939e-06
1.11631 7.62939e-06
0.985171 7.62939e-06
1.16179 7.62939e-06
1.13342 7.62939e-06
1.39837 7.62939e-06
0.962149 7.62939e-06
1.3065 7.62939e-06
0.87642 7.62939e-06
0.888869 7.62939e-06
0.818953 7.62939e-06
0.886068 7.62939e-06
2.3973 7.62939e-06
2.56414 7.62939e-06
0.277865 7.62939e-06
0.81406 7.62939e-06
3.33746 7.62939e-06
1.62138 7.62939e-06
2.02786 7.62939e-06
END
$hits3 << END
1.14328 0.00662231
1.54753 0.00582886
1.52449 0.0233154
1.7793 0.00970459
1.52142 0.021698
1.89214 0.0115967
0.96508 0.00662231
1.24273 0.00582886
1.33868 0.0233154
1.30404 0.00970459
1.52697 0.021698
1.30844 0.0115967
0.998555 0.00762939
1.21881 0.00596619
0.898055 0.0183563
0.980411 0.016861
0.811374 0.0166779
0.954829 0.0120697
2.75326 0.0205231
3.19632 0.0093689
END
$hits4 << END
1.26311 5.6514e-06
1.77158 5.6514e-06
1.41374 5.6514e-06
1.7833 5.6514e-06
1.55704 5.6514e-06
1.72749 5.6514e-06
1.14696 5.6514e-06
1.27435 5.6514e-06
0.901396 5.6514e-06
1.11048 5.6514e-06
1.32597 5.6514e-06
1.30506 5.6514e-06
1.2224 5.6514e-06
1.426 5.6514e-06
0.861017 5.6514e-06
1.22099 5.6514e-06
0.851127 5.6514e-06
1.22923 5.6514e-06
2.34886 5.6514e-06
2.78652 5.6514e-06
END
$hits5 << END
1.2337 0.00662231
1.38016 0.00582886
1.3731 0.0233154
1.66307 0.00971985
1.68839 0.021698
2.36076 0.0115967
1.26699 0.00662231
1.5136 0.00582886
1.18264 0.0233154
1.37969 0.00970459
1.37159 0.021698
1.58978 0.0115967
1.31597 0.00762939
1.53596 0.00596619
0.835844 0.0183716
1.35212 0.0168762
0.86583 0.0166779
1.03337 0.0120697
2.86931 0.0205231
3.01159 0.0093689
END
$hits_front << END
3.33746 7.62939e-06
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
set xrange [1.87996:29.0194]; set yrange [3.10144e-05:0.137335]
set xlabel 'pictures a second  (more is better)'; set ylabel 'picture: RMSE of a channel  (less is better)' offset -1.5
set xtics ('2' 2, '3' 3, '5' 5, '7' 7, '10' 10, '15' 15, '20' 20)
set ytics ("same\nbits" 7.75359e-05, '10⁻³' 1e-3, '10⁻²' 1e-2, '10⁻¹' 1e-1)
set object rectangle from graph 0, graph 0 to graph 1, first 0.000131811 fs solid noborder fc rgb '#eeeeee' behind
set arrow from first 24.1829,0.000620287 to graph 1.0,0.3568 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.3568 to graph 1.015,0.3568 nohead lw 0.8 lc rgb '#999999'
set label 'robust: uniform 32 exact' at graph 1.02,0.3568 left
set arrow from first 22.7965,5.7434e-05 to graph 1.0,0.0734 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.0734 to graph 1.015,0.0734 nohead lw 0.8 lc rgb '#999999'
set label 'double: irregular exact' at graph 1.02,0.0734 left
$picture0 << END
5.82436 0.0245371
7.18913 0.0245371
8.64484 0.0245371
11.6694 0.0245371
9.25706 0.0245371
16.3456 0.0245371
5.87134 0.0245371
8.21525 0.0245371
7.29802 0.0245371
9.75656 0.0245371
8.0445 0.0245371
14.1031 0.0245371
5.58565 0.0245371
7.27394 0.0245371
4.98505 0.0245371
6.85973 0.0245371
4.57646 0.0245371
6.33985 0.0245371
14.703 0.0245371
18.5386 0.0245371
END
$picture1 << END
6.17198 0.0325513
7.11273 0.0309071
9.13011 0.0549339
14.1496 0.0378821
8.68201 0.0510348
12.6383 0.0400519
6.23876 0.0325513
6.99947 0.0309071
7.80968 0.0549339
12.8167 0.0378821
7.90144 0.0510348
10.9664 0.0400519
5.86742 0.0325541
6.54934 0.0309071
6.30212 0.0430485
6.42981 0.0427338
5.07215 0.0450923
6.14392 0.0387686
16.943 0.0515727
16.5347 0.0385781
END
$picture2 << END
9.7009 0.000620287
8.66796 0.000620287
9.42501 0.000620287
13.7649 0.000620287
11.8884 0.000620287
12.8388 0.000620287
8.49764 0.000620287
8.92665 0.000620287
7.31168 0.000620287
9.56527 0.000620287
8.80058 0.000620287
12.1377 0.000620287
7.20909 0.000620287
10.3498 0.000620287
7.35202 0.000620287
10.7826 0.000620287
6.80475 0.000620287
9.19558 0.000620287
12.7905 0.000620287
19.5783 0.000620287
2.25595 0.000620287
6.51561 0.000620287
24.1829 0.000620287
15.5477 0.000620287
19.0516 0.000620287
END
$picture3 << END
10.1462 0.0224825
9.26449 0.019705
10.3995 0.0500998
11.8236 0.0290847
11.8368 0.0457432
14.493 0.0323349
7.7348 0.0224825
8.37045 0.019705
8.4386 0.0500998
10.9711 0.0290847
11.8362 0.0457432
10.2143 0.0323349
7.7612 0.0224865
9.7227 0.019705
8.16598 0.0360749
7.7832 0.035728
7.39625 0.0385456
9.68638 0.0307357
13.5991 0.0462929
24.0835 0.0306985
END
$picture4 << END
11.1183 5.7434e-05
13.5616 5.7434e-05
11.4933 5.7434e-05
13.2367 5.7434e-05
11.3212 5.7434e-05
12.6149 5.7434e-05
9.50002 5.7434e-05
9.95932 5.7434e-05
8.50272 5.7434e-05
10.4534 5.7434e-05
11.8551 5.7434e-05
12.5488 5.7434e-05
8.27749 5.7434e-05
10.2786 5.7434e-05
8.09873 5.7434e-05
10.7711 5.7434e-05
8.03502 5.7434e-05
9.81303 5.7434e-05
19.3159 5.7434e-05
22.7965 5.7434e-05
END
$picture5 << END
10.8553 0.0224738
9.7181 0.0196934
11.5982 0.0500977
15.8652 0.0290847
12.2239 0.0457408
15.8149 0.0323289
9.7855 0.0224738
10.8214 0.0196934
9.60341 0.0500977
9.42116 0.0290894
10.366 0.0457408
14.3468 0.0323289
9.88786 0.0224779
10.3912 0.0196934
8.0544 0.0360477
9.9076 0.0358389
8.23123 0.0385421
10.8708 0.0307286
21.1306 0.0462913
17.4741 0.0306909
END
$picture_front << END
22.7965 5.7434e-05
24.1829 0.000620287
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
set xrange [0.803735:14.4596]; set yrange [3.05176e-06:0.00114441]
set xlabel 'million nearest hits a second  (more is better)'; set ylabel 'wrong hits  (less is better)' offset -1.5
set label 'teapot: speed against accuracy (CPU, 2 threads)' at screen 0.02, screen 0.9774 font ',20'
set label '256x256 primary and 65,536 random rays a scene; 65,536 in all compared with brute force in double; pictures of 128x128' at screen 0.02, screen 0.9516
set xtics ('1' 1, '1.5' 1.5, '2' 2, '3' 3, '5' 5, '7' 7, '10' 10)
set ytics ("none of\n65,536" 7.62939e-06, '0.01 %%' 1e-4, '0.1 %%' 1e-3)
set object rectangle from graph 0, graph 0 to graph 1, first 1.297e-05 fs solid noborder fc rgb '#eeeeee' behind
set arrow from first 12.0496,7.62939e-06 to graph 1.0,0.1546 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.1546 to graph 1.015,0.1546 nohead lw 0.8 lc rgb '#999999'
set label 'robust: irregular exact' at graph 1.02,0.1546 left
$hits0 << END
5.42044 1.52588e-05
6.07865 1.52588e-05
4.6113 1.52588e-05
4.93034 1.52588e-05
5.3095 1.52588e-05
5.50079 1.52588e-05
5.22188 1.52588e-05
5.33408 1.52588e-05
1.53804 1.52588e-05
2.49893 1.52588e-05
3.78603 1.52588e-05
3.88707 1.52588e-05
5.06956 1.52588e-05
5.18499 1.52588e-05
3.28972 1.52588e-05
3.21286 1.52588e-05
4.15025 1.52588e-05
4.11794 1.52588e-05
10.5778 1.52588e-05
11.3808 1.52588e-05
END
$hits1 << END
3.40252 0.000457764
3.48885 0.000457764
4.34558 0.00038147
4.4962 0.000396729
4.8535 0.000366211
5.02657 0.000198364
3.05425 0.000457764
3.17844 0.000457764
2.53114 0.00038147
2.55166 0.000396729
3.57467 0.000366211
3.66323 0.000198364
2.79647 0.000457764
2.90801 0.000457764
2.03758 0.000350952
2.00243 0.000427246
2.39627 0.000305176
2.4614 0.000167847
10.0221 0.000320435
10.9897 0.000137329
END
$hits2 << END
5.77705 7.62939e-06
6.77532 7.62939e-06
4.73509 7.62939e-06
4.9284 7.62939e-06
5.64218 7.62939e-06
5.87663 7.62939e-06
5.4951 7.62939e-06
5.73282 7.62939e-06
2.51284 7.62939e-06
2.56087 7.62939e-06
3.67622 7.62939e-06
3.88865 7.62939e-06
3.53395 7.62939e-06
5.08446 7.62939e-06
2.95354 7.62939e-06
3.28687 7.62939e-06
3.98002 7.62939e-06
4.09715 7.62939e-06
11.3272 7.62939e-06
12.0496 7.62939e-06
0.964482 7.62939e-06
3.11413 7.62939e-06
7.0487 7.62939e-06
2.88989 7.62939e-06
4.1331 7.62939e-06
END
$hits3 << END
3.61834 0.000442505
3.68871 0.000442505
4.39729 0.000366211
4.67122 0.00038147
4.89342 0.000350952
5.14749 0.000183105
3.23205 0.000442505
3.36175 0.000442505
2.45326 0.000366211
2.51991 0.00038147
3.62892 0.000350952
3.74384 0.000183105
1.96872 0.000442505
3.07155 0.000442505
2.05809 0.000335693
2.09643 0.000411987
2.42571 0.000289917
2.58856 0.000152588
9.88481 0.000305176
10.6741 0.00012207
END
$hits4 << END
6.43862 5.6514e-06
6.46905 5.6514e-06
4.44263 5.6514e-06
4.66779 5.6514e-06
5.16598 5.6514e-06
5.40646 5.6514e-06
5.39805 5.6514e-06
4.44077 5.6514e-06
2.44493 5.6514e-06
2.53572 5.6514e-06
3.78482 5.6514e-06
3.88717 5.6514e-06
4.32678 5.6514e-06
5.36602 5.6514e-06
3.14189 5.6514e-06
3.19288 5.6514e-06
3.82276 5.6514e-06
3.96909 5.6514e-06
11.2066 5.6514e-06
11.7241 5.6514e-06
END
$hits5 << END
4.00039 0.000442505
4.1891 0.000442505
4.1631 0.000366211
4.43209 0.00038147
4.60826 0.000350952
4.74711 0.000183105
3.63239 0.000442505
2.7628 0.000442505
2.43347 0.000366211
2.52346 0.00038147
3.70837 0.000350952
3.7953 0.000183105
3.33062 0.000442505
3.47257 0.000442505
2.23453 0.000335693
2.19383 0.000411987
2.60456 0.000289917
2.71866 0.000152588
10.3287 0.000305176
9.45713 0.00012207
END
$hits_front << END
12.0496 7.62939e-06
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
set xrange [2.92066:117.54]; set yrange [6.22131e-08:0.0179017]
set xlabel 'pictures a second  (more is better)'; set ylabel 'picture: RMSE of a channel  (less is better)' offset -1.5
set xtics ('5' 5, '10' 10, '20' 20, '50' 50, '100' 100)
set ytics ("same\nbits" 1.55533e-07, '10⁻⁶' 1e-6, '10⁻⁵' 1e-5, '10⁻⁴' 1e-4, '10⁻³' 1e-3, '10⁻²' 1e-2)
set object rectangle from graph 0, graph 0 to graph 1, first 2.64406e-07 fs solid noborder fc rgb '#eeeeee' behind
set arrow from first 97.9499,0.000386076 to graph 1.0,0.6948 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.6948 to graph 1.015,0.6948 nohead lw 0.8 lc rgb '#999999'
set label 'fast: irregular exact' at graph 1.02,0.6948 left
set arrow from first 85.1182,1.1521e-07 to graph 1.0,0.0490 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.0490 to graph 1.015,0.0490 nohead lw 0.8 lc rgb '#999999'
set label 'double: irregular exact' at graph 1.02,0.0490 left
$picture0 << END
53.7955 0.000386076
53.7084 0.000386076
44.5198 0.000386076
47.0363 0.000386076
54.5111 0.000386076
56.0994 0.000386076
46.0672 0.000386076
47.7093 0.000386076
25.275 0.000386076
24.0234 0.000386076
39.0945 0.000386076
38.7951 0.000386076
45.2853 0.000386076
46.2055 0.000386076
29.4953 0.000386076
27.7997 0.000386076
38.7835 0.000386076
37.723 0.000386076
93.8604 0.000386076
97.9499 0.000386076
END
$picture1 << END
35.1077 0.00676137
35.7704 0.00676137
41.9443 0.0071607
45.0694 0.00713817
51.9421 0.00709362
54.0678 0.00356432
31.6267 0.00676137
33.2454 0.00676137
24.4161 0.0071607
22.6299 0.00713817
37.7659 0.00709362
38.2074 0.00356432
30.7998 0.00676137
31.1693 0.00676137
21.1603 0.00596842
20.917 0.00531404
28.21 0.00426532
22.7021 0.00207633
85.3649 0.00584577
91.2496 0.00373511
END
$picture2 << END
29.4732 1.24426e-06
30.1708 1.24426e-06
38.942 1.24426e-06
42.9006 1.24426e-06
45.321 1.24426e-06
50.0167 1.24426e-06
27.217 1.24426e-06
28.9355 1.24426e-06
22.8748 1.24426e-06
24.6975 1.24426e-06
33.9152 1.24426e-06
36.4686 1.24426e-06
19.0443 1.24426e-06
26.8361 1.24426e-06
17.1107 1.24426e-06
18.2068 1.24426e-06
22.1504 1.24426e-06
23.1609 1.24426e-06
72.0993 1.24426e-06
80.8571 1.24426e-06
3.50479 1.24426e-06
11.8985 1.24426e-06
49.1715 1.24426e-06
22.4382 1.24426e-06
37.7014 1.24426e-06
END
$picture3 << END
30.3069 0.00675033
30.6623 0.00675033
40.1068 0.00715028
43.724 0.00712772
47.4334 0.0070831
52.2671 0.00354334
28.604 0.00675033
29.9216 0.00675033
23.2721 0.00715028
25.5551 0.00712772
35.6148 0.0070831
37.9397 0.00354334
15.0148 0.00675033
27.4517 0.00675033
17.5264 0.00595591
18.3472 0.0053
22.1982 0.00424781
23.6029 0.00204012
76.8534 0.005833
84.4199 0.00371511
END
$picture4 << END
33.8582 1.1521e-07
36.1829 1.1521e-07
38.866 1.1521e-07
43.0711 1.1521e-07
45.8567 1.1521e-07
50.3672 1.1521e-07
31.7996 1.1521e-07
27.7193 1.1521e-07
23.2855 1.1521e-07
25.0765 1.1521e-07
34.573 1.1521e-07
37.3822 1.1521e-07
29.8962 1.1521e-07
31.9971 1.1521e-07
18.7762 1.1521e-07
19.5291 1.1521e-07
23.9664 1.1521e-07
24.6852 1.1521e-07
77.2588 1.1521e-07
85.1182 1.1521e-07
END
$picture5 << END
34.6102 0.00675033
37.3091 0.00675033
39.2049 0.00715028
43.0429 0.00712772
47.8284 0.00708309
52.7059 0.00354334
32.6895 0.00675033
24.1562 0.00675033
23.9022 0.00715028
25.5016 0.00712772
36.7701 0.00708309
37.6361 0.00354334
30.3116 0.00675033
32.5016 0.00675033
18.396 0.00595591
19.5093 0.0053
23.8767 0.00424781
24.973 0.00204011
81.9852 0.005833
86.5081 0.0037151
END
$picture_front << END
85.1182 1.1521e-07
97.9499 0.000386076
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
set xrange [0.803735:14.4596]; set yrange [3.05176e-06:0.00114441]
set xlabel 'million nearest hits a second  (more is better)'; set ylabel 'wrong hits  (less is better)' offset -1.5
set label 'teapot: speed against accuracy (CPU, 2 threads)' at screen 0.02, screen 0.9774 font ',20'
set label '256x256 primary and 65,536 random rays a scene; 65,536 in all compared with brute force in double; pictures of 128x128' at screen 0.02, screen 0.9516
set xtics ('1' 1, '1.5' 1.5, '2' 2, '3' 3, '5' 5, '7' 7, '10' 10)
set ytics ("none of\n65,536" 7.62939e-06, '0.01 %%' 1e-4, '0.1 %%' 1e-3)
set object rectangle from graph 0, graph 0 to graph 1, first 1.297e-05 fs solid noborder fc rgb '#eeeeee' behind
set arrow from first 12.0496,7.62939e-06 to graph 1.0,0.1546 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.1546 to graph 1.015,0.1546 nohead lw 0.8 lc rgb '#999999'
set label 'robust: irregular exact' at graph 1.02,0.1546 left
$hits0 << END
5.42044 1.52588e-05
6.07865 1.52588e-05
4.6113 1.52588e-05
4.93034 1.52588e-05
5.3095 1.52588e-05
5.50079 1.52588e-05
5.22188 1.52588e-05
5.33408 1.52588e-05
1.53804 1.52588e-05
2.49893 1.52588e-05
3.78603 1.52588e-05
3.88707 1.52588e-05
5.06956 1.52588e-05
5.18499 1.52588e-05
3.28972 1.52588e-05
3.21286 1.52588e-05
4.15025 1.52588e-05
4.11794 1.52588e-05
10.5778 1.52588e-05
11.3808 1.52588e-05
END
$hits1 << END
3.40252 0.000457764
3.48885 0.000457764
4.34558 0.00038147
4.4962 0.000396729
4.8535 0.000366211
5.02657 0.000198364
3.05425 0.000457764
3.17844 0.000457764
2.53114 0.00038147
2.55166 0.000396729
3.57467 0.000366211
3.66323 0.000198364
2.79647 0.000457764
2.90801 0.000457764
2.03758 0.000350952
2.00243 0.000427246
2.39627 0.000305176
2.4614 0.000167847
10.0221 0.000320435
10.9897 0.000137329
END
$hits2 << END
5.77705 7.62939e-06
6.77532 7.62939e-06
4.73509 7.62939e-06
4.9284 7.62939e-06
5.64218 7.62939e-06
5.87663 7.62939e-06
5.4951 7.62939e-06
5.73282 7.62939e-06
2.51284 7.62939e-06
2.56087 7.62939e-06
3.67622 7.62939e-06
3.88865 7.62939e-06
3.53395 7.62939e-06
5.08446 7.62939e-06
2.95354 7.62939e-06
3.28687 7.62939e-06
3.98002 7.62939e-06
4.09715 7.62939e-06
11.3272 7.62939e-06
12.0496 7.62939e-06
0.964482 7.62939e-06
3.11413 7.62939e-06
7.0487 7.62939e-06
2.88989 7.62939e-06
4.1331 7.62939e-06
END
$hits3 << END
3.61834 0.000442505
3.68871 0.000442505
4.39729 0.000366211
4.67122 0.00038147
4.89342 0.000350952
5.14749 0.000183105
3.23205 0.000442505
3.36175 0.000442505
2.45326 0.000366211
2.51991 0.00038147
3.62892 0.000350952
3.74384 0.000183105
1.96872 0.000442505
3.07155 0.000442505
2.05809 0.000335693
2.09643 0.000411987
2.42571 0.000289917
2.58856 0.000152588
9.88481 0.000305176
10.6741 0.00012207
END
$hits4 << END
6.43862 5.6514e-06
6.46905 5.6514e-06
4.44263 5.6514e-06
4.66779 5.6514e-06
5.16598 5.6514e-06
5.40646 5.6514e-06
5.39805 5.6514e-06
4.44077 5.6514e-06
2.44493 5.6514e-06
2.53572 5.6514e-06
3.78482 5.6514e-06
3.88717 5.6514e-06
4.32678 5.6514e-06
5.36602 5.6514e-06
3.14189 5.6514e-06
3.19288 5.6514e-06
3.82276 5.6514e-06
3.96909 5.6514e-06
11.2066 5.6514e-06
11.7241 5.6514e-06
END
$hits5 << END
4.00039 0.000442505
4.1891 0.000442505
4.1631 0.000366211
4.43209 0.00038147
4.60826 0.000350952
4.74711 0.000183105
3.63239 0.000442505
2.7628 0.000442505
2.43347 0.000366211
2.52346 0.00038147
3.70837 0.000350952
3.7953 0.000183105
3.33062 0.000442505
3.47257 0.000442505
2.23453 0.000335693
2.19383 0.000411987
2.60456 0.000289917
2.71866 0.000152588
10.3287 0.000305176
9.45713 0.00012207
END
$hits_front << END
12.0496 7.62939e-06
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
set xrange [2.92066:117.54]; set yrange [6.22131e-08:0.0179017]
set xlabel 'pictures a second  (more is better)'; set ylabel 'picture: RMSE of a channel  (less is better)' offset -1.5
set xtics ('5' 5, '10' 10, '20' 20, '50' 50, '100' 100)
set ytics ("same\nbits" 1.55533e-07, '10⁻⁶' 1e-6, '10⁻⁵' 1e-5, '10⁻⁴' 1e-4, '10⁻³' 1e-3, '10⁻²' 1e-2)
set object rectangle from graph 0, graph 0 to graph 1, first 2.64406e-07 fs solid noborder fc rgb '#eeeeee' behind
set arrow from first 97.9499,0.000386076 to graph 1.0,0.6948 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.6948 to graph 1.015,0.6948 nohead lw 0.8 lc rgb '#999999'
set label 'fast: irregular exact' at graph 1.02,0.6948 left
set arrow from first 85.1182,1.1521e-07 to graph 1.0,0.0490 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.0490 to graph 1.015,0.0490 nohead lw 0.8 lc rgb '#999999'
set label 'double: irregular exact' at graph 1.02,0.0490 left
$picture0 << END
53.7955 0.000386076
53.7084 0.000386076
44.5198 0.000386076
47.0363 0.000386076
54.5111 0.000386076
56.0994 0.000386076
46.0672 0.000386076
47.7093 0.000386076
25.275 0.000386076
24.0234 0.000386076
39.0945 0.000386076
38.7951 0.000386076
45.2853 0.000386076
46.2055 0.000386076
29.4953 0.000386076
27.7997 0.000386076
38.7835 0.000386076
37.723 0.000386076
93.8604 0.000386076
97.9499 0.000386076
END
$picture1 << END
35.1077 0.00676137
35.7704 0.00676137
41.9443 0.0071607
45.0694 0.00713817
51.9421 0.00709362
54.0678 0.00356432
31.6267 0.00676137
33.2454 0.00676137
24.4161 0.0071607
22.6299 0.00713817
37.7659 0.00709362
38.2074 0.00356432
30.7998 0.00676137
31.1693 0.00676137
21.1603 0.00596842
20.917 0.00531404
28.21 0.00426532
22.7021 0.00207633
85.3649 0.00584577
91.2496 0.00373511
END
$picture2 << END
29.4732 1.24426e-06
30.1708 1.24426e-06
38.942 1.24426e-06
42.9006 1.24426e-06
45.321 1.24426e-06
50.0167 1.24426e-06
27.217 1.24426e-06
28.9355 1.24426e-06
22.8748 1.24426e-06
24.6975 1.24426e-06
33.9152 1.24426e-06
36.4686 1.24426e-06
19.0443 1.24426e-06
26.8361 1.24426e-06
17.1107 1.24426e-06
18.2068 1.24426e-06
22.1504 1.24426e-06
23.1609 1.24426e-06
72.0993 1.24426e-06
80.8571 1.24426e-06
3.50479 1.24426e-06
11.8985 1.24426e-06
49.1715 1.24426e-06
22.4382 1.24426e-06
37.7014 1.24426e-06
END
$picture3 << END
30.3069 0.00675033
30.6623 0.00675033
40.1068 0.00715028
43.724 0.00712772
47.4334 0.0070831
52.2671 0.00354334
28.604 0.00675033
29.9216 0.00675033
23.2721 0.00715028
25.5551 0.00712772
35.6148 0.0070831
37.9397 0.00354334
15.0148 0.00675033
27.4517 0.00675033
17.5264 0.00595591
18.3472 0.0053
22.1982 0.00424781
23.6029 0.00204012
76.8534 0.005833
84.4199 0.00371511
END
$picture4 << END
33.8582 1.1521e-07
36.1829 1.1521e-07
38.866 1.1521e-07
43.0711 1.1521e-07
45.8567 1.1521e-07
50.3672 1.1521e-07
31.7996 1.1521e-07
27.7193 1.1521e-07
23.2855 1.1521e-07
25.0765 1.1521e-07
34.573 1.1521e-07
37.3822 1.1521e-07
29.8962 1.1521e-07
31.9971 1.1521e-07
18.7762 1.1521e-07
19.5291 1.1521e-07
23.9664 1.1521e-07
24.6852 1.1521e-07
77.2588 1.1521e-07
85.1182 1.1521e-07
END
$picture5 << END
34.6102 0.00675033
37.3091 0.00675033
39.2049 0.00715028
43.0429 0.00712772
47.8284 0.00708309
52.7059 0.00354334
32.6895 0.00675033
24.1562 0.00675033
23.9022 0.00715028
25.5016 0.00712772
36.7701 0.00708309
37.6361 0.00354334
30.3116 0.00675033
32.5016 0.00675033
18.396 0.00595591
19.5093 0.0053
23.8767 0.00424781
24.973 0.00204011
81.9852 0.005833
86.5081 0.0037151
END
$picture_front << END
85.1182 1.1521e-07
97.9499 0.000386076
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
set xrange [0.453971:11.297]; set yrange [3.05176e-06:0.00175476]
set xlabel 'million nearest hits a second  (more is better)'; set ylabel 'wrong hits  (less is better)' offset -1.5
set label 'tetra: speed against accuracy (CPU, 2 threads)' at screen 0.02, screen 0.9774 font ',20'
set label '256x256 primary and 65,536 random rays a scene; 65,536 in all compared with brute force in double; pictures of 128x128' at screen 0.02, screen 0.9516
set xtics ('0.5' 0.5, '1' 1, '2' 2, '5' 5, '10' 10)
set ytics ("none of\n65,536" 7.62939e-06, '0.01 %%' 1e-4, '0.1 %%' 1e-3)
set object rectangle from graph 0, graph 0 to graph 1, first 1.297e-05 fs solid noborder fc rgb '#eeeeee' behind
set arrow from first 9.41413,7.62939e-06 to graph 1.0,0.1442 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.1442 to graph 1.015,0.1442 nohead lw 0.8 lc rgb '#999999'
set label 'robust: irregular exact' at graph 1.02,0.1442 left
$hits0 << END
4.68931 1.02997e-05
4.57488 1.02997e-05
4.1724 1.02997e-05
4.47479 1.02997e-05
6.45222 1.02997e-05
6.4582 1.02997e-05
4.33771 1.02997e-05
4.10673 1.02997e-05
2.53167 1.02997e-05
2.36125 1.02997e-05
5.01927 1.02997e-05
4.93282 1.02997e-05
3.86015 1.02997e-05
3.80208 1.02997e-05
3.10517 1.02997e-05
2.19207 1.02997e-05
4.14387 1.02997e-05
3.42385 1.02997e-05
8.33936 1.02997e-05
8.23605 1.02997e-05
END
$hits1 << END
2.67701 1.02997e-05
2.86894 4.57764e-05
3.55523 1.02997e-05
4.13757 7.62939e-05
4.9344 1.02997e-05
5.37167 1.02997e-05
2.69651 1.02997e-05
2.79333 4.57764e-05
2.42315 1.02997e-05
2.67539 7.62939e-05
4.09943 1.02997e-05
4.4038 1.02997e-05
2.35325 1.02997e-05
2.50058 6.10352e-05
1.89832 1.02997e-05
1.27708 0.000701904
2.48091 1.02997e-05
2.08566 0.000442505
6.97478 1.02997e-05
7.21818 4.57764e-05
END
$hits2 << END
5.94425 7.62939e-06
5.67031 7.62939e-06
4.47535 7.62939e-06
4.84797 7.62939e-06
7.1044 7.62939e-06
7.33023 7.62939e-06
5.2478 7.62939e-06
5.49093 7.62939e-06
2.71509 7.62939e-06
2.84638 7.62939e-06
5.35385 7.62939e-06
5.57859 7.62939e-06
4.91938 7.62939e-06
5.19539 7.62939e-06
3.55959 7.62939e-06
2.83741 7.62939e-06
4.80231 7.62939e-06
4.4988 7.62939e-06
9.09026 7.62939e-06
9.41413 7.62939e-06
0.544765 7.62939e-06
1.6179 7.62939e-06
4.07033 7.62939e-06
6.12473 7.62939e-06
2.6318 7.62939e-06
2.96273 7.62939e-06
END
$hits3 << END
3.18316 7.62939e-06
3.56571 4.57764e-05
3.69024 7.62939e-06
3.16798 7.62939e-05
5.33825 7.62939e-06
5.97045 7.62939e-06
3.07068 7.62939e-06
3.42145 4.57764e-05
2.43221 7.62939e-06
2.79299 7.62939e-05
4.37048 7.62939e-06
4.83277 7.62939e-06
2.73668 7.62939e-06
3.07248 6.10352e-05
2.01397 7.62939e-06
1.64637 0.000701904
2.70578 7.62939e-06
2.53241 0.000442505
7.49699 7.62939e-06
7.87027 4.57764e-05
END
$hits4 << END
5.84172 5.6514e-06
6.19085 5.6514e-06
4.21059 5.6514e-06
4.60486 5.6514e-06
6.9286 5.6514e-06
7.164 5.6514e-06
5.08669 5.6514e-06
5.33537 5.6514e-06
2.68533 5.6514e-06
2.82645 5.6514e-06
5.18674 5.6514e-06
5.43521 5.6514e-06
4.69437 5.6514e-06
4.99984 5.6514e-06
3.42779 5.6514e-06
2.69704 5.6514e-06
4.66075 5.6514e-06
4.07062 5.6514e-06
9.14438 5.6514e-06
9.2181 5.6514e-06
END
$hits5 << END
3.59335 5.6514e-06
3.76931 4.57764e-05
3.61882 5.6514e-06
4.16346 7.62939e-05
5.39353 5.6514e-06
5.92969 5.6514e-06
3.40276 5.6514e-06
3.66741 4.57764e-05
2.45579 5.6514e-06
2.77006 7.62939e-05
4.40965 5.6514e-06
4.88303 5.6514e-06
3.05316 5.6514e-06
3.39417 6.10352e-05
2.20462 5.6514e-06
1.7417 0.000701904
2.93819 5.6514e-06
2.65815 0.000442505
7.67281 5.6514e-06
8.06587 4.57764e-05
END
$hits_front << END
9.41413 7.62939e-06
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
set xrange [6.567:509.426]; set yrange [8.74782e-10:0.00543184]
set xlabel 'pictures a second  (more is better)'; set ylabel 'picture: RMSE of a channel  (less is better)' offset -1.5
set xtics ('10' 10, '20' 20, '50' 50, '100' 100, '200' 200, '500' 500)
set ytics ("same\nbits" 2.18695e-09, '10⁻⁸' 1e-8, '10⁻⁷' 1e-7, '10⁻⁶' 1e-6, '10⁻⁵' 1e-5, '10⁻⁴' 1e-4, '10⁻³' 1e-3)
set object rectangle from graph 0, graph 0 to graph 1, first 3.71782e-09 fs solid noborder fc rgb '#eeeeee' behind
set arrow from first 424.522,4.25742e-07 to graph 1.0,0.3956 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.3956 to graph 1.015,0.3956 nohead lw 0.8 lc rgb '#999999'
set label 'fast: irregular box' at graph 1.02,0.3956 left
set arrow from first 343.325,1.61997e-09 to graph 1.0,0.0394 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.0394 to graph 1.015,0.0394 nohead lw 0.8 lc rgb '#999999'
set label 'double, study: irregular box' at graph 1.02,0.0394 left
$picture0 << END
251.17 4.25742e-07
244.648 4.25742e-07
246.131 4.25742e-07
254.911 4.25742e-07
366.391 4.25742e-07
340.776 4.25742e-07
228.627 4.25742e-07
215.472 4.25742e-07
143.849 4.25742e-07
145.792 4.25742e-07
261.032 4.25742e-07
242.441 4.25742e-07
211.72 4.25742e-07
205.125 4.25742e-07
186.053 4.25742e-07
124.121 4.25742e-07
239.375 4.25742e-07
210.947 4.25742e-07
424.522 4.25742e-07
392.17 4.25742e-07
END
$picture1 << END
142.547 4.25742e-07
136.016 4.25742e-07
198.755 4.25742e-07
213.392 4.25742e-07
237.214 4.25742e-07
284.085 4.25742e-07
135.18 4.25742e-07
140.082 4.25742e-07
125.315 4.25742e-07
138.342 4.25742e-07
212.722 4.25742e-07
218.133 4.25742e-07
125.182 4.25742e-07
130.896 4.25742e-07
111.948 4.25742e-07
87.023 0.00173156
142.129 4.25742e-07
127.112 0.00217274
355.199 4.25742e-07
342.008 4.25742e-07
END
$picture2 << END
120.483 1.74956e-08
132.886 1.74956e-08
170.152 1.74956e-08
206.138 1.74956e-08
231.74 1.74956e-08
262.789 1.74956e-08
117.458 1.74956e-08
127.055 1.74956e-08
115.609 1.74956e-08
131.701 1.74956e-08
185.208 1.74956e-08
207.938 1.74956e-08
110.175 1.74956e-08
119.873 1.74956e-08
99.6476 1.74956e-08
84.2713 1.74956e-08
126.449 1.74956e-08
125.761 1.74956e-08
304.827 1.74956e-08
325.398 1.74956e-08
7.8804 1.74956e-08
24.0967 1.74956e-08
66.6299 1.74956e-08
179.327 1.74956e-08
111.854 1.74956e-08
157.478 1.74956e-08
END
$picture3 << END
131.593 1.74956e-08
146.199 1.74956e-08
179.924 1.74956e-08
222.235 1.74956e-08
245.118 1.74956e-08
279.088 1.74956e-08
126.426 1.74956e-08
138.468 1.74956e-08
119.862 1.74956e-08
135.233 1.74956e-08
197.091 1.74956e-08
216.902 1.74956e-08
116.552 1.74956e-08
130.169 1.74956e-08
106.196 1.74956e-08
86.0639 0.00173156
133.646 1.74956e-08
130.407 0.00217274
330.555 1.74956e-08
340.73 1.74956e-08
END
$picture4 << END
137.846 1.61997e-09
150.668 1.61997e-09
173.131 1.61997e-09
206.407 1.61997e-09
243.204 1.61997e-09
272.636 1.61997e-09
130.241 1.61997e-09
143.572 1.61997e-09
114.597 1.61997e-09
131.671 1.61997e-09
194.876 1.61997e-09
211.625 1.61997e-09
125.324 1.61997e-09
134.289 1.61997e-09
112.193 1.61997e-09
90.4635 1.61997e-09
144.178 1.61997e-09
136.707 1.61997e-09
324.874 1.61997e-09
331.683 1.61997e-09
END
$picture5 << END
150.061 1.61997e-09
162.994 1.61997e-09
178.389 1.61997e-09
216.653 1.61997e-09
256.632 1.61997e-09
283.344 1.61997e-09
139.802 1.61997e-09
151.264 1.61997e-09
121.126 1.61997e-09
136.417 1.61997e-09
200.8 1.61997e-09
219.289 1.61997e-09
130.624 1.61997e-09
146.721 1.61997e-09
114.439 1.61997e-09
92.4059 0.00173156
144.117 1.61997e-09
137.168 0.00217274
343.325 1.61997e-09
339.038 1.61997e-09
END
$picture_front << END
343.325 1.61997e-09
424.522 4.25742e-07
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
set xrange [0.453971:11.297]; set yrange [3.05176e-06:0.00175476]
set xlabel 'million nearest hits a second  (more is better)'; set ylabel 'wrong hits  (less is better)' offset -1.5
set label 'tetra: speed against accuracy (CPU, 2 threads)' at screen 0.02, screen 0.9774 font ',20'
set label '256x256 primary and 65,536 random rays a scene; 65,536 in all compared with brute force in double; pictures of 128x128' at screen 0.02, screen 0.9516
set xtics ('0.5' 0.5, '1' 1, '2' 2, '5' 5, '10' 10)
set ytics ("none of\n65,536" 7.62939e-06, '0.01 %%' 1e-4, '0.1 %%' 1e-3)
set object rectangle from graph 0, graph 0 to graph 1, first 1.297e-05 fs solid noborder fc rgb '#eeeeee' behind
set arrow from first 9.41413,7.62939e-06 to graph 1.0,0.1442 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.1442 to graph 1.015,0.1442 nohead lw 0.8 lc rgb '#999999'
set label 'robust: irregular exact' at graph 1.02,0.1442 left
$hits0 << END
4.68931 1.02997e-05
4.57488 1.02997e-05
4.1724 1.02997e-05
4.47479 1.02997e-05
6.45222 1.02997e-05
6.4582 1.02997e-05
4.33771 1.02997e-05
4.10673 1.02997e-05
2.53167 1.02997e-05
2.36125 1.02997e-05
5.01927 1.02997e-05
4.93282 1.02997e-05
3.86015 1.02997e-05
3.80208 1.02997e-05
3.10517 1.02997e-05
2.19207 1.02997e-05
4.14387 1.02997e-05
3.42385 1.02997e-05
8.33936 1.02997e-05
8.23605 1.02997e-05
END
$hits1 << END
2.67701 1.02997e-05
2.86894 4.57764e-05
3.55523 1.02997e-05
4.13757 7.62939e-05
4.9344 1.02997e-05
5.37167 1.02997e-05
2.69651 1.02997e-05
2.79333 4.57764e-05
2.42315 1.02997e-05
2.67539 7.62939e-05
4.09943 1.02997e-05
4.4038 1.02997e-05
2.35325 1.02997e-05
2.50058 6.10352e-05
1.89832 1.02997e-05
1.27708 0.000701904
2.48091 1.02997e-05
2.08566 0.000442505
6.97478 1.02997e-05
7.21818 4.57764e-05
END
$hits2 << END
5.94425 7.62939e-06
5.67031 7.62939e-06
4.47535 7.62939e-06
4.84797 7.62939e-06
7.1044 7.62939e-06
7.33023 7.62939e-06
5.2478 7.62939e-06
5.49093 7.62939e-06
2.71509 7.62939e-06
2.84638 7.62939e-06
5.35385 7.62939e-06
5.57859 7.62939e-06
4.91938 7.62939e-06
5.19539 7.62939e-06
3.55959 7.62939e-06
2.83741 7.62939e-06
4.80231 7.62939e-06
4.4988 7.62939e-06
9.09026 7.62939e-06
9.41413 7.62939e-06
0.544765 7.62939e-06
1.6179 7.62939e-06
4.07033 7.62939e-06
6.12473 7.62939e-06
2.6318 7.62939e-06
2.96273 7.62939e-06
END
$hits3 << END
3.18316 7.62939e-06
3.56571 4.57764e-05
3.69024 7.62939e-06
3.16798 7.62939e-05
5.33825 7.62939e-06
5.97045 7.62939e-06
3.07068 7.62939e-06
3.42145 4.57764e-05
2.43221 7.62939e-06
2.79299 7.62939e-05
4.37048 7.62939e-06
4.83277 7.62939e-06
2.73668 7.62939e-06
3.07248 6.10352e-05
2.01397 7.62939e-06
1.64637 0.000701904
2.70578 7.62939e-06
2.53241 0.000442505
7.49699 7.62939e-06
7.87027 4.57764e-05
END
$hits4 << END
5.84172 5.6514e-06
6.19085 5.6514e-06
4.21059 5.6514e-06
4.60486 5.6514e-06
6.9286 5.6514e-06
7.164 5.6514e-06
5.08669 5.6514e-06
5.33537 5.6514e-06
2.68533 5.6514e-06
2.82645 5.6514e-06
5.18674 5.6514e-06
5.43521 5.6514e-06
4.69437 5.6514e-06
4.99984 5.6514e-06
3.42779 5.6514e-06
2.69704 5.6514e-06
4.66075 5.6514e-06
4.07062 5.6514e-06
9.14438 5.6514e-06
9.2181 5.6514e-06
END
$hits5 << END
3.59335 5.6514e-06
3.76931 4.57764e-05
3.61882 5.6514e-06
4.16346 7.62939e-05
5.39353 5.6514e-06
5.92969 5.6514e-06
3.40276 5.6514e-06
3.66741 4.57764e-05
2.45579 5.6514e-06
2.77006 7.62939e-05
4.40965 5.6514e-06
4.88303 5.6514e-06
3.05316 5.6514e-06
3.39417 6.10352e-05
2.20462 5.6514e-06
1.7417 0.000701904
2.93819 5.6514e-06
2.65815 0.000442505
7.67281 5.6514e-06
8.06587 4.57764e-05
END
$hits_front << END
9.41413 7.62939e-06
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
set xrange [6.567:509.426]; set yrange [8.74782e-10:0.00543184]
set xlabel 'pictures a second  (more is better)'; set ylabel 'picture: RMSE of a channel  (less is better)' offset -1.5
set xtics ('10' 10, '20' 20, '50' 50, '100' 100, '200' 200, '500' 500)
set ytics ("same\nbits" 2.18695e-09, '10⁻⁸' 1e-8, '10⁻⁷' 1e-7, '10⁻⁶' 1e-6, '10⁻⁵' 1e-5, '10⁻⁴' 1e-4, '10⁻³' 1e-3)
set object rectangle from graph 0, graph 0 to graph 1, first 3.71782e-09 fs solid noborder fc rgb '#eeeeee' behind
set arrow from first 424.522,4.25742e-07 to graph 1.0,0.3956 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.3956 to graph 1.015,0.3956 nohead lw 0.8 lc rgb '#999999'
set label 'fast: irregular box' at graph 1.02,0.3956 left
set arrow from first 343.325,1.61997e-09 to graph 1.0,0.0394 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.0394 to graph 1.015,0.0394 nohead lw 0.8 lc rgb '#999999'
set label 'double, study: irregular box' at graph 1.02,0.0394 left
$picture0 << END
251.17 4.25742e-07
244.648 4.25742e-07
246.131 4.25742e-07
254.911 4.25742e-07
366.391 4.25742e-07
340.776 4.25742e-07
228.627 4.25742e-07
215.472 4.25742e-07
143.849 4.25742e-07
145.792 4.25742e-07
261.032 4.25742e-07
242.441 4.25742e-07
211.72 4.25742e-07
205.125 4.25742e-07
186.053 4.25742e-07
124.121 4.25742e-07
239.375 4.25742e-07
210.947 4.25742e-07
424.522 4.25742e-07
392.17 4.25742e-07
END
$picture1 << END
142.547 4.25742e-07
136.016 4.25742e-07
198.755 4.25742e-07
213.392 4.25742e-07
237.214 4.25742e-07
284.085 4.25742e-07
135.18 4.25742e-07
140.082 4.25742e-07
125.315 4.25742e-07
138.342 4.25742e-07
212.722 4.25742e-07
218.133 4.25742e-07
125.182 4.25742e-07
130.896 4.25742e-07
111.948 4.25742e-07
87.023 0.00173156
142.129 4.25742e-07
127.112 0.00217274
355.199 4.25742e-07
342.008 4.25742e-07
END
$picture2 << END
120.483 1.74956e-08
132.886 1.74956e-08
170.152 1.74956e-08
206.138 1.74956e-08
231.74 1.74956e-08
262.789 1.74956e-08
117.458 1.74956e-08
127.055 1.74956e-08
115.609 1.74956e-08
131.701 1.74956e-08
185.208 1.74956e-08
207.938 1.74956e-08
110.175 1.74956e-08
119.873 1.74956e-08
99.6476 1.74956e-08
84.2713 1.74956e-08
126.449 1.74956e-08
125.761 1.74956e-08
304.827 1.74956e-08
325.398 1.74956e-08
7.8804 1.74956e-08
24.0967 1.74956e-08
66.6299 1.74956e-08
179.327 1.74956e-08
111.854 1.74956e-08
157.478 1.74956e-08
END
$picture3 << END
131.593 1.74956e-08
146.199 1.74956e-08
179.924 1.74956e-08
222.235 1.74956e-08
245.118 1.74956e-08
279.088 1.74956e-08
126.426 1.74956e-08
138.468 1.74956e-08
119.862 1.74956e-08
135.233 1.74956e-08
197.091 1.74956e-08
216.902 1.74956e-08
116.552 1.74956e-08
130.169 1.74956e-08
106.196 1.74956e-08
86.0639 0.00173156
133.646 1.74956e-08
130.407 0.00217274
330.555 1.74956e-08
340.73 1.74956e-08
END
$picture4 << END
137.846 1.61997e-09
150.668 1.61997e-09
173.131 1.61997e-09
206.407 1.61997e-09
243.204 1.61997e-09
272.636 1.61997e-09
130.241 1.61997e-09
143.572 1.61997e-09
114.597 1.61997e-09
131.671 1.61997e-09
194.876 1.61997e-09
211.625 1.61997e-09
125.324 1.61997e-09
134.289 1.61997e-09
112.193 1.61997e-09
90.4635 1.61997e-09
144.178 1.61997e-09
136.707 1.61997e-09
324.874 1.61997e-09
331.683 1.61997e-09
END
$picture5 << END
150.061 1.61997e-09
162.994 1.61997e-09
178.389 1.61997e-09
216.653 1.61997e-09
256.632 1.61997e-09
283.344 1.61997e-09
139.802 1.61997e-09
151.264 1.61997e-09
121.126 1.61997e-09
136.417 1.61997e-09
200.8 1.61997e-09
219.289 1.61997e-09
130.624 1.61997e-09
146.721 1.61997e-09
114.439 1.61997e-09
92.4059 0.00173156
144.117 1.61997e-09
137.168 0.00217274
343.325 1.61997e-09
339.038 1.61997e-09
END
$picture_front << END
343.325 1.61997e-09
424.522 4.25742e-07
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
set xrange [0.554061:15.9363]; set yrange [3.05176e-06:0.017395]
set xlabel 'million nearest hits a second  (more is better)'; set ylabel 'wrong hits  (less is better)' offset -1.5
set label 'tree: speed against accuracy (CPU, 2 threads)' at screen 0.02, screen 0.9774 font ',20'
set label '256x256 primary and 65,536 random rays a scene; 65,536 in all compared with brute force in double; pictures of 128x128' at screen 0.02, screen 0.9516
set xtics ('1' 1, '2' 2, '5' 5, '10' 10)
set ytics ("none of\n65,536" 7.62939e-06, '0.01 %%' 1e-4, '0.1 %%' 1e-3, '1 %%' 1e-2)
set object rectangle from graph 0, graph 0 to graph 1, first 1.297e-05 fs solid noborder fc rgb '#eeeeee' behind
set arrow from first 13.2802,0.00564575 to graph 1.0,0.8699 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.8699 to graph 1.015,0.8699 nohead lw 0.8 lc rgb '#999999'
set label 'double, study: irregular exact' at graph 1.02,0.8699 left
set arrow from first 12.8496,0.00125122 to graph 1.0,0.6957 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.6957 to graph 1.015,0.6957 nohead lw 0.8 lc rgb '#999999'
set label 'fast: irregular exact' at graph 1.02,0.6957 left
set arrow from first 12.1305,5.6514e-06 to graph 1.0,0.0713 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.0713 to graph 1.015,0.0713 nohead lw 0.8 lc rgb '#999999'
set label 'double: irregular box' at graph 1.02,0.0713 left
$hits0 << END
2.48316 0.00125122
2.65053 0.00125122
1.46673 0.00125122
1.48652 0.00125122
2.63388 0.00125122
2.79118 0.00125122
11.7206 0.00125122
12.8496 0.00125122
END
$hits1 << END
2.59494 0.00257874
2.78333 0.0022583
1.62959 0.00257874
1.54434 0.0022583
2.83893 0.00180054
2.72944 0.00158691
12.1196 0.00695801
13.2802 0.00691223
END
$hits2 << END
2.50656 7.62939e-06
2.75968 7.62939e-06
1.45843 7.62939e-06
1.45894 7.62939e-06
0.684946 7.62939e-06
0.694273 7.62939e-06
3.62989 7.62939e-06
3.5666 7.62939e-06
11.7139 7.62939e-06
11.6294 7.62939e-06
1.65246 7.62939e-06
2.3124 7.62939e-06
END
$hits3 << END
0.664873 0.000930786
3.01244 0.00132751
3.0882 0.00100708
1.56429 0.00132751
1.5617 0.00100708
0.698027 0.000823975
0.70904 0.000793457
3.42971 0.000564575
3.3968 0.000350952
12.2778 0.00569153
12.8965 0.00564575
END
$hits4 << END
0.909928 5.6514e-06
0.916204 5.6514e-06
2.82398 5.6514e-06
3.07774 5.6514e-06
0.83743 5.6514e-06
0.868222 5.6514e-06
1.43377 5.6514e-06
1.27848 5.6514e-06
0.970065 5.6514e-06
0.984764 5.6514e-06
3.64311 5.6514e-06
3.37594 5.6514e-06
12.1305 5.6514e-06
11.8141 5.6514e-06
END
$hits5 << END
0.917514 0.000823975
0.930403 0.000930786
2.96214 0.00132751
3.1973 0.00100708
0.861818 0.000823975
0.891072 0.000930786
1.69052 0.00132751
1.62873 0.00100708
0.998756 0.000823975
1.02613 0.000793457
3.94957 0.000564575
3.80776 0.000350952
12.4554 0.00569153
13.2802 0.00564575
END
$hits_front << END
12.1305 5.6514e-06
12.8496 0.00125122
13.2802 0.00564575
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
set xrange [3.67252:132.827]; set yrange [5.26248e-05:0.0737031]
set xlabel 'pictures a second  (more is better)'; set ylabel 'picture: RMSE of a channel  (less is better)' offset -1.5
set xtics ('5' 5, '10' 10, '20' 20, '50' 50, '100' 100)
set ytics ("same\nbits" 0.000131562, '10⁻³' 1e-3, '10⁻²' 1e-2)
set object rectangle from graph 0, graph 0 to graph 1, first 0.000223655 fs solid noborder fc rgb '#eeeeee' behind
set arrow from first 110.689,0.02938 to graph 1.0,0.8730 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.8730 to graph 1.015,0.8730 nohead lw 0.8 lc rgb '#999999'
set label 'fast, study: irregular exact' at graph 1.02,0.8730 left
set arrow from first 109.109,0.0196098 to graph 1.0,0.8172 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.8172 to graph 1.015,0.8172 nohead lw 0.8 lc rgb '#999999'
set label 'fast: irregular exact' at graph 1.02,0.8172 left
set arrow from first 99.7457,9.74533e-05 to graph 1.0,0.0851 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.0851 to graph 1.015,0.0851 nohead lw 0.8 lc rgb '#999999'
set label 'double: irregular exact' at graph 1.02,0.0851 left
$picture0 << END
25.2248 0.0196098
27.9695 0.0196098
12.019 0.0196098
12.2785 0.0196098
18.5385 0.0196098
21.0698 0.0196098
103.155 0.0196098
109.109 0.0196098
END
$picture1 << END
25.5634 0.0207304
27.9892 0.0205941
12.0886 0.0207304
12.1966 0.0205941
18.2796 0.0198815
21.1226 0.0197756
103.647 0.0294812
110.689 0.02938
END
$picture2 << END
24.6847 0.0010525
27.1123 0.0010525
11.7339 0.0010525
11.8915 0.0010525
4.477 0.0010525
4.52098 0.0010525
24.9231 0.0010525
26.392 0.0010525
89.1925 0.0010525
96.1993 0.0010525
8.35289 0.0010525
12.2856 0.0010525
END
$picture3 << END
4.40703 0.00466028
25.8091 0.00698046
28.341 0.0064093
11.5924 0.00698046
11.9129 0.0064093
4.51271 0.00394034
4.55948 0.00405174
24.8564 0.00375491
26.754 0.00280699
93.5471 0.0220059
97.4061 0.0218984
END
$picture4 << END
5.96692 9.74533e-05
6.20591 9.74533e-05
24.8749 9.74533e-05
27.004 9.74533e-05
5.02559 9.74533e-05
5.39211 9.74533e-05
11.6378 9.74533e-05
11.7108 9.74533e-05
6.29439 9.74533e-05
6.26124 9.74533e-05
27.3755 9.74533e-05
29.0905 9.74533e-05
94.0748 9.74533e-05
99.7457 9.74533e-05
END
$picture5 << END
6.17761 0.00379718
6.25603 0.00453988
25.493 0.00690066
27.4721 0.00632229
5.19497 0.00379718
5.35149 0.00453988
11.9224 0.00690066
11.9818 0.00632229
6.25635 0.00379718
6.50917 0.00391266
27.258 0.00360438
28.752 0.0026022
96.6709 0.0219873
100.652 0.0218731
END
$picture_front << END
99.7457 9.74533e-05
109.109 0.0196098
110.689 0.02938
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
set xrange [0.554061:15.9363]; set yrange [3.05176e-06:0.017395]
set xlabel 'million nearest hits a second  (more is better)'; set ylabel 'wrong hits  (less is better)' offset -1.5
set label 'tree: speed against accuracy (CPU, 2 threads)' at screen 0.02, screen 0.9774 font ',20'
set label '256x256 primary and 65,536 random rays a scene; 65,536 in all compared with brute force in double; pictures of 128x128' at screen 0.02, screen 0.9516
set xtics ('1' 1, '2' 2, '5' 5, '10' 10)
set ytics ("none of\n65,536" 7.62939e-06, '0.01 %%' 1e-4, '0.1 %%' 1e-3, '1 %%' 1e-2)
set object rectangle from graph 0, graph 0 to graph 1, first 1.297e-05 fs solid noborder fc rgb '#eeeeee' behind
set arrow from first 13.2802,0.00564575 to graph 1.0,0.8699 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.8699 to graph 1.015,0.8699 nohead lw 0.8 lc rgb '#999999'
set label 'double, study: irregular exact' at graph 1.02,0.8699 left
set arrow from first 12.8496,0.00125122 to graph 1.0,0.6957 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.6957 to graph 1.015,0.6957 nohead lw 0.8 lc rgb '#999999'
set label 'fast: irregular exact' at graph 1.02,0.6957 left
set arrow from first 12.1305,5.6514e-06 to graph 1.0,0.0713 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.0713 to graph 1.015,0.0713 nohead lw 0.8 lc rgb '#999999'
set label 'double: irregular box' at graph 1.02,0.0713 left
$hits0 << END
2.48316 0.00125122
2.65053 0.00125122
1.46673 0.00125122
1.48652 0.00125122
2.63388 0.00125122
2.79118 0.00125122
11.7206 0.00125122
12.8496 0.00125122
END
$hits1 << END
2.59494 0.00257874
2.78333 0.0022583
1.62959 0.00257874
1.54434 0.0022583
2.83893 0.00180054
2.72944 0.00158691
12.1196 0.00695801
13.2802 0.00691223
END
$hits2 << END
2.50656 7.62939e-06
2.75968 7.62939e-06
1.45843 7.62939e-06
1.45894 7.62939e-06
0.684946 7.62939e-06
0.694273 7.62939e-06
3.62989 7.62939e-06
3.5666 7.62939e-06
11.7139 7.62939e-06
11.6294 7.62939e-06
1.65246 7.62939e-06
2.3124 7.62939e-06
END
$hits3 << END
0.664873 0.000930786
3.01244 0.00132751
3.0882 0.00100708
1.56429 0.00132751
1.5617 0.00100708
0.698027 0.000823975
0.70904 0.000793457
3.42971 0.000564575
3.3968 0.000350952
12.2778 0.00569153
12.8965 0.00564575
END
$hits4 << END
0.909928 5.6514e-06
0.916204 5.6514e-06
2.82398 5.6514e-06
3.07774 5.6514e-06
0.83743 5.6514e-06
0.868222 5.6514e-06
1.43377 5.6514e-06
1.27848 5.6514e-06
0.970065 5.6514e-06
0.984764 5.6514e-06
3.64311 5.6514e-06
3.37594 5.6514e-06
12.1305 5.6514e-06
11.8141 5.6514e-06
END
$hits5 << END
0.917514 0.000823975
0.930403 0.000930786
2.96214 0.00132751
3.1973 0.00100708
0.861818 0.000823975
0.891072 0.000930786
1.69052 0.00132751
1.62873 0.00100708
0.998756 0.000823975
1.02613 0.000793457
3.94957 0.000564575
3.80776 0.000350952
12.4554 0.00569153
13.2802 0.00564575
END
$hits_front << END
12.1305 5.6514e-06
12.8496 0.00125122
13.2802 0.00564575
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
set xrange [3.67252:132.827]; set yrange [5.26248e-05:0.0737031]
set xlabel 'pictures a second  (more is better)'; set ylabel 'picture: RMSE of a channel  (less is better)' offset -1.5
set xtics ('5' 5, '10' 10, '20' 20, '50' 50, '100' 100)
set ytics ("same\nbits" 0.000131562, '10⁻³' 1e-3, '10⁻²' 1e-2)
set object rectangle from graph 0, graph 0 to graph 1, first 0.000223655 fs solid noborder fc rgb '#eeeeee' behind
set arrow from first 110.689,0.02938 to graph 1.0,0.8730 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.8730 to graph 1.015,0.8730 nohead lw 0.8 lc rgb '#999999'
set label 'fast, study: irregular exact' at graph 1.02,0.8730 left
set arrow from first 109.109,0.0196098 to graph 1.0,0.8172 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.8172 to graph 1.015,0.8172 nohead lw 0.8 lc rgb '#999999'
set label 'fast: irregular exact' at graph 1.02,0.8172 left
set arrow from first 99.7457,9.74533e-05 to graph 1.0,0.0851 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.0851 to graph 1.015,0.0851 nohead lw 0.8 lc rgb '#999999'
set label 'double: irregular exact' at graph 1.02,0.0851 left
$picture0 << END
25.2248 0.0196098
27.9695 0.0196098
12.019 0.0196098
12.2785 0.0196098
18.5385 0.0196098
21.0698 0.0196098
103.155 0.0196098
109.109 0.0196098
END
$picture1 << END
25.5634 0.0207304
27.9892 0.0205941
12.0886 0.0207304
12.1966 0.0205941
18.2796 0.0198815
21.1226 0.0197756
103.647 0.0294812
110.689 0.02938
END
$picture2 << END
24.6847 0.0010525
27.1123 0.0010525
11.7339 0.0010525
11.8915 0.0010525
4.477 0.0010525
4.52098 0.0010525
24.9231 0.0010525
26.392 0.0010525
89.1925 0.0010525
96.1993 0.0010525
8.35289 0.0010525
12.2856 0.0010525
END
$picture3 << END
4.40703 0.00466028
25.8091 0.00698046
28.341 0.0064093
11.5924 0.00698046
11.9129 0.0064093
4.51271 0.00394034
4.55948 0.00405174
24.8564 0.00375491
26.754 0.00280699
93.5471 0.0220059
97.4061 0.0218984
END
$picture4 << END
5.96692 9.74533e-05
6.20591 9.74533e-05
24.8749 9.74533e-05
27.004 9.74533e-05
5.02559 9.74533e-05
5.39211 9.74533e-05
11.6378 9.74533e-05
11.7108 9.74533e-05
6.29439 9.74533e-05
6.26124 9.74533e-05
27.3755 9.74533e-05
29.0905 9.74533e-05
94.0748 9.74533e-05
99.7457 9.74533e-05
END
$picture5 << END
6.17761 0.00379718
6.25603 0.00453988
25.493 0.00690066
27.4721 0.00632229
5.19497 0.00379718
5.35149 0.00453988
11.9224 0.00690066
11.9818 0.00632229
6.25635 0.00379718
6.50917 0.00391266
27.258 0.00360438
28.752 0.0026022
96.6709 0.0219873
100.652 0.0218731
END
$picture_front << END
99.7457 9.74533e-05
109.109 0.0196098
110.689 0.02938
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
set xrange [0.579893:9.1041]; set yrange [4.35965e-07:0.0195694]
set xlabel 'million nearest hits a second  (more is better)'; set ylabel 'wrong hits  (less is better)' offset -1.5
set label 'mean of 7 scenes: speed against accuracy (CPU, 2 threads)' at screen 0.02, screen 0.9774 font ',20'
set label '256x256 primary and 65,536 random rays a scene; 458,752 in all compared with brute force in double; pictures of 128x128' at screen 0.02, screen 0.9516
set xtics ('0.7' 0.7, '1' 1, '1.5' 1.5, '2' 2, '3' 3, '5' 5, '7' 7)
set ytics ("none of\n458,752" 1.08991e-06, '0.001 %%' 1e-5, '0.01 %%' 1e-4, '0.1 %%' 1e-3, '1 %%' 1e-2)
set object rectangle from graph 0, graph 0 to graph 1, first 1.85285e-06 fs solid noborder fc rgb '#eeeeee' behind
set arrow from first 7.58675,0.00243051 to graph 1.0,0.8053 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.8053 to graph 1.015,0.8053 nohead lw 0.8 lc rgb '#999999'
set label 'robust, study: irregular exact' at graph 1.02,0.8053 left
set arrow from first 7.35372,0.000233241 to graph 1.0,0.5865 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.5865 to graph 1.015,0.5865 nohead lw 0.8 lc rgb '#999999'
set label 'fast: irregular exact' at graph 1.02,0.5865 left
set arrow from first 7.23422,8.07343e-07 to graph 1.0,0.0575 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.0575 to graph 1.015,0.0575 nohead lw 0.8 lc rgb '#999999'
set label 'double: irregular exact' at graph 1.02,0.0575 left
$hits0 << END
1.35903 0.000233241
1.3324 0.000233241
2.08799 0.000233241
2.23889 0.000233241
3.23918 0.000233241
3.57752 0.000233241
1.25407 0.000233241
1.26912 0.000233241
1.29108 0.000233241
1.48125 0.000233241
2.29419 0.000233241
2.5558 0.000233241
1.18705 0.000233241
1.29994 0.000233241
1.4146 0.000233241
1.35279 0.000233241
2.31378 0.000233241
2.35395 0.000233241
6.77244 0.000233241
7.35372 0.000233241
END
$hits1 << END
1.0102 0.00527736
0.975321 0.00514657
2.02682 0.00782776
2.18131 0.00444249
3.09136 0.00572641
3.57634 0.00240871
0.938044 0.00527736
0.934597 0.00514657
1.3904 0.00782776
1.50703 0.00444249
2.21699 0.00572641
2.46225 0.00240871
0.864556 0.00543649
0.953503 0.00517927
1.09998 0.00716291
1.07944 0.00560652
1.80617 0.00575692
1.84849 0.00289699
6.26709 0.0055978
7.26955 0.00266157
END
$hits2 << END
1.30465 1.08991e-06
1.33462 1.08991e-06
2.17506 1.08991e-06
2.33469 1.08991e-06
3.2506 1.08991e-06
3.5932 1.08991e-06
1.15118 1.08991e-06
1.19653 1.08991e-06
1.41142 1.08991e-06
1.5119 1.08991e-06
2.25054 1.08991e-06
2.3891 1.08991e-06
1.0618 1.08991e-06
1.15998 1.08991e-06
1.3961 1.08991e-06
1.40272 1.08991e-06
2.40121 1.08991e-06
2.34197 1.08991e-06
6.71729 1.08991e-06
7.15366 1.08991e-06
0.695871 1.08991e-06
2.18508 1.08991e-06
1.8703 1.08991e-06
2.51623 1.08991e-06
END
$hits3 << END
0.98461 0.00504848
1.01676 0.00491333
2.04562 0.00759888
2.08872 0.00421797
3.39584 0.00550188
3.38695 0.00217983
0.894825 0.00504848
0.966871 0.00491333
1.48106 0.00759888
1.50947 0.00421797
2.4747 0.00550188
2.50787 0.00217983
0.83757 0.00520979
0.942578 0.00494603
1.18647 0.00694275
1.17952 0.00538853
2.1033 0.0055324
2.04295 0.00267029
6.92999 0.00537109
7.58675 0.00243051
END
$hits4 << END
1.55108 8.07343e-07
1.67062 8.07343e-07
2.35032 8.07343e-07
2.36364 8.07343e-07
3.36476 8.07343e-07
3.46612 8.07343e-07
1.3702 8.07343e-07
1.35185 8.07343e-07
1.56161 8.07343e-07
1.54767 8.07343e-07
2.28167 8.07343e-07
2.39153 8.07343e-07
1.34022 8.07343e-07
1.4442 8.07343e-07
1.57488 8.07343e-07
1.57928 8.07343e-07
2.43014 8.07343e-07
2.48055 8.07343e-07
6.33349 8.07343e-07
7.23422 8.07343e-07
END
$hits5 << END
1.20901 0.00504848
1.29675 0.00491333
2.10404 0.00759888
2.28213 0.00422015
3.35405 0.00550188
3.48262 0.00217983
1.25588 0.00504848
1.19494 0.00491333
1.59085 0.00759888
1.64241 0.00421797
2.357 0.00550188
2.55223 0.00217983
1.16768 0.00520979
1.24057 0.00494603
1.3848 0.00694493
1.37816 0.00539071
2.15027 0.0055324
2.15085 0.00267029
7.25711 0.00537109
7.29578 0.00243051
END
$hits_front << END
7.23422 8.07343e-07
7.35372 0.000233241
7.58675 0.00243051
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
set xrange [4.23869:91.4508]; set yrange [4.92158e-05:0.0711461]
set xlabel 'pictures a second  (more is better)'; set ylabel 'picture: RMSE of a channel  (less is better)' offset -1.5
set xtics ('5' 5, '10' 10, '20' 20, '50' 50)
set ytics ("same\nbits" 0.000123039, '10⁻³' 1e-3, '10⁻²' 1e-2)
set object rectangle from graph 0, graph 0 to graph 1, first 0.000209167 fs solid noborder fc rgb '#eeeeee' behind
set arrow from first 76.209,0.0125823 to graph 1.0,0.7619 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.7619 to graph 1.015,0.7619 nohead lw 0.8 lc rgb '#999999'
set label 'fast: irregular exact' at graph 1.02,0.7619 left
set arrow from first 69.6777,9.11403e-05 to graph 1.0,0.0847 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.0847 to graph 1.015,0.0847 nohead lw 0.8 lc rgb '#999999'
set label 'double: irregular exact' at graph 1.02,0.0847 left
$picture0 << END
13.9024 0.0125823
13.7068 0.0125823
21.9971 0.0125823
23.6591 0.0125823
36.8096 0.0125823
44.1271 0.0125823
12.8356 0.0125823
13.465 0.0125823
16.0249 0.0125823
16.798 0.0125823
25.6929 0.0125823
28.2803 0.0125823
12.6283 0.0125823
12.8016 0.0125823
16.8835 0.0125823
15.6071 0.0125823
27.1527 0.0125823
26.2382 0.0125823
66.4354 0.0125823
76.209 0.0125823
END
$picture1 << END
12.1414 0.0227031
11.5447 0.0223245
21.8886 0.0284584
24.6276 0.0216955
35.4482 0.0244157
41.474 0.0182114
10.7777 0.0227031
11.2847 0.0223245
16.4236 0.0284584
16.7325 0.0216955
25.8641 0.0244157
28.6095 0.0182114
10.4893 0.0227037
11.0183 0.0223245
14.4605 0.0253324
13.769 0.0228795
22.5211 0.0237884
22.5854 0.0184323
66.1648 0.0251166
71.1655 0.0192592
END
$picture2 << END
9.93744 0.000984316
9.60749 0.000984316
19.3565 0.000984316
23.0555 0.000984316
32.2036 0.000984316
38.0742 0.000984316
9.18956 0.000984316
9.96191 0.000984316
14.0323 0.000984316
15.8033 0.000984316
22.6802 0.000984316
26.2109 0.000984316
8.61482 0.000984316
9.84839 0.000984316
12.5523 0.000984316
13.7469 0.000984316
22.4508 0.000984316
22.9931 0.000984316
57.4249 0.000984316
67.2428 0.000984316
5.08643 0.000984316
18.248 0.000984316
19.1939 0.000984316
26.2067 0.000984316
END
$picture3 << END
10.1572 0.0192272
10.4919 0.0187296
21.7781 0.0258928
21.7228 0.017856
34.6567 0.0212963
38.6935 0.0134829
9.43703 0.0192272
9.7083 0.0187296
15.3358 0.0258928
16.2633 0.017856
25.3569 0.0212963
26.8421 0.0134829
8.45286 0.0192279
9.69257 0.0187296
12.8613 0.0222709
13.5092 0.019423
23.6483 0.0204607
23.6747 0.0137771
62.1393 0.0220541
68.1175 0.0148812
END
$picture4 << END
12.384 9.11403e-05
13.17 9.11403e-05
21.9517 9.11403e-05
24.6047 9.11403e-05
31.9426 9.11403e-05
37.9588 9.11403e-05
12.2858 9.11403e-05
11.9989 9.11403e-05
16.6737 9.11403e-05
18.4262 9.11403e-05
24.8 9.11403e-05
28.0044 9.11403e-05
11.6158 9.11403e-05
12.1854 9.11403e-05
15.3533 9.11403e-05
15.3536 9.11403e-05
23.7424 9.11403e-05
25.2853 9.11403e-05
64.6059 9.11403e-05
69.6777 9.11403e-05
END
$picture5 << END
12.4867 0.0192032
12.3627 0.0187047
22.8284 0.0258798
26.9913 0.0178357
35.7198 0.0212768
38.8032 0.0134492
11.7966 0.0192032
11.7512 0.0187047
17.2355 0.0258798
18.3882 0.0178368
25.6484 0.0212768
27.1671 0.0134492
11.8501 0.0192039
12.6899 0.0187047
15.8343 0.0222502
15.5637 0.0194335
24.7776 0.0204423
25.4905 0.0137465
66.3439 0.0220359
67.9972 0.0148491
END
$picture_front << END
69.6777 9.11403e-05
76.209 0.0125823
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
set xrange [0.579893:9.1041]; set yrange [4.35965e-07:0.0195694]
set xlabel 'million nearest hits a second  (more is better)'; set ylabel 'wrong hits  (less is better)' offset -1.5
set label 'mean of 7 scenes: speed against accuracy (CPU, 2 threads)' at screen 0.02, screen 0.9774 font ',20'
set label '256x256 primary and 65,536 random rays a scene; 458,752 in all compared with brute force in double; pictures of 128x128' at screen 0.02, screen 0.9516
set xtics ('0.7' 0.7, '1' 1, '1.5' 1.5, '2' 2, '3' 3, '5' 5, '7' 7)
set ytics ("none of\n458,752" 1.08991e-06, '0.001 %%' 1e-5, '0.01 %%' 1e-4, '0.1 %%' 1e-3, '1 %%' 1e-2)
set object rectangle from graph 0, graph 0 to graph 1, first 1.85285e-06 fs solid noborder fc rgb '#eeeeee' behind
set arrow from first 7.58675,0.00243051 to graph 1.0,0.8053 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.8053 to graph 1.015,0.8053 nohead lw 0.8 lc rgb '#999999'
set label 'robust, study: irregular exact' at graph 1.02,0.8053 left
set arrow from first 7.35372,0.000233241 to graph 1.0,0.5865 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.5865 to graph 1.015,0.5865 nohead lw 0.8 lc rgb '#999999'
set label 'fast: irregular exact' at graph 1.02,0.5865 left
set arrow from first 7.23422,8.07343e-07 to graph 1.0,0.0575 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.0575 to graph 1.015,0.0575 nohead lw 0.8 lc rgb '#999999'
set label 'double: irregular exact' at graph 1.02,0.0575 left
$hits0 << END
1.35903 0.000233241
1.3324 0.000233241
2.08799 0.000233241
2.23889 0.000233241
3.23918 0.000233241
3.57752 0.000233241
1.25407 0.000233241
1.26912 0.000233241
1.29108 0.000233241
1.48125 0.000233241
2.29419 0.000233241
2.5558 0.000233241
1.18705 0.000233241
1.29994 0.000233241
1.4146 0.000233241
1.35279 0.000233241
2.31378 0.000233241
2.35395 0.000233241
6.77244 0.000233241
7.35372 0.000233241
END
$hits1 << END
1.0102 0.00527736
0.975321 0.00514657
2.02682 0.00782776
2.18131 0.00444249
3.09136 0.00572641
3.57634 0.00240871
0.938044 0.00527736
0.934597 0.00514657
1.3904 0.00782776
1.50703 0.00444249
2.21699 0.00572641
2.46225 0.00240871
0.864556 0.00543649
0.953503 0.00517927
1.09998 0.00716291
1.07944 0.00560652
1.80617 0.00575692
1.84849 0.00289699
6.26709 0.0055978
7.26955 0.00266157
END
$hits2 << END
1.30465 1.08991e-06
1.33462 1.08991e-06
2.17506 1.08991e-06
2.33469 1.08991e-06
3.2506 1.08991e-06
3.5932 1.08991e-06
1.15118 1.08991e-06
1.19653 1.08991e-06
1.41142 1.08991e-06
1.5119 1.08991e-06
2.25054 1.08991e-06
2.3891 1.08991e-06
1.0618 1.08991e-06
1.15998 1.08991e-06
1.3961 1.08991e-06
1.40272 1.08991e-06
2.40121 1.08991e-06
2.34197 1.08991e-06
6.71729 1.08991e-06
7.15366 1.08991e-06
0.695871 1.08991e-06
2.18508 1.08991e-06
1.8703 1.08991e-06
2.51623 1.08991e-06
END
$hits3 << END
0.98461 0.00504848
1.01676 0.00491333
2.04562 0.00759888
2.08872 0.00421797
3.39584 0.00550188
3.38695 0.00217983
0.894825 0.00504848
0.966871 0.00491333
1.48106 0.00759888
1.50947 0.00421797
2.4747 0.00550188
2.50787 0.00217983
0.83757 0.00520979
0.942578 0.00494603
1.18647 0.00694275
1.17952 0.00538853
2.1033 0.0055324
2.04295 0.00267029
6.92999 0.00537109
7.58675 0.00243051
END
$hits4 << END
1.55108 8.07343e-07
1.67062 8.07343e-07
2.35032 8.07343e-07
2.36364 8.07343e-07
3.36476 8.07343e-07
3.46612 8.07343e-07
1.3702 8.07343e-07
1.35185 8.07343e-07
1.56161 8.07343e-07
1.54767 8.07343e-07
2.28167 8.07343e-07
2.39153 8.07343e-07
1.34022 8.07343e-07
1.4442 8.07343e-07
1.57488 8.07343e-07
1.57928 8.07343e-07
2.43014 8.07343e-07
2.48055 8.07343e-07
6.33349 8.07343e-07
7.23422 8.07343e-07
END
$hits5 << END
1.20901 0.00504848
1.29675 0.00491333
2.10404 0.00759888
2.28213 0.00422015
3.35405 0.00550188
3.48262 0.00217983
1.25588 0.00504848
1.19494 0.00491333
1.59085 0.00759888
1.64241 0.00421797
2.357 0.00550188
2.55223 0.00217983
1.16768 0.00520979
1.24057 0.00494603
1.3848 0.00694493
1.37816 0.00539071
2.15027 0.0055324
2.15085 0.00267029
7.25711 0.00537109
7.29578 0.00243051
END
$hits_front << END
7.23422 8.07343e-07
7.35372 0.000233241
7.58675 0.00243051
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
set xrange [4.23869:91.4508]; set yrange [4.92158e-05:0.0711461]
set xlabel 'pictures a second  (more is better)'; set ylabel 'picture: RMSE of a channel  (less is better)' offset -1.5
set xtics ('5' 5, '10' 10, '20' 20, '50' 50)
set ytics ("same\nbits" 0.000123039, '10⁻³' 1e-3, '10⁻²' 1e-2)
set object rectangle from graph 0, graph 0 to graph 1, first 0.000209167 fs solid noborder fc rgb '#eeeeee' behind
set arrow from first 76.209,0.0125823 to graph 1.0,0.7619 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.7619 to graph 1.015,0.7619 nohead lw 0.8 lc rgb '#999999'
set label 'fast: irregular exact' at graph 1.02,0.7619 left
set arrow from first 69.6777,9.11403e-05 to graph 1.0,0.0847 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.0847 to graph 1.015,0.0847 nohead lw 0.8 lc rgb '#999999'
set label 'double: irregular exact' at graph 1.02,0.0847 left
$picture0 << END
13.9024 0.0125823
13.7068 0.0125823
21.9971 0.0125823
23.6591 0.0125823
36.8096 0.0125823
44.1271 0.0125823
12.8356 0.0125823
13.465 0.0125823
16.0249 0.0125823
16.798 0.0125823
25.6929 0.0125823
28.2803 0.0125823
12.6283 0.0125823
12.8016 0.0125823
16.8835 0.0125823
15.6071 0.0125823
27.1527 0.0125823
26.2382 0.0125823
66.4354 0.0125823
76.209 0.0125823
END
$picture1 << END
12.1414 0.0227031
11.5447 0.0223245
21.8886 0.0284584
24.6276 0.0216955
35.4482 0.0244157
41.474 0.0182114
10.7777 0.0227031
11.2847 0.0223245
16.4236 0.0284584
16.7325 0.0216955
25.8641 0.0244157
28.6095 0.0182114
10.4893 0.0227037
11.0183 0.0223245
14.4605 0.0253324
13.769 0.0228795
22.5211 0.0237884
22.5854 0.0184323
66.1648 0.0251166
71.1655 0.0192592
END
$picture2 << END
9.93744 0.000984316
9.60749 0.000984316
19.3565 0.000984316
23.0555 0.000984316
32.2036 0.000984316
38.0742 0.000984316
9.18956 0.000984316
9.96191 0.000984316
14.0323 0.000984316
15.8033 0.000984316
22.6802 0.000984316
26.2109 0.000984316
8.61482 0.000984316
9.84839 0.000984316
12.5523 0.000984316
13.7469 0.000984316
22.4508 0.000984316
22.9931 0.000984316
57.4249 0.000984316
67.2428 0.000984316
5.08643 0.000984316
18.248 0.000984316
19.1939 0.000984316
26.2067 0.000984316
END
$picture3 << END
10.1572 0.0192272
10.4919 0.0187296
21.7781 0.0258928
21.7228 0.017856
34.6567 0.0212963
38.6935 0.0134829
9.43703 0.0192272
9.7083 0.0187296
15.3358 0.0258928
16.2633 0.017856
25.3569 0.0212963
26.8421 0.0134829
8.45286 0.0192279
9.69257 0.0187296
12.8613 0.0222709
13.5092 0.019423
23.6483 0.0204607
23.6747 0.0137771
62.1393 0.0220541
68.1175 0.0148812
END
$picture4 << END
12.384 9.11403e-05
13.17 9.11403e-05
21.9517 9.11403e-05
24.6047 9.11403e-05
31.9426 9.11403e-05
37.9588 9.11403e-05
12.2858 9.11403e-05
11.9989 9.11403e-05
16.6737 9.11403e-05
18.4262 9.11403e-05
24.8 9.11403e-05
28.0044 9.11403e-05
11.6158 9.11403e-05
12.1854 9.11403e-05
15.3533 9.11403e-05
15.3536 9.11403e-05
23.7424 9.11403e-05
25.2853 9.11403e-05
64.6059 9.11403e-05
69.6777 9.11403e-05
END
$picture5 << END
12.4867 0.0192032
12.3627 0.0187047
22.8284 0.0258798
26.9913 0.0178357
35.7198 0.0212768
38.8032 0.0134492
11.7966 0.0192032
11.7512 0.0187047
17.2355 0.0258798
18.3882 0.0178368
25.6484 0.0212768
27.1671 0.0134492
11.8501 0.0192039
12.6899 0.0187047
15.8343 0.0222502
15.5637 0.0194335
24.7776 0.0204423
25.4905 0.0137465
66.3439 0.0220359
67.9972 0.0148491
END
$picture_front << END
69.6777 9.11403e-05
76.209 0.0125823
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
1 3764.43
2 1104.05
4 953.295
8 768.598
16 534.089
32 177.231
64 80.4367
128 63.866
256 49.2524
END
$chosen0 << END
138.128 31.0038
END
$line1 << END
1 31114.6
2 8773.2
4 3396.86
8 787.303
16 230.846
32 110.511
64 63.7627
128 75.5354
256 63.2582
END
$chosen1 << END
93.6537 47.2403
END
$line2 << END
1 9001.19
2 908.81
4 236.041
8 81.0745
16 45.6302
32 36.435
64 30.3845
128 70.4009
256 52.5382
END
$chosen2 << END
43.323 26.9323
END
$line3 << END
1 5333.48
2 991.299
4 443.272
8 153.478
16 115.367
32 41.3516
64 72.6485
128 64.3183
256 52.4891
END
$chosen3 << END
50.6645 77.8888
END
$line4 << END
1 4361.74
2 1177.69
4 285.324
8 84.0439
16 33.1446
32 20.337
64 23.3097
128 44.5669
256 26.5242
END
$chosen4 << END
50.4685 19.9933
END
$line5 << END
1 429.217
2 126.897
4 41.4995
8 15.0083
16 7.52525
32 5.5764
64 4.85112
128 8.94019
256 6.35008
END
$chosen5 << END
30 3.80534
END
$line6 << END
1 5157.26
2 1601.79
4 1356.41
8 1195.37
16 817.57
32 443.505
64 225.578
128 119.719
256 81.396
END
$chosen6 << END
278.218 36.8837
END

reset
set terminal svg size 1100,760 font 'DejaVu Sans,15' noenhanced background rgb 'white'
set output 'division.svg'
set encoding utf8
set logscale xy
set border 3 lc rgb '#444444'
set tics nomirror
set grid lc rgb '#d4d4d4' lw 1 dt 1
set label 'Time against division (CPU, 2 threads)' at screen 0.02, screen 0.9632 font ',20'
set label 'uniform grids, exact overlap, robust; pictures of 128x128 with shadows and mirrors; ringed: --division auto' at screen 0.02, screen 0.9211
set lmargin at screen 0.09; set rmargin at screen 0.88; set bmargin at screen 0.10; set tmargin at screen 0.89
unset key
set xrange [0.909091:306.04]; set yrange [2.92718:40449]
set xlabel 'voxels an axis'; set ylabel 'ms a picture'
set xtics (1, 2, 4, 8, 16, 32, 64, 128, 256, 512, 1024)
set ytics ('10' 10, '100' 100, '1000' 1000, '10000' 10000)
set arrow from first 16, graph 0 to first 16, graph 1 nohead lw 1.5 dt '-' lc rgb '#444444'
set label '16: what the founding study found enough' at first 16, graph 0.97 offset 1,0 left
set arrow from first 256,49.2524 to graph 1.0,0.2961 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.2961 to graph 1.015,0.2961 nohead lw 0.8 lc rgb '#999999'
set label 'balls' at graph 1.02,0.2961 left
set arrow from first 256,63.2582 to graph 1.0,0.4311 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.4311 to graph 1.015,0.4311 nohead lw 0.8 lc rgb '#999999'
set label 'gears' at graph 1.02,0.4311 left
set arrow from first 256,52.5382 to graph 1.0,0.3861 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.3861 to graph 1.015,0.3861 nohead lw 0.8 lc rgb '#999999'
set label 'mount' at graph 1.02,0.3861 left
set arrow from first 256,52.4891 to graph 1.0,0.3411 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.3411 to graph 1.015,0.3411 nohead lw 0.8 lc rgb '#999999'
set label 'rings' at graph 1.02,0.3411 left
set arrow from first 256,26.5242 to graph 1.0,0.2312 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.2312 to graph 1.015,0.2312 nohead lw 0.8 lc rgb '#999999'
set label 'teapot' at graph 1.02,0.2312 left
set arrow from first 256,6.35008 to graph 1.0,0.0812 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.0812 to graph 1.015,0.0812 nohead lw 0.8 lc rgb '#999999'
set label 'tetra' at graph 1.02,0.0812 left
set arrow from first 256,81.396 to graph 1.0,0.4761 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.4761 to graph 1.015,0.4761 nohead lw 0.8 lc rgb '#999999'
set label 'tree' at graph 1.02,0.4761 left
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
set label 'Time against division (CPU, 2 threads)' at screen 0.02, screen 0.9632 font ',20'
set label 'uniform grids, exact overlap, robust; pictures of 128x128 with shadows and mirrors; ringed: --division auto' at screen 0.02, screen 0.9211
set lmargin at screen 0.09; set rmargin at screen 0.88; set bmargin at screen 0.10; set tmargin at screen 0.89
unset key
set xrange [0.909091:306.04]; set yrange [2.92718:40449]
set xlabel 'voxels an axis'; set ylabel 'ms a picture'
set xtics (1, 2, 4, 8, 16, 32, 64, 128, 256, 512, 1024)
set ytics ('10' 10, '100' 100, '1000' 1000, '10000' 10000)
set arrow from first 16, graph 0 to first 16, graph 1 nohead lw 1.5 dt '-' lc rgb '#444444'
set label '16: what the founding study found enough' at first 16, graph 0.97 offset 1,0 left
set arrow from first 256,49.2524 to graph 1.0,0.2961 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.2961 to graph 1.015,0.2961 nohead lw 0.8 lc rgb '#999999'
set label 'balls' at graph 1.02,0.2961 left
set arrow from first 256,63.2582 to graph 1.0,0.4311 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.4311 to graph 1.015,0.4311 nohead lw 0.8 lc rgb '#999999'
set label 'gears' at graph 1.02,0.4311 left
set arrow from first 256,52.5382 to graph 1.0,0.3861 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.3861 to graph 1.015,0.3861 nohead lw 0.8 lc rgb '#999999'
set label 'mount' at graph 1.02,0.3861 left
set arrow from first 256,52.4891 to graph 1.0,0.3411 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.3411 to graph 1.015,0.3411 nohead lw 0.8 lc rgb '#999999'
set label 'rings' at graph 1.02,0.3411 left
set arrow from first 256,26.5242 to graph 1.0,0.2312 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.2312 to graph 1.015,0.2312 nohead lw 0.8 lc rgb '#999999'
set label 'teapot' at graph 1.02,0.2312 left
set arrow from first 256,6.35008 to graph 1.0,0.0812 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.0812 to graph 1.015,0.0812 nohead lw 0.8 lc rgb '#999999'
set label 'tetra' at graph 1.02,0.0812 left
set arrow from first 256,81.396 to graph 1.0,0.4761 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.4761 to graph 1.015,0.4761 nohead lw 0.8 lc rgb '#999999'
set label 'tree' at graph 1.02,0.4761 left
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
