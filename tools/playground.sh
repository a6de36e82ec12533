#!/usr/bin/env bash
# Makes the playground: installs what it needs, compiles the planner for a browser, and makes the page
# build/playground/asv-playground.html, which opens from disk, beside the engine and its worker in
# build/playground/engine/ (docs/playground.md).
set -euo pipefail
cd "$(dirname "$0")/.."

tools/install_packages.sh playground
# Emscripten is a program of Python and node: Debian's, which know its modules.
with_debian=(env PATH=/usr/bin:/bin EMSDK_PYTHON=/usr/bin/python3 NODE_PATH=/usr/share/nodejs)
build=build/playground/wasm
"${with_debian[@]}" cmake -S tools/playground/engine -B $build -G Ninja -DCMAKE_BUILD_TYPE=Release \
    -DCMAKE_TOOLCHAIN_FILE=/usr/share/emscripten/cmake/Modules/Platform/Emscripten.cmake \
    -DCMAKE_CXX_COMPILER_LAUNCHER="$(command -v ccache || true)"
"${with_debian[@]}" cmake --build $build
engine=build/playground/engine
mkdir -p $engine
cp $build/engine.js $build/engine.wasm tools/playground/worker.js $engine/

# What joins the page comes from npm, anew only when the lock file has changed.
packages=build/playground/npm
if ! cmp --silent tools/playground/package-lock.json $packages/node_modules/.lock-used; then
    mkdir -p $packages
    cp tools/playground/package.json tools/playground/package-lock.json $packages/
    npm ci --prefix $packages --no-audit --no-fund --loglevel error
    cp tools/playground/package-lock.json $packages/node_modules/.lock-used
fi
node tools/playground/bundle.mjs $engine build/playground
