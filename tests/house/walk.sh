#!/usr/bin/env bash
# Fails unless asv-solve passes through the functions that a page lists, in their order. The page
# holds one block that begins with ```walk: a function a line, with its namespaces, and a comment
# behind "#" where wanted.
# Usage: walk.sh ASV_SOLVE PAGE PROBLEM
set -euo pipefail
[ $# -eq 3 ] || { echo "usage: walk.sh ASV_SOLVE PAGE PROBLEM"; exit 2; }
command -v gdb > /dev/null || { echo "skipped: no gdb"; exit 77; }
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

awk '/^```walk$/ { inside = 1; next } /^```/ { inside = 0 } inside' "$2" |
    sed 's/#.*//; s/^ *//; s/ *$//' | grep -v '^$' > "$work/told" || true
[ -s "$work/told" ] || { echo "$2: no block that begins with \`\`\`walk"; exit 1; }

# Each breakpoint says its function and is gone after the first hit.
{
    echo 'set pagination off'
    echo 'set confirm off'
    echo 'set breakpoint pending off'
    while read -r name; do
        echo "tbreak $name"
        printf 'commands\nsilent\necho walk: %s\\n\ncontinue\nend\n' "$name"
    done < "$work/told"
    echo run
} > "$work/script"
gdb -batch -nx -x "$work/script" --args "$1" "$3" "$work/solution.txt" \
    --seed 1 --threads 1 --optimize 0.2 --quiet > "$work/log" 2>&1 < /dev/null || true

if grep -qE 'ptrace|Could not trace|Couldn.t get registers' "$work/log"; then
    echo "skipped: a debugger may not look at programs here"
    exit 77
fi
if grep -E '^(Function "|No symbol|.*Error in sourced)' "$work/log"; then
    echo "$2 names a function that the program has not, or has only inlined"
    exit 1
fi
grep '^walk: ' "$work/log" | sed 's/^walk: //' > "$work/seen" || true
if ! diff "$work/told" "$work/seen" > "$work/difference"; then
    echo "Told by $2 (<), seen by the debugger (>):"
    cat "$work/difference"
    [ -s "$work/seen" ] || tail -20 "$work/log"
    exit 1
fi
[ -s "$work/solution.txt" ] || { echo "The walk ends without a solution."; exit 1; }
