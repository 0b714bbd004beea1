# Error and evaluations of viscoelastic JKR over speed and relaxation time, from damped.csv and undamped.csv.
# usage: gnuplot -e "directory='out/maps'" tests/campaign/maps.gp
if (!exists("directory")) directory = 'out/maps'
csv(name) = directory . '/' . name . '.csv'
svg(name) = sprintf("set terminal svg size 900,640 font 'Helvetica,14' background '#ffffff'; set output '%s/%s.svg'", directory, name)
png(name) = sprintf("set terminal pngcairo size 1350,960 font 'Helvetica,18' background '#ffffff'; set output '%s/%s.png'", directory, name)
draw(name) = format eq 'svg' ? svg(name) : png(name)
set datafile separator ','
set datafile missing NaN

# Where captured cells meet others: with a blank line after each relaxation time, as contours want it.
set contour base
unset surface
set cntrparam levels discrete 0.5
rows(name) = "< awk -F, '/^[0-9]/ { if ($2 != last && last) print \"\"; last = $2; \
  print log($2) / log(10) \",\" log($1) / log(10) \",\" ($3 == \"captured\") }' '" . csv(name) . "'"
set table $damped
splot rows('damped') using 1:2:3
set table $undamped
splot rows('undamped') using 1:2:3
unset table
unset contour

set xlabel 'relaxation time T_{vis} (s)'
set ylabel 'impact speed v (m/s)'
set xrange [-18.1:0.1]
set yrange [-1.03:3.03]
set xtics 2 out nomirror
set ytics 1 out nomirror
set format x '10^{%.0f}'
set format y '10^{%.0f}'
set key outside below horizontal center Left reverse samplen 2

is(kind) = strcol(3) eq kind
ended(row) = is('separated') || is('captured')
about = 'two spheres of water ice, radius 2 {/Symbol m}m, viscoelastic JKR, k = 0.02, tolerance 10^{-8}'
array names = ['damped', 'undamped']
array laws = ['with bulk damping, A = T_{vis}/{/Symbol n}^2', 'without bulk damping']

place(n) = real(word(strcol(1), n)) # of a border, whose columns no comma separates
marks = "$%s using (place(1)):(place(2)) with lines lw 2 lc rgb '#000000' title 'limit of capture', \
  file using ((!ended(0)) ? log10($2) : NaN):(log10($1)) with points pt 2 ps 0.8 lc rgb '#ff0000' title 'unresolved or failed', \
  file using ((ended(0) && $4 == 0) ? log10($2) : NaN):(log10($1)) with points pt 6 ps 0.8 lc rgb '#ff00ff' title 'ending uncertain', \
  file using ((ended(0) && $6 > 1e-8) ? log10($2) : NaN):(log10($1)) with points pt 4 ps 0.8 lc rgb '#0000ff' title 'estimate above tolerance', \
  file using ((is('separated') && strcol(7) eq '') ? log10($2) : NaN):(log10($1)) with points pt 1 ps 0.8 lc rgb '#000000' title 'no closer solution to compare'"

# Cells without an error, of pairs that stick among them, are grey: an image needs a number everywhere, and an empty column has none.
shaded(name) = "< awk -F, '/^[0-9]/ { shade = -6.5; if ($3 == \"separated\" && $7 != \"\") { \
  shade = $7 > 1e-14 ? log($7 / 1e-8) / log(10) : -6 } \
  print log($2) / log(10) \",\" log($1) / log(10) \",\" shade }' '" . csv(name) . "'"
do for [format in 'svg png'] {
  do for [i = 1:2] {
    file = csv(names[i])
    set title sprintf("error of e over tolerance\n{/*0.8 %s, %s}", about, laws[i])
    set cblabel '|e - e at a hundredth of the tolerance| / tolerance'
    set cbrange [-7:1]
    set cbtics ('none' -6.5, '10^{-6}' -6, '10^{-5}' -5, '10^{-4}' -4, '10^{-3}' -3, '10^{-2}' -2, '0.1' -1, '1' 0, '10' 1)
    set palette defined (-7 '#d0d0d0', -6.01 '#d0d0d0', -6 '#440154', -4 '#3b528b', -2 '#21918c', -0.01 '#fde725', 0 '#d55e00', 1 '#d55e00')
    eval draw(names[i] . '_error')
    eval "plot shaded(names[i]) using 1:2:3 with image notitle, " . sprintf(marks, names[i])
    set title sprintf("evaluations of a collision\n{/*0.8 %s, %s}", about, laws[i])
    set cblabel 'evaluations'
    set cbrange [2:7]
    set cbtics ('100' 2, '10^3' 3, '10^4' 4, '10^5' 5, '10^6' 6, '10^7' 7)
    set palette defined (2 '#440154', 3 '#3b528b', 4 '#21918c', 5 '#5ec962', 7 '#fde725')
    eval draw(names[i] . '_evaluations')
    eval "plot file using (log10($2)):(log10($1)):(log10($9)) with image notitle, " . sprintf(marks, names[i])
  }
}
