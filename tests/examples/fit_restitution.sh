#!/usr/bin/env bash
# Tests the program `fit_restitution`: fit_restitution.sh PROGRAM REPOSITORY
set -u
source "$(dirname "$0")/checks.sh"
here=$root/examples/fit_restitution
ice=("$here/ice.csv" --scene "$here/ice_scene.csv" --tie "bulk_time=16*relaxation_time")
wide=(--free work_of_adhesion=0.05:5 --free relaxation_time=1e-13:1e-9 --free yield_strength=2e7:2e10)

# found NAME: "value low high" of a parameter, from the JSON
found() {
  tr -d ' \n' <"$work/fit.json" | sed 's/},{/}\n{/g' | grep "\"name\":\"$1\"" |
    sed -E 's/.*"interval":\[([^,]*),([^]]*)\].*"value":([^,}]*).*/\3 \1 \2/'
}
holds_truth() { # NAME TRUTH: it is inside the interval, which is no wider than a fifth of it
  # shellcheck disable=SC2046
  set -- "$2" $(found "$1")
  holds "$3 < $1 && $1 < $4 && $4 - $3 < 0.2 * $1 && $3 < $2 && $2 < $4"
}

# The same from the page beside the program.
shown() { sed -nE "s/^$1 += ([^ ]*) .*between ([^ ]*) and (.*)$/\1 \2 \3/p" "$here/README.md"; }
is_as_shown() { # NAME: to a thousandth
  # shellcheck disable=SC2046
  set -- $(found "$1") $(shown "$1")
  holds "$# == 6 && ($1 / $4 - 1) ^ 2 < 1e-6 && ($2 / $5 - 1) ^ 2 < 1e-6 && ($3 / $6 - 1) ^ 2 < 1e-6"
}

solve "$here/ball.csv" --scene "$here/ball_scene.csv" --free bulk_time=1e-6:1e-3 -o "$work/fit"
check "a rubber ball: A is in its interval" holds_truth bulk_time 6e-5
check "which is the one shown" is_as_shown bulk_time
check "the fit of unknown errors tells the scatter" output_has "scatter of one restitution: 0.00342, from 7 degrees"

solve "${ice[@]}" "${wide[@]}" -o "$work/fit"
check "made-up grains: fitted in silence" all 'status_is 0' '[ ! -s "$work/err" ]'
check "w is in its interval" holds_truth work_of_adhesion 0.7
check "T_vis is in its interval" holds_truth relaxation_time 1.2e-11
check "Y is in its interval" holds_truth yield_strength 3e8
for name in work_of_adhesion relaxation_time yield_strength; do
  check "$name is as shown" is_as_shown $name
done
check "it says what was fitted" output_has "24 measurements, 4 of them captured; hertz+jkr+greenwood+kuwabara_kono"
check "a warning for what acts together" output_has "note: work_of_adhesion and relaxation_time can hardly be told apart"
check "the tied column is in the result" grep -q '"bulk_time": 1\.' "$work/fit.json"
check "all measurements are in the table" test "$(grep -vc '^#' "$work/fit_points.csv")" = 25
check "the curve sticks where it is slow and bounces where it is fast" awk -F, '
  /^[0-9]/ { if ($1 < 3 && $2 != 0) bad = 1; if ($1 > 5 && !($2 > 0.3)) bad = 1; ++n } END { exit bad || n < 200 }
  ' "$work/fit_curve.csv"
check "tables say what they are" all 'grep -q "^# command: fit_restitution" "$work/fit_curve.csv"' \
  'grep -q "^# units: speed \[m/s\]" "$work/fit_points.csv"'
if command -v gnuplot >/dev/null; then
  check "the figure is drawn" all '[ -s "$work/fit.svg" ]' '[ -s "$work/fit.png" ]'
  check "with all points and the curve" grep -q 'measured - fitted' "$work/fit.svg"
fi
cp "$work/fit.json" "$work/first.json"
solve "${ice[@]}" "${wide[@]}" --threads 1 -o "$work/fit"
check "one thread finds the same" cmp <(grep -v '"command"' "$work/first.json") <(grep -v '"command"' "$work/fit.json")

# A local minimum without damping, chi^2 = 301.6, is left wherever the search begins.
for starts in 1 64; do
  solve "$here/ice.csv" --scene "$here/ice_scene.csv" --set model=hertz+jkr+kuwabara_kono+thornton_ning \
    --free work_of_adhesion=0.05:5 --free bulk_time=1e-13:1e-8 --free yield_strength=2e7:2e10 --starts $starts
  check "$starts starts find the least of all minima" output_has "chi^2 = 91.65 of 17 degrees of freedom"
done
check "laws outside their range are named" output_has "7 of the 24 collisions take laws outside their range"

# Brach & Dunn 1995: two spheres of their own radius; half of the zeta_A printed (12.5) gives what was measured.
cat >"$work/glass.csv" <<'CSV'
speed,restitution,error,radius_1,zeta_h
2.8,0.62,0.005,4.3e-6,10.45
2.8,0.746,0.0005,5.06e-6,10.54
CSV
glass=("$work/glass.csv" --set model=hertz+line_force+hunt_crossley --set radius_2=inf --set density_1=2600
  --set youngs_modulus_1=72e9 --set youngs_modulus_2=207e9 --set poissons_ratio_1=0.21 --set poissons_ratio_2=0.27
  --set line_force=250)
solve "${glass[@]}" --free zeta_a=0.1:100 -o "$work/fit"
check "zeta_A of Brach & Dunn" all 'status_is 0' 'holds_truth zeta_a 6.25'

refused() { # STATUS SENTENCE ARGUMENT...
  local wanted=$1 sentence=$2
  shift 2
  solve "$@"
  check "refused: $sentence" all "status_is $wanted" "says '$sentence'"
}
refused 2 "cannot read $work/none.csv" "$work/none.csv" --free zeta_a=1:10
refused 2 "--free is required" "${glass[@]}"
refused 2 "--free zeta_a=1 is not of the form COLUMN=LOW:HIGH" "${glass[@]}" --free zeta_a=1
refused 2 "--free zeta_a: \"x\" is not a number" "${glass[@]}" --free zeta_a=x:2
refused 2 "--tie zeta_a=zeta_h is not of the form COLUMN=FACTOR*COLUMN" "${glass[@]}" --free zeta_h=1:2 --tie zeta_a=zeta_h
refused 2 "--free zeta_a: 10 is not below 1" "${glass[@]}" --free zeta_a=10:1
refused 2 "--confidence = 95 is outside [0, 1)" "${glass[@]}" --free zeta_a=1:10 --confidence 95
refused 2 "there is no column zeta_b; did you mean zeta_a?" "${glass[@]}" --free zeta_b=1:10
refused 2 "yield_strength is given, but no law of the model takes it: hertz+line_force+hunt_crossley" "${glass[@]}" \
  --free zeta_a=1:10 --set yield_strength=1e9
cp "$work/glass.csv" "$work/own_points.csv"
refused 2 "-o $work/own would overwrite $work/own_points.csv" "$work/own_points.csv" "${glass[@]:1}" \
  --free zeta_a=0.1:100 -o "$work/own"
refused 2 "radius_1 is set by $work/glass.csv and by --free" "${glass[@]}" --free radius_1=1e-6:1e-5
refused 2 "speed is set by" "${glass[@]}" --free speed=1:10
refused 2 "model is no parameter" "$work/glass.csv" --free model=1:10
refused 2 "zeta_a is tied to zeta_x, which is not free" "${glass[@]:0:15}" --free line_force=1:10 --tie "zeta_a=2*zeta_x"
refused 2 "line_force is set by --scene or --set and by --free" "${glass[@]}" --free line_force=1:10
refused 2 "model is set twice by --set" "${glass[@]}" --set model=hertz+jkr --free zeta_a=1:10
refused 2 "column work_of_adhesion: the header has no such column, and jkr needs it; give it with --set or --scene, or in" \
  "${glass[@]/line_force+/jkr+}" --free zeta_a=1:10
refused 2 "line 2, column radius_2, value \"-1\": radius_2 = -1 m is outside (0, inf] m" "${glass[@]/=inf/=-1}" \
  --free zeta_a=1:10
refused 2 "-o $work/ is a folder" "${glass[@]}" \
  --free zeta_a=0.1:100 -o "$work/"
sed 's/,/;/g' "$work/glass.csv" >"$work/semicolons.csv"
refused 2 "columns are separated by commas" "$work/semicolons.csv" "${glass[@]:1}" --free zeta_a=0.1:100
sed 's/error/eror/' "$work/glass.csv" >"$work/misspelt.csv"
solve "$work/misspelt.csv" "${glass[@]:1}" --free zeta_a=0.1:100
check "columns that mean nothing are named" says "note: not used of $work/misspelt.csv: eror"
sed 's/0.746/0/' "$work/glass.csv" >"$work/zero.csv"
solve "$work/zero.csv" "${glass[@]:1}" --free zeta_a=0.1:100
check "zeros are doubted" output_has "1 restitutions are given as the number zero"
awk '/^#/ { print; next } { print $0 (rows++ ? ",1e9" : ",yield_strength") }' "$here/ball_scene.csv" >"$work/more.csv"
# The same from the page beside the program.
shown() { sed -nE "s/^$1 += ([^ ]*) .*between ([^ ]*) and (.*)$/\1 \2 \3/p" "$here/README.md"; }
is_as_shown() { # NAME: to a thousandth
  # shellcheck disable=SC2046
  set -- $(found "$1") $(shown "$1")
  holds "$# == 6 && ($1 / $4 - 1) ^ 2 < 1e-6 && ($2 / $5 - 1) ^ 2 < 1e-6 && ($3 / $6 - 1) ^ 2 < 1e-6"
}

solve "$here/ball.csv" --scene "$work/more.csv" --free bulk_time=1e-6:1e-3
check "what a scene has beside is named" all 'status_is 0' 'says "note: yield_strength in the scene changes nothing"'
refused 1 "are too few for 3 free parameters" "${glass[@]:0:5}" "${glass[@]:7:8}" \
  --free zeta_a=1:10 --free line_force=100:500 --free density_1=1000:3000
# The tutorial's commands find what it says they do.
(cd "$work" && "$program" glass.csv "${glass[@]:1}" --free zeta_a=0.1:100) >"$work/out"
check "the tutorial's zeta_a" grep -qF "$(sed -n '2,3p' "$work/out")" "$here/README.md"
# The same from the page beside the program.
shown() { sed -nE "s/^$1 += ([^ ]*) .*between ([^ ]*) and (.*)$/\1 \2 \3/p" "$here/README.md"; }
is_as_shown() { # NAME: to a thousandth
  # shellcheck disable=SC2046
  set -- $(found "$1") $(shown "$1")
  holds "$# == 6 && ($1 / $4 - 1) ^ 2 < 1e-6 && ($2 / $5 - 1) ^ 2 < 1e-6 && ($3 / $6 - 1) ^ 2 < 1e-6"
}

solve "$here/ball.csv" --scene "$here/ball_scene.csv" --free bulk_time=1e-6:1e-3
check "the tutorial's bulk_time" grep -qF "$(sed -n '2p' "$work/out")" "$here/README.md"

solve --help
check "help explains the columns" all 'status_is 0' 'output_has "standard deviation of the restitution"'
done_with_checks
