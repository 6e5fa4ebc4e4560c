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
set xrange [0.627573:18.0407]; set yrange [3.05176e-06:0.0717163]
set xlabel 'million nearest hits a second  (more is better)'; set ylabel 'wrong hits  (less is better)' offset -1.5
set label 'balls: speed against accuracy (CPU, 2 threads)' at screen 0.02, screen 0.9774 font ',20'
set label '256x256 primary and 65,536 random rays a scene; 65,536 in all compared with brute force in double; pictures of 128x128' at screen 0.02, screen 0.9516
set xtics ('1' 1, '2' 2, '5' 5, '10' 10)
set ytics ("none of\n65,536" 7.62939e-06, '0.01 %%' 1e-4, '0.1 %%' 1e-3, '1 %%' 1e-2)
set object rectangle from graph 0, graph 0 to graph 1, first 1.297e-05 fs solid noborder fc rgb '#eeeeee' behind
set arrow from first 15.0339,0.00192261 to graph 1.0,0.6847 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.6847 to graph 1.015,0.6847 nohead lw 0.8 lc rgb '#999999'
set label 'fast, study: irregular exact' at graph 1.02,0.6847 left
set arrow from first 14.5334,0.0018158 to graph 1.0,0.6347 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.6347 to graph 1.015,0.6347 nohead lw 0.8 lc rgb '#999999'
set label 'double, study: irregular exact' at graph 1.02,0.6347 left
set arrow from first 13.686,0.000106812 to graph 1.0,0.3532 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.3532 to graph 1.015,0.3532 nohead lw 0.8 lc rgb '#999999'
set label 'fast: irregular exact' at graph 1.02,0.3532 left
set arrow from first 13.2888,5.6514e-06 to graph 1.0,0.0612 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.0612 to graph 1.015,0.0612 nohead lw 0.8 lc rgb '#999999'
set label 'double: irregular exact' at graph 1.02,0.0612 left
$hits0 << END
1.12482 0.000106812
1.12608 0.000106812
4.15731 0.000106812
4.27793 0.000106812
5.11875 0.000106812
5.1143 0.000106812
1.08062 0.000106812
1.06738 0.000106812
2.23356 0.000106812
2.26515 0.000106812
3.65952 0.000106812
3.32347 0.000106812
1.09038 0.000106812
1.12008 0.000106812
2.65592 0.000106812
2.68443 0.000106812
5.46965 0.000106812
5.66945 0.000106812
12.7615 0.000106812
13.686 0.000106812
END
$hits1 << END
1.06132 0.0268707
1.14681 0.0266876
4.2875 0.0286865
4.2142 0.0184937
5.29494 0.0145111
5.31459 0.00234985
1.05661 0.0268707
1.04261 0.0266876
2.31256 0.0286865
2.29863 0.0184937
3.80956 0.0145111
3.71167 0.00234985
1.07379 0.0268707
1.08437 0.0266876
2.75807 0.0286865
2.68951 0.0185394
5.74308 0.0203094
5.54674 0.00489807
14.5612 0.011673
15.0339 0.00192261
END
$hits2 << END
2.80301 7.62939e-06
3.28719 7.62939e-06
4.73773 7.62939e-06
4.70083 7.62939e-06
1.90359 7.62939e-06
1.94446 7.62939e-06
3.32069 7.62939e-06
3.37494 7.62939e-06
2.22863 7.62939e-06
2.23751 7.62939e-06
5.03546 7.62939e-06
4.98014 7.62939e-06
11.9864 7.62939e-06
12.8554 7.62939e-06
2.20761 7.62939e-06
2.73447 7.62939e-06
2.92386 7.62939e-06
END
$hits3 << END
3.64012 0.028595
3.54545 0.0184021
5.0103 0.0144196
4.16267 0.00224304
2.0941 0.028595
2.03239 0.0184021
3.52089 0.0144196
3.53022 0.00224304
0.753088 0.0265961
2.44787 0.028595
2.35663 0.0184479
5.44649 0.0202179
5.29215 0.00479126
13.7316 0.0115662
13.9723 0.0018158
END
$hits4 << END
3.06597 5.6514e-06
3.19686 5.6514e-06
4.55085 5.6514e-06
4.69226 5.6514e-06
1.84577 5.6514e-06
1.96942 5.6514e-06
3.41016 5.6514e-06
3.43136 5.6514e-06
2.16806 5.6514e-06
2.15962 5.6514e-06
4.93974 5.6514e-06
5.12452 5.6514e-06
12.4195 5.6514e-06
13.2888 5.6514e-06
END
$hits5 << END
3.55059 0.028595
2.90076 0.0184021
4.99328 0.0144196
5.09335 0.00224304
1.79892 0.028595
2.06264 0.0184021
3.69849 0.0144196
3.51515 0.00224304
2.41517 0.028595
2.29727 0.0184479
5.38522 0.0202179
5.15658 0.00479126
14.2699 0.0115662
14.5334 0.0018158
END
$hits_front << END
13.2888 5.6514e-06
13.686 0.000106812
14.5334 0.0018158
15.0339 0.00192261
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
set xrange [5.97985:115.186]; set yrange [0.000114843:0.116291]
set xlabel 'pictures a second  (more is better)'; set ylabel 'picture: RMSE of a channel  (less is better)' offset -1.5
set xtics ('7' 7, '10' 10, '15' 15, '20' 20, '30' 30, '50' 50, '70' 70, '100' 100)
set ytics ("same\nbits" 0.000287109, '10⁻³' 1e-3, '10⁻²' 1e-2, '10⁻¹' 1e-1)
set object rectangle from graph 0, graph 0 to graph 1, first 0.000488085 fs solid noborder fc rgb '#eeeeee' behind
set arrow from first 95.9886,0.0144693 to graph 1.0,0.6988 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.6988 to graph 1.015,0.6988 nohead lw 0.8 lc rgb '#999999'
set label 'fast, study: irregular exact' at graph 1.02,0.6988 left
set arrow from first 92.1082,0.00918705 to graph 1.0,0.6332 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.6332 to graph 1.015,0.6332 nohead lw 0.8 lc rgb '#999999'
set label 'fast: irregular exact' at graph 1.02,0.6332 left
set arrow from first 87.4883,0.000212673 to graph 1.0,0.0890 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.0890 to graph 1.015,0.0890 nohead lw 0.8 lc rgb '#999999'
set label 'double: irregular exact' at graph 1.02,0.0890 left
$picture0 << END
13.6385 0.00918705
14.2609 0.00918705
33.506 0.00918705
33.3263 0.00918705
41.4864 0.00918705
39.7433 0.00918705
12.9068 0.00918705
12.878 0.00918705
19.8041 0.00918705
20.2082 0.00918705
30.5494 0.00918705
30.3213 0.00918705
13.2055 0.00918705
13.4483 0.00918705
23.0903 0.00918705
23.3325 0.00918705
41.9822 0.00918705
41.5806 0.00918705
88.5277 0.00918705
92.1082 0.00918705
END
$picture1 << END
11.7341 0.0454111
10.484 0.0452486
30.501 0.0465164
31.1415 0.0368519
40.1347 0.0318397
39.8432 0.015151
10.735 0.0454111
10.8439 0.0452486
19.1922 0.0465164
19.2598 0.0368519
30.6799 0.0318397
30.0439 0.015151
9.49749 0.0454111
11.2246 0.0452486
22.5574 0.0465164
22.6532 0.0368933
41.4604 0.0379429
40.488 0.0203198
93.813 0.0289228
95.9886 0.0144693
END
$picture2 << END
23.7916 0.00229687
19.8965 0.00229687
36.685 0.00229687
33.2932 0.00229687
16.3148 0.00229687
16.8493 0.00229687
27.3005 0.00229687
28.299 0.00229687
18.8041 0.00229687
18.885 0.00229687
36.6754 0.00229687
36.6822 0.00229687
80.812 0.00229687
84.702 0.00229687
16.2483 0.00229687
20.3611 0.00229687
23.3876 0.00229687
END
$picture3 << END
24.7232 0.0460029
25.2143 0.0361277
37.0697 0.0307557
36.853 0.0126211
15.4855 0.0460029
16.4068 0.0361277
28.1254 0.0307557
29.3369 0.0126211
7.17581 0.0446926
19.4049 0.0460029
18.5095 0.0361705
37.9537 0.0370789
37.3917 0.0184932
88.0127 0.0276666
89.5367 0.0114011
END
$picture4 << END
24.0854 0.000212673
23.808 0.000212673
36.9182 0.000212673
38.5499 0.000212673
15.5829 0.000212673
15.9809 0.000212673
27.4085 0.000212673
28.3862 0.000212673
17.6937 0.000212673
17.2683 0.000212673
36.4159 0.000212673
36.9766 0.000212673
83.042 0.000212673
87.4883 0.000212673
END
$picture5 << END
24.6319 0.0459663
24.7512 0.036073
37.7162 0.0306826
36.5143 0.0124275
16.7997 0.0459663
17.0755 0.036073
28.9028 0.0306826
29.1125 0.0124275
18.9574 0.0459663
16.2829 0.0361159
37.6558 0.0370265
37.171 0.0183749
89.8045 0.0275858
90.7836 0.0111627
END
$picture_front << END
87.4883 0.000212673
92.1082 0.00918705
95.9886 0.0144693
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
set xrange [0.627573:18.0407]; set yrange [3.05176e-06:0.0717163]
set xlabel 'million nearest hits a second  (more is better)'; set ylabel 'wrong hits  (less is better)' offset -1.5
set label 'balls: speed against accuracy (CPU, 2 threads)' at screen 0.02, screen 0.9774 font ',20'
set label '256x256 primary and 65,536 random rays a scene; 65,536 in all compared with brute force in double; pictures of 128x128' at screen 0.02, screen 0.9516
set xtics ('1' 1, '2' 2, '5' 5, '10' 10)
set ytics ("none of\n65,536" 7.62939e-06, '0.01 %%' 1e-4, '0.1 %%' 1e-3, '1 %%' 1e-2)
set object rectangle from graph 0, graph 0 to graph 1, first 1.297e-05 fs solid noborder fc rgb '#eeeeee' behind
set arrow from first 15.0339,0.00192261 to graph 1.0,0.6847 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.6847 to graph 1.015,0.6847 nohead lw 0.8 lc rgb '#999999'
set label 'fast, study: irregular exact' at graph 1.02,0.6847 left
set arrow from first 14.5334,0.0018158 to graph 1.0,0.6347 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.6347 to graph 1.015,0.6347 nohead lw 0.8 lc rgb '#999999'
set label 'double, study: irregular exact' at graph 1.02,0.6347 left
set arrow from first 13.686,0.000106812 to graph 1.0,0.3532 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.3532 to graph 1.015,0.3532 nohead lw 0.8 lc rgb '#999999'
set label 'fast: irregular exact' at graph 1.02,0.3532 left
set arrow from first 13.2888,5.6514e-06 to graph 1.0,0.0612 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.0612 to graph 1.015,0.0612 nohead lw 0.8 lc rgb '#999999'
set label 'double: irregular exact' at graph 1.02,0.0612 left
$hits0 << END
1.12482 0.000106812
1.12608 0.000106812
4.15731 0.000106812
4.27793 0.000106812
5.11875 0.000106812
5.1143 0.000106812
1.08062 0.000106812
1.06738 0.000106812
2.23356 0.000106812
2.26515 0.000106812
3.65952 0.000106812
3.32347 0.000106812
1.09038 0.000106812
1.12008 0.000106812
2.65592 0.000106812
2.68443 0.000106812
5.46965 0.000106812
5.66945 0.000106812
12.7615 0.000106812
13.686 0.000106812
END
$hits1 << END
1.06132 0.0268707
1.14681 0.0266876
4.2875 0.0286865
4.2142 0.0184937
5.29494 0.0145111
5.31459 0.00234985
1.05661 0.0268707
1.04261 0.0266876
2.31256 0.0286865
2.29863 0.0184937
3.80956 0.0145111
3.71167 0.00234985
1.07379 0.0268707
1.08437 0.0266876
2.75807 0.0286865
2.68951 0.0185394
5.74308 0.0203094
5.54674 0.00489807
14.5612 0.011673
15.0339 0.00192261
END
$hits2 << END
2.80301 7.62939e-06
3.28719 7.62939e-06
4.73773 7.62939e-06
4.70083 7.62939e-06
1.90359 7.62939e-06
1.94446 7.62939e-06
3.32069 7.62939e-06
3.37494 7.62939e-06
2.22863 7.62939e-06
2.23751 7.62939e-06
5.03546 7.62939e-06
4.98014 7.62939e-06
11.9864 7.62939e-06
12.8554 7.62939e-06
2.20761 7.62939e-06
2.73447 7.62939e-06
2.92386 7.62939e-06
END
$hits3 << END
3.64012 0.028595
3.54545 0.0184021
5.0103 0.0144196
4.16267 0.00224304
2.0941 0.028595
2.03239 0.0184021
3.52089 0.0144196
3.53022 0.00224304
0.753088 0.0265961
2.44787 0.028595
2.35663 0.0184479
5.44649 0.0202179
5.29215 0.00479126
13.7316 0.0115662
13.9723 0.0018158
END
$hits4 << END
3.06597 5.6514e-06
3.19686 5.6514e-06
4.55085 5.6514e-06
4.69226 5.6514e-06
1.84577 5.6514e-06
1.96942 5.6514e-06
3.41016 5.6514e-06
3.43136 5.6514e-06
2.16806 5.6514e-06
2.15962 5.6514e-06
4.93974 5.6514e-06
5.12452 5.6514e-06
12.4195 5.6514e-06
13.2888 5.6514e-06
END
$hits5 << END
3.55059 0.028595
2.90076 0.0184021
4.99328 0.0144196
5.09335 0.00224304
1.79892 0.028595
2.06264 0.0184021
3.69849 0.0144196
3.51515 0.00224304
2.41517 0.028595
2.29727 0.0184479
5.38522 0.0202179
5.15658 0.00479126
14.2699 0.0115662
14.5334 0.0018158
END
$hits_front << END
13.2888 5.6514e-06
13.686 0.000106812
14.5334 0.0018158
15.0339 0.00192261
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
set xrange [5.97985:115.186]; set yrange [0.000114843:0.116291]
set xlabel 'pictures a second  (more is better)'; set ylabel 'picture: RMSE of a channel  (less is better)' offset -1.5
set xtics ('7' 7, '10' 10, '15' 15, '20' 20, '30' 30, '50' 50, '70' 70, '100' 100)
set ytics ("same\nbits" 0.000287109, '10⁻³' 1e-3, '10⁻²' 1e-2, '10⁻¹' 1e-1)
set object rectangle from graph 0, graph 0 to graph 1, first 0.000488085 fs solid noborder fc rgb '#eeeeee' behind
set arrow from first 95.9886,0.0144693 to graph 1.0,0.6988 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.6988 to graph 1.015,0.6988 nohead lw 0.8 lc rgb '#999999'
set label 'fast, study: irregular exact' at graph 1.02,0.6988 left
set arrow from first 92.1082,0.00918705 to graph 1.0,0.6332 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.6332 to graph 1.015,0.6332 nohead lw 0.8 lc rgb '#999999'
set label 'fast: irregular exact' at graph 1.02,0.6332 left
set arrow from first 87.4883,0.000212673 to graph 1.0,0.0890 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.0890 to graph 1.015,0.0890 nohead lw 0.8 lc rgb '#999999'
set label 'double: irregular exact' at graph 1.02,0.0890 left
$picture0 << END
13.6385 0.00918705
14.2609 0.00918705
33.506 0.00918705
33.3263 0.00918705
41.4864 0.00918705
39.7433 0.00918705
12.9068 0.00918705
12.878 0.00918705
19.8041 0.00918705
20.2082 0.00918705
30.5494 0.00918705
30.3213 0.00918705
13.2055 0.00918705
13.4483 0.00918705
23.0903 0.00918705
23.3325 0.00918705
41.9822 0.00918705
41.5806 0.00918705
88.5277 0.00918705
92.1082 0.00918705
END
$picture1 << END
11.7341 0.0454111
10.484 0.0452486
30.501 0.0465164
31.1415 0.0368519
40.1347 0.0318397
39.8432 0.015151
10.735 0.0454111
10.8439 0.0452486
19.1922 0.0465164
19.2598 0.0368519
30.6799 0.0318397
30.0439 0.015151
9.49749 0.0454111
11.2246 0.0452486
22.5574 0.0465164
22.6532 0.0368933
41.4604 0.0379429
40.488 0.0203198
93.813 0.0289228
95.9886 0.0144693
END
$picture2 << END
23.7916 0.00229687
19.8965 0.00229687
36.685 0.00229687
33.2932 0.00229687
16.3148 0.00229687
16.8493 0.00229687
27.3005 0.00229687
28.299 0.00229687
18.8041 0.00229687
18.885 0.00229687
36.6754 0.00229687
36.6822 0.00229687
80.812 0.00229687
84.702 0.00229687
16.2483 0.00229687
20.3611 0.00229687
23.3876 0.00229687
END
$picture3 << END
24.7232 0.0460029
25.2143 0.0361277
37.0697 0.0307557
36.853 0.0126211
15.4855 0.0460029
16.4068 0.0361277
28.1254 0.0307557
29.3369 0.0126211
7.17581 0.0446926
19.4049 0.0460029
18.5095 0.0361705
37.9537 0.0370789
37.3917 0.0184932
88.0127 0.0276666
89.5367 0.0114011
END
$picture4 << END
24.0854 0.000212673
23.808 0.000212673
36.9182 0.000212673
38.5499 0.000212673
15.5829 0.000212673
15.9809 0.000212673
27.4085 0.000212673
28.3862 0.000212673
17.6937 0.000212673
17.2683 0.000212673
36.4159 0.000212673
36.9766 0.000212673
83.042 0.000212673
87.4883 0.000212673
END
$picture5 << END
24.6319 0.0459663
24.7512 0.036073
37.7162 0.0306826
36.5143 0.0124275
16.7997 0.0459663
17.0755 0.036073
28.9028 0.0306826
29.1125 0.0124275
18.9574 0.0459663
16.2829 0.0361159
37.6558 0.0370265
37.171 0.0183749
89.8045 0.0275858
90.7836 0.0111627
END
$picture_front << END
87.4883 0.000212673
92.1082 0.00918705
95.9886 0.0144693
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
set xrange [0.677594:15.5809]; set yrange [3.05176e-06:0.00156403]
set xlabel 'million nearest hits a second  (more is better)'; set ylabel 'wrong hits  (less is better)' offset -1.5
set label 'gears: speed against accuracy (CPU, 2 threads)' at screen 0.02, screen 0.9774 font ',20'
set label '256x256 primary and 65,536 random rays a scene; 65,536 in all compared with brute force in double; pictures of 128x128' at screen 0.02, screen 0.9516
set xtics ('1' 1, '2' 2, '5' 5, '10' 10)
set ytics ("none of\n65,536" 7.62939e-06, '0.01 %%' 1e-4, '0.1 %%' 1e-3)
set object rectangle from graph 0, graph 0 to graph 1, first 1.297e-05 fs solid noborder fc rgb '#eeeeee' behind
set arrow from first 12.9841,6.10352e-05 to graph 1.0,0.4801 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.4801 to graph 1.015,0.4801 nohead lw 0.8 lc rgb '#999999'
set label 'robust, study: irregular exact' at graph 1.02,0.4801 left
set arrow from first 11.5317,5.6514e-06 to graph 1.0,0.0988 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.0988 to graph 1.015,0.0988 nohead lw 0.8 lc rgb '#999999'
set label 'double: irregular exact' at graph 1.02,0.0988 left
$hits0 << END
3.06906 1.02997e-05
3.15058 1.02997e-05
4.70631 1.02997e-05
4.85829 1.02997e-05
5.21288 1.02997e-05
5.75167 1.02997e-05
2.98181 1.02997e-05
3.05373 1.02997e-05
2.87631 1.02997e-05
2.96437 1.02997e-05
3.53146 1.02997e-05
3.71083 1.02997e-05
3.0911 1.02997e-05
3.07471 1.02997e-05
5.28141 1.02997e-05
4.74731 1.02997e-05
4.39551 1.02997e-05
3.37139 1.02997e-05
9.16115 1.02997e-05
10.0555 1.02997e-05
END
$hits1 << END
2.35751 0.000152588
2.39658 0.000152588
4.60462 7.62939e-05
4.87736 3.05176e-05
4.78525 0.00050354
5.36448 0.000152588
2.13982 0.000152588
2.22704 0.000152588
2.84995 7.62939e-05
2.97442 3.05176e-05
3.55001 0.00050354
3.42131 0.000152588
2.27644 0.000152588
2.26646 0.000152588
5.15759 0.000289917
4.53176 3.05176e-05
4.32853 0.00062561
3.09185 0.000366211
9.39695 0.000259399
11.5361 6.10352e-05
END
$hits2 << END
3.71786 7.62939e-06
3.92374 7.62939e-06
5.25574 7.62939e-06
5.48493 7.62939e-06
5.15636 7.62939e-06
5.74805 7.62939e-06
3.47168 7.62939e-06
3.57809 7.62939e-06
3.00346 7.62939e-06
3.113 7.62939e-06
3.64313 7.62939e-06
2.80376 7.62939e-06
3.65677 7.62939e-06
3.69974 7.62939e-06
5.89501 7.62939e-06
5.05187 7.62939e-06
4.74616 7.62939e-06
4.33501 7.62939e-06
9.19956 7.62939e-06
10.6919 7.62939e-06
0.813113 7.62939e-06
2.87921 7.62939e-06
1.50684 7.62939e-06
2.38975 7.62939e-06
END
$hits3 << END
4.08186 0.000152588
4.25806 0.000152588
5.5787 7.62939e-05
5.67744 3.05176e-05
5.34305 0.00050354
5.91316 0.000152588
3.78641 0.000152588
3.97363 0.000152588
3.17483 7.62939e-05
3.21152 3.05176e-05
3.78678 0.00050354
3.86844 0.000152588
3.88209 0.000152588
3.96949 0.000152588
6.41114 0.000289917
5.55033 3.05176e-05
5.00392 0.00062561
4.09578 0.000366211
10.7856 0.000259399
12.9841 6.10352e-05
END
$hits4 << END
3.24253 5.6514e-06
3.37648 5.6514e-06
5.129 5.6514e-06
3.40544 5.6514e-06
5.54018 5.6514e-06
5.79588 5.6514e-06
3.04554 5.6514e-06
3.17702 5.6514e-06
2.98188 5.6514e-06
3.06176 5.6514e-06
3.67504 5.6514e-06
3.69023 5.6514e-06
3.17222 5.6514e-06
3.25322 5.6514e-06
5.78621 5.6514e-06
5.16146 5.6514e-06
4.30084 5.6514e-06
3.98993 5.6514e-06
10.0723 5.6514e-06
11.5317 5.6514e-06
END
$hits5 << END
3.36791 0.000152588
3.69154 0.000152588
5.48207 7.62939e-05
5.6921 3.05176e-05
5.64513 0.00050354
6.00148 0.000152588
3.37137 0.000152588
3.46462 0.000152588
2.73723 7.62939e-05
3.17772 3.05176e-05
3.67816 0.00050354
3.85502 0.000152588
3.39744 0.000152588
3.46583 0.000152588
6.12435 0.000289917
5.52342 3.05176e-05
4.92107 0.00062561
4.29455 0.000366211
11.2786 0.000259399
12.2922 6.10352e-05
END
$hits_front << END
11.5317 5.6514e-06
12.9841 6.10352e-05
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
set xrange [3.91236:74.7542]; set yrange [2.21855e-08:0.0161019]
set xlabel 'pictures a second  (more is better)'; set ylabel 'picture: RMSE of a channel  (less is better)' offset -1.5
set xtics ('5' 5, '7' 7, '10' 10, '15' 15, '20' 20, '30' 30, '50' 50, '70' 70)
set ytics ("same\nbits" 5.54636e-08, '10⁻⁶' 1e-6, '10⁻⁵' 1e-5, '10⁻⁴' 1e-4, '10⁻³' 1e-3, '10⁻²' 1e-2)
set object rectangle from graph 0, graph 0 to graph 1, first 9.42882e-08 fs solid noborder fc rgb '#eeeeee' behind
set arrow from first 62.2952,4.10842e-08 to graph 1.0,0.0457 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.0457 to graph 1.015,0.0457 nohead lw 0.8 lc rgb '#999999'
set label 'double: irregular exact' at graph 1.02,0.0457 left
$picture0 << END
13.9128 0.00319435
14.8632 0.00319435
27.2106 0.00319435
27.5424 0.00319435
30.7688 0.00319435
34.5389 0.00319435
13.982 0.00319435
14.1237 0.00319435
19.4787 0.00319435
19.9972 0.00319435
22.5527 0.00319435
23.6169 0.00319435
14.289 0.00319435
14.1723 0.00319435
28.9495 0.00319435
25.0357 0.00319435
25.1484 0.00319435
18.5626 0.00319435
48.7049 0.00319435
56.4921 0.00319435
END
$picture1 << END
12.0064 0.00383996
12.5081 0.00383912
26.681 0.00319435
27.6558 0.0042878
30.6767 0.00642127
33.9541 0.00454316
11.6437 0.00383996
11.8052 0.00383912
19.2334 0.00319435
19.652 0.0042878
22.9625 0.00642127
23.7363 0.00454316
11.8501 0.00383996
11.6175 0.00383912
27.8128 0.00365496
24.2896 0.0042878
23.4399 0.00644074
20.875 0.00561794
47.8852 0.00413272
58.7879 0.00400417
END
$picture2 << END
18.0242 4.43709e-07
18.9566 4.43709e-07
32.0126 4.43709e-07
33.0086 4.43709e-07
33.6336 4.43709e-07
37.6054 4.43709e-07
17.6268 4.43709e-07
18.3383 4.43709e-07
21.504 4.43709e-07
22.0725 4.43709e-07
24.0711 4.43709e-07
24.2853 4.43709e-07
18.2296 4.43709e-07
17.966 4.43709e-07
31.9275 4.43709e-07
31.8429 4.43709e-07
28.0434 4.43709e-07
27.4054 4.43709e-07
52.2081 4.43709e-07
58.4676 4.43709e-07
4.69484 4.43709e-07
18.9278 4.43709e-07
15.0986 4.43709e-07
19.9337 4.43709e-07
END
$picture3 << END
18.4379 0.00213107
19.36 0.00212955
33.4473 4.43709e-07
33.6595 0.00286034
34.5035 0.00557035
36.2363 0.00323054
17.6888 0.00213107
18.2954 0.00212955
21.4193 4.43709e-07
21.9064 0.00286034
24.0365 0.00557035
23.8811 0.00323054
18.1889 0.00213107
18.3103 0.00212955
33.9605 0.00177614
31.3359 0.00286034
22.4708 0.00559278
26.5894 0.00462139
49.5793 0.00262212
60.3508 0.00241446
END
$picture4 << END
14.2894 4.10842e-08
14.8695 4.10842e-08
29.5667 4.10842e-08
30.0889 4.10842e-08
32.2522 4.10842e-08
35.0549 4.10842e-08
13.7264 4.10842e-08
13.9926 4.10842e-08
20.6466 4.10842e-08
21.1275 4.10842e-08
23.4547 4.10842e-08
24.2105 4.10842e-08
14.0797 4.10842e-08
14.2805 4.10842e-08
31.3652 4.10842e-08
28.5307 4.10842e-08
24.7797 4.10842e-08
24.192 4.10842e-08
50.8616 4.10842e-08
62.2952 4.10842e-08
END
$picture5 << END
14.3444 0.00213107
15.1242 0.00212955
30.3283 4.10842e-08
31.2459 0.00286034
32.881 0.00557035
35.0055 0.00323054
14.5349 0.00213107
14.6614 0.00212955
21.0092 4.10842e-08
21.7032 0.00286034
23.6459 0.00557035
24.1497 0.00323054
14.6186 0.00213107
14.6685 0.00212955
31.522 0.00177613
28.9426 0.00286034
25.6216 0.00559278
24.5342 0.00462139
53.7089 0.00262212
52.727 0.00241446
END
$picture_front << END
62.2952 4.10842e-08
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
set xrange [0.677594:15.5809]; set yrange [3.05176e-06:0.00156403]
set xlabel 'million nearest hits a second  (more is better)'; set ylabel 'wrong hits  (less is better)' offset -1.5
set label 'gears: speed against accuracy (CPU, 2 threads)' at screen 0.02, screen 0.9774 font ',20'
set label '256x256 primary and 65,536 random rays a scene; 65,536 in all compared with brute force in double; pictures of 128x128' at screen 0.02, screen 0.9516
set xtics ('1' 1, '2' 2, '5' 5, '10' 10)
set ytics ("none of\n65,536" 7.62939e-06, '0.01 %%' 1e-4, '0.1 %%' 1e-3)
set object rectangle from graph 0, graph 0 to graph 1, first 1.297e-05 fs solid noborder fc rgb '#eeeeee' behind
set arrow from first 12.9841,6.10352e-05 to graph 1.0,0.4801 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.4801 to graph 1.015,0.4801 nohead lw 0.8 lc rgb '#999999'
set label 'robust, study: irregular exact' at graph 1.02,0.4801 left
set arrow from first 11.5317,5.6514e-06 to graph 1.0,0.0988 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.0988 to graph 1.015,0.0988 nohead lw 0.8 lc rgb '#999999'
set label 'double: irregular exact' at graph 1.02,0.0988 left
$hits0 << END
3.06906 1.02997e-05
3.15058 1.02997e-05
4.70631 1.02997e-05
4.85829 1.02997e-05
5.21288 1.02997e-05
5.75167 1.02997e-05
2.98181 1.02997e-05
3.05373 1.02997e-05
2.87631 1.02997e-05
2.96437 1.02997e-05
3.53146 1.02997e-05
3.71083 1.02997e-05
3.0911 1.02997e-05
3.07471 1.02997e-05
5.28141 1.02997e-05
4.74731 1.02997e-05
4.39551 1.02997e-05
3.37139 1.02997e-05
9.16115 1.02997e-05
10.0555 1.02997e-05
END
$hits1 << END
2.35751 0.000152588
2.39658 0.000152588
4.60462 7.62939e-05
4.87736 3.05176e-05
4.78525 0.00050354
5.36448 0.000152588
2.13982 0.000152588
2.22704 0.000152588
2.84995 7.62939e-05
2.97442 3.05176e-05
3.55001 0.00050354
3.42131 0.000152588
2.27644 0.000152588
2.26646 0.000152588
5.15759 0.000289917
4.53176 3.05176e-05
4.32853 0.00062561
3.09185 0.000366211
9.39695 0.000259399
11.5361 6.10352e-05
END
$hits2 << END
3.71786 7.62939e-06
3.92374 7.62939e-06
5.25574 7.62939e-06
5.48493 7.62939e-06
5.15636 7.62939e-06
5.74805 7.62939e-06
3.47168 7.62939e-06
3.57809 7.62939e-06
3.00346 7.62939e-06
3.113 7.62939e-06
3.64313 7.62939e-06
2.80376 7.62939e-06
3.65677 7.62939e-06
3.69974 7.62939e-06
5.89501 7.62939e-06
5.05187 7.62939e-06
4.74616 7.62939e-06
4.33501 7.62939e-06
9.19956 7.62939e-06
10.6919 7.62939e-06
0.813113 7.62939e-06
2.87921 7.62939e-06
1.50684 7.62939e-06
2.38975 7.62939e-06
END
$hits3 << END
4.08186 0.000152588
4.25806 0.000152588
5.5787 7.62939e-05
5.67744 3.05176e-05
5.34305 0.00050354
5.91316 0.000152588
3.78641 0.000152588
3.97363 0.000152588
3.17483 7.62939e-05
3.21152 3.05176e-05
3.78678 0.00050354
3.86844 0.000152588
3.88209 0.000152588
3.96949 0.000152588
6.41114 0.000289917
5.55033 3.05176e-05
5.00392 0.00062561
4.09578 0.000366211
10.7856 0.000259399
12.9841 6.10352e-05
END
$hits4 << END
3.24253 5.6514e-06
3.37648 5.6514e-06
5.129 5.6514e-06
3.40544 5.6514e-06
5.54018 5.6514e-06
5.79588 5.6514e-06
3.04554 5.6514e-06
3.17702 5.6514e-06
2.98188 5.6514e-06
3.06176 5.6514e-06
3.67504 5.6514e-06
3.69023 5.6514e-06
3.17222 5.6514e-06
3.25322 5.6514e-06
5.78621 5.6514e-06
5.16146 5.6514e-06
4.30084 5.6514e-06
3.98993 5.6514e-06
10.0723 5.6514e-06
11.5317 5.6514e-06
END
$hits5 << END
3.36791 0.000152588
3.69154 0.000152588
5.48207 7.62939e-05
5.6921 3.05176e-05
5.64513 0.00050354
6.00148 0.000152588
3.37137 0.000152588
3.46462 0.000152588
2.73723 7.62939e-05
3.17772 3.05176e-05
3.67816 0.00050354
3.85502 0.000152588
3.39744 0.000152588
3.46583 0.000152588
6.12435 0.000289917
5.52342 3.05176e-05
4.92107 0.00062561
4.29455 0.000366211
11.2786 0.000259399
12.2922 6.10352e-05
END
$hits_front << END
11.5317 5.6514e-06
12.9841 6.10352e-05
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
set xrange [3.91236:74.7542]; set yrange [2.21855e-08:0.0161019]
set xlabel 'pictures a second  (more is better)'; set ylabel 'picture: RMSE of a channel  (less is better)' offset -1.5
set xtics ('5' 5, '7' 7, '10' 10, '15' 15, '20' 20, '30' 30, '50' 50, '70' 70)
set ytics ("same\nbits" 5.54636e-08, '10⁻⁶' 1e-6, '10⁻⁵' 1e-5, '10⁻⁴' 1e-4, '10⁻³' 1e-3, '10⁻²' 1e-2)
set object rectangle from graph 0, graph 0 to graph 1, first 9.42882e-08 fs solid noborder fc rgb '#eeeeee' behind
set arrow from first 62.2952,4.10842e-08 to graph 1.0,0.0457 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.0457 to graph 1.015,0.0457 nohead lw 0.8 lc rgb '#999999'
set label 'double: irregular exact' at graph 1.02,0.0457 left
$picture0 << END
13.9128 0.00319435
14.8632 0.00319435
27.2106 0.00319435
27.5424 0.00319435
30.7688 0.00319435
34.5389 0.00319435
13.982 0.00319435
14.1237 0.00319435
19.4787 0.00319435
19.9972 0.00319435
22.5527 0.00319435
23.6169 0.00319435
14.289 0.00319435
14.1723 0.00319435
28.9495 0.00319435
25.0357 0.00319435
25.1484 0.00319435
18.5626 0.00319435
48.7049 0.00319435
56.4921 0.00319435
END
$picture1 << END
12.0064 0.00383996
12.5081 0.00383912
26.681 0.00319435
27.6558 0.0042878
30.6767 0.00642127
33.9541 0.00454316
11.6437 0.00383996
11.8052 0.00383912
19.2334 0.00319435
19.652 0.0042878
22.9625 0.00642127
23.7363 0.00454316
11.8501 0.00383996
11.6175 0.00383912
27.8128 0.00365496
24.2896 0.0042878
23.4399 0.00644074
20.875 0.00561794
47.8852 0.00413272
58.7879 0.00400417
END
$picture2 << END
18.0242 4.43709e-07
18.9566 4.43709e-07
32.0126 4.43709e-07
33.0086 4.43709e-07
33.6336 4.43709e-07
37.6054 4.43709e-07
17.6268 4.43709e-07
18.3383 4.43709e-07
21.504 4.43709e-07
22.0725 4.43709e-07
24.0711 4.43709e-07
24.2853 4.43709e-07
18.2296 4.43709e-07
17.966 4.43709e-07
31.9275 4.43709e-07
31.8429 4.43709e-07
28.0434 4.43709e-07
27.4054 4.43709e-07
52.2081 4.43709e-07
58.4676 4.43709e-07
4.69484 4.43709e-07
18.9278 4.43709e-07
15.0986 4.43709e-07
19.9337 4.43709e-07
END
$picture3 << END
18.4379 0.00213107
19.36 0.00212955
33.4473 4.43709e-07
33.6595 0.00286034
34.5035 0.00557035
36.2363 0.00323054
17.6888 0.00213107
18.2954 0.00212955
21.4193 4.43709e-07
21.9064 0.00286034
24.0365 0.00557035
23.8811 0.00323054
18.1889 0.00213107
18.3103 0.00212955
33.9605 0.00177614
31.3359 0.00286034
22.4708 0.00559278
26.5894 0.00462139
49.5793 0.00262212
60.3508 0.00241446
END
$picture4 << END
14.2894 4.10842e-08
14.8695 4.10842e-08
29.5667 4.10842e-08
30.0889 4.10842e-08
32.2522 4.10842e-08
35.0549 4.10842e-08
13.7264 4.10842e-08
13.9926 4.10842e-08
20.6466 4.10842e-08
21.1275 4.10842e-08
23.4547 4.10842e-08
24.2105 4.10842e-08
14.0797 4.10842e-08
14.2805 4.10842e-08
31.3652 4.10842e-08
28.5307 4.10842e-08
24.7797 4.10842e-08
24.192 4.10842e-08
50.8616 4.10842e-08
62.2952 4.10842e-08
END
$picture5 << END
14.3444 0.00213107
15.1242 0.00212955
30.3283 4.10842e-08
31.2459 0.00286034
32.881 0.00557035
35.0055 0.00323054
14.5349 0.00213107
14.6614 0.00212955
21.0092 4.10842e-08
21.7032 0.00286034
23.6459 0.00557035
24.1497 0.00323054
14.6186 0.00213107
14.6685 0.00212955
31.522 0.00177613
28.9426 0.00286034
25.6216 0.00559278
24.5342 0.00462139
53.7089 0.00262212
52.727 0.00241446
END
$picture_front << END
62.2952 4.10842e-08
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
set xrange [0.975908:11.7895]; set yrange [3.05176e-06:0.001297]
set xlabel 'million nearest hits a second  (more is better)'; set ylabel 'wrong hits  (less is better)' offset -1.5
set label 'mount: speed against accuracy (CPU, 2 threads)' at screen 0.02, screen 0.9774 font ',20'
set label '256x256 primary and 65,536 random rays a scene; 65,536 in all compared with brute force in double; pictures of 128x128' at screen 0.02, screen 0.9516
set xtics ('1' 1, '1.5' 1.5, '2' 2, '3' 3, '5' 5, '7' 7, '10' 10)
set ytics ("none of\n65,536" 7.62939e-06, '0.01 %%' 1e-4, '0.1 %%' 1e-3)
set object rectangle from graph 0, graph 0 to graph 1, first 1.297e-05 fs solid noborder fc rgb '#eeeeee' behind
set arrow from first 9.82462,1.52588e-05 to graph 1.0,0.2659 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.2659 to graph 1.015,0.2659 nohead lw 0.8 lc rgb '#999999'
set label 'robust, study: irregular exact' at graph 1.02,0.2659 left
set arrow from first 9.14609,5.6514e-06 to graph 1.0,0.1018 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.1018 to graph 1.015,0.1018 nohead lw 0.8 lc rgb '#999999'
set label 'double: irregular exact' at graph 1.02,0.1018 left
$hits0 << END
5.14966 1.02997e-05
5.33071 1.02997e-05
3.61586 1.02997e-05
3.84157 1.02997e-05
4.53197 1.02997e-05
4.88642 1.02997e-05
4.48156 1.02997e-05
4.6519 1.02997e-05
2.55797 1.02997e-05
2.70525 1.02997e-05
3.46895 1.02997e-05
3.72082 1.02997e-05
4.24998 1.02997e-05
4.47828 1.02997e-05
1.55733 1.02997e-05
1.52031 1.02997e-05
2.48096 1.02997e-05
2.56282 1.02997e-05
7.27812 1.02997e-05
7.77635 1.02997e-05
END
$hits1 << END
4.49854 6.10352e-05
4.5643 4.57764e-05
3.75102 1.52588e-05
3.86376 1.02997e-05
4.66744 0.000213623
4.95173 7.62939e-05
3.96198 6.10352e-05
4.16406 4.57764e-05
2.66008 1.52588e-05
2.7658 1.02997e-05
3.64588 0.000213623
3.82041 7.62939e-05
3.79501 0.000183105
3.91162 0.000167847
1.19225 0.000198364
1.17109 0.000473022
2.30077 0.000350952
2.32607 0.000518799
8.08879 9.15527e-05
8.79396 1.52588e-05
END
$hits2 << END
6.19552 7.62939e-06
6.35406 7.62939e-06
3.73784 7.62939e-06
4.01371 7.62939e-06
4.90697 7.62939e-06
5.21934 7.62939e-06
5.30332 7.62939e-06
5.51319 7.62939e-06
2.60075 7.62939e-06
2.77904 7.62939e-06
3.77409 7.62939e-06
3.95383 7.62939e-06
5.07674 7.62939e-06
5.37181 7.62939e-06
1.68601 7.62939e-06
1.70217 7.62939e-06
2.75212 7.62939e-06
2.88633 7.62939e-06
8.19545 7.62939e-06
8.13019 7.62939e-06
1.20885 7.62939e-06
3.48894 7.62939e-06
5.90071 7.62939e-06
2.22729 7.62939e-06
3.14443 7.62939e-06
END
$hits3 << END
6.62252 6.10352e-05
6.80078 4.57764e-05
3.95469 1.52588e-05
4.0843 7.62939e-06
5.26095 0.000213623
5.37735 7.62939e-05
5.91084 6.10352e-05
6.09081 4.57764e-05
2.76913 1.52588e-05
2.8815 7.62939e-06
4.07544 0.000213623
4.11977 7.62939e-05
5.50306 0.000183105
5.77029 0.000167847
1.35604 0.000198364
1.6773 0.000473022
2.9885 0.000350952
3.03723 0.000518799
9.38138 9.15527e-05
9.82462 1.52588e-05
END
$hits4 << END
5.9514 5.6514e-06
6.15166 5.6514e-06
3.68452 5.6514e-06
3.95965 5.6514e-06
4.89995 5.6514e-06
4.16272 5.6514e-06
5.07413 5.6514e-06
5.26279 5.6514e-06
2.62487 5.6514e-06
2.79728 5.6514e-06
3.77304 5.6514e-06
3.93663 5.6514e-06
4.74411 5.6514e-06
5.04771 5.6514e-06
1.52029 5.6514e-06
1.35878 5.6514e-06
2.63009 5.6514e-06
2.74439 5.6514e-06
8.26478 5.6514e-06
9.14609 5.6514e-06
END
$hits5 << END
5.31147 6.10352e-05
6.57148 4.57764e-05
3.92515 1.52588e-05
4.13142 5.6514e-06
5.22043 0.000213623
5.42596 7.62939e-05
5.55724 6.10352e-05
5.6837 4.57764e-05
2.7262 1.52588e-05
2.89147 5.6514e-06
3.88099 0.000213623
4.18198 7.62939e-05
5.14695 0.000183105
5.33626 0.000167847
1.57494 0.000198364
1.58166 0.000473022
2.82057 0.000350952
2.84578 0.000518799
8.66117 9.15527e-05
9.57178 1.52588e-05
END
$hits_front << END
9.14609 5.6514e-06
9.82462 1.52588e-05
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
set xrange [17.8818:121.469]; set yrange [5.91675e-06:0.0144206]
set xlabel 'pictures a second  (more is better)'; set ylabel 'picture: RMSE of a channel  (less is better)' offset -1.5
set xtics ('20' 20, '30' 30, '50' 50, '70' 70, '100' 100)
set ytics ("same\nbits" 1.47919e-05, '10⁻⁴' 1e-4, '10⁻³' 1e-3, '10⁻²' 1e-2)
set object rectangle from graph 0, graph 0 to graph 1, first 2.51462e-05 fs solid noborder fc rgb '#eeeeee' behind
set arrow from first 101.224,0.000118335 to graph 1.0,0.3841 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.3841 to graph 1.015,0.3841 nohead lw 0.8 lc rgb '#999999'
set label 'robust, study: irregular exact' at graph 1.02,0.3841 left
set arrow from first 99.5798,1.09569e-05 to graph 1.0,0.0790 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.0790 to graph 1.015,0.0790 nohead lw 0.8 lc rgb '#999999'
set label 'double, study: irregular exact' at graph 1.02,0.0790 left
$picture0 << END
66.9268 0.00517964
68.1631 0.00517964
50.9406 0.00517964
54.9701 0.00517964
58.6858 0.00517964
62.461 0.00517964
59.4569 0.00517964
60.9764 0.00517964
36.6294 0.00517964
40.6379 0.00517964
46.5575 0.00517964
50.4439 0.00517964
61.3057 0.00517964
62.6555 0.00517964
29.8903 0.00517964
27.9226 0.00517964
45.703 0.00517964
46.6144 0.00517964
89.4198 0.00517964
88.5371 0.00517964
END
$picture1 << END
63.4691 0.00531405
65.0297 0.00531405
59.3838 0.00519279
62.3336 0.00517964
66.0192 0.00576825
70.028 0.00551613
59.0357 0.00531405
61.078 0.00531405
44.9618 0.00519279
46.9693 0.00517964
55.2975 0.00576825
58.0936 0.00551613
56.267 0.00531405
59.7593 0.00531405
23.2267 0.00519239
21.4582 0.00520441
41.4525 0.00576825
41.1499 0.0055394
91.4378 0.00531712
96.4925 0.00517964
END
$picture2 << END
74.112 0.000118335
75.0638 0.000118335
48.3559 0.000118335
55.2456 0.000118335
60.3901 0.000118335
66.2208 0.000118335
66.0563 0.000118335
67.485 0.000118335
37.6323 0.000118335
42.4398 0.000118335
50.2646 0.000118335
54.1263 0.000118335
69.4416 0.000118335
71.4097 0.000118335
29.8167 0.000118335
29.6595 0.000118335
47.5529 0.000118335
48.4778 0.000118335
93.3515 0.000118335
95.1873 0.000118335
22.8785 0.000118335
55.1146 0.000118335
72.1839 0.000118335
34.963 0.000118335
35.1807 0.000118335
END
$picture3 << END
79.3216 0.00159667
81.662 0.00159667
60.8709 0.000387878
64.4347 0.000118335
73.3557 0.00254127
76.0856 0.0019008
74.857 0.00159667
76.0832 0.00159667
45.716 0.000387878
29.5685 0.000118335
60.5826 0.00254127
63.0144 0.0019008
74.5751 0.00159667
76.3592 0.00159667
30.9097 0.000382429
33.1704 0.000520823
52.5025 0.00254127
53.2507 0.0019673
97.8206 0.00120712
101.224 0.000118335
END
$picture4 << END
70.1282 1.09569e-05
72.097 1.09569e-05
49.0836 1.09569e-05
55.864 1.09569e-05
60.0871 1.09569e-05
64.821 1.09569e-05
63.0772 1.09569e-05
64.3492 1.09569e-05
36.7365 1.09569e-05
41.1105 1.09569e-05
47.9026 1.09569e-05
52.6951 1.09569e-05
65.2546 1.09569e-05
67.9136 1.09569e-05
28.6646 1.09569e-05
27.1065 1.09569e-05
45.6494 1.09569e-05
45.8272 1.09569e-05
89.5624 1.09569e-05
94.5439 1.09569e-05
END
$picture5 << END
79.6933 0.00159428
81.2414 0.00159428
63.2759 0.000369387
66.4818 1.09569e-05
73.4085 0.00253977
77.1075 0.00189879
74.135 0.00159428
75.2666 0.00159428
46.9354 0.000369387
49.4391 1.09569e-05
60.2112 0.00253977
62.1906 0.00189879
72.5679 0.00159428
72.8369 0.00159428
32.6965 0.00036366
31.9965 0.000509379
51.0704 0.00253977
52.1273 0.00196593
97.3928 0.0012013
99.5798 1.09569e-05
END
$picture_front << END
99.5798 1.09569e-05
101.224 0.000118335
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
set xrange [0.975908:11.7895]; set yrange [3.05176e-06:0.001297]
set xlabel 'million nearest hits a second  (more is better)'; set ylabel 'wrong hits  (less is better)' offset -1.5
set label 'mount: speed against accuracy (CPU, 2 threads)' at screen 0.02, screen 0.9774 font ',20'
set label '256x256 primary and 65,536 random rays a scene; 65,536 in all compared with brute force in double; pictures of 128x128' at screen 0.02, screen 0.9516
set xtics ('1' 1, '1.5' 1.5, '2' 2, '3' 3, '5' 5, '7' 7, '10' 10)
set ytics ("none of\n65,536" 7.62939e-06, '0.01 %%' 1e-4, '0.1 %%' 1e-3)
set object rectangle from graph 0, graph 0 to graph 1, first 1.297e-05 fs solid noborder fc rgb '#eeeeee' behind
set arrow from first 9.82462,1.52588e-05 to graph 1.0,0.2659 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.2659 to graph 1.015,0.2659 nohead lw 0.8 lc rgb '#999999'
set label 'robust, study: irregular exact' at graph 1.02,0.2659 left
set arrow from first 9.14609,5.6514e-06 to graph 1.0,0.1018 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.1018 to graph 1.015,0.1018 nohead lw 0.8 lc rgb '#999999'
set label 'double: irregular exact' at graph 1.02,0.1018 left
$hits0 << END
5.14966 1.02997e-05
5.33071 1.02997e-05
3.61586 1.02997e-05
3.84157 1.02997e-05
4.53197 1.02997e-05
4.88642 1.02997e-05
4.48156 1.02997e-05
4.6519 1.02997e-05
2.55797 1.02997e-05
2.70525 1.02997e-05
3.46895 1.02997e-05
3.72082 1.02997e-05
4.24998 1.02997e-05
4.47828 1.02997e-05
1.55733 1.02997e-05
1.52031 1.02997e-05
2.48096 1.02997e-05
2.56282 1.02997e-05
7.27812 1.02997e-05
7.77635 1.02997e-05
END
$hits1 << END
4.49854 6.10352e-05
4.5643 4.57764e-05
3.75102 1.52588e-05
3.86376 1.02997e-05
4.66744 0.000213623
4.95173 7.62939e-05
3.96198 6.10352e-05
4.16406 4.57764e-05
2.66008 1.52588e-05
2.7658 1.02997e-05
3.64588 0.000213623
3.82041 7.62939e-05
3.79501 0.000183105
3.91162 0.000167847
1.19225 0.000198364
1.17109 0.000473022
2.30077 0.000350952
2.32607 0.000518799
8.08879 9.15527e-05
8.79396 1.52588e-05
END
$hits2 << END
6.19552 7.62939e-06
6.35406 7.62939e-06
3.73784 7.62939e-06
4.01371 7.62939e-06
4.90697 7.62939e-06
5.21934 7.62939e-06
5.30332 7.62939e-06
5.51319 7.62939e-06
2.60075 7.62939e-06
2.77904 7.62939e-06
3.77409 7.62939e-06
3.95383 7.62939e-06
5.07674 7.62939e-06
5.37181 7.62939e-06
1.68601 7.62939e-06
1.70217 7.62939e-06
2.75212 7.62939e-06
2.88633 7.62939e-06
8.19545 7.62939e-06
8.13019 7.62939e-06
1.20885 7.62939e-06
3.48894 7.62939e-06
5.90071 7.62939e-06
2.22729 7.62939e-06
3.14443 7.62939e-06
END
$hits3 << END
6.62252 6.10352e-05
6.80078 4.57764e-05
3.95469 1.52588e-05
4.0843 7.62939e-06
5.26095 0.000213623
5.37735 7.62939e-05
5.91084 6.10352e-05
6.09081 4.57764e-05
2.76913 1.52588e-05
2.8815 7.62939e-06
4.07544 0.000213623
4.11977 7.62939e-05
5.50306 0.000183105
5.77029 0.000167847
1.35604 0.000198364
1.6773 0.000473022
2.9885 0.000350952
3.03723 0.000518799
9.38138 9.15527e-05
9.82462 1.52588e-05
END
$hits4 << END
5.9514 5.6514e-06
6.15166 5.6514e-06
3.68452 5.6514e-06
3.95965 5.6514e-06
4.89995 5.6514e-06
4.16272 5.6514e-06
5.07413 5.6514e-06
5.26279 5.6514e-06
2.62487 5.6514e-06
2.79728 5.6514e-06
3.77304 5.6514e-06
3.93663 5.6514e-06
4.74411 5.6514e-06
5.04771 5.6514e-06
1.52029 5.6514e-06
1.35878 5.6514e-06
2.63009 5.6514e-06
2.74439 5.6514e-06
8.26478 5.6514e-06
9.14609 5.6514e-06
END
$hits5 << END
5.31147 6.10352e-05
6.57148 4.57764e-05
3.92515 1.52588e-05
4.13142 5.6514e-06
5.22043 0.000213623
5.42596 7.62939e-05
5.55724 6.10352e-05
5.6837 4.57764e-05
2.7262 1.52588e-05
2.89147 5.6514e-06
3.88099 0.000213623
4.18198 7.62939e-05
5.14695 0.000183105
5.33626 0.000167847
1.57494 0.000198364
1.58166 0.000473022
2.82057 0.000350952
2.84578 0.000518799
8.66117 9.15527e-05
9.57178 1.52588e-05
END
$hits_front << END
9.14609 5.6514e-06
9.82462 1.52588e-05
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
set xrange [17.8818:121.469]; set yrange [5.91675e-06:0.0144206]
set xlabel 'pictures a second  (more is better)'; set ylabel 'picture: RMSE of a channel  (less is better)' offset -1.5
set xtics ('20' 20, '30' 30, '50' 50, '70' 70, '100' 100)
set ytics ("same\nbits" 1.47919e-05, '10⁻⁴' 1e-4, '10⁻³' 1e-3, '10⁻²' 1e-2)
set object rectangle from graph 0, graph 0 to graph 1, first 2.51462e-05 fs solid noborder fc rgb '#eeeeee' behind
set arrow from first 101.224,0.000118335 to graph 1.0,0.3841 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.3841 to graph 1.015,0.3841 nohead lw 0.8 lc rgb '#999999'
set label 'robust, study: irregular exact' at graph 1.02,0.3841 left
set arrow from first 99.5798,1.09569e-05 to graph 1.0,0.0790 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.0790 to graph 1.015,0.0790 nohead lw 0.8 lc rgb '#999999'
set label 'double, study: irregular exact' at graph 1.02,0.0790 left
$picture0 << END
66.9268 0.00517964
68.1631 0.00517964
50.9406 0.00517964
54.9701 0.00517964
58.6858 0.00517964
62.461 0.00517964
59.4569 0.00517964
60.9764 0.00517964
36.6294 0.00517964
40.6379 0.00517964
46.5575 0.00517964
50.4439 0.00517964
61.3057 0.00517964
62.6555 0.00517964
29.8903 0.00517964
27.9226 0.00517964
45.703 0.00517964
46.6144 0.00517964
89.4198 0.00517964
88.5371 0.00517964
END
$picture1 << END
63.4691 0.00531405
65.0297 0.00531405
59.3838 0.00519279
62.3336 0.00517964
66.0192 0.00576825
70.028 0.00551613
59.0357 0.00531405
61.078 0.00531405
44.9618 0.00519279
46.9693 0.00517964
55.2975 0.00576825
58.0936 0.00551613
56.267 0.00531405
59.7593 0.00531405
23.2267 0.00519239
21.4582 0.00520441
41.4525 0.00576825
41.1499 0.0055394
91.4378 0.00531712
96.4925 0.00517964
END
$picture2 << END
74.112 0.000118335
75.0638 0.000118335
48.3559 0.000118335
55.2456 0.000118335
60.3901 0.000118335
66.2208 0.000118335
66.0563 0.000118335
67.485 0.000118335
37.6323 0.000118335
42.4398 0.000118335
50.2646 0.000118335
54.1263 0.000118335
69.4416 0.000118335
71.4097 0.000118335
29.8167 0.000118335
29.6595 0.000118335
47.5529 0.000118335
48.4778 0.000118335
93.3515 0.000118335
95.1873 0.000118335
22.8785 0.000118335
55.1146 0.000118335
72.1839 0.000118335
34.963 0.000118335
35.1807 0.000118335
END
$picture3 << END
79.3216 0.00159667
81.662 0.00159667
60.8709 0.000387878
64.4347 0.000118335
73.3557 0.00254127
76.0856 0.0019008
74.857 0.00159667
76.0832 0.00159667
45.716 0.000387878
29.5685 0.000118335
60.5826 0.00254127
63.0144 0.0019008
74.5751 0.00159667
76.3592 0.00159667
30.9097 0.000382429
33.1704 0.000520823
52.5025 0.00254127
53.2507 0.0019673
97.8206 0.00120712
101.224 0.000118335
END
$picture4 << END
70.1282 1.09569e-05
72.097 1.09569e-05
49.0836 1.09569e-05
55.864 1.09569e-05
60.0871 1.09569e-05
64.821 1.09569e-05
63.0772 1.09569e-05
64.3492 1.09569e-05
36.7365 1.09569e-05
41.1105 1.09569e-05
47.9026 1.09569e-05
52.6951 1.09569e-05
65.2546 1.09569e-05
67.9136 1.09569e-05
28.6646 1.09569e-05
27.1065 1.09569e-05
45.6494 1.09569e-05
45.8272 1.09569e-05
89.5624 1.09569e-05
94.5439 1.09569e-05
END
$picture5 << END
79.6933 0.00159428
81.2414 0.00159428
63.2759 0.000369387
66.4818 1.09569e-05
73.4085 0.00253977
77.1075 0.00189879
74.135 0.00159428
75.2666 0.00159428
46.9354 0.000369387
49.4391 1.09569e-05
60.2112 0.00253977
62.1906 0.00189879
72.5679 0.00159428
72.8369 0.00159428
32.6965 0.00036366
31.9965 0.000509379
51.0704 0.00253977
52.1273 0.00196593
97.3928 0.0012013
99.5798 1.09569e-05
END
$picture_front << END
99.5798 1.09569e-05
101.224 0.000118335
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
set xrange [0.537673:7.2926]; set yrange [3.05176e-06:0.0588608]
set xlabel 'million nearest hits a second  (more is better)'; set ylabel 'wrong hits  (less is better)' offset -1.5
set label 'rings: speed against accuracy (CPU, 2 threads)' at screen 0.02, screen 0.9774 font ',20'
set label '256x256 primary and 65,536 random rays a scene; 65,536 in all compared with brute force in double; pictures of 128x128' at screen 0.02, screen 0.9516
set xtics ('0.7' 0.7, '1' 1, '1.5' 1.5, '2' 2, '3' 3, '5' 5, '7' 7)
set ytics ("none of\n65,536" 7.62939e-06, '0.01 %%' 1e-4, '0.1 %%' 1e-3, '1 %%' 1e-2)
set object rectangle from graph 0, graph 0 to graph 1, first 1.297e-05 fs solid noborder fc rgb '#eeeeee' behind
set arrow from first 6.07717,0.00984192 to graph 1.0,0.8187 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.8187 to graph 1.015,0.8187 nohead lw 0.8 lc rgb '#999999'
set label 'robust, study: irregular exact' at graph 1.02,0.8187 left
set arrow from first 5.76275,5.6514e-06 to graph 1.0,0.0624 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.0624 to graph 1.015,0.0624 nohead lw 0.8 lc rgb '#999999'
set label 'double: irregular exact' at graph 1.02,0.0624 left
$hits0 << END
1.8565 0.000259399
2.17145 0.000259399
2.23456 0.000259399
3.20463 0.000259399
2.57567 0.000259399
3.57276 0.000259399
1.69004 0.000259399
2.02051 0.000259399
1.74413 0.000259399
2.16879 0.000259399
2.08759 0.000259399
2.36174 0.000259399
1.70656 0.000259399
2.02187 0.000259399
1.18986 0.000259399
1.56405 0.000259399
1.13381 0.000259399
1.51187 0.000259399
4.1798 0.000259399
5.63534 0.000259399
END
$hits1 << END
1.9188 0.00686646
2.18773 0.00610352
2.67658 0.0235443
3.23261 0.00991821
2.7751 0.0219116
3.6949 0.0118256
1.77732 0.00686646
2.08871 0.00610352
1.88328 0.0235443
2.22803 0.00991821
2.21781 0.0219116
2.58821 0.0118256
1.71092 0.00785828
2.11814 0.00624084
1.22431 0.0185242
1.63926 0.0170288
1.18155 0.0169067
1.56502 0.0122986
4.72169 0.0209045
5.85888 0.0100708
END
$hits2 << END
3.06683 7.62939e-06
3.54869 7.62939e-06
2.73452 7.62939e-06
3.23654 7.62939e-06
3.06055 7.62939e-06
3.71053 7.62939e-06
2.81737 7.62939e-06
3.10194 7.62939e-06
1.87598 7.62939e-06
2.14149 7.62939e-06
2.23625 7.62939e-06
2.51134 7.62939e-06
2.69638 7.62939e-06
3.17043 7.62939e-06
2.05312 7.62939e-06
2.44069 7.62939e-06
1.95976 7.62939e-06
2.37386 7.62939e-06
4.7012 7.62939e-06
5.61413 7.62939e-06
0.645208 7.62939e-06
1.76512 7.62939e-06
4.27168 7.62939e-06
2.05566 7.62939e-06
2.33901 7.62939e-06
END
$hits3 << END
3.38488 0.00662231
3.84222 0.00582886
2.91302 0.0233154
3.31301 0.00970459
3.37693 0.021698
3.7857 0.0115967
2.22068 0.00662231
3.4319 0.00582886
1.98335 0.0233154
2.2355 0.00970459
2.35889 0.021698
2.75808 0.0115967
2.76312 0.00762939
3.4404 0.00596619
2.28227 0.0183563
2.42386 0.016861
2.12799 0.0166779
2.52017 0.0120697
5.44222 0.0207062
6.07717 0.00984192
END
$hits4 << END
2.92698 5.6514e-06
3.36285 5.6514e-06
2.70511 5.6514e-06
3.13201 5.6514e-06
3.05414 5.6514e-06
3.57622 5.6514e-06
2.68802 5.6514e-06
3.04584 5.6514e-06
1.90806 5.6514e-06
2.1823 5.6514e-06
2.00349 5.6514e-06
2.60836 5.6514e-06
2.55144 5.6514e-06
3.06524 5.6514e-06
1.9775 5.6514e-06
2.39699 5.6514e-06
1.82802 5.6514e-06
2.25465 5.6514e-06
4.60933 5.6514e-06
5.76275 5.6514e-06
END
$hits5 << END
2.72814 0.00662231
3.5421 0.00582886
2.90292 0.0233154
3.27911 0.00971985
3.34685 0.021698
3.7947 0.0115967
2.86262 0.00662231
3.24585 0.00582886
2.00586 0.0233154
2.16842 0.00970459
2.42362 0.021698
2.7237 0.0115967
2.87924 0.00762939
3.1424 0.00596619
2.09723 0.0183716
2.58675 0.0168762
2.00492 0.0166779
2.34154 0.0120697
5.42964 0.0207062
6.07362 0.00984192
END
$hits_front << END
5.76275 5.6514e-06
6.07717 0.00984192
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
set xrange [4.15914:49.901]; set yrange [3.10143e-05:0.137335]
set xlabel 'pictures a second  (more is better)'; set ylabel 'picture: RMSE of a channel  (less is better)' offset -1.5
set xtics ('5' 5, '7' 7, '10' 10, '15' 15, '20' 20, '30' 30)
set ytics ("same\nbits" 7.75359e-05, '10⁻³' 1e-3, '10⁻²' 1e-2, '10⁻¹' 1e-1)
set object rectangle from graph 0, graph 0 to graph 1, first 0.000131811 fs solid noborder fc rgb '#eeeeee' behind
set arrow from first 41.5842,0.031186 to graph 1.0,0.8234 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.8234 to graph 1.015,0.8234 nohead lw 0.8 lc rgb '#999999'
set label 'double, study: irregular exact' at graph 1.02,0.8234 left
set arrow from first 39.6084,5.7434e-05 to graph 1.0,0.0734 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.0734 to graph 1.015,0.0734 nohead lw 0.8 lc rgb '#999999'
set label 'double: irregular exact' at graph 1.02,0.0734 left
$picture0 << END
14.1993 0.0245371
16.5748 0.0245371
19.2222 0.0245371
25.867 0.0245371
19.0556 0.0245371
27.5643 0.0245371
13.2862 0.0245371
15.6986 0.0245371
14.6335 0.0245371
18.2721 0.0245371
16.9302 0.0245371
19.2489 0.0245371
13.5848 0.0245371
15.5617 0.0245371
11.5833 0.0245371
14.8607 0.0245371
10.7781 0.0245371
13.966 0.0245371
28.6274 0.0245371
37.9321 0.0245371
END
$picture1 << END
14.4236 0.0325513
17.1502 0.0309071
20.6645 0.0549339
26.2812 0.0378821
21.517 0.0510348
28.6521 0.0400519
13.635 0.0325513
15.4701 0.0309071
15.8827 0.0549339
18.2842 0.0378821
15.968 0.0510348
22.3719 0.0400519
13.6573 0.0325541
16.2132 0.0309071
11.9435 0.0430485
15.2054 0.0427338
10.9817 0.0450923
12.568 0.0387686
30.5124 0.0516064
37.3354 0.0389731
END
$picture2 << END
21.5702 0.000620287
25.3885 0.000620287
21.3658 0.000620287
26.1314 0.000620287
23.6964 0.000620287
28.543 0.000620287
20.8821 0.000620287
22.9736 0.000620287
15.7827 0.000620287
17.8843 0.000620287
18.624 0.000620287
21.2675 0.000620287
20.6243 0.000620287
23.2539 0.000620287
18.0407 0.000620287
21.2025 0.000620287
16.7449 0.000620287
19.3506 0.000620287
33.2176 0.000620287
38.8435 0.000620287
4.99097 0.000620287
12.6004 0.000620287
30.0957 0.000620287
18.1533 0.000620287
18.9267 0.000620287
END
$picture3 << END
23.5497 0.0224825
26.4222 0.019705
22.577 0.0500998
26.1399 0.0290847
24.8569 0.0457432
29.2005 0.0323349
21.5082 0.0224825
24.4323 0.019705
16.4432 0.0500998
18.5049 0.0290847
16.9133 0.0457432
22.8321 0.0323349
19.9801 0.0224865
24.8871 0.019705
19.2668 0.0360749
22.0368 0.035728
15.358 0.0385456
20.4899 0.0307357
35.5987 0.0463306
41.5167 0.0311935
END
$picture4 << END
21.3773 5.7434e-05
24.5885 5.7434e-05
21.784 5.7434e-05
26.0764 5.7434e-05
23.8571 5.7434e-05
28.4574 5.7434e-05
20.4217 5.7434e-05
22.3568 5.7434e-05
15.908 5.7434e-05
18.3623 5.7434e-05
18.5643 5.7434e-05
21.8956 5.7434e-05
20.7572 5.7434e-05
23.0999 5.7434e-05
16.9836 5.7434e-05
21.2312 5.7434e-05
16.6667 5.7434e-05
19.0712 5.7434e-05
33.051 5.7434e-05
39.6084 5.7434e-05
END
$picture5 << END
22.4868 0.0224738
25.1882 0.0196934
23.0114 0.0500977
26.7405 0.0290847
25.1217 0.0457408
29.1887 0.0323289
20.8265 0.0224738
23.7362 0.0196934
16.4576 0.0500977
18.0036 0.0290894
18.2878 0.0457408
22.0068 0.0323289
20.7111 0.0224779
23.3719 0.0196934
18.7031 0.0360477
21.8176 0.0358389
16.7989 0.0385421
19.7501 0.0307286
35.7182 0.046329
41.5842 0.031186
END
$picture_front << END
39.6084 5.7434e-05
41.5842 0.031186
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
set xrange [0.537673:7.2926]; set yrange [3.05176e-06:0.0588608]
set xlabel 'million nearest hits a second  (more is better)'; set ylabel 'wrong hits  (less is better)' offset -1.5
set label 'rings: speed against accuracy (CPU, 2 threads)' at screen 0.02, screen 0.9774 font ',20'
set label '256x256 primary and 65,536 random rays a scene; 65,536 in all compared with brute force in double; pictures of 128x128' at screen 0.02, screen 0.9516
set xtics ('0.7' 0.7, '1' 1, '1.5' 1.5, '2' 2, '3' 3, '5' 5, '7' 7)
set ytics ("none of\n65,536" 7.62939e-06, '0.01 %%' 1e-4, '0.1 %%' 1e-3, '1 %%' 1e-2)
set object rectangle from graph 0, graph 0 to graph 1, first 1.297e-05 fs solid noborder fc rgb '#eeeeee' behind
set arrow from first 6.07717,0.00984192 to graph 1.0,0.8187 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.8187 to graph 1.015,0.8187 nohead lw 0.8 lc rgb '#999999'
set label 'robust, study: irregular exact' at graph 1.02,0.8187 left
set arrow from first 5.76275,5.6514e-06 to graph 1.0,0.0624 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.0624 to graph 1.015,0.0624 nohead lw 0.8 lc rgb '#999999'
set label 'double: irregular exact' at graph 1.02,0.0624 left
$hits0 << END
1.8565 0.000259399
2.17145 0.000259399
2.23456 0.000259399
3.20463 0.000259399
2.57567 0.000259399
3.57276 0.000259399
1.69004 0.000259399
2.02051 0.000259399
1.74413 0.000259399
2.16879 0.000259399
2.08759 0.000259399
2.36174 0.000259399
1.70656 0.000259399
2.02187 0.000259399
1.18986 0.000259399
1.56405 0.000259399
1.13381 0.000259399
1.51187 0.000259399
4.1798 0.000259399
5.63534 0.000259399
END
$hits1 << END
1.9188 0.00686646
2.18773 0.00610352
2.67658 0.0235443
3.23261 0.00991821
2.7751 0.0219116
3.6949 0.0118256
1.77732 0.00686646
2.08871 0.00610352
1.88328 0.0235443
2.22803 0.00991821
2.21781 0.0219116
2.58821 0.0118256
1.71092 0.00785828
2.11814 0.00624084
1.22431 0.0185242
1.63926 0.0170288
1.18155 0.0169067
1.56502 0.0122986
4.72169 0.0209045
5.85888 0.0100708
END
$hits2 << END
3.06683 7.62939e-06
3.54869 7.62939e-06
2.73452 7.62939e-06
3.23654 7.62939e-06
3.06055 7.62939e-06
3.71053 7.62939e-06
2.81737 7.62939e-06
3.10194 7.62939e-06
1.87598 7.62939e-06
2.14149 7.62939e-06
2.23625 7.62939e-06
2.51134 7.62939e-06
2.69638 7.62939e-06
3.17043 7.62939e-06
2.05312 7.62939e-06
2.44069 7.62939e-06
1.95976 7.62939e-06
2.37386 7.62939e-06
4.7012 7.62939e-06
5.61413 7.62939e-06
0.645208 7.62939e-06
1.76512 7.62939e-06
4.27168 7.62939e-06
2.05566 7.62939e-06
2.33901 7.62939e-06
END
$hits3 << END
3.38488 0.00662231
3.84222 0.00582886
2.91302 0.0233154
3.31301 0.00970459
3.37693 0.021698
3.7857 0.0115967
2.22068 0.00662231
3.4319 0.00582886
1.98335 0.0233154
2.2355 0.00970459
2.35889 0.021698
2.75808 0.0115967
2.76312 0.00762939
3.4404 0.00596619
2.28227 0.0183563
2.42386 0.016861
2.12799 0.0166779
2.52017 0.0120697
5.44222 0.0207062
6.07717 0.00984192
END
$hits4 << END
2.92698 5.6514e-06
3.36285 5.6514e-06
2.70511 5.6514e-06
3.13201 5.6514e-06
3.05414 5.6514e-06
3.57622 5.6514e-06
2.68802 5.6514e-06
3.04584 5.6514e-06
1.90806 5.6514e-06
2.1823 5.6514e-06
2.00349 5.6514e-06
2.60836 5.6514e-06
2.55144 5.6514e-06
3.06524 5.6514e-06
1.9775 5.6514e-06
2.39699 5.6514e-06
1.82802 5.6514e-06
2.25465 5.6514e-06
4.60933 5.6514e-06
5.76275 5.6514e-06
END
$hits5 << END
2.72814 0.00662231
3.5421 0.00582886
2.90292 0.0233154
3.27911 0.00971985
3.34685 0.021698
3.7947 0.0115967
2.86262 0.00662231
3.24585 0.00582886
2.00586 0.0233154
2.16842 0.00970459
2.42362 0.021698
2.7237 0.0115967
2.87924 0.00762939
3.1424 0.00596619
2.09723 0.0183716
2.58675 0.0168762
2.00492 0.0166779
2.34154 0.0120697
5.42964 0.0207062
6.07362 0.00984192
END
$hits_front << END
5.76275 5.6514e-06
6.07717 0.00984192
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
set xrange [4.15914:49.901]; set yrange [3.10143e-05:0.137335]
set xlabel 'pictures a second  (more is better)'; set ylabel 'picture: RMSE of a channel  (less is better)' offset -1.5
set xtics ('5' 5, '7' 7, '10' 10, '15' 15, '20' 20, '30' 30)
set ytics ("same\nbits" 7.75359e-05, '10⁻³' 1e-3, '10⁻²' 1e-2, '10⁻¹' 1e-1)
set object rectangle from graph 0, graph 0 to graph 1, first 0.000131811 fs solid noborder fc rgb '#eeeeee' behind
set arrow from first 41.5842,0.031186 to graph 1.0,0.8234 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.8234 to graph 1.015,0.8234 nohead lw 0.8 lc rgb '#999999'
set label 'double, study: irregular exact' at graph 1.02,0.8234 left
set arrow from first 39.6084,5.7434e-05 to graph 1.0,0.0734 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.0734 to graph 1.015,0.0734 nohead lw 0.8 lc rgb '#999999'
set label 'double: irregular exact' at graph 1.02,0.0734 left
$picture0 << END
14.1993 0.0245371
16.5748 0.0245371
19.2222 0.0245371
25.867 0.0245371
19.0556 0.0245371
27.5643 0.0245371
13.2862 0.0245371
15.6986 0.0245371
14.6335 0.0245371
18.2721 0.0245371
16.9302 0.0245371
19.2489 0.0245371
13.5848 0.0245371
15.5617 0.0245371
11.5833 0.0245371
14.8607 0.0245371
10.7781 0.0245371
13.966 0.0245371
28.6274 0.0245371
37.9321 0.0245371
END
$picture1 << END
14.4236 0.0325513
17.1502 0.0309071
20.6645 0.0549339
26.2812 0.0378821
21.517 0.0510348
28.6521 0.0400519
13.635 0.0325513
15.4701 0.0309071
15.8827 0.0549339
18.2842 0.0378821
15.968 0.0510348
22.3719 0.0400519
13.6573 0.0325541
16.2132 0.0309071
11.9435 0.0430485
15.2054 0.0427338
10.9817 0.0450923
12.568 0.0387686
30.5124 0.0516064
37.3354 0.0389731
END
$picture2 << END
21.5702 0.000620287
25.3885 0.000620287
21.3658 0.000620287
26.1314 0.000620287
23.6964 0.000620287
28.543 0.000620287
20.8821 0.000620287
22.9736 0.000620287
15.7827 0.000620287
17.8843 0.000620287
18.624 0.000620287
21.2675 0.000620287
20.6243 0.000620287
23.2539 0.000620287
18.0407 0.000620287
21.2025 0.000620287
16.7449 0.000620287
19.3506 0.000620287
33.2176 0.000620287
38.8435 0.000620287
4.99097 0.000620287
12.6004 0.000620287
30.0957 0.000620287
18.1533 0.000620287
18.9267 0.000620287
END
$picture3 << END
23.5497 0.0224825
26.4222 0.019705
22.577 0.0500998
26.1399 0.0290847
24.8569 0.0457432
29.2005 0.0323349
21.5082 0.0224825
24.4323 0.019705
16.4432 0.0500998
18.5049 0.0290847
16.9133 0.0457432
22.8321 0.0323349
19.9801 0.0224865
24.8871 0.019705
19.2668 0.0360749
22.0368 0.035728
15.358 0.0385456
20.4899 0.0307357
35.5987 0.0463306
41.5167 0.0311935
END
$picture4 << END
21.3773 5.7434e-05
24.5885 5.7434e-05
21.784 5.7434e-05
26.0764 5.7434e-05
23.8571 5.7434e-05
28.4574 5.7434e-05
20.4217 5.7434e-05
22.3568 5.7434e-05
15.908 5.7434e-05
18.3623 5.7434e-05
18.5643 5.7434e-05
21.8956 5.7434e-05
20.7572 5.7434e-05
23.0999 5.7434e-05
16.9836 5.7434e-05
21.2312 5.7434e-05
16.6667 5.7434e-05
19.0712 5.7434e-05
33.051 5.7434e-05
39.6084 5.7434e-05
END
$picture5 << END
22.4868 0.0224738
25.1882 0.0196934
23.0114 0.0500977
26.7405 0.0290847
25.1217 0.0457408
29.1887 0.0323289
20.8265 0.0224738
23.7362 0.0196934
16.4576 0.0500977
18.0036 0.0290894
18.2878 0.0457408
22.0068 0.0323289
20.7111 0.0224779
23.3719 0.0196934
18.7031 0.0360477
21.8176 0.0358389
16.7989 0.0385421
19.7501 0.0307286
35.7182 0.046329
41.5842 0.031186
END
$picture_front << END
39.6084 5.7434e-05
41.5842 0.031186
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
set xrange [0.937275:15.5436]; set yrange [3.05176e-06:0.00114441]
set xlabel 'million nearest hits a second  (more is better)'; set ylabel 'wrong hits  (less is better)' offset -1.5
set label 'teapot: speed against accuracy (CPU, 2 threads)' at screen 0.02, screen 0.9774 font ',20'
set label '256x256 primary and 65,536 random rays a scene; 65,536 in all compared with brute force in double; pictures of 128x128' at screen 0.02, screen 0.9516
set xtics ('1' 1, '1.5' 1.5, '2' 2, '3' 3, '5' 5, '7' 7, '10' 10, '15' 15)
set ytics ("none of\n65,536" 7.62939e-06, '0.01 %%' 1e-4, '0.1 %%' 1e-3)
set object rectangle from graph 0, graph 0 to graph 1, first 1.297e-05 fs solid noborder fc rgb '#eeeeee' behind
set arrow from first 12.953,0.000137329 to graph 1.0,0.6423 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.6423 to graph 1.015,0.6423 nohead lw 0.8 lc rgb '#999999'
set label 'double, study: irregular exact' at graph 1.02,0.6423 left
set arrow from first 11.4162,5.6514e-06 to graph 1.0,0.1040 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.1040 to graph 1.015,0.1040 nohead lw 0.8 lc rgb '#999999'
set label 'double: irregular exact' at graph 1.02,0.1040 left
$hits0 << END
6.00388 1.52588e-05
6.1337 1.52588e-05
4.35134 1.52588e-05
4.50591 1.52588e-05
5.08037 1.52588e-05
5.29885 1.52588e-05
5.33625 1.52588e-05
5.43607 1.52588e-05
2.43797 1.52588e-05
2.45963 1.52588e-05
3.70776 1.52588e-05
3.79832 1.52588e-05
5.25526 1.52588e-05
5.37369 1.52588e-05
3.20513 1.52588e-05
3.15528 1.52588e-05
4.19711 1.52588e-05
4.17108 1.52588e-05
10.2376 1.52588e-05
10.6318 1.52588e-05
END
$hits1 << END
4.98443 0.000457764
5.21906 0.000457764
4.33786 0.00038147
4.16731 0.000396729
4.87659 0.000366211
5.14134 0.000198364
3.6469 0.000457764
4.46288 0.000457764
2.5699 0.00038147
2.48881 0.000396729
3.66759 0.000366211
3.74809 0.000198364
4.22115 0.000457764
4.3946 0.000457764
2.51965 0.000350952
2.5116 0.000427246
3.38503 0.000305176
3.37356 0.000167847
10.6064 0.000320435
10.8732 0.000152588
END
$hits2 << END
6.68351 7.62939e-06
6.94297 7.62939e-06
4.32265 7.62939e-06
4.45906 7.62939e-06
5.30632 7.62939e-06
5.45433 7.62939e-06
5.65059 7.62939e-06
5.73254 7.62939e-06
2.50649 7.62939e-06
2.55031 7.62939e-06
3.62189 7.62939e-06
3.81995 7.62939e-06
5.62334 7.62939e-06
5.95899 7.62939e-06
3.34716 7.62939e-06
3.39598 7.62939e-06
4.01979 7.62939e-06
4.15315 7.62939e-06
10.4891 7.62939e-06
11.1362 7.62939e-06
1.12473 7.62939e-06
3.53222 7.62939e-06
6.61963 7.62939e-06
2.3928 7.62939e-06
3.7241 7.62939e-06
END
$hits3 << END
7.06751 0.000442505
7.16219 0.000442505
4.45335 0.000366211
4.61369 0.00038147
5.51875 0.000350952
5.74913 0.000183105
6.15084 0.000442505
6.15657 0.000442505
2.53294 0.000366211
2.61695 0.00038147
4.01951 0.000350952
4.02581 0.000183105
5.99255 0.000442505
6.15226 0.000442505
3.28177 0.000335693
3.50034 0.000411987
4.11482 0.000289917
4.31755 0.000152588
11.8908 0.000305176
12.4893 0.000137329
END
$hits4 << END
6.17371 5.6514e-06
6.25191 5.6514e-06
4.37718 5.6514e-06
4.54937 5.6514e-06
4.76745 5.6514e-06
5.63891 5.6514e-06
5.41316 5.6514e-06
5.5185 5.6514e-06
2.48139 5.6514e-06
2.54499 5.6514e-06
3.73382 5.6514e-06
3.90906 5.6514e-06
5.43591 5.6514e-06
5.42779 5.6514e-06
3.11723 5.6514e-06
3.11158 5.6514e-06
3.70471 5.6514e-06
3.89796 5.6514e-06
10.7785 5.6514e-06
11.4162 5.6514e-06
END
$hits5 << END
6.4204 0.000442505
6.63206 0.000442505
4.54254 0.000366211
4.58161 0.00038147
5.46084 0.000350952
5.64474 0.000183105
5.76901 0.000442505
5.95866 0.000442505
2.55695 0.000366211
2.63186 0.00038147
3.98587 0.000350952
4.10161 0.000183105
5.71446 0.000442505
5.55888 0.000442505
3.24086 0.000335693
3.25125 0.000411987
3.9144 0.000289917
4.11313 0.000152588
12.3354 0.000305176
12.953 0.000137329
END
$hits_front << END
11.4162 5.6514e-06
12.953 0.000137329
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
set xrange [10.2157:139.064]; set yrange [6.2213e-08:0.0179018]
set xlabel 'pictures a second  (more is better)'; set ylabel 'picture: RMSE of a channel  (less is better)' offset -1.5
set xtics ('15' 15, '20' 20, '30' 30, '50' 50, '70' 70, '100' 100)
set ytics ("same\nbits" 1.55533e-07, '10⁻⁶' 1e-6, '10⁻⁵' 1e-5, '10⁻⁴' 1e-4, '10⁻³' 1e-3, '10⁻²' 1e-2)
set object rectangle from graph 0, graph 0 to graph 1, first 2.64405e-07 fs solid noborder fc rgb '#eeeeee' behind
set arrow from first 115.886,0.00231555 to graph 1.0,0.8373 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.8373 to graph 1.015,0.8373 nohead lw 0.8 lc rgb '#999999'
set label 'double, study: irregular exact' at graph 1.02,0.8373 left
set arrow from first 111.911,1.15209e-07 to graph 1.0,0.0490 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.0490 to graph 1.015,0.0490 nohead lw 0.8 lc rgb '#999999'
set label 'double: irregular exact' at graph 1.02,0.0490 left
$picture0 << END
54.6072 0.000386076
55.2389 0.000386076
41.9671 0.000386076
43.7181 0.000386076
53.8831 0.000386076
56.3978 0.000386076
48.6284 0.000386076
49.1439 0.000386076
25.9221 0.000386076
25.5631 0.000386076
39.5911 0.000386076
40.2207 0.000386076
48.6098 0.000386076
33.6185 0.000386076
31.1262 0.000386076
29.1903 0.000386076
39.9778 0.000386076
40.1976 0.000386076
97.5286 0.000386076
103.401 0.000386076
END
$picture1 << END
40.5254 0.00676137
43.4111 0.00676137
40.6205 0.0071607
43.2899 0.00713817
52.4301 0.00709362
54.6212 0.00356432
39.1572 0.00676137
39.3943 0.00676137
24.5289 0.0071607
25.6054 0.00713817
37.8441 0.00709362
38.2278 0.00356432
38.0573 0.00676137
38.6203 0.00676137
25.1426 0.00596842
23.7383 0.00531404
28.5887 0.00426532
33.232 0.00207633
89.3312 0.00584577
93.9443 0.00234752
END
$picture2 << END
63.572 1.24426e-06
66.1419 1.24426e-06
41.4297 1.24426e-06
44.7571 1.24426e-06
55.1514 1.24426e-06
58.534 1.24426e-06
58.3107 1.24426e-06
58.4594 1.24426e-06
26.4696 1.24426e-06
23.7176 1.24426e-06
38.9801 1.24426e-06
41.7585 1.24426e-06
56.7237 1.24426e-06
59.6588 1.24426e-06
30.7134 1.24426e-06
31.369 1.24426e-06
38.7426 1.24426e-06
41.9405 1.24426e-06
102.188 1.24426e-06
109.982 1.24426e-06
12.2589 1.24426e-06
36.0141 1.24426e-06
64.0931 1.24426e-06
21.4676 1.24426e-06
36.4067 1.24426e-06
END
$picture3 << END
65.4939 0.00675033
50.8934 0.00675033
42.755 0.00715028
44.6614 0.00712772
56.4541 0.0070831
59.6887 0.00354334
59.5646 0.00675033
57.4848 0.00675033
27.0251 0.00715028
27.3575 0.00712772
41.9824 0.0070831
42.9301 0.00354334
58.7392 0.00675033
58.9355 0.00675033
30.6732 0.00595591
31.1368 0.0053
39.6772 0.00424781
40.8503 0.00204012
107.224 0.005833
113.446 0.00231555
END
$picture4 << END
61.6599 1.15209e-07
63.7206 1.15209e-07
45.0339 1.15209e-07
46.3549 1.15209e-07
56.8195 1.15209e-07
60.7552 1.15209e-07
53.9258 1.15209e-07
56.0243 1.15209e-07
26.7389 1.15209e-07
27.4191 1.15209e-07
40.3616 1.15209e-07
42.0094 1.15209e-07
53.4785 1.15209e-07
54.2614 1.15209e-07
28.4163 1.15209e-07
28.9241 1.15209e-07
37.1588 1.15209e-07
39.311 1.15209e-07
103.756 1.15209e-07
111.911 1.15209e-07
END
$picture5 << END
62.9144 0.00675033
64.7178 0.00675033
44.8718 0.00715028
46.4414 0.00712772
57.3901 0.00708309
60.1888 0.00354334
54.9976 0.00675033
46.1896 0.00675033
26.924 0.00715028
27.2176 0.00712772
41.4673 0.00708309
41.4752 0.00354334
54.997 0.00675033
55.1298 0.00675033
28.6776 0.00595591
29.6251 0.0053
38.4956 0.00424781
39.8995 0.00204011
108.079 0.005833
115.886 0.00231555
END
$picture_front << END
111.911 1.15209e-07
115.886 0.00231555
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
set xrange [0.937275:15.5436]; set yrange [3.05176e-06:0.00114441]
set xlabel 'million nearest hits a second  (more is better)'; set ylabel 'wrong hits  (less is better)' offset -1.5
set label 'teapot: speed against accuracy (CPU, 2 threads)' at screen 0.02, screen 0.9774 font ',20'
set label '256x256 primary and 65,536 random rays a scene; 65,536 in all compared with brute force in double; pictures of 128x128' at screen 0.02, screen 0.9516
set xtics ('1' 1, '1.5' 1.5, '2' 2, '3' 3, '5' 5, '7' 7, '10' 10, '15' 15)
set ytics ("none of\n65,536" 7.62939e-06, '0.01 %%' 1e-4, '0.1 %%' 1e-3)
set object rectangle from graph 0, graph 0 to graph 1, first 1.297e-05 fs solid noborder fc rgb '#eeeeee' behind
set arrow from first 12.953,0.000137329 to graph 1.0,0.6423 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.6423 to graph 1.015,0.6423 nohead lw 0.8 lc rgb '#999999'
set label 'double, study: irregular exact' at graph 1.02,0.6423 left
set arrow from first 11.4162,5.6514e-06 to graph 1.0,0.1040 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.1040 to graph 1.015,0.1040 nohead lw 0.8 lc rgb '#999999'
set label 'double: irregular exact' at graph 1.02,0.1040 left
$hits0 << END
6.00388 1.52588e-05
6.1337 1.52588e-05
4.35134 1.52588e-05
4.50591 1.52588e-05
5.08037 1.52588e-05
5.29885 1.52588e-05
5.33625 1.52588e-05
5.43607 1.52588e-05
2.43797 1.52588e-05
2.45963 1.52588e-05
3.70776 1.52588e-05
3.79832 1.52588e-05
5.25526 1.52588e-05
5.37369 1.52588e-05
3.20513 1.52588e-05
3.15528 1.52588e-05
4.19711 1.52588e-05
4.17108 1.52588e-05
10.2376 1.52588e-05
10.6318 1.52588e-05
END
$hits1 << END
4.98443 0.000457764
5.21906 0.000457764
4.33786 0.00038147
4.16731 0.000396729
4.87659 0.000366211
5.14134 0.000198364
3.6469 0.000457764
4.46288 0.000457764
2.5699 0.00038147
2.48881 0.000396729
3.66759 0.000366211
3.74809 0.000198364
4.22115 0.000457764
4.3946 0.000457764
2.51965 0.000350952
2.5116 0.000427246
3.38503 0.000305176
3.37356 0.000167847
10.6064 0.000320435
10.8732 0.000152588
END
$hits2 << END
6.68351 7.62939e-06
6.94297 7.62939e-06
4.32265 7.62939e-06
4.45906 7.62939e-06
5.30632 7.62939e-06
5.45433 7.62939e-06
5.65059 7.62939e-06
5.73254 7.62939e-06
2.50649 7.62939e-06
2.55031 7.62939e-06
3.62189 7.62939e-06
3.81995 7.62939e-06
5.62334 7.62939e-06
5.95899 7.62939e-06
3.34716 7.62939e-06
3.39598 7.62939e-06
4.01979 7.62939e-06
4.15315 7.62939e-06
10.4891 7.62939e-06
11.1362 7.62939e-06
1.12473 7.62939e-06
3.53222 7.62939e-06
6.61963 7.62939e-06
2.3928 7.62939e-06
3.7241 7.62939e-06
END
$hits3 << END
7.06751 0.000442505
7.16219 0.000442505
4.45335 0.000366211
4.61369 0.00038147
5.51875 0.000350952
5.74913 0.000183105
6.15084 0.000442505
6.15657 0.000442505
2.53294 0.000366211
2.61695 0.00038147
4.01951 0.000350952
4.02581 0.000183105
5.99255 0.000442505
6.15226 0.000442505
3.28177 0.000335693
3.50034 0.000411987
4.11482 0.000289917
4.31755 0.000152588
11.8908 0.000305176
12.4893 0.000137329
END
$hits4 << END
6.17371 5.6514e-06
6.25191 5.6514e-06
4.37718 5.6514e-06
4.54937 5.6514e-06
4.76745 5.6514e-06
5.63891 5.6514e-06
5.41316 5.6514e-06
5.5185 5.6514e-06
2.48139 5.6514e-06
2.54499 5.6514e-06
3.73382 5.6514e-06
3.90906 5.6514e-06
5.43591 5.6514e-06
5.42779 5.6514e-06
3.11723 5.6514e-06
3.11158 5.6514e-06
3.70471 5.6514e-06
3.89796 5.6514e-06
10.7785 5.6514e-06
11.4162 5.6514e-06
END
$hits5 << END
6.4204 0.000442505
6.63206 0.000442505
4.54254 0.000366211
4.58161 0.00038147
5.46084 0.000350952
5.64474 0.000183105
5.76901 0.000442505
5.95866 0.000442505
2.55695 0.000366211
2.63186 0.00038147
3.98587 0.000350952
4.10161 0.000183105
5.71446 0.000442505
5.55888 0.000442505
3.24086 0.000335693
3.25125 0.000411987
3.9144 0.000289917
4.11313 0.000152588
12.3354 0.000305176
12.953 0.000137329
END
$hits_front << END
11.4162 5.6514e-06
12.953 0.000137329
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
set xrange [10.2157:139.064]; set yrange [6.2213e-08:0.0179018]
set xlabel 'pictures a second  (more is better)'; set ylabel 'picture: RMSE of a channel  (less is better)' offset -1.5
set xtics ('15' 15, '20' 20, '30' 30, '50' 50, '70' 70, '100' 100)
set ytics ("same\nbits" 1.55533e-07, '10⁻⁶' 1e-6, '10⁻⁵' 1e-5, '10⁻⁴' 1e-4, '10⁻³' 1e-3, '10⁻²' 1e-2)
set object rectangle from graph 0, graph 0 to graph 1, first 2.64405e-07 fs solid noborder fc rgb '#eeeeee' behind
set arrow from first 115.886,0.00231555 to graph 1.0,0.8373 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.8373 to graph 1.015,0.8373 nohead lw 0.8 lc rgb '#999999'
set label 'double, study: irregular exact' at graph 1.02,0.8373 left
set arrow from first 111.911,1.15209e-07 to graph 1.0,0.0490 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.0490 to graph 1.015,0.0490 nohead lw 0.8 lc rgb '#999999'
set label 'double: irregular exact' at graph 1.02,0.0490 left
$picture0 << END
54.6072 0.000386076
55.2389 0.000386076
41.9671 0.000386076
43.7181 0.000386076
53.8831 0.000386076
56.3978 0.000386076
48.6284 0.000386076
49.1439 0.000386076
25.9221 0.000386076
25.5631 0.000386076
39.5911 0.000386076
40.2207 0.000386076
48.6098 0.000386076
33.6185 0.000386076
31.1262 0.000386076
29.1903 0.000386076
39.9778 0.000386076
40.1976 0.000386076
97.5286 0.000386076
103.401 0.000386076
END
$picture1 << END
40.5254 0.00676137
43.4111 0.00676137
40.6205 0.0071607
43.2899 0.00713817
52.4301 0.00709362
54.6212 0.00356432
39.1572 0.00676137
39.3943 0.00676137
24.5289 0.0071607
25.6054 0.00713817
37.8441 0.00709362
38.2278 0.00356432
38.0573 0.00676137
38.6203 0.00676137
25.1426 0.00596842
23.7383 0.00531404
28.5887 0.00426532
33.232 0.00207633
89.3312 0.00584577
93.9443 0.00234752
END
$picture2 << END
63.572 1.24426e-06
66.1419 1.24426e-06
41.4297 1.24426e-06
44.7571 1.24426e-06
55.1514 1.24426e-06
58.534 1.24426e-06
58.3107 1.24426e-06
58.4594 1.24426e-06
26.4696 1.24426e-06
23.7176 1.24426e-06
38.9801 1.24426e-06
41.7585 1.24426e-06
56.7237 1.24426e-06
59.6588 1.24426e-06
30.7134 1.24426e-06
31.369 1.24426e-06
38.7426 1.24426e-06
41.9405 1.24426e-06
102.188 1.24426e-06
109.982 1.24426e-06
12.2589 1.24426e-06
36.0141 1.24426e-06
64.0931 1.24426e-06
21.4676 1.24426e-06
36.4067 1.24426e-06
END
$picture3 << END
65.4939 0.00675033
50.8934 0.00675033
42.755 0.00715028
44.6614 0.00712772
56.4541 0.0070831
59.6887 0.00354334
59.5646 0.00675033
57.4848 0.00675033
27.0251 0.00715028
27.3575 0.00712772
41.9824 0.0070831
42.9301 0.00354334
58.7392 0.00675033
58.9355 0.00675033
30.6732 0.00595591
31.1368 0.0053
39.6772 0.00424781
40.8503 0.00204012
107.224 0.005833
113.446 0.00231555
END
$picture4 << END
61.6599 1.15209e-07
63.7206 1.15209e-07
45.0339 1.15209e-07
46.3549 1.15209e-07
56.8195 1.15209e-07
60.7552 1.15209e-07
53.9258 1.15209e-07
56.0243 1.15209e-07
26.7389 1.15209e-07
27.4191 1.15209e-07
40.3616 1.15209e-07
42.0094 1.15209e-07
53.4785 1.15209e-07
54.2614 1.15209e-07
28.4163 1.15209e-07
28.9241 1.15209e-07
37.1588 1.15209e-07
39.311 1.15209e-07
103.756 1.15209e-07
111.911 1.15209e-07
END
$picture5 << END
62.9144 0.00675033
64.7178 0.00675033
44.8718 0.00715028
46.4414 0.00712772
57.3901 0.00708309
60.1888 0.00354334
54.9976 0.00675033
46.1896 0.00675033
26.924 0.00715028
27.2176 0.00712772
41.4673 0.00708309
41.4752 0.00354334
54.997 0.00675033
55.1298 0.00675033
28.6776 0.00595591
29.6251 0.0053
38.4956 0.00424781
39.8995 0.00204011
108.079 0.005833
115.886 0.00231555
END
$picture_front << END
111.911 1.15209e-07
115.886 0.00231555
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
set xrange [0.519645:11.6602]; set yrange [3.05176e-06:0.00175476]
set xlabel 'million nearest hits a second  (more is better)'; set ylabel 'wrong hits  (less is better)' offset -1.5
set label 'tetra: speed against accuracy (CPU, 2 threads)' at screen 0.02, screen 0.9774 font ',20'
set label '256x256 primary and 65,536 random rays a scene; 65,536 in all compared with brute force in double; pictures of 128x128' at screen 0.02, screen 0.9516
set xtics ('1' 1, '2' 2, '5' 5, '10' 10)
set ytics ("none of\n65,536" 7.62939e-06, '0.01 %%' 1e-4, '0.1 %%' 1e-3)
set object rectangle from graph 0, graph 0 to graph 1, first 1.297e-05 fs solid noborder fc rgb '#eeeeee' behind
set arrow from first 9.71685,3.05176e-05 to graph 1.0,0.3624 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.3624 to graph 1.015,0.3624 nohead lw 0.8 lc rgb '#999999'
set label 'robust, study: irregular exact' at graph 1.02,0.3624 left
set arrow from first 9.62346,7.62939e-06 to graph 1.0,0.1442 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.1442 to graph 1.015,0.1442 nohead lw 0.8 lc rgb '#999999'
set label 'robust, study: irregular box' at graph 1.02,0.1442 left
$hits0 << END
4.53441 1.02997e-05
4.39277 1.02997e-05
3.90809 1.02997e-05
4.1551 1.02997e-05
6.01832 1.02997e-05
6.13591 1.02997e-05
4.05237 1.02997e-05
3.946 1.02997e-05
2.47962 1.02997e-05
2.64788 1.02997e-05
4.78823 1.02997e-05
4.682 1.02997e-05
3.75719 1.02997e-05
3.55584 1.02997e-05
3.01072 1.02997e-05
2.0649 1.02997e-05
3.95927 1.02997e-05
3.28319 1.02997e-05
7.66386 1.02997e-05
7.7403 1.02997e-05
END
$hits1 << END
3.9261 1.02997e-05
3.98761 4.57764e-05
3.76391 1.02997e-05
4.13656 7.62939e-05
5.64541 1.02997e-05
5.99552 1.02997e-05
3.62121 1.02997e-05
3.64663 4.57764e-05
2.45469 1.02997e-05
2.67602 7.62939e-05
4.62221 1.02997e-05
4.65222 1.02997e-05
3.27255 1.02997e-05
3.33673 6.10352e-05
2.54363 1.02997e-05
1.78912 0.000701904
3.31592 1.02997e-05
2.79935 0.000442505
7.4406 1.02997e-05
7.50794 3.05176e-05
END
$hits2 << END
6.17432 7.62939e-06
6.41048 7.62939e-06
4.01886 7.62939e-06
4.44295 7.62939e-06
6.92033 7.62939e-06
7.24273 7.62939e-06
5.28356 7.62939e-06
5.51188 7.62939e-06
2.52073 7.62939e-06
2.76768 7.62939e-06
5.23391 7.62939e-06
5.0675 7.62939e-06
5.03918 7.62939e-06
5.36514 7.62939e-06
3.51296 7.62939e-06
2.82371 7.62939e-06
4.9521 7.62939e-06
4.56898 7.62939e-06
9.07304 7.62939e-06
8.72135 7.62939e-06
0.623574 7.62939e-06
1.92463 7.62939e-06
4.35907 7.62939e-06
6.00783 7.62939e-06
2.43902 7.62939e-06
2.55444 7.62939e-06
END
$hits3 << END
6.60592 7.62939e-06
6.89738 4.57764e-05
4.27974 7.62939e-06
4.58594 7.62939e-05
7.14168 7.62939e-06
7.37884 7.62939e-06
5.67153 7.62939e-06
5.92539 4.57764e-05
2.71454 7.62939e-06
2.87887 7.62939e-05
5.56713 7.62939e-06
5.1801 7.62939e-06
5.26647 7.62939e-06
5.7062 6.10352e-05
3.62671 7.62939e-06
2.92305 0.000701904
5.10166 7.62939e-06
4.68526 0.000442505
9.62346 7.62939e-06
9.71685 3.05176e-05
END
$hits4 << END
5.7349 5.6514e-06
6.12252 5.6514e-06
4.16733 5.6514e-06
4.42964 5.6514e-06
6.92436 5.6514e-06
7.08385 5.6514e-06
5.03635 5.6514e-06
5.29791 5.6514e-06
2.5821 5.6514e-06
2.73781 5.6514e-06
5.24125 5.6514e-06
5.30858 5.6514e-06
4.69188 5.6514e-06
5.04251 5.6514e-06
3.2049 5.6514e-06
2.60635 5.6514e-06
4.57568 5.6514e-06
4.24369 5.6514e-06
8.85658 5.6514e-06
9.18375 5.6514e-06
END
$hits5 << END
6.26215 5.6514e-06
6.60559 4.57764e-05
4.30673 5.6514e-06
4.58753 7.62939e-05
7.06428 5.6514e-06
7.32695 5.6514e-06
5.43082 5.6514e-06
5.68643 4.57764e-05
2.70008 5.6514e-06
2.84796 7.62939e-05
5.44524 5.6514e-06
5.60145 5.6514e-06
4.68177 5.6514e-06
5.33533 6.10352e-05
3.30543 5.6514e-06
2.61256 0.000701904
4.75558 5.6514e-06
4.3435 0.000442505
9.46467 5.6514e-06
9.62719 3.05176e-05
END
$hits_front << END
9.62346 7.62939e-06
9.71685 3.05176e-05
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
set xrange [23.3616:531.053]; set yrange [8.7478e-10:0.00543185]
set xlabel 'pictures a second  (more is better)'; set ylabel 'picture: RMSE of a channel  (less is better)' offset -1.5
set xtics ('50' 50, '100' 100, '200' 200, '500' 500)
set ytics ("same\nbits" 2.18695e-09, '10⁻⁸' 1e-8, '10⁻⁷' 1e-7, '10⁻⁶' 1e-6, '10⁻⁵' 1e-5, '10⁻⁴' 1e-4, '10⁻³' 1e-3)
set object rectangle from graph 0, graph 0 to graph 1, first 3.71782e-09 fs solid noborder fc rgb '#eeeeee' behind
set arrow from first 442.544,1.74956e-08 to graph 1.0,0.1915 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.1915 to graph 1.015,0.1915 nohead lw 0.8 lc rgb '#999999'
set label 'robust, study: irregular box' at graph 1.02,0.1915 left
set arrow from first 439.288,1.61996e-09 to graph 1.0,0.0394 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.0394 to graph 1.015,0.0394 nohead lw 0.8 lc rgb '#999999'
set label 'double, study: irregular exact' at graph 1.02,0.0394 left
$picture0 << END
270.97 4.25742e-07
249.303 4.25742e-07
234.942 4.25742e-07
243.106 4.25742e-07
353.962 4.25742e-07
335.711 4.25742e-07
234.562 4.25742e-07
220.239 4.25742e-07
134.98 4.25742e-07
142.229 4.25742e-07
256.205 4.25742e-07
242.534 4.25742e-07
225.262 4.25742e-07
211.164 4.25742e-07
190.458 4.25742e-07
68.4678 4.25742e-07
247.006 4.25742e-07
213.09 4.25742e-07
407.611 4.25742e-07
377.685 4.25742e-07
END
$picture1 << END
181.631 4.25742e-07
181.896 4.25742e-07
210.788 4.25742e-07
228.045 4.25742e-07
304.013 4.25742e-07
304.118 4.25742e-07
163.923 4.25742e-07
167.784 4.25742e-07
105.412 4.25742e-07
136.197 4.25742e-07
229.544 4.25742e-07
224.212 4.25742e-07
160.15 4.25742e-07
160.382 4.25742e-07
135.469 4.25742e-07
98.5241 0.00173156
176.502 4.25742e-07
150.486 0.00217274
360.862 4.25742e-07
343.374 4.25742e-07
END
$picture2 << END
281.916 1.74956e-08
289.407 1.74956e-08
218.474 1.74956e-08
241.171 1.74956e-08
348.607 1.74956e-08
364.788 1.74956e-08
241.506 1.74956e-08
257.544 1.74956e-08
132.872 1.74956e-08
144.948 1.74956e-08
256.405 1.74956e-08
253.73 1.74956e-08
235.371 1.74956e-08
253.27 1.74956e-08
192.351 1.74956e-08
153.256 1.74956e-08
251.879 1.74956e-08
243.242 1.74956e-08
424.834 1.74956e-08
419.533 1.74956e-08
28.034 1.74956e-08
81.0143 1.74956e-08
191.295 1.74956e-08
297.756 1.74956e-08
135.712 1.74956e-08
127.998 1.74956e-08
END
$picture3 << END
296.032 1.74956e-08
311.365 1.74956e-08
228.932 1.74956e-08
123.66 1.74956e-08
365.095 1.74956e-08
367.635 1.74956e-08
253.864 1.74956e-08
263.927 1.74956e-08
138.6 1.74956e-08
146.927 1.74956e-08
259.177 1.74956e-08
232.665 1.74956e-08
249.16 1.74956e-08
261.949 1.74956e-08
197.534 1.74956e-08
154.879 0.00173156
261.526 1.74956e-08
245.598 0.00217274
442.544 1.74956e-08
440.987 1.74956e-08
END
$picture4 << END
262.958 1.61996e-09
285.582 1.61996e-09
228.425 1.61996e-09
245.712 1.61996e-09
356.79 1.61996e-09
361.415 1.61996e-09
229.183 1.61996e-09
242.901 1.61996e-09
134.225 1.61996e-09
141.047 1.61996e-09
248.193 1.61996e-09
259.038 1.61996e-09
223.464 1.61996e-09
228.57 1.61996e-09
175.162 1.61996e-09
143.919 1.61996e-09
239.922 1.61996e-09
226.89 1.61996e-09
418.969 1.61996e-09
419.213 1.61996e-09
END
$picture5 << END
282.199 1.61996e-09
297.612 1.61996e-09
232.901 1.61996e-09
252.092 1.61996e-09
355.881 1.61996e-09
367.435 1.61996e-09
244.95 1.61996e-09
258.522 1.61996e-09
138.696 1.61996e-09
144.903 1.61996e-09
258.842 1.61996e-09
256.852 1.61996e-09
234.221 1.61996e-09
247.886 1.61996e-09
183.959 1.61996e-09
145.936 0.00173156
241.771 1.61996e-09
232.317 0.00217274
434.837 1.61996e-09
439.288 1.61996e-09
END
$picture_front << END
439.288 1.61996e-09
442.544 1.74956e-08
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
set xrange [0.519645:11.6602]; set yrange [3.05176e-06:0.00175476]
set xlabel 'million nearest hits a second  (more is better)'; set ylabel 'wrong hits  (less is better)' offset -1.5
set label 'tetra: speed against accuracy (CPU, 2 threads)' at screen 0.02, screen 0.9774 font ',20'
set label '256x256 primary and 65,536 random rays a scene; 65,536 in all compared with brute force in double; pictures of 128x128' at screen 0.02, screen 0.9516
set xtics ('1' 1, '2' 2, '5' 5, '10' 10)
set ytics ("none of\n65,536" 7.62939e-06, '0.01 %%' 1e-4, '0.1 %%' 1e-3)
set object rectangle from graph 0, graph 0 to graph 1, first 1.297e-05 fs solid noborder fc rgb '#eeeeee' behind
set arrow from first 9.71685,3.05176e-05 to graph 1.0,0.3624 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.3624 to graph 1.015,0.3624 nohead lw 0.8 lc rgb '#999999'
set label 'robust, study: irregular exact' at graph 1.02,0.3624 left
set arrow from first 9.62346,7.62939e-06 to graph 1.0,0.1442 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.1442 to graph 1.015,0.1442 nohead lw 0.8 lc rgb '#999999'
set label 'robust, study: irregular box' at graph 1.02,0.1442 left
$hits0 << END
4.53441 1.02997e-05
4.39277 1.02997e-05
3.90809 1.02997e-05
4.1551 1.02997e-05
6.01832 1.02997e-05
6.13591 1.02997e-05
4.05237 1.02997e-05
3.946 1.02997e-05
2.47962 1.02997e-05
2.64788 1.02997e-05
4.78823 1.02997e-05
4.682 1.02997e-05
3.75719 1.02997e-05
3.55584 1.02997e-05
3.01072 1.02997e-05
2.0649 1.02997e-05
3.95927 1.02997e-05
3.28319 1.02997e-05
7.66386 1.02997e-05
7.7403 1.02997e-05
END
$hits1 << END
3.9261 1.02997e-05
3.98761 4.57764e-05
3.76391 1.02997e-05
4.13656 7.62939e-05
5.64541 1.02997e-05
5.99552 1.02997e-05
3.62121 1.02997e-05
3.64663 4.57764e-05
2.45469 1.02997e-05
2.67602 7.62939e-05
4.62221 1.02997e-05
4.65222 1.02997e-05
3.27255 1.02997e-05
3.33673 6.10352e-05
2.54363 1.02997e-05
1.78912 0.000701904
3.31592 1.02997e-05
2.79935 0.000442505
7.4406 1.02997e-05
7.50794 3.05176e-05
END
$hits2 << END
6.17432 7.62939e-06
6.41048 7.62939e-06
4.01886 7.62939e-06
4.44295 7.62939e-06
6.92033 7.62939e-06
7.24273 7.62939e-06
5.28356 7.62939e-06
5.51188 7.62939e-06
2.52073 7.62939e-06
2.76768 7.62939e-06
5.23391 7.62939e-06
5.0675 7.62939e-06
5.03918 7.62939e-06
5.36514 7.62939e-06
3.51296 7.62939e-06
2.82371 7.62939e-06
4.9521 7.62939e-06
4.56898 7.62939e-06
9.07304 7.62939e-06
8.72135 7.62939e-06
0.623574 7.62939e-06
1.92463 7.62939e-06
4.35907 7.62939e-06
6.00783 7.62939e-06
2.43902 7.62939e-06
2.55444 7.62939e-06
END
$hits3 << END
6.60592 7.62939e-06
6.89738 4.57764e-05
4.27974 7.62939e-06
4.58594 7.62939e-05
7.14168 7.62939e-06
7.37884 7.62939e-06
5.67153 7.62939e-06
5.92539 4.57764e-05
2.71454 7.62939e-06
2.87887 7.62939e-05
5.56713 7.62939e-06
5.1801 7.62939e-06
5.26647 7.62939e-06
5.7062 6.10352e-05
3.62671 7.62939e-06
2.92305 0.000701904
5.10166 7.62939e-06
4.68526 0.000442505
9.62346 7.62939e-06
9.71685 3.05176e-05
END
$hits4 << END
5.7349 5.6514e-06
6.12252 5.6514e-06
4.16733 5.6514e-06
4.42964 5.6514e-06
6.92436 5.6514e-06
7.08385 5.6514e-06
5.03635 5.6514e-06
5.29791 5.6514e-06
2.5821 5.6514e-06
2.73781 5.6514e-06
5.24125 5.6514e-06
5.30858 5.6514e-06
4.69188 5.6514e-06
5.04251 5.6514e-06
3.2049 5.6514e-06
2.60635 5.6514e-06
4.57568 5.6514e-06
4.24369 5.6514e-06
8.85658 5.6514e-06
9.18375 5.6514e-06
END
$hits5 << END
6.26215 5.6514e-06
6.60559 4.57764e-05
4.30673 5.6514e-06
4.58753 7.62939e-05
7.06428 5.6514e-06
7.32695 5.6514e-06
5.43082 5.6514e-06
5.68643 4.57764e-05
2.70008 5.6514e-06
2.84796 7.62939e-05
5.44524 5.6514e-06
5.60145 5.6514e-06
4.68177 5.6514e-06
5.33533 6.10352e-05
3.30543 5.6514e-06
2.61256 0.000701904
4.75558 5.6514e-06
4.3435 0.000442505
9.46467 5.6514e-06
9.62719 3.05176e-05
END
$hits_front << END
9.62346 7.62939e-06
9.71685 3.05176e-05
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
set xrange [23.3616:531.053]; set yrange [8.7478e-10:0.00543185]
set xlabel 'pictures a second  (more is better)'; set ylabel 'picture: RMSE of a channel  (less is better)' offset -1.5
set xtics ('50' 50, '100' 100, '200' 200, '500' 500)
set ytics ("same\nbits" 2.18695e-09, '10⁻⁸' 1e-8, '10⁻⁷' 1e-7, '10⁻⁶' 1e-6, '10⁻⁵' 1e-5, '10⁻⁴' 1e-4, '10⁻³' 1e-3)
set object rectangle from graph 0, graph 0 to graph 1, first 3.71782e-09 fs solid noborder fc rgb '#eeeeee' behind
set arrow from first 442.544,1.74956e-08 to graph 1.0,0.1915 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.1915 to graph 1.015,0.1915 nohead lw 0.8 lc rgb '#999999'
set label 'robust, study: irregular box' at graph 1.02,0.1915 left
set arrow from first 439.288,1.61996e-09 to graph 1.0,0.0394 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.0394 to graph 1.015,0.0394 nohead lw 0.8 lc rgb '#999999'
set label 'double, study: irregular exact' at graph 1.02,0.0394 left
$picture0 << END
270.97 4.25742e-07
249.303 4.25742e-07
234.942 4.25742e-07
243.106 4.25742e-07
353.962 4.25742e-07
335.711 4.25742e-07
234.562 4.25742e-07
220.239 4.25742e-07
134.98 4.25742e-07
142.229 4.25742e-07
256.205 4.25742e-07
242.534 4.25742e-07
225.262 4.25742e-07
211.164 4.25742e-07
190.458 4.25742e-07
68.4678 4.25742e-07
247.006 4.25742e-07
213.09 4.25742e-07
407.611 4.25742e-07
377.685 4.25742e-07
END
$picture1 << END
181.631 4.25742e-07
181.896 4.25742e-07
210.788 4.25742e-07
228.045 4.25742e-07
304.013 4.25742e-07
304.118 4.25742e-07
163.923 4.25742e-07
167.784 4.25742e-07
105.412 4.25742e-07
136.197 4.25742e-07
229.544 4.25742e-07
224.212 4.25742e-07
160.15 4.25742e-07
160.382 4.25742e-07
135.469 4.25742e-07
98.5241 0.00173156
176.502 4.25742e-07
150.486 0.00217274
360.862 4.25742e-07
343.374 4.25742e-07
END
$picture2 << END
281.916 1.74956e-08
289.407 1.74956e-08
218.474 1.74956e-08
241.171 1.74956e-08
348.607 1.74956e-08
364.788 1.74956e-08
241.506 1.74956e-08
257.544 1.74956e-08
132.872 1.74956e-08
144.948 1.74956e-08
256.405 1.74956e-08
253.73 1.74956e-08
235.371 1.74956e-08
253.27 1.74956e-08
192.351 1.74956e-08
153.256 1.74956e-08
251.879 1.74956e-08
243.242 1.74956e-08
424.834 1.74956e-08
419.533 1.74956e-08
28.034 1.74956e-08
81.0143 1.74956e-08
191.295 1.74956e-08
297.756 1.74956e-08
135.712 1.74956e-08
127.998 1.74956e-08
END
$picture3 << END
296.032 1.74956e-08
311.365 1.74956e-08
228.932 1.74956e-08
123.66 1.74956e-08
365.095 1.74956e-08
367.635 1.74956e-08
253.864 1.74956e-08
263.927 1.74956e-08
138.6 1.74956e-08
146.927 1.74956e-08
259.177 1.74956e-08
232.665 1.74956e-08
249.16 1.74956e-08
261.949 1.74956e-08
197.534 1.74956e-08
154.879 0.00173156
261.526 1.74956e-08
245.598 0.00217274
442.544 1.74956e-08
440.987 1.74956e-08
END
$picture4 << END
262.958 1.61996e-09
285.582 1.61996e-09
228.425 1.61996e-09
245.712 1.61996e-09
356.79 1.61996e-09
361.415 1.61996e-09
229.183 1.61996e-09
242.901 1.61996e-09
134.225 1.61996e-09
141.047 1.61996e-09
248.193 1.61996e-09
259.038 1.61996e-09
223.464 1.61996e-09
228.57 1.61996e-09
175.162 1.61996e-09
143.919 1.61996e-09
239.922 1.61996e-09
226.89 1.61996e-09
418.969 1.61996e-09
419.213 1.61996e-09
END
$picture5 << END
282.199 1.61996e-09
297.612 1.61996e-09
232.901 1.61996e-09
252.092 1.61996e-09
355.881 1.61996e-09
367.435 1.61996e-09
244.95 1.61996e-09
258.522 1.61996e-09
138.696 1.61996e-09
144.903 1.61996e-09
258.842 1.61996e-09
256.852 1.61996e-09
234.221 1.61996e-09
247.886 1.61996e-09
183.959 1.61996e-09
145.936 0.00173156
241.771 1.61996e-09
232.317 0.00217274
434.837 1.61996e-09
439.288 1.61996e-09
END
$picture_front << END
439.288 1.61996e-09
442.544 1.74956e-08
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
set xrange [0.587226:16.5972]; set yrange [3.05176e-06:0.017395]
set xlabel 'million nearest hits a second  (more is better)'; set ylabel 'wrong hits  (less is better)' offset -1.5
set label 'tree: speed against accuracy (CPU, 2 threads)' at screen 0.02, screen 0.9774 font ',20'
set label '256x256 primary and 65,536 random rays a scene; 65,536 in all compared with brute force in double; pictures of 128x128' at screen 0.02, screen 0.9516
set xtics ('1' 1, '2' 2, '5' 5, '10' 10)
set ytics ("none of\n65,536" 7.62939e-06, '0.01 %%' 1e-4, '0.1 %%' 1e-3, '1 %%' 1e-2)
set object rectangle from graph 0, graph 0 to graph 1, first 1.297e-05 fs solid noborder fc rgb '#eeeeee' behind
set arrow from first 13.831,0.00569153 to graph 1.0,0.8708 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.8708 to graph 1.015,0.8708 nohead lw 0.8 lc rgb '#999999'
set label 'double, study: irregular exact' at graph 1.02,0.8708 left
set arrow from first 13.7534,5.6514e-06 to graph 1.0,0.0713 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.0713 to graph 1.015,0.0713 nohead lw 0.8 lc rgb '#999999'
set label 'double: irregular exact' at graph 1.02,0.0713 left
$hits0 << END
2.66526 0.00125122
2.83743 0.00125122
1.2543 0.00125122
1.37502 0.00125122
0.704671 0.00125122
2.97986 0.00125122
3.25671 0.00125122
12.7137 0.00125122
13.0295 0.00125122
END
$hits1 << END
2.85769 0.00257874
3.14024 0.0022583
1.37756 0.00257874
1.45991 0.0022583
0.723689 0.00204468
2.96076 0.00180054
3.25838 0.00158691
13.1332 0.00695801
13.1111 0.00695801
END
$hits2 << END
1.45414 7.62939e-06
1.49349 7.62939e-06
2.84718 7.62939e-06
2.96923 7.62939e-06
1.26254 7.62939e-06
1.33953 7.62939e-06
1.26858 7.62939e-06
1.31019 7.62939e-06
1.40432 7.62939e-06
1.45568 7.62939e-06
3.89562 7.62939e-06
4.13698 7.62939e-06
12.6777 7.62939e-06
12.8347 7.62939e-06
0.840149 7.62939e-06
2.43576 7.62939e-06
2.60915 7.62939e-06
END
$hits3 << END
1.354 0.000823975
1.55176 0.000930786
3.04233 0.00132751
3.32787 0.00100708
1.29004 0.000823975
1.35603 0.000930786
1.46114 0.00132751
1.53959 0.00100708
1.47329 0.000823975
1.51205 0.000793457
3.95078 0.000564575
4.14514 0.000350952
13.7675 0.00569153
12.8285 0.00569153
END
$hits4 << END
1.36284 5.6514e-06
1.37133 5.6514e-06
2.82426 5.6514e-06
3.09103 5.6514e-06
1.1997 5.6514e-06
1.24967 5.6514e-06
1.28725 5.6514e-06
1.45841 5.6514e-06
1.29702 5.6514e-06
1.26325 5.6514e-06
3.81253 5.6514e-06
4.23948 5.6514e-06
12.894 5.6514e-06
13.7534 5.6514e-06
END
$hits5 << END
1.35542 0.000823975
1.35127 0.000930786
3.04997 0.00132751
3.017 0.00100708
1.17204 0.000823975
1.20682 0.000930786
1.44747 0.00132751
1.55171 0.00100708
1.35477 0.000823975
1.39297 0.000793457
3.85846 0.000564575
4.09722 0.000350952
13.5578 0.00569153
13.831 0.00569153
END
$hits_front << END
13.7534 5.6514e-06
13.831 0.00569153
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
set xrange [3.76068:131.722]; set yrange [5.2625e-05:0.0737055]
set xlabel 'pictures a second  (more is better)'; set ylabel 'picture: RMSE of a channel  (less is better)' offset -1.5
set xtics ('5' 5, '10' 10, '20' 20, '50' 50, '100' 100)
set ytics ("same\nbits" 0.000131563, '10⁻³' 1e-3, '10⁻²' 1e-2)
set object rectangle from graph 0, graph 0 to graph 1, first 0.000223656 fs solid noborder fc rgb '#eeeeee' behind
set arrow from first 109.769,0.0294223 to graph 1.0,0.9172 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.9172 to graph 1.015,0.9172 nohead lw 0.8 lc rgb '#999999'
set label 'fast, study: irregular exact' at graph 1.02,0.9172 left
set arrow from first 109.372,0.02193 to graph 1.0,0.8672 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.8672 to graph 1.015,0.8672 nohead lw 0.8 lc rgb '#999999'
set label 'double, study: irregular exact' at graph 1.02,0.8672 left
set arrow from first 109.001,0.0196098 to graph 1.0,0.8172 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.8172 to graph 1.015,0.8172 nohead lw 0.8 lc rgb '#999999'
set label 'fast: irregular exact' at graph 1.02,0.8172 left
set arrow from first 108.628,9.74537e-05 to graph 1.0,0.0851 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.0851 to graph 1.015,0.0851 nohead lw 0.8 lc rgb '#999999'
set label 'double: irregular exact' at graph 1.02,0.0851 left
$picture0 << END
24.0978 0.0196098
28.9935 0.0196098
11.3724 0.0196098
11.483 0.0196098
4.54256 0.0196098
22.7985 0.0196098
25.9794 0.0196098
106.35 0.0196098
109.001 0.0196098
END
$picture1 << END
28.0632 0.0207304
29.8926 0.0205941
10.8209 0.0207304
11.4947 0.0205941
4.51282 0.0200072
22.9925 0.0198815
25.7013 0.0197756
106.621 0.0294822
109.769 0.0294223
END
$picture2 << END
7.41801 0.0010525
8.96523 0.0010525
27.3539 0.0010525
29.9251 0.0010525
6.91018 0.0010525
7.02346 0.0010525
11.2878 0.0010525
11.7839 0.0010525
8.69391 0.0010525
8.91735 0.0010525
32.3099 0.0010525
31.4685 0.0010525
103.373 0.0010525
103.132 0.0010525
5.04796 0.0010525
12.0708 0.0010525
13.8697 0.0010525
END
$picture3 << END
8.91496 0.00394034
9.35515 0.00466028
28.7965 0.00698046
30.0796 0.0064093
7.11136 0.00394034
7.27696 0.00466028
11.6443 0.00698046
12.0259 0.0064093
9.18957 0.00394034
8.89 0.00405174
32.3619 0.00375491
33.9299 0.00280699
104.693 0.0220073
107.219 0.0219551
END
$picture4 << END
8.165 9.74537e-05
8.38666 9.74537e-05
29.1013 9.74537e-05
26.4549 9.74537e-05
6.51755 9.74537e-05
6.72405 9.74537e-05
11.3599 9.74537e-05
11.949 9.74537e-05
8.3894 9.74537e-05
8.62277 9.74537e-05
29.4055 9.74537e-05
31.3607 9.74537e-05
104.681 9.74537e-05
108.628 9.74537e-05
END
$picture5 << END
8.24429 0.00379718
8.69074 0.00453988
28.8563 0.00690066
30.4498 0.00632229
6.73932 0.00379718
6.89712 0.00453988
11.5921 0.00690066
11.899 0.00632229
8.68297 0.00379718
8.81881 0.00391266
31.3459 0.00360438
31.8455 0.0026022
107.056 0.0219886
109.372 0.02193
END
$picture_front << END
108.628 9.74537e-05
109.001 0.0196098
109.372 0.02193
109.769 0.0294223
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
set xrange [0.587226:16.5972]; set yrange [3.05176e-06:0.017395]
set xlabel 'million nearest hits a second  (more is better)'; set ylabel 'wrong hits  (less is better)' offset -1.5
set label 'tree: speed against accuracy (CPU, 2 threads)' at screen 0.02, screen 0.9774 font ',20'
set label '256x256 primary and 65,536 random rays a scene; 65,536 in all compared with brute force in double; pictures of 128x128' at screen 0.02, screen 0.9516
set xtics ('1' 1, '2' 2, '5' 5, '10' 10)
set ytics ("none of\n65,536" 7.62939e-06, '0.01 %%' 1e-4, '0.1 %%' 1e-3, '1 %%' 1e-2)
set object rectangle from graph 0, graph 0 to graph 1, first 1.297e-05 fs solid noborder fc rgb '#eeeeee' behind
set arrow from first 13.831,0.00569153 to graph 1.0,0.8708 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.8708 to graph 1.015,0.8708 nohead lw 0.8 lc rgb '#999999'
set label 'double, study: irregular exact' at graph 1.02,0.8708 left
set arrow from first 13.7534,5.6514e-06 to graph 1.0,0.0713 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.0713 to graph 1.015,0.0713 nohead lw 0.8 lc rgb '#999999'
set label 'double: irregular exact' at graph 1.02,0.0713 left
$hits0 << END
2.66526 0.00125122
2.83743 0.00125122
1.2543 0.00125122
1.37502 0.00125122
0.704671 0.00125122
2.97986 0.00125122
3.25671 0.00125122
12.7137 0.00125122
13.0295 0.00125122
END
$hits1 << END
2.85769 0.00257874
3.14024 0.0022583
1.37756 0.00257874
1.45991 0.0022583
0.723689 0.00204468
2.96076 0.00180054
3.25838 0.00158691
13.1332 0.00695801
13.1111 0.00695801
END
$hits2 << END
1.45414 7.62939e-06
1.49349 7.62939e-06
2.84718 7.62939e-06
2.96923 7.62939e-06
1.26254 7.62939e-06
1.33953 7.62939e-06
1.26858 7.62939e-06
1.31019 7.62939e-06
1.40432 7.62939e-06
1.45568 7.62939e-06
3.89562 7.62939e-06
4.13698 7.62939e-06
12.6777 7.62939e-06
12.8347 7.62939e-06
0.840149 7.62939e-06
2.43576 7.62939e-06
2.60915 7.62939e-06
END
$hits3 << END
1.354 0.000823975
1.55176 0.000930786
3.04233 0.00132751
3.32787 0.00100708
1.29004 0.000823975
1.35603 0.000930786
1.46114 0.00132751
1.53959 0.00100708
1.47329 0.000823975
1.51205 0.000793457
3.95078 0.000564575
4.14514 0.000350952
13.7675 0.00569153
12.8285 0.00569153
END
$hits4 << END
1.36284 5.6514e-06
1.37133 5.6514e-06
2.82426 5.6514e-06
3.09103 5.6514e-06
1.1997 5.6514e-06
1.24967 5.6514e-06
1.28725 5.6514e-06
1.45841 5.6514e-06
1.29702 5.6514e-06
1.26325 5.6514e-06
3.81253 5.6514e-06
4.23948 5.6514e-06
12.894 5.6514e-06
13.7534 5.6514e-06
END
$hits5 << END
1.35542 0.000823975
1.35127 0.000930786
3.04997 0.00132751
3.017 0.00100708
1.17204 0.000823975
1.20682 0.000930786
1.44747 0.00132751
1.55171 0.00100708
1.35477 0.000823975
1.39297 0.000793457
3.85846 0.000564575
4.09722 0.000350952
13.5578 0.00569153
13.831 0.00569153
END
$hits_front << END
13.7534 5.6514e-06
13.831 0.00569153
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
set xrange [3.76068:131.722]; set yrange [5.2625e-05:0.0737055]
set xlabel 'pictures a second  (more is better)'; set ylabel 'picture: RMSE of a channel  (less is better)' offset -1.5
set xtics ('5' 5, '10' 10, '20' 20, '50' 50, '100' 100)
set ytics ("same\nbits" 0.000131563, '10⁻³' 1e-3, '10⁻²' 1e-2)
set object rectangle from graph 0, graph 0 to graph 1, first 0.000223656 fs solid noborder fc rgb '#eeeeee' behind
set arrow from first 109.769,0.0294223 to graph 1.0,0.9172 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.9172 to graph 1.015,0.9172 nohead lw 0.8 lc rgb '#999999'
set label 'fast, study: irregular exact' at graph 1.02,0.9172 left
set arrow from first 109.372,0.02193 to graph 1.0,0.8672 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.8672 to graph 1.015,0.8672 nohead lw 0.8 lc rgb '#999999'
set label 'double, study: irregular exact' at graph 1.02,0.8672 left
set arrow from first 109.001,0.0196098 to graph 1.0,0.8172 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.8172 to graph 1.015,0.8172 nohead lw 0.8 lc rgb '#999999'
set label 'fast: irregular exact' at graph 1.02,0.8172 left
set arrow from first 108.628,9.74537e-05 to graph 1.0,0.0851 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.0851 to graph 1.015,0.0851 nohead lw 0.8 lc rgb '#999999'
set label 'double: irregular exact' at graph 1.02,0.0851 left
$picture0 << END
24.0978 0.0196098
28.9935 0.0196098
11.3724 0.0196098
11.483 0.0196098
4.54256 0.0196098
22.7985 0.0196098
25.9794 0.0196098
106.35 0.0196098
109.001 0.0196098
END
$picture1 << END
28.0632 0.0207304
29.8926 0.0205941
10.8209 0.0207304
11.4947 0.0205941
4.51282 0.0200072
22.9925 0.0198815
25.7013 0.0197756
106.621 0.0294822
109.769 0.0294223
END
$picture2 << END
7.41801 0.0010525
8.96523 0.0010525
27.3539 0.0010525
29.9251 0.0010525
6.91018 0.0010525
7.02346 0.0010525
11.2878 0.0010525
11.7839 0.0010525
8.69391 0.0010525
8.91735 0.0010525
32.3099 0.0010525
31.4685 0.0010525
103.373 0.0010525
103.132 0.0010525
5.04796 0.0010525
12.0708 0.0010525
13.8697 0.0010525
END
$picture3 << END
8.91496 0.00394034
9.35515 0.00466028
28.7965 0.00698046
30.0796 0.0064093
7.11136 0.00394034
7.27696 0.00466028
11.6443 0.00698046
12.0259 0.0064093
9.18957 0.00394034
8.89 0.00405174
32.3619 0.00375491
33.9299 0.00280699
104.693 0.0220073
107.219 0.0219551
END
$picture4 << END
8.165 9.74537e-05
8.38666 9.74537e-05
29.1013 9.74537e-05
26.4549 9.74537e-05
6.51755 9.74537e-05
6.72405 9.74537e-05
11.3599 9.74537e-05
11.949 9.74537e-05
8.3894 9.74537e-05
8.62277 9.74537e-05
29.4055 9.74537e-05
31.3607 9.74537e-05
104.681 9.74537e-05
108.628 9.74537e-05
END
$picture5 << END
8.24429 0.00379718
8.69074 0.00453988
28.8563 0.00690066
30.4498 0.00632229
6.73932 0.00379718
6.89712 0.00453988
11.5921 0.00690066
11.899 0.00632229
8.68297 0.00379718
8.81881 0.00391266
31.3459 0.00360438
31.8455 0.0026022
107.056 0.0219886
109.372 0.02193
END
$picture_front << END
108.628 9.74537e-05
109.001 0.0196098
109.372 0.02193
109.769 0.0294223
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
set xrange [0.504731:13.0421]; set yrange [4.35965e-07:0.0195694]
set xlabel 'million nearest hits a second  (more is better)'; set ylabel 'wrong hits  (less is better)' offset -1.5
set label 'mean of 7 scenes: speed against accuracy (CPU, 2 threads)' at screen 0.02, screen 0.9774 font ',20'
set label '256x256 primary and 65,536 random rays a scene; 458,752 in all compared with brute force in double; pictures of 128x128' at screen 0.02, screen 0.9516
set xtics ('1' 1, '2' 2, '5' 5, '10' 10)
set ytics ("none of\n458,752" 1.08991e-06, '0.001 %%' 1e-5, '0.01 %%' 1e-4, '0.1 %%' 1e-3, '1 %%' 1e-2)
set object rectangle from graph 0, graph 0 to graph 1, first 1.85285e-06 fs solid noborder fc rgb '#eeeeee' behind
set arrow from first 10.8684,0.00251334 to graph 1.0,0.8084 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.8084 to graph 1.015,0.8084 nohead lw 0.8 lc rgb '#999999'
set label 'double, study: irregular exact' at graph 1.02,0.8084 left
set arrow from first 10.2201,8.07343e-07 to graph 1.0,0.0575 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.0575 to graph 1.015,0.0575 nohead lw 0.8 lc rgb '#999999'
set label 'double: irregular exact' at graph 1.02,0.0575 left
$hits0 << END
2.07911 0.000233241
2.15166 0.000233241
2.90562 0.000233241
3.17665 0.000233241
4.25813 0.000233241
4.65519 0.000233241
1.92639 0.000233241
1.99263 0.000233241
1.94283 0.000233241
2.06352 0.000233241
2.97941 0.000233241
3.08346 0.000233241
1.90372 0.000233241
1.96961 0.000233241
2.07744 0.000233241
2.02395 0.000233241
3.18827 0.000233241
3.18201 0.000233241
8.62395 0.000233241
9.39621 0.000233241
END
$hits1 << END
1.86904 0.00527736
1.95471 0.00514657
2.98347 0.00782776
3.13759 0.00444249
4.26853 0.00572641
4.69774 0.00240871
1.68874 0.00527736
1.80599 0.00514657
1.98469 0.00782776
2.08652 0.00444249
3.06718 0.00572641
3.16714 0.00240871
1.69306 0.00543649
1.78129 0.00517927
1.90371 0.00716291
1.85678 0.00560652
3.0114 0.00575692
2.94495 0.00289699
9.16134 0.00574384
9.93654 0.0027444
END
$hits2 << END
2.65622 1.08991e-06
2.77479 1.08991e-06
3.24683 1.08991e-06
3.53734 1.08991e-06
4.51687 1.08991e-06
4.83064 1.08991e-06
2.42998 1.08991e-06
2.51362 1.08991e-06
2.1644 1.08991e-06
2.30012 1.08991e-06
3.05002 1.08991e-06
3.037 1.08991e-06
2.40403 1.08991e-06
2.54584 1.08991e-06
2.57515 1.08991e-06
2.52563 1.08991e-06
3.72737 1.08991e-06
3.80804 1.08991e-06
9.08947 1.08991e-06
9.65489 1.08991e-06
0.605677 1.08991e-06
1.4613 1.08991e-06
3.40924 1.08991e-06
2.22289 1.08991e-06
2.77761 1.08991e-06
END
$hits3 << END
2.84475 0.00504848
2.94031 0.00491333
3.46831 0.00759888
3.66856 0.00421797
4.78014 0.00550188
4.92957 0.00217983
2.4863 0.00504848
2.65323 0.00491333
2.28363 0.00759888
2.37762 0.00421797
3.29209 0.00550188
3.37444 0.00217983
2.51648 0.00520979
2.67009 0.00494603
2.62187 0.00694275
2.60893 0.00538853
3.92593 0.0055324
3.90762 0.00267029
10.2532 0.00551714
10.7751 0.00251334
END
$hits4 << END
2.46354 8.07343e-07
2.56408 8.07343e-07
3.25801 8.07343e-07
3.23789 8.07343e-07
4.46135 8.07343e-07
4.69102 8.07343e-07
2.25671 8.07343e-07
2.33386 8.07343e-07
2.14932 8.07343e-07
2.28023 8.07343e-07
3.03765 8.07343e-07
3.2626 8.07343e-07
2.21884 8.07343e-07
2.33587 8.07343e-07
2.42186 8.07343e-07
2.32922 8.07343e-07
3.51287 8.07343e-07
3.66442 8.07343e-07
9.26621 8.07343e-07
10.2201 8.07343e-07
END
$hits5 << END
2.47147 0.00504848
2.71981 0.00491333
3.45536 0.00759888
3.49368 0.00422015
4.79107 0.00550188
5.00373 0.00217983
2.39783 0.00504848
2.45629 0.00491333
2.1579 0.00759888
2.32904 0.00421797
3.27256 0.00550188
3.42269 0.00217983
2.34142 0.00520979
2.41864 0.00494603
2.55411 0.00694493
2.50228 0.00539071
3.76701 0.0055324
3.76888 0.00267029
10.2615 0.00551714
10.8684 0.00251334
END
$hits_front << END
10.2201 8.07343e-07
10.8684 0.00251334
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
set xrange [5.83415:123.43]; set yrange [4.92157e-05:0.0711461]
set xlabel 'pictures a second  (more is better)'; set ylabel 'picture: RMSE of a channel  (less is better)' offset -1.5
set xtics ('10' 10, '20' 20, '50' 50, '100' 100)
set ytics ("same\nbits" 0.000123039, '10⁻³' 1e-3, '10⁻²' 1e-2)
set object rectangle from graph 0, graph 0 to graph 1, first 0.000209167 fs solid noborder fc rgb '#eeeeee' behind
set arrow from first 102.858,0.0151009 to graph 1.0,0.8367 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.8367 to graph 1.015,0.8367 nohead lw 0.8 lc rgb '#999999'
set label 'robust, study: irregular exact' at graph 1.02,0.8367 left
set arrow from first 101.419,0.0150679 to graph 1.0,0.7867 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.7867 to graph 1.015,0.7867 nohead lw 0.8 lc rgb '#999999'
set label 'double, study: irregular exact' at graph 1.02,0.7867 left
set arrow from first 100.563,9.11403e-05 to graph 1.0,0.0847 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.0847 to graph 1.015,0.0847 nohead lw 0.8 lc rgb '#999999'
set label 'double: irregular exact' at graph 1.02,0.0847 left
$picture0 << END
22.9626 0.0125823
23.7099 0.0125823
32.3676 0.0125823
34.7182 0.0125823
48.7682 0.0125823
53.7572 0.0125823
21.3496 0.0125823
21.7243 0.0125823
22.2421 0.0125823
23.6651 0.0125823
34.8669 0.0125823
35.9686 0.0125823
21.5457 0.0125823
20.8221 0.0125823
24.9351 0.0125823
21.6097 0.0125823
38.1254 0.0125823
37.8755 0.0125823
89.6834 0.0125823
95.8612 0.0125823
END
$picture1 << END
19.6478 0.0227032
20.3904 0.0223245
32.176 0.0284585
34.8069 0.0216955
50.0099 0.0244157
54.0513 0.0182114
18.7097 0.0227032
19.3114 0.0223245
22.0677 0.0284585
23.8636 0.0216955
34.5253 0.0244157
36.7952 0.0182114
18.1715 0.0227037
19.2989 0.0223245
22.0717 0.0253324
21.1529 0.0228795
33.8882 0.0237884
34.3286 0.0184323
88.6647 0.025209
95.4125 0.0194287
END
$picture2 << END
26.5332 0.000984315
27.9345 0.000984315
34.0286 0.000984315
36.8203 0.000984315
51.2494 0.000984315
54.9466 0.000984315
25.4444 0.000984315
26.3473 0.000984315
24.3422 0.000984315
25.3973 0.000984315
35.3809 0.000984315
37.2103 0.000984315
25.6234 0.000984315
26.6872 0.000984315
28.8381 0.000984315
28.7441 0.000984315
42.6858 0.000984315
43.6671 0.000984315
92.6748 0.000984315
98.0517 0.000984315
7.00099 0.000984315
15.6035 0.000984315
35.0019 0.000984315
25.4218 0.000984315
29.6327 0.000984315
END
$picture3 << END
28.2178 0.0192273
28.3193 0.0187296
37.2313 0.0258928
35.6966 0.017856
54.2573 0.0212963
57.0144 0.0134829
26.2075 0.0192273
26.9972 0.0187296
25.3036 0.0258928
24.7892 0.017856
36.5874 0.0212963
38.3085 0.0134829
26.2972 0.0192279
27.1867 0.0187296
29.9964 0.0222709
29.2175 0.0194229
42.0101 0.0204607
44.924 0.0137772
96.0625 0.0221638
102.858 0.0151009
END
$picture4 << END
25.0669 9.11403e-05
26.1269 9.11403e-05
34.97 9.11403e-05
37.2591 9.11403e-05
51.8463 9.11403e-05
54.6077 9.11403e-05
23.3805 9.11403e-05
24.1741 9.11403e-05
23.8567 9.11403e-05
25.2961 9.11403e-05
35.0554 9.11403e-05
37.4391 9.11403e-05
23.5278 9.11403e-05
24.2148 9.11403e-05
27.2932 9.11403e-05
26.8944 9.11403e-05
40.5406 9.11403e-05
41.6844 9.11403e-05
92.2591 9.11403e-05
100.563 9.11403e-05
END
$picture5 << END
26.0999 0.0192032
27.3951 0.0187046
36.9321 0.0258798
39.107 0.0178357
54.0514 0.0212768
56.9263 0.0134492
24.6617 0.0192032
23.9677 0.0187046
25.4214 0.0258798
26.4147 0.0178368
36.9274 0.0212768
38.3487 0.0134492
24.6226 0.0192039
25.3399 0.0187046
28.8758 0.0222503
27.7096 0.0194335
42.2792 0.0204423
43.1194 0.0137465
97.6093 0.0221462
101.419 0.0150679
END
$picture_front << END
100.563 9.11403e-05
101.419 0.0150679
102.858 0.0151009
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
set xrange [0.504731:13.0421]; set yrange [4.35965e-07:0.0195694]
set xlabel 'million nearest hits a second  (more is better)'; set ylabel 'wrong hits  (less is better)' offset -1.5
set label 'mean of 7 scenes: speed against accuracy (CPU, 2 threads)' at screen 0.02, screen 0.9774 font ',20'
set label '256x256 primary and 65,536 random rays a scene; 458,752 in all compared with brute force in double; pictures of 128x128' at screen 0.02, screen 0.9516
set xtics ('1' 1, '2' 2, '5' 5, '10' 10)
set ytics ("none of\n458,752" 1.08991e-06, '0.001 %%' 1e-5, '0.01 %%' 1e-4, '0.1 %%' 1e-3, '1 %%' 1e-2)
set object rectangle from graph 0, graph 0 to graph 1, first 1.85285e-06 fs solid noborder fc rgb '#eeeeee' behind
set arrow from first 10.8684,0.00251334 to graph 1.0,0.8084 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.8084 to graph 1.015,0.8084 nohead lw 0.8 lc rgb '#999999'
set label 'double, study: irregular exact' at graph 1.02,0.8084 left
set arrow from first 10.2201,8.07343e-07 to graph 1.0,0.0575 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.0575 to graph 1.015,0.0575 nohead lw 0.8 lc rgb '#999999'
set label 'double: irregular exact' at graph 1.02,0.0575 left
$hits0 << END
2.07911 0.000233241
2.15166 0.000233241
2.90562 0.000233241
3.17665 0.000233241
4.25813 0.000233241
4.65519 0.000233241
1.92639 0.000233241
1.99263 0.000233241
1.94283 0.000233241
2.06352 0.000233241
2.97941 0.000233241
3.08346 0.000233241
1.90372 0.000233241
1.96961 0.000233241
2.07744 0.000233241
2.02395 0.000233241
3.18827 0.000233241
3.18201 0.000233241
8.62395 0.000233241
9.39621 0.000233241
END
$hits1 << END
1.86904 0.00527736
1.95471 0.00514657
2.98347 0.00782776
3.13759 0.00444249
4.26853 0.00572641
4.69774 0.00240871
1.68874 0.00527736
1.80599 0.00514657
1.98469 0.00782776
2.08652 0.00444249
3.06718 0.00572641
3.16714 0.00240871
1.69306 0.00543649
1.78129 0.00517927
1.90371 0.00716291
1.85678 0.00560652
3.0114 0.00575692
2.94495 0.00289699
9.16134 0.00574384
9.93654 0.0027444
END
$hits2 << END
2.65622 1.08991e-06
2.77479 1.08991e-06
3.24683 1.08991e-06
3.53734 1.08991e-06
4.51687 1.08991e-06
4.83064 1.08991e-06
2.42998 1.08991e-06
2.51362 1.08991e-06
2.1644 1.08991e-06
2.30012 1.08991e-06
3.05002 1.08991e-06
3.037 1.08991e-06
2.40403 1.08991e-06
2.54584 1.08991e-06
2.57515 1.08991e-06
2.52563 1.08991e-06
3.72737 1.08991e-06
3.80804 1.08991e-06
9.08947 1.08991e-06
9.65489 1.08991e-06
0.605677 1.08991e-06
1.4613 1.08991e-06
3.40924 1.08991e-06
2.22289 1.08991e-06
2.77761 1.08991e-06
END
$hits3 << END
2.84475 0.00504848
2.94031 0.00491333
3.46831 0.00759888
3.66856 0.00421797
4.78014 0.00550188
4.92957 0.00217983
2.4863 0.00504848
2.65323 0.00491333
2.28363 0.00759888
2.37762 0.00421797
3.29209 0.00550188
3.37444 0.00217983
2.51648 0.00520979
2.67009 0.00494603
2.62187 0.00694275
2.60893 0.00538853
3.92593 0.0055324
3.90762 0.00267029
10.2532 0.00551714
10.7751 0.00251334
END
$hits4 << END
2.46354 8.07343e-07
2.56408 8.07343e-07
3.25801 8.07343e-07
3.23789 8.07343e-07
4.46135 8.07343e-07
4.69102 8.07343e-07
2.25671 8.07343e-07
2.33386 8.07343e-07
2.14932 8.07343e-07
2.28023 8.07343e-07
3.03765 8.07343e-07
3.2626 8.07343e-07
2.21884 8.07343e-07
2.33587 8.07343e-07
2.42186 8.07343e-07
2.32922 8.07343e-07
3.51287 8.07343e-07
3.66442 8.07343e-07
9.26621 8.07343e-07
10.2201 8.07343e-07
END
$hits5 << END
2.47147 0.00504848
2.71981 0.00491333
3.45536 0.00759888
3.49368 0.00422015
4.79107 0.00550188
5.00373 0.00217983
2.39783 0.00504848
2.45629 0.00491333
2.1579 0.00759888
2.32904 0.00421797
3.27256 0.00550188
3.42269 0.00217983
2.34142 0.00520979
2.41864 0.00494603
2.55411 0.00694493
2.50228 0.00539071
3.76701 0.0055324
3.76888 0.00267029
10.2615 0.00551714
10.8684 0.00251334
END
$hits_front << END
10.2201 8.07343e-07
10.8684 0.00251334
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
set xrange [5.83415:123.43]; set yrange [4.92157e-05:0.0711461]
set xlabel 'pictures a second  (more is better)'; set ylabel 'picture: RMSE of a channel  (less is better)' offset -1.5
set xtics ('10' 10, '20' 20, '50' 50, '100' 100)
set ytics ("same\nbits" 0.000123039, '10⁻³' 1e-3, '10⁻²' 1e-2)
set object rectangle from graph 0, graph 0 to graph 1, first 0.000209167 fs solid noborder fc rgb '#eeeeee' behind
set arrow from first 102.858,0.0151009 to graph 1.0,0.8367 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.8367 to graph 1.015,0.8367 nohead lw 0.8 lc rgb '#999999'
set label 'robust, study: irregular exact' at graph 1.02,0.8367 left
set arrow from first 101.419,0.0150679 to graph 1.0,0.7867 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.7867 to graph 1.015,0.7867 nohead lw 0.8 lc rgb '#999999'
set label 'double, study: irregular exact' at graph 1.02,0.7867 left
set arrow from first 100.563,9.11403e-05 to graph 1.0,0.0847 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.0847 to graph 1.015,0.0847 nohead lw 0.8 lc rgb '#999999'
set label 'double: irregular exact' at graph 1.02,0.0847 left
$picture0 << END
22.9626 0.0125823
23.7099 0.0125823
32.3676 0.0125823
34.7182 0.0125823
48.7682 0.0125823
53.7572 0.0125823
21.3496 0.0125823
21.7243 0.0125823
22.2421 0.0125823
23.6651 0.0125823
34.8669 0.0125823
35.9686 0.0125823
21.5457 0.0125823
20.8221 0.0125823
24.9351 0.0125823
21.6097 0.0125823
38.1254 0.0125823
37.8755 0.0125823
89.6834 0.0125823
95.8612 0.0125823
END
$picture1 << END
19.6478 0.0227032
20.3904 0.0223245
32.176 0.0284585
34.8069 0.0216955
50.0099 0.0244157
54.0513 0.0182114
18.7097 0.0227032
19.3114 0.0223245
22.0677 0.0284585
23.8636 0.0216955
34.5253 0.0244157
36.7952 0.0182114
18.1715 0.0227037
19.2989 0.0223245
22.0717 0.0253324
21.1529 0.0228795
33.8882 0.0237884
34.3286 0.0184323
88.6647 0.025209
95.4125 0.0194287
END
$picture2 << END
26.5332 0.000984315
27.9345 0.000984315
34.0286 0.000984315
36.8203 0.000984315
51.2494 0.000984315
54.9466 0.000984315
25.4444 0.000984315
26.3473 0.000984315
24.3422 0.000984315
25.3973 0.000984315
35.3809 0.000984315
37.2103 0.000984315
25.6234 0.000984315
26.6872 0.000984315
28.8381 0.000984315
28.7441 0.000984315
42.6858 0.000984315
43.6671 0.000984315
92.6748 0.000984315
98.0517 0.000984315
7.00099 0.000984315
15.6035 0.000984315
35.0019 0.000984315
25.4218 0.000984315
29.6327 0.000984315
END
$picture3 << END
28.2178 0.0192273
28.3193 0.0187296
37.2313 0.0258928
35.6966 0.017856
54.2573 0.0212963
57.0144 0.0134829
26.2075 0.0192273
26.9972 0.0187296
25.3036 0.0258928
24.7892 0.017856
36.5874 0.0212963
38.3085 0.0134829
26.2972 0.0192279
27.1867 0.0187296
29.9964 0.0222709
29.2175 0.0194229
42.0101 0.0204607
44.924 0.0137772
96.0625 0.0221638
102.858 0.0151009
END
$picture4 << END
25.0669 9.11403e-05
26.1269 9.11403e-05
34.97 9.11403e-05
37.2591 9.11403e-05
51.8463 9.11403e-05
54.6077 9.11403e-05
23.3805 9.11403e-05
24.1741 9.11403e-05
23.8567 9.11403e-05
25.2961 9.11403e-05
35.0554 9.11403e-05
37.4391 9.11403e-05
23.5278 9.11403e-05
24.2148 9.11403e-05
27.2932 9.11403e-05
26.8944 9.11403e-05
40.5406 9.11403e-05
41.6844 9.11403e-05
92.2591 9.11403e-05
100.563 9.11403e-05
END
$picture5 << END
26.0999 0.0192032
27.3951 0.0187046
36.9321 0.0258798
39.107 0.0178357
54.0514 0.0212768
56.9263 0.0134492
24.6617 0.0192032
23.9677 0.0187046
25.4214 0.0258798
26.4147 0.0178368
36.9274 0.0212768
38.3487 0.0134492
24.6226 0.0192039
25.3399 0.0187046
28.8758 0.0222503
27.7096 0.0194335
42.2792 0.0204423
43.1194 0.0137465
97.6093 0.0221462
101.419 0.0150679
END
$picture_front << END
100.563 9.11403e-05
101.419 0.0150679
102.858 0.0151009
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
1 1004.44
2 298.393
4 267.64
8 209.317
16 148.198
32 61.5448
64 50.26
128 49.1132
256 42.7577
END
$chosen0 << END
138.128 30.0362
END
$line1 << END
1 8202.96
2 2231.67
4 916.543
8 213
16 52.752
32 52.8323
64 30.2951
128 66.2312
256 50.1662
END
$chosen1 << END
93.6537 26.5919
END
$line2 << END
1 1665.59
2 161.943
4 43.7092
8 18.144
16 13.322
32 13.8535
64 18.101
128 28.6017
256 28.4247
END
$chosen2 << END
43.323 15.101
END
$line3 << END
1 1986.79
2 441.372
4 200.362
8 79.3624
16 39.3879
32 33.2273
64 38.2681
128 55.0864
256 52.8355
END
$chosen3 << END
50.6645 35.0348
END
$line4 << END
1 1185.5
2 328.274
4 81.5736
8 27.7669
16 15.119
32 15.6023
64 22.3428
128 46.5818
256 27.4675
END
$chosen4 << END
50.4685 17.0841
END
$line5 << END
1 118.904
2 35.671
4 12.3435
8 5.22752
16 3.45534
32 3.35846
64 4.14643
128 7.36852
256 7.81265
END
$chosen5 << END
30 2.74132
END
$line6 << END
1 2103.36
2 648.93
4 560.797
8 476.533
16 351.548
32 198.1
64 111.542
128 82.8447
256 72.0997
END
$chosen6 << END
278.218 33.4168
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
set xrange [0.909091:306.04]; set yrange [2.10871:10663.8]
set xlabel 'voxels an axis'; set ylabel 'ms a picture'
set xtics (1, 2, 4, 8, 16, 32, 64, 128, 256, 512, 1024)
set ytics ('10' 10, '100' 100, '1000' 1000, '10000' 10000)
set arrow from first 16, graph 0 to first 16, graph 1 nohead lw 1.5 dt '-' lc rgb '#444444'
set label '16: what the founding study found enough' at first 16, graph 0.97 offset 1,0 left
set arrow from first 256,42.7577 to graph 1.0,0.3910 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.3910 to graph 1.015,0.3910 nohead lw 0.8 lc rgb '#999999'
set label 'balls' at graph 1.02,0.3910 left
set arrow from first 256,50.1662 to graph 1.0,0.4360 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.4360 to graph 1.015,0.4360 nohead lw 0.8 lc rgb '#999999'
set label 'gears' at graph 1.02,0.4360 left
set arrow from first 256,28.4247 to graph 1.0,0.3460 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.3460 to graph 1.015,0.3460 nohead lw 0.8 lc rgb '#999999'
set label 'mount' at graph 1.02,0.3460 left
set arrow from first 256,52.8355 to graph 1.0,0.4810 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.4810 to graph 1.015,0.4810 nohead lw 0.8 lc rgb '#999999'
set label 'rings' at graph 1.02,0.4810 left
set arrow from first 256,27.4675 to graph 1.0,0.3010 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.3010 to graph 1.015,0.3010 nohead lw 0.8 lc rgb '#999999'
set label 'teapot' at graph 1.02,0.3010 left
set arrow from first 256,7.81265 to graph 1.0,0.1536 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.1536 to graph 1.015,0.1536 nohead lw 0.8 lc rgb '#999999'
set label 'tetra' at graph 1.02,0.1536 left
set arrow from first 256,72.0997 to graph 1.0,0.5260 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.5260 to graph 1.015,0.5260 nohead lw 0.8 lc rgb '#999999'
set label 'tree' at graph 1.02,0.5260 left
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
set xrange [0.909091:306.04]; set yrange [2.10871:10663.8]
set xlabel 'voxels an axis'; set ylabel 'ms a picture'
set xtics (1, 2, 4, 8, 16, 32, 64, 128, 256, 512, 1024)
set ytics ('10' 10, '100' 100, '1000' 1000, '10000' 10000)
set arrow from first 16, graph 0 to first 16, graph 1 nohead lw 1.5 dt '-' lc rgb '#444444'
set label '16: what the founding study found enough' at first 16, graph 0.97 offset 1,0 left
set arrow from first 256,42.7577 to graph 1.0,0.3910 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.3910 to graph 1.015,0.3910 nohead lw 0.8 lc rgb '#999999'
set label 'balls' at graph 1.02,0.3910 left
set arrow from first 256,50.1662 to graph 1.0,0.4360 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.4360 to graph 1.015,0.4360 nohead lw 0.8 lc rgb '#999999'
set label 'gears' at graph 1.02,0.4360 left
set arrow from first 256,28.4247 to graph 1.0,0.3460 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.3460 to graph 1.015,0.3460 nohead lw 0.8 lc rgb '#999999'
set label 'mount' at graph 1.02,0.3460 left
set arrow from first 256,52.8355 to graph 1.0,0.4810 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.4810 to graph 1.015,0.4810 nohead lw 0.8 lc rgb '#999999'
set label 'rings' at graph 1.02,0.4810 left
set arrow from first 256,27.4675 to graph 1.0,0.3010 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.3010 to graph 1.015,0.3010 nohead lw 0.8 lc rgb '#999999'
set label 'teapot' at graph 1.02,0.3010 left
set arrow from first 256,7.81265 to graph 1.0,0.1536 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.1536 to graph 1.015,0.1536 nohead lw 0.8 lc rgb '#999999'
set label 'tetra' at graph 1.02,0.1536 left
set arrow from first 256,72.0997 to graph 1.0,0.5260 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.5260 to graph 1.015,0.5260 nohead lw 0.8 lc rgb '#999999'
set label 'tree' at graph 1.02,0.5260 left
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
