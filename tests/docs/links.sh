#!/usr/bin/env bash
# Does every link and every path in the pages lead somewhere, and does the index name every page?
# links.sh ROOT
set -euo pipefail
cd "$1"
failed=0
fail() {
    echo "$1"
    failed=1
}
pages=(README.md CONTRIBUTING.md CHANGELOG.md docs/*.md docs/gallery/*.md testcases/README.md)

# Links and pictures that are no addresses of the web, without what follows a #.
for page in "${pages[@]}"; do
    folder=$(dirname "$page")
    while read -r target; do
        [ -z "$target" ] || [ -e "$folder/$target" ] || fail "$page: no file $target"
    done < <(grep -oE '\]\([^) ]+\)|(src|srcset|href)="[^"]+"' "$page" |
        sed -E 's/^\]\(//; s/\)$//; s/^[a-z]+="//; s/"$//; s/#.*//' | grep -vE '^[a-z]+:' || true)
done

# Paths of the tree in backquotes: `core/model/problem.hpp`, `core/shorten/band/`, `space/slide.*`.
# The changelog may name what is gone.
for page in "${pages[@]}"; do
    [ "$page" != CHANGELOG.md ] && [ "$page" != docs/history.md ] || continue
    while read -r path; do
        compgen -G "$path" > /dev/null || fail "$page: no file $path"
    done < <(grep -oE '`(geometry|core|io|tools|tests|docs|testcases)/[A-Za-z0-9_./*-]*`' "$page" |
        tr -d '`' || true)
done

for page in docs/*.md docs/gallery/README.md; do
    name=${page#docs/}
    [ "$name" = README.md ] || grep -qF "($name)" docs/README.md ||
        fail "docs/README.md: does not name $name"
done
for page in docs/gallery/*.md; do
    name=${page#docs/gallery/}
    [ "$name" = README.md ] || grep -qF "($name)" docs/gallery/README.md ||
        fail "docs/gallery/README.md: does not name $name"
done
[ "$failed" -ne 0 ] || echo "${#pages[@]} pages: all links and paths lead somewhere"
exit "$failed"
