#!/usr/bin/env bash
# Plans for the arms and the point of testcases/bodies and prints the tables of docs/bodies.md.
#   bodies.sh arms-plane|arms-map|arms-best|arms-workshop|point|rrt-star|pictures [SEEDS]
# ASV_BIN: folder of the programs. Every path passes asv-validate --continuous, or the script fails.
set -euo pipefail
root=$(cd "$(dirname "$0")/../.." && pwd)
bin=${ASV_BIN:-"$root/build/release/bin"}
cases=$root/testcases/bodies
table=$1
seeds=${2:-20}
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

number() { sed -n "s/^  \"$1\": \([-0-9.e+]*\),*$/\1/p" "$work/stats.json"; }
vertices() { tr -d '\n ' < "$work/stats.json" | sed 's/.*"tree_nodes":\[\([0-9]*\),\([0-9]*\)\].*/\1 \2/' | awk '{print $1 + $2}'; }

# plan CASE PLANNER OPTIONS...: one row for each seed that solves it, in $work/rows: 1 first cost, 2 cost,
# 3 vertices, 4 seconds to the first path, 5 lower bound, 6 cost that the search ended with, 7 seconds.
plan() {
    local case=$1 planner=$2
    shift 2
    : > "$work/rows"
    for ((seed = 1; seed <= seeds; ++seed)); do
        "$bin/asv-solve" "$cases/$case.json" "$work/s.txt" --planner "$planner" --seed "$seed" \
            --threads 1 --stats "$work/stats.json" --quiet "$@" || continue
        "$bin/asv-validate" "$cases/$case.json" "$work/s.txt" --continuous --quiet > "$work/verdict" ||
            { cat "$work/verdict" >&2; exit 1; }
        echo "$(number cost_first) $(number cost) $(vertices) $(number time_to_first_s) $(number cost_lower_bound) $(number cost_of_search) $(number time_total_s)" >> "$work/rows"
    done
}

# mean COLUMN FORMAT, and the least and the greatest of a column.
mean() { awk -v c="$1" -v f="$2" '{s += $c} END {if (NR) printf f, s / NR; else printf "-"}' "$work/rows"; }
extreme() { sort -g -k "$1,$1" "$work/rows" | awk -v c="$1" -v w="$2" '{v[NR] = $c} END {printf "%.4f", v[w == "least" ? 1 : NR]}'; }
solved() { printf '%s of %s' "$(wc -l < "$work/rows")" "$seeds"; }

# The planners for the point and their settings; with fewer samples for pictures.
point_settings() {
    local fewer=${1:-}
    # Two of three cells of the town are free.
    echo "prm-grid --set grid-cells=${fewer:-1000} --set samples=$((${fewer:-1000} * 63 / 100))"
    echo "prm-random --set samples=${fewer:-1000}"
    echo "prm-gaussian --set samples=${fewer:-2000} --set sigma=10"
    echo "prm-bridge --set samples=${fewer:-1000} --set sigma=15"
    echo "rrt --set step=10 --set goal-bias=0.05"
    echo "rrt-star --set step=10 --set goal-bias=0.1 --set radius=20 --set nodes=$((${fewer:+1}0 ? 1000 : 2000))"
}

case $table in
arms-plane)
    printf '| joints | planner | solved | least cost | greatest cost | vertices | ms |\n|---|---|---|---|---|---|---|\n'
    for n in 1 3 4 5 6; do
        for planner in rrt rrt-connect; do
            plan "arm-$n-plane" $planner --optimize 0
            printf '| %s | %s | %s | %s | %s | %s | %s |\n' $n $planner "$(solved)" "$(extreme 2 least)" \
                "$(extreme 2 greatest)" "$(mean 3 %.1f)" "$(mean 4 %.5f | awk '{print 1000 * $1}')"
        done
    done
    ;;
arms-map | arms-workshop)
    printf '| joints | planner | solved | first cost | after shortcuts | least | vertices | ms |\n|---|---|---|---|---|---|---|---|\n'
    joints="1 3 4 5 6"
    [ "$table" = arms-map ] || joints="3 4 5 6 8 10"
    for n in $joints; do
        for planner in prm-random rrt rrt-connect; do
            plan "arm-$n-${table#arms-}" $planner --optimize 0 --time-limit 20 $([ $planner = prm-random ] && echo --set samples=500)
            printf '| %s | %s | %s | %s | %s | %s | %s | %s |\n' $n $planner "$(solved)" "$(mean 1 %.3f)" \
                "$(mean 2 %.3f)" "$(extreme 2 least)" "$(mean 3 %.1f)" "$(mean 4 %.6f | awk '{print 1000 * $1}')"
        done
    done
    ;;
arms-best)
    # What is the true cost on the map? The best that long improvement finds.
    printf '| joints | straight | best found | worst found |\n|---|---|---|---|\n'
    for n in 1 3 4 5 6; do
        plan "arm-$n-map" rrt-connect --optimize 5
        printf '| %s | %s | %s | %s |\n' $n "$(mean 5 %.4f)" "$(extreme 2 least)" "$(extreme 2 greatest)"
    done
    ;;
point)
    # The settings are those of the reports; the best of the visibility graph is the lower bound.
    printf '| planner | solved | first cost | over the shortest | after shortcuts | vertices | ms |\n|---|---|---|---|---|---|---|\n'
    while read -r planner settings; do
        # shellcheck disable=SC2086
        plan point-town "$planner" --optimize 0 --time-limit 30 $settings
        printf '| %s | %s | %s | %s | %s | %s | %s |\n' "$planner" "$(solved)" "$(mean 1 %.1f)" \
            "$(awk '{s += $1 / $5} END {printf "%.3f", s / NR}' "$work/rows")" "$(mean 2 %.1f)" "$(mean 3 %.0f)" \
            "$(mean 4 %.6f | awk '{printf "%.1f", 1000 * $1}')"
    done < <(point_settings)
    ;;
rrt-star)
    printf '| nodes | solved | first path | last path | over the shortest | worst | ms in all |\n|---|---|---|---|---|---|---|\n'
    for nodes in 500 1000 2000 5000; do
        plan point-town rrt-star --optimize 0 --time-limit 60 --set step=10 --set goal-bias=0.1 --set radius=20 --set nodes=$nodes
        printf '| %s | %s | %s | %s | %s | %s | %s |\n' $nodes "$(solved)" "$(mean 1 %.1f)" "$(mean 6 %.1f)" \
            "$(awk '{s += $6 / $5} END {printf "%.3f", s / NR}' "$work/rows")" \
            "$(awk '{r = $6 / $5; if (r > w) w = r} END {printf "%.3f", w}' "$work/rows")" \
            "$(mean 7 %.6f | awk '{printf "%.0f", 1000 * $1}')"
    done
    ;;
pictures)
    out=${ASV_PICTURES:-"$root/docs/images"}
    while read -r planner settings; do
        # shellcheck disable=SC2086
        "$bin/asv-solve" "$cases/point-town.json" "$work/s.txt" --planner "$planner" --threads 1 --optimize 0 \
            --quiet --time-limit 30 --trees "$work/trees.json" --stats "$work/stats.json" $settings
        "$bin/asv-view" "$cases/point-town.json" "$work/s.txt" --trees "$work/trees.json" \
            --stats "$work/stats.json" -o "$work/picture.svg"
        # Two decimals of a point are more than one sees.
        sed -E 's/([0-9]+\.[0-9]{2})[0-9]+/\1/g' "$work/picture.svg" > "$out/town-$planner.svg"
    done < <(point_settings 250)
    ;;
*)
    echo "unknown table $table" >&2
    exit 2
    ;;
esac
