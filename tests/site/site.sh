#!/usr/bin/env bash
# Does the site build without a warning, lead every link somewhere, and does its search work offline?
# site.sh ROOT OUT
#
# Skipped where the packages that it is built with are not installed. The search is tried where there
# is a browser.
set -euo pipefail
root=$(realpath "$1")
out=$2
/usr/bin/python3 -c 'import breathe, furo, myst_parser, sphinx' 2> /dev/null && command -v doxygen > /dev/null || {
    echo "skipped: no Sphinx with Breathe, MyST and Furo, or no Doxygen; tools/install_packages.sh site"
    exit 77
}
mkdir -p "$out"
out=$(realpath "$out")
"$root/tools/site.sh" "$out"
/usr/bin/python3 "$root/tests/site/check_site.py" "$out/html"

command -v chromium > /dev/null || { echo "no browser to try the search in"; exit 0; }
found=$(chromium --headless --no-sandbox --disable-gpu --disable-dev-shm-usage --user-data-dir="$out/browser" \
    --virtual-time-budget=20000 --dump-dom "file://$out/html/search.html?q=bridge" 2> /dev/null)
rm -rf "$out/browser"
if ! grep -q 'planner-comparison.html' <<< "$found"; then
    echo "the search does not find the page of planners:"
    grep -A20 'id="search-results"' <<< "$found" || true
    exit 1
fi
echo "the search finds pages"
