#!/usr/bin/env bash
# Is the walk of a problem file that ARCHITECTURE.md tells what a debugger sees? walk.sh ROOT PROGRAM
#
# ROOT is the project, PROGRAM the built asv-solve. Every function of the page's ```walk block must
# exist, be reached, and be reached for the first time after those before it. Exits with 77, which
# CTest counts as skipped, where there is no gdb or it may not trace.
set -euo pipefail
root=$(realpath "$1")
program=$(realpath "$2")

if ! command -v gdb > /dev/null; then
    echo "Skipped: gdb is not installed (Debian package gdb)."
    exit 77
fi
if ! gdb -nx -batch -ex run /bin/true 2>&1 | grep -q 'exited normally'; then
    echo "Skipped: gdb may not trace a program here."
    exit 77
fi

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

# One function a line; comments and blanks go.
sed -n '/^```walk$/,/^```$/p' "$root/docs/ARCHITECTURE.md" |
    sed -e '/^```/d' -e 's/#.*//' -e 's/[[:space:]]*$//' -e '/^$/d' > "$work/functions"
count=$(wc -l < "$work/functions")
if [ "$count" -lt 10 ]; then
    echo "docs/ARCHITECTURE.md: the walk has $count functions"
    exit 1
fi

# Each breakpoint ends with its first hit, so the hits are the order of first calls. gdb leaves its
# commands at the first that fails: a function that does not exist, or no program to continue.
{
    echo "set breakpoint pending off"
    sed 's/^/tbreak /' "$work/functions"
    echo "run"
    for _ in $(seq "$count"); do echo "continue"; done
} > "$work/commands"
gdb -nx -batch -x "$work/commands" --args "$program" "$root/testcases/7ASV.txt" "$work/out.txt" \
    --threads 1 --optimize 0 --quiet > "$work/log" 2>&1 < /dev/null || true

grep -oE 'Temporary breakpoint [0-9]+[.,]' "$work/log" | tr -dc '0-9\n' > "$work/hits"
seq "$count" > "$work/expected"
if ! grep -q 'exited normally' "$work/log" || ! cmp -s "$work/hits" "$work/expected"; then
    echo "docs/ARCHITECTURE.md tells another walk than the debugger:"
    nl -w3 -s' ' "$work/functions"
    echo "reached, by these numbers: $(xargs < "$work/hits")"
    echo "what gdb said:"
    cat "$work/log"
    exit 1
fi
echo "$count functions, reached in this order:"
cat "$work/functions"
