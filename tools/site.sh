#!/usr/bin/env bash
# Builds the site of all pages and of the public headers: site.sh [FOLDER], build/site by default. Open
# FOLDER/html/index.html in a browser; it needs no network. Whatever is wrong with a page is an error.
# Needs tools/install_packages.sh site.
set -euo pipefail
cd "$(dirname "$0")/.."
mkdir -p "${1:-build/site}"
out=$(realpath "${1:-build/site}")
python=/usr/bin/python3 # Debian's, for which the packages are

# The public headers as they are installed; nothing is compiled.
cmake -S . -B "$out/configured" -DASV_BUILD_TOOLS=OFF -DASV_BUILD_TESTS=OFF > "$out/configure.log"
headers=$out/configured/include

{
    cat tools/site/Doxyfile
    echo "INPUT = $headers/asv"
    echo "STRIP_FROM_PATH = $headers"
    echo "STRIP_FROM_INC_PATH = $headers"
    echo "OUTPUT_DIRECTORY = $out/doxygen"
} > "$out/Doxyfile"
rm -rf "$out/doxygen" "$out/html"
mkdir "$out/doxygen"
doxygen "$out/Doxyfile"

"$python" -B tools/site/stage.py . "$out/doxygen/xml" "$out/source"
"$python" -m sphinx -q -W --keep-going -j auto -b html -c tools/site -d "$out/doctrees" \
    -D "breathe_projects.asv=$out/doxygen/xml" "$out/source" "$out/html"
# Where tools/playground.sh has been run, the pictures of the lesson about it are alive.
[ ! -f build/playground/asv-playground.html ] || cp build/playground/asv-playground.html "$out/html/_static/"
echo "$out/html/index.html"
