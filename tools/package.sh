#!/usr/bin/env bash
# Makes Debian packages from the release build, which it builds if need be: package.sh [FOLDER]
# package.sh --shared [FOLDER] makes them with shared libraries, from a build of its own.
# The packages lie in FOLDER, build/packages by default.
set -euo pipefail
cd "$(dirname "$0")/.."

preset=release
if [ "${1:-}" = --shared ]; then
    preset=shared
    shift
fi
folder=$(realpath -m "${1:-build/packages}")

tools/install_packages.sh package
options=()
[ -f "build/$preset/CMakeCache.txt" ] || options+=(-DASV_BUILD_TESTS=OFF)
cmake --preset "$preset" "${options[@]}"
cmake --build --preset "$preset"

mkdir -p "$folder"
rm -f "$folder"/*.deb
(cd "build/$preset" && cpack -B "$folder")
rm -rf "$folder/_CPack_Packages"
ls -l "$folder"/*.deb
