#!/usr/bin/env bash
# Makes Debian packages from the release build, which it builds if need be: package.sh [FOLDER]
# package.sh --shared ... makes them with shared libraries, from a build of its own;
# package.sh --python ... makes that of the Python module too.
# The packages lie in FOLDER, build/packages by default.
set -euo pipefail
cd "$(dirname "$0")/.."

preset=release
folder=build/packages
options=()
tools/install_packages.sh package
for argument in "$@"; do
    case "$argument" in
        --shared) preset=shared ;;
        --python)
            tools/install_packages.sh python
            options+=(-DASV_BUILD_PYTHON=ON)
            ;;
        *) folder=$argument ;;
    esac
done
folder=$(realpath -m "$folder")

[ -f "build/$preset/CMakeCache.txt" ] || options+=(-DASV_BUILD_TESTS=OFF)
cmake --preset "$preset" "${options[@]}"
cmake --build --preset "$preset"

mkdir -p "$folder"
rm -f "$folder"/*.deb
(cd "build/$preset" && cpack -B "$folder")
rm -rf "$folder/_CPack_Packages"
ls -l "$folder"/*.deb
