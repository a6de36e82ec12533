#!/usr/bin/env bash
# Fails, and says where, when core/ or geometry/ under ROOT calls a function of <cmath> that C
# libraries round differently, instead of geometry/elementary/functions.hpp. Statistics of benchmarks
# may: no path depends on them.
# Usage: own_functions.sh ROOT
set -euo pipefail
cd "${1:?usage: own_functions.sh ROOT}"

rounded='a?(sin|cos|tan)h?|atan2|exp2?|expm1|log(2|10|1p)?|pow|hypot|cbrt|erfc?|[lt]gamma'
found=$(grep -rnE "std::($rounded)\(" --include='*.?pp' core geometry | grep -v '^core/benchmark/' || true)
[ -z "$found" ] || { echo "$found"; exit 1; }
