#!/usr/bin/env bash
# Formats all C++ as .clang-format says; format.sh --check changes nothing, fails and says where.
# (The scripts of the player are laid out by hand.) Versions of clang-format differ in details: the
# code is written with that of Debian 12, and another one checks nothing.
set -euo pipefail
cd "$(dirname "$0")/.."
wanted=14

command -v clang-format > /dev/null || { echo "skipped: no clang-format"; exit 77; }
version=$(clang-format --version | sed 's/.*version \([0-9]*\).*/\1/')
[ "$version" = "$wanted" ] || { echo "skipped: clang-format $version formats otherwise than $wanted"; exit 77; }

how=(-i)
[ "${1:-}" != --check ] || how=(--dry-run --Werror --ferror-limit=1)
find geometry core io tools tests -path tests/house/bad_example -prune -o -path '*/node_modules' -prune \
    -o \( -name '*.hpp' -o -name '*.cpp' \) -print0 | xargs -0 clang-format "${how[@]}"
