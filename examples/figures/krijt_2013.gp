# Figures of Krijt et al. 2013.
# usage: gnuplot -e "directory='out/figures'" examples/figures/krijt_2013.gp
load ARG0[1:strlen(ARG0) - strlen('krijt_2013.gp')] . 'common.gp'

do for [format in 'svg png'] {

  # 2 and 3: contact radius and elastic force over mutual approach
  do for [number in '2 3'] {
    data = csv('krijt_2013_figure_' . number)
    eval plain
    eval draw('krijt_2013_figure_' . number, 1100, 500)
    set multiplot layout 1,2 title 'two water-ice spheres at ' . (number eq '2' ? '8' : '2') . ' m/s, radius 2 {/Symbol m}m, T_{vis} = 10^{-11} s'
    set xlabel 'mutual approach {/Symbol d} (10^{-8} m)'
    set ylabel 'contact radius a (10^{-7} m)'
    set xrange [(number eq '2' ? -1.5 : -0.75):(number eq '2' ? 4 : 1.75)]
    unset key
    plot \
      data using (column('mutual_approach') * 1e8):(column('hertz_contact_radius') * 1e7) with lines lw 2 dt 3 lc rgb grey, \
      data using (column('mutual_approach') * 1e8):(column('jkr_contact_radius') * 1e7) with lines lw 2 dt 2 lc rgb blue, \
      data using (column('mutual_approach') * 1e8):(column('jkr_snap_on_contact_radius') * 1e7) with lines lw 1.2 dt 2 lc rgb blue, \
      data using (column('mutual_approach') * 1e8):(column('contact_radius') * 1e7) with lines lw 2.5 lc rgb red, \
      data using (column('mutual_approach') * 1e8):(column('jkr_equilibrium_contact_radius') * 1e7) with points pt 3 ps 1.5 lw 2 lc rgb '#000000'
    set ylabel 'elastic force F_E ({/Symbol m}N)'
    set key top left
    plot \
      data using (column('mutual_approach') * 1e8):(column('hertz_force') * 1e6) with lines lw 2 dt 3 lc rgb grey title 'Hertz', \
      data using (column('mutual_approach') * 1e8):(column('jkr_force') * 1e6) with lines lw 2 dt 2 lc rgb blue title 'JKR', \
      data using (column('mutual_approach') * 1e8):(column('jkr_snap_on_force') * 1e6) with lines lw 1.2 dt 2 lc rgb blue notitle, \
      data using (column('mutual_approach') * 1e8):(column('elastic_force') * 1e6) with lines lw 2.5 lc rgb red title 'viscoelastic JKR', \
      data using (column('mutual_approach') * 1e8):(column('jkr_equilibrium_force') * 1e6) with points pt 3 ps 1.5 lw 2 lc rgb '#000000' title 'JKR at rest'
    unset multiplot
  }

  # 4: restitution over speed, from the numbers of restitution_curves
  data = csv('restitution_curves')
  eval plain
  eval draw('krijt_2013_figure_4', 800, 550)
  set title 'two water-ice spheres, radius 2 {/Symbol m}m, T_{vis} = 10^{-11} s'
  set xlabel 'impact speed v (m/s)'
  set ylabel 'coefficient of restitution e'
  set logscale x
  set xrange [0.5:100]
  set yrange [0:1.05]
  set key bottom right
  plot \
    data using 'speed':(column('hertz+jkr')) with lines lw 2 dt 2 lc rgb blue title 'JKR (24)', \
    data using 'speed':'hertz+kuwabara_kono' with lines lw 2 dt 2 lc rgb orange title 'viscous Hertz', \
    data using 'speed':'independent_losses' with lines lw 2 dt 4 lc rgb green title 'losses added (27)', \
    data using 'speed':'hertz+jkr+greenwood_fit+kuwabara_kono' with lines lw 2.5 lc rgb red title 'viscoelastic JKR'

  # 5: restitution and sticking speed over reduced radius
  eval plain
  eval draw('krijt_2013_figure_5', 1100, 500)
  set multiplot layout 1,2 title 'two equal water-ice spheres; left: T_{vis} = 10^{-11} s'
  set xlabel 'reduced radius R (m)'
  set logscale x
  set xrange [1e-7:1e-4]
  set format x '10^{%T}'
  set ylabel 'coefficient of restitution e at 8 m/s'
  set yrange [0:1.05]
  set key bottom right
  data = csv('krijt_2013_figure_5_left')
  plot \
    data using 'reduced_radius':'jkr' with lines lw 2 dt 2 lc rgb blue title 'JKR (24)', \
    data using 'reduced_radius':'viscous' with lines lw 2 dt 2 lc rgb orange title 'weak damping (26)', \
    data using 'reduced_radius':'independent' with lines lw 2 dt 4 lc rgb green title 'losses added (27)', \
    data using 'reduced_radius':'viscoelastic_jkr' with lines lw 2.5 lc rgb red title 'viscoelastic JKR'
  set ylabel 'sticking speed v_s (m/s)'
  set xrange [1e-7:1e-5]
  set logscale y
  set format y '10^{%T}'
  set yrange [0.1:200]
  set key top right
  data = csv('krijt_2013_figure_5_right')
  plot \
    data using 'reduced_radius':'T_vis_1e-10_s' with lines lw 2.5 lc rgb red title 'T_{vis} = 10^{-10} s', \
    data using 'reduced_radius':'T_vis_1e-11_s' with lines lw 2.5 lc rgb orange title 'T_{vis} = 10^{-11} s', \
    data using 'reduced_radius':'T_vis_1e-12_s' with lines lw 2.5 lc rgb green title 'T_{vis} = 10^{-12} s', \
    data using 'reduced_radius':'T_vis_1e-13_s' with lines lw 2.5 lc rgb pink title 'T_{vis} = 10^{-13} s', \
    data using 'reduced_radius':'jkr' with lines lw 2 dt 2 lc rgb blue title 'JKR (25)'
  unset multiplot

  # C1 and C2: energies over time
  do for [number in 'C1 C2'] {
    data = csv('krijt_2013_figure_' . number)
    eval plain
    eval draw('krijt_2013_figure_' . number, 800, 550)
    set title 'two water-ice spheres at ' . (number eq 'C1' ? '8' : '2') . ' m/s, radius 2 {/Symbol m}m, T_{vis} = 10^{-11} s'
    set xlabel 'time t (10^{-8} s)'
    set ylabel 'energy over initial kinetic energy'
    set key below horizontal
    plot \
      data using (column('time') * 1e8):'kinetic_energy' with lines lw 2 lc rgb '#000000' title 'kinetic', \
      data using (column('time') * 1e8):'elastic_energy' with lines lw 2 dt 2 lc rgb blue title 'elastic', \
      data using (column('time') * 1e8):'surface_energy' with lines lw 2 dt 4 lc rgb green title 'surface', \
      data using (column('time') * 1e8):'crack_loss' with lines lw 2.5 lc rgb red title 'lost at the edge', \
      data using (column('time') * 1e8):'bulk_loss' with lines lw 2.5 dt 3 lc rgb orange title 'lost in the bulk'
  }

  # (30): adhesive and plastic losses, added and in one motion
  data = csv('krijt_2013_losses_added')
  eval plain
  eval draw('krijt_2013_losses_added', 1100, 500)
  set multiplot layout 1,2 title 'adhesion and plastic flow: in one motion (lines), losses added as in (30) (dashes)'
  set xlabel 'impact speed over yield speed v/v_y'
  set logscale x
  set ylabel 'coefficient of restitution e'
  set xrange [0.2:100]
  set yrange [0:1.05]
  set key below horizontal title 'sticking speed of JKR over v_y'
  plot \
    data using 'speed_over_yield_speed':'plastic' with lines lw 2 dt 3 lc rgb grey title 'no adhesion (29)', \
    data using 'speed_over_yield_speed':'motion_0.1' with lines lw 2.5 lc rgb blue title '0.1', \
    data using 'speed_over_yield_speed':'added_0.1' with lines lw 1.5 dt 2 lc rgb blue notitle, \
    data using 'speed_over_yield_speed':'motion_0.3' with lines lw 2.5 lc rgb green title '0.3', \
    data using 'speed_over_yield_speed':'added_0.3' with lines lw 1.5 dt 2 lc rgb green notitle, \
    data using 'speed_over_yield_speed':'motion_1' with lines lw 2.5 lc rgb red title '1', \
    data using 'speed_over_yield_speed':'added_1' with lines lw 1.5 dt 2 lc rgb red notitle
  set ylabel 'e by (30) less e of the motion'
  set xrange [0.2:1000]
  set logscale y
  set format y '10^{%T}'
  set yrange [1e-5:1]
  set key below horizontal title 'sticking speed of JKR over v_y'
  plot \
    data using 'speed_over_yield_speed':'added_minus_motion_1' with lines lw 2.5 lc rgb red title '1', \
    data using 'speed_over_yield_speed':'added_minus_motion_0.3' with lines lw 2.5 lc rgb green title '0.3', \
    data using 'speed_over_yield_speed':'added_minus_motion_0.1' with lines lw 2.5 lc rgb blue title '0.1', \
    data using 'speed_over_yield_speed':'added_minus_motion_0.03' with lines lw 2.5 lc rgb orange title '0.03'
  unset multiplot

  # (16), (17): energy release rate over the edge's speed
  data = csv('krijt_2013_crack_velocity_law')
  eval plain
  eval draw('krijt_2013_crack_velocity_law', 800, 550)
  set title 'crack-velocity law, k = 0.02'
  set xlabel 'edge speed |da/dt| {/Symbol s}_0^2 T_{vis}/(E* w)'
  set ylabel '{/Symbol b} = G_{eff}/w'
  set logscale xy
  set format x '10^{%T}'
  set xrange [1e-3:1e3]
  set yrange [0.015:70]
  set key top left
  plot \
    data using 'opening_speed_exact':'energy_release_ratio' with lines lw 2.5 lc rgb red title 'opening, exact', \
    data using 'opening_speed_fit':'energy_release_ratio' with lines lw 1.5 dt 2 lc rgb '#000000' title 'opening, fits (16), (17)', \
    data using 'closing_speed_exact':'energy_release_ratio' with lines lw 2.5 lc rgb blue title 'closing, exact', \
    data using 'closing_speed_fit':'energy_release_ratio' with lines lw 1.5 dt 3 lc rgb '#000000' title 'closing, fits (16), (17)'
}
