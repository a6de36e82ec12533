#!/usr/bin/env bash
# Installs what is needed, builds and runs all tests: as users run it (release), then with the
# sanitizers for memory and undefined behaviour. test.sh PRESET... runs only the presets named.
set -euo pipefail
cd "$(dirname "$0")/.."

tools/install_packages.sh test
presets=("$@")
[ $# -gt 0 ] || presets=(release asan)
for name in "${presets[@]}"; do
    echo "== $name"
    cmake --preset "$name" -DASV_BUILD_TESTS=ON -DASV_WARNINGS_AS_ERRORS=ON
    cmake --build --preset "$name"
    ctest --preset "$name" -j "$(nproc)"
done
