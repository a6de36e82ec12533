#!/usr/bin/env bash
# The tables of docs/planners.md: every planner, or every extension of rrt-connect forward and
# reversed, on each problem.
#   planners.sh planners SEEDS PROBLEM...
#   planners.sh extensions SEEDS PROBLEM...
# See seeds.sh for the environment; the time limit is 60 s by default.
set -euo pipefail
here=$(dirname "$0")
bin=${ASV_BIN:-"$here/../../build/release/bin"}
export ASV_BIN=$bin ASV_TIME_LIMIT=${ASV_TIME_LIMIT:-60}
what=$1
seeds=$2
shift 2

head() {
    printf '\n%s:\n\n| %s | solved | median ms | worst ms | mean ms | std ms | nodes | state checks | cost |\n|---|---|---|---|---|---|---|---|---|\n' "$1" "$2"
}
row() { ASV_LABEL=$1 "$here/seeds.sh" "$seeds" "$2" -- "${@:3}"; }

planners() {
    head "$(basename "$1" .txt)" planner
    "$bin/asv-solve" --list-planners | sed -n 's/^\([a-z-]*\): .*/\1/p' | while read -r planner; do
        row "$planner" "$1" --planner "$planner"
    done
}

extensions() {
    head "$(basename "$1" .txt) ${2:-forward}" extension
    connect() { row "$1" "$problem" --planner rrt-connect ${direction:+"$direction"} "${@:2}"; }
    local problem=$1 direction=${2:-}
    connect base
    connect "1 swap limiter" --set swap-limiter=on
    connect "2 collision swap" --set collision-swap=on
    connect "3 exhaustion, plain" --set exhaustion=plain
    connect "3 exhaustion, heuristic" --set exhaustion=heuristic
    connect "4 neighbour cost" --set neighbour-cost=on
    connect "5 passage filter" --set passage-filter=on
    connect "6 control chosen, with 2" --set control-chosen=on --set collision-swap=on
    connect "7 goal bias" --set goal-bias=on
    connect "all (3 heuristic)" --set swap-limiter=on --set collision-swap=on \
        --set exhaustion=heuristic --set neighbour-cost=on --set passage-filter=on \
        --set control-chosen=on --set goal-bias=on
}

for problem in "$@"; do
    case $what in
        planners) planners "$problem" ;;
        extensions)
            extensions "$problem"
            extensions "$problem" --reverse
            ;;
        *)
            echo "planners.sh: first word is planners or extensions" >&2
            exit 2
            ;;
    esac
done
