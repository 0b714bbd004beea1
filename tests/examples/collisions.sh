#!/usr/bin/env bash
# Tests the program `collisions`: collisions.sh PROGRAM REPOSITORY
set -u
source "$(dirname "$0")/checks.sh"

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

# --- attraction, friction, oblique impacts ----------------------------------------------------------------------------
names_of_friction=$names,line_force,rebound_coefficient,zeta_h,zeta_a,friction,angle,spin_1,spin_2
# grains MODEL [NAME=VALUE]...: one row of two glass spheres with every parameter of the laws given, no ratios; angle
# and spins are blank
grains() {
  local each row="$1,${2}-6,$3,2600,2600,72e9,72e9,0.21,0.21,$laws,3,200,0.02,,,0.1,,,"
  shift 3
  for each; do
    row=$(echo "$row" | awk -F, -v OFS=, -v names="$names_of_friction" -v name="${each%%=*}" -v text="${each#*=}" '
      { n = split(names, all, ","); for (i = 1; i <= n; ++i) if (all[i] == name) $i = text; print }')
  done
  echo "$row"
}
spheres() { grains "$1" 5e 4e-6 "${@:2}"; }
on_wall() { grains "$1" 5e inf "${@:2}"; }
oblique() { solve < <(echo "$names_of_friction"; for row; do echo "$row"; done); }
frictions=tangential_speed,spin_1_after,spin_2_after,tangential_restitution,rebound_angle,impulse_ratio,friction_loss,peeling_loss,rolls,rotation_1,rotation_2,normal_turn
# friction_cells_are_blank ROW
friction_cells_are_blank() {
  local each
  for each in ${frictions//,/ }; do cell_is "$1" "$each" "" || return 1; done
}

models="hertz+coulomb hertz+kuwabara_kono+end_at_zero_overlap+coulomb hertz+jkr+greenwood+kuwabara_kono+coulomb"
for damping in "" +kuwabara_kono +hunt_crossley +tsuji; do
  models="$models hertz+line_force$damping hertz+dmt$damping hertz+line_force$damping+coulomb"
done
row=0
for stepper in automatic dopri5 bulirsch_stoer; do
  solve --tolerance 1e-8 --stepper $stepper < <(echo "$names_of_friction"; for model in $models; do
    case $model in *coulomb*) spheres $model angle=30 spin_2=2e4 ;; *) spheres $model ;; esac
  done)
  check "$stepper, new laws: exit status 0, silence but for warnings" all 'status_is 0' only_warned
  cp "$work/out" "$work/$stepper"
done
for model in $models; do
  row=$((row + 1))
  check "model $model" all "near \"\$(cell $row ledger_residual)\" 0 3e-8" "near \"\$(cell $row error_estimate)\" 0 1e-8" \
    "cell_is $row ending_is_certain 1"
done
check "the steppers agree on them" awk -F, -v count="$row" -v names=restitution,impulse_ratio,tangential_speed '
    /^#/ { next }
    $1 == "model" { for (i = 1; i <= NF; ++i) at[$i] = i; n = split(names, all, ","); next }
    { for (k = 1; k <= n; ++k) { x = $at[all[k]]; if (FILENAME == ARGV[1]) first[$1 all[k]] = x
        else if ((x == "") != (first[$1 all[k]] == "") || (x - first[$1 all[k]])^2 > 1e-14) { print $1, all[k], x, first[$1 all[k]]; bad = 1 } }
      ++rows }
    END { exit bad || rows != 3 * count }' "$work/automatic" "$work/dopri5" "$work/bulirsch_stoer"
check "the output's columns" output_has ",max_tension,max_compression,crack_loss,bulk_loss,plastic_loss,ledger_residual,error_estimate,ending_is_certain,evaluations,$frictions,warnings"

# The README's example: Brach & Dunn 1995, table 1.
brach_dunn() { grains hertz+line_force+hunt_crossley+coulomb 5.06e inf density_2=7800 youngs_modulus_2=207e9 \
  poissons_ratio_2=0.27 speed=2.8 line_force=250 hunt_crossley_coefficient= rebound_coefficient= zeta_h=10.54 zeta_a=6.25 \
  spin_1=1.4557e5 "$@"; }
oblique "$(brach_dunn)"
check "Brach and Dunn's table 1: e = 0.7460, rebound at 5.75 degrees, rolling" all 'status_is 0' 'row_is 1 separated' \
  'near "$(cell 1 restitution)" 0.746005094 1e-9' 'near "$(cell 1 rebound_angle)" 5.75 0.005' 'cell_is 1 rolls 1' \
  'cell_is 1 tangential_restitution ""' 'near "$(cell 1 spin_1_after)" 41591.428571 1e-5' 'cell_is 1 spin_2_after 0' \
  'near "$(cell 1 impulse_ratio)" -0.04304778566 1e-9' 'near "$(cell 1 friction_loss)" 0.01977245932 1e-9' \
  'near "$(cell 1 rotation_1)" 0.00215514845 1e-9' 'cell_is 1 rotation_2 0' 'cell_is 1 normal_turn 0'
compression=$(cell 1 max_compression)
check "the largest compression" near "$compression" 7.5347877741e-4 1e-12
solve < <(sed -n '/^model,.*,friction,/,/^hertz/p' "$root/README.md")
check "the README's example" all 'status_is 0' '[ ! -s "$work/err" ]' 'near "$(cell 1 rebound_angle)" 5.75 0.005' \
  "near \"\$(cell 1 max_compression)\" $compression 1e-12"
oblique "$(brach_dunn angle=60 speed=5.6 friction=0.01)" "$(brach_dunn)"
check "damping ratios hold at the speed along the normal" near "$(cell 1 restitution)" "$(cell 2 restitution)" 1e-9
oblique "$(on_wall hertz+coulomb angle=60 friction=0.05)"
check "sliding throughout: impulse ratio f, e_t = 1 - 2f/tan(angle)" all 'cell_is 1 rolls 0' \
  'near "$(cell 1 impulse_ratio)" 0.05 1e-9' 'near "$(cell 1 tangential_restitution)" 0.94226497308 1e-9' \
  'near "$(cell 1 tangential_speed)" 2.44807621135 1e-9'
oblique "$(on_wall hertz+coulomb angle=40 friction=5 spin_1=1e4)"
check "rolling: (5 v_t + 2 r omega)/7, along surface and by spin" all 'cell_is 1 rolls 1' \
  'near "$(cell 1 tangential_speed)" 1.39168773504 1e-9' 'near "$(cell 1 spin_1_after)" 278337.547008 1e-4'
oblique "$(spheres hertz+coulomb spin_1=1e5)" "$(spheres hertz+coulomb angle=20)"
check "of two spheres both turn, and the normal" all 'holds "$(cell 1 spin_2_after) < 0"' 'holds "$(cell 1 rotation_2) > 0"' \
  'holds "$(cell 2 normal_turn) > 0"'
oblique "$(spheres hertz+coulomb spin_2=1e5)"
check "spin_2 counts" all 'holds "$(cell 1 spin_1_after) < 0"' 'holds "$(cell 1 spin_2_after) < 1e5"' \
  'holds "$(cell 1 spin_2_after) > 0"'
oblique "$(on_wall hertz+line_force+hunt_crossley+coulomb)" "$(on_wall hertz+line_force+hunt_crossley angle=0 spin_1=0 friction=)" \
  "$(on_wall hertz+line_force+hunt_crossley rebound_coefficient= angle=)" "$(on_wall hertz+line_force+hunt_crossley rebound_coefficient=0)"
check "head-on, friction changes nothing; angles and spins of zero need none" all 'status_is 0' \
  '[ "$(cell 1 restitution)" = "$(cell 2 restitution)" ]' 'friction_cells_are_blank 2' \
  'near "$(cell 1 rebound_angle)" 0 0' 'cell_is 1 impulse_ratio 0'
check "no rebound coefficient is one of zero" all '[ "$(cell 3 restitution)" = "$(cell 4 restitution)" ]' \
  '[ "$(cell 3 restitution)" != "$(cell 2 restitution)" ]'
oblique "$(on_wall hertz+jkr+coulomb angle=30 speed=0.01)"
check "captured: friction's columns are filled, but the angle of rebound" all 'status_is 0' 'row_is 1 captured' \
  'cell_is 1 rebound_angle ""' '[ -n "$(cell 1 rolls)" ]' '[ -n "$(cell 1 tangential_speed)" ]'
for each in hertz+mindlin hertz+tsuji+end_at_zero_overlap+mindlin hertz+kuwabara_kono+dmt+mindlin \
  hertz+line_force+hunt_crossley+mindlin; do
  oblique "$(on_wall $each angle=70 friction=0.02)" "$(on_wall ${each/mindlin/coulomb} angle=70 friction=0.02)" \
    "$(on_wall $each angle=20)" "$(on_wall ${each/mindlin/coulomb} angle=20)"
  check "$each: coulomb's where it slides throughout, springs where that rolls" all 'status_is 0' \
    'near "$(cell 1 tangential_speed)" "$(cell 2 tangential_speed)" 1e-6' \
    'near "$(cell 3 restitution)" "$(cell 4 restitution)" 1e-8' 'cell_is 4 rolls 1' \
    'cell_is 3 rolls 0' 'holds "$(cell 3 impulse_ratio) != $(cell 4 impulse_ratio)"'
done
oblique "$(on_wall hertz+mindlin angle=20)"
with_its_solids=$(cell 1 tangential_speed)
solve < <(echo "$names_of_friction,stiffness_ratio"
  for ratio in "" 0.8826815642458101 1; do echo "$(on_wall hertz+mindlin angle=20),$ratio"; done)
check "stiffness_ratio: that of the solids if blank" all 'status_is 0' '[ "$(cell 1 tangential_speed)" = "$with_its_solids" ]' \
  'near "$(cell 2 tangential_speed)" "$with_its_solids" 1e-9' '[ "$(cell 3 tangential_speed)" != "$with_its_solids" ]'
solve --stepper dopri5 < <(echo "$names_of_friction"; on_wall hertz+mindlin angle=20)
check "mindlin with another stepper" all 'status_is 1' 'row_is 1 failed' 'says "mindlin goes with the automatic stepper only"'
solve < <(echo model,radius_1,radius_2,density_1,youngs_modulus_1,youngs_modulus_2,poissons_ratio_1,poissons_ratio_2,friction,speed
  echo hertz+coulomb,1e-3,inf,1000,7e9,7e9,0.25,0.25,0.1,1e-3)
check "columns of angle and spins may be missing" all 'status_is 0' 'row_is 1 separated' 'cell_is 1 spin_1_after 0'

# --- a contact that resists rolling -----------------------------------------------------------------------------------
# peeling MODEL MOMENT [NAME=VALUE]...: a spinning sphere on a wall
peeling() { echo "$(on_wall "$1" spin_1=1e5 angle=20 "${@:3}"),$2"; }
peels() { solve --tolerance 1e-9 "${options[@]}" < <(echo "$names_of_friction,peeling_moment"; for row; do echo "$row"; done); }
options=()
models=""
for damping in "" +kuwabara_kono +hunt_crossley +tsuji; do
  models="$models hertz+line_force$damping+coulomb_with_peeling"
done
peels $(for model in $models; do peeling $model 1e-8; done)
check "peeling: exit status 0, silence but for warnings" all 'status_is 0' only_warned
for row in 1 2 3 4; do
  # friction and moment take what the sphere loses of its motion along the surface and of its spin, 2/5 m r^2
  taken=$(awk -v spin="$(cell $row spin_1_after)" -v vt="$(cell $row tangential_speed)" 'BEGIN {
    r = 5e-6; v = 3; turn = 20 * atan2(0, -1) / 180; n = v * cos(turn); t = v * sin(turn)
    printf "%.17g", (t * t - vt * vt + 0.4 * r * r * (1e10 - spin * spin)) / (n * n) }')
  check "model $(cell $row model): both losses are what the motion along the surface lost" all \
    'holds "$(cell $row peeling_loss) > 1e-6"' 'cell_is $row ending_is_certain 1' \
    'near "$(awk -v f="$(cell $row friction_loss)" -v p="$(cell $row peeling_loss)" "BEGIN { printf \"%.17g\", f + p }")" $taken 1e-8'
done
peels "$(peeling hertz+line_force+coulomb_with_peeling 0)" "$(peeling hertz+line_force+coulomb "")"
check "a moment of zero is coulomb; without the law its loss is blank" all 'status_is 0' 'cell_is 1 peeling_loss 0' \
  'near "$(cell 1 spin_1_after)" "$(cell 2 spin_1_after)" 1e-3' 'near "$(cell 1 tangential_speed)" "$(cell 2 tangential_speed)" 1e-8' \
  'cell_is 2 peeling_loss ""' '[ -n "$(cell 2 friction_loss)" ]'
peels "$(brach_dunn | sed s/coulomb/coulomb_with_peeling/),1e-7" # the numbers are those of a program in C++
check "Brach and Dunn's table 1 with a moment" all 'status_is 0' 'near "$(cell 1 restitution)" 0.746005094 1e-9' \
  'near "$(cell 1 rebound_angle)" 4.3598344017 1e-7' 'near "$(cell 1 spin_1_after)" 31465.2411499 1e-3' \
  'near "$(cell 1 friction_loss)" 0.0170452990729 1e-9' 'near "$(cell 1 peeling_loss)" 0.00610794932767 1e-9'
options=(--stepper dopri5)
peels "$(peeling hertz+line_force+coulomb_with_peeling 1e-8)"
check "peeling with another stepper" all 'status_is 1' 'says "line 2: coulomb_with_peeling goes with the automatic stepper only"'
options=()
peels "$(spheres hertz+line_force+coulomb_with_peeling),1e-8" "$(on_wall hertz+coulomb_with_peeling),1e-8" \
  "$(on_wall hertz+dmt+coulomb_with_peeling),1e-8" "$(peeling hertz+line_force+coulomb_with_peeling "")" \
  "$(peeling hertz+line_force+coulomb_with_peeling -1)" "$(peeling hertz+line_force+coulomb_with_peeling 0 friction=)"
check "peeling, wrong input" all 'status_is 1' 'says "line 2: radius of the second body = 4e-06 m is not that of a flat wall"' \
  'says "line 3, column model, value \"hertz+coulomb_with_peeling\": a peeling moment needs an adhesion law with a rebound"' \
  'says "line 4, column model, value \"hertz+dmt+coulomb_with_peeling\": a peeling moment needs"' \
  'says "line 5, column peeling_moment, value \"\": blank, but needed by coulomb_with_peeling"' \
  'says "line 6, column peeling_moment, value \"-1\": peeling_moment = -1 J is outside [0, inf) J"' \
  'says "line 7, column friction, value \"\": blank, but needed by coulomb_with_peeling"' 'row_is 1 failed' 'row_is 6 failed'

# bad_oblique NAME MESSAGE ROW: the row fails with one message that begins so, and the good row after it does not fail
bad_oblique() {
  message=$2
  oblique "$3" "$(on_wall hertz+coulomb angle=10)"
  check "$1" all 'status_is 1' 'says "collisions: line 2$message"' 'row_is 1 failed' 'friction_cells_are_blank 1' \
    'row_is 2 separated' '[ "$(wc -l <"$work/err")" = 1 ]'
}
bad_oblique "angle without friction" ', column angle, value "10": an oblique impact needs friction: add coulomb or mindlin to the model' \
  "$(on_wall hertz angle=10)"
bad_oblique "spin without friction" ', column spin_1, value "-3": a spin needs friction: add coulomb or mindlin to the model' \
  "$(on_wall hertz spin_1=-3)"
bad_oblique "second spin without friction" ', column spin_2, value "1": a spin needs friction: add coulomb or mindlin to the model' \
  "$(spheres hertz spin_2=1)"
bad_oblique "spinning wall" ', column spin_2, value "1": a flat wall does not spin: leave it blank or 0' \
  "$(on_wall hertz+coulomb spin_2=1)"
bad_oblique "spinning wall without friction" ', column spin_2, value "1": a flat wall does not spin: leave it blank or 0' \
  "$(on_wall hertz spin_2=1)"
for angle in 90 -1 nan inf; do
  bad_oblique "angle $angle" ", column angle, value \"$angle\": angle = $angle is outside [0, 90)" "$(on_wall hertz+coulomb angle=$angle)"
done
bad_oblique "angle in words" ', column angle, value "steep": not a number' "$(on_wall hertz+coulomb angle=steep)"
bad_oblique "infinite spin" ', column spin_1, value "inf": spin_1 = inf' "$(on_wall hertz+coulomb spin_1=inf)"
bad_oblique "no friction coefficient" ', column friction, value "": blank, but needed by coulomb' "$(on_wall hertz+coulomb friction=)"
bad_oblique "negative friction" ', column friction, value "-1": friction = -1 is outside [0, inf)' "$(on_wall hertz+coulomb friction=-1)"
bad_oblique "no line force" ', column line_force, value "": blank, but needed by line_force' "$(on_wall hertz+line_force line_force=)"
bad_oblique "dmt without work of adhesion" ', column work_of_adhesion, value "": blank, but needed by dmt' \
  "$(on_wall hertz+dmt work_of_adhesion=)"
bad_oblique "damping ratio and coefficient" \
  ', column zeta_h, value "10": hunt_crossley_coefficient is given too, and says the same: keep one of the two' \
  "$(on_wall hertz+hunt_crossley zeta_h=10)"
bad_oblique "damping ratio and coefficient of the rebound" \
  ', column zeta_a, value "6": rebound_coefficient is given too, and says the same: keep one of the two' \
  "$(on_wall hertz+line_force zeta_a=6)"
bad_oblique "neither ratio nor coefficient" \
  ', column hunt_crossley_coefficient, value "": blank, but needed by hunt_crossley, unless there is zeta_h' \
  "$(on_wall hertz+hunt_crossley hunt_crossley_coefficient=)"
bad_oblique "negative damping ratio" ', column zeta_h, value "-1": zeta_h = -1 is outside [0, inf)' \
  "$(on_wall hertz+hunt_crossley hunt_crossley_coefficient= zeta_h=-1)"
bad_oblique "stick and slip with jkr" ', column model, value "hertz+jkr+mindlin": a tangential law with stick and slip' \
  "$(on_wall hertz+jkr+mindlin)"
bad_oblique "no friction coefficient of mindlin" ', column friction, value "": blank, but needed by mindlin' \
  "$(on_wall hertz+mindlin friction=)"
bad_oblique "two adhesion laws" ', column model, value "hertz+jkr+dmt": two adhesion laws were given' "$(on_wall hertz+jkr+dmt)"
bad_oblique "crack law with an attraction" ', column model, value "hertz+dmt+greenwood": a crack-velocity law needs' \
  "$(on_wall hertz+dmt+greenwood)"
bad_oblique "end condition with an attraction" ', column model, value "hertz+line_force+end_at_zero_overlap": an end condition' \
  "$(on_wall hertz+line_force+end_at_zero_overlap)"
bad_oblique "friction twice" ', column model, value "hertz+coulomb+coulomb": two tangential laws were given' "$(on_wall hertz+coulomb+coulomb)"
oblique "$(on_wall hertz+jkr+greenwood zeta_h=10 zeta_a=6)"
check "ratios that the model does not need are not looked at" all 'status_is 0' only_warned
check "a law outside its range: sentence in the last column, and a note" all \
  'output_has ",\"the Tabor number is "' 'says "note: 1 of the rows uses laws outside their range; see the column warnings"'
oblique "$(on_wall hertz)"
check "laws within their range: no warning" all '[ ! -s "$work/err" ]' '[[ "$(tail -n 1 "$work/out")" == *, ]]'

# --- misspelt columns -------------------------------------------------------------------------------------------------
# misspelt NAME MEANT: among good columns, this one gets this note, and the rows are computed
misspelt() {
  note="collisions: column \"$1\" is copied through: did you mean $2?"
  solve < <(echo "$names,$1"; ice hertz | sed 's/$/,7/')
  check "misspelt: $1" all 'status_is 0' 'row_is 1 separated' 'says "$note"' '[ "$(wc -l <"$work/err")" = 1 ]' \
    'output_has "8,7,separated,"'
}
misspelt poisons_ratio_1 poissons_ratio_1
misspelt poisson_ratio_2 poissons_ratio_2
misspelt sped speed
misspelt speeed speed
misspelt Angle angle
misspelt spin1 spin_1
misspelt line_froce line_force
misspelt frictions friction
misspelt zeta_A zeta_a
misspelt stifness stiffness
solve < <(echo "$names" | sed 's/,speed/,sped/'; ice hertz)
check "a misspelt column that is needed: note and error" all 'status_is 1' 'says "did you mean speed?"' \
  'says "line 2, column speed: the header has no such column"'
solve < <(echo "$names,label,particle,zeta_hertz,,run,theta"; ice hertz | sed 's/$/,a,b,c,d,e,f/')
check "other columns are copied silently" all 'status_is 0' '[ ! -s "$work/err" ]'
cp "$work/out" "$work/again.csv"
solve "$work/again.csv"
check "so are those of an output" all 'status_is 0' '[ ! -s "$work/err" ]'

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

# --- plastic flow -----------------------------------------------------------------------------------------------------
plastic() { solve --tolerance 1e-9 < <(echo "$names,yield_strength"; for model; do echo "$(ice $model),200e6"; done); }
plastic hertz hertz+thornton_ning hertz+jkr+kuwabara_kono hertz+thornton_ning+jkr+kuwabara_kono
check "plastic flow: exit status 0, silence" all 'status_is 0' '[ ! -s "$work/err" ]'
check "its loss is blank without the law" cell_is 1 plastic_loss ""
loss=0.19653447866 # closed form: 1 - 0.89636238282511^2
check "plastic flow alone" all 'near "$(cell 2 restitution)" 0.89636238282511 1e-9' 'near "$(cell 2 plastic_loss)" $loss 1e-9'
check "plastic flow is added to the other losses" near "$(cell 4 restitution)" \
  "$(awk -v e="$(cell 3 restitution)" -v p=$loss 'BEGIN { printf "%.17g", sqrt(e * e - p) }')" 1e-8
solve < <(echo "$names,yield_strength"; echo "$(ice hertz+jkr+thornton_ning 1.6),2e6")
check "what it leaves may be nothing: captured" all 'row_is 1 captured' 'cell_is 1 restitution 0'
solve < <(echo "$names,friction,yield_strength"; echo "$(ice hertz+coulomb+thornton_ning),0.1,2e8")
check "not with friction" all 'status_is 1' 'says "plastic flow is added to the normal motion only"'
solve < <(echo "$names,yield_strength"; echo "$(ice hertz+thornton_ning),"; echo "$(ice hertz+thornton_ning),0")
check "it needs its strength" all 'status_is 1' 'says "line 2, column yield_strength, value \"\": blank, but needed by thornton_ning"' \
  'says "line 3, column yield_strength, value \"0\": yield_strength = 0 Pa is outside (0, inf) Pa"'

# --- plastic flow within the motion -----------------------------------------------------------------------------------
models="hertz+thornton_ning_contact+end_at_zero_overlap"
for damping in "" +kuwabara_kono +hunt_crossley +tsuji; do
  models="$models hertz$damping+thornton_ning_contact hertz+jkr$damping+thornton_ning_contact"
done
plastic $models
check "flow within the motion: exit status 0, silence" all 'status_is 0' '[ ! -s "$work/err" ]'
row=0
for model in $models; do
  row=$((row + 1))
  check "model $model" all "row_is $row separated" "near \"\$(cell $row ledger_residual)\" 0 3e-8" \
    "holds \"\$(cell $row plastic_loss) > 0.1\"" "near \"\$(cell $row error_estimate)\" 0 1e-9"
done
check "alone it is the closed form" all 'near "$(cell 2 restitution)" 0.89636238282511 1e-9' 'near "$(cell 2 plastic_loss)" $loss 1e-9'
# the numbers are those of a program in C++, by dopri5
check "with jkr and kuwabara_kono" all 'cell_is 5 model hertz+jkr+kuwabara_kono+thornton_ning_contact' \
  'near "$(cell 5 restitution)" 0.7366394193048 1e-9' 'near "$(cell 5 plastic_loss)" 0.2399770965298 1e-8'
solve --stepper bulirsch_stoer < <(echo "$names,yield_strength"; echo "$(ice hertz+thornton_ning_contact),2e8")
check "flow with another stepper" all 'status_is 1' 'says "line 2: thornton_ning_contact goes with the automatic stepper only"'
solve < <(echo "$names,friction,yield_strength"; echo "$(ice hertz+coulomb+thornton_ning_contact),0.1,2e8"
  echo "$(ice hertz+jkr+greenwood+thornton_ning_contact),,2e8"; echo "$(ice hertz+dmt+thornton_ning_contact),,2e8"
  echo "$(ice hertz+thornton_ning+thornton_ning_contact),,2e8"; echo "$(ice hertz+thornton_ning_contact),,"
  echo "$(ice hertz+jkr+thornton_ning_contact),,2e6")
check "flow, wrong input" all 'status_is 1' 'says "line 2, column model, value \"hertz+coulomb+thornton_ning_contact\": plastic flow is added"' \
  'says "line 3, column model, value \"hertz+jkr+greenwood+thornton_ning_contact\": plastic flow within the motion goes with a static"' \
  'says "line 4, column model, value \"hertz+dmt+thornton_ning_contact\": plastic flow within the motion goes with an"' \
  'says "line 5, column model, value \"hertz+thornton_ning+thornton_ning_contact\": two plasticity laws were given"' \
  'says "line 6, column yield_strength, value \"\": blank, but needed by thornton_ning_contact"' \
  'says "line 7: yield_strength = 2000000 Pa is below"' 'row_is 1 failed' 'row_is 6 failed'

# --- linear springs ---------------------------------------------------------------------------------------------------
# linear MODEL...: rows of springs of 500 N/m with a dashpot of zeta = 0.3, given as such
linear() { solve --tolerance 1e-9 "${options[@]}" < <(echo "$names,stiffness,dashpot_coefficient,zeta"; for model; do echo "$(ice $model),500,,0.3"; done); }
linear linear linear+end_at_zero_overlap linear+linear_dashpot linear_dashpot+end_at_zero_overlap+linear
check "linear springs: exit status 0, silence" all 'status_is 0' '[ ! -s "$work/err" ]'
mass=$(awk 'BEGIN { printf "%.17g", 2. / 3 * atan2(0, -1) * 8e-15 }') # of the pair: half that of one sphere
spring() { awk -v z=0.3 -v m=$mass -v k=500 "BEGIN { pi = atan2(0, -1); s = sqrt(1 - z * z); w = sqrt(k / m); printf \"%.17g\", $1 }"; }
# near_part A B: relatively
near_part() { awk -v x="$1" -v y="$2" 'BEGIN { exit !(x != "" && (x / y - 1)^2 <= 1e-16) }'; }
for row in 1 2; do
  check "a spring in closed form, $(cell $row model)" all 'near "$(cell $row restitution)" 1 1e-9' \
    'near_part "$(cell $row contact_duration)" "$(spring "pi / w")"' 'near_part "$(cell $row max_approach)" "$(spring "8 / w")"' \
    'near_part "$(cell $row max_compression)" "$(spring "8 * k / w")"' 'near "$(cell $row bulk_loss)" 0 1e-30'
done
check "spring and dashpot to zero force: exp(-2 zeta acos(zeta)/s)" all \
  'near "$(cell 3 restitution)" "$(spring "exp(-2 * z * atan2(s, z) / s)")" 1e-9' \
  'near_part "$(cell 3 contact_duration)" "$(spring "2 * atan2(s, z) / (s * w)")"' 'near "$(cell 3 ledger_residual)" 0 1e-8'
check "spring and dashpot to zero overlap: exp(-pi zeta/s)" all \
  'near "$(cell 4 restitution)" "$(spring "exp(-pi * z / s)")" 1e-9' 'near_part "$(cell 4 contact_duration)" "$(spring "pi / (s * w)")"'
solve < <(echo "$names,stiffness,dashpot_coefficient"; echo "$(ice linear+linear_dashpot),500,$(spring "2 * z * sqrt(m * k)")"
  echo "$(ice linear+linear_dashpot 1),500,$(spring "2 * z * sqrt(m * k)")")
check "the same by the dashpot's coefficient, at any speed" all 'status_is 0' \
  'near "$(cell 1 restitution)" "$(spring "exp(-2 * z * atan2(s, z) / s)")" 1e-7' 'near "$(cell 1 restitution)" "$(cell 2 restitution)" 1e-7'
solve < <(echo "$names,stiffness,dashpot_coefficient,zeta,friction,angle"; echo "$(ice linear+coulomb),500,,,0.05,60")
check "springs slide: e_t = 1 - 2f/tan(angle)" near "$(cell 1 tangential_restitution)" 0.94226497308 1e-8
options=(--stepper dopri5)
linear linear
check "linear with another stepper" all 'status_is 1' 'says "line 2: linear goes with the automatic stepper only"'
options=()
linear linear+jkr linear+dmt linear+tsuji hertz+linear_dashpot linear+mindlin linear+thornton_ning hertz+linear
check "linear, models that are refused" all 'status_is 1' '[ "$(wc -l <"$work/err")" = 7 ]' \
  'says "line 2, column model, value \"linear+jkr\": an adhesion law with a surface energy needs an elastic law with an edge"' \
  'says "line 3, column model, value \"linear+dmt\": linear goes without adhesion here"' \
  'says "line 4, column model, value \"linear+tsuji\": linear goes without damping or with linear_dashpot here"' \
  'says "line 5, column model, value \"hertz+linear_dashpot\": linear_dashpot goes with linear here"' \
  'says "line 6, column model, value \"linear+mindlin\": stick and slip is that of a Hertzian contact"' \
  'says "line 7, column model, value \"linear+thornton_ning\": plastic flow is added to Hertzian contacts only"' \
  'says "line 8, column model, value \"hertz+linear\": two elastic laws were given"'
solve < <(echo "$names,stiffness,dashpot_coefficient,zeta"; echo "$(ice linear),,,"; echo "$(ice linear),0,,"
  echo "$(ice linear+linear_dashpot),50,,"; echo "$(ice linear+linear_dashpot),50,1e-9,0.3"
  echo "$(ice linear+linear_dashpot),50,-1,"; echo "$(ice linear_dashpot+linear),50,,-1"; echo "$(ice linear_dashpot+linear),,,1")
check "linear, wrong numbers" all 'status_is 1' '[ "$(wc -l <"$work/err")" = 7 ]' \
  'says "line 2, column stiffness, value \"\": blank, but needed by linear"' \
  'says "line 3, column stiffness, value \"0\": stiffness = 0 J/m^2 is outside (0, inf) J/m^2"' \
  'says "line 4, column dashpot_coefficient, value \"\": blank, but needed by linear_dashpot, unless there is zeta"' \
  'says "line 5, column zeta, value \"0.3\": dashpot_coefficient is given too, and says the same: keep one of the two"' \
  'says "line 6, column dashpot_coefficient, value \"-1\": dashpot_coefficient = -1 N s/m is outside [0, inf) N s/m"' \
  'says "line 7, column zeta, value \"-1\": zeta = -1 is outside [0, inf)"' \
  'says "line 8, column stiffness, value \"\": blank, but needed by linear"'

# --- the power law of the edge ----------------------------------------------------------------------------------------
# power_law SPEED EXPONENT MODEL...
power_law() { solve --tolerance 1e-9 "${options[@]}" < <(echo "$names,reference_speed,exponent"; for model in "${@:3}"; do echo "$(ice $model),$1,$2"; done); }
models=""
for damping in "" +kuwabara_kono +hunt_crossley +tsuji; do
  models="$models hertz+jkr+maugis_barquins$damping"
done
power_law 100 0.5 $models
check "the power law: exit status 0, silence" all 'status_is 0' '[ ! -s "$work/err" ]'
for row in 1 2 3 4; do
  check "model $(cell $row model)" all 'row_is $row separated' 'near "$(cell $row ledger_residual)" 0 3e-8' \
    'near "$(cell $row error_estimate)" 0 1e-9' 'holds "$(cell $row crack_loss) > 0"'
done
check "with kuwabara_kono, as a program in C++ has it" near "$(cell 2 restitution)" 0.7568678916463 1e-9
power_law 1e6 1 hertz+jkr+maugis_barquins hertz+jkr
check "a fast edge is a static one" near "$(cell 1 restitution)" "$(cell 2 restitution)" 1e-3
options=(--stepper dopri5)
power_law 1 0.5 hertz+jkr+maugis_barquins
check "the power law with another stepper" all 'status_is 1' 'says "line 2: maugis_barquins goes with the automatic stepper only"'
options=()
power_law 1 0.05 hertz+jkr+maugis_barquins hertz+maugis_barquins hertz+jkr+greenwood+maugis_barquins
check "the power law, wrong input" all 'status_is 1' \
  'says "line 2, column exponent, value \"0.05\": exponent = 0.05 is outside [0.1, 1]"' \
  'says "line 3, column model, value \"hertz+maugis_barquins\": a crack-velocity law needs an adhesion law"' \
  'says "line 4, column model, value \"hertz+jkr+greenwood+maugis_barquins\": two crack-velocity laws were given"'
power_law "" 0.5 hertz+jkr+maugis_barquins
check "the power law without its speed" says 'line 2, column reference_speed, value "": blank, but needed by maugis_barquins'

# --- adhesion with a range of its own ---------------------------------------------------------------------------------
# cohesive MODEL...: at this range of adhesion, 5 nm unless given
range=5e-9
cohesive() {
  solve --tolerance 1e-9 "${options[@]}" < <(
    echo "${names/interaction_range/other},interaction_range,yield_strength"
    for model in "$@"; do echo "$(ice $model),$range,2e9"; done)
}
models=""
for damping in "" +kuwabara_kono +hunt_crossley +tsuji; do
  models="$models hertz+maugis_dugdale$damping"
done
cohesive $models hertz+maugis_dugdale+thornton_ning
check "maugis_dugdale: exit status 0, silence" all 'status_is 0' '[ ! -s "$work/err" ]'
for row in 1 2 3 4 5; do
  check "model $(cell $row model)" all 'row_is $row separated' 'near "$(cell $row ledger_residual)" 0 1e-8' \
    'near "$(cell $row error_estimate)" 0 1e-9' 'holds "$(cell $row crack_loss) > 0"' '[ -z "$(cell $row warnings)" ]'
done
options=(--stepper dopri5)
cohesive hertz+maugis_dugdale
check "maugis_dugdale with another stepper" says "line 2: maugis_dugdale goes with the automatic stepper only"
options=()
cohesive hertz+maugis_dugdale+coulomb hertz+maugis_dugdale+greenwood
check "maugis_dugdale, wrong input" all 'status_is 1' \
  'says "line 2, column model, value \"hertz+maugis_dugdale+coulomb\": a contact with a cohesive zone moves along"' \
  'says "line 3, column model, value \"hertz+maugis_dugdale+greenwood\": a crack-velocity law needs an adhesion law"'
range=1
cohesive hertz+maugis_dugdale
check "maugis_dugdale of too long a range" says 'line 2, column interaction_range, value "1": transition_parameter = '

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
bad "quantities impossible together" ': first sphere: mass = inf kg is outside' "hertz,1e200,1e200${bodies#2e-6,2e-6},$laws,8"
bad "too few cells" ': the row has 3 cells, the header 17' "hertz,1,1"
bad "too many cells" ': the row has 19 cells, the header 17' "$(ice hertz),1,2"
bad "misplaced quote" ': misplaced quote' "her\"tz,1,1"
bad "unknown law" ', column model, value "hertz+hurtz": unknown law "hurtz"; there are hertz, linear, jkr,' "$(ice hertz+hurtz)"
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
check "quote never closed" all 'status_is 1' 'row_is 1 separated' 'row_is 2 failed' 'row_is 3 separated' 'row_is 4 separated' 'says "line 3: a quoted cell is not closed"'
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
check "... of which nothing is kept" all '! says "are kept in"'
if [ -w /dev/full ]; then
  "$program" < <(echo "$names"; ice hertz) >/dev/full 2>"$work/err"
  status=$?
  : >"$work/out"
  refused "full disk" "standard output cannot be written"
fi

# --- options ----------------------------------------------------------------------------------------------------------
solve --help
check "--help names every column, law and stepper" all 'status_is 0' \
  'for name in ${names//,/ } ${names_of_friction//,/ } ${frictions//,/ } max_compression ending_is_certain hertz jkr greenwood_fit line_force dmt coulomb thornton_ning yield_strength linear linear_dashpot stiffness dashpot_coefficient zeta maugis_barquins reference_speed exponent thornton_ning_contact coulomb_with_peeling peeling_moment plastic_loss end_at_zero_overlap dopri5 bulirsch_stoer ledger_residual --tolerance -o; do output_has "$name" || return 1; done'
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

table=$root/tests/data/brach_dunn.csv
if [ ! -e "$table" ]; then
  echo "skipped brach_dunn: $table is not there"
else
  solve "$table"
  check "brach_dunn: exit status 0, silence" all 'status_is 0' '[ ! -s "$work/err" ]'
  check "brach_dunn: every ending, restitution, approach and duration within 1e-9" awk -F, '
    /^#/ { next }
    !header { header = NR; for (i = 1; i <= NF; ++i) at[$i] = i; next }
    function off(name) { return $at[name] == "" ? 1 : $at[name] / $at["input_" name] - 1 }
    { ++rows; d = $at["restitution"] - $at["input_restitution"]; h = off("max_approach")
      t = $at["input_contact_duration"] == "" ? 0 : off("contact_duration") } # none of captured pairs
    $at["ending"] != $at["input_ending"] || d * d > 1e-18 || h * h > 1e-18 || t * t > 1e-18 {
      print "        row", NR - header, $at["ending"], d, h, t; bad = 1 }
    END { exit bad || rows != 20 }' "$work/out"
fi

done_with_checks
