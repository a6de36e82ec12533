#!/usr/bin/env bash
# Makes the pictures of the README and the pages of docs/gallery/ from problems in testcases/.
#
#   make_pictures.sh                   everything, for every planner that asv-solve lists
#   make_pictures.sh PLANNER...        the pages of these planners alone, and the list of pages
#
# Pages and pictures come together: no page says a figure that another run of this would change.
set -euo pipefail
cd "$(dirname "$0")/.."
bin=build/release/bin
gallery=docs/gallery
seconds=30
planner_cases=(3ASV 3ASV-clutter-20 7ASV-x6)
worlds=(harbour islands river floor machine-room)
shown_cases=(3ASV-maze 3ASV-spiral 3ASV-clutter-100 7ASV-x4 15ASV 15ASV-x6 25ASV-crossing)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

planners() { "$bin/asv-solve" --list-planners | grep -v '^ ' | cut -d: -f1; }
summary() { "$bin/asv-solve" --list-planners | sed -n "s/^$1: //p"; }

# Roadmaps are small ones, in which one can still see something.
planner_options() {
    echo "--planner $1"
    [[ $1 != prm-* ]] || echo "--set samples=200 --set neighbours=5"
}

# The file of a case, which is a scenario where it is a world.
problem() {
    if [ -e "testcases/$1.txt" ]; then echo "testcases/$1.txt"; else echo "testcases/worlds/$1.json"; fi
}

# solve PLANNER CASE: fails when the planner finds no solution in time.
solve() {
    "$bin/asv-solve" "$(problem "$2")" "$work/$2.txt" $(planner_options "$1") --seed 1 --threads 1 --quiet \
        --time-limit "$seconds" --optimize 1 --trees "$work/$2.trees.json" --stats "$work/$2.stats.json"
}

# draw CASE FILE [OPTION...]: the solution that was found last.
draw() {
    local case=$1 file=$2
    shift 2
    "$bin/asv-view" "$(problem "$case")" "$work/$case.txt" --stats "$work/$case.stats.json" "$@" -o "$file"
}

# figure NAME TITLE CASE [OPTION...]: its picture, and on standard output its place in a page.
figure() {
    local name=$1 title=$2 case=$3
    shift 3
    rm -f "$gallery/$name.svg"
    draw "$case" "$work/$name.svg" "$@"
    # A roadmap of many thousand edges is a dark field and megabytes of it.
    if [ "$(stat -c %s "$work/$name.svg")" -gt 500000 ]; then
        echo 'Its roadmap has too many edges to be shown.'
        return
    fi
    cp "$work/$name.svg" "$gallery/$name.svg"
    echo "<img src=\"$name.svg\" alt=\"$title\" width=\"600\">"
}

planner_page() {
    local planner=$1 case
    echo "# $planner"
    echo
    echo "$(summary "$planner")."
    echo
    echo "The search trees or the roadmap, drawn through ASV 1, and the path that came of them after one second of"
    echo "improvement:"
    echo
    echo "    asv-solve testcases/CASE.txt CASE.solution.txt $(planner_options "$planner" | xargs) --seed 1 --threads 1 --trees CASE.trees.json"
    echo "    asv-view testcases/CASE.txt CASE.solution.txt --trees CASE.trees.json -o CASE.svg"
    for case in "${planner_cases[@]}"; do
        printf '\n## %s\n\n' "$case"
        if solve "$planner" "$case"; then
            figure "$planner-$case" "$case, solved by $planner" "$case" --trees "$work/$case.trees.json"
        else
            echo "Not solved within $seconds s."
        fi
    done
}

index_page() {
    local planner
    echo "# Gallery"
    echo
    echo "Made by \`tools/make_pictures.sh\`. A page for each planner, with its search trees:"
    echo
    for planner in $(planners); do
        if [ -e "$gallery/$planner.md" ]; then echo "- [$planner]($planner.md): $(summary "$planner")"; fi
    done
    printf -- '- [test cases](testcases.md) and their solutions\n'
    printf -- '- [worlds](worlds.md) that look like real ones\n'
}

testcases_page() {
    local case
    echo "# Test cases and their solutions"
    echo
    echo "Solved by \`auto\` with seed 1, one thread and one second of improvement. [asv-view](../asv-view.md) tells what a"
    echo "picture shows, [testcases/README.md](../../testcases/README.md) what each case is for."
    for case in "${shown_cases[@]}"; do
        printf '\n## %s\n\n' "$case"
        solve auto "$case"
        figure "case-$case" "$case and its solution" "$case"
    done
}

worlds_page() {
    local world
    echo "# Worlds that look like real ones"
    echo
    echo "In metres, from boxes, charts that are pictures, and a map of ROS ([testcases/README.md](../../testcases/README.md#worlds-that-look-like-real-ones))."
    echo "Solved by \`auto\` with seed 1, one thread and one second of improvement:"
    echo
    echo "    asv-solve testcases/worlds/WORLD.json WORLD.txt --seed 1 --threads 1"
    echo "    asv-view testcases/worlds/WORLD.json WORLD.txt -o WORLD.svg"
    for world in "${worlds[@]}"; do
        printf '\n## %s\n\n' "$world"
        solve auto "$world"
        figure "world-$world" "$world and a way through it" "$world"
    done
}

mkdir -p "$gallery"
for planner in ${*:-$(planners)}; do
    planner_page "$planner" > "$work/page"
    mv "$work/page" "$gallery/$planner.md"
done
if [ $# -eq 0 ]; then
    solve auto 7ASV
    draw 7ASV docs/7ASV.svg
    draw 7ASV docs/7ASV-dark.svg --theme dark
    testcases_page > "$work/page"
    mv "$work/page" "$gallery/testcases.md"
    worlds_page > "$work/page"
    mv "$work/page" "$gallery/worlds.md"
fi
index_page > "$work/page"
mv "$work/page" "$gallery/README.md"
