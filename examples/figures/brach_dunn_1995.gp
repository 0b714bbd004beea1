# Figures of Brach & Dunn 1995.
# usage: gnuplot -e "directory='out/figures'" examples/figures/brach_dunn_1995.gp
load ARG0[1:strlen(ARG0) - strlen('brach_dunn_1995.gp')] . 'common.gp'
single = 'silver-coated glass on steel, diameter 10.12 {/Symbol m}m, 2.8 m/s'

do for [format in 'svg png'] {

  # 2: limiting impulse ratio over angle
  data = csv('brach_dunn_1995_figure_2')
  eval plain
  eval draw('brach_dunn_1995_figure_2', 800, 550)
  set title 'rigid sphere at 2.8 m/s: impulse ratio that makes it roll'
  set xlabel 'angle of incidence {/Symbol a} (degrees; 90: along the normal)'
  set ylabel 'impulse ratio, > 0 where it slows the sphere'
  set xrange [10:90]
  set xtics 10
  set yrange [-0.2:0.8]
  set key top right
  plot \
    data using 'angle':'backspin_R_0' with lines lw 2 dt 2 lc rgb red title 'backspin, R = 0', \
    data using 'angle':'backspin_R_1' with lines lw 2.5 lc rgb red title 'backspin, R = 1', \
    data using 'angle':'no_spin_R_0' with lines lw 2 dt 2 lc rgb blue title 'no spin, R = 0 (I)', \
    data using 'angle':'no_spin_R_1' with lines lw 2.5 lc rgb blue title 'no spin, R = 1 (II)', \
    data using 'angle':'forespin_R_0' with lines lw 2 dt 2 lc rgb green title 'forespin, R = 0', \
    data using 'angle':'forespin_R_1' with lines lw 2.5 lc rgb green title 'forespin, R = 1', \
    data using 'angle':'with_friction' with lines lw 1.5 dt 3 lc rgb '#000000' title 'friction 0.1, no spin, e = 0.746'

  # 4: the same with the bounds of the measurements
  data = csv('brach_dunn_1995_figure_4')
  eval plain
  eval draw('brach_dunn_1995_figure_4', 800, 550)
  set title 'steel spheres on steel at 2.3 m/s, e = 0.601: bounds by constant r{/Symbol w}'
  set xlabel 'angle of incidence {/Symbol a} (degrees; 90: along the normal)'
  set ylabel 'impulse ratio, > 0 where it slows the sphere'
  set xrange [15:92]
  set xtics 15
  set key top right
  plot \
    data using 'angle':'backspin' with lines lw 2.5 lc rgb red title 'backspin', \
    data using 'angle':'no_spin' with lines lw 2 dt 2 lc rgb blue title 'no spin', \
    data using 'angle':'forespin' with lines lw 2.5 lc rgb green title 'forespin of the same r{/Symbol w}', \
    data using 'angle':'measured_at_normal' with points pt 7 ps 0.8 lc rgb '#000000' title 'measured range at 90 degrees'

  # 6: restitution over speed
  data = csv('brach_dunn_1995_figure_6')
  eval plain
  eval draw('brach_dunn_1995_figure_6', 800, 550)
  set title 'silver-coated glass on steel, along the normal'
  set xlabel 'initial normal velocity (m/s)'
  set ylabel 'velocity ratio V_n/v_n'
  set xrange [0:25]
  set yrange [0:1]
  set key bottom right
  plot \
    data using 'speed':'simulated_13_um' with lines lw 2 dt 2 lc rgb orange title 'simulation, 13 {/Symbol m}m', \
    data using 'speed':'simulated_10.12_um' with lines lw 2 dt 3 lc rgb grey title 'simulation, 10.12 {/Symbol m}m', \
    data using 'speed':'simulated_5_um' with lines lw 2 dt 2 lc rgb red title 'simulation, 5 {/Symbol m}m', \
    data using 'speed':'rigid_body' with lines lw 2.5 lc rgb blue title 'rigid body, table 1', \
    data using 'speed':'measured_10.12_um' with points pt 7 ps 1 lc rgb '#000000' title 'measured, table 1', \
    data using 'speed':'measured_8.6_um' with points pt 6 ps 1.2 lw 2 lc rgb '#000000' title 'measured, 8.6 {/Symbol m}m'

  # 6, of all sizes
  data = csv('brach_dunn_1995_population')
  eval plain
  eval draw('brach_dunn_1995_population', 800, 550)
  set title 'silver-coated glass on steel: diameters lognormal, nine tenths from 5 to 13 {/Symbol m}m (assumed)'
  set xlabel 'initial normal velocity (m/s)'
  set ylabel 'velocity ratio V_n/v_n; share captured'
  set xrange [0:25]
  set yrange [0:1]
  set key bottom right
  set style fill transparent solid 0.25 noborder
  plot \
    data using 'speed':'e_of_5_percent':'e_of_95_percent' with filledcurves lc rgb blue title 'nine tenths of the spheres', \
    data using 'speed':'e_of_25_percent':'e_of_75_percent' with filledcurves fs transparent solid 0.5 noborder lc rgb blue title 'half of them', \
    data using 'speed':'e_of_50_percent' with lines lw 2.5 lc rgb blue title 'median', \
    data using 'speed':'captured_fraction' with lines lw 2 dt 2 lc rgb red title 'share captured', \
    data using 'speed':'measured_10.12_um' with points pt 7 ps 1 lc rgb '#000000' title 'measured, 10.12 {/Symbol m}m', \
    data using 'speed':'measured_8.6_um' with points pt 6 ps 1.2 lw 2 lc rgb '#000000' title 'measured, 8.6 {/Symbol m}m'

  # 7: forces over time
  data = csv('brach_dunn_1995_figure_7')
  eval plain
  eval draw('brach_dunn_1995_figure_7', 800, 550)
  set title single
  set xlabel 'time (10^{-8} s)'
  set ylabel 'normal force (10^{-4} N)'
  set key top right
  plot \
    data using (column('time') * 1e8):(column('body') * 1e4) with lines lw 2 dt 2 lc rgb blue title 'body', \
    data using (column('time') * 1e8):(column('adhesion') * 1e4) with lines lw 2 dt 4 lc rgb green title 'adhesion', \
    data using (column('time') * 1e8):(column('net') * 1e4) with lines lw 2.5 lc rgb red title 'net'

  # 8: displacement and velocity over time
  data = csv('brach_dunn_1995_figure_8')
  eval plain
  eval draw('brach_dunn_1995_figure_8', 800, 550)
  set title single
  set xlabel 'time (10^{-8} s)'
  set ylabel 'displacement over largest, velocity over initial'
  set key top right
  plot \
    data using (column('time') * 1e8):'displacement_over_largest' with lines lw 2.5 lc rgb blue title 'displacement', \
    data using (column('time') * 1e8):'velocity_over_initial' with lines lw 2.5 dt 2 lc rgb red title 'velocity, > 0 towards the wall'

  # 9: hysteresis
  data = csv('brach_dunn_1995_figure_9')
  eval plain
  eval draw('brach_dunn_1995_figure_9', 800, 550)
  set title single
  set xlabel 'displacement (10^{-8} m)'
  set ylabel 'net normal force (10^{-4} N)'
  unset key
  plot data using (column('displacement') * 1e8):(column('net_force') * 1e4) with lines lw 2.5 lc rgb red

  # A2: energy restitution over speed
  data = csv('brach_dunn_1995_figure_A2')
  eval plain
  eval draw('brach_dunn_1995_figure_A2', 800, 550)
  set title 'rigid body with the coefficients of table 1'
  set xlabel 'initial normal velocity (m/s)'
  set ylabel 'energy restitution'
  set logscale x
  set xrange [0.5:100]
  set yrange [0:1.05]
  set key bottom right
  plot \
    data using 'speed':'R_squared' with lines lw 2 dt 2 lc rgb blue title 'without adhesion, R^2', \
    data using 'speed':'adhesion' with lines lw 2 dt 4 lc rgb green title 'adhesion alone, (1 - {/Symbol r})^2', \
    data using 'speed':'e_squared' with lines lw 2.5 lc rgb red title 'together, e^2'

  # without a figure in the paper: tangential motion and rotation
  data = csv('brach_dunn_1995_tangential_motion')
  eval plain
  eval draw('brach_dunn_1995_tangential_motion', 800, 550)
  set title single . ', spin 1.4557 10^5 rad/s, f = 0.1'
  set xlabel 'time (10^{-8} s)'
  set ylabel 'speed along the wall (m/s)'
  set y2label 'rotation (degrees)'
  set ytics nomirror
  set y2tics
  set key bottom right
  plot \
    data using (column('time') * 1e8):'surface_speed' with lines lw 2 dt 2 lc rgb blue title 'r{/Symbol w}', \
    data using (column('time') * 1e8):'tangential_velocity' with lines lw 2 lc rgb green title 'v_t', \
    data using (column('time') * 1e8):'slip' with lines lw 2.5 lc rgb red title 'contact point, v_t - r{/Symbol w}', \
    data using (column('time') * 1e8):'rotation' axes x1y2 with lines lw 2 dt 3 lc rgb grey title 'rotation (right axis)'
}
