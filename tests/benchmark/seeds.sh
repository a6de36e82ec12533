#!/usr/bin/env bash
# Solves problems with many seeds and prints a table: solved of all, time to the first solution
# (median, worst, mean, standard deviation), nodes, state checks, cost of the shortcut path (medians).
#   seeds.sh SEEDS PROBLEM... [-- OPTIONS OF asv-solve]
# ASV_BIN: folder of the programs. ASV_VALIDATE=1: every solution also passes asv-validate
# --continuous, or the script fails. ASV_TIME_LIMIT: seconds for each run, 10 by default.
# ASV_LABEL: what the rows are named after instead of their problem, without the table's head.
set -euo pipefail
bin=${ASV_BIN:-"$(dirname "$0")/../../build/release/bin"}
seeds=$1
shift
problems=()
while [ $# -gt 0 ] && [ "$1" != -- ]; do
    problems+=("$1")
    shift
done
[ $# -eq 0 ] || shift
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

number() { sed -n "s/^  \"$1\": \([-0-9.e+]*\),*$/\1/p" "$work/stats.json"; }
nodes() { sed -n '/"tree_nodes"/,/]/p' "$work/stats.json" | grep -o '[0-9]*' | awk '{n += $1} END {print n}'; }

[ -n "${ASV_LABEL:-}" ] || printf '| problem | solved | median ms | worst ms | mean ms | std ms | nodes | state checks | cost |\n|---|---|---|---|---|---|---|---|---|\n'
for problem in "${problems[@]}"; do
    : > "$work/rows"
    for ((seed = 1; seed <= seeds; ++seed)); do
        if "$bin/asv-solve" "$problem" "$work/solution.txt" --seed "$seed" --threads 1 \
            --optimize 0 --time-limit "${ASV_TIME_LIMIT:-10}" --stats "$work/stats.json" --quiet "$@"; then
            echo "$(number time_to_first_s) $(nodes) $(number state_checks) $(number cost)" >> "$work/rows"
            if [ "${ASV_VALIDATE:-0}" = 1 ]; then
                "$bin/asv-validate" "$problem" "$work/solution.txt" --continuous --quiet \
                    > "$work/verdict" || { cat "$work/verdict"; exit 1; }
            fi
        fi
    done
    median() { sort -g -k "$1,$1" "$work/rows" | awk -v c="$1" '{v[NR]=$c} END {print NR ? v[int((NR+1)/2)] : "nan"}'; }
    worst=$(sort -g "$work/rows" | tail -n 1 | cut -d ' ' -f 1)
    moments=$(awk '{s += $1; q += $1 * $1} END {if (!NR) print "nan nan"; else {m = s / NR; v = q / NR - m * m; print m, sqrt(v > 0 ? v : 0)}}' "$work/rows")
    awk -v name="${ASV_LABEL:-$(basename "$problem" .txt)}" -v solved="$(wc -l < "$work/rows")" -v all="$seeds" \
        -v median="$(median 1)" -v worst="${worst:-nan}" -v mean="${moments% *}" -v std="${moments#* }" \
        -v nodes="$(median 2)" -v checks="$(median 3)" -v cost="$(median 4)" \
        'BEGIN {printf "| %s | %d of %d | %.2f | %.1f | %.2f | %.2f | %d | %d | %.3f |\n",
                name, solved, all, 1000 * median, 1000 * worst, 1000 * mean, 1000 * std, nodes, checks, cost}'
done
