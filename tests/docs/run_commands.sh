#!/usr/bin/env bash
# Runs the commands that a page shows, as its reader would type them: run_commands.sh ROOT PROGRAMS PAGE
#
# A block opened by ```sh is run, all blocks of a page in one shell, from the project's folder; each
# command must succeed. A block opened by ```sh slow installs, builds or takes minutes: of it the
# scripts must exist and the options of our programs are not tried. Commands stand in no other block.
# What is run sees a copy of the tree, with links to what is large, so that it may write anywhere.
set -euo pipefail
root=$(realpath "$1")
programs=$(realpath "$2")
page=$3
failed=0

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
mkdir -p "$work/tree/build/release"
ln -s "$programs" "$work/tree/build/release/bin"
ln -s "$(dirname "$programs")/share" "$work/tree/build/release/share"
for entry in docs tools tests; do ln -s "$root/$entry" "$work/tree/$entry"; done
cp -r "$root/testcases" "$work/tree/testcases"

block() { # KIND: the lines of its blocks
    awk -v kind="$1" '/^```/ { inside = !inside && $0 == kind; next } inside' "$root/$page"
}

# An opening fence toggles, so a block of another kind must not be mistaken for the text between.
awk '/^```/ { open = !open } END { exit open }' "$root/$page" || {
    echo "$page: a block is not closed"
    exit 1
}

{
    echo 'set -euo pipefail'
    block '```sh'
} > "$work/commands"
if ! (cd "$work/tree" && bash -v "$work/commands" > "$work/log" 2>&1); then
    echo "$page: a command fails; the last one here:"
    tail -n 40 "$work/log"
    failed=1
fi

block '```sh slow' > "$work/slow"
bash -n "$work/slow" || failed=1
while read -r script; do
    if [ ! -x "$root/$script" ]; then
        echo "$page: no program $script"
        failed=1
    fi
done < <(grep -oE '(tools|tests)/[A-Za-z0-9_/-]+\.(sh|py)' "$work/slow" || true)

# Elsewhere a command would not be tried.
if grep -nE '^    (build/|tools/|tests/|asv-|\$ )' "$root/$page"; then
    echo "$page: these commands stand outside of blocks that are tried"
    failed=1
fi
[ "$failed" -ne 0 ] || echo "$page: $(grep -c . "$work/commands") lines run, $(grep -c . "$work/slow" || true) slow ones read"
exit "$failed"
