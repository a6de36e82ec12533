#!/usr/bin/env bash
# Fails unless own_functions.sh finds calls of the C library's functions where they may not be, and
# nothing else.
set -euo pipefail
cd "$(dirname "$0")"
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

mkdir -p "$work"/{good,bad}/{core/benchmark,geometry/room}
echo 'double f(double x) { return std::sqrt(x) + elementary::log(x); }' | tee "$work"/{good,bad}/core/a.cpp > /dev/null
echo 'double f(double x) { return std::log(x); }' | tee "$work"/{good,bad}/core/benchmark/b.cpp > "$work/bad/core/c.hpp"
echo 'double g(double x) { return std::atan2(x, 1); }' > "$work/bad/geometry/room/d.cpp"

./own_functions.sh "$work/good"
expected='core/c.hpp:1:
geometry/room/d.cpp:1:'
code=0
found=$(./own_functions.sh "$work/bad") || code=$?
[ "$code" = 1 ] && [ "$(sed 's/double.*//' <<< "$found")" = "$expected" ] || { echo "found instead: $found"; exit 1; }
