#!/usr/bin/env bash
# The program `figures` writes every table that the figures of the papers are drawn from, and no column without numbers.
# usage: figures.sh PROGRAM DIRECTORY
set -euo pipefail
program=$1
directory=$2
rm -rf "$directory"
"$program" "$directory"
failed=0
for name in krijt_2013_figure_{2,3,5_left,5_right,C1,C2} krijt_2013_crack_velocity_law krijt_2013_losses_added \
  brach_dunn_1995_figure_{2,4,6,7,8,9,A2} brach_dunn_1995_population brach_dunn_1995_tangential_motion kharaz_2001 kharaz_2001_residuals; do
  file=$directory/$name.csv
  if [[ ! -s $file ]]; then
    echo "$file is missing or empty"
    failed=1
    continue
  fi
  awk -F, -v file="$file" '
    /^#/ { next }
    !columns { columns = split($0, name, ","); next }
    { ++rows; for (i = 1; i <= columns; ++i) if ($i != "") ++filled[i] }
    END {
      for (i = 1; i <= columns; ++i) if (!filled[i]) { print file ": no number in column " name[i]; bad = 1 }
      if (rows < 20) { print file ": only " rows + 0 " rows"; bad = 1 }
      exit bad
    }' "$file" || failed=1
done
exit $failed
