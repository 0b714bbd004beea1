# Which speeds tell which parameter of water-ice grains, and the plan made of that, from the numbers of 12_experiment.
# usage: gnuplot -e "directory='out/figures'" examples/figures/experiment.gp
load ARG0[1:strlen(ARG0) - strlen('experiment.gp')] . 'common.gp'

do for [format in 'svg png'] {
  data = csv('experiment')
  eval plain
  eval draw('experiment', 1100, 500)
  set multiplot layout 1,2 title 'two water-ice spheres, radius 2 {/Symbol m}m: w = 0.7 J/m^2, T_{vis} = 1.2 10^{-11} s, Y = 200 MPa'
  set xlabel 'impact speed v (m/s)'
  set logscale x
  set xrange [3.5:65]
  set xtics (4, 6, 10, 20, 40, 60)
  set ylabel 'e, and its derivatives by logarithms'
  set yrange [-2:1.5]
  set key bottom right
  plot 0 with lines lc rgb '#000000' notitle, \
    data using 'speed':'restitution' with lines lw 2 dt 3 lc rgb grey title 'e', \
    data using 'speed':'by_yield_strength' with lines lw 2.5 lc rgb green title 'by ln Y', \
    data using 'speed':'by_relaxation_time' with lines lw 2.5 lc rgb blue title 'by ln T_{vis}', \
    data using 'speed':'by_work_of_adhesion' with lines lw 2.5 lc rgb red title 'by ln w'
  set ylabel 'variance of prediction / number of parameters'
  set yrange [0:1.1]
  set y2label 'measurements, of 20'
  set y2range [0:11]
  set y2tics 2
  set key at graph 0.93, 0.2
  plot 1 with lines dt 2 lc rgb '#000000' notitle, \
    data using 'planned_speed':'measurements' axes x1y2 with impulses lw 6 lc rgb orange title 'measurements', \
    data using 'planned_speed':'variance_over_parameters' with lines lw 2.5 lc rgb blue title 'variance'
  unset multiplot
}
