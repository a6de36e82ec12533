#!/usr/bin/env bash
# Does every path of the tree that a page names in backquotes exist? paths.sh ROOT
#
# `core/model/problem.hpp`, `core/shorten/band/`, `core/space/steering/slide.*`. Pages that tell of
# what was, CHANGELOG.md and docs/history.md, may name what is gone. Links have a test in tests/house.
set -euo pipefail
cd "${1:?usage: paths.sh ROOT}"
pages=(README.md CONTRIBUTING.md docs/*.md docs/gallery/*.md docs/tutorials/*.md testcases/README.md)
bad=0
for page in "${pages[@]}"; do
    [ "$page" != docs/history.md ] || continue
    while IFS=: read -r line path; do
        if ! compgen -G "${path%/}" > /dev/null; then
            echo "$page:$line: no file $path"
            bad=1
        fi
    done < <(grep -noE '`(geometry|core|io|tools|tests|docs|testcases)/[A-Za-z0-9_./*-]*`' "$page" |
        tr -d '`' || true)
done
exit "$bad"
