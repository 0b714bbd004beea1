# What the figures of the papers share: draw(name, width, height) opens <directory>/<name>.svg or .png, by `format`.
if (!exists("directory")) directory = 'out/figures'
csv(name) = directory . '/' . name . '.csv'
svg(name, w, h) = sprintf("set terminal svg size %d,%d font 'Helvetica,14' background '#ffffff'; set output '%s/%s.svg'", w, h, directory, name)
png(name, w, h) = sprintf("set terminal pngcairo size %d,%d font 'Helvetica,18' background '#ffffff'; set output '%s/%s.png'", w * 1.5, h * 1.5, directory, name)
draw(name, w, h) = format eq 'svg' ? svg(name, w, h) : png(name, w, h)
plain = "reset; \
  set datafile separator ','; \
  set datafile missing NaN; \
  set grid xtics ytics lc rgb '#dddddd' lt 1; \
  set key box lc rgb '#bbbbbb' opaque spacing 1.2 width 1; \
  set format x '%g'; set format y '%g'"
grey = '#555555'
orange = '#e69f00'
blue = '#0072b2'
green = '#009e73'
pink = '#cc79a7'
red = '#d55e00'
