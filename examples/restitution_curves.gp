# e(v) of two water-ice spheres, after Krijt et al. 2013, figure 4.
# usage: gnuplot -e "directory='out'" examples/restitution_curves.gp
if (!exists("directory")) directory = 'out'
curves = directory . '/restitution_curves.csv'
sticking = directory . '/sticking_speeds.csv'
set datafile separator ','
set datafile missing NaN

set xlabel 'impact speed v (m/s)'
set ylabel 'coefficient of restitution e'
set logscale x
set xrange [0.5:100]
set yrange [0:1.05]
set format x '%g'
set grid xtics ytics lc rgb '#dddddd' lt 1
set key bottom right box lc rgb '#bbbbbb' opaque spacing 1.2 width 1
set title "two water-ice spheres, radius 2 {/Symbol m}m, w = 0.74 J/m^2, T_{vis} = 10^{-11} s, k = 0.02"

plot_all = "\
  curves using 'speed':'hertz' with lines lw 2 dt 3 lc rgb '#555555' title 'Hertz', \
  curves using 'speed':'hertz+kuwabara_kono' with lines lw 2 dt 2 lc rgb '#e69f00' title 'viscous Hertz', \
  curves using 'speed':(column('hertz+jkr')) with lines lw 2 dt 2 lc rgb '#0072b2' title 'JKR', \
  curves using 'speed':'independent_losses' with lines lw 2 dt 4 lc rgb '#009e73' title 'losses added, Krijt (27)', \
  curves using 'speed':'hertz+jkr+kuwabara_kono' with lines lw 2 lc rgb '#cc79a7' title 'JKR, viscous bulk', \
  curves using 'speed':'hertz+jkr+greenwood+kuwabara_kono' with lines lw 3 lc rgb '#d55e00' title 'viscoelastic JKR, exact edge', \
  curves using 'speed':'hertz+jkr+greenwood_fit+kuwabara_kono' with lines lw 1.2 dt 3 lc rgb '#000000' title 'viscoelastic JKR, published fits'"

set terminal svg size 900,600 font 'Helvetica,14' background '#ffffff'
set output directory . '/restitution_curves.svg'
eval 'plot ' . plot_all
set terminal pngcairo size 1350,900 font 'Helvetica,18' background '#ffffff'
set output directory . '/restitution_curves.png'
eval 'plot ' . plot_all
