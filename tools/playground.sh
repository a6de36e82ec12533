#!/usr/bin/env bash
# Makes the playground: installs what it needs, compiles the planner for a browser, and puts the engine and
# its worker into build/playground/engine/ (docs/playground.md).
set -euo pipefail
cd "$(dirname "$0")/.."

tools/install_packages.sh playground
# Emscripten is a program of Python and node: Debian's, which know its modules.
export PATH=/usr/bin:/bin EMSDK_PYTHON=/usr/bin/python3 NODE_PATH=/usr/share/nodejs
build=build/playground/wasm
cmake -S tools/playground/engine -B $build -G Ninja -DCMAKE_BUILD_TYPE=Release \
    -DCMAKE_TOOLCHAIN_FILE=/usr/share/emscripten/cmake/Modules/Platform/Emscripten.cmake \
    -DCMAKE_CXX_COMPILER_LAUNCHER="$(command -v ccache || true)"
cmake --build $build
node tools/playground/build.mjs $build build/playground
