#!/usr/bin/env bash
# Tests the program `collisions`: collisions.sh PROGRAM REPOSITORY
set -u
export LC_ALL=C
program=${1:?path of the program collisions} root=${2:?root of the repository}
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
passed=0 failed=0

# check NAME COMMAND...: one line that says whether the command succeeded
check() {
  local name=$1
  shift
  if "$@"; then
    passed=$((passed + 1))
    echo "ok      $name"
  else
    failed=$((failed + 1))
    echo "FAILED  $name"
    sed 's/^/          out: /' "$work/out" | tail -n 4 | cut -c1-300
    sed 's/^/          err: /' "$work/err" | tail -n 4 | cut -c1-300
  fi
}

# solve [OPTIONS]: the program on standard input; leaves status, $work/out and $work/err
solve() {
  "$program" "$@" >"$work/out" 2>"$work/err"
  status=$?
}

# cell ROW NAME: the cell of the ROWth collision in column NAME (no quoted commas in these files)
cell() {
  grep -v '^#' "$work/out" | awk -F, -v row="$1" -v name="$2" '
    NR == 1 { for (i = 1; i <= NF; ++i) if ($i == name) place = i }
    NR == row + 1 { print place ? $place : "no such column" }'
}

says() { grep -qF -- "$1" "$work/err"; }
output_has() { grep -qF -- "$1" "$work/out"; }
status_is() { [ "$status" = "$1" ]; }
row_is() { [ "$(cell "$1" ending)" = "$2" ]; }
cell_is() { [ "$(cell "$1" "$2")" = "$3" ]; }
near() { awk -v x="$1" -v y="$2" -v d="$3" 'BEGIN { exit !(x != "" && (x - y)^2 <= d * d) }'; }
all() { # several checks as one, each a quoted command
  local each
  for each in "$@"; do eval "$each" || { echo "        not so: $each"; return 1; }; done
}

names=model,radius_1,radius_2,density_1,density_2,youngs_modulus_1,youngs_modulus_2,poissons_ratio_1,poissons_ratio_2,work_of_adhesion,relaxation_time,modulus_ratio,interaction_range,bulk_time,hunt_crossley_coefficient,tsuji_coefficient,speed
bodies=2e-6,2e-6,1000,1000,7e9,7e9,0.25,0.25
laws=0.74,1e-11,0.02,3e-10,1.6e-10,0.01,0.2
# ice MODEL [SPEED]: one row of two ice spheres with every parameter given
ice() { echo "$1,$bodies,$laws,${2:-8}"; }
one() { solve "${@:2}" < <(echo "$names"; echo "$1"); }

# --- models -----------------------------------------------------------------------------------------------------------
models="hertz hertz+end_at_zero_force hertz+end_at_zero_overlap"
for damping in kuwabara_kono hunt_crossley tsuji; do
  models="$models hertz+$damping hertz+$damping+end_at_zero_force hertz+$damping+end_at_zero_overlap"
done
for crack in "" +greenwood +greenwood_fit; do
  for damping in "" +kuwabara_kono +hunt_crossley +tsuji; do
    models="$models hertz+jkr$crack$damping"
  done
done
row=0
solve --tolerance 1e-8 < <(echo "$names"; for model in $models; do ice "$model"; done)
check "all models: exit status 0, silence" all 'status_is 0' '[ ! -s "$work/err" ]'
for model in $models; do
  row=$((row + 1))
  check "model $model" all "row_is $row separated" "near \"\$(cell $row ledger_residual)\" 0 3e-8" \
    "near \"\$(cell $row error_estimate)\" 0 1e-8"
done
cp "$work/out" "$work/automatic"
check "hertz bounces with restitution 1" near "$(cell 1 restitution)" 1 1e-8
tsuji=$(awk 'BEGIN { z = 0.2 / sqrt(5); s = sqrt(1 - z * z); print exp(-2 * z * atan2(s, z) / s) }') # its closed form
check "tsuji reads its own coefficient" near "$(cell 10 restitution)" "$tsuji" 1e-5
for stepper in dopri5 bulirsch_stoer; do
  solve --tolerance 1e-8 --stepper $stepper < <(echo "$names"; for model in $models; do ice "$model"; done)
  check "$stepper agrees with the automatic stepper in all models" awk -F, -v count="$row" '
    /^#/ { next }
    !place { for (i = 1; i <= NF; ++i) if ($i == "restitution") place = i; next }
    FNR == NR { e[$1] = $place; next }
    $1 != "model" { ++n; if ($place == "" || (e[$1] - $place)^2 > 4e-16) { print $1, e[$1], $place; bad = 1 } }
    END { exit bad || n != count }' "$work/automatic" "$work/out"
done

one "$(ice 'hertz+jkr+greenwood_fit+kuwabara_kono')"
first=$(cell 1 restitution)
check "Krijt's ice case at 8 m/s: 0.656742881328" near "$first" 0.656742881328 1e-9
one "$(ice ' kuwabara_kono + greenwood_fit+hertz +  jkr ')"
check "order of names and spaces do not matter" all 'status_is 0' "cell_is 1 restitution $first"
one "$(ice hertz+jkr 1)"
check "captured: restitution 0, status 0" all 'status_is 0' 'row_is 1 captured' 'cell_is 1 restitution 0'
one "hertz+kuwabara_kono,2e-6,inf,1000,,7e9,7e9,0.25,0.25,,,,,1e-11,,,1"
check "flat wall, its density and unneeded cells blank" all 'status_is 0' 'row_is 1 separated'
e=$(cell 1 restitution)
one "hertz+kuwabara_kono,2e-6,1e6,1000,1000,7e9,7e9,0.25,0.25,,,,,1e-11,,,1"
check "a flat wall is a very large sphere" near "$(cell 1 restitution)" "$e" 1e-9
one "hertz+jkr+greenwood_fit,$bodies,0.74,1e-11,,3e-10,,,,8"
check "greenwood_fit without modulus_ratio" all 'status_is 0' 'row_is 1 separated'
one "hertz+jkr+greenwood_fit,$bodies,0.74,1e-11,0.5,3e-10,,,,8"
check "greenwood_fit with modulus_ratio 0.5" all 'status_is 1' 'row_is 1 failed' \
  'says "line 2, column modulus_ratio, value \"0.5\": "' 'says "use greenwood"'

# --- the table --------------------------------------------------------------------------------------------------------
solve < <(echo "# a comment"; echo "# another"; echo "label,$names,restitution,yield_strength,note "
  echo "\"a, b\",$(ice hertz),0.5, soft ,\"say \"\"hi\"\"\""; echo; echo "   "; echo "c,$(ice hertz),,,x")
check "copying through: comments" all 'status_is 0' 'output_has "# a comment"' 'output_has "# another"'
check "copying through: unknown columns, spaces and quotes" all \
  "output_has '\"a, b\",hertz,$bodies'" "output_has '8,0.5, soft ,\"say \"\"hi\"\"\",separated,'"
check "an input column with an output's name is renamed" output_has "speed,input_restitution,yield_strength,note ,ending,restitution,contacts,"
check "blank lines are skipped" cell_is 2 label c
check "the head: version, command, units" all 'sed -n 1p "$work/out" | grep -q "^# ricochet [0-9.]* collisions$"' \
  'sed -n 2p "$work/out" | grep -q "^# command: collisions$"' 'sed -n 3p "$work/out" | grep -q "^# units: SI; .*contact_duration \[s\]"'
cp "$work/out" "$work/again.csv"
solve "$work/again.csv"
check "an output is an input again, with names unique" all 'status_is 0' \
  'output_has ",input_restitution,yield_strength,note ,input_ending,input_input_restitution,"'
one "$(ice hertz+tsuji)"
cp "$work/out" "$work/unix"
solve < <({ echo "$names"; ice hertz+tsuji; } | sed 's/$/\r/')
check "line ends CR LF" cmp -s "$work/out" "$work/unix"
solve < <({ echo "$names"; ice hertz+tsuji; } | tr '\n' '\r')
check "line ends CR" cmp -s "$work/out" "$work/unix"
solve < <(printf '\xEF\xBB\xBF%s\n%s' "$names" "$(ice hertz+tsuji)")
check "byte order mark, no line end at the end" cmp -s "$work/out" "$work/unix"
solve < <(printf '\xEF\xBB\xBF# comment\r\n%s\r\n%s\r\n' "$names" "$(ice hertz+tsuji)")
check "byte order mark before a comment" all 'status_is 0' 'output_has "# comment"' 'row_is 1 separated'
solve < <(echo model,radius_1,radius_2,density_1,youngs_modulus_1,youngs_modulus_2,poissons_ratio_1,poissons_ratio_2,speed
  echo "hertz, 1e-3 ,inf, +1000,7e9,7E9,0,.25,1e-3")
check "columns that no row needs may be missing; spaces around numbers, signs and exponents" \
  all 'status_is 0' 'row_is 1 separated' 'cell_is 1 radius_1 " 1e-3 "'
one "$(ice '"hertz+jkr"')"
check "quoted cells" all 'status_is 0' 'row_is 1 separated'
one "$(ice hertz+jkr)"
check "17 significant digits" all '[ "$(cell 1 restitution | tr -d . | sed s/^0*// | wc -c)" -ge 17 ]'

# --- bad rows ---------------------------------------------------------------------------------------------------------
# bad NAME MESSAGE ROW: the row fails with one message that begins so, and the good row after it does not fail
bad() {
  message=$2
  solve < <(echo "$names"; echo "$3"; ice hertz)
  check "$1" all 'status_is 1' 'says "collisions: line 2$message"' 'row_is 1 failed' 'cell_is 1 restitution ""' \
    'cell_is 1 evaluations ""' 'row_is 2 separated' '[ "$(wc -l <"$work/err")" = 1 ]' 'is_rectangular'
}
is_rectangular() { [ "$(grep -v '^#' "$work/out" | awk -F, '{ print NF }' | sort -u | wc -l)" = 1 ]; }
# with COLUMN TEXT: a row of many laws with this cell changed
with() {
  echo "$names,
$(ice hertz+jkr+greenwood+kuwabara_kono)," | awk -F, -v OFS=, -v name="$1" -v text="$2" '
    NR == 1 { for (i = 1; i < NF; ++i) if ($i == name) place = i }
    NR == 2 { $place = text; NF = NF - 1; print }'
}

bad "missing needed value" ', column work_of_adhesion, value "": blank, but needed by jkr' "$(with work_of_adhesion "")"
bad "a cell of spaces is missing" ', column speed, value "  ": blank, but needed by every collision' "$(with speed "  ")"
bad "a second sphere needs its density" ', column density_2, value "": blank' "$(with density_2 "")"
bad "negative radius" ', column radius_1, value "-1": radius_1 = -1 m is outside (0, inf) m' "$(with radius_1 -1)"
bad "zero speed" ', column speed, value "0": speed = 0 m/s is outside (0, inf) m/s' "$(with speed 0)"
bad "nan" ', column density_1, value "nan": density_1 = nan kg/m^3 is outside' "$(with density_1 nan)"
bad "infinite first radius" ', column radius_1, value "inf": radius_1 = inf m is outside' "$(with radius_1 inf)"
bad "infinite modulus" ', column youngs_modulus_2, value "inf": youngs_modulus_2 = inf Pa is outside' "$(with youngs_modulus_2 inf)"
bad "minus infinite second radius" ', column radius_2, value "-inf": radius_2 = -inf m is outside (0, inf] m' "$(with radius_2 -inf)"
bad "text" ', column bulk_time, value "short": not a number' "$(with bulk_time short)"
bad "number with its unit" ', column speed, value "8 m/s": not a number' "$(with speed '8 m/s')"
bad "separator within a number" ', column speed, value "8;5": not a number' "$(with speed '8;5')"
bad "too large for a double" ', column speed, value "1e999": too large or too small' "$(with speed 1e999)"
bad "too small for a double" ', column speed, value "1e-999": too large or too small' "$(with speed 1e-999)"
bad "modulus ratio outside its range" ', column modulus_ratio, value "0.99": modulus_ratio = 0.99 is outside [0.0001, 0.98]' \
  "$(with modulus_ratio 0.99)"
bad "Poisson's ratio outside its range" ', column poissons_ratio_2, value "0.5": poissons_ratio_2 = 0.5 is outside [0, 0.5)' \
  "$(with poissons_ratio_2 0.5)"
bad "quantities impossible together" ': reduced_mass = ' "hertz,1e200,1e200${bodies#2e-6,2e-6},$laws,8"
bad "too few cells" ': the row has 3 cells, the header 17' "hertz,1,1"
bad "too many cells" ': the row has 19 cells, the header 17' "$(ice hertz),1,2"
bad "misplaced quote" ': misplaced quote' "her\"tz,1,1"
bad "unknown law" ', column model, value "hertz+hurtz": unknown law "hurtz"; there are hertz, jkr,' "$(ice hertz+hurtz)"
bad "a + too many" ", column model, value \"hertz+\": a law's name is missing" "$(ice hertz+)"
bad "no model" ', column model, value "": blank' "$(ice "")"
bad "no elastic law" ', column model, value "jkr": a contact model needs an elastic law' "$(ice jkr)"
bad "two damping laws" ', column model, value "hertz+tsuji+kuwabara_kono": two bulk damping laws were given' \
  "$(ice hertz+tsuji+kuwabara_kono)"
bad "one law twice" ', column model, value "hertz+hertz": two elastic laws were given' "$(ice hertz+hertz)"
bad "crack law without adhesion" ', column model, value "hertz+greenwood": a crack-velocity law needs an adhesion law' \
  "$(ice hertz+greenwood)"
bad "end condition with adhesion" ', column model, value "hertz+jkr+end_at_zero_force": an end condition is only for' \
  "$(ice hertz+jkr+end_at_zero_force)"
solve < <(echo "$names"; ice hertz; echo "hertz,\"open"; ice hertz; ice hertz)
check "quote never closed" all 'status_is 1' 'row_is 1 separated' 'says "line 3: a quoted cell is not closed"'
one "$(with speed '"0,5"')"
check "decimal comma" all 'status_is 1' 'says "line 2, column speed, value \"0,5\": not a number"' 'output_has ",\"0,5\",failed,"'
solve < <(echo model,speed; echo hertz,1)
check "missing column" all 'status_is 1' 'says "line 2, column radius_1: the header has no such column, and every collision needs it"'

# --- bad files and wrong use ------------------------------------------------------------------------------------------
# refused NAME MESSAGE: exit status 2, nothing on standard output
refused() {
  message=$2
  check "$1" all 'status_is 2' 'says "$message"' '[ ! -s "$work/out" ]'
}
solve </dev/null
refused "empty file" "standard input is empty"
solve < <(echo "# only a comment"; echo)
refused "no header" "standard input is empty"
solve < <(ice hertz)
refused "missing column model" 'there is no column "model"'
solve < <(echo "$names" | tr , ';'; ice hertz | tr , ';')
refused "semicolons" "separated by commas"
solve < <(echo "$names, speed "; echo "$(ice hertz),1")
refused "duplicate column" 'columns 17 and 18 are both named "speed"'
for tolerance in 1 1e-13 -1e-6 nan tight; do
  one "$(ice hertz)" --tolerance=$tolerance
  refused "tolerance $tolerance" "tolerance"
done
one "$(ice hertz)" --stepper euler
refused "unknown stepper" "euler"
one "$(ice hertz)" --frobnicate
refused "unknown option" "frobnicate"
solve "$work/nowhere.csv"
refused "no such file" "nowhere.csv cannot be read: No such file or directory"
solve "$work"
refused "a directory" "is a directory"
one "$(ice hertz)" -o "$work/nowhere/out.csv"
refused "output in no directory" "cannot be made"
if [ -w /dev/full ]; then
  "$program" < <(echo "$names"; ice hertz) >/dev/full 2>"$work/err"
  status=$?
  : >"$work/out"
  refused "full disk" "standard output cannot be written"
fi

# --- options ----------------------------------------------------------------------------------------------------------
solve --help
check "--help names every column, law and stepper" all 'status_is 0' \
  'for name in ${names//,/ } hertz jkr greenwood_fit end_at_zero_overlap dopri5 bulirsch_stoer ledger_residual --tolerance -o; do output_has "$name" || return 1; done'
sed -n '/^    model,/,/^$/ s/^    //p' "$work/out" >"$work/ice.csv"
solve "$work/ice.csv"
check "the example of --help" all 'status_is 0' 'row_is 1 separated' 'row_is 2 separated'
cp "$work/out" "$work/expected"
solve "$work/ice.csv" -o "$work/outcomes.csv"
check "-o writes the same to a file, silently" all 'status_is 0' '[ ! -s "$work/out" ]' '[ ! -s "$work/err" ]' \
  'diff <(grep -v "^# command" "$work/expected") <(grep -v "^# command" "$work/outcomes.csv")' \
  'grep -q "^# command: collisions .*ice.csv -o .*outcomes.csv$" "$work/outcomes.csv"'
check "-o leaves no other file" all '[ -z "$(ls "$work" | grep part)" ]'
cp "$work/ice.csv" "$work/same.csv"
solve "$work/same.csv" --output "$work/same.csv"
check "-o onto the input" all 'status_is 0' 'grep -q "^# ricochet" "$work/same.csv"' '[ "$(grep -c separated "$work/same.csv")" = 2 ]'
ln -s same.csv "$work/link.csv"
solve "$work/ice.csv" -o "$work/link.csv"
check "-o onto a symbolic link writes the file it names" all 'status_is 0' '[ -L "$work/link.csv" ]'
solve "$work/ice.csv" -o /dev/null
check "-o /dev/null leaves the device" all 'status_is 0' '[ -c /dev/null ]'
echo kept >"$work/kept.csv"
mkfifo "$work/pipe"
exec 3<>"$work/pipe" # stays open, so that the program waits for more
cat "$work/ice.csv" >&3
"$program" -o "$work/kept.csv" <"$work/pipe" 2>/dev/null &
for _ in $(seq 100); do
  ls "$work"/kept.csv.*.part >/dev/null 2>&1 && break
  sleep 0.05
done
part=$(ls "$work" | grep '^kept.csv.*part$')
kill -TERM $!
wait $! 2>/dev/null
exec 3>&-
check "interrupted: the old file stays, no half file" all '[ -n "$part" ]' '[ "$(cat "$work/kept.csv")" = kept ]' '[ ! -e "$work/$part" ]'

# --- reference --------------------------------------------------------------------------------------------------------
for file in viscoelastic_jkr other_compositions; do
  table=$root/tests/data/$file.csv
  if [ ! -e "$table" ]; then
    echo "skipped $file: $table is not there"
    continue
  fi
  solve "$table"
  check "$file: exit status 0" status_is 0
  # Of the rows with modulus_ratio 0.9 and 0.5 the reference stops the edge at a finite fraction of its limiting ratio.
  check "$file: every ending, every restitution within 1e-9" awk -F, '
    /^#/ { next }
    !header { header = NR; for (i = 1; i <= NF; ++i) at[$i] = i; next }
    at["modulus_ratio"] && ($at["modulus_ratio"] == 0.9 || $at["modulus_ratio"] == 0.5) { next }
    { ++rows; d = $at["restitution"] - $at["input_restitution"] }
    $at["ending"] != $at["input_ending"] || d * d > 1e-18 { print "        row", NR - header, $at["model"], $at["ending"], d; bad = 1 }
    END { exit bad || rows < 20 }' "$work/out"
done

echo "$passed passed, $failed failed"
[ "$failed" = 0 ]
