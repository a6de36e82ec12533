#!/usr/bin/env bash
# Uses the playground in a real Chromium: run.sh PROGRAMS PLAYGROUND OUT
#
# PROGRAMS is the folder of the built programs, PLAYGROUND that of the built playground. OUT gets the
# node packages, screenshots/ to look at, and figures.json with what was measured. Exits with 77,
# which CTest counts as skipped, where there is no Chromium or no playground.
set -euo pipefail
here=$(realpath "$(dirname "$0")")
page=$2/asv-playground.html
if [ ! -f "$page" ]; then
    echo "Skipped: there is no $page; tools/playground.sh makes it."
    exit 77
fi
. "$here/../../browser/chromium.sh"
use_chromium "$1" "$3"
cp "$page" "$ASV_OUT/pages/"
run_tests "$here"
