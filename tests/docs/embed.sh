#!/usr/bin/env bash
# Does the project of docs/tutorials/embed_in_cpp.md build against an installed copy, and run?
# embed.sh ROOT BUILD
#
# Its CMakeLists.txt is the page's block of CMake, harbour.cpp the example that the page shows.
set -euo pipefail
root=$(realpath "$1")
build=$(realpath "$2")
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cmake --install "$build" --prefix "$work/asv" > "$work/log"
mkdir "$work/project"
cd "$work/project"
awk '/^```cmake/ { inside = 1; next } /^```/ { inside = 0 } inside' \
    "$root/docs/tutorials/embed_in_cpp.md" > CMakeLists.txt
cp "$root/docs/examples/plan_validate_draw.cpp" harbour.cpp
cmake -S . -B build -DCMAKE_PREFIX_PATH="$work/asv" -DCMAKE_BUILD_TYPE=Release > "$work/log"
cmake --build build >> "$work/log"
build/harbour
grep -q '</svg>' harbour.svg
grep -qi '</html>' harbour.html
