#!/usr/bin/env bash
# What improvement is worth: the cost over the lower bound, median and range over the seeds, of the
# first path and after --optimize 0, 0.1, 1, ... as a table.
#
#   improve.sh SEEDS "SECONDS..." PROBLEM... [-- OPTIONS OF ASV-SOLVE]
#
# One thread; times are CPU-bound, so run nothing else beside it. ASV_BIN: folder of the programs.
# Every solution is validated with --continuous.
set -euo pipefail
bin=${ASV_BIN:-$(dirname "$0")/../../build/release/bin}
seeds=$1 budgets=$2
shift 2
problems=()
while [ $# -gt 0 ] && [ "$1" != -- ]; do problems+=("$1"); shift; done
[ $# -eq 0 ] || shift
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

header="| problem | bound | first" rule="|---|---|---"
for budget in $budgets; do header+=" | after $budget s"; rule+="|---"; done
printf '%s | steps, least |\n%s|---|\n' "$header" "$rule"
for problem in "${problems[@]}"; do
    name=$(basename "$problem" .txt)
    for budget in $budgets; do
        for seed in $(seq 1 "$seeds"); do
            "$bin/asv-solve" "$problem" "$work/solution" --seed "$seed" --threads 1 --quiet \
                --optimize "$budget" --stats "$work/$budget-$seed.json" "$@" 2> "$work/message" ||
                { cat "$work/message" >&2; exit 1; }
            "$bin/asv-validate" "$problem" "$work/solution" --continuous > "$work/verdict" 2>&1 ||
                { echo "$name, seed $seed, $budget s: not valid" >&2; cat "$work/verdict" >&2; exit 1; }
        done
    done
    python3 - "$name" "$work" "$seeds" $budgets << 'PYTHON'
import json
import statistics
import sys

name, work, seeds, budgets = sys.argv[1], sys.argv[2], int(sys.argv[3]), sys.argv[4:]
runs = {b: [json.load(open(f"{work}/{b}-{s}.json")) for s in range(1, seeds + 1)] for b in budgets}
bound = runs[budgets[0]][0]["cost_lower_bound"]


def ratios(costs):
    values = sorted(cost / bound for cost in costs)
    return f"{statistics.median(values):.3f} ({values[0]:.3f} to {values[-1]:.3f})"


cells = [ratios([run["cost_first"] for run in runs[budgets[0]]])]
cells += [ratios([run["cost"] for run in runs[b]]) for b in budgets]
last = runs[budgets[-1]]
steps = statistics.median(run["primitive_steps"] for run in last)
least = last[0]["primitive_steps_lower_bound"]
print(f"| {name} | {bound:.3f} | {' | '.join(cells)} | {steps:.0f}, {least} |", flush=True)
PYTHON
done
