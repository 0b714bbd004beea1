#!/usr/bin/env bash
# Tests what `collisions` says of damaged tables, and that no other row is lost: collisions_bad_tables.sh PROGRAM REPOSITORY
set -u
source "$(dirname "$0")/checks.sh"

columns=model,radius_1,radius_2,density_1,youngs_modulus_1,youngs_modulus_2,poissons_ratio_1,poissons_ratio_2,speed,label
good=hertz,2e-6,inf,1000,7e9,7e9,0.25,0.25,8
# table LINE...: the program on these lines, read by printf, behind the names of the columns
table() { solve < <(printf "$columns\n"; for line; do printf "$line\n"; done); }
# rows_are ENDING...: of all rows; s, f for separated and failed
rows_are() {
  [ "$(grep -v '^#' "$work/out" | sed 1d | grep -oE 'separated|failed' | cut -c1 | tr -d '\n')" = "$1" ]
}
refused() { # refused NAME MESSAGE: exit status 2, nothing on standard output
  message=$2
  check "$1" all 'status_is 2' 'says "$message"' '[ ! -s "$work/out" ]' '[ "$(wc -l <"$work/err")" = 1 ]'
}

# --- quotes -----------------------------------------------------------------------------------------------------------
open="a quoted cell is not closed by a quote on this line, nor well on those behind it"
table "$good,a" "$good,\"open" "$good,b" "$good,c"
check "a quote left open swallows no other row" all 'status_is 1' 'rows_are sfss' 'says "line 3: $open"'
table "$good,\"open" "$good,\"b\"" "$good,c"
check "nor where a quoted cell comes after it" all 'status_is 1' 'rows_are fss' 'says "line 2: $open"'
table "\"open,2" "$good,b" "x\",1" "$good,c"
check "nor where another orphan closes it" all 'status_is 1' 'rows_are fsfs' 'says "line 2: $open"' 'says "line 4: misplaced quote"'
solve < <(printf "$columns\n$good,\"open\n"; yes "$good,x" | head -n 150)
check "nor many rows" all 'status_is 1' '[ "$(grep -c separated, "$work/out")" = 150 ]' '[ "$(wc -l <"$work/err")" = 1 ]'
table "$good,\"two\\nlines, and \"\"quotes\"\"\"" "$good,b"
check "a cell of two lines is one" all 'status_is 0' 'rows_are ss' 'output_has "lines, and \"\"quotes\"\"\",separated,"'
table "$good,\"a\"b" "$good,a\"b" "$good,\"\"" "$good,b"
check "misplaced quotes" all 'status_is 1' 'rows_are ffss' 'says "line 2: misplaced quote"' 'says "line 3: misplaced quote"'

# --- encodings --------------------------------------------------------------------------------------------------------
table "$good,K\xf6rner" "$good,K\xc3\xb6rner"
check "Latin-1" all 'status_is 1' 'rows_are fs' \
  'says "line 2, column \"label\", value \"K$(printf "\xef\xbf\xbd")rner\": byte 0xF6 is no UTF-8 here: save the file as UTF-8"' \
  'output_has "K$(printf "\xc3\xb6")rner,separated"' '! LC_ALL=C grep -q "$(printf "\xf6")" "$work/out"'
table "$good,a\0b" "${good}\0,c" "\0\0\0" "$good,d"
check "NUL bytes" all 'status_is 1' 'rows_are fffs' 'says "line 2, column \"label\", value"' \
  'says "line 3, column \"speed\", value \"8"' 'says "line 4, column \"model\""' 'says "a NUL byte, so the file is damaged"' \
  '[ "$(tr -d "\0" <"$work/out" | wc -c)" = "$(wc -c <"$work/out")" ]'
table "$good,a\rb" "$good,c"
check "a CR within a line ends it" all 'status_is 1' 'rows_are sfs'
printf "$columns\n$good,a\n" >"$work/utf8"
for encoding in UTF-16 UTF-16LE UTF-16BE UTF-32; do
  iconv -f UTF-8 -t $encoding "$work/utf8" >"$work/other" 2>/dev/null || continue
  solve "$work/other"
  refused "a file in $encoding" "UTF-16"
done
solve < <(printf "K\xf6rner,$columns\n1,$good,a\n")
refused "Latin-1 in the header" "line 1: byte 0xF6 is no UTF-8 here"
solve < <(printf "# K\xf6rner\n$columns\n$good,a\n")
check "Latin-1 in a comment" all 'status_is 0' 'rows_are s' 'output_has "# K"' '! LC_ALL=C grep -q "$(printf "\xf6")" "$work/out"'
long=$(printf '\xc3\xb6%.0s' $(seq 60))
table "$(echo "$good" | sed 's/8$//')$long,a"
check "a message does not end within a character" all 'status_is 1' 'iconv -f UTF-8 -t UTF-8 "$work/err" >/dev/null'

# --- sizes ------------------------------------------------------------------------------------------------------------
solve < <(printf "$columns\n$good,a\n$good,"; head -c 3000000 /dev/zero | tr '\0' x; printf "\n$good,b\n")
check "a very long line" all 'status_is 1' 'rows_are sfs' 'says "line 3: the line is longer than 1048576 bytes"'
solve < <(printf "$columns\n$good,"; head -c 1000000 /dev/zero | tr '\0' x; printf "\n")
check "a long one" all 'status_is 0' 'rows_are s'
solve < <(head -c 3000000 /dev/zero | tr '\0' x)
refused "a header too long" "line 1: the line is longer than 1048576 bytes"
solve < <(printf "$columns\n"; yes "$good," | head -n 20 | tr '\n' ','; printf "\n$good,b\n")
check "a line of many cells" all 'status_is 1' 'rows_are fs' 'says "line 2: the row has 201 cells, the header 10"'
solve < <(printf "$columns\n"; awk -v good="$good" 'BEGIN { for (i = 1; i <= 1000000; ++i) print i % 1000 ? good "," i : "hertz,-1," i }')
check "a million rows, a thousand of them bad" all 'status_is 1' '[ "$(grep -c ",separated," "$work/out")" = 999000 ]' \
  '[ "$(grep -c ",failed," "$work/out")" = 1000 ]' '[ "$(wc -l <"$work/err")" = 1000 ]' \
  'says "line 1000001: the row has 3 cells"'
solve < <(printf "$columns\n$good,a\nhertz,2e-6,in")
check "a truncated table" all 'status_is 1' 'rows_are sf' 'says "line 3: the row has 3 cells, the header 10"'

# --- headers ----------------------------------------------------------------------------------------------------------
solve < <(echo "$columns,speed,label"; echo "$good,,1,2")
refused "a column twice" 'line 1: columns 9 and 11 are both named "speed"'
solve < <(printf '"model,radius_1\n%s,a\n' "$good")
refused "a quote left open in the header" "line 1: $open"

done_with_checks
