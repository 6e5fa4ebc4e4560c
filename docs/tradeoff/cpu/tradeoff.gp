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
set xrange [0.64757:18.4908]; set yrange [3.05176e-06:0.0717163]
set xlabel 'million nearest hits a second  (more is better)'; set ylabel 'wrong hits  (less is better)' offset -1.5
set label 'balls: speed against accuracy (CPU, 2 threads)' at screen 0.02, screen 0.9774 font ',20'
set label '256x256 primary and 65,536 random rays a scene; 65,536 in all compared with brute force in double; pictures of 128x128' at screen 0.02, screen 0.9516
set xtics ('1' 1, '2' 2, '5' 5, '10' 10)
set ytics ("none of\n65,536" 7.62939e-06, '0.01 %%' 1e-4, '0.1 %%' 1e-3, '1 %%' 1e-2)
set object rectangle from graph 0, graph 0 to graph 1, first 1.297e-05 fs solid noborder fc rgb '#eeeeee' behind
set arrow from first 15.409,0.00192261 to graph 1.0,0.6847 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.6847 to graph 1.015,0.6847 nohead lw 0.8 lc rgb '#999999'
set label 'fast, study: irregular exact' at graph 1.02,0.6847 left
set arrow from first 14.8474,0.0018158 to graph 1.0,0.6347 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.6347 to graph 1.015,0.6347 nohead lw 0.8 lc rgb '#999999'
set label 'double, study: irregular exact' at graph 1.02,0.6347 left
set arrow from first 14.3864,0.000106812 to graph 1.0,0.3532 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.3532 to graph 1.015,0.3532 nohead lw 0.8 lc rgb '#999999'
set label 'fast: irregular exact' at graph 1.02,0.3532 left
set arrow from first 13.7261,7.62939e-06 to graph 1.0,0.0910 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.0910 to graph 1.015,0.0910 nohead lw 0.8 lc rgb '#999999'
set label 'robust: irregular exact' at graph 1.02,0.0910 left
$hits0 << END
1.0565 0.000106812
1.16529 0.000106812
4.20471 0.000106812
4.31203 0.000106812
4.30591 0.000106812
4.923 0.000106812
1.1326 0.000106812
1.063 0.000106812
2.34804 0.000106812
2.3468 0.000106812
3.03325 0.000106812
3.46719 0.000106812
1.13088 0.000106812
1.03442 0.000106812
2.67226 0.000106812
2.72357 0.000106812
4.52456 0.000106812
4.67622 0.000106812
13.1599 0.000106812
14.3864 0.000106812
END
$hits1 << END
1.05766 0.0268707
1.14619 0.0266876
4.3055 0.0286865
4.25235 0.0184937
4.08876 0.0145111
4.7947 0.00234985
1.11902 0.0268707
1.12461 0.0266876
2.44251 0.0286865
2.40311 0.0184937
3.28723 0.0145111
3.51483 0.00234985
1.10458 0.0268707
1.11326 0.0266876
2.78751 0.0286865
2.58233 0.0185394
4.85404 0.0203094
5.18422 0.00489807
14.2437 0.011673
15.409 0.00192261
END
$hits2 << END
3.14345 7.62939e-06
3.26558 7.62939e-06
4.24254 7.62939e-06
4.81003 7.62939e-06
1.9918 7.62939e-06
2.02749 7.62939e-06
3.10383 7.62939e-06
3.23361 7.62939e-06
2.21065 7.62939e-06
2.11188 7.62939e-06
4.18021 7.62939e-06
4.69565 7.62939e-06
12.7164 7.62939e-06
13.7261 7.62939e-06
2.14183 7.62939e-06
2.74309 7.62939e-06
2.96304 7.62939e-06
END
$hits3 << END
0.777084 0.0265961
3.77695 0.028595
3.66877 0.0184021
4.56018 0.0144196
4.92106 0.00224304
0.795497 0.0267792
0.795984 0.0265961
2.19463 0.028595
2.15566 0.0184021
3.1459 0.0144196
3.34419 0.00224304
0.790431 0.0267792
2.50358 0.028595
2.42508 0.0184479
4.59353 0.0202179
4.02371 0.00479126
15.0041 0.0115662
14.5915 0.0018158
END
$hits4 << END
3.10392 5.6514e-06
3.22084 5.6514e-06
4.20771 5.6514e-06
4.40447 5.6514e-06
1.97286 5.6514e-06
2.00505 5.6514e-06
3.03828 5.6514e-06
3.26628 5.6514e-06
2.16375 5.6514e-06
2.18288 5.6514e-06
4.26428 5.6514e-06
4.74356 5.6514e-06
12.5397 5.6514e-06
13.5474 5.6514e-06
END
$hits5 << END
3.65852 0.028595
3.54715 0.0184021
4.6841 0.0144196
4.84315 0.00224304
2.16772 0.028595
2.11929 0.0184021
3.40575 0.0144196
3.55594 0.00224304
2.34478 0.028595
2.28396 0.0184479
4.32958 0.0202179
4.63878 0.00479126
14.7694 0.0115662
14.8474 0.0018158
END
$hits_front << END
13.7261 7.62939e-06
14.3864 0.000106812
14.8474 0.0018158
15.409 0.00192261
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
set xrange [6.22016:113.603]; set yrange [0.000114843:0.116291]
set xlabel 'pictures a second  (more is better)'; set ylabel 'picture: RMSE of a channel  (less is better)' offset -1.5
set xtics ('7' 7, '10' 10, '15' 15, '20' 20, '30' 30, '50' 50, '70' 70, '100' 100)
set ytics ("same\nbits" 0.000287109, '10⁻³' 1e-3, '10⁻²' 1e-2, '10⁻¹' 1e-1)
set object rectangle from graph 0, graph 0 to graph 1, first 0.000488085 fs solid noborder fc rgb '#eeeeee' behind
set arrow from first 94.6692,0.0144693 to graph 1.0,0.6988 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.6988 to graph 1.015,0.6988 nohead lw 0.8 lc rgb '#999999'
set label 'fast, study: irregular exact' at graph 1.02,0.6988 left
set arrow from first 92.3097,0.00918705 to graph 1.0,0.6332 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.6332 to graph 1.015,0.6332 nohead lw 0.8 lc rgb '#999999'
set label 'fast: irregular exact' at graph 1.02,0.6332 left
set arrow from first 85.2355,0.000212673 to graph 1.0,0.0890 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.0890 to graph 1.015,0.0890 nohead lw 0.8 lc rgb '#999999'
set label 'double: irregular box' at graph 1.02,0.0890 left
$picture0 << END
11.7248 0.00918705
12.3729 0.00918705
32.4771 0.00918705
33.1299 0.00918705
38.4007 0.00918705
39.2778 0.00918705
11.9395 0.00918705
12.35 0.00918705
18.9348 0.00918705
20.4017 0.00918705
29.2662 0.00918705
29.2346 0.00918705
12.0681 0.00918705
11.0407 0.00918705
22.5785 0.00918705
21.7265 0.00918705
37.4848 0.00918705
40.8993 0.00918705
88.091 0.00918705
92.3097 0.00918705
END
$picture1 << END
8.75197 0.0454111
9.37392 0.0452486
28.9428 0.0465164
29.1795 0.0368519
36.9228 0.0318397
40.0444 0.015151
9.30787 0.0454111
9.36154 0.0452486
19.2986 0.0465164
19.1094 0.0368519
29.676 0.0318397
29.8949 0.015151
9.64032 0.0454111
8.91075 0.0452486
21.3134 0.0465164
18.703 0.0368933
37.2266 0.0379429
39.9771 0.0203198
92.6956 0.0289228
94.6692 0.0144693
END
$picture2 << END
23.5533 0.00229687
24.0049 0.00229687
36.3832 0.00229687
38.099 0.00229687
16.6937 0.00229687
16.9309 0.00229687
26.6916 0.00229687
28.4493 0.00229687
18.3727 0.00229687
17.8528 0.00229687
32.4996 0.00229687
33.4522 0.00229687
83.4091 0.00229687
81.612 0.00229687
16.1337 0.00229687
20.3124 0.00229687
23.1105 0.00229687
END
$picture3 << END
7.64392 0.0446926
26.1385 0.0460029
26.0653 0.0361277
37.8013 0.0307557
38.6648 0.0126211
7.46419 0.0448556
7.46798 0.0446926
17.7509 0.0460029
17.9115 0.0361277
27.7584 0.0307557
29.7175 0.0126211
7.78131 0.0448556
18.1488 0.0460029
17.9807 0.0361705
36.7513 0.0370789
37.6486 0.0184932
91.927 0.0276666
87.1384 0.0114011
END
$picture4 << END
23.5926 0.000212673
24.1251 0.000212673
35.2312 0.000212673
37.8361 0.000212673
16.3686 0.000212673
16.5987 0.000212673
28.1198 0.000212673
28.9853 0.000212673
16.4997 0.000212673
17.3953 0.000212673
35.7898 0.000212673
36.3613 0.000212673
85.2355 0.000212673
84.9156 0.000212673
END
$picture5 << END
25.0173 0.0459663
25.0981 0.036073
37.8175 0.0306826
38.5304 0.0124275
17.3539 0.0459663
17.162 0.036073
25.9171 0.0306826
29.9918 0.0124275
16.8866 0.0459663
17.0018 0.0361159
35.3473 0.0370265
36.1141 0.0183749
86.9233 0.0275858
89.7062 0.0111627
END
$picture_front << END
85.2355 0.000212673
92.3097 0.00918705
94.6692 0.0144693
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
set xrange [0.64757:18.4908]; set yrange [3.05176e-06:0.0717163]
set xlabel 'million nearest hits a second  (more is better)'; set ylabel 'wrong hits  (less is better)' offset -1.5
set label 'balls: speed against accuracy (CPU, 2 threads)' at screen 0.02, screen 0.9774 font ',20'
set label '256x256 primary and 65,536 random rays a scene; 65,536 in all compared with brute force in double; pictures of 128x128' at screen 0.02, screen 0.9516
set xtics ('1' 1, '2' 2, '5' 5, '10' 10)
set ytics ("none of\n65,536" 7.62939e-06, '0.01 %%' 1e-4, '0.1 %%' 1e-3, '1 %%' 1e-2)
set object rectangle from graph 0, graph 0 to graph 1, first 1.297e-05 fs solid noborder fc rgb '#eeeeee' behind
set arrow from first 15.409,0.00192261 to graph 1.0,0.6847 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.6847 to graph 1.015,0.6847 nohead lw 0.8 lc rgb '#999999'
set label 'fast, study: irregular exact' at graph 1.02,0.6847 left
set arrow from first 14.8474,0.0018158 to graph 1.0,0.6347 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.6347 to graph 1.015,0.6347 nohead lw 0.8 lc rgb '#999999'
set label 'double, study: irregular exact' at graph 1.02,0.6347 left
set arrow from first 14.3864,0.000106812 to graph 1.0,0.3532 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.3532 to graph 1.015,0.3532 nohead lw 0.8 lc rgb '#999999'
set label 'fast: irregular exact' at graph 1.02,0.3532 left
set arrow from first 13.7261,7.62939e-06 to graph 1.0,0.0910 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.0910 to graph 1.015,0.0910 nohead lw 0.8 lc rgb '#999999'
set label 'robust: irregular exact' at graph 1.02,0.0910 left
$hits0 << END
1.0565 0.000106812
1.16529 0.000106812
4.20471 0.000106812
4.31203 0.000106812
4.30591 0.000106812
4.923 0.000106812
1.1326 0.000106812
1.063 0.000106812
2.34804 0.000106812
2.3468 0.000106812
3.03325 0.000106812
3.46719 0.000106812
1.13088 0.000106812
1.03442 0.000106812
2.67226 0.000106812
2.72357 0.000106812
4.52456 0.000106812
4.67622 0.000106812
13.1599 0.000106812
14.3864 0.000106812
END
$hits1 << END
1.05766 0.0268707
1.14619 0.0266876
4.3055 0.0286865
4.25235 0.0184937
4.08876 0.0145111
4.7947 0.00234985
1.11902 0.0268707
1.12461 0.0266876
2.44251 0.0286865
2.40311 0.0184937
3.28723 0.0145111
3.51483 0.00234985
1.10458 0.0268707
1.11326 0.0266876
2.78751 0.0286865
2.58233 0.0185394
4.85404 0.0203094
5.18422 0.00489807
14.2437 0.011673
15.409 0.00192261
END
$hits2 << END
3.14345 7.62939e-06
3.26558 7.62939e-06
4.24254 7.62939e-06
4.81003 7.62939e-06
1.9918 7.62939e-06
2.02749 7.62939e-06
3.10383 7.62939e-06
3.23361 7.62939e-06
2.21065 7.62939e-06
2.11188 7.62939e-06
4.18021 7.62939e-06
4.69565 7.62939e-06
12.7164 7.62939e-06
13.7261 7.62939e-06
2.14183 7.62939e-06
2.74309 7.62939e-06
2.96304 7.62939e-06
END
$hits3 << END
0.777084 0.0265961
3.77695 0.028595
3.66877 0.0184021
4.56018 0.0144196
4.92106 0.00224304
0.795497 0.0267792
0.795984 0.0265961
2.19463 0.028595
2.15566 0.0184021
3.1459 0.0144196
3.34419 0.00224304
0.790431 0.0267792
2.50358 0.028595
2.42508 0.0184479
4.59353 0.0202179
4.02371 0.00479126
15.0041 0.0115662
14.5915 0.0018158
END
$hits4 << END
3.10392 5.6514e-06
3.22084 5.6514e-06
4.20771 5.6514e-06
4.40447 5.6514e-06
1.97286 5.6514e-06
2.00505 5.6514e-06
3.03828 5.6514e-06
3.26628 5.6514e-06
2.16375 5.6514e-06
2.18288 5.6514e-06
4.26428 5.6514e-06
4.74356 5.6514e-06
12.5397 5.6514e-06
13.5474 5.6514e-06
END
$hits5 << END
3.65852 0.028595
3.54715 0.0184021
4.6841 0.0144196
4.84315 0.00224304
2.16772 0.028595
2.11929 0.0184021
3.40575 0.0144196
3.55594 0.00224304
2.34478 0.028595
2.28396 0.0184479
4.32958 0.0202179
4.63878 0.00479126
14.7694 0.0115662
14.8474 0.0018158
END
$hits_front << END
13.7261 7.62939e-06
14.3864 0.000106812
14.8474 0.0018158
15.409 0.00192261
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
set xrange [6.22016:113.603]; set yrange [0.000114843:0.116291]
set xlabel 'pictures a second  (more is better)'; set ylabel 'picture: RMSE of a channel  (less is better)' offset -1.5
set xtics ('7' 7, '10' 10, '15' 15, '20' 20, '30' 30, '50' 50, '70' 70, '100' 100)
set ytics ("same\nbits" 0.000287109, '10⁻³' 1e-3, '10⁻²' 1e-2, '10⁻¹' 1e-1)
set object rectangle from graph 0, graph 0 to graph 1, first 0.000488085 fs solid noborder fc rgb '#eeeeee' behind
set arrow from first 94.6692,0.0144693 to graph 1.0,0.6988 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.6988 to graph 1.015,0.6988 nohead lw 0.8 lc rgb '#999999'
set label 'fast, study: irregular exact' at graph 1.02,0.6988 left
set arrow from first 92.3097,0.00918705 to graph 1.0,0.6332 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.6332 to graph 1.015,0.6332 nohead lw 0.8 lc rgb '#999999'
set label 'fast: irregular exact' at graph 1.02,0.6332 left
set arrow from first 85.2355,0.000212673 to graph 1.0,0.0890 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.0890 to graph 1.015,0.0890 nohead lw 0.8 lc rgb '#999999'
set label 'double: irregular box' at graph 1.02,0.0890 left
$picture0 << END
11.7248 0.00918705
12.3729 0.00918705
32.4771 0.00918705
33.1299 0.00918705
38.4007 0.00918705
39.2778 0.00918705
11.9395 0.00918705
12.35 0.00918705
18.9348 0.00918705
20.4017 0.00918705
29.2662 0.00918705
29.2346 0.00918705
12.0681 0.00918705
11.0407 0.00918705
22.5785 0.00918705
21.7265 0.00918705
37.4848 0.00918705
40.8993 0.00918705
88.091 0.00918705
92.3097 0.00918705
END
$picture1 << END
8.75197 0.0454111
9.37392 0.0452486
28.9428 0.0465164
29.1795 0.0368519
36.9228 0.0318397
40.0444 0.015151
9.30787 0.0454111
9.36154 0.0452486
19.2986 0.0465164
19.1094 0.0368519
29.676 0.0318397
29.8949 0.015151
9.64032 0.0454111
8.91075 0.0452486
21.3134 0.0465164
18.703 0.0368933
37.2266 0.0379429
39.9771 0.0203198
92.6956 0.0289228
94.6692 0.0144693
END
$picture2 << END
23.5533 0.00229687
24.0049 0.00229687
36.3832 0.00229687
38.099 0.00229687
16.6937 0.00229687
16.9309 0.00229687
26.6916 0.00229687
28.4493 0.00229687
18.3727 0.00229687
17.8528 0.00229687
32.4996 0.00229687
33.4522 0.00229687
83.4091 0.00229687
81.612 0.00229687
16.1337 0.00229687
20.3124 0.00229687
23.1105 0.00229687
END
$picture3 << END
7.64392 0.0446926
26.1385 0.0460029
26.0653 0.0361277
37.8013 0.0307557
38.6648 0.0126211
7.46419 0.0448556
7.46798 0.0446926
17.7509 0.0460029
17.9115 0.0361277
27.7584 0.0307557
29.7175 0.0126211
7.78131 0.0448556
18.1488 0.0460029
17.9807 0.0361705
36.7513 0.0370789
37.6486 0.0184932
91.927 0.0276666
87.1384 0.0114011
END
$picture4 << END
23.5926 0.000212673
24.1251 0.000212673
35.2312 0.000212673
37.8361 0.000212673
16.3686 0.000212673
16.5987 0.000212673
28.1198 0.000212673
28.9853 0.000212673
16.4997 0.000212673
17.3953 0.000212673
35.7898 0.000212673
36.3613 0.000212673
85.2355 0.000212673
84.9156 0.000212673
END
$picture5 << END
25.0173 0.0459663
25.0981 0.036073
37.8175 0.0306826
38.5304 0.0124275
17.3539 0.0459663
17.162 0.036073
25.9171 0.0306826
29.9918 0.0124275
16.8866 0.0459663
17.0018 0.0361159
35.3473 0.0370265
36.1141 0.0183749
86.9233 0.0275858
89.7062 0.0111627
END
$picture_front << END
85.2355 0.000212673
92.3097 0.00918705
94.6692 0.0144693
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
set xrange [1.08924:17.4652]; set yrange [3.05176e-06:0.00156403]
set xlabel 'million nearest hits a second  (more is better)'; set ylabel 'wrong hits  (less is better)' offset -1.5
set label 'gears: speed against accuracy (CPU, 2 threads)' at screen 0.02, screen 0.9774 font ',20'
set label '256x256 primary and 65,536 random rays a scene; 65,536 in all compared with brute force in double; pictures of 128x128' at screen 0.02, screen 0.9516
set xtics ('1.5' 1.5, '2' 2, '3' 3, '5' 5, '7' 7, '10' 10, '15' 15)
set ytics ("none of\n65,536" 7.62939e-06, '0.01 %%' 1e-4, '0.1 %%' 1e-3)
set object rectangle from graph 0, graph 0 to graph 1, first 1.297e-05 fs solid noborder fc rgb '#eeeeee' behind
set arrow from first 14.5543,6.10352e-05 to graph 1.0,0.4801 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.4801 to graph 1.015,0.4801 nohead lw 0.8 lc rgb '#999999'
set label 'robust, study: irregular exact' at graph 1.02,0.4801 left
set arrow from first 13.4424,5.6514e-06 to graph 1.0,0.0988 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.0988 to graph 1.015,0.0988 nohead lw 0.8 lc rgb '#999999'
set label 'double: irregular exact' at graph 1.02,0.0988 left
$hits0 << END
3.27129 1.02997e-05
3.32448 1.02997e-05
4.63579 1.02997e-05
4.0127 1.02997e-05
4.99914 1.02997e-05
4.67151 1.02997e-05
3.04984 1.02997e-05
2.86237 1.02997e-05
2.53095 1.02997e-05
2.70998 1.02997e-05
3.01043 1.02997e-05
3.14356 1.02997e-05
3.26993 1.02997e-05
3.25319 1.02997e-05
5.18914 1.02997e-05
4.68812 1.02997e-05
4.13514 1.02997e-05
3.43755 1.02997e-05
9.53334 1.02997e-05
11.6892 1.02997e-05
END
$hits1 << END
2.40766 0.000152588
2.45809 0.000152588
4.50056 7.62939e-05
4.77724 3.05176e-05
4.84314 0.00050354
4.91108 0.000152588
2.22978 0.000152588
2.20645 0.000152588
2.45489 7.62939e-05
2.83176 3.05176e-05
3.03626 0.00050354
3.25946 0.000152588
2.3541 0.000152588
2.34983 0.000152588
5.12299 0.000289917
4.53953 3.05176e-05
3.88049 0.00062561
3.17605 0.000366211
9.64119 0.000259399
12.9631 6.10352e-05
END
$hits2 << END
4.01417 7.62939e-06
3.97785 7.62939e-06
5.17861 7.62939e-06
5.35545 7.62939e-06
5.21289 7.62939e-06
4.82949 7.62939e-06
3.49453 7.62939e-06
3.23579 7.62939e-06
2.91456 7.62939e-06
2.98385 7.62939e-06
3.04295 7.62939e-06
3.31482 7.62939e-06
3.957 7.62939e-06
3.39007 7.62939e-06
5.88573 7.62939e-06
5.25863 7.62939e-06
4.13646 7.62939e-06
4.05384 7.62939e-06
10.4274 7.62939e-06
13.1793 7.62939e-06
1.30709 7.62939e-06
6.22087 7.62939e-06
3.29093 7.62939e-06
4.24004 7.62939e-06
END
$hits3 << END
4.31707 0.000152588
4.39887 0.000152588
5.5167 7.62939e-05
5.72512 3.05176e-05
5.31909 0.00050354
5.24605 0.000152588
3.65044 0.000152588
3.36671 0.000152588
3.06405 7.62939e-05
3.07471 3.05176e-05
3.2018 0.00050354
3.35013 0.000152588
4.15019 0.000152588
3.70588 0.000152588
6.45415 0.000289917
5.58412 3.05176e-05
4.39289 0.00062561
4.14946 0.000366211
11.7122 0.000259399
14.5543 6.10352e-05
END
$hits4 << END
3.06273 5.6514e-06
2.10066 5.6514e-06
5.01874 5.6514e-06
5.24203 5.6514e-06
5.15756 5.6514e-06
5.04978 5.6514e-06
2.84236 5.6514e-06
2.8289 5.6514e-06
2.93844 5.6514e-06
2.93754 5.6514e-06
3.18871 5.6514e-06
3.39499 5.6514e-06
3.3268 5.6514e-06
3.38588 5.6514e-06
5.62056 5.6514e-06
4.99911 5.6514e-06
4.00462 5.6514e-06
3.87537 5.6514e-06
11.6343 5.6514e-06
13.4424 5.6514e-06
END
$hits5 << END
3.74972 0.000152588
3.47191 0.000152588
5.50898 7.62939e-05
5.58825 3.05176e-05
5.38322 0.00050354
4.94996 0.000152588
2.70113 0.000152588
3.58574 0.000152588
3.08512 7.62939e-05
3.04705 3.05176e-05
3.404 0.00050354
3.65851 0.000152588
3.58709 0.000152588
3.69718 0.000152588
6.06827 0.000289917
5.6474 3.05176e-05
4.33749 0.00062561
3.99075 0.000366211
11.4983 0.000259399
13.5203 6.10352e-05
END
$hits_front << END
13.4424 5.6514e-06
14.5543 6.10352e-05
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
set xrange [5.79098:76.6528]; set yrange [2.21855e-08:0.0161019]
set xlabel 'pictures a second  (more is better)'; set ylabel 'picture: RMSE of a channel  (less is better)' offset -1.5
set xtics ('7' 7, '10' 10, '15' 15, '20' 20, '30' 30, '50' 50, '70' 70)
set ytics ("same\nbits" 5.54636e-08, '10⁻⁶' 1e-6, '10⁻⁵' 1e-5, '10⁻⁴' 1e-4, '10⁻³' 1e-3, '10⁻²' 1e-2)
set object rectangle from graph 0, graph 0 to graph 1, first 9.42882e-08 fs solid noborder fc rgb '#eeeeee' behind
set arrow from first 63.8774,0.00241446 to graph 1.0,0.8594 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.8594 to graph 1.015,0.8594 nohead lw 0.8 lc rgb '#999999'
set label 'robust, study: irregular exact' at graph 1.02,0.8594 left
set arrow from first 62.4949,4.43709e-07 to graph 1.0,0.2220 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.2220 to graph 1.015,0.2220 nohead lw 0.8 lc rgb '#999999'
set label 'robust: irregular exact' at graph 1.02,0.2220 left
set arrow from first 60.6925,4.10842e-08 to graph 1.0,0.0457 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.0457 to graph 1.015,0.0457 nohead lw 0.8 lc rgb '#999999'
set label 'double: irregular exact' at graph 1.02,0.0457 left
$picture0 << END
15.5079 0.00319435
15.6217 0.00319435
27.7653 0.00319435
28.188 0.00319435
32.0352 0.00319435
33.8733 0.00319435
14.7347 0.00319435
14.4516 0.00319435
17.1002 0.00319435
19.1881 0.00319435
21.5553 0.00319435
22.9294 0.00319435
15.3196 0.00319435
14.7641 0.00319435
29.4699 0.00319435
26.1819 0.00319435
24.7128 0.00319435
22.9294 0.00319435
53.049 0.00319435
61.1524 0.00319435
END
$picture1 << END
12.2129 0.00383996
12.4234 0.00383912
26.5573 0.00319435
27.7012 0.0042878
31.1841 0.00642127
33.5627 0.00454316
14.2301 0.00383996
14.2573 0.00383912
19.2718 0.00319435
18.8328 0.0042878
21.7344 0.00642127
22.9365 0.00454316
15.0034 0.00383996
14.2909 0.00383912
30.4733 0.00365496
27.2274 0.0042878
24.8236 0.00644074
23.6529 0.00561794
53.0625 0.00413272
61.1438 0.00400417
END
$picture2 << END
18.9544 4.43709e-07
19.4162 4.43709e-07
31.2094 4.43709e-07
33.7702 4.43709e-07
33.8741 4.43709e-07
34.8527 4.43709e-07
17.6565 4.43709e-07
16.4925 4.43709e-07
21.1945 4.43709e-07
21.1142 4.43709e-07
22.3047 4.43709e-07
23.1211 4.43709e-07
19.2314 4.43709e-07
16.6928 4.43709e-07
33.5362 4.43709e-07
31.7081 4.43709e-07
27.5786 4.43709e-07
27.4203 4.43709e-07
54.1562 4.43709e-07
62.4949 4.43709e-07
6.94917 4.43709e-07
36.4591 4.43709e-07
23.1979 4.43709e-07
24.5352 4.43709e-07
END
$picture3 << END
19.042 0.00213107
19.7217 0.00212955
32.5687 4.43709e-07
34.1483 0.00286034
34.3157 0.00557035
35.1108 0.00323054
17.7392 0.00213107
16.9124 0.00212955
21.2256 4.43709e-07
21.043 0.00286034
22.4164 0.00557035
23.7661 0.00323054
19.3011 0.00213107
18.9228 0.00212955
33.4684 0.00177614
32.6551 0.00286034
28.0685 0.00559278
27.1531 0.00462139
56.4586 0.00262212
63.8774 0.00241446
END
$picture4 << END
12.2883 4.10842e-08
15.1915 4.10842e-08
28.8287 4.10842e-08
30.0667 4.10842e-08
32.5321 4.10842e-08
34.3451 4.10842e-08
12.8402 4.10842e-08
12.7372 4.10842e-08
20.2104 4.10842e-08
20.8026 4.10842e-08
22.4359 4.10842e-08
24.0525 4.10842e-08
14.9712 4.10842e-08
15.0332 4.10842e-08
31.8856 4.10842e-08
28.3401 4.10842e-08
26.006 4.10842e-08
25.3213 4.10842e-08
51.7087 4.10842e-08
60.6925 4.10842e-08
END
$picture5 << END
15.3343 0.00213107
15.681 0.00212955
30.1257 4.10842e-08
31.2525 0.00286034
32.8702 0.00557035
34.5236 0.00323054
12.4644 0.00213107
12.8313 0.00212955
20.8488 4.10842e-08
21.3947 0.00286034
23.1682 0.00557035
24.2051 0.00323054
15.1618 0.00213107
15.2912 0.00212955
32.3802 0.00177613
28.9022 0.00286034
26.5052 0.00559278
25.3598 0.00462139
52.9327 0.00262212
61.6006 0.00241446
END
$picture_front << END
60.6925 4.10842e-08
62.4949 4.43709e-07
63.8774 0.00241446
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
set xrange [1.08924:17.4652]; set yrange [3.05176e-06:0.00156403]
set xlabel 'million nearest hits a second  (more is better)'; set ylabel 'wrong hits  (less is better)' offset -1.5
set label 'gears: speed against accuracy (CPU, 2 threads)' at screen 0.02, screen 0.9774 font ',20'
set label '256x256 primary and 65,536 random rays a scene; 65,536 in all compared with brute force in double; pictures of 128x128' at screen 0.02, screen 0.9516
set xtics ('1.5' 1.5, '2' 2, '3' 3, '5' 5, '7' 7, '10' 10, '15' 15)
set ytics ("none of\n65,536" 7.62939e-06, '0.01 %%' 1e-4, '0.1 %%' 1e-3)
set object rectangle from graph 0, graph 0 to graph 1, first 1.297e-05 fs solid noborder fc rgb '#eeeeee' behind
set arrow from first 14.5543,6.10352e-05 to graph 1.0,0.4801 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.4801 to graph 1.015,0.4801 nohead lw 0.8 lc rgb '#999999'
set label 'robust, study: irregular exact' at graph 1.02,0.4801 left
set arrow from first 13.4424,5.6514e-06 to graph 1.0,0.0988 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.0988 to graph 1.015,0.0988 nohead lw 0.8 lc rgb '#999999'
set label 'double: irregular exact' at graph 1.02,0.0988 left
$hits0 << END
3.27129 1.02997e-05
3.32448 1.02997e-05
4.63579 1.02997e-05
4.0127 1.02997e-05
4.99914 1.02997e-05
4.67151 1.02997e-05
3.04984 1.02997e-05
2.86237 1.02997e-05
2.53095 1.02997e-05
2.70998 1.02997e-05
3.01043 1.02997e-05
3.14356 1.02997e-05
3.26993 1.02997e-05
3.25319 1.02997e-05
5.18914 1.02997e-05
4.68812 1.02997e-05
4.13514 1.02997e-05
3.43755 1.02997e-05
9.53334 1.02997e-05
11.6892 1.02997e-05
END
$hits1 << END
2.40766 0.000152588
2.45809 0.000152588
4.50056 7.62939e-05
4.77724 3.05176e-05
4.84314 0.00050354
4.91108 0.000152588
2.22978 0.000152588
2.20645 0.000152588
2.45489 7.62939e-05
2.83176 3.05176e-05
3.03626 0.00050354
3.25946 0.000152588
2.3541 0.000152588
2.34983 0.000152588
5.12299 0.000289917
4.53953 3.05176e-05
3.88049 0.00062561
3.17605 0.000366211
9.64119 0.000259399
12.9631 6.10352e-05
END
$hits2 << END
4.01417 7.62939e-06
3.97785 7.62939e-06
5.17861 7.62939e-06
5.35545 7.62939e-06
5.21289 7.62939e-06
4.82949 7.62939e-06
3.49453 7.62939e-06
3.23579 7.62939e-06
2.91456 7.62939e-06
2.98385 7.62939e-06
3.04295 7.62939e-06
3.31482 7.62939e-06
3.957 7.62939e-06
3.39007 7.62939e-06
5.88573 7.62939e-06
5.25863 7.62939e-06
4.13646 7.62939e-06
4.05384 7.62939e-06
10.4274 7.62939e-06
13.1793 7.62939e-06
1.30709 7.62939e-06
6.22087 7.62939e-06
3.29093 7.62939e-06
4.24004 7.62939e-06
END
$hits3 << END
4.31707 0.000152588
4.39887 0.000152588
5.5167 7.62939e-05
5.72512 3.05176e-05
5.31909 0.00050354
5.24605 0.000152588
3.65044 0.000152588
3.36671 0.000152588
3.06405 7.62939e-05
3.07471 3.05176e-05
3.2018 0.00050354
3.35013 0.000152588
4.15019 0.000152588
3.70588 0.000152588
6.45415 0.000289917
5.58412 3.05176e-05
4.39289 0.00062561
4.14946 0.000366211
11.7122 0.000259399
14.5543 6.10352e-05
END
$hits4 << END
3.06273 5.6514e-06
2.10066 5.6514e-06
5.01874 5.6514e-06
5.24203 5.6514e-06
5.15756 5.6514e-06
5.04978 5.6514e-06
2.84236 5.6514e-06
2.8289 5.6514e-06
2.93844 5.6514e-06
2.93754 5.6514e-06
3.18871 5.6514e-06
3.39499 5.6514e-06
3.3268 5.6514e-06
3.38588 5.6514e-06
5.62056 5.6514e-06
4.99911 5.6514e-06
4.00462 5.6514e-06
3.87537 5.6514e-06
11.6343 5.6514e-06
13.4424 5.6514e-06
END
$hits5 << END
3.74972 0.000152588
3.47191 0.000152588
5.50898 7.62939e-05
5.58825 3.05176e-05
5.38322 0.00050354
4.94996 0.000152588
2.70113 0.000152588
3.58574 0.000152588
3.08512 7.62939e-05
3.04705 3.05176e-05
3.404 0.00050354
3.65851 0.000152588
3.58709 0.000152588
3.69718 0.000152588
6.06827 0.000289917
5.6474 3.05176e-05
4.33749 0.00062561
3.99075 0.000366211
11.4983 0.000259399
13.5203 6.10352e-05
END
$hits_front << END
13.4424 5.6514e-06
14.5543 6.10352e-05
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
set xrange [5.79098:76.6528]; set yrange [2.21855e-08:0.0161019]
set xlabel 'pictures a second  (more is better)'; set ylabel 'picture: RMSE of a channel  (less is better)' offset -1.5
set xtics ('7' 7, '10' 10, '15' 15, '20' 20, '30' 30, '50' 50, '70' 70)
set ytics ("same\nbits" 5.54636e-08, '10⁻⁶' 1e-6, '10⁻⁵' 1e-5, '10⁻⁴' 1e-4, '10⁻³' 1e-3, '10⁻²' 1e-2)
set object rectangle from graph 0, graph 0 to graph 1, first 9.42882e-08 fs solid noborder fc rgb '#eeeeee' behind
set arrow from first 63.8774,0.00241446 to graph 1.0,0.8594 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.8594 to graph 1.015,0.8594 nohead lw 0.8 lc rgb '#999999'
set label 'robust, study: irregular exact' at graph 1.02,0.8594 left
set arrow from first 62.4949,4.43709e-07 to graph 1.0,0.2220 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.2220 to graph 1.015,0.2220 nohead lw 0.8 lc rgb '#999999'
set label 'robust: irregular exact' at graph 1.02,0.2220 left
set arrow from first 60.6925,4.10842e-08 to graph 1.0,0.0457 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.0457 to graph 1.015,0.0457 nohead lw 0.8 lc rgb '#999999'
set label 'double: irregular exact' at graph 1.02,0.0457 left
$picture0 << END
15.5079 0.00319435
15.6217 0.00319435
27.7653 0.00319435
28.188 0.00319435
32.0352 0.00319435
33.8733 0.00319435
14.7347 0.00319435
14.4516 0.00319435
17.1002 0.00319435
19.1881 0.00319435
21.5553 0.00319435
22.9294 0.00319435
15.3196 0.00319435
14.7641 0.00319435
29.4699 0.00319435
26.1819 0.00319435
24.7128 0.00319435
22.9294 0.00319435
53.049 0.00319435
61.1524 0.00319435
END
$picture1 << END
12.2129 0.00383996
12.4234 0.00383912
26.5573 0.00319435
27.7012 0.0042878
31.1841 0.00642127
33.5627 0.00454316
14.2301 0.00383996
14.2573 0.00383912
19.2718 0.00319435
18.8328 0.0042878
21.7344 0.00642127
22.9365 0.00454316
15.0034 0.00383996
14.2909 0.00383912
30.4733 0.00365496
27.2274 0.0042878
24.8236 0.00644074
23.6529 0.00561794
53.0625 0.00413272
61.1438 0.00400417
END
$picture2 << END
18.9544 4.43709e-07
19.4162 4.43709e-07
31.2094 4.43709e-07
33.7702 4.43709e-07
33.8741 4.43709e-07
34.8527 4.43709e-07
17.6565 4.43709e-07
16.4925 4.43709e-07
21.1945 4.43709e-07
21.1142 4.43709e-07
22.3047 4.43709e-07
23.1211 4.43709e-07
19.2314 4.43709e-07
16.6928 4.43709e-07
33.5362 4.43709e-07
31.7081 4.43709e-07
27.5786 4.43709e-07
27.4203 4.43709e-07
54.1562 4.43709e-07
62.4949 4.43709e-07
6.94917 4.43709e-07
36.4591 4.43709e-07
23.1979 4.43709e-07
24.5352 4.43709e-07
END
$picture3 << END
19.042 0.00213107
19.7217 0.00212955
32.5687 4.43709e-07
34.1483 0.00286034
34.3157 0.00557035
35.1108 0.00323054
17.7392 0.00213107
16.9124 0.00212955
21.2256 4.43709e-07
21.043 0.00286034
22.4164 0.00557035
23.7661 0.00323054
19.3011 0.00213107
18.9228 0.00212955
33.4684 0.00177614
32.6551 0.00286034
28.0685 0.00559278
27.1531 0.00462139
56.4586 0.00262212
63.8774 0.00241446
END
$picture4 << END
12.2883 4.10842e-08
15.1915 4.10842e-08
28.8287 4.10842e-08
30.0667 4.10842e-08
32.5321 4.10842e-08
34.3451 4.10842e-08
12.8402 4.10842e-08
12.7372 4.10842e-08
20.2104 4.10842e-08
20.8026 4.10842e-08
22.4359 4.10842e-08
24.0525 4.10842e-08
14.9712 4.10842e-08
15.0332 4.10842e-08
31.8856 4.10842e-08
28.3401 4.10842e-08
26.006 4.10842e-08
25.3213 4.10842e-08
51.7087 4.10842e-08
60.6925 4.10842e-08
END
$picture5 << END
15.3343 0.00213107
15.681 0.00212955
30.1257 4.10842e-08
31.2525 0.00286034
32.8702 0.00557035
34.5236 0.00323054
12.4644 0.00213107
12.8313 0.00212955
20.8488 4.10842e-08
21.3947 0.00286034
23.1682 0.00557035
24.2051 0.00323054
15.1618 0.00213107
15.2912 0.00212955
32.3802 0.00177613
28.9022 0.00286034
26.5052 0.00559278
25.3598 0.00462139
52.9327 0.00262212
61.6006 0.00241446
END
$picture_front << END
60.6925 4.10842e-08
62.4949 4.43709e-07
63.8774 0.00241446
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
set xrange [0.985817:12.5082]; set yrange [3.05176e-06:0.001297]
set xlabel 'million nearest hits a second  (more is better)'; set ylabel 'wrong hits  (less is better)' offset -1.5
set label 'mount: speed against accuracy (CPU, 2 threads)' at screen 0.02, screen 0.9774 font ',20'
set label '256x256 primary and 65,536 random rays a scene; 65,536 in all compared with brute force in double; pictures of 128x128' at screen 0.02, screen 0.9516
set xtics ('1' 1, '1.5' 1.5, '2' 2, '3' 3, '5' 5, '7' 7, '10' 10)
set ytics ("none of\n65,536" 7.62939e-06, '0.01 %%' 1e-4, '0.1 %%' 1e-3)
set object rectangle from graph 0, graph 0 to graph 1, first 1.297e-05 fs solid noborder fc rgb '#eeeeee' behind
set arrow from first 10.4235,1.52588e-05 to graph 1.0,0.2659 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.2659 to graph 1.015,0.2659 nohead lw 0.8 lc rgb '#999999'
set label 'robust, study: irregular exact' at graph 1.02,0.2659 left
set arrow from first 9.52399,5.6514e-06 to graph 1.0,0.1018 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.1018 to graph 1.015,0.1018 nohead lw 0.8 lc rgb '#999999'
set label 'double: irregular exact' at graph 1.02,0.1018 left
$hits0 << END
5.11338 1.02997e-05
4.33844 1.02997e-05
2.71076 1.02997e-05
3.96267 1.02997e-05
4.59045 1.02997e-05
4.27241 1.02997e-05
4.46961 1.02997e-05
4.67027 1.02997e-05
2.44526 1.02997e-05
2.55945 1.02997e-05
3.42594 1.02997e-05
3.7688 1.02997e-05
4.43182 1.02997e-05
4.66111 1.02997e-05
1.62509 1.02997e-05
1.55746 1.02997e-05
2.60509 1.02997e-05
2.65963 1.02997e-05
7.55238 1.02997e-05
8.41836 1.02997e-05
END
$hits1 << END
4.5738 6.10352e-05
3.77791 4.57764e-05
3.40652 1.52588e-05
3.95515 1.02997e-05
4.40577 0.000213623
4.32834 7.62939e-05
4.02109 6.10352e-05
4.14594 4.57764e-05
2.41451 1.52588e-05
2.68901 1.02997e-05
3.332 0.000213623
3.87962 7.62939e-05
3.52269 0.000183105
3.98994 0.000167847
1.22351 0.000198364
1.18298 0.000473022
2.32065 0.000350952
2.38945 0.000518799
8.25993 9.15527e-05
8.94501 1.52588e-05
END
$hits2 << END
5.58845 7.62939e-06
4.33149 7.62939e-06
3.20019 7.62939e-06
4.186 7.62939e-06
4.53941 7.62939e-06
5.40663 7.62939e-06
5.02826 7.62939e-06
5.29323 7.62939e-06
2.46227 7.62939e-06
2.64463 7.62939e-06
3.14588 7.62939e-06
4.00102 7.62939e-06
4.92821 7.62939e-06
5.60088 7.62939e-06
1.74105 7.62939e-06
1.71628 7.62939e-06
2.91067 7.62939e-06
3.01756 7.62939e-06
8.60142 7.62939e-06
9.43744 7.62939e-06
1.28693 7.62939e-06
3.85244 7.62939e-06
6.31229 7.62939e-06
1.93479 7.62939e-06
3.03713 7.62939e-06
END
$hits3 << END
6.35491 6.10352e-05
4.75371 4.57764e-05
3.60121 1.52588e-05
4.24955 7.62939e-06
4.79264 0.000213623
5.72545 7.62939e-05
5.5705 6.10352e-05
5.88788 4.57764e-05
2.69261 1.52588e-05
2.76297 7.62939e-06
3.88016 0.000213623
4.14419 7.62939e-05
5.82233 0.000183105
6.04272 0.000167847
1.78999 0.000198364
1.75437 0.000473022
3.16171 0.000350952
3.1945 0.000518799
9.84836 9.15527e-05
10.4235 1.52588e-05
END
$hits4 << END
3.83829 5.6514e-06
4.00365 5.6514e-06
3.76842 5.6514e-06
3.97487 5.6514e-06
4.43851 5.6514e-06
5.30075 5.6514e-06
5.24987 5.6514e-06
4.92829 5.6514e-06
2.48625 5.6514e-06
2.69064 5.6514e-06
3.56071 5.6514e-06
4.09918 5.6514e-06
5.02226 5.6514e-06
5.26229 5.6514e-06
1.5279 5.6514e-06
1.60248 5.6514e-06
2.7388 5.6514e-06
2.84124 5.6514e-06
8.64392 5.6514e-06
9.52399 5.6514e-06
END
$hits5 << END
4.29721 6.10352e-05
4.35586 4.57764e-05
4.11669 1.52588e-05
4.20584 5.6514e-06
4.81743 0.000213623
5.26887 7.62939e-05
5.51046 6.10352e-05
5.38774 4.57764e-05
2.695 1.52588e-05
2.84205 5.6514e-06
4.02987 0.000213623
4.30402 7.62939e-05
5.39573 0.000183105
5.68987 0.000167847
1.60967 0.000198364
1.64949 0.000473022
2.9565 0.000350952
3.01732 0.000518799
9.71973 9.15527e-05
10.0714 1.52588e-05
END
$hits_front << END
9.52399 5.6514e-06
10.4235 1.52588e-05
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
set xrange [20.1893:125.779]; set yrange [5.91675e-06:0.0144206]
set xlabel 'pictures a second  (more is better)'; set ylabel 'picture: RMSE of a channel  (less is better)' offset -1.5
set xtics ('30' 30, '50' 50, '70' 70, '100' 100)
set ytics ("same\nbits" 1.47919e-05, '10⁻⁴' 1e-4, '10⁻³' 1e-3, '10⁻²' 1e-2)
set object rectangle from graph 0, graph 0 to graph 1, first 2.51462e-05 fs solid noborder fc rgb '#eeeeee' behind
set arrow from first 104.816,0.00517964 to graph 1.0,0.8687 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.8687 to graph 1.015,0.8687 nohead lw 0.8 lc rgb '#999999'
set label 'fast, study: irregular exact' at graph 1.02,0.8687 left
set arrow from first 104.508,1.09569e-05 to graph 1.0,0.0790 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.0790 to graph 1.015,0.0790 nohead lw 0.8 lc rgb '#999999'
set label 'double, study: irregular exact' at graph 1.02,0.0790 left
$picture0 << END
68.0332 0.00517964
58.5374 0.00517964
47.2925 0.00517964
56.0158 0.00517964
61.0627 0.00517964
56.3533 0.00517964
60.7493 0.00517964
62.1465 0.00517964
35.5816 0.00517964
40.298 0.00517964
47.7218 0.00517964
52.2005 0.00517964
62.5407 0.00517964
65.4022 0.00517964
31.0628 0.00517964
27.714 0.00517964
47.5679 0.00517964
47.9929 0.00517964
91.9422 0.00517964
98.2174 0.00517964
END
$picture1 << END
64.2682 0.00531405
54.9487 0.00531405
59.4658 0.00519279
63.2871 0.00517964
62.4586 0.00576825
71.4755 0.00551613
66.9519 0.00531405
68.534 0.00531405
44.4373 0.00519279
47.1698 0.00517964
53.4659 0.00576825
62.0802 0.00551613
66.9577 0.00531405
70.2149 0.00531405
32.3032 0.00519239
29.6842 0.00520441
52.6621 0.00576825
53.6052 0.0055394
100.533 0.00531712
104.816 0.00517964
END
$picture2 << END
74.6196 0.000118335
56.5 0.000118335
48.3826 0.000118335
58.9178 0.000118335
51.0621 0.000118335
70.3646 0.000118335
64.895 0.000118335
71.4041 0.000118335
36.8836 0.000118335
42.1742 0.000118335
49.2206 0.000118335
54.9303 0.000118335
71.9135 0.000118335
74.2545 0.000118335
31.633 0.000118335
30.5005 0.000118335
49.0745 0.000118335
50.3596 0.000118335
96.0061 0.000118335
99.4639 0.000118335
24.2272 0.000118335
59.0267 0.000118335
75.6447 0.000118335
30.6433 0.000118335
35.7121 0.000118335
END
$picture3 << END
84.3078 0.00159667
63.4417 0.00159667
65.7358 0.000387878
65.7873 0.000118335
68.3335 0.00254127
80.9651 0.0019008
76.4076 0.00159667
79.2896 0.00159667
45.0165 0.000387878
48.5001 0.000118335
62.1276 0.00254127
63.7227 0.0019008
77.7744 0.00159667
79.6502 0.00159667
33.4306 0.000382429
33.638 0.000520823
53.504 0.00254127
55.8313 0.0019673
100.336 0.00120712
103.611 0.000118335
END
$picture4 << END
52.3555 1.09569e-05
53.6855 1.09569e-05
50.8363 1.09569e-05
56.0566 1.09569e-05
57.6575 1.09569e-05
67.2183 1.09569e-05
65.3962 1.09569e-05
68.4927 1.09569e-05
36.1974 1.09569e-05
41.468 1.09569e-05
47.8858 1.09569e-05
54.5974 1.09569e-05
67.9657 1.09569e-05
71.5123 1.09569e-05
27.4959 1.09569e-05
27.5153 1.09569e-05
47.482 1.09569e-05
47.9448 1.09569e-05
95.8166 1.09569e-05
99.8273 1.09569e-05
END
$picture5 << END
60.2508 0.00159428
61.2209 0.00159428
65.2822 0.000369387
68.604 1.09569e-05
60.825 0.00253977
71.4745 0.00189879
75.2587 0.00159428
74.1911 0.00159428
47.28 0.000369387
50.046 1.09569e-05
62.074 0.00253977
64.774 0.00189879
74.6464 0.00159428
76.7077 0.00159428
32.675 0.00036366
31.6291 0.000509379
53.0783 0.00253977
53.9174 0.00196593
100.65 0.0012013
104.508 1.09569e-05
END
$picture_front << END
104.508 1.09569e-05
104.816 0.00517964
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
set xrange [0.985817:12.5082]; set yrange [3.05176e-06:0.001297]
set xlabel 'million nearest hits a second  (more is better)'; set ylabel 'wrong hits  (less is better)' offset -1.5
set label 'mount: speed against accuracy (CPU, 2 threads)' at screen 0.02, screen 0.9774 font ',20'
set label '256x256 primary and 65,536 random rays a scene; 65,536 in all compared with brute force in double; pictures of 128x128' at screen 0.02, screen 0.9516
set xtics ('1' 1, '1.5' 1.5, '2' 2, '3' 3, '5' 5, '7' 7, '10' 10)
set ytics ("none of\n65,536" 7.62939e-06, '0.01 %%' 1e-4, '0.1 %%' 1e-3)
set object rectangle from graph 0, graph 0 to graph 1, first 1.297e-05 fs solid noborder fc rgb '#eeeeee' behind
set arrow from first 10.4235,1.52588e-05 to graph 1.0,0.2659 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.2659 to graph 1.015,0.2659 nohead lw 0.8 lc rgb '#999999'
set label 'robust, study: irregular exact' at graph 1.02,0.2659 left
set arrow from first 9.52399,5.6514e-06 to graph 1.0,0.1018 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.1018 to graph 1.015,0.1018 nohead lw 0.8 lc rgb '#999999'
set label 'double: irregular exact' at graph 1.02,0.1018 left
$hits0 << END
5.11338 1.02997e-05
4.33844 1.02997e-05
2.71076 1.02997e-05
3.96267 1.02997e-05
4.59045 1.02997e-05
4.27241 1.02997e-05
4.46961 1.02997e-05
4.67027 1.02997e-05
2.44526 1.02997e-05
2.55945 1.02997e-05
3.42594 1.02997e-05
3.7688 1.02997e-05
4.43182 1.02997e-05
4.66111 1.02997e-05
1.62509 1.02997e-05
1.55746 1.02997e-05
2.60509 1.02997e-05
2.65963 1.02997e-05
7.55238 1.02997e-05
8.41836 1.02997e-05
END
$hits1 << END
4.5738 6.10352e-05
3.77791 4.57764e-05
3.40652 1.52588e-05
3.95515 1.02997e-05
4.40577 0.000213623
4.32834 7.62939e-05
4.02109 6.10352e-05
4.14594 4.57764e-05
2.41451 1.52588e-05
2.68901 1.02997e-05
3.332 0.000213623
3.87962 7.62939e-05
3.52269 0.000183105
3.98994 0.000167847
1.22351 0.000198364
1.18298 0.000473022
2.32065 0.000350952
2.38945 0.000518799
8.25993 9.15527e-05
8.94501 1.52588e-05
END
$hits2 << END
5.58845 7.62939e-06
4.33149 7.62939e-06
3.20019 7.62939e-06
4.186 7.62939e-06
4.53941 7.62939e-06
5.40663 7.62939e-06
5.02826 7.62939e-06
5.29323 7.62939e-06
2.46227 7.62939e-06
2.64463 7.62939e-06
3.14588 7.62939e-06
4.00102 7.62939e-06
4.92821 7.62939e-06
5.60088 7.62939e-06
1.74105 7.62939e-06
1.71628 7.62939e-06
2.91067 7.62939e-06
3.01756 7.62939e-06
8.60142 7.62939e-06
9.43744 7.62939e-06
1.28693 7.62939e-06
3.85244 7.62939e-06
6.31229 7.62939e-06
1.93479 7.62939e-06
3.03713 7.62939e-06
END
$hits3 << END
6.35491 6.10352e-05
4.75371 4.57764e-05
3.60121 1.52588e-05
4.24955 7.62939e-06
4.79264 0.000213623
5.72545 7.62939e-05
5.5705 6.10352e-05
5.88788 4.57764e-05
2.69261 1.52588e-05
2.76297 7.62939e-06
3.88016 0.000213623
4.14419 7.62939e-05
5.82233 0.000183105
6.04272 0.000167847
1.78999 0.000198364
1.75437 0.000473022
3.16171 0.000350952
3.1945 0.000518799
9.84836 9.15527e-05
10.4235 1.52588e-05
END
$hits4 << END
3.83829 5.6514e-06
4.00365 5.6514e-06
3.76842 5.6514e-06
3.97487 5.6514e-06
4.43851 5.6514e-06
5.30075 5.6514e-06
5.24987 5.6514e-06
4.92829 5.6514e-06
2.48625 5.6514e-06
2.69064 5.6514e-06
3.56071 5.6514e-06
4.09918 5.6514e-06
5.02226 5.6514e-06
5.26229 5.6514e-06
1.5279 5.6514e-06
1.60248 5.6514e-06
2.7388 5.6514e-06
2.84124 5.6514e-06
8.64392 5.6514e-06
9.52399 5.6514e-06
END
$hits5 << END
4.29721 6.10352e-05
4.35586 4.57764e-05
4.11669 1.52588e-05
4.20584 5.6514e-06
4.81743 0.000213623
5.26887 7.62939e-05
5.51046 6.10352e-05
5.38774 4.57764e-05
2.695 1.52588e-05
2.84205 5.6514e-06
4.02987 0.000213623
4.30402 7.62939e-05
5.39573 0.000183105
5.68987 0.000167847
1.60967 0.000198364
1.64949 0.000473022
2.9565 0.000350952
3.01732 0.000518799
9.71973 9.15527e-05
10.0714 1.52588e-05
END
$hits_front << END
9.52399 5.6514e-06
10.4235 1.52588e-05
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
set xrange [20.1893:125.779]; set yrange [5.91675e-06:0.0144206]
set xlabel 'pictures a second  (more is better)'; set ylabel 'picture: RMSE of a channel  (less is better)' offset -1.5
set xtics ('30' 30, '50' 50, '70' 70, '100' 100)
set ytics ("same\nbits" 1.47919e-05, '10⁻⁴' 1e-4, '10⁻³' 1e-3, '10⁻²' 1e-2)
set object rectangle from graph 0, graph 0 to graph 1, first 2.51462e-05 fs solid noborder fc rgb '#eeeeee' behind
set arrow from first 104.816,0.00517964 to graph 1.0,0.8687 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.8687 to graph 1.015,0.8687 nohead lw 0.8 lc rgb '#999999'
set label 'fast, study: irregular exact' at graph 1.02,0.8687 left
set arrow from first 104.508,1.09569e-05 to graph 1.0,0.0790 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.0790 to graph 1.015,0.0790 nohead lw 0.8 lc rgb '#999999'
set label 'double, study: irregular exact' at graph 1.02,0.0790 left
$picture0 << END
68.0332 0.00517964
58.5374 0.00517964
47.2925 0.00517964
56.0158 0.00517964
61.0627 0.00517964
56.3533 0.00517964
60.7493 0.00517964
62.1465 0.00517964
35.5816 0.00517964
40.298 0.00517964
47.7218 0.00517964
52.2005 0.00517964
62.5407 0.00517964
65.4022 0.00517964
31.0628 0.00517964
27.714 0.00517964
47.5679 0.00517964
47.9929 0.00517964
91.9422 0.00517964
98.2174 0.00517964
END
$picture1 << END
64.2682 0.00531405
54.9487 0.00531405
59.4658 0.00519279
63.2871 0.00517964
62.4586 0.00576825
71.4755 0.00551613
66.9519 0.00531405
68.534 0.00531405
44.4373 0.00519279
47.1698 0.00517964
53.4659 0.00576825
62.0802 0.00551613
66.9577 0.00531405
70.2149 0.00531405
32.3032 0.00519239
29.6842 0.00520441
52.6621 0.00576825
53.6052 0.0055394
100.533 0.00531712
104.816 0.00517964
END
$picture2 << END
74.6196 0.000118335
56.5 0.000118335
48.3826 0.000118335
58.9178 0.000118335
51.0621 0.000118335
70.3646 0.000118335
64.895 0.000118335
71.4041 0.000118335
36.8836 0.000118335
42.1742 0.000118335
49.2206 0.000118335
54.9303 0.000118335
71.9135 0.000118335
74.2545 0.000118335
31.633 0.000118335
30.5005 0.000118335
49.0745 0.000118335
50.3596 0.000118335
96.0061 0.000118335
99.4639 0.000118335
24.2272 0.000118335
59.0267 0.000118335
75.6447 0.000118335
30.6433 0.000118335
35.7121 0.000118335
END
$picture3 << END
84.3078 0.00159667
63.4417 0.00159667
65.7358 0.000387878
65.7873 0.000118335
68.3335 0.00254127
80.9651 0.0019008
76.4076 0.00159667
79.2896 0.00159667
45.0165 0.000387878
48.5001 0.000118335
62.1276 0.00254127
63.7227 0.0019008
77.7744 0.00159667
79.6502 0.00159667
33.4306 0.000382429
33.638 0.000520823
53.504 0.00254127
55.8313 0.0019673
100.336 0.00120712
103.611 0.000118335
END
$picture4 << END
52.3555 1.09569e-05
53.6855 1.09569e-05
50.8363 1.09569e-05
56.0566 1.09569e-05
57.6575 1.09569e-05
67.2183 1.09569e-05
65.3962 1.09569e-05
68.4927 1.09569e-05
36.1974 1.09569e-05
41.468 1.09569e-05
47.8858 1.09569e-05
54.5974 1.09569e-05
67.9657 1.09569e-05
71.5123 1.09569e-05
27.4959 1.09569e-05
27.5153 1.09569e-05
47.482 1.09569e-05
47.9448 1.09569e-05
95.8166 1.09569e-05
99.8273 1.09569e-05
END
$picture5 << END
60.2508 0.00159428
61.2209 0.00159428
65.2822 0.000369387
68.604 1.09569e-05
60.825 0.00253977
71.4745 0.00189879
75.2587 0.00159428
74.1911 0.00159428
47.28 0.000369387
50.046 1.09569e-05
62.074 0.00253977
64.774 0.00189879
74.6464 0.00159428
76.7077 0.00159428
32.675 0.00036366
31.6291 0.000509379
53.0783 0.00253977
53.9174 0.00196593
100.65 0.0012013
104.508 1.09569e-05
END
$picture_front << END
104.508 1.09569e-05
104.816 0.00517964
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
set xrange [0.599926:7.95868]; set yrange [3.05176e-06:0.0588608]
set xlabel 'million nearest hits a second  (more is better)'; set ylabel 'wrong hits  (less is better)' offset -1.5
set label 'rings: speed against accuracy (CPU, 2 threads)' at screen 0.02, screen 0.9774 font ',20'
set label '256x256 primary and 65,536 random rays a scene; 65,536 in all compared with brute force in double; pictures of 128x128' at screen 0.02, screen 0.9516
set xtics ('0.7' 0.7, '1' 1, '1.5' 1.5, '2' 2, '3' 3, '5' 5, '7' 7)
set ytics ("none of\n65,536" 7.62939e-06, '0.01 %%' 1e-4, '0.1 %%' 1e-3, '1 %%' 1e-2)
set object rectangle from graph 0, graph 0 to graph 1, first 1.297e-05 fs solid noborder fc rgb '#eeeeee' behind
set arrow from first 6.63223,0.00984192 to graph 1.0,0.8187 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.8187 to graph 1.015,0.8187 nohead lw 0.8 lc rgb '#999999'
set label 'double, study: irregular exact' at graph 1.02,0.8187 left
set arrow from first 6.2207,5.6514e-06 to graph 1.0,0.0624 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.0624 to graph 1.015,0.0624 nohead lw 0.8 lc rgb '#999999'
set label 'double: irregular exact' at graph 1.02,0.0624 left
$hits0 << END
1.89404 0.000259399
2.31495 0.000259399
2.57327 0.000259399
3.45547 0.000259399
2.76862 0.000259399
3.68733 0.000259399
1.81217 0.000259399
2.19898 0.000259399
1.82794 0.000259399
2.16216 0.000259399
2.15227 0.000259399
2.63117 0.000259399
1.73227 0.000259399
2.16608 0.000259399
1.27749 0.000259399
1.52386 0.000259399
1.21074 0.000259399
1.59596 0.000259399
4.00696 0.000259399
5.79008 0.000259399
END
$hits1 << END
2.01289 0.00686646
2.42173 0.00610352
2.79418 0.0235443
3.47007 0.00991821
2.89558 0.0219116
3.76933 0.0118256
1.92847 0.00686646
2.29659 0.00610352
1.90695 0.0235443
2.28207 0.00991821
2.24569 0.0219116
2.76113 0.0118256
1.91233 0.00785828
2.23651 0.00624084
1.34511 0.0185242
1.7811 0.0170288
1.27123 0.0169067
1.65523 0.0122986
4.97807 0.0209045
6.03826 0.0100708
END
$hits2 << END
3.39124 7.62939e-06
3.91223 7.62939e-06
2.90766 7.62939e-06
3.5373 7.62939e-06
3.16377 7.62939e-06
4.05848 7.62939e-06
3.0946 7.62939e-06
3.448 7.62939e-06
1.98589 7.62939e-06
2.2375 7.62939e-06
2.39231 7.62939e-06
2.74559 7.62939e-06
3.06084 7.62939e-06
3.50586 7.62939e-06
2.29591 7.62939e-06
2.74917 7.62939e-06
2.03513 7.62939e-06
2.58408 7.62939e-06
5.19653 7.62939e-06
6.16311 7.62939e-06
0.719911 7.62939e-06
1.92886 7.62939e-06
4.78553 7.62939e-06
1.65813 7.62939e-06
2.24781 7.62939e-06
END
$hits3 << END
3.55018 0.00662231
3.97339 0.00582886
3.1491 0.0233154
3.31099 0.00970459
3.63637 0.021698
4.05189 0.0115967
3.31023 0.00662231
3.63292 0.00582886
2.12703 0.0233154
2.35308 0.00970459
2.49667 0.021698
2.75919 0.0115967
3.23557 0.00762939
3.62509 0.00596619
2.42964 0.0183563
2.87835 0.016861
2.27621 0.0166779
2.6865 0.0120697
5.90438 0.0207062
6.60554 0.00984192
END
$hits4 << END
3.11769 5.6514e-06
3.64184 5.6514e-06
2.89378 5.6514e-06
3.20828 5.6514e-06
3.26346 5.6514e-06
3.90537 5.6514e-06
2.68412 5.6514e-06
3.32641 5.6514e-06
1.99635 5.6514e-06
2.32143 5.6514e-06
2.28568 5.6514e-06
2.64527 5.6514e-06
2.92023 5.6514e-06
3.26232 5.6514e-06
1.94986 5.6514e-06
2.6138 5.6514e-06
1.96973 5.6514e-06
2.34287 5.6514e-06
5.16957 5.6514e-06
6.2207 5.6514e-06
END
$hits5 << END
3.48567 0.00662231
3.92623 0.00582886
3.15512 0.0233154
3.22055 0.00971985
3.44769 0.021698
4.0512 0.0115967
3.13861 0.00662231
3.5648 0.00582886
2.17581 0.0233154
2.37105 0.00970459
2.61675 0.021698
2.88043 0.0115967
3.18387 0.00762939
3.51725 0.00596619
2.34923 0.0183716
2.79841 0.0168762
2.11 0.0166779
2.53153 0.0120697
5.90674 0.0207062
6.63223 0.00984192
END
$hits_front << END
6.2207 5.6514e-06
6.63223 0.00984192
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
set xrange [4.69619:51.9879]; set yrange [3.10267e-05:0.137335]
set xlabel 'pictures a second  (more is better)'; set ylabel 'picture: RMSE of a channel  (less is better)' offset -1.5
set xtics ('5' 5, '7' 7, '10' 10, '15' 15, '20' 20, '30' 30, '50' 50)
set ytics ("same\nbits" 7.75666e-05, '10⁻³' 1e-3, '10⁻²' 1e-2, '10⁻¹' 1e-1)
set object rectangle from graph 0, graph 0 to graph 1, first 0.000131863 fs solid noborder fc rgb '#eeeeee' behind
set arrow from first 43.3232,0.031186 to graph 1.0,0.8234 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.8234 to graph 1.015,0.8234 nohead lw 0.8 lc rgb '#999999'
set label 'double, study: irregular exact' at graph 1.02,0.8234 left
set arrow from first 43.0182,5.74568e-05 to graph 1.0,0.0734 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.0734 to graph 1.015,0.0734 nohead lw 0.8 lc rgb '#999999'
set label 'double: irregular exact' at graph 1.02,0.0734 left
$picture0 << END
14.8843 0.0245371
17.8057 0.0245371
20.4344 0.0245371
27.6855 0.0245371
20.9 0.0245371
27.9273 0.0245371
14.136 0.0245371
17.0382 0.0245371
15.4771 0.0245371
18.7305 0.0245371
17.7521 0.0245371
22.4072 0.0245371
13.5101 0.0245371
16.5929 0.0245371
11.9925 0.0245371
16.0294 0.0245371
11.383 0.0245371
14.7334 0.0245371
29.7637 0.0245371
39.3193 0.0245371
END
$picture1 << END
15.278 0.0325513
18.2505 0.0309071
21.3475 0.0549339
28.5047 0.0378821
22.9424 0.0510348
29.8436 0.0400519
14.9722 0.0325513
17.497 0.0309071
16.0379 0.0549339
19.1227 0.0378821
18.8491 0.0510348
22.8725 0.0400519
14.0232 0.0325541
17.4296 0.0309071
12.7799 0.0430485
16.7376 0.0427338
12.1082 0.0450923
15.2851 0.0387686
32.7159 0.0516064
40.839 0.0389731
END
$picture2 << END
24.031 0.000620533
27.007 0.000620533
22.9371 0.000620533
26.2759 0.000620533
24.5796 0.000620533
29.7173 0.000620533
23.1323 0.000620533
25.3803 0.000620533
16.6288 0.000620533
18.9288 0.000620533
19.9246 0.000620533
21.5716 0.000620533
23.2645 0.000620533
25.0148 0.000620533
17.9777 0.000620533
23.7705 0.000620533
18.4307 0.000620533
21.6602 0.000620533
34.4893 0.000620533
41.8386 0.000620533
5.63542 0.000620533
14.352 0.000620533
33.9838 0.000620533
17.0579 0.000620533
19.011 0.000620533
END
$picture3 << END
24.5015 0.0224824
27.5796 0.019705
23.2788 0.0500996
24.514 0.0290847
25.7161 0.0457431
30.8244 0.0323349
23.7477 0.0224824
25.9421 0.019705
16.7578 0.0500996
19.2729 0.0290847
18.7528 0.0457431
21.4505 0.0323349
23.5907 0.0224865
26.0884 0.019705
20.1336 0.0360748
24.0345 0.035728
18.4351 0.0385455
21.0639 0.0307357
36.5341 0.0463304
42.731 0.0311935
END
$picture4 << END
23.2723 5.74568e-05
26.058 5.74568e-05
22.5199 5.74568e-05
26.6926 5.74568e-05
25.5562 5.74568e-05
28.6558 5.74568e-05
22.1853 5.74568e-05
24.6598 5.74568e-05
16.8018 5.74568e-05
18.8529 5.74568e-05
19.6917 5.74568e-05
23.763 5.74568e-05
22.1539 5.74568e-05
24.5474 5.74568e-05
18.8186 5.74568e-05
23.1389 5.74568e-05
17.6289 5.74568e-05
18.9336 5.74568e-05
34.5142 5.74568e-05
43.0182 5.74568e-05
END
$picture5 << END
24.926 0.0224738
26.3999 0.0196934
24.2742 0.0500977
27.4513 0.0290847
24.836 0.0457408
31.8952 0.0323289
23.9644 0.0224738
25.7752 0.0196934
17.5611 0.0500977
19.7066 0.0290894
20.9514 0.0457408
23.8389 0.0323289
23.7644 0.0224779
26.0555 0.0196934
20.2413 0.0360477
24.4394 0.0358389
18.0652 0.0385421
21.4014 0.0307286
36.8077 0.046329
43.3232 0.031186
END
$picture_front << END
43.0182 5.74568e-05
43.3232 0.031186
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
set xrange [0.599926:7.95868]; set yrange [3.05176e-06:0.0588608]
set xlabel 'million nearest hits a second  (more is better)'; set ylabel 'wrong hits  (less is better)' offset -1.5
set label 'rings: speed against accuracy (CPU, 2 threads)' at screen 0.02, screen 0.9774 font ',20'
set label '256x256 primary and 65,536 random rays a scene; 65,536 in all compared with brute force in double; pictures of 128x128' at screen 0.02, screen 0.9516
set xtics ('0.7' 0.7, '1' 1, '1.5' 1.5, '2' 2, '3' 3, '5' 5, '7' 7)
set ytics ("none of\n65,536" 7.62939e-06, '0.01 %%' 1e-4, '0.1 %%' 1e-3, '1 %%' 1e-2)
set object rectangle from graph 0, graph 0 to graph 1, first 1.297e-05 fs solid noborder fc rgb '#eeeeee' behind
set arrow from first 6.63223,0.00984192 to graph 1.0,0.8187 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.8187 to graph 1.015,0.8187 nohead lw 0.8 lc rgb '#999999'
set label 'double, study: irregular exact' at graph 1.02,0.8187 left
set arrow from first 6.2207,5.6514e-06 to graph 1.0,0.0624 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.0624 to graph 1.015,0.0624 nohead lw 0.8 lc rgb '#999999'
set label 'double: irregular exact' at graph 1.02,0.0624 left
$hits0 << END
1.89404 0.000259399
2.31495 0.000259399
2.57327 0.000259399
3.45547 0.000259399
2.76862 0.000259399
3.68733 0.000259399
1.81217 0.000259399
2.19898 0.000259399
1.82794 0.000259399
2.16216 0.000259399
2.15227 0.000259399
2.63117 0.000259399
1.73227 0.000259399
2.16608 0.000259399
1.27749 0.000259399
1.52386 0.000259399
1.21074 0.000259399
1.59596 0.000259399
4.00696 0.000259399
5.79008 0.000259399
END
$hits1 << END
2.01289 0.00686646
2.42173 0.00610352
2.79418 0.0235443
3.47007 0.00991821
2.89558 0.0219116
3.76933 0.0118256
1.92847 0.00686646
2.29659 0.00610352
1.90695 0.0235443
2.28207 0.00991821
2.24569 0.0219116
2.76113 0.0118256
1.91233 0.00785828
2.23651 0.00624084
1.34511 0.0185242
1.7811 0.0170288
1.27123 0.0169067
1.65523 0.0122986
4.97807 0.0209045
6.03826 0.0100708
END
$hits2 << END
3.39124 7.62939e-06
3.91223 7.62939e-06
2.90766 7.62939e-06
3.5373 7.62939e-06
3.16377 7.62939e-06
4.05848 7.62939e-06
3.0946 7.62939e-06
3.448 7.62939e-06
1.98589 7.62939e-06
2.2375 7.62939e-06
2.39231 7.62939e-06
2.74559 7.62939e-06
3.06084 7.62939e-06
3.50586 7.62939e-06
2.29591 7.62939e-06
2.74917 7.62939e-06
2.03513 7.62939e-06
2.58408 7.62939e-06
5.19653 7.62939e-06
6.16311 7.62939e-06
0.719911 7.62939e-06
1.92886 7.62939e-06
4.78553 7.62939e-06
1.65813 7.62939e-06
2.24781 7.62939e-06
END
$hits3 << END
3.55018 0.00662231
3.97339 0.00582886
3.1491 0.0233154
3.31099 0.00970459
3.63637 0.021698
4.05189 0.0115967
3.31023 0.00662231
3.63292 0.00582886
2.12703 0.0233154
2.35308 0.00970459
2.49667 0.021698
2.75919 0.0115967
3.23557 0.00762939
3.62509 0.00596619
2.42964 0.0183563
2.87835 0.016861
2.27621 0.0166779
2.6865 0.0120697
5.90438 0.0207062
6.60554 0.00984192
END
$hits4 << END
3.11769 5.6514e-06
3.64184 5.6514e-06
2.89378 5.6514e-06
3.20828 5.6514e-06
3.26346 5.6514e-06
3.90537 5.6514e-06
2.68412 5.6514e-06
3.32641 5.6514e-06
1.99635 5.6514e-06
2.32143 5.6514e-06
2.28568 5.6514e-06
2.64527 5.6514e-06
2.92023 5.6514e-06
3.26232 5.6514e-06
1.94986 5.6514e-06
2.6138 5.6514e-06
1.96973 5.6514e-06
2.34287 5.6514e-06
5.16957 5.6514e-06
6.2207 5.6514e-06
END
$hits5 << END
3.48567 0.00662231
3.92623 0.00582886
3.15512 0.0233154
3.22055 0.00971985
3.44769 0.021698
4.0512 0.0115967
3.13861 0.00662231
3.5648 0.00582886
2.17581 0.0233154
2.37105 0.00970459
2.61675 0.021698
2.88043 0.0115967
3.18387 0.00762939
3.51725 0.00596619
2.34923 0.0183716
2.79841 0.0168762
2.11 0.0166779
2.53153 0.0120697
5.90674 0.0207062
6.63223 0.00984192
END
$hits_front << END
6.2207 5.6514e-06
6.63223 0.00984192
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
set xrange [4.69619:51.9879]; set yrange [3.10267e-05:0.137335]
set xlabel 'pictures a second  (more is better)'; set ylabel 'picture: RMSE of a channel  (less is better)' offset -1.5
set xtics ('5' 5, '7' 7, '10' 10, '15' 15, '20' 20, '30' 30, '50' 50)
set ytics ("same\nbits" 7.75666e-05, '10⁻³' 1e-3, '10⁻²' 1e-2, '10⁻¹' 1e-1)
set object rectangle from graph 0, graph 0 to graph 1, first 0.000131863 fs solid noborder fc rgb '#eeeeee' behind
set arrow from first 43.3232,0.031186 to graph 1.0,0.8234 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.8234 to graph 1.015,0.8234 nohead lw 0.8 lc rgb '#999999'
set label 'double, study: irregular exact' at graph 1.02,0.8234 left
set arrow from first 43.0182,5.74568e-05 to graph 1.0,0.0734 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.0734 to graph 1.015,0.0734 nohead lw 0.8 lc rgb '#999999'
set label 'double: irregular exact' at graph 1.02,0.0734 left
$picture0 << END
14.8843 0.0245371
17.8057 0.0245371
20.4344 0.0245371
27.6855 0.0245371
20.9 0.0245371
27.9273 0.0245371
14.136 0.0245371
17.0382 0.0245371
15.4771 0.0245371
18.7305 0.0245371
17.7521 0.0245371
22.4072 0.0245371
13.5101 0.0245371
16.5929 0.0245371
11.9925 0.0245371
16.0294 0.0245371
11.383 0.0245371
14.7334 0.0245371
29.7637 0.0245371
39.3193 0.0245371
END
$picture1 << END
15.278 0.0325513
18.2505 0.0309071
21.3475 0.0549339
28.5047 0.0378821
22.9424 0.0510348
29.8436 0.0400519
14.9722 0.0325513
17.497 0.0309071
16.0379 0.0549339
19.1227 0.0378821
18.8491 0.0510348
22.8725 0.0400519
14.0232 0.0325541
17.4296 0.0309071
12.7799 0.0430485
16.7376 0.0427338
12.1082 0.0450923
15.2851 0.0387686
32.7159 0.0516064
40.839 0.0389731
END
$picture2 << END
24.031 0.000620533
27.007 0.000620533
22.9371 0.000620533
26.2759 0.000620533
24.5796 0.000620533
29.7173 0.000620533
23.1323 0.000620533
25.3803 0.000620533
16.6288 0.000620533
18.9288 0.000620533
19.9246 0.000620533
21.5716 0.000620533
23.2645 0.000620533
25.0148 0.000620533
17.9777 0.000620533
23.7705 0.000620533
18.4307 0.000620533
21.6602 0.000620533
34.4893 0.000620533
41.8386 0.000620533
5.63542 0.000620533
14.352 0.000620533
33.9838 0.000620533
17.0579 0.000620533
19.011 0.000620533
END
$picture3 << END
24.5015 0.0224824
27.5796 0.019705
23.2788 0.0500996
24.514 0.0290847
25.7161 0.0457431
30.8244 0.0323349
23.7477 0.0224824
25.9421 0.019705
16.7578 0.0500996
19.2729 0.0290847
18.7528 0.0457431
21.4505 0.0323349
23.5907 0.0224865
26.0884 0.019705
20.1336 0.0360748
24.0345 0.035728
18.4351 0.0385455
21.0639 0.0307357
36.5341 0.0463304
42.731 0.0311935
END
$picture4 << END
23.2723 5.74568e-05
26.058 5.74568e-05
22.5199 5.74568e-05
26.6926 5.74568e-05
25.5562 5.74568e-05
28.6558 5.74568e-05
22.1853 5.74568e-05
24.6598 5.74568e-05
16.8018 5.74568e-05
18.8529 5.74568e-05
19.6917 5.74568e-05
23.763 5.74568e-05
22.1539 5.74568e-05
24.5474 5.74568e-05
18.8186 5.74568e-05
23.1389 5.74568e-05
17.6289 5.74568e-05
18.9336 5.74568e-05
34.5142 5.74568e-05
43.0182 5.74568e-05
END
$picture5 << END
24.926 0.0224738
26.3999 0.0196934
24.2742 0.0500977
27.4513 0.0290847
24.836 0.0457408
31.8952 0.0323289
23.9644 0.0224738
25.7752 0.0196934
17.5611 0.0500977
19.7066 0.0290894
20.9514 0.0457408
23.8389 0.0323289
23.7644 0.0224779
26.0555 0.0196934
20.2413 0.0360477
24.4394 0.0358389
18.0652 0.0385421
21.4014 0.0307286
36.8077 0.046329
43.3232 0.031186
END
$picture_front << END
43.0182 5.74568e-05
43.3232 0.031186
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
set xrange [1.02538:16.7123]; set yrange [3.05176e-06:0.00114441]
set xlabel 'million nearest hits a second  (more is better)'; set ylabel 'wrong hits  (less is better)' offset -1.5
set label 'teapot: speed against accuracy (CPU, 2 threads)' at screen 0.02, screen 0.9774 font ',20'
set label '256x256 primary and 65,536 random rays a scene; 65,536 in all compared with brute force in double; pictures of 128x128' at screen 0.02, screen 0.9516
set xtics ('1.5' 1.5, '2' 2, '3' 3, '5' 5, '7' 7, '10' 10, '15' 15)
set ytics ("none of\n65,536" 7.62939e-06, '0.01 %%' 1e-4, '0.1 %%' 1e-3)
set object rectangle from graph 0, graph 0 to graph 1, first 1.297e-05 fs solid noborder fc rgb '#eeeeee' behind
set arrow from first 13.9269,0.000137329 to graph 1.0,0.6423 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.6423 to graph 1.015,0.6423 nohead lw 0.8 lc rgb '#999999'
set label 'robust, study: irregular exact' at graph 1.02,0.6423 left
set arrow from first 12.3057,5.6514e-06 to graph 1.0,0.1040 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.1040 to graph 1.015,0.1040 nohead lw 0.8 lc rgb '#999999'
set label 'double: irregular exact' at graph 1.02,0.1040 left
$hits0 << END
5.75473 1.52588e-05
6.51247 1.52588e-05
4.56455 1.52588e-05
4.79661 1.52588e-05
5.32 1.52588e-05
5.46977 1.52588e-05
5.36995 1.52588e-05
5.38982 1.52588e-05
2.45847 1.52588e-05
2.59285 1.52588e-05
3.82039 1.52588e-05
3.63682 1.52588e-05
5.63509 1.52588e-05
5.45744 1.52588e-05
3.34876 1.52588e-05
2.94369 1.52588e-05
4.49319 1.52588e-05
4.51593 1.52588e-05
10.4814 1.52588e-05
11.6001 1.52588e-05
END
$hits1 << END
4.67239 0.000457764
5.55096 0.000457764
4.54978 0.00038147
4.56057 0.000396729
5.16883 0.000366211
4.95041 0.000198364
4.52151 0.000457764
4.60097 0.000457764
2.5345 0.00038147
2.63811 0.000396729
3.65452 0.000366211
3.80156 0.000198364
4.50393 0.000457764
4.63416 0.000457764
2.71677 0.000350952
2.4933 0.000427246
3.66191 0.000305176
3.68968 0.000167847
11.1721 0.000320435
11.6532 0.000152588
END
$hits2 << END
7.27493 7.62939e-06
7.57442 7.62939e-06
4.47451 7.62939e-06
4.63883 7.62939e-06
5.47541 7.62939e-06
5.22439 7.62939e-06
5.74216 7.62939e-06
6.065 7.62939e-06
2.47226 7.62939e-06
2.62505 7.62939e-06
4.0121 7.62939e-06
3.92459 7.62939e-06
6.19256 7.62939e-06
5.94149 7.62939e-06
3.15038 7.62939e-06
3.70886 7.62939e-06
4.42664 7.62939e-06
4.54086 7.62939e-06
11.8321 7.62939e-06
12.2796 7.62939e-06
1.23046 7.62939e-06
3.92237 7.62939e-06
7.13795 7.62939e-06
2.6193 7.62939e-06
4.0814 7.62939e-06
END
$hits3 << END
7.81048 0.000442505
7.83045 0.000442505
4.87364 0.000366211
5.00059 0.00038147
5.84226 0.000350952
5.45429 0.000183105
6.55402 0.000442505
6.69017 0.000442505
2.53458 0.000366211
2.67587 0.00038147
4.16963 0.000350952
4.07173 0.000183105
6.2579 0.000442505
6.08803 0.000442505
2.84389 0.000335693
3.74651 0.000411987
4.547 0.000289917
4.71156 0.000152588
13.2798 0.000305176
13.9269 0.000137329
END
$hits4 << END
6.5745 5.6514e-06
6.70839 5.6514e-06
4.58913 5.6514e-06
4.78328 5.6514e-06
5.49405 5.6514e-06
5.74067 5.6514e-06
5.75068 5.6514e-06
5.53371 5.6514e-06
2.62313 5.6514e-06
2.74226 5.6514e-06
4.08331 5.6514e-06
4.11854 5.6514e-06
5.70871 5.6514e-06
5.8262 5.6514e-06
3.42805 5.6514e-06
3.43717 5.6514e-06
4.10444 5.6514e-06
4.26224 5.6514e-06
11.8904 5.6514e-06
12.3057 5.6514e-06
END
$hits5 << END
6.95579 0.000442505
7.19888 0.000442505
4.73773 0.000366211
4.90537 0.00038147
5.78408 0.000350952
5.63761 0.000183105
5.85983 0.000442505
5.92722 0.000442505
2.69127 0.000366211
2.83872 0.00038147
4.27088 0.000350952
4.22561 0.000183105
5.54005 0.000442505
5.89535 0.000442505
3.48676 0.000335693
3.44741 0.000411987
4.23349 0.000289917
4.40948 0.000152588
13.0864 0.000305176
13.6961 0.000137329
END
$hits_front << END
12.3057 5.6514e-06
13.9269 0.000137329
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
set xrange [11.0719:151.835]; set yrange [6.2213e-08:0.0179018]
set xlabel 'pictures a second  (more is better)'; set ylabel 'picture: RMSE of a channel  (less is better)' offset -1.5
set xtics ('15' 15, '20' 20, '30' 30, '50' 50, '70' 70, '100' 100, '150' 150)
set ytics ("same\nbits" 1.55533e-07, '10⁻⁶' 1e-6, '10⁻⁵' 1e-5, '10⁻⁴' 1e-4, '10⁻³' 1e-3, '10⁻²' 1e-2)
set object rectangle from graph 0, graph 0 to graph 1, first 2.64405e-07 fs solid noborder fc rgb '#eeeeee' behind
set arrow from first 126.529,0.00231555 to graph 1.0,0.8373 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.8373 to graph 1.015,0.8373 nohead lw 0.8 lc rgb '#999999'
set label 'robust, study: irregular exact' at graph 1.02,0.8373 left
set arrow from first 122.147,1.15209e-07 to graph 1.0,0.0490 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.0490 to graph 1.015,0.0490 nohead lw 0.8 lc rgb '#999999'
set label 'double: irregular exact' at graph 1.02,0.0490 left
$picture0 << END
55.0767 0.000386076
59.2536 0.000386076
45.1402 0.000386076
47.6422 0.000386076
57.3368 0.000386076
56.2892 0.000386076
51.2844 0.000386076
51.9435 0.000386076
25.4507 0.000386076
27.0367 0.000386076
41.8526 0.000386076
42.0045 0.000386076
50.0907 0.000386076
53.4336 0.000386076
32.7343 0.000386076
31.6161 0.000386076
43.4641 0.000386076
43.4201 0.000386076
101.154 0.000386076
111.345 0.000386076
END
$picture1 << END
39.6324 0.00676137
45.3461 0.00676137
42.7223 0.0071607
45.9008 0.00713817
55.1426 0.00709362
55.0019 0.00356432
49.281 0.00676137
52.1627 0.00676137
25.5005 0.0071607
27.7098 0.00713817
42.609 0.00709362
39.5617 0.00356432
48.51 0.00676137
52.478 0.00676137
30.6226 0.00596842
30.3426 0.00531404
42.6347 0.00426532
42.1749 0.00207633
108.753 0.00584577
117.581 0.00234752
END
$picture2 << END
69.097 1.24426e-06
69.9491 1.24426e-06
45.3145 1.24426e-06
48.5717 1.24426e-06
59.145 1.24426e-06
62.6386 1.24426e-06
57.8908 1.24426e-06
62.6594 1.24426e-06
25.8645 1.24426e-06
27.8451 1.24426e-06
42.9997 1.24426e-06
39.0111 1.24426e-06
61.9686 1.24426e-06
58.3809 1.24426e-06
30.6555 1.24426e-06
33.5215 1.24426e-06
42.9856 1.24426e-06
44.094 1.24426e-06
113.669 1.24426e-06
120.481 1.24426e-06
13.2863 1.24426e-06
39.3224 1.24426e-06
69.4999 1.24426e-06
26.5175 1.24426e-06
39.4918 1.24426e-06
END
$picture3 << END
69.682 0.00675033
72.4076 0.00675033
47.543 0.00715028
49.4479 0.00712772
60.5782 0.0070831
63.4844 0.00354334
62.7278 0.00675033
63.7223 0.00675033
25.2236 0.00715028
28.3982 0.00712772
43.5861 0.0070831
44.2347 0.00354334
58.7292 0.00675033
58.547 0.00675033
33.2884 0.00595591
33.975 0.0053
43.5941 0.00424781
44.7876 0.00204012
118.377 0.005833
126.529 0.00231555
END
$picture4 << END
66.0995 1.15209e-07
69.3813 1.15209e-07
46.0282 1.15209e-07
47.7721 1.15209e-07
59.6196 1.15209e-07
58.1669 1.15209e-07
55.3958 1.15209e-07
52.1472 1.15209e-07
27.1064 1.15209e-07
29.083 1.15209e-07
43.0791 1.15209e-07
44.6496 1.15209e-07
55.2392 1.15209e-07
56.1158 1.15209e-07
31.2533 1.15209e-07
31.4214 1.15209e-07
41.2393 1.15209e-07
42.1943 1.15209e-07
114.679 1.15209e-07
122.147 1.15209e-07
END
$picture5 << END
66.7058 0.00675033
70.6384 0.00675033
46.6662 0.00715028
48.9927 0.00712772
61.1217 0.00708309
63.2839 0.00354334
54.2953 0.00675033
59.2203 0.00675033
27.1884 0.00715028
29.2586 0.00712772
44.5256 0.00708309
45.504 0.00354334
55.7249 0.00675033
56.2689 0.00675033
31.2731 0.00595591
31.3128 0.0053
41.2262 0.00424781
42.7144 0.00204011
119.093 0.005833
124.448 0.00231555
END
$picture_front << END
122.147 1.15209e-07
126.529 0.00231555
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
set xrange [1.02538:16.7123]; set yrange [3.05176e-06:0.00114441]
set xlabel 'million nearest hits a second  (more is better)'; set ylabel 'wrong hits  (less is better)' offset -1.5
set label 'teapot: speed against accuracy (CPU, 2 threads)' at screen 0.02, screen 0.9774 font ',20'
set label '256x256 primary and 65,536 random rays a scene; 65,536 in all compared with brute force in double; pictures of 128x128' at screen 0.02, screen 0.9516
set xtics ('1.5' 1.5, '2' 2, '3' 3, '5' 5, '7' 7, '10' 10, '15' 15)
set ytics ("none of\n65,536" 7.62939e-06, '0.01 %%' 1e-4, '0.1 %%' 1e-3)
set object rectangle from graph 0, graph 0 to graph 1, first 1.297e-05 fs solid noborder fc rgb '#eeeeee' behind
set arrow from first 13.9269,0.000137329 to graph 1.0,0.6423 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.6423 to graph 1.015,0.6423 nohead lw 0.8 lc rgb '#999999'
set label 'robust, study: irregular exact' at graph 1.02,0.6423 left
set arrow from first 12.3057,5.6514e-06 to graph 1.0,0.1040 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.1040 to graph 1.015,0.1040 nohead lw 0.8 lc rgb '#999999'
set label 'double: irregular exact' at graph 1.02,0.1040 left
$hits0 << END
5.75473 1.52588e-05
6.51247 1.52588e-05
4.56455 1.52588e-05
4.79661 1.52588e-05
5.32 1.52588e-05
5.46977 1.52588e-05
5.36995 1.52588e-05
5.38982 1.52588e-05
2.45847 1.52588e-05
2.59285 1.52588e-05
3.82039 1.52588e-05
3.63682 1.52588e-05
5.63509 1.52588e-05
5.45744 1.52588e-05
3.34876 1.52588e-05
2.94369 1.52588e-05
4.49319 1.52588e-05
4.51593 1.52588e-05
10.4814 1.52588e-05
11.6001 1.52588e-05
END
$hits1 << END
4.67239 0.000457764
5.55096 0.000457764
4.54978 0.00038147
4.56057 0.000396729
5.16883 0.000366211
4.95041 0.000198364
4.52151 0.000457764
4.60097 0.000457764
2.5345 0.00038147
2.63811 0.000396729
3.65452 0.000366211
3.80156 0.000198364
4.50393 0.000457764
4.63416 0.000457764
2.71677 0.000350952
2.4933 0.000427246
3.66191 0.000305176
3.68968 0.000167847
11.1721 0.000320435
11.6532 0.000152588
END
$hits2 << END
7.27493 7.62939e-06
7.57442 7.62939e-06
4.47451 7.62939e-06
4.63883 7.62939e-06
5.47541 7.62939e-06
5.22439 7.62939e-06
5.74216 7.62939e-06
6.065 7.62939e-06
2.47226 7.62939e-06
2.62505 7.62939e-06
4.0121 7.62939e-06
3.92459 7.62939e-06
6.19256 7.62939e-06
5.94149 7.62939e-06
3.15038 7.62939e-06
3.70886 7.62939e-06
4.42664 7.62939e-06
4.54086 7.62939e-06
11.8321 7.62939e-06
12.2796 7.62939e-06
1.23046 7.62939e-06
3.92237 7.62939e-06
7.13795 7.62939e-06
2.6193 7.62939e-06
4.0814 7.62939e-06
END
$hits3 << END
7.81048 0.000442505
7.83045 0.000442505
4.87364 0.000366211
5.00059 0.00038147
5.84226 0.000350952
5.45429 0.000183105
6.55402 0.000442505
6.69017 0.000442505
2.53458 0.000366211
2.67587 0.00038147
4.16963 0.000350952
4.07173 0.000183105
6.2579 0.000442505
6.08803 0.000442505
2.84389 0.000335693
3.74651 0.000411987
4.547 0.000289917
4.71156 0.000152588
13.2798 0.000305176
13.9269 0.000137329
END
$hits4 << END
6.5745 5.6514e-06
6.70839 5.6514e-06
4.58913 5.6514e-06
4.78328 5.6514e-06
5.49405 5.6514e-06
5.74067 5.6514e-06
5.75068 5.6514e-06
5.53371 5.6514e-06
2.62313 5.6514e-06
2.74226 5.6514e-06
4.08331 5.6514e-06
4.11854 5.6514e-06
5.70871 5.6514e-06
5.8262 5.6514e-06
3.42805 5.6514e-06
3.43717 5.6514e-06
4.10444 5.6514e-06
4.26224 5.6514e-06
11.8904 5.6514e-06
12.3057 5.6514e-06
END
$hits5 << END
6.95579 0.000442505
7.19888 0.000442505
4.73773 0.000366211
4.90537 0.00038147
5.78408 0.000350952
5.63761 0.000183105
5.85983 0.000442505
5.92722 0.000442505
2.69127 0.000366211
2.83872 0.00038147
4.27088 0.000350952
4.22561 0.000183105
5.54005 0.000442505
5.89535 0.000442505
3.48676 0.000335693
3.44741 0.000411987
4.23349 0.000289917
4.40948 0.000152588
13.0864 0.000305176
13.6961 0.000137329
END
$hits_front << END
12.3057 5.6514e-06
13.9269 0.000137329
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
set xrange [11.0719:151.835]; set yrange [6.2213e-08:0.0179018]
set xlabel 'pictures a second  (more is better)'; set ylabel 'picture: RMSE of a channel  (less is better)' offset -1.5
set xtics ('15' 15, '20' 20, '30' 30, '50' 50, '70' 70, '100' 100, '150' 150)
set ytics ("same\nbits" 1.55533e-07, '10⁻⁶' 1e-6, '10⁻⁵' 1e-5, '10⁻⁴' 1e-4, '10⁻³' 1e-3, '10⁻²' 1e-2)
set object rectangle from graph 0, graph 0 to graph 1, first 2.64405e-07 fs solid noborder fc rgb '#eeeeee' behind
set arrow from first 126.529,0.00231555 to graph 1.0,0.8373 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.8373 to graph 1.015,0.8373 nohead lw 0.8 lc rgb '#999999'
set label 'robust, study: irregular exact' at graph 1.02,0.8373 left
set arrow from first 122.147,1.15209e-07 to graph 1.0,0.0490 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.0490 to graph 1.015,0.0490 nohead lw 0.8 lc rgb '#999999'
set label 'double: irregular exact' at graph 1.02,0.0490 left
$picture0 << END
55.0767 0.000386076
59.2536 0.000386076
45.1402 0.000386076
47.6422 0.000386076
57.3368 0.000386076
56.2892 0.000386076
51.2844 0.000386076
51.9435 0.000386076
25.4507 0.000386076
27.0367 0.000386076
41.8526 0.000386076
42.0045 0.000386076
50.0907 0.000386076
53.4336 0.000386076
32.7343 0.000386076
31.6161 0.000386076
43.4641 0.000386076
43.4201 0.000386076
101.154 0.000386076
111.345 0.000386076
END
$picture1 << END
39.6324 0.00676137
45.3461 0.00676137
42.7223 0.0071607
45.9008 0.00713817
55.1426 0.00709362
55.0019 0.00356432
49.281 0.00676137
52.1627 0.00676137
25.5005 0.0071607
27.7098 0.00713817
42.609 0.00709362
39.5617 0.00356432
48.51 0.00676137
52.478 0.00676137
30.6226 0.00596842
30.3426 0.00531404
42.6347 0.00426532
42.1749 0.00207633
108.753 0.00584577
117.581 0.00234752
END
$picture2 << END
69.097 1.24426e-06
69.9491 1.24426e-06
45.3145 1.24426e-06
48.5717 1.24426e-06
59.145 1.24426e-06
62.6386 1.24426e-06
57.8908 1.24426e-06
62.6594 1.24426e-06
25.8645 1.24426e-06
27.8451 1.24426e-06
42.9997 1.24426e-06
39.0111 1.24426e-06
61.9686 1.24426e-06
58.3809 1.24426e-06
30.6555 1.24426e-06
33.5215 1.24426e-06
42.9856 1.24426e-06
44.094 1.24426e-06
113.669 1.24426e-06
120.481 1.24426e-06
13.2863 1.24426e-06
39.3224 1.24426e-06
69.4999 1.24426e-06
26.5175 1.24426e-06
39.4918 1.24426e-06
END
$picture3 << END
69.682 0.00675033
72.4076 0.00675033
47.543 0.00715028
49.4479 0.00712772
60.5782 0.0070831
63.4844 0.00354334
62.7278 0.00675033
63.7223 0.00675033
25.2236 0.00715028
28.3982 0.00712772
43.5861 0.0070831
44.2347 0.00354334
58.7292 0.00675033
58.547 0.00675033
33.2884 0.00595591
33.975 0.0053
43.5941 0.00424781
44.7876 0.00204012
118.377 0.005833
126.529 0.00231555
END
$picture4 << END
66.0995 1.15209e-07
69.3813 1.15209e-07
46.0282 1.15209e-07
47.7721 1.15209e-07
59.6196 1.15209e-07
58.1669 1.15209e-07
55.3958 1.15209e-07
52.1472 1.15209e-07
27.1064 1.15209e-07
29.083 1.15209e-07
43.0791 1.15209e-07
44.6496 1.15209e-07
55.2392 1.15209e-07
56.1158 1.15209e-07
31.2533 1.15209e-07
31.4214 1.15209e-07
41.2393 1.15209e-07
42.1943 1.15209e-07
114.679 1.15209e-07
122.147 1.15209e-07
END
$picture5 << END
66.7058 0.00675033
70.6384 0.00675033
46.6662 0.00715028
48.9927 0.00712772
61.1217 0.00708309
63.2839 0.00354334
54.2953 0.00675033
59.2203 0.00675033
27.1884 0.00715028
29.2586 0.00712772
44.5256 0.00708309
45.504 0.00354334
55.7249 0.00675033
56.2689 0.00675033
31.2731 0.00595591
31.3128 0.0053
41.2262 0.00424781
42.7144 0.00204011
119.093 0.005833
124.448 0.00231555
END
$picture_front << END
122.147 1.15209e-07
126.529 0.00231555
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
set xrange [0.533138:12.825]; set yrange [3.05176e-06:0.00175476]
set xlabel 'million nearest hits a second  (more is better)'; set ylabel 'wrong hits  (less is better)' offset -1.5
set label 'tetra: speed against accuracy (CPU, 2 threads)' at screen 0.02, screen 0.9774 font ',20'
set label '256x256 primary and 65,536 random rays a scene; 65,536 in all compared with brute force in double; pictures of 128x128' at screen 0.02, screen 0.9516
set xtics ('1' 1, '2' 2, '5' 5, '10' 10)
set ytics ("none of\n65,536" 7.62939e-06, '0.01 %%' 1e-4, '0.1 %%' 1e-3)
set object rectangle from graph 0, graph 0 to graph 1, first 1.297e-05 fs solid noborder fc rgb '#eeeeee' behind
set arrow from first 10.6875,3.05176e-05 to graph 1.0,0.3624 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.3624 to graph 1.015,0.3624 nohead lw 0.8 lc rgb '#999999'
set label 'robust, study: irregular exact' at graph 1.02,0.3624 left
set arrow from first 9.93396,7.62939e-06 to graph 1.0,0.1442 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.1442 to graph 1.015,0.1442 nohead lw 0.8 lc rgb '#999999'
set label 'robust: irregular exact' at graph 1.02,0.1442 left
$hits0 << END
4.92806 1.02997e-05
4.79256 1.02997e-05
4.14011 1.02997e-05
4.44537 1.02997e-05
6.49002 1.02997e-05
6.47706 1.02997e-05
4.35779 1.02997e-05
4.26366 1.02997e-05
2.61559 1.02997e-05
2.47843 1.02997e-05
4.65468 1.02997e-05
4.74281 1.02997e-05
4.03699 1.02997e-05
3.9799 1.02997e-05
3.14137 1.02997e-05
2.22128 1.02997e-05
4.39648 1.02997e-05
3.4734 1.02997e-05
7.76905 1.02997e-05
7.91248 1.02997e-05
END
$hits1 << END
4.20102 1.02997e-05
4.26947 4.57764e-05
4.02371 1.02997e-05
4.41528 7.62939e-05
6.05084 1.02997e-05
6.25194 1.02997e-05
3.8467 1.02997e-05
3.90104 4.57764e-05
2.41342 1.02997e-05
2.48423 7.62939e-05
4.66144 1.02997e-05
4.50278 1.02997e-05
3.48635 1.02997e-05
3.5432 6.10352e-05
2.65268 1.02997e-05
1.91701 0.000701904
3.60224 1.02997e-05
2.81304 0.000442505
7.46739 1.02997e-05
7.98211 3.05176e-05
END
$hits2 << END
6.72213 7.62939e-06
7.06769 7.62939e-06
4.49093 7.62939e-06
4.7449 7.62939e-06
7.47943 7.62939e-06
7.68882 7.62939e-06
5.78183 7.62939e-06
6.02573 7.62939e-06
2.32989 7.62939e-06
2.83507 7.62939e-06
5.5555 7.62939e-06
5.24598 7.62939e-06
5.50145 7.62939e-06
5.81291 7.62939e-06
3.79369 7.62939e-06
2.94643 7.62939e-06
5.45905 7.62939e-06
4.44779 7.62939e-06
8.95048 7.62939e-06
9.93396 7.62939e-06
0.639766 7.62939e-06
1.84718 7.62939e-06
4.38684 7.62939e-06
5.99905 7.62939e-06
1.88461 7.62939e-06
2.3858 7.62939e-06
END
$hits3 << END
7.28923 7.62939e-06
7.67647 4.57764e-05
4.64597 7.62939e-06
4.93667 7.62939e-05
7.75121 7.62939e-06
7.95233 7.62939e-06
6.17261 7.62939e-06
6.45034 4.57764e-05
2.47797 7.62939e-06
2.87958 7.62939e-05
5.86535 7.62939e-06
5.49022 7.62939e-06
5.97111 7.62939e-06
6.25121 6.10352e-05
3.92789 7.62939e-06
3.17066 0.000701904
5.65194 7.62939e-06
4.61217 0.000442505
9.73484 7.62939e-06
10.6875 3.05176e-05
END
$hits4 << END
6.17543 5.6514e-06
6.58882 5.6514e-06
4.39582 5.6514e-06
4.74469 5.6514e-06
7.29208 5.6514e-06
7.49215 5.6514e-06
5.41962 5.6514e-06
5.65304 5.6514e-06
2.62015 5.6514e-06
2.52084 5.6514e-06
5.55123 5.6514e-06
5.7698 5.6514e-06
5.11787 5.6514e-06
5.39654 5.6514e-06
3.4719 5.6514e-06
2.86109 5.6514e-06
4.99315 5.6514e-06
3.9335 5.6514e-06
8.6952 5.6514e-06
9.65902 5.6514e-06
END
$hits5 << END
6.72921 5.6514e-06
7.0549 4.57764e-05
4.47551 5.6514e-06
4.884 7.62939e-05
7.4795 5.6514e-06
7.77335 5.6514e-06
5.82349 5.6514e-06
6.06996 4.57764e-05
2.61416 5.6514e-06
2.8031 7.62939e-05
5.60987 5.6514e-06
6.01205 5.6514e-06
5.49756 5.6514e-06
5.85199 6.10352e-05
3.64758 5.6514e-06
2.91044 0.000701904
4.8428 5.6514e-06
4.17286 0.000442505
9.16544 5.6514e-06
10.1952 3.05176e-05
END
$hits_front << END
9.93396 7.62939e-06
10.6875 3.05176e-05
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
set xrange [26.0474:569.698]; set yrange [8.7478e-10:0.00543185]
set xlabel 'pictures a second  (more is better)'; set ylabel 'picture: RMSE of a channel  (less is better)' offset -1.5
set xtics ('50' 50, '100' 100, '200' 200, '500' 500)
set ytics ("same\nbits" 2.18695e-09, '10⁻⁸' 1e-8, '10⁻⁷' 1e-7, '10⁻⁶' 1e-6, '10⁻⁵' 1e-5, '10⁻⁴' 1e-4, '10⁻³' 1e-3)
set object rectangle from graph 0, graph 0 to graph 1, first 3.71782e-09 fs solid noborder fc rgb '#eeeeee' behind
set arrow from first 474.748,1.74956e-08 to graph 1.0,0.1915 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.1915 to graph 1.015,0.1915 nohead lw 0.8 lc rgb '#999999'
set label 'robust, study: irregular exact' at graph 1.02,0.1915 left
set arrow from first 465.922,1.61996e-09 to graph 1.0,0.0394 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.0394 to graph 1.015,0.0394 nohead lw 0.8 lc rgb '#999999'
set label 'double, study: irregular box' at graph 1.02,0.0394 left
$picture0 << END
290.819 4.25742e-07
262.041 4.25742e-07
247.544 4.25742e-07
263.893 4.25742e-07
388.021 4.25742e-07
359.455 4.25742e-07
250.798 4.25742e-07
235.919 4.25742e-07
135.793 4.25742e-07
129.049 4.25742e-07
261.977 4.25742e-07
251.905 4.25742e-07
234.749 4.25742e-07
228.821 4.25742e-07
201.199 4.25742e-07
139.854 4.25742e-07
263.666 4.25742e-07
224.457 4.25742e-07
431.598 4.25742e-07
416.479 4.25742e-07
END
$picture1 << END
189.682 4.25742e-07
195.948 4.25742e-07
219.185 4.25742e-07
238.637 4.25742e-07
321.926 4.25742e-07
317.857 4.25742e-07
251.56 4.25742e-07
246.592 4.25742e-07
127.045 4.25742e-07
143.137 4.25742e-07
272.792 4.25742e-07
250.951 4.25742e-07
237.167 4.25742e-07
239.58 4.25742e-07
199.797 4.25742e-07
140.816 0.00173156
260.235 4.25742e-07
226.848 0.00217274
448.352 4.25742e-07
414.334 4.25742e-07
END
$picture2 << END
302.983 1.74956e-08
322.037 1.74956e-08
244.827 1.74956e-08
267.882 1.74956e-08
374.428 1.74956e-08
392.043 1.74956e-08
259.641 1.74956e-08
275.105 1.74956e-08
127.605 1.74956e-08
144.492 1.74956e-08
266.083 1.74956e-08
252.319 1.74956e-08
256.429 1.74956e-08
271.967 1.74956e-08
204.484 1.74956e-08
167.036 1.74956e-08
279.575 1.74956e-08
242.98 1.74956e-08
450.914 1.74956e-08
454.36 1.74956e-08
31.2568 1.74956e-08
89.1552 1.74956e-08
210.752 1.74956e-08
297.1 1.74956e-08
123.421 1.74956e-08
134.346 1.74956e-08
END
$picture3 << END
316.674 1.74956e-08
340.903 1.74956e-08
250.621 1.74956e-08
270.672 1.74956e-08
392.025 1.74956e-08
393.238 1.74956e-08
272.638 1.74956e-08
284.569 1.74956e-08
138.264 1.74956e-08
146.076 1.74956e-08
277.16 1.74956e-08
271.471 1.74956e-08
267.619 1.74956e-08
281.994 1.74956e-08
211.268 1.74956e-08
171.028 0.00173156
284.83 1.74956e-08
240.526 0.00217274
473.584 1.74956e-08
474.748 1.74956e-08
END
$picture4 << END
289.747 1.61996e-09
303.098 1.61996e-09
237.011 1.61996e-09
260.709 1.61996e-09
370.661 1.61996e-09
377.629 1.61996e-09
243.151 1.61996e-09
254.59 1.61996e-09
138.585 1.61996e-09
146.802 1.61996e-09
266.21 1.61996e-09
271.565 1.61996e-09
235.74 1.61996e-09
257.161 1.61996e-09
191.659 1.61996e-09
154.677 1.61996e-09
258.6 1.61996e-09
229.159 1.61996e-09
436.546 1.61996e-09
450.556 1.61996e-09
END
$picture5 << END
302.64 1.61996e-09
317.915 1.61996e-09
248.644 1.61996e-09
270.325 1.61996e-09
383.617 1.61996e-09
392.48 1.61996e-09
260.165 1.61996e-09
273.422 1.61996e-09
128.826 1.61996e-09
141.09 1.61996e-09
269.574 1.61996e-09
282.587 1.61996e-09
254.683 1.61996e-09
272.256 1.61996e-09
201.504 1.61996e-09
159.677 0.00173156
236.918 1.61996e-09
250.776 0.00217274
465.922 1.61996e-09
463.525 1.61996e-09
END
$picture_front << END
465.922 1.61996e-09
474.748 1.74956e-08
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
set xrange [0.533138:12.825]; set yrange [3.05176e-06:0.00175476]
set xlabel 'million nearest hits a second  (more is better)'; set ylabel 'wrong hits  (less is better)' offset -1.5
set label 'tetra: speed against accuracy (CPU, 2 threads)' at screen 0.02, screen 0.9774 font ',20'
set label '256x256 primary and 65,536 random rays a scene; 65,536 in all compared with brute force in double; pictures of 128x128' at screen 0.02, screen 0.9516
set xtics ('1' 1, '2' 2, '5' 5, '10' 10)
set ytics ("none of\n65,536" 7.62939e-06, '0.01 %%' 1e-4, '0.1 %%' 1e-3)
set object rectangle from graph 0, graph 0 to graph 1, first 1.297e-05 fs solid noborder fc rgb '#eeeeee' behind
set arrow from first 10.6875,3.05176e-05 to graph 1.0,0.3624 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.3624 to graph 1.015,0.3624 nohead lw 0.8 lc rgb '#999999'
set label 'robust, study: irregular exact' at graph 1.02,0.3624 left
set arrow from first 9.93396,7.62939e-06 to graph 1.0,0.1442 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.1442 to graph 1.015,0.1442 nohead lw 0.8 lc rgb '#999999'
set label 'robust: irregular exact' at graph 1.02,0.1442 left
$hits0 << END
4.92806 1.02997e-05
4.79256 1.02997e-05
4.14011 1.02997e-05
4.44537 1.02997e-05
6.49002 1.02997e-05
6.47706 1.02997e-05
4.35779 1.02997e-05
4.26366 1.02997e-05
2.61559 1.02997e-05
2.47843 1.02997e-05
4.65468 1.02997e-05
4.74281 1.02997e-05
4.03699 1.02997e-05
3.9799 1.02997e-05
3.14137 1.02997e-05
2.22128 1.02997e-05
4.39648 1.02997e-05
3.4734 1.02997e-05
7.76905 1.02997e-05
7.91248 1.02997e-05
END
$hits1 << END
4.20102 1.02997e-05
4.26947 4.57764e-05
4.02371 1.02997e-05
4.41528 7.62939e-05
6.05084 1.02997e-05
6.25194 1.02997e-05
3.8467 1.02997e-05
3.90104 4.57764e-05
2.41342 1.02997e-05
2.48423 7.62939e-05
4.66144 1.02997e-05
4.50278 1.02997e-05
3.48635 1.02997e-05
3.5432 6.10352e-05
2.65268 1.02997e-05
1.91701 0.000701904
3.60224 1.02997e-05
2.81304 0.000442505
7.46739 1.02997e-05
7.98211 3.05176e-05
END
$hits2 << END
6.72213 7.62939e-06
7.06769 7.62939e-06
4.49093 7.62939e-06
4.7449 7.62939e-06
7.47943 7.62939e-06
7.68882 7.62939e-06
5.78183 7.62939e-06
6.02573 7.62939e-06
2.32989 7.62939e-06
2.83507 7.62939e-06
5.5555 7.62939e-06
5.24598 7.62939e-06
5.50145 7.62939e-06
5.81291 7.62939e-06
3.79369 7.62939e-06
2.94643 7.62939e-06
5.45905 7.62939e-06
4.44779 7.62939e-06
8.95048 7.62939e-06
9.93396 7.62939e-06
0.639766 7.62939e-06
1.84718 7.62939e-06
4.38684 7.62939e-06
5.99905 7.62939e-06
1.88461 7.62939e-06
2.3858 7.62939e-06
END
$hits3 << END
7.28923 7.62939e-06
7.67647 4.57764e-05
4.64597 7.62939e-06
4.93667 7.62939e-05
7.75121 7.62939e-06
7.95233 7.62939e-06
6.17261 7.62939e-06
6.45034 4.57764e-05
2.47797 7.62939e-06
2.87958 7.62939e-05
5.86535 7.62939e-06
5.49022 7.62939e-06
5.97111 7.62939e-06
6.25121 6.10352e-05
3.92789 7.62939e-06
3.17066 0.000701904
5.65194 7.62939e-06
4.61217 0.000442505
9.73484 7.62939e-06
10.6875 3.05176e-05
END
$hits4 << END
6.17543 5.6514e-06
6.58882 5.6514e-06
4.39582 5.6514e-06
4.74469 5.6514e-06
7.29208 5.6514e-06
7.49215 5.6514e-06
5.41962 5.6514e-06
5.65304 5.6514e-06
2.62015 5.6514e-06
2.52084 5.6514e-06
5.55123 5.6514e-06
5.7698 5.6514e-06
5.11787 5.6514e-06
5.39654 5.6514e-06
3.4719 5.6514e-06
2.86109 5.6514e-06
4.99315 5.6514e-06
3.9335 5.6514e-06
8.6952 5.6514e-06
9.65902 5.6514e-06
END
$hits5 << END
6.72921 5.6514e-06
7.0549 4.57764e-05
4.47551 5.6514e-06
4.884 7.62939e-05
7.4795 5.6514e-06
7.77335 5.6514e-06
5.82349 5.6514e-06
6.06996 4.57764e-05
2.61416 5.6514e-06
2.8031 7.62939e-05
5.60987 5.6514e-06
6.01205 5.6514e-06
5.49756 5.6514e-06
5.85199 6.10352e-05
3.64758 5.6514e-06
2.91044 0.000701904
4.8428 5.6514e-06
4.17286 0.000442505
9.16544 5.6514e-06
10.1952 3.05176e-05
END
$hits_front << END
9.93396 7.62939e-06
10.6875 3.05176e-05
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
set xrange [26.0474:569.698]; set yrange [8.7478e-10:0.00543185]
set xlabel 'pictures a second  (more is better)'; set ylabel 'picture: RMSE of a channel  (less is better)' offset -1.5
set xtics ('50' 50, '100' 100, '200' 200, '500' 500)
set ytics ("same\nbits" 2.18695e-09, '10⁻⁸' 1e-8, '10⁻⁷' 1e-7, '10⁻⁶' 1e-6, '10⁻⁵' 1e-5, '10⁻⁴' 1e-4, '10⁻³' 1e-3)
set object rectangle from graph 0, graph 0 to graph 1, first 3.71782e-09 fs solid noborder fc rgb '#eeeeee' behind
set arrow from first 474.748,1.74956e-08 to graph 1.0,0.1915 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.1915 to graph 1.015,0.1915 nohead lw 0.8 lc rgb '#999999'
set label 'robust, study: irregular exact' at graph 1.02,0.1915 left
set arrow from first 465.922,1.61996e-09 to graph 1.0,0.0394 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.0394 to graph 1.015,0.0394 nohead lw 0.8 lc rgb '#999999'
set label 'double, study: irregular box' at graph 1.02,0.0394 left
$picture0 << END
290.819 4.25742e-07
262.041 4.25742e-07
247.544 4.25742e-07
263.893 4.25742e-07
388.021 4.25742e-07
359.455 4.25742e-07
250.798 4.25742e-07
235.919 4.25742e-07
135.793 4.25742e-07
129.049 4.25742e-07
261.977 4.25742e-07
251.905 4.25742e-07
234.749 4.25742e-07
228.821 4.25742e-07
201.199 4.25742e-07
139.854 4.25742e-07
263.666 4.25742e-07
224.457 4.25742e-07
431.598 4.25742e-07
416.479 4.25742e-07
END
$picture1 << END
189.682 4.25742e-07
195.948 4.25742e-07
219.185 4.25742e-07
238.637 4.25742e-07
321.926 4.25742e-07
317.857 4.25742e-07
251.56 4.25742e-07
246.592 4.25742e-07
127.045 4.25742e-07
143.137 4.25742e-07
272.792 4.25742e-07
250.951 4.25742e-07
237.167 4.25742e-07
239.58 4.25742e-07
199.797 4.25742e-07
140.816 0.00173156
260.235 4.25742e-07
226.848 0.00217274
448.352 4.25742e-07
414.334 4.25742e-07
END
$picture2 << END
302.983 1.74956e-08
322.037 1.74956e-08
244.827 1.74956e-08
267.882 1.74956e-08
374.428 1.74956e-08
392.043 1.74956e-08
259.641 1.74956e-08
275.105 1.74956e-08
127.605 1.74956e-08
144.492 1.74956e-08
266.083 1.74956e-08
252.319 1.74956e-08
256.429 1.74956e-08
271.967 1.74956e-08
204.484 1.74956e-08
167.036 1.74956e-08
279.575 1.74956e-08
242.98 1.74956e-08
450.914 1.74956e-08
454.36 1.74956e-08
31.2568 1.74956e-08
89.1552 1.74956e-08
210.752 1.74956e-08
297.1 1.74956e-08
123.421 1.74956e-08
134.346 1.74956e-08
END
$picture3 << END
316.674 1.74956e-08
340.903 1.74956e-08
250.621 1.74956e-08
270.672 1.74956e-08
392.025 1.74956e-08
393.238 1.74956e-08
272.638 1.74956e-08
284.569 1.74956e-08
138.264 1.74956e-08
146.076 1.74956e-08
277.16 1.74956e-08
271.471 1.74956e-08
267.619 1.74956e-08
281.994 1.74956e-08
211.268 1.74956e-08
171.028 0.00173156
284.83 1.74956e-08
240.526 0.00217274
473.584 1.74956e-08
474.748 1.74956e-08
END
$picture4 << END
289.747 1.61996e-09
303.098 1.61996e-09
237.011 1.61996e-09
260.709 1.61996e-09
370.661 1.61996e-09
377.629 1.61996e-09
243.151 1.61996e-09
254.59 1.61996e-09
138.585 1.61996e-09
146.802 1.61996e-09
266.21 1.61996e-09
271.565 1.61996e-09
235.74 1.61996e-09
257.161 1.61996e-09
191.659 1.61996e-09
154.677 1.61996e-09
258.6 1.61996e-09
229.159 1.61996e-09
436.546 1.61996e-09
450.556 1.61996e-09
END
$picture5 << END
302.64 1.61996e-09
317.915 1.61996e-09
248.644 1.61996e-09
270.325 1.61996e-09
383.617 1.61996e-09
392.48 1.61996e-09
260.165 1.61996e-09
273.422 1.61996e-09
128.826 1.61996e-09
141.09 1.61996e-09
269.574 1.61996e-09
282.587 1.61996e-09
254.683 1.61996e-09
272.256 1.61996e-09
201.504 1.61996e-09
159.677 0.00173156
236.918 1.61996e-09
250.776 0.00217274
465.922 1.61996e-09
463.525 1.61996e-09
END
$picture_front << END
465.922 1.61996e-09
474.748 1.74956e-08
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
set xrange [0.642273:17.8638]; set yrange [3.05176e-06:0.017395]
set xlabel 'million nearest hits a second  (more is better)'; set ylabel 'wrong hits  (less is better)' offset -1.5
set label 'tree: speed against accuracy (CPU, 2 threads)' at screen 0.02, screen 0.9774 font ',20'
set label '256x256 primary and 65,536 random rays a scene; 65,536 in all compared with brute force in double; pictures of 128x128' at screen 0.02, screen 0.9516
set xtics ('1' 1, '2' 2, '5' 5, '10' 10)
set ytics ("none of\n65,536" 7.62939e-06, '0.01 %%' 1e-4, '0.1 %%' 1e-3, '1 %%' 1e-2)
set object rectangle from graph 0, graph 0 to graph 1, first 1.297e-05 fs solid noborder fc rgb '#eeeeee' behind
set arrow from first 14.8865,0.00569153 to graph 1.0,0.8708 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.8708 to graph 1.015,0.8708 nohead lw 0.8 lc rgb '#999999'
set label 'double, study: irregular box' at graph 1.02,0.8708 left
set arrow from first 14.2602,7.62939e-06 to graph 1.0,0.1060 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.1060 to graph 1.015,0.1060 nohead lw 0.8 lc rgb '#999999'
set label 'robust: irregular exact' at graph 1.02,0.1060 left
$hits0 << END
2.38861 0.00125122
3.13265 0.00125122
1.44854 0.00125122
1.54915 0.00125122
0.770728 0.00125122
3.03817 0.00125122
3.26243 0.00125122
12.6021 0.00125122
13.7665 0.00125122
END
$hits1 << END
2.69252 0.00257874
3.31174 0.0022583
1.55325 0.00257874
1.58989 0.0022583
0.775455 0.00204468
3.05267 0.00180054
3.23891 0.00158691
13.7711 0.00695801
13.8913 0.00695801
END
$hits2 << END
1.49381 7.62939e-06
1.54886 7.62939e-06
2.78221 7.62939e-06
3.27899 7.62939e-06
1.39443 7.62939e-06
1.43675 7.62939e-06
1.47616 7.62939e-06
1.48952 7.62939e-06
1.50093 7.62939e-06
1.55241 7.62939e-06
3.85044 7.62939e-06
3.88773 7.62939e-06
13.2167 7.62939e-06
14.2602 7.62939e-06
0.868782 7.62939e-06
2.41954 7.62939e-06
2.78272 7.62939e-06
END
$hits3 << END
1.52777 0.000823975
1.61136 0.000930786
3.11968 0.00132751
3.30986 0.00100708
1.40271 0.000823975
1.47499 0.000930786
1.62589 0.00132751
1.64895 0.00100708
1.57088 0.000823975
1.63696 0.000793457
3.91408 0.000564575
3.86418 0.000350952
14.5246 0.00569153
14.3844 0.00569153
END
$hits4 << END
1.44586 5.6514e-06
1.52587 5.6514e-06
3.15084 5.6514e-06
2.99646 5.6514e-06
1.35833 5.6514e-06
1.40986 5.6514e-06
1.49256 5.6514e-06
1.53119 5.6514e-06
1.44205 5.6514e-06
1.49339 5.6514e-06
3.74262 5.6514e-06
3.80531 5.6514e-06
13.5684 5.6514e-06
13.6563 5.6514e-06
END
$hits5 << END
1.46595 0.000823975
1.55392 0.000930786
3.37004 0.00132751
3.33605 0.00100708
1.34441 0.000823975
1.41224 0.000930786
1.64162 0.00132751
1.64924 0.00100708
1.51819 0.000823975
1.54204 0.000793457
3.76103 0.000564575
3.83927 0.000350952
14.8865 0.00569153
14.572 0.00569153
END
$hits_front << END
14.2602 7.62939e-06
14.8865 0.00569153
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
set xrange [4.07074:138.697]; set yrange [5.2625e-05:0.0737055]
set xlabel 'pictures a second  (more is better)'; set ylabel 'picture: RMSE of a channel  (less is better)' offset -1.5
set xtics ('5' 5, '10' 10, '20' 20, '50' 50, '100' 100)
set ytics ("same\nbits" 0.000131563, '10⁻³' 1e-3, '10⁻²' 1e-2)
set object rectangle from graph 0, graph 0 to graph 1, first 0.000223656 fs solid noborder fc rgb '#eeeeee' behind
set arrow from first 115.581,0.0294223 to graph 1.0,0.9172 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.9172 to graph 1.015,0.9172 nohead lw 0.8 lc rgb '#999999'
set label 'fast, study: irregular exact' at graph 1.02,0.9172 left
set arrow from first 113.025,0.02193 to graph 1.0,0.8672 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.8672 to graph 1.015,0.8672 nohead lw 0.8 lc rgb '#999999'
set label 'double, study: irregular exact' at graph 1.02,0.8672 left
set arrow from first 112.666,0.0196098 to graph 1.0,0.8172 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.8172 to graph 1.015,0.8172 nohead lw 0.8 lc rgb '#999999'
set label 'fast: irregular exact' at graph 1.02,0.8172 left
set arrow from first 111.845,9.74537e-05 to graph 1.0,0.0851 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.0851 to graph 1.015,0.0851 nohead lw 0.8 lc rgb '#999999'
set label 'double: irregular exact' at graph 1.02,0.0851 left
$picture0 << END
26.9288 0.0196098
31.3428 0.0196098
11.9839 0.0196098
12.5472 0.0196098
4.88489 0.0196098
24.2527 0.0196098
25.7075 0.0196098
107.039 0.0196098
112.666 0.0196098
END
$picture1 << END
28.0514 0.0207304
32.4437 0.0205941
12.4288 0.0207304
12.6979 0.0205941
4.94166 0.0200072
24.2402 0.0198815
24.8093 0.0197756
108.858 0.0294822
115.581 0.0294223
END
$picture2 << END
9.03669 0.0010525
9.30484 0.0010525
26.6655 0.0010525
27.6799 0.0010525
7.56138 0.0010525
7.82087 0.0010525
12.3263 0.0010525
12.6349 0.0010525
9.05256 0.0010525
9.50941 0.0010525
30.7052 0.0010525
30.9839 0.0010525
105.609 0.0010525
109.301 0.0010525
5.40602 0.0010525
12.6856 0.0010525
15.1688 0.0010525
END
$picture3 << END
9.30492 0.00394034
9.86952 0.00466028
27.1211 0.00698046
30.3938 0.0064093
7.72284 0.00394034
8.07213 0.00466028
12.4991 0.00698046
12.6298 0.0064093
9.76868 0.00394034
9.94283 0.00405174
29.3845 0.00375491
31.4416 0.00280699
108.61 0.0220073
110.297 0.0219551
END
$picture4 << END
8.72814 9.74537e-05
9.35594 9.74537e-05
31.9054 9.74537e-05
29.3984 9.74537e-05
7.34182 9.74537e-05
7.72965 9.74537e-05
12.719 9.74537e-05
13.163 9.74537e-05
9.32071 9.74537e-05
9.62418 9.74537e-05
29.4919 9.74537e-05
32.0752 9.74537e-05
106.932 9.74537e-05
111.845 9.74537e-05
END
$picture5 << END
9.24813 0.00379718
9.91237 0.00453988
32.5558 0.00690066
30.6805 0.00632229
7.46497 0.00379718
7.90064 0.00453988
12.9647 0.00690066
13.1735 0.00632229
9.54864 0.00379718
9.595 0.00391266
29.5997 0.00360438
32.1301 0.0026022
108.406 0.0219886
113.025 0.02193
END
$picture_front << END
111.845 9.74537e-05
112.666 0.0196098
113.025 0.02193
115.581 0.0294223
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
set xrange [0.642273:17.8638]; set yrange [3.05176e-06:0.017395]
set xlabel 'million nearest hits a second  (more is better)'; set ylabel 'wrong hits  (less is better)' offset -1.5
set label 'tree: speed against accuracy (CPU, 2 threads)' at screen 0.02, screen 0.9774 font ',20'
set label '256x256 primary and 65,536 random rays a scene; 65,536 in all compared with brute force in double; pictures of 128x128' at screen 0.02, screen 0.9516
set xtics ('1' 1, '2' 2, '5' 5, '10' 10)
set ytics ("none of\n65,536" 7.62939e-06, '0.01 %%' 1e-4, '0.1 %%' 1e-3, '1 %%' 1e-2)
set object rectangle from graph 0, graph 0 to graph 1, first 1.297e-05 fs solid noborder fc rgb '#eeeeee' behind
set arrow from first 14.8865,0.00569153 to graph 1.0,0.8708 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.8708 to graph 1.015,0.8708 nohead lw 0.8 lc rgb '#999999'
set label 'double, study: irregular box' at graph 1.02,0.8708 left
set arrow from first 14.2602,7.62939e-06 to graph 1.0,0.1060 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.1060 to graph 1.015,0.1060 nohead lw 0.8 lc rgb '#999999'
set label 'robust: irregular exact' at graph 1.02,0.1060 left
$hits0 << END
2.38861 0.00125122
3.13265 0.00125122
1.44854 0.00125122
1.54915 0.00125122
0.770728 0.00125122
3.03817 0.00125122
3.26243 0.00125122
12.6021 0.00125122
13.7665 0.00125122
END
$hits1 << END
2.69252 0.00257874
3.31174 0.0022583
1.55325 0.00257874
1.58989 0.0022583
0.775455 0.00204468
3.05267 0.00180054
3.23891 0.00158691
13.7711 0.00695801
13.8913 0.00695801
END
$hits2 << END
1.49381 7.62939e-06
1.54886 7.62939e-06
2.78221 7.62939e-06
3.27899 7.62939e-06
1.39443 7.62939e-06
1.43675 7.62939e-06
1.47616 7.62939e-06
1.48952 7.62939e-06
1.50093 7.62939e-06
1.55241 7.62939e-06
3.85044 7.62939e-06
3.88773 7.62939e-06
13.2167 7.62939e-06
14.2602 7.62939e-06
0.868782 7.62939e-06
2.41954 7.62939e-06
2.78272 7.62939e-06
END
$hits3 << END
1.52777 0.000823975
1.61136 0.000930786
3.11968 0.00132751
3.30986 0.00100708
1.40271 0.000823975
1.47499 0.000930786
1.62589 0.00132751
1.64895 0.00100708
1.57088 0.000823975
1.63696 0.000793457
3.91408 0.000564575
3.86418 0.000350952
14.5246 0.00569153
14.3844 0.00569153
END
$hits4 << END
1.44586 5.6514e-06
1.52587 5.6514e-06
3.15084 5.6514e-06
2.99646 5.6514e-06
1.35833 5.6514e-06
1.40986 5.6514e-06
1.49256 5.6514e-06
1.53119 5.6514e-06
1.44205 5.6514e-06
1.49339 5.6514e-06
3.74262 5.6514e-06
3.80531 5.6514e-06
13.5684 5.6514e-06
13.6563 5.6514e-06
END
$hits5 << END
1.46595 0.000823975
1.55392 0.000930786
3.37004 0.00132751
3.33605 0.00100708
1.34441 0.000823975
1.41224 0.000930786
1.64162 0.00132751
1.64924 0.00100708
1.51819 0.000823975
1.54204 0.000793457
3.76103 0.000564575
3.83927 0.000350952
14.8865 0.00569153
14.572 0.00569153
END
$hits_front << END
14.2602 7.62939e-06
14.8865 0.00569153
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
set xrange [4.07074:138.697]; set yrange [5.2625e-05:0.0737055]
set xlabel 'pictures a second  (more is better)'; set ylabel 'picture: RMSE of a channel  (less is better)' offset -1.5
set xtics ('5' 5, '10' 10, '20' 20, '50' 50, '100' 100)
set ytics ("same\nbits" 0.000131563, '10⁻³' 1e-3, '10⁻²' 1e-2)
set object rectangle from graph 0, graph 0 to graph 1, first 0.000223656 fs solid noborder fc rgb '#eeeeee' behind
set arrow from first 115.581,0.0294223 to graph 1.0,0.9172 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.9172 to graph 1.015,0.9172 nohead lw 0.8 lc rgb '#999999'
set label 'fast, study: irregular exact' at graph 1.02,0.9172 left
set arrow from first 113.025,0.02193 to graph 1.0,0.8672 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.8672 to graph 1.015,0.8672 nohead lw 0.8 lc rgb '#999999'
set label 'double, study: irregular exact' at graph 1.02,0.8672 left
set arrow from first 112.666,0.0196098 to graph 1.0,0.8172 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.8172 to graph 1.015,0.8172 nohead lw 0.8 lc rgb '#999999'
set label 'fast: irregular exact' at graph 1.02,0.8172 left
set arrow from first 111.845,9.74537e-05 to graph 1.0,0.0851 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.0851 to graph 1.015,0.0851 nohead lw 0.8 lc rgb '#999999'
set label 'double: irregular exact' at graph 1.02,0.0851 left
$picture0 << END
26.9288 0.0196098
31.3428 0.0196098
11.9839 0.0196098
12.5472 0.0196098
4.88489 0.0196098
24.2527 0.0196098
25.7075 0.0196098
107.039 0.0196098
112.666 0.0196098
END
$picture1 << END
28.0514 0.0207304
32.4437 0.0205941
12.4288 0.0207304
12.6979 0.0205941
4.94166 0.0200072
24.2402 0.0198815
24.8093 0.0197756
108.858 0.0294822
115.581 0.0294223
END
$picture2 << END
9.03669 0.0010525
9.30484 0.0010525
26.6655 0.0010525
27.6799 0.0010525
7.56138 0.0010525
7.82087 0.0010525
12.3263 0.0010525
12.6349 0.0010525
9.05256 0.0010525
9.50941 0.0010525
30.7052 0.0010525
30.9839 0.0010525
105.609 0.0010525
109.301 0.0010525
5.40602 0.0010525
12.6856 0.0010525
15.1688 0.0010525
END
$picture3 << END
9.30492 0.00394034
9.86952 0.00466028
27.1211 0.00698046
30.3938 0.0064093
7.72284 0.00394034
8.07213 0.00466028
12.4991 0.00698046
12.6298 0.0064093
9.76868 0.00394034
9.94283 0.00405174
29.3845 0.00375491
31.4416 0.00280699
108.61 0.0220073
110.297 0.0219551
END
$picture4 << END
8.72814 9.74537e-05
9.35594 9.74537e-05
31.9054 9.74537e-05
29.3984 9.74537e-05
7.34182 9.74537e-05
7.72965 9.74537e-05
12.719 9.74537e-05
13.163 9.74537e-05
9.32071 9.74537e-05
9.62418 9.74537e-05
29.4919 9.74537e-05
32.0752 9.74537e-05
106.932 9.74537e-05
111.845 9.74537e-05
END
$picture5 << END
9.24813 0.00379718
9.91237 0.00453988
32.5558 0.00690066
30.6805 0.00632229
7.46497 0.00379718
7.90064 0.00453988
12.9647 0.00690066
13.1735 0.00632229
9.54864 0.00379718
9.595 0.00391266
29.5997 0.00360438
32.1301 0.0026022
108.406 0.0219886
113.025 0.02193
END
$picture_front << END
111.845 9.74537e-05
112.666 0.0196098
113.025 0.02193
115.581 0.0294223
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
set xrange [0.551747:14.1249]; set yrange [4.35965e-07:0.0195694]
set xlabel 'million nearest hits a second  (more is better)'; set ylabel 'wrong hits  (less is better)' offset -1.5
set label 'mean of 7 scenes: speed against accuracy (CPU, 2 threads)' at screen 0.02, screen 0.9774 font ',20'
set label '256x256 primary and 65,536 random rays a scene; 458,752 in all compared with brute force in double; pictures of 128x128' at screen 0.02, screen 0.9516
set xtics ('1' 1, '2' 2, '5' 5, '10' 10)
set ytics ("none of\n458,752" 1.08991e-06, '0.001 %%' 1e-5, '0.01 %%' 1e-4, '0.1 %%' 1e-3, '1 %%' 1e-2)
set object rectangle from graph 0, graph 0 to graph 1, first 1.85285e-06 fs solid noborder fc rgb '#eeeeee' behind
set arrow from first 11.7708,0.00251334 to graph 1.0,0.8084 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.8084 to graph 1.015,0.8084 nohead lw 0.8 lc rgb '#999999'
set label 'robust, study: irregular exact' at graph 1.02,0.8084 left
set arrow from first 10.9019,1.08991e-06 to graph 1.0,0.0855 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.0855 to graph 1.015,0.0855 nohead lw 0.8 lc rgb '#999999'
set label 'robust: irregular exact' at graph 1.02,0.0855 left
$hits0 << END
2.12227 0.000233241
2.20134 0.000233241
2.91081 0.000233241
3.23805 0.000233241
4.18708 0.000233241
4.54738 0.000233241
2.01129 0.000233241
2.04166 0.000233241
1.95995 0.000233241
2.05522 0.000233241
2.90225 0.000233241
3.12156 0.000233241
2.01254 0.000233241
2.05252 0.000233241
2.16012 0.000233241
2.05109 0.000233241
3.21388 0.000233241
3.20736 0.000233241
8.74013 0.000233241
10.0503 0.000233241
END
$hits1 << END
1.91106 0.00527736
1.99371 0.00514657
3.03437 0.00782776
3.27516 0.00444249
4.15206 0.00572641
4.5338 0.00240871
1.82409 0.00527736
1.89008 0.00514657
1.95179 0.00782776
2.11028 0.00444249
2.95686 0.00572641
3.18706 0.00240871
1.77451 0.00543649
1.86219 0.00517927
1.99298 0.00716291
1.90649 0.00560652
3.00982 0.00575692
3.00044 0.00289699
9.40052 0.00574384
10.486 0.0027444
END
$hits2 << END
2.70761 1.08991e-06
2.75906 1.08991e-06
3.33066 1.08991e-06
3.66182 1.08991e-06
4.47947 1.08991e-06
4.89292 1.08991e-06
2.49596 1.08991e-06
2.56727 1.08991e-06
2.17194 1.08991e-06
2.3388 1.08991e-06
3.02889 1.08991e-06
3.22279 1.08991e-06
2.5451 1.08991e-06
2.53963 1.08991e-06
2.65624 1.08991e-06
2.63796 1.08991e-06
3.70207 1.08991e-06
3.81003 1.08991e-06
9.73661 1.08991e-06
10.9019 1.08991e-06
0.662097 1.08991e-06
1.64218 1.08991e-06
3.94888 1.08991e-06
2.30519 1.08991e-06
3.02616 1.08991e-06
END
$hits3 << END
2.9714 0.00504848
2.94023 0.00491333
3.62177 0.00759888
3.81474 0.00421797
4.81175 0.00550188
5.06891 0.00217983
2.6968 0.00504848
2.75631 0.00491333
2.29885 0.00759888
2.42261 0.00421797
3.25604 0.00550188
3.34872 0.00217983
2.72417 0.00520979
2.74678 0.00494603
2.76422 0.00694275
2.79416 0.00538853
3.93496 0.0055324
3.82741 0.00267029
10.9756 0.00551714
11.7708 0.00251334
END
$hits4 << END
2.37512 8.07343e-07
2.35143 8.07343e-07
3.37179 8.07343e-07
3.57451 8.07343e-07
4.53878 8.07343e-07
4.80735 8.07343e-07
2.33459 8.07343e-07
2.39034 8.07343e-07
2.22342 8.07343e-07
2.31705 8.07343e-07
3.08636 8.07343e-07
3.31239 8.07343e-07
2.38077 8.07343e-07
2.46449 8.07343e-07
2.50667 8.07343e-07
2.53421 8.07343e-07
3.54717 8.07343e-07
3.59806 8.07343e-07
9.87317 8.07343e-07
10.8334 8.07343e-07
END
$hits5 << END
2.61449 0.00504848
2.67043 0.00491333
3.61942 0.00759888
3.72737 0.00422015
4.82702 0.00550188
4.96914 0.00217983
2.43768 0.00504848
2.59555 0.00491333
2.3283 0.00759888
2.42207 0.00421797
3.35737 0.00550188
3.52462 0.00217983
2.48876 0.00520979
2.61184 0.00494603
2.69737 0.00694493
2.65142 0.00539071
3.67385 0.0055324
3.72702 0.00267029
10.8242 0.00551714
11.5417 0.00251334
END
$hits_front << END
10.9019 1.08991e-06
11.7708 0.00251334
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
set xrange [6.63323:128.706]; set yrange [4.92168e-05:0.0711461]
set xlabel 'pictures a second  (more is better)'; set ylabel 'picture: RMSE of a channel  (less is better)' offset -1.5
set xtics ('7' 7, '10' 10, '15' 15, '20' 20, '30' 30, '50' 50, '70' 70, '100' 100)
set ytics ("same\nbits" 0.000123042, '10⁻³' 1e-3, '10⁻²' 1e-2)
set object rectangle from graph 0, graph 0 to graph 1, first 0.000209172 fs solid noborder fc rgb '#eeeeee' behind
set arrow from first 107.255,0.0151009 to graph 1.0,0.8367 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.8367 to graph 1.015,0.8367 nohead lw 0.8 lc rgb '#999999'
set label 'robust, study: irregular exact' at graph 1.02,0.8367 left
set arrow from first 107.241,0.0150679 to graph 1.0,0.7867 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.7867 to graph 1.015,0.7867 nohead lw 0.8 lc rgb '#999999'
set label 'double, study: irregular exact' at graph 1.02,0.7867 left
set arrow from first 104.516,9.11423e-05 to graph 1.0,0.0847 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.0847 to graph 1.015,0.0847 nohead lw 0.8 lc rgb '#999999'
set label 'double: irregular exact' at graph 1.02,0.0847 left
$picture0 << END
23.2568 0.0125823
23.7743 0.0125823
33.1086 0.0125823
36.4829 0.0125823
51.3434 0.0125823
53.9361 0.0125823
22.0831 0.0125823
22.6951 0.0125823
22.0686 0.0125823
23.8952 0.0125823
35.4401 0.0125823
37.4903 0.0125823
21.9742 0.0125823
22.5274 0.0125823
25.7877 0.0125823
24.604 0.0125823
39.0879 0.0125823
40.0797 0.0125823
92.9093 0.0125823
101.876 0.0125823
END
$picture1 << END
19.4569 0.0227032
20.2829 0.0223245
32.834 0.0284585
35.8212 0.0216955
50.361 0.0244157
55.52 0.0182114
21.5907 0.0227032
22.3522 0.0223245
23.1415 0.0284585
24.7123 0.0216955
36.9425 0.0244157
38.3832 0.0182114
21.4984 0.0227037
22.2634 0.0223245
25.8931 0.0253324
24.5286 0.0228795
39.8102 0.0237884
40.6654 0.0184323
97.8471 0.025209
104.873 0.0194287
END
$picture2 << END
27.6363 0.000984337
27.8209 0.000984337
36.2204 0.000984337
39.5715 0.000984337
51.1291 0.000984337
56.7144 0.000984337
25.9793 0.000984337
27.0066 0.000984337
24.5765 0.000984337
26.4177 0.000984337
36.2555 0.000984337
37.1106 0.000984337
27.0325 0.000984337
26.898 0.000984337
29.5947 0.000984337
29.9966 0.000984337
43.5925 0.000984337
44.249 0.000984337
97.028 0.000984337
103.473 0.000984337
7.95988 0.000984337
17.5693 0.000984337
40.1706 0.000984337
26.9127 0.000984337
31.5304 0.000984337
END
$picture3 << END
29.6958 0.0192272
29.8112 0.0187296
39.2859 0.0258927
40.8437 0.017856
54.7156 0.0212963
59.2741 0.0134829
27.7961 0.0192272
28.4264 0.0187296
25.8223 0.0258927
27.468 0.017856
37.7606 0.0212963
39.3626 0.0134829
28.0281 0.0192279
28.3905 0.0187296
31.0917 0.0222709
30.986 0.0194229
44.9581 0.0204607
45.5559 0.0137772
102.123 0.0221638
107.255 0.0151009
END
$picture4 << END
24.4339 9.11423e-05
26.4488 9.11423e-05
35.7162 9.11423e-05
38.5477 9.11423e-05
53.1028 9.11423e-05
55.4724 9.11423e-05
24.3215 9.11423e-05
24.8609 9.11423e-05
24.6621 9.11423e-05
26.3877 9.11423e-05
36.5281 9.11423e-05
39.2833 9.11423e-05
24.8043 9.11423e-05
25.7968 9.11423e-05
28.4802 9.11423e-05
28.3397 9.11423e-05
42.3675 9.11423e-05
42.7093 9.11423e-05
96.5176 9.11423e-05
104.516 9.11423e-05
END
$picture5 << END
26.8708 0.0192032
27.618 0.0187046
38.6208 0.0258798
40.975 0.0178357
54.5288 0.0212768
58.3785 0.0134492
25.3709 0.0192032
26.3408 0.0187046
25.9173 0.0258798
27.4724 0.0178368
38.3285 0.0212768
40.8521 0.0134492
25.9664 0.0192039
26.9153 0.0187046
29.9785 0.0222503
29.2282 0.0194335
42.7212 0.0204423
44.8268 0.0137465
100.358 0.0221462
107.241 0.0150679
END
$picture_front << END
104.516 9.11423e-05
107.241 0.0150679
107.255 0.0151009
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
set xrange [0.551747:14.1249]; set yrange [4.35965e-07:0.0195694]
set xlabel 'million nearest hits a second  (more is better)'; set ylabel 'wrong hits  (less is better)' offset -1.5
set label 'mean of 7 scenes: speed against accuracy (CPU, 2 threads)' at screen 0.02, screen 0.9774 font ',20'
set label '256x256 primary and 65,536 random rays a scene; 458,752 in all compared with brute force in double; pictures of 128x128' at screen 0.02, screen 0.9516
set xtics ('1' 1, '2' 2, '5' 5, '10' 10)
set ytics ("none of\n458,752" 1.08991e-06, '0.001 %%' 1e-5, '0.01 %%' 1e-4, '0.1 %%' 1e-3, '1 %%' 1e-2)
set object rectangle from graph 0, graph 0 to graph 1, first 1.85285e-06 fs solid noborder fc rgb '#eeeeee' behind
set arrow from first 11.7708,0.00251334 to graph 1.0,0.8084 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.8084 to graph 1.015,0.8084 nohead lw 0.8 lc rgb '#999999'
set label 'robust, study: irregular exact' at graph 1.02,0.8084 left
set arrow from first 10.9019,1.08991e-06 to graph 1.0,0.0855 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.0855 to graph 1.015,0.0855 nohead lw 0.8 lc rgb '#999999'
set label 'robust: irregular exact' at graph 1.02,0.0855 left
$hits0 << END
2.12227 0.000233241
2.20134 0.000233241
2.91081 0.000233241
3.23805 0.000233241
4.18708 0.000233241
4.54738 0.000233241
2.01129 0.000233241
2.04166 0.000233241
1.95995 0.000233241
2.05522 0.000233241
2.90225 0.000233241
3.12156 0.000233241
2.01254 0.000233241
2.05252 0.000233241
2.16012 0.000233241
2.05109 0.000233241
3.21388 0.000233241
3.20736 0.000233241
8.74013 0.000233241
10.0503 0.000233241
END
$hits1 << END
1.91106 0.00527736
1.99371 0.00514657
3.03437 0.00782776
3.27516 0.00444249
4.15206 0.00572641
4.5338 0.00240871
1.82409 0.00527736
1.89008 0.00514657
1.95179 0.00782776
2.11028 0.00444249
2.95686 0.00572641
3.18706 0.00240871
1.77451 0.00543649
1.86219 0.00517927
1.99298 0.00716291
1.90649 0.00560652
3.00982 0.00575692
3.00044 0.00289699
9.40052 0.00574384
10.486 0.0027444
END
$hits2 << END
2.70761 1.08991e-06
2.75906 1.08991e-06
3.33066 1.08991e-06
3.66182 1.08991e-06
4.47947 1.08991e-06
4.89292 1.08991e-06
2.49596 1.08991e-06
2.56727 1.08991e-06
2.17194 1.08991e-06
2.3388 1.08991e-06
3.02889 1.08991e-06
3.22279 1.08991e-06
2.5451 1.08991e-06
2.53963 1.08991e-06
2.65624 1.08991e-06
2.63796 1.08991e-06
3.70207 1.08991e-06
3.81003 1.08991e-06
9.73661 1.08991e-06
10.9019 1.08991e-06
0.662097 1.08991e-06
1.64218 1.08991e-06
3.94888 1.08991e-06
2.30519 1.08991e-06
3.02616 1.08991e-06
END
$hits3 << END
2.9714 0.00504848
2.94023 0.00491333
3.62177 0.00759888
3.81474 0.00421797
4.81175 0.00550188
5.06891 0.00217983
2.6968 0.00504848
2.75631 0.00491333
2.29885 0.00759888
2.42261 0.00421797
3.25604 0.00550188
3.34872 0.00217983
2.72417 0.00520979
2.74678 0.00494603
2.76422 0.00694275
2.79416 0.00538853
3.93496 0.0055324
3.82741 0.00267029
10.9756 0.00551714
11.7708 0.00251334
END
$hits4 << END
2.37512 8.07343e-07
2.35143 8.07343e-07
3.37179 8.07343e-07
3.57451 8.07343e-07
4.53878 8.07343e-07
4.80735 8.07343e-07
2.33459 8.07343e-07
2.39034 8.07343e-07
2.22342 8.07343e-07
2.31705 8.07343e-07
3.08636 8.07343e-07
3.31239 8.07343e-07
2.38077 8.07343e-07
2.46449 8.07343e-07
2.50667 8.07343e-07
2.53421 8.07343e-07
3.54717 8.07343e-07
3.59806 8.07343e-07
9.87317 8.07343e-07
10.8334 8.07343e-07
END
$hits5 << END
2.61449 0.00504848
2.67043 0.00491333
3.61942 0.00759888
3.72737 0.00422015
4.82702 0.00550188
4.96914 0.00217983
2.43768 0.00504848
2.59555 0.00491333
2.3283 0.00759888
2.42207 0.00421797
3.35737 0.00550188
3.52462 0.00217983
2.48876 0.00520979
2.61184 0.00494603
2.69737 0.00694493
2.65142 0.00539071
3.67385 0.0055324
3.72702 0.00267029
10.8242 0.00551714
11.5417 0.00251334
END
$hits_front << END
10.9019 1.08991e-06
11.7708 0.00251334
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
set xrange [6.63323:128.706]; set yrange [4.92168e-05:0.0711461]
set xlabel 'pictures a second  (more is better)'; set ylabel 'picture: RMSE of a channel  (less is better)' offset -1.5
set xtics ('7' 7, '10' 10, '15' 15, '20' 20, '30' 30, '50' 50, '70' 70, '100' 100)
set ytics ("same\nbits" 0.000123042, '10⁻³' 1e-3, '10⁻²' 1e-2)
set object rectangle from graph 0, graph 0 to graph 1, first 0.000209172 fs solid noborder fc rgb '#eeeeee' behind
set arrow from first 107.255,0.0151009 to graph 1.0,0.8367 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.8367 to graph 1.015,0.8367 nohead lw 0.8 lc rgb '#999999'
set label 'robust, study: irregular exact' at graph 1.02,0.8367 left
set arrow from first 107.241,0.0150679 to graph 1.0,0.7867 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.7867 to graph 1.015,0.7867 nohead lw 0.8 lc rgb '#999999'
set label 'double, study: irregular exact' at graph 1.02,0.7867 left
set arrow from first 104.516,9.11423e-05 to graph 1.0,0.0847 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.0847 to graph 1.015,0.0847 nohead lw 0.8 lc rgb '#999999'
set label 'double: irregular exact' at graph 1.02,0.0847 left
$picture0 << END
23.2568 0.0125823
23.7743 0.0125823
33.1086 0.0125823
36.4829 0.0125823
51.3434 0.0125823
53.9361 0.0125823
22.0831 0.0125823
22.6951 0.0125823
22.0686 0.0125823
23.8952 0.0125823
35.4401 0.0125823
37.4903 0.0125823
21.9742 0.0125823
22.5274 0.0125823
25.7877 0.0125823
24.604 0.0125823
39.0879 0.0125823
40.0797 0.0125823
92.9093 0.0125823
101.876 0.0125823
END
$picture1 << END
19.4569 0.0227032
20.2829 0.0223245
32.834 0.0284585
35.8212 0.0216955
50.361 0.0244157
55.52 0.0182114
21.5907 0.0227032
22.3522 0.0223245
23.1415 0.0284585
24.7123 0.0216955
36.9425 0.0244157
38.3832 0.0182114
21.4984 0.0227037
22.2634 0.0223245
25.8931 0.0253324
24.5286 0.0228795
39.8102 0.0237884
40.6654 0.0184323
97.8471 0.025209
104.873 0.0194287
END
$picture2 << END
27.6363 0.000984337
27.8209 0.000984337
36.2204 0.000984337
39.5715 0.000984337
51.1291 0.000984337
56.7144 0.000984337
25.9793 0.000984337
27.0066 0.000984337
24.5765 0.000984337
26.4177 0.000984337
36.2555 0.000984337
37.1106 0.000984337
27.0325 0.000984337
26.898 0.000984337
29.5947 0.000984337
29.9966 0.000984337
43.5925 0.000984337
44.249 0.000984337
97.028 0.000984337
103.473 0.000984337
7.95988 0.000984337
17.5693 0.000984337
40.1706 0.000984337
26.9127 0.000984337
31.5304 0.000984337
END
$picture3 << END
29.6958 0.0192272
29.8112 0.0187296
39.2859 0.0258927
40.8437 0.017856
54.7156 0.0212963
59.2741 0.0134829
27.7961 0.0192272
28.4264 0.0187296
25.8223 0.0258927
27.468 0.017856
37.7606 0.0212963
39.3626 0.0134829
28.0281 0.0192279
28.3905 0.0187296
31.0917 0.0222709
30.986 0.0194229
44.9581 0.0204607
45.5559 0.0137772
102.123 0.0221638
107.255 0.0151009
END
$picture4 << END
24.4339 9.11423e-05
26.4488 9.11423e-05
35.7162 9.11423e-05
38.5477 9.11423e-05
53.1028 9.11423e-05
55.4724 9.11423e-05
24.3215 9.11423e-05
24.8609 9.11423e-05
24.6621 9.11423e-05
26.3877 9.11423e-05
36.5281 9.11423e-05
39.2833 9.11423e-05
24.8043 9.11423e-05
25.7968 9.11423e-05
28.4802 9.11423e-05
28.3397 9.11423e-05
42.3675 9.11423e-05
42.7093 9.11423e-05
96.5176 9.11423e-05
104.516 9.11423e-05
END
$picture5 << END
26.8708 0.0192032
27.618 0.0187046
38.6208 0.0258798
40.975 0.0178357
54.5288 0.0212768
58.3785 0.0134492
25.3709 0.0192032
26.3408 0.0187046
25.9173 0.0258798
27.4724 0.0178368
38.3285 0.0212768
40.8521 0.0134492
25.9664 0.0192039
26.9153 0.0187046
29.9785 0.0222503
29.2282 0.0194335
42.7212 0.0204423
44.8268 0.0137465
100.358 0.0221462
107.241 0.0150679
END
$picture_front << END
104.516 9.11423e-05
107.241 0.0150679
107.255 0.0151009
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
1 1036.04
2 329.681
4 259.371
8 210.997
16 155.935
32 61.982
64 41.6581
128 49.231
256 43.2703
END
$chosen0 << END
138.128 26.2474
END
$line1 << END
1 5260.03
2 1572.91
4 581.132
8 143.902
16 51.5034
32 27.428
64 29.6119
128 43.1073
256 40.7577
END
$chosen1 << END
93.6537 28.6922
END
$line2 << END
1 1544.11
2 151.226
4 41.276
8 16.9415
16 17.6991
32 13.2197
64 16.9728
128 32.6336
256 28.0017
END
$chosen2 << END
43.323 14.2117
END
$line3 << END
1 1887.21
2 376.065
4 177.449
8 69.6769
16 37.0275
32 29.4258
64 38.0577
128 58.6239
256 52.6012
END
$chosen3 << END
50.6645 33.6504
END
$line4 << END
1 1072.28
2 296.983
4 75.2654
8 25.4308
16 14.2961
32 14.3885
64 20.5881
128 37.7109
256 25.3217
END
$chosen4 << END
50.4685 15.9646
END
$line5 << END
1 117.405
2 31.993
4 11.2164
8 4.74491
16 3.10523
32 3.36587
64 3.73299
128 8.10238
256 7.44344
END
$chosen5 << END
30 2.55074
END
$line6 << END
1 2009.15
2 606.761
4 529.956
8 447.456
16 331.765
32 184.979
64 107.471
128 78.8293
256 65.925
END
$chosen6 << END
278.218 36.1273
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
set xrange [0.909091:306.04]; set yrange [1.96211:6838.04]
set xlabel 'voxels an axis'; set ylabel 'ms a picture'
set xtics (1, 2, 4, 8, 16, 32, 64, 128, 256, 512, 1024)
set ytics ('10' 10, '100' 100, '1000' 1000)
set arrow from first 16, graph 0 to first 16, graph 1 nohead lw 1.5 dt '-' lc rgb '#444444'
set label '16: what the founding study found enough' at first 16, graph 0.97 offset 1,0 left
set arrow from first 256,43.2703 to graph 1.0,0.4486 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.4486 to graph 1.015,0.4486 nohead lw 0.8 lc rgb '#999999'
set label 'balls' at graph 1.02,0.4486 left
set arrow from first 256,40.7577 to graph 1.0,0.4036 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.4036 to graph 1.015,0.4036 nohead lw 0.8 lc rgb '#999999'
set label 'gears' at graph 1.02,0.4036 left
set arrow from first 256,28.0017 to graph 1.0,0.3586 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.3586 to graph 1.015,0.3586 nohead lw 0.8 lc rgb '#999999'
set label 'mount' at graph 1.02,0.3586 left
set arrow from first 256,52.6012 to graph 1.0,0.4936 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.4936 to graph 1.015,0.4936 nohead lw 0.8 lc rgb '#999999'
set label 'rings' at graph 1.02,0.4936 left
set arrow from first 256,25.3217 to graph 1.0,0.3136 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.3136 to graph 1.015,0.3136 nohead lw 0.8 lc rgb '#999999'
set label 'teapot' at graph 1.02,0.3136 left
set arrow from first 256,7.44344 to graph 1.0,0.1635 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.1635 to graph 1.015,0.1635 nohead lw 0.8 lc rgb '#999999'
set label 'tetra' at graph 1.02,0.1635 left
set arrow from first 256,65.925 to graph 1.0,0.5386 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.5386 to graph 1.015,0.5386 nohead lw 0.8 lc rgb '#999999'
set label 'tree' at graph 1.02,0.5386 left
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
set xrange [0.909091:306.04]; set yrange [1.96211:6838.04]
set xlabel 'voxels an axis'; set ylabel 'ms a picture'
set xtics (1, 2, 4, 8, 16, 32, 64, 128, 256, 512, 1024)
set ytics ('10' 10, '100' 100, '1000' 1000)
set arrow from first 16, graph 0 to first 16, graph 1 nohead lw 1.5 dt '-' lc rgb '#444444'
set label '16: what the founding study found enough' at first 16, graph 0.97 offset 1,0 left
set arrow from first 256,43.2703 to graph 1.0,0.4486 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.4486 to graph 1.015,0.4486 nohead lw 0.8 lc rgb '#999999'
set label 'balls' at graph 1.02,0.4486 left
set arrow from first 256,40.7577 to graph 1.0,0.4036 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.4036 to graph 1.015,0.4036 nohead lw 0.8 lc rgb '#999999'
set label 'gears' at graph 1.02,0.4036 left
set arrow from first 256,28.0017 to graph 1.0,0.3586 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.3586 to graph 1.015,0.3586 nohead lw 0.8 lc rgb '#999999'
set label 'mount' at graph 1.02,0.3586 left
set arrow from first 256,52.6012 to graph 1.0,0.4936 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.4936 to graph 1.015,0.4936 nohead lw 0.8 lc rgb '#999999'
set label 'rings' at graph 1.02,0.4936 left
set arrow from first 256,25.3217 to graph 1.0,0.3136 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.3136 to graph 1.015,0.3136 nohead lw 0.8 lc rgb '#999999'
set label 'teapot' at graph 1.02,0.3136 left
set arrow from first 256,7.44344 to graph 1.0,0.1635 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.1635 to graph 1.015,0.1635 nohead lw 0.8 lc rgb '#999999'
set label 'tetra' at graph 1.02,0.1635 left
set arrow from first 256,65.925 to graph 1.0,0.5386 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.5386 to graph 1.015,0.5386 nohead lw 0.8 lc rgb '#999999'
set label 'tree' at graph 1.02,0.5386 left
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
