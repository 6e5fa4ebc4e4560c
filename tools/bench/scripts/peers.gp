# gnuplot -e "data='peers.dat'; out='peers'" peers.gp: Masu's rate over each peer's, a group of bars for each scene and kind
# of rays. Columns: label, over CWBVH, over OptiX, over hagrid.
set datafile separator "\t"
set style data histogram
set style histogram cluster gap 1
set style fill solid 0.9 border -1
set logscale y 2
set yrange [0.5:32]
set title "Rays a second of Masu, through what gridbuild --structure fastest builds, over those of others (H200)"
set ylabel "times"
set grid y
set xtics rotate by -50 left
set key top left
set bmargin 9
set rmargin 9
set arrow from graph 0, first 1 to graph 1, first 1 nohead lw 2 lc rgb "black"
set terminal pngcairo size 1100,520 noenhanced
set output out.".png"
plot data using 2:xtic(1) title "CWBVH, same test" lc rgb "#d95f02", "" using 3 title "OptiX" lc rgb "#1b9e77", \
     "" using 4 title "hagrid's best" lc rgb "#7570b3"
