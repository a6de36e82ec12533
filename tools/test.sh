#!/usr/bin/env bash
# Installs what is needed, builds and runs all tests as users run the programs (release).
# test.sh PRESET... runs them in other builds: test.sh asan with the sanitizers for memory and
# undefined behaviour, test.sh tsan with the one for threads.
set -euo pipefail
cd "$(dirname "$0")/.."

tools/install_packages.sh test
presets=("$@")
[ $# -gt 0 ] || presets=(release)
for name in "${presets[@]}"; do
    echo "== $name"
    cmake --preset "$name" -DASV_BUILD_TESTS=ON -DASV_WARNINGS_AS_ERRORS=ON
    cmake --build --preset "$name"
    ctest --preset "$name" -j "$(nproc)"
done
