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
set xrange [0.292198:7.95816]; set yrange [3.05176e-06:0.0716782]
set xlabel 'million nearest hits a second  (more is better)'; set ylabel 'wrong hits  (less is better)' offset -1.5
set label 'balls: speed against accuracy (CPU, 2 threads)' at screen 0.02, screen 0.9774 font ',20'
set label '256x256 primary and 65,536 random rays a scene; 65,536 in all compared with brute force in double; pictures of 128x128' at screen 0.02, screen 0.9516
set xtics ('0.5' 0.5, '1' 1, '2' 2, '5' 5)
set ytics ("none of\n65,536" 7.62939e-06, '0.01 %%' 1e-4, '0.1 %%' 1e-3, '1 %%' 1e-2)
set object rectangle from graph 0, graph 0 to graph 1, first 1.297e-05 fs solid noborder fc rgb '#eeeeee' behind
set arrow from first 6.6318,0.00132751 to graph 1.0,0.6037 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.6037 to graph 1.015,0.6037 nohead lw 0.8 lc rgb '#999999'
set label 'fast, study: irregular exact' at graph 1.02,0.6037 left
set arrow from first 6.35995,0.000106812 to graph 1.0,0.3533 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.3533 to graph 1.015,0.3533 nohead lw 0.8 lc rgb '#999999'
set label 'fast: irregular exact' at graph 1.02,0.3533 left
set arrow from first 5.64086,7.62939e-06 to graph 1.0,0.0910 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.0910 to graph 1.015,0.0910 nohead lw 0.8 lc rgb '#999999'
set label 'robust: irregular exact' at graph 1.02,0.0910 left
$hits0 << END
1.32837 0.000106812
1.59935 0.000106812
3.85621 0.000106812
3.54724 0.000106812
0.464305 0.000106812
0.485149 0.000106812
1.71803 0.000106812
1.69964 0.000106812
2.27448 0.000106812
2.63579 0.000106812
0.403099 0.000106812
0.467094 0.000106812
1.61149 0.000106812
0.95667 0.000106812
1.69934 0.000106812
1.66102 0.000106812
6.23075 0.000106812
6.35995 0.000106812
END
$hits1 << END
1.52388 0.0286713
1.50633 0.0184937
4.53437 0.0145111
4.44794 0.00234985
0.493287 0.0266724
1.599 0.0286713
1.71791 0.0184937
3.08721 0.0145111
2.38871 0.00234985
0.502631 0.0268555
0.435455 0.0266724
1.71471 0.0286713
0.991232 0.0185394
1.74411 0.0203094
1.0989 0.00489807
6.50871 0.0109406
6.6318 0.00132751
END
$hits2 << END
0.728263 7.62939e-06
0.737231 7.62939e-06
2.20568 7.62939e-06
3.25487 7.62939e-06
1.1218 7.62939e-06
1.13352 7.62939e-06
2.44605 7.62939e-06
2.15741 7.62939e-06
1.11193 7.62939e-06
0.56143 7.62939e-06
1.20171 7.62939e-06
1.4028 7.62939e-06
5.0581 7.62939e-06
5.64086 7.62939e-06
0.93752 7.62939e-06
1.2519 7.62939e-06
END
$hits3 << END
0.893131 0.028595
0.676824 0.0184021
2.23594 0.0144196
2.81631 0.00224304
1.23436 0.028595
1.24129 0.0184021
2.77789 0.0144196
2.16983 0.00224304
1.33016 0.028595
0.637135 0.0184479
1.52133 0.0202179
1.45468 0.00479126
5.79548 0.010849
5.51482 0.0012207
END
$hits4 << END
1.11994 5.6514e-06
0.739161 5.6514e-06
3.59897 5.6514e-06
2.67398 5.6514e-06
1.49557 5.6514e-06
1.20782 5.6514e-06
2.27181 5.6514e-06
1.72646 5.6514e-06
0.350638 5.6514e-06
1.54796 5.6514e-06
0.819713 5.6514e-06
2.04712 5.6514e-06
1.61704 5.6514e-06
5.06293 5.6514e-06
5.11598 5.6514e-06
END
$hits5 << END
1.21922 0.028595
1.57941 0.0184021
4.02433 0.0144196
3.45219 0.00224304
0.371144 0.0267792
1.65316 0.028595
1.55208 0.0184021
3.16155 0.0144196
2.49298 0.00224304
0.368148 0.0267792
0.372512 0.0265961
1.76974 0.028595
0.877557 0.0184479
1.55832 0.0202179
1.68968 0.00479126
6.06869 0.010849
5.59797 0.0012207
END
$hits_front << END
5.64086 7.62939e-06
6.35995 0.000106812
6.6318 0.00132751
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
set xrange [2.45492:49.0358]; set yrange [0.000113255:0.116058]
set xlabel 'pictures a second  (more is better)'; set ylabel 'picture: RMSE of a channel  (less is better)' offset -1.5
set xtics ('3' 3, '5' 5, '7' 7, '10' 10, '15' 15, '20' 20, '30' 30)
set ytics ("same\nbits" 0.000283139, '10⁻³' 1e-3, '10⁻²' 1e-2, '10⁻¹' 1e-1)
set object rectangle from graph 0, graph 0 to graph 1, first 0.000481336 fs solid noborder fc rgb '#eeeeee' behind
set arrow from first 40.8632,0.0285362 to graph 1.0,0.7976 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.7976 to graph 1.015,0.7976 nohead lw 0.8 lc rgb '#999999'
set label 'fast, study: irregular box' at graph 1.02,0.7976 left
set arrow from first 39.3369,0.0122769 to graph 1.0,0.6760 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.6760 to graph 1.015,0.6760 nohead lw 0.8 lc rgb '#999999'
set label 'fast, study: irregular exact' at graph 1.02,0.6760 left
set arrow from first 38.4851,0.00860212 to graph 1.0,0.6246 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.6246 to graph 1.015,0.6246 nohead lw 0.8 lc rgb '#999999'
set label 'fast: irregular box' at graph 1.02,0.6246 left
set arrow from first 33.0383,0.00226511 to graph 1.0,0.4321 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.4321 to graph 1.015,0.4321 nohead lw 0.8 lc rgb '#999999'
set label 'robust: irregular exact' at graph 1.02,0.4321 left
set arrow from first 32.7449,0.000209732 to graph 1.0,0.0889 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.0889 to graph 1.015,0.0889 nohead lw 0.8 lc rgb '#999999'
set label 'double: irregular box' at graph 1.02,0.0889 left
$picture0 << END
10.4763 0.00860212
9.94758 0.00860212
33.9037 0.00860212
33.5459 0.00860212
3.37917 0.00860212
4.69753 0.00860212
12.4059 0.00860212
13.6465 0.00860212
24.8435 0.00860212
23.4388 0.00860212
3.9508 0.00860212
4.08047 0.00860212
12.9331 0.00860212
7.50835 0.00860212
15.936 0.00860212
13.4227 0.00860212
38.4851 0.00860212
38.4638 0.00860212
END
$picture1 << END
11.7244 0.0464233
11.9045 0.0367359
26.3318 0.0316881
34.6508 0.0151005
4.79522 0.0451434
14.4914 0.0464233
15.29 0.0367359
26.4487 0.0316881
26.4942 0.0151005
5.38312 0.0453063
5.48543 0.0451434
16.2156 0.0464233
8.05743 0.0367775
13.6415 0.0378178
17.3253 0.0202819
40.8632 0.0285362
39.3369 0.0122769
END
$picture2 << END
5.95639 0.00226511
5.55071 0.00226511
26.9953 0.00226511
27.773 0.00226511
9.46136 0.00226511
9.49947 0.00226511
22.2718 0.00226511
21.1053 0.00226511
8.85559 0.00226511
4.99643 0.00226511
13.2271 0.00226511
13.5759 0.00226511
32.9885 0.00226511
33.0383 0.00226511
7.26417 0.00226511
9.7502 0.00226511
END
$picture3 << END
5.04826 0.0460011
5.11467 0.0361254
27.8211 0.0307574
16.003 0.0126376
9.7661 0.0460011
8.63774 0.0361254
21.8538 0.0307574
21.9397 0.0126376
9.62464 0.0460011
5.00686 0.0361681
13.559 0.0370824
13.5726 0.0185072
33.8006 0.0274317
31.3928 0.00885209
END
$picture4 << END
9.60356 0.000209732
9.91051 0.000209732
28.8967 0.000209732
29.1869 0.000209732
13.412 0.000209732
11.9426 0.000209732
23.5613 0.000209732
21.2314 0.000209732
4.62894 0.000209732
13.4741 0.000209732
6.23037 0.000209732
17.7969 0.000209732
15.5074 0.000209732
32.7449 0.000209732
31.2488 0.000209732
END
$picture5 << END
8.37409 0.0459663
9.93493 0.036073
15.3991 0.0306826
29.432 0.0124275
3.62476 0.0448002
12.274 0.0459663
12.1428 0.036073
21.9854 0.0306826
24.896 0.0124275
3.58142 0.0448002
2.9459 0.044637
12.8106 0.0459663
6.08195 0.0361159
14.4092 0.0370265
15.1691 0.0183749
34.0335 0.0273421
31.4066 0.0085583
END
$picture_front << END
32.7449 0.000209732
33.0383 0.00226511
38.4851 0.00860212
39.3369 0.0122769
40.8632 0.0285362
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
set xrange [0.292198:7.95816]; set yrange [3.05176e-06:0.0716782]
set xlabel 'million nearest hits a second  (more is better)'; set ylabel 'wrong hits  (less is better)' offset -1.5
set label 'balls: speed against accuracy (CPU, 2 threads)' at screen 0.02, screen 0.9774 font ',20'
set label '256x256 primary and 65,536 random rays a scene; 65,536 in all compared with brute force in double; pictures of 128x128' at screen 0.02, screen 0.9516
set xtics ('0.5' 0.5, '1' 1, '2' 2, '5' 5)
set ytics ("none of\n65,536" 7.62939e-06, '0.01 %%' 1e-4, '0.1 %%' 1e-3, '1 %%' 1e-2)
set object rectangle from graph 0, graph 0 to graph 1, first 1.297e-05 fs solid noborder fc rgb '#eeeeee' behind
set arrow from first 6.6318,0.00132751 to graph 1.0,0.6037 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.6037 to graph 1.015,0.6037 nohead lw 0.8 lc rgb '#999999'
set label 'fast, study: irregular exact' at graph 1.02,0.6037 left
set arrow from first 6.35995,0.000106812 to graph 1.0,0.3533 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.3533 to graph 1.015,0.3533 nohead lw 0.8 lc rgb '#999999'
set label 'fast: irregular exact' at graph 1.02,0.3533 left
set arrow from first 5.64086,7.62939e-06 to graph 1.0,0.0910 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.0910 to graph 1.015,0.0910 nohead lw 0.8 lc rgb '#999999'
set label 'robust: irregular exact' at graph 1.02,0.0910 left
$hits0 << END
1.32837 0.000106812
1.59935 0.000106812
3.85621 0.000106812
3.54724 0.000106812
0.464305 0.000106812
0.485149 0.000106812
1.71803 0.000106812
1.69964 0.000106812
2.27448 0.000106812
2.63579 0.000106812
0.403099 0.000106812
0.467094 0.000106812
1.61149 0.000106812
0.95667 0.000106812
1.69934 0.000106812
1.66102 0.000106812
6.23075 0.000106812
6.35995 0.000106812
END
$hits1 << END
1.52388 0.0286713
1.50633 0.0184937
4.53437 0.0145111
4.44794 0.00234985
0.493287 0.0266724
1.599 0.0286713
1.71791 0.0184937
3.08721 0.0145111
2.38871 0.00234985
0.502631 0.0268555
0.435455 0.0266724
1.71471 0.0286713
0.991232 0.0185394
1.74411 0.0203094
1.0989 0.00489807
6.50871 0.0109406
6.6318 0.00132751
END
$hits2 << END
0.728263 7.62939e-06
0.737231 7.62939e-06
2.20568 7.62939e-06
3.25487 7.62939e-06
1.1218 7.62939e-06
1.13352 7.62939e-06
2.44605 7.62939e-06
2.15741 7.62939e-06
1.11193 7.62939e-06
0.56143 7.62939e-06
1.20171 7.62939e-06
1.4028 7.62939e-06
5.0581 7.62939e-06
5.64086 7.62939e-06
0.93752 7.62939e-06
1.2519 7.62939e-06
END
$hits3 << END
0.893131 0.028595
0.676824 0.0184021
2.23594 0.0144196
2.81631 0.00224304
1.23436 0.028595
1.24129 0.0184021
2.77789 0.0144196
2.16983 0.00224304
1.33016 0.028595
0.637135 0.0184479
1.52133 0.0202179
1.45468 0.00479126
5.79548 0.010849
5.51482 0.0012207
END
$hits4 << END
1.11994 5.6514e-06
0.739161 5.6514e-06
3.59897 5.6514e-06
2.67398 5.6514e-06
1.49557 5.6514e-06
1.20782 5.6514e-06
2.27181 5.6514e-06
1.72646 5.6514e-06
0.350638 5.6514e-06
1.54796 5.6514e-06
0.819713 5.6514e-06
2.04712 5.6514e-06
1.61704 5.6514e-06
5.06293 5.6514e-06
5.11598 5.6514e-06
END
$hits5 << END
1.21922 0.028595
1.57941 0.0184021
4.02433 0.0144196
3.45219 0.00224304
0.371144 0.0267792
1.65316 0.028595
1.55208 0.0184021
3.16155 0.0144196
2.49298 0.00224304
0.368148 0.0267792
0.372512 0.0265961
1.76974 0.028595
0.877557 0.0184479
1.55832 0.0202179
1.68968 0.00479126
6.06869 0.010849
5.59797 0.0012207
END
$hits_front << END
5.64086 7.62939e-06
6.35995 0.000106812
6.6318 0.00132751
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
set xrange [2.45492:49.0358]; set yrange [0.000113255:0.116058]
set xlabel 'pictures a second  (more is better)'; set ylabel 'picture: RMSE of a channel  (less is better)' offset -1.5
set xtics ('3' 3, '5' 5, '7' 7, '10' 10, '15' 15, '20' 20, '30' 30)
set ytics ("same\nbits" 0.000283139, '10⁻³' 1e-3, '10⁻²' 1e-2, '10⁻¹' 1e-1)
set object rectangle from graph 0, graph 0 to graph 1, first 0.000481336 fs solid noborder fc rgb '#eeeeee' behind
set arrow from first 40.8632,0.0285362 to graph 1.0,0.7976 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.7976 to graph 1.015,0.7976 nohead lw 0.8 lc rgb '#999999'
set label 'fast, study: irregular box' at graph 1.02,0.7976 left
set arrow from first 39.3369,0.0122769 to graph 1.0,0.6760 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.6760 to graph 1.015,0.6760 nohead lw 0.8 lc rgb '#999999'
set label 'fast, study: irregular exact' at graph 1.02,0.6760 left
set arrow from first 38.4851,0.00860212 to graph 1.0,0.6246 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.6246 to graph 1.015,0.6246 nohead lw 0.8 lc rgb '#999999'
set label 'fast: irregular box' at graph 1.02,0.6246 left
set arrow from first 33.0383,0.00226511 to graph 1.0,0.4321 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.4321 to graph 1.015,0.4321 nohead lw 0.8 lc rgb '#999999'
set label 'robust: irregular exact' at graph 1.02,0.4321 left
set arrow from first 32.7449,0.000209732 to graph 1.0,0.0889 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.0889 to graph 1.015,0.0889 nohead lw 0.8 lc rgb '#999999'
set label 'double: irregular box' at graph 1.02,0.0889 left
$picture0 << END
10.4763 0.00860212
9.94758 0.00860212
33.9037 0.00860212
33.5459 0.00860212
3.37917 0.00860212
4.69753 0.00860212
12.4059 0.00860212
13.6465 0.00860212
24.8435 0.00860212
23.4388 0.00860212
3.9508 0.00860212
4.08047 0.00860212
12.9331 0.00860212
7.50835 0.00860212
15.936 0.00860212
13.4227 0.00860212
38.4851 0.00860212
38.4638 0.00860212
END
$picture1 << END
11.7244 0.0464233
11.9045 0.0367359
26.3318 0.0316881
34.6508 0.0151005
4.79522 0.0451434
14.4914 0.0464233
15.29 0.0367359
26.4487 0.0316881
26.4942 0.0151005
5.38312 0.0453063
5.48543 0.0451434
16.2156 0.0464233
8.05743 0.0367775
13.6415 0.0378178
17.3253 0.0202819
40.8632 0.0285362
39.3369 0.0122769
END
$picture2 << END
5.95639 0.00226511
5.55071 0.00226511
26.9953 0.00226511
27.773 0.00226511
9.46136 0.00226511
9.49947 0.00226511
22.2718 0.00226511
21.1053 0.00226511
8.85559 0.00226511
4.99643 0.00226511
13.2271 0.00226511
13.5759 0.00226511
32.9885 0.00226511
33.0383 0.00226511
7.26417 0.00226511
9.7502 0.00226511
END
$picture3 << END
5.04826 0.0460011
5.11467 0.0361254
27.8211 0.0307574
16.003 0.0126376
9.7661 0.0460011
8.63774 0.0361254
21.8538 0.0307574
21.9397 0.0126376
9.62464 0.0460011
5.00686 0.0361681
13.559 0.0370824
13.5726 0.0185072
33.8006 0.0274317
31.3928 0.00885209
END
$picture4 << END
9.60356 0.000209732
9.91051 0.000209732
28.8967 0.000209732
29.1869 0.000209732
13.412 0.000209732
11.9426 0.000209732
23.5613 0.000209732
21.2314 0.000209732
4.62894 0.000209732
13.4741 0.000209732
6.23037 0.000209732
17.7969 0.000209732
15.5074 0.000209732
32.7449 0.000209732
31.2488 0.000209732
END
$picture5 << END
8.37409 0.0459663
9.93493 0.036073
15.3991 0.0306826
29.432 0.0124275
3.62476 0.0448002
12.274 0.0459663
12.1428 0.036073
21.9854 0.0306826
24.896 0.0124275
3.58142 0.0448002
2.9459 0.044637
12.8106 0.0459663
6.08195 0.0361159
14.4092 0.0370265
15.1691 0.0183749
34.0335 0.0273421
31.4066 0.0085583
END
$picture_front << END
32.7449 0.000209732
33.0383 0.00226511
38.4851 0.00860212
39.3369 0.0122769
40.8632 0.0285362
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
set xrange [0.62058:12.3286]; set yrange [3.05176e-06:0.00156403]
set xlabel 'million nearest hits a second  (more is better)'; set ylabel 'wrong hits  (less is better)' offset -1.5
set label 'gears: speed against accuracy (CPU, 2 threads)' at screen 0.02, screen 0.9774 font ',20'
set label '256x256 primary and 65,536 random rays a scene; 65,536 in all compared with brute force in double; pictures of 128x128' at screen 0.02, screen 0.9516
set xtics ('0.7' 0.7, '1' 1, '1.5' 1.5, '2' 2, '3' 3, '5' 5, '7' 7, '10' 10)
set ytics ("none of\n65,536" 7.62939e-06, '0.01 %%' 1e-4, '0.1 %%' 1e-3)
set object rectangle from graph 0, graph 0 to graph 1, first 1.297e-05 fs solid noborder fc rgb '#eeeeee' behind
set arrow from first 10.2738,1.02997e-05 to graph 1.0,0.1950 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.1950 to graph 1.015,0.1950 nohead lw 0.8 lc rgb '#999999'
set label 'fast, study: irregular exact' at graph 1.02,0.1950 left
$hits0 << END
1.47345 1.02997e-05
2.26558 1.02997e-05
4.00514 1.02997e-05
3.71367 1.02997e-05
4.18905 1.02997e-05
4.46229 1.02997e-05
2.50413 1.02997e-05
1.57925 1.02997e-05
1.3185 1.02997e-05
1.28974 1.02997e-05
1.56335 1.02997e-05
1.41216 1.02997e-05
2.62025 1.02997e-05
2.41645 1.02997e-05
2.6435 1.02997e-05
3.66242 1.02997e-05
3.49831 1.02997e-05
2.73994 1.02997e-05
9.44179 1.02997e-05
5.136 1.02997e-05
END
$hits1 << END
1.29487 0.000152588
1.23727 0.000152588
3.5149 7.62939e-05
3.85192 3.05176e-05
2.66565 0.00050354
4.32825 0.000152588
1.25112 0.000152588
1.30917 0.000152588
1.25967 7.62939e-05
1.21586 3.05176e-05
1.50686 0.00050354
1.67171 0.000152588
0.904248 0.000152588
0.804529 0.000152588
2.71401 0.000289917
2.7149 3.05176e-05
3.19403 0.00062561
2.19629 0.000366211
7.9375 0.000198364
10.2738 1.02997e-05
END
$hits2 << END
3.33722 7.62939e-06
3.14953 7.62939e-06
3.12587 7.62939e-06
3.50555 7.62939e-06
3.29945 7.62939e-06
4.69076 7.62939e-06
2.96563 7.62939e-06
2.59734 7.62939e-06
1.36858 7.62939e-06
1.49302 7.62939e-06
1.66163 7.62939e-06
1.90155 7.62939e-06
2.76114 7.62939e-06
2.66254 7.62939e-06
2.83899 7.62939e-06
3.96737 7.62939e-06
4.04452 7.62939e-06
1.96677 7.62939e-06
5.54262 7.62939e-06
9.26973 7.62939e-06
0.846016 7.62939e-06
3.00709 7.62939e-06
1.76918 7.62939e-06
4.10292 7.62939e-06
END
$hits3 << END
1.36321 0.000152588
1.32589 0.000152588
3.4243 7.62939e-05
3.7024 3.05176e-05
4.34981 0.00050354
4.5396 0.000152588
1.10595 0.000152588
0.744696 0.000152588
1.24888 7.62939e-05
1.30717 3.05176e-05
1.49156 0.00050354
3.2904 0.000152588
1.18608 0.000152588
1.16533 0.000152588
3.57276 0.000289917
1.80558 3.05176e-05
2.88937 0.00062561
2.18787 0.000366211
8.19529 0.000198364
4.32171 7.62939e-06
END
$hits4 << END
1.92405 5.6514e-06
2.03186 5.6514e-06
4.19763 5.6514e-06
3.8704 5.6514e-06
3.88724 5.6514e-06
4.94596 5.6514e-06
1.52404 5.6514e-06
1.29502 5.6514e-06
1.2319 5.6514e-06
1.36788 5.6514e-06
1.11556 5.6514e-06
1.62879 5.6514e-06
1.64676 5.6514e-06
1.49357 5.6514e-06
3.7826 5.6514e-06
3.74522 5.6514e-06
3.30162 5.6514e-06
3.00907 5.6514e-06
6.93376 5.6514e-06
6.83725 5.6514e-06
END
$hits5 << END
1.63279 0.000152588
1.69149 0.000152588
3.90791 7.62939e-05
3.16677 3.05176e-05
2.85375 0.00050354
4.87655 0.000152588
1.37143 0.000152588
0.798257 0.000152588
1.18524 7.62939e-05
1.33903 3.05176e-05
1.5128 0.00050354
3.02321 0.000152588
1.11073 0.000152588
1.40553 0.000152588
3.61856 0.000289917
2.42452 3.05176e-05
3.08991 0.00062561
2.48418 0.000366211
6.16933 0.000198364
5.00665 5.6514e-06
END
$hits_front << END
10.2738 1.02997e-05
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
set xrange [2.52338:60.4446]; set yrange [2.20756e-08:0.0161019]
set xlabel 'pictures a second  (more is better)'; set ylabel 'picture: RMSE of a channel  (less is better)' offset -1.5
set xtics ('5' 5, '10' 10, '20' 20, '50' 50)
set ytics ("same\nbits" 5.5189e-08, '10⁻⁶' 1e-6, '10⁻⁵' 1e-5, '10⁻⁴' 1e-4, '10⁻³' 1e-3, '10⁻²' 1e-2)
set object rectangle from graph 0, graph 0 to graph 1, first 9.38213e-08 fs solid noborder fc rgb '#eeeeee' behind
set arrow from first 50.3705,0.00319435 to graph 1.0,0.8802 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.8802 to graph 1.015,0.8802 nohead lw 0.8 lc rgb '#999999'
set label 'fast: irregular box' at graph 1.02,0.8802 left
set arrow from first 46.9356,4.41512e-07 to graph 1.0,0.2219 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.2219 to graph 1.015,0.2219 nohead lw 0.8 lc rgb '#999999'
set label 'robust: irregular box' at graph 1.02,0.2219 left
set arrow from first 35.3754,4.08807e-08 to graph 1.0,0.0456 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.0456 to graph 1.015,0.0456 nohead lw 0.8 lc rgb '#999999'
set label 'double: irregular box' at graph 1.02,0.0456 left
$picture0 << END
10.8223 0.00319435
11.92 0.00319435
25.4097 0.00319435
27.0447 0.00319435
27.1734 0.00319435
33.3269 0.00319435
11.7165 0.00319435
12.7445 0.00319435
8.46776 0.00319435
8.68025 0.00319435
9.96641 0.00319435
9.92556 0.00319435
12.5434 0.00319435
8.30482 0.00319435
25.5352 0.00319435
20.1462 0.00319435
20.8865 0.00319435
18.2091 0.00319435
50.3705 0.00319435
48.3683 0.00319435
END
$picture1 << END
9.04871 0.00383996
8.99345 0.00383912
22.3023 0.00319435
25.0823 0.0042878
28.4323 0.00642127
28.4758 0.00454316
8.27397 0.00383996
8.03503 0.00383912
8.78789 0.00319435
8.9736 0.0042878
10.0254 0.00642127
19.6135 0.00454316
6.74951 0.00383996
8.47529 0.00383912
23.5234 0.00365496
20.7453 0.0042878
18.947 0.00644074
16.8431 0.00561794
25.4631 0.00326796
24.2621 0.00340251
END
$picture2 << END
9.9456 4.41512e-07
10.1622 4.41512e-07
23.4788 4.41512e-07
27.2985 4.41512e-07
29.4436 4.41512e-07
30.5726 4.41512e-07
9.53334 4.41512e-07
10.1889 4.41512e-07
8.54657 4.41512e-07
9.21396 4.41512e-07
9.8495 4.41512e-07
13.5749 4.41512e-07
10.478 4.41512e-07
8.72844 4.41512e-07
22.936 4.41512e-07
19.0674 4.41512e-07
20.1761 4.41512e-07
11.4309 4.41512e-07
46.9356 4.41512e-07
40.2855 4.41512e-07
3.10972 4.41512e-07
20.738 4.41512e-07
19.8927 4.41512e-07
13.545 4.41512e-07
END
$picture3 << END
5.00894 0.00213107
5.15993 0.00212955
17.7787 4.41512e-07
19.5866 0.00286034
23.5638 0.00557035
26.3719 0.00323054
4.84489 0.00213107
5.11067 0.00212955
7.23045 4.41512e-07
7.87842 0.00286034
9.29264 0.00557035
19.0608 0.00323054
5.24962 0.00213107
4.76084 0.00212955
17.0061 0.00177614
11.7986 0.00286034
16.473 0.00559278
9.61797 0.00462139
19.2474 0.000689732
33.122 0.00117184
END
$picture4 << END
6.19053 4.08807e-08
5.5281 4.08807e-08
19.311 4.08807e-08
21.0278 4.08807e-08
21.9076 4.08807e-08
26.3354 4.08807e-08
5.95359 4.08807e-08
3.02805 4.08807e-08
6.91047 4.08807e-08
7.4448 4.08807e-08
7.51874 4.08807e-08
14.2763 4.08807e-08
6.29418 4.08807e-08
5.34839 4.08807e-08
16.6513 4.08807e-08
13.3155 4.08807e-08
16.0632 4.08807e-08
15.1691 4.08807e-08
35.3754 4.08807e-08
17.992 4.08807e-08
END
$picture5 << END
5.38407 0.00213107
6.41219 0.00212955
18.6385 4.08807e-08
21.3329 0.00286034
24.2501 0.00557035
26.0176 0.00323054
6.03355 0.00213107
3.06178 0.00212955
7.75272 4.08807e-08
7.85207 0.00286034
8.56582 0.00557035
18.007 0.00323054
6.28389 0.00213107
5.95869 0.00212955
18.7894 0.00177613
17.0107 0.00286034
15.9821 0.00559278
15.2057 0.00462139
29.8227 0.000689733
22.9353 0.00117184
END
$picture_front << END
35.3754 4.08807e-08
46.9356 4.41512e-07
50.3705 0.00319435
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
set xrange [0.62058:12.3286]; set yrange [3.05176e-06:0.00156403]
set xlabel 'million nearest hits a second  (more is better)'; set ylabel 'wrong hits  (less is better)' offset -1.5
set label 'gears: speed against accuracy (CPU, 2 threads)' at screen 0.02, screen 0.9774 font ',20'
set label '256x256 primary and 65,536 random rays a scene; 65,536 in all compared with brute force in double; pictures of 128x128' at screen 0.02, screen 0.9516
set xtics ('0.7' 0.7, '1' 1, '1.5' 1.5, '2' 2, '3' 3, '5' 5, '7' 7, '10' 10)
set ytics ("none of\n65,536" 7.62939e-06, '0.01 %%' 1e-4, '0.1 %%' 1e-3)
set object rectangle from graph 0, graph 0 to graph 1, first 1.297e-05 fs solid noborder fc rgb '#eeeeee' behind
set arrow from first 10.2738,1.02997e-05 to graph 1.0,0.1950 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.1950 to graph 1.015,0.1950 nohead lw 0.8 lc rgb '#999999'
set label 'fast, study: irregular exact' at graph 1.02,0.1950 left
$hits0 << END
1.47345 1.02997e-05
2.26558 1.02997e-05
4.00514 1.02997e-05
3.71367 1.02997e-05
4.18905 1.02997e-05
4.46229 1.02997e-05
2.50413 1.02997e-05
1.57925 1.02997e-05
1.3185 1.02997e-05
1.28974 1.02997e-05
1.56335 1.02997e-05
1.41216 1.02997e-05
2.62025 1.02997e-05
2.41645 1.02997e-05
2.6435 1.02997e-05
3.66242 1.02997e-05
3.49831 1.02997e-05
2.73994 1.02997e-05
9.44179 1.02997e-05
5.136 1.02997e-05
END
$hits1 << END
1.29487 0.000152588
1.23727 0.000152588
3.5149 7.62939e-05
3.85192 3.05176e-05
2.66565 0.00050354
4.32825 0.000152588
1.25112 0.000152588
1.30917 0.000152588
1.25967 7.62939e-05
1.21586 3.05176e-05
1.50686 0.00050354
1.67171 0.000152588
0.904248 0.000152588
0.804529 0.000152588
2.71401 0.000289917
2.7149 3.05176e-05
3.19403 0.00062561
2.19629 0.000366211
7.9375 0.000198364
10.2738 1.02997e-05
END
$hits2 << END
3.33722 7.62939e-06
3.14953 7.62939e-06
3.12587 7.62939e-06
3.50555 7.62939e-06
3.29945 7.62939e-06
4.69076 7.62939e-06
2.96563 7.62939e-06
2.59734 7.62939e-06
1.36858 7.62939e-06
1.49302 7.62939e-06
1.66163 7.62939e-06
1.90155 7.62939e-06
2.76114 7.62939e-06
2.66254 7.62939e-06
2.83899 7.62939e-06
3.96737 7.62939e-06
4.04452 7.62939e-06
1.96677 7.62939e-06
5.54262 7.62939e-06
9.26973 7.62939e-06
0.846016 7.62939e-06
3.00709 7.62939e-06
1.76918 7.62939e-06
4.10292 7.62939e-06
END
$hits3 << END
1.36321 0.000152588
1.32589 0.000152588
3.4243 7.62939e-05
3.7024 3.05176e-05
4.34981 0.00050354
4.5396 0.000152588
1.10595 0.000152588
0.744696 0.000152588
1.24888 7.62939e-05
1.30717 3.05176e-05
1.49156 0.00050354
3.2904 0.000152588
1.18608 0.000152588
1.16533 0.000152588
3.57276 0.000289917
1.80558 3.05176e-05
2.88937 0.00062561
2.18787 0.000366211
8.19529 0.000198364
4.32171 7.62939e-06
END
$hits4 << END
1.92405 5.6514e-06
2.03186 5.6514e-06
4.19763 5.6514e-06
3.8704 5.6514e-06
3.88724 5.6514e-06
4.94596 5.6514e-06
1.52404 5.6514e-06
1.29502 5.6514e-06
1.2319 5.6514e-06
1.36788 5.6514e-06
1.11556 5.6514e-06
1.62879 5.6514e-06
1.64676 5.6514e-06
1.49357 5.6514e-06
3.7826 5.6514e-06
3.74522 5.6514e-06
3.30162 5.6514e-06
3.00907 5.6514e-06
6.93376 5.6514e-06
6.83725 5.6514e-06
END
$hits5 << END
1.63279 0.000152588
1.69149 0.000152588
3.90791 7.62939e-05
3.16677 3.05176e-05
2.85375 0.00050354
4.87655 0.000152588
1.37143 0.000152588
0.798257 0.000152588
1.18524 7.62939e-05
1.33903 3.05176e-05
1.5128 0.00050354
3.02321 0.000152588
1.11073 0.000152588
1.40553 0.000152588
3.61856 0.000289917
2.42452 3.05176e-05
3.08991 0.00062561
2.48418 0.000366211
6.16933 0.000198364
5.00665 5.6514e-06
END
$hits_front << END
10.2738 1.02997e-05
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
set xrange [2.52338:60.4446]; set yrange [2.20756e-08:0.0161019]
set xlabel 'pictures a second  (more is better)'; set ylabel 'picture: RMSE of a channel  (less is better)' offset -1.5
set xtics ('5' 5, '10' 10, '20' 20, '50' 50)
set ytics ("same\nbits" 5.5189e-08, '10⁻⁶' 1e-6, '10⁻⁵' 1e-5, '10⁻⁴' 1e-4, '10⁻³' 1e-3, '10⁻²' 1e-2)
set object rectangle from graph 0, graph 0 to graph 1, first 9.38213e-08 fs solid noborder fc rgb '#eeeeee' behind
set arrow from first 50.3705,0.00319435 to graph 1.0,0.8802 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.8802 to graph 1.015,0.8802 nohead lw 0.8 lc rgb '#999999'
set label 'fast: irregular box' at graph 1.02,0.8802 left
set arrow from first 46.9356,4.41512e-07 to graph 1.0,0.2219 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.2219 to graph 1.015,0.2219 nohead lw 0.8 lc rgb '#999999'
set label 'robust: irregular box' at graph 1.02,0.2219 left
set arrow from first 35.3754,4.08807e-08 to graph 1.0,0.0456 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.0456 to graph 1.015,0.0456 nohead lw 0.8 lc rgb '#999999'
set label 'double: irregular box' at graph 1.02,0.0456 left
$picture0 << END
10.8223 0.00319435
11.92 0.00319435
25.4097 0.00319435
27.0447 0.00319435
27.1734 0.00319435
33.3269 0.00319435
11.7165 0.00319435
12.7445 0.00319435
8.46776 0.00319435
8.68025 0.00319435
9.96641 0.00319435
9.92556 0.00319435
12.5434 0.00319435
8.30482 0.00319435
25.5352 0.00319435
20.1462 0.00319435
20.8865 0.00319435
18.2091 0.00319435
50.3705 0.00319435
48.3683 0.00319435
END
$picture1 << END
9.04871 0.00383996
8.99345 0.00383912
22.3023 0.00319435
25.0823 0.0042878
28.4323 0.00642127
28.4758 0.00454316
8.27397 0.00383996
8.03503 0.00383912
8.78789 0.00319435
8.9736 0.0042878
10.0254 0.00642127
19.6135 0.00454316
6.74951 0.00383996
8.47529 0.00383912
23.5234 0.00365496
20.7453 0.0042878
18.947 0.00644074
16.8431 0.00561794
25.4631 0.00326796
24.2621 0.00340251
END
$picture2 << END
9.9456 4.41512e-07
10.1622 4.41512e-07
23.4788 4.41512e-07
27.2985 4.41512e-07
29.4436 4.41512e-07
30.5726 4.41512e-07
9.53334 4.41512e-07
10.1889 4.41512e-07
8.54657 4.41512e-07
9.21396 4.41512e-07
9.8495 4.41512e-07
13.5749 4.41512e-07
10.478 4.41512e-07
8.72844 4.41512e-07
22.936 4.41512e-07
19.0674 4.41512e-07
20.1761 4.41512e-07
11.4309 4.41512e-07
46.9356 4.41512e-07
40.2855 4.41512e-07
3.10972 4.41512e-07
20.738 4.41512e-07
19.8927 4.41512e-07
13.545 4.41512e-07
END
$picture3 << END
5.00894 0.00213107
5.15993 0.00212955
17.7787 4.41512e-07
19.5866 0.00286034
23.5638 0.00557035
26.3719 0.00323054
4.84489 0.00213107
5.11067 0.00212955
7.23045 4.41512e-07
7.87842 0.00286034
9.29264 0.00557035
19.0608 0.00323054
5.24962 0.00213107
4.76084 0.00212955
17.0061 0.00177614
11.7986 0.00286034
16.473 0.00559278
9.61797 0.00462139
19.2474 0.000689732
33.122 0.00117184
END
$picture4 << END
6.19053 4.08807e-08
5.5281 4.08807e-08
19.311 4.08807e-08
21.0278 4.08807e-08
21.9076 4.08807e-08
26.3354 4.08807e-08
5.95359 4.08807e-08
3.02805 4.08807e-08
6.91047 4.08807e-08
7.4448 4.08807e-08
7.51874 4.08807e-08
14.2763 4.08807e-08
6.29418 4.08807e-08
5.34839 4.08807e-08
16.6513 4.08807e-08
13.3155 4.08807e-08
16.0632 4.08807e-08
15.1691 4.08807e-08
35.3754 4.08807e-08
17.992 4.08807e-08
END
$picture5 << END
5.38407 0.00213107
6.41219 0.00212955
18.6385 4.08807e-08
21.3329 0.00286034
24.2501 0.00557035
26.0176 0.00323054
6.03355 0.00213107
3.06178 0.00212955
7.75272 4.08807e-08
7.85207 0.00286034
8.56582 0.00557035
18.007 0.00323054
6.28389 0.00213107
5.95869 0.00212955
18.7894 0.00177613
17.0107 0.00286034
15.9821 0.00559278
15.2057 0.00462139
29.8227 0.000689733
22.9353 0.00117184
END
$picture_front << END
35.3754 4.08807e-08
46.9356 4.41512e-07
50.3705 0.00319435
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
set xrange [0.343732:5.24054]; set yrange [3.05176e-06:0.001297]
set xlabel 'million nearest hits a second  (more is better)'; set ylabel 'wrong hits  (less is better)' offset -1.5
set label 'mount: speed against accuracy (CPU, 2 threads)' at screen 0.02, screen 0.9774 font ',20'
set label '256x256 primary and 65,536 random rays a scene; 65,536 in all compared with brute force in double; pictures of 128x128' at screen 0.02, screen 0.9516
set xtics ('0.5' 0.5, '0.7' 0.7, '1' 1, '1.5' 1.5, '2' 2, '3' 3, '5' 5)
set ytics ("none of\n65,536" 7.62939e-06, '0.01 %%' 1e-4, '0.1 %%' 1e-3)
set object rectangle from graph 0, graph 0 to graph 1, first 1.297e-05 fs solid noborder fc rgb '#eeeeee' behind
set arrow from first 4.36712,3.05176e-05 to graph 1.0,0.3805 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.3805 to graph 1.015,0.3805 nohead lw 0.8 lc rgb '#999999'
set label 'double, study: irregular exact' at graph 1.02,0.3805 left
set arrow from first 4.3061,1.02997e-05 to graph 1.0,0.2010 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.2010 to graph 1.015,0.2010 nohead lw 0.8 lc rgb '#999999'
set label 'fast: irregular exact' at graph 1.02,0.2010 left
$hits0 << END
2.32069 1.02997e-05
2.41443 1.02997e-05
1.82368 1.02997e-05
1.98069 1.02997e-05
1.99593 1.02997e-05
2.40995 1.02997e-05
2.12139 1.02997e-05
2.22347 1.02997e-05
1.21453 1.02997e-05
1.49128 1.02997e-05
3.41048 1.02997e-05
3.81765 1.02997e-05
3.92759 1.02997e-05
4.20256 1.02997e-05
1.36136 1.02997e-05
1.32923 1.02997e-05
1.1449 1.02997e-05
1.18331 1.02997e-05
3.52783 1.02997e-05
4.3061 1.02997e-05
END
$hits1 << END
1.74663 6.10352e-05
1.81906 4.57764e-05
1.88484 1.52588e-05
1.98769 1.02997e-05
2.24982 0.000213623
2.35024 7.62939e-05
1.61955 6.10352e-05
1.68616 4.57764e-05
1.25909 1.52588e-05
1.40517 1.02997e-05
2.74575 0.000213623
3.77528 7.62939e-05
2.9435 0.000183105
3.15667 0.000167847
0.823241 0.000198364
0.806562 0.000473022
0.921434 0.000350952
0.917305 0.000518799
3.70155 3.05176e-05
4.31607 3.05176e-05
END
$hits2 << END
1.50466 7.62939e-06
1.52428 7.62939e-06
1.43265 7.62939e-06
1.86976 7.62939e-06
1.99143 7.62939e-06
2.1306 7.62939e-06
1.41625 7.62939e-06
1.51651 7.62939e-06
1.19409 7.62939e-06
2.59077 7.62939e-06
3.09739 7.62939e-06
3.48262 7.62939e-06
2.58291 7.62939e-06
2.79221 7.62939e-06
0.793095 7.62939e-06
0.665019 7.62939e-06
0.78042 7.62939e-06
0.816295 7.62939e-06
3.37722 7.62939e-06
3.85168 7.62939e-06
0.601401 7.62939e-06
2.16706 7.62939e-06
0.574172 7.62939e-06
1.30506 7.62939e-06
END
$hits3 << END
1.70959 6.10352e-05
1.83411 4.57764e-05
1.83457 1.52588e-05
2.0002 7.62939e-06
2.21777 0.000213623
2.37964 7.62939e-05
1.60782 6.10352e-05
1.6992 4.57764e-05
1.33333 1.52588e-05
2.82843 7.62939e-06
3.54037 0.000213623
3.8372 7.62939e-05
2.8392 0.000183105
3.08469 0.000167847
0.817335 0.000198364
0.412478 0.000473022
0.910069 0.000350952
0.915254 0.000518799
4.00052 3.05176e-05
4.23739 3.05176e-05
END
$hits4 << END
1.73877 5.6514e-06
1.87635 5.6514e-06
1.70482 5.6514e-06
1.95977 5.6514e-06
2.00596 5.6514e-06
2.25927 5.6514e-06
1.51045 5.6514e-06
1.70872 5.6514e-06
1.14435 5.6514e-06
2.71148 5.6514e-06
3.15789 5.6514e-06
3.50889 5.6514e-06
2.89749 5.6514e-06
2.64345 5.6514e-06
0.891134 5.6514e-06
0.455073 5.6514e-06
0.869127 5.6514e-06
0.94976 5.6514e-06
3.12741 5.6514e-06
3.87543 5.6514e-06
END
$hits5 << END
1.95659 6.10352e-05
2.07708 4.57764e-05
1.8673 1.52588e-05
2.03227 5.6514e-06
2.19021 0.000213623
2.45583 7.62939e-05
1.84908 6.10352e-05
1.90289 4.57764e-05
1.32188 1.52588e-05
2.77902 5.6514e-06
3.64544 0.000213623
3.82588 7.62939e-05
3.25649 0.000183105
3.43877 0.000167847
0.909349 0.000198364
0.465632 0.000473022
0.910305 0.000350952
0.948616 0.000518799
4.08785 3.05176e-05
4.36712 3.05176e-05
END
$hits_front << END
4.3061 1.02997e-05
4.36712 3.05176e-05
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
set xrange [6.14027:68.0002]; set yrange [5.91675e-06:0.0144207]
set xlabel 'pictures a second  (more is better)'; set ylabel 'picture: RMSE of a channel  (less is better)' offset -1.5
set xtics ('7' 7, '10' 10, '15' 15, '20' 20, '30' 30, '50' 50)
set ytics ("same\nbits" 1.47919e-05, '10⁻⁴' 1e-4, '10⁻³' 1e-3, '10⁻²' 1e-2)
set object rectangle from graph 0, graph 0 to graph 1, first 2.51462e-05 fs solid noborder fc rgb '#eeeeee' behind
set arrow from first 56.6669,0.00551617 to graph 1.0,0.8768 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.8768 to graph 1.015,0.8768 nohead lw 0.8 lc rgb '#999999'
set label 'fast, study: x auto exact' at graph 1.02,0.8768 left
set arrow from first 53.4774,0.0019008 to graph 1.0,0.8176 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.8176 to graph 1.015,0.8176 nohead lw 0.8 lc rgb '#999999'
set label 'robust, study: x auto exact' at graph 1.02,0.8176 left
set arrow from first 53.2904,0.00189879 to graph 1.0,0.7676 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.7676 to graph 1.015,0.7676 nohead lw 0.8 lc rgb '#999999'
set label 'double, study: x auto exact' at graph 1.02,0.7676 left
set arrow from first 52.2747,0.00159428 to graph 1.0,0.7176 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.7176 to graph 1.015,0.7176 nohead lw 0.8 lc rgb '#999999'
set label 'double, study: balance 16 exact' at graph 1.02,0.7176 left
set arrow from first 46.9356,0.000750071 to graph 1.0,0.6209 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.6209 to graph 1.015,0.6209 nohead lw 0.8 lc rgb '#999999'
set label 'double, study: irregular exact' at graph 1.02,0.6209 left
set arrow from first 46.6949,1.09569e-05 to graph 1.0,0.0790 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.0790 to graph 1.015,0.0790 nohead lw 0.8 lc rgb '#999999'
set label 'double: balance 16 exact' at graph 1.02,0.0790 left
$picture0 << END
26.921 0.00517968
27.9474 0.00517968
24.4644 0.00517968
26.2417 0.00517968
27.3916 0.00517968
30.07 0.00517968
25.4281 0.00517968
26.5582 0.00517968
18.1681 0.00517968
21.0766 0.00517968
43.0773 0.00517968
48.1921 0.00517968
49.135 0.00517968
51.8124 0.00517968
23.2358 0.00517968
21.1982 0.00517968
19.2012 0.00517968
19.7928 0.00517968
41.6873 0.00517968
47.4635 0.00517968
END
$picture1 << END
28.438 0.0053141
25.3459 0.0053141
28.0251 0.00519284
30.4201 0.00517968
33.4216 0.00576829
34.7471 0.00551617
26.6942 0.0053141
27.4805 0.0053141
21.9476 0.00519284
21.2201 0.00517968
51.755 0.00576829
56.6669 0.00551617
50.7354 0.0053141
52.6067 0.0053141
19.11 0.00519243
18.2005 0.00520446
17.8413 0.00576829
18.8616 0.00553944
48.5512 0.00525173
50.1138 0.00523371
END
$picture2 << END
21.6671 0.000118335
23.0005 0.000118335
18.9289 0.000118335
24.8305 0.000118335
23.3085 0.000118335
27.6873 0.000118335
20.5237 0.000118335
21.9311 0.000118335
16.9034 0.000118335
37.6557 0.000118335
39.5873 0.000118335
45.7114 0.000118335
37.474 0.000118335
41.114 0.000118335
16.0075 0.000118335
7.36833 0.000118335
13.9971 0.000118335
15.1111 0.000118335
40.398 0.000118335
41.754 0.000118335
10.5873 0.000118335
24.7566 0.000118335
12.9327 0.000118335
14.6595 0.000118335
END
$picture3 << END
24.3113 0.00159667
25.5407 0.00159667
26.145 0.000387878
29.392 0.000118335
29.0328 0.00254127
32.2514 0.0019008
23.3386 0.00159667
24.3372 0.00159667
21.9962 0.000387878
45.3694 0.000118335
49.5471 0.00254127
53.4774 0.0019008
43.0545 0.00159667
45.9905 0.00159667
17.3258 0.000382429
8.09769 0.000520823
17.2755 0.00254127
16.2039 0.0019673
41.5557 0.000874952
45.3521 0.000759348
END
$picture4 << END
24.2233 1.09569e-05
25.9629 1.09569e-05
21.46 1.09569e-05
25.0054 1.09569e-05
24.8015 1.09569e-05
28.8994 1.09569e-05
23.3342 1.09569e-05
24.5105 1.09569e-05
16.5431 1.09569e-05
35.6028 1.09569e-05
41.0371 1.09569e-05
46.3671 1.09569e-05
43.4018 1.09569e-05
46.6949 1.09569e-05
17.8936 1.09569e-05
9.60181 1.09569e-05
14.9725 1.09569e-05
16.166 1.09569e-05
42.0398 1.09569e-05
43.0461 1.09569e-05
END
$picture5 << END
27.0049 0.00159428
28.667 0.00159428
27.1687 0.000369387
30.0504 1.09569e-05
30.3207 0.00253977
33.9549 0.00189879
26.1073 0.00159428
27.0574 0.00159428
22.0385 0.000369387
43.3911 1.09569e-05
50.158 0.00253977
53.2904 0.00189879
48.291 0.00159428
52.2747 0.00159428
19.323 0.00036366
9.54308 0.000509379
17.4571 0.00253977
18.1601 0.00196593
45.588 0.000866912
46.9356 0.000750071
END
$picture_front << END
46.6949 1.09569e-05
46.9356 0.000750071
52.2747 0.00159428
53.2904 0.00189879
53.4774 0.0019008
56.6669 0.00551617
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
set xrange [0.343732:5.24054]; set yrange [3.05176e-06:0.001297]
set xlabel 'million nearest hits a second  (more is better)'; set ylabel 'wrong hits  (less is better)' offset -1.5
set label 'mount: speed against accuracy (CPU, 2 threads)' at screen 0.02, screen 0.9774 font ',20'
set label '256x256 primary and 65,536 random rays a scene; 65,536 in all compared with brute force in double; pictures of 128x128' at screen 0.02, screen 0.9516
set xtics ('0.5' 0.5, '0.7' 0.7, '1' 1, '1.5' 1.5, '2' 2, '3' 3, '5' 5)
set ytics ("none of\n65,536" 7.62939e-06, '0.01 %%' 1e-4, '0.1 %%' 1e-3)
set object rectangle from graph 0, graph 0 to graph 1, first 1.297e-05 fs solid noborder fc rgb '#eeeeee' behind
set arrow from first 4.36712,3.05176e-05 to graph 1.0,0.3805 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.3805 to graph 1.015,0.3805 nohead lw 0.8 lc rgb '#999999'
set label 'double, study: irregular exact' at graph 1.02,0.3805 left
set arrow from first 4.3061,1.02997e-05 to graph 1.0,0.2010 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.2010 to graph 1.015,0.2010 nohead lw 0.8 lc rgb '#999999'
set label 'fast: irregular exact' at graph 1.02,0.2010 left
$hits0 << END
2.32069 1.02997e-05
2.41443 1.02997e-05
1.82368 1.02997e-05
1.98069 1.02997e-05
1.99593 1.02997e-05
2.40995 1.02997e-05
2.12139 1.02997e-05
2.22347 1.02997e-05
1.21453 1.02997e-05
1.49128 1.02997e-05
3.41048 1.02997e-05
3.81765 1.02997e-05
3.92759 1.02997e-05
4.20256 1.02997e-05
1.36136 1.02997e-05
1.32923 1.02997e-05
1.1449 1.02997e-05
1.18331 1.02997e-05
3.52783 1.02997e-05
4.3061 1.02997e-05
END
$hits1 << END
1.74663 6.10352e-05
1.81906 4.57764e-05
1.88484 1.52588e-05
1.98769 1.02997e-05
2.24982 0.000213623
2.35024 7.62939e-05
1.61955 6.10352e-05
1.68616 4.57764e-05
1.25909 1.52588e-05
1.40517 1.02997e-05
2.74575 0.000213623
3.77528 7.62939e-05
2.9435 0.000183105
3.15667 0.000167847
0.823241 0.000198364
0.806562 0.000473022
0.921434 0.000350952
0.917305 0.000518799
3.70155 3.05176e-05
4.31607 3.05176e-05
END
$hits2 << END
1.50466 7.62939e-06
1.52428 7.62939e-06
1.43265 7.62939e-06
1.86976 7.62939e-06
1.99143 7.62939e-06
2.1306 7.62939e-06
1.41625 7.62939e-06
1.51651 7.62939e-06
1.19409 7.62939e-06
2.59077 7.62939e-06
3.09739 7.62939e-06
3.48262 7.62939e-06
2.58291 7.62939e-06
2.79221 7.62939e-06
0.793095 7.62939e-06
0.665019 7.62939e-06
0.78042 7.62939e-06
0.816295 7.62939e-06
3.37722 7.62939e-06
3.85168 7.62939e-06
0.601401 7.62939e-06
2.16706 7.62939e-06
0.574172 7.62939e-06
1.30506 7.62939e-06
END
$hits3 << END
1.70959 6.10352e-05
1.83411 4.57764e-05
1.83457 1.52588e-05
2.0002 7.62939e-06
2.21777 0.000213623
2.37964 7.62939e-05
1.60782 6.10352e-05
1.6992 4.57764e-05
1.33333 1.52588e-05
2.82843 7.62939e-06
3.54037 0.000213623
3.8372 7.62939e-05
2.8392 0.000183105
3.08469 0.000167847
0.817335 0.000198364
0.412478 0.000473022
0.910069 0.000350952
0.915254 0.000518799
4.00052 3.05176e-05
4.23739 3.05176e-05
END
$hits4 << END
1.73877 5.6514e-06
1.87635 5.6514e-06
1.70482 5.6514e-06
1.95977 5.6514e-06
2.00596 5.6514e-06
2.25927 5.6514e-06
1.51045 5.6514e-06
1.70872 5.6514e-06
1.14435 5.6514e-06
2.71148 5.6514e-06
3.15789 5.6514e-06
3.50889 5.6514e-06
2.89749 5.6514e-06
2.64345 5.6514e-06
0.891134 5.6514e-06
0.455073 5.6514e-06
0.869127 5.6514e-06
0.94976 5.6514e-06
3.12741 5.6514e-06
3.87543 5.6514e-06
END
$hits5 << END
1.95659 6.10352e-05
2.07708 4.57764e-05
1.8673 1.52588e-05
2.03227 5.6514e-06
2.19021 0.000213623
2.45583 7.62939e-05
1.84908 6.10352e-05
1.90289 4.57764e-05
1.32188 1.52588e-05
2.77902 5.6514e-06
3.64544 0.000213623
3.82588 7.62939e-05
3.25649 0.000183105
3.43877 0.000167847
0.909349 0.000198364
0.465632 0.000473022
0.910305 0.000350952
0.948616 0.000518799
4.08785 3.05176e-05
4.36712 3.05176e-05
END
$hits_front << END
4.3061 1.02997e-05
4.36712 3.05176e-05
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
set xrange [6.14027:68.0002]; set yrange [5.91675e-06:0.0144207]
set xlabel 'pictures a second  (more is better)'; set ylabel 'picture: RMSE of a channel  (less is better)' offset -1.5
set xtics ('7' 7, '10' 10, '15' 15, '20' 20, '30' 30, '50' 50)
set ytics ("same\nbits" 1.47919e-05, '10⁻⁴' 1e-4, '10⁻³' 1e-3, '10⁻²' 1e-2)
set object rectangle from graph 0, graph 0 to graph 1, first 2.51462e-05 fs solid noborder fc rgb '#eeeeee' behind
set arrow from first 56.6669,0.00551617 to graph 1.0,0.8768 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.8768 to graph 1.015,0.8768 nohead lw 0.8 lc rgb '#999999'
set label 'fast, study: x auto exact' at graph 1.02,0.8768 left
set arrow from first 53.4774,0.0019008 to graph 1.0,0.8176 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.8176 to graph 1.015,0.8176 nohead lw 0.8 lc rgb '#999999'
set label 'robust, study: x auto exact' at graph 1.02,0.8176 left
set arrow from first 53.2904,0.00189879 to graph 1.0,0.7676 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.7676 to graph 1.015,0.7676 nohead lw 0.8 lc rgb '#999999'
set label 'double, study: x auto exact' at graph 1.02,0.7676 left
set arrow from first 52.2747,0.00159428 to graph 1.0,0.7176 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.7176 to graph 1.015,0.7176 nohead lw 0.8 lc rgb '#999999'
set label 'double, study: balance 16 exact' at graph 1.02,0.7176 left
set arrow from first 46.9356,0.000750071 to graph 1.0,0.6209 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.6209 to graph 1.015,0.6209 nohead lw 0.8 lc rgb '#999999'
set label 'double, study: irregular exact' at graph 1.02,0.6209 left
set arrow from first 46.6949,1.09569e-05 to graph 1.0,0.0790 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.0790 to graph 1.015,0.0790 nohead lw 0.8 lc rgb '#999999'
set label 'double: balance 16 exact' at graph 1.02,0.0790 left
$picture0 << END
26.921 0.00517968
27.9474 0.00517968
24.4644 0.00517968
26.2417 0.00517968
27.3916 0.00517968
30.07 0.00517968
25.4281 0.00517968
26.5582 0.00517968
18.1681 0.00517968
21.0766 0.00517968
43.0773 0.00517968
48.1921 0.00517968
49.135 0.00517968
51.8124 0.00517968
23.2358 0.00517968
21.1982 0.00517968
19.2012 0.00517968
19.7928 0.00517968
41.6873 0.00517968
47.4635 0.00517968
END
$picture1 << END
28.438 0.0053141
25.3459 0.0053141
28.0251 0.00519284
30.4201 0.00517968
33.4216 0.00576829
34.7471 0.00551617
26.6942 0.0053141
27.4805 0.0053141
21.9476 0.00519284
21.2201 0.00517968
51.755 0.00576829
56.6669 0.00551617
50.7354 0.0053141
52.6067 0.0053141
19.11 0.00519243
18.2005 0.00520446
17.8413 0.00576829
18.8616 0.00553944
48.5512 0.00525173
50.1138 0.00523371
END
$picture2 << END
21.6671 0.000118335
23.0005 0.000118335
18.9289 0.000118335
24.8305 0.000118335
23.3085 0.000118335
27.6873 0.000118335
20.5237 0.000118335
21.9311 0.000118335
16.9034 0.000118335
37.6557 0.000118335
39.5873 0.000118335
45.7114 0.000118335
37.474 0.000118335
41.114 0.000118335
16.0075 0.000118335
7.36833 0.000118335
13.9971 0.000118335
15.1111 0.000118335
40.398 0.000118335
41.754 0.000118335
10.5873 0.000118335
24.7566 0.000118335
12.9327 0.000118335
14.6595 0.000118335
END
$picture3 << END
24.3113 0.00159667
25.5407 0.00159667
26.145 0.000387878
29.392 0.000118335
29.0328 0.00254127
32.2514 0.0019008
23.3386 0.00159667
24.3372 0.00159667
21.9962 0.000387878
45.3694 0.000118335
49.5471 0.00254127
53.4774 0.0019008
43.0545 0.00159667
45.9905 0.00159667
17.3258 0.000382429
8.09769 0.000520823
17.2755 0.00254127
16.2039 0.0019673
41.5557 0.000874952
45.3521 0.000759348
END
$picture4 << END
24.2233 1.09569e-05
25.9629 1.09569e-05
21.46 1.09569e-05
25.0054 1.09569e-05
24.8015 1.09569e-05
28.8994 1.09569e-05
23.3342 1.09569e-05
24.5105 1.09569e-05
16.5431 1.09569e-05
35.6028 1.09569e-05
41.0371 1.09569e-05
46.3671 1.09569e-05
43.4018 1.09569e-05
46.6949 1.09569e-05
17.8936 1.09569e-05
9.60181 1.09569e-05
14.9725 1.09569e-05
16.166 1.09569e-05
42.0398 1.09569e-05
43.0461 1.09569e-05
END
$picture5 << END
27.0049 0.00159428
28.667 0.00159428
27.1687 0.000369387
30.0504 1.09569e-05
30.3207 0.00253977
33.9549 0.00189879
26.1073 0.00159428
27.0574 0.00159428
22.0385 0.000369387
43.3911 1.09569e-05
50.158 0.00253977
53.2904 0.00189879
48.291 0.00159428
52.2747 0.00159428
19.323 0.00036366
9.54308 0.000509379
17.4571 0.00253977
18.1601 0.00196593
45.588 0.000866912
46.9356 0.000750071
END
$picture_front << END
46.6949 1.09569e-05
46.9356 0.000750071
52.2747 0.00159428
53.2904 0.00189879
53.4774 0.0019008
56.6669 0.00551617
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
set xrange [0.696592:12.306]; set yrange [3.05176e-06:0.00114441]
set xlabel 'million nearest hits a second  (more is better)'; set ylabel 'wrong hits  (less is better)' offset -1.5
set label 'teapot: speed against accuracy (CPU, 2 threads)' at screen 0.02, screen 0.9774 font ',20'
set label '256x256 primary and 65,536 random rays a scene; 65,536 in all compared with brute force in double; pictures of 128x128' at screen 0.02, screen 0.9516
set xtics ('0.7' 0.7, '1' 1, '1.5' 1.5, '2' 2, '3' 3, '5' 5, '7' 7, '10' 10)
set ytics ("none of\n65,536" 7.62939e-06, '0.01 %%' 1e-4, '0.1 %%' 1e-3)
set object rectangle from graph 0, graph 0 to graph 1, first 1.297e-05 fs solid noborder fc rgb '#eeeeee' behind
set arrow from first 10.255,7.62939e-06 to graph 1.0,0.1546 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.1546 to graph 1.015,0.1546 nohead lw 0.8 lc rgb '#999999'
set label 'robust: irregular exact' at graph 1.02,0.1546 left
$hits0 << END
5.07334 1.52588e-05
5.08491 1.52588e-05
3.86655 1.52588e-05
3.12305 1.52588e-05
2.95456 1.52588e-05
5.17696 1.52588e-05
4.53434 1.52588e-05
4.2225 1.52588e-05
1.27457 1.52588e-05
2.2957 1.52588e-05
1.84088 1.52588e-05
2.41646 1.52588e-05
3.43613 1.52588e-05
4.76552 1.52588e-05
2.6161 1.52588e-05
2.7295 1.52588e-05
3.23787 1.52588e-05
3.07785 1.52588e-05
5.44979 1.52588e-05
5.83674 1.52588e-05
END
$hits1 << END
2.89105 0.000457764
3.17486 0.000457764
3.58452 0.00038147
2.97263 0.000396729
4.33055 0.000366211
3.43671 0.000198364
2.04665 0.000457764
2.00674 0.000457764
1.72636 0.00038147
1.80502 0.000396729
2.54552 0.000366211
3.25892 0.000198364
2.8313 0.000457764
3.03688 0.000457764
1.85356 0.000350952
1.46369 0.000427246
1.8629 0.000305176
1.5928 0.000167847
5.02052 0.00038147
8.96817 0.000152588
END
$hits2 << END
4.10594 7.62939e-06
5.91411 7.62939e-06
2.30116 7.62939e-06
3.98651 7.62939e-06
3.33164 7.62939e-06
5.0296 7.62939e-06
3.93167 7.62939e-06
4.04159 7.62939e-06
2.25301 7.62939e-06
2.37692 7.62939e-06
3.26152 7.62939e-06
2.67923 7.62939e-06
3.30268 7.62939e-06
2.93394 7.62939e-06
1.7408 7.62939e-06
2.71763 7.62939e-06
3.29902 7.62939e-06
2.57243 7.62939e-06
5.3603 7.62939e-06
10.255 7.62939e-06
0.835911 7.62939e-06
2.6935 7.62939e-06
4.29822 7.62939e-06
1.55496 7.62939e-06
3.0796 7.62939e-06
END
$hits3 << END
2.98316 0.000442505
3.00738 0.000442505
2.79098 0.000366211
2.87169 0.00038147
4.29872 0.000350952
2.8698 0.000183105
2.34364 0.000442505
2.22628 0.000442505
1.75218 0.000366211
2.23169 0.00038147
2.14317 0.000350952
3.28907 0.000183105
2.43458 0.000442505
2.63221 0.000442505
1.72805 0.000335693
1.13383 0.000411987
1.93836 0.000289917
2.12809 0.000152588
8.15882 0.000366211
9.85306 0.000137329
END
$hits4 << END
2.58848 5.6514e-06
4.53413 5.6514e-06
3.41924 5.6514e-06
2.47568 5.6514e-06
2.39309 5.6514e-06
2.90142 5.6514e-06
3.47755 5.6514e-06
3.66592 5.6514e-06
2.17976 5.6514e-06
1.4233 5.6514e-06
2.433 5.6514e-06
2.96212 5.6514e-06
3.36481 5.6514e-06
3.18289 5.6514e-06
2.0622 5.6514e-06
2.16363 5.6514e-06
1.74763 5.6514e-06
2.3635 5.6514e-06
4.67993 5.6514e-06
6.44778 5.6514e-06
END
$hits5 << END
2.47917 0.000442505
3.54852 0.000442505
3.29506 0.000366211
2.05707 0.00038147
2.45425 0.000350952
2.63092 0.000183105
2.08567 0.000442505
3.12696 0.000442505
2.16458 0.000366211
2.24026 0.00038147
3.25537 0.000350952
2.96458 0.000183105
2.61564 0.000442505
2.00604 0.000442505
1.92843 0.000335693
1.4095 0.000411987
2.17695 0.000289917
2.25977 0.000152588
7.67373 0.000366211
6.27961 0.000137329
END
$hits_front << END
10.255 7.62939e-06
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
set xrange [3.9007:97.4651]; set yrange [6.13835e-08:0.0179018]
set xlabel 'pictures a second  (more is better)'; set ylabel 'picture: RMSE of a channel  (less is better)' offset -1.5
set xtics ('5' 5, '10' 10, '20' 20, '50' 50)
set ytics ("same\nbits" 1.53459e-07, '10⁻⁶' 1e-6, '10⁻⁵' 1e-5, '10⁻⁴' 1e-4, '10⁻³' 1e-3, '10⁻²' 1e-2)
set object rectangle from graph 0, graph 0 to graph 1, first 2.6088e-07 fs solid noborder fc rgb '#eeeeee' behind
set arrow from first 81.2209,0.000386071 to graph 1.0,0.6951 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.6951 to graph 1.015,0.6951 nohead lw 0.8 lc rgb '#999999'
set label 'fast: irregular box' at graph 1.02,0.6951 left
set arrow from first 77.5904,1.22767e-06 to graph 1.0,0.2381 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.2381 to graph 1.015,0.2381 nohead lw 0.8 lc rgb '#999999'
set label 'robust: irregular exact' at graph 1.02,0.2381 left
set arrow from first 69.588,1.13673e-07 to graph 1.0,0.0490 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.0490 to graph 1.015,0.0490 nohead lw 0.8 lc rgb '#999999'
set label 'double: irregular exact' at graph 1.02,0.0490 left
$picture0 << END
33.2378 0.000386071
51.0048 0.000386071
28.9686 0.000386071
24.2484 0.000386071
27.703 0.000386071
48.2302 0.000386071
42.8273 0.000386071
34.5214 0.000386071
23.3264 0.000386071
24.0357 0.000386071
34.0717 0.000386071
21.2786 0.000386071
28.3952 0.000386071
36.4146 0.000386071
21.9893 0.000386071
25.6537 0.000386071
17.3403 0.000386071
34.6113 0.000386071
81.2209 0.000386071
48.9546 0.000386071
END
$picture1 << END
34.005 0.00676137
35.5314 0.00676137
34.5355 0.0071607
37.892 0.00713817
25.8246 0.00709362
50.0984 0.00356432
31.3971 0.00676137
33.3738 0.00676137
22.528 0.0071607
24.244 0.00713817
22.6451 0.00709362
36.9895 0.00356432
31.0235 0.00676137
21.7057 0.00676137
20.9992 0.00596842
17.6745 0.00531404
25.798 0.00426532
25.6605 0.00207633
62.5661 0.00655914
46.6027 0.00373511
END
$picture2 << END
34.4383 1.22767e-06
37.1984 1.22767e-06
19.8787 1.22767e-06
35.6724 1.22767e-06
41.6835 1.22767e-06
27.8435 1.22767e-06
33.3977 1.22767e-06
34.3525 1.22767e-06
15.4055 1.22767e-06
23.8579 1.22767e-06
31.4167 1.22767e-06
20.1968 1.22767e-06
16.9968 1.22767e-06
31.2633 1.22767e-06
12.1567 1.22767e-06
20.9277 1.22767e-06
25.3312 1.22767e-06
27.3308 1.22767e-06
41.9082 1.22767e-06
77.5904 1.22767e-06
4.68084 1.22767e-06
15.6117 1.22767e-06
56.0139 1.22767e-06
24.3018 1.22767e-06
19.2074 1.22767e-06
END
$picture3 << END
25.8667 0.00675033
23.0249 0.00675033
32.9928 0.00715028
22.0201 0.00712772
30.7118 0.0070831
26.1587 0.00354334
25.6205 0.00675033
24.2017 0.00675033
22.2571 0.00715028
23.0131 0.00712772
31.2362 0.0070831
29.3684 0.00354334
21.8015 0.00675033
25.5536 0.00675033
15.0664 0.00595591
16.3644 0.0053
15.4038 0.00424781
20.5935 0.00204012
74.2451 0.00654777
42.0364 0.00371511
END
$picture4 << END
29.1191 1.13673e-07
28.106 1.13673e-07
34.0336 1.13673e-07
29.7697 1.13673e-07
39.1383 1.13673e-07
21.2243 1.13673e-07
28.1862 1.13673e-07
16.1903 1.13673e-07
21.0677 1.13673e-07
22.9649 1.13673e-07
30.1659 1.13673e-07
34.1466 1.13673e-07
25.2542 1.13673e-07
24.1356 1.13673e-07
16.4047 1.13673e-07
18.0337 1.13673e-07
19.5891 1.13673e-07
22.8349 1.13673e-07
39.1241 1.13673e-07
69.588 1.13673e-07
END
$picture5 << END
29.9558 0.00675033
33.0937 0.00675033
26.1905 0.00715028
22.9071 0.00712772
29.5267 0.00708309
26.407 0.00354334
29.2596 0.00675033
28.1671 0.00675033
20.399 0.00715028
23.4828 0.00712772
18.4832 0.00708309
34.5313 0.00354334
27.2528 0.00675033
25.0879 0.00675033
10.2993 0.00595591
11.8328 0.0053
20.397 0.00424781
23.6463 0.00204011
45.3459 0.00654777
43.792 0.0037151
END
$picture_front << END
69.588 1.13673e-07
77.5904 1.22767e-06
81.2209 0.000386071
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
set xrange [0.696592:12.306]; set yrange [3.05176e-06:0.00114441]
set xlabel 'million nearest hits a second  (more is better)'; set ylabel 'wrong hits  (less is better)' offset -1.5
set label 'teapot: speed against accuracy (CPU, 2 threads)' at screen 0.02, screen 0.9774 font ',20'
set label '256x256 primary and 65,536 random rays a scene; 65,536 in all compared with brute force in double; pictures of 128x128' at screen 0.02, screen 0.9516
set xtics ('0.7' 0.7, '1' 1, '1.5' 1.5, '2' 2, '3' 3, '5' 5, '7' 7, '10' 10)
set ytics ("none of\n65,536" 7.62939e-06, '0.01 %%' 1e-4, '0.1 %%' 1e-3)
set object rectangle from graph 0, graph 0 to graph 1, first 1.297e-05 fs solid noborder fc rgb '#eeeeee' behind
set arrow from first 10.255,7.62939e-06 to graph 1.0,0.1546 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.1546 to graph 1.015,0.1546 nohead lw 0.8 lc rgb '#999999'
set label 'robust: irregular exact' at graph 1.02,0.1546 left
$hits0 << END
5.07334 1.52588e-05
5.08491 1.52588e-05
3.86655 1.52588e-05
3.12305 1.52588e-05
2.95456 1.52588e-05
5.17696 1.52588e-05
4.53434 1.52588e-05
4.2225 1.52588e-05
1.27457 1.52588e-05
2.2957 1.52588e-05
1.84088 1.52588e-05
2.41646 1.52588e-05
3.43613 1.52588e-05
4.76552 1.52588e-05
2.6161 1.52588e-05
2.7295 1.52588e-05
3.23787 1.52588e-05
3.07785 1.52588e-05
5.44979 1.52588e-05
5.83674 1.52588e-05
END
$hits1 << END
2.89105 0.000457764
3.17486 0.000457764
3.58452 0.00038147
2.97263 0.000396729
4.33055 0.000366211
3.43671 0.000198364
2.04665 0.000457764
2.00674 0.000457764
1.72636 0.00038147
1.80502 0.000396729
2.54552 0.000366211
3.25892 0.000198364
2.8313 0.000457764
3.03688 0.000457764
1.85356 0.000350952
1.46369 0.000427246
1.8629 0.000305176
1.5928 0.000167847
5.02052 0.00038147
8.96817 0.000152588
END
$hits2 << END
4.10594 7.62939e-06
5.91411 7.62939e-06
2.30116 7.62939e-06
3.98651 7.62939e-06
3.33164 7.62939e-06
5.0296 7.62939e-06
3.93167 7.62939e-06
4.04159 7.62939e-06
2.25301 7.62939e-06
2.37692 7.62939e-06
3.26152 7.62939e-06
2.67923 7.62939e-06
3.30268 7.62939e-06
2.93394 7.62939e-06
1.7408 7.62939e-06
2.71763 7.62939e-06
3.29902 7.62939e-06
2.57243 7.62939e-06
5.3603 7.62939e-06
10.255 7.62939e-06
0.835911 7.62939e-06
2.6935 7.62939e-06
4.29822 7.62939e-06
1.55496 7.62939e-06
3.0796 7.62939e-06
END
$hits3 << END
2.98316 0.000442505
3.00738 0.000442505
2.79098 0.000366211
2.87169 0.00038147
4.29872 0.000350952
2.8698 0.000183105
2.34364 0.000442505
2.22628 0.000442505
1.75218 0.000366211
2.23169 0.00038147
2.14317 0.000350952
3.28907 0.000183105
2.43458 0.000442505
2.63221 0.000442505
1.72805 0.000335693
1.13383 0.000411987
1.93836 0.000289917
2.12809 0.000152588
8.15882 0.000366211
9.85306 0.000137329
END
$hits4 << END
2.58848 5.6514e-06
4.53413 5.6514e-06
3.41924 5.6514e-06
2.47568 5.6514e-06
2.39309 5.6514e-06
2.90142 5.6514e-06
3.47755 5.6514e-06
3.66592 5.6514e-06
2.17976 5.6514e-06
1.4233 5.6514e-06
2.433 5.6514e-06
2.96212 5.6514e-06
3.36481 5.6514e-06
3.18289 5.6514e-06
2.0622 5.6514e-06
2.16363 5.6514e-06
1.74763 5.6514e-06
2.3635 5.6514e-06
4.67993 5.6514e-06
6.44778 5.6514e-06
END
$hits5 << END
2.47917 0.000442505
3.54852 0.000442505
3.29506 0.000366211
2.05707 0.00038147
2.45425 0.000350952
2.63092 0.000183105
2.08567 0.000442505
3.12696 0.000442505
2.16458 0.000366211
2.24026 0.00038147
3.25537 0.000350952
2.96458 0.000183105
2.61564 0.000442505
2.00604 0.000442505
1.92843 0.000335693
1.4095 0.000411987
2.17695 0.000289917
2.25977 0.000152588
7.67373 0.000366211
6.27961 0.000137329
END
$hits_front << END
10.255 7.62939e-06
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
set xrange [3.9007:97.4651]; set yrange [6.13835e-08:0.0179018]
set xlabel 'pictures a second  (more is better)'; set ylabel 'picture: RMSE of a channel  (less is better)' offset -1.5
set xtics ('5' 5, '10' 10, '20' 20, '50' 50)
set ytics ("same\nbits" 1.53459e-07, '10⁻⁶' 1e-6, '10⁻⁵' 1e-5, '10⁻⁴' 1e-4, '10⁻³' 1e-3, '10⁻²' 1e-2)
set object rectangle from graph 0, graph 0 to graph 1, first 2.6088e-07 fs solid noborder fc rgb '#eeeeee' behind
set arrow from first 81.2209,0.000386071 to graph 1.0,0.6951 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.6951 to graph 1.015,0.6951 nohead lw 0.8 lc rgb '#999999'
set label 'fast: irregular box' at graph 1.02,0.6951 left
set arrow from first 77.5904,1.22767e-06 to graph 1.0,0.2381 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.2381 to graph 1.015,0.2381 nohead lw 0.8 lc rgb '#999999'
set label 'robust: irregular exact' at graph 1.02,0.2381 left
set arrow from first 69.588,1.13673e-07 to graph 1.0,0.0490 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.0490 to graph 1.015,0.0490 nohead lw 0.8 lc rgb '#999999'
set label 'double: irregular exact' at graph 1.02,0.0490 left
$picture0 << END
33.2378 0.000386071
51.0048 0.000386071
28.9686 0.000386071
24.2484 0.000386071
27.703 0.000386071
48.2302 0.000386071
42.8273 0.000386071
34.5214 0.000386071
23.3264 0.000386071
24.0357 0.000386071
34.0717 0.000386071
21.2786 0.000386071
28.3952 0.000386071
36.4146 0.000386071
21.9893 0.000386071
25.6537 0.000386071
17.3403 0.000386071
34.6113 0.000386071
81.2209 0.000386071
48.9546 0.000386071
END
$picture1 << END
34.005 0.00676137
35.5314 0.00676137
34.5355 0.0071607
37.892 0.00713817
25.8246 0.00709362
50.0984 0.00356432
31.3971 0.00676137
33.3738 0.00676137
22.528 0.0071607
24.244 0.00713817
22.6451 0.00709362
36.9895 0.00356432
31.0235 0.00676137
21.7057 0.00676137
20.9992 0.00596842
17.6745 0.00531404
25.798 0.00426532
25.6605 0.00207633
62.5661 0.00655914
46.6027 0.00373511
END
$picture2 << END
34.4383 1.22767e-06
37.1984 1.22767e-06
19.8787 1.22767e-06
35.6724 1.22767e-06
41.6835 1.22767e-06
27.8435 1.22767e-06
33.3977 1.22767e-06
34.3525 1.22767e-06
15.4055 1.22767e-06
23.8579 1.22767e-06
31.4167 1.22767e-06
20.1968 1.22767e-06
16.9968 1.22767e-06
31.2633 1.22767e-06
12.1567 1.22767e-06
20.9277 1.22767e-06
25.3312 1.22767e-06
27.3308 1.22767e-06
41.9082 1.22767e-06
77.5904 1.22767e-06
4.68084 1.22767e-06
15.6117 1.22767e-06
56.0139 1.22767e-06
24.3018 1.22767e-06
19.2074 1.22767e-06
END
$picture3 << END
25.8667 0.00675033
23.0249 0.00675033
32.9928 0.00715028
22.0201 0.00712772
30.7118 0.0070831
26.1587 0.00354334
25.6205 0.00675033
24.2017 0.00675033
22.2571 0.00715028
23.0131 0.00712772
31.2362 0.0070831
29.3684 0.00354334
21.8015 0.00675033
25.5536 0.00675033
15.0664 0.00595591
16.3644 0.0053
15.4038 0.00424781
20.5935 0.00204012
74.2451 0.00654777
42.0364 0.00371511
END
$picture4 << END
29.1191 1.13673e-07
28.106 1.13673e-07
34.0336 1.13673e-07
29.7697 1.13673e-07
39.1383 1.13673e-07
21.2243 1.13673e-07
28.1862 1.13673e-07
16.1903 1.13673e-07
21.0677 1.13673e-07
22.9649 1.13673e-07
30.1659 1.13673e-07
34.1466 1.13673e-07
25.2542 1.13673e-07
24.1356 1.13673e-07
16.4047 1.13673e-07
18.0337 1.13673e-07
19.5891 1.13673e-07
22.8349 1.13673e-07
39.1241 1.13673e-07
69.588 1.13673e-07
END
$picture5 << END
29.9558 0.00675033
33.0937 0.00675033
26.1905 0.00715028
22.9071 0.00712772
29.5267 0.00708309
26.407 0.00354334
29.2596 0.00675033
28.1671 0.00675033
20.399 0.00715028
23.4828 0.00712772
18.4832 0.00708309
34.5313 0.00354334
27.2528 0.00675033
25.0879 0.00675033
10.2993 0.00595591
11.8328 0.0053
20.397 0.00424781
23.6463 0.00204011
45.3459 0.00654777
43.792 0.0037151
END
$picture_front << END
69.588 1.13673e-07
77.5904 1.22767e-06
81.2209 0.000386071
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
set xrange [0.396131:10.2865]; set yrange [3.05176e-06:0.00175476]
set xlabel 'million nearest hits a second  (more is better)'; set ylabel 'wrong hits  (less is better)' offset -1.5
set label 'tetra: speed against accuracy (CPU, 2 threads)' at screen 0.02, screen 0.9774 font ',20'
set label '256x256 primary and 65,536 random rays a scene; 65,536 in all compared with brute force in double; pictures of 128x128' at screen 0.02, screen 0.9516
set xtics ('0.5' 0.5, '1' 1, '2' 2, '5' 5, '10' 10)
set ytics ("none of\n65,536" 7.62939e-06, '0.01 %%' 1e-4, '0.1 %%' 1e-3)
set object rectangle from graph 0, graph 0 to graph 1, first 1.297e-05 fs solid noborder fc rgb '#eeeeee' behind
set arrow from first 8.57207,7.62939e-06 to graph 1.0,0.1442 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.1442 to graph 1.015,0.1442 nohead lw 0.8 lc rgb '#999999'
set label 'robust: irregular exact' at graph 1.02,0.1442 left
$hits0 << END
3.24004 1.02997e-05
3.22815 1.02997e-05
2.54469 1.02997e-05
2.17138 1.02997e-05
4.51944 1.02997e-05
3.09874 1.02997e-05
2.89339 1.02997e-05
2.84637 1.02997e-05
1.68521 1.02997e-05
2.37656 1.02997e-05
4.31418 1.02997e-05
3.29299 1.02997e-05
2.57544 1.02997e-05
1.96626 1.02997e-05
1.46586 1.02997e-05
1.34188 1.02997e-05
3.07348 1.02997e-05
2.13213 1.02997e-05
5.22307 1.02997e-05
5.2634 1.02997e-05
END
$hits1 << END
2.06072 1.02997e-05
2.49057 4.57764e-05
2.62585 1.02997e-05
2.67581 7.62939e-05
3.50737 1.02997e-05
3.66028 1.02997e-05
2.05377 1.02997e-05
1.75535 4.57764e-05
1.66258 1.02997e-05
2.18339 7.62939e-05
2.6072 1.02997e-05
2.70444 1.02997e-05
1.29501 1.02997e-05
1.90902 6.10352e-05
1.66314 1.02997e-05
1.30646 0.000701904
1.77504 1.02997e-05
1.52736 0.000442505
4.93273 1.02997e-05
5.22481 1.52588e-05
END
$hits2 << END
5.86695 7.62939e-06
4.37621 7.62939e-06
3.80608 7.62939e-06
3.0327 7.62939e-06
4.59465 7.62939e-06
5.1884 7.62939e-06
3.34984 7.62939e-06
3.26636 7.62939e-06
1.72391 7.62939e-06
2.03178 7.62939e-06
4.28211 7.62939e-06
4.56873 7.62939e-06
3.05072 7.62939e-06
3.36309 7.62939e-06
2.86726 7.62939e-06
2.52338 7.62939e-06
3.32551 7.62939e-06
2.90946 7.62939e-06
6.10069 7.62939e-06
8.57207 7.62939e-06
0.475357 7.62939e-06
1.58092 7.62939e-06
3.45699 7.62939e-06
3.15161 7.62939e-06
2.43328 7.62939e-06
1.22485 7.62939e-06
END
$hits3 << END
2.79981 7.62939e-06
2.29406 4.57764e-05
3.04592 7.62939e-06
3.74796 7.62939e-05
3.15882 7.62939e-06
3.71555 7.62939e-06
1.86507 7.62939e-06
2.0204 4.57764e-05
1.98696 7.62939e-06
2.45625 7.62939e-05
2.26488 7.62939e-06
2.93137 7.62939e-06
2.34287 7.62939e-06
1.90703 6.10352e-05
1.50732 7.62939e-06
1.43149 0.000701904
2.448 7.62939e-06
2.17954 0.000442505
4.66552 7.62939e-06
5.01471 1.52588e-05
END
$hits4 << END
3.07607 5.6514e-06
2.38807 5.6514e-06
2.4174 5.6514e-06
2.12962 5.6514e-06
3.91456 5.6514e-06
4.15111 5.6514e-06
2.43101 5.6514e-06
3.52901 5.6514e-06
1.74449 5.6514e-06
2.04699 5.6514e-06
3.60174 5.6514e-06
4.33761 5.6514e-06
1.95644 5.6514e-06
2.90734 5.6514e-06
1.92411 5.6514e-06
1.52497 5.6514e-06
3.15526 5.6514e-06
2.93501 5.6514e-06
6.35478 5.6514e-06
3.84839 5.6514e-06
END
$hits5 << END
2.21616 5.6514e-06
1.9501 4.57764e-05
2.52131 5.6514e-06
2.23314 7.62939e-05
4.77141 5.6514e-06
3.94955 5.6514e-06
2.16447 5.6514e-06
2.15293 4.57764e-05
2.16847 5.6514e-06
2.23473 7.62939e-05
3.13278 5.6514e-06
2.98823 5.6514e-06
1.58448 5.6514e-06
1.67775 6.10352e-05
1.66209 5.6514e-06
1.28848 0.000701904
2.58603 5.6514e-06
2.04579 0.000442505
6.10139 5.6514e-06
5.49964 1.52588e-05
END
$hits_front << END
8.57207 7.62939e-06
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
set xrange [7.49111:441.586]; set yrange [8.77735e-10:0.00543185]
set xlabel 'pictures a second  (more is better)'; set ylabel 'picture: RMSE of a channel  (less is better)' offset -1.5
set xtics ('10' 10, '20' 20, '50' 50, '100' 100, '200' 200)
set ytics ("same\nbits" 2.19434e-09, '10⁻⁸' 1e-8, '10⁻⁷' 1e-7, '10⁻⁶' 1e-6, '10⁻⁵' 1e-5, '10⁻⁴' 1e-4, '10⁻³' 1e-3)
set object rectangle from graph 0, graph 0 to graph 1, first 3.73037e-09 fs solid noborder fc rgb '#eeeeee' behind
set arrow from first 367.988,4.25719e-07 to graph 1.0,0.3955 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.3955 to graph 1.015,0.3955 nohead lw 0.8 lc rgb '#999999'
set label 'fast, study: irregular exact' at graph 1.02,0.3955 left
set arrow from first 364.397,1.75547e-08 to graph 1.0,0.1916 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.1916 to graph 1.015,0.1916 nohead lw 0.8 lc rgb '#999999'
set label 'robust: irregular exact' at graph 1.02,0.1916 left
set arrow from first 344.169,1.62544e-09 to graph 1.0,0.0394 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.0394 to graph 1.015,0.0394 nohead lw 0.8 lc rgb '#999999'
set label 'double, study: irregular exact' at graph 1.02,0.0394 left
$picture0 << END
250.414 4.25719e-07
133.277 4.25719e-07
104.341 4.25719e-07
107.395 4.25719e-07
180.938 4.25719e-07
324.846 4.25719e-07
223.637 4.25719e-07
115.846 4.25719e-07
71.6368 4.25719e-07
72.0062 4.25719e-07
127.642 4.25719e-07
125.611 4.25719e-07
113.38 4.25719e-07
203.226 4.25719e-07
134.92 4.25719e-07
70.3042 4.25719e-07
233.65 4.25719e-07
109.514 4.25719e-07
228.367 4.25719e-07
214.352 4.25719e-07
END
$picture1 << END
148.008 4.25719e-07
95.4198 4.25719e-07
97.1628 4.25719e-07
120.319 4.25719e-07
170.072 4.25719e-07
148.569 4.25719e-07
127.153 4.25719e-07
134.011 4.25719e-07
128.169 4.25719e-07
114.55 4.25719e-07
116.239 4.25719e-07
187.693 4.25719e-07
80.7129 4.25719e-07
131.137 4.25719e-07
65.4896 4.25719e-07
80.5425 0.00173156
136.383 4.25719e-07
72.7516 0.00217274
206.268 4.25719e-07
367.988 4.25719e-07
END
$picture2 << END
130.5 1.75547e-08
142.139 1.75547e-08
179.874 1.75547e-08
113.228 1.75547e-08
135.962 1.75547e-08
238.723 1.75547e-08
122.492 1.75547e-08
81.4339 1.75547e-08
72.4003 1.75547e-08
110.836 1.75547e-08
106.06 1.75547e-08
112.156 1.75547e-08
72.2517 1.75547e-08
79.1321 1.75547e-08
58.0676 1.75547e-08
61.4285 1.75547e-08
74.6191 1.75547e-08
110.393 1.75547e-08
245.832 1.75547e-08
364.397 1.75547e-08
8.98933 1.75547e-08
20.282 1.75547e-08
74.4668 1.75547e-08
113.475 1.75547e-08
98.2753 1.75547e-08
56.6887 1.75547e-08
END
$picture3 << END
76.9438 1.75547e-08
82.3798 1.75547e-08
128.946 1.75547e-08
153.589 1.75547e-08
129.355 1.75547e-08
146.689 1.75547e-08
70.798 1.75547e-08
128.091 1.75547e-08
101.408 1.75547e-08
70.0236 1.75547e-08
97.1817 1.75547e-08
112.861 1.75547e-08
64.2946 1.75547e-08
73.6171 1.75547e-08
52.5624 1.75547e-08
73.3063 0.00173156
70.1779 1.75547e-08
65.6612 0.00217274
183.115 1.75547e-08
193.382 1.75547e-08
END
$picture4 << END
126.066 1.62544e-09
111.421 1.62544e-09
125.425 1.62544e-09
147.639 1.62544e-09
232.777 1.62544e-09
136.438 1.62544e-09
71.4669 1.62544e-09
78.7426 1.62544e-09
98.1682 1.62544e-09
63.2591 1.62544e-09
147.394 1.62544e-09
105.944 1.62544e-09
83.5492 1.62544e-09
117.479 1.62544e-09
90.6602 1.62544e-09
43.9626 1.62544e-09
72.9975 1.62544e-09
69.1797 1.62544e-09
173.462 1.62544e-09
326.15 1.62544e-09
END
$picture5 << END
86.2463 1.62544e-09
128.867 1.62544e-09
134.327 1.62544e-09
105.763 1.62544e-09
129.69 1.62544e-09
216.907 1.62544e-09
78.0921 1.62544e-09
83.3875 1.62544e-09
58.1209 1.62544e-09
68.3312 1.62544e-09
104.921 1.62544e-09
164.718 1.62544e-09
121.461 1.62544e-09
128.217 1.62544e-09
101.203 1.62544e-09
44.925 0.00173156
73.4047 1.62544e-09
69.9017 0.00217274
181.671 1.62544e-09
344.169 1.62544e-09
END
$picture_front << END
344.169 1.62544e-09
364.397 1.75547e-08
367.988 4.25719e-07
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
set xrange [0.396131:10.2865]; set yrange [3.05176e-06:0.00175476]
set xlabel 'million nearest hits a second  (more is better)'; set ylabel 'wrong hits  (less is better)' offset -1.5
set label 'tetra: speed against accuracy (CPU, 2 threads)' at screen 0.02, screen 0.9774 font ',20'
set label '256x256 primary and 65,536 random rays a scene; 65,536 in all compared with brute force in double; pictures of 128x128' at screen 0.02, screen 0.9516
set xtics ('0.5' 0.5, '1' 1, '2' 2, '5' 5, '10' 10)
set ytics ("none of\n65,536" 7.62939e-06, '0.01 %%' 1e-4, '0.1 %%' 1e-3)
set object rectangle from graph 0, graph 0 to graph 1, first 1.297e-05 fs solid noborder fc rgb '#eeeeee' behind
set arrow from first 8.57207,7.62939e-06 to graph 1.0,0.1442 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.1442 to graph 1.015,0.1442 nohead lw 0.8 lc rgb '#999999'
set label 'robust: irregular exact' at graph 1.02,0.1442 left
$hits0 << END
3.24004 1.02997e-05
3.22815 1.02997e-05
2.54469 1.02997e-05
2.17138 1.02997e-05
4.51944 1.02997e-05
3.09874 1.02997e-05
2.89339 1.02997e-05
2.84637 1.02997e-05
1.68521 1.02997e-05
2.37656 1.02997e-05
4.31418 1.02997e-05
3.29299 1.02997e-05
2.57544 1.02997e-05
1.96626 1.02997e-05
1.46586 1.02997e-05
1.34188 1.02997e-05
3.07348 1.02997e-05
2.13213 1.02997e-05
5.22307 1.02997e-05
5.2634 1.02997e-05
END
$hits1 << END
2.06072 1.02997e-05
2.49057 4.57764e-05
2.62585 1.02997e-05
2.67581 7.62939e-05
3.50737 1.02997e-05
3.66028 1.02997e-05
2.05377 1.02997e-05
1.75535 4.57764e-05
1.66258 1.02997e-05
2.18339 7.62939e-05
2.6072 1.02997e-05
2.70444 1.02997e-05
1.29501 1.02997e-05
1.90902 6.10352e-05
1.66314 1.02997e-05
1.30646 0.000701904
1.77504 1.02997e-05
1.52736 0.000442505
4.93273 1.02997e-05
5.22481 1.52588e-05
END
$hits2 << END
5.86695 7.62939e-06
4.37621 7.62939e-06
3.80608 7.62939e-06
3.0327 7.62939e-06
4.59465 7.62939e-06
5.1884 7.62939e-06
3.34984 7.62939e-06
3.26636 7.62939e-06
1.72391 7.62939e-06
2.03178 7.62939e-06
4.28211 7.62939e-06
4.56873 7.62939e-06
3.05072 7.62939e-06
3.36309 7.62939e-06
2.86726 7.62939e-06
2.52338 7.62939e-06
3.32551 7.62939e-06
2.90946 7.62939e-06
6.10069 7.62939e-06
8.57207 7.62939e-06
0.475357 7.62939e-06
1.58092 7.62939e-06
3.45699 7.62939e-06
3.15161 7.62939e-06
2.43328 7.62939e-06
1.22485 7.62939e-06
END
$hits3 << END
2.79981 7.62939e-06
2.29406 4.57764e-05
3.04592 7.62939e-06
3.74796 7.62939e-05
3.15882 7.62939e-06
3.71555 7.62939e-06
1.86507 7.62939e-06
2.0204 4.57764e-05
1.98696 7.62939e-06
2.45625 7.62939e-05
2.26488 7.62939e-06
2.93137 7.62939e-06
2.34287 7.62939e-06
1.90703 6.10352e-05
1.50732 7.62939e-06
1.43149 0.000701904
2.448 7.62939e-06
2.17954 0.000442505
4.66552 7.62939e-06
5.01471 1.52588e-05
END
$hits4 << END
3.07607 5.6514e-06
2.38807 5.6514e-06
2.4174 5.6514e-06
2.12962 5.6514e-06
3.91456 5.6514e-06
4.15111 5.6514e-06
2.43101 5.6514e-06
3.52901 5.6514e-06
1.74449 5.6514e-06
2.04699 5.6514e-06
3.60174 5.6514e-06
4.33761 5.6514e-06
1.95644 5.6514e-06
2.90734 5.6514e-06
1.92411 5.6514e-06
1.52497 5.6514e-06
3.15526 5.6514e-06
2.93501 5.6514e-06
6.35478 5.6514e-06
3.84839 5.6514e-06
END
$hits5 << END
2.21616 5.6514e-06
1.9501 4.57764e-05
2.52131 5.6514e-06
2.23314 7.62939e-05
4.77141 5.6514e-06
3.94955 5.6514e-06
2.16447 5.6514e-06
2.15293 4.57764e-05
2.16847 5.6514e-06
2.23473 7.62939e-05
3.13278 5.6514e-06
2.98823 5.6514e-06
1.58448 5.6514e-06
1.67775 6.10352e-05
1.66209 5.6514e-06
1.28848 0.000701904
2.58603 5.6514e-06
2.04579 0.000442505
6.10139 5.6514e-06
5.49964 1.52588e-05
END
$hits_front << END
8.57207 7.62939e-06
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
set xrange [7.49111:441.586]; set yrange [8.77735e-10:0.00543185]
set xlabel 'pictures a second  (more is better)'; set ylabel 'picture: RMSE of a channel  (less is better)' offset -1.5
set xtics ('10' 10, '20' 20, '50' 50, '100' 100, '200' 200)
set ytics ("same\nbits" 2.19434e-09, '10⁻⁸' 1e-8, '10⁻⁷' 1e-7, '10⁻⁶' 1e-6, '10⁻⁵' 1e-5, '10⁻⁴' 1e-4, '10⁻³' 1e-3)
set object rectangle from graph 0, graph 0 to graph 1, first 3.73037e-09 fs solid noborder fc rgb '#eeeeee' behind
set arrow from first 367.988,4.25719e-07 to graph 1.0,0.3955 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.3955 to graph 1.015,0.3955 nohead lw 0.8 lc rgb '#999999'
set label 'fast, study: irregular exact' at graph 1.02,0.3955 left
set arrow from first 364.397,1.75547e-08 to graph 1.0,0.1916 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.1916 to graph 1.015,0.1916 nohead lw 0.8 lc rgb '#999999'
set label 'robust: irregular exact' at graph 1.02,0.1916 left
set arrow from first 344.169,1.62544e-09 to graph 1.0,0.0394 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.0394 to graph 1.015,0.0394 nohead lw 0.8 lc rgb '#999999'
set label 'double, study: irregular exact' at graph 1.02,0.0394 left
$picture0 << END
250.414 4.25719e-07
133.277 4.25719e-07
104.341 4.25719e-07
107.395 4.25719e-07
180.938 4.25719e-07
324.846 4.25719e-07
223.637 4.25719e-07
115.846 4.25719e-07
71.6368 4.25719e-07
72.0062 4.25719e-07
127.642 4.25719e-07
125.611 4.25719e-07
113.38 4.25719e-07
203.226 4.25719e-07
134.92 4.25719e-07
70.3042 4.25719e-07
233.65 4.25719e-07
109.514 4.25719e-07
228.367 4.25719e-07
214.352 4.25719e-07
END
$picture1 << END
148.008 4.25719e-07
95.4198 4.25719e-07
97.1628 4.25719e-07
120.319 4.25719e-07
170.072 4.25719e-07
148.569 4.25719e-07
127.153 4.25719e-07
134.011 4.25719e-07
128.169 4.25719e-07
114.55 4.25719e-07
116.239 4.25719e-07
187.693 4.25719e-07
80.7129 4.25719e-07
131.137 4.25719e-07
65.4896 4.25719e-07
80.5425 0.00173156
136.383 4.25719e-07
72.7516 0.00217274
206.268 4.25719e-07
367.988 4.25719e-07
END
$picture2 << END
130.5 1.75547e-08
142.139 1.75547e-08
179.874 1.75547e-08
113.228 1.75547e-08
135.962 1.75547e-08
238.723 1.75547e-08
122.492 1.75547e-08
81.4339 1.75547e-08
72.4003 1.75547e-08
110.836 1.75547e-08
106.06 1.75547e-08
112.156 1.75547e-08
72.2517 1.75547e-08
79.1321 1.75547e-08
58.0676 1.75547e-08
61.4285 1.75547e-08
74.6191 1.75547e-08
110.393 1.75547e-08
245.832 1.75547e-08
364.397 1.75547e-08
8.98933 1.75547e-08
20.282 1.75547e-08
74.4668 1.75547e-08
113.475 1.75547e-08
98.2753 1.75547e-08
56.6887 1.75547e-08
END
$picture3 << END
76.9438 1.75547e-08
82.3798 1.75547e-08
128.946 1.75547e-08
153.589 1.75547e-08
129.355 1.75547e-08
146.689 1.75547e-08
70.798 1.75547e-08
128.091 1.75547e-08
101.408 1.75547e-08
70.0236 1.75547e-08
97.1817 1.75547e-08
112.861 1.75547e-08
64.2946 1.75547e-08
73.6171 1.75547e-08
52.5624 1.75547e-08
73.3063 0.00173156
70.1779 1.75547e-08
65.6612 0.00217274
183.115 1.75547e-08
193.382 1.75547e-08
END
$picture4 << END
126.066 1.62544e-09
111.421 1.62544e-09
125.425 1.62544e-09
147.639 1.62544e-09
232.777 1.62544e-09
136.438 1.62544e-09
71.4669 1.62544e-09
78.7426 1.62544e-09
98.1682 1.62544e-09
63.2591 1.62544e-09
147.394 1.62544e-09
105.944 1.62544e-09
83.5492 1.62544e-09
117.479 1.62544e-09
90.6602 1.62544e-09
43.9626 1.62544e-09
72.9975 1.62544e-09
69.1797 1.62544e-09
173.462 1.62544e-09
326.15 1.62544e-09
END
$picture5 << END
86.2463 1.62544e-09
128.867 1.62544e-09
134.327 1.62544e-09
105.763 1.62544e-09
129.69 1.62544e-09
216.907 1.62544e-09
78.0921 1.62544e-09
83.3875 1.62544e-09
58.1209 1.62544e-09
68.3312 1.62544e-09
104.921 1.62544e-09
164.718 1.62544e-09
121.461 1.62544e-09
128.217 1.62544e-09
101.203 1.62544e-09
44.925 0.00173156
73.4047 1.62544e-09
69.9017 0.00217274
181.671 1.62544e-09
344.169 1.62544e-09
END
$picture_front << END
344.169 1.62544e-09
364.397 1.75547e-08
367.988 4.25719e-07
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
set xrange [0.62153:6.17652]; set yrange [3.05176e-06:0.0588608]
set xlabel 'million nearest hits a second  (more is better)'; set ylabel 'wrong hits  (less is better)' offset -1.5
set label 'rings: speed against accuracy (CPU, 2 threads)' at screen 0.02, screen 0.9774 font ',20'
set label '256x256 primary and 65,536 random rays a scene; 65,536 in all compared with brute force in double; pictures of 128x128' at screen 0.02, screen 0.9516
set xtics ('0.7' 0.7, '1' 1, '1.5' 1.5, '2' 2, '3' 3, '5' 5)
set ytics ("none of\n65,536" 7.62939e-06, '0.01 %%' 1e-4, '0.1 %%' 1e-3, '1 %%' 1e-2)
set object rectangle from graph 0, graph 0 to graph 1, first 1.297e-05 fs solid noborder fc rgb '#eeeeee' behind
set arrow from first 5.1471,0.00816345 to graph 1.0,0.7998 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.7998 to graph 1.015,0.7998 nohead lw 0.8 lc rgb '#999999'
set label 'double, study: irregular exact' at graph 1.02,0.7998 left
set arrow from first 5.03734,5.6514e-06 to graph 1.0,0.0624 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.0624 to graph 1.015,0.0624 nohead lw 0.8 lc rgb '#999999'
set label 'double: irregular exact' at graph 1.02,0.0624 left
$hits0 << END
1.20764 0.000259399
1.46687 0.000259399
1.91014 0.000259399
2.70174 0.000259399
2.07016 0.000259399
3.20495 0.000259399
1.19534 0.000259399
1.49012 0.000259399
1.62447 0.000259399
2.03465 0.000259399
1.78143 0.000259399
2.3879 0.000259399
1.18044 0.000259399
1.46722 0.000259399
0.855196 0.000259399
1.1489 0.000259399
0.80521 0.000259399
1.02106 0.000259399
3.49389 0.000259399
4.58288 0.000259399
END
$hits1 << END
1.18065 0.00686646
1.49247 0.00610352
2.27279 0.0235443
2.99246 0.00991821
2.22604 0.0219116
3.32898 0.0118256
1.21919 0.00686646
1.50408 0.00610352
1.73572 0.0235443
2.1662 0.00991821
1.88531 0.0219116
2.51303 0.0118256
1.21315 0.00785828
1.47628 0.00624084
0.880852 0.0185242
1.17042 0.0170288
0.832603 0.0169067
1.10216 0.0122986
3.65415 0.0161591
4.85522 0.00840759
END
$hits2 << END
1.52509 7.62939e-06
1.79774 7.62939e-06
2.3418 7.62939e-06
3.03131 7.62939e-06
2.22832 7.62939e-06
3.30227 7.62939e-06
1.50934 7.62939e-06
1.79773 7.62939e-06
1.73963 7.62939e-06
2.1041 7.62939e-06
1.95299 7.62939e-06
2.30496 7.62939e-06
1.51326 7.62939e-06
1.79994 7.62939e-06
1.22909 7.62939e-06
1.53725 7.62939e-06
1.15174 7.62939e-06
1.45853 7.62939e-06
3.93457 7.62939e-06
4.84323 7.62939e-06
0.745836 7.62939e-06
3.38374 7.62939e-06
2.12292 7.62939e-06
2.59483 7.62939e-06
END
$hits3 << END
1.606 0.00662231
1.93673 0.00582886
2.58373 0.0233154
3.1268 0.00970459
2.70004 0.021698
3.52264 0.0115967
1.63333 0.00662231
1.92181 0.00582886
1.84376 0.0233154
2.16619 0.00970459
2.11318 0.021698
2.55153 0.0115967
1.61623 0.00762939
1.88488 0.00596619
1.31691 0.0183563
1.61792 0.016861
1.21326 0.0166779
1.52515 0.0120697
4.24117 0.0159454
5.06876 0.00816345
END
$hits4 << END
1.98431 5.6514e-06
2.40919 5.6514e-06
2.46724 5.6514e-06
3.02067 5.6514e-06
2.49264 5.6514e-06
3.42338 5.6514e-06
1.99307 5.6514e-06
2.30282 5.6514e-06
1.7665 5.6514e-06
2.00258 5.6514e-06
1.7586 5.6514e-06
2.44942 5.6514e-06
1.97954 5.6514e-06
1.98581 5.6514e-06
1.48078 5.6514e-06
1.77288 5.6514e-06
1.32658 5.6514e-06
1.69655 5.6514e-06
4.29496 5.6514e-06
5.03734 5.6514e-06
END
$hits5 << END
2.20897 0.00662231
2.55984 0.00582886
2.73372 0.0233154
3.22156 0.00971985
2.97087 0.021698
3.63718 0.0115967
1.87865 0.00662231
2.40828 0.00582886
1.92697 0.0233154
2.14379 0.00970459
2.20621 0.021698
2.51067 0.0115967
2.08925 0.00762939
2.33701 0.00596619
1.57108 0.0183716
1.89456 0.0168762
1.45501 0.0166779
1.79753 0.0120697
4.67385 0.0159454
5.1471 0.00816345
END
$hits_front << END
5.03734 5.6514e-06
5.1471 0.00816345
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
set xrange [4.78658:37.5266]; set yrange [3.11188e-05:0.137365]
set xlabel 'pictures a second  (more is better)'; set ylabel 'picture: RMSE of a channel  (less is better)' offset -1.5
set xtics ('5' 5, '7' 7, '10' 10, '15' 15, '20' 20, '30' 30)
set ytics ("same\nbits" 7.7797e-05, '10⁻³' 1e-3, '10⁻²' 1e-2, '10⁻¹' 1e-1)
set object rectangle from graph 0, graph 0 to graph 1, first 0.000132255 fs solid noborder fc rgb '#eeeeee' behind
set arrow from first 31.2722,0.0277958 to graph 1.0,0.8096 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.8096 to graph 1.015,0.8096 nohead lw 0.8 lc rgb '#999999'
set label 'double, study: irregular exact' at graph 1.02,0.8096 left
set arrow from first 29.4577,5.76274e-05 to graph 1.0,0.0734 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.0734 to graph 1.015,0.0734 nohead lw 0.8 lc rgb '#999999'
set label 'double: irregular exact' at graph 1.02,0.0734 left
$picture0 << END
9.52435 0.0245371
11.4049 0.0245371
15.9565 0.0245371
23.2434 0.0245371
15.6636 0.0245371
23.7545 0.0245371
9.46772 0.0245371
11.5769 0.0245371
13.065 0.0245371
17.7804 0.0245371
14.6517 0.0245371
19.7375 0.0245371
9.52807 0.0245371
11.5368 0.0245371
8.32092 0.0245371
10.9989 0.0245371
7.72929 0.0245371
8.90996 0.0245371
22.1189 0.0245371
28.9948 0.0245371
END
$picture1 << END
9.31932 0.0325512
11.6215 0.0309071
16.8672 0.0549459
23.8083 0.0378821
16.3997 0.0510349
24.5901 0.0400682
9.68908 0.0325512
11.6751 0.0309071
13.7316 0.0549459
17.8923 0.0378821
13.2938 0.0510349
20.0829 0.0400682
9.52644 0.032554
11.6189 0.0309071
8.5197 0.0430485
10.903 0.0427337
7.73365 0.0450922
10.471 0.0387855
23.0803 0.0460561
30.0906 0.036609
END
$picture2 << END
11.4562 0.000622376
12.8123 0.000622376
16.512 0.000622376
22.4356 0.000622376
17.4277 0.000622376
23.288 0.000622376
11.5667 0.000622376
13.1351 0.000622376
13.6375 0.000622376
17.2204 0.000622376
14.9254 0.000622376
18.195 0.000622376
11.4323 0.000622376
13.2742 0.000622376
11.1803 0.000622376
13.4178 0.000622376
9.97466 0.000622376
12.7037 0.000622376
24.0672 0.000622376
28.2473 0.000622376
5.74389 0.000622376
23.0861 0.000622376
16.9422 0.000622376
19.0409 0.000622376
END
$picture3 << END
11.9172 0.0224824
13.7751 0.0197051
17.8764 0.0500996
22.9448 0.0290847
18.4406 0.045743
24.6634 0.032335
11.962 0.0224824
13.6515 0.0197051
14.5405 0.0500996
17.4992 0.0290847
15.9322 0.045743
19.7091 0.032335
12.0374 0.0224865
13.6819 0.0197051
11.5442 0.0360748
13.9651 0.0357277
10.3925 0.0385456
13.0732 0.0307357
25.6219 0.040044
30.0122 0.0278026
END
$picture4 << END
14.9142 5.76274e-05
15.6396 5.76274e-05
17.9021 5.76274e-05
22.6657 5.76274e-05
18.3876 5.76274e-05
24.5178 5.76274e-05
14.7015 5.76274e-05
16.3824 5.76274e-05
14.1412 5.76274e-05
16.7286 5.76274e-05
15.5037 5.76274e-05
19.4944 5.76274e-05
14.6505 5.76274e-05
15.7748 5.76274e-05
12.8155 5.76274e-05
15.4106 5.76274e-05
12.0289 5.76274e-05
14.4872 5.76274e-05
25.8248 5.76274e-05
29.4577 5.76274e-05
END
$picture5 << END
15.3479 0.0224738
17.6718 0.0196934
19.286 0.0500977
23.4791 0.0290847
20.2169 0.0457408
25.4249 0.0323289
13.4668 0.0224738
14.8552 0.0196934
14.658 0.0500977
17.268 0.0290894
16.9575 0.0457408
19.9854 0.0323289
15.0631 0.0224779
16.9637 0.0196934
13.5033 0.0360477
15.9452 0.0358389
12.3992 0.0385421
14.964 0.0307286
27.4443 0.0400428
31.2722 0.0277958
END
$picture_front << END
29.4577 5.76274e-05
31.2722 0.0277958
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
set xrange [0.62153:6.17652]; set yrange [3.05176e-06:0.0588608]
set xlabel 'million nearest hits a second  (more is better)'; set ylabel 'wrong hits  (less is better)' offset -1.5
set label 'rings: speed against accuracy (CPU, 2 threads)' at screen 0.02, screen 0.9774 font ',20'
set label '256x256 primary and 65,536 random rays a scene; 65,536 in all compared with brute force in double; pictures of 128x128' at screen 0.02, screen 0.9516
set xtics ('0.7' 0.7, '1' 1, '1.5' 1.5, '2' 2, '3' 3, '5' 5)
set ytics ("none of\n65,536" 7.62939e-06, '0.01 %%' 1e-4, '0.1 %%' 1e-3, '1 %%' 1e-2)
set object rectangle from graph 0, graph 0 to graph 1, first 1.297e-05 fs solid noborder fc rgb '#eeeeee' behind
set arrow from first 5.1471,0.00816345 to graph 1.0,0.7998 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.7998 to graph 1.015,0.7998 nohead lw 0.8 lc rgb '#999999'
set label 'double, study: irregular exact' at graph 1.02,0.7998 left
set arrow from first 5.03734,5.6514e-06 to graph 1.0,0.0624 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.0624 to graph 1.015,0.0624 nohead lw 0.8 lc rgb '#999999'
set label 'double: irregular exact' at graph 1.02,0.0624 left
$hits0 << END
1.20764 0.000259399
1.46687 0.000259399
1.91014 0.000259399
2.70174 0.000259399
2.07016 0.000259399
3.20495 0.000259399
1.19534 0.000259399
1.49012 0.000259399
1.62447 0.000259399
2.03465 0.000259399
1.78143 0.000259399
2.3879 0.000259399
1.18044 0.000259399
1.46722 0.000259399
0.855196 0.000259399
1.1489 0.000259399
0.80521 0.000259399
1.02106 0.000259399
3.49389 0.000259399
4.58288 0.000259399
END
$hits1 << END
1.18065 0.00686646
1.49247 0.00610352
2.27279 0.0235443
2.99246 0.00991821
2.22604 0.0219116
3.32898 0.0118256
1.21919 0.00686646
1.50408 0.00610352
1.73572 0.0235443
2.1662 0.00991821
1.88531 0.0219116
2.51303 0.0118256
1.21315 0.00785828
1.47628 0.00624084
0.880852 0.0185242
1.17042 0.0170288
0.832603 0.0169067
1.10216 0.0122986
3.65415 0.0161591
4.85522 0.00840759
END
$hits2 << END
1.52509 7.62939e-06
1.79774 7.62939e-06
2.3418 7.62939e-06
3.03131 7.62939e-06
2.22832 7.62939e-06
3.30227 7.62939e-06
1.50934 7.62939e-06
1.79773 7.62939e-06
1.73963 7.62939e-06
2.1041 7.62939e-06
1.95299 7.62939e-06
2.30496 7.62939e-06
1.51326 7.62939e-06
1.79994 7.62939e-06
1.22909 7.62939e-06
1.53725 7.62939e-06
1.15174 7.62939e-06
1.45853 7.62939e-06
3.93457 7.62939e-06
4.84323 7.62939e-06
0.745836 7.62939e-06
3.38374 7.62939e-06
2.12292 7.62939e-06
2.59483 7.62939e-06
END
$hits3 << END
1.606 0.00662231
1.93673 0.00582886
2.58373 0.0233154
3.1268 0.00970459
2.70004 0.021698
3.52264 0.0115967
1.63333 0.00662231
1.92181 0.00582886
1.84376 0.0233154
2.16619 0.00970459
2.11318 0.021698
2.55153 0.0115967
1.61623 0.00762939
1.88488 0.00596619
1.31691 0.0183563
1.61792 0.016861
1.21326 0.0166779
1.52515 0.0120697
4.24117 0.0159454
5.06876 0.00816345
END
$hits4 << END
1.98431 5.6514e-06
2.40919 5.6514e-06
2.46724 5.6514e-06
3.02067 5.6514e-06
2.49264 5.6514e-06
3.42338 5.6514e-06
1.99307 5.6514e-06
2.30282 5.6514e-06
1.7665 5.6514e-06
2.00258 5.6514e-06
1.7586 5.6514e-06
2.44942 5.6514e-06
1.97954 5.6514e-06
1.98581 5.6514e-06
1.48078 5.6514e-06
1.77288 5.6514e-06
1.32658 5.6514e-06
1.69655 5.6514e-06
4.29496 5.6514e-06
5.03734 5.6514e-06
END
$hits5 << END
2.20897 0.00662231
2.55984 0.00582886
2.73372 0.0233154
3.22156 0.00971985
2.97087 0.021698
3.63718 0.0115967
1.87865 0.00662231
2.40828 0.00582886
1.92697 0.0233154
2.14379 0.00970459
2.20621 0.021698
2.51067 0.0115967
2.08925 0.00762939
2.33701 0.00596619
1.57108 0.0183716
1.89456 0.0168762
1.45501 0.0166779
1.79753 0.0120697
4.67385 0.0159454
5.1471 0.00816345
END
$hits_front << END
5.03734 5.6514e-06
5.1471 0.00816345
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
set xrange [4.78658:37.5266]; set yrange [3.11188e-05:0.137365]
set xlabel 'pictures a second  (more is better)'; set ylabel 'picture: RMSE of a channel  (less is better)' offset -1.5
set xtics ('5' 5, '7' 7, '10' 10, '15' 15, '20' 20, '30' 30)
set ytics ("same\nbits" 7.7797e-05, '10⁻³' 1e-3, '10⁻²' 1e-2, '10⁻¹' 1e-1)
set object rectangle from graph 0, graph 0 to graph 1, first 0.000132255 fs solid noborder fc rgb '#eeeeee' behind
set arrow from first 31.2722,0.0277958 to graph 1.0,0.8096 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.8096 to graph 1.015,0.8096 nohead lw 0.8 lc rgb '#999999'
set label 'double, study: irregular exact' at graph 1.02,0.8096 left
set arrow from first 29.4577,5.76274e-05 to graph 1.0,0.0734 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.0734 to graph 1.015,0.0734 nohead lw 0.8 lc rgb '#999999'
set label 'double: irregular exact' at graph 1.02,0.0734 left
$picture0 << END
9.52435 0.0245371
11.4049 0.0245371
15.9565 0.0245371
23.2434 0.0245371
15.6636 0.0245371
23.7545 0.0245371
9.46772 0.0245371
11.5769 0.0245371
13.065 0.0245371
17.7804 0.0245371
14.6517 0.0245371
19.7375 0.0245371
9.52807 0.0245371
11.5368 0.0245371
8.32092 0.0245371
10.9989 0.0245371
7.72929 0.0245371
8.90996 0.0245371
22.1189 0.0245371
28.9948 0.0245371
END
$picture1 << END
9.31932 0.0325512
11.6215 0.0309071
16.8672 0.0549459
23.8083 0.0378821
16.3997 0.0510349
24.5901 0.0400682
9.68908 0.0325512
11.6751 0.0309071
13.7316 0.0549459
17.8923 0.0378821
13.2938 0.0510349
20.0829 0.0400682
9.52644 0.032554
11.6189 0.0309071
8.5197 0.0430485
10.903 0.0427337
7.73365 0.0450922
10.471 0.0387855
23.0803 0.0460561
30.0906 0.036609
END
$picture2 << END
11.4562 0.000622376
12.8123 0.000622376
16.512 0.000622376
22.4356 0.000622376
17.4277 0.000622376
23.288 0.000622376
11.5667 0.000622376
13.1351 0.000622376
13.6375 0.000622376
17.2204 0.000622376
14.9254 0.000622376
18.195 0.000622376
11.4323 0.000622376
13.2742 0.000622376
11.1803 0.000622376
13.4178 0.000622376
9.97466 0.000622376
12.7037 0.000622376
24.0672 0.000622376
28.2473 0.000622376
5.74389 0.000622376
23.0861 0.000622376
16.9422 0.000622376
19.0409 0.000622376
END
$picture3 << END
11.9172 0.0224824
13.7751 0.0197051
17.8764 0.0500996
22.9448 0.0290847
18.4406 0.045743
24.6634 0.032335
11.962 0.0224824
13.6515 0.0197051
14.5405 0.0500996
17.4992 0.0290847
15.9322 0.045743
19.7091 0.032335
12.0374 0.0224865
13.6819 0.0197051
11.5442 0.0360748
13.9651 0.0357277
10.3925 0.0385456
13.0732 0.0307357
25.6219 0.040044
30.0122 0.0278026
END
$picture4 << END
14.9142 5.76274e-05
15.6396 5.76274e-05
17.9021 5.76274e-05
22.6657 5.76274e-05
18.3876 5.76274e-05
24.5178 5.76274e-05
14.7015 5.76274e-05
16.3824 5.76274e-05
14.1412 5.76274e-05
16.7286 5.76274e-05
15.5037 5.76274e-05
19.4944 5.76274e-05
14.6505 5.76274e-05
15.7748 5.76274e-05
12.8155 5.76274e-05
15.4106 5.76274e-05
12.0289 5.76274e-05
14.4872 5.76274e-05
25.8248 5.76274e-05
29.4577 5.76274e-05
END
$picture5 << END
15.3479 0.0224738
17.6718 0.0196934
19.286 0.0500977
23.4791 0.0290847
20.2169 0.0457408
25.4249 0.0323289
13.4668 0.0224738
14.8552 0.0196934
14.658 0.0500977
17.268 0.0290894
16.9575 0.0457408
19.9854 0.0323289
15.0631 0.0224779
16.9637 0.0196934
13.5033 0.0360477
15.9452 0.0358389
12.3992 0.0385421
14.964 0.0307286
27.4443 0.0400428
31.2722 0.0277958
END
$picture_front << END
29.4577 5.76274e-05
31.2722 0.0277958
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
set xrange [0.710753:18.9485]; set yrange [3.05176e-06:0.0325012]
set xlabel 'million nearest hits a second  (more is better)'; set ylabel 'wrong hits  (less is better)' offset -1.5
set label 'tree: speed against accuracy (CPU, 2 threads)' at screen 0.02, screen 0.9774 font ',20'
set label '256x256 primary and 65,536 random rays a scene; 65,536 in all compared with brute force in double; pictures of 128x128' at screen 0.02, screen 0.9516
set xtics ('1' 1, '2' 2, '5' 5, '10' 10)
set ytics ("none of\n65,536" 7.62939e-06, '0.01 %%' 1e-4, '0.1 %%' 1e-3, '1 %%' 1e-2)
set object rectangle from graph 0, graph 0 to graph 1, first 1.297e-05 fs solid noborder fc rgb '#eeeeee' behind
set arrow from first 15.7904,0.01297 to graph 1.0,0.9899 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.9899 to graph 1.015,0.9899 nohead lw 0.8 lc rgb '#999999'
set label 'fast, study: irregular exact' at graph 1.02,0.9899 left
set arrow from first 13.743,0.011734 to graph 1.0,0.9399 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.9399 to graph 1.015,0.9399 nohead lw 0.8 lc rgb '#999999'
set label 'robust, study: irregular box' at graph 1.02,0.9399 left
set arrow from first 13.682,0.0117035 to graph 1.0,0.8899 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.8899 to graph 1.015,0.8899 nohead lw 0.8 lc rgb '#999999'
set label 'robust, study: irregular exact' at graph 1.02,0.8899 left
set arrow from first 12.2363,7.62939e-06 to graph 1.0,0.0988 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.0988 to graph 1.015,0.0988 nohead lw 0.8 lc rgb '#999999'
set label 'robust: irregular exact' at graph 1.02,0.0988 left
$hits0 << END
2.25718 0.00125122
2.69874 0.00125122
1.27287 0.00125122
1.33843 0.00125122
2.33915 0.00125122
2.5784 0.00125122
11.1497 0.00125122
11.6437 0.00125122
END
$hits1 << END
2.66891 0.00257874
2.79709 0.0022583
1.37642 0.00257874
1.43012 0.0022583
2.39047 0.00180054
2.58252 0.00158691
14.6231 0.0130005
15.7904 0.01297
END
$hits2 << END
2.46488 7.62939e-06
2.79292 7.62939e-06
1.30518 7.62939e-06
1.38827 7.62939e-06
2.75303 7.62939e-06
2.98796 7.62939e-06
11.5293 7.62939e-06
12.2363 7.62939e-06
1.53787 7.62939e-06
2.1979 7.62939e-06
END
$hits3 << END
2.87053 0.00132751
2.98455 0.00100708
1.42213 0.00132751
1.44499 0.00100708
2.76106 0.000564575
2.96195 0.000350952
13.743 0.011734
13.682 0.0117035
END
$hits4 << END
0.902084 5.6514e-06
0.932235 5.6514e-06
2.70411 5.6514e-06
2.82339 5.6514e-06
0.852904 5.6514e-06
0.854117 5.6514e-06
1.31202 5.6514e-06
1.3571 5.6514e-06
0.911159 5.6514e-06
0.959304 5.6514e-06
3.15034 5.6514e-06
3.24077 5.6514e-06
11.3063 5.6514e-06
11.7922 5.6514e-06
END
$hits5 << END
0.921964 0.000823975
0.942135 0.000930786
3.0849 0.00132751
3.12798 0.00100708
0.853073 0.000823975
0.876795 0.000930786
1.49317 0.00132751
1.51376 0.00100708
0.969216 0.000823975
0.979988 0.000793457
3.04738 0.000564575
3.26138 0.000350952
12.9232 0.011734
13.0429 0.0117035
END
$hits_front << END
12.2363 7.62939e-06
13.682 0.0117035
13.743 0.011734
15.7904 0.01297
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
set xrange [4.11084:136.573]; set yrange [5.2625e-05:0.10563]
set xlabel 'pictures a second  (more is better)'; set ylabel 'picture: RMSE of a channel  (less is better)' offset -1.5
set xtics ('5' 5, '10' 10, '20' 20, '50' 50, '100' 100)
set ytics ("same\nbits" 0.000131563, '10⁻³' 1e-3, '10⁻²' 1e-2, '10⁻¹' 1e-1)
set object rectangle from graph 0, graph 0 to graph 1, first 0.000223656 fs solid noborder fc rgb '#eeeeee' behind
set arrow from first 113.811,0.042252 to graph 1.0,0.9295 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.9295 to graph 1.015,0.9295 nohead lw 0.8 lc rgb '#999999'
set label 'fast, study: irregular box' at graph 1.02,0.9295 left
set arrow from first 110.632,0.0422346 to graph 1.0,0.8795 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.8795 to graph 1.015,0.8795 nohead lw 0.8 lc rgb '#999999'
set label 'fast, study: irregular exact' at graph 1.02,0.8795 left
set arrow from first 105.23,0.0196098 to graph 1.0,0.7786 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.7786 to graph 1.015,0.7786 nohead lw 0.8 lc rgb '#999999'
set label 'fast: irregular exact' at graph 1.02,0.7786 left
set arrow from first 96.4683,0.0010525 to graph 1.0,0.3939 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.3939 to graph 1.015,0.3939 nohead lw 0.8 lc rgb '#999999'
set label 'robust: irregular exact' at graph 1.02,0.3939 left
set arrow from first 93.1949,9.74537e-05 to graph 1.0,0.0810 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.0810 to graph 1.015,0.0810 nohead lw 0.8 lc rgb '#999999'
set label 'double: irregular exact' at graph 1.02,0.0810 left
$picture0 << END
25.4378 0.0196098
23.8777 0.0196098
11.7128 0.0196098
12.2229 0.0196098
17.4915 0.0196098
19.936 0.0196098
99.1444 0.0196098
105.23 0.0196098
END
$picture1 << END
26.9848 0.0207304
28.5408 0.0205941
11.9281 0.0207304
12.4352 0.0205941
17.7972 0.0198815
19.8314 0.0197756
113.811 0.042252
110.632 0.0422346
END
$picture2 << END
25.1181 0.0010525
27.3715 0.0010525
11.515 0.0010525
12.1314 0.0010525
21.7003 0.0010525
22.7429 0.0010525
89.0551 0.0010525
96.4683 0.0010525
7.73455 0.0010525
12.0368 0.0010525
END
$picture3 << END
26.5472 0.00698046
28.2131 0.0064093
11.7047 0.00698046
12.2513 0.0064093
21.2475 0.00375491
22.7282 0.00280699
92.8333 0.0374531
98.342 0.0374263
END
$picture4 << END
5.8339 9.74537e-05
6.13926 9.74537e-05
26.5671 9.74537e-05
28.7214 9.74537e-05
5.10743 9.74537e-05
5.17406 9.74537e-05
11.6266 9.74537e-05
11.817 9.74537e-05
5.82303 9.74537e-05
6.19026 9.74537e-05
23.6726 9.74537e-05
25.0344 9.74537e-05
88.0786 9.74537e-05
93.1949 9.74537e-05
END
$picture5 << END
5.91919 0.00379718
6.06586 0.00453988
27.8347 0.00690066
28.9498 0.00632229
4.93301 0.00379718
5.13163 0.00453988
11.659 0.00690066
11.8447 0.00632229
6.08843 0.00379718
6.18686 0.00391266
23.6251 0.00360438
25.1519 0.0026022
89.769 0.0374423
96.2094 0.0374155
END
$picture_front << END
93.1949 9.74537e-05
96.4683 0.0010525
105.23 0.0196098
110.632 0.0422346
113.811 0.042252
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
set xrange [0.710753:18.9485]; set yrange [3.05176e-06:0.0325012]
set xlabel 'million nearest hits a second  (more is better)'; set ylabel 'wrong hits  (less is better)' offset -1.5
set label 'tree: speed against accuracy (CPU, 2 threads)' at screen 0.02, screen 0.9774 font ',20'
set label '256x256 primary and 65,536 random rays a scene; 65,536 in all compared with brute force in double; pictures of 128x128' at screen 0.02, screen 0.9516
set xtics ('1' 1, '2' 2, '5' 5, '10' 10)
set ytics ("none of\n65,536" 7.62939e-06, '0.01 %%' 1e-4, '0.1 %%' 1e-3, '1 %%' 1e-2)
set object rectangle from graph 0, graph 0 to graph 1, first 1.297e-05 fs solid noborder fc rgb '#eeeeee' behind
set arrow from first 15.7904,0.01297 to graph 1.0,0.9899 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.9899 to graph 1.015,0.9899 nohead lw 0.8 lc rgb '#999999'
set label 'fast, study: irregular exact' at graph 1.02,0.9899 left
set arrow from first 13.743,0.011734 to graph 1.0,0.9399 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.9399 to graph 1.015,0.9399 nohead lw 0.8 lc rgb '#999999'
set label 'robust, study: irregular box' at graph 1.02,0.9399 left
set arrow from first 13.682,0.0117035 to graph 1.0,0.8899 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.8899 to graph 1.015,0.8899 nohead lw 0.8 lc rgb '#999999'
set label 'robust, study: irregular exact' at graph 1.02,0.8899 left
set arrow from first 12.2363,7.62939e-06 to graph 1.0,0.0988 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.0988 to graph 1.015,0.0988 nohead lw 0.8 lc rgb '#999999'
set label 'robust: irregular exact' at graph 1.02,0.0988 left
$hits0 << END
2.25718 0.00125122
2.69874 0.00125122
1.27287 0.00125122
1.33843 0.00125122
2.33915 0.00125122
2.5784 0.00125122
11.1497 0.00125122
11.6437 0.00125122
END
$hits1 << END
2.66891 0.00257874
2.79709 0.0022583
1.37642 0.00257874
1.43012 0.0022583
2.39047 0.00180054
2.58252 0.00158691
14.6231 0.0130005
15.7904 0.01297
END
$hits2 << END
2.46488 7.62939e-06
2.79292 7.62939e-06
1.30518 7.62939e-06
1.38827 7.62939e-06
2.75303 7.62939e-06
2.98796 7.62939e-06
11.5293 7.62939e-06
12.2363 7.62939e-06
1.53787 7.62939e-06
2.1979 7.62939e-06
END
$hits3 << END
2.87053 0.00132751
2.98455 0.00100708
1.42213 0.00132751
1.44499 0.00100708
2.76106 0.000564575
2.96195 0.000350952
13.743 0.011734
13.682 0.0117035
END
$hits4 << END
0.902084 5.6514e-06
0.932235 5.6514e-06
2.70411 5.6514e-06
2.82339 5.6514e-06
0.852904 5.6514e-06
0.854117 5.6514e-06
1.31202 5.6514e-06
1.3571 5.6514e-06
0.911159 5.6514e-06
0.959304 5.6514e-06
3.15034 5.6514e-06
3.24077 5.6514e-06
11.3063 5.6514e-06
11.7922 5.6514e-06
END
$hits5 << END
0.921964 0.000823975
0.942135 0.000930786
3.0849 0.00132751
3.12798 0.00100708
0.853073 0.000823975
0.876795 0.000930786
1.49317 0.00132751
1.51376 0.00100708
0.969216 0.000823975
0.979988 0.000793457
3.04738 0.000564575
3.26138 0.000350952
12.9232 0.011734
13.0429 0.0117035
END
$hits_front << END
12.2363 7.62939e-06
13.682 0.0117035
13.743 0.011734
15.7904 0.01297
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
set xrange [4.11084:136.573]; set yrange [5.2625e-05:0.10563]
set xlabel 'pictures a second  (more is better)'; set ylabel 'picture: RMSE of a channel  (less is better)' offset -1.5
set xtics ('5' 5, '10' 10, '20' 20, '50' 50, '100' 100)
set ytics ("same\nbits" 0.000131563, '10⁻³' 1e-3, '10⁻²' 1e-2, '10⁻¹' 1e-1)
set object rectangle from graph 0, graph 0 to graph 1, first 0.000223656 fs solid noborder fc rgb '#eeeeee' behind
set arrow from first 113.811,0.042252 to graph 1.0,0.9295 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.9295 to graph 1.015,0.9295 nohead lw 0.8 lc rgb '#999999'
set label 'fast, study: irregular box' at graph 1.02,0.9295 left
set arrow from first 110.632,0.0422346 to graph 1.0,0.8795 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.8795 to graph 1.015,0.8795 nohead lw 0.8 lc rgb '#999999'
set label 'fast, study: irregular exact' at graph 1.02,0.8795 left
set arrow from first 105.23,0.0196098 to graph 1.0,0.7786 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.7786 to graph 1.015,0.7786 nohead lw 0.8 lc rgb '#999999'
set label 'fast: irregular exact' at graph 1.02,0.7786 left
set arrow from first 96.4683,0.0010525 to graph 1.0,0.3939 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.3939 to graph 1.015,0.3939 nohead lw 0.8 lc rgb '#999999'
set label 'robust: irregular exact' at graph 1.02,0.3939 left
set arrow from first 93.1949,9.74537e-05 to graph 1.0,0.0810 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.0810 to graph 1.015,0.0810 nohead lw 0.8 lc rgb '#999999'
set label 'double: irregular exact' at graph 1.02,0.0810 left
$picture0 << END
25.4378 0.0196098
23.8777 0.0196098
11.7128 0.0196098
12.2229 0.0196098
17.4915 0.0196098
19.936 0.0196098
99.1444 0.0196098
105.23 0.0196098
END
$picture1 << END
26.9848 0.0207304
28.5408 0.0205941
11.9281 0.0207304
12.4352 0.0205941
17.7972 0.0198815
19.8314 0.0197756
113.811 0.042252
110.632 0.0422346
END
$picture2 << END
25.1181 0.0010525
27.3715 0.0010525
11.515 0.0010525
12.1314 0.0010525
21.7003 0.0010525
22.7429 0.0010525
89.0551 0.0010525
96.4683 0.0010525
7.73455 0.0010525
12.0368 0.0010525
END
$picture3 << END
26.5472 0.00698046
28.2131 0.0064093
11.7047 0.00698046
12.2513 0.0064093
21.2475 0.00375491
22.7282 0.00280699
92.8333 0.0374531
98.342 0.0374263
END
$picture4 << END
5.8339 9.74537e-05
6.13926 9.74537e-05
26.5671 9.74537e-05
28.7214 9.74537e-05
5.10743 9.74537e-05
5.17406 9.74537e-05
11.6266 9.74537e-05
11.817 9.74537e-05
5.82303 9.74537e-05
6.19026 9.74537e-05
23.6726 9.74537e-05
25.0344 9.74537e-05
88.0786 9.74537e-05
93.1949 9.74537e-05
END
$picture5 << END
5.91919 0.00379718
6.06586 0.00453988
27.8347 0.00690066
28.9498 0.00632229
4.93301 0.00379718
5.13163 0.00453988
11.659 0.00690066
11.8447 0.00632229
6.08843 0.00379718
6.18686 0.00391266
23.6251 0.00360438
25.1519 0.0026022
89.769 0.0374423
96.2094 0.0374155
END
$picture_front << END
93.1949 9.74537e-05
96.4683 0.0010525
105.23 0.0196098
110.632 0.0422346
113.811 0.042252
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
set xrange [0.494293:8.70418]; set yrange [4.35965e-07:0.0195639]
set xlabel 'million nearest hits a second  (more is better)'; set ylabel 'wrong hits  (less is better)' offset -1.5
set label 'mean of 7 scenes: speed against accuracy (CPU, 2 threads)' at screen 0.02, screen 0.9774 font ',20'
set label '256x256 primary and 65,536 random rays a scene; 458,752 in all compared with brute force in double; pictures of 128x128' at screen 0.02, screen 0.9516
set xtics ('0.5' 0.5, '0.7' 0.7, '1' 1, '1.5' 1.5, '2' 2, '3' 3, '5' 5, '7' 7)
set ytics ("none of\n458,752" 1.08991e-06, '0.001 %%' 1e-5, '0.01 %%' 1e-4, '0.1 %%' 1e-3, '1 %%' 1e-2)
set object rectangle from graph 0, graph 0 to graph 1, first 1.85285e-06 fs solid noborder fc rgb '#eeeeee' behind
set arrow from first 7.25349,0.00327192 to graph 1.0,0.8330 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.8330 to graph 1.015,0.8330 nohead lw 0.8 lc rgb '#999999'
set label 'fast, study: irregular exact' at graph 1.02,0.8330 left
set arrow from first 7.24643,1.08991e-06 to graph 1.0,0.0855 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.0855 to graph 1.015,0.0855 nohead lw 0.8 lc rgb '#999999'
set label 'robust: irregular exact' at graph 1.02,0.0855 left
$hits0 << END
1.11257 0.000233241
1.2124 0.000233241
1.87067 0.000233241
1.93186 0.000233241
2.96441 0.000233241
3.40374 0.000233241
1.24619 0.000233241
1.20953 0.000233241
1.21718 0.000233241
1.48212 0.000233241
2.15862 0.000233241
2.31966 0.000233241
1.26764 0.000233241
1.34506 0.000233241
1.36207 0.000233241
1.37598 0.000233241
1.99905 0.000233241
1.91091 0.000233241
5.83441 0.000233241
5.83604 0.000233241
END
$hits1 << END
0.8913 0.00527518
0.961659 0.00514439
1.91022 0.00782558
1.99653 0.00444249
3.04976 0.00572641
3.40437 0.00240871
0.861423 0.00527518
0.948678 0.00514439
1.26554 0.00782558
1.40366 0.00444249
2.16086 0.00572641
2.41387 0.00240871
0.952196 0.00543431
1.01637 0.00517709
1.24695 0.00716073
1.12868 0.00560652
1.65343 0.00575692
1.47695 0.00289699
5.91411 0.00581578
7.25349 0.00327192
END
$hits2 << END
1.13557 1.08991e-06
1.1563 1.08991e-06
1.68874 1.08991e-06
1.95595 1.08991e-06
2.75952 1.08991e-06
3.59953 1.08991e-06
1.11076 1.08991e-06
1.13518 1.08991e-06
1.31112 1.08991e-06
1.57876 1.08991e-06
2.39209 1.08991e-06
2.4692 1.08991e-06
1.16191 1.08991e-06
1.20017 1.08991e-06
1.3747 1.08991e-06
1.38285 1.08991e-06
2.0087 1.08991e-06
1.84747 1.08991e-06
5.43703 1.08991e-06
7.24643 1.08991e-06
0.593151 1.08991e-06
1.61347 1.08991e-06
1.42212 1.08991e-06
2.03436 1.08991e-06
END
$hits3 << END
0.902496 0.00504848
0.892362 0.00491333
1.8424 0.00759888
1.93496 0.00421797
3.01602 0.00550188
3.19661 0.00217983
0.857823 0.00504848
0.851424 0.00491333
1.3289 0.00759888
1.63092 0.00421797
2.15234 0.00550188
2.67257 0.00217983
0.934497 0.00520979
0.999873 0.00494603
1.35553 0.00694275
0.968665 0.00538853
1.80978 0.0055324
1.79921 0.00267029
6.36139 0.00558908
6.18454 0.00303868
END
$hits4 << END
1.12488 8.07343e-07
1.22501 8.07343e-07
2.04081 8.07343e-07
1.88075 8.07343e-07
2.91117 8.07343e-07
3.20561 8.07343e-07
1.18866 8.07343e-07
1.28088 8.07343e-07
1.4275 8.07343e-07
1.55841 8.07343e-07
2.06812 8.07343e-07
2.37116 8.07343e-07
1.25484 8.07343e-07
1.31964 8.07343e-07
1.60913 8.07343e-07
1.34201 8.07343e-07
2.01606 8.07343e-07
2.09352 8.07343e-07
5.532 8.07343e-07
5.71782 8.07343e-07
END
$hits5 << END
1.06826 0.00504848
1.18059 0.00491333
2.11015 0.00759888
2.02931 0.00422015
3.0916 0.00550188
3.36521 0.00217983
1.11835 0.00504848
1.10961 0.00491333
1.53396 0.00759888
1.76964 0.00421797
2.48535 0.00550188
2.67137 0.00217983
1.17488 0.00520979
1.21524 0.00494603
1.61311 0.00694493
1.18804 0.00539071
1.95567 0.0055324
1.95182 0.00267029
6.38538 0.00558908
6.01169 0.00303868
END
$hits_front << END
7.24643 1.08991e-06
7.25349 0.00327192
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
set xrange [4.3839:76.5062]; set yrange [4.86967e-05:0.0711001]
set xlabel 'pictures a second  (more is better)'; set ylabel 'picture: RMSE of a channel  (less is better)' offset -1.5
set xtics ('5' 5, '7' 7, '10' 10, '15' 15, '20' 20, '30' 30, '50' 50, '70' 70)
set ytics ("same\nbits" 0.000121742, '10⁻³' 1e-3, '10⁻²' 1e-2)
set object rectangle from graph 0, graph 0 to graph 1, first 0.000206961 fs solid noborder fc rgb '#eeeeee' behind
set arrow from first 63.7552,0.000973934 to graph 1.0,0.4111 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.4111 to graph 1.015,0.4111 nohead lw 0.8 lc rgb '#999999'
set label 'robust: irregular exact' at graph 1.02,0.4111 left
set arrow from first 54.925,9.01791e-05 to graph 1.0,0.0846 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.0846 to graph 1.015,0.0846 nohead lw 0.8 lc rgb '#999999'
set label 'double: irregular exact' at graph 1.02,0.0846 left
$picture0 << END
12.438 0.0125231
12.483 0.0125231
18.9902 0.0125231
19.9601 0.0125231
33.8002 0.0125231
43.5842 0.0125231
13.3062 0.0125231
12.9299 0.0125231
14.06 0.0125231
15.4815 0.0125231
25.9668 0.0125231
25.612 0.0125231
12.941 0.0125231
14.2527 0.0125231
17.7719 0.0125231
15.3304 0.0125231
23.0915 0.0125231
22.8548 0.0125231
61.3925 0.0125231
60.0848 0.0125231
END
$picture1 << END
11.5969 0.0226732
11.1005 0.022294
19.6663 0.02844
22.5285 0.0216674
33.6284 0.0243876
40.512 0.0182106
11.6728 0.0226732
12.4023 0.022294
16.2001 0.02844
16.9215 0.0216674
24.7743 0.0243876
33.8626 0.0182106
11.951 0.0226738
13.1173 0.022294
15.8485 0.025308
14.6906 0.0228528
21.655 0.0237599
21.5146 0.0184314
55.9323 0.0261916
59.7869 0.0218031
END
$picture2 << END
10.1345 0.000973934
10.6164 0.000973934
17.9565 0.000973934
20.1843 0.000973934
33.3581 0.000973934
37.2549 0.000973934
10.7946 0.000973934
10.7587 0.000973934
13.3229 0.000973934
17.6894 0.000973934
24.2791 0.000973934
25.2524 0.000973934
10.0567 0.000973934
11.2187 0.000973934
13.8965 0.000973934
12.5455 0.000973934
20.513 0.000973934
21.3832 0.000973934
54.2401 0.000973934
63.7552 0.000973934
5.26067 0.000973934
16.9887 0.000973934
17.8828 0.000973934
17.4013 0.000973934
END
$picture3 << END
8.37699 0.0192262
8.62034 0.0187285
18.3347 0.0258923
19.0813 0.0178553
32.3422 0.0212966
32.2575 0.0134852
8.96713 0.0192262
10.0784 0.0187285
15.1381 0.0258923
16.3559 0.0178553
24.7544 0.0212966
29.1533 0.0134852
9.62152 0.0192269
10.1916 0.0187285
13.9179 0.0222704
11.8239 0.0194222
19.0815 0.0204616
18.8635 0.0137798
50.8098 0.0233081
52.7164 0.0179993
END
$picture4 << END
11.3946 9.01791e-05
11.4714 9.01791e-05
20.9551 9.01791e-05
22.7838 9.01791e-05
35.4153 9.01791e-05
33.2886 9.01791e-05
11.7532 9.01791e-05
10.3931 9.01791e-05
15.6412 9.01791e-05
16.9262 9.01791e-05
24.8347 9.01791e-05
27.4396 9.01791e-05
12.7606 9.01791e-05
13.7985 9.01791e-05
17.2012 9.01791e-05
12.9246 9.01791e-05
20.9017 9.01791e-05
21.5788 9.01791e-05
49.7256 9.01791e-05
54.925 9.01791e-05
END
$picture5 << END
10.7984 0.0192032
12.3848 0.0187046
20.8328 0.0258798
21.6055 0.0178357
30.4726 0.0212768
37.7683 0.0134492
11.7346 0.0192032
10.7229 0.0187046
15.1095 0.0258798
17.8976 0.0178368
23.2037 0.0212768
31.7 0.0134492
13.8423 0.0192039
13.7139 0.0187046
16.9295 0.0222503
12.6479 0.0194335
20.9363 0.0204423
22.1379 0.0137465
51.3318 0.0232902
55.0549 0.0179742
END
$picture_front << END
54.925 9.01791e-05
63.7552 0.000973934
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
set xrange [0.494293:8.70418]; set yrange [4.35965e-07:0.0195639]
set xlabel 'million nearest hits a second  (more is better)'; set ylabel 'wrong hits  (less is better)' offset -1.5
set label 'mean of 7 scenes: speed against accuracy (CPU, 2 threads)' at screen 0.02, screen 0.9774 font ',20'
set label '256x256 primary and 65,536 random rays a scene; 458,752 in all compared with brute force in double; pictures of 128x128' at screen 0.02, screen 0.9516
set xtics ('0.5' 0.5, '0.7' 0.7, '1' 1, '1.5' 1.5, '2' 2, '3' 3, '5' 5, '7' 7)
set ytics ("none of\n458,752" 1.08991e-06, '0.001 %%' 1e-5, '0.01 %%' 1e-4, '0.1 %%' 1e-3, '1 %%' 1e-2)
set object rectangle from graph 0, graph 0 to graph 1, first 1.85285e-06 fs solid noborder fc rgb '#eeeeee' behind
set arrow from first 7.25349,0.00327192 to graph 1.0,0.8330 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.8330 to graph 1.015,0.8330 nohead lw 0.8 lc rgb '#999999'
set label 'fast, study: irregular exact' at graph 1.02,0.8330 left
set arrow from first 7.24643,1.08991e-06 to graph 1.0,0.0855 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.0855 to graph 1.015,0.0855 nohead lw 0.8 lc rgb '#999999'
set label 'robust: irregular exact' at graph 1.02,0.0855 left
$hits0 << END
1.11257 0.000233241
1.2124 0.000233241
1.87067 0.000233241
1.93186 0.000233241
2.96441 0.000233241
3.40374 0.000233241
1.24619 0.000233241
1.20953 0.000233241
1.21718 0.000233241
1.48212 0.000233241
2.15862 0.000233241
2.31966 0.000233241
1.26764 0.000233241
1.34506 0.000233241
1.36207 0.000233241
1.37598 0.000233241
1.99905 0.000233241
1.91091 0.000233241
5.83441 0.000233241
5.83604 0.000233241
END
$hits1 << END
0.8913 0.00527518
0.961659 0.00514439
1.91022 0.00782558
1.99653 0.00444249
3.04976 0.00572641
3.40437 0.00240871
0.861423 0.00527518
0.948678 0.00514439
1.26554 0.00782558
1.40366 0.00444249
2.16086 0.00572641
2.41387 0.00240871
0.952196 0.00543431
1.01637 0.00517709
1.24695 0.00716073
1.12868 0.00560652
1.65343 0.00575692
1.47695 0.00289699
5.91411 0.00581578
7.25349 0.00327192
END
$hits2 << END
1.13557 1.08991e-06
1.1563 1.08991e-06
1.68874 1.08991e-06
1.95595 1.08991e-06
2.75952 1.08991e-06
3.59953 1.08991e-06
1.11076 1.08991e-06
1.13518 1.08991e-06
1.31112 1.08991e-06
1.57876 1.08991e-06
2.39209 1.08991e-06
2.4692 1.08991e-06
1.16191 1.08991e-06
1.20017 1.08991e-06
1.3747 1.08991e-06
1.38285 1.08991e-06
2.0087 1.08991e-06
1.84747 1.08991e-06
5.43703 1.08991e-06
7.24643 1.08991e-06
0.593151 1.08991e-06
1.61347 1.08991e-06
1.42212 1.08991e-06
2.03436 1.08991e-06
END
$hits3 << END
0.902496 0.00504848
0.892362 0.00491333
1.8424 0.00759888
1.93496 0.00421797
3.01602 0.00550188
3.19661 0.00217983
0.857823 0.00504848
0.851424 0.00491333
1.3289 0.00759888
1.63092 0.00421797
2.15234 0.00550188
2.67257 0.00217983
0.934497 0.00520979
0.999873 0.00494603
1.35553 0.00694275
0.968665 0.00538853
1.80978 0.0055324
1.79921 0.00267029
6.36139 0.00558908
6.18454 0.00303868
END
$hits4 << END
1.12488 8.07343e-07
1.22501 8.07343e-07
2.04081 8.07343e-07
1.88075 8.07343e-07
2.91117 8.07343e-07
3.20561 8.07343e-07
1.18866 8.07343e-07
1.28088 8.07343e-07
1.4275 8.07343e-07
1.55841 8.07343e-07
2.06812 8.07343e-07
2.37116 8.07343e-07
1.25484 8.07343e-07
1.31964 8.07343e-07
1.60913 8.07343e-07
1.34201 8.07343e-07
2.01606 8.07343e-07
2.09352 8.07343e-07
5.532 8.07343e-07
5.71782 8.07343e-07
END
$hits5 << END
1.06826 0.00504848
1.18059 0.00491333
2.11015 0.00759888
2.02931 0.00422015
3.0916 0.00550188
3.36521 0.00217983
1.11835 0.00504848
1.10961 0.00491333
1.53396 0.00759888
1.76964 0.00421797
2.48535 0.00550188
2.67137 0.00217983
1.17488 0.00520979
1.21524 0.00494603
1.61311 0.00694493
1.18804 0.00539071
1.95567 0.0055324
1.95182 0.00267029
6.38538 0.00558908
6.01169 0.00303868
END
$hits_front << END
7.24643 1.08991e-06
7.25349 0.00327192
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
set xrange [4.3839:76.5062]; set yrange [4.86967e-05:0.0711001]
set xlabel 'pictures a second  (more is better)'; set ylabel 'picture: RMSE of a channel  (less is better)' offset -1.5
set xtics ('5' 5, '7' 7, '10' 10, '15' 15, '20' 20, '30' 30, '50' 50, '70' 70)
set ytics ("same\nbits" 0.000121742, '10⁻³' 1e-3, '10⁻²' 1e-2)
set object rectangle from graph 0, graph 0 to graph 1, first 0.000206961 fs solid noborder fc rgb '#eeeeee' behind
set arrow from first 63.7552,0.000973934 to graph 1.0,0.4111 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.4111 to graph 1.015,0.4111 nohead lw 0.8 lc rgb '#999999'
set label 'robust: irregular exact' at graph 1.02,0.4111 left
set arrow from first 54.925,9.01791e-05 to graph 1.0,0.0846 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.0846 to graph 1.015,0.0846 nohead lw 0.8 lc rgb '#999999'
set label 'double: irregular exact' at graph 1.02,0.0846 left
$picture0 << END
12.438 0.0125231
12.483 0.0125231
18.9902 0.0125231
19.9601 0.0125231
33.8002 0.0125231
43.5842 0.0125231
13.3062 0.0125231
12.9299 0.0125231
14.06 0.0125231
15.4815 0.0125231
25.9668 0.0125231
25.612 0.0125231
12.941 0.0125231
14.2527 0.0125231
17.7719 0.0125231
15.3304 0.0125231
23.0915 0.0125231
22.8548 0.0125231
61.3925 0.0125231
60.0848 0.0125231
END
$picture1 << END
11.5969 0.0226732
11.1005 0.022294
19.6663 0.02844
22.5285 0.0216674
33.6284 0.0243876
40.512 0.0182106
11.6728 0.0226732
12.4023 0.022294
16.2001 0.02844
16.9215 0.0216674
24.7743 0.0243876
33.8626 0.0182106
11.951 0.0226738
13.1173 0.022294
15.8485 0.025308
14.6906 0.0228528
21.655 0.0237599
21.5146 0.0184314
55.9323 0.0261916
59.7869 0.0218031
END
$picture2 << END
10.1345 0.000973934
10.6164 0.000973934
17.9565 0.000973934
20.1843 0.000973934
33.3581 0.000973934
37.2549 0.000973934
10.7946 0.000973934
10.7587 0.000973934
13.3229 0.000973934
17.6894 0.000973934
24.2791 0.000973934
25.2524 0.000973934
10.0567 0.000973934
11.2187 0.000973934
13.8965 0.000973934
12.5455 0.000973934
20.513 0.000973934
21.3832 0.000973934
54.2401 0.000973934
63.7552 0.000973934
5.26067 0.000973934
16.9887 0.000973934
17.8828 0.000973934
17.4013 0.000973934
END
$picture3 << END
8.37699 0.0192262
8.62034 0.0187285
18.3347 0.0258923
19.0813 0.0178553
32.3422 0.0212966
32.2575 0.0134852
8.96713 0.0192262
10.0784 0.0187285
15.1381 0.0258923
16.3559 0.0178553
24.7544 0.0212966
29.1533 0.0134852
9.62152 0.0192269
10.1916 0.0187285
13.9179 0.0222704
11.8239 0.0194222
19.0815 0.0204616
18.8635 0.0137798
50.8098 0.0233081
52.7164 0.0179993
END
$picture4 << END
11.3946 9.01791e-05
11.4714 9.01791e-05
20.9551 9.01791e-05
22.7838 9.01791e-05
35.4153 9.01791e-05
33.2886 9.01791e-05
11.7532 9.01791e-05
10.3931 9.01791e-05
15.6412 9.01791e-05
16.9262 9.01791e-05
24.8347 9.01791e-05
27.4396 9.01791e-05
12.7606 9.01791e-05
13.7985 9.01791e-05
17.2012 9.01791e-05
12.9246 9.01791e-05
20.9017 9.01791e-05
21.5788 9.01791e-05
49.7256 9.01791e-05
54.925 9.01791e-05
END
$picture5 << END
10.7984 0.0192032
12.3848 0.0187046
20.8328 0.0258798
21.6055 0.0178357
30.4726 0.0212768
37.7683 0.0134492
11.7346 0.0192032
10.7229 0.0187046
15.1095 0.0258798
17.8976 0.0178368
23.2037 0.0212768
31.7 0.0134492
13.8423 0.0192039
13.7139 0.0187046
16.9295 0.0222503
12.6479 0.0194335
20.9363 0.0204423
22.1379 0.0137465
51.3318 0.0232902
55.0549 0.0179742
END
$picture_front << END
54.925 9.01791e-05
63.7552 0.000973934
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
1 7726.06
2 2270.21
4 1994.6
8 1506.26
16 1147.84
32 365.206
64 180.157
128 137.662
256 102.562
END
$chosen0 << END
138.128 36.0062
END
$line1 << END
1 14764
2 3900.03
4 1728.31
8 321.572
16 98.4039
32 48.2206
64 36.632
128 50.2698
256 73.8281
END
$chosen1 << END
93.6537 32.709
END
$line2 << END
1 11226.5
2 1141.11
4 299.124
8 94.4526
16 43.4773
32 40.3933
64 40.273
128 77.3231
256 68.2151
END
$chosen2 << END
43.323 36.1176
END
$line3 << END
1 3035.67
2 771.849
4 213.637
8 64.0546
16 26.8829
32 17.8527
64 28.0329
128 41.1492
256 52.0632
END
$chosen3 << END
50.4685 35.915
END
$line4 << END
1 393.612
2 111.243
4 49.3049
8 13.4288
16 7.03536
32 8.81252
64 8.83173
128 10.1755
256 17.6402
END
$chosen4 << END
30 4.18896
END
$line5 << END
1 5583.63
2 1113.27
4 519.545
8 174.098
16 78.0502
32 43.3161
64 44.572
128 59.0243
256 52.5184
END
$chosen5 << END
50.6645 42.9406
END
$line6 << END
1 5829.32
2 1834.64
4 1565.15
8 1308.99
16 907.52
32 505.071
64 249.802
128 129.29
256 83.0789
END
$chosen6 << END
278.218 36.5344
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
set xrange [0.909091:306.04]; set yrange [3.22228:19193.2]
set xlabel 'voxels an axis'; set ylabel 'ms a picture'
set xtics (1, 2, 4, 8, 16, 32, 64, 128, 256, 512, 1024)
set ytics ('10' 10, '100' 100, '1000' 1000, '10000' 10000)
set arrow from first 16, graph 0 to first 16, graph 1 nohead lw 1.5 dt '-' lc rgb '#444444'
set label '16: what the founding study found enough' at first 16, graph 0.97 offset 1,0 left
set arrow from first 256,102.562 to graph 1.0,0.5451 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.5451 to graph 1.015,0.5451 nohead lw 0.8 lc rgb '#999999'
set label 'balls' at graph 1.02,0.5451 left
set arrow from first 256,73.8281 to graph 1.0,0.4551 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.4551 to graph 1.015,0.4551 nohead lw 0.8 lc rgb '#999999'
set label 'gears' at graph 1.02,0.4551 left
set arrow from first 256,68.2151 to graph 1.0,0.4101 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.4101 to graph 1.015,0.4101 nohead lw 0.8 lc rgb '#999999'
set label 'mount' at graph 1.02,0.4101 left
set arrow from first 256,52.0632 to graph 1.0,0.3201 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.3201 to graph 1.015,0.3201 nohead lw 0.8 lc rgb '#999999'
set label 'teapot' at graph 1.02,0.3201 left
set arrow from first 256,17.6402 to graph 1.0,0.1956 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.1956 to graph 1.015,0.1956 nohead lw 0.8 lc rgb '#999999'
set label 'tetra' at graph 1.02,0.1956 left
set arrow from first 256,52.5184 to graph 1.0,0.3651 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.3651 to graph 1.015,0.3651 nohead lw 0.8 lc rgb '#999999'
set label 'rings' at graph 1.02,0.3651 left
set arrow from first 256,83.0789 to graph 1.0,0.5001 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.5001 to graph 1.015,0.5001 nohead lw 0.8 lc rgb '#999999'
set label 'tree' at graph 1.02,0.5001 left
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
set xrange [0.909091:306.04]; set yrange [3.22228:19193.2]
set xlabel 'voxels an axis'; set ylabel 'ms a picture'
set xtics (1, 2, 4, 8, 16, 32, 64, 128, 256, 512, 1024)
set ytics ('10' 10, '100' 100, '1000' 1000, '10000' 10000)
set arrow from first 16, graph 0 to first 16, graph 1 nohead lw 1.5 dt '-' lc rgb '#444444'
set label '16: what the founding study found enough' at first 16, graph 0.97 offset 1,0 left
set arrow from first 256,102.562 to graph 1.0,0.5451 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.5451 to graph 1.015,0.5451 nohead lw 0.8 lc rgb '#999999'
set label 'balls' at graph 1.02,0.5451 left
set arrow from first 256,73.8281 to graph 1.0,0.4551 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.4551 to graph 1.015,0.4551 nohead lw 0.8 lc rgb '#999999'
set label 'gears' at graph 1.02,0.4551 left
set arrow from first 256,68.2151 to graph 1.0,0.4101 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.4101 to graph 1.015,0.4101 nohead lw 0.8 lc rgb '#999999'
set label 'mount' at graph 1.02,0.4101 left
set arrow from first 256,52.0632 to graph 1.0,0.3201 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.3201 to graph 1.015,0.3201 nohead lw 0.8 lc rgb '#999999'
set label 'teapot' at graph 1.02,0.3201 left
set arrow from first 256,17.6402 to graph 1.0,0.1956 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.1956 to graph 1.015,0.1956 nohead lw 0.8 lc rgb '#999999'
set label 'tetra' at graph 1.02,0.1956 left
set arrow from first 256,52.5184 to graph 1.0,0.3651 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.3651 to graph 1.015,0.3651 nohead lw 0.8 lc rgb '#999999'
set label 'rings' at graph 1.02,0.3651 left
set arrow from first 256,83.0789 to graph 1.0,0.5001 nohead lw 0.8 lc rgb '#999999'
set arrow from graph 1.0,0.5001 to graph 1.015,0.5001 nohead lw 0.8 lc rgb '#999999'
set label 'tree' at graph 1.02,0.5001 left
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
