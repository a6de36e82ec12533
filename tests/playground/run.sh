#!/usr/bin/env bash
# Compares the playground's engine with the programs: run.sh PROGRAMS ENGINE
#
# PROGRAMS is the folder of the built programs, ENGINE what tools/playground.sh has made. Exits with 77, which
# CTest counts as skipped, where there is no engine.
set -euo pipefail
here=$(realpath "$(dirname "$0")")

if [ ! -e "$2/engine.wasm" ]; then
    echo "skipped: there is no engine (tools/playground.sh makes it)"
    exit 77
fi
ASV_PROGRAMS=$(realpath "$1") ASV_ENGINE=$(realpath "$2")
export ASV_PROGRAMS ASV_ENGINE
export ASV_SOURCE=$(realpath "$here/../..")
failed=0
for tests in "$here"/*_test.mjs; do
    node --test --test-reporter=spec "$tests" || failed=1
done
exit $failed
