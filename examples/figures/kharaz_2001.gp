# Rebound over angle of incidence, measured by Kharaz et al. 2001 and by both tangential laws.
# usage: gnuplot -e "directory='out/figures'" examples/figures/kharaz_2001.gp
load ARG0[1:strlen(ARG0) - strlen('kharaz_2001.gp')] . 'common.gp'
quantities = 'tangential_restitution spin contact_point_angle'
labels = "'tangential restitution' 'spin (rad/s)' 'rebound of the contact point (degrees)'"
lows = '0.5 0 -20'
highs = '1 1200 90'

do for [format in 'svg png'] {
  data = csv('kharaz_2001')
  eval plain
  eval draw('kharaz_2001', 1000, 800)
  set multiplot layout 2,2 title 'aluminium oxide on glass, 3.9 m/s, f = 0.092, e = 0.98'
  set xlabel 'angle of incidence from the normal (degrees)'
  set xrange [0:90]
  set xtics 15
  do for [i = 1:3] {
    name = word(quantities, i)
    set ylabel word(labels, i)
    if (i == 2) { set key top right } else { unset key }
    set yrange [word(lows, i) + 0:word(highs, i) + 0]
    plot \
      data using 'angle':(column(name . '_coulomb')) with lines lw 2 dt 2 lc rgb blue title 'coulomb', \
      data using 'angle':(column(name . '_mindlin')) with lines lw 2.5 lc rgb red title 'mindlin', \
      data using 'angle':(column(name . '_measured')) with points pt 7 ps 0.8 lc rgb '#000000' title 'measured', \
      data using 'angle':(column(name . '_benchmark')) with points pt 4 ps 0.8 lc rgb '#888888' title 'Chung and Ooi, test 4'
  }
  data = csv('kharaz_2001_residuals')
  set ylabel 'tangential restitution, model less measured'
  set yrange [-0.1:0.15]
  set key top right
  plot 0 with lines lc rgb '#000000' notitle, \
    data using 'angle':'tangential_restitution_coulomb' with linespoints pt 6 dt 2 lw 2 lc rgb blue title 'coulomb', \
    data using 'angle':'tangential_restitution_mindlin' with linespoints pt 7 ps 0.8 lw 2 lc rgb red title 'mindlin'
  unset multiplot
}
