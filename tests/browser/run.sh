#!/usr/bin/env bash
# Opens players and pages of benchmarks in a real Chromium and uses them: run.sh PROGRAMS OUT
#
# PROGRAMS is the folder of the built programs. OUT gets the node packages, the pages under test,
# screenshots/ to look at, and figures.json with what was measured. Exits with 77, which CTest
# counts as skipped, where no Chromium is installed.
set -euo pipefail
here=$(realpath "$(dirname "$0")")
. "$here/chromium.sh"
use_chromium "$1" "$2"
node "$here/make_pages.mjs"
run_tests "$here" "$here/benchmark"
