#!/usr/bin/env bash
# Uses the playground in a real Chromium: run.sh PROGRAMS PLAYGROUND OUT
#
# PROGRAMS is the folder of the built programs, PLAYGROUND that of the built playground. OUT gets the
# node packages, screenshots/ to look at, and figures.json with what was measured. Exits with 77,
# which CTest counts as skipped, where there is no Chromium or no playground.
set -euo pipefail
programs=$(realpath "$1")
page=$2/asv-playground.html
mkdir -p "$3"
out=$(realpath "$3")
here=$(realpath "$(dirname "$0")")
packages=$(realpath "$here/../../browser")

browser=$(command -v chromium || command -v chromium-browser || true)
if [ -z "$browser" ]; then
    echo "Skipped: chromium is not installed (Debian package chromium)."
    exit 77
fi
if [ ! -f "$page" ]; then
    echo "Skipped: there is no $page; tools/playground.sh makes it."
    exit 77
fi

# The packages are those of the player's tests, installed anew only when the lock file has changed.
if ! cmp --silent "$packages/package-lock.json" "$out/node_modules/.lock-used"; then
    cp "$packages/package.json" "$packages/package-lock.json" "$out/"
    npm ci --prefix "$out" --no-audit --no-fund --loglevel error
    cp "$packages/package-lock.json" "$out/node_modules/.lock-used"
fi

export ASV_BROWSER=$browser ASV_PROGRAMS=$programs ASV_OUT=$out
export ASV_SOURCE=$(realpath "$here/../../..")
rm -rf "$out/screenshots" "$out/figures.json"
mkdir -p "$out/screenshots" "$out/pages"
cp "$page" "$out/pages/"
# One file after the other: what is measured in one is not to be disturbed by another.
failed=0
for tests in "$here"/*_test.mjs; do
    node --test --test-reporter=spec "$tests" || failed=1
done
echo "Screenshots and figures.json are in $out"
exit $failed
