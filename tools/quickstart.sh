#!/usr/bin/env bash
# From a fresh Debian machine to a solved, checked and drawn problem.
set -euo pipefail
cd "$(dirname "$0")/.."

tools/install_packages.sh build
cmake --preset release -DASV_BUILD_TESTS=OFF
cmake --build --preset release

problem=testcases/7ASV.txt
out=build/quickstart
mkdir -p "$out"
bin=build/release/bin
echo
echo "Solving $problem"
"$bin/asv-solve" "$problem" "$out/7ASV-solution.txt"
"$bin/asv-validate" "$problem" "$out/7ASV-solution.txt" --continuous
"$bin/asv-view" "$problem" "$out/7ASV-solution.txt" -o "$out/7ASV.svg" -o "$out/7ASV.html"
echo
echo "Solution: $out/7ASV-solution.txt"
echo "Picture:  $out/7ASV.svg"
echo "Player:   $out/7ASV.html (open it in a browser)"
if [ -f build/playground/asv-playground.html ]; then
    echo "Playground: build/playground/asv-playground.html (move an obstacle, and the path follows)"
else
    echo "Playground: tools/playground.sh makes a page on which you move an obstacle and the path follows"
fi
