# Time for a collision over the largest error reached, of peers and of ricochet's steppers, from work_precision.csv.
# usage: gnuplot -e "directory='out/work_precision'" benchmarks/work_precision.gp
load ARG0[1:strlen(ARG0) - strlen('benchmarks/work_precision.gp')] . 'examples/figures/common.gp'
data = csv('work_precision')
array instances = ['Hertz + Kuwabara-Kono', 'Hertz + Hunt-Crossley', 'Hertz + Tsuji', \
  'Hertz + ring force + Hunt-Crossley', 'Hertz + JKR', 'Hertz + JKR + Kuwabara-Kono', \
  'Hertz + JKR + Greenwood fit + Kuwabara-Kono', 'Hertz + JKR + Greenwood + Kuwabara-Kono']

# Name, colour, kind of dash and of points.
array peers = ['ricochet, batch', 'ricochet, one by one', 'ricochet, automatic', \
  'odeint dopri5, dense output, bisection', 'odeint dopri5, Newton', \
  'odeint bulirsch_stoer, dense output, bisection', 'odeint dopri5, SIMD packs in step', \
  'Verlet, SIMD packs, fixed step', 'GSL rk8pd, Newton', 'CVODE Adams, root finding', 'CVODE BDF, root finding', \
  'ARKODE Dormand-Prince 5(4), root finding', 'ARKODE Verner 6(5), root finding']
array peer_colours = [red, red, red, blue, blue, blue, blue, grey, green, pink, pink, orange, orange]
array peer_dashes = [1, 2, 3, 1, 2, 4, 3, 1, 1, 1, 2, 1, 2]
array peer_points = [5, 7, 9, 4, 6, 8, 12, 1, 2, 3, 1, 2, 3]
array steppers = ['ricochet, automatic', 'ricochet, tsitouras_papakostas75', 'ricochet, fehlberg78', 'ricochet, dopri5', \
  'ricochet, cash_karp54', 'ricochet, runge_kutta4', 'ricochet, runge_kutta_gill', 'ricochet, bulirsch_stoer', \
  'ricochet, bulirsch_stoer_dense_out', 'ricochet, radau<5>']
array stepper_colours = [red, red, blue, green, green, grey, grey, pink, pink, orange]
array stepper_dashes = [1, 2, 1, 1, 2, 1, 2, 1, 2, 1]
array stepper_points = [5, 7, 4, 6, 8, 1, 2, 3, 1, 2]

# Rows of one contender on one instance; an error of round-off is drawn at 1e-16.
rows(i, who) = sprintf("< grep -F '%s,\"%s\",' '%s'", instances[i], who, data)
at_least(x) = x > 1e-16 ? x : 1e-16
style(kind) = sprintf("with linespoints lw 1.5 ps 0.6 lc rgb %s_colours[c] dt %s_dashes[c] pt %s_points[c]", kind, kind, kind)
panel(kind) = sprintf("plot for [c = 1:|%ss|] rows(i, %ss[c]) using (at_least($4)):6 %s notitle", kind, kind, style(kind))
legend(kind) = sprintf("plot for [c = 1:|%ss|] NaN %s title %ss[c] noenhanced", kind, style(kind), kind)

do for [format in 'svg png'] {
  do for [kind in 'peer stepper'] {
    eval plain
    eval draw('work_precision_' . kind . 's', 1200, 1100)
    set multiplot layout 3,3
    set logscale xy
    set xlabel 'largest error of e'
    set ylabel 'time per collision ({/Symbol m}s)'
    set xrange [1:5e-17]
    set yrange [0.02:1e4]
    set xtics ('1' 1, '10^{-4}' 1e-4, '10^{-8}' 1e-8, '10^{-12}' 1e-12, '10^{-16}' 1e-16)
    unset key
    do for [i = 1:|instances|] {
      set title instances[i]
      eval panel(kind)
    }
    unset title; unset border; unset tics; unset xlabel; unset ylabel; unset grid; unset logscale
    set key at graph -0.1,1 left top nobox samplen 3 Left reverse font ',12'
    set xrange [0:1]
    set yrange [0:1]
    eval legend(kind)
    unset multiplot
  }
}
