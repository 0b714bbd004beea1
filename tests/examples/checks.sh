# shellcheck shell=bash
# Sourced by the tests of the program `collisions`, which are called so: TEST PROGRAM REPOSITORY
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
only_warned() { ! grep -qv 'see the column warnings$' "$work/err"; } # nothing else on standard error
output_has() { grep -qF -- "$1" "$work/out"; }
status_is() { [ "$status" = "$1" ]; }
row_is() { [ "$(cell "$1" ending)" = "$2" ]; }
cell_is() { [ "$(cell "$1" "$2")" = "$3" ]; }
holds() { awk "BEGIN { exit !($1) }"; }
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

# The last line of each test.
done_with_checks() {
  echo "$passed passed, $failed failed"
  [ "$failed" = 0 ]
}
