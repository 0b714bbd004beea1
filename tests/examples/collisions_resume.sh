#!/usr/bin/env bash
# Tests that an interrupted run of `collisions` leaves no half file under the final name, and that the same command goes
# on where it stopped: collisions_resume.sh PROGRAM REPOSITORY
set -u
source "$(dirname "$0")/checks.sh"

columns=model,radius_1,radius_2,density_1,youngs_modulus_1,youngs_modulus_2,poissons_ratio_1,poissons_ratio_2,speed,label
good=hertz,2e-6,inf,1000,7e9,7e9,0.25,0.25
cd "$work" || exit 1
{
  echo "# a comment"
  echo "$columns"
  for v in 1 2 3 4 5 6 7 8 9; do echo "$good,$v,row $v"; done
  echo "$good,-1,\"bad \"\"one\"\"\""
  printf '%s\n' "$good,11,\"two" "lines, one row\"" "$good,12,broken\"quote" "$good,13,last"
} >rows.csv
solve rows.csv -o out.csv
check "a whole run leaves no .part" all 'status_is 1' '[ ! -e out.csv.part ]' '[ -e out.csv ]'
mv out.csv whole.csv
cp "$work/err" whole.err

# again BYTES: the same command on what a run has left that was killed after so many bytes
again() {
  rm -f out.csv
  head -c "$1" whole.csv >out.csv.part
  solve rows.csv -o out.csv
}
# --- where it stopped -------------------------------------------------------------------------------------------------
size=$(wc -c <whole.csv)
wrong=0
for bytes in $(seq 0 37 "$size") $((size - 1)) "$size"; do
  again "$bytes"
  { [ "$status" = 1 ] && cmp -s out.csv whole.csv && [ ! -e out.csv.part ]; } || wrong=$((wrong + 1))
done
check "cut anywhere, the whole comes out the same" [ "$wrong" = 0 ]
head_size=$(sed '/^model,/q' whole.csv | wc -c)
again "$head_size"
check "nothing kept behind the head: silence about it" all '! says "going on"' 'diff "$work/err" whole.err'
again "$size"
check "everything kept: no row is solved again" all 'says "collisions: going on after 13 rows kept in out.csv.part, 2 of them failed or unresolved"' \
  '[ "$(wc -l <"$work/err")" = 1 ]' 'status_is 1'
head -n -1 whole.csv | sed 's/\(,4,row 4,separated\),[^,]*/\1,0.5/' >out.csv.part
solve rows.csv -o out.csv
check "what is kept is not solved again" all 'grep -q "row 4,separated,0.5," out.csv' '[ "$(wc -l <out.csv)" = "$(wc -l <whole.csv)" ]'
head -c $((size / 2)) whole.csv | sed 's/command: .*/command: collisions -o out.csv/' >out.csv.part
solve -o out.csv <rows.csv
check "from standard input" all 'status_is 1' 'says "going on after"' 'diff <(grep -v "^# command" out.csv) <(grep -v "^# command" whole.csv)'

# --- what is of another run -------------------------------------------------------------------------------------------
# refused NAME MESSAGE: exit status 2, and what was left stays as it is
refused() {
  message=$2
  check "$1" all 'status_is 2' 'says "$message"' 'says "to begin anew delete it, or name another output"' \
    'cmp -s out.csv.part left' '[ "$(wc -l <"$work/err")" = 1 ]' '[ "$(cat out.csv)" = old ]'
}
echo old >out.csv
head -c $((size - 100)) whole.csv >left
cp left out.csv.part
solve rows.csv -o out.csv --tolerance 1e-6
refused "other options" 'it has the line "# command: collisions rows.csv -o out.csv" where this one has "# command: collisions rows.csv -o out.csv --tolerance'
cp rows.csv kept.csv
sed 's/,3,row 3/,3.5,row 3/' kept.csv >rows.csv
solve rows.csv -o out.csv
refused "another row" "its line 8 is not that of the input's line 5"
sed 's/a comment/another/' kept.csv >rows.csv
solve rows.csv -o out.csv
refused "another comment" 'it has the line "# a comment" where this one has "# another"'
head -n 7 kept.csv >rows.csv
solve rows.csv -o out.csv
refused "fewer rows" "it has rows from its line 11 on that the input has not"
cp kept.csv rows.csv
echo "no table" | tee left >out.csv.part
solve rows.csv -o out.csv
refused "no output at all" 'it has the line "no table" where'
sed 's/ricochet [0-9.]*/ricochet 0.0.9/' whole.csv | tee left >out.csv.part
solve rows.csv -o out.csv
refused "another version" 'it has the line "# ricochet 0.0.9 collisions" where'
rm out.csv.part
mkdir out.csv.part
solve rows.csv -o out.csv
check "no file at all" all 'status_is 2' 'says "out.csv.part cannot be made: Is a directory"' '[ "$(cat out.csv)" = old ]'
rmdir out.csv.part

# --- interruptions ----------------------------------------------------------------------------------------------------
mkfifo pipe
# start: a run in the background that waits for more rows, its number in $run
start() {
  rm -f out.csv.part
  exec 3<>pipe # stays open
  env --default-signal=INT "$program" -o out.csv <pipe >"$work/out" 2>"$work/err" & # bash would have it ignored
  run=$!
  cat rows.csv >&3
  for _ in $(seq 200); do
    grep -q '^model' out.csv.part 2>/dev/null && break
    sleep 0.05
  done
}
for signal in INT TERM HUP KILL; do
  start
  if [ $signal = INT ]; then # a second run at the same time
    "$program" -o out.csv <rows.csv >/dev/null 2>second
    second=$?
  fi
  kill -$signal $run
  wait $run 2>/dev/null
  status=$?
  exec 3>&-
  check "SIG$signal: the old file stays, the rows are kept" all '[ "$(cat out.csv)" = old ]' 'grep -q "^# ricochet" out.csv.part' \
    'holds "$status > 128"' '[ $signal = KILL ] || says "interrupted; the rows done are kept in $(pwd -P)/out.csv.part, and the same command goes on from there"'
done
check "a second run at the same time is refused" all '[ "$second" = 2 ]' 'grep -q "out.csv is being written by another run" second'
solve -o out.csv <rows.csv
check "after the last, the same command ends it" all 'status_is 1' '[ ! -e out.csv.part ]' \
  'diff <(grep -v "^# command" out.csv) <(grep -v "^# command" whole.csv)'
echo old >out.csv
{ cat rows.csv; for i in $(seq 200); do echo "$good,$i,more"; done; } >many.csv
(
  trap '' XFSZ # as a full disk, writing fails
  ulimit -f 8
  "$program" many.csv -o out.csv 2>"$work/err"
)
status=$?
check "a full disk: the old file stays, the rows are kept" all 'status_is 2' '[ "$(cat out.csv)" = old ]' \
  'says "out.csv cannot be written: File too large; the rows done are kept in $(pwd -P)/out.csv.part, and the same command goes on"' \
  '[ "$(wc -c <out.csv.part)" -ge 4096 ]'
solve many.csv -o out.csv
check "with space again, the same command ends it" all 'status_is 1' 'says "going on after"' '[ ! -e out.csv.part ]' \
  '[ "$(grep -c more,separated, out.csv)" = 200 ]'

done_with_checks
