#!/usr/bin/env bash
# Makes all pictures of the README and of docs/gallery.md anew, with the programs of the release
# build, and writes docs/gallery.md. A planner that is added to asv-solve gets its pictures by itself.
set -euo pipefail
cd "$(dirname "$0")/.."
bin=build/release/bin
images=docs/images
page=docs/gallery.md
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
mkdir -p "$images"

# solve PLANNER CASE: prints the planner's summary line, or nothing when it finds no solution in time.
solve() {
    "$bin/asv-solve" "testcases/$2.txt" "$work/$2.txt" --planner "$1" --seed 1 --threads 1 \
        --time-limit 30 --optimize 1 --trees "$work/$2.trees.json" --stats "$work/$2.stats.json" --quiet
}

# figure NAME TITLE: a picture for light and for dark pages.
figure() {
    echo "<picture><source media=\"(prefers-color-scheme: dark)\" srcset=\"images/$1-dark.svg\"><img src=\"images/$1.svg\" alt=\"$2\" width=\"440\"></picture>"
}

# draw NAME CASE [OPTION...]: NAME.svg and NAME-dark.svg.
draw() {
    local name=$1 case=$2
    shift 2
    "$bin/asv-view" "testcases/$case.txt" "$@" -o "$images/$name.svg"
    "$bin/asv-view" "testcases/$case.txt" "$@" --theme dark -o "$images/$name-dark.svg"
}

solve auto 7ASV
draw 7ASV 7ASV "$work/7ASV.txt"

{
    echo "# Pictures"
    echo
    echo "Made by \`tools/make_pictures.sh\` from the problems in \`testcases/\`: \`asv-solve\` with seed 1, one thread"
    echo "and one second of improvement, then \`asv-view\` with \`--trees\` and without. A player for each comes from"
    echo "\`asv-view --gallery OUT_DIR testcases --solutions DIR\`."
} > "$page"

mapfile -t planners < <("$bin/asv-solve" --list-planners | grep -v '^ ' | cut -d: -f1)
for planner in "${planners[@]}"; do
    summary=$("$bin/asv-solve" --list-planners | sed -n "s/^$planner: //p")
    printf '\n## %s\n\n%s\n\nThe search trees, through ASV 1, and the path that came of them:\n\n' "$planner" "$summary" >> "$page"
    for case in 3ASV 7ASV; do
        if solve "$planner" "$case"; then
            draw "$planner-$case" "$case" "$work/$case.txt" --trees "$work/$case.trees.json" --stats "$work/$case.stats.json"
            figure "$planner-$case" "$case, solved by $planner" >> "$page"
        else
            echo "Not solved in 30 s: $case." >> "$page"
        fi
    done
done

printf '\n## What the test cases look like, and their solutions\n\n' >> "$page"
for case in 3ASV-x4 3ASV-spiral 3ASV-maze 3ASV-clutter-20 7ASV-x2 15ASV-x2 15ASV 20ASV-crossing; do
    solve auto "$case"
    draw "case-$case" "$case" "$work/$case.txt"
    figure "case-$case" "$case and its solution" >> "$page"
done
