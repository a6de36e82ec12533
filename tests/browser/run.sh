#!/usr/bin/env bash
# Opens players in a real Chromium and uses them: run.sh PROGRAMS OUT
#
# PROGRAMS is the folder of the built programs. OUT gets the node packages, the pages under test,
# screenshots/ to look at, and figures.json with what was measured. Exits with 77, which CTest
# counts as skipped, where no Chromium is installed.
set -euo pipefail
programs=$(realpath "$1")
mkdir -p "$2"
out=$(realpath "$2")
here=$(realpath "$(dirname "$0")")

browser=$(command -v chromium || command -v chromium-browser || true)
if [ -z "$browser" ]; then
    echo "Skipped: chromium is not installed (Debian package chromium)."
    exit 77
fi

# The packages are installed anew only when the lock file has changed.
if ! cmp --silent "$here/package-lock.json" "$out/node_modules/.lock-used"; then
    cp "$here/package.json" "$here/package-lock.json" "$out/"
    npm ci --prefix "$out" --no-audit --no-fund --loglevel error
    cp "$here/package-lock.json" "$out/node_modules/.lock-used"
fi

export ASV_BROWSER=$browser ASV_PROGRAMS=$programs ASV_OUT=$out
export ASV_SOURCE=$(realpath "$here/../..")
rm -rf "$out/screenshots" "$out/figures.json"
mkdir -p "$out/screenshots" "$out/pages"
node "$here/make_pages.mjs"
# One file after the other: the frames of one are not to be counted while another one works.
failed=0
for tests in "$here"/*_test.mjs; do
    node --test --test-reporter=spec "$tests" || failed=1
done
echo "Screenshots and figures.json are in $out"
exit $failed
