#!/usr/bin/env bash
# Fails, and says where, when a relative link of a page under ROOT leads to no file, or when a page
# of docs/ cannot be reached by links from docs/README.md.
# Usage: links.sh ROOT
set -euo pipefail
cd "${1:?usage: links.sh ROOT}"
bad=0

pages() {
    { ls ./*.md 2> /dev/null || true; find docs testcases tests \( -name node_modules -o -name 'bad_*' \) -prune -o -name '*.md' -print; } |
        sed 's,^\./,,' | LC_ALL=C sort
}

# links PAGE: "line target" of each relative link, without its anchor; code is no link.
links() {
    awk '
        /^ *```/ { code = !code }
        code || /^    / { next }
        {
            gsub(/`[^`]*`/, "")
            while (match($0, /\]\([^)]*\)|^\[[^]]*\]: *[^ ]+|(src|href|srcset)="[^"]*"/)) {
                link = substr($0, RSTART, RLENGTH)
                $0 = substr($0, RSTART + RLENGTH)
                sub(/^\]\(|^\[[^]]*\]: *|^[a-z]*="/, "", link)
                sub(/[ )"].*$/, "", link)
                sub(/#.*/, "", link)
                if (link != "" && link !~ /^[a-z]+:/) print FNR, link
            }
        }
    ' "$1"
}

# from PAGE TARGET: the path in the tree that the link leads to.
from() { realpath -m --relative-to=. "$(dirname "$1")/$2"; }

while read -r page; do
    while read -r line target; do
        if [ ! -e "$(from "$page" "$target")" ]; then
            echo "$page:$line: no file $target"
            bad=1
        fi
    done < <(links "$page")
done < <(pages)

declare -A reached
waiting=(docs/README.md)
while [ ${#waiting[@]} -gt 0 ]; do
    page=${waiting[0]}
    waiting=("${waiting[@]:1}")
    if [ -n "${reached[$page]:-}" ] || [ ! -f "$page" ]; then continue; fi
    reached[$page]=1
    while read -r line target; do
        next=$(from "$page" "$target")
        [ ! -d "$next" ] || next=$next/README.md
        [[ $next != *.md ]] || waiting+=("$next")
    done < <(links "$page")
done
while read -r page; do
    if [ -z "${reached[$page]:-}" ]; then
        echo "$page:1: not reached from docs/README.md"
        bad=1
    fi
done < <(find docs -name '*.md' | LC_ALL=C sort)
exit "$bad"
